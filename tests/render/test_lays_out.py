"""Rendering lays out, it does not calculate: of the analyses it knows the classes of their results."""

import ast
import inspect
from importlib import import_module
from importlib.util import resolve_name
from pathlib import Path

import afmcalc

ROOT = Path(afmcalc.__file__).parent


def test_of_the_analyses_only_classes_are_imported():
    for path in (ROOT / "render").rglob("*.py"):
        package = ".".join(("afmcalc", *path.relative_to(ROOT).parts[:-1]))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.level:
                module = resolve_name("." * node.level + (node.module or ""), package)
                assert not module.startswith(("afmcalc.equations", "afmcalc.engines", "afmcalc.cli")), path
                for alias in node.names if module.startswith("afmcalc.analysis") else ():
                    assert inspect.isclass(getattr(import_module(module), alias.name)), (path, alias.name)
