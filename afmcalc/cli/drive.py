"""Commands that calculate the drive around a clutch."""

from .clutch import FrictionOption, SweepOption, axes_of, friction_of
from .options import Common, SpecArgument, with_common
from .run import calculate


@with_common
def simulate(
    spec: SpecArgument = None,
    friction: FrictionOption = None,
    sweep: SweepOption = None,
    *,
    common: Common,
) -> None:
    """The drive in time: what happens when the clutch trips, by the [drive] block.

    \b
    afmcalc simulate drive.toml
    afmcalc simulate drive.toml --friction 0.2 --json
    """  # noqa: D301
    points = [friction_of(text) for text in friction or ()]
    calculate(common, spec, lambda clutch: {"friction": points, "sweeps": axes_of(sweep, clutch)})
