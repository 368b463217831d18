"""The equations of this package by name, with what their signatures and docstrings say."""

import inspect
import pkgutil
import re
from collections.abc import Callable
from functools import cache
from importlib import import_module
from typing import Any, NamedTuple, get_type_hints

from .terms import Term

_NO_EQUATIONS = ("arrays", "calls", "catalogue", "terms")


class Equation(NamedTuple):
    """One equation function."""

    name: str
    """``module.function``."""
    function: Callable[..., Any]
    summary: str
    """First line of its docstring."""
    source: str
    """What follows ``Source:`` there."""
    validity: str
    """What follows ``Validity:``."""
    arguments: dict[str, Term]
    result: Term

    @property
    def about(self) -> str:
        """What is calculated: the summary without its formula."""
        return re.split("[,:;]", self.summary)[0].rstrip(".")


@cache
def equations() -> dict[str, Equation]:
    """Every public function of the package's modules, by ``module.function``."""
    package = __name__.rpartition(".")[0]
    found: dict[str, Equation] = {}
    for module in pkgutil.iter_modules(import_module(package).__path__):
        if module.name not in _NO_EQUATIONS:
            namespace = import_module(f"{package}.{module.name}")
            for name, function in inspect.getmembers(namespace, inspect.isfunction):
                if function.__module__ == namespace.__name__:
                    found[f"{module.name}.{name}"] = _equation(f"{module.name}.{name}", function)
    return found


def _equation(name: str, function: Callable[..., Any]) -> Equation:
    summary, _, rest = (inspect.getdoc(function) or "").partition("\n")
    source, _, validity = (part.partition("\n\n")[0] for part in rest.partition("Source:")[2].partition("Validity:"))
    terms = {key: Term(*hint.__metadata__) for key, hint in get_type_hints(function, include_extras=True).items()}
    result = terms.pop("return")
    return Equation(name, function, summary, " ".join(source.split()), " ".join(validity.split()), terms, result)
