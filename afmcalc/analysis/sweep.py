"""Sweeps: any numeric key of the spec over a range of values, one array expression for all points."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from ..engines import build
from ..engines.findings import Finding
from ..engines.protocol import Clutch
from ..errors import AfmcalcError, SpecError
from ..spec import Spec, make_spec
from ..spec.paths import ALIASES, Key, is_whole, keys
from ..spec.rules import variants_of
from ..spec.suggest import did_you_mean
from .result import Series

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

ALTERNATIVES = {
    "control_unit.gain": ("control_unit.wall_angle",),
    "control_unit.wall_angle": ("control_unit.gain",),
    "friction_group.mean_radius": (
        "friction_group.inner_radius",
        "friction_group.outer_radius",
        "friction_group.radius_model",
    ),
    "adjustment.nominal_torque": ("closing_spring.force",),
    "friction.min": ("friction.material",),
    "friction.mean": ("friction.material",),
    "friction.max": ("friction.material",),
}
"""Keys that a swept key stands in for: they are taken out of the spec."""

MOST_POINTS = 2_000_000


class Axis(NamedTuple):
    """One swept key with its values, SI."""

    name: str
    """As the user called it: a symbol or a path."""
    key: Key
    values: "NDArray[np.float64]"
    """Values of the parameter as called."""
    scale: float = 1.0
    """What a value is multiplied by to give the spec key (zC → C)."""


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

    from ..spec.quantity import parse_quantity

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
        start = getattr(clutch, "gain_threshold", 0.0)
        return np.linspace(start, limit if limit is not None else max(2 * float(clutch.gain), start + 5.0), 26)
    if key.path == "friction_group.driving_pairs":
        return np.arange(1, max(group.pairs, 2)).astype(float)
    if key.path == "friction_group.pairs":
        return np.arange(spec.bypass_pairs + 1 if spec.variant == "differentiated" else 1, 2 * group.pairs + 1).astype(
            float
        )
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


def value_at(spec: Spec, path: str) -> Any:
    """Return the value at ``path`` as given; None when absent."""
    value: Any = spec
    for part in path.split("."):
        value = getattr(value, part, None)
    return value


def clutch_over(spec: Spec, values: Mapping[str, Any]) -> Clutch:
    """Build the clutch of ``spec`` with arrays in place of the numbers at some paths.

    Every constraint of the spec bounds one value or orders two, so that the extremes of the arrays stand
    for all their elements: those are validated, then the arrays go through the same engine as numbers do.

    Args:
        spec: the spec.
        values: path → array, SI; shapes broadcast.

    Returns:
        A clutch whose answers are arrays.

    Raises:
        SpecError: a value no spec may have.
    """
    import numpy as np

    arrays = {path: np.asarray(array, float) for path, array in values.items()}
    for path, array in arrays.items():
        if array.size == 0:
            raise AfmcalcError(f"{path}: no values to sweep")
        if is_whole(path) and bool(np.any(array != np.floor(array))):
            wrong = float(array[array != np.floor(array)].ravel()[0])
            raise AfmcalcError(f"--sweep {path}: {wrong:g} is not a whole number")
    data = spec.model_dump(exclude_none=True)
    for path in arrays:
        for other in ALTERNATIVES.get(path, ()):
            if other not in arrays:
                if other == "friction.material" and spec.friction.material is not None:
                    low, _, high = spec.friction.range
                    data["friction"] = {"min": low, "max": high}
                put(data, other, None)
    valid = None
    for extreme in _corners(arrays):
        valid = _validated(data, extreme)
    assert valid is not None
    for path, array in arrays.items():
        valid = with_value(valid, path.split("."), array)
    return build(valid)


def replaced(spec: Spec, axes: Sequence[Axis]) -> list[Finding]:
    """Say which keys of the spec a sweep has taken the place of."""
    swept = {axis.key.path for axis in axes}
    found = []
    for path in sorted(swept):
        for other in ALTERNATIVES.get(path, ()):
            if other not in swept and value_at(spec, other) is not None:
                message = f"{other} of the spec gives way to the swept {path}"
                found.append(Finding(level="info", code="sweep-replaces", message=message, path=other))
    return found


def _corners(arrays: Mapping[str, Any]) -> list[dict[str, float]]:
    """Every combination of smallest and largest values (one swept key: two of them)."""
    corners: list[dict[str, float]] = [{}]
    for path, array in arrays.items():
        ends = dict.fromkeys((float(array.min()), float(array.max())))
        corners = [{**corner, path: end} for corner in corners for end in ends]
    return corners


def _validated(data: Mapping[str, Any], extreme: Mapping[str, float]) -> Spec:
    import copy

    trial = copy.deepcopy(dict(data))
    for path, value in extreme.items():
        put(trial, path, int(value) if is_whole(path) else value)
    try:
        valid = make_spec(trial, "sweep")
        build(valid)
    except SpecError as error:
        where = ", ".join(f"{path} = {value:g}" for path, value in extreme.items())
        raise SpecError(f"sweep at {where}", error.problems) from None
    return valid


def put(data: dict[str, Any], path: str, value: Any) -> None:
    """Set a nested value; None removes it."""
    *blocks, name = path.split(".")
    for block in blocks:
        data = data.setdefault(block, {})
    if value is None:
        data.pop(name, None)
    else:
        data[name] = value


def with_value(model: Any, path: Sequence[str], value: Any) -> Any:
    """Copy a spec with an unvalidated value (an array) at ``path``."""
    name, *rest = path
    return model.model_copy(update={name: with_value(getattr(model, name), rest, value) if rest else value})


def grid(axes: Sequence[Axis]) -> list[Any]:
    """Coordinates of every point of the grid by axis, flat, the first axis slowest."""
    import numpy as np

    count = 1
    for axis in axes:
        count *= axis.values.size
    if count > MOST_POINTS:
        raise AfmcalcError(f"the sweep asks for {count} points; at most {MOST_POINTS} are swept")
    if len({axis.key.path for axis in axes}) < len(axes):
        raise AfmcalcError("the same key is swept twice")
    if any(axis.name == "zC" for axis in axes) and any(axis.key.path.endswith("pairs") for axis in axes):
        raise AfmcalcError("zC and a number of pairs cannot be swept together: sweep C with it")
    if len(axes) == 1:
        return [axes[0].values]
    return [coordinates.ravel() for coordinates in np.meshgrid(*(axis.values for axis in axes), indexing="ij")]


def evaluate(spec: Spec, values: Mapping[str, Any], outputs: Mapping[str, Callable[[Clutch], Any]]) -> dict[str, Any]:
    """Evaluate ``outputs`` of the clutch over arrays of spec values.

    Args:
        spec: the spec.
        values: path → array, SI.
        outputs: name → function of the clutch.

    Returns:
        name → array in the broadcast shape of ``values``.
    """
    import numpy as np

    clutch = clutch_over(spec, values)
    shape = np.broadcast_shapes(*(np.shape(array) for array in values.values()))
    with np.errstate(all="ignore"):
        return {name: np.broadcast_to(function(clutch), shape) for name, function in outputs.items()}


S = TypeVar("S", bound=Series)


def series(
    kind: type[S], clutch: Clutch, axes: Sequence[Axis], outputs: Mapping[str, Callable[[Clutch], Any]]
) -> list[S] | None:
    """Sweep ``outputs`` over the grid of ``axes``, one series per axis; None without axes."""
    if not axes:
        return None
    points = grid(axes)
    values = {axis.key.path: given * axis.scale for axis, given in zip(axes, points, strict=True)}
    answers = {name: array.tolist() for name, array in evaluate(clutch.spec, values, outputs).items()}
    return [
        kind(parameter=axis.name, path=axis.key.path, unit=axis.key.unit or "1", values=given.tolist(), **answers)
        for axis, given in zip(axes, points, strict=True)
    ]
