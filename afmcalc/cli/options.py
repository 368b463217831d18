"""Names that can be given on a command line; common options; reading the spec, calculating, printing the output."""

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
from ..messages import is_unicode, native, say, translate
from ..progress import bar
from .files import ending_of, format_of, refuse, tell, write

if TYPE_CHECKING:
    from ..engines import Clutch
    from ..findings import Finding
    from ..spec import Spec

Named = list[tuple[str, str]]
"""Pairs of a name and its meaning."""


def names_of(kind: str) -> Named:
    """Names of a kind (plot, example, target, path, swept; any other kind: symbols), each with its meaning."""
    from ..analysis.registry import PLOTS
    from ..equations.terms import TERMS
    from ..spec.keys import ALIASES, keys
    from ..spec.parse import example_names

    about = {path: translate(key.description) for path, key in keys().items()}
    symbols = [(symbol, f"{path}, {about[path].partition(';')[0]}") for symbol, path in ALIASES.items()]
    match kind:
        case "plot":
            return [(name, translate(plot.about)) for name, plot in PLOTS.items() if name not in DRAWINGS]
        case "example":
            return [(name, "") for name in example_names()]
        case "target":
            from ..analysis.solve import is_quantity

            terms = {name: own for name, own in TERMS.items() if is_quantity(name)}
            named = {name: f"{native(own.symbol)}, {translate(own.meaning)}" for name, own in terms.items()}
            required = [key for key in keys().values() if key.path.startswith("requirements.")]
            for key in required:
                meaning = about[key.path].partition(",")[0]
                named[key.path.partition(".")[2]] = f"{native(key.symbol or '')}, {meaning}"
            return [*named.items()]
        case "path":
            return [*about.items()]
        case "swept":
            return [("zC", translate("reduced gain")), *symbols]
    return symbols


DRAWINGS = {"section": "layout", "layout": "layout", "pocket": "pocket", "synthesize": "pocket"}
"""Drawing to scale, which is not a plot → the command that writes the drawing with --output."""


def completing(kind: str, end: str = "") -> Callable[[str], Named]:
    """Completion callback for a kind: names that begin with the typed text, each followed by ``end``."""
    return lambda incomplete: [(name + end, about) for name, about in names_of(kind) if name.startswith(incomplete)]


SpecArgument = Annotated[
    str | None,
    Argument(metavar="SPEC", help="TOML or JSON file, - for standard input, example:NAME; without it an example."),
]
SaveOption = Annotated[str | None, Option(metavar="FILE", help="Write a spec with the values found to FILE.")]


def output_option(help: str) -> Any:
    """Declare ``--output`` with its help."""
    return Option("--output", "-o", metavar="FILE", help=help)


ForceOption = Annotated[bool, Option("--force", "-f", help="Replace a file that exists.")]
QuietOption = Annotated[bool, Option("--quiet", "-q", help="No notes; of the findings only errors and doubtful units.")]


def _with_equals_sign(overrides: list[str] | None) -> list[str] | None:
    """Overrides, each checked for an equals sign: in ``--set gain 0.7`` the parser would take 0.7 as SPEC."""
    from ..spec.read import key_of

    for override in overrides or ():
        key_of(override)
    return overrides


@dataclass
class Common:
    """Name of the command, and the options common to all commands."""

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
    format: Annotated[
        Literal["table", "json", "csv", "markdown"] | None,
        Option(
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
    """Example that is calculated because no SPEC was given; empty if a SPEC was given."""

    @property
    def overrides(self) -> list[str]:
        """Values of ``--set``, each ``PATH=VALUE``."""
        return self.set or []

    @property
    def chosen_format(self) -> str:
        """Format by ``--format`` or ``--json``, else by the extension of the output file, else table."""
        if self.json and self.format not in (None, "json"):
            raise AfmcalcError("--json and --format {name} exclude each other", name=self.format)
        return format_of(self.output, "json" if self.json else self.format)

    def keep(self, *sources: str | None, beside: str | None = None, save: str | None = None) -> None:
        """Check the output paths: they are no inputs, exist only with ``--force``, and have an extension that fits.

        ``sources``: input paths; ``beside``: a second file to write; ``save``: path of a spec to write.
        """
        self.chosen_format  # noqa: B018
        if save:
            ending_of("--save", save, ".toml", ".json", others=True)
        refuse(self.output, beside, save, force=self.force, inputs=sources)

    def bar(self) -> AbstractContextManager[object]:
        """Context that shows progress on a terminal."""
        return nullcontext() if self.quiet or not sys.stderr.isatty() else bar()

    def note(self, text: str) -> None:
        """Print a note on standard error, unless ``--quiet``."""
        if not self.quiet:
            tell(say("note: {text}", text=text))

    def note_default(self) -> None:
        """Print the name of the default example, for output that does not contain the name."""
        if self.default:
            self.note(_no_spec(self.default))

    def read(self, source: str | None, of: str = "") -> "Spec":
        """Spec with overrides, from SPEC, else from the default example of the analysis ``of`` or of the command."""
        from ..spec import read_spec

        if source is None:
            analysis = ANALYSES.get(of or self.command)
            self.default = f"example:{analysis and analysis.example or 'default'}"
        elif source == "-" and sys.stdin.isatty():
            self.note(say("reading the spec from the terminal: end it with Ctrl-D, or give a file"))
        return read_spec(source or self.default, self.overrides)

    def build(self, source: str | None, of: str = "") -> "Clutch":
        """Clutch of a spec; arguments as in ``read``."""
        from ..engines import build

        return build(self.read(source, of))

    def drawn(self, source: str | None, of: str = "") -> "Clutch":
        """Clutch to draw; findings on the spec are printed, as drawings show no findings. Arguments as in ``read``."""
        clutch = self.build(source, of)
        self.note_default()
        for question in clutch.spec.label.findings:
            self.note(question.message)
        return clutch

    def clutch(self, source: str | None, **others: str | None) -> "Clutch":
        """Clutch of a spec, after ``keep`` has checked the output paths."""
        self.keep(source, **others)
        return self.build(source)

    def calculate(self, clutch: "Clutch", **options: object) -> Any:
        """Run the command's analysis on a clutch; print its output and return its result."""
        result, findings = self.ask(clutch, **options)
        self.emit(result, findings, clutch.spec)
        return result

    def keep_without_clutch(self) -> None:
        """Check the output path of a command that reads no spec; ``--set`` is an error."""
        self.keep()
        if self.overrides:
            raise AfmcalcError("{name} takes no clutch, so --set has nothing to override", name=self.command)

    def without_clutch(self, analysis: str, *arguments: object, **options: object) -> None:
        """Run an analysis that reads no spec, and print its result."""
        self.keep_without_clutch()
        self.command = analysis
        self.emit(*self.ask(*arguments, **options))

    def ask(self, *arguments: object, **options: object) -> Any:
        """Result and findings of the command's analysis."""
        with self.bar():
            return ANALYSES[self.command].function(*arguments, **options)

    def emit(self, result: Any, findings: "list[Finding]", spec: "Spec | None" = None) -> None:
        """Write a result in the chosen format to standard output or a file; the heat of an event is a second table."""
        from ..render import renderer
        from ..result import Output
        from ..spec import resolved

        chosen, heat = self.chosen_format, getattr(result, "heat", None)
        if self.quiet and chosen != "json" and self.command != "check":  # whose purpose the findings are
            findings = [each for each in findings if each.level == "error" or each.code == "number-without-unit"]
        outputs = [Output(self.command, __version__, resolved(spec) if spec else None, result, findings)]
        text = ""
        if chosen in ("table", "markdown"):
            text = f"{_no_spec(self.default)}\n\n" if self.default else ""
            if heat:
                event = replace(outputs[0], result=result.model_copy(update={"heat": None}), findings=[])
                outputs = [event, replace(outputs[0], command="heat", result=heat)]
        terminal = self.output is None and sys.stdout.isatty() and os.environ.get("TERM") != "dumb"
        text += "\n".join(renderer(chosen)(output, terminal) for output in outputs)
        if chosen == "json" and self.output in (None, "-") and not is_unicode(sys.stdout):
            from ..render.formats import in_ascii

            text = in_ascii(text)
        write(text, self.output, force=self.force, utf8=chosen == "csv")
        if chosen == "csv":
            from ..render.text_tables import findings_lines

            for line in findings_lines(findings):
                print(line, file=sys.stderr)

    def save(self, content: bytes, path: str | None) -> None:
        """Write a document or picture to standard output, or to a file with a note about it."""
        write(content, path, force=self.force)
        if path not in (None, "-"):
            self.note(say("wrote {output}", output=path))

    def save_spec(self, spec: "Spec", changes: Mapping[str, Any], path: str, changed: "Spec | None" = None) -> None:
        """Write a spec with the values of ``changes``; ``changed`` is the spec with these values, if it is known."""
        from ..spec.edit import respecified, saved

        self.save(saved(spec, changes, changed or respecified(spec, changes), path).encode(), path)


COMMON = frozenset(field.name for field in fields(Common)[1:-1])
"""Names of the options that only ``afmcalc help options`` shows, not the help of a command."""


def _no_spec(default: str) -> str:
    return say("no SPEC given: this is {default} (afmcalc init writes a spec to start from)", default=default)


_PAGES = "HTML file, or PDF by its name; without it HTML to standard output."
_DOCUMENTS = {
    "report": _PAGES,
    "handbook": _PAGES,
    "plot": "File, .png, .svg or .pdf; without it SVG to standard output.",
}
"""Command that writes a document, which has no formats and units → help of its ``--output``."""


def with_common(function: Callable[..., None]) -> Callable[..., None]:
    """Command with the common options, which the function receives as ``common`` if it has such a parameter."""
    own = inspect.signature(function, eval_str=True).parameters
    if "common" not in own:
        return function
    name = function.__name__.rstrip("_")
    options = {option.name: (option.type, option.default) for option in fields(Common)[1:-1]}
    if name in _DOCUMENTS:
        options = {each: options[each] for each in ("set", "output", "force", "quiet")}
        options["output"] = (Annotated[str | None, output_option(_DOCUMENTS[name])], None)
    parameters = [parameter for parameter in own.values() if parameter.name != "common"]
    parameters += [
        inspect.Parameter(each, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation)
        for each, (annotation, default) in options.items()
    ]

    @wraps(function)
    def command(**arguments: Any) -> None:
        common = Common(name, **{each: arguments.pop(each) for each in options})
        if common.units == "engineer":
            return function(**arguments, common=common)
        from ..render.amounts import shown_in

        with shown_in(common.units):
            return function(**arguments, common=common)

    command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    command.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    return command


def need_drawing(extra: str) -> None:
    """Check that the modules of an extra for drawing are installed; let matplotlib log nothing but errors."""
    import logging

    need(extra)
    logging.getLogger("matplotlib").setLevel(logging.ERROR)
