"""Syntax trees of the package, each parsed once, and tables of test inputs."""

import ast
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import afmcalc

PACKAGE = Path(afmcalc.__file__).parent
FILES = {
    ".".join(parts[:-1] if parts[-1] == "__init__" else parts): file
    for file in sorted(PACKAGE.rglob("*.py"))
    for parts in [file.relative_to(PACKAGE).with_suffix("").parts]
}
"""Files by the name of their module, without that of the package."""


@cache
def tree(module: str) -> ast.Module:
    """Syntax tree of a module."""
    return ast.parse(FILES[module].read_text(encoding="utf-8"))


@cache
def nodes(module: str) -> tuple[ast.AST, ...]:
    """All nodes of the syntax tree of a module."""
    return tuple(ast.walk(tree(module)))


@cache
def _all_calls(module: str) -> tuple[ast.Call, ...]:
    return tuple(node for node in nodes(module) if isinstance(node, ast.Call))


def called(node: ast.Call) -> str:
    """Name of the function that a call calls."""
    return node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")


def calls(*names: str) -> Iterator[tuple[str, ast.Call]]:
    """Calls of functions of some names anywhere in the package, and the module of each."""
    for module in FILES:
        for node in _all_calls(module):
            if called(node) in names:
                yield module, node


DATA = Path(__file__).parent / "data"


def table(name: str) -> dict[str, Any]:
    """A table of data/."""
    return tomllib.loads((DATA / f"{name}.toml").read_text(encoding="utf-8"))


REFUSED, READ, SCRIPTS, CLUTCHES = map(table, ("refused", "read", "page", "clutches"))
"""Inputs that are refused, with their messages; inputs that are read; actions in a page; specs and parts of them."""
