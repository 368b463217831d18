"""Formulas of a document: trees of signs, fractions and indices, which a page and a sheet of paper set alike."""

from dataclasses import dataclass

from ...formula_tree import TIMES, Node, Tree, text


@dataclass(frozen=True)
class Formula:
    """A formula as a tree, and in one line for those who are read it."""

    tree: Tree
    alt: str


def formula(*sides: Tree) -> Formula:
    """Set the sides of an equation.

    >>> formula(("F",), (Node("fraction", parts=(("a", "b"), ("c",))),)).alt
    'F = ab/c'
    """
    tree = equated(*sides)
    return Formula(tree, text(tree))


def equated(*sides: Tree) -> Tree:
    """Join the sides of an equation."""
    return tuple(sign for side in sides for sign in ("=", *side))[1:]


SHORT = 64
"""Signs that a line of a formula may have."""


def size(tree: Tree) -> int:
    """Number of signs that a formula has, about."""
    return sum(len(node) if isinstance(node, str) else len(node.text) + sum(map(size, node.parts)) for node in tree)


def broken(tree: Tree, most: int = SHORT) -> Tree:
    """Set a sum or product that is too long in several lines: MathML breaks none, and paper does not scroll."""
    if size(tree) <= most:
        return tree
    rows: list[Tree] = [()]
    for node in tree:
        if rows[-1] and (node in ("+", "−") or (node in ("·", TIMES) and size(rows[-1]) > most / 2)):
            rows.append(())
        rows[-1] += (node,)
    return (Node("rows", parts=tuple(rows)),) if len(rows) > 1 else tree
