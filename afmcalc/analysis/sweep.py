"""A sweep: its axes as written on the command line, and the answers over their grid in one array expression."""

import math
import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import NamedTuple, TypeVar

import numpy as np

from ..engines import build
from ..engines.evaluate import BLOCK, Output, evaluate
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
from ..spec.removed import instead_of
from ..variants import variants_of

MOST_POINTS = 200_000
"""Points of a sweep: its answers take 0.3 GB then."""
_MOST_COUNTED = 200
"""Whole numbers that are swept where no range is given."""
_RANGE = re.compile(r"\.\.|…|\d\s*(?:-|–|to)\s*\d")
"""Ranges as other programs write them."""


class Axis(NamedTuple):
    """One swept key with its values, SI."""

    name: str
    """Symbol or path, as the user called it."""
    key: Key
    values: Floats
    """Values of the parameter as called."""
    scale: float = 1.0
    """Factor from a value to the spec key (zC → C)."""
    question: Finding | None = None
    """The first value without a unit that may be meant in another than SI."""

    @property
    def called_path(self) -> str:
        """Spec path; of zC, which is no key, its name in results."""
        return "reduced_gain" if self.name == "zC" else self.key.path


def find_key(name: str, spec: Spec, option: str = "--sweep") -> Key:
    """Return the numeric key of a spec that ``name`` (a path, a key's name or a symbol) means, given to an option.

    Raises AfmcalcError: no such key, a key that is no number, or one of other variants.
    """
    path, known = path_of(name), keys()
    if path is None:
        symbols = ", ".join(ALIASES)
        hint = instead_of(name) or elsewhere(name) or did_you_mean(name, [*ALIASES, *names()])
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

    Raises AfmcalcError: the text cannot be read.
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
    """Return a sensible range: the gain from 0 to its limit, counts one by one, else half to twice the value."""
    current, pairs = current_value(spec, key.path), spec.friction_group.pairs
    if key.path == "control_unit.gain":
        own = build(spec)
        start = float(own.get("gain_threshold", 0.0))
        return np.linspace(start, own.get("gain_limit", max(2 * float(own["gain"]), start + 5.0)), 26)
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
    """Every whole number of a range, or as many as are worth a row each."""
    if high - low < _MOST_COUNTED:
        return np.arange(low, high + 1, dtype=float)
    return np.unique(np.rint(np.linspace(low, high, _MOST_COUNTED)))


def feasible(spec: Spec, path: str, current: float, end: float) -> float:
    """Draw an end of a range in to where the spec is valid and the clutch can be built."""

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
    """Return the value at ``path`` as the engines see it; None when absent."""
    if path == "friction_group.mean_radius":
        return float(build(spec).mean_radius)
    group, _, end = path.rpartition(".")
    friction = None if group == "friction" and spec.friction.unlike else value_at(spec, group)
    if isinstance(friction, FrictionRange) and end in ("min", "mean", "max"):
        return getattr(friction.range, end)
    return value_at(spec, path)


def replaced(spec: Spec, axes: Sequence[Axis]) -> list[Finding]:
    """Say which keys of the spec a sweep has taken the place of, and ask after its numbers without a unit."""
    gone = edit.replaced(spec, [axis.key.path for axis in axes])
    asked = [axis.question for axis in axes if axis.question]
    return [*asked, *(finding("sweep-replaces", "info", path=path, by=by) for path, by in gone.items())]


def grid(axes: Sequence[Axis]) -> list[Floats]:
    """Coordinates of every point of the grid by axis, flat, the first axis slowest."""
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
    block: int = BLOCK,
) -> list[S] | None:
    """Sweep ``outputs`` over the grid of ``axes``, one series per axis; None without axes.

    ``open_at`` names the columns that have None where there is no finite number.
    """
    if not axes:
        return None
    points = grid(axes)
    values = {axis.key.path: given * axis.scale for axis, given in zip(axes, points, strict=True)}
    answers = {name: array.tolist() for name, array in evaluate(spec, values, outputs, block).items()}
    answers |= {
        name: [value if math.isfinite(value) else None for value in answers[name]]
        for name in open_at
        if name in answers
    }
    return [
        kind(parameter=axis.name, path=axis.called_path, unit=axis.key.unit or "1", values=given.tolist(), **answers)
        for axis, given in zip(axes, points, strict=True)
    ]
