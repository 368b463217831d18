"""Options of every command; reading the spec, running the calculation, printing its output."""

import inspect
import os
import sys
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, fields
from functools import wraps
from typing import TYPE_CHECKING, Annotated, Any, Literal

from typer import Argument, Option

from .. import __version__
from ..analysis.registry import ANALYSES
from ..errors import AfmcalcError, need
from ..messages import is_unicode, localized, say
from ..progress import Bar
from .files import format_of, is_json_spec, refuse, tell, write, write_file
from .names import completing

if TYPE_CHECKING:
    from ..engines import Clutch
    from ..findings import Finding
    from ..result import Output
    from ..spec import Spec

SpecArgument = Annotated[
    str | None,
    Argument(metavar="SPEC", help="TOML or JSON file, - for standard input, example:NAME; without it an example."),
]
SaveOption = Annotated[str | None, Option("--save", metavar="FILE", help="Write the spec with what was found.")]


def output_option(help: str) -> Any:
    """Declare ``--output`` with its help."""
    return Option("--output", "-o", metavar="FILE", help=help)


ForceOption = Annotated[bool, Option("--force", "-f", help="Replace a file that exists.")]
QuietOption = Annotated[bool, Option("--quiet", "-q", help="No notes; of the findings errors, and units in doubt.")]


def _with_equals_sign(overrides: list[str] | None) -> list[str] | None:
    """Check that overrides have a ``=`` before SPEC is read: of ``--set gain 0.7`` the parser takes 0.7 as SPEC."""
    from ..spec.read import key_of

    for override in overrides or ():
        key_of(override)
    return overrides


@dataclass
class Common:
    """The name of the command, and the options that all commands share."""

    command: str
    set: Annotated[
        list[str] | None,
        Option(
            "--set",
            metavar="PATH=VALUE",
            help="Override a spec key; repeatable. Empty VALUE removes it.",
            autocompletion=completing("path", "="),
            callback=_with_equals_sign,
        ),
    ] = None
    format: Annotated[
        Literal["table", "json", "csv", "markdown"] | None,
        Option(
            "--format",
            help="table, json, csv or markdown; JSON and CSV are SI in full precision. In Russian CSV has decimal "
            "commas and semicolons, as spreadsheets there read it.",
        ),
    ] = None
    json: Annotated[bool, Option("--json", help="The same as --format json.")] = False
    units: Annotated[
        Literal["engineer", "si"], Option("--units", help="Units of tables: engineer (mm, kN, MPa, deg) or si.")
    ] = "engineer"
    output: Annotated[str | None, output_option("Write the result to FILE; its name says the format.")] = None
    force: ForceOption = False
    quiet: QuietOption = False
    default: str = ""
    """Example that is calculated because no SPEC was given."""

    @property
    def overrides(self) -> list[str]:
        """Keys overridden by ``--set``."""
        return self.set or []

    @property
    def chosen_format(self) -> str:
        """The format asked for, or that of the file."""
        if self.json and self.format not in (None, "json"):
            raise AfmcalcError("--json and --format {name} exclude each other", name=self.format)
        return format_of(self.output, "json" if self.json else self.format)

    @property
    def csv_dialect(self) -> str:
        """The format that CSV is written in: that of spreadsheets where the language has a decimal comma."""
        return "csv" if localized("0.5") == "0.5" else "excel"

    def shown(self) -> AbstractContextManager[None]:
        """Show quantities in the units asked for."""
        if self.units == "engineer":
            return nullcontext()
        from ..render.amounts import shown_in

        return shown_in(self.units)

    def keep(self, *sources: str | None, beside: str | None = None, save: str | None = None) -> None:
        """Check the output paths: none is an input or exists, and their names fit.

        Args:
            sources: what is read.
            beside: a second file to write.
            save: file that gets a spec.
        """
        self.chosen_format  # noqa: B018
        if save:
            is_json_spec(save)
        refuse(self.output, beside, save, force=self.force, inputs=sources)

    def bar(self) -> AbstractContextManager[object]:
        """Show progress on a terminal while the block calculates."""
        return nullcontext() if self.quiet or not sys.stderr.isatty() else Bar()

    def note(self, text: str) -> None:
        """Print a note on standard error, unless ``--quiet``."""
        if not self.quiet:
            tell(say("note: {text}", text=text))

    def source(self, given: str | None, of: str = "") -> str:
        """Return SPEC, or the default example of an analysis: of the command, or of what is plotted or explained."""
        if given is None:
            analysis = ANALYSES.get(of or self.command)
            self.default = f"example:{analysis and analysis.example or 'default'}"
        elif given == "-" and sys.stdin.isatty():
            self.note(say("reading the spec from the terminal: end it with Ctrl-D, or give a file"))
        return given or self.default

    def note_default(self) -> None:
        """Name the default example where no table is headed by it."""
        if self.default:
            self.note(_no_spec(self.default))

    def read(self, source: str | None, of: str = "") -> "Spec":
        """Read the given spec, or the default example; ``of``: the analysis that is plotted or explained."""
        from ..spec import read_spec

        return read_spec(self.source(source, of), self.overrides)

    def build(self, source: str | None, of: str = "") -> "Clutch":
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

    def keep_without_clutch(self) -> None:
        """Check the options of a command that reads no spec: it has nothing to override."""
        self.keep()
        if self.overrides:
            raise AfmcalcError("{name} takes no clutch, so --set has nothing to override", name=self.command)

    def without_clutch(self, analysis: str, *arguments: object, **options: object) -> None:
        """Run an analysis that reads no spec, and print its result."""
        self.keep_without_clutch()
        self.command = analysis
        self.emit(*self.ask(*arguments, **options))

    def ask(self, *arguments: object, **options: object) -> Any:
        """Run the analysis of the command; return its result and findings."""
        with self.bar():
            return ANALYSES[self.command].function(*arguments, **options)

    def emit(self, result: Any, findings: "list[Finding]", spec: dict[str, Any] | None = None) -> "Output":
        """Render the output of a command in the chosen format, to standard output or a file."""
        from ..result import Output

        chosen = self.chosen_format
        if self.quiet and chosen != "json" and not result.findings_first:
            findings = [each for each in findings if each.level == "error" or each.code == "number-without-unit"]
        output = Output(command=self.command, version=__version__, spec=spec, result=result, findings=findings)
        terminal = self.output is None and sys.stdout.isatty() and os.environ.get("TERM") != "dumb"
        text = self._rendered(output, chosen, terminal)
        if self.default and chosen in ("table", "markdown"):
            text = f"{_no_spec(self.default)}\n\n{text}"
        if chosen == "json" and self.output in (None, "-") and not is_unicode(sys.stdout):
            from ..render.formats import in_ascii

            text = in_ascii(text)
        write(text, self.output, force=self.force, utf8=chosen == "csv")
        if chosen == "csv":
            from ..render.text_tables import findings_lines

            for line in findings_lines(findings):
                print(line, file=sys.stderr)
        return output

    def _rendered(self, output: "Output", chosen: str, terminal: bool) -> str:  # noqa: FBT001
        """Return the text of a result; heat of an event stands below it in a table of its own."""
        from dataclasses import replace

        from ..render import renderer

        render = renderer(self.csv_dialect if chosen == "csv" else chosen)
        heat = getattr(output.result, "heat", None)
        if chosen not in ("table", "markdown") or heat is None:
            return render(output, terminal)
        event = replace(output, result=output.result.model_copy(update={"heat": None}), findings=[])
        return f"{render(event, terminal)}\n{render(replace(output, command='heat', result=heat), terminal)}"

    def save(self, content: bytes, path: str) -> None:
        """Write a file, and report it."""
        write_file(path, content, force=self.force)
        self.note(say("wrote {output}", output=path))

    def save_spec(self, spec: "Spec", changes: Mapping[str, Any], changed: "Spec", path: str) -> None:
        """Write a spec with other values of some keys, its comments kept where the file is TOML."""
        from ..spec import resolved
        from ..spec.edit import saved

        if is_json_spec(path):
            import json

            text = json.dumps(resolved(changed), indent=2, ensure_ascii=False) + "\n"
        else:
            text = saved(spec, changes, changed, os.path.dirname(os.path.abspath(path)))
        self.save(text.encode(), path)


COMMON = frozenset(field.name for field in fields(Common)[1:-1])
"""Names of the options that the help of a command leaves to ``afmcalc help options``."""


def _no_spec(default: str) -> str:
    return say("no SPEC given: this is {default} (afmcalc init writes a spec to start from)", default=default)


def common_options(output_help: str = "") -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Give a command the common options, which it receives as ``common``.

    A command that writes a document says with ``output_help`` what ``--output`` gets; it has no format and no units.
    """
    options = {option.name: (option.type, option.default) for option in fields(Common)[1:-1]}
    if output_help:
        options = {name: options[name] for name in ("set", "output", "force", "quiet")}
        options["output"] = (Annotated[str | None, output_option(output_help)], None)

    def decorate(function: Callable[..., None]) -> Callable[..., None]:
        parameters = [p for p in inspect.signature(function, eval_str=True).parameters.values() if p.name != "common"]
        parameters += [
            inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation)
            for name, (annotation, default) in options.items()
        ]

        @wraps(function)
        def command(**arguments: Any) -> None:
            common = Common(function.__name__.rstrip("_"), **{name: arguments.pop(name) for name in options})
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
