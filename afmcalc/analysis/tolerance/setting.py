"""Who is set: the springs as the nominal clutch needs them, then held, or every clutch on the bench."""

from ...engines import Clutch
from ...errors import Problem, SpecError
from ...messages import say
from ...spec import Spec
from ...spec.edit import with_force, with_key, with_value
from ...spec.tolerance import Tolerance
from ..slips import dynamic_factor

_ONLY_SETTING = (
    "adjustment.",
    "friction.min",
    "friction.mean",
    "friction.max",
    "friction.driving.",
    "friction.driven.",
)
"""Keys that act on a clutch through its setting alone."""
_CONTROL_FORCE = ("control_spring", "force")


def with_setting(clutch: Clutch, given: Tolerance) -> Spec:
    """Return the spec whose samples are set in one of the two ways.

    Args:
        clutch: the nominal clutch.
        given: its [tolerance] block; as-made: the springs of the nominal clutch, each-adjusted: those a sample needs.

    Raises:
        SpecError: a field scatters that could have no effect.
    """
    setting = given.setting
    for path in given.fields:
        if setting == "as-made" and path.startswith(_ONLY_SETTING):
            message = say(
                'acts through the setting alone, which "as-made" holds: give tolerance.setting = "each-adjusted"'
            )
            raise SpecError(clutch.spec.label, [Problem(f"tolerance.fields.{path}", None, message)])
        if setting == "each-adjusted" and path == ".".join(_CONTROL_FORCE):
            message = say('follows from the setting of each clutch: give tolerance.setting = "as-made"')
            raise SpecError(clutch.spec.label, [Problem(f"tolerance.fields.{path}", None, message)])
    spec = clutch.spec
    if spec.fatigue is not None:
        # the life of every sample takes that of the nominal clutch
        spec = with_value(spec, ("drive", "dynamic_factor"), dynamic_factor(clutch))
    if setting == "as-made":
        spec = with_force(spec, float(clutch.closing_force))
    if clutch.control_force is not None:
        made = float(clutch.control_force) if setting == "as-made" else None
        spec = with_value(spec, _CONTROL_FORCE, made)
    if clutch.gain_slope:
        # pockets are cut once, for the nominal clutch
        spec = with_key(spec, "control_unit.gain_slope", float(clutch.gain_slope))
    return spec
