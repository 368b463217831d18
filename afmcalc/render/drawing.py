"""A drawing as a list of shapes in millimetres, each on a layer that says what it is: painted as SVG or into axes.

The axis of x runs to the right, that of y upwards. Whoever writes another format walks ``Drawing.shapes``.
"""

import math
import textwrap
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from html import escape
from importlib import import_module
from itertools import chain, product
from typing import Any, NamedTuple, TypeAlias

from ..messages import printable
from .plot.paint import COLOURS, INK, PAPER, SHADE, WIDTH, WRONG
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
    hides: bool = False
    """Whether its areas hide what is painted before them: they are filled with the colour of the paper."""

    @property
    def face(self) -> str:
        """Colour of its areas."""
        return PAPER if self.hides else self.colour


LAYERS: dict[str, Layer] = {
    "faces": Layer("friction faces, from their end", SHADE, 0.5, fill=0.28),
    "discs": Layer("friction discs, one a pair", COLOURS[0], 0.5, fill=0.3),
    "bypass": Layer("discs of the pairs that bypass the control unit", COLOURS[1], 0.5, fill=0.6),
    "hatch": Layer("cut faces", INK, 0.35),
    "outline": Layer("edges that are seen", INK, 1.1),
    "assumed": Layer("edges of what is drawn at a default", INK, 0.8, (4, 2), 1.0, hides=True),
    "springs": Layer("springs", COLOURS[2], 1.0),
    "balls": Layer("balls of the control unit", COLOURS[0], 1.3, fill=1.0, hides=True),
    "ghost": Layer("parts that move, where they are at f_max", COLOURS[3], 0.9, (7, 1.5, 1, 1.5, 1, 1.5)),
    "overlap": Layer("where parts are in each other's way", WRONG, 0.8, fill=0.55),
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


Simple: TypeAlias = Region | Stroke | Circle | Inscription
Shape: TypeAlias = Simple | DimensionLine

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
        row, lines = 1.4 * TEXT * self.point, textwrap.wrap(caption, int(PAGE / (LETTER * TEXT)))
        inset = left + 4 * self.point
        texts = [Inscription(line, (inset, bottom - row * place)) for place, line in enumerate(lines, 1)]
        texts += [Inscription(title, (inset, top + 1.6 * row)), Inscription(name, (inset, top + 0.6 * row), ours=False)]
        frame = left, bottom - row * (len(lines) + 0.5), right, top + 2.7 * row
        return replace(self, shapes=(*self.shapes, *texts), frame=frame)

    def without_table(self) -> "Drawing":
        """Return it without the part list, whose cells are the last of its shapes."""
        cells = [shape for shape in self.shapes if isinstance(shape, Inscription)][
            -sum(map(bool, chain(*self.table))) :
        ]
        left, _, right, top = self.frame
        frame = left, cells[0].at[1] + TEXT * self.point, right, top
        return replace(self, shapes=self.shapes[: -len(cells)], frame=frame, table=())

    def by_layer(self) -> Iterator[tuple[str, list[Shape]]]:
        """Yield each layer that has shapes, in the order they are painted."""
        for name in LAYERS:
            if shapes := [shape for shape in self.shapes if getattr(shape, "layer", "dimensions") == name]:
                yield name, shapes

    def svg(self, title: str = "") -> str:
        """Write it as SVG whose numbers are millimetres, as wide as the text of a page."""
        left, bottom, right, top = self.frame
        hatches = {shape.hatch for shape in self.shapes if isinstance(shape, Region) and shape.hatch}
        parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{_n(25.4 * WIDTH)}mm" height="{_n(25.4 * self.height)}mm" '
            f'viewBox="{_path([(left, top)])} {_n(right - left)} {_n(top - bottom)}" '
            f'font-family="DejaVu Sans, sans-serif" font-size="{_n(TEXT * self.point)}">',
            f"<title>{escape(printable(title), quote=False)}</title>" if title else "",
            *(_pattern(angle, self.point) for angle in sorted(hatches)),
        ]
        for name, shapes in self.by_layer():
            look = LAYERS[name]
            dashes = " ".join(_n(length * self.point) for length in look.dashes) or "none"
            parts.append(
                f'<g class="{name}" stroke="{look.colour}" stroke-width="{_n(look.width * self.point)}" '
                f'stroke-dasharray="{dashes}" stroke-linejoin="round" '
                f'fill="{look.face}" fill-opacity="{look.fill:g}" fill-rule="evenodd">'
            )
            for shape in shapes:
                simple = "\n".join(_svg(part) for part in exploded(shape, self.point))
                about = f"<title>{escape(shape.about, quote=False)}</title>" if isinstance(shape, DimensionLine) else ""
                parts.append(
                    f'<g data-key="{shape.key}">{about}{simple}</g>' if isinstance(shape, DimensionLine) else simple
                )
            parts.append("</g>")
        return "\n".join([*filter(None, parts), "</svg>", ""])

    def paint(self, axes: Any) -> None:
        """Draw into matplotlib's axes."""
        patches: Any = import_module("matplotlib.patches")
        path: Any = import_module("matplotlib.path").Path
        left, bottom, right, top = self.frame
        axes.set_axis_off()
        axes.set(aspect="equal", xlim=(left, right), ylim=(bottom, top))
        for order, (name, shapes) in enumerate(self.by_layer()):
            look = LAYERS[name]
            line: dict[str, Any] = {"linewidth": look.width, "zorder": 2 + order / 100}
            if look.dashes:
                line["linestyle"] = 0, tuple(length / look.width for length in look.dashes)
            area = line | {"facecolor": (look.face, look.fill), "edgecolor": look.colour}
            for shape in chain.from_iterable(exploded(each, self.point) for each in shapes):
                if isinstance(shape, Inscription):
                    text, side = (mathtext if shape.ours else literal)(shape.text), _SIDES[shape.anchor]
                    turn = 90.0 if shape.upright else 0.0
                    axes.text(*shape.at, text, size=TEXT, ha=side, va="baseline", rotation=turn, rotation_mode="anchor")
                elif isinstance(shape, Stroke):
                    axes.plot(*zip(*shape.points, strict=True), color=look.colour, **line)
                elif isinstance(shape, Circle):
                    ring = patches.Annulus(shape.centre, shape.radius, shape.radius - shape.hole, **area)
                    axes.add_patch(ring if shape.hole else patches.Circle(shape.centre, shape.radius, **area))
                else:
                    rings = path.make_compound_path(*(path([*ring, ring[0]], closed=True) for ring in shape.contours))
                    hatch = {"hatch": "////" if shape.hatch < 90 else "\\\\\\\\", "linewidth": 0} if shape.hatch else {}
                    axes.add_patch(patches.PathPatch(rings, **area | hatch))


_SIDES = {"start": "left", "middle": "center", "end": "right"}


def exploded(shape: Shape, point: float) -> list[Simple]:
    """Return the lines, arrows and text of a dimension, anything else as it is; ``point``: a point in millimetres."""
    if not isinstance(shape, DimensionLine):
        return [shape]
    layer, y, (long, half) = "dimensions", shape.line, (length * point for length in _ARROW)

    def turned(*points: Point) -> tuple[Point, ...]:
        return tuple((y, x) for x, y in points) if shape.upright else points

    (low, low_at), (high, high_at) = sorted(turned(shape.start, shape.end))
    outside = high - low < 2.6 * long
    parts: list[Simple] = [Stroke(layer, turned((low, y), (high, y)))]
    for end, at, hand in ((low, low_at, 1), (high, high_at, -1)):
        back = end + (-hand if outside else hand) * long
        parts.append(Region(layer, (turned((end, y), (back, y + half), (back, y - half)),)))
        if outside:
            parts.append(Stroke(layer, turned((back, y), (2 * back - end, y))))
        if abs(y - at) > point:
            parts.append(Stroke(layer, turned((end, at), (end, y + math.copysign(2 * point, y - at)))))
    base = y - 2 * point if shape.upright else y + 2 * point
    beside = not shape.upright and high - low < text_width(shape.label) * point
    place = high + (2.3 * long if outside else point) if beside else (low + high) / 2
    (at_text,) = turned((place, base))
    return [*parts, Inscription(shape.label, at_text, "start" if beside else "middle", shape.upright)]


def text_width(text: str) -> float:
    """Points that a text takes, about and at most."""
    return sum((0.7 if low else 1.0) * len(piece) for piece, low in split(text)) * LETTER * TEXT


def _svg(shape: Simple) -> str:
    if isinstance(shape, Inscription):
        return _text(shape)
    if isinstance(shape, Stroke):
        return f'<path fill="none" d="M{_path(shape.points)}"/>'
    about = f' data-part="{shape.part}"' if shape.part else ""
    if isinstance(shape, Circle):
        x, y = shape.centre
        if not shape.hole:
            return f'<circle{about} cx="{_n(x)}" cy="{_n(-y)}" r="{_n(shape.radius)}"/>'
        arc = "a{0} {0} 0 1 0 {1} 0a{0} {0} 0 1 0 -{1} 0Z".format
        rings = (f"M{_path([(x - r, y)])}{arc(_n(r), _n(2 * r))}" for r in (shape.radius, shape.hole))
    else:
        rings = (f"M{_path(ring)}Z" for ring in shape.contours)
        about += f' stroke="none" fill="url(#hatch{shape.hatch:g})" fill-opacity="1"' if shape.hatch else ""
    return f'<path{about} d="{"".join(rings)}"/>'


def _text(text: Inscription) -> str:
    at, shown = _path([text.at]), spans(text.text, text.ours)
    turn = f' transform="rotate(-90 {at})"' if text.upright else ""
    x, y = at.split()
    return f'<text x="{x}" y="{y}" stroke="none" text-anchor="{text.anchor}"{turn}>{shown}</text>'


def spans(text: str, ours: bool = True) -> str:
    """Set a text of SVG with its subscripts; what is quoted is not ``ours``."""
    shown, lowered, pieces = printable(text), False, ""
    for piece, low in split(shown) if ours else [(shown, False)]:
        drop = "" if low == lowered else ' dy=".18em"' if low else ' dy="-.126em"'
        size, lowered = ' font-size="70%"' if low else "", low
        pieces += f"<tspan{drop}{size}>{escape(piece, quote=False)}</tspan>"
    return pieces


def _pattern(angle: float, point: float) -> str:
    look, step = LAYERS["hatch"], _n(4 * point)
    lines = f'<path d="M0 0H{step}" stroke="{look.colour}" stroke-width="{_n(2 * look.width * point)}"/>'
    size = f'width="{step}" height="{step}" patternUnits="userSpaceOnUse" patternTransform="rotate({-angle:g})"'
    return f'<pattern id="hatch{angle:g}" {size}>{lines}</pattern>'


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
    """Return the closed contours of what rectangles cover together, each with what is covered to its left."""
    xs, ys = (sorted({box[side + end] for box in boxes for end in (0, 1)}) for side in (0, 2))
    covered = {
        (i, j)
        for i, j in product(range(len(xs) - 1), range(len(ys) - 1))
        if any(left <= xs[i] < right and low <= ys[j] < high for left, right, low, high in boxes)
    }
    edges: dict[tuple[int, int], list[tuple[int, int]]] = {}
    for i, j in covered:
        ring = (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)
        beside = (i, j - 1), (i + 1, j), (i, j + 1), (i - 1, j)
        for start, end, other in zip(ring, (*ring[1:], ring[0]), beside, strict=True):
            if other not in covered:
                edges.setdefault(start, []).append(end)
    contours = []
    while edges:
        at, turns, level = min(edges), [], None
        while at in edges:  # until it is where it began
            onward = edges[at].pop()
            if not edges[at]:
                del edges[at]
            if level != (level := onward[1] == at[1]):
                turns.append((xs[at[0]], ys[at[1]]))
            at = onward
        contours.append(tuple(turns))
    return tuple(contours)
