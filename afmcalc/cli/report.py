"""The command that writes a calculation report."""

import os
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from .. import __version__
from ..errors import AfmcalcError
from ..extras import need
from ..messages import say
from .files import write, write_file
from .options import Common, SpecArgument

if TYPE_CHECKING:
    from ..engines import Clutch
    from ..findings import Finding
    from ..spec import Spec


def report(
    spec: SpecArgument = None,
    pdf: Annotated[
        bool, typer.Option("--pdf", help="Print it to PDF too, beside FILE, with a headless browser found here.")
    ] = False,
    model: Annotated[
        Literal["mean-stress", "amplitude", "goodman"],
        typer.Option("--model", help="Rule for the damaging stress of the life."),
    ] = "mean-stress",
    set_: Annotated[
        list[str] | None, typer.Option("--set", metavar="PATH=VALUE", help="Override a spec key; repeatable.")
    ] = None,
    output: Annotated[
        str | None, typer.Option("--output", "-o", metavar="FILE", help="HTML file; without it standard output.")
    ] = None,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="No notes on standard error.")] = False,
) -> None:
    """Calculation report: one self-contained HTML file, for the project folder or the reviewer.

    \b
    afmcalc report clutch.toml -o report.html
    afmcalc report clutch.toml -o report.html --pdf
    """  # noqa: D301
    need("report")
    from ..analysis.dossier import dossier
    from ..engines import build
    from ..render.report import Subject, render
    from ..render.report.browser import find_browser, print_pdf
    from ..render.report.steps import explained

    common = Common(set=set_, output=output, quiet=quiet)
    target = _pdf_beside(output) if pdf else None
    browser = find_browser() if pdf else None
    common.keep(spec)
    given, read = _read(spec, common)
    clutch = build(read)
    found, findings = dossier(clutch, model)
    calculations: dict[str, dict[str, str]] = {"torque": {}, "accuracy": {}, "adjust": {}}
    calculations |= {"overload": {}} if found.overload else {}
    calculations |= {"synthesize": {}} if found.synthesis else {}
    calculations |= {"life": {"model": model}} if found.life else {}
    steps = explained(read, calculations)
    results, more = _beyond(clutch)
    findings = list(dict.fromkeys([*findings, *more]))
    subject = Subject(
        clutch, found, findings, given, set_ or (), __version__, _date(), model=model, steps=steps, results=results
    )
    page = render(subject)
    write(page, output)
    if output not in (None, "-"):
        common.note(say("wrote {output}", output=output))
    if target and browser:
        write_file(target, print_pdf(browser, page))
        common.note(say("wrote {target}", target=target))


def _beyond(clutch: "Clutch") -> "tuple[dict[str, Any], list[Finding]]":
    """Results that the spec asks for by a block of its own, and their findings."""
    if clutch.spec.tolerance is None:
        return {}, []
    from ..analysis.tolerance.study import study

    found = study(clutch)
    return {"tolerance": found}, found.findings


def _pdf_beside(output: str | None) -> str:
    if output in (None, "-"):
        raise AfmcalcError(say("--pdf prints beside the HTML file: give it with -o report.html"))
    assert output is not None
    stem, ending = os.path.splitext(output)
    if ending.lower() == ".pdf":
        raise AfmcalcError(
            say(
                "-o {output}: the report is HTML; -o {stem}.html --pdf writes {output} beside it",
                output=output,
                stem=stem,
            )
        )
    return f"{stem}.pdf"


def _read(source: str | None, common: Common) -> "tuple[str, Spec]":
    """Read a spec once, and return its text with it; of a command's JSON the spec block."""
    from ..spec import make_spec
    from ..spec.reading import apply_overrides, parse, text_of

    if source is None:
        common.note(say("no SPEC given: the built-in base clutch is used (afmcalc init writes a spec to start from)"))
    text, label = text_of(source)
    data = parse(text, label)
    if text.lstrip().startswith("{"):
        import json

        text = json.dumps(data, indent=2, ensure_ascii=False)
    return text.strip("\n"), make_spec(apply_overrides(data, common.set or ()), label)


def _date() -> str:
    """Today, or the day of SOURCE_DATE_EPOCH where a build must be repeatable."""
    from datetime import UTC, datetime

    epoch = os.environ.get("SOURCE_DATE_EPOCH", "")
    if not epoch:
        return datetime.now().date().isoformat()
    if not epoch.isdecimal():
        raise AfmcalcError(say("SOURCE_DATE_EPOCH = {epoch!r}: seconds since 1970 are wanted", epoch=epoch))
    return datetime.fromtimestamp(int(epoch), UTC).date().isoformat()
