"""Axes of a sweep: which key is meant, and the values to give it."""

from typing import Any

from ...engines import build
from ...errors import AfmcalcError, SpecError
from ...spec import Spec
from ...spec.edit import value_at, with_value
from ...spec.paths import ALIASES, Key, keys
from ...spec.rules import variants_of
from ...spec.suggest import did_you_mean
from .grid import MOST_POINTS, Axis


def find_key(name: str) -> Key:
    """Return the numeric spec key that ``name`` (a symbol or a path) means.

    Raises:
        AfmcalcError: no such key, or a key that is no number.
    """
    path = ALIASES.get(name, name)
    known = keys()
    if path not in known:
        symbols = ", ".join(ALIASES)
        hint = did_you_mean(name, [*ALIASES, *known])
        raise AfmcalcError(f"{name!r} is no spec path or symbol{hint}; symbols: {symbols}; paths: as in the spec")
    if known[path].unit is None:
        raise AfmcalcError(f"{name!r} is not a number and cannot be swept")
    return known[path]


def parse_axis(text: str, spec: Spec) -> Axis:
    """Read ``NAME``, ``NAME=start:stop:count`` or ``NAME=v1,v2,…`` (values in SI or with units).

    Raises:
        AfmcalcError: the text cannot be read.
    """
    name, separator, given = text.partition("=")
    name = name.strip()
    key = find_key("C" if name == "zC" else name)
    if (only := variants_of(key.path)) and spec.variant not in only:
        raise AfmcalcError(f"--sweep {text}: {key.path} is only for {', '.join(only)}, not {spec.variant!r}")
    unit = key.unit or "1"
    scale = 1 / (spec.friction_group.pairs - spec.bypass_pairs) if name == "zC" else 1.0

    values = parse_values(text, given, unit) if separator else default_range(key, spec) / scale
    return Axis(name, key, values, scale)


def parse_values(text: str, given: str, unit: str) -> Any:
    """Read ``start:stop:count`` or ``v1,v2,…``; ``text`` is the whole option, for messages."""
    import numpy as np

    from ...spec.quantity import parse_quantity

    def number(part: str) -> float:
        part = part.strip()
        try:
            return parse_quantity(float(part), unit)
        except ValueError:
            pass
        try:
            return parse_quantity(part, unit)
        except ValueError as error:
            raise AfmcalcError(f"--sweep {text}: {part!r}: {error}") from None

    parts = given.split(":") if ":" in given else given.split(",")
    listed = parts[:2] if ":" in given else parts
    if len({_has_unit(part) for part in listed}) > 1:
        raise AfmcalcError(f"--sweep {text}: give every value a unit, or none (SI)")
    if ":" not in given:
        return np.array([number(part) for part in parts])
    if len(parts) != 3 or not parts[2].strip().isdecimal() or int(parts[2]) < 2:
        raise AfmcalcError(f"--sweep {text}: write start:stop:count with a whole count of at least 2")
    count = int(parts[2])
    if count > MOST_POINTS:
        raise AfmcalcError(f"--sweep {text}: {count} points; at most {MOST_POINTS} are swept")
    return np.linspace(number(parts[0]), number(parts[1]), count)


def _has_unit(part: str) -> bool:
    return any(letter.isalpha() for letter in part.strip().lower().replace("e", ""))


def default_range(key: Key, spec: Spec) -> Any:
    """Return a sensible range: the gain from 0 to its limit, counts one by one, else half to twice the value."""
    import numpy as np

    current = current_value(spec, key.path)
    group = spec.friction_group
    if key.path == "control_unit.gain":
        clutch = build(spec)
        limit = clutch.gain_limit
        start = float(clutch.gain_threshold or 0.0)
        return np.linspace(start, limit if limit is not None else max(2 * float(clutch.gain), start + 5.0), 26)
    if key.path == "friction_group.driving_pairs":
        return np.arange(1, max(group.pairs, 2)).astype(float)
    if key.path == "friction_group.pairs":
        return np.arange(spec.least_pairs, 2 * group.pairs + 1).astype(float)
    if key.path == "adjustment.margin":
        return np.linspace(1.0, max(2.0, float(current or 1)), 21)
    if current is None:
        raise AfmcalcError(f"{key.path} is not in the spec: give a range, {key.path}=start:stop:count")
    low, high = 0.5 * current, 2 * current
    if key.path.startswith("friction."):
        low, high = _friction_range(key.path, spec, low, high)
    if key.path == "control_unit.wall_angle":
        high = min(high, 1.5)
    return np.linspace(_feasible(spec, key.path, current, low), _feasible(spec, key.path, current, high), 26)


def _feasible(spec: Spec, path: str, current: float, end: float) -> float:
    """Draw an end of a default range in to where the clutch can still be built (the key's threshold)."""

    def builds(value: float) -> bool:
        try:
            build(with_value(spec, path.split("."), value))
        except SpecError:
            return False
        return True

    inside = current
    if builds(end):
        return end
    for _ in range(60):
        middle = (inside + end) / 2
        inside, end = (middle, end) if builds(middle) else (inside, middle)
    return inside


def _friction_range(path: str, spec: Spec, low: float, high: float) -> tuple[float, float]:
    """Keep a default range of friction within min ≤ mean ≤ max of its group."""
    group, _, end = path.rpartition(".")
    block = spec.friction if group == "friction" else getattr(spec.friction, group.rpartition(".")[2])
    own = block.range
    pinned = block.mean is not None
    if end == "min":
        return low, own.mean if pinned else own.max
    if end == "max":
        return own.mean if pinned else own.min, high
    return own.min, own.max


def current_value(spec: Spec, path: str) -> Any:
    """Return the value at ``path`` as the engines see it; None when absent."""
    if path.startswith("friction.") and path.rpartition(".")[2] in ("min", "mean", "max"):
        block: Any = spec.friction
        for part in path.split(".")[1:-1]:
            block = getattr(block, part)
            if block is None:
                return None
        if block is spec.friction and spec.friction.unlike:
            return None
        return getattr(block.range, path.rpartition(".")[2])
    if path == "friction_group.mean_radius":
        return build(spec).mean_radius
    return value_at(spec, path)
