"""Rendering lays out, it does not calculate: of the analyses it knows the classes of their results."""

import ast
import inspect
from importlib import import_module
from pathlib import Path

import afmcalc

ROOT = Path(afmcalc.__file__).parent


def test_of_the_analyses_only_classes_are_imported():
    seen = set()
    for path in sorted((ROOT / "render").rglob("*.py")):
        here = ("afmcalc", *path.relative_to(ROOT).with_suffix("").parts)
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.ImportFrom):
                assert not isinstance(node, ast.Import) or not any("afmcalc" in alias.name for alias in node.names)
                continue
            module = ".".join(filter(None, (*(here[: -node.level] if node.level else ()), node.module)))
            assert not module.startswith(("afmcalc.equations", "afmcalc.engines", "afmcalc.cli")), path
            if module.startswith("afmcalc.analysis"):
                seen.add(module)
                for alias in node.names:
                    assert inspect.isclass(getattr(import_module(module), alias.name)), (path, alias.name)
    assert {"afmcalc.analysis.curves", "afmcalc.analysis.dossier"} <= seen
