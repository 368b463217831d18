"""Symbols of the theory, positive reals."""

import sympy as sp

z, z1, z2, C, R, r, F, t, f, f1, f2 = sp.symbols("z z_1 z_2 C R r F t f f_1 f_2", positive=True)
fmin, fcp, fmax, fset = sp.symbols("f_min f_cp f_max f_set", positive=True)
f1min, f1max, f2min, f2max = sp.symbols("f_1min f_1max f_2min f_2max", positive=True)
n, p, q = sp.symbols("n p q", positive=True)
beta, T_n = sp.symbols("beta T_n", positive=True)
c1, c2, d, fk, x = sp.symbols("c_1 c_2 d f_k x", positive=True)
N = sp.Symbol("N", positive=True)


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
