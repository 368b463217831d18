"""A formula as a tree of signs, fractions and indices, and its writers: one line of text, LaTeX."""

import re
from typing import NamedTuple, TypeAlias

from .messages import localized, native


class Node(NamedTuple):
    """A part of a formula that is more than one sign."""

    kind: str
    """``number``, ``text``, ``function`` or ``gap`` have a text; ``root`` and ``brackets`` have one tree, ``fraction``
    two, ``rows`` several; ``script`` has base, index and exponent, of which one may be empty."""
    text: str = ""
    parts: "tuple[Tree, ...]" = ()


Tree: TypeAlias = tuple[str | Node, ...]
"""A formula as a row of signs and nodes, set in the letters, numbers and units of the user's language."""
GAP = Node("gap", "0.17")
"""Space between a number and its unit, em."""
TIMES = "\u2062"
"""Sign between factors where none is seen."""


def bracketed(tree: Tree) -> Tree:
    """Put a tree in brackets, unless it is in them."""
    single = len(tree) == 1 and isinstance(tree[0], Node) and tree[0].kind == "brackets"
    return tree if single else (Node("brackets", parts=(tree,)),)


def is_single(tree: Tree) -> bool:
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
    return (*tree, GAP, Node("text", unit)) if unit else tree


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
            return f"{text(parts[0] if is_single(parts[0]) else bracketed(parts[0]))}^{localized('0.5')}"
        case "brackets":
            return f"({text(parts[0])})"
        case "rows":
            return " ".join(map(text, parts))
        case "gap":
            return " "
        case "script":
            base, index, power = text(parts[0]), text(parts[1]), tuple(sign for sign in parts[2] if sign != "′")
            base += "'" * (len(parts[2]) - len(power)) + (f"_{index}" if index else "")
            return base + (f"^{text(power if is_single(power) else bracketed(power))}" if power else "")
    return node.text


def _without(tree: Tree, signs: str) -> str:
    """Write a tree, in brackets if one of some signs is in it or in a unit of it."""
    marks = (
        node if isinstance(node, str) else {"text": node.text, "fraction": "/"}.get(node.kind, "") for node in tree
    )
    return text(bracketed(tree) if {*"".join(marks)} & {*signs} else tree)


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
