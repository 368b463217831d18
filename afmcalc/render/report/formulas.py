"""Formulas of a document: trees of signs, fractions and indices, typeset on pages and on sheets of paper."""

from dataclasses import dataclass

from ...formula_tree import TIMES, Node, Tree, text


@dataclass(frozen=True)
class Formula:
    """Formula as a tree, and as a line of text for screen readers."""

    tree: Tree
    alt: str


def formula(*sides: Tree) -> Formula:
    """Equation with two or more sides.

    >>> formula(("F",), (Node("fraction", parts=(("a", "b"), ("c",))),)).alt
    'F = ab/c'
    """
    tree = equated(*sides)
    return Formula(tree, text(tree))


def equated(*sides: Tree) -> Tree:
    """Tree of the sides of an equation, joined by equals signs."""
    return tuple(sign for side in sides for sign in ("=", *side))[1:]


SHORT = 64
"""Largest number of signs in a line of a formula."""


def size(tree: Tree) -> int:
    """Approximate number of signs in a formula."""
    return sum(len(node) if isinstance(node, str) else len(node.text) + sum(map(size, node.parts)) for node in tree)


def broken(tree: Tree, most: int = SHORT) -> Tree:
    """Break a sum or product longer than ``most`` into lines, as MathML breaks no formula and paper does not scroll."""
    if size(tree) <= most:
        return tree
    rows: list[Tree] = [()]
    for node in tree:
        if rows[-1] and (node in ("+", "−") or (node in ("·", TIMES) and size(rows[-1]) > most / 2)):
            rows.append(())
        rows[-1] += (node,)
    return (Node("rows", parts=tuple(rows)),) if len(rows) > 1 else tree
