"""Places in a spec of the keys of a requirements file before 0.4."""

from collections.abc import Iterable

from ..messages import deferred
from ..units import table
from .keys import path_of

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
