"""The direct law against a numerical solution of the axial balance, and its special cases against each other."""

import numpy as np
import pytest
from hypothesis import example, given
from strategies import FRICTION, direct_specs

import afmcalc
from afmcalc.analysis.clutch_findings import clutch_findings
from afmcalc.engines import build
from afmcalc.engines.elasticity import elasticities
from afmcalc.spec import make_spec


def slopes(clutch):
    """Elasticities of the accuracy factor."""
    return {path: each.slope for path, each in elasticities(clutch).items()}


def _base(**changes):
    data = {
        "variant": "differentiated", "friction": {"min": 0.1, "max": 0.8},
        "friction_group": {"pairs": 8, "mean_radius": 0.1}, "closing_spring": {"force": 2000.0},
        "control_unit": {"gain": 0.5},
    }  # fmt: skip
    return make_spec({**data, **changes})


def solve_balance(spec, f1: float, f2: float) -> tuple[float, float, float]:
    """Normal force, release force and torque by bisection on N = F_п − F_p(N), from the forces alone."""
    force, radius, pairs = spec.closing_spring.force, spec.friction_group.mean_radius, spec.friction_group.pairs
    bypass = {"conventional": pairs, "all-driving": 0}.get(spec.variant, spec.friction_group.driving_pairs)
    gain = spec.control_unit.gain if spec.control_unit else 0.0
    ball_circle = 0.8 * radius
    tan_angle = gain * ball_circle / radius

    def released(normal: float) -> float:
        ball_torque = (pairs - bypass) * f2 * radius * normal
        return ball_torque / ball_circle * tan_angle

    low, high = 0.0, force
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (low, middle) if middle > force - released(middle) else (middle, high)
    normal = (low + high) / 2
    return normal, released(normal), radius * normal * (bypass * f1 + (pairs - bypass) * f2)


@given(direct_specs(), FRICTION, FRICTION)
def test_closed_form_solves_the_balance(spec, f1, f2):
    if not spec.friction.unlike:
        f2 = f1
    clutch = build(spec)
    normal, release, torque = solve_balance(spec, f1, f2)
    force = spec.closing_spring.force
    assert clutch.at_friction(f1, f2)["normal_force"] == pytest.approx(normal, rel=1e-9, abs=1e-12 * force)
    assert clutch.at_friction(f1, f2)["release_force"] == pytest.approx(release, rel=1e-9, abs=1e-12 * force)
    assert clutch.at_friction(f1, f2)["torque"] == pytest.approx(torque, rel=1e-9)


RAISED = {"driving": {"min": 0.22, "mean": 0.81, "max": 0.84}, "driven": {"min": 0.06, "mean": 0.1, "max": 0.74}}
BENT = {"driving": {"min": 0.5, "mean": 0.5, "max": 0.9}, "driven": {"min": 0.1, "mean": 0.55, "max": 0.6}}


@given(direct_specs())
@example(_base(friction=BENT, control_unit={"gain": 3.0}))  # least torque at the mean
@example(_base(friction=RAISED, control_unit={"gain": 1.47}))  # most there
def test_accuracy_is_the_extreme_ratio_of_the_torque_itself(spec):
    clutch = build(spec)
    first, second = clutch.spec.friction.groups
    path = np.linspace(0, 1, 501)
    pieces = [("min", "mean"), ("mean", "max")] if spec.friction.unlike else [("min", "max")]
    ways = [
        [getattr(own, low) + path * (getattr(own, high) - getattr(own, low)) for own in (first, second)]
        for low, high in pieces
    ]
    along = np.concatenate([clutch.at_friction(*way)["torque"] for way in ways])
    assert clutch.accuracy_factor == pytest.approx(along.max() / along.min(), rel=1e-9)
    assert clutch.torque_max == pytest.approx(along.max(), rel=1e-12)
    f1, f2 = np.meshgrid(np.linspace(first.min, first.max, 31), np.linspace(second.min, second.max, 31))
    everywhere = clutch.at_friction(f1, f2)["torque"]
    assert clutch.accuracy_factor_worst_case == pytest.approx(everywhere.max() / everywhere.min(), rel=1e-9)
    peaks = clutch.at_friction(
        first.min + path * (first.max - first.min), second.min + path * (second.max - second.min)
    )["breakaway_torque"]
    assert clutch.accuracy_factor_peak == pytest.approx(peaks.max() / peaks.min(), rel=1e-9)


@pytest.mark.parametrize("bad", [-0.1, float("nan"), float("inf"), True, "0.3", [0.1, -0.1], [0.1, float("nan")]])
def test_friction_that_is_none_is_refused(bad):
    clutch = afmcalc.load()
    with pytest.raises(ValueError, match="friction"):
        clutch.torque(bad)
    assert clutch.torque([0.1, 0.3]).tolist() == [clutch.torque(0.1), clutch.torque(0.3)]


def codes(spec):
    return {finding.code: finding for finding in clutch_findings(build(spec))}


def test_findings():
    assert codes(_base()) == {}
    above = codes(_base(control_unit={"gain": 2.0}))["gain-above-limit"]
    assert (above.level, above.value, above.limit, above.path) == ("warning", 2.0, 1.25, "control_unit.gain")
    assert codes(_base(control_unit={"gain": 0.0})).keys() == {"feedback-idle"}
    reduced = codes(_base(variant="all-driving", control_unit={"gain": 0.7}))["reduced-gain-above-limit"]
    assert (reduced.value, reduced.limit) == (pytest.approx(5.6), 5.0)
    assert "reduced-gain-above-limit" not in codes(_base(variant="all-driving", control_unit={"gain": 0.625}))
    missed = codes(_base(adjustment={"nominal_torque": 200.0}))["nominal-torque-missed"]
    assert (missed.limit, missed.value) == (200.0, pytest.approx(118.5185185))
    below = codes(_base(adjustment={"method": "mean-friction"}))["below-nominal-torque"]
    assert below.value < below.limit
    # z_1 1, z_2 6, C 3, f_1 0.5…0.6, f_2 0.1…0.6: (0.6 + 3.6)/11.8 over (0.5 + 0.6)/2.8
    falls = {"driving": {"min": 0.5, "max": 0.6}, "driven": {"min": 0.1, "max": 0.6}}
    pack = {"pairs": 7, "mean_radius": 0.1}
    told = codes(_base(friction=falls, friction_group=pack, control_unit={"gain": 3.0}))
    assert told["torque-falls"].value == pytest.approx(4.2 / 11.8 / (1.1 / 2.8))
