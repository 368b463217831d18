"""The papers' symbols, written ``K_т`` in the results, set with real subscripts."""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

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


_LATIN = {
    "н": "n", "т": "T", "п": "sp", "ш": "ball", "ц": "c", "д": "dyn", "в": "sh", "р": "s", "cp": "mean", "ср": "pub",
    "муф": "c", "маш": "m", "дв": "mot", "пуск": "st", "тр": "fr", "зад": "req", "ном": "nom",
}  # fmt: skip
"""Letters of an index of the papers → Latin ones, of the English word that they stand for."""
_LATIN_OF = {
    "F_п": "cl", "T_п": "pot", "K_п": "n", "m_п": "st", "T_муф": "exp", "T_маш": "mach",
    "σ_т": "y", "τ_т": "y",
}  # fmt: skip
"""The same of a symbol in which they stand for another word."""

_OURS = {
    "T_ср": "T_ср", "T_сраб": "T_ср", "C_экв": "C_eff", "наст": "set", "ср": "cp", "экв": "eq", "равн": "eq",
    "действ": "act", "ожид": "exp", "доп": "allow", "верх": "high", "ниж": "low", "пред": "lim", "опт": "opt",
    "пик": "peak", "обр": "ret", "пор": "thr", "ст": "st", "сер": "mid", "треб": "req", "баз": "base", "косв": "ind",
    "диф": "diff", "вед": "all",
}  # fmt: skip
"""Symbols and words of indices that Russian sentences write → the same in ours."""
_RUSSIAN = re.compile(rf"(?<![а-яё])(?:{'|'.join(_OURS)})(?![а-яё])")

_as_latin: ContextVar[dict[str, str] | None] = ContextVar("as_latin", default=None)


@contextmanager
def latin_symbols(asked: bool = True) -> Iterator[dict[str, str]]:
    """Set indices of symbols in Latin letters in the block; give those that were, and what the papers write."""
    record: dict[str, str] = {}
    before = _as_latin.set(record if asked else None)
    try:
        yield record
    finally:
        _as_latin.reset(before)


def latin(symbol: str) -> str:
    """Set the index of a symbol of the papers in Latin letters.

    >>> latin("T_н.маш"), latin("K_т,act"), latin("F_п"), latin("F_п2"), latin("f_1cp"), latin("T'_п")
    ('T_n,m', 'K_T,act', 'F_cl', 'F_sp2', 'f_1mean', "T'_pot")
    """
    letter, _, index = symbol.partition("_")
    first, *others = re.split("[.,]", index)
    own = _LATIN_OF.get(f"{letter.rstrip(chr(39))}_{first}")
    parts = [own or _INDEX_WORD.sub(_latin_word, first), *(_INDEX_WORD.sub(_latin_word, part) for part in others)]
    return f"{letter}_{','.join(parts)}"


def _latin_word(word: re.Match[str]) -> str:
    return _LATIN.get(word[0], word[0])


_INDEX_WORD = re.compile(r"[а-яё]+|(?<![^\W\d_])cp(?![^\W\d_])")


def _recorded(symbol: re.Match[str]) -> str:
    ours = symbol[0] if spoken() == "en" else _RUSSIAN.sub(lambda word: _OURS[word[0]], symbol[0])
    set_so = latin(ours)
    if set_so != ours and (record := _as_latin.get()) is not None:
        record[set_so] = ours
    return set_so


def native(text: str) -> str:
    """Set symbols as people of the user's language write them: ``f_наст`` for ``f_set``, ``tg α`` for ``tan α``.

    What is quoted, in «», stays as it is printed.
    """
    if _as_latin.get() is not None:
        text = _INDEXED.sub(_recorded, text)
    if spoken() == "en":
        return text
    return "".join(part if part[:1] == "«" else _SYMBOL.sub(_native, part) for part in _QUOTED.split(text))


def _native(symbol: re.Match[str]) -> str:
    if _as_latin.get() is not None and ("_" in symbol[0] or symbol[0] == "opt"):
        return symbol[0]
    whole = translate(symbol[0], "symbol")
    return whole if whole != symbol[0] else _WORD.sub(lambda word: translate(word[0], "symbol"), whole)


_QUOTED = re.compile("(«[^»]*»)")
_SYMBOL = re.compile(
    r"\b\w+ wanted|(?<=\)_)opt\b| or (?=κ)|"
    r"(?<![^\W_])(?:[^\W\d_]{1,2}'?_[^\W_]+(?:[.,][^\W_]+)*|(?:arc)?tanh?|cot)(?![^\W_])"
)
_INDEXED = re.compile(r"(?<![^\W_])[^\W\d_]{1,2}'?_[^\W_]+(?:[.,][^\W_]+)*")
_WORD = re.compile(r"[^\W\d_]{2,}")


def native_latex(latex: str) -> str:
    """Set the symbols of LaTeX of ours in the same way."""
    if spoken() == "en" and _as_latin.get() is None:
        return latex
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
