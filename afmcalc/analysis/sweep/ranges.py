"""Values of a swept key: as given, or over a sensible range."""

import math
import re

import numpy as np

from ...arrays import Floats
from ...engines import build
from ...errors import AfmcalcError, SpecError
from ...messages import say
from ...source import Unlikely
from ...spec import Spec
from ...spec.edit import respecified, value_at
from ...spec.models import FrictionRange
from ...spec.quantity import impossible, parse_quantity, unlikely
from ...spec.walk import Key
from .grid import MOST_POINTS

_MOST_COUNTED = 200
"""Whole numbers that are swept where no range is given."""


def parse_values(text: str, given: str, unit: str) -> Floats:
    """Read ``start:stop:count`` or ``v1,v2,…``; ``text`` is the whole option, for messages."""

    def number(part: str) -> float:
        part = part.strip()
        try:
            return parse_quantity(float(part), unit)
        except ValueError:
            pass
        try:
            return parse_quantity(part, unit)
        except ValueError as error:
            raise AfmcalcError(
                say("--sweep {text:.80}: {part!r:.80}: {why}", text=text, part=part, why=error)
            ) from None

    ranged = ":" in given or _RANGE.search(given)
    parts = given.split(":") if ranged else given.split(",")
    listed = parts[:2] if ranged else parts
    if len({_has_unit(part) for part in listed}) > 1:
        raise AfmcalcError(say("--sweep {text:.80}: give every value a unit, or none (SI)", text=text))
    if not ranged:
        return np.array([number(part) for part in parts])
    asked = parts[2].strip() if len(parts) == 3 else ""
    if not asked.isdecimal() or (len(asked) <= 4 and int(asked) < 2):
        raise AfmcalcError(
            say("--sweep {text:.80}: write start:stop:count with a whole count of at least 2", text=text)
        )
    if len(asked) > 10 or (count := int(asked)) > MOST_POINTS:
        raise AfmcalcError(
            say(
                "--sweep {text:.80}: {count:.20} points; at most {most:,} are swept",
                text=text,
                count=asked,
                most=MOST_POINTS,
            )
        )
    return np.linspace(number(parts[0]), number(parts[1]), count)


_RANGE = re.compile(r"\.\.|…|\d\s*(?:-|–|to)\s*\d")
"""How a range is written elsewhere."""


def doubted(text: str, given: str, key: Key, values: Floats) -> Unlikely | None:
    """Return the first of the values of a sweep that, given without a unit, may be meant in another than SI.

    Raises:
        AfmcalcError: one that cannot be meant in SI.
    """
    if _has_unit(given):
        return None
    found = [each for value in values.tolist() if (each := unlikely(value, key.unit, key.path))]
    if never := next((each for each in found if not each.possible), None):
        raise AfmcalcError(say("--sweep {text:.80}: {why}", text=text, why=impossible(never)))
    return next(iter(found), None)


def _has_unit(part: str) -> bool:
    return any(letter.isalpha() for letter in part.strip().lower().replace("e", ""))


def default_range(key: Key, spec: Spec) -> Floats:
    """Return a sensible range: the gain from 0 to its limit, counts one by one, else half to twice the value."""
    current = current_value(spec, key.path)
    group = spec.friction_group
    if key.path == "control_unit.gain":
        clutch = build(spec)
        limit = clutch.gain_limit
        start = float(clutch.gain_threshold or 0.0)
        return np.linspace(start, limit if limit is not None else max(2 * float(clutch.gain), start + 5.0), 26)
    if key.path == "control_unit.gain_slope":
        return np.linspace(0.0, 2 * float(build(spec).constant_torque_slope or 0.0), 41)
    if key.path == "friction_group.driving_pairs":
        return _whole(1, max(group.pairs - 1, 1))
    if key.path == "friction_group.pairs":
        return _whole(spec.least_pairs, 2 * group.pairs)
    if key.path == "adjustment.margin":
        return np.linspace(1.0, max(2.0, float(current or 1)), 21)
    if current is None:
        raise AfmcalcError(say("{path} is not in the spec: give a range, {path}=start:stop:count", path=key.path))
    about = key.about
    assert about is not None
    low, high = 0.5 * current, 2 * current
    if key.path.startswith("friction.") and key.path.rpartition(".")[2] in FrictionRange.model_fields:
        low, high = _friction_range(key.path, spec, low, high)
    if key.path == "control_unit.wall_angle":
        high = min(high, 1.5)
    low = low if about.low is None else max(low, about.low)
    high = high if about.high is None else min(high, about.high)
    low, high = (_feasible(spec, key.path, current, end) for end in (low, high))
    return _whole(math.ceil(low), math.floor(high)) if about.whole else np.linspace(low, high, 26)


def _whole(low: int, high: int) -> Floats:
    """Every whole number of a range, or as many as are worth a row each."""
    if high - low < _MOST_COUNTED:
        return np.arange(low, high + 1, dtype=float)
    return np.unique(np.rint(np.linspace(low, high, _MOST_COUNTED)))


def _feasible(spec: Spec, path: str, current: float, end: float) -> float:
    """Draw an end of a default range in to where the spec is valid and the clutch can be built."""

    def builds(value: float) -> bool:
        try:
            build(respecified(spec, {path: value}))
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


def _friction_block(path: str, spec: Spec) -> FrictionRange | None:
    """Return the friction that a coefficient at ``path`` belongs to: of all pairs, or of one group."""
    group = path.rpartition(".")[0]
    block: FrictionRange | None = value_at(spec, group)
    return None if group == "friction" and spec.friction.unlike else block


def _friction_range(path: str, spec: Spec, low: float, high: float) -> tuple[float, float]:
    """Keep a default range of friction within min ≤ mean ≤ max of its group."""
    block = _friction_block(path, spec)
    assert block is not None
    own, end = block.range, path.rpartition(".")[2]
    pinned = block.mean is not None
    if end == "min":
        return low, own.mean if pinned else own.max
    if end == "max":
        return own.mean if pinned else own.min, high
    return own.min, own.max


def current_value(spec: Spec, path: str) -> float | None:
    """Return the value at ``path`` as the engines see it; None when absent."""
    value: float | None = value_at(spec, path)
    if path.startswith("friction.") and (end := path.rpartition(".")[2]) in ("min", "mean", "max"):
        block = _friction_block(path, spec)
        value = None if block is None else getattr(block.range, end)
    if path == "friction_group.mean_radius":
        value = float(build(spec).mean_radius)
    return value
