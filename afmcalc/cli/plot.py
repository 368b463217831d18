"""The command that draws, also for the shop."""

from typing import TYPE_CHECKING, Annotated

from typer import Argument, Option

from ..analysis.registry import PLOTS, StressRule
from ..errors import AfmcalcError, need
from .files import picture_of, refuse
from .help import completing
from .options import Common, common_options, need_drawing

if TYPE_CHECKING:
    from ..analysis.answers import Answers
    from ..analysis.figures import Request
    from ..render.drawing import Drawing

_SHOP = ("dxf", "svg")
"""Drawings of the pocket for the shop."""


_KINDS = [name for name in PLOTS if name != "paper"]


@common_options("File, .png, .svg, .pdf (section, pocket: .dxf); without it SVG to standard output.")
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
            metavar="NAME[=RANGE]", autocompletion=completing("swept"), help="accuracy: the axis (C); life: dT=RANGE."
        ),
    ] = None,
    model: Annotated[StressRule | None, Option(help="life: rule for the damaging stress.")] = None,
    *,
    common: Common,
) -> None:
    """Plots: of clutches, of section and pocket to scale, of tolerances, of a design's front, of the papers' figures.

    \b
    afmcalc plot section clutch.toml -o section.svg
    afmcalc plot torque clutch.toml -o torque.svg
    afmcalc plot accuracy a.toml b.toml --sweep C=0:1.25:101 -o accuracy.png
    afmcalc plot pocket clutch.toml -o pocket.pdf
    afmcalc plot pocket clutch.toml -o pocket.dxf
    afmcalc plot tolerance clutch.toml -o tolerance.svg
    afmcalc plot pareto requirements.toml -o front.svg
    afmcalc plot paper S22-3 -o figure.png
    """  # noqa: D301
    from ..analysis.figures import Request, check_request, gathered, plot_of, shop_drawing_of
    from ..render import shop
    from ..render.plot import sheet_of
    from ..render.plot.figure import save

    chosen = plot_of(what)
    what, output = chosen.name, common.output
    ending = picture_of(output)
    of_clutches = chosen.takes not in ("names", "search")
    sources: list[str | None] = [*(subjects or ())] or ([None] if of_clutches else [])
    refuse(output, force=common.force, inputs=sources)
    if sources.count("-") > 1:
        raise AfmcalcError("standard input (-) can be read once only")
    request = Request(sources, sweep, model)
    check_request(what, request)
    if ending == "dxf" and what not in _DRAWN:
        raise AfmcalcError("--output {output}: only plot pocket and plot section are drawn as .dxf", output=output)
    _need(what, ending)
    if of_clutches:
        request = request._replace(subjects=_answers(what, request, common))
    elif chosen.takes == "search":
        request = request._replace(subjects=[common.read(source) for source in request.subjects])
    with common.bar():
        if what == "pocket" and ending in _SHOP:
            content = _for_the_shop(shop.pocket(shop_drawing_of(what, request)), ending)
        elif ending == "dxf":
            drawing = shop.section(gathered(what, request), request.subjects[0].clutch.spec)
            content = _for_the_shop(drawing, ending)
        else:
            content = save(sheet_of(what, gathered(what, request)), ending)
    if output in (None, "-"):
        common.write(content.decode(), utf8=True)
    else:
        common.save(content, str(output))


_DRAWN = ("section", "pocket")


def _need(what: str, ending: str) -> None:
    """Require what writes a picture: of a curve matplotlib, of a drawing ezdxf or Typst."""
    if ending == "dxf":
        need("cad")
    elif what not in _DRAWN:
        need_drawing("plot")
    elif ending != "svg":
        need("plot")
        need("pdf")


def _for_the_shop(drawing: "Drawing", ending: str) -> bytes:
    """Write a sheet for the shop."""
    from ..render.dxf import dxf
    from ..render.svg import svg

    return dxf(drawing) if ending == "dxf" else svg(drawing).encode()


def _answers(what: str, request: "Request", common: Common) -> "list[Answers]":
    """Read and build the clutches that are drawn."""
    from ..analysis.answers import Answers

    clutches = [common.build(source, what) for source in request.subjects]
    for clutch in clutches:
        for question in clutch.spec.label.findings:
            common.note(question.message)  # a plot has no findings
    return [Answers(clutch, model=request.model or "mean-stress") for clutch in clutches]
