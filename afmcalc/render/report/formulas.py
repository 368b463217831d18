r"""Formulas as trees of signs, fractions and indices, which a page and a sheet of paper set alike.

A tree is a list of nodes. A node is a sign, or a dictionary of one entry: ``number``, ``text``, ``function`` with a
string, ``space`` in em; ``row``, ``root`` with a tree; ``fraction`` with two, ``rows`` with several; ``brackets`` with
the opening, a tree, the closing; ``script`` with base, index and exponent, of which one may be nothing.
"""

import re
from dataclasses import dataclass
from typing import Any

from ...messages import localized
from ..symbols import latex_in_numbers

Tree = list[Any]


@dataclass(frozen=True)
class Formula:
    """A formula as a tree, and in one line for those who are read it."""

    tree: Tree
    alt: str


def formula(latex: str) -> Formula:
    """Read LaTeX of ours, set in the numbers and units of the user's language.

    >>> formula(r"\\frac{F_{\\text{cl}}}{2}").tree
    [{'fraction': [[{'script': [['F'], [{'text': 'cl'}], None]}], [{'number': '2'}]]}]
    >>> formula(r"F = \\sqrt{2} \\cdot 10^{3}\\,\\text{N}").alt
    'F = √(2)·10^3\u2009N'
    """
    tree = _Reader(latex_in_numbers(latex)).row()
    return Formula(tree, plain(tree))


_GREEK = {
    "alpha": "α", "beta": "β", "kappa": "κ", "nu": "ν", "pi": "π", "tau": "τ", "psi": "ψ", "Delta": "Δ", "sigma": "σ",
    "partial": "∂",
}  # fmt: skip
_SIGNS = {"-": "−", r"\cdot": "·", r"\prime": "′"} | {rf"\{name}": sign for name, sign in _GREEK.items()}
_TOKEN = re.compile(
    r"\\(?:begin|end)\{array\}(?:\{l\})?|\\(?:text|operatorname)\{[^}]*\}|\\[A-Za-z]+|\\.|\d+(?:(?:\.|\{,\})\d+)*|\S"
)
_OF_TEXT = {r"\text": "text", r"\operatorname": "function"}


class _Reader:
    """Reads what ``explain.formula`` and ``value_latex`` write."""

    def __init__(self, latex: str) -> None:
        self._tokens = _TOKEN.findall(latex)[::-1]

    def row(self, end: str = "") -> Tree:
        """Read until a token, which is taken too, or the end of a line."""
        tree: Tree = []
        while self._tokens and self._tokens[-1] != r"\\" and (token := self._tokens.pop()) != end:
            if token in ("^", "_"):
                base = tree.pop() if tree else ""
                script = base["script"] if isinstance(base, dict) and "script" in base else [[base], None, None]
                place = 1 if token == "_" else 2
                script[place] = [*(script[place] or []), *self._argument()]
                tree.append({"script": script})
            else:
                tree.append(self._node(token))
        return tree

    def _argument(self) -> Tree:
        token = self._tokens.pop()
        return self.row("}") if token == "{" else [self._node(token)]

    def _node(self, token: str) -> Any:
        command, _, inside = token.partition("{")
        if command in _OF_TEXT:
            return {_OF_TEXT[command]: inside[:-1]}
        if command == r"\begin":
            rows = [self.row(r"\end{array}")]
            while self._tokens and self._tokens[-1] == r"\\":
                self._tokens.pop()
                rows.append(self.row(r"\end{array}"))
            return {"rows": rows}
        if token == r"\frac":
            return {"fraction": [self._argument(), self._argument()]}
        if token == r"\sqrt":
            return {"root": self._argument()}
        if token == r"\left":
            return {"brackets": [self._tokens.pop(), self.row(r"\right"), self._tokens.pop()]}
        if token == r"\,":
            return {"space": 0.17}
        if token[0].isdigit():
            return {"number": localized(token.replace("{,}", "."))}
        sign = _SIGNS.get(token, token)
        return {"function": sign[1:]} if sign[0] == "\\" else sign


def plain(tree: Any) -> str:
    """Say a formula in one line."""
    if isinstance(tree, list):
        return "".join(map(plain, tree))
    if isinstance(tree, str):
        return f" {tree} " if tree in "=+−" else tree
    ((kind, body),) = tree.items()
    match kind, body:
        case "fraction", [above, below]:
            return f"({plain(above)})/({plain(below)})"
        case "root", _:
            return f"√({plain(body)})"
        case "brackets", [opening, inner, closing]:
            return f"{opening}{plain(inner)}{closing}"
        case "rows", _:
            return " ".join(map(plain, body))
        case "script", [base, below, above]:
            raised = plain(above or [])
            return plain(base) + (f"_{plain(below)}" if below else "") + (f"^{raised}" if raised.strip("′") else raised)
        case "space", _:
            return "\u2009"
        case "function", _:
            return f"{body} "
    return plain(body)
