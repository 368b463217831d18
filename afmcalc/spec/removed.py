"""Keys that earlier versions had, and what to do instead."""

from collections.abc import Mapping

from ..messages import say

_PROFILED = say("one sleeve has the curved wall, the other seats the ball; leave the key out")
_WEIGHT = say("the weight of a pack with a vertical axis is not calculated; leave the key out")

REMOVED: Mapping[str, str] = {
    "control_unit.profiled": _PROFILED,
    "control_unit.wall_friction": say("cams that slide are not calculated, balls roll; leave the key out"),
    "fatigue.load_low": say("every slip swings the load from 0 to T(f); leave the key out"),
    "fixed.profiled": _PROFILED,
    "friction_group.discs_mass": _WEIGHT,
    "friction_group.pressure_disc_mass": _WEIGHT,
    "friction_group.vertical_axis": _WEIGHT,
}
"""Path of a key of a spec or of requirements → what to do instead."""


def instead_of(path: str) -> str:
    """Return what to do instead of a key, by its path or name, to be put behind "unknown key"; else nothing."""
    found = (hint for key, hint in REMOVED.items() if f".{key}".endswith(f".{path.strip()}"))
    hint = next(found, "")
    return say(" since 0.4: {instead}", instead=hint) if hint else ""
