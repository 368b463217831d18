"""What every command shares: its options, reading the spec, running the calculation, printing its output."""

import inspect
import os
import sys
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, fields, replace
from functools import wraps
from typing import TYPE_CHECKING, Annotated, Any, Literal

from typer import Argument, Option

from .. import __version__
from ..analysis.registry import ANALYSES
from ..errors import AfmcalcError, need
from ..messages import is_unicode, say, told
from ..progress import Bar
from .files import format_of, is_json_spec, refuse, write, write_file
from .help import completing
from .signals import unreported
from .streams import tell

if TYPE_CHECKING:
    from ..engines import Clutch
    from ..findings import Finding
    from ..result import Output
    from ..spec import Spec

LANG = "Language: en or ru; else by AFMCALC_LANG or the system."

SpecArgument = Annotated[
    str | None, Argument(metavar="SPEC", help="TOML or JSON file, - for standard input; without it one that ships.")
]


def output_option(help: str) -> Any:
    """Declare ``--output`` with its help."""
    return Option("--output", "-o", metavar="FILE", help=help)


ForceOption = Annotated[bool, Option("--force", "-f", help="Replace a file that exists.")]
QuietOption = Annotated[bool, Option("--quiet", "-q", help="No notes; of the findings errors alone.")]


def _with_equals_sign(overrides: list[str] | None) -> list[str] | None:
    """Check that overrides have a ``=`` before SPEC is read: of ``--set gain 0.7`` the parser takes 0.7 as SPEC."""
    from ..spec.edit import key_of

    for override in overrides or ():
        key_of(override)
    return overrides


@dataclass(frozen=True)
class Common:
    """The name of the command, and the options that all commands share."""

    command: str
    set: Annotated[
        list[str] | None,
        Option(
            metavar="PATH=VALUE",
            help="Override a spec key; repeatable. Empty VALUE removes it.",
            autocompletion=completing("path", "="),
            callback=_with_equals_sign,
        ),
    ] = None
    materials: Annotated[
        str | None, Option(metavar="FILE", help="Your own list of friction materials, TOML or CSV.")
    ] = None
    discs: Annotated[str | None, Option(metavar="FILE", help="Your own list of disc springs, TOML or CSV.")] = None
    balls: Annotated[str | None, Option(metavar="FILE", help="Your own list of ball diameters, TOML or CSV.")] = None
    format: Annotated[
        Literal["table", "json", "csv", "markdown"] | None,
        Option(help="How to print. JSON and CSV are SI in full precision.  [default: table]"),
    ] = None
    json: Annotated[bool, Option("--json", help="The same as --format json.")] = False
    excel: Annotated[
        bool,
        Option("--excel", help="The same as --format csv, for Excel: semicolons, decimal commas, a byte order mark."),
    ] = False
    units: Annotated[
        Literal["engineer", "si"], Option(help="Units of tables and Markdown: mm, kN, MPa, deg, or SI.")
    ] = "engineer"
    output: Annotated[str | None, output_option("Write to FILE instead of standard output.")] = None
    force: ForceOption = False
    yes: Annotated[bool, Option("--yes", help="Go on with what takes longer than a minute.")] = False
    quiet: QuietOption = False
    lang: Annotated[str | None, Option(metavar="NAME", help=LANG)] = None

    @property
    def overrides(self) -> list[str]:
        """Keys overridden: by ``--set``, and the catalogues, whose options are short forms of keys."""
        from json import dumps

        named = ((name, getattr(self, name)) for name in CATALOGUES)
        quoted = (f"catalogues.{name}={dumps(file, ensure_ascii=False)}" for name, file in named if file)
        return [*(self.set or ()), *quoted]

    @property
    def chosen_format(self) -> str:
        """The format asked for, or that of the file; ``--json`` and ``--excel`` are short forms."""
        asked = {
            "--json": self.json and "json",
            "--excel": self.excel and "csv",
            f"--format {self.format}": self.format,
        }
        given = [(option, name) for option, name in asked.items() if name]
        for option, name in given[1:]:
            if name != given[0][1]:
                raise AfmcalcError("{first} and {option} exclude each other", first=given[0][0], option=option)
        return format_of(self.output, given[0][1] if given else None)

    @property
    def csv_dialect(self) -> str:
        """The format that CSV is written in."""
        return "excel" if self.excel else "csv"

    def to_standard_output(self) -> "Common":
        """The same options with the result on standard output, for a command whose FILE is something else."""
        return replace(self, output=None)

    def shown(self) -> AbstractContextManager[None]:
        """Show quantities in the units asked for."""
        if self.units == "engineer":
            return nullcontext()
        from ..render.units import shown_in

        return shown_in(self.units)

    def keep(self, *sources: str | None, beside: str | None = None, spec: bool = False) -> None:
        """Refuse to overwrite ``sources`` or other files, and the name of another file than of a result, or a spec.

        ``beside`` is a second file to write.
        """
        if not spec:
            self.chosen_format  # noqa: B018
        elif self.output:
            is_json_spec(self.output)
        lists = (getattr(self, name) for name in CATALOGUES)
        refuse(self.output, beside, force=self.force, inputs=(*sources, *lists))

    def bar(self) -> Bar:
        """Show progress while the block calculates; refuse a calculation of more than a minute without ``--yes``."""
        return Bar(quiet=self.quiet, agreed=self.yes)

    def note(self, text: str) -> None:
        """Print a note on standard error, unless ``--quiet``."""
        if not self.quiet:
            tell(told("note: {text}", text=text))

    def wrote(self, text: str) -> None:
        """Report what was written."""
        self.note(text)
        unreported.clear()

    def read(self, source: str | None, of: str | None = None) -> "Spec":
        """Read the given spec, or the built-in one; ``of``: the analysis that is plotted or explained."""
        from ..spec import read_spec

        if source is None:
            source = self.given_instead(of or self.command)
        elif source == "-" and sys.stdin.isatty():
            self.note(say("reading the spec from the terminal: end it with Ctrl-D, or give a file"))
        return read_spec(source, self.overrides)

    def given_instead(self, of: str) -> str | None:
        """Return the built-in example for an analysis, None for the base clutch, and name it in a note."""
        if of not in ANALYSES or (kind := ANALYSES[of].example) is None:
            self.note(say("no SPEC given: the built-in base clutch is used (afmcalc init writes a spec to start from)"))
            return None
        self.note(say("no SPEC given: example:{kind} is used (afmcalc init --kind {kind} writes it)", kind=kind))
        return f"example:{kind}"

    def build(self, source: str | None, of: str | None = None) -> "Clutch":
        """Read a spec and build its clutch; arguments as ``read``."""
        from ..engines import build

        return build(self.read(source, of))

    def clutch(self, source: str | None) -> "Clutch":
        """Build the clutch of a spec for a command that writes its result; refuses what ``keep`` refuses."""
        self.keep(source)
        return self.build(source)

    def calculate(self, clutch: "Clutch", **options: object) -> "Output":
        """Run the analysis of the command on a clutch and print its result."""
        from ..spec import resolved

        result, findings = self.ask(clutch, **options)
        return self.emit(result, findings, resolved(clutch.spec))

    def without_clutch(self, *arguments: object, **options: object) -> None:
        """Run the analysis of a command that reads no spec, and print its result; refuses overrides."""
        self.keep()
        if self.overrides:
            raise AfmcalcError("{name} takes no clutch, so --set has nothing to override", name=self.command)
        self.emit(*self.ask(*arguments, **options))

    def ask(self, *arguments: object, **options: object) -> Any:
        """Run the analysis of the command; return its result and findings."""
        with self.bar():
            return ANALYSES[self.command].function(*arguments, **options)

    def emit(self, result: Any, findings: "list[Finding]", spec: dict[str, Any] | None = None) -> "Output":
        """Render the output of a command in the chosen format, to standard output or a file."""
        from ..render import renderer
        from ..result import Output

        chosen = self.chosen_format
        if self.quiet and chosen != "json" and not result.findings_first:
            findings = [finding for finding in findings if finding.level == "error"]
        output = Output(command=self.command, version=__version__, spec=spec, result=result, findings=findings)
        terminal = self.output is None and sys.stdout.isatty() and os.environ.get("TERM") != "dumb"
        text = renderer(self.csv_dialect if chosen == "csv" else chosen)(output, terminal)
        if chosen == "json" and self.output in (None, "-") and not is_unicode(sys.stdout):
            from ..render.formats import in_ascii

            text = in_ascii(text)
        self.write(text, utf8=self.excel)
        if chosen == "csv" and not result.findings_first:
            from ..render.layout import findings_lines

            for line in findings_lines(findings):
                print(line, file=sys.stderr)
        return output

    def write(self, text: str, *, utf8: bool = False) -> None:
        """Write to the file, or to standard output."""
        write(text, self.output, force=self.force, utf8=utf8)

    def save(self, content: bytes, path: str) -> None:
        """Write a file, and report it."""
        write_file(path, content, force=self.force)
        self.wrote(say("wrote {output}", output=path))

    def save_spec(self, spec: "Spec", changes: Mapping[str, Any], changed: "Spec", path: str) -> None:
        """Write a spec with other values of some keys, its comments kept where the file is TOML."""
        from ..spec import resolved
        from ..spec.saved import saved

        if is_json_spec(path):
            import json

            text = json.dumps(resolved(changed), indent=2, ensure_ascii=False) + "\n"
        else:
            text = saved(spec, changes, changed, os.path.dirname(os.path.abspath(path)))
        self.save(text.encode(), path)

    def write_spec(self, data: dict[str, Any], about: str, wrote: str) -> None:
        """Write a spec, with ``about`` as its first line, to the file beside the result; report it with ``wrote``."""
        assert self.output is not None
        if listed := data.get("catalogues"):
            home = os.path.dirname(os.path.abspath(self.output))
            data = data | {"catalogues": {name: _relative(file, home) for name, file in listed.items()}}
        if is_json_spec(self.output):
            import json

            text = json.dumps(data, indent=2, ensure_ascii=False) + "\n"
        else:
            from ..spec import to_toml

            text = to_toml(data, about)
        self.write(text, utf8=True)
        self.wrote(wrote)


CATALOGUES = ("materials", "discs", "balls")
"""Lists of one's own that may stand in the place of those that ship."""


def _relative(path: str, home: str) -> str:
    """Return a path as from a folder; as it is where none leads there, as to another drive."""
    try:
        return os.path.relpath(path, home).replace(os.sep, "/")
    except ValueError:
        return path


def common_options(output_help: str = "") -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Give a command the common options, which it receives as ``common``.

    A command that writes a document says with ``output_help`` what ``--output`` gets; it has no format and no units.
    """
    options = {option.name: (option.type, option.default) for option in fields(Common)[1:]}
    if output_help:
        options = {name: options[name] for name in ("set", *CATALOGUES, "output", "force", "yes", "quiet")}
        options["output"] = (Annotated[str | None, output_option(output_help)], None)

    def decorate(function: Callable[..., None]) -> Callable[..., None]:
        parameters = [p for p in inspect.signature(function, eval_str=True).parameters.values() if p.name != "common"]
        parameters += [
            inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation)
            for name, (annotation, default) in options.items()
        ]

        @wraps(function)
        def command(**arguments: Any) -> None:
            common = Common(function.__name__, **{name: arguments.pop(name) for name in options})
            with common.shown():
                function(**arguments, common=common)

        command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
        command.__annotations__ = {p.name: p.annotation for p in parameters}
        del command.__wrapped__
        return command

    return decorate


with_common = common_options()


def need_drawing(extra: str) -> None:
    """Require the modules of an extra that draws, and silence what matplotlib logs below an error."""
    import logging

    need(extra)
    logging.getLogger("matplotlib").setLevel(logging.ERROR)
