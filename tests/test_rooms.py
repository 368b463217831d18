"""The rooms of the package: imports go one way, those inside functions too."""

import ast
from functools import cache
from graphlib import CycleError, TopologicalSorter

import pytest
from sources import FILES, nodes

LINE = (
    *("laws", "equations", "ground", "variants", "spec", "engines"),
    *("drive", "papers", "analysis", "render", "web", "cli", "door"),
)
"""A room imports from itself and from rooms to its left."""

GROUND = {"errors", "findings", "messages", "progress", "result", "units"}
MAY_ONLY = {"equations": {"laws"}, "ground": set()}
"""Rooms that know less than what is left of them."""


@pytest.fixture(scope="module", autouse=True)
def _parsed():
    """Every module is parsed before the time of a test runs."""
    for module in FILES:
        nodes(module)


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
    """Modules that a module names in a string, to import them when they are asked for."""
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
    """Modules of its own folder that a module names for type checkers alone, as a base names its subclass."""
    home = module.rpartition(".")[0]
    blocks = [node for node in nodes(module) if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"]
    inside = {
        node.module
        for block in blocks
        for node in ast.walk(block)
        if isinstance(node, ast.ImportFrom) and node.level == 1
    }
    outside = {
        node.module
        for node in nodes(module)
        if isinstance(node, ast.ImportFrom) and node.level == 1 and not any(node in block.body for block in blocks)
    }
    return {f"{home}.{name}" for name in inside - outside}


def test_no_circle():
    try:
        TopologicalSorter({module: imported(module) - for_types(module) for module in FILES}).prepare()
    except CycleError as error:
        pytest.fail(" → ".join(error.args[1]))


def test_russian_needs_no_library():
    """What compiles a catalogue is for those who change it."""
    assert not [
        module
        for module in FILES
        for node in nodes(module)
        if isinstance(node, ast.Import | ast.ImportFrom) and "babel" in ast.unparse(node)
    ]
