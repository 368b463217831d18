"""The formula of a law, as text and as a tree, from running it on terms that keep what is done to them."""

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple, TypeAlias

from ...formula_tree import TIMES, Node, Tree, bracketed, is_single, raised, symbol_tree, text, value_tree
from ...messages import localized, translate
from ...units import typeset

Factor: TypeAlias = "Tree | Expression"
"""An atom or a quotient as a tree, or a sum."""


class Style(NamedTuple):
    """How products and quotients are written."""

    dots: bool = False
    """True if a dot stands between factors, as between numbers."""
    line: bool = False
    """True if quotients are in one line, not fractions."""


_OF_SYMBOLS = Style()


class Product(NamedTuple):
    """A product; without factors it is 1."""

    negative: bool = False
    over: tuple[Factor, ...] = ()
    under: tuple[Factor, ...] = ()


@dataclass(frozen=True)
class Expression:
    """A sum of products, kept as it was written; arithmetic on it gives another."""

    terms: tuple[Product, ...] = (Product(),)
    style: Style | None = None
    """None of a number of the law itself."""
    value: float = math.nan
    """Value that it stands for: a law may ask whether there is one."""

    def __gt__(self, other: float) -> bool:
        """Compare what it stands for; what is calculated from it stands for no value."""
        if math.isnan(self.value):
            raise TypeError("a law that compares results is no formula")
        return self.value > other

    def __add__(self, other: "Expression | float") -> "Expression":
        """Join sums."""
        return self._with((*self.terms, *_term(other).terms), other)

    def __sub__(self, other: "Expression | float") -> "Expression":
        """Take off; a sum that is taken off stays in brackets."""
        return self + -_term(other)

    def __mul__(self, other: "Expression | float") -> "Expression":
        """Join products and quotients."""
        one, two = _product(self), _product(_term(other))
        return self._joined(Product(one.negative != two.negative, one.over + two.over, one.under + two.under), other)

    def __truediv__(self, other: "Expression | float") -> "Expression":
        """Put below the line; a quotient stays one."""
        one, two = _product(self), _product(_term(other))
        below = (self._with((two._replace(negative=False),), other).tree(),) if two.under else two.over
        return self._joined(Product(one.negative != two.negative, one.over, one.under + below), other)

    def __pow__(self, exponent: "Expression | float") -> "Expression":
        """Raise; a third stays a fraction, which has no last decimal."""
        base = self.tree()
        if exponent == 0.5:
            return self._atom((Node("root", parts=(base,)),))
        power = Expression() / 3 if exponent == 1 / 3 else _term(exponent)
        return self._atom(raised(base if is_single(base) else bracketed(base), power.tree()))

    def __neg__(self) -> "Expression":
        """Change the sign."""
        own = _product(self)
        return self._joined(own._replace(negative=not own.negative), 1.0)

    def called(self, name: str, *values: "Expression | float") -> "Expression":
        """Keep a function that is no arithmetic, as ``equations.arrays`` calls it."""
        shown = [sign for one in values for sign in (",", *_term(one).tree())][1:]
        function = Node("function", translate(name.replace("atan", "arctan"), "symbol"))
        return self._atom((function, *bracketed(tuple(shown))))

    def __radd__(self, other: float) -> "Expression":
        """Join sums."""
        return _term(other) + self

    def __rsub__(self, other: float) -> "Expression":
        """Take off."""
        return _term(other) - self

    def __rmul__(self, other: float) -> "Expression":
        """Join products."""
        return _term(other) * self

    def __rtruediv__(self, other: float) -> "Expression":
        """Put below the line."""
        return _term(other) / self

    def _with(self, terms: tuple[Product, ...], other: "Expression | float") -> "Expression":
        return Expression(terms, self.style or _term(other).style)

    def _atom(self, tree: Tree) -> "Expression":
        return Expression((Product(over=(tree,)),), self.style)

    def _joined(self, product: Product, other: "Expression | float") -> "Expression":
        match product:
            case Product(False, (Expression() as only,), ()):
                return only
        return self._with((product,), other)

    def tree(self) -> Tree:
        """Return it as a tree."""
        tree: Tree = ()
        for term in self.terms:
            own = self._quotient(term)
            is_sum = not term.under and len(term.over) == 1 and isinstance(term.over[0], Expression)
            sign = ("−",) if term.negative else ("+",) if tree else ()
            tree += (*sign, *(bracketed(own) if is_sum else own))
        return tree

    def _quotient(self, term: Product) -> Tree:
        above, below = self._factors(term.over) or (Node("number", "1"),), self._factors(term.under)
        if not below:
            return above
        if not (self.style and self.style.line):
            return (Node("fraction", parts=(above, below)),)
        if len(term.over) == 1 and isinstance(term.over[0], Expression):
            above = bracketed(above)
        # a number with its unit is divided by as a whole
        return (*above, "/", *(below if is_single(below) else bracketed(below)))

    def _factors(self, factors: tuple[Factor, ...]) -> Tree:
        tree: Tree = ()
        for factor in factors:
            own = replace(factor, style=self.style).tree() if isinstance(factor, Expression) else factor
            own = bracketed(own) if isinstance(factor, Expression) and len(factors) > 1 else own
            digits = tree and all(isinstance(each, Node) and each.kind == "number" for each in (tree[-1], own[0]))
            dot = digits or (self.style and self.style.dots)
            tree += ("·" if dot else TIMES, *own) if tree else own
        return tree


def _term(value: Expression | float) -> Expression:
    if isinstance(value, Expression):
        return value
    size = abs(value)
    own: Iterable[Factor] = [] if size == 1 else [("π",) if size == math.pi else value_tree(localized(f"{size:g}"))]
    return Expression((Product(value < 0, (*own,)),))


def _product(term: Expression) -> Product:
    return term.terms[0] if len(term.terms) == 1 else Product(over=(term,))


def leaf(tree: Tree, value: float = math.nan, style: Style = _OF_SYMBOLS) -> Expression:
    """Return a symbol, or a number put in, that stands for a value."""
    return Expression((Product(over=(tree,)),), style, value)


class FormulaText:
    """An equation function called on symbols, and on numbers that keep their units, unevaluated."""

    def __init__(
        self,
        function: Callable[..., Any],
        terms: Mapping[str, tuple[str, str]],
        values: Mapping[str, Any],
    ) -> None:
        """Run ``function`` on its arguments: name → symbol and SI unit, name → value."""
        self._function, self._values = function, {name: values[name] for name in terms}
        self._units = {name: unit for name, (_, unit) in terms.items()}
        self._tree = self._run({name: symbol_tree(symbol) for name, (symbol, _) in terms.items()}, _OF_SYMBOLS)

    def _run(self, trees: Mapping[str, Tree], style: Style) -> Tree:
        leaves = {name: leaf(tree, self._values[name], style) for name, tree in trees.items()}
        return _term(self._function(**leaves)).tree()

    def text(self) -> str:
        """Return the formula on one line, Unicode."""
        return text(self._tree)

    def text_with_numbers(self) -> str:
        """Return the formula with numbers and units put in, Unicode."""
        return text(self.tree_with_numbers())

    def tree(self) -> Tree:
        """Return the formula as a tree."""
        return self._tree

    def tree_with_numbers(self, *, units: bool = True, line: bool = False) -> Tree:
        """Return the formula with numbers as a tree, with their units, in one line if so wanted."""
        trees = {}
        for name, value in self._values.items():
            unit = translate(typeset(self._units[name]), "unit") if units and self._units[name] != "1" else ""
            shown = value_tree(f"{localized(f'{value:.5g}')} {unit}")
            trees[name] = bracketed(shown) if value < 0 else shown
        return self._run(trees, Style(True, line))
