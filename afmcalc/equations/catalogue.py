"""The laws and equations by name, with what their arguments, terms and docstrings say."""

import inspect
import pkgutil
import re
from collections.abc import Callable, Iterator
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import Any, NamedTuple, get_type_hints

from ..laws.terms import term_of
from .terms import Term

_NO_EQUATIONS = ("arrays", "catalogue", "terms", "wiring")
_AS_LAWS = ("accuracy", "adjustment", "direct", "indirect", "life", "machine", "overload", "pocket", "wall")
"""Modules of equations that the laws replace; of ``synthesis`` all but the inverse laws."""

_INVERSE = re.compile("_for_(?!control_force)|net_loop_gain")


class Equation(NamedTuple):
    """One law, or one equation function."""

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
    """Every law that gives a number, and every public function of the equations, by ``module.function``."""
    found = [equation_of(*law) for module in _modules("laws") for law in _laws_of(module)]
    for module in _modules("equations"):
        if module.__name__.rpartition(".")[2] not in _AS_LAWS:
            functions = inspect.getmembers(module, inspect.isfunction)
            found += [equation_of(*each) for each in functions if each[1].__module__ == module.__name__]
    found = [each for each in found if not each.name.startswith("synthesis.") or _INVERSE.search(each.name)]
    return {each.name: each for each in found if each.result.unit}


def _modules(package: str) -> Iterator[ModuleType]:
    home = f"{__name__.split('.', maxsplit=1)[0]}.{package}"
    for module in pkgutil.iter_modules(import_module(home).__path__):
        if module.name not in _NO_EQUATIONS:
            yield import_module(f"{home}.{module.name}")


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
    summary, _, rest = (inspect.getdoc(function) or "").partition("\n")
    source, _, validity = (part.partition("\n\n")[0] for part in rest.partition("Source:")[2].partition("Validity:"))
    hints = get_type_hints(function, include_extras=True)
    if hints:
        terms = {key: Term(*hint.__metadata__) for key, hint in hints.items()}
    else:
        names = {one: one for one in inspect.signature(function).parameters} | {"return": quantity}
        terms = {key: Term(*term_of(one)) for key, one in names.items()}
    result = terms.pop("return")
    texts = summary, " ".join(source.split()), " ".join(validity.split())
    return Equation(f"{module}.{name}", function, *texts, terms, result)
