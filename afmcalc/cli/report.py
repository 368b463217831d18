"""The command that writes a calculation report."""

import os
from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated, Any

from typer import Option

from .. import __version__, progress
from ..analysis.registry import StressRule
from ..errors import AfmcalcError, need
from ..messages import say, spoken
from .files import ending_of, refuse, write
from .options import Common, SpecArgument, common_options, need_drawing

if TYPE_CHECKING:
    from ..render.report.blocks import Document


def _entry(text: str) -> Any:
    return Option(metavar="TEXT", help=text)


@common_options("HTML file, or PDF by its name; without it HTML to standard output.")
def report(
    spec: SpecArgument = None,
    pdf: Annotated[bool, Option("--pdf", help="PDF too, beside FILE.")] = False,
    short: Annotated[
        bool, Option("--short", help="Two pages: task, limits and their use, section, peaks and heat, conclusions.")
    ] = False,
    with_source: Annotated[bool, Option("--with-source", help="The spec as given, as an appendix.")] = False,
    model: Annotated[StressRule, Option(help="Rule for the damaging stress of the life.")] = "mean-stress",
    organisation: Annotated[str | None, _entry("Title block: who answers for the calculation.")] = None,
    project: Annotated[str | None, _entry("Title block: project the clutch belongs to.")] = None,
    drawing: Annotated[str | None, _entry("Title block: number of the drawing.")] = None,
    revision: Annotated[str | None, _entry("Title block: revision of the calculation.")] = None,
    author: Annotated[str | None, _entry("Title block: who calculated.")] = None,
    checked: Annotated[str | None, _entry("Title block: who checked.")] = None,
    norm_control: Annotated[str | None, _entry("Title block: who checked it against the standards.")] = None,
    approved: Annotated[str | None, _entry("Title block: who approved.")] = None,
    date: Annotated[str | None, _entry("Title block: date of the calculation.  [default: today]")] = None,
    form: Annotated[
        str | None,
        Option(
            metavar="calculation|report",
            help="Sheets: with frame and title block in Russian, or in 12 pt.  [default: calculation]",
        ),
    ] = None,
    *,
    common: Common,
) -> None:
    """Calculation report: one self-contained HTML file, for the project folder or the reviewer.

    \b
    afmcalc report clutch.toml -o report.html
    afmcalc report clutch.toml -o report.pdf
    afmcalc report clutch.toml -o report.html --pdf
    afmcalc report clutch.toml -o report.html --drawing AFM-17 --author "A. N. Other"

    The block [report] of the spec says the same; an option goes before it.
    """  # noqa: D301
    need_drawing("report")
    from hashlib import sha256

    from ..analysis.dossier import dossier
    from ..render.report import Subject
    from ..render.report import report as laid_out
    from ..render.report.title import text_as_given, title_block
    from ..spec.parse import bytes_of, decoded
    from ..spec.read import spec_of

    options = {
        "organisation": organisation, "project": project, "drawing": drawing, "revision": revision,
        "author": author, "checked": checked, "norm_control": norm_control,
        "approved": approved, "date": date, "form": form,
    }  # fmt: skip

    def document() -> "Document":
        # read once: the digest is of what is calculated
        raw, name = bytes_of(common.source(spec))
        common.note_default()
        source = decoded(raw, name)
        read, given = spec_of(source, common.overrides), text_as_given(source)
        title, digest = title_block(read, options), sha256(raw).hexdigest()
        told = dossier(read, model, explained=not short)
        texts = given, title, digest, read.label, common.overrides, __version__
        return laid_out(Subject(told, *texts, with_source, short))

    _write(common, document, spec=spec, pdf=pdf)


@common_options("HTML file, or PDF by its name; without it HTML to standard output.")
def handbook(
    pdf: Annotated[bool, Option("--pdf", help="PDF too, beside FILE.")] = False,
    *,
    common: Common,
) -> None:
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
    _write(common, lambda: book(gathered(spoken())), pdf=pdf)


def _write(common: Common, lay_out: Callable[[], "Document"], *, spec: str | None = None, pdf: bool) -> None:
    """Write a document as HTML, as PDF, or both; nothing where one of them fails."""
    from ..render.report.html import page

    output, target = common.output, None
    alone = output is not None and ending_of("--output", output, ".html", ".htm", ".pdf", others=True) == ".pdf"
    if alone:
        target = output
    elif pdf:
        if output in (None, "-"):
            raise AfmcalcError("--pdf writes beside the HTML file: name that with -o FILE.html")
        target = f"{os.path.splitext(output)[0]}.pdf"
    if target:
        need("pdf", "typst")
    refuse(*dict.fromkeys((output, target)), force=common.force, inputs=[spec])
    with common.bar():
        document = lay_out()
        progress.tell("report", 1, 2 if target else 1)
        sheets = b""
        if target:
            from ..render.report.sheets import lacking, print_pdf

            if signs := lacking(document):
                common.note(say("the PDF has boxes in the place of {signs}: no font for them", signs=signs))
            sheets = print_pdf(document)
    if not alone:
        if output in (None, "-"):
            write(page(document), None)
        else:
            common.save(page(document).encode(), output)
    if target:
        common.save(sheets, target)
