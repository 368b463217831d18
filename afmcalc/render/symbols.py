"""The papers' symbols, written ``K_т`` in the results, set with real subscripts."""

import re

from ..messages import native, printable, spoken, translate

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


def native_latex(latex: str) -> str:
    """Set the symbols of LaTeX of ours in the same way."""
    latex = _INDEX.sub(_native_index, latex)
    return _TAN.sub(lambda match: f"\\operatorname{{{translate(match[1], 'symbol')}}}", latex)


def _native_index(indexed: re.Match[str]) -> str:
    letter = {"sigma": "σ", "tau": "τ", "beta": "β"}.get(indexed[2] or "", indexed[3] or "x")
    return f"{indexed[1]}_{{\\text{{{native(f'{letter}_{indexed[4]}').partition('_')[2]}}}}}"


_INDEX = re.compile(r"((?:\\([a-z]+)|([A-Za-z]))? ?(?:\^\{\\prime\})?)_\{\\text\{([^}]*)\}\}")
_TAN = re.compile(r"\\(tan|cot|arctan)\b")


def mathtext(text: str) -> str:
    """Set a text of our own (labels, symbols) for matplotlib.

    >>> mathtext("K_т")
    'K$_{\\\\mathregular{T}}$'
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
    mantissa = mantissa.replace(",", "{,}").replace("−", "-").replace("\xa0", "\\,")
    shown = f"{mantissa} \\cdot 10^{{{int(exponent)}}}" if exponent else mantissa
    return f"{shown}\\,\\text{{{unit}}}" if unit else shown


_POWER = re.compile("(?:(.+)·)?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)")
_LOWERED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def latex_in_numbers(latex: str) -> str:
    """Return LaTeX of ours with its numbers and units as people of the user's language write them."""
    if spoken() == "en":
        return native_latex(latex)
    # a unit follows its number after a gap; an index does not
    latex = re.sub(r"\\,\\text\{([^}]*)\}", lambda match: f"\\,\\text{{{translate(match[1], 'unit')}}}", latex)
    return native_latex(re.sub(r"(?<=\d)\.(?=\d)", "{,}", latex))
