"""Synthesis: standard balls, contact, the completed spec."""

import math

import numpy as np
import pytest
from conftest import CONFIGS, S21, WANTED
from hypothesis import given
from hypothesis import strategies as st
from strategies import indirect_specs

from afmcalc.analysis import hertz
from afmcalc.analysis.check import check
from afmcalc.analysis.synthesize import synthesize
from afmcalc.engines import build
from afmcalc.errors import AfmcalcError
from afmcalc.spec import make_spec, read_spec
from afmcalc.spec.lists import diameters
from afmcalc.spec.models import HARDENED_STEEL, Required

CONTACT = {
    "ball_modulus": "210 GPa", "ball_poisson": 0.3, "wall_modulus": "206 GPa", "wall_poisson": 0.28,
    "allowable_pressure": "2500 MPa",
}  # fmt: skip


def codes(findings):
    return {finding.code: finding for finding in findings}


@given(indirect_specs(), st.floats(0, 0.01), st.floats(0, 0.01))
def test_the_next_standard_ball_not_smaller(spec, gap, clearance):
    unit = spec.control_unit.model_copy(update={"face_gap": gap, "edge_clearance": clearance})
    result, findings = synthesize(build(spec.model_copy(update={"control_unit": unit})))
    sizes = diameters()
    wanted = 2 * result.ball_radius
    if result.ball_diameter_standard is None:
        assert wanted > max(sizes)
        assert codes(findings)["no-standard-ball"].level == "error"
        assert codes(findings)["no-standard-ball"].limit == max(sizes)
        return
    assert result.ball_diameter_standard >= wanted * (1 - 1e-9)
    assert not any(wanted * (1 + 1e-9) <= size < result.ball_diameter_standard for size in sizes)
    assert result.edge_clearance_standard >= clearance - 1e-9
    # the torque of the balls: F_n has the moment n F_n cos α r about the axis
    clutch = build(spec)
    moment = result.contact_force * spec.control_unit.balls * math.cos(result.wall_angle) * result.ball_circle_radius
    assert moment == pytest.approx(clutch.torque(spec.friction.range.max), rel=1e-9)


def test_the_balls_of_a_direct_clutch_carry_only_t_2():
    clutch = build(read_spec())
    result, _ = synthesize(clutch)
    carried = clutch.at(0.8)["release_force"] * 0.05 / math.tan(result.wall_angle)
    assert result.contact_force * 6 * math.cos(result.wall_angle) * 0.05 == pytest.approx(carried)
    assert carried < clutch.torque(0.8)


def test_hertz_in_place_of_a_given_force():
    """At the allowable force the textbook's contact radius and pressure give the allowable pressure."""
    overrides = ["control_unit.allowable_contact_force="]
    overrides += [f"control_unit.contact.{key}={value}" for key, value in CONTACT.items()]
    result, _ = synthesize(build(read_spec(CONFIGS / "default.toml", overrides)))
    assert result.contact_basis == "hertz-ball-on-flat"
    modulus = 1 / ((1 - 0.3**2) / 210e9 + (1 - 0.28**2) / 206e9)
    radius = result.ball_diameter_standard / 2
    contact_radius = (3 * result.contact_force_allowable * radius / (4 * modulus)) ** (1 / 3)
    pressure = 3 * result.contact_force_allowable / (2 * math.pi * contact_radius**2)
    assert pressure == pytest.approx(2.5e9, rel=1e-9)
    assert result.contact_utilisation == pytest.approx(result.contact_force / result.contact_force_allowable)


def small_balls(*overrides):
    """Six balls of 5 mm, 574 N on each."""
    data = {
        "variant": "all-driving",
        "friction": {"material": "moulded-dry"},
        "friction_group": {"pairs": 2, "inner_radius": 0.06, "outer_radius": 0.08},
        "closing_spring": {"force": 3600},
        "control_unit": {
            "gain": 1.5, "ball_circle_radius": 0.035, "balls": 6, "face_gap": 1e-3, "edge_clearance": 1e-3,
            "ball_diameter": 5e-3,
        },
    }  # fmt: skip
    for key, value in overrides:
        data["control_unit"][key] = value
    return build(make_spec(data))


STEEL = {"ball_modulus": 206e9, "ball_poisson": 0.3, "wall_modulus": 206e9, "wall_poisson": 0.3}


@pytest.mark.parametrize(
    ("given", "judged"),
    [
        ((), {"Hertz": 3.08}),
        ((("allowable_contact_force", 5000),), {"given": 0.115}),
        ((("contact", STEEL | {"allowable_pressure": 4.2e9}),), {"Hertz": 3.08}),
        (
            (("allowable_contact_force", 5000), ("contact", STEEL | {"allowable_pressure": 4.2e9})),
            {"given": 0.115, "Hertz": 3.08},
        ),
    ],
)
def test_small_balls_are_judged_by_hertz_unless_a_force_is_given(given, judged):
    """187 N allowed, share 3.08, 6.1 GPa; 0.115 of the flat 5 kN; both where both are given."""
    own = small_balls(*given)
    verdict, found = check(own)
    rows = {
        "Hertz" if "Hertz" in each.name else "given": each
        for each in verdict.limits
        if each.name.startswith("contact force on one ball")
    }
    assert {name: each.utilisation for name, each in rows.items()} == pytest.approx(judged, rel=2e-3)
    assert {name: each.verdict for name, each in rows.items()} == {
        name: "fail" if share > 1 else "pass" for name, share in judged.items()
    }
    assert ("contact-assumed" in codes(found)) == ("contact" not in dict(given))
    if "Hertz" in judged:
        assert rows["Hertz"].limit == pytest.approx(187, abs=0.5)
        assert "6107.9 MPa" in codes(found)["contact-force-exceeded"].message
    result, _ = synthesize(own)
    assert result.contact_pressure == pytest.approx(6.1e9, rel=5e-3)
    assert result.contact_utilisation == max(each.utilisation for each in rows.values())
    for most, passed in ((6.0e9, False), (6.2e9, True)):
        required = own.spec.model_copy(update={"requirements": Required(contact_pressure=most)})
        (row,) = check(build(required))[0].requirements
        assert (row.requirement, row.passed) == ("contact_pressure", passed)
        assert row.value == result.contact_pressure


def test_arrays_of_balls_bear_what_each_bears():
    """Numbers and arrays alike; p_0 = 3F/(2πa²)."""
    balls = np.linspace(2e-3, 3e-2, 7)
    forces = hertz.allowable_force(HARDENED_STEEL, balls)
    one_by_one = [hertz.allowable_force(HARDENED_STEEL, float(ball)) for ball in balls]
    assert forces.tolist() == pytest.approx(one_by_one, rel=1e-12)
    modulus = 206e9 / (2 * (1 - 0.3**2))
    contact_radius = (3 * 574.47 * 2.5e-3 / (4 * modulus)) ** (1 / 3)
    pressure = hertz.pressure(HARDENED_STEEL, np.array([574.47, 8 * 574.47]), 2.5e-3)
    assert pressure[0] == pytest.approx(3 * 574.47 / (2 * math.pi * contact_radius**2), rel=1e-9)
    assert pressure[1] == pytest.approx(2 * pressure[0], rel=1e-12)


@pytest.mark.parametrize("name", [path.stem for path in CONFIGS.glob("*.toml") if path.stem not in WANTED])
def test_no_example_has_a_force_whatever_the_ball(name):
    unit = read_spec(CONFIGS / f"{name}.toml").control_unit
    assert unit is None or (unit.allowable_contact_force, unit.contact) == (None, None)


def test_findings():
    spec = read_spec(CONFIGS / "default.toml", ["control_unit.allowable_contact_force=100", "control_unit.balls=3"])
    exceeded = codes(synthesize(build(spec))[1])["contact-force-exceeded"]
    assert exceeded.level == "error"
    assert exceeded.value > exceeded.limit == 100
    bare = ["control_unit.face_gap=", "control_unit.edge_clearance=", "control_unit.balls="]
    found = codes(synthesize(build(read_spec(None, bare)))[1])
    assert {"default-clearance", "balls-not-given"} <= set(found)
    small = codes(synthesize(build(read_spec(None, ["control_unit.ball_diameter=5 mm"])))[1])["ball-too-small"]
    assert small.level == "error"


def test_what_cannot_be_synthesized(afmcalc):
    for overrides, says in (
        (["control_unit.ball_circle_radius="], "control_unit.ball_circle_radius: required by synthesize"),
        (["C=0"], "control_unit.gain = 0: must be greater than 0"),
    ):
        run = afmcalc("synthesize", *(part for override in overrides for part in ("--set", override)))
        assert run.code == 2
        assert says in run.err
    assert "no control unit" in afmcalc("synthesize", CONFIGS / "conventional.toml").err


def test_output_writes_the_completed_spec(afmcalc, tmp_path):
    target = tmp_path / "completed.toml"
    run = afmcalc("synthesize", S21, "--json", "--output", target)
    result = run.json["result"]
    unit = read_spec(target).control_unit
    assert unit.wall_angle == pytest.approx(result["wall_angle"], rel=1e-11)
    assert unit.gain is None
    before, after = (afmcalc("torque", path, "--json").json["result"] for path in (S21, target))
    for key, value in before.items():
        assert after[key] == pytest.approx(value) or value is None
    again = afmcalc("synthesize", target, "--json").json["result"]
    assert again["ball_diameter_standard"] == result["ball_diameter_standard"]
    assert again["wall_angle"] == pytest.approx(result["wall_angle"])
    own = afmcalc("synthesize", target, "--output", target)
    assert own.code == 2
    assert "is read itself" in own.err


def test_the_users_own_balls(afmcalc, tmp_path):
    own = tmp_path / "balls.toml"
    own.write_text('diameters = [30, "60 mm", 200]')
    result = afmcalc("synthesize", "--balls", own, "--json").json["result"]
    assert result["ball_diameter_standard"] == pytest.approx(0.03)
    for text in ("diameters = []", "diameters = [true]", 'diameters = ["x"]', "diameters = [-1]", "x", "a = 1"):
        own.write_text(text)
        run = afmcalc("synthesize", "--balls", own)
        assert (run.code, run.out) == (2, "")
    assert afmcalc("synthesize", "--balls", tmp_path / "none").code == 3
    own.write_bytes(b"\xff")
    with pytest.raises(AfmcalcError):
        diameters(own)


@given(indirect_specs(), st.floats(0, 0.01), st.floats(0, 0.01))
def test_the_pocket_is_as_it_was_laid_out(spec, gap, clearance):
    """Ball at the origin, faces at ±s/2: the wall from mouth to apex touches the ball, the floor lies under it."""
    unit = spec.control_unit.model_copy(update={"face_gap": gap, "edge_clearance": clearance})
    found, _ = synthesize(build(spec.model_copy(update={"control_unit": unit})))
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


def test_a_single_ball_has_no_neighbour(afmcalc):
    for balls in ("1", ""):
        found = afmcalc("synthesize", "--set", f"control_unit.balls={balls}", "--json").json["result"]
        assert (found["ball_pitch"], found["web"]) == (None, None)
