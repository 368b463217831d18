"""The command that draws."""

from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from ..errors import AfmcalcError
from ..extras import need
from .files import write, write_file
from .options import Common
from .run import build_from, guarded, naming

if TYPE_CHECKING:
    from ..render.plot import Request
    from ..render.plot.chart import Sheet

_ENDINGS = ("png", "svg", "pdf")


def plot(
    what: Annotated[
        str,
        typer.Argument(
            metavar="WHAT", help="torque, accuracy, overload, life, pocket, tolerance, pareto, or paper with a figure."
        ),
    ],
    subjects: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[SPEC...]",
            help="Specs; several give several curves. After paper: F11-2, S22-3, ...; after pareto: REQUIREMENTS.",
        ),
    ] = None,
    sweep: Annotated[
        str | None, typer.Option("--sweep", metavar="NAME[=RANGE]", help="accuracy: the axis (C); life: dT=RANGE.")
    ] = None,
    model: Annotated[
        Literal["mean-stress", "amplitude", "goodman"] | None,
        typer.Option("--model", help="life: rule for the damaging stress."),
    ] = None,
    set_: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="PATH=VALUE", help="Override a spec key in every SPEC; repeatable."),
    ] = None,
    output: Annotated[
        str | None,
        typer.Option("--output", "-o", metavar="FILE", help="File, .png, .svg or .pdf; without it drawn as text."),
    ] = None,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="No notes on standard error.")] = False,
) -> None:
    """Plots: of clutches, of the pocket to scale, of tolerances, of a design's front, of the papers' figures.

    \b
    afmcalc plot torque clutch.toml -o torque.svg
    afmcalc plot accuracy a.toml b.toml --sweep C=0:1.25:101 -o accuracy.png
    afmcalc plot pocket clutch.toml -o pocket.pdf
    afmcalc plot tolerance clutch.toml -o tolerance.svg
    afmcalc plot pareto requirements.toml -o front.svg
    afmcalc plot paper S22-3 -o figure.png
    """  # noqa: D301
    from ..render.plot import Request, kind_of, sheet_of

    common = Common(set=set_, output=output, quiet=quiet)
    kind = kind_of(what)
    ending = _ending(output)
    need("plot", "matplotlib" if ending else "plotext")
    given: list[Any] = list(subjects or ())
    if kind.takes == "names":
        sheet = sheet_of(what, Request(given, sweep, model))
    elif kind.takes == "requirements":
        sheet = _of_requirements(what, Request(given, sweep, model), common)
    else:
        _refuse_twice(given)
        for source in given:
            common.keep(source)
        sources = given or [None]
        with naming(sources[0]):
            clutches = [build_from(source, common) for source in sources]
            sheet = guarded(lambda: sheet_of(what, Request(clutches, sweep, model)))
    _write(sheet, ending, common)


def _of_requirements(what: str, request: "Request", common: Common) -> "Sheet":
    """Read the requirements and search, with a progress bar."""
    from ..analysis.design.space import total
    from ..render.plot import check_request, sheet_of
    from ..spec.requirements import read_requirements
    from .progress import Progress

    check_request(what, request)
    (source,) = request.subjects
    common.keep(source)
    need = read_requirements(source, common.set or ())
    with Progress(total(need), quiet=common.quiet) as progress:
        sheet: Sheet = guarded(lambda: sheet_of(what, request._replace(subjects=[need], progress=progress.advance)))
    return sheet


def _ending(output: str | None) -> str | None:
    """Kind of the file, by its ending; None for text."""
    if output in (None, "-"):
        return None
    assert output is not None
    ending = output.rpartition(".")[2].lower() if "." in output else ""
    if ending not in _ENDINGS:
        raise AfmcalcError(f"--output {output}: end it in .png, .svg or .pdf")
    return ending


def _refuse_twice(sources: list[str]) -> None:
    if sources.count("-") > 1:
        raise AfmcalcError("standard input (-) can be read once only")


def _write(sheet: "Sheet", ending: str | None, common: Common) -> None:
    if ending is None:
        from ..render.formats.table import is_unicode
        from ..render.plot.chart import Chart
        from ..render.plot.text import draw_sheet

        if not any(isinstance(panel, Chart) for panel in sheet.panels):
            raise AfmcalcError("this is a drawing, no curve: give a file, -o FILE.svg (or .png, .pdf)")
        write(draw_sheet(sheet, unicode=is_unicode()), None)
        return
    from ..render.plot.figure import save

    assert common.output is not None
    write_file(common.output, save(sheet, ending))  # type: ignore[arg-type]
    common.note(f"wrote {common.output}")
