"""Search space of ``design``: the [search] block of a spec, with the keys to vary and the values of each key."""

from collections.abc import Iterator, Mapping
from typing import Annotated

from pydantic import BaseModel, WithJsonSchema

from ..messages import did_you_mean, say
from .fields import Broken, Key, keys_below, rule_error
from .quantity import Quantity, asked_unit
from .rules import Table, given_in

MOST = 2_000_000
"""Largest number of candidates of a search, and largest number of values of a range."""
SPRINGS = "springs"
"""Key of [search] that is not a path: the kind of springs to choose from the lists."""
_KINDS = ("disc", "coil", "any")
_NOT_VARIED = ("search", "objectives", "name", "requirements.", "tolerance.", "catalogues.", "report.", "drawing.")
_DIGITS = 12
"""Significant digits of the inner values of a range."""

Values = tuple[int | float | str, ...]
Axes = dict[str, Values]
"""Path → values to try, numbers in SI."""
_WRITTEN = {"anyOf": [{"type": name} for name in ("string", "number", "array", "object")]}
Search = Annotated[Axes, WithJsonSchema({"type": "object", "additionalProperties": _WRITTEN})]


def flat(table: Table) -> dict[str, object]:
    """Path → value in a [search] table; dotted paths may be quoted keys or nested tables."""
    return {path: value for path, value in given_in(table).items() if not isinstance(value, dict)}


def axes_of(given: Table, spec: type[BaseModel]) -> Axes:
    """Validated axes of a [search] table, numbers in SI. Raises ValidationError with every problem found."""
    axes, broken = Axes(), list[Broken]()
    known = {path: key for path, key in keys_below(spec).items() if not path.startswith(_NOT_VARIED)}
    for path, value in flat(given).items():
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
    return tuple(dict.fromkeys(map(key.about.read, listed)))


def _range(text: str, key: Key, about: Quantity) -> Iterator[float]:
    """Equally spaced values of ``start:stop:count``, both ends included."""
    parts = [part.strip() for part in text.split(":")]
    if len(parts) != 3 or not parts[2].isdecimal() or not 2 <= int(parts[2][:9]) <= MOST:
        raise ValueError(say('must be a list, or "start:stop:count" with a whole count of at least 2'))
    start, stop = (about.read(_as_written(part, key)) for part in parts[:2])
    steps = int(parts[2]) - 1
    for number in range(steps + 1):
        between = float(f"{start + (stop - start) * number / steps:.{_DIGITS}g}")
        yield about.read({0: start, steps: stop}.get(number, between))


def _as_written(part: str, key: Key) -> float | str:
    try:
        value = float(part)
    except ValueError:
        return part
    asked_unit(value, key.unit, key.path)
    return value
