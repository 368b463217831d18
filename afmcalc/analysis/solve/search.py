"""Search for a wanted value of a quantity: domain of the parameter, roots and extremes, closed-form inverses.

The engines take arrays, so that a curve is sampled at once, and a bracket is narrowed by sampling it again. This finds
kinks and smooth extremes alike, to the last bit. (Importing SciPy's root finders takes 0.4 s, a whole
``afmcalc solve`` 0.3 s.) What is asked of one clutch at a time, an event, a sample, a life, takes up to a second and is
known to some digits only: few values are looked at, and brackets are narrowed by secants.
"""

import math
from collections.abc import Callable
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...engines import Clutch, build
from ...equations import adjustment, indirect, synthesis
from ...equations.arrays import Floats, Values
from ...errors import CalculationError, SpecError
from ...messages import say
from ...spec import Spec
from ...spec.edit import with_key
from ...spec.keys import ALIASES, keys
from ...variants import GainLimit

SAME = 1e-9
"""Relative tolerance within which a wanted value counts as reached."""
Function: TypeAlias = Callable[[Floats], Floats]
Truths: TypeAlias = NDArray[np.bool_]

_STEP = 0.05
"""Step between two samples, in the logarithm of the distance from an end."""
_ROUNDING = 1e-13
"""Relative difference that rounding can make."""
_RUN = 20
"""Number of steady samples in a row that cannot be a chance of rounding."""
_ZOOM = 65
"""Number of samples in a bracket."""


class Domain(NamedTuple):
    """Values a parameter may take."""

    low: float
    low_taken: bool
    """Whether the low end belongs to the domain."""
    high: float
    """The high end, which belongs to the domain unless it is infinite."""
    why: str
    """Text: what limits the domain at the high end."""


def domain_of(clutch: Clutch, name: str, *, beyond_limit: bool) -> Domain:
    """Return the values of a parameter that give a clutch and, unless ``beyond_limit``, keep the gain within its limit.

    Raises:
        CalculationError: no value keeps the gain within its limit.
    """
    spec = clutch.spec
    about = keys()[ALIASES[name]].about
    assert about is not None
    low, low_taken = max(about.limits[0], 0.0), about.gt is None
    ends = [(math.inf, "")]
    low = float(
        clutch.gain_threshold if name == "C" and spec.kind.travels else spec.least_pairs if name == "z" else low
    )
    if name == "z1":
        ends.append((float(spec.friction_group.pairs - 1), say("one driven pair at least")))
    if name == "R":
        ends.append(
            (_threshold_radius(clutch) if spec.kind.travels else math.inf, say("the feedback ends, C = 2 R f_1/d"))
        )
    if spec.kind.gain_limit is not None and not beyond_limit:
        end = _gain_limit(clutch, spec.kind.gain_limit, name)
        if about.whole and math.isfinite(end):
            end = float(math.floor(end * (1 + SAME)))
        rule = spec.kind.gain_limit.rule
        if end < low:
            raise CalculationError(
                "no value of {name} keeps C = {gain:.6g} within the gain limit {rule} (--beyond-limit goes past it)",
                name=name,
                gain=float(clutch.gain),
                rule=rule,
            )
        ends.append((end, say("the gain limit {rule}", rule=rule)))
    high, why = min(ends, key=lambda end: end[0])
    return Domain(low, low_taken, high, why)


def _gain_limit(clutch: Clutch, limit: GainLimit, name: str) -> float:
    """Largest value of a parameter at which the gain is within its limit; infinite without such a value."""
    most, gain = float(clutch.gain_limit), float(clutch.gain)
    if name == "C":
        return most
    if gain == 0:
        return math.inf
    if name == "R" and _angle_given(clutch.spec):
        return float(clutch.mean_radius) * most / gain
    pairs = float(limit.most(gain, clutch.friction[0].max))
    if name == "z" and limit.reduced is not None:
        return float(clutch.bypass_pairs) + pairs
    if name == "z1" and limit.reduced is None:
        return pairs
    return math.inf


def _angle_given(spec: Spec) -> bool:
    """Whether the gain follows from a wall angle."""
    return spec.control_unit is not None and spec.control_unit.wall_angle is not None


def _threshold_radius(clutch: Clutch) -> float:
    """Largest R with 2 R f_1/d up to C; infinite with a given wall angle, where C grows with R as well."""
    if not clutch.gain_threshold or _angle_given(clutch.spec):
        return math.inf
    end = float(clutch.mean_radius * clutch.gain / clutch.gain_threshold)
    while True:
        try:
            build(with_key(clutch.spec, "friction_group.mean_radius", end))
        except SpecError:
            end = math.nextafter(end, 0.0)
        else:
            return end


class Curve(NamedTuple):
    """Samples of the quantity over its domain, with every extreme that is nearest to the wanted value from one side."""

    at: Floats
    """Values of the parameter, rising."""
    value: Floats
    limit_low: float | None
    """Limit of the quantity towards a low end that is not in the domain; None where it is, or without a limit."""
    limit_high: float | None
    """Limit of the quantity as the parameter grows for ever; None where there is no limit."""


def explore(function: Function, wanted: float, domain: Domain) -> Curve:
    """Sample a quantity over a domain and refine its extremes on the wanted value's side.

    The curve leaves out samples that equal a limit by rounding only.
    """
    at = _samples(domain)
    value = function(at)
    at, value = at[np.isfinite(value)], value[np.isfinite(value)]
    if not len(at):
        return Curve(at, value, None, None)
    low = 0 if domain.low_taken else _approached(value)
    high = lost = 0
    if not math.isfinite(domain.high):
        high = _approached(value[::-1])
        # rounding rules the last samples, which change by more than ``SAME`` in a step of ``_ROUNDING``
        steady = np.abs(function(at * (1 + _ROUNDING)) - value) < SAME * np.abs(value)
        runs = np.convolve(steady, np.ones(_RUN), "valid") == _RUN
        lost = int(np.argmax(runs[::-1]))
    limit_low, limit_high = float(value[0]) if low else None, float(value[-1]) if high else None
    kept = slice(low, len(value) - max(high, lost))
    at, value = at[kept], value[kept]
    if lost > high:
        # by L + a/x from its last decade
        near, far = len(at) - 1, max(len(at) - 1 - round(math.log(10) / _STEP), 0)
        limit = (value[near] * at[near] - value[far] * at[far]) / (at[near] - at[far])
        limit_high = float(limit) if abs(limit) > 1e-3 * abs(value[near]) else 0.0
    return Curve(*_with_extremes(function, wanted, at, value), limit_low, limit_high)


def roots(function: Function, wanted: float, curve: Curve) -> list[float]:
    """Return every value of the parameter at which the quantity is the wanted one: crossed, touched or at an end."""
    at, gap = curve.at, curve.value - wanted
    if not len(at):
        return []
    side = np.where(np.abs(gap) <= _ROUNDING * abs(wanted), 0.0, np.sign(gap))
    crossed = np.flatnonzero(side[:-1] * side[1:] < 0)
    places = [root for i in crossed if (root := _crossing(function, wanted, at[i], at[i + 1])) is not None]
    on = side == 0
    for i in np.flatnonzero(on & ~np.concatenate([[False], on[:-1]])):
        # where the curve stays on the wanted value, the root is the begin of that stretch
        stretch = 0 < i < len(on) - 1 and on[i + 1]
        places.append(
            _edge(lambda x: np.abs(function(x) - wanted) <= _ROUNDING * wanted, at[i - 1], at[i])[1]
            if stretch
            else float(at[i])
        )
    near = ~on & (np.abs(gap) <= SAME * abs(wanted)) & _lowest(np.abs(gap))
    near[crossed] = near[crossed + 1] = False
    # an end that is not in the domain cannot be a root
    near[0] &= curve.limit_low is None
    near[-1] &= curve.limit_high is None
    near[:-1] &= ~on[1:]
    near[1:] &= ~on[:-1]
    return sorted([*places, *at[near].tolist()])


def _samples(domain: Domain) -> Floats:
    """Values over a domain, dense towards its ends; logarithmic where it has no end."""
    if math.isfinite(domain.high):
        inner = domain.low + (domain.high - domain.low) / (1 + np.exp(-np.arange(-30, 30, _STEP)))
    else:
        inner = domain.low + np.exp(np.arange(-30, 40, _STEP))
    ends = [*([domain.low] if domain.low_taken else []), *([domain.high] if math.isfinite(domain.high) else [])]
    inner = inner[(inner > domain.low) & (inner < domain.high)]
    return np.unique(np.concatenate([inner, ends]))


def _approached(value: Floats) -> int:
    """Number of first samples that equal the limit by rounding only, as no clutch reaches a limit."""
    away = np.abs(value - value[0]) > SAME * abs(value[0])
    count = int(np.argmax(away))
    # samples that are level to the last digit do reach their value
    return count if abs(value[count - 1] - value[0]) > _ROUNDING * abs(value[0]) else 0


def _lowest(gap: Floats) -> Truths:
    """Where neither neighbour is lower."""
    padded = np.concatenate([[np.inf], gap, [np.inf]])
    return np.logical_and(gap <= padded[:-2], gap <= padded[2:])


def _with_extremes(function: Function, wanted: float, at: Floats, value: Floats) -> tuple[Floats, Floats]:
    """Add the extremes that come nearest to the wanted value from either side, each narrowed from its bracket."""
    gap, side = np.abs(value - wanted), np.sign(value - wanted)
    bracketed = _lowest(gap)
    bracketed[[0, -1]] = False
    extremes = []
    for i in np.flatnonzero(bracketed):
        level = max(gap[i - 1], gap[i + 1]) - gap[i] <= SAME * (abs(value[i]) + abs(wanted))
        if level or not side[i - 1] == side[i] == side[i + 1]:
            continue
        low, high = at[i - 1], at[i + 1]
        for _ in range(12):
            inside = np.linspace(low, high, _ZOOM)
            k = int(np.argmin(side[i] * function(inside)))
            low, high = inside[max(k - 1, 0)], inside[min(k + 1, _ZOOM - 1)]
        extremes.append(inside[k])
    at = np.unique(np.append(at, extremes))
    return at, function(at)


def _crossing(function: Function, wanted: float, low: float, high: float) -> float | None:
    """Where the quantity crosses the wanted value in a bracket; None where it jumps over it."""
    ends = np.array(_edge(lambda at: function(at) > wanted, low, high))
    gap = np.abs(function(ends) - wanted)
    return float(ends[np.argmin(gap)]) if min(gap) <= 1e-6 * abs(wanted) else None


def _edge(holds: Callable[[Floats], Truths], low: float, high: float) -> tuple[float, float]:
    """Narrow a bracket at whose ends a condition differs until no number lies between them."""
    while True:
        at = np.linspace(low, high, _ZOOM)
        there = holds(at)
        i = int(np.argmax(there != there[0]))
        if at[i - 1] == low and at[i] == high:
            return float(low), float(high)
        low, high = at[i - 1], at[i]


_AT_SETTING = ("nominal_torque", "closing_force", "control_force")
"""Targets proportional to the spring force with any pocket, as the sleeve is at its stop."""
_PROPORTIONAL = (*_AT_SETTING, "torque_min", "torque_max", "scatter", "travel_max")
"""Targets proportional to the spring force."""


def closed_inverse(clutch: Clutch, name: str, target: str, now: float, wanted: float) -> Values | None:
    """Value of a parameter that gives what is wanted of a target that is ``now``; None without a closed formula."""
    unit, straight = clutch.spec.control_unit, "gain_slope" not in clutch.quantities
    # a constant-torque pocket: its C_1 falls with the force as the travel grows, so that C_1 x does not change
    follows = unit is not None and unit.pocket is not None
    if name == "F" and target in (_PROPORTIONAL if straight or follows else _AT_SETTING):
        return adjustment.closing_force(wanted, 1.0, now / float(clutch.closing_force))
    if not clutch.spec.kind.travels:
        if target == "accuracy_factor":
            return _for_accuracy(clutch, name, wanted)
        # with the spring set for a nominal torque, the torques no longer follow the law at fixed force
        if clutch.spec.closing_spring.force is not None:
            return _for_torque(clutch, name, target, wanted)
    elif straight and target == "accuracy_factor":
        return _for_indirect_accuracy(clutch, name, wanted)
    elif (name, target) == ("C", "control_force"):
        at_setting = clutch.closing_force, clutch.pairs, clutch.friction_set
        return indirect.net_gain_for_control_force(wanted, *at_setting) + clutch.gain_threshold
    return None


def _for_accuracy(clutch: Clutch, name: str, wanted: float) -> Values | None:
    first, second = clutch.friction
    z1, z2 = clutch.bypass_pairs, clutch.controlled_pairs
    if name == "C":
        return synthesis.gain_for_accuracy_factor(z1, z2, wanted, first.min, second.min, first.max, second.max)
    if name not in ("z", "z1") or clutch.spec.friction.unlike:
        return None
    controlled = synthesis.controlled_pairs_for_accuracy_factor(clutch.gain, wanted, first.min, first.max)
    return z1 + controlled if name == "z" else z1 + z2 - controlled


def _for_torque(clutch: Clutch, name: str, target: str, wanted: float) -> Values | None:
    if target == "nominal_torque":
        friction = clutch.friction_driving_set, clutch.friction_driven_set
        torque = clutch.margin_in_spring * wanted
    elif target == "torque_max" and not clutch.spec.friction.unlike:
        friction, torque = (clutch.friction[0].max, clutch.friction[0].max), wanted
    else:
        return None
    force, radius, gain = clutch.closing_force, clutch.mean_radius, clutch.gain
    z1, z2 = clutch.bypass_pairs, clutch.controlled_pairs
    if name == "C":
        return synthesis.gain_for_torque(torque, force, radius, z1, z2, *friction)
    if name == "z":
        # added pairs are controlled ones; without a control unit the gain is 0, and these carry like bypass pairs
        kept = z1 if z2 else 0
        return kept + synthesis.controlled_pairs_for_torque(torque, force, radius, kept, gain, *friction)
    if name == "R" and not _angle_given(clutch.spec):
        return synthesis.mean_radius_for_torque(torque, force, z1, z2, gain, *friction)
    return None


def _for_indirect_accuracy(clutch: Clutch, name: str, wanted: float) -> Values | None:
    frictions = clutch.friction[0].min, clutch.friction_set, clutch.friction[0].max
    c1, c2, pairs, net = clutch.closing_stiffness, clutch.control_stiffness, clutch.pairs, clutch.net_gain
    if name in ("C", "z"):
        low, _, high = frictions
        linear = synthesis.net_loop_gain_linear(*frictions, c1, c2, wanted)
        constant = synthesis.net_loop_gain_constant(low, high, c1, c2, wanted)
        loop = synthesis.net_loop_gain_for_accuracy_factor(*frictions, c1, wanted, linear, constant)
        if name == "z":
            return synthesis.pairs_for_accuracy_factor_indirect(loop, net)
        return synthesis.net_gain_for_accuracy_factor(loop, pairs) + clutch.gain_threshold
    if name not in ("c1", "c2"):
        return None
    ratio = synthesis.stiffness_ratio_for_accuracy_factor(*frictions, pairs, net, wanted)
    return c2 / ratio if name == "c1" else c1 * ratio


STEPS = 1e-2
"""Jump, relative to the step between two values, below which the quantity only comes in the steps of a sample."""
_CLOSE = 1e-10
"""Relative width to which a bracket is narrowed."""


def places(domain: Domain, now: float | None, count: int, reach: float, *, whole: bool) -> Floats:
    """Values to look at: even steps over a domain that ends, and even ratios from now/reach to now times reach."""
    around = now * np.geomspace(1 / reach, reach, count) if now else np.zeros(0)
    if math.isfinite(domain.high):
        around = np.concatenate([around, np.linspace(domain.low, domain.high, count)])
    around = np.round(around) if whole else around
    low = around >= domain.low if domain.low_taken else around > domain.low
    return np.unique(around[low & (around <= domain.high)])


def looked(function: Function, wanted: float, at: Floats) -> tuple[Curve, list[float]]:
    """Return the quantity where it is known, and one root for each pair of neighbours that it passes without a jump.

    Where all miss the wanted value on the same side, the extreme next to it is looked for.
    """
    from scipy.optimize import brentq, minimize_scalar

    def gap(x: float) -> float:
        # what has no end is far away
        return float(np.clip(function(np.array([x]))[0] - wanted, -10 * wanted, 10 * wanted))

    at = at[~np.isnan(function(at))]
    value = function(at)
    side = np.sign(value - wanted)
    k = int(np.argmin(np.abs(value - wanted))) if len(at) else 0
    if 0 < k < len(at) - 1 and bool((side == side[0]).all()):
        towards, ends = side[0], (at[k - 1], at[k + 1])
        within = {"xatol": 1e-4 * (ends[1] - ends[0])}
        extreme = minimize_scalar(
            lambda x: towards * function(np.array([x]))[0], bounds=ends, method="bounded", options=within
        )
        at = np.insert(at, k + int(extreme.x > at[k]), extreme.x)
        value = function(at)
        side = np.sign(value - wanted)
    on = np.append(False, side == 0)
    solutions, jumps = at[on[1:] & ~on[:-1]].tolist(), []
    for i in np.flatnonzero(side[:-1] * side[1:] < 0):
        try:
            root = brentq(gap, at[i], at[i + 1], xtol=_CLOSE * at[i + 1], rtol=_CLOSE)
        except ValueError:  # it is not known somewhere between
            continue
        beside = np.clip([root * (1 - 2 * _CLOSE), root * (1 + 2 * _CLOSE)], at[i], at[i + 1])
        step = min(wanted, abs(value[i + 1] - value[i]))
        if bool((np.abs(function(beside) - wanted) <= STEPS * step).all()):
            solutions.append(root)
        else:
            jumps += beside.tolist()
    at = np.sort(np.append(at, jumps))
    return Curve(at, function(at), None, None), sorted(solutions)
