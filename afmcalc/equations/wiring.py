"""Entries of a table of laws other than functions: other names and choices."""

from typing import NamedTuple


class Same(NamedTuple):
    """Another name of a quantity."""

    quantity: str


class Either(NamedTuple):
    """Choice between two quantities by a condition; if that is no array only the chosen one is calculated."""

    condition: str
    yes: str
    no: str
