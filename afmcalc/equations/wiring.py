"""What stands beside functions in a table of laws."""

from typing import NamedTuple


class Same(NamedTuple):
    """Another name of a quantity."""

    quantity: str


class Either(NamedTuple):
    """A choice between two quantities by a third; of numbers only the chosen one is calculated."""

    condition: str
    yes: str
    no: str
