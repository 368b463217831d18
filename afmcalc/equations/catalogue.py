"""Catalogue of the laws by name: arguments, result, formula, source and validity, from docstrings and terms."""

import inspect
import pkgutil
import re
from collections.abc import Callable, Iterator
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import Any, NamedTuple

from .terms import Term, term_in

_NO_EQUATIONS = ("arrays", "catalogue", "terms", "wiring")


class Equation(NamedTuple):
    """One law and its documentation."""

    name: str
    """``module.function``."""
    function: Callable[..., Any]
    summary: str
    """Text of its docstring before ``Source:``, the noun and the formula."""
    source: str
    """Text after ``Source:``."""
    validity: str
    """Text after ``Validity:``; may be empty."""
    arguments: dict[str, Term]
    result: Term

    @property
    def about(self) -> str:
        """Name of the result: the summary without its formula."""
        return re.split("[,:;]", self.summary)[0].rstrip(".")


@cache
def equations() -> dict[str, Equation]:
    """Return every law whose result is a number, by ``module.function``."""
    found = [equation_of(*law) for module in _modules() for law in _laws_of(module)]
    return {each.name: each for each in found if each.result.unit}


def _modules() -> Iterator[ModuleType]:
    package = __name__.rpartition(".")[0]
    for module in pkgutil.iter_modules(import_module(package).__path__):
        if module.name not in _NO_EQUATIONS:
            yield import_module(f"{package}.{module.name}")


def _laws_of(module: ModuleType) -> Iterator[tuple[str, Callable[..., Any]]]:
    """Yield quantity and law of each public function, including those in mappings of options."""
    parts = [vars(module), *(part for name, part in vars(module).items() if name.isupper() and isinstance(part, dict))]
    for part in parts:
        for name, law in part.items():
            if inspect.isfunction(law) and law.__module__ == module.__name__ and not name.startswith("_"):
                yield name, law


@cache
def equation_of(quantity: str, function: Callable[..., Any]) -> Equation:
    """Return the documentation of the function that calculates a quantity."""
    module, name = function.__module__.rpartition(".")[2], function.__name__.lstrip("_")
    summary, _, rest = " ".join((function.__doc__ or "").split()).partition(" Source: ")
    source, _, validity = rest.partition(" Validity: ")
    of = f"{module}.{name}"
    arguments = {one: term_in(of, one) for one in inspect.signature(function).parameters}
    return Equation(of, function, summary, source, validity, arguments, term_in(of, quantity))
