"""Letters that look alike, and texts for streams that lack some: did you mean …?; ``T_н`` becomes T_n, no escape."""

import codecs
import re
from collections.abc import Iterable

from .messages import say

NAME = "afmcalc.spelled"
"""Of the error handler, for streams."""

_CYRILLIC = {
    "а": "a", "б": "b", "в": "v", "г": "g", "д": "d", "е": "e", "ё": "e", "ж": "zh", "з": "z", "и": "i", "й": "y",
    "к": "k", "л": "l", "м": "m", "н": "n", "о": "o", "п": "p", "р": "r", "с": "s", "т": "t", "у": "u", "ф": "f",
    "х": "kh", "ц": "ts", "ч": "ch", "ш": "sh", "щ": "shch", "ъ": "'", "ы": "y", "ь": "'", "э": "e", "ю": "yu",
    "я": "ya",
}  # fmt: skip
_GREEK = {
    "α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "ε": "eps", "ζ": "zeta", "η": "eta", "θ": "theta",
    "ι": "iota", "κ": "kappa", "λ": "lambda", "μ": "mu", "ν": "nu", "ξ": "xi", "ο": "o", "π": "pi", "ρ": "rho",
    "σ": "sigma", "ς": "s", "τ": "tau", "υ": "upsilon", "φ": "phi", "χ": "chi", "ψ": "psi", "ω": "omega",
    "ϑ": "theta", "ϕ": "phi",
}  # fmt: skip
_SIGNS = {
    "–": "-", "—": "-", "−": "-", "…": "...", "·": "*", "•": "*", "×": "x", "≤": "<=", "≥": ">=", "≈": "~", "≠": "!=",
    "±": "+-", "°": "deg", "√": "sqrt", "∞": "inf", "→": "->", "∂": "d", "∝": "~", "₊": "+",
    "₋": "-", "′": "'", "‘": "'", "’": "'", "“": '"', "”": '"', "«": '"', "»": '"', "\u00a0": " ", "\u2009": " ",
}  # fmt: skip
_LETTERS = _CYRILLIC | _GREEK
_SPELLED = _LETTERS | {letter.upper(): spelled.capitalize() for letter, spelled in _LETTERS.items()} | _SIGNS
# a difference, not a letter: ΔT is dT, as --sweep calls it
_SPELLED["Δ"] = "d"
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_POWER = re.compile("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+")
_OF_A_SPRING = re.compile(r"(?<=[_,])п(?![^\W\d_])")
"""The index of a spring: F_п is F_sp, for F_p is the release force."""


def _spelled(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    lacking = "".join(
        "sp" if _OF_A_SPRING.match(error.object, at) else error.object[at] for at in range(error.start, error.end)
    )
    lacking = _POWER.sub(lambda power: f"^{power[0].translate(_RAISED)}", lacking)
    return "".join(
        sign if sign.isascii() else _SPELLED.get(sign) or sign.encode("ascii", "backslashreplace").decode()
        for sign in lacking
    ), error.end


codecs.register_error(NAME, _spelled)


def fitting(text: str, encoding: str) -> str:
    """Return a text as a stream of an encoding shows it.

    >>> fitting("ΔT = 10⁻³ T_н, °C", "ascii"), fitting("T_н", "koi8-r"), fitting("漢", "ascii")
    ('dT = 10^-3 T_n, degC', 'T_н', '\\\\u6f22')
    >>> fitting("F_п1, K_т,п, F_p, T_пр", "ascii")
    'F_sp1, K_t,sp, F_p, T_pr'
    """
    return text.encode(encoding, NAME).decode(encoding)


_LONGEST_WORD = 60
"""Letters of a word that is worth comparing."""

_LATIN = str.maketrans(
    dict(zip("АВЕКМНОРСТХавекмнорстхпдш", "ABEKMHOPCTXabekmnopctxpds", strict=True))
    | {"α": "alpha", "β": "beta", "ν": "nu", "τ": "tau", "Δ": "d"}
)
"""Letters that are taken for Latin ones, or stand for them in the symbols of the papers → these."""


def plain(name: str) -> str:
    """Return a name in Latin letters, however its letters were typed.

    >>> plain("К_т"), plain("ΔT")
    ('K_t', 'dT')
    """
    return name.translate(_LATIN)


def in_latin(word: str) -> str:
    """Return ``"; did you mean 'x'?"`` for a word that looks as if it were Latin, or nothing.

    >>> in_latin("gаin")
    "; did you mean 'gain' (all Latin)?"
    """
    latin = plain(word)
    return say("; did you mean {latin!r} (all Latin)?", latin=latin) if latin.isascii() and latin != word else ""


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """Return ``"; did you mean 'x'?"`` for the nearest known word, or nothing when none is near.

    >>> did_you_mean("frction", ["friction", "drive"])
    "; did you mean 'friction'?"
    """
    known = list(known)
    if word in known or len(word) > _LONGEST_WORD:
        return ""
    if plain(word) in known:
        return in_latin(word)
    from difflib import get_close_matches

    lower = {candidate.casefold(): candidate for candidate in reversed(known)}
    near = get_close_matches(plain(word).casefold(), lower, n=1, cutoff=0.6)
    return say("; did you mean {near!r}?", near=lower[near[0]]) if near else ""
