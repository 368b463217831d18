"""Laws of a clutch: one plain function for each quantity, named after it, with arguments named after quantities.

A law is plain arithmetic on numbers, NumPy arrays, pint quantities or SymPy symbols. ``terms`` has symbol, SI unit and
meaning of every name; the docstring of a law has its formula, source and validity. ``engines.selection`` selects the
laws of a clutch, ``engines.quantities`` calculates quantities with them.

Besides functions a module may hold: a number, the default of a quantity; ``Same("x")``, another name of x;
``Either(condition, yes, no)``, a choice; a mapping in capitals, laws that an option replaces; ``CASES``, in which a
quantity takes the value of another one.
"""
