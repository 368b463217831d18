"""Elasticities of the accuracy against differences of it; arrays against numbers; the threshold of the gain."""

import contextlib

import numpy as np
import pytest
from conftest import S21
from hypothesis import assume, example, given
from hypothesis import strategies as st
from random_clutches import random_clutches
from strategies import FRICTION, direct_specs, indirect_specs, p5

import afmcalc
from afmcalc.analysis.clutch_findings import clutch_findings
from afmcalc.engines import build
from afmcalc.engines.elasticity import PATHS, elasticities
from afmcalc.engines.quantities import Quantities
from afmcalc.errors import SpecError
from afmcalc.spec import make_spec, read_spec
from afmcalc.spec.edit import value_at, with_nominal_torque, with_values

INDIRECT = st.one_of(indirect_specs(), indirect_specs(curved=True))
STEP = 1e-6


def slopes(clutch):
    """Elasticities of the accuracy factor."""
    return {path: each.slope for path, each in elasticities(clutch).items()}


def difference(factor):
    """Central difference of a logarithm over relative steps."""
    return (np.log(float(factor(1 + STEP))) - np.log(float(factor(1 - STEP)))) / (2 * STEP)


def numeric(spec, path):
    value = value_at(spec, path)
    return difference(lambda share: build(with_values(spec, {path: value * share})).accuracy_factor)


def apart(own):
    """True if the mean of a range is none of its ends, by more than a difference steps."""
    return own.min * 1.0001 < own.mean < own.max * 0.9999


@given(direct_specs())
def test_elasticities_of_a_direct_clutch(spec):
    """Every continuous key; pairs are continuous for the law, those of the other group kept."""
    clutch = build(spec)
    ranges = clutch.spec.friction.groups if spec.friction.unlike else ()
    # K_т = max/min has a kink where both are one, and at a mean that is an end
    assume(abs(clutch.accuracy_factor - 1) > 1e-6 and all(map(apart, ranges)))
    found = slopes(clutch)
    for path in (path for path in found if not path.endswith("pairs")):
        assert found[path] == pytest.approx(numeric(spec, path), abs=2e-5), path
    z1, z2 = float(clutch.bypass_pairs), float(clutch.controlled_pairs)
    if spec.friction.unlike or not z2:
        return

    def factor(bypass, controlled):
        return clutch.at(bypass_pairs=bypass, pairs=bypass + controlled)["accuracy_factor"]

    in_pairs = difference(lambda share: factor(z1, z2 + (z1 + z2) * (share - 1)))
    assert found["friction_group.pairs"] == pytest.approx(in_pairs, abs=2e-5)
    if z1:
        in_driving = difference(lambda share: factor(z1 * share, z2 - z1 * (share - 1)))
        assert found["friction_group.driving_pairs"] == pytest.approx(in_driving, abs=2e-5)


def is_smooth(clutch):
    """True if K_т has a derivative: no jump off the stop near by, and no two torques about to change places."""
    own = clutch.spec.friction.groups[0]
    if own.max < own.min * 1.0001 or (clutch.spec.adjustment.method == "mean-friction" and not apart(own)):
        return False  # K_т has a kink where the sleeve leaves at an end
    if "gain_slope" not in clutch:
        return True
    at_stop = clutch.friction_leaving
    ends = [float(clutch.at(friction=own.min)["torque"]), float(clutch.at(friction=own.max)["torque"])]
    differ = abs(np.log(ends[1] / ends[0])) > 1e-4
    differ &= not own.min < at_stop < own.max or abs(np.log(clutch.at(friction=at_stop)["torque"] / ends[1])) > 1e-4
    return differ and clutch.gain_slope < 0.9 * clutch.jumping_slope


@given(INDIRECT, st.booleans())
@example(p5("control_spring.force=3920", "control_unit.gain_slope=8"), False)  # most torque where the sleeve leaves
def test_elasticities_of_an_indirect_clutch(spec, by_torque):
    clutch = build(spec)
    assume(clutch.net_gain > 1e-2)
    assume(is_smooth(clutch))
    if by_torque:
        spec = with_nominal_torque(spec, clutch.nominal_torque)
    for path, elasticity in slopes(build(spec)).items():
        expected = numeric(spec, path) if value_at(spec, path) else 0.0
        assert elasticity == pytest.approx(expected, abs=5e-5 * (1 + abs(expected))), path


def disc_springs(count):
    """Random indirect clutches whose closing spring, or both springs, are of discs."""
    for data in random_clutches(10_000, 7, ("indirect",)):
        if not count:
            return
        if "disc" in data["closing_spring"]:
            with contextlib.suppress(SpecError):
                yield build(make_spec(data))
                count -= 1


@pytest.mark.parametrize("count", [2, pytest.param(14, marks=pytest.mark.slow)])
def test_elasticities_with_disc_springs(count):
    """On either side, by differences of K_т extrapolated to no step; at a kink the two differ."""
    seen = set()
    for clutch in disc_springs(count):
        cut = {"gain_slope": clutch["gain_slope"]} if "gain_slope" in clutch else {}
        paths = {name: path for path, name in PATHS.items()}
        for path, found in elasticities(clutch).items():

            def factor(step, name=paths[path], clutch=clutch, cut=cut):
                given = clutch.given | cut
                at = Quantities(clutch.laws, given | {name: given[name] * np.exp(step)})
                return np.log(float(at["accuracy_factor"]))

            def difference(step, factor=factor):
                return (4 * factor(step) - factor(2 * step) - 3 * factor(0.0)) / (2 * step)

            for side, slope in ((-2e-5, found.slope), (2e-5, found.larger)):
                expected = (4 * difference(side / 2) - difference(side)) / 3
                assert slope == pytest.approx(expected, rel=1e-4, abs=1e-6), (path, side)
            seen.add((bool(cut), found.kink))
    assert count == 2 or seen >= {(False, False), (True, False), (True, True)}


@pytest.mark.parametrize("method", ["min-friction", "mean-friction"])
def test_a_mean_that_is_not_given_moves_with_the_range(method):
    base = read_spec(S21, ["friction.mean=", f"adjustment.method={method}"])
    for path in ("friction.min", "friction.max"):
        assert slopes(build(base))[path] == pytest.approx(numeric(base, path), abs=1e-6)


@given(st.one_of(direct_specs(), INDIRECT), st.lists(FRICTION, min_size=1, max_size=12))
def test_arrays_and_floats_agree_bit_for_bit(spec, friction):
    clutch = build(spec)
    own = ("travel", "torque_returning") if spec.kind.travels else ("breakaway_torque",)
    array = np.array(friction).reshape(1, -1, 1)
    for name in ("torque", "normal_force", "release_force", *own):
        values = clutch.at_friction(array, array)[name]
        assert values.shape == array.shape
        assert values.ravel().tolist() == [clutch.at_friction(f, f)[name] for f in friction], name


def test_the_threshold_of_the_gain(afmcalc):
    """2 R f_1/d = 0.6: below it is refused, at it the clutch is an ordinary one."""
    for arguments in (["torque", S21, "--set", "C=0.59"], ["accuracy", S21, "--sweep", "C=0.1:2:5"]):
        run = afmcalc(*arguments)
        assert (run.code, run.out, "control_unit.gain" in run.err) == (2, "", True)
    clutch = build(read_spec(S21, ["control_unit.gain=0.6"]))
    assert clutch.accuracy_factor == pytest.approx(8.0)
    assert [finding.code for finding in clutch_findings(clutch)] == ["feedback-idle"]
    assert clutch.at(friction=0.8)["travel"] == pytest.approx(0, abs=1e-15)


def test_wall_angle_in_place_of_the_gain():
    plain = build(read_spec(S21))
    angled = build(read_spec(S21, ["C=", f"control_unit.wall_angle={float(np.arctan(0.5))!r}"]))
    assert angled.at(friction=0.5)["torque"] == pytest.approx(plain.at(friction=0.5)["torque"])
    both = slopes(plain)["control_unit.gain"] + slopes(plain)["friction_group.mean_radius"]
    assert slopes(angled)["friction_group.mean_radius"] == pytest.approx(both)


def test_two_frictions_are_refused():
    clutch = afmcalc.load(S21)
    assert clutch.torque(0.3, 0.3) == clutch.torque(0.3)
    with pytest.raises(ValueError, match="one friction"):
        clutch.torque(0.3, 0.4)
