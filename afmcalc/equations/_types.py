"""The type of what an equation takes and gives."""

from typing import Any, TypeAlias

Number: TypeAlias = Any
"""Anything with ``+ - * / **``: a float, a NumPy array of any shape, a pint quantity, a SymPy expression.

No static type covers all four, so equations are typed ``Number -> Number``; the engines, which
know what they pass, narrow it to floats and arrays.
"""
