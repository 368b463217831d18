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
from sympy.polys.rings import ring

from afmcalc.equations import indirect as _indirect


def symbolic(law, pi=sp.pi):
    """Return a law with an exact π, and without bounds of a force, as a symbol cannot be compared with a bound."""
    exact = {
        "math": SimpleNamespace(pi=pi), "sin": sp.sin, "cos": sp.cos, "smaller": lambda bound, value: value,
        "larger": lambda value, bound: value, "chosen": lambda condition, yes, no: yes(),
    }  # fmt: skip
    return FunctionType(law.__code__, law.__globals__ | exact)


def accuracy_as_set(low, at_set, high, c1, c2, pairs, net):
    """Accuracy factor by S21 (15) at the given frictions."""
    stiffness = [_indirect.sleeve_stiffness(c1, c2, pairs, friction, net) for friction in (at_set, high)]
    return _indirect._accuracy_factor_as_set(low, high, *stiffness, pairs, net, at_set)


class Refutation(NamedTuple):
    """Difference between the printed form of a law and the right one, which must not vanish."""

    statement: str
    expression: sp.Expr


def is_proof(name, function):
    """True if a member of a module is a proof."""
    return isgeneratorfunction(function) and not name.startswith("_")


def proofs():
    """Return name of each proof, as pytest knows it → proof."""
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
    letters = sorted(_letters(expression), key=str)
    polynomials = ring([f"a{place}" for place in range(len(letters) + 1)], sp.QQ)[1:]
    top, bottom = _fraction(expression, dict(zip(letters, polynomials[1:], strict=True)), polynomials[0] ** 0)
    if top == 0:
        return bottom != 0
    if all(letter.is_Symbol or letter is sp.pi for letter in letters):
        return False  # symbols and π are independent of each other
    return bool(sp.simplify(expression) == 0)


def _letters(expression):
    """Return the parts that a rational function is made of: symbols, and subexpressions that are not rational."""
    if expression.is_Add or expression.is_Mul:
        return set().union(*map(_letters, expression.args))
    if expression.is_Pow and expression.exp.is_Integer:
        return _letters(expression.base)
    return set() if expression.is_Rational else {expression}


def _fraction(expression, polynomial_of, one):
    """Return numerator and denominator as polynomials, not reduced, as this takes longer than all the rest."""
    if expression.is_Rational:
        return expression.p * one, expression.q * one
    if expression.is_Add or expression.is_Mul:
        top, bottom = 0 * one if expression.is_Add else one, one
        for part in expression.args:
            over, under = _fraction(part, polynomial_of, one)
            if expression.is_Mul:
                top, bottom = top * over, bottom * under
            elif under == bottom:
                top = top + over
            else:
                top, bottom = top * under + over * bottom, bottom * under
        return top, bottom
    if expression.is_Pow and expression.exp.is_Integer:
        top, bottom = (each ** abs(expression.exp.p) for each in _fraction(expression.base, polynomial_of, one))
        return (top, bottom) if expression.exp > 0 else (bottom, top)
    return polynomial_of[expression], one


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
    """Return an equation with its decimal numbers as fractions, and a power 0.5 as a square root."""
    return sp.nsimplify(expression, rational=True)


def rooted(expression):
    """Return an expression in which the roots of perfect squares are taken."""
    half = sp.Rational(1, 2)
    return expression.replace(lambda e: e.is_Pow and e.exp == half, lambda e: sp.sqrt(sp.factor(e.base)))
