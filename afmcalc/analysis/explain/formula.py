"""Formula of a law as a tree, read from the source of its function: with symbols of its arguments, or with numbers."""

import ast
import inspect
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, NamedTuple

from ...formula_tree import TIMES, Node, Tree, bracketed, is_single, raised, symbol_tree, value_tree
from ...messages import localized, translate
from ...units import typeset

_FUNCTIONS = {"larger": "max", "smaller": "min", "sin": "sin", "cos": "cos", "tan": "tan", "atan": "arctan"}
"""Function of ``equations.arrays`` → its name in a formula."""


@cache
def _returned(function: Callable[..., Any]) -> ast.expr:
    """Expression that a law returns, its local variables replaced by the expressions assigned to them.

    Raises TypeError if the function has other statements than assignments and a return.
    """
    named: dict[str, ast.expr] = {}

    class PutIn(ast.NodeTransformer):
        def visit_Name(self, node: ast.Name) -> ast.expr:  # noqa: N802
            return named.get(node.id, node)

    (law,) = ast.parse(inspect.getsource(function)).body
    for line in law.body[1:] if isinstance(law, ast.FunctionDef) else ():
        match PutIn().visit(line):
            case ast.Assign([ast.Name(name)], value):
                named[name] = value
            case ast.Assign([ast.Tuple(names)], ast.Tuple(values)):
                named |= zip(map(ast.unparse, names), values, strict=True)
            case ast.Return(ast.expr() as value):
                return value
            case _:
                break
    raise TypeError(f"{function.__name__} is no formula")


def _terms(node: ast.expr) -> list[tuple[bool, ast.expr]]:
    """Terms of a sum, each after a flag that is True if the term is subtracted."""
    match node:
        case ast.BinOp(left, ast.Add(), right):
            return [*_terms(left), *_terms(right)]
        case ast.BinOp(left, ast.Sub(), right):
            return [*_terms(left), (True, right)]
    return [(False, node)]


class _Product(NamedTuple):
    """Factors in the numerator and in the denominator of a product; a product without factors is 1."""

    negative: bool
    over: list[ast.expr]
    under: list[ast.expr]


def _product(node: ast.expr) -> _Product:
    match node:
        case ast.BinOp(left, ast.Mult(), right):
            one, two = _product(left), _product(right)
            return _Product(one.negative != two.negative, one.over + two.over, one.under + two.under)
        case ast.BinOp(left, ast.Div(), right) | ast.Call(ast.Name("quotient"), [left, right]):
            one, two = _product(left), _product(right)
            if two.under:  # a quotient in a denominator stays a quotient
                return one._replace(under=[*one.under, right])
            return _Product(one.negative != two.negative, one.over, one.under + two.over)
        case ast.UnaryOp(ast.USub(), operand):
            return (one := _product(operand))._replace(negative=not one.negative)
        case ast.Constant(1):
            return _Product(False, [], [])
    return _Product(False, [node], [])


class _Writer(NamedTuple):
    """Writer of expressions as trees: ``names`` has the tree of each argument, ``values`` the number of each."""

    names: Mapping[str, Tree]
    values: Mapping[str, Any]
    dots: bool
    """True if factors are joined by dots, as numbers are."""
    line: bool
    """True if quotients are written in one line, not as fractions."""

    def tree(self, node: ast.expr) -> Tree:
        """Tree of an expression; a subtracted sum keeps its brackets."""
        tree: Tree = ()
        for taken_off, term in _terms(node):
            product = _product(term)
            negative, own = product.negative != taken_off, self._quotient(product)
            is_sum = not product.under and [*map(_is_sum, product.over)] == [True]
            sign = ("−",) if negative else ("+",) if tree else ()
            tree += (*sign, *(bracketed(own) if is_sum and negative else own))
        return tree

    def _quotient(self, product: _Product) -> Tree:
        above, below = self._factors(product.over) or (Node("number", "1"),), self._factors(product.under)
        if not below:
            return above
        if not self.line:
            return (Node("fraction", parts=(above, below)),)
        if [*map(_is_sum, product.over)] == [True]:
            above = bracketed(above)
        # brackets keep a number and its unit together in the denominator
        return (*above, "/", *(below if is_single(below) else bracketed(below)))

    def _factors(self, factors: list[ast.expr]) -> Tree:
        tree: Tree = ()
        for factor in factors:
            own = bracketed(self.tree(factor)) if _is_sum(factor) and len(factors) > 1 else self._factor(factor)
            digits = tree and all(isinstance(each, Node) and each.kind == "number" for each in (tree[-1], own[0]))
            tree += ("·" if digits or self.dots else TIMES, *own) if tree else own
        return tree

    def _factor(self, node: ast.expr) -> Tree:
        match node:
            case ast.Name(name):
                return self.names[name]
            case ast.Constant(int() | float() as value):
                return value_tree(localized(f"{value:g}"))
            case ast.Attribute(attr="pi"):
                return ("π",)
            case ast.BinOp(base, ast.Pow(), ast.Constant(0.5)):
                return (Node("root", parts=(self.tree(base),)),)
            case ast.BinOp(base, ast.Pow(), exponent):
                own = self.tree(base)
                return raised(own if is_single(own) else bracketed(own), self.tree(exponent))
            case ast.BinOp():
                return self.tree(node)
            case ast.Call(ast.Name("chosen"), [ast.Compare(ast.Name(name)), ast.Lambda(body=yes), ast.Lambda(body=no)]):
                return self.tree(yes if self.values[name] > 0 else no)
            case ast.Call(ast.Name(name), arguments) if name in _FUNCTIONS:
                shown = [sign for one in arguments for sign in (",", *self.tree(one))][1:]
                return (Node("function", translate(_FUNCTIONS[name], "symbol")), *bracketed(tuple(shown)))
        raise TypeError(f"{ast.unparse(node)} is no formula")


def _is_sum(node: ast.expr) -> bool:
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub)


class FormulaText:
    """Formula of a law with symbols, and with numbers that keep their units."""

    def __init__(
        self, function: Callable[..., Any], terms: Mapping[str, tuple[str, str]], values: Mapping[str, Any]
    ) -> None:
        """Read ``function``; for each argument, ``terms`` has the symbol and SI unit, ``values`` the number.

        Raises TypeError if the law is no formula.
        """
        self._formula, self._terms, self._values = _returned(function), terms, values
        symbols = {name: symbol_tree(symbol) for name, (symbol, _) in terms.items()}
        self.tree = _Writer(symbols, values, dots=False, line=False).tree(self._formula)

    def with_numbers(self, *, units: bool = True, line: bool = False) -> Tree:
        """Return the formula with numbers in place of symbols; ``units`` adds units, ``line`` sets it in one line."""
        trees = {}
        for name, (_, unit) in self._terms.items():
            value, shown = self._values[name], translate(typeset(unit), "unit") if units and unit != "1" else ""
            tree = value_tree(f"{localized(f'{value:.5g}')} {shown}")
            trees[name] = bracketed(tree) if value < 0 else tree
        return _Writer(trees, self._values, dots=True, line=line).tree(self._formula)
