"""The command that plots."""

from typing import Annotated

from typer import Argument, Option

from ..analysis.registry import PLOTS, StressRule
from ..errors import AfmcalcError
from .files import picture_of, refuse
from .names import DRAWINGS, completing
from .options import Common, common_options, need_drawing

_KINDS = [name for name in PLOTS if name not in DRAWINGS and name != "paper"]


@common_options("File, .png, .svg or .pdf; without it SVG to standard output.")
def plot(
    what: Annotated[
        str,
        Argument(
            metavar="WHAT", autocompletion=completing("plot"), help=f"{', '.join(_KINDS)}, or paper with a figure."
        ),
    ],
    subjects: Annotated[
        list[str] | None,
        Argument(
            metavar="SPEC",
            help="Specs; several give several curves. After paper: F11-2, S22-3, ...; after pareto: REQUIREMENTS.",
        ),
    ] = None,
    sweep: Annotated[
        str | None,
        Option(
            metavar="NAME[=RANGE]",
            autocompletion=completing("swept"),
            help="For accuracy: key on the axis, default C; for life: dT=RANGE.",
        ),
    ] = None,
    model: Annotated[StressRule | None, Option(help="For life: the rule for the damaging stress.")] = None,
    *,
    common: Common,
) -> None:
    """Plots: of clutches, of tolerances, of a design's front, of the papers' figures.

    \b
    afmcalc plot torque clutch.toml -o torque.svg
    afmcalc plot accuracy a.toml b.toml --sweep C=0:1.25:101 -o accuracy.png
    afmcalc plot tolerance clutch.toml -o tolerance.svg
    afmcalc plot pareto requirements.toml -o front.svg
    afmcalc plot paper S22-3 -o figure.png
    """  # noqa: D301
    from ..analysis.asking import Answers
    from ..analysis.plot_data import Request, check_request, gathered, plot_of
    from ..render.plot import sheet_of
    from ..render.plot.figure import save

    if what in DRAWINGS:
        raise AfmcalcError("{what} is a drawing: afmcalc {command} SPEC -o FILE.svg", what=what, command=DRAWINGS[what])
    chosen = plot_of(what)
    what, output = chosen.name, common.output
    ending = picture_of(output, "png", "svg", "pdf")
    of_clutches = chosen.takes not in ("names", "search")
    sources: list[str | None] = [*(subjects or ())] or ([None] if of_clutches else [])
    refuse(output, force=common.force, inputs=sources)
    if sources.count("-") > 1:
        raise AfmcalcError("standard input (-) can be read once only")
    request = Request(sources, sweep, model)
    check_request(what, request)
    need_drawing("plot")
    if of_clutches:
        clutches = [common.drawn(source, what) for source in request.subjects]
        request = request._replace(subjects=[Answers(clutch, model=model or "mean-stress") for clutch in clutches])
    elif chosen.takes == "search":
        request = request._replace(subjects=[common.read(source) for source in request.subjects])
    with common.bar():
        content = save(sheet_of(what, gathered(what, request)), ending)
    common.save(content, output)
