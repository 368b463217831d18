"""The direct law against a numerical solution of the axial balance; elasticities of both laws against differences."""

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
from afmcalc.spec.edit import value_at, with_key, with_values


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
    with pytest.raises(ValueError, match="one friction"):
        afmcalc.load(S21).torque(0.3, 0.4)


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


INDIRECT = st.one_of(indirect_specs(), indirect_specs(curved=True))
STEP = 1e-6


def difference(factor):
    """Elasticity by central difference of the logarithm of a function of a share."""
    return (np.log(float(factor(1 + STEP))) - np.log(float(factor(1 - STEP)))) / (2 * STEP)


def numeric(spec, path):
    value = value_at(spec, path)
    return difference(lambda share: build(with_values(spec, {path: value * share})).accuracy_factor)


def apart(own):
    """True if the mean of a range differs from both ends by more than the step of a difference."""
    return own.min * 1.0001 < own.mean < own.max * 0.9999


@given(direct_specs())
def test_elasticities_of_a_direct_clutch(spec):
    """Every continuous key is compared, and the pairs, which the law takes as real numbers."""
    clutch = build(spec)
    ranges = clutch.spec.friction.groups if spec.friction.unlike else ()
    # K_т = T_max/T_min has a kink where both are equal, and at a mean friction that is an end of the range
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
    """True if K_т has a derivative: the sleeve is far from a jump, and the extremes are not about to change places."""
    own = clutch.spec.friction.groups[0]
    if own.max < own.min * 1.0001 or (clutch.spec.adjustment.method == "mean-friction" and not apart(own)):
        return False  # K_т has a kink where the sleeve leaves its stop at an end of the range
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
        spec = with_key(spec, "adjustment.nominal_torque", clutch.nominal_torque)
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


@pytest.mark.parametrize("count", [2, pytest.param(6, marks=pytest.mark.slow)])
def test_elasticities_with_disc_springs(count):
    """On either side they agree with differences of K_т, extrapolated to a step of 0; at a kink the sides differ."""
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
    """A gain below 2 R f_1/d = 0.6 is refused; with this gain the clutch is an ordinary one."""
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
