"""What every command shares: its options, reading the spec, printing the output, the exit code."""

import inspect
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, fields, replace
from functools import wraps
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from .. import __version__
from ..errors import AfmcalcError, CalculationError, FileError, SpecError

if TYPE_CHECKING:
    from ..analysis.result import Output
    from ..engines import Clutch
    from ..render.table import Curve
    from ..spec import Spec

SpecArgument = Annotated[
    str | None,
    typer.Argument(metavar="SPEC", help="TOML or JSON file, - for standard input; without it the base clutch."),
]


@dataclass(frozen=True)
class Common:
    """Options of every command."""

    set: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="PATH=VALUE", help="Override a spec key; repeatable. Empty VALUE removes it."),
    ] = None
    format: Annotated[
        Literal["table", "json", "csv", "markdown"] | None,
        typer.Option("--format", help="How to print. JSON and CSV are SI in full precision.  [default: table]"),
    ] = None
    json: Annotated[bool, typer.Option("--json", help="The same as --format json.")] = False
    output: Annotated[
        str | None, typer.Option("--output", "-o", metavar="FILE", help="Write to FILE instead of standard output.")
    ] = None
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="No notes on standard error.")] = False

    @property
    def chosen_format(self) -> str:
        """The format asked for; ``--json`` is a short form."""
        if self.json and self.format not in (None, "json"):
            raise AfmcalcError(f"--json and --format {self.format} exclude each other")
        return "json" if self.json else self.format or "table"

    def to_standard_output(self) -> "Common":
        """The same options with the result on standard output, for a command whose FILE is something else."""
        return replace(self, output=None)

    def keep(self, source: str | None) -> None:
        """Refuse to write over the spec that is read."""
        import os

        if source not in (None, "-") and self.output and os.path.exists(self.output):
            assert source is not None
            if os.path.exists(source) and os.path.samefile(source, self.output):
                raise AfmcalcError(f"--output {self.output}: is the SPEC itself; write to another file")

    def takes_no_clutch(self, name: str) -> None:
        """Refuse overrides where there is no spec to override."""
        if self.set:
            raise AfmcalcError(f"{name} takes no clutch, so --set has nothing to override")

    def note(self, text: str) -> None:
        """Say something beside the result."""
        if not self.quiet:
            print(f"note: {text}", file=sys.stderr)


def with_common(function: Callable[..., None]) -> Callable[..., None]:
    """Give a command the common options; it receives them as ``common``."""
    own = inspect.signature(function, eval_str=True)
    parameters = [p for p in own.parameters.values() if p.name != "common"]
    parameters += [
        inspect.Parameter(option.name, inspect.Parameter.KEYWORD_ONLY, default=option.default, annotation=option.type)
        for option in fields(Common)
    ]

    @wraps(function)
    def command(**arguments: Any) -> None:
        options = {option.name: arguments.pop(option.name) for option in fields(Common)}
        function(**arguments, common=Common(**options))

    command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    command.__annotations__ = {p.name: p.annotation for p in parameters}
    del command.__wrapped__
    return command


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
    from ..analysis.result import Output
    from ..render import renderer

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
    from ..render import table

    return table.render(output, terminal, curve)


def _is_terminal() -> bool:
    import os

    return sys.stdout.isatty() and os.environ.get("TERM") != "dumb"


def write(text: str, path: str | None) -> None:
    """Write text to standard output, or to a file that is either whole or untouched."""
    if path is None or path == "-":
        sys.stdout.write(text)
        sys.stdout.flush()
        return
    write_file(path, text.encode("utf-8"))


def write_file(path: str, content: bytes) -> None:
    """Replace a file at once, by way of a temporary one beside it.

    Raises:
        FileError: it cannot be written.
    """
    import os
    import tempfile

    target = os.path.realpath(path)
    if os.path.exists(target) and not os.path.isfile(target):
        _write_through(path, content)
        return
    temporary = None
    try:
        handle, temporary = tempfile.mkstemp(dir=os.path.dirname(target), prefix=".afmcalc-")
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        os.chmod(temporary, _mode(target))
        os.replace(temporary, target)
    except OSError as error:
        raise FileError(f"{path}: cannot be written: {error.strerror or error}") from None
    except BaseException:
        if temporary:
            os.unlink(temporary)
        raise


def _write_through(path: str, content: bytes) -> None:
    """Write to what is no regular file (a device, a pipe)."""
    try:
        with open(path, "wb") as file:
            file.write(content)
    except OSError as error:
        raise FileError(f"{path}: cannot be written: {error.strerror or error}") from None


def _mode(target: str) -> int:
    """Permissions for a written file: those it had, or those the umask leaves."""
    import os

    try:
        return os.stat(target).st_mode & 0o777
    except FileNotFoundError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask
