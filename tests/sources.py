"""The package as its source has it, parsed once."""

import ast
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

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
    """All there is in it."""
    return tuple(ast.walk(tree(module)))


@cache
def _all_calls(module: str) -> tuple[ast.Call, ...]:
    return tuple(node for node in nodes(module) if isinstance(node, ast.Call))


def called(node: ast.Call) -> str:
    """Name of what is called."""
    return node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")


def calls(*names: str) -> Iterator[tuple[str, ast.Call]]:
    """Calls of functions of some names anywhere in the package, and the module of each."""
    for module in FILES:
        for node in _all_calls(module):
            if called(node) in names:
                yield module, node


DATA = Path(__file__).parent / "data"
TABLES = (tomllib.loads((DATA / f"{name}.toml").read_text(encoding="utf-8")) for name in ("refused", "read", "page"))
REFUSED, READ, SCRIPTS = TABLES
"""Inputs that are refused, and how it is said; inputs that are read; what is done in a page."""
