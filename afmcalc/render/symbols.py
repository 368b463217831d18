"""The papers' symbols, which results write like ``K_т``, set with real subscripts."""

import re

from ..messages import native, printable

_SUBSCRIPT = re.compile(r"(?<![^\W_]{3})_([^\W_²³⁶]+(?:[.,][^\W_²³⁶]+)*)")
"""Pattern of a subscript after at most two letters: ``control_unit.gain`` is a key of the spec, not a symbol."""
DOWN, UP = "\u2062", "\u2063"
"""Zero-width marks before and after a subscript in a plot; ``printable`` escapes them in texts of a user."""


def split(text: str, ours: bool = True) -> list[tuple[str, bool]]:
    """Pieces of a text, each with True if it is a subscript; a quotation (``ours`` is False) stays as printed.

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


def marked(text: str) -> str:
    """Text with marks around its subscripts, for matplotlib, which measures the text, and for ``lowered``.

    >>> marked("K_т") == f"K{DOWN}T{UP}"
    True
    """
    return "".join(f"{DOWN}{piece}{UP}" if low else printable(piece) for piece, low in split(text))


def lowered(content: str) -> str:
    """Content of an SVG text with its marked subscripts set lower and smaller.

    >>> lowered("F"), lowered(marked("K_т"))
    ('F', '<tspan>K</tspan><tspan dy=".18em" font-size="70%">T</tspan><tspan dy="-.126em"></tspan>')
    """
    if DOWN not in content:
        return content
    below, above = '</tspan><tspan dy=".18em" font-size="70%">', '</tspan><tspan dy="-.126em">'
    return f"<tspan>{content.replace(DOWN, below).replace(UP, above)}</tspan>"
