"""Overrides of a spec: ``path=value`` from the command line, a mapping from Python."""

from collections.abc import Collection, Iterator, Mapping
from typing import TypeAlias

from pydantic import BaseModel

from ..errors import AfmcalcError
from ..messages import say
from .limits import check_size, too_deep
from .models import Spec
from .rules import Table

Overrides: TypeAlias = Collection[str] | Mapping[str, object]
"""Texts ``path=value``, an empty value removes the key; or path → value, None removes it."""


def apply_overrides(data: dict[str, object], overrides: Overrides, model: type[BaseModel] = Spec) -> Table:
    """Apply overrides to parsed data."""
    for override, value in _each(overrides):
        *blocks, name = _path(override, model)
        block = data
        for depth, part in enumerate(blocks, start=1):
            nested = block.setdefault(part, {})
            if not isinstance(nested, dict):
                path = ".".join(blocks[:depth])
                raise AfmcalcError(say("--set {override:.80}: {path} is no table", override=override, path=path))
            block = nested
        if value is None:
            block.pop(name, None)
        else:
            block[name] = value
    return data


def overridden(overrides: Overrides, model: type[BaseModel] = Spec) -> dict[str, object]:
    """Return the dotted paths that overrides name, each with its value."""
    return {".".join(_path(override, model)): value for override, value in _each(overrides)}


def _each(overrides: Overrides) -> Iterator[tuple[str, object]]:
    """Overrides as texts, each with its value; None removes the key."""
    if isinstance(overrides, Mapping):
        for name, value in overrides.items():
            yield f"{name}={value}", getattr(value, "tolist", lambda given=value: given)()  # of NumPy
        return
    for override in overrides:
        text = override.partition("=")[2].strip()
        yield override, _value(text, override) if text else None


def key_of(override: str) -> str:
    """Return the key of an override as given; refuse where there is no equals sign, or nothing before it."""
    given, separator, _ = override.partition("=")
    if not separator or not given.strip():
        raise AfmcalcError(
            say(
                "--set {override:.80}: write PATH=VALUE, both and the equals sign in one word, for example "
                "control_unit.gain=0.5",
                override=override,
            )
        )
    return given.strip()


def _path(override: str, model: type[BaseModel]) -> list[str]:
    """Parts of the path an override names; a name or symbol stands for its path."""
    from .names import elsewhere, names, path_of
    from .suggest import did_you_mean
    from .walk import names_in

    given = key_of(override)
    path = path_of(given, model) or given
    *blocks, last = path.split(".")
    known = names_in(tuple(blocks), model)
    if last not in known:
        hint = did_you_mean(last, known) or elsewhere(last, model) or did_you_mean(last, names(model))
        if known and not hint:
            hint = say("; known here: {names}", names=", ".join(known))
        raise AfmcalcError(
            say("--set {override:.80}: unknown key {path!r:.80}{hint}", override=override, path=path, hint=hint)
        )
    return [*blocks, last]


def _value(text: str, override: str) -> object:
    """Read a number, boolean, quoted string or inline table as TOML, anything else as plain text."""
    import tomllib

    try:
        read = tomllib.loads(f"value = {text}")
    except tomllib.TOMLDecodeError:
        return text
    except RecursionError:
        raise AfmcalcError(say("--set {override:.80}: {why}", override=override, why=too_deep())) from None
    except ValueError:
        raise AfmcalcError(say("--set {override:.80}: a number has too many digits", override=override)) from None
    if set(read) != {"value"}:  # further lines are part of the text
        return text
    check_size(read["value"], say("--set {override:.80}", override=override))
    return read["value"]
