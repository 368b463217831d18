"""Synthesis: standard balls, contact, the completed spec."""

import math

import numpy as np
import pytest
from conftest import S21
from hypothesis import given
from hypothesis import strategies as st
from strategies import indirect_specs

from afmcalc.analysis.check import check
from afmcalc.analysis.synthesize import pocket
from afmcalc.engines import build
from afmcalc.spec import make_spec, read_spec
from afmcalc.spec.catalogues import balls
from afmcalc.spec.models import Required


def codes(findings):
    return {finding.code: finding for finding in findings}


@given(indirect_specs(), st.floats(0, 0.01), st.floats(0, 0.01))
def test_the_next_standard_ball_not_smaller(spec, gap, clearance):
    unit = spec.control_unit.model_copy(update={"face_gap": gap, "edge_clearance": clearance})
    result, findings = pocket(build(spec.model_copy(update={"control_unit": unit})))
    sizes = balls()
    wanted = 2 * result.ball_radius
    if result.ball_diameter_standard is None:
        assert wanted > max(sizes) == codes(findings)["no-standard-ball"].limit
        return
    assert result.ball_diameter_standard >= wanted * (1 - 1e-9)
    assert not any(wanted * (1 + 1e-9) <= size < result.ball_diameter_standard for size in sizes)
    assert result.edge_clearance_standard >= clearance - 1e-9
    # the torque of the balls: F_n has the moment n F_n cos α r about the axis
    clutch = build(spec)
    moment = result.contact_force * spec.control_unit.balls * math.cos(result.wall_angle) * result.ball_circle_radius
    assert moment == pytest.approx(clutch.at(friction=spec.friction.range.max)["torque"], rel=1e-9)


def small_balls(given):
    """Six balls of 5 mm, 574 N on each."""
    unit = {"gain": 1.5, "ball_circle_radius": 0.035, "balls": 6, "face_gap": 1e-3, "edge_clearance": 1e-3}
    data = {
        "variant": "all-driving", "friction": {"material": "moulded-dry"}, "closing_spring": {"force": 3600},
        "friction_group": {"pairs": 2, "inner_radius": 0.06, "outer_radius": 0.08},
        "control_unit": unit | {"ball_diameter": 5e-3} | given,
    }  # fmt: skip
    return build(make_spec(data))


FORCE = {"allowable_contact_force": 5000}
STEEL = {"ball_modulus": 206e9, "ball_poisson": 0.3, "wall_modulus": 206e9, "wall_poisson": 0.3}
CONTACT = {"contact": STEEL | {"allowable_pressure": 4.2e9}}
BY_HERTZ, BY_FORCE = {True: 3.08}, {False: 0.115}
JUDGED = [({}, BY_HERTZ), (FORCE, BY_FORCE), (CONTACT, BY_HERTZ), (FORCE | CONTACT, BY_HERTZ | BY_FORCE)]


@pytest.mark.parametrize(("given", "judged"), JUDGED)
def test_small_balls_are_judged_by_hertz_unless_a_force_is_given(given, judged):
    """187 N allowed, share 3.08, 6.1 GPa; 0.115 of the flat 5 kN; both where both are given."""
    own = small_balls(given)
    verdict, found = check(own)
    on_ball = [each for each in verdict.checks if each.name.startswith("contact force on one ball")]
    rows = {"Hertz" in each.name: each for each in on_ball}
    assert {hertz: each.utilisation for hertz, each in rows.items()} == pytest.approx(judged, rel=2e-3)
    assert all(each.grade == ("fail" if hertz else "pass") for hertz, each in rows.items())
    assert ("contact-assumed" in codes(found)) == ("contact" not in given)
    assert True not in rows or rows[True].limit == pytest.approx(187, abs=0.5)
    result, _ = pocket(own)
    assert result.contact_pressure == pytest.approx(6.1e9, rel=5e-3)
    assert result.contact_utilisation == max(each.utilisation for each in rows.values())
    for most, passed in ((6.0e9, False), (6.2e9, True)):
        required = own.spec.model_copy(update={"requirements": Required(contact_pressure=most)})
        (row,) = check(build(required))[0].requirements
        assert (row.path, row.passed) == ("requirements.contact_pressure", passed)
        assert row.value == result.contact_pressure


@given(indirect_specs(), st.floats(0, 0.01), st.floats(0, 0.01))
def test_the_pocket_is_as_it_was_laid_out(spec, gap, clearance):
    """Ball at the origin, faces at ±s/2: the wall from mouth to apex touches the ball, the floor lies under it."""
    unit = spec.control_unit.model_copy(update={"face_gap": gap, "edge_clearance": clearance})
    found, _ = pocket(build(spec.model_copy(update={"control_unit": unit})))
    mouth, apex = np.array([gap / 2, found.pocket_width / 2]), np.array([gap / 2 + found.pocket_depth, 0.0])
    wall = (apex - mouth) / np.linalg.norm(apex - mouth)
    touching = mouth - wall * (mouth @ wall)
    assert np.linalg.norm(touching) == pytest.approx(found.ball_diameter / 2, rel=1e-9)
    assert found.pocket_depth_cut + gap / 2 == pytest.approx(found.ball_diameter / 2, rel=1e-9)
    around = [found.ball_circle_radius * np.exp(2j * np.pi * k / unit.balls) for k in (0, 1)]
    assert found.ball_pitch == pytest.approx(abs(around[0] - around[1]), rel=1e-9)
    assert found.web == pytest.approx(found.ball_pitch - found.pocket_width, abs=1e-12)
    if found.ball_diameter_standard is not None:
        # the contact stays y below the face when the sleeve has gone all its way
        assert touching[0] - (gap + found.travel_max) / 2 == pytest.approx(found.edge_clearance_standard, abs=1e-9)


def test_the_completed_spec_is_the_same_clutch(afmcalc, tmp_path):
    target, own = tmp_path / "completed.toml", tmp_path / "balls.toml"
    assert afmcalc("pocket", S21, "--save", target).code == 0
    assert read_spec(target).control_unit.gain is None
    before, after = (afmcalc("torque", path, "--json").json["result"]["torque"] for path in (S21, target))
    assert after == pytest.approx(before)
    own.write_text('diameters = [30, "60 mm", 200]')
    found = afmcalc("pocket", "--set", f"catalogues.balls={own}", "--json").json["result"]
    assert found["ball_diameter_standard"] == 0.03
