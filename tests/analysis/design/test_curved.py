"""A design of clutches whose pockets hold the torque, against synthesis of every candidate by itself."""

import itertools

import pytest

from afmcalc.analysis.design.design import design
from afmcalc.analysis.design.rows import as_spec
from afmcalc.analysis.synthesize import synthesize
from afmcalc.engines import build
from afmcalc.errors import SpecError
from afmcalc.spec.requirements import make_requirements

SEARCH = {
    "pairs": [8],
    "mean_radius": [0.08, 0.1],
    "gain": [0.6, 1.0, 1.5, 2.5],
    "ball_circle_radius": [0.04, 0.05],
    "closing_stiffness": [1e5, 3e5, 8e5],
    "control_stiffness": [0.0, 2e5],
}


def wanted(method="min-friction", variant="indirect", pocket="constant-torque"):
    return {
            "variants": [variant],
            "objectives": ["closing_force", "ball_diameter", "travel"],
            "friction": {"min": 0.1, "mean": 0.3, "max": 0.8},
            "wanted": {"nominal_torque": 150, "method": method},
            "search": {**SEARCH, "closing_force": {"min": 100, "max": 1e5}},
            "fixed": {
                "hub_diameter": 0.05, "key_friction": 0.01, "pocket": pocket,
            },
            "limits": {"contact_force": 900.0},
        }  # fmt: skip


def requirements(*given):
    return make_requirements(wanted(*given))


def rounded(*values):
    return tuple(float(f"{value:.7g}") for value in values)


def clutch_of(need, values):
    """The clutch of one candidate, its spring set for the torque."""
    return build(
        {
            "variant": "indirect",
            "friction": {"min": 0.1, "mean": 0.3, "max": 0.8},
            "friction_group": {"pairs": values["pairs"], "mean_radius": values["mean_radius"]},
            "closing_spring": {"stiffness": values["closing_stiffness"]},
            "control_spring": {"stiffness": values["control_stiffness"]},
            "control_unit": {
                "gain": values["gain"], "ball_circle_radius": values["ball_circle_radius"], "balls": 6,
                "face_gap": 0.002, "edge_clearance": 0.002, "hub_diameter": 0.05, "key_friction": 0.01,
                "pocket": need.fixed.pocket, "allowable_contact_force": 900.0,
            },
            "adjustment": {"method": need.wanted.method, "nominal_torque": 150},
        }
    )  # fmt: skip


@pytest.mark.every(2)
@pytest.mark.parametrize("method", ["mean-friction", "min-friction"])
def test_every_candidate_against_synthesis(method):
    need = requirements(method)
    good = []
    for values in (dict(zip(SEARCH, each, strict=True)) for each in itertools.product(*SEARCH.values())):
        clutch = clutch_of(need, values)
        found, findings = synthesize(clutch)
        if clutch.spec.control_unit.hub_diameter > 2 * values["ball_circle_radius"] - found.ball_diameter:
            continue
        if found.ball_diameter_standard is not None and not any(each.level == "error" for each in findings):
            good.append(rounded(clutch.control_force, found.ball_diameter_standard, found.travel_max))
    result, _ = design(need)
    assert result.feasible == len(good)
    assert 2 < len(good) < 90
    best = {
        one
        for one in good
        if not any(all(a <= b for a, b in zip(other, one, strict=True)) and other != one for other in good)
    }
    assert {rounded(row.pack_force_at_rest, row.ball_diameter, row.travel) for row in result.front} == best


def test_what_is_picked_holds_the_torque():
    need = requirements()
    result, _ = design(need)
    for row in result.front:
        clutch = build(as_spec(need, row))
        assert clutch.accuracy_factor == pytest.approx(1, rel=1e-12)
        assert clutch.gain_slope == pytest.approx(row.gain_slope, rel=1e-12)
        found, findings = synthesize(clutch)
        assert not any(each.level == "error" for each in findings)
        assert found.ball_diameter_standard == pytest.approx(row.ball_diameter)
        assert found.contact_force == pytest.approx(row.contact_force, rel=1e-9)


def test_of_an_indirect_clutch_alone():
    with pytest.raises(SpecError, match="is of variant 'indirect'"):
        make_requirements(wanted(variant="all-driving"))
