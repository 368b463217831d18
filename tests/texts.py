"""Every English text of the program that people read: what a catalogue has to hold."""

import ast
import errno
import inspect
import os
import pkgutil
import re
import string
import textwrap
import tomllib
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Literal, get_args, get_origin

from conftest import CONFIGS
from sources import called, calls

import afmcalc
from afmcalc.result import Shown, shown_as

Key = tuple[str, str]
"""Context and text."""

FAILURES = (
    errno.ENOENT, errno.EACCES, errno.EPERM, errno.EISDIR, errno.ENOTDIR, errno.ENOSPC, errno.EROFS, errno.ENAMETOOLONG,
    errno.ELOOP, errno.EBADF, errno.EIO, errno.EPIPE,
)  # fmt: skip
"""Why files cannot be read or written, as the system says it."""

SAYING = (
    *("say", "told", "message", "translate", "term", "heard", "wrong"),
    *("AfmcalcError", "FileError", "CalculationError"),
)


@cache
def texts() -> dict[Key, str]:
    """Context and text → where it is from."""
    found: dict[Key, str] = {}
    for where, each in (
        ("literals", _literals()),
        ("findings", _findings()),
        ("report", _report()),
        ("fields", _fields()),
        ("schema", _schemas()),
        ("help", _help()),
        ("registry", _registry()),
        ("equations", _equations()),
        ("papers", _papers()),
        ("values", _values()),
        ("units", _units()),
        ("names", _names()),
        ("symbols", _symbols()),
        ("examples", _examples()),
    ):
        for key in each:
            if worded(key[1]) or key[0] in ("unit", "date", "symbol"):
                found.setdefault(key, where)
    return found


def worded(text: str) -> bool:
    """Whether a text has words, units or decimal points of its own beside its fields."""
    bare = "".join(part for part, *_ in string.Formatter().parse(text)) if "{" in text else text
    bare = re.sub(r"\w+_\w+|\b(sin|cos|tan|ln|zC|pi)\b|\b[FSM]\d+\b", "", bare)
    return re.search(r"[A-Za-z]{2}|\d\.\d|N·m|N/mm", bare) is not None


def _literals() -> Iterator[Key]:
    """First arguments of what says something, wherever it is called."""
    for _, node in calls("map"):
        if node.args and getattr(node.args[0], "id", "") == "translate":
            yield from (("", text) for each in ast.walk(node.args[1]) for text in _strings(each))
    for module, node in calls(*SAYING, "say_many"):
        in_table = called(node) == "told" and module.startswith("render.report")
        if node.args and not in_table:
            yield from ((_context(node), text) for text in _strings(node.args[0]))


def _context(node: ast.Call) -> str:
    second = node.args[1] if len(node.args) > 1 else None
    name = getattr(node.func, "id", "")
    if name == "translate" and isinstance(second, ast.Constant):
        return str(second.value)
    return ""


def _strings(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    elif isinstance(node, ast.IfExp):
        yield from _strings(node.body)
        yield from _strings(node.orelse)


def _findings() -> Iterator[Key]:
    from afmcalc.findings import FINDINGS

    yield from (("", text) for text in FINDINGS.values())


def _report() -> Iterator[Key]:
    from afmcalc.render import verdict
    from afmcalc.render.report import words

    yield from (("", text) for text in (*words.REPORT.values(), *verdict.SENTENCES.values()))
    report = Path(words.__file__).parent
    for page in (*report.glob("*.html"), *report.glob("*.css"), *(report.parents[1] / "web").glob("*.html")):
        yield from (("", text) for text in re.findall(r'\b_\("([^"]+)"', page.read_text(encoding="utf-8")))


def modules() -> Iterator[object]:
    for each in pkgutil.walk_packages(afmcalc.__path__, "afmcalc."):
        if not each.name.endswith("__main__"):
            yield import_module(each.name)


def models() -> list[type]:
    from pydantic import BaseModel

    found: dict[type, None] = {}
    for module in modules():
        for each in vars(module).values():
            if inspect.isclass(each) and issubclass(each, BaseModel) and each.__module__.startswith("afmcalc"):
                found[each] = None
    return list(found)


def _fields() -> Iterator[Key]:
    """Descriptions of what results and specs hold, and their symbols of more than letters."""
    for model in models():
        for name, info in model.model_fields.items():  # type: ignore[attr-defined]
            yield ("", info.description or name)
            shown = shown_as(info)
            yield ("", shown.keys_are)
            if shown.null not in ("", Shown.null):
                yield ("value", shown.null)
            if re.search(r" (from|to|of|at) |\b(from|to)$|^[a-z]+\.$", shown.symbol or ""):
                yield ("", str(shown.symbol))


def _schemas() -> Iterator[Key]:
    """What JSON Schemas say of tables, results and their fields."""
    from afmcalc.analysis.registry import ANALYSES, schema

    for name in (None, "requirements", *ANALYSES):
        yield from (("", text) for text in described(schema(name)))


def described(part: object) -> Iterator[str]:
    """Descriptions in a part of a schema."""
    if isinstance(part, dict):
        if isinstance(text := part.get("description"), str):
            yield text
        part = list(part.values())
    if isinstance(part, list):
        for each in part:
            yield from described(each)


def _help() -> Iterator[Key]:
    """Paragraphs of the help of commands, and what is said of their arguments."""
    import typer

    from afmcalc.analysis.solve.solve import TARGETS
    from afmcalc.cli import help
    from afmcalc.cli.main import application

    program = typer.main.get_command(application([]))
    for command in (program, *program.commands.values()):  # type: ignore[attr-defined]
        for part in help.paragraphs(command.help or ""):
            lines = part.splitlines()[1:] if part.startswith("\b") else [part]
            if not all(re.fullmatch(r"\s*(\S+ )?(afmcalc|export|eval|source)\b(?!.*   ).*", line) for line in lines):
                yield ("", part)
        for parameter in command.params:
            if parameter.help:
                yield ("", parameter.help)
    sections = {*help.SECTIONS.values(), *help.APART.values(), help.FILES}
    yield from (("", text) for text in (*help.LABELS, help.OF_HELP, *help.SAID, *help.OURS.values(), *sections))
    yield from (("", target.description) for target in TARGETS.values())
    yield from (("", about) for _, about in help.names_of("plot"))


def _registry() -> Iterator[Key]:
    from afmcalc.analysis import registry

    yield from (("", plot.about) for plot in registry.PLOTS.values())
    for each in registry.ANALYSES.values():
        if each.section:
            for text in (each.section.title, each.section.about, each.section.conclusion):
                if isinstance(text, str):
                    yield ("", text)
                else:
                    yield from (("", said) for said in _returned(inspect.getsource(text)))


def _returned(source: str) -> Iterator[str]:
    """Sentences in the source of a function, each a whole one."""
    for node in ast.walk(ast.parse(textwrap.dedent(source))):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and " " in node.value:
            yield node.value


def _equations() -> Iterator[Key]:
    """What the equations calculate, as steps and reports name it, and what their symbols mean."""
    from afmcalc.analysis.explain.explain import _OF_TANGENT
    from afmcalc.equations.catalogue import equations

    for each in equations().values():
        yield ("", each.summary.partition(",")[0].rstrip("."))
        yield ("", each.about)
        yield ("", each.validity)
        for term in (*each.arguments.values(), each.result):
            if term.meaning:
                yield ("", term.meaning)
    yield from (("", text) for text in _OF_TANGENT.values())


def _papers() -> Iterator[Key]:
    """What the lists of the papers say, and what is said of their figures."""
    from afmcalc.equations.catalogue import equations
    from afmcalc.papers import FIGURES, register
    from afmcalc.papers.claims import paper_figure
    from afmcalc.render.plot.schemes import SCHEMES
    from afmcalc.spec.catalogues import friction_materials

    for each in equations().values():
        yield ("", each.source)
    for material in friction_materials().values():
        yield from (("value", text) for text in (material.description, material.condition))
    for name in FIGURES:
        figure = paper_figure(name)
        yield from (("", text) for text in (figure.name, figure.title, figure.inputs, figure.assumed))
        yield from (("", text) for text in figure.corrections)
        yield from (("", axis.name) for axis in (figure.x, *figure.y))
        yield from (("", curve.label) for panel in figure.panels for curve in panel)
    for entry in register.misprints():
        yield from (
            ("", text) for text in (entry.where, entry.printed, entry.correct, entry.why, entry.reading) if text
        )
    for scheme in SCHEMES.values():
        yield from (("", text) for text in (scheme().title, scheme().caption))
    for formula in register.register():
        said = (formula.id, formula.says, formula.printed, formula.covered_by, formula.correct, formula.not_reached)
        yield from (("", text) for text in said if text)
    for claim in register.data("claims.toml")["claim"]:
        yield from (("", claim[part]) for part in ("source", "inputs", "printed", "why", "correction") if part in claim)


def _values() -> Iterator[Key]:
    """Words that a result may hold: those of its types."""
    for model in models():
        if not model.__name__.startswith("_"):
            for info in model.model_fields.values():  # type: ignore[attr-defined]
                yield from (("value", word) for word in _choices(info.annotation))
    yield from (("value", word) for word in ("error", "warning", "info", "min", "mean", "max"))


def _choices(annotation: object) -> Iterator[str]:
    if get_origin(annotation) is Literal:
        yield from (word for word in get_args(annotation) if isinstance(word, str))
    for each in get_args(annotation):
        if not isinstance(each, str):
            yield from _choices(each)


def _units() -> Iterator[Key]:
    from afmcalc.equations.catalogue import equations
    from afmcalc.render.units import display_unit
    from afmcalc.spec.quantity import EXAMPLES
    from afmcalc.units import ENGINEER, typeset

    for _, text in (*_literals(), *_findings()):
        for *_, wanted, _ in string.Formatter().parse(text):
            if unit := (wanted or "").partition(" ")[2].removesuffix("…"):
                yield ("unit", unit)
    yield from (("unit", typeset(unit)) for unit in ENGINEER.values())
    terms = [term for each in equations().values() for term in (*each.arguments.values(), each.result)]
    written = {*ENGINEER, *EXAMPLES, *(term.unit for term in terms)}
    si = {typeset(unit) for unit in written}
    yield from (("unit", unit) for unit in sorted(si | written) if re.search("[A-Za-z]", unit) and "abs" not in unit)
    axes = (node.args[2] for _, node in calls("ChartAxis") if len(node.args) > 2)
    yield from (("unit", typeset(unit)) for axis in axes for unit in _strings(axis) if re.search("[A-Za-z]", unit))
    for model in models():
        for info in model.model_fields.values():  # type: ignore[attr-defined]
            shown = display_unit(shown_as(info).unit)
            if re.search("[A-Za-z]", shown):
                yield ("unit", shown)


def _symbols() -> Iterator[Key]:
    """What Russian writes otherwise: words in symbols and functions."""
    from afmcalc.equations.catalogue import equations

    terms = [term for each in equations().values() for term in (*each.arguments.values(), each.result)]
    shown = [shown_as(info).symbol or "" for model in models() for info in model.model_fields.values()]  # type: ignore[attr-defined]
    for text in (*(term.symbol for term in terms), *shown):
        yield from (
            ("symbol", word)
            for index in re.findall(r"_([^\W_]+(?:[.,][^\W_]+)*)", text)
            for word in re.findall("[A-Za-z]{2,}", index)
        )
    yield from (
        ("symbol", text)
        for text in (
            "f_cp",
            "tan",
            "cot",
            "arctan",
            "tanh",
            "K_т wanted",
            "T wanted",
            " or ",
            "τ_eq",
            "τ'_eq",
            "T_ср",
            "T_ср.max",
        )
    )


def _names() -> Iterator[Key]:
    """What tables hold: names of limits, kinds of quantities, variants."""
    from afmcalc.analysis.requirements import JUDGED
    from afmcalc.engines import parts
    from afmcalc.render import drawing, dxf
    from afmcalc.render.shop import LAYERS
    from afmcalc.spec.keys import keys
    from afmcalc.spec.quantity import EXAMPLES
    from afmcalc.variants import VARIANTS

    yield from (("", kind) for kind, _ in EXAMPLES.values())
    yield from (("", keys()[f"requirements.{name}"].description.partition(",")[0]) for name in JUDGED)
    yield from (("value", name) for name in VARIANTS)
    yield from (("value", part) for part in ("center", "spread"))
    rules = [each for each in vars(parts).values() if isinstance(each, parts.PartRule)]
    yield from (("", name) for name in ("stiffness", *(each.misses for each in rules)))
    yield from (("", each.what) for each in rules)
    yield from (("", each.needs) for each in JUDGED.values() if " " in each.needs)
    yield from (("", about) for about, *_ in (*LAYERS.values(), *drawing.LAYERS.values(), *dxf.SHEET.values()))
    yield from (("", os.strerror(number)) for number in FAILURES)


def _examples() -> Iterator[Key]:
    """Names and comments of the specs that ship."""
    for path in sorted(CONFIGS.glob("*.toml")):
        text = path.read_text(encoding="utf-8")
        yield ("name", tomllib.loads(text)["name"])
        for line in text.splitlines():
            if comment := comment_of(line):
                yield ("comment", comment)


def comment_of(line: str) -> str:
    """Words of a line's comment; nothing of a line that is an optional key alone."""
    from afmcalc.spec.write import comment

    return comment(line)
