"""The papers' symbols, written ``K_т`` in the results, set with real subscripts."""

import re

from ..messages import printable, spoken, translate

_SUBSCRIPT = re.compile(r"(?<![^\W_]{3})_([^\W_²³⁶]+(?:[.,][^\W_²³⁶]+)*)")
"""A symbol has a letter or two before its subscript: ``control_unit.gain`` is a key."""


def split(text: str) -> list[tuple[str, bool]]:
    """Split a text into pieces and whether each is a subscript.

    >>> split("ΔT_2/ΔT_1")
    [('ΔT', False), ('2', True), ('/ΔT', False), ('1', True)]
    >>> split("T_н.муф, K_т,p")
    [('T', False), ('н.муф', True), (', K', False), ('т,p', True)]
    >>> split("ν_1²")
    [('ν', False), ('1', True), ('²', False)]
    >>> split("control_unit.gain")
    [('control_unit.gain', False)]
    """
    pieces = _SUBSCRIPT.split(text)
    return [(piece, bool(number % 2)) for number, piece in enumerate(pieces) if piece]


def mathtext(text: str) -> str:
    """Set a text of our own (labels, symbols) for matplotlib.

    >>> mathtext("K_т")
    'K$_{\\\\mathregular{т}}$'
    """
    return "".join(f"$_{{\\mathregular{{{piece}}}}}$" if low else literal(piece) for piece, low in split(text))


def literal(text: str) -> str:
    """Keep matplotlib from reading anything into a text of the user's (the name of a spec), or hiding it (``_x``)."""
    shown = printable(text)
    return (f" {shown}" if shown.startswith("_") else shown).replace("$", r"\$")


def value_latex(text: str) -> str:
    """Return a value as shown to people, such as ``1.2e+07 N·m``, in LaTeX."""
    number, _, unit = re.sub("(?<! )°", " °", text).partition(" ")
    mantissa, _, exponent = number.partition("e")
    if power := _POWER.fullmatch(number):
        mantissa, exponent = power[1] or "1", power[2].translate(_LOWERED)
    mantissa = mantissa.replace(",", "{,}")
    shown = f"{mantissa} \\cdot 10^{{{int(exponent)}}}" if exponent else mantissa
    return f"{shown}\\,\\text{{{unit}}}" if unit else shown


_POWER = re.compile("(?:(.+)·)?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)")
_LOWERED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def latex_in_numbers(latex: str) -> str:
    """Return LaTeX of ours with its numbers and units as people of the user's language write them."""
    if spoken() == "en":
        return latex
    # a unit follows its number after a gap; an index does not
    latex = re.sub(r"\\,\\text\{([^}]*)\}", lambda match: f"\\,\\text{{{translate(match[1], 'unit')}}}", latex)
    return re.sub(r"(?<=\d)\.(?=\d)", "{,}", latex)
