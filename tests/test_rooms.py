"""The order of the source: all imports go one way, also those in functions; each message is a template in one place."""

import ast
import inspect
import string
from functools import cache
from graphlib import CycleError, TopologicalSorter
from importlib import import_module
from importlib.util import resolve_name

import pytest
from sources import FILES, called, calls, nodes

from afmcalc.engines.checks import CHECKS
from afmcalc.engines.parts import RULES
from afmcalc.findings import FINDINGS
from afmcalc.units import per_si

pytestmark = pytest.mark.usefixtures("parsed_package")
LINE = [
    "equations", "ground", "variants", "spec", "engines", "drive", "papers", "analysis", "render", "web", "cli",
    "door",
]  # fmt: skip
"""A room imports from itself and from rooms to its left."""

GROUND = {"errors", "findings", "formula_tree", "messages", "progress", "result", "units"}
MAY_ONLY = {"equations": set(), "ground": set()}  # Rooms that know less than what is left of them


def room(module: str) -> str:
    first = module.partition(".")[0]
    return "door" if first in ("", "__main__", "python") else "ground" if first in GROUND else first


@cache
def imported(module: str) -> set[str]:
    """Modules of the package that a module imports anywhere in it."""
    found = set()
    for node in nodes(module):
        if isinstance(node, ast.ImportFrom) and (node.level or (node.module or "").startswith("afmcalc")):
            home = [*module.split(".")] if FILES[module].stem == "__init__" else module.split(".")[:-1]
            base = home[: len(home) - node.level + 1] if node.level else []
            path = ".".join([*base, *(node.module or "").removeprefix("afmcalc").split(".")]).strip(".")
            for alias in node.names:
                inner = f"{path}.{alias.name}".strip(".")
                found.add(inner if inner in FILES else path)
        elif isinstance(node, ast.Import):
            found |= {alias.name.removeprefix("afmcalc.") for alias in node.names if alias.name.startswith("afmcalc")}
    return found - {module, ""}  # of the package itself only the version is asked


def named(module: str) -> set[str]:
    """Modules that a module names in a string, to import them at their first use."""
    texts = {node.value for node in nodes(module) if isinstance(node, ast.Constant) and isinstance(node.value, str)}
    return {text.strip(".").removeprefix("afmcalc.") for text in texts if "." in text.rstrip(".")} & set(FILES) - {""}


def test_no_arrow_goes_back():
    back = set()
    for module in FILES:
        own = room(module)
        assert own in LINE, f"{module} stands in no room"
        allowed = MAY_ONLY.get(own, set(LINE[: LINE.index(own)])) | {own}
        back |= {(module, other) for other in imported(module) | named(module) if room(other) not in allowed}
    assert not back


def for_types(module: str) -> set[str]:
    """Modules of its own folder that a module imports for type checkers alone, as a base class does its subclass."""
    home = module.rpartition(".")[0]
    blocks = [node for node in nodes(module) if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"]
    inside = [node for block in blocks for node in ast.walk(block)]
    beside = [node for node in nodes(module) if isinstance(node, ast.ImportFrom) and node.level == 1]
    outside = {node.module for node in beside if node not in inside}
    return {f"{home}.{node.module}" for node in beside if node.module not in outside}


def test_no_circle():
    try:
        TopologicalSorter({module: imported(module) - for_types(module) for module in FILES}).prepare()
    except CycleError as error:
        pytest.fail(" → ".join(error.args[1]))


ALWAYS = {"value", "limit", "path", None}
"""The fields of a finding, whether or not its sentence shows it; None: a dictionary of further values."""
GLUED = (ast.JoinedStr, ast.BinOp)  # Texts put together on the spot, which no catalogue could hold


def fields(template: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(template) if name is not None}


def literal(node: ast.AST) -> str | None:
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def test_what_is_said_is_a_literal_template_filled_with_what_it_names():
    for where, call in calls("say", "wrong", "AfmcalcError", "FileError", "CalculationError"):
        template, given = literal(call.args[0]), {each.arg for each in call.keywords}
        named, own = fields(template or ""), called(call)
        if own == "wrong":
            filled = named - {"kind", "allowed"} == given and "allowed" in named
        elif template is None:  # an error may hand over what was said
            filled = where == "messages" or own != "say" and not any(isinstance(each, GLUED) for each in call.args)
        else:
            filled = given - {None} <= named if None in given else given == named
        assert filled, f"{where}:{call.lineno}: {ast.unparse(call)}"
    for where, call in (*calls("ValueError"), *calls("Problem")):
        text = call.args[2] if len(call.args) > 2 else call.args[0]
        assert not where.startswith("spec.") or not isinstance(text, (*GLUED, ast.Constant)), f"{where}:{call.lineno}"


def fits(code: str, given: set[str | None]) -> bool:
    """True if the sentence of a code gets all values that it names, and no others."""
    named = fields(FINDINGS[code])
    return (None in given or named <= given) and given - ALWAYS <= named


def codes(code: ast.expr) -> set[str]:
    """Codes that the expression ``code`` may have; none if it is a variable."""
    if isinstance(code, ast.IfExp):
        return codes(code.body) | codes(code.orelse)
    return {text} if (text := literal(code)) else set()


def test_every_finding_has_a_sentence_and_gives_it_what_it_names():
    for where, call in calls("finding"):
        given = {each.arg for each in call.keywords}
        assert all(fits(code, given) for code in codes(call.args[0])), f"{where}:{call.lineno}"
    everything = (node for module in FILES if module != "findings" for node in nodes(module))
    strings = {node.value for node in everything if isinstance(node, ast.Constant)}
    assert set(FINDINGS) <= strings | {check.code for check in (*CHECKS, *RULES)}, "a sentence that nothing says"
    assert {check.code for check in CHECKS} <= set(FINDINGS)
    for sentence in FINDINGS.values():
        for _, _, wanted, _ in string.Formatter().parse(sentence):
            _, _, unit = (wanted or "").partition(" ")
            assert not unit or per_si(unit.removesuffix("…")), sentence


def test_rendering_knows_of_the_analyses_the_classes_of_their_results():
    """It lays out, and does not calculate."""
    for module in (module for module in FILES if module.startswith("render")):
        assert not [each for each in imported(module) if room(each) in ("equations", "engines", "cli")], module
        for node in (node for node in nodes(module) if isinstance(node, ast.ImportFrom) and node.level):
            path = resolve_name("." * node.level + (node.module or ""), package_of(module))
            for alias in node.names if path.startswith("afmcalc.analysis") else ():
                assert inspect.isclass(getattr(import_module(path), alias.name)), (module, alias.name)


def package_of(module: str) -> str:
    return f"afmcalc.{module}" if FILES[module].stem == "__init__" else f"afmcalc.{module}".rpartition(".")[0]
