"""The papers' schemes, drawn anew: the clutches in half section with their numbers, and a ball in its pockets."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

from ...messages import translate
from ..symbols import mathtext
from .chart import Sheet
from .paint import COLOURS, INK, SHADE, WIDTH

Box = tuple[float, float, float, float]
"""Left, right, lower and upper edge."""


class Part(NamedTuple):
    """One part of a clutch in half section, axis below."""

    number: str
    """As in the paper; empty of a part without one."""
    boxes: tuple[Box, ...]
    at: tuple[float, float]
    """Where its number stands."""
    kind: str = "body"
    """``body``, ``drum``, ``moving``, ``disc``, ``spring``, ``bearing``, ``ball`` or ``key``."""


_STYLE: dict[str, dict[str, Any]] = {
    "body": {"hatch": "////", "edgecolor": INK, "facecolor": "none"},
    "drum": {"hatch": "\\\\\\\\", "edgecolor": SHADE, "facecolor": "none"},
    "moving": {"hatch": "||||", "edgecolor": INK, "facecolor": "none"},
    "disc": {"edgecolor": COLOURS[0], "facecolor": COLOURS[0]},
    "bearing": {"hatch": "xxxx", "edgecolor": INK, "facecolor": "none"},
    "key": {"edgecolor": COLOURS[1], "facecolor": COLOURS[1]},
}
_TURNS = 4


class HalfSection:
    """A clutch in half section."""

    def __init__(self, parts: tuple[Part, ...], length: float, top: float) -> None:
        """Lay out ``parts`` over an axis of a length."""
        self.parts, self.length, self.top = parts, length, top

    @property
    def height(self) -> float:
        """Inches over the width of a sheet."""
        return WIDTH * (self.top + 0.6) / self.length

    def paint(self, axes: Any) -> None:
        """Draw into matplotlib's axes."""
        axes.set_axis_off()
        axes.set_aspect("equal")
        axes.set_xlim(0, self.length)
        axes.set_ylim(-0.5, self.top)
        axes.plot([0, self.length], [0, 0], color=INK, linewidth=0.8, linestyle=(0, (12, 3, 2, 3)))
        for part in self.parts:
            for box in part.boxes:
                _paint(axes, part.kind, box)
            if not part.number:
                continue
            left, right, low, high = part.boxes[0]
            x, y = (left + right) / 2, (low + high) / 2
            style = {"arrowstyle": "-", "color": INK, "linewidth": 0.6, "shrinkA": 1, "shrinkB": 0}
            axes.annotate(part.number, (x, y), part.at, ha="center", va="center", fontsize=10, arrowprops=style)
            axes.plot([x], [y], marker="o", markersize=2.4, color=INK)


def _paint(axes: Any, kind: str, box: Box) -> None:
    from matplotlib.patches import Circle, Rectangle

    left, right, low, high = box
    if kind == "ball":
        middle = (left + right) / 2, (low + high) / 2
        axes.add_patch(Circle(middle, (high - low) / 2, facecolor="none", edgecolor=COLOURS[0], linewidth=1.8))
    elif kind == "spring":
        step = (right - left) / (2 * _TURNS)
        x = [left + step * turn for turn in range(2 * _TURNS + 1)]
        axes.plot(x, [low if turn % 2 else high for turn in range(len(x))], color=COLOURS[1], linewidth=1.6)
    else:
        axes.add_patch(Rectangle((left, low), right - left, high - low, linewidth=1.0, **_STYLE[kind]))


def _discs(first: float, count: int, inner: tuple[float, float], outer: tuple[float, float]) -> tuple[Box, ...]:
    """Discs of a kind, every second place of a pack."""
    places = (first + 0.5 * number for number in range(count))
    return tuple((left, left + 0.18, inner[0], outer[1]) for left in places)


_F11 = (
    Part("1", ((2.1, 12.6, 0.35, 0.95), (10.7, 11.1, 0.95, 3.0)), (12.3, 1.6)),
    Part("2", ((1.2, 1.6, 0.35, 4.75), (1.6, 7.3, 4.5, 4.75)), (0.6, 3.9), "drum"),
    Part("3", _discs(3.25, 2, (1.95, 0), (0, 4.0)), (3.1, 5.5), "disc"),
    Part("4", _discs(3.5, 2, (2.4, 0), (0, 4.5)), (3.9, 5.5), "disc"),
    Part("5", _discs(4.5, 3, (1.7, 0), (0, 4.0)), (4.9, 5.5), "disc"),
    Part("6", _discs(4.75, 3, (2.4, 0), (0, 4.5)), (5.9, 5.5), "disc"),
    Part("7", ((6.3, 7.0, 1.1, 4.2), (3.45, 6.3, 1.1, 1.65)), (6.9, 5.5), "moving"),
    Part("8", ((2.68, 3.42, 1.0, 1.74),), (1.9, 2.2), "ball"),
    Part("9", ((2.4, 2.85, 1.75, 4.2), (2.4, 2.68, 0.95, 1.75), (2.85, 4.2, 1.78, 1.92)), (2.3, 5.5)),
    Part("10", ((7.4, 10.7, 1.9, 2.9),), (9.0, 3.7), "spring"),
    Part("11", ((7.0, 7.4, 1.7, 3.1),), (8.4, 4.6), "bearing"),
)
_S19 = (
    Part("1", ((2.1, 12.6, 0.35, 0.95), (10.7, 11.1, 0.95, 3.0)), (12.3, 1.6)),
    Part("2", ((1.2, 1.6, 0.35, 4.75), (1.6, 7.3, 4.5, 4.75)), (0.6, 3.9), "drum"),
    Part("3", _discs(3.3, 6, (1.7, 0), (0, 4.0)), (4.4, 5.5), "disc"),
    Part("4", _discs(3.05, 6, (2.4, 0), (0, 4.5)), (3.2, 5.5), "disc"),
    Part("5", ((6.3, 7.0, 1.1, 4.2), (3.45, 6.3, 1.1, 1.65)), (6.9, 5.5), "moving"),
    Part("6", ((2.68, 3.42, 1.0, 1.74),), (1.9, 2.2), "ball"),
    Part("7", ((2.4, 2.85, 1.75, 4.2), (2.4, 2.68, 0.95, 1.75)), (2.3, 5.5)),
    Part("8", ((7.4, 10.7, 1.9, 2.9),), (9.0, 3.7), "spring"),
    Part("9", ((7.0, 7.4, 1.7, 3.1),), (8.4, 4.6), "bearing"),
)
_S21 = (
    Part("1", ((2.1, 13.6, 0.35, 0.95), (2.4, 2.8, 0.95, 4.2), (12.0, 12.4, 0.95, 3.0)), (13.2, 1.6)),
    Part("2", ((1.2, 1.6, 0.35, 4.75), (1.6, 6.5, 4.5, 4.75)), (0.6, 3.9), "drum"),
    Part("3", _discs(3.3, 5, (2.6, 0), (0, 4.5)), (3.5, 5.5), "disc"),
    Part("4", _discs(3.55, 4, (2.2, 0), (0, 4.0)), (4.6, 5.5), "disc"),
    Part("5", ((5.55, 6.0, 1.95, 4.2), (3.3, 5.55, 1.95, 2.2)), (6.6, 5.2), "moving"),
    Part("6", ((3.1, 7.35, 1.1, 1.7),), (1.9, 2.3)),
    Part("7", ((4.6, 5.4, 1.6, 1.95),), (3.0, 5.5), "key"),
    Part("8", ((7.13, 7.87, 1.03, 1.77),), (7.0, 2.3), "ball"),
    Part("9", ((8.8, 9.2, 1.1, 3.9), (7.65, 9.9, 1.1, 1.7)), (9.6, 4.4), "moving"),
    Part("10", ((6.0, 8.8, 2.55, 2.8),), (8.0, 4.6), "moving"),
    Part("11", ((9.2, 12.0, 1.9, 2.8),), (10.8, 3.6), "spring"),
    Part("12", ((8.9, 9.8, 0.85, 1.15),), (10.4, 1.4), "key"),
    Part("13", ((6.0, 8.8, 3.0, 3.8),), (7.2, 4.9), "spring"),
    Part("", ((2.8, 3.1, 1.1, 4.1),), (2.95, 4.4), "bearing"),
)


class BallInPockets:
    """A ball between two sleeves with the points of S21 fig. 3: O its centre, B where it touches, C the walls' apex."""

    height = 3.6
    angle = math.radians(38)

    def paint(self, axes: Any) -> None:
        """Draw into matplotlib's axes; the ball has the radius 1."""
        from matplotlib.patches import Arc, Circle, Polygon

        sine, cosine, gap, floor = math.sin(self.angle), math.cos(self.angle), 0.13, 1.1
        apex = 1 / sine
        axes.set_axis_off()
        axes.set_aspect("equal")
        axes.set_xlim(-3.4, 3.4)
        axes.set_ylim(-2.15, 2.15)
        for hand, hatch in ((-1, "////"), (1, "\\\\\\\\")):
            wall = [(gap, (apex - gap) * math.tan(self.angle)), (floor, (apex - floor) * math.tan(self.angle))]
            half = [(2.5, 1.9), (gap, 1.9), *wall]
            outline = [(hand * x, y) for x, y in (*half, *((x, -y) for x, y in reversed(half)))]
            axes.add_patch(Polygon(outline, closed=True, facecolor="none", edgecolor=INK, hatch=hatch, linewidth=1.0))
        axes.add_patch(Circle((0, 0), 1, facecolor="none", edgecolor=COLOURS[0], linewidth=2.0))
        axes.plot([-2.6, 2.6], [0, 0], color=INK, linewidth=0.8, linestyle=(0, (12, 3, 2, 3)))
        points = {"O": (0.0, 0.0), "A": (0.0, 1 / cosine), "B": (sine, cosine), "C": (apex, 0.0), "D": (sine, 0.0)}
        for first, second in ("OA", "AC", "OB", "BD"):
            axes.plot(*zip(points[first], points[second], strict=True), color=COLOURS[1], linewidth=1.2)
        for name, (x, y) in points.items():
            axes.plot([x], [y], marker="o", markersize=4, color=INK)
            below = -0.2 if y == 0 else 0.18
            axes.text(x + (0.14 if name == "B" else 0), y + below, name, ha="center", va="center", fontsize=10)
        axes.add_patch(Arc((apex, 0), 1.1, 1.1, theta1=180 - math.degrees(self.angle), theta2=180, color=INK))
        axes.text(apex - 0.68, 0.2, "α", ha="center", va="center", fontsize=10)
        axes.text(sine / 2 - 0.05, cosine / 2 + 0.16, mathtext("r_ш"), ha="right", va="center", fontsize=10)
        axes.text(0, -1.89, "s", ha="center", va="center", fontsize=10)
        arrow = {"arrowstyle": "<|-|>", "color": INK, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0}
        axes.annotate("", (gap, -1.75), (apex, -1.75), arrowprops=arrow)
        axes.text((gap + apex) / 2, -1.61, mathtext("h_1"), ha="center", va="center", fontsize=10)
        axes.plot([apex, apex], [0, -1.85], color=INK, linewidth=0.6)


def _scheme(title: str, caption: str, panel: Any) -> Callable[[], Sheet]:
    return lambda: Sheet(translate(title), [panel], translate(caption))


SCHEMES: dict[str, Callable[[], Sheet]] = {
    "F11-1": _scheme(
        "Clutch with bypass and controlled pairs (after F11 fig. 1)",
        "1, 2 half-couplings; 3, 4 discs of the bypass group; 5, 6 discs of the controlled group; 7 pressure disc; "
        "8 balls in pockets; 9 thrust disc; 10 spring; 11 thrust bearing.",
        HalfSection(_F11, 13, 6),
    ),
    "S19-1": _scheme(
        "Clutch with one bypass pair (after S19 fig. 1)",
        "1, 2 half-couplings; 3, 4 discs; 5 pressure disc; 6 balls in pockets; 7 thrust disc, which the first disc 4 "
        "touches; 8 spring; 9 thrust bearing.",
        HalfSection(_S19, 13, 6),
    ),
    "S21-1": _scheme(
        "Clutch with indirect regulation (after S21 fig. 1)",
        "1, 2 half-couplings; 3, 4 discs; 5 pressure disc; 6 sleeve; 7, 12 keys; 8 balls in pockets; 9 thrust sleeve; "
        "10 stop; 11 control spring; 13 closing spring; thrust bearings without a number.",
        HalfSection(_S21, 14, 6),
    ),
    "S21-3": _scheme(
        "Ball in its pockets (after S21 fig. 3)",
        "O centre of the ball, B where it touches the wall, C where the walls would meet; OA = r_ш/cos α, "
        "OC = r_ш/sin α, OD = r_ш sin α.",
        BallInPockets(),
    ),
}
"""Name of a figure of the papers → the drawing."""
