"""Rendering lays out, it does not calculate: of the analyses it knows the classes of their results."""

import ast
import inspect
from importlib import import_module
from pathlib import Path

import pytest

import afmcalc

ROOT = Path(afmcalc.__file__).parent
MODULES = sorted((ROOT / "render").rglob("*.py"))


def imported(path):
    """``(module, name)`` of all that a module imports from the package, wherever it stands in it."""
    here = ("afmcalc", *path.relative_to(ROOT).with_suffix("").parts)
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            base = ".".join(here[: -node.level]) if node.level else ""
            module = ".".join(filter(None, (base, node.module)))
            yield from ((module, alias.name) for alias in node.names)
        elif isinstance(node, ast.Import):
            yield from ((alias.name, None) for alias in node.names)


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(ROOT)))
def test_of_the_analyses_only_classes_are_imported(path):
    for module, name in imported(path):
        assert not module.startswith(("afmcalc.equations", "afmcalc.engines", "afmcalc.cli"))
        if module.startswith("afmcalc.analysis"):
            assert inspect.isclass(getattr(import_module(module), name)), f"{module}.{name} is no class"


def test_the_walk_sees_imports():
    found = {module for path in MODULES for module, _ in imported(path)}
    assert {"afmcalc.analysis.curves", "afmcalc.analysis.dossier", "afmcalc.result"} <= found
