"""The extremes of the torque against a search of 10⁴ frictions, over random clutches of every kind."""

import numpy as np
import pytest
from conftest import several
from hypothesis import HealthCheck, assume, example, given, settings
from hypothesis import strategies as st
from strategies import direct_specs, indirect_specs

from afmcalc.analysis.sweep.grid import evaluate
from afmcalc.engines import build
from afmcalc.engines.springs import DiscCharacteristic
from afmcalc.errors import SpecError
from afmcalc.spec import make_spec, resolved
from afmcalc.spec.catalogues import discs
from afmcalc.spec.models import DiscStack

SIZES = {size.name: size for size in discs()}
SHAPE = ("outer_diameter", "inner_diameter", "thickness", "reduced_thickness", "free_height")


@st.composite
def clutches(draw):
    """Direct with one material or unlike ones; indirect: walls, springs, setting and force of every kind."""
    if draw(st.integers(0, 3)) == 3:
        return draw(direct_specs(variants=(draw(st.sampled_from(("unlike", "differentiated", "all-driving"))),)))
    data = resolved(draw(indirect_specs(curved=draw(st.booleans()))))
    assume(data["control_spring"]["stiffness"] > 1e3)
    unit, force = data["control_unit"], data["closing_spring"]["force"]
    if draw(st.booleans()):
        # leaves its stop below, within or above the range
        at, net = draw(st.floats(0.01, 1.0)), float(build(make_spec(data)).net_gain)
        data["control_spring"]["force"] = force * (1 + data["friction_group"]["pairs"] * net * at)
    elif draw(st.booleans()):
        unit.pop("gain_slope", None)
        unit["pocket"] = "constant-torque"
    held = float(build(make_spec(data)).control_force)
    for name, wanted in (("closing_spring", force), ("control_spring", held)):
        if draw(st.booleans()):
            data[name]["disc"] = draw(stacks(wanted, 1.6 if name == "control_spring" else 1.05))
    try:
        return make_spec(data)
    except SpecError:
        assume(False)


@st.composite
def stacks(draw, wanted, spare):
    """A stack that bears a force, and some more."""
    size = SIZES[draw(st.sampled_from(["A 40", "B 40", "C 40", "C 100"]))]
    own = {each: getattr(size, each) for each in SHAPE}
    series = draw(st.integers(2, 12))
    one = DiscCharacteristic(DiscStack(**own, parallel=1, series=series))
    parallel = int(np.ceil(spare * wanted / float(one.force(one.end))))
    return DiscStack(**own, parallel=parallel, series=series).model_dump(exclude_none=True)


def seated(low):
    """Key's friction halves the net gain, κ 2 and κ₊ 4; the sleeve leaves its stop at f = 1 only, above f_max = 0.5."""
    size = SIZES["A 40"]
    disc = {name: getattr(size, name) for name in SHAPE if getattr(size, name) is not None}
    return make_spec(
        {
            "variant": "indirect",
            "friction": {"min": low, "mean": low, "max": 0.5},
            "friction_group": {"pairs": 1, "mean_radius": 0.05},
            "closing_spring": {"force": 500.0, "stiffness": 2000.0},
            "control_spring": {"stiffness": 1000.0, "force": 1500.0, "disc": {**disc, "parallel": 1, "series": 4}},
            "control_unit": {
                "gain": 3.0,
                "gain_slope": 40.02,
                "key_friction": 0.3,
                "hub_diameter": 0.03,
                "ball_circle_radius": 0.05,
                "balls": 6,
            },
        }
    )


@pytest.mark.parametrize("low", [0.5, 0.4, 0.25, 0.1])
def test_a_sleeve_that_never_left_its_stop_does_not_return(low):
    """The key keeps N = F_п2/(1 + z κ f_max) = 750 N down to f_max κ/κ₊ = 0.25; below, N = F_п2/(1 + z κ₊ f).

    Along κ₊ the force on the stop would be nought at f = 0.5: a sleeve that came back from a travel would sit down there.
    """
    pressed = max(1500 / (1 + 2 * 0.5), 1500 / (1 + 4 * low))
    clutch = build(seated(low))
    assert clutch.travel_max == 0
    assert clutch.torque_returning_min == pytest.approx(0.05 * low * pressed, rel=1e-12)


def _bent(clutch):
    """Whether the torque may turn anywhere: where it jumps it does so ever more steeply."""
    return bool(clutch.spec.spring_parts) and bool(clutch.gain_slope)


def met(clutch):
    """Smallest and largest torque of 10⁴ frictions, rising, and the smallest, falling; each clutch's whole path."""
    share = np.append(np.linspace(0.0, 1.0, 10_001), clutch.path_bend)
    path = clutch.path(share)
    swept = np.asarray(clutch.torque(*path))
    back = None if clutch.sleeve is None else float(np.min(clutch.torque_returning(path[0])))
    return float(swept.min()), float(swept.max()), back


@settings(
    max_examples=several(10, 40),
    suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow],
    deadline=None,
)
@given(clutches())
@example(seated(0.5))
def test_no_friction_gives_more_or_less_and_a_step_aside_gives_as_much(spec):
    clutch = build(spec)
    own, (low, high, back) = clutch.torque_range, met(clutch)
    assert own.low <= low * (1 + 1e-9)
    assert own.high >= high * (1 - 1e-9)
    assert clutch.scatter == pytest.approx(own.high - own.low, rel=1e-9, abs=1e-12 * high)
    assert clutch.accuracy_factor == pytest.approx(own.high / own.low, rel=1e-9)
    first = clutch.friction[0]
    for at, extreme in ((own.at_low, own.low), (own.at_high, own.high)):
        assert first.min * (1 - 1e-9) <= at <= first.max * (1 + 1e-9)
        # within a step of 10⁴ on either side; a step and a hair, for a jump is just there
        step = (first.max - first.min) / 1e4 + 1e-9
        near = np.clip(at + step * np.linspace(-1, 1, 10_001), first.min, first.max)
        torques = [low, high] if spec.friction.unlike else clutch.torque(near)
        assert np.min(np.abs(np.asarray(torques) / extreme - 1)) < (1e-4 if _bent(clutch) else 1e-6)
    if back is not None:
        assert clutch.torque_returning_min <= back * (1 + 1e-9)
        assert clutch.torque_returning_min <= own.low * (1 + 1e-9)
        assert clutch.accuracy_factor_hysteresis >= clutch.accuracy_factor * (1 - 1e-9)
        assert clutch.torque_returning_min == pytest.approx(back, rel=2e-2)


@settings(
    max_examples=several(5, 15),
    suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow],
    deadline=None,
)
@given(clutches())
def test_arrays_equal_numbers(spec):
    path = "friction_group.mean_radius"
    radii = np.array([0.97, 1.0, 1.02]) * spec.friction_group.mean_radius
    names = ["accuracy_factor", "torque_min", "torque_max"]
    names += ["torque_returning_min"] if spec.kind.travels else []
    try:
        swept = evaluate(spec, {path: radii}, {name: lambda own, name=name: getattr(own, name) for name in names})
        swept["at"] = evaluate(spec, {path: radii}, {"at": lambda own: own.torque_range.at_high})["at"]
    except SpecError:
        assume(False)
    for place, radius in enumerate(radii):
        data = resolved(spec)
        data["friction_group"]["mean_radius"] = radius
        one = build(make_spec(data))
        for name in names:
            assert swept[name][place] == pytest.approx(float(getattr(one, name)), rel=1e-9), name
        # a pocket that holds the torque leaves the place to rounding
        if one.scatter > 1e-9 * one.torque_max:
            assert swept["at"][place] == pytest.approx(float(one.torque_range.at_high), rel=1e-6)
