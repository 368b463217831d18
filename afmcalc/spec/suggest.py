"""Did you mean …?"""

from collections.abc import Iterable

from ..messages import say


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """Return ``"; did you mean 'x'?"`` for the nearest known word, or nothing when none is near.

    >>> did_you_mean("frction", ["friction", "drive"])
    "; did you mean 'friction'?"
    """
    from difflib import get_close_matches

    known = list(known)
    if word in known:
        return ""
    lower = {candidate.casefold(): candidate for candidate in reversed(known)}
    near = get_close_matches(word.casefold(), lower, n=1, cutoff=0.6)
    return say("; did you mean {near!r}?", near=lower[near[0]]) if near else ""
