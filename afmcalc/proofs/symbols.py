"""Symbols of the theory, positive reals, and what proofs do with them."""

from typing import Any

import sympy as sp


def positive(names: str) -> Any:
    """Return symbols of positive reals: one, or a tuple of several."""
    return sp.symbols(names, positive=True)


z, z1, z2, C, R, r, F, t, f, f1, f2 = positive("z z_1 z_2 C R r F t f f_1 f_2")
fmin, fcp, fmax, fset = positive("f_min f_cp f_max f_set")
f1min, f1max, f2min, f2max = positive("f_1min f_1max f_2min f_2max")
n, p, q, N = positive("n p q N")
beta, T_n, F1, F2 = positive("beta T_n F_1 F_2")
c1, c2, d, fk, x = positive("c_1 c_2 d f_k x")


def solved(equation: sp.Expr, unknown: sp.Symbol) -> sp.Expr:
    """Return the one solution of ``equation = 0``."""
    (solution,) = sp.solve(equation, unknown, simplify=False)
    return solution


def exact(expression: sp.Expr) -> sp.Expr:
    """Take the decimal numbers of an equation as fractions, its power 0.5 as a square root."""
    return sp.nsimplify(expression, rational=True)


def rooted(expression: sp.Expr) -> sp.Expr:
    """Draw the roots of perfect squares."""
    half = sp.Rational(1, 2)
    return expression.replace(lambda e: e.is_Pow and e.exp == half, lambda e: sp.sqrt(sp.factor(e.base)))
