"""The published formulas, one short function each: plain ``+ - * / **`` on whatever arguments are given.

The same function therefore runs on floats, NumPy arrays, pint quantities and SymPy symbols.
"""
