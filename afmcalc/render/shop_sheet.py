"""Shop drawings on an A3 sheet with frame, title block and notes: the sleeves with pockets, the clutch.

Parts are drawn in true millimetres; the sheet (texts, arrows, frame) is scaled instead, by the inverse of the scale of
the drawing.
"""

import math
import re
import textwrap
from collections.abc import Sequence
from typing import Any

from ..analysis.assembly import ClutchSection
from ..analysis.pocket_contours import ShopDrawing
from ..messages import filled, localized, named, say, translate
from ..spec import Spec
from ..spec.models import ShopNotes, TitleBlock
from . import drawing as draw
from .amounts import display
from .plot import pocket_drawing as pockets
from .plot.section_drawing import section as laid_out

_TITLE_TEXT, _TEXT, _SMALL, _LETTER, _LINE = 7.0, 5.0, 3.5, 0.54, 4.2
"""Sizes of titles, text and notes on paper, mm; largest letter width over font size; line spacing of notes, mm."""
_SCALES = (20, 10, 5, 4, 2.5, 2, 1, 0.5, 0.4, 0.25, 0.2, 0.1, 0.05, 0.02)
_WIDE, _HIGH, _TITLE = 420, 297, (185, 55)
_LEFT, _EDGE = 20, 5
"""Margins of the sheet, mm: the left margin, and each of the other margins."""


class ShopSheet:
    """A sheet around a drawing; places on paper are millimetres from the lower left corner of the sheet."""

    scale = 1.0
    origin = 0.0, 0.0
    """Place of the drawing's origin on paper, mm."""

    def __init__(
        self, spec: Spec, title: str, said: Sequence[Any], *below: str, mass: str = "", material: str | None = ""
    ) -> None:
        """Reserve the space of title block and notes: the numbered notes of the spec and ``said``, then ``below``.

        Empty notes are left out.
        """
        shop = _notes(spec)
        first = (
            shop.hardness and say("hardness of the pocket walls {hardness}", hardness=shop.hardness),
            shop.tolerance
            and say(
                "limit deviations of dimensions that show none: {tolerance}; the same for the division, along the ball "
                "circle, and for wall angles, across the wall",
                tolerance=shop.tolerance,
            ),
        )
        numbered = enumerate(filter(None, (*first, *said)), 1)
        texts = [*(f"{number}. {text[0].upper()}{text[1:].rstrip('.')}." for number, text in numbered), *below]
        letters = int((_WIDE - _LEFT - _EDGE - _TITLE[0] - 6) / (_SMALL * _LETTER))
        self.notes = [line for text in texts for line in textwrap.wrap(text, letters, subsequent_indent="    ")]
        self.low = _EDGE + max(_TITLE[1], _LINE * len(self.notes) + 4)
        self.free = _WIDE - _LEFT - _EDGE, _HIGH - self.low - _EDGE
        self.spec, self.title, self.mass, self.material = spec, title, mass, material
        digits = re.search(r"[.,](\d+)", shop.tolerance or "")
        self.places = len(digits[1]) if digits else 1

    @property
    def unit(self) -> float:
        """Millimetres of the drawing for one millimetre of paper."""
        return 1 / self.scale

    def at(self, x: float, y: float) -> draw.Point:
        """Point of the paper, mm, in drawing coordinates."""
        return (x - self.origin[0]) * self.unit, (y - self.origin[1]) * self.unit

    @property
    def text(self) -> float:
        """Font size of the texts, mm of the drawing."""
        return _TEXT * self.unit

    def length(self, value: float) -> str:
        """Calculated length (m) as text in mm, with as many decimals as the tolerance in the spec, else to a tenth."""
        return localized(f"{round(1e3 * value, self.places):.9g}")

    def drawing(self, shapes: Sequence[draw.Shape]) -> draw.Drawing:
        """Drawing of the shapes with frame, title block and notes."""
        frame = *self.at(0, 0), *self.at(_WIDE, _HIGH)
        return draw.Drawing([*shapes, *self._surround()], frame, _WIDE)

    def _surround(self) -> draw.Shapes:
        spec, block = self.spec, self.spec.report or TitleBlock()
        roles = map(translate, ("Approved", "Standards", "Checked", "Drawn"))
        names = block.approved, block.norm_control, block.checked, block.author
        people = zip((0, 5, 15, 20), roles, names, strict=True)
        cells = [
            *(cell for y, role, who in people for cell in ((0, y, 22, 5, role), (22, y, 28, 5, who))),
            (50, 20, 15, 5, block.date), (0, 40, 65, 15, block.project), (0, 25, 65, 15, block.revision),
            (65, 40, 120, 15, block.drawing),
            (65, 27, 70, 13, named(spec.name)), (65, 15, 70, 12, self.title), (65, 0, 70, 15, self.material),
            (135, 35, 25, 5, translate("Mass (kg)")), (135, 20, 25, 15, self.mass or "–"),
            (160, 35, 25, 5, translate("Scale")), (160, 20, 25, 15, _stated(self.scale)),
            (135, 15, 50, 5, translate("Sheet 1 of 1")), (135, 0, 50, 15, block.organisation),
        ]  # fmt: skip
        x = _WIDE - _EDGE - _TITLE[0]
        yield self._box("frame", _LEFT, _EDGE, self.free[0], _HIGH - 2 * _EDGE)
        for left, low, width, height, text in cells:
            yield self._box("title", x + left, _EDGE + low, width, height)
            if text:
                size = min(_TITLE_TEXT, 0.7 * height, (width - 2) / (_LETTER * len(text)))
                middle = self.at(x + left + width / 2, _EDGE + low + height / 2 - 0.35 * size)
                yield draw.Inscription(text, middle, size * self.unit, "middle", ours=False)
        for row, note in enumerate(self.notes, 1):
            yield draw.Inscription(note, self.at(_LEFT + 4, self.low - _LINE * row), _SMALL * self.unit, ours=False)

    def _box(self, layer: str, left: float, low: float, width: float, height: float) -> draw.Region:
        corner, (right, top) = self.at(left, low), self.at(left + width, low + height)
        return draw.rectangle(layer, (corner[0], right, corner[1], top))


def largest_scale(size: draw.Point, free: draw.Point) -> float:
    """Largest standard scale at which ``size`` fits into ``free``, both in mm; else the smallest standard scale."""
    fits = (scale for scale in _SCALES if all(a * scale <= b for a, b in zip(size, free, strict=True)))
    return next(fits, _SCALES[-1])


def _stated(scale: float) -> str:
    number = localized(f"{max(scale, 1 / scale):g}")
    return f"{number}:1" if scale >= 1 else f"1:{number}"


def _notes(spec: Spec) -> ShopNotes:
    """The [drawing] block of a spec."""
    return spec.drawing or ShopNotes()


def _said(drawing: ShopDrawing) -> list[Any]:
    """Notes of a pocket drawing; a note that does not apply is empty."""
    ball, sleeve = drawing.synthesis, drawing.sleeve
    near = ball.edge_clearance_standard or 0.0
    wall = say("straight walls, angle to the axis {angle:.4f deg}", angle=ball.wall_angle)
    if ball.wall_angle_max is not None:
        wall = say(
            "curved wall, angle to the axis {angle:.4f deg} at the stop, {most:.4f deg} at x = {travel:.4f mm}",
            angle=ball.wall_angle, most=ball.wall_angle_max, travel=ball.travel_max,
        )  # fmt: skip
    return [
        say("{name}: pocket, cylindrical section at the ball circle, radius {radius:.5g mm}, unrolled; mm, sleeves at "
            "the stop", name=named(drawing.name), radius=ball.ball_circle_radius),
        say(
            "pocket {width:.1f mm} wide at the face, cut to {depth:.1f mm}; ball {ball:.5g mm}, gap {gap:g mm}",
            width=ball.pocket_width, depth=ball.pocket_depth_cut, ball=ball.ball_diameter, gap=ball.face_gap,
        ),
        ball.wear_play and say(
            "drawn with the pack worn: as new the sleeves are {apart:.4g mm} apart, with {play:.4g mm} of play",
            apart=ball.face_gap + ball.wear_play, play=ball.wear_play,
        ),
        ball.ball_designation and say("{ball}, of a grade for the designer to set", ball=ball.ball_designation),
        wall,
        say("relief under the ball {groove:.4g mm} wide and {relief:g mm} deep, corners R {corner:g mm} at most: "
            "the ball touches the walls only", groove=sleeve.groove, relief=sleeve.relief, corner=sleeve.relief / 2),
        say(
            "1 mm around the ball circle is {turn:.5g deg} of a turn: walls and grooves run towards the axis, from "
            "the rim to R {end:.5g mm}",
            turn=1e-3 / ball.ball_circle_radius, end=sleeve.pocket_end,
        ),
        translate(
            "contours to cut in true millimetres on layers POCKET_1 and POCKET_2; "
            "the view of sleeve 1 is to its own scale"
        ),
        near > 0 and say(
            "edges of the pockets at the face broken by {most:.2g mm} at most: the ball touches as near as "
            "{near:.3g mm}",
            most=near / 5, near=near,
        ),
    ]  # fmt: skip


def pocket(drawing: ShopDrawing) -> draw.Drawing:
    """Draw both sleeves in section at the ball circle (origin: the ball's centre), and the first sleeve in end view."""
    unit, sleeve = drawing.synthesis, drawing.sleeve
    back, side = (1e3 * end for end in drawing.extent)
    outer = sleeve.outer_diameter * 1e3
    below = [translate("* not in the spec: drawn at a default, for the designer to set")] if sleeve.assumed else []
    mass = "; ".join(localized(f"{each:.3g}") for each in drawing.masses)
    title, material = translate("Sleeves with ball pockets"), _notes(drawing.spec).material
    sheet = ShopSheet(drawing.spec, title, _said(drawing), *below, mass=mass, material=material)
    wide, high = sheet.free
    own = largest_scale((outer, outer), (_WIDE / 2 - 33, high - 36))
    left = own * outer + 74
    sheet.scale = largest_scale((2 * back, 2 * side), (wide - left - 60, high - 64))
    middle = (sheet.low + _HIGH - _EDGE) / 2 - 4
    sheet.origin = (left + _WIDE - 18) / 2, middle

    shapes: list[draw.Shape] = [draw.Circle("ball", (0.0, 0.0), unit.ball_diameter * 500)]
    *closed, path = pockets.contours(drawing).items()
    shapes += [
        draw.Region(name.lower(), (points,)) for name, points in closed[2:]
    ]  # sleeves are drawn with their hatches
    shapes.append(draw.Stroke("path", path[1]))
    for name, hand in (("SLEEVE_1", 1), ("SLEEVE_2", -1)):
        shapes += pockets.sleeve(drawing, name)
        place = hand * back / 2, -side - 9 * sheet.unit
        shapes.append(draw.Inscription(name[-1], place, _TITLE_TEXT * sheet.unit, "middle"))
    shapes += pockets.dimensions(drawing, sheet.unit, sheet.text, lambda _, length: sheet.length(length))
    for x, y in ((back + 3 * sheet.unit, 0.0), (0.0, side + 3 * sheet.unit)):
        shapes.append(draw.Stroke("centre", ((-x, -y), (x, y))))
    shapes += _roughness(sheet, drawing)
    x = _LEFT + 52 + own * outer / 2
    shapes += _end_view(sheet, drawing, sheet.at(x, middle), own / sheet.scale)
    title = say("A–A ({scale}), unrolled", scale=_stated(sheet.scale))
    shapes.append(draw.Inscription(title, (0.0, side + 30 * sheet.unit), _TITLE_TEXT * sheet.unit, "middle"))
    title = filled("Sleeve 1 ({scale})" if unit.wall else "Sleeve 1, sleeve 2 alike ({scale})", {"scale": _stated(own)})
    shapes.append(draw.Inscription(title, sheet.at(_LEFT + 8, _HIGH - 15), _TITLE_TEXT * sheet.unit))
    return sheet.drawing(shapes)


def _roughness(sheet: ShopSheet, drawing: ShopDrawing) -> draw.Shapes:
    """Draw the roughness symbol of the pocket walls, if the spec gives their roughness."""
    unit, k, groove = drawing.synthesis, sheet.unit, drawing.sleeve.groove * 500
    floor, (back, side) = 1e3 * (unit.face_gap / 2 + unit.pocket_depth_cut), (1e3 * end for end in drawing.extent)
    if rough := _notes(drawing.spec).roughness:
        wall = pockets.contours(drawing)["POCKET_1"]
        x, y = next(point for point in wall[1:] if -point[1] > groove + 1e-9)
        tip, knee = ((x + floor) / 2, (y - groove) / 2), (back + 4 * k, -side - 12 * k)
        yield from draw.leader("", tip, knee, sheet.text)
        sign = (1.0, 3.5), (3.0, 0.0), (7.0, 7.0), (16.0, 7.0)
        for line in (sign, ((0.0, 0.0), (3.0, 0.0)), ((1.0, 3.5), (5.0, 3.5))):
            yield draw.Stroke("dimensions", tuple((knee[0] + a * k, knee[1] + b * k) for a, b in line))
        yield draw.Inscription(rough, (knee[0] + 7 * k, knee[1] + 2.5 * k), sheet.text, ours=False)


def _end_view(sheet: ShopSheet, drawing: ShopDrawing, centre: draw.Point, shrunk: float) -> draw.Shapes:
    """Draw the first sleeve seen from its pockets, at the scale ``shrunk`` relative to the section."""
    unit, sleeve, k, given = drawing.synthesis, drawing.sleeve, sheet.unit, drawing.spec.control_unit
    count, circle, text = (given and given.balls) or 1, unit.ball_circle_radius, sheet.text
    rim, bore, end, pitch, ball = (
        each * 500 * shrunk
        for each in (sleeve.outer_diameter, sleeve.bore, 2 * sleeve.pocket_end, 2 * circle, unit.ball_diameter)
    )
    up, step = math.pi / 2, 2 * math.pi / count
    wide, groove = unit.pocket_width / 2 / circle, sleeve.groove / 2 / circle

    def at(radius: float, angle: float) -> draw.Point:
        return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)

    for layer, radius in (("end_view", rim), ("end_view", bore), ("centre", pitch)):
        yield draw.Circle(layer, centre, radius)
    for turn in (up - number * step for number in range(count)):
        floor = (at(end, turn + wide * (1 - share / 8)) for share in range(17))
        yield draw.Stroke("end_view", (at(rim, turn + wide), *floor, at(rim, turn - wide)))
        for side in (-groove, groove):
            yield draw.Stroke("end_view", (at(end, turn + side), at(rim, turn + side)))
        yield draw.Stroke("centre", (at(end - 3 * k, turn), at(rim + 4 * k, turn)))
        yield draw.Circle("ball", at(pitch, turn), ball)
    for turn in (0.0, up):
        yield draw.Stroke("centre", (at(-bore - 4 * k, turn), at(bore + 4 * k, turn)))
    hole = sheet.length(sleeve.bore) + "*" if "bore" in sleeve.assumed else display(sleeve.bore, "m")
    yield draw.Diameter(f"Ø{hole}", text, centre, bore, 30.0, shrunk)
    left = centre[0] - rim
    depth = sheet.length(sleeve.outer_diameter / 2 - sleeve.pocket_end)
    yield draw.Length(depth, text, at(end, up), at(rim, up), left - 8 * k, upright=True, shrunk=shrunk)
    sizes = (pitch, display(2 * circle, "m")), (rim, sheet.length(sleeve.outer_diameter) + "*")
    for away, (radius, said) in zip((17, 26), sizes, strict=True):
        ends = at(-radius, up), at(radius, up)
        yield draw.Length(f"Ø{said}", text, *ends, left - away * k, upright=True, shrunk=shrunk)
    if count > 2:
        division = localized(f"{count}×{360 / count:.6g}°")
        yield draw.Angle(division, text, centre, at(rim, up - step), at(rim, up), rim + 9 * k)
    tip = at(pitch, -up + step / 2 if count > 1 else -up)
    yield from draw.leader("A–A", tip, at(1.2 * rim, -0.3 * math.pi), text)


def section(clutch: ClutchSection, spec: Spec) -> draw.Drawing:
    """Draw the whole clutch, laid out by ``plot.section_drawing``."""
    page = laid_out(clutch)
    drawing = page.panels[0]
    shop = _notes(spec)
    mass = localized(f"{sum(part.row.mass for part in clutch.parts.values()):.3g}")
    of_sleeves = (
        shop.material and say("material of the sleeves with pockets {material}", material=shop.material),
        shop.roughness and say("roughness of the pocket walls {roughness}", roughness=shop.roughness),
    )
    sheet = ShopSheet(spec, page.title, [*of_sleeves, page.caption], mass=mass)
    left, low, right, high = drawing.frame
    size = right - left, high - low
    sheet.scale = largest_scale(size, sheet.free)
    x, y = ((room - sheet.scale * wide) / 2 for room, wide in zip(sheet.free, size, strict=True))
    sheet.origin = _LEFT + x - left * sheet.scale, sheet.low + y - low * sheet.scale
    return sheet.drawing(drawing.shapes)
