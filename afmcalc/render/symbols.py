"""The papers' symbols, written ``K_т`` in the results, set with real subscripts."""

import re

from ..messages import native, printable

_SUBSCRIPT = re.compile(r"(?<![^\W_]{3})_([^\W_²³⁶]+(?:[.,][^\W_²³⁶]+)*)")
"""A symbol has a letter or two before its subscript: ``control_unit.gain`` is a key."""


def split(text: str, ours: bool = True) -> list[tuple[str, bool]]:
    """Split a text into pieces and whether each is a subscript; what is quoted is not ours and stays as it is.

    >>> split("ΔT_2/ΔT_1")
    [('ΔT', False), ('2', True), ('/ΔT', False), ('1', True)]
    >>> split("T_н.муф, K_т,p")
    [('T', False), ('n,c', True), (', K', False), ('T,p', True)]
    >>> split("ν_1²")
    [('ν', False), ('1', True), ('²', False)]
    >>> split("control_unit.gain")
    [('control_unit.gain', False)]
    """
    pieces = _SUBSCRIPT.split(native(text) if ours else text)
    return [(piece, bool(number % 2)) for number, piece in enumerate(pieces) if piece]


def mathtext(text: str) -> str:
    """Set a text of our own (labels, symbols) for matplotlib.

    >>> mathtext("K_т")
    'K$_{T}$'
    """
    return "".join(f"$_{{{piece}}}$" if low else literal(piece) for piece, low in split(text))


def literal(text: str) -> str:
    """Keep matplotlib from reading anything into a text of the user's (the name of a spec), or hiding it (``_x``)."""
    shown = printable(text)
    return (f" {shown}" if shown.startswith("_") else shown).replace("$", r"\$")
