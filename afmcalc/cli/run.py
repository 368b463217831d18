"""Reading the spec, running a calculation, printing its output."""

import os
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from .. import __version__
from ..analysis.registry import ANALYSES
from ..errors import CalculationError, SpecError
from .files import write
from .options import Common

if TYPE_CHECKING:
    from ..engines import Clutch
    from ..findings import Finding
    from ..render.layout import Curve
    from ..result import Output
    from ..spec import Spec


def read(source: str | None, common: Common) -> "Spec":
    """Read the spec a command was given, or the built-in one with a note."""
    from ..spec import read_spec

    if source is None:
        common.note("no SPEC given: the built-in base clutch is used (afmcalc init writes a spec to start from)")
    elif source == "-" and sys.stdin.isatty():
        common.note("reading the spec from the terminal: end it with Ctrl-D, or give a file")
    return read_spec(source, common.set or ())


def calculate(
    common: Common,
    source: str | None,
    options: "Callable[[Clutch], Mapping[str, object]]" = lambda clutch: {},
    curve: "Curve | None" = None,
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
    with naming(source):
        result, findings = guarded(lambda: analysis(clutch, **options(clutch)))
    return emit(common, result, findings, resolved(clutch.spec), curve)


def build_from(source: str | None, common: Common) -> "Clutch":
    """Read a spec and build its clutch."""
    from ..engines import build

    spec = read(source, common)
    with naming(source):
        clutch: Clutch = guarded(lambda: build(spec))
    return clutch


@contextmanager
def naming(source: str | None) -> Iterator[None]:
    """Name the file in errors that engines and analyses find in a spec."""
    from ..spec.reading import label_of

    try:
        yield
    except SpecError as error:
        raise error.named(label_of(source)) from None


def guarded(calculation: Callable[[], Any]) -> Any:
    """Run a calculation; a result beyond the range of numbers is an error for people."""
    from pydantic import ValidationError

    try:
        return calculation()
    except ValidationError as error:
        if any(detail["type"] != "finite_number" for detail in error.errors()):
            raise
        raise CalculationError(_NOT_FINITE) from None
    except (OverflowError, ZeroDivisionError):
        raise CalculationError(_NOT_FINITE) from None


_NOT_FINITE = "a result is not finite (beyond the range of numbers): check the magnitudes in the spec"


def emit(
    common: Common,
    result: Any,
    findings: "list[Finding]",
    spec: dict[str, Any] | None = None,
    curve: "Curve | None" = None,
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
    write(text, common.output)
    if chosen == "csv" and not result.findings_first:
        from ..render.layout import findings_lines

        for line in findings_lines(findings):
            if not (common.quiet and line.startswith("info")):
                print(line, file=sys.stderr)
    return output
