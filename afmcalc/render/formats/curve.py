"""A small curve of characters, under a sweep in the terminal."""

from collections.abc import Sequence

from ..units import significant

HEIGHT, WIDTH = 8, 52


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
    drawn = [(a, b) for a, b in zip(x, y, strict=True) if b is not None]
    if not drawn:
        return [f"{title}: no values to draw"]
    xs, ys = [a for a, _ in drawn], [b for _, b in drawn]
    low_x, high_x, low_y, high_y = min(xs), max(xs), min(ys), max(ys)
    cells = [[" "] * WIDTH for _ in range(HEIGHT)]
    mark = "•" if unicode else "*"
    for a, b in drawn:
        column = _place(a, low_x, high_x, WIDTH)
        row = HEIGHT - 1 - _place(b, low_y, high_y, HEIGHT)
        cells[row][column] = mark
    top, bottom = significant(high_y), significant(low_y)
    margin = max(len(top), len(bottom))
    side, corner, floor = ("│", "└", "─") if unicode else ("|", "+", "-")
    lines = [title]
    for number, cell in enumerate(cells):
        label = top if number == 0 else bottom if number == HEIGHT - 1 and bottom != top else ""
        lines.append(f"{label:>{margin}} {side}{''.join(cell)}".rstrip())
    left, right = significant(low_x), significant(high_x)
    lines.append(" " * (margin + 1) + corner + floor * WIDTH)
    lines.append(" " * (margin + 2) + left + right.rjust(WIDTH - len(left)))
    return lines


def _place(value: float, low: float, high: float, cells: int) -> int:
    """Cell of a value on an axis of that many cells."""
    if high == low:
        return cells // 2
    # halved before the difference, so that ends of opposite sign near the largest float do not overflow
    share = (value / 2 - low / 2) / (high / 2 - low / 2)
    return min(cells - 1, round(share * (cells - 1)))
