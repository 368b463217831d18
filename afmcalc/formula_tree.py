"""A formula as a tree of signs, fractions and indices, and in one line of text."""

import re
from typing import NamedTuple

from .messages import localized, native


class Node(NamedTuple):
    """Part of a formula that is more than one sign."""

    kind: str
    """``number``, ``text``, ``function`` and ``gap`` have a text; ``root`` and ``brackets`` have one tree, ``fraction``
    two, ``rows`` several; ``script`` has base, index and exponent, of which index or exponent may be empty."""
    text: str = ""
    parts: "tuple[Tree, ...]" = ()


Tree = tuple[str | Node, ...]
"""Formula as a sequence of signs and nodes, its symbols, numbers and units in the user's language."""
GAP = Node("gap", "0.17")
"""Space between a number and its unit; its width is in em."""
TIMES = "\u2062"
"""Invisible multiplication sign between factors."""


def bracketed(tree: Tree) -> Tree:
    """Tree in brackets; a tree already in brackets is not changed."""
    single = len(tree) == 1 and isinstance(tree[0], Node) and tree[0].kind == "brackets"
    return tree if single else (Node("brackets", parts=(tree,)),)


def is_single(tree: Tree) -> bool:
    """True if a tree is one sign, number or symbol, perhaps with an index but without an exponent."""
    first, *others = tree
    kind = "number" if isinstance(first, str) else first.kind
    return not others and (kind in ("number", "text") or (kind == "script" and not first[2][2]))


def raised(base: Tree, exponent: Tree, index: Tree = ()) -> Tree:
    """Tree with ``exponent`` and ``index`` added to its last part."""
    *before, last = base
    parts: tuple[Tree, ...] = ((last,), (), ())
    if isinstance(last, Node) and last.kind == "script":
        parts = last.parts
    return (*before, Node("script", parts=(parts[0], parts[1] + index, parts[2] + exponent)))


def symbol_tree(symbol: str) -> Tree:
    """Symbol of the papers as a tree.

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
    """Displayed number with its unit as a tree.

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
    """Formula as one line of text.

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
    """Formula as one line of text, in brackets if the formula or a unit in it contains one of ``signs``."""
    marks = (
        node if isinstance(node, str) else {"text": node.text, "fraction": "/"}.get(node.kind, "") for node in tree
    )
    return text(bracketed(tree) if {*"".join(marks)} & {*signs} else tree)
