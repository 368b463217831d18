"""The text of an equation function, from running it on SymPy symbols."""

import re
from collections.abc import Callable, Mapping
from typing import Any

import sympy
from sympy.printing.latex import LatexPrinter
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.str import StrPrinter


class Formula:
    """An equation function called on symbols, and on numbers that keep their units, unevaluated."""

    def __init__(
        self,
        function: Callable[..., Any],
        symbols: Mapping[str, str],
        values: Mapping[str, Any],
        units: Mapping[str, str],
    ) -> None:
        """Run ``function`` on the symbols and on the values of its arguments."""
        plain = {name: _number(values[name], units[name], latex=False) for name in symbols}
        set_in_latex = {name: _number(values[name], units[name], latex=True) for name in symbols}
        with sympy.evaluate(False):
            self._symbolic, self._plain, self._latex = (
                _flat(function(**{name: sympy.Symbol(text) for name, text in texts.items()}))
                for texts in (symbols, plain, set_in_latex)
            )

    def text(self) -> str:
        """Return the formula on one line, Unicode."""
        return str(_Text({"order": "none"}).doprint(self._symbolic))

    def text_with_numbers(self) -> str:
        """Return the formula with numbers and units put in, Unicode."""
        return str(_Text({"order": "none"}).doprint(self._plain))

    def latex(self) -> str:
        """Return the formula in LaTeX."""
        return str(_Latex({"order": "none"}).doprint(self._symbolic))

    def latex_with_numbers(self) -> str:
        """Return the formula with numbers and units in LaTeX."""
        return str(_Latex({"order": "none", "mul_symbol": "dot"}).doprint(self._latex))


def _flat(expression: Any) -> Any:
    """Join nested sums and products, in the order they are written, and pull −1 to the front of a product."""
    if isinstance(expression, tuple):
        return sympy.Tuple(*map(_flat, expression))
    if not expression.args:
        return expression
    arguments = [_flat(argument) for argument in expression.args]
    if isinstance(expression, sympy.Add | sympy.Mul):
        kind = type(expression)
        arguments = [part for each in arguments for part in (each.args if isinstance(each, kind) else (each,))]
        if kind is sympy.Mul:
            arguments = _signs_joined([part for part in arguments if part != 1]) or [sympy.Integer(1)]
        if len(arguments) == 1:
            return arguments[0]
        return kind(*arguments, evaluate=False)
    if isinstance(expression, sympy.Pow) and isinstance(arguments[0], sympy.Mul) and arguments[1] == -1:
        # 1/(a·b) as a⁻¹·b⁻¹, so that it joins the product it divides
        return sympy.Mul(*(sympy.Pow(part, -1, evaluate=False) for part in arguments[0].args), evaluate=False)
    return expression.func(*arguments, evaluate=False)


def _signs_joined(factors: list[Any]) -> list[Any]:
    """Put the minus of a difference onto the number it stands before: −1·2·x is −2·x."""
    if len(factors) > 1 and factors[0] == -1 and factors[1].is_Integer:
        return [-factors[1], *factors[2:]]
    return factors


def _number(value: Any, unit: str, *, latex: bool) -> str:
    """Write a value with its SI unit; the spaces keep it apart from operators."""
    text = f"{value:.5g}"
    if "e" in text:
        mantissa, _, exponent = text.partition("e")
        text = f"{mantissa}\\cdot 10^{{{int(exponent)}}}" if latex else f"({mantissa}·10^{int(exponent)})"
    if unit == "1":
        return text
    shown = unit.replace("*", "·").replace("^3", "³")
    return f"{text}\\,\\text{{{shown}}}" if latex else f"{text} {shown}"


def symbol_latex(symbol: str) -> str:
    """Return a symbol of the papers in LaTeX."""
    return str(_Latex().doprint(sympy.Symbol(symbol)))


def _apart(power: Any) -> Any:
    """Put brackets round a number with a unit that is raised to a power."""
    base, exponent = power.args
    if base.is_Symbol and " " in base.name and exponent != -1:
        return sympy.Pow(sympy.Symbol(f"({base.name})"), exponent, evaluate=False)
    return power


def _is_negative(term: Any) -> bool:
    """Whether a term of a sum is written with a minus."""
    number = term.args[0] if isinstance(term, sympy.Mul) else term
    return bool(number.is_Integer and number < 0)


def _negated(term: Any) -> Any:
    """Return a negative term without its minus."""
    if not isinstance(term, sympy.Mul):
        return -term
    number, *rest = term.args
    factors = rest if number == -1 else [-number, *rest]
    return factors[0] if len(factors) == 1 else sympy.Mul(*factors, evaluate=False)


class _Text(StrPrinter):  # type: ignore[misc]
    """One-line Unicode: a raised dot for products, no space around it."""

    def _print_Mul(self, expr: Any) -> str:  # noqa: N802
        return str(super()._print_Mul(expr)).replace("*", "·").replace("··", "**")

    def _print_Add(self, expr: Any, order: Any = None) -> str:  # noqa: N802
        text = ""
        for term in expr.args:
            minus = _is_negative(term)
            shown = self.parenthesize(_negated(term) if minus else term, PRECEDENCE["Add"])
            text += (" - " if minus else " + ") + shown if text else ("-" if minus else "") + shown
        return text

    def _print_Pow(self, expr: Any, rational: bool = False) -> str:  # noqa: N802
        return str(super()._print_Pow(_apart(expr), rational)).replace("**", "^")


class _Latex(LatexPrinter):  # type: ignore[misc]
    """LaTeX whose symbols are taken as they are: names with a unit, or the papers' own with an index."""

    def _print_Symbol(self, expr: Any, style: str = "plain") -> str:  # noqa: N802
        name = str(expr.name)
        if "\\" in name or name[:1].isdigit() or name[:1] == "-":
            return name
        for letter, command in _GREEK.items():
            name = name.replace(letter, command)
        indexed = _INDEXED.sub(r"\1_{\\text{\2}}", name.replace("'", "^{\\prime}"))
        return _FUNCTION.sub(r"\\\1 ", indexed)


_GREEK = {
    "α": "\\alpha ",
    "β": "\\beta",
    "κ": "\\kappa ",
    "ν": "\\nu",
    "π": "\\pi ",
    "τ": "\\tau",
    "ψ": "\\psi",
    "Δ": "\\Delta ",
    "∂": "\\partial ",
}
_INDEXED = re.compile(r"((?:\\[a-z]+|[^\W_])(?:\^\{\\prime\})?)_([\w.,+]+)")
"""A letter with an index: F_п, ΔT_2, T'_п."""
_FUNCTION = re.compile(r"\b(sin|cos|tan|ln) ?(?=\w)")
