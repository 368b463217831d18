"""The papers' symbols, written ``K_т`` in the results, set with real subscripts."""

import re

from ..messages import printable, spoken, translate

_SUBSCRIPT = re.compile(r"(?<![^\W_]{3})_([^\W_²³⁶]+(?:[.,][^\W_²³⁶]+)*)")
"""A symbol has a letter or two before its subscript: ``control_unit.gain`` is a key."""


def split(text: str, ours: bool = True) -> list[tuple[str, bool]]:
    """Split a text into pieces and whether each is a subscript; what is quoted is not ours and stays as it is.

    >>> split("ΔT_2/ΔT_1")
    [('ΔT', False), ('2', True), ('/ΔT', False), ('1', True)]
    >>> split("T_н.муф, K_т,p")
    [('T', False), ('н.муф', True), (', K', False), ('т,p', True)]
    >>> split("ν_1²")
    [('ν', False), ('1', True), ('²', False)]
    >>> split("control_unit.gain")
    [('control_unit.gain', False)]
    """
    pieces = _SUBSCRIPT.split(native(text) if ours else text)
    return [(piece, bool(number % 2)) for number, piece in enumerate(pieces) if piece]


def native(text: str) -> str:
    """Set symbols as people of the user's language write them: ``f_наст`` for ``f_set``, ``tg α`` for ``tan α``.

    What is quoted, in «», stays as it is printed.
    """
    if spoken() == "en":
        return text
    return "".join(part if part[:1] == "«" else _SYMBOL.sub(_native, part) for part in _QUOTED.split(text))


def _native(symbol: re.Match[str]) -> str:
    whole = translate(symbol[0], "symbol")
    return whole if whole != symbol[0] else _WORD.sub(lambda word: translate(word[0], "symbol"), whole)


_QUOTED = re.compile("(«[^»]*»)")
_SYMBOL = re.compile(
    r"\b\w+ wanted|(?<![^\W_])(?:[^\W\d_]{1,2}'?_[^\W_]+(?:[.,][^\W_]+)*|(?:arc)?tanh?|cot)(?![^\W_])| or (?=κ)"
)
_WORD = re.compile(r"[^\W\d_]{2,}")


def native_latex(latex: str) -> str:
    """Set the symbols of LaTeX of ours in the same way."""
    if spoken() == "en":
        return latex
    latex = _INDEX.sub(_native_index, latex)
    return _TAN.sub(lambda match: f"\\operatorname{{{translate(match[1], 'symbol')}}}", latex)


def _native_index(indexed: re.Match[str]) -> str:
    letter = "τ" if "tau" in indexed[1] else indexed[1] if indexed[1].isalpha() else "x"
    return f"{indexed[1]}_{{\\text{{{native(f'{letter}_{indexed[2]}').partition('_')[2]}}}}}"


_INDEX = re.compile(r"(\\tau ?|[\w}])_\{\\text\{([^}]*)\}\}")
_TAN = re.compile(r"\\(tan|cot|arctan)\b")


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
    mantissa = mantissa.replace(",", "{,}").replace("−", "-").replace("\xa0", "\\,")
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
    return native_latex(re.sub(r"(?<=\d)\.(?=\d)", "{,}", latex))
