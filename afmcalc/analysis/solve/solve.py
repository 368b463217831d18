"""From a wanted quantity back to one parameter: closed where the law can be inverted, else a bracketed root."""

import math
from collections.abc import Callable
from typing import Any, Literal, NamedTuple

from ...engines import build
from ...engines.protocol import Clutch
from ...errors import AfmcalcError, CalculationError, SpecError
from ...findings import Finding
from ...result import Result, quantity
from ...spec import Spec, make_spec, resolved
from ...spec.edit import ALTERNATIVES, put, value_at, with_value
from ...spec.paths import ALIASES, is_whole
from ...spec.rules import variants_of
from ...spec.suggest import did_you_mean
from .inverses import closed_inverse
from .targets import TARGETS, scatter

NAMES = ("C", "F", "z", "z1", "R", "c1", "c2")
"""Parameters that can be solved for, by symbol."""

_UNITS = {"C": "1", "F": "N", "z": "1", "z1": "1", "R": "m", "c1": "N/m", "c2": "N/m"}
_REPLACED = {**ALTERNATIVES, "closing_spring.force": ("adjustment.nominal_torque",)}
"""Keys that a solved one takes the place of; a force solved for replaces the torque it was set for."""
_SAME = 1e-9
"""Relative tolerance within which a wanted value counts as reached."""


class SolveResult(Result):
    """The value of one parameter that gives what is wanted, and the clutch it gives."""

    parameter: str = quantity("", None, "parameter solved for")
    path: str = quantity("", None, "spec path")
    unit: str = quantity("", None, "SI unit of the parameter")
    value: float = quantity("", None, "value found, SI")
    exact_value: float | None = quantity("", None, "value before rounding to a whole number", optional=True)
    target: str = quantity("", None, "wanted quantity")
    target_unit: str = quantity("", None, "SI unit of the target")
    wanted: float = quantity("", None, "wanted value, SI")
    reached: float = quantity("", None, "value reached, SI")
    method: Literal["closed-form", "bracketed-root"] = quantity("", None, "how it was found")
    gain: float = quantity("1", "C", "feedback gain")
    closing_force: float = quantity("N", "F_п", "closing-spring force as set")
    nominal_torque: float = quantity("N*m", "T_н", "nominal torque of the setting")
    torque_max: float = quantity("N*m", "T_max", "largest torque")
    scatter: float = quantity("N*m", "ΔT", "torque scatter band")
    accuracy_factor: float = quantity("1", "K_т", "accuracy factor")


class Domain(NamedTuple):
    """Values a parameter may take; ``why`` says what ends it above."""

    low: float
    high: float
    why: str


def solve(
    clutch: Clutch, name: str, target: str, wanted: float, *, beyond_limit: bool = False
) -> tuple[SolveResult, Clutch, list[Finding]]:
    """Find the value of a parameter that gives a clutch a wanted quantity.

    Args:
        clutch: the clutch to start from.
        name: parameter, one of ``NAMES``.
        target: a name of ``TARGETS``.
        wanted: its value, SI.
        beyond_limit: go past the gain limit of the variant.

    Returns:
        The result, the clutch with the value in it, and findings.

    Raises:
        CalculationError: not attainable; the message gives the best and where it is reached.
        AfmcalcError: the parameter is none of the variant's, or the target does not depend on it.
    """
    path = _path(clutch.spec, name)
    domain = _domain(clutch, name, beyond_limit)

    def value(x: float) -> float:
        return float(TARGETS[target].value(build(with_parameter(clutch.spec, path, x))))

    found, method = _exact(clutch, name, target, wanted, domain, value)
    chosen = found
    if is_whole(path):
        chosen = _whole(found, wanted, target, domain, value)
    if chosen is None:
        raise CalculationError(_not_attainable(name, target, wanted, domain, value))
    solved = build(solved_spec(clutch.spec, path, chosen))
    result = SolveResult(
        parameter=name,
        path=path,
        unit=_UNITS[name],
        value=chosen,
        exact_value=found if is_whole(path) else None,
        target=target,
        target_unit=TARGETS[target].unit,
        wanted=wanted,
        reached=TARGETS[target].value(solved),
        method=method,
        gain=solved.gain,
        closing_force=solved.closing_force,
        nominal_torque=solved.nominal_torque,
        torque_max=solved.torque_max,
        scatter=scatter(solved),
        accuracy_factor=solved.accuracy_factor,
    )
    return result, solved, [*solved.findings(), *_replaced(clutch.spec, path)]


def _path(spec: Spec, name: str) -> str:
    """Spec path of a parameter; refuse one that the variant does not have."""
    if name not in NAMES:
        raise AfmcalcError(f"--for {name}: cannot be solved for{did_you_mean(name, NAMES)}; one of {', '.join(NAMES)}")
    path = ALIASES[name]
    if (only := variants_of(path)) and spec.variant not in only:
        raise AfmcalcError(f"--for {name}: {path} is only for {', '.join(only)}, not {spec.variant!r}")
    return path


def with_parameter(spec: Spec, path: str, x: float) -> Spec:
    """Return the spec with an unvalidated (real) value at a path, its alternatives taken out."""
    for other in _REPLACED.get(path, ()):
        if value_at(spec, other) is not None:
            spec = with_value(spec, other.split("."), None)
    changed: Spec = with_value(spec, path.split("."), x)
    return changed


def solved_spec(spec: Spec, path: str, x: float) -> Spec:
    """Return the validated spec with the value found."""
    data = resolved(spec)
    for other in _REPLACED.get(path, ()):
        put(data, other, None)
    put(data, path, int(x) if is_whole(path) else x)
    return make_spec(data)


def _replaced(spec: Spec, path: str) -> list[Finding]:
    found = []
    for other in _REPLACED.get(path, ()):
        if value_at(spec, other) is not None:
            message = f"{other} of the spec gives way to the {path} found"
            found.append(Finding(level="info", code="solve-replaces", message=message, path=other))
    return found


def _domain(clutch: Clutch, name: str, beyond_limit: bool) -> Domain:
    """Return where to look: up to the gain limit, whole numbers of pairs as the variant allows."""
    spec, limit, rule = clutch.spec, clutch.gain_limit, clutch.spec.kind.gain_limit
    if name == "C":
        low = float(clutch.gain_threshold or 0.0)
        if limit is None or rule is None or beyond_limit:
            return Domain(low, math.inf, "")
        return Domain(low, float(limit), f"the gain limit {rule.rule}")
    most = None
    if rule is not None and clutch.gain > 0 and not beyond_limit:
        most = math.floor(rule.most(float(clutch.gain), clutch.friction[0].max) * (1 + _SAME))
    if name == "z":
        low = float(spec.least_pairs)
        if most is not None and rule is not None and rule.reduced is not None:
            return Domain(low, max(low, spec.bypass_pairs + most), f"the gain limit {rule.rule}")
        return Domain(low, math.inf, "")
    if name == "z1":
        all_but_one = spec.friction_group.pairs - 1
        if most is not None and rule is not None and rule.reduced is None and 1 <= most < all_but_one:
            return Domain(1.0, float(most), f"the gain limit {rule.rule}")
        return Domain(1.0, float(all_but_one), "one driven pair at least")
    return Domain(0.0, math.inf, "")


def _exact(
    clutch: Clutch, name: str, target: str, wanted: float, domain: Domain, value: Callable[[float], float]
) -> tuple[float | None, Literal["closed-form", "bracketed-root"]]:
    """Real value that gives the wanted one, within the domain; None when there is none."""
    inverse = closed_inverse(clutch, name, target)
    if inverse is not None:
        try:
            x = inverse(clutch, wanted)
        except (ZeroDivisionError, OverflowError):
            x = math.nan
        within = domain.low * (1 - _SAME) <= x <= domain.high * (1 + _SAME)
        if within and math.isfinite(x):
            x = min(max(x, domain.low), domain.high)
            if _close(_at(value, x), wanted):
                return x, "closed-form"
    return _root(value, wanted, domain), "bracketed-root"


def _at(value: Callable[[float], float], x: float) -> float:
    """Value at x; NaN where there is no clutch."""
    try:
        return value(x)
    except (SpecError, ZeroDivisionError, OverflowError):
        return math.nan


def _close(a: float, b: float) -> bool:
    return abs(a - b) <= _SAME * abs(b)


_STEPS = 400


def _samples(domain: Domain) -> list[float]:
    """Values over the domain from below; logarithmic where it has no end."""
    if math.isfinite(domain.high):
        return [domain.low + (domain.high - domain.low) * i / _STEPS for i in range(_STEPS + 1)]
    return [domain.low, *(domain.low + 10 ** (-9 + 24 * i / _STEPS) for i in range(_STEPS + 1))]


def _root(value: Callable[[float], float], wanted: float, domain: Domain) -> float | None:
    """First x at which the value is the wanted one, by bisection of a bracket; None without one."""
    samples = _samples(domain)
    if not math.isfinite(domain.high) and _close(_at(value, samples[-1]), wanted):
        # the limit itself: numbers reach it by rounding, no clutch does
        return None
    before: tuple[float, float] | None = None
    for x in samples:
        here = _at(value, x) - wanted
        if math.isnan(here):
            continue
        if abs(here) <= 1e-14 * abs(wanted):
            return x
        if before is not None and before[1] * here < 0:
            return _bisect(value, wanted, before, x)
        before = x, here
    return None


def _bisect(value: Callable[[float], float], wanted: float, start: tuple[float, float], high: float) -> float | None:
    """Narrow a bracket to the last bit; None where the sign changes by a jump, not by a root."""
    low, sign = start
    for _ in range(2000):
        middle = (low + high) / 2
        if middle in (low, high):
            break
        if (_at(value, middle) - wanted) * sign > 0:
            low = middle
        else:
            high = middle
    return high if abs(_at(value, high) - wanted) <= 1e-6 * abs(wanted) else None


def _whole(
    found: float | None, wanted: float, target: str, domain: Domain, value: Callable[[float], float]
) -> float | None:
    """Whole number that meets the wanted value: next to the real one, or the end of the domain that does."""
    meets = _meets(target, wanted, value)
    if found is not None:
        nearest = {float(math.floor(found * (1 + 1e-12))), float(math.ceil(found * (1 - 1e-12)))}
        near = sorted((x for x in nearest if domain.low <= x <= domain.high), key=lambda x: abs(x - found))
    else:
        near = [domain.low, *([domain.high] if math.isfinite(domain.high) else [])]
        near.sort(key=lambda x: abs(_at(value, x) - wanted))
    return next((x for x in near if meets(x)), None)


def _meets(target: str, wanted: float, value: Callable[[float], float]) -> Callable[[float], bool]:
    def meets(x: float) -> bool:
        here = _at(value, x)
        if TARGETS[target].better == "low":
            return here <= wanted * (1 + _SAME)
        return here >= wanted * (1 - _SAME)

    return meets


def _not_attainable(name: str, target: str, wanted: float, domain: Domain, value: Callable[[float], float]) -> str:
    """Say what is nearest to the wanted value, and where."""
    whole = is_whole(ALIASES[name])
    tried = [float(round(x)) for x in _samples(domain)] if whole else _samples(domain)
    states = [(x, here) for x in tried if domain.low <= x <= domain.high and not math.isnan(here := _at(value, x))]
    if not states:
        return f"{target} = {wanted:.6g} is not attainable by {name}: no value of {name} gives a clutch"
    values = [here for _, here in states]
    if max(values) - min(values) <= 1e-12 * abs(max(values)):
        return f"{target} does not depend on {name} here: it is {values[0]:.6g} {_unit(target)}for every value".rstrip()
    best_at, best = min(states, key=lambda state: (abs(state[1] - wanted), state[0]))
    unit = _unit(target)
    if not math.isfinite(domain.high) and abs(best - states[-1][1]) <= _SAME * abs(best):
        where = f"approached as {name} grows without end"
    elif best_at == domain.low and domain.low == 0 and name != "C":
        where = f"approached as {name} goes to 0"
    else:
        at = f"{best_at:.6g} {_UNITS[name]}".removesuffix(" 1")
        why = f" ({domain.why})" if best_at == domain.high and domain.why else ""
        where = f"reached at {name} = {at}{why}"
    return f"{target} = {wanted:.6g} {unit}is not attainable by {name}: the best is {best:.6g} {unit}, {where}".replace(
        " ,", ","
    )


def _unit(target: str) -> str:
    unit: Any = TARGETS[target].unit
    return "" if unit == "1" else f"{unit.replace('*', '·')} "
