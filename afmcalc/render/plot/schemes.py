"""The papers' schemes, drawn anew: clutches in half section with the numbers of their parts, and a ball in pockets."""

import math
from collections.abc import Callable
from typing import NamedTuple

from ...messages import translate
from .. import drawing as draw
from .chart import Sheet

_HATCH = {"body": (45.0,), "drum": (135.0,), "moving": (90.0,), "bearing": (45.0, 135.0)}
"""Kind of a part → angles of its hatches."""
_FILLED = {"disc": "discs", "key": "bypass"}
_TURNS = 4


class Part(NamedTuple):
    """One part of a clutch in half section; the axis of the clutch is below."""

    boxes: tuple[draw.Rectangle, ...]
    at: draw.Point | None
    """Position of the number, its place among the parts; None if the part has no number in the paper."""
    kind: str = "body"
    """One of ``_HATCH``, else ``disc``, ``spring``, ``ball`` or ``key``."""


def _half_section(parts: tuple[Part, ...], length: float, top: float) -> draw.Drawing:
    """Draw a clutch in half section over an axis of the given length."""
    size = draw.TEXT * length / draw.WIDTH
    shapes: list[draw.Shape] = [draw.Stroke("centre", ((0.0, 0.0), (length, 0.0)))]
    for number, part in enumerate(parts, 1):
        shapes += (shape for box in part.boxes for shape in _shapes(part.kind, box))
        if part.at:
            tip, (x, y) = draw.middle(part.boxes[0]), part.at
            below = y - 0.5 * size if y > tip[1] else y + size
            shapes += [draw.Stroke("dimensions", (tip, (x, below))), draw.Circle("dimensions", tip, 0.15 * size)]
            shapes.append(draw.Inscription(str(number), (x, y - 0.35 * size), size, "middle"))
    return draw.Drawing(shapes, (0.0, -0.5, length, top))


def _shapes(kind: str, box: draw.Rectangle) -> draw.Shapes:
    left, right, low, high = box
    if kind == "ball":
        yield draw.Circle("balls", draw.middle(box), (high - low) / 2)
    elif kind == "spring":
        step = (right - left) / (2 * _TURNS)
        points = ((left + step * turn, low if turn % 2 else high) for turn in range(2 * _TURNS + 1))
        yield draw.Stroke("springs", tuple(points))
    elif kind in _FILLED:
        yield draw.rectangle(_FILLED[kind], box)
    else:
        yield from (draw.rectangle("hatch", box, hatch=angle) for angle in _HATCH[kind])
        yield draw.rectangle("outline", box)


def _discs(first: float, count: int, inner: float, outer: float) -> tuple[draw.Rectangle, ...]:
    """Friction discs of one kind, outer or inner, which take every second place in a pack."""
    places = (first + 0.5 * number for number in range(count))
    return tuple((left, left + 0.18, inner, outer) for left in places)


_HALVES = (
    Part(((2.1, 12.6, 0.35, 0.95), (10.7, 11.1, 0.95, 3.0)), (12.3, 1.6)),
    Part(((1.2, 1.6, 0.35, 4.75), (1.6, 7.3, 4.5, 4.75)), (0.6, 3.9), "drum"),
)
"""The half-couplings of a direct clutch."""


def _beside(*more: draw.Rectangle) -> tuple[Part, ...]:
    """Pressure disc, ball, thrust disc with boxes ``more``, spring and thrust bearing of a direct clutch."""
    return (
        Part(((6.3, 7.0, 1.1, 4.2), (3.45, 6.3, 1.1, 1.65)), (6.9, 5.5), "moving"),
        Part(((2.68, 3.42, 1.0, 1.74),), (1.9, 2.2), "ball"),
        Part(((2.4, 2.85, 1.75, 4.2), (2.4, 2.68, 0.95, 1.75), *more), (2.3, 5.5)),
        Part(((7.4, 10.7, 1.9, 2.9),), (9.0, 3.7), "spring"),
        Part(((7.0, 7.4, 1.7, 3.1),), (8.4, 4.6), "bearing"),
    )


_F11 = (
    *_HALVES,
    Part(_discs(3.25, 2, 1.95, 4.0), (3.1, 5.5), "disc"),
    Part(_discs(3.5, 2, 2.4, 4.5), (3.9, 5.5), "disc"),
    Part(_discs(4.5, 3, 1.7, 4.0), (4.9, 5.5), "disc"),
    Part(_discs(4.75, 3, 2.4, 4.5), (5.9, 5.5), "disc"),
    *_beside((2.85, 4.2, 1.78, 1.92)),
)
_S19 = (
    *_HALVES,
    Part(_discs(3.3, 6, 1.7, 4.0), (4.4, 5.5), "disc"),
    Part(_discs(3.05, 6, 2.4, 4.5), (3.2, 5.5), "disc"),
    *_beside(),
)
_S21 = (
    Part(((2.1, 13.6, 0.35, 0.95), (2.4, 2.8, 0.95, 4.2), (12.0, 12.4, 0.95, 3.0)), (13.2, 1.6)),
    Part(((1.2, 1.6, 0.35, 4.75), (1.6, 6.5, 4.5, 4.75)), (0.6, 3.9), "drum"),
    Part(_discs(3.3, 5, 2.6, 4.5), (3.5, 5.5), "disc"),
    Part(_discs(3.55, 4, 2.2, 4.0), (4.6, 5.5), "disc"),
    Part(((5.55, 6.0, 1.95, 4.2), (3.3, 5.55, 1.95, 2.2)), (6.6, 5.2), "moving"),
    Part(((3.1, 7.35, 1.1, 1.7),), (1.9, 2.3)),
    Part(((4.6, 5.4, 1.6, 1.95),), (3.0, 5.5), "key"),
    Part(((7.13, 7.87, 1.03, 1.77),), (7.0, 2.3), "ball"),
    Part(((8.8, 9.2, 1.1, 3.9), (7.65, 9.9, 1.1, 1.7)), (9.6, 4.4), "moving"),
    Part(((6.0, 8.8, 2.55, 2.8),), (8.0, 4.6), "moving"),
    Part(((9.2, 12.0, 1.9, 2.8),), (10.8, 3.6), "spring"),
    Part(((8.9, 9.8, 0.85, 1.15),), (10.4, 1.4), "key"),
    Part(((6.0, 8.8, 3.0, 3.8),), (7.2, 4.9), "spring"),
    Part(((2.8, 3.1, 1.1, 4.1),), None, "bearing"),
)


def _ball_in_pockets() -> draw.Drawing:
    """Draw a ball of the radius 1 between two sleeves, with the points of S21 fig. 3."""
    angle, gap, floor = math.radians(38), 0.13, 1.1
    sine, cosine = math.sin(angle), math.cos(angle)
    apex, size = 1 / sine, draw.TEXT * 6.8 / draw.WIDTH
    shapes: list[draw.Shape] = []
    wall = [(x, (apex - x) * math.tan(angle)) for x in (gap, floor)]
    half = [(2.5, 1.9), (gap, 1.9), *wall]
    for hand, hatch in ((-1, 45.0), (1, 135.0)):
        outline = tuple((hand * x, y) for x, y in (*half, *((x, -y) for x, y in reversed(half))))
        shapes += [draw.Region("hatch", (outline,), hatch=hatch), draw.Region("outline", (outline,))]
    shapes += [draw.Circle("balls", (0.0, 0.0), 1.0), draw.Stroke("centre", ((-2.6, 0.0), (2.6, 0.0)))]
    points = {"O": (0.0, 0.0), "A": (0.0, 1 / cosine), "B": (sine, cosine), "C": (apex, 0.0), "D": (sine, 0.0)}
    shapes += [draw.Stroke("contact", (points[first], points[second])) for first, second in ("OA", "AC", "OB", "BD")]
    for name, (x, y) in points.items():
        at = x + (0.14 if name == "B" else 0.0), y + (-0.26 if y == 0 else 0.1)
        shapes += [draw.Circle("dimensions", (x, y), 0.03), draw.Inscription(name, at, size, "middle")]
    shapes += [
        draw.Angle("", size, (apex, 0.0), (sine, cosine), (0.0, 0.0), 0.55),
        draw.Inscription("α", (apex - 0.68, 0.12), size, "middle"),
        draw.Inscription("r_ш", (sine / 2 - 0.05, cosine / 2 + 0.1), size, "end"),
        draw.Inscription("s", (0.0, -1.95), size, "middle"),
        draw.Length("h_1", size, (gap, -1.9), (apex, 0.0), -1.75),
    ]
    return draw.Drawing(shapes, (-3.4, -2.15, 3.4, 2.15))


def _scheme(title: str, caption: str, drawing: draw.Drawing) -> Callable[[], Sheet]:
    return lambda: Sheet(translate(title), [drawing], translate(caption))


SCHEMES: dict[str, Callable[[], Sheet]] = {
    "F11-1": _scheme(
        "Clutch with bypass and controlled pairs (after F11 fig. 1)",
        "1, 2 half-couplings; 3, 4 discs of the bypass group; 5, 6 discs of the controlled group; 7 pressure disc; "
        "8 balls in pockets; 9 thrust disc; 10 spring; 11 thrust bearing.",
        _half_section(_F11, 13, 6),
    ),
    "S19-1": _scheme(
        "Clutch with one bypass pair (after S19 fig. 1)",
        "1, 2 half-couplings; 3, 4 discs; 5 pressure disc; 6 balls in pockets; 7 thrust disc, which the first disc 4 "
        "touches; 8 spring; 9 thrust bearing.",
        _half_section(_S19, 13, 6),
    ),
    "S21-1": _scheme(
        "Clutch with indirect regulation (after S21 fig. 1)",
        "1, 2 half-couplings; 3, 4 discs; 5 pressure disc; 6 sleeve; 7, 12 keys; 8 balls in pockets; 9 thrust sleeve; "
        "10 stop; 11 control spring; 13 closing spring; thrust bearings without a number.",
        _half_section(_S21, 14, 6),
    ),
    "S21-3": _scheme(
        "Ball in its pockets (after S21 fig. 3)",
        "O centre of the ball, B where it touches the wall, C where the walls would meet; OA = r_ш/cos α, "
        "OC = r_ш/sin α, OD = r_ш sin α.",
        _ball_in_pockets(),
    ),
}
"""Name of a figure of the papers → the drawing."""
