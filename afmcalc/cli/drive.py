"""Commands that calculate the drive around a clutch."""

from typing import TYPE_CHECKING, Annotated

import typer

from ..errors import AfmcalcError
from ..messages import say
from .clutch import FrictionOption, SweepOption, axes_of, curve_of, friction_of
from .files import write
from .options import Common, SpecArgument, with_common
from .run import calculate, write_spec

if TYPE_CHECKING:
    from ..analysis.torque import Pair
    from ..engines import Clutch

HistoryOption = Annotated[
    str | None,
    typer.Option("--history", metavar="FILE", help="Write torques, speeds and travel over time to FILE (CSV, SI)."),
]

PlotOption = Annotated[bool, typer.Option("--plot", help="Draw the event, or the sweep, below the table.")]


@with_common
def simulate(
    spec: SpecArgument = None,
    friction: FrictionOption = None,
    sweep: SweepOption = None,
    history: HistoryOption = None,
    plot: PlotOption = False,
    *,
    common: Common,
) -> None:
    """The drive in time: what happens when the clutch trips, by the [drive] block.

    --output FILE writes the spec with the dynamic factor found, for life; the result goes to standard output all the
    same. With --friction the history is that of these frictions alone.

    An event is followed until nothing more can come, or for drive.event.duration. The time to a cut-off runs from the
    first slip on, also while the clutch is stuck again. A load resists as friction does and holds a stopped tool; that
    of a hoist would turn it back. The sleeve of an indirect clutch meets its stop elastically.

    \b
    afmcalc simulate drive.toml
    afmcalc simulate drive.toml --friction 0.2 --history event.csv
    afmcalc simulate drive.toml --sweep drive.shaft_stiffness --plot
    afmcalc simulate drive.toml --output drive-with-factor.toml
    """  # noqa: D301
    from ..analysis.simulate import with_dynamic_factor
    from ..engines import build
    from ..spec import make_spec

    if "-" in (common.output, history):
        raise AfmcalcError(say("simulate --output and --history write files beside the result: name one for each"))
    common.keep(spec, beside=history, writes="spec")
    own = common.to_standard_output()
    curve = curve_of(plot, sweep, own) if sweep else None
    if plot and own.chosen_format != "table":
        raise AfmcalcError(say("--plot draws under a table, not with --format {name}", name=own.chosen_format))
    points = [friction_of(text) for text in friction or ()]
    output = calculate(own, spec, lambda clutch: {"friction": points, "sweeps": axes_of(sweep, clutch)}, curve)
    assert output.spec is not None
    resolved = make_spec(output.spec)
    if plot and not sweep:
        _draw(build(resolved), common)
    if history:
        _write_history(build(resolved), points, history, common)
    if common.output:
        about = say("Its dynamic factor is that of afmcalc simulate.")
        write_spec(with_dynamic_factor(resolved, output.result), common, about)
        common.wrote(say("wrote the spec with the dynamic factor to {output}", output=common.output))


def _draw(clutch: "Clutch", common: Common) -> None:
    """Draw the event in the terminal."""
    from ..analysis.answers import Answers
    from ..analysis.figures import Request, gathered
    from ..render.formats.table import columns, is_unicode
    from ..render.plot import sheet_of
    from ..render.plot.text import draw_sheet

    with common.bar():
        sheet = sheet_of("simulate", gathered("simulate", Request([Answers(clutch)])))
    write("\n" + draw_sheet(sheet, unicode=is_unicode(), width=columns()), None)


def _write_history(clutch: "Clutch", points: "list[Pair]", path: str, common: Common) -> None:
    from .. import __version__
    from ..analysis.simulate import history
    from ..render.formats import csv
    from ..result import Output

    with common.bar():
        found = Output(command="history", version=__version__, spec=None, result=history(clutch, points), findings=[])
    write(csv.render(found, terminal=False), path, force=common.force)
    common.wrote(say("wrote the history to {output}", output=path))
