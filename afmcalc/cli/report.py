"""The command that writes a calculation report."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated, Literal

from typer import Option

from .. import progress
from ..analysis.registry import StressRule
from ..errors import AfmcalcError, need
from ..messages import say, spoken
from .files import ending_of, refuse
from .options import Common, SpecArgument, common_options, need_drawing

if TYPE_CHECKING:
    from ..render.report.blocks import Document


@common_options("HTML file, or PDF by its name; without it HTML to standard output.")
def report(
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
    *,
    common: Common,
) -> None:
    """Calculation report: one self-contained HTML file, for the project folder or the reviewer.

    \b
    afmcalc report clutch.toml -o report.html
    afmcalc report clutch.toml -o report.pdf
    afmcalc report clutch.toml -o report.html --set report.author="A. N. Other"

    The block [report] of the spec fills the title block; its date is today's if it has none.
    """  # noqa: D301
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


@common_options("HTML file, or PDF by its name; without it HTML to standard output.")
def handbook(*, common: Common) -> None:
    """Handbook: the theory behind every number, one HTML file.

    \b
    afmcalc handbook -o handbook.html
    afmcalc handbook -o handbook.pdf
    """  # noqa: D301
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
        need("pdf", "typst")
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
