"""The formula of a law, as text and as a tree, from running it on terms that keep what is done to them."""

import math
import operator
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from ...formula_tree import TIMES, Node, Tree, bracketed, is_single, raised, symbol_tree, text, value_tree
from ...messages import localized, translate
from ...units import typeset


def _reflected(
    operation: "Callable[[Expression, Expression], Expression]",
) -> "Callable[[Expression, float], Expression]":
    return lambda own, other: operation(_term(other), own)


class Expression:
    """An expression, kept as it was written; arithmetic on it gives another."""

    def __add__(self, other: "Expression | float") -> "Expression":
        """Join sums."""
        return Sum((*_summands(self), *_summands(_term(other))))

    def __sub__(self, other: "Expression | float") -> "Expression":
        """Take off; a sum that is taken off stays in brackets."""
        return Sum((*_summands(self), _negated(_term(other))))

    def __mul__(self, other: "Expression | float") -> "Expression":
        """Join products and quotients."""
        one, two = _product(self), _product(_term(other))
        return _joined(one.negative != two.negative, (*one.over, *two.over), (*one.under, *two.under))

    def __truediv__(self, other: "Expression | float") -> "Expression":
        """Put below the line; a quotient stays one."""
        one, two = _product(self), _product(_term(other))
        below = (two,) if two.under else two.over
        return _joined(one.negative != two.negative, one.over, (*one.under, *below))

    def __pow__(self, exponent: "Expression | float") -> "Expression":
        """Raise; a third stays a fraction, which has no last decimal."""
        return Power(self, _ONE / 3 if exponent == 1 / 3 else _term(exponent))

    def __neg__(self) -> "Expression":
        """Change the sign."""
        return _negated(self)

    @staticmethod
    def called(name: str, *values: "Expression | float") -> "Expression":
        """Keep a function that is no arithmetic, as ``equations.arrays`` calls it."""
        return Called(name, tuple(map(_term, values)))

    __radd__, __rsub__ = _reflected(operator.add), _reflected(operator.sub)
    __rmul__, __rtruediv__ = _reflected(operator.mul), _reflected(operator.truediv)


@dataclass(frozen=True)
class Leaf(Expression):
    """A symbol, or a number."""

    text: str
    own: bool = False
    """True if it is a number of the equation itself."""
    value: float = field(default=math.nan, compare=False)
    """Value that it stands for: a law may ask whether there is one."""
    unit: str | None = None
    """SI unit of a number that is put in."""

    def __gt__(self, other: float) -> bool:
        """Compare what it stands for."""
        return self.value > other


@dataclass(frozen=True)
class Power(Expression):
    """A power."""

    base: Expression
    exponent: Expression


@dataclass(frozen=True)
class Product(Expression):
    """A product, the factors it is divided by apart."""

    negative: bool
    over: tuple[Expression, ...]
    under: tuple[Expression, ...] = ()


@dataclass(frozen=True)
class Sum(Expression):
    """A sum of two terms or more; those taken off are negative products."""

    terms: tuple[Expression, ...]


@dataclass(frozen=True)
class Called(Expression):
    """A function of expressions: max, sin, …"""

    name: str
    arguments: tuple[Expression, ...]


_ONE, _PI = Leaf("1", own=True), Leaf("π", own=True)


def _term(value: Expression | float) -> Expression:
    if isinstance(value, Expression):
        return value
    own = _PI if abs(value) == math.pi else Leaf(f"{abs(value):g}", own=True)
    return _negated(own) if value < 0 else own


def _product(term: Expression) -> Product:
    return term if isinstance(term, Product) else Product(False, (term,))


def _joined(negative: bool, over: Iterable[Expression], under: tuple[Expression, ...]) -> Expression:
    above = tuple(factor for factor in over if factor != _ONE)
    if not negative and not under and len(above) == 1:
        return above[0]
    return Product(negative, above or (_ONE,), under)


def _summands(term: Expression) -> tuple[Expression, ...]:
    return term.terms if isinstance(term, Sum) else (term,)


def _negated(term: Expression) -> Expression:
    own = _product(term)
    return _joined(not own.negative, own.over, own.under)


class _Tree:
    """Writes an expression as a tree; ``line``: quotients in one line, not as fractions."""

    def __init__(self, *, numbers: bool, units: bool = True, line: bool = False) -> None:
        self._numbers, self._units, self._line = numbers, units, line

    def show(self, term: Expression) -> Tree:
        match term:
            case Power(base, Leaf("0.5")):
                return (Node("root", parts=(self.show(base),)),)
            case Power(base, exponent):
                own = self.show(base)
                return raised(own if is_single(own) else bracketed(own), self.show(exponent))
            case Sum(terms):
                return self._sum(terms)
            case Product(True, (Sum() as taken_off,), ()):
                return ("−", *bracketed(self.show(taken_off)))
            case Product(negative, over, under):
                return ("−", *self._quotient(over, under)) if negative else self._quotient(over, under)
            case Called(name, arguments):
                shown = [sign for one in arguments for sign in (",", *self.show(one))][1:]
                function = Node("function", translate(name.replace("atan", "arctan"), "symbol"))
                return (function, *bracketed(tuple(shown)))
        assert isinstance(term, Leaf)
        return self._leaf(term)

    def _leaf(self, leaf: Leaf) -> Tree:
        if leaf.unit is None:
            return value_tree(localized(leaf.text)) if leaf.own and leaf is not _PI else symbol_tree(leaf.text)
        unit = translate(leaf.unit, "unit") if self._units else ""
        shown = value_tree(f"{localized(f'{leaf.value:.5g}')} {unit}")
        return bracketed(shown) if leaf.value < 0 else shown

    def _sum(self, terms: tuple[Expression, ...]) -> Tree:
        tree: Tree = ()
        for term in terms:
            minus = isinstance(term, Product) and term.negative
            own = _negated(term) if minus else term
            sign = ("−",) if minus else ("+",) if tree else ()
            tree += (*sign, *(bracketed(self.show(own)) if isinstance(own, Sum) else self.show(own)))
        return tree

    def _quotient(self, over: tuple[Expression, ...], under: tuple[Expression, ...]) -> Tree:
        above, below = self._factors(over), self._factors(under)
        if not under:
            return above
        if not self._line:
            return (Node("fraction", parts=(above, below)),)
        if len(over) == 1 and isinstance(over[0], Sum):
            above = bracketed(above)
        # a number with its unit is divided by as a whole
        return (*above, "/", *(below if is_single(below) else bracketed(below)))

    def _factors(self, factors: tuple[Expression, ...]) -> Tree:
        tree: Tree = ()
        for factor in factors:
            own = self.show(factor)
            own = bracketed(own) if isinstance(factor, Sum) and len(factors) > 1 else own
            digits = tree and all(isinstance(each, Node) and each.kind == "number" for each in (tree[-1], own[0]))
            tree += ("·" if self._numbers or digits else TIMES, *own) if tree else own
        return tree


class FormulaText:
    """An equation function called on symbols, and on numbers that keep their units, unevaluated."""

    def __init__(
        self,
        function: Callable[..., Any],
        symbols: Mapping[str, str],
        values: Mapping[str, Any],
        units: Mapping[str, str],
    ) -> None:
        """Run ``function`` on the symbols and on the values of its arguments."""
        self._symbols = _term(function(**{name: Leaf(text, value=values[name]) for name, text in symbols.items()}))
        shown = {name: "" if units[name] == "1" else typeset(units[name]) for name in symbols}
        numbers = {name: Leaf(f"{values[name]:.5g}", value=values[name], unit=unit) for name, unit in shown.items()}
        self._numbers = _term(function(**numbers))

    def text(self) -> str:
        """Return the formula on one line, Unicode."""
        return text(self.tree())

    def text_with_numbers(self) -> str:
        """Return the formula with numbers and units put in, Unicode."""
        return text(self.tree_with_numbers())

    def tree(self) -> Tree:
        """Return the formula as a tree."""
        return _Tree(numbers=False).show(self._symbols)

    def tree_with_numbers(self, *, units: bool = True, line: bool = False) -> Tree:
        """Return the formula with numbers as a tree, with their units, in one line if so wanted."""
        return _Tree(numbers=True, units=units, line=line).show(self._numbers)
