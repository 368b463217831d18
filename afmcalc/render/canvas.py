"""Curves set in characters: under a sweep in the terminal, and where a plot is asked for without a file."""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

Ends = tuple[float, float]


class Trace(NamedTuple):
    """The points of one curve, its mark, and whether they are joined."""

    mark: str
    points: Sequence[tuple[float, float]]
    joined: bool = False


def bounds(traces: Sequence[Trace]) -> tuple[Ends, Ends]:
    """Return the smallest and largest abscissa, and ordinate, of all points."""
    x, y = ([point[axis] for trace in traces for point in trace.points] for axis in (0, 1))
    return (min(x), max(x)), (min(y), max(y))


def place(value: float, ends: Ends, cells: int) -> int:
    """Return the cell of a value on an axis of that many cells."""
    low, high = ends
    if high == low:
        return cells // 2
    # halved before the difference, so that ends of opposite sign near the largest float do not overflow
    share = (value / 2 - low / 2) / (high / 2 - low / 2)
    return min(cells - 1, round(share * (cells - 1)))


def ticks(ends: Ends, most: int) -> list[float]:
    """Return round values within an axis, as many as fit: steps of 1, 2 or 5 times a power of ten.

    >>> ticks((0.1, 0.8), 4), ticks((3.0, 3.0), 4)
    ([0.2, 0.4, 0.6, 0.8], [3.0])
    """
    low, high = ends
    if not 0 < high - low < math.inf:
        return [low]
    power = 10.0 ** math.floor(math.log10((high - low) / most))
    step = next(step for step in (power, 2 * power, 5 * power, 10 * power) if (high - low) / step <= most)
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [float(f"{count * step:.12g}") for count in range(first, last + 1)]


def drawn(
    traces: Sequence[Trace],
    size: tuple[int, int],
    beside: Mapping[int, str],
    below: Mapping[int, str],
    *,
    unicode: bool,
    notch: bool = False,
) -> list[str]:
    """Draw traces in a frame.

    Args:
        traces: the curves; a later one covers an earlier.
        size: columns and rows.
        beside: row → text left of it, rows counted from the top.
        below: column → text below it.
        unicode: False for a terminal that shows ASCII only.
        notch: whether rows and columns with a text are marked in the frame.

    Returns:
        The lines, without line ends.
    """
    width, height = size
    x, y = bounds(traces)
    cells = [[" "] * width for _ in range(height)]
    for trace in traces:
        spots = [(place(a, x, width), height - 1 - place(b, y, height)) for a, b in trace.points]
        for column, row in _line(spots) if trace.joined else spots:
            cells[row][column] = trace.mark
    side, corner, floor, left, foot = "│└─┤┬" if unicode else "|+-++"
    margin = max(map(len, beside.values()))
    lines = [
        f"{beside.get(number, ''):>{margin}} {left if notch and number in beside else side}{''.join(row)}".rstrip()
        for number, row in enumerate(cells)
    ]
    base = "".join(foot if notch and column in below else floor for column in range(width))
    return [*lines, f"{'':{margin}} {corner}{base}", f"{'':{margin}}  {_spread(below, width)}"]


def _line(spots: Sequence[tuple[int, int]]) -> list[tuple[int, int]]:
    """Return every cell on the way from spot to spot."""
    found = list(spots[:1])
    for (a, b), (c, d) in zip(spots, spots[1:], strict=False):
        steps = max(abs(c - a), abs(d - b))
        found += [(a + round((c - a) * n / steps), b + round((d - b) * n / steps)) for n in range(1, steps + 1)]
    return found


def _spread(texts: Mapping[int, str], width: int) -> str:
    """Set texts in one line, each about its column; one without room is left out."""
    line = ""
    for column, text in texts.items():
        start = max(0, min(column - len(text) // 2, width - len(text)))
        if not line or start > len(line):
            line = line.ljust(start) + text
    return line
