"""Proofs: the equation functions themselves, run on SymPy symbols, against independent derivations.

A proof yields statements, each with an expression that must vanish for all arguments, and refutations: forms that
papers print and that differ from the right ones. SymPy is needed (extra ``explain``); only a proof imports it.
"""

from collections.abc import Callable, Iterator
from functools import cache
from importlib import import_module
from inspect import getmembers, isfunction
from pkgutil import iter_modules
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from sympy import Expr

MODULES = [module.name for module in iter_modules(__path__) if module.name != "symbols"]


class Refutation(NamedTuple):
    """A printed form's difference from the right one: it must not vanish."""

    statement: str
    expression: "Expr | int"


Steps = Iterator[tuple[str, "Expr | int"]]


class ProofError(AssertionError):
    """A proof does not hold."""


@cache
def proofs() -> dict[str, Callable[[], Steps]]:
    """Every proof by name: the public functions of the modules of this package."""
    found: dict[str, Callable[[], Steps]] = {}
    for name in MODULES:
        module = import_module(f".{name}", __name__)
        functions = [(key, function) for key, function in getmembers(module, isfunction) if not key.startswith("_")]
        found |= {key: function for key, function in functions if function.__module__ == module.__name__}
    return found


def prove(name: str) -> list[str]:
    """Run a proof and return what it has shown.

    Raises:
        ProofError: an identity does not vanish, or a refuted form does.
    """
    shown = []
    for step in proofs()[name]():
        statement, expression = step
        if is_zero(expression) == isinstance(step, Refutation):
            raise ProofError(f"{name}: {statement}: {expression}")
        shown.append(statement)
    return shown


def is_zero(expression: "Expr | int") -> bool:
    """Whether an expression vanishes identically."""
    import sympy

    expression = sympy.sympify(expression)
    if sympy.numer(sympy.together(expression)).expand() == 0:
        return True
    if expression.is_rational_function(*expression.free_symbols):
        return False  # of a rational function the expanded numerator decides
    return bool(sympy.simplify(expression) == 0)
