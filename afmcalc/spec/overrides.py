"""Overrides of a spec from the command line: ``path=value``."""

from collections.abc import Iterable

from pydantic import BaseModel

from ..errors import AfmcalcError
from ..messages import say
from .limits import check_size, too_deep
from .models import Spec
from .rules import Table


def apply_overrides(data: dict[str, object], overrides: Iterable[str], model: type[BaseModel] = Spec) -> Table:
    """Apply ``path=value`` overrides to parsed data; an empty value removes the key."""
    for override in overrides:
        *blocks, name = _path(override, model)
        block = data
        for depth, part in enumerate(blocks, start=1):
            nested = block.setdefault(part, {})
            if not isinstance(nested, dict):
                path = ".".join(blocks[:depth])
                raise AfmcalcError(say("--set {override:.80}: {path} is no table", override=override, path=path))
            block = nested
        if text := override.partition("=")[2].strip():
            block[name] = _value(text, override)
        else:
            block.pop(name, None)
    return data


def overridden(overrides: Iterable[str], model: type[BaseModel] = Spec) -> list[str]:
    """Return the dotted paths that overrides name."""
    return [".".join(_path(override, model)) for override in overrides]


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
