"""Sweep of keys: axes as written on the command line, and quantities over their grid, calculated with arrays."""

import math
import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import NamedTuple, TypeVar

import numpy as np

from ..engines import build
from ..engines.evaluate import Output, evaluate
from ..equations.arrays import Floats
from ..errors import AfmcalcError, SpecError
from ..findings import Finding, finding
from ..messages import did_you_mean
from ..result import Series
from ..spec import Spec, edit
from ..spec.edit import respecified, value_at
from ..spec.fields import Key
from ..spec.keys import ALIASES, elsewhere, is_whole, keys, names, path_of
from ..spec.models import FrictionRange
from ..spec.quantity import asked_unit, parse_quantity
from ..variants import variants_of

MOST_POINTS = 200_000
"""Largest number of points of a sweep; the results of so many points take 0.3 GB."""
_MOST_COUNTED = 200
"""Largest number of values of a key with whole numbers, if no range is given."""
_RANGE = re.compile(r"\.\.|…|\d\s*(?:-|–|to)\s*\d")
"""Pattern of ranges that are not written as start:stop:count, such as 1..5, 1–5 or 1 to 5."""


class Axis(NamedTuple):
    """One swept key with its values, SI."""

    name: str
    """Symbol or path of the key, as the user wrote it."""
    key: Key
    values: Floats
    """Values of ``name``: for the name zC they are values of zC, not of C."""
    scale: float = 1.0
    """Factor that converts a value of ``name`` to the value of the spec key (zC → C)."""
    question: Finding | None = None
    """Finding on the first value without a unit that is hardly meant in SI."""

    @property
    def called_path(self) -> str:
        """Path of the key; ``reduced_gain`` for zC, which is no key."""
        return "reduced_gain" if self.name == "zC" else self.key.path


def find_key(name: str, spec: Spec, option: str = "--sweep") -> Key:
    """Return the numeric key of a spec by its path, name or symbol; ``option`` is for messages.

    Raises AfmcalcError if there is no such key, if it is not a number, or if only other variants have it.
    """
    path, known = path_of(name), keys()
    if path is None:
        symbols = ", ".join(ALIASES)
        hint = elsewhere(name) or did_you_mean(name, [*ALIASES, *names()])
        raise AfmcalcError(
            "{name!r:.80} is no key or symbol{hint}; symbols: {symbols}; keys: by name or path, as in the spec",
            name=name, hint=hint, symbols=symbols,
        )  # fmt: skip
    if known[path].unit is None:
        raise AfmcalcError("{name!r} is not a number", name=name)
    if (only := variants_of(path)) and spec.variant not in only:
        raise AfmcalcError(
            "{option} {name:.80}: {path} is only for {only}, not {variant!r}",
            option=option, name=name, path=path, only=", ".join(only), variant=spec.variant,
        )  # fmt: skip
    return known[path]


def parse_axis(text: str, spec: Spec) -> Axis:
    """Read ``NAME``, ``NAME=start:stop:count`` or ``NAME=v1,v2,…`` (values in SI or with units).

    Raises AfmcalcError if the text cannot be read.
    """
    name, separator, given = text.partition("=")
    name = name.strip()
    key = find_key("C" if name == "zC" else name, spec)
    scale = 1 / (spec.friction_group.pairs - spec.bypass_pairs) if name == "zC" else 1.0
    if not separator:
        return Axis(name, key, default_range(key, spec) / scale, scale)
    values = parse_values(text, given, key.unit or "1")
    try:
        asked = () if _has_unit(given) else [asked_unit(value, key.unit, key.path) for value in values.tolist()]
    except ValueError as error:
        raise AfmcalcError("--sweep {text:.80}: {why}", text=text, why=str(error)) from None
    return Axis(name, key, values, scale, next(filter(None, asked), None))


def parse_values(text: str, given: str, unit: str) -> Floats:
    """Read ``start:stop:count`` or ``v1,v2,…``; ``text`` is the whole option, for messages."""

    def number(part: str) -> float:
        value: float | str = part
        with suppress(ValueError):
            value = float(part)
        try:
            return parse_quantity(value, unit)
        except ValueError as error:
            raise AfmcalcError("--sweep {text:.80}: {part!r:.80}: {why}", text=text, part=part, why=error) from None

    ranged = ":" in given or _RANGE.search(given)
    parts = [part.strip() for part in given.split(":" if ranged else ",")]
    if len({_has_unit(part) for part in (parts[:2] if ranged else parts)}) > 1:
        raise AfmcalcError("--sweep {text:.80}: give every value a unit, or none (SI)", text=text)
    if not ranged:
        return np.array([number(part) for part in parts])
    asked = parts[2] if len(parts) == 3 else ""
    if not asked.isdecimal() or (len(asked) <= 4 and int(asked) < 2):
        raise AfmcalcError("--sweep {text:.80}: write start:stop:count with a whole count of at least 2", text=text)
    if len(asked) > 10 or (count := int(asked)) > MOST_POINTS:
        raise AfmcalcError(
            "--sweep {text:.80}: {count:.20} points; at most {most:,} are swept",
            text=text, count=asked, most=MOST_POINTS,
        )  # fmt: skip
    return np.linspace(number(parts[0]), number(parts[1]), count)


def _has_unit(part: str) -> bool:
    return any(letter.isalpha() for letter in part.lower().replace("e", ""))


def default_range(key: Key, spec: Spec) -> Floats:
    """Return the default values of an axis: gain from 0 to its limit, counts one by one, other keys half to twice."""
    current, pairs = current_value(spec, key.path), spec.friction_group.pairs
    if key.path == "control_unit.gain":
        own = build(spec)
        start = float(own.get("gain_threshold", 0.0))
        return np.linspace(start, own.get("gain_limit", max(2 * own["gain"], start + 5.0)), 26)
    if key.path == "control_unit.gain_slope":
        return np.linspace(0.0, 2 * float(build(spec).constant_torque_slope) if spec.kind.travels else 0.0, 41)
    if key.path == "friction_group.driving_pairs":
        return _whole(1, max(pairs - 1, 1))
    if key.path == "friction_group.pairs":
        return _whole(spec.least_pairs, 2 * pairs)
    if key.path == "adjustment.margin":
        return np.linspace(1.0, max(2.0, float(current or 1)), 21)
    if current is None:
        raise AfmcalcError("{path} is not in the spec: give a range, {path}=start:stop:count", path=key.path)
    assert key.about is not None
    least, most = key.about.limits
    ends = max(0.5 * current, least), min(2 * current, most, *[1.5] * (key.path == "control_unit.wall_angle"))
    low, high = (feasible(spec, key.path, current, end) for end in ends)
    return _whole(math.ceil(low), math.floor(high)) if key.about.whole else np.linspace(low, high, 26)


def _whole(low: int, high: int) -> Floats:
    """Whole numbers from ``low`` to ``high``, at most ``_MOST_COUNTED`` of them, evenly spaced."""
    if high - low < _MOST_COUNTED:
        return np.arange(low, high + 1, dtype=float)
    return np.unique(np.rint(np.linspace(low, high, _MOST_COUNTED)))


def feasible(spec: Spec, path: str, current: float, end: float) -> float:
    """Return ``end`` of a range or, if no clutch can be built there, the nearest value at which it can (bisection)."""

    def builds(value: float) -> bool:
        try:
            build(respecified(spec, {path: round(value) if is_whole(path) else value}))
        except SpecError:
            return False
        return True

    if builds(end):
        return end
    inside = current
    for _ in range(60):
        middle = (inside + end) / 2
        inside, end = (middle, end) if builds(middle) else (inside, middle)
    return inside


def current_value(spec: Spec, path: str) -> float | None:
    """Return the number at ``path`` or None; mean radius and mean friction may also follow from other keys."""
    if path == "friction_group.mean_radius":
        return float(build(spec).mean_radius)
    group, _, end = path.rpartition(".")
    friction = None if group == "friction" and spec.friction.unlike else value_at(spec, group)
    if isinstance(friction, FrictionRange) and end in ("min", "mean", "max"):
        return getattr(friction.range, end)
    return value_at(spec, path)


def replaced(spec: Spec, axes: Sequence[Axis]) -> list[Finding]:
    """Findings on keys of the spec that a sweep replaces, and on numbers without a unit in its axes."""
    gone = edit.replaced(spec, [axis.key.path for axis in axes])
    asked = [axis.question for axis in axes if axis.question]
    return [*asked, *(finding("sweep-replaces", "info", path=path, by=by) for path, by in gone.items())]


def grid(axes: Sequence[Axis]) -> list[Floats]:
    """Values at every point of the grid, one flat array per axis; the first axis varies slowest."""
    count = math.prod(axis.values.size for axis in axes)
    if count > MOST_POINTS:
        raise AfmcalcError(
            "the sweep asks for {count:,} points; at most {most:,} are swept", count=count, most=MOST_POINTS
        )
    if len({axis.key.path for axis in axes}) < len(axes):
        raise AfmcalcError("the same key is swept twice")
    if any(axis.name == "zC" for axis in axes) and any(axis.key.path.endswith("pairs") for axis in axes):
        raise AfmcalcError("zC and a number of pairs cannot be swept together: sweep C with it")
    return [coordinates.ravel() for coordinates in np.meshgrid(*(axis.values for axis in axes), indexing="ij")]


S = TypeVar("S", bound=Series)


def series(
    kind: type[S],
    spec: Spec,
    axes: Sequence[Axis],
    outputs: Mapping[str, Output],
    open_at: Sequence[str] = (),
) -> list[S] | None:
    """Sweep ``outputs`` (column → quantity) over the grid of ``axes``; return one series per axis, None without axes.

    ``open_at`` names the columns in which None replaces a number that is not finite.
    """
    if not axes:
        return None
    points = grid(axes)
    values = {axis.key.path: given * axis.scale for axis, given in zip(axes, points, strict=True)}
    answers = {name: array.tolist() for name, array in evaluate(spec, values, outputs).items()}
    answers |= {
        name: [value if math.isfinite(value) else None for value in answers[name]]
        for name in open_at
        if name in answers
    }
    return [
        kind(parameter=axis.name, path=axis.called_path, unit=axis.key.unit or "1", values=given.tolist(), **answers)
        for axis, given in zip(axes, points, strict=True)
    ]
