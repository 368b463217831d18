"""Base class of ``Quantities``; its stub tells type checkers and editors which quantities there are."""


class Named:
    """Object whose attributes are the quantities of ``equations.terms``."""
