"""Section through a ball and its two pockets (A–A in the papers), to scale: a figure, and part of a shop drawing."""

import math
from collections.abc import Callable

from ...analysis.pocket_contours import ShopDrawing
from ...analysis.synthesize import SynthesisResult
from ...messages import localized, say, translate
from .. import drawing as draw
from ..amounts import display
from .chart import Sheet, stated

Label = Callable[[str, float], str]
"""Function that returns the text of a dimension from its symbol and its length, m."""
_BESIDE, _BETWEEN, _HIGH = 62, 46, 210
"""Space for dimensions beside and between the two positions of the ball; largest height of both, mm on paper."""


def pocket(drawing: ShopDrawing) -> Sheet:
    """Draw the ball with the sleeve at the stop and, if the sleeve travels, at the largest travel."""
    found, titles = drawing.synthesis, [(0.0, "")]
    if travel := found.travel_max:
        moved = say("at f_max, {stated}", stated=stated("x_max", travel, "m"))
        titles = [(0.0, translate("at the stop, x = 0")), (travel, moved)]
    back, side = (1e3 * end for end in drawing.extent)
    unit = max(2 * back / (draw.WIDTH - _BESIDE), 2 * side / (_HIGH / len(titles) - _BETWEEN))
    size, high, right = draw.TEXT * unit, 2 * side + _BETWEEN * unit, draw.WIDTH / 2 * unit
    steepness = (math.tan(found.wall_angle) + math.tan(found.wall_angle_max or found.wall_angle)) / 2
    shapes = list[draw.Shape]()
    for number, (travel, title) in enumerate(titles):
        # the sleeves off their stop; with a curved wall one sleeve seats the ball, the other is turned to touch it
        up, first = -number * high, travel if found.wall is not None else travel / 2
        faces = 1e3 * (found.face_gap / 2 + first), 1e3 * (found.face_gap / 2 + travel - first)
        for name, hand, face in zip(("SLEEVE_1", "SLEEVE_2"), (1, -1), faces, strict=True):
            off = face - 500 * found.face_gap
            shapes += sleeve(drawing, name, hand * off, up + hand * off * steepness)
        shapes.append(draw.Circle("balls", (0.0, up), found.ball_diameter * 500))
        for x, y in ((1.04 * back, 0.0), (0.0, 1.04 * side)):
            shapes.append(draw.Stroke("centre", ((-x, up - y), (x, up + y))))
        if title:
            shapes.append(draw.Inscription(title, (size - right, side + 26 * unit + up), size))
        if travel:
            label, low = f"s + x = {draw.tenths(found.face_gap + travel)}", up - side
            shapes.append(draw.Length(label, size, (-faces[1], low), (faces[0], low), low - 8 * unit))
    shapes += dimensions(drawing, unit, size, lambda symbol, length: f"{symbol} = {draw.tenths(length)}")
    frame = -right, high - side - 14 * unit - len(titles) * high, right, side + 30 * unit
    title = translate("Ball and pockets, section A–A")
    return Sheet(title, [draw.Drawing(shapes, frame)], _caption(found), drawing.name)


def sleeve(drawing: ShopDrawing, name: str, x: float = 0.0, y: float = 0.0) -> draw.Shapes:
    """Draw one of the sleeves with its pocket, displaced by ``x`` and ``y`` (mm) from its place at the stop."""
    contour = tuple((along + x, around + y) for along, around in contours(drawing)[name])
    yield draw.Region("hatch", (contour,), hatch=45.0 if name == "SLEEVE_1" else 135.0)
    yield draw.Region(name.lower(), (contour,))


def contours(drawing: ShopDrawing) -> dict[str, draw.Polyline]:
    """Points of every contour by its layer, mm."""
    return {each.layer: tuple((1e3 * x, 1e3 * y) for x, y in each.points) for each in drawing.contours}


def dimensions(drawing: ShopDrawing, k: float, text: float, label: Label) -> draw.Shapes:
    """Draw dimensions of pockets and sleeves at the stop; ``k``: millimetres of the drawing for one on paper."""
    unit, shop = drawing.synthesis, drawing.sleeve
    points = contours(drawing)
    (face, half), (back, side) = points["POCKET_1"][-1], points["SLEEVE_1"][-1]
    other, groove = points["POCKET_2"][0], shop.groove * 500
    floor = face + unit.pocket_depth_cut * 1e3
    bottom = floor + shop.relief * 1e3
    yield draw.Length(label("h_c", unit.pocket_depth_cut), text, (face, half), (floor, groove), side + 6 * k)
    relieved = label("h", unit.pocket_depth_cut + shop.relief)
    yield draw.Length(relieved, text, (face, half), (bottom, groove), side + 13 * k)
    star = "*" * ("depth" in shop.assumed)
    yield draw.Length(label("B", shop.depth) + star, text, (face, side), (back, side), side + 20 * k)
    yield draw.Length(display(unit.face_gap, "m"), text, (-face, -side), (face, -side), -side - 8 * k)
    yield draw.Length(label("g", shop.groove), text, (bottom, -groove), (bottom, groove), back + 8 * k, upright=True)
    yield draw.Length(label("b", unit.pocket_width), text, (face, -half), (face, half), back + 16 * k, upright=True)
    if abs(other[1]) < half:
        ends = (-face, -abs(other[1])), (-face, abs(other[1]))
        yield draw.Length(label("b_2", abs(other[1]) / 500), text, *ends, -back - 8 * k, upright=True)
    ball = unit.ball_diameter * 500
    yield draw.Diameter(localized(f"Ø{2 * ball:.6g}"), text, (0.0, 0.0), ball, 115.0)
    slope, reach = math.tan(unit.wall_angle), 0.75 * (floor - face)
    apex = ball / math.sin(unit.wall_angle)
    first, second = ((floor - reach, hand * (groove + reach * slope)) for hand in (1, -1))
    angle = localized(f"{math.degrees(2 * unit.wall_angle):.5g}°")
    yield draw.Angle(angle, text, (apex, 0.0), first, second, apex - min(face + reach, apex - 10 * k))


def _caption(found: SynthesisResult) -> str:
    ball, near = stated("d_ш", found.ball_diameter, "m"), found.edge_clearance_standard
    if found.ball_diameter_standard is None:
        drawn = say("Drawn with {ball}, for no standard ball is that large.", ball=ball)
    elif near is None:
        drawn = say("Drawn with {ball}.", ball=ball)
    else:
        drawn = say(
            "Drawn with {ball}, which leaves {clearance} to the edge.", ball=ball, clearance=stated("y", near, "m")
        )
    sentences = [
        say(
            "To scale, dimensions in mm. Cylindrical section at the ball circle ({circle}), axis of clutch "
            "horizontal. S21 (20), (23), (24): smallest ball {smallest}.",
            circle=stated("r", found.ball_circle_radius, "m"), smallest=stated("r_ш", found.ball_radius, "m"),
        ),
        drawn,
        translate("Cut to h_c, where the ball ends; below it a groove keeps the ball off the floor."),
    ]  # fmt: skip
    if found.contact_force is not None:
        sentences.append(say("On one ball {force}.", force=stated("F_n", found.contact_force, "N")))
    if found.web is not None:
        sentences.append(say("The web between pockets is {web}.", web=stated("e", found.web, "m")))
    if found.wall_angle_max is not None:
        angle = found.wall_angle_max
        sentences.append(say("Curved wall: at the largest travel α = {angle:.4g deg}.", angle=angle))
    return " ".join(sentences)
