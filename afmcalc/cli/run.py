"""Reading the spec, running a calculation, printing its output."""

import os
import sys
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from .. import __version__
from ..analysis.registry import ANALYSES
from ..extras import need
from ..messages import say
from .files import SPEC, format_of_spec, result_kind
from .options import Common
from .streams import is_unicode

if TYPE_CHECKING:
    from ..engines import Clutch
    from ..findings import Finding
    from ..render.layout import SweepDrawing
    from ..result import Output
    from ..spec import Spec


def read(source: str | None, common: Common) -> "Spec":
    """Read the spec a command was given, or the built-in one with a note."""
    from ..spec import read_spec

    if source is None:
        common.note(say("no SPEC given: the built-in base clutch is used (afmcalc init writes a spec to start from)"))
    elif source == "-" and sys.stdin.isatty():
        common.note(say("reading the spec from the terminal: end it with Ctrl-D, or give a file"))
    return read_spec(source, common.set or ())


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


def build_from(source: str | None, common: Common) -> "Clutch":
    """Read a spec and build its clutch."""
    from ..engines import build

    return build(read(source, common))


def emit(
    common: Common,
    result: Any,
    findings: "list[Finding]",
    spec: dict[str, Any] | None = None,
    curve: "SweepDrawing | None" = None,
) -> "Output":
    """Render the output of a command in the chosen format, to standard output or a file."""
    from ..result import Output

    output = Output(command=common.command, version=__version__, spec=spec, result=result, findings=findings)
    chosen = common.chosen_format
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
    common.write(text, result_kind(common.command, chosen, text))
    if chosen == "csv" and not result.findings_first:
        from ..render.layout import findings_lines

        for line in findings_lines(findings):
            if not (common.quiet and line.startswith("info")):
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
    common.write(text, SPEC)
