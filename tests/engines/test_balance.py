"""A sleeve between curved springs behind curved walls: against the closed law, and against what a march over x finds."""

import numpy as np
import pytest
from conftest import several
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from strategies import indirect_specs

from afmcalc.analysis.synthesize import synthesize
from afmcalc.engines import build
from afmcalc.engines.springs import DiscCharacteristic, SetSpring
from afmcalc.spec.catalogues import discs
from afmcalc.spec.models import DiscStack

SIZES = {size.name: size for size in discs()}
SHAPE = ("outer_diameter", "inner_diameter", "thickness", "reduced_thickness", "free_height")
PLACES = 40_001


def stack(name, series):
    return DiscStack(**{each: getattr(SIZES[name], each) for each in SHAPE}, parallel=6, series=series)


@settings(max_examples=several(10, 40))
@given(indirect_specs(curved=True))
def test_the_same_place_as_the_closed_law_of_straight_springs(spec):
    """Jumps off the stop and back to it among them."""
    clutch = build(spec)
    own = clutch.friction[0]
    assume(not clutch.straight)
    for friction in np.linspace(own.min, own.max, 7)[1:]:
        if clutch.is_seated(friction):
            continue
        found, rounding = (
            clutch.balance(clutch.net_gain).travel(friction),
            clutch.closing_force / clutch.closing_stiffness,
        )
        assert float(found) == pytest.approx(float(clutch.travel(friction)), rel=1e-7, abs=1e-9 * rounding)
    back = float(clutch.torque_returning(own.min))
    place = clutch.travel_returning(own.min)
    torque = clutch.mean_radius * clutch.pairs * own.min * float(clutch.balance(0.0).pressed(place))
    if place > 1e-9:
        assert torque == pytest.approx(back, rel=1e-6)


@settings(max_examples=several(8, 30))
@given(
    indirect_specs(curved=True),
    st.sampled_from(sorted(SIZES)),
    st.sampled_from(sorted(SIZES)),
    st.integers(1, 40),
    st.booleans(),
)
def test_the_first_place_that_holds_the_sleeve(spec, one, two, series, both):
    plain = build(spec)
    assume(spec.control_unit.gain_slope > 0)
    closing, control = stack(one, series), stack(two, series) if both else None
    first, second = DiscCharacteristic(closing), control and DiscCharacteristic(control)
    assume(float(first.force(first.end)) > plain.closing_force)
    assume(second is None or float(second.force(second.end)) > 1.5 * plain.control_force)
    parts = {
        "closing_spring": spec.closing_spring.model_copy(update={"disc": closing}),
        "control_spring": spec.control_spring.model_copy(update={"disc": control}),
    }
    clutch = build(spec.model_copy(update=parts))
    law, own, start = clutch, clutch.friction[0], float(first.deflection(clutch.closing_force))
    x = np.linspace(0, start, PLACES)
    pressed = first.force(start - x)
    held = float(clutch.control_force)
    pushed = held + law.control_stiffness * x if second is None else second.force(second.deflection(held) + x)

    def left(friction, threshold):
        return pushed - pressed * (1 + law.pairs * friction * (law.gain + law.gain_slope * x + threshold))

    frictions = np.linspace(own.min, own.max, 9)
    rising = []
    for friction in frictions:
        off = np.flatnonzero(left(friction, -law.gain_threshold) >= -1e-9 * held)
        rising.append(x[off[0]] if off.size else start)
    moved = clutch.travel(frictions)
    assert moved == pytest.approx([float(clutch.travel(each)) for each in frictions], abs=1e-12 + 1e-9 * start)
    near = np.diff(np.concatenate([[0.0], rising])) < start / 20  # a jump is as far off as the march is coarse
    assert moved[near] == pytest.approx(np.array(rising)[near], abs=3e-4 * start)
    assert (np.diff(moved) >= -1e-9 * start).all()
    # back from where f_max put it: the last place that holds it
    far = float(moved[-1])
    for friction in frictions[::3]:
        there = np.flatnonzero((left(friction, law.gain_threshold) <= 0) & (x <= far))
        back = float(law.travel_returning(friction))
        assert back == pytest.approx(x[there[-1]] if there.size else 0.0, abs=3e-4 * start)
        if back > 0:
            torque = law.mean_radius * law.pairs * friction * float(first.force(start - back))
            assert clutch.torque_returning(friction) == pytest.approx(torque, rel=1e-9)
    # extremes: of the places that friction brings the sleeve to, the jumps left out
    ends = [float(clutch.torque(each)) for each in (own.min, own.max)]
    for threshold, way, least in (
        (-law.gain_threshold, slice(None), clutch.torque_min),
        (law.gain_threshold, slice(None, None, -1), clutch.torque_returning_min),
    ):
        net = (law.gain + law.gain_slope * x + threshold)[x <= far][way]
        most, less = pushed[x <= far][way], pressed[x <= far][way]
        with np.errstate(divide="ignore"):
            at = (most / less - 1) / (law.pairs * net)
        farthest = np.maximum.accumulate(at) if threshold <= 0 and way.step is None else np.minimum.accumulate(at)
        held = law.mean_radius * ((most - less) / net)[(at == farthest) & (at >= own.min) & (at <= own.max)]
        if way.step:
            ends[0] = float(clutch.torque_returning(own.min))
        else:
            assert clutch.torque_max == pytest.approx(max([*ends, *held]), rel=1e-3)
            assert clutch.torque_max >= max([*ends, *held]) * (1 - 1e-9)
        assert least == pytest.approx(min([*ends, *held]), rel=1e-3)
        assert least <= min([*ends, *held]) * (1 + 1e-9)


def test_a_pocket_cut_for_disc_springs_nearly_holds_the_torque():
    own = {
        "variant": "indirect",
        "friction": {"min": 0.1, "mean": 0.3, "max": 0.8},
        "friction_group": {"pairs": 8, "mean_radius": 0.1},
        "closing_spring": {"force": 2000.0, "stiffness": 4e5, "disc": stack("B 40", 2).model_dump() | {"parallel": 1, "series": 6}},
        "control_spring": {"stiffness": 2e5},
        "control_unit": {
            "gain": 2.0, "ball_circle_radius": 0.05, "hub_diameter": 0.05, "key_friction": 0.01, "balls": 6,
            "pocket": "constant-torque",
        },
    }  # fmt: skip
    clutch = build(own)
    assert 1 < clutch.accuracy_factor < 1.03
    assert clutch.torque(0.8) == pytest.approx(clutch.torque(0.1), rel=1e-9), "the same at both ends"
    swept = clutch.torque(np.linspace(0.1, 0.8, 10_001))
    assert clutch.torque_min == pytest.approx(swept.min(), rel=1e-9), "between them"
    assert clutch.torque_min < clutch.torque(0.8) / 1.001
    found, _ = synthesize(clutch)
    assert found.travel_max == pytest.approx(float(clutch.travel(0.8)))


def test_a_jump_between_disc_springs_is_seen_from_both_sides():
    """Far from the stop, where the discs give way: the largest torque just before it, the smallest just after."""
    disc = {"outer_diameter": 0.071, "inner_diameter": 0.036, "thickness": 0.002, "free_height": 0.0046}
    clutch = build({
        "variant": "indirect",
        "friction": {"min": 0.13, "max": 0.66},
        "friction_group": {"pairs": 7, "mean_radius": 0.1},
        "closing_spring": {"force": 4445.0, "stiffness": 1e5},
        "control_spring": {"force": 22693.5, "stiffness": 1e5, "disc": disc | {"parallel": 7, "series": 10}},
        "control_unit": {
            "gain": 2.756, "gain_slope": 1231.0, "hub_diameter": 0.05, "key_friction": 0.01, "ball_circle_radius": 0.05,
        },
    })  # fmt: skip
    own = clutch.torque_range
    assert own.at_low == pytest.approx(own.at_high, rel=1e-9)
    assert own.high == pytest.approx(float(clutch.torque(own.at_high * (1 - 1e-9))), rel=1e-6)
    assert own.low == pytest.approx(float(clutch.torque(own.at_low * (1 + 1e-9))), rel=1e-6)
    assert own.low < 0.2 * own.high


@pytest.mark.parametrize("disc", [None, DiscCharacteristic(stack("B 40", 20))])
def test_a_set_spring_slackens_to_a_force_and_grows_by_its_stiffness(disc):
    spring = SetSpring(2000.0, 4e4 if disc is None else disc.stiffness(disc.deflection(2000.0)), disc)
    assert float(spring.force(0.0)) == pytest.approx(2000)
    for force in (500.0, 1000.0, 1999.0):
        assert float(spring.force(-spring.slackens(force))) == pytest.approx(force, rel=1e-9)
    # let out by all that it is pressed in it presses no more
    assert float(spring.force(-spring.deflection)) == pytest.approx(0, abs=1e-9)
    for further in (-1e-3, 5e-4):
        slope = (float(spring.force(further + 1e-7)) - float(spring.force(further - 1e-7))) / 2e-7
        assert float(spring.stiffness(further)) == pytest.approx(slope, rel=1e-6)
