"""Reading the spec, running a calculation, printing its output."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from .. import __version__
from ..errors import CalculationError, SpecError
from .files import write
from .options import Common

if TYPE_CHECKING:
    from ..engines import Clutch
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
    name: str,
    source: str | None,
    common: Common,
    analysis: Callable[["Clutch"], Any],
    curve: "Curve | None" = None,
) -> "Output":
    """Read the spec, build the clutch, run ``analysis`` on it and print what it returns."""
    from ..spec import resolved

    common.keep(source)
    clutch = build_from(source, common)
    with naming(source):
        result, findings = guarded(lambda: analysis(clutch))
    return emit(name, result, findings, common, resolved(clutch.spec), curve)


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


def read_again(output: "Output") -> "Spec":
    """Return the spec an output carries."""
    from ..spec import make_spec

    assert output.spec is not None
    return make_spec(output.spec)


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
    name: str,
    result: Any,
    findings: Any,
    common: Common,
    spec: dict[str, Any] | None,
    curve: "Curve | None" = None,
) -> "Output":
    """Render an output in the chosen format, to standard output or a file; ``curve`` draws under a table's sweep."""
    from ..render import renderer
    from ..result import Output

    output = Output(command=name, version=__version__, spec=spec, result=result, findings=findings)
    chosen = common.chosen_format
    terminal = common.output is None and _is_terminal()
    text = renderer(chosen)(output, terminal) if curve is None else _with_curve(output, terminal, curve)
    write(text, common.output)
    if chosen == "csv" and not result.findings_first:
        from ..render.layout import findings_lines

        for line in findings_lines(findings):
            if not (common.quiet and line.startswith("info")):
                print(line, file=sys.stderr)
    return output


def _with_curve(output: "Output", terminal: bool, curve: "Curve") -> str:
    from ..render.formats import table

    return table.render(output, terminal, curve)


def _is_terminal() -> bool:
    import os

    return sys.stdout.isatty() and os.environ.get("TERM") != "dumb"
