"""Entries of a table of laws that are no functions."""

from typing import NamedTuple


class Same(NamedTuple):
    """Another name of a quantity."""

    quantity: str


class Either(NamedTuple):
    """A choice between two quantities by a third; of numbers only the chosen one is calculated."""

    condition: str
    yes: str
    no: str
