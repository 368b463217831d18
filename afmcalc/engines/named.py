"""Base of ``Quantities``, whose stub tells type checkers and editors which quantities there are."""


class Named:
    """Object that has the quantities of ``equations.terms`` as attributes."""
