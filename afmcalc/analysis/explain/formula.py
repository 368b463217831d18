"""The formula of a law, as text and as a tree, from running it on terms that keep what is done to them."""

import math
import operator
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple, TypeAlias

from ...messages import localized, native, translate
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


class Node(NamedTuple):
    """A part of a formula that is more than one sign."""

    kind: str
    """``number``, ``text``, ``function`` or ``gap`` have a text; ``root`` and ``brackets`` have one tree, ``fraction``
    two, ``rows`` several; ``script`` has base, index and exponent, of which one may be empty."""
    text: str = ""
    parts: "tuple[Tree, ...]" = ()


Tree: TypeAlias = tuple[str | Node, ...]
"""A formula as a row of signs and nodes, set in the letters, numbers and units of the user's language."""
_GAP = Node("gap", "0.17")
"""Space between a number and its unit, em."""
TIMES = "\u2062"
"""Sign between factors where none is seen."""


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
                return raised(own if _is_single(own) else _bracketed(own), self.show(exponent))
            case Sum(terms):
                return self._sum(terms)
            case Product(True, (Sum() as taken_off,), ()):
                return ("−", *_bracketed(self.show(taken_off)))
            case Product(negative, over, under):
                return ("−", *self._quotient(over, under)) if negative else self._quotient(over, under)
            case Called(name, arguments):
                shown = [sign for one in arguments for sign in (",", *self.show(one))][1:]
                function = Node("function", translate(name.replace("atan", "arctan"), "symbol"))
                return (function, *_bracketed(tuple(shown)))
        assert isinstance(term, Leaf)
        return self._leaf(term)

    def _leaf(self, leaf: Leaf) -> Tree:
        if leaf.unit is None:
            return value_tree(localized(leaf.text)) if leaf.own and leaf is not _PI else symbol_tree(leaf.text)
        unit = translate(leaf.unit, "unit") if self._units else ""
        shown = value_tree(f"{localized(f'{leaf.value:.5g}')} {unit}")
        return _bracketed(shown) if leaf.value < 0 else shown

    def _sum(self, terms: tuple[Expression, ...]) -> Tree:
        tree: Tree = ()
        for term in terms:
            minus = isinstance(term, Product) and term.negative
            own = _negated(term) if minus else term
            sign = ("−",) if minus else ("+",) if tree else ()
            tree += (*sign, *(_bracketed(self.show(own)) if isinstance(own, Sum) else self.show(own)))
        return tree

    def _quotient(self, over: tuple[Expression, ...], under: tuple[Expression, ...]) -> Tree:
        above, below = self._factors(over), self._factors(under)
        if not under:
            return above
        if not self._line:
            return (Node("fraction", parts=(above, below)),)
        if len(over) == 1 and isinstance(over[0], Sum):
            above = _bracketed(above)
        # a number with its unit is divided by as a whole
        return (*above, "/", *(below if _is_single(below) else _bracketed(below)))

    def _factors(self, factors: tuple[Expression, ...]) -> Tree:
        tree: Tree = ()
        for factor in factors:
            own = self.show(factor)
            own = _bracketed(own) if isinstance(factor, Sum) and len(factors) > 1 else own
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


def _bracketed(tree: Tree) -> Tree:
    single = len(tree) == 1 and isinstance(tree[0], Node) and tree[0].kind == "brackets"
    return tree if single else (Node("brackets", parts=(tree,)),)


def _is_single(tree: Tree) -> bool:
    """True if a tree is one sign, number or symbol, perhaps with an index."""
    first, *others = tree
    kind = "number" if isinstance(first, str) else first.kind
    return not others and (kind in ("number", "text") or (kind == "script" and not first[2][2]))


def raised(base: Tree, exponent: Tree, index: Tree = ()) -> Tree:
    """Add an exponent, or an index, to the last part of a tree."""
    *before, last = base
    parts: tuple[Tree, ...] = ((last,), (), ())
    if isinstance(last, Node) and last.kind == "script":
        parts = last.parts
    return (*before, Node("script", parts=(parts[0], parts[1] + index, parts[2] + exponent)))


def symbol_tree(symbol: str) -> Tree:
    """Return a symbol of the papers as a tree.

    >>> symbol_tree("F_п2")[0].parts
    (('F',), (Node(kind='text', text='sp2', parts=()),), ())
    """
    tree: Tree = ()
    for function, word, number, sign, index in _SIGNS.findall(native(symbol)):
        if word:
            tree += (Node("text", f"\xa0{word}\xa0"),)
        elif index:
            tree = raised(tree, (), (Node("text", index),))
        elif number:
            tree += (Node("number", localized(number)),)
        elif function:
            tree += (Node("function", function),)
        elif sign in "'²":
            tree = raised(tree, ("′",) if sign == "'" else (Node("number", "2"),))
        else:
            tree += ("−" if sign == "-" else sign,)
    return tree


_SIGNS = re.compile(
    r"\b(sin|cos|tan|tg|ln)(?: |(?=[\w(]))| ([^\W\d_]{2,})(?: |$)|(\d+(?:\.\d+)*)|([^_])|_((?:[^\W²]|[.,+])+)"
)


def value_tree(shown: str) -> Tree:
    """Return a number as people see it, with its unit, as a tree.

    >>> text(value_tree("1.2e+07 N"))
    '1.2·10^7 N'
    """
    number, _, unit = re.sub("(?<! )°", " °", shown).partition(" ")
    mantissa, _, exponent = number.partition("e")
    if power := _POWER.fullmatch(number):
        mantissa, exponent = power[1] or "1", power[2].translate(_LOWERED)
    minus = ("−",) if mantissa[:1] in ("-", "−") else ()
    tree: Tree = (*minus, Node("number", mantissa.lstrip("-−")))
    if exponent:
        sign: Tree = ("−",) if int(exponent) < 0 else ()
        ten = raised((Node("number", "10"),), (*sign, Node("number", str(abs(int(exponent))))))
        tree = (*tree, "·", *ten)
    return (*tree, _GAP, Node("text", unit)) if unit else tree


_POWER = re.compile("(?:(.+)·)?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)")
_LOWERED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def text(tree: Tree) -> str:
    """Write a tree in one line.

    >>> text(("a", "+", Node("fraction", parts=(("b", "+", "c"), ("d", TIMES, "e")))))
    'a + (b + c)/(d·e)'
    """
    line = ""
    for node, after in zip(tree, (*tree[1:], "("), strict=False):
        if isinstance(node, Node):
            called = after == "(" or isinstance(after, Node) and after.kind == "brackets"
            line += _text(node, *node.parts) + " " * (node.kind == "function" and not called)
        elif node in "+−":
            sign = "+" if node == "+" else localized("-")
            line += sign if line[-1:] in ("", "(", "·", "/") else f" {sign} "
        else:
            line += {"=": " = ", ",": ", ", TIMES: "·"}.get(node, node)
    return line


def _text(node: Node, *parts: Tree) -> str:
    match node.kind:
        case "fraction":
            return f"{_without(parts[0], '+−')}/{_without(parts[1], '+−·/ ' + TIMES)}"
        case "root":
            return f"{text(parts[0] if _is_single(parts[0]) else _bracketed(parts[0]))}^{localized('0.5')}"
        case "brackets":
            return f"({text(parts[0])})"
        case "rows":
            return " ".join(map(text, parts))
        case "gap":
            return " "
        case "script":
            base, index, power = text(parts[0]), text(parts[1]), tuple(sign for sign in parts[2] if sign != "′")
            base += "'" * (len(parts[2]) - len(power)) + (f"_{index}" if index else "")
            return base + (f"^{text(power if _is_single(power) else _bracketed(power))}" if power else "")
    return node.text


def _without(tree: Tree, signs: str) -> str:
    """Write a tree, in brackets if one of some signs is in it or in a unit of it."""
    marks = (
        node if isinstance(node, str) else {"text": node.text, "fraction": "/"}.get(node.kind, "") for node in tree
    )
    return text(_bracketed(tree) if {*"".join(marks)} & {*signs} else tree)


def latex(tree: Tree) -> str:
    """Write a tree as LaTeX.

    >>> latex((*symbol_tree("F_п"), "=", *value_tree("0,5 кН")))
    'F_{\\\\text{cl}} = 0{,}5 \\\\, \\\\text{кН}'
    """
    return " ".join(map(_latex, tree))


def _latex(node: str | Node) -> str:
    if isinstance(node, str):
        return _LATEX.get(node, node)
    parts = [*map(latex, node.parts)]
    match node.kind:
        case "number":
            return node.text.replace(",", "{,}").replace("\xa0", "\\,")
        case "text":
            return f"\\text{{{node.text}}}"
        case "function":
            return f"\\operatorname{{{node.text}}}" if node.text.endswith("tg") else f"\\{node.text}"
        case "gap":
            return "\\,"
        case "brackets":
            return f"\\left({parts[0]}\\right)"
        case "root":
            return f"\\sqrt{{{parts[0]}}}"
        case "fraction":
            return f"\\frac{{{parts[0]}}}{{{parts[1]}}}"
    base, below, above = parts
    return base + (f"_{{{below}}}" if below else "") + (f"^{{{above}}}" if above else "")


_LATEX = {
    "α": "\\alpha", "β": "\\beta", "κ": "\\kappa", "ν": "\\nu", "π": "\\pi", "σ": "\\sigma", "τ": "\\tau", "ψ": "\\psi",
    "Δ": "\\Delta", "∂": "\\partial", "·": "\\cdot", "′": "\\prime", "−": "-", TIMES: "",
}  # fmt: skip
