"""Symbols of the theory, positive reals, and what proofs do with them.

A proof is a generator function of a test module here: the equation functions themselves, run on SymPy symbols, against
an independent derivation. It yields statements, each with an expression that must vanish for all arguments, and
refutations: forms that papers print and that differ from the right ones.
"""

from importlib import import_module
from inspect import isgeneratorfunction
from pathlib import Path
from types import FunctionType, SimpleNamespace
from typing import NamedTuple

import sympy as sp

from afmcalc.equations import indirect as _indirect


def symbolic(law, pi=sp.pi):
    """Return a law with an exact π, and without the bound of a force that no symbol can be compared with."""
    exact = {
        "math": SimpleNamespace(pi=pi), "sin": sp.sin, "cos": sp.cos, "smaller": lambda bound, value: value,
        "larger": lambda value, bound: value,
    }  # fmt: skip
    return FunctionType(law.__code__, law.__globals__ | exact)


def accuracy_as_set(low, at_set, high, c1, c2, pairs, net):
    """S21 (15) of the frictions."""
    stiffness = [_indirect.sleeve_stiffness(c1, c2, pairs, friction, net) for friction in (at_set, high)]
    return _indirect._accuracy_factor_as_set(low, high, *stiffness, pairs, net, at_set)


class Refutation(NamedTuple):
    """A printed form's difference from the right one: it must not vanish."""

    statement: str
    expression: sp.Expr


def is_proof(name, function):
    """True if a member of a module is a proof."""
    return isgeneratorfunction(function) and not name.startswith("_")


def proofs():
    """Return every proof by the name that pytest calls it by."""
    found = {}
    for file in sorted(Path(__file__).parent.glob("test_*.py")):
        members = vars(import_module(f"proofs.{file.stem}"))
        found |= {f"tests/proofs/{file.name}::{name}": each for name, each in members.items() if is_proof(name, each)}
    return found


def prove(proof):
    """Assert that every identity of a proof vanishes, and that no refuted form does."""
    shown = 0
    for step in proof():
        statement, expression = step
        assert is_zero(expression) != isinstance(step, Refutation), f"{statement}: {expression}"
        shown += 1
    assert shown


def is_zero(expression):
    """True if an expression vanishes identically."""
    expression = sp.sympify(expression)
    if sp.numer(sp.together(expression)).expand() == 0:
        return True
    if expression.is_rational_function(*expression.free_symbols):
        return False  # of a rational function the expanded numerator decides
    return bool(sp.simplify(expression) == 0)


def positive(names):
    """Return symbols of positive reals: one, or a tuple of several."""
    return sp.symbols(names, positive=True)


z, z1, z2, C, R, r, F, t, f, f1, f2 = positive("z z_1 z_2 C R r F t f f_1 f_2")
fmin, fcp, fmax, fset = positive("f_min f_cp f_max f_set")
f1min, f1max, f2min, f2max = positive("f_1min f_1max f_2min f_2max")
n, p, q, N = positive("n p q N")
beta, T_n, F1, F2 = positive("beta T_n F_1 F_2")
c1, c2, d, fk, x = positive("c_1 c_2 d f_k x")


def solved(equation, unknown):
    """Return the one solution of ``equation = 0``."""
    (solution,) = sp.solve(equation, unknown, simplify=False)
    return solution


def exact(expression):
    """Take the decimal numbers of an equation as fractions, its power 0.5 as a square root."""
    return sp.nsimplify(expression, rational=True)


def rooted(expression):
    """Draw the roots of perfect squares."""
    half = sp.Rational(1, 2)
    return expression.replace(lambda e: e.is_Pow and e.exp == half, lambda e: sp.sqrt(sp.factor(e.base)))
