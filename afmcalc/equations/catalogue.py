"""The laws by name, with what their arguments, terms and docstrings say."""

import inspect
import pkgutil
import re
from collections.abc import Callable, Iterator
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import Any, NamedTuple

from .terms import Term, read_terms, term_of

_NO_EQUATIONS = ("arrays", "catalogue", "terms", "wiring")


class Equation(NamedTuple):
    """One law, or one equation function."""

    name: str
    """``module.function``."""
    function: Callable[..., Any]
    summary: str
    """Summary: its docstring before ``Source:``."""
    source: str
    """Text after ``Source:`` there."""
    validity: str
    """Text after ``Validity:``."""
    arguments: dict[str, Term]
    result: Term

    @property
    def about(self) -> str:
        """Name of the result: the summary without its formula."""
        return re.split("[,:;]", self.summary)[0].rstrip(".")


@cache
def equations() -> dict[str, Equation]:
    """Return every law that gives a number, by ``module.function``."""
    found = [equation_of(*law) for module in _modules() for law in _laws_of(module)]
    return {each.name: each for each in found if each.result.unit}


def _modules() -> Iterator[ModuleType]:
    package = __name__.rpartition(".")[0]
    for module in pkgutil.iter_modules(import_module(package).__path__):
        if module.name not in _NO_EQUATIONS:
            yield import_module(f"{package}.{module.name}")


def _laws_of(module: ModuleType) -> Iterator[tuple[str, Callable[..., Any]]]:
    """Quantity and law of each function, those in mappings of options among them."""
    parts = [vars(module), *(part for name, part in vars(module).items() if name.isupper() and isinstance(part, dict))]
    for part in parts:
        for name, law in part.items():
            if inspect.isfunction(law) and law.__module__ == module.__name__ and not name.startswith("_"):
                yield name, law


@cache
def equation_of(quantity: str, function: Callable[..., Any]) -> Equation:
    """Return what there is to say of the function that gives a quantity."""
    module, name = function.__module__.rpartition(".")[2], function.__name__.lstrip("_")
    summary, _, rest = " ".join((function.__doc__ or "").split()).partition(" Source: ")
    source, _, validity = rest.partition(" Validity: ")
    own = _symbols(function.__module__)
    names = inspect.signature(function).parameters
    arguments = {one: own.get(f"{name}.{one}") or own.get(one) or term_of(one) for one in names}
    result = own.get(quantity) or term_of(quantity)
    return Equation(f"{module}.{name}", function, summary, source, validity, arguments, result)


@cache
def _symbols(module: str) -> dict[str, Term]:
    """Return the terms of a module's table ``SYMBOLS``: of ``name``, or of ``function.argument``, there alone."""
    return read_terms(getattr(import_module(module), "SYMBOLS", ""))
