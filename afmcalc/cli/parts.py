"""Commands about what a trip does to the parts, and the parts themselves."""

from .options import Common, SpecArgument, with_common
from .run import calculate


@with_common
def heat(spec: SpecArgument = None, *, common: Common) -> None:
    """Work, temperature and wear of a trip, and how often it may be.

    \b
    afmcalc heat clutch.toml
    afmcalc heat clutch.toml --set drive.speed='1430 rpm' --set drive.cut_off='0.5 s'
    afmcalc heat clutch.toml --json
    """  # noqa: D301
    calculate(common, spec)


@with_common
def effects(spec: SpecArgument = None, *, common: Common) -> None:
    """What the torque law neglects, in numbers: splines, sliding cams, centrifugal force, wear.

    \b
    afmcalc effects clutch.toml
    afmcalc effects --set control_unit.wall_friction=0.1
    afmcalc effects clutch.toml --set friction_group.spline_friction=0.15 --json
    """  # noqa: D301
    calculate(common, spec)
