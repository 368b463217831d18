"""From a wanted quantity back to one parameter: closed where the law can be inverted, else a bracketed root."""

import math
from typing import Literal, TypeGuard

import numpy as np

from ...arrays import Floats
from ...engines import build
from ...engines.protocol import Clutch
from ...errors import AfmcalcError, CalculationError
from ...findings import Finding, finding
from ...messages import joined, measured, say
from ...result import Answer, quantity
from ...spec import Spec
from ...spec.edit import replaced, respecified, with_key
from ...spec.names import path_of
from ...spec.paths import ALIASES, is_whole
from ...spec.rules import variants_of
from ...spec.suggest import did_you_mean
from .domain import SAME, Domain, domain_of
from .inverses import closed_inverse
from .search import Curve, Function, explore, roots
from .targets import TARGETS

NAMES = ("C", "F", "z", "z1", "R", "c1", "c2", "gain_slope")
"""Parameters that can be solved for, by symbol."""

_UNITS = {"C": "1", "F": "N", "z": "1", "z1": "1", "R": "m", "c1": "N/m", "c2": "N/m", "gain_slope": "1/m"}


class NotAttainableError(CalculationError):
    """No value gives what is wanted; ``best`` is the nearest there is, ``at`` where, None where only approached."""

    def __init__(self, message: str, best: float, at: float | None) -> None:
        """Say it, and keep the numbers."""
        super().__init__(message)
        self.best, self.at = best, at


class SolveResult(Answer):
    """The value of one parameter that gives what is wanted, and the clutch it gives."""

    parameter: str = quantity("", None, "parameter solved for")
    path: str = quantity("", None, "spec path")
    unit: str = quantity("", None, "SI unit of the parameter", is_unit=True)
    value: float = quantity("", None, "value found", unit_in="unit")
    exact_value: float | None = quantity(
        "", None, "value before rounding to a whole number", optional=True, unit_in="unit"
    )
    target: str = quantity("", None, "wanted quantity")
    target_unit: str = quantity("", None, "SI unit of the target", is_unit=True)
    wanted: float = quantity("", None, "wanted value", unit_in="target_unit")
    reached: float = quantity("", None, "value reached", unit_in="target_unit")
    method: Literal["closed-form", "bracketed-root"] = quantity("", None, "how it was found")
    gain: float = quantity("1", "C", "feedback gain")
    closing_force: float = quantity("N", "F_п", "closing-spring force as set")
    nominal_torque: float = quantity("N*m", "T_н", "nominal torque of the clutch")
    torque_max: float = quantity("N*m", "T_max", "largest torque")
    scatter: float = quantity("N*m", "ΔT", "torque scatter band")
    accuracy_factor: float = quantity("1", "K_т", "accuracy factor")


def solve(
    clutch: Clutch, name: str, target: str, wanted: float, *, beyond_limit: bool = False
) -> tuple[SolveResult, Clutch, list[Finding]]:
    """Find the value of a parameter that gives a clutch a wanted quantity: the smallest, others in a finding.

    Args:
        clutch: the clutch to start from.
        name: parameter: one of ``NAMES``, or the name or path of its key.
        target: a name of ``TARGETS``.
        wanted: its value, SI.
        beyond_limit: go past the gain limit of the variant.

    Returns:
        The result, the clutch with the value in it, and findings.

    Raises:
        NotAttainableError: the message gives the best and where it is reached.
        CalculationError: the target does not depend on the parameter.
        AfmcalcError: the parameter is none of the variant's.
    """
    name = _symbol(name)
    path = _path(clutch.spec, name)

    def function(at: Floats) -> Floats:
        with np.errstate(all="ignore"):
            value = TARGETS[target].value(build(with_key(clutch.spec, path, at)))
        return np.broadcast_to(np.asarray(value, float), at.shape)

    domain = domain_of(clutch, name, beyond_limit=beyond_limit)
    curve = explore(function, wanted, domain)
    if len(curve.at) > 1 and np.ptp(curve.value) <= 1e-12 * abs(curve.value[0]):
        level = _with_unit(float(curve.value[0]), TARGETS[target].unit)
        raise CalculationError(
            say(
                "{target} does not depend on {name} here: it is {level} for every value",
                target=target,
                name=name,
                level=level,
            )
        )
    found = roots(function, wanted, curve)
    exact = _closed(clutch, name, target, wanted, curve, function)
    if exact is not None:
        found = sorted([exact, *(root for root in found if not _alike(root, exact))])
    chosen = _whole(found, wanted, target, domain, function) if is_whole(path) else found
    if not chosen:
        raise _not_attainable(name, target, wanted, domain, curve, function)
    if not is_whole(path) and _is_level(curve, wanted, chosen[0]):
        raise CalculationError(
            say(
                "{target} = {wanted} is given by a whole range of {name}, not by one value: choose one, or solve for "
                "another parameter",
                target=target,
                wanted=_with_unit(wanted, TARGETS[target].unit),
                name=name,
            )
        )
    solved = build(respecified(clutch.spec, {path: chosen[0]}))
    result = SolveResult(
        parameter=name,
        path=path,
        unit=_UNITS[name],
        value=chosen[0],
        exact_value=(found[0] if found else None) if is_whole(path) else None,
        target=target,
        target_unit=TARGETS[target].unit,
        wanted=wanted,
        reached=TARGETS[target].value(solved),
        method="closed-form" if found and found[0] == exact else "bracketed-root",
        gain=solved.gain,
        closing_force=solved.closing_force,
        nominal_torque=solved.nominal_torque,
        torque_max=solved.torque_max,
        scatter=solved.scatter,
        accuracy_factor=solved.accuracy_factor,
    )
    gone = [finding("solve-replaces", "info", path=other, by=path) for other in replaced(clutch.spec, [path])]
    return result, solved, [*solved.findings(), *gone, *_others(name, path, target, wanted, chosen[1:])]


def _is_level(curve: Curve, wanted: float, at: float) -> bool:
    """Whether the quantity keeps the wanted value beyond a place, as far as numbers tell."""
    beyond = curve.value[curve.at > at][:2]
    return len(beyond) == 2 and bool(np.all(np.abs(beyond - wanted) <= 1e-13 * abs(wanted)))


def _symbol(name: str) -> str:
    """Symbol of a parameter, however it is called."""
    path = path_of(name)
    for symbol in NAMES:
        if path == ALIASES[symbol]:
            return symbol
    named = [ALIASES[symbol] for symbol in NAMES]
    raise AfmcalcError(
        say(
            "--for {name:.80}: cannot be solved for{hint}; one of {names}",
            name=name,
            hint="" if path else did_you_mean(name, [*NAMES, *named, *(path.rpartition(".")[2] for path in named)]),
            names=", ".join(f"{symbol} ({ALIASES[symbol]})" for symbol in NAMES),
        )
    )


def _path(spec: Spec, name: str) -> str:
    """Spec path of a parameter; refuse one that the variant does not have."""
    path = ALIASES[name]
    if (only := variants_of(path)) and spec.variant not in only:
        raise AfmcalcError(
            say(
                "--for {name}: {path} is only for {only}, not {variant!r}",
                name=name,
                path=path,
                only=", ".join(only),
                variant=spec.variant,
            )
        )
    return path


def _closed(clutch: Clutch, name: str, target: str, wanted: float, curve: Curve, function: Function) -> float | None:
    """Value that the closed inverse gives; None where there is none, or it lies off the curve."""
    inverse = closed_inverse(clutch, name, target)
    if inverse is None or not len(curve.at):
        return None
    # a number of NumPy: what has no answer is NaN, not an exception of a kind of its own for each equation
    with np.errstate(all="ignore"):
        exact = inverse(np.float64(wanted))
    low, high = float(curve.at[0]), float(curve.at[-1])
    if not low * (1 - SAME) <= exact <= high * (1 + SAME):
        return None
    exact = min(max(exact, low), high)
    return exact if abs(float(function(np.array([exact]))[0]) - wanted) <= SAME * wanted else None


def _alike(root: float, exact: float) -> bool:
    return abs(root - exact) <= 1e-6 * abs(exact)


def _whole(found: list[float], wanted: float, target: str, domain: Domain, function: Function) -> list[float]:
    """Whole numbers that meet the wanted value: next to each real one, else the end of the domain that does."""
    tried = [_nearest(root, domain) for root in found]
    ends = np.array([end for end in (domain.low, domain.high) if math.isfinite(end)])
    tried.append(ends[np.argsort(np.abs(function(ends) - wanted), kind="stable")].tolist())
    meeting = [[x for x in near if _meets(x, wanted, target, function)][:1] for near in tried]
    numbers = list(dict.fromkeys(x for near in meeting[:-1] for x in near))
    return numbers or meeting[-1]


def _nearest(root: float, domain: Domain) -> list[float]:
    """Whole numbers beside a real one, the nearer first."""
    beside = {float(math.floor(root * (1 + 1e-12))), float(math.ceil(root * (1 - 1e-12)))}
    return sorted((x for x in beside if domain.low <= x <= domain.high), key=lambda x: abs(x - root))


def _meets(x: float, wanted: float, target: str, function: Function) -> bool:
    here = float(function(np.array([x]))[0])
    return here <= wanted * (1 + SAME) if TARGETS[target].better == "low" else here >= wanted * (1 - SAME)


def _others(name: str, path: str, target: str, wanted: float, others: list[float]) -> list[Finding]:
    """Name every further value that gives what is wanted."""
    if not others:
        return []
    listed = joined(say("{name} = {value}", name=name, value=_with_unit(x, _UNITS[name])) for x in others)
    given = _with_unit(wanted, TARGETS[target].unit)
    return [
        finding("solve-another-value", "info", value=others[0], path=path, target=target, wanted=given, others=listed)
    ]


def _not_attainable(
    name: str, target: str, wanted: float, domain: Domain, curve: Curve, function: Function
) -> CalculationError:
    """Say what is nearest to the wanted value, and where."""
    unit = TARGETS[target].unit

    def refusal(nearest: str) -> str:
        given = _with_unit(wanted, unit)
        return say(
            "{target} = {wanted} is not attainable by {name}: {nearest}",
            target=target,
            wanted=given,
            name=name,
            nearest=nearest,
        )

    at, value = curve.at, curve.value
    if is_whole(ALIASES[name]) and len(at):
        at = np.unique(np.clip(np.concatenate([np.floor(at), np.ceil(at)]), domain.low, domain.high))
        value = function(at)
    if not len(at):
        return CalculationError(refusal(say("no value of {name} gives a clutch", name=name)))
    # all on one side of the wanted value, unless the quantity jumps over it
    gap = np.abs(value - wanted)
    tied = np.flatnonzero(gap <= gap.min() + 1e-13 * abs(value[np.argmin(gap)]))
    best = tied[-1] if at[tied[-1]] == domain.high else tied[0]
    nearest, place = float(value[best]), float(at[best])

    def nearer(limit: float | None) -> TypeGuard[float]:
        return limit is not None and abs(nearest - wanted) - abs(limit - wanted) > 1e-12 * abs(limit)

    if nearer(limit := curve.limit_low):
        where = say("the best is {best}, approached as {name} goes to 0", best=_with_unit(limit, unit), name=name)
        return NotAttainableError(refusal(where), limit, None)
    if nearer(limit := curve.limit_high):
        where = say(
            "the best is {best}, approached as {name} grows without end", best=_with_unit(limit, unit), name=name
        )
        return NotAttainableError(refusal(where), limit, None)
    where = say(
        "the best is {best}, reached at {name} = {place}{why}",
        best=_with_unit(nearest, unit),
        name=name,
        place=_with_unit(place, _UNITS[name]),
        why=say(" ({why})", why=domain.why) if place == domain.high and domain.why else "",
    )
    return NotAttainableError(refusal(where), nearest, place)


def _with_unit(value: float, unit: str) -> str:
    return measured(value, "" if unit == "1" else unit.replace("*", "·"))
