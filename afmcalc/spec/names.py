"""What a key may be called on the command line: its path, its name, its symbol in the papers."""

from collections import Counter
from functools import cache

from pydantic import BaseModel

from ..messages import joined, say
from .models import Spec
from .paths import ALIASES
from .suggest import plain
from .walk import keys_below

_APART = ("tolerance.", "requirements.")
"""Tables whose keys are called like those of the clutch that they are about."""


def path_of(name: str, model: type[BaseModel] = Spec) -> str | None:
    """Return the path that a path, name or symbol means; None where it means none, or more than one.

    >>> path_of("gain"), path_of("z_1"), path_of("force")
    ('control_unit.gain', 'friction_group.driving_pairs', None)
    """
    name = name.strip()
    return _called(model).get(plain(name)) if len(name) <= 100 else None


@cache
def _called(model: type[BaseModel]) -> dict[str, str]:
    """Every name and what it means; a name of several keys means none."""
    known = keys_below(model)
    own = [key for key in known.values() if not key.path.startswith(_APART)]
    found: dict[str, str] = {}
    for called in ([(key.symbol, key.path) for key in own], [(_last(key.path), key.path) for key in own]):
        times = Counter(name for name, _ in called)
        found |= {plain(name): path for name, path in called if name and times[name] == 1}
    return found | (ALIASES if model is Spec else {}) | {path: path for path in known}


def names(model: type[BaseModel] = Spec) -> list[str]:
    """Every name that ``path_of`` takes."""
    return list(_called(model))


def elsewhere(name: str, model: type[BaseModel] = Spec) -> str:
    """Return ``"; did you mean a.x or b.x?"`` for a key that has the name in other tables, or nothing."""
    paths = [path for path in keys_below(model) if _last(path) == name]
    if not paths and (path := path_of(name, model)):
        paths = [path]
    return say("; did you mean {paths}?", paths=joined(paths, say(" or "))) if paths else ""


def _last(path: str) -> str:
    return path.rpartition(".")[2]
