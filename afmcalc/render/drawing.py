"""A drawing as data: shapes in millimetres, each on a layer for its kind; ``svg`` and ``dxf`` write the drawing.

The x axis runs to the right, the y axis upwards.
"""

import math
import textwrap
from collections.abc import Iterator, Sequence
from itertools import product
from typing import NamedTuple, TypeAlias

from ..messages import localized
from .plot.paint import COLOURS, INK, PAPER, SHADE, WRONG
from .symbols import split

Point: TypeAlias = tuple[float, float]
Polyline: TypeAlias = tuple[Point, ...]
Rectangle: TypeAlias = tuple[float, float, float, float]
"""Left, right, lower and upper coordinate of a rectangle."""
HIDDEN, CENTRE, GHOST = "HIDDEN2", "CENTER2", "DIVIDE2"
DASHES = {HIDDEN: (1.4, 0.7), CENTRE: (3.2, 0.7, 0.5, 0.7), GHOST: (2.5, 0.5, 0.35, 0.5, 0.35, 0.5)}
"""Line type → lengths of its dashes and gaps, mm on paper."""
WIDTH = 175.0
"""Width of a drawing that fills the text width of a page, mm on paper."""
TEXT = 3.2
"""Size of texts in a drawing, mm on paper: nine points."""
_LETTER = 0.62
"""Upper estimate of the width of a letter, relative to the font size."""
_LONG, _HALF = 0.55, 0.14
"""Length and half width of an arrowhead, relative to the font size."""


class Layer(NamedTuple):
    """Style of the lines and areas of a layer; millimetres on paper."""

    about: str
    colour: str
    number: int
    """Index of the colour in AutoCAD."""
    width: float
    line: str = "CONTINUOUS"
    """Line type, one of ``DASHES`` or continuous."""
    fill: float = 0.0
    """Opacity of areas on the layer."""
    face: str = ""
    """Colour of areas on the layer, if it is not ``colour``; that of the paper hides what was painted before."""


LAYERS: dict[str, Layer] = {
    "faces": Layer("friction faces, from their end", SHADE, 8, 0.18, fill=0.28),
    "discs": Layer("friction discs, one a pair", COLOURS[0], 5, 0.18, fill=0.3),
    "bypass": Layer("discs of the pairs that bypass the control unit", COLOURS[1], 30, 0.18, fill=0.6),
    "hatch": Layer("cut faces", INK, 8, 0.13),
    "outline": Layer("edges that are seen", INK, 7, 0.4),
    "sleeve_1": Layer("sleeve with the profiled wall", INK, 7, 0.5),
    "sleeve_2": Layer("the other sleeve", INK, 7, 0.5),
    "pocket_1": Layer("pocket of the profiled wall: to cut", INK, 7, 0.5),
    "pocket_2": Layer("pocket of the other sleeve: to cut", INK, 7, 0.5),
    "end_view": Layer("a sleeve seen from its pockets", INK, 7, 0.5),
    "assumed": Layer("edges of what is drawn at a default", INK, 7, 0.25, HIDDEN, fill=1.0, face=PAPER),
    "springs": Layer("springs", COLOURS[2], 3, 0.35),
    "balls": Layer("balls of the control unit", COLOURS[0], 5, 0.5, fill=1.0, face=PAPER),
    "ball": Layer("the ball at the stop", COLOURS[0], 5, 0.25, GHOST),
    "contact": Layer("where the ball touches", COLOURS[1], 30, 0.25, fill=1.0),
    "path": Layer("path of the ball's centre in the profiled sleeve", COLOURS[2], 3, 0.25, CENTRE),
    "ghost": Layer("parts that move, where they are at f_max", COLOURS[3], 6, 0.3, GHOST),
    "overlap": Layer("where parts are in each other's way", WRONG, 1, 0.3, fill=0.55),
    "centre": Layer("centre lines", INK, 1, 0.18, CENTRE),
    "dimensions": Layer("dimensions, notes and the list of the parts", INK, 7, 0.18, fill=1.0),
    "title": Layer("title block", INK, 7, 0.25),
    "frame": Layer("frame of the sheet", INK, 7, 0.7),
}
"""Name of a layer → its style, in the order of painting."""


class Region(NamedTuple):
    """Area within closed contours; a contour inside another contour is a hole."""

    layer: str
    contours: tuple[Polyline, ...]
    part: str = ""
    hatch: float = 0.0
    """Angle of the hatch lines, degrees; 0: none."""


class Stroke(NamedTuple):
    """A line through points."""

    layer: str
    points: Polyline


class Circle(NamedTuple):
    """A circle."""

    layer: str
    centre: Point
    radius: float
    part: str = ""
    hole: float = 0.0
    """Radius of its concentric hole; 0: none."""


class Inscription(NamedTuple):
    """Text with its start, middle or end at a point on its base line."""

    text: str
    at: Point
    height: float
    """Font size, mm of the drawing; capital letters are 0.7 as high."""
    anchor: str = "start"
    """``start``, ``middle`` or ``end``."""
    upright: bool = False
    """True if the text runs upwards."""
    ours: bool = True
    """True if symbols in the text get subscripts; False for a text of the user."""
    layer: str = "dimensions"


class Length(NamedTuple):
    """Dimension of a length; the dimension line is at y = ``line`` or, if ``upright``, at x = ``line``."""

    label: str
    height: float
    start: Point
    end: Point
    line: float
    upright: bool = False
    key: str = ""
    about: str = ""
    shrunk: float = 1.0
    """Scale of the view that has the dimension, relative to the rest of the drawing."""
    layer: str = "dimensions"


class Diameter(NamedTuple):
    """Dimension across a circle; the dimension line is at ``angle`` degrees to the x axis."""

    label: str
    height: float
    centre: Point
    radius: float
    angle: float
    shrunk: float = 1.0
    layer: str = "dimensions"


class Angle(NamedTuple):
    """Dimension of the angle between two lines from an apex, anticlockwise from the first line to the second."""

    label: str
    height: float
    apex: Point
    first: Point
    second: Point
    radius: float
    """Radius of the dimension arc."""
    layer: str = "dimensions"


Simple: TypeAlias = Region | Stroke | Circle | Inscription
Shape: TypeAlias = Simple | Length | Diameter | Angle
Shapes: TypeAlias = Iterator[Shape]


class Drawing(NamedTuple):
    """Shapes, and the rectangle that encloses them: left, bottom, right, top, mm."""

    shapes: Sequence[Shape]
    frame: tuple[float, float, float, float]
    width: float = WIDTH
    """Width on paper, mm."""
    cells: int = 0
    """Number of shapes, at the end of ``shapes``, that form the part list."""

    @property
    def unit(self) -> float:
        """Millimetres of the drawing for one millimetre of paper."""
        return (self.frame[2] - self.frame[0]) / self.width

    def captioned(self, title: str, name: str, caption: str) -> "Drawing":
        """Drawing with a title and a name above it and a caption below."""
        left, bottom, right, top = self.frame
        size = TEXT * self.unit
        row, inset = 1.4 * size, left + 0.5 * size
        lines = textwrap.wrap(caption, int((right - left) / (_LETTER * size)))
        texts = [Inscription(line, (inset, bottom - row * place), size) for place, line in enumerate(lines, 1)]
        above = Inscription(title, (inset, top + 1.6 * row), size)
        below = Inscription(name, (inset, top + 0.6 * row), size, ours=False)
        frame = left, bottom - row * (len(lines) + 0.5), right, top + 2.7 * row
        return self._replace(shapes=[*self.shapes, *texts, above, below], frame=frame)

    def without_table(self) -> "Drawing":
        """Drawing without its part list."""
        *shapes, first = self.shapes[: len(self.shapes) - self.cells + 1]
        assert isinstance(first, Inscription)
        left, _, right, top = self.frame
        return self._replace(shapes=shapes, frame=(left, first.at[1] + first.height, right, top), cells=0)

    def by_layer(self) -> Iterator[tuple[str, list[Shape]]]:
        """Yield each layer that has shapes, in the order they are painted."""
        for name in LAYERS:
            if shapes := [shape for shape in self.shapes if shape.layer == name]:
                yield name, shapes


def exploded(shape: Shape) -> list[Simple]:
    """Lines, arrows and text of a dimension; any other shape as it is."""
    match shape:
        case Length():
            return _length(shape)
        case Diameter(label, height, (x, y), radius, angle):
            along, across = math.cos(math.radians(angle)), math.sin(math.radians(angle))
            near, far, knee = ((x + r * along, y + r * across) for r in (-radius, radius, radius + 2 * height))
            line, head, *text = leader(label, near, knee, height)
            return [line, head, arrow(far, (x, y), height), *text]
        case Angle(label, height, apex, first, second, radius):
            start, stop = (math.atan2(y - apex[1], x - apex[0]) for x, y in (first, second))
            turn = (stop - start) % (2 * math.pi)
            angles = [start + turn * step / 24 for step in range(25)]
            arc = [(apex[0] + radius * math.cos(each), apex[1] + radius * math.sin(each)) for each in angles]
            line = Stroke("dimensions", tuple(arc))
            if not label:
                return [line]
            along, across, out = math.cos(angles[12]), math.sin(angles[12]), radius + 0.4 * height
            x, y = apex[0] + out * along, apex[1] + out * across
            at = x + (along - 1) * text_width(label, height) / 2, y + (across - 1) * height / 2
            heads = arrow(arc[0], arc[1], height), arrow(arc[-1], arc[-2], height)
            return [line, Inscription(label, at, height), *heads]
        case _:
            return [shape]


def _length(shape: Length) -> list[Simple]:
    y, height = shape.line, shape.height
    long, gap = _LONG * height, 0.25 * height

    def turned(*points: Point) -> Polyline:
        return tuple((y, x) for x, y in points) if shape.upright else points

    (low, low_at), (high, high_at) = sorted(turned(shape.start, shape.end))
    outside = high - low < 2.6 * long
    parts: list[Simple] = [Stroke("dimensions", turned((low, y), (high, y)))]
    for end, at, hand in ((low, low_at, 1), (high, high_at, -1)):
        back = end + (-hand if outside else hand) * long
        tip, tail = turned((end, y), (back, y))
        parts.append(arrow(tip, tail, height))
        if outside:
            parts.append(Stroke("dimensions", turned((back, y), (2 * back - end, y))))
        if abs(y - at) > gap / 2:
            parts.append(Stroke("dimensions", turned((end, at), (end, y + math.copysign(gap, y - at)))))
    base = y - gap if shape.upright else y + gap
    beside = not shape.upright and high - low < text_width(shape.label, height)
    place = high + (2.3 * long if outside else gap / 2) if beside else (low + high) / 2
    (at_text,) = turned((place, base))
    return [*parts, Inscription(shape.label, at_text, height, "start" if beside else "middle", shape.upright)]


def arrow(tip: Point, tail: Point, height: float) -> Region:
    """Arrowhead at ``tip``, of a size that suits texts of ``height``."""
    long = math.dist(tip, tail)
    along, across = ((end - start) / long * height for start, end in zip(tip, tail, strict=True))
    back = tip[0] + _LONG * along, tip[1] + _LONG * across
    sides = (back[0] - _HALF * across, back[1] + _HALF * along), (back[0] + _HALF * across, back[1] - _HALF * along)
    return Region("dimensions", ((tip, *sides),))


def leader(text: str, tip: Point, knee: Point, height: float) -> list[Simple]:
    """Leader from a text to ``tip``: an arrow with a horizontal shelf at ``knee``."""
    shelf = knee[0] + math.copysign(text_width(text, height), knee[0] - tip[0]), knee[1]
    at = min(knee[0], shelf[0]), knee[1] + 0.3 * height
    line = Stroke("dimensions", (tip, knee, shelf)), arrow(tip, knee, height)
    return [*line, Inscription(text, at, height)] if text else [*line]


def tenths(value: float) -> str:
    """Calculated length (m) as text in millimetres, to a tenth.

    >>> tenths(0.0994561), tenths(0.1)
    ('99.5', '100')
    """
    return localized(f"{1e3 * value:.1f}".removesuffix(".0"))


def text_width(text: str, height: float) -> float:
    """Upper estimate of the width of a text."""
    return sum((0.7 if low else 1.0) * len(piece) for piece, low in split(text)) * _LETTER * height


def corners(box: Rectangle) -> Polyline:
    """Corners of a rectangle, anticlockwise from the lower left."""
    left, right, low, high = box
    return (left, low), (right, low), (right, high), (left, high)


def middle(box: Rectangle) -> Point:
    """Centre of a rectangle."""
    left, right, low, high = box
    return (left + right) / 2, (low + high) / 2


def rectangle(layer: str, box: Rectangle, part: str = "", hatch: float = 0.0) -> Region:
    """Area of a rectangle."""
    return Region(layer, (corners(box),), part, hatch)


def outlines(boxes: Sequence[Rectangle]) -> tuple[Polyline, ...]:
    """Closed contours of the union of rectangles, each with the covered area to its left."""
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
        while at in edges:  # until the contour closes
            onward = edges[at].pop()
            if not edges[at]:
                del edges[at]
            if level != (level := onward[1] == at[1]):
                turns.append((xs[at[0]], ys[at[1]]))
            at = onward
        contours.append(tuple(turns))
    return tuple(contours)
