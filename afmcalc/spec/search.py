"""The [search] block of a spec: the keys that ``design`` varies, each with its values."""

from collections.abc import Iterator, Mapping
from typing import Annotated, TypeAlias

from pydantic import BaseModel, WithJsonSchema

from ..messages import did_you_mean, say
from .fields import Broken, Key, Quantity, keys_below, rule_error
from .quantity import asked_unit
from .rules import Table

MOST = 2_000_000
"""Candidates of a search, at most."""
SPRINGS = "springs"
"""Key of [search] that is no path: springs of that kind are chosen from the lists."""
_KINDS = ("disc", "coil", "any")
_NOT_VARIED = ("search", "objectives", "name", "requirements.", "tolerance.", "catalogues.", "report.", "drawing.")
_DIGITS = 12
"""Significant digits of the values between the ends of a range."""

Values: TypeAlias = tuple[int | float | str, ...]
Axes: TypeAlias = dict[str, Values]
"""Path → its values, numbers in SI."""
_WRITTEN = {"anyOf": [{"type": name} for name in ("string", "number", "array", "object")]}
Search = Annotated[Axes, WithJsonSchema({"type": "object", "additionalProperties": _WRITTEN})]


def flat(table: Table, prefix: str = "") -> Iterator[tuple[str, object]]:
    """Paths and values of a [search] table; a path may be a quoted key or a nested one."""
    for name, value in table.items():
        if isinstance(value, Mapping):
            yield from flat(value, f"{prefix}{name}.")
        else:
            yield prefix + name, value


def axes_of(given: Table, spec: type[BaseModel]) -> Axes:
    """Read a [search] table: numbers in SI. Raises ValidationError: every problem found."""
    axes, broken = Axes(), list[Broken]()
    known = {path: key for path, key in keys_below(spec).items() if not path.startswith(_NOT_VARIED)}
    for path, value in flat(given):
        if value is None:
            continue
        try:
            if path == SPRINGS:
                axes[path] = _names(value, _KINDS)[:1]
            elif path in known:
                axes[path] = _values(value, known[path])
            else:
                raise ValueError(_unknown(path, known))
        except ValueError as error:
            broken.append((path, str(error)))
    if broken:
        raise rule_error(broken)
    return axes


def _unknown(path: str, known: Mapping[str, Key]) -> str:
    alike = [name for name in known if name.rpartition(".")[2] == path.rpartition(".")[2]]
    hint = say("; did you mean {paths}?", paths=", ".join(alike)) if alike else did_you_mean(path, known)
    return say("is no key of a clutch that can be varied{hint}", hint=hint)


def _names(given: object, allowed: tuple[str, ...] = ()) -> Values:
    listed = given if isinstance(given, list | tuple) else [given]
    if not listed or not all(isinstance(value, str) for value in listed):
        raise ValueError(say("must be a list of names in quotes"))
    if allowed and not set(listed) <= set(allowed):
        raise ValueError(say("must be one of {expected}{hint}", expected=", ".join(allowed), hint=""))
    return tuple(dict.fromkeys(listed))


def _values(given: object, key: Key) -> Values:
    if key.about is None:
        return _names(given)
    if isinstance(given, str) and ":" in given:
        return tuple(_range(given, key, key.about))
    listed = given if isinstance(given, list | tuple) else [given]
    if not listed:
        raise ValueError(say("must not be an empty list"))
    return tuple(dict.fromkeys(_number(value, key.about) for value in listed))


def _range(text: str, key: Key, about: Quantity) -> Iterator[float]:
    """Values of ``start:stop:count``, both ends among them."""
    parts = [part.strip() for part in text.split(":")]
    if len(parts) != 3 or not parts[2].isdecimal() or not 2 <= int(parts[2][:9]) <= MOST:
        raise ValueError(say('must be a list, or "start:stop:count" with a whole count of at least 2'))
    start, stop = (_number(_as_written(part, key), about) for part in parts[:2])
    steps = int(parts[2]) - 1
    for number in range(steps + 1):
        between = float(f"{start + (stop - start) * number / steps:.{_DIGITS}g}")
        yield _number({0: start, steps: stop}.get(number, between), about)


def _as_written(part: str, key: Key) -> float | str:
    try:
        value = float(part)
    except ValueError:
        return part
    asked_unit(value, key.unit, key.path)
    return value


def _number(given: object, about: Quantity) -> float:
    """Read a number, and hold it to what its key may be."""
    value = about.read(given)
    if about.gt is not None and value <= about.gt:
        raise ValueError(say("must be greater than {bound:g}", bound=about.gt))
    if about.ge is not None and value < about.ge:
        raise ValueError(say("must be at least {bound:g}", bound=about.ge))
    if about.lt is not None and value >= about.lt:
        raise ValueError(say("must be less than {bound:g}", bound=about.lt))
    if about.le is not None and value > about.le:
        raise ValueError(say("must be at most {bound:g}", bound=about.le))
    return value
