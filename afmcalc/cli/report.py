"""The command that writes a calculation report."""

import os
from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated, Any

from typer import Option

from .. import __version__
from ..analysis.registry import StressRule
from ..errors import AfmcalcError
from ..messages import say, spoken
from .files import html_only, refuse
from .options import Common, SpecArgument, common_options, need_drawing

if TYPE_CHECKING:
    from ..spec import Spec
    from ..spec.models import TitleBlock


def _entry(text: str) -> Any:
    return Option(metavar="TEXT", help=text)


@common_options("HTML file; without it standard output.")
def report(
    spec: SpecArgument = None,
    pdf: Annotated[
        bool, Option("--pdf", help="Print it to PDF too, beside FILE, with a headless browser found here.")
    ] = False,
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
    *,
    common: Common,
) -> None:
    """Calculation report: one self-contained HTML file, for the project folder or the reviewer.

    \b
    afmcalc report clutch.toml -o report.html
    afmcalc report clutch.toml -o report.html --pdf
    afmcalc report clutch.toml -o report.html --drawing AFM-17 --author "A. N. Other"

    The block [report] of the spec says the same; an option goes before it.
    """  # noqa: D301
    need_drawing("report")
    from hashlib import sha256

    from ..analysis.dossier import dossier
    from ..render.report import Subject, render

    options = {
        "organisation": organisation, "project": project, "drawing": drawing, "revision": revision,
        "author": author, "checked": checked, "norm_control": norm_control,
        "approved": approved, "date": date,
    }  # fmt: skip

    def page() -> str:
        raw, given, read = _read(spec, common)
        title, digest = _title_block(read, options), sha256(raw).hexdigest()
        return render(Subject(dossier(read, model), given, title, digest, read.label, common.overrides, __version__))

    _write(common, page, spec=spec, pdf=pdf)


@common_options("HTML file; without it standard output.")
def handbook(
    pdf: Annotated[
        bool, Option("--pdf", help="Print it to PDF too, beside FILE, with a headless browser found here.")
    ] = False,
    *,
    common: Common,
) -> None:
    """Handbook: the theory behind every number, one HTML file.

    \b
    afmcalc handbook -o handbook.html
    afmcalc handbook -o handbook.html --pdf
    """  # noqa: D301
    need_drawing("report")
    from ..analysis.handbook import handbook as gathered
    from ..render.handbook import render

    if common.overrides:
        raise AfmcalcError("{name} takes no clutch, so --set has nothing to override", name=common.command)
    _write(common, lambda: render(gathered(spoken())), pdf=pdf)


def _write(common: Common, render: Callable[[], str], *, spec: str | None = None, pdf: bool) -> None:
    """Write a page, and print it to PDF if so wanted: both, or neither where the browser fails."""
    from ..render.report.browser import find_browser, print_pdf

    output = common.output
    html_only(output)
    target = browser = None
    if pdf:
        if output in (None, "-"):
            raise AfmcalcError("--pdf prints beside the HTML file: name that with -o FILE.html")
        target, browser = f"{os.path.splitext(output)[0]}.pdf", find_browser()
    refuse(output, target, force=common.force, inputs=[spec])
    with common.bar() as bar:
        page = render()
        bar.advance("report", 1, 2 if browser else 1)
        printed = print_pdf(browser, page) if browser else b""
    common.write(page)
    if output not in (None, "-"):
        common.wrote(say("wrote {output}", output=output))
    if target:
        common.save(printed, target)


def _title_block(spec: "Spec", options: dict[str, str | None]) -> "TitleBlock":
    """The [report] block of the spec under the options, dated today where neither has a date."""
    from ..spec.make import validated
    from ..spec.models import TitleBlock

    given = {name: text for name, text in options.items() if text is not None}
    block = {"date": None} if spec.report is None else spec.report.model_dump()
    return validated(TitleBlock, {**block, "date": block["date"] or _date(), **given}, "report")


def _read(source: str | None, common: Common) -> "tuple[bytes, str, Spec]":
    """Read a spec once, and return file and text with it; the text of a command's JSON is that of its spec block."""
    from ..spec.parse import bytes_of, decoded, parse
    from ..spec.read import spec_of

    raw, name = bytes_of(common.given_instead("report") if source is None else source)
    given = decoded(raw, name)
    spec, text = spec_of(given, common.overrides), given.text
    if text.lstrip().startswith("{"):
        import json

        text = json.dumps(parse(given), indent=2, ensure_ascii=False)
    return raw, text.strip("\n"), spec


_DIGITS = 11
"""Of seconds since 1970: those of the year 5000."""


def _date() -> str:
    """Today, or the day of SOURCE_DATE_EPOCH where a build must be repeatable."""
    from datetime import UTC, datetime

    epoch = os.environ.get("SOURCE_DATE_EPOCH", "")
    if not epoch:
        return datetime.now().date().isoformat()
    if not epoch.isdecimal() or len(epoch) > _DIGITS:
        raise AfmcalcError("SOURCE_DATE_EPOCH = {epoch!r:.40}: seconds since 1970 are wanted", epoch=epoch)
    return datetime.fromtimestamp(int(epoch), UTC).date().isoformat()
