"""Names of the keys of a spec: path, name, symbol in the papers; the key at a path; new places of old keys."""

import re
from collections import Counter
from collections.abc import Iterable
from functools import cache

from ..messages import deferred, latin, say
from ..units import table
from .fields import Key, keys_below
from .models import Spec
from .quantity import Quantity
from .scatter import FRICTION, scattering

ALIASES = table("""\
C = control_unit.gain; z = friction_group.pairs; z1 = friction_group.driving_pairs;
R = friction_group.mean_radius; F = closing_spring.force; f_min = friction.min; f_cp f_mean = friction.mean;
f_max = friction.max; c1 = closing_spring.stiffness; c2 = control_spring.stiffness; beta = adjustment.margin;
T_n = adjustment.nominal_torque; r = control_unit.ball_circle_radius; alpha = control_unit.wall_angle;
f1 = control_unit.key_friction; d = control_unit.hub_diameter; gain_slope = control_unit.gain_slope;
speed = drive.speed""")
"""Symbol that the command line accepts → path."""

_APART = ("catalogues.", "tolerance.", "requirements.")
"""Tables whose keys have the same names as keys of the clutch; a bare name never means a key of these tables."""


def keys() -> dict[str, Key]:
    """All keys with values (not tables) of a spec, by dotted path."""
    return keys_below(Spec)


def is_whole(path: str) -> bool:
    """True if the value of the key is a whole number."""
    key = keys().get(path)
    return key is not None and key.about is not None and key.about.whole


def scatter_at(path: str) -> Quantity | None:
    """Unit and bounds of the number at a path, if it may scatter; None if it may not."""
    return scattering(path, Spec)


def key_of_number(path: str) -> Key | None:
    """Key whose unit holds for the number at a path, also for paths in [search] and in [tolerance.fields]."""
    apart = re.fullmatch(r"search\.(.*)|tolerance\.fields\.(.*?)(?:\.(?:center|spread|min|max))?", path)
    name = (apart[1] or apart[2]) if apart else path
    return keys().get(f"{name}.min" if name in FRICTION else name)


def path_of(name: str) -> str | None:
    """Path of the key with a path, name or symbol; None if there is no such key, or if the name is ambiguous.

    >>> path_of("gain"), path_of("z_1"), path_of("force")
    ('control_unit.gain', 'friction_group.driving_pairs', None)
    """
    name = name.strip()
    return names().get(name) if len(name) <= 100 else None


@cache
def names() -> dict[str, str]:
    """Name or symbol → path; names shared by several keys or by a table are left out."""
    of_clutch = [key for key in keys().values() if not key.path.startswith(_APART)]
    paths: dict[str, str] = {}
    tables = Spec.model_fields
    for pairs in ([(key.symbol, key.path) for key in of_clutch], [(_last(key.path), key.path) for key in of_clutch]):
        times = Counter(name for name, _ in pairs)
        of_one = ((name, path) for name, path in pairs if name and times[name] == 1 and name not in tables)
        paths |= {spelled: path for name, path in of_one for spelled in (latin(name), name)}
    return paths | ALIASES | {path: path for path in keys()}


def elsewhere(name: str) -> str:
    """Hint ``"; did you mean a.x or b.x?"`` if other tables have a key with this name; else empty."""
    paths = [path for path in keys() if _last(path) == name]
    if not paths and (path := path_of(name)):
        paths = [path]
    return say("; did you mean {paths}?", paths=say(" or ").join(paths)) if paths else ""


def _last(path: str) -> str:
    return path.rpartition(".")[2]


MOVED = table("""\
variants = search.variant; springs = search.springs; wanted.nominal_torque = adjustment.nominal_torque;
wanted.method = adjustment.method; wanted.margin = adjustment.margin;
limits.contact_force = control_unit.allowable_contact_force;
fixed.closing_room = closing_spring.room; fixed.control_room = control_spring.room;
search.closing_force = requirements.closing_force; search.closing_forces = search.closing_spring.force;
search.closing_stiffness = search.closing_spring.stiffness; search.ball_diameters = catalogues.balls;
search.control_stiffness = search.control_spring.stiffness""") | {
    "limits.gain_limit": deferred("no key: the limit of the gain is always held"),
    "fixed.face_width": deferred("friction_group.inner_radius and friction_group.outer_radius"),
}
"""Key of a requirements file before 0.4 → its place in a spec, if ``moved_in`` has no rule for it."""
OLD = frozenset(("wanted", "limits", "fixed", "variants"))
"""Tables that occur only in a requirements file before 0.4."""


def moved_in(given: Iterable[str]) -> dict[str, str]:
    """Old key among those ``given`` → its new place."""
    places = {}
    for path in given:
        block, _, name = path.partition(".")
        if path in MOVED:
            places[path] = MOVED[path]
        elif name and "." not in name and block in OLD:
            places[path] = f"control_unit.{name}" if block == "fixed" else f"requirements.{name}"
        elif block == "search" and path_of(name) not in (None, name):
            places[path] = f"search.{path_of(name)}"
    return places
