"""What a recomputed claim comes to."""

from collections.abc import Callable
from typing import Literal, NamedTuple

Verdict = Literal["reproduced", "reproduced with correction", "not reproduced", "undecided"]


class Found(NamedTuple):
    """One claim recomputed: the numbers in words, the verdict, computed over printed less 1."""

    computed: str
    verdict: Verdict
    deviation: float | None = None


def verdict(as_printed: bool, corrected: bool = False) -> Verdict:
    """Judge a row: it follows from the inputs as printed, or with the correction, or not at all."""
    if as_printed:
        return "reproduced"
    return "reproduced with correction" if corrected else "not reproduced"


def near(computed: float, printed: float, digits: float) -> bool:
    """Whether a computed number rounds to the printed one: ``digits`` is a unit in its last place."""
    return abs(computed - printed) <= digits


def bisect(function: Callable[[float], float], low: float, high: float) -> float:
    """Return where a falling function crosses zero."""
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if function(middle) > 0 else (low, middle)
    return low
