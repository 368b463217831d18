"""Commands about the drive around a clutch: what happens when it trips, and what the law neglects."""

from typing import TYPE_CHECKING, Annotated

from typer import Option

from ..errors import AfmcalcError
from ..messages import say
from .clutch import FrictionOption, SweepOption, axes_of, friction_of
from .files import write
from .options import Common, SaveOption, SpecArgument, with_common

if TYPE_CHECKING:
    from ..analysis.torque import Pair
    from ..engines import Clutch

HistoryOption = Annotated[
    str | None,
    Option("--history", metavar="FILE", help="Write torques, speeds and travel over time to FILE (CSV, SI)."),
]


@with_common
def simulate(
    spec: SpecArgument = None,
    friction: FrictionOption = None,
    sweep: SweepOption = None,
    history: HistoryOption = None,
    save: SaveOption = None,
    *,
    common: Common,
) -> None:
    """The drive in time: what happens when the clutch trips, and the heat of it, by the [drive] block.

    Without [drive.event] the heat alone. --save writes the spec with the dynamic factor found, for life. With
    --friction the history is that of these frictions alone.

    An event is followed until nothing more can come, or for drive.event.duration. The time to a cut-off runs from the
    first slip on, also while the clutch is stuck again. A load resists as friction does and holds a stopped tool; that
    of a hoist would turn it back. The sleeve of an indirect clutch meets its stop elastically.

    \b
    afmcalc simulate drive.toml
    afmcalc simulate drive.toml --friction 0.2 --history event.csv
    afmcalc simulate drive.toml --sweep drive.shaft_stiffness
    afmcalc simulate drive.toml --save drive-with-factor.toml
    """  # noqa: D301
    from ..spec.edit import respecified

    if history == "-":
        raise AfmcalcError("--history writes a file beside the result: name one")
    points = [friction_of(text) for text in friction or ()]
    common.keep(spec, beside=history, save=save)
    clutch = common.build(spec)
    if clutch.spec.drive.event is None:
        for option, given in {"--friction": points, "--sweep": sweep, "--history": history, "--save": save}.items():
            if given:
                raise AfmcalcError("{option} is of an event: give [drive.event]", option=option)
        common.command = "heat"
        common.calculate(clutch)
        return
    result = common.calculate(clutch, friction=points, sweeps=axes_of(sweep, clutch), heated=not sweep).result
    if history:
        _write_history(clutch, points, history, common)
    if save:
        changes = {"drive.dynamic_factor": result.largest_dynamic_factor}
        common.save_spec(clutch.spec, changes, respecified(clutch.spec, changes), save)


def _write_history(clutch: "Clutch", points: "list[Pair]", path: str, common: Common) -> None:
    from .. import __version__
    from ..analysis.simulate import history
    from ..render import renderer
    from ..result import Output

    with common.bar():
        output = Output(command="history", version=__version__, spec=None, result=history(clutch, points), findings=[])
    write(renderer(common.csv_dialect)(output, False), path, force=common.force)
    common.note(say("wrote the history to {output}", output=path))


@with_common
def effects(spec: SpecArgument = None, *, common: Common) -> None:
    """What the torque law neglects, in numbers: centrifugal force, wear, friction of the parts.

    \b
    afmcalc effects clutch.toml
    afmcalc effects clutch.toml --set friction_group.spline_friction=0.15 --json
    """  # noqa: D301
    common.calculate(common.clutch(spec))
