"""A drawing as a list of shapes in millimetres, each on a layer that says what it is: painted as SVG or into axes.

The axis of x runs to the right, that of y upwards. Whoever writes another format walks ``Drawing.shapes``.
"""

import math
import textwrap
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple, TypeAlias
from xml.sax.saxutils import escape

from ..messages import printable
from .plot.paint import COLOURS, INK, SHADE, WIDTH
from .symbols import literal, mathtext, split

Point: TypeAlias = tuple[float, float]
Rectangle: TypeAlias = tuple[float, float, float, float]
"""Left, right, low, high."""


class Layer(NamedTuple):
    """How the lines of a layer look; the width in points of a drawing that is as wide as the text of a page."""

    about: str
    colour: str
    width: float
    dashes: tuple[float, ...] = ()
    """Lengths of dashes and gaps, points."""
    fill: float = 0.0
    """Opacity that its areas are filled with."""


RED = "#b3261e"
LAYERS: dict[str, Layer] = {
    "faces": Layer("friction faces, from their end", SHADE, 0.5, fill=0.28),
    "discs": Layer("friction discs, one a pair", COLOURS[0], 0.5, fill=0.3),
    "bypass": Layer("discs of the pairs that bypass the control unit", COLOURS[1], 0.5, fill=0.6),
    "hatch": Layer("cut faces", INK, 0.35),
    "outline": Layer("edges that are seen", INK, 1.1),
    "assumed": Layer("edges of what is drawn at a default", INK, 0.8, (4, 2)),
    "springs": Layer("springs", COLOURS[2], 1.0),
    "balls": Layer("balls of the control unit", COLOURS[0], 1.3),
    "ghost": Layer("parts that move, where they are at f_max", COLOURS[3], 0.9, (7, 1.5, 1, 1.5, 1, 1.5)),
    "overlap": Layer("where parts are in each other's way", RED, 0.8, fill=0.55),
    "centre": Layer("centre lines", INK, 0.45, (9, 2, 1.5, 2)),
    "dimensions": Layer("dimensions, numbers of the parts and their list", INK, 0.45, fill=1.0),
}
"""Name → look, in the order they are painted."""


class Region(NamedTuple):
    """Closed contours; every second one within another is a hole."""

    layer: str
    contours: tuple[tuple[Point, ...], ...]
    part: str = ""
    hatch: float = 0.0
    """Angle of the hatch lines, degrees; 0: none."""


class Stroke(NamedTuple):
    """A line through points."""

    layer: str
    points: tuple[Point, ...]
    part: str = ""


class Circle(NamedTuple):
    """A circle."""

    layer: str
    centre: Point
    radius: float
    part: str = ""
    hole: float = 0.0
    """Radius of what its area leaves out; 0: nothing."""


class Inscription(NamedTuple):
    """A text that begins, has its middle or ends at a place, on its base line."""

    text: str
    at: Point
    anchor: str = "start"
    """``start``, ``middle`` or ``end``."""
    upright: bool = False
    """Whether it reads from below upwards."""
    ours: bool = True
    """Whether symbols in it are set as such; what a user wrote is set as it is."""


class DimensionLine(NamedTuple):
    """A dimension between two points, its line along x at a height ``line``, or upright along y at an x."""

    key: str
    label: str
    start: Point
    end: Point
    line: float
    upright: bool = False
    about: str = ""


Shape: TypeAlias = Region | Stroke | Circle | Inscription | DimensionLine

TEXT = 9.0
"""Points of every text."""
LETTER = 0.62
"""Width of a letter over the size of the text, at most about."""
_ARROW = 5.0, 1.3
"""Length and half width of the head of an arrow, points."""
PAGE = 72 * WIDTH
"""Width of a drawing, points."""


@dataclass(frozen=True)
class Drawing:
    """Shapes, and the rectangle that holds them: left, bottom, right, top, mm."""

    shapes: Sequence[Shape]
    frame: tuple[float, float, float, float]
    table: Sequence[Sequence[str]] = ()
    """The part list: heads, then a row for each part; it is among the shapes too."""
    solids: Sequence[tuple[str, Rectangle]] = ()
    """What is above the axis for a sketch in letters: the sign of a part, where it is."""

    @property
    def point(self) -> float:
        """How many millimetres of the drawing a point is where it is as wide as the text of a page."""
        return (self.frame[2] - self.frame[0]) / PAGE

    @property
    def height(self) -> float:
        """Inches, as wide as the text of a page."""
        left, bottom, right, top = self.frame
        return WIDTH * (top - bottom) / (right - left)

    def captioned(self, title: str, name: str, caption: str) -> "Drawing":
        """Return it with a title and a name above it and a caption below."""
        left, bottom, right, top = self.frame
        row, letters = 1.4 * TEXT * self.point, int(PAGE / (LETTER * TEXT))
        texts = [
            Inscription(line, (left, top + row * (place + 0.5)), ours=not place)
            for place, line in enumerate((title, name))
        ]
        lines = textwrap.wrap(caption, letters)
        texts += [Inscription(line, (left, bottom - row * place)) for place, line in enumerate(lines, 1)]
        frame = left, bottom - row * (len(lines) + 0.5), right, top + 2.5 * row
        return replace(self, shapes=(*self.shapes, *texts), frame=frame)

    def by_layer(self) -> Iterator[tuple[str, list[Shape]]]:
        """Yield each layer that has shapes, in the order they are painted."""
        for name in LAYERS:
            if shapes := [shape for shape in self.shapes if getattr(shape, "layer", "dimensions") == name]:
                yield name, shapes

    def svg(self, title: str = "") -> str:
        """Write it as SVG whose numbers are millimetres, as wide as the text of a page."""
        left, bottom, right, top = self.frame
        size = " ".join(map(_n, (left, -top, right - left, top - bottom)))
        hatches = {shape.hatch for shape in self.shapes if isinstance(shape, Region) and shape.hatch}
        lines = [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{_n(25.4 * WIDTH)}mm" '
            f'height="{_n(25.4 * self.height)}mm" viewBox="{size}" font-family="DejaVu Sans, sans-serif" '
            f'font-size="{_n(TEXT * self.point)}">',
            *([f"<title>{escape(title)}</title>"] if title else []),
            *(_pattern(angle, self.point) for angle in sorted(hatches)),
        ]
        for name, shapes in self.by_layer():
            look = LAYERS[name]
            dashes = " ".join(_n(length * self.point) for length in look.dashes)
            lines.append(
                f'<g class="{name}" stroke="{look.colour}" stroke-width="{_n(look.width * self.point)}" '
                f'fill="{look.colour}" fill-opacity="{look.fill:g}" fill-rule="evenodd" stroke-linejoin="round"'
                + (f' stroke-dasharray="{dashes}">' if dashes else ">")
            )
            for shape in shapes:
                if isinstance(shape, DimensionLine):
                    lines.append(f'<g data-key="{shape.key}"><title>{escape(shape.about)}</title>')
                    lines += [_svg(part) for part in exploded(shape, self.point)]
                    lines.append("</g>")
                else:
                    lines.append(_svg(shape))
            lines.append("</g>")
        return "\n".join([*lines, "</svg>", ""])

    def paint(self, axes: Any) -> None:
        """Draw into matplotlib's axes."""
        from importlib import import_module

        patches: Any = import_module("matplotlib.patches")
        path: Any = import_module("matplotlib.path").Path
        left, bottom, right, top = self.frame
        axes.set_axis_off()
        axes.set_aspect("equal")
        axes.set_xlim(left, right)
        axes.set_ylim(bottom, top)
        for order, (name, shapes) in enumerate(self.by_layer()):
            look = LAYERS[name]
            style = (0, tuple(length / look.width for length in look.dashes)) if look.dashes else "solid"
            edge: dict[str, Any] = {"linewidth": look.width, "linestyle": style, "zorder": 2 + order / 100}
            faint = {"facecolor": (look.colour, look.fill), "edgecolor": look.colour} | edge
            simple = [part for shape in shapes for part in exploded(shape, self.point)]
            for shape in simple:
                if isinstance(shape, Inscription):
                    turned = {"rotation": 90, "rotation_mode": "anchor"} if shape.upright else {}
                    place = {"start": "left", "middle": "center", "end": "right"}[shape.anchor]
                    axes.text(
                        *shape.at,
                        (mathtext if shape.ours else literal)(shape.text),
                        ha=place,
                        va="baseline",
                        fontsize=TEXT,
                        **turned,
                    )
                elif isinstance(shape, Stroke):
                    axes.plot(*zip(*shape.points, strict=True), color=look.colour, **edge)
                elif isinstance(shape, Circle) and shape.hole:
                    axes.add_patch(patches.Annulus(shape.centre, shape.radius, shape.radius - shape.hole, **faint))
                elif isinstance(shape, Circle):
                    axes.add_patch(patches.Circle(shape.centre, shape.radius, **faint))
                else:
                    outline = path.make_compound_path(*(path([*ring, ring[0]], closed=True) for ring in shape.contours))
                    hatch = {"hatch": "////" if shape.hatch < 90 else "\\\\\\\\", "linewidth": 0} if shape.hatch else {}
                    axes.add_patch(patches.PathPatch(outline, **faint | hatch))


def exploded(shape: Shape, point: float) -> list[Region | Stroke | Circle | Inscription]:
    """Return the lines, arrows and text of a dimension, anything else as it is; ``point``: a point in millimetres."""
    if not isinstance(shape, DimensionLine):
        return [shape]
    upright = shape.upright

    def turn(x: float, y: float) -> Point:
        return (y, x) if upright else (x, y)

    (low, from_low), (high, from_high) = sorted((turn(*shape.start), turn(*shape.end)))
    long, half = (length * point for length in _ARROW)
    beyond = math.copysign(2 * point, shape.line - from_low)
    wide = LETTER * TEXT * point * len(shape.label)
    outside = high - low < 2.6 * long
    parts: list[Region | Stroke | Circle | Inscription] = [
        Stroke("dimensions", (turn(low, shape.line), turn(high, shape.line)), "line")
    ]
    for end, start in ((low, from_low), (high, from_high)):
        if abs(shape.line - start) > point:
            parts.append(Stroke("dimensions", (turn(end, start), turn(end, shape.line + beyond))))
        hand = 1 if (end == low) != outside else -1
        head = (end, shape.line), (end + hand * long, shape.line + half), (end + hand * long, shape.line - half)
        parts.append(Region("dimensions", (tuple(turn(*corner) for corner in head),)))
        if outside:
            parts.append(Stroke("dimensions", (turn(end, shape.line), turn(end + 2 * hand * long, shape.line))))
    base = shape.line + (-1 if shape.upright else 1) * 2 * point
    if high - low >= wide or shape.upright:
        parts.append(Inscription(shape.label, turn((low + high) / 2, base), "middle", shape.upright))
    else:
        away = high + (2.3 * long if outside else point)
        parts.append(Inscription(shape.label, turn(away, base if not outside else base), "start", shape.upright))
    return parts


def _svg(shape: Region | Stroke | Circle | Inscription) -> str:
    if isinstance(shape, Inscription):
        return _text(shape)
    about = f' data-part="{shape.part}"' if shape.part else ""
    if isinstance(shape, Stroke):
        return f'<path fill="none"{about} d="M{_path(shape.points)}"/>'
    if isinstance(shape, Circle):
        x, y = _n(shape.centre[0]), _n(-shape.centre[1])
        if not shape.hole:
            return f'<circle{about} cx="{x}" cy="{y}" r="{_n(shape.radius)}"/>'
        rings = (
            f"M{_n(shape.centre[0] - r)} {y}a{_n(r)} {_n(r)} 0 1 0 {_n(2 * r)} 0a{_n(r)} {_n(r)} 0 1 0 {_n(-2 * r)} 0Z"
            for r in (shape.radius, shape.hole)
        )
        return f'<path{about} d="{"".join(rings)}"/>'
    fill = f' stroke="none" fill="url(#hatch{shape.hatch:g})" fill-opacity="1"' if shape.hatch else ""
    return f'<path{about}{fill} d="{"".join(f"M{_path(ring)}Z" for ring in shape.contours)}"/>'


def _text(note: Inscription) -> str:
    x, y = _n(note.at[0]), _n(-note.at[1])
    turned = f' transform="rotate(-90 {x} {y})"' if note.upright else ""
    anchor = "" if note.anchor == "start" else f' text-anchor="{note.anchor}"'
    spans, lowered = [], False
    for piece, low in split(printable(note.text), note.ours):
        drop = "" if low == lowered else f' dy="{".18em" if low else "-.126em"}"'
        size = ' font-size="70%"' if low else ""
        spans.append(f"<tspan{drop}{size}>{escape(piece)}</tspan>" if drop or size else escape(piece))
        lowered = low
    return f'<text x="{x}" y="{y}" stroke="none"{anchor}{turned}>{"".join(spans)}</text>'


def _pattern(angle: float, point: float) -> str:
    look, step = LAYERS["hatch"], _n(4 * point)
    return (
        f'<pattern id="hatch{angle:g}" patternUnits="userSpaceOnUse" width="{step}" height="{step}" '
        f'patternTransform="rotate({-angle:g})"><path d="M0 0H{step}" stroke="{look.colour}" '
        f'stroke-width="{_n(2 * look.width * point)}"/></pattern>'
    )


def _path(points: Iterable[Point]) -> str:
    return "L".join(f"{_n(x)} {_n(-y)}" for x, y in points)


def _n(value: float) -> str:
    """A number to the tenth of a micrometre."""
    return f"{round(value, 4) + 0.0:.4f}".rstrip("0").rstrip(".")


def corners(box: Rectangle) -> tuple[Point, ...]:
    """Return the corners of a rectangle, from the lower left one on."""
    left, right, low, high = box
    return (left, low), (right, low), (right, high), (left, high)


def outlines(boxes: Sequence[Rectangle]) -> tuple[tuple[Point, ...], ...]:
    """Return the closed contours of what rectangles cover together, holes included."""
    xs = sorted({x for box in boxes for x in box[:2]})
    ys = sorted({y for box in boxes for y in box[2:]})
    covered = {
        (i, j)
        for i, x in enumerate(xs[:-1])
        for j, y in enumerate(ys[:-1])
        if any(left <= x < right and low <= y < high for left, right, low, high in boxes)
    }
    ends: dict[tuple[int, int], list[tuple[int, int]]] = {}
    for i, j in covered:  # each edge with the covered cell to its left
        for beside, start, end in (
            ((i, j - 1), (i, j), (i + 1, j)),
            ((i + 1, j), (i + 1, j), (i + 1, j + 1)),
            ((i, j + 1), (i + 1, j + 1), (i, j + 1)),
            ((i - 1, j), (i, j + 1), (i, j)),
        ):
            if beside not in covered:
                ends.setdefault(start, []).append(end)
    rings = []
    while ends:
        start = min(ends)
        ring, at = [start], start
        while True:
            following = ends[at].pop(0)
            if not ends[at]:
                del ends[at]
            ring, at = [*ring, following], following
            if at == start:
                break
        corners = [
            b
            for a, b, c in zip([ring[-2], *ring], ring[:-1], ring[1:], strict=False)
            if (a[0] == b[0]) != (b[0] == c[0])
        ]
        rings.append(tuple((xs[i], ys[j]) for i, j in corners))
    return tuple(rings)
