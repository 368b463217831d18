"""Values of one key of the spec that give a quantity a wanted value: its range is sampled, crossings are refined."""

import math
from collections.abc import Callable
from contextlib import suppress
from functools import cache, partial
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ..engines import Clutch, build
from ..engines.checks import REQUIRED, after_event, takes_factor_of_event
from ..engines.evaluate import Output, evaluate
from ..engines.selection import NAMES
from ..equations.arrays import Floats
from ..equations.terms import CASES, TERMS, term_of
from ..errors import AfmcalcError, CalculationError, SpecError
from ..findings import Finding, finding
from ..messages import did_you_mean, latin, measured, say
from ..progress import counted, unwatched
from ..result import Answer, Result, described
from ..spec.edit import replaced, respecified, value_at
from ..spec.fields import Key
from ..spec.keys import is_whole, keys, path_of
from ..spec.quantity import Quantity, asked_unit
from ..units import ENGINEER
from .asking import Answers, Asking, answer, asked
from .check import lacks, simulating, told
from .clutch_findings import clutch_findings
from .simulate import dynamic_factors, largest_peaks
from .sweep import feasible, find_key
from .tolerance_study import exceedance

Function = Callable[[Floats], Floats]
SAMPLES, ROWS = 400, 40
"""Number of samples of the key: with arrays, and if clutches are calculated one at a time."""
REACH, REACH_OF_EVENTS = 100.0, 5.0
"""Ratio of the outermost samples to the present value: of a key without bounds, and if samples simulate an event."""
_SAME, _TOUCH = 1e-12, 1e-8
"""Relative tolerances: for equality apart from rounding, and for an extreme that only touches the wanted value."""
_CLOSE, _CLOSE_OF_ROWS = 1e-14, 1e-5
"""Relative tolerances of a root: with arrays, and clutch by clutch."""
_JUMP, _JUMP_OF_ROWS = 1e-6, 0.01
"""Deviation of the target at a crossing, relative to the wanted value, above which the crossing is a jump."""
SEVERAL = {"balls_listed", *(name for name in TERMS if "_slips" in name)}
"""Quantities that are lists of numbers (one number for each slip, or a catalogue) and therefore no targets."""


class Root(Result):
    """A value of the key, and what it gives."""

    value: float = described("value", unit_in="unit", digits=5)
    unit: str = described("unit", is_unit=True)
    reached: float = described("value reached", unit_in="target_unit", digits=5)
    target_unit: str = described("unit", is_unit=True)


class SolveResult(Asking, Answer):
    """Values of one key that give a quantity its wanted value, and the clutch with one of them."""

    rows_with_values: ClassVar[bool] = True

    parameter: str = described("parameter solved for")
    path: str = described("spec path")
    unit: str = described("SI unit of the parameter", is_unit=True)
    value: float = described("value found, the nearest to the present one", unit_in="unit", digits=5)
    target: str = described("wanted quantity")
    target_unit: str = described("SI unit of the target", is_unit=True)
    wanted: float = described("wanted value", unit_in="shown_unit", digits=5)
    reached: float = described("value reached", unit_in="shown_unit", digits=5)
    low: float = described("smallest value looked at", unit_in="unit", details=True)
    high: float = described("largest value looked at", unit_in="unit", details=True)
    roots: list[Root] = described("values found")
    gain: float = asked()
    closing_force: float = asked()
    nominal_torque: float = asked()
    torque_max: float = asked()
    scatter: float = asked()
    accuracy_factor: float = asked()

    @property
    def shown_unit(self) -> str:
        """Unit to show; ``K abs`` for a temperature, whose scale is not that of a temperature difference."""
        return unit_of(self.target)


def is_quantity(name: str) -> bool:
    """True if a name is a quantity that is one number, with or without a case, such as ``torque_at_f_max``."""
    inner, _, case = name.rpartition("_at_")
    if name in TERMS:
        return TERMS[name].unit != "" and name not in SEVERAL
    return case in CASES and is_quantity(inner)


def unit_of(target: str) -> str:
    """Return the SI unit of a target; ``K abs`` for a temperature."""
    return (keys()[f"requirements.{target}"].unit or "1") if target in REQUIRED else term_of(target).unit


def quantity_at(path: str) -> str:
    """Return the name of the quantity that a key sets: closing_force for closing_spring.force."""
    block, _, key = path.rpartition(".")
    return NAMES.get(block, {}).get(key, key).removesuffix("_made").removesuffix("_wanted")


@cache
def targets() -> dict[str, str]:
    """Name or symbol → name of a target; a symbol of several quantities means the quantity with the shortest name."""
    names = sorted(filter(is_quantity, TERMS), key=len, reverse=True)
    called = {keys()[f"requirements.{name}"].symbol or name: name for name in REQUIRED}
    called |= {TERMS[name].symbol: name for name in names} | {"K": "accuracy_factor"}
    return (
        {latin(symbol): name for symbol, name in called.items()} | called | {name: name for name in (*names, *REQUIRED)}
    )


def parse_target(text: str) -> tuple[str, float, list[Finding]]:
    """Read ``NAME=VALUE``; return name, SI value, and findings on a number without unit that is hardly meant in SI.

    Raises AfmcalcError if there is no such target, or if the value cannot be read.
    """
    given, _, value = (part.strip() for part in text.partition("="))
    path = path_of(given)
    name = targets().get(given) or (quantity_at(path) if path else given)
    if not (name in REQUIRED or is_quantity(name)):
        raise AfmcalcError(
            "{text!r:.80} is no target{hint}; write NAME=VALUE, NAME a quantity by its name in JSON or its symbol, "
            "or one of {known}",
            text=text, hint=did_you_mean(given, targets().values()), known=", ".join(REQUIRED),
        )  # fmt: skip
    if not value:
        raise AfmcalcError("{text:.80}: write {name}=VALUE", text=text.strip(), name=given)
    number: float | str = value
    with suppress(ValueError):
        number = float(value)
    about = (name in REQUIRED and keys()[f"requirements.{name}"].about) or Quantity(unit_of(name))
    try:
        wanted, question = about.read(number), asked_unit(number, unit_of(name), name)
    except ValueError as error:
        raise AfmcalcError("{text:.80}: {why}", text=text, why=error) from None
    return name, wanted, [question] if question else []


def solve(
    clutch: Clutch, name: str, target: str, wanted: float, *, beyond_limit: bool = False
) -> tuple[SolveResult, Clutch, list[Finding]]:
    """Find every value of a key that gives a target its wanted value; return also the clutch with the nearest value.

    The key is given by path, name or symbol, the target as ``parse_target`` returns it; with ``beyond_limit`` the key
    may exceed the gain limit of the variant. Without a root the result has the key value that comes nearest, and the
    last finding is ``not-attainable``. Raises CalculationError if the target does not depend on the key, or if no
    value of the key gives a number; AfmcalcError if there is no such key, or if the clutch does not have the target.
    """
    key = find_key(name, clutch.spec, "--for")
    values, arrays = _function(clutch, key.path, target)
    whole, now, shown, place = is_whole(key.path), _present(clutch, key), _shown(unit_of(target)), _shown(key.unit)
    reach = REACH if arrays or not simulating(clutch) else REACH_OF_EVENTS
    at = _samples(clutch, key, now, SAMPLES if arrays else ROWS, reach)
    if clutch.spec.kind.gain_limit is not None and not beyond_limit:
        at = _within_gain_limit(clutch, key.path, at)
    low, high = float(at[0]), float(at[-1])
    about: dict[str, Any] = {"target": target, "name": name, "low": place(low), "high": place(high), "count": at.size}
    if arrays and not whole:
        at = _with_extremes(values, wanted, at)
    gap, rounding = values(at) - wanted, _SAME * abs(wanted)
    if arrays and not wanted:  # rounding moves a target of 0 as the last digits of the key do
        moved = np.abs(values(np.clip(at * (1 + _SAME / 10), at[0], at[-1])) - values(at))
        rounding = 4 * float(np.max(moved, where=np.isfinite(moved), initial=0.0))
    on = np.abs(gap) <= rounding
    # of a stretch on which the target has the wanted value, its ends are roots
    places, crossed = {*np.flatnonzero(on).tolist()}, _crossed(np.where(on, 0.0, gap))
    roots = sorted(float(at[i]) for i in places if whole or not {i - 1, i + 1} <= places)
    if whole:
        roots = sorted({*roots, *at[crossed].tolist(), *at[crossed + 1].tolist()})
    elif crossed.size:
        close, jump = (_CLOSE, _JUMP) if arrays else (_CLOSE_OF_ROWS, _JUMP_OF_ROWS)
        met = np.array([_root(values, wanted, at[i], at[i + 1], close) for i in crossed])
        size = abs(wanted) or float(np.nanmedian(np.abs(values(at))))
        roots = sorted([*roots, *met[np.abs(values(met) - wanted) <= jump * size].tolist()])
        # where the target jumps, the nearest value lies on one side
        at = np.unique([*at, *met, *(met * (1 - 10 * close)), *(met * (1 + 10 * close))])
    value = values(at)
    at, value = at[np.isfinite(value)], value[np.isfinite(value)]
    if not at.size:
        raise CalculationError("{target}: no value of {name} gives a number", target=target, name=name)
    if at.size > 1 and np.allclose(value, value[0], _SAME, 0):
        raise CalculationError(
            "{target} does not depend on {name} here: it is {level} for every value",
            target=target, name=name, level=shown(value[0]),
        )  # fmt: skip
    nearest = float(at[np.argmin(np.abs(value - wanted))])
    if not roots and abs(values(np.array([nearest]))[0] - wanted) <= _TOUCH * abs(wanted):
        roots = [nearest]  # at a step between two samples, or at an extreme that only touches the wanted value
    found = roots or [nearest]
    value_of = partial(_judged_value, target=target)
    judged = partial(_rows, clutch, key.path, value_of) if not arrays and target in REQUIRED else values
    reached = dict(zip(found, judged(np.array(found)).tolist(), strict=True))

    def distance(root: float) -> tuple[bool, float]:
        """Sort key: roots that are whole numbers and miss a requirement last, then distance from the present value."""
        gap = reached[root] - wanted
        return whole and target in REQUIRED and (gap < 0 if REQUIRED[target].least else gap > 0), abs(root - now)

    chosen = min(reached, key=distance)
    solved = build(respecified(clutch.spec, {key.path: int(chosen) if whole else chosen}))
    units = {"unit": key.unit or "1", "target_unit": unit_of(target).removesuffix(" abs")}
    result = answer(
        SolveResult, solved, parameter=name, path=key.path, value=chosen, target=target, wanted=wanted,
        reached=reached[chosen], low=low, high=high, roots=[Root(value=x, reached=reached[x], **units) for x in roots],
        **units,
    )  # fmt: skip
    gone = replaced(clutch.spec, [key.path])
    remarks = [finding("solve-replaces", "info", path=path, by=by) for path, by in gone.items()]
    if (on[1:] & on[:-1]).any() and not whole:
        remarks.append(finding("solve-range", "info", path=key.path, **about))
    if not arrays:
        remarks.append(finding("solve-looked", "info", path=key.path, **about))
    if not roots:
        about |= {"required": shown(wanted), "best": shown(reached[nearest]), "place": place(nearest)}
        remarks.append(finding("not-attainable", "error", value=reached[nearest], limit=wanted, path=key.path, **about))
    return result, solved, [*clutch_findings(solved), *remarks]


def _shown(unit: str | None) -> Callable[[float], str]:
    return lambda value: measured(float(value), ENGINEER["K abs"] if unit == "K abs" else unit or "1")


def _present(clutch: Clutch, key: Key) -> float:
    """Value of a key, else of the quantity that it sets, else 0; raises AfmcalcError if the key cannot be set to it."""
    value = value_at(clutch.spec, key.path)
    if value is None:
        value = clutch.get(quantity_at(key.path), 0.0)
        try:
            build(respecified(clutch.spec, {key.path: value}))
        except SpecError:
            raise AfmcalcError(
                "{path} is not in the spec: give it a value to start from, with --set", path=key.path
            ) from None
    return float(value)


def _judged_value(clutch: Clutch, target: str) -> float:
    """Value that a requirement judges; infinite if the value is unlimited, or if the slip has not ended."""
    check = after_event(clutch.spec, REQUIRED[target])
    known = told(Answers(clutch), check.needs)
    if (value := check.value_of(known)) is None:
        needs = lacks(clutch, check)
        raise AfmcalcError("{name} cannot be solved for: it needs {needs}", name=target, needs=needs)
    return math.inf if check.value in (known.get("open") or ()) else float(value)


def _function(clutch: Clutch, path: str, target: str) -> tuple[Function, bool]:
    """Return the function from values of a key to a target, and True if it is fast: arrays without simulation.

    Raises AfmcalcError if the clutch does not have the target.
    """
    name = REQUIRED[target].value if target in REQUIRED else target
    output: Output = name
    if takes_factor_of_event(clutch.spec, name):  # each clutch has the dynamic factor of its own event
        output = lambda own: own.at(dynamic_factor=dynamic_factors(own))[name]  # noqa: E731
        return _kept(lambda at: evaluate(clutch.spec, {path: at}, {target: output})[target]), False
    arrays = not (target in REQUIRED and (REQUIRED[target].needs or name not in clutch))
    if arrays:
        try:
            with suppress(ArithmeticError):  # other values of the key may give a number
                clutch[name]
        except LookupError as error:
            raise AfmcalcError("{name} cannot be solved for: {why}", name=target, why=error) from None
    elif target == "peak_torque" and clutch.spec.drive.event is not None:
        output = largest_peaks
    else:
        _judged_value(clutch, target)
        judged = exceedance if target == "exceedance" else partial(_judged_value, target=target)
        return _kept(partial(_rows, clutch, path, judged)), False
    return _kept(lambda at: evaluate(clutch.spec, {path: at}, {target: output})[target]), arrays


def _kept(function: Function) -> Function:
    """Return a function with a cache, so that each value is calculated once."""
    known: dict[float, float] = {}

    def values(at: Floats) -> Floats:
        if new := [each for each in at.tolist() if each not in known]:
            known.update(zip(new, function(np.array(new)).tolist(), strict=True))
        return np.array([known[each] for each in at.tolist()])

    return values


def _rows(clutch: Clutch, path: str, value_of: Callable[[Clutch], float], at: Floats) -> Floats:
    """Values that a requirement judges, one clutch at a time; NaN if a clutch cannot be built or has no value."""
    value = np.full(at.shape, math.nan)
    for i in counted(say("solving"), range(at.size)):
        with suppress(AfmcalcError), unwatched():
            value[i] = value_of(build(respecified(clutch.spec, {path: at[i]})))
    return value


def _samples(clutch: Clutch, key: Key, now: float, count: int, reach: float) -> Floats:
    """Values of a key of the spec for which the clutch is valid: spaced evenly, over a wide range logarithmically."""
    assert key.about is not None
    (low, high), scale = key.about.limits, now or 1.0
    reach = reach if now else reach**3
    if key.about.whole:
        low = max(low, 0.0)
        high = min(high, max(low + count - 1, 2 * now))
        low, high = (round(feasible(clutch.spec, key.path, now, end)) for end in (low, high))
        return np.unique(np.rint(np.linspace(low, high, count)))
    if key.about.gt is not None or reach < REACH:
        low = max(low, scale / reach)
    low, high = (feasible(clutch.spec, key.path, now, end) for end in (low, min(high, reach * scale)))
    start = max(low, min(scale, high) / reach)
    if high <= 20 * low:
        return np.linspace(low, high, count)
    return np.unique([low, *np.geomspace(start, high, count)])


def _within_gain_limit(clutch: Clutch, path: str, at: Floats) -> Floats:
    """Samples within the gain limit, and the values of the key at which the limit is reached."""

    def excess(at: Floats) -> Floats:
        gains = evaluate(clutch.spec, {path: at}, {"gain": "gain", "gain_limit": "gain_limit"})
        return gains["gain"] / gains["gain_limit"] - 1

    met = [] if is_whole(path) else [_root(excess, 0.0, at[i], at[i + 1], _CLOSE) for i in _crossed(excess(at))]
    at = np.unique([*at, *met])
    within = at[excess(at) <= 1e-9]
    if not within.size:
        raise CalculationError("no value of {path} keeps the gain limit (--beyond-limit goes past it)", path=path)
    return within


def _crossed(gap: Floats) -> NDArray[np.intp]:
    """Places of the samples after which a function changes its sign."""
    return np.flatnonzero(np.sign(gap[:-1]) * np.sign(gap[1:]) < 0)


def _root(function: Function, wanted: float, low: float, high: float, close: float) -> float:
    """Argument between two others at which a function passes a wanted value, jumps past it, or has no value."""
    from scipy.optimize import brentq

    def gap(at: float) -> float:
        value = float(function(np.array([at]))[0]) - wanted
        return 0.0 if math.isnan(value) else value

    return float(brentq(gap, low, high, xtol=close * (high - low), rtol=close))


def _with_extremes(function: Function, wanted: float, at: Floats) -> Floats:
    """Samples with more values around each extreme that may reach the wanted value, and around the nearest sample."""
    for _ in range(5):
        gap = function(at) - wanted
        size, side = np.abs(gap), np.sign(gap)
        left, inner, right = size[:-2], size[1:-1], size[2:]
        lowest = (inner > 0) & (inner <= np.minimum(left, right)) & (np.abs(side[:-2] + side[1:-1] + side[2:]) == 3)
        middle = 1 + np.flatnonzero(lowest & ((2 * inner < np.maximum(left, right)) | (inner == np.nanmin(size))))
        at = np.unique([*at, *(x for i in middle[:20] for x in np.linspace(at[i - 1], at[i + 1], 33))])
    return at
