"""The text of a law, from running it on terms that keep what is done to them."""

import math
import operator
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

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
    """A symbol with the number that it stands for, or a number of the law itself."""

    text: str
    unit: str | None = None
    """SI unit of the number; None of a number of the law itself."""
    value: float = field(default=math.nan, compare=False)

    def __gt__(self, other: float) -> bool:
        """Compare the number: a law may ask whether there is one."""
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


_ONE, _PI = Leaf("1"), Leaf("π")


def _term(value: Expression | float) -> Expression:
    if isinstance(value, Expression):
        return value
    own = _PI if abs(value) == math.pi else Leaf(f"{abs(value):g}")
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


_SEVERAL = re.compile(r"^(?!sin|cos|tan|ln)\D\S* |^[^(]*/|\d .*·")
"""One term that reads as several: a symbol such as α A_c or A/B, a number whose unit is a product or a ratio."""


class _Text:
    """One line, Unicode: a raised dot for products, no space around it."""

    brackets, minus, times, unit = "({})", "-", "·", "{} {}"
    power_of_ten = "({}·10^{})"
    split = re.compile("[ /]")
    """Signs of a term that is raised in brackets: a number with a unit, a ratio that is one symbol."""

    def __init__(self, *, numbers: bool) -> None:
        """Write the symbols, or the numbers that they stand for."""
        self.numbers = numbers

    def show(self, term: Expression) -> str:
        """Write an expression."""
        match term:
            case Power(base, exponent):
                return self._power(base, exponent)
            case Sum(terms):
                return self._sum(terms)
            case Product(True, (Sum() as taken_off,), ()):
                return self.minus + self._in_brackets(taken_off, True)
            case Product(negative, over, under):
                return (self.minus if negative else "") + self._quotient(over, under)
            case Called(name, arguments):
                return self._function(name) + self.brackets.format(", ".join(map(self.show, arguments)))
        assert isinstance(term, Leaf)
        return self._symbol(self._text(term))

    def _text(self, leaf: Leaf) -> str:
        """Symbol, or number with its SI unit; the spaces keep it apart from operators."""
        if leaf.unit is None or not self.numbers:
            return leaf.text
        number, _, exponent = f"{leaf.value:.5g}".partition("e")
        text = self.power_of_ten.format(number, int(exponent)) if exponent else number
        text = text if leaf.unit == "1" else self.unit.format(text, typeset(leaf.unit))
        return f"({text})" if leaf.value < 0 else text

    def _symbol(self, text: str) -> str:
        return text

    def _function(self, name: str) -> str:
        return name

    def _in_brackets(self, term: Expression, when: bool) -> str:
        own = self.show(term)
        return self.brackets.format(own) if when else own

    def _is_whole(self, term: Expression) -> bool:
        return isinstance(term, Leaf) and not self.split.search(self._text(term))

    def _power(self, base: Expression, exponent: Expression) -> str:
        return "^".join(self._in_brackets(each, not self._is_whole(each)) for each in (base, exponent))

    def _sum(self, terms: tuple[Expression, ...]) -> str:
        text = ""
        for term in terms:
            minus = isinstance(term, Product) and term.negative
            own = _negated(term) if minus else term
            shown = self._in_brackets(own, isinstance(own, Sum))
            text += (" - " if minus else " + ") + shown if text else (self.minus if minus else "") + shown
        return text

    def _quotient(self, over: tuple[Expression, ...], under: tuple[Expression, ...]) -> str:
        above = self.times.join(self._in_brackets(each, isinstance(each, Sum | Product)) for each in over)
        below = self.times.join(map(self._divisor, under))
        return f"{above}/({below})" if len(under) > 1 else f"{above}/{below}" if under else above

    def _divisor(self, term: Expression) -> str:
        of_sum = isinstance(term, Power) and isinstance(term.base, Sum)
        several = isinstance(term, Leaf) and _SEVERAL.search(self._text(term)) is not None
        return self._in_brackets(term, isinstance(term, Sum | Product) or of_sum or several)


class _Latex(_Text):
    """LaTeX: quotients as fractions."""

    brackets, minus, unit = "\\left({}\\right)", "- ", "{}\\,\\text{{{}}}"
    power_of_ten = "{}\\cdot 10^{{{}}}"
    split = re.compile(r"[ /^]|\\,")

    def _symbol(self, text: str) -> str:
        return symbol_latex(text)

    def _function(self, name: str) -> str:
        return f"\\{name.replace('atan', 'arctan')} "

    def _power(self, base: Expression, exponent: Expression) -> str:
        if isinstance(exponent, Leaf) and self._text(exponent) == "0.5":
            return f"\\sqrt{{{self.show(base)}}}"
        return f"{self._in_brackets(base, not self._is_whole(base))}^{{{self.show(exponent)}}}"

    def _quotient(self, over: tuple[Expression, ...], under: tuple[Expression, ...]) -> str:
        above = self._factors(over)
        return f"\\frac{{{above}}}{{{self._factors(under)}}}" if under else above

    def _factors(self, factors: tuple[Expression, ...]) -> str:
        text = ""
        for factor in factors:
            own = self._in_brackets(factor, isinstance(factor, Sum) and len(factors) > 1)
            dot = self.numbers or (text[-1:].isdigit() and own[:1].isdigit())
            text += (" \\cdot " if dot else " ") + own if text else own
        return text


class _LatexLine(_Latex):
    """LaTeX in one line: a stroke for a fraction's bar, brackets that do not grow."""

    brackets = "({})"

    def _quotient(self, over: tuple[Expression, ...], under: tuple[Expression, ...]) -> str:
        above, below = self._factors(over), self._factors(under)
        if len(over) == 1 and isinstance(over[0], Sum) and under:
            above = self.brackets.format(above)
        # a number with its unit is divided by as a whole
        whole = len(under) == 1 and isinstance(under[0], Leaf) and "\\" not in self._text(under[0])
        return f"{above}/{below if whole else self.brackets.format(below)}" if under else above


def formula_of(
    function: Callable[..., Any], terms: Mapping[str, tuple[str, str]], values: Mapping[str, Any]
) -> Expression:
    """Return the formula of a law, called on its arguments: name → symbol and SI unit, name → value."""
    leaves = {name: Leaf(symbol, unit, values[name]) for name, (symbol, unit) in terms.items()}
    return _term(function(**leaves))


def text(formula: Expression, *, numbers: bool = False) -> str:
    """Write a formula on one line, Unicode, with its symbols or with numbers and units put in."""
    return _Text(numbers=numbers).show(formula)


def latex(formula: Expression, *, numbers: bool = False, line: bool = False) -> str:
    """Write a formula in LaTeX, with its symbols or with numbers and units put in; in one line if so wanted."""
    return (_LatexLine if line else _Latex)(numbers=numbers).show(formula)


def symbol_latex(name: str) -> str:
    """Return a symbol of the papers in LaTeX."""
    if "\\" in name or (name[:1].isdigit() and "_" not in name) or name[:1] == "-":
        return name
    for letter, command in _GREEK.items():
        name = name.replace(letter, command)
    indexed = _INDEXED.sub(r"\1_{\\text{\2}}", name.replace("'", "^{\\prime}"))
    return _FUNCTION.sub(r"\\\1 ", indexed).replace("²", "^{2}")


_GREEK = {
    "α": "\\alpha ", "β": "\\beta", "κ": "\\kappa ", "ν": "\\nu", "π": "\\pi ", "τ": "\\tau", "ψ": "\\psi",
    "Δ": "\\Delta ", "∂": "\\partial ",
}  # fmt: skip
_INDEXED = re.compile(r"((?:\\[a-z]+|[^\W_]|\))(?:\^\{\\prime\})?)_((?:[^\W²]|[.,+])+)")
"""A letter with an index: F_п, ΔT_2, T'_п."""
_FUNCTION = re.compile(r"\b(sin|cos|tan|ln) ?(?=[\w\\(])")
