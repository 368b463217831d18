"""The laws of a clutch: one plain function for each quantity, named by it, its arguments named by what they are.

A law is arithmetic on whatever it is given: numbers, NumPy arrays, pint quantities, SymPy symbols. ``terms`` has
symbol, SI unit and meaning of every name, a law's docstring the formula, its source and its validity.
``engines.selection`` says which laws make up a clutch, ``engines.quantities`` calculates a name by them.

Beside functions a module may hold: a number, which is taken where nothing is given; ``Same("x")``, another name of x;
``Either(condition, yes, no)``; a mapping in capitals, laws that an option puts in the place of others; and ``CASES``,
in which a quantity has the value of another one; ``SYMBOLS``, terms of names that mean something else in this module.
"""
