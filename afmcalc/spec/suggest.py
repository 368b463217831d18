"""Did you mean …?"""

from collections.abc import Iterable

from ..messages import say

_LONGEST = 60
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
    if word in known or len(word) > _LONGEST:
        return ""
    if plain(word) in known:
        return in_latin(word)
    from difflib import get_close_matches

    lower = {candidate.casefold(): candidate for candidate in reversed(known)}
    near = get_close_matches(plain(word).casefold(), lower, n=1, cutoff=0.6)
    return say("; did you mean {near!r}?", near=lower[near[0]]) if near else ""
