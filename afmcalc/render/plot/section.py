"""The whole clutch in longitudinal section and from its end, to scale, with its dimensions and its part list."""

import math
from collections.abc import Iterable, Iterator

from ...analysis.section import Box, ClutchSection, DrawnPart, Measure
from ...messages import told, translate
from ...spec.keys import keys
from ..drawing import (
    LETTER,
    PAGE,
    TEXT,
    Circle,
    DimensionLine,
    Drawing,
    Inscription,
    Rectangle,
    Region,
    Shape,
    Stroke,
    corners,
    outlines,
)
from ..units import display, measured
from .chart import Sheet, stated

_MM = 1e3
_HATCH: dict[str, float] = {
    "housing": 135.0, "hub": 45.0, "thrust disc": 135.0, "pressure disc": 45.0, "ball sleeve": 135.0,
    "thrust sleeve": 135.0, "stop ring": 45.0, "pack": 135.0,
}  # fmt: skip
"""Angle of the hatch of a part: another than that of its neighbours."""
_INSIDE, _OUTSIDE = ("bore", "hub", "ball_circle"), ("inner_diameter", "outer_diameter", "housing")
"""Diameters with their dimensions to the left and to the right of the section."""
_LEFT, _BETWEEN, _RIGHT, _ROW = 52.0, 62.0, 8.0, 13.0
"""Points beside and between the views, and for a row of dimensions or of the part list."""


def section(section: ClutchSection) -> Sheet:
    """Draw a clutch at rest, with what moves also as it is at f_max."""
    return Sheet(
        translate("Clutch in section, at rest and at f_max"), [drawing(section)], _caption(section), section.name
    )


def drawing(section: ClutchSection) -> Drawing:
    """Lay out both views, the dimensions and the part list."""
    measures = {each.key: each for each in section.measures}
    length, radius = (measures[key].ends[1] * _MM for key in ("length", "housing"))
    point = (length + 2 * radius) / (PAGE - _LEFT - _BETWEEN - _RIGHT)
    row, column = _ROW * point, 1.15 * _ROW * point
    shapes = [*_longitudinal(section, length), *_end_view(section, length + _BETWEEN * point + radius, radius, point)]
    rows: list[float] = []  # ends of the texts above the section
    lengths = (each for each in section.measures if each.kind == "length" and each.key != "length")
    for each in sorted(lengths, key=lambda each: each.ends):
        low, high = (end * _MM for end in each.ends)
        text = LETTER * TEXT * point * len(_label(each))
        place = next((number for number, end in enumerate(rows) if low - row > end), len(rows))
        rows[place : place + 1] = [high + (0 if high - low > text else row + text)]
        shapes.append(_dimension(each, radius + (place + 1) * row))
    for at, way, keys_of in ((0.0, -column, _INSIDE), (length, column, _OUTSIDE)):
        found = (each for key, each in measures.items() if key in keys_of)
        for place, each in enumerate(sorted(found, key=lambda each: each.value), 1):
            shapes.append(_dimension(each, at + place * way))
    numbers = -radius - 1.8 * row
    table = numbers - 3.0 * row
    left = -_LEFT * point
    shapes += _numbers(section, length, numbers, point)
    shapes.append(_dimension(measures["length"], numbers - 1.3 * row, -1))
    listed = _part_list(section)
    for place, cells in enumerate(listed):
        places = ((left + (4 + at) * point, table - place * row) for at in _COLUMNS)
        shapes += [Inscription(text, at) for text, at in zip(cells, places, strict=True)]
    solids = [(str(part.number)[-1], box) for part in section.parts for box in _rectangles(part.boxes)]
    bottom = table - (len(section.parts) + 0.6) * row
    return Drawing(shapes, (left, bottom, left + PAGE * point, radius + (len(rows) + 1) * row), listed, solids)


def _dimension(measure: Measure, line: float, hand: int = 1) -> DimensionLine:
    low, high, at = (value * _MM for value in (*measure.ends, hand * measure.at))
    upright = measure.kind == "diameter"
    ends = ((at, low), (at, high)) if upright else ((low, at), (high, at))
    return DimensionLine(measure.key, _label(measure), *ends, line, upright, translate(measure.about))


def _rectangles(boxes: Iterable[Box], hand: int = 1) -> list[Rectangle]:
    """Rectangles of what is above the axis, or below it, mm."""
    sides = ((box.left, box.right, *sorted((hand * box.inner, hand * box.outer))) for box in boxes)
    return [(left * _MM, right * _MM, low * _MM, high * _MM) for left, right, low, high in sides]


def _longitudinal(section: ClutchSection, length: float) -> Iterator[Shape]:
    """Draw the section along the axis, both sides of it."""
    yield Stroke("centre", ((-0.03 * length, 0.0), (1.03 * length, 0.0)))
    for hand in (1, -1):
        for part in section.parts:
            yield from _part(section, part, hand)
            for box in _rectangles(part.moved, hand):
                yield _ball(box, "ghost") if part.name == "balls" else Region("ghost", (corners(box),))
            if part.name == "balls":
                ((left, right, low, high),) = _rectangles(part.boxes, hand)
                middle, over = (low + high) / 2, 0.02 * length
                yield Stroke("centre", ((left - over, middle), (right + over, middle)))
        for overlap in section.overlaps:
            for box in _rectangles(overlap.boxes, hand):
                yield Region("overlap", (corners(box),), f"{overlap.first}/{overlap.second}")


def _part(section: ClutchSection, part: DrawnPart, hand: int) -> Iterator[Shape]:
    boxes = _rectangles(part.boxes, hand)
    if part.name == "balls":
        yield _ball(boxes[0], "assumed" if part.assumed else "balls", part.name)
    elif part.turns:
        yield from _spring(part, boxes[0], "assumed" if part.assumed else "springs")
    elif part.name == "pack":
        yield from _pack(section, boxes[0], hand)
    else:
        outline, pockets = outlines(boxes), outlines(_rectangles(part.pockets, hand))
        yield Region("hatch", (*outline, *(ring[::-1] for ring in pockets)), hatch=_HATCH[part.name])
        yield Region("outline", outline, part.name)
        yield from (Region("outline", (ring,)) for ring in pockets)


def _ball(box: Rectangle, layer: str, part: str = "") -> Circle:
    return Circle(layer, ((box[0] + box[1]) / 2, (box[2] + box[3]) / 2), (box[1] - box[0]) / 2, part)


def _pack(section: ClutchSection, box: Rectangle, hand: int) -> Iterator[Shape]:
    """Draw the discs, one a pair, the bypass pairs farthest from the spring, and what carries inner ones."""
    left, right, low, high = box
    step, (inner, outer) = (right - left) / section.pairs, (hand * radius * _MM for radius in section.faces)
    drum = (corners((left, right, *((low, inner) if hand > 0 else (inner, high)))),)
    yield Region("hatch", drum, hatch=_HATCH["pack"])
    yield Region("outline", drum, "pack")
    for number in range(section.pairs):
        disc = left + number * step, left + (number + 1) * step, min(inner, outer), max(inner, outer)
        yield Region("bypass" if number < section.bypass_pairs else "discs", (corners(disc),), "pack")


def _spring(part: DrawnPart, box: Rectangle, layer: str) -> Iterator[Shape]:
    """Draw a spring as the wire of its one coil, or as a zigzag: of discs, or of coils on a circle."""
    left, right, low, high = box
    wire, long = high - low, right - left
    yield Region(layer, (corners(box),), part.name)
    if part.single and wire < 0.4 * long:
        count = min(round(part.turns) + 2, int(long / wire))
        for number in range(count):
            at = left + wire / 2 + (long - wire) * number / (count - 1)
            yield Circle(layer, (at, (low + high) / 2), wire / 2)
    else:
        bends = 2 * min(round(part.turns), 20)
        yield Stroke(layer, tuple((left + long * bend / bends, high if bend % 2 else low) for bend in range(bends + 1)))


def _end_view(section: ClutchSection, middle: float, housing: float, point: float) -> Iterator[Shape]:
    """Draw the view along the axis: housing, faces, hub, key, balls on their circle."""
    inner, outer = (radius * _MM for radius in section.faces)
    yield Circle("faces", (middle, 0.0), outer, hole=inner)
    for radius in filter(None, (housing, section.hub * _MM, section.bore * _MM)):
        yield Circle("outline", (middle, 0.0), radius)
    far = housing + 4 * point
    yield Stroke("centre", ((middle - far, 0.0), (middle + far, 0.0)))
    yield Stroke("centre", ((middle, -far), (middle, far)))
    if bore := 2 * section.bore * _MM:  # the key: 0.3 by 0.2 of the bore, about as ISO 773 has it
        yield Region("assumed", (corners((middle - 0.15 * bore, middle + 0.15 * bore, 0.38 * bore, 0.58 * bore)),))
    if balls := section.part("balls"):
        ((left, right, low, high),) = _rectangles(balls.boxes)
        circle = (low + high) / 2
        yield Circle("centre", (middle, 0.0), circle)
        for number in range(balls.pieces):
            angle = math.pi / 2 + 2 * math.pi * number / balls.pieces
            at = middle + circle * math.cos(angle), circle * math.sin(angle)
            yield Circle("assumed" if balls.assumed else "balls", at, (right - left) / 2, "ball")


def _numbers(section: ClutchSection, length: float, y: float, point: float) -> Iterator[Shape]:
    """Number the parts below the section, each with a line to it."""
    places = []
    for part in section.parts:
        left, right, low, high = max(_rectangles(part.boxes, -1), key=lambda box: (box[1] - box[0]) * (box[3] - box[2]))
        places.append(((left + right) / 2, (low + high) / 2, part.number))
    step = max(length / len(places), 1.6 * TEXT * point)
    for place, (x, middle, number) in enumerate(sorted(places)):
        at = length / 2 + (place + 0.5 - len(places) / 2) * step
        yield Stroke("dimensions", ((x, middle), (at, y + TEXT * point)))
        yield Inscription(str(number), (at, y), "middle")


def _part_list(section: ClutchSection) -> list[list[str]]:
    rows = [[*map(translate, ("No.", "Part", "Count", "Size, mm", "Mass, kg", "Sizes"))]]
    for part in section.parts:
        row = part.row
        inner = f"/{_mm(row.inner_diameter)}" if row.inner_diameter else ""
        size = f"Ø {_mm(row.outer_diameter)}{inner} × {_mm(row.right - row.left)}"
        if part.name == "balls":
            size = f"Ø {_mm(row.right - row.left)}"
        mass = display(row.mass, "kg") if row.mass else "–"
        origin = translate("default *") if part.assumed else translate("given")
        rows.append([str(part.number), translate(row.part, "value"), str(part.pieces), size, mass, origin])
    return rows


_COLUMNS = (0.0, 24.0, 180.0, 230.0, 370.0, 425.0)
"""Where the columns of the part list begin, points."""


def _label(measure: Measure) -> str:
    number = f"Ø {_mm(measure.value)}" if measure.kind == "diameter" else _mm(measure.value)
    text = f"{measure.symbol} = {number}" if measure.symbol else number
    return f"{text} *" if measure.assumed else text


def _mm(value: float) -> str:
    return display(value, "m")


def _caption(section: ClutchSection) -> str:
    sentences = [
        translate("To scale, dimensions in mm; without clearances, bearings, splines and bolts."),
    ]
    if section.travel:
        travel = stated("x_max", section.travel, "m")
        sentences.append(told("Dash-dot-dot: at f_max, the sleeve off its stop by {travel}.", travel=travel))
    elif section.part("balls"):
        sentences.append(translate("By its law nothing of a direct clutch travels: at f_max it is as at rest."))
    if section.bypass_pairs:
        sentences.append(translate("Orange: discs of the pairs that bypass the control unit."))
    if section.overlaps:
        listed = "; ".join(
            told(
                "{first} and {second} by {missing:.4g mm}",
                first=translate(each.first, "value"),
                second=translate(each.second, "value"),
                missing=each.missing,
            )
            for each in section.overlaps
        )
        sentences.append(told("Red: in each other's way are {listed}.", listed=listed))
    if section.assumed:
        filled = ", ".join(
            f"{path} = {measured(value, keys()[path].unit or '')}" for path, value in section.assumed.items()
        )
        sentences.append(told("* and dashed: drawn at a default, for the spec does not give {keys}.", keys=filled))
    if section.bore:
        sentences.append(translate("The key is drawn at 0.3 by 0.2 of the bore."))
    return " ".join(sentences)
