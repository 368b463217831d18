"""The equations of this package by name, with what their docstrings say of arguments, results and sources."""

import inspect
import pkgutil
import re
from collections.abc import Callable
from functools import cache
from importlib import import_module
from typing import Any, NamedTuple


class Term(NamedTuple):
    """An argument or result of an equation."""

    symbol: str
    """Symbol of the papers, e.g. ``F_п``."""
    meaning: str
    unit: str
    """SI unit, ``1`` for a pure number."""


class Equation(NamedTuple):
    """One equation function, as its docstring describes it."""

    name: str
    """``module.function``."""
    function: Callable[..., Any]
    summary: str
    source: str
    arguments: dict[str, Term]
    result: Term


_TERM = re.compile(r"(?P<symbol>[^,;=\[]+?(?:,\w+)?)\s*(?:[,;=](?P<meaning>.*?))?\s*\[(?P<unit>[^\]]+)\]", re.DOTALL)


@cache
def equations() -> dict[str, Equation]:
    """Every public function of the package's modules, by ``module.function``."""
    package = __name__.rpartition(".")[0]
    found: dict[str, Equation] = {}
    for module in pkgutil.iter_modules(import_module(package).__path__):
        if module.name.startswith("_") or module.name in ("calls", "catalogue"):
            continue
        namespace = import_module(f"{package}.{module.name}")
        for name, function in inspect.getmembers(namespace, inspect.isfunction):
            if function.__module__ == namespace.__name__ and not name.startswith("_"):
                found[f"{module.name}.{name}"] = _described(f"{module.name}.{name}", function)
    return found


def _described(name: str, function: Callable[..., Any]) -> Equation:
    text = inspect.cleandoc(function.__doc__ or "")
    summary, _, rest = text.partition("\n")
    arguments = {}
    for parameter in inspect.signature(function).parameters:
        match = re.search(rf"^    {parameter}: (.*?\])[.;]", rest, re.MULTILINE | re.DOTALL)
        if match is None:
            raise ValueError(f"{name}: argument {parameter} is not described with a unit")
        arguments[parameter] = _term(match[1], f"{name}: {parameter}")
    returns = _section(rest, "Returns")
    return Equation(name, function, summary, _section(rest, "Source"), arguments, _term(returns, f"{name}: Returns"))


def _section(text: str, title: str) -> str:
    """Text of one section of a docstring, on one line."""
    match = re.search(rf"^{title}:(.*?)(?=^\S|\Z)", text, re.MULTILINE | re.DOTALL)
    if match is None:
        raise ValueError(f"no section {title}")
    return " ".join(match[1].split())


def _term(text: str, where: str) -> Term:
    match = _TERM.match(" ".join(text.split()))
    if match is None:
        raise ValueError(f"{where}: no symbol and unit in {text!r}")
    return Term(match["symbol"].strip(), (match["meaning"] or "").strip(), match["unit"])
