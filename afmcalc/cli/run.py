"""Reading the spec, running a calculation, printing its output."""

import os
import sys
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from .. import __version__
from ..analysis.registry import ANALYSES
from ..errors import need
from ..messages import say
from .files import format_of_spec
from .options import Common
from .streams import is_unicode

if TYPE_CHECKING:
    from ..engines import Clutch
    from ..findings import Finding
    from ..render.layout import SweepDrawing
    from ..result import Output
    from ..spec import Spec


def read(source: str | None, common: Common, of: str | None = None) -> "Spec":
    """Read the spec a command was given, or the one that ships; ``of``: what a plot or explanation is of."""
    from ..spec import read_spec

    if source is None:
        source = given_instead(common, of or common.command)
    elif source == "-" and sys.stdin.isatty():
        common.note(say("reading the spec from the terminal: end it with Ctrl-D, or give a file"))
    return read_spec(source, common.set or ())


def given_instead(common: Common, of: str) -> str | None:
    """Return the example that ships for an analysis, None for the base clutch, and name it in a note."""
    if of not in ANALYSES or (kind := ANALYSES[of].example) is None:
        common.note(say("no SPEC given: the built-in base clutch is used (afmcalc init writes a spec to start from)"))
        return None
    common.note(say("no SPEC given: example:{kind} is used (afmcalc init --kind {kind} writes it)", kind=kind))
    return f"example:{kind}"


def calculate(
    common: Common,
    source: str | None,
    options: "Callable[[Clutch], Mapping[str, object]]" = lambda clutch: {},
    curve: "SweepDrawing | None" = None,
) -> "Output":
    """Read the spec, build the clutch, run the analysis of the command on it and print what it returns.

    Args:
        common: the common options.
        source: where the spec is.
        options: arguments of the analysis beside the clutch.
        curve: what draws under a table's sweep.
    """
    from ..spec import resolved

    common.keep(source)
    clutch = build_from(source, common)
    analysis = ANALYSES[common.command].function
    with common.bar():
        result, findings = analysis(clutch, **options(clutch))
    return emit(common, result, findings, resolved(clutch.spec), curve)


def need_drawing(extra: str) -> None:
    """Make sure that the modules of an extra that draws are installed; what they log is not for our readers."""
    import logging

    need(extra)
    logging.getLogger("matplotlib").setLevel(logging.ERROR)


def build_from(source: str | None, common: Common, of: str | None = None) -> "Clutch":
    """Read a spec and build its clutch; arguments as ``read``."""
    from ..engines import build

    return build(read(source, common, of))


def emit(
    common: Common,
    result: Any,
    findings: "list[Finding]",
    spec: dict[str, Any] | None = None,
    curve: "SweepDrawing | None" = None,
) -> "Output":
    """Render the output of a command in the chosen format, to standard output or a file."""
    from ..result import Output

    chosen = common.chosen_format
    if common.quiet and chosen != "json" and not result.findings_first:
        findings = [finding for finding in findings if finding.level == "error"]
    output = Output(command=common.command, version=__version__, spec=spec, result=result, findings=findings)
    terminal = common.output is None and sys.stdout.isatty() and os.environ.get("TERM") != "dumb"
    if curve:
        from ..render.formats import table

        text = table.render(output, terminal, curve)
    else:
        from ..render import renderer

        text = renderer(chosen)(output, terminal)
    if chosen == "json" and common.output in (None, "-") and not is_unicode(sys.stdout):
        from ..render.formats.json import in_ascii

        text = in_ascii(text)
    common.write(text)
    if chosen == "csv" and not result.findings_first:
        from ..render.layout import findings_lines

        for line in findings_lines(findings):
            print(line, file=sys.stderr)
    return output


def write_spec(data: dict[str, Any], common: Common, about: str) -> None:
    """Write a spec to the file of a command that gives one beside its result; ``about`` says what it is."""
    assert common.output is not None
    if format_of_spec(common.output) == "json":
        import json

        text = json.dumps(data, indent=2, ensure_ascii=False) + "\n"
    else:
        from ..spec import to_toml

        text = to_toml(data, about)
    common.write(text, utf8=True)
