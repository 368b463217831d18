"""The command that draws."""

from typing import TYPE_CHECKING, Annotated, Any

import typer

from ..analysis.registry import PLOTS, StressRule
from ..errors import AfmcalcError
from ..messages import say
from .files import write, write_file
from .names import completing, plots, swept
from .options import Common, common_options
from .run import need_drawing
from .shop import answers_of, for_the_shop, length

if TYPE_CHECKING:
    from ..analysis.figures import Request
    from ..render.plot.chart import Sheet

_ENDINGS = ("png", "svg", "pdf", "dxf")
_SHOP = ("dxf", "svg")
"""Drawings of the pocket for the shop."""


_KINDS = [name for name in PLOTS if name != "paper"]


@common_options(
    "set",
    "output",
    "force",
    "yes",
    "quiet",
    output="File, .png, .svg, .pdf (pocket: .dxf); without it drawn as text.",
)
def plot(
    what: Annotated[
        str,
        typer.Argument(
            metavar="WHAT", autocompletion=completing(plots), help=f"{', '.join(_KINDS)}, or paper with a figure."
        ),
    ],
    subjects: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="SPEC",
            help="Specs; several give several curves. After paper: F11-2, S22-3, ...; after pareto: REQUIREMENTS.",
        ),
    ] = None,
    sweep: Annotated[
        str | None,
        typer.Option(
            "--sweep",
            metavar="NAME[=RANGE]",
            autocompletion=completing(swept),
            help="accuracy: the axis (C); life: dT=RANGE.",
        ),
    ] = None,
    model: Annotated[StressRule | None, typer.Option("--model", help="life: rule for the damaging stress.")] = None,
    profile: Annotated[
        str | None, typer.Option("--profile", metavar="FILE.csv", help="pocket: path, wall and cutter path, mm.")
    ] = None,
    cutter: Annotated[
        str | None, typer.Option("--cutter", metavar="DIAMETER", help="pocket: cutter, such as 10mm (the ball's).")
    ] = None,
    chord: Annotated[
        str | None, typer.Option("--chord", metavar="LENGTH", help="pocket: chords within this of the wall (0.001mm).")
    ] = None,
    *,
    common: Common,
) -> None:
    """Plots: of clutches, of the pocket to scale, of tolerances, of a design's front, of the papers' figures.

    \b
    afmcalc plot torque clutch.toml -o torque.svg
    afmcalc plot accuracy a.toml b.toml --sweep C=0:1.25:101 -o accuracy.png
    afmcalc plot pocket clutch.toml -o pocket.pdf
    afmcalc plot pocket clutch.toml -o pocket.dxf --profile wall.csv --cutter 10mm
    afmcalc plot tolerance clutch.toml -o tolerance.svg
    afmcalc plot pareto requirements.toml -o front.svg
    afmcalc plot paper S22-3 -o figure.png
    """  # noqa: D301
    from ..analysis.figures import Request, gathered, plot_of
    from ..render.plot import sheet_of

    what, takes = (chosen := plot_of(what)).name, chosen.takes
    ending = _ending(common.output)
    common.keep(*subjects or (), beside=profile, writes="document")
    request = Request(subjects or (), sweep, model, profile, length("cutter", cutter), length("chord", chord))
    if (what == "pocket" and ending in _SHOP) or profile is not None:
        for_the_shop(what, request, ending, common)
        return
    if ending == "dxf":
        raise AfmcalcError(say("--output {output}: only plot pocket is drawn as .dxf", output=common.output))
    if ending:
        need_drawing("plot")
    if takes == "names":
        found = gathered(what, request)
    else:
        found = (_of_requirements if takes == "requirements" else _of_clutches)(what, request, common)
    _write(sheet_of(what, found), ending, common)


def _of_clutches(what: str, request: "Request", common: Common) -> Any:
    """Read and build the clutches, and calculate what is drawn of them."""
    from ..analysis.figures import gathered

    subjects = answers_of(what, request, common)
    with common.bar():
        return gathered(what, request._replace(subjects=subjects))


def _of_requirements(what: str, request: "Request", common: Common) -> Any:
    """Read the requirements and search, with a progress bar."""
    from ..analysis.figures import check_request, gathered
    from ..spec.requirements import read_requirements

    check_request(what, request)
    (source,) = request.subjects
    need = read_requirements(source, common.set or ())
    with common.bar():
        return gathered(what, request._replace(subjects=[need]))


def _ending(output: str | None) -> str | None:
    """Kind of the file, by its ending; None for text."""
    if output in (None, "-"):
        return None
    assert output is not None
    ending = output.rpartition(".")[2].lower() if "." in output else ""
    if ending not in _ENDINGS:
        raise AfmcalcError(say("--output {output}: end it in .png, .svg or .pdf (plot pocket: or .dxf)", output=output))
    return ending


def _write(sheet: "Sheet", ending: str | None, common: Common) -> None:
    if ending is None:
        from ..render.formats.table import columns, is_unicode
        from ..render.plot.chart import Chart
        from ..render.plot.text import draw_sheet

        if not any(isinstance(panel, Chart) for panel in sheet.panels):
            raise AfmcalcError(say("this is a drawing, no curve: give a file, -o FILE.svg (or .dxf, .png, .pdf)"))
        write(draw_sheet(sheet, unicode=is_unicode(), width=columns()), None)
        return
    from ..render.plot.figure import save

    assert common.output is not None
    write_file(common.output, save(sheet, ending), force=common.force)  # type: ignore[arg-type]
    common.wrote(say("wrote {output}", output=common.output))
