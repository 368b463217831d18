"""A small curve of characters, under a sweep in the terminal."""

from collections.abc import Sequence

from ...messages import told
from ..canvas import Trace, bounds, drawn
from ..layout import TextTable
from ..units import significant

SIZE = WIDTH, HEIGHT = 52, 8


def curve(x: Sequence[float], y: Sequence[float | None], title: str, *, unicode: bool) -> list[str]:
    """Draw y over x as lines of text, with the ends of both axes named.

    Args:
        x: abscissae in any order.
        y: ordinates, as many; None where there is none.
        title: what is drawn.
        unicode: False for a terminal that shows ASCII only.

    Returns:
        The lines, without line ends.
    """
    trace = Trace("•" if unicode else "*", [(a, b) for a, b in zip(x, y, strict=True) if b is not None])
    if not trace.points:
        return [told("{title}: no values to draw", title=title)]
    (left, right), (bottom, top) = ([significant(end) for end in ends] for ends in bounds([trace]))
    beside = {0: top} | ({HEIGHT - 1: bottom} if bottom != top else {})
    return [title, *drawn([trace], SIZE, beside, {0: left, WIDTH - 1: right}, unicode=unicode)]


def curve_lines(block: TextTable, unicode: bool, width: int | None = None) -> list[str]:
    """Draw the first answer of a sweep along one axis; nothing for any other table."""
    if block.source is None or block.source.axes != 1:
        return []
    x, y = block.source.columns[:2]
    if len(x.values) < 3:
        return []
    return ["", *curve(x.values, y.values, told("{y} against {x}", y=y.symbol, x=x.symbol), unicode=unicode)]
