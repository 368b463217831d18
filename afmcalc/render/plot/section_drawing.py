"""The whole clutch in longitudinal section and in end view, to scale, with dimensions and part list."""

import math
from collections.abc import Iterable

from ...analysis.assembly import Box, ClutchSection, DrawnPart, MainDimension
from ...findings import finding
from ...messages import say, translate
from ...spec.catalogues import ball_designation
from ...spec.keys import keys
from .. import drawing as draw
from ..amounts import display, measured
from .chart import Sheet, stated

_MM = 1e3
_HATCH = {"hub": 45.0, "stop ring": 45.0, "thrust disc": 120.0}
"""Part → angle of its hatch lines, for any other part 135 degrees, so that neighbours differ."""
_INSIDE, _OUTSIDE = ("bore", "hub", "ball_circle"), ("inner_diameter", "outer_diameter", "housing")
"""Diameters that are dimensioned to the left, and to the right, of the section."""
_GIVEN = (*_INSIDE, "inner_diameter", "outer_diameter", "face_gap")
"""Dimensions that are numbers of the spec; other dimensions are calculated."""
_LEFT, _BETWEEN, _RIGHT, _ROW = 20.5, 22.0, 2.0, 4.6
"""Space left of, between and right of the views, and height of a row of dimensions or part list, mm on paper."""
_COLUMNS = (0.0, 9.5, 55.0, 67.0, 126.0, 146.0)
"""Left ends of the columns of the part list, mm on paper."""


def section(section: ClutchSection) -> Sheet:
    """Draw a clutch at rest; parts that move are also drawn in their place at f_max."""
    title, assumed = translate("Clutch in section, at rest and at f_max"), ""
    if sizes := [f"{path} = {measured(value, keys()[path].unit or '')}" for path, value in section.assumed.items()]:
        assumed = say("Defaults: {keys}.", keys="; ".join(sizes))
    return Sheet(title, [_drawing(section)], _caption(section), section.name, assumed)


def _drawing(section: ClutchSection) -> draw.Drawing:
    """Lay out both views, the dimensions and the part list."""
    measures = section.measures
    length, radius = measures["length"].high * _MM, measures["housing"].high * _MM
    unit = (length + 2 * radius) / (draw.WIDTH - _LEFT - _BETWEEN - _RIGHT)
    row, left, size = _ROW * unit, -_LEFT * unit, draw.TEXT * unit
    shapes = [*_along(section, length), *_from_the_end(section, length + _BETWEEN * unit + radius, size)]
    # dimensions above the section from right to left, so that no text crosses an extension line
    starts: list[float] = []
    lengths = [each for each in measures.values() if each.low >= 0 and each.key != "length"]
    for each in sorted(lengths, key=lambda each: -each.low):
        drawn = _dimension(each, size)
        text = draw.text_width(drawn.label, size)
        end = each.high * _MM + (0.0 if text < (each.high - each.low) * _MM else text + row)
        level = next((level for level, start in enumerate(starts) if end < start), len(starts))
        starts[level : level + 1] = [each.low * _MM - row]
        shapes.append(drawn._replace(line=radius + (level + 1) * row))
    for side, step, names in ((0.0, -1.15 * row, _INSIDE), (length, 1.15 * row, _OUTSIDE)):
        diameters = sorted((measures[name] for name in names if name in measures), key=lambda each: each.high)
        shapes += [_dimension(each, size, side + place * step) for place, each in enumerate(diameters, 1)]
    shapes += _numbers(section, length, -radius - 1.8 * row, size)
    shapes.append(_dimension(measures["length"], size, -radius - 3.1 * row, -1))
    table, top = _part_list(section), -radius - 4.8 * row
    cells = [
        draw.Inscription(cell, (left + (1.4 + column) * unit, top - number * row), size)
        for number, texts in enumerate(table)
        for cell, column in zip(texts, _COLUMNS, strict=True)
        if cell
    ]
    frame = left, top - (len(table) - 0.4) * row, left + draw.WIDTH * unit, radius + (len(starts) + 1) * row
    return draw.Drawing([*shapes, *cells], frame, cells=len(cells))


def _dimension(measure: MainDimension, size: float, line: float = 0.0, hand: int = 1) -> draw.Length:
    low, high, at, upright = measure.low * _MM, measure.high * _MM, hand * measure.at * _MM, measure.low < 0
    ends = ((at, low), (at, high)) if upright else ((low, at), (high, at))
    given = measure.key in _GIVEN and not measure.assumed
    length = display(measure.high - measure.low, "m") if given else draw.tenths(measure.high - measure.low)
    number = f"{'Ø ' if upright else ''}{length}{' *' if measure.assumed else ''}"
    label = f"{measure.symbol} = {number}" if measure.symbol else number
    return draw.Length(label, size, *ends, line, upright, measure.key, measure.about)


def _rectangles(boxes: Iterable[Box], hand: int) -> list[draw.Rectangle]:
    """Rectangles of boxes above the axis or, if ``hand`` is −1, below it, mm."""
    both = ((box, (box.inner, box.outer) if hand > 0 else (-box.outer, -box.inner)) for box in boxes)
    return [(box.left * _MM, box.right * _MM, low * _MM, high * _MM) for box, (low, high) in both]


def _along(section: ClutchSection, length: float) -> draw.Shapes:
    """Draw the section along the axis, on both sides of the axis."""
    yield draw.Stroke("centre", ((-0.03 * length, 0.0), (1.03 * length, 0.0)))
    for hand in (1, -1):
        for part in section.parts.values():
            yield from _part(section, part, hand)
            for box in _rectangles(part.moved, hand):
                yield _ball(box, "ghost") if part.name == "balls" else draw.rectangle("ghost", box)
        for one, other, _ in section.overlaps:
            boxes = (same for box in section.parts[one].boxes for same in box.common(section.parts[other].boxes))
            for box in _rectangles(boxes, hand):
                yield draw.rectangle("overlap", box, f"{one}/{other}")


def _part(section: ClutchSection, part: DrawnPart, hand: int) -> draw.Shapes:
    boxes = _rectangles(part.boxes, hand)
    left, right, low, high = boxes[0]
    if part.name == "balls":
        over, middle = 0.1 * (right - left), (low + high) / 2
        yield _ball(boxes[0], "assumed" if part.assumed else "balls", part.name)
        yield draw.Stroke("centre", ((left - over, middle), (right + over, middle)))
    elif part.turns:
        yield from _spring(part, boxes[0])
    elif part.name == "pack":
        # a disc for each friction pair, the bypass pairs farthest from the spring, and the carrier of the inner discs
        face, wide = hand * section.measures["inner_diameter"].high * _MM, right - left
        carrier, discs = ((low, face), (face, high)) if hand > 0 else ((face, high), (low, face))
        yield from _cut(part, [(left, right, *carrier)], [])
        for number in range(part.pieces):
            disc = left + number * wide / part.pieces, left + (number + 1) * wide / part.pieces, *discs
            yield draw.rectangle("bypass" if number < section.bypass_pairs else "discs", disc, part.name)
    else:
        yield from _cut(part, boxes, _rectangles(part.pockets, hand))


def _cut(part: DrawnPart, boxes: list[draw.Rectangle], pockets: list[draw.Rectangle]) -> draw.Shapes:
    outline, holes = draw.outlines(boxes), draw.outlines(pockets)
    inside_out = (hole[::-1] for hole in holes)
    yield draw.Region("hatch", (*outline, *inside_out), hatch=_HATCH.get(part.name, 135.0))
    yield draw.Region("outline", outline, part.name)
    yield from (draw.Region("outline", (hole,)) for hole in holes)


def _ball(box: draw.Rectangle, layer: str, part: str = "") -> draw.Circle:
    return draw.Circle(layer, draw.middle(box), (box[1] - box[0]) / 2, part)


def _spring(part: DrawnPart, box: draw.Rectangle) -> draw.Shapes:
    """Draw a spring: the wire of a single coil spring, or a zigzag for disc springs and coil springs on a circle."""
    (left, right, low, high), layer = box, "assumed" if part.assumed else "springs"
    wire, long = high - low, right - left
    yield draw.rectangle(layer, box, part.name)
    if part.pieces == 1 and wire < 0.4 * long:
        count = min(round(part.turns) + 2, int(long / wire))
        places = (left + wire / 2 + (long - wire) * number / (count - 1) for number in range(count))
        yield from (draw.Circle(layer, (at, (low + high) / 2), wire / 2) for at in places)
    else:
        bends = 2 * min(round(part.turns), 20)
        points = ((left + long * bend / bends, high if bend % 2 else low) for bend in range(bends + 1))
        yield draw.Stroke(layer, tuple(points))


def _from_the_end(section: ClutchSection, middle: float, size: float) -> draw.Shapes:
    """Draw the view along the axis: housing, friction faces, hub, feather key, balls on their circle."""
    radii = {name: measure.high * _MM for name, measure in section.measures.items() if measure.low < 0}
    yield draw.Circle("faces", (middle, 0.0), radii["outer_diameter"], hole=radii["inner_diameter"])
    yield from (
        draw.Circle("outline", (middle, 0.0), radii[name]) for name in ("housing", "hub", "bore") if name in radii
    )
    far = radii["housing"] + 0.4 * size
    yield draw.Stroke("centre", ((middle - far, 0.0), (middle + far, 0.0)))
    yield draw.Stroke("centre", ((middle, -far), (middle, far)))
    if bore := 2 * radii.get("bore", 0.0):  # the shaft key: 0.3 by 0.2 of the bore, about as in ISO 773
        yield draw.rectangle("assumed", (middle - 0.15 * bore, middle + 0.15 * bore, 0.38 * bore, 0.58 * bore))
    if balls := section.parts.get("balls"):
        circle, ball = radii["ball_circle"], (balls.row.right - balls.row.left) / 2 * _MM
        yield draw.Circle("centre", (middle, 0.0), circle)
        for number in reversed(range(balls.pieces)):  # the last ball is at the top
            angle = math.pi * (0.5 + 2 * number / balls.pieces)
            at = middle + circle * math.cos(angle), circle * math.sin(angle)
            yield draw.Circle("assumed" if balls.assumed else "balls", at, ball)
        label = f"{balls.pieces} × Ø {display(2 * ball / _MM, 'm')}{' *' if balls.assumed else ''}"
        corner, wide = (middle + far, 0.93 * radii["housing"]), draw.text_width(label, size)
        yield draw.Inscription(label, corner, size, "end")
        yield draw.Stroke("dimensions", ((at[0], at[1] + ball), (corner[0] - wide / 2, corner[1] - 0.3 * size)))


def _numbers(section: ClutchSection, length: float, y: float, size: float) -> draw.Shapes:
    """Write the numbers of the parts below the section, each with a line to its part."""
    places = []
    for part in section.parts.values():
        boxes = _rectangles(part.boxes, -1)
        largest = max(boxes, key=lambda box: (box[1] - box[0]) * (box[3] - box[2]))
        places.append((*draw.middle(largest), part.number))
    # in the middle of equal steps along the length and beyond it, so that no number is on a line of its dimension
    within = max(1, min(len(places), int(length / (2 * size))))
    for place, (x, middle, number) in enumerate(sorted(places), (within - len(places)) // 2):
        at = (place + 0.5) * length / within
        yield draw.Stroke("dimensions", ((x, middle), (at, y + size)))
        yield draw.Inscription(str(number), (at, y), size, "middle")


def _part_list(section: ClutchSection) -> list[list[str]]:
    """Cells of the part list: headings, a row for each part, and the sum of the known masses."""
    rows = [[*map(translate, ("Item", "Part", "Count", "Size, mm", "Mass, kg", "Sizes"))]]
    for part in section.parts.values():
        row, long = part.row, draw.tenths(part.row.right - part.row.left)
        inner = f"/{draw.tenths(row.inner_diameter)}" if row.inner_diameter else ""
        size = f"Ø {draw.tenths(row.outer_diameter)}{inner} × {long}"
        if part.name == "balls":
            size = translate(ball_designation(row.right - row.left) or f"Ø {display(row.right - row.left, 'm')}")
        origin = translate("default *" if part.assumed else "given")
        mass = display(row.mass or None, "kg")
        rows.append([str(part.number), translate(part.name, "value"), str(part.pieces), size, mass, origin])
    return [*rows, ["", "", "", "", "Σ " + display(sum(part.row.mass for part in section.parts.values()), "kg"), ""]]


def _caption(section: ClutchSection) -> str:
    said = [translate("To scale, dimensions in mm; without clearances, bearings, splines and bolts.")]
    if section.travel:
        travel = stated("x_max", section.travel, "m")
        said.append(say("Dash-dot-dot: at f_max, the sleeve off its stop by {travel}.", travel=travel))
    elif "balls" in section.parts:
        said.append(translate("By its law nothing of a direct clutch travels: at f_max it is as at rest."))
    if section.bypass_pairs:
        said.append(translate("Orange: discs of the pairs that bypass the control unit."))
    for one, other, missing in section.overlaps:
        overlap = finding("parts-collide", "error", value=missing, first=translate(one), second=translate(other))
        said.append(say("Red: {overlap}.", overlap=overlap.message))  # as the command check says
    if section.assumed:
        said.append(translate("* and dashed: drawn at a default, for the spec does not give it."))
    if "bore" in section.measures:
        said.append(translate("The key is drawn at 0.3 by 0.2 of the bore."))
    return " ".join(said)
