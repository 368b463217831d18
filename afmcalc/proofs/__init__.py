"""Proofs: the equation functions themselves, run on SymPy symbols, against independent derivations.

A proof yields identities (expressions that must vanish for all arguments) and refutations (printed forms
that must not). SymPy is needed (extra ``explain``); it is imported only when a proof is.
"""

from collections.abc import Callable, Iterator
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from sympy import Expr

MODULES = (
    "direct", "adjustment", "indirect", "pocket", "overload", "parts", "wall", "inverse", "motion", "heat", "springs",
    "numbers",
)  # fmt: skip


class Identity(NamedTuple):
    """An expression that vanishes for all arguments."""

    statement: str
    expression: "Expr | int"


class Refutation(NamedTuple):
    """A printed form's difference from the right one: it must not vanish."""

    statement: str
    expression: "Expr | int"


Steps = Iterator[Identity | Refutation]


class ProofError(AssertionError):
    """A proof does not hold."""


@cache
def proofs() -> dict[str, Callable[[], Steps]]:
    """Every proof by name: the public functions of the modules of this package."""
    found: dict[str, Callable[[], Steps]] = {}
    for name in MODULES:
        module = import_module(f".{name}", __name__)
        found |= {key: getattr(module, key) for key in module.__all__}
    return found


def prove(name: str) -> list[str]:
    """Run a proof and return what it has shown.

    Raises:
        ProofError: an identity does not vanish, or a refuted form does.
    """
    shown = []
    for step in proofs()[name]():
        vanishes = is_zero(step.expression)
        if vanishes != isinstance(step, Identity):
            raise ProofError(f"{name}: {step.statement}: {step.expression}")
        shown.append(step.statement)
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
