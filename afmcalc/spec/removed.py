"""Places in a spec of the keys of a requirements file before 0.4."""

from collections.abc import Iterable, Mapping

from ..messages import deferred

_UNIT = ("balls", "face_gap", "edge_clearance", "hub_diameter", "key_friction", "pocket", "contact")
_PACK = ("pairs", "driving_pairs", "mean_radius", "inner_radius", "outer_radius")
_BALLS = ("gain", "wall_angle", "ball_circle_radius")
_FACES = deferred("friction_group.inner_radius and friction_group.outer_radius")

MOVED: Mapping[str, str] = {
    "variants": "search.variant", "springs": "search.springs", "wanted.nominal_torque": "adjustment.nominal_torque",
    "wanted.method": "adjustment.method", "wanted.margin": "adjustment.margin",
    "limits.contact_force": "control_unit.allowable_contact_force",
    "limits.gain_limit": deferred("no key: the limit of the gain is always held"), "fixed.face_width": _FACES,
    "fixed.closing_room": "closing_spring.room", "fixed.control_room": "control_spring.room",
    **{f"fixed.{name}": f"control_unit.{name}" for name in _UNIT},
    **{f"search.{name}": f"search.friction_group.{name}" for name in _PACK},
    **{f"search.{name}": f"search.control_unit.{name}" for name in _BALLS},
    "search.closing_force": "requirements.closing_force", "search.closing_forces": "search.closing_spring.force",
    "search.closing_stiffness": "search.closing_spring.stiffness",
    "search.control_stiffness": "search.control_spring.stiffness", "search.ball_diameters": "catalogues.balls",
}  # fmt: skip
"""Key of a requirements file before 0.4 → its place in a spec; other keys of wanted and limits → [requirements]."""
OLD = frozenset(("wanted", "limits", "fixed", "variants"))
"""Tables that occur only in a requirements file before 0.4."""


def moved_in(given: Iterable[str]) -> dict[str, str]:
    """Old key among those ``given`` → its new place."""
    places = {}
    for path in given:
        table, _, name = path.partition(".")
        if path in MOVED:
            places[path] = MOVED[path]
        elif table in ("wanted", "limits") and name and "." not in name:
            places[path] = f"requirements.{name}"
    return places
