"""Commands that write documents and pictures: report, handbook, plot."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated, Literal

from typer import Argument, Option

from .. import progress
from ..analysis.registry import PLOTS, StressRule
from ..errors import AfmcalcError, need
from ..messages import say, spoken
from .files import ending_of, picture_of, refuse
from .options import DRAWINGS, Common, SpecArgument, completing, need_drawing

if TYPE_CHECKING:
    from ..render.report.blocks import Document


def report(
    common: Common,
    spec: SpecArgument = None,
    short: Annotated[
        bool, Option("--short", help="Two pages: task, limits and their use, section, peaks and heat, conclusions.")
    ] = False,
    with_source: Annotated[bool, Option("--with-source", help="The spec as given, as an appendix.")] = False,
    model: Annotated[StressRule, Option(help="Rule for the damaging stress of the life.")] = "mean-stress",
    form: Annotated[
        Literal["calculation", "report"] | None,
        Option(help="calculation: in Russian with frame and title block; report: in 12 pt.  [default: calculation]"),
    ] = None,
    revision: Annotated[
        str | None, Option(help="Revision for the title block; its other cells stand in [report].")
    ] = None,
) -> None:
    """Calculation report: one self-contained HTML file, for the project folder or the reviewer.

    \b
    afmcalc report clutch.toml -o report.html
    afmcalc report clutch.toml -o report.pdf
    afmcalc report clutch.toml -o report.html --set report.author="A. N. Other"

    The block [report] of the spec fills the title block; its date is today's if it has none.
    """
    need_drawing("report")
    from ..analysis.dossier import dossier
    from ..render.report import Subject
    from ..render.report import report as laid_out

    given = {"form": form, "revision": revision}
    common.set = [*common.overrides, *(f"report.{key}={value}" for key, value in given.items() if value)]

    def document() -> "Document":
        told = dossier(common.read(spec), model, explained=not short)
        common.note_default()
        return laid_out(Subject(told, common.overrides, with_source, short))

    _write(common, document, spec)


def handbook(common: Common) -> None:
    """Handbook: the theory behind every number, one HTML file.

    \b
    afmcalc handbook -o handbook.html
    afmcalc handbook -o handbook.pdf
    """
    need_drawing("report")
    from ..analysis.handbook_content import handbook as gathered
    from ..render.report.book import book

    if common.overrides:
        raise AfmcalcError("{name} takes no clutch, so --set has nothing to override", name=common.command)
    _write(common, lambda: book(gathered(spoken())))


def _write(common: Common, lay_out: Callable[[], "Document"], spec: str | None = None) -> None:
    """Write a document as HTML or, if its file is named so, as PDF."""
    sheets = ending_of("--output", common.output, ".html", ".htm", ".pdf", others=True) == ".pdf"
    if sheets:
        need("pdf")
    refuse(common.output, force=common.force, inputs=[spec])
    with common.bar():
        document = lay_out()
        progress.tell("report", 1, 1 + sheets)
        if sheets:
            from ..render.report.sheets import print_pdf

            content, missing = print_pdf(document)
            if missing:
                common.note(say("the PDF has boxes in the place of {signs}: no font for them", signs=missing))
        else:
            from ..render.report.html import page

            content = page(document).encode()
    common.save(content, common.output)


_KINDS = [name for name in PLOTS if name not in DRAWINGS and name != "paper"]


def plot(
    common: Common,
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
) -> None:
    """Plots: of clutches, of tolerances, of a design's front, of the papers' figures.

    \b
    afmcalc plot torque clutch.toml -o torque.svg
    afmcalc plot accuracy a.toml b.toml --sweep C=0:1.25:101 -o accuracy.png
    afmcalc plot tolerance clutch.toml -o tolerance.svg
    afmcalc plot pareto requirements.toml -o front.svg
    afmcalc plot paper S22-3 -o figure.png
    """
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
