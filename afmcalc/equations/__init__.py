"""The published formulas, one short function each: plain ``+ - * / **`` on whatever arguments are given.

The same function therefore runs on floats, NumPy arrays, pint quantities and SymPy symbols. Its signature names the
quantities with symbol and unit (``terms``), its docstring the formula, its source and the limits of its validity.
"""
