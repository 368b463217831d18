"""Drawings for the shop as DXF R2010, in true millimetres on a sheet A3 with a frame, a title block and notes.

What is of the sheet (texts, arrows, frame) is as much smaller than on paper as the drawing is larger there. LibreCAD
takes a font by the name of its text style, sizes of dimensions from the header, and the pattern of a hatch unturned: so
the style is called as its font, header and dimension style both have the sizes, and hatches are lines.
"""

import io
import math
import textwrap
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from ..analysis.section import ClutchSection
from ..analysis.shop import ShopDrawing
from ..messages import localized, named, told, translate
from ..spec import Spec
from ..spec.models import ShopNotes, TitleBlock
from . import drawing as shapes
from .plot.section import section as laid_out
from .shop import CREATOR, LAYERS, notes

if TYPE_CHECKING:
    from ezdxf.layouts.layout import Modelspace

Point: TypeAlias = tuple[float, float]


class Pen(NamedTuple):
    """How the lines of a layer are drawn: number of the colour, line type, width in hundredths of a millimetre."""

    about: str
    colour: int = 7
    line: str = "CONTINUOUS"
    width: int = 25


CENTRE, HIDDEN, GHOST = "CENTER2", "HIDDEN2", "DIVIDE2"
SHEET = {
    "END_VIEW": Pen("a sleeve seen from its pockets", width=50),
    "CENTRE": Pen("centre lines", 1, CENTRE),
    "HATCH": Pen("cut faces", 8, width=18),
    "DIMENSIONS": Pen("dimensions and notes"),
    "TITLE": Pen("title block"),
    "FRAME": Pen("frame of the sheet", width=70),
}
_OF_POCKET = {"PATH": (3, CENTRE, 25), "BALL": (5, GHOST, 25)}
"""Layers of the pocket that are no visible edges."""
_OF_SECTION = {
    "faces": (8, "CONTINUOUS", 18), "discs": (5, "CONTINUOUS", 25), "bypass": (30, "CONTINUOUS", 50),
    "outline": (7, "CONTINUOUS", 50), "assumed": (7, HIDDEN, 25), "springs": (3, "CONTINUOUS", 35),
    "balls": (5, "CONTINUOUS", 50), "ghost": (6, GHOST, 25), "overlap": (1, "CONTINUOUS", 70),
}  # fmt: skip
_STYLE, _FONT = "lc_opengost-br", "arial.ttf"
"""Text style, and its font elsewhere: both have Greek and Cyrillic letters."""
_TEXT, _SMALL, _LETTER, _LINE = 3.5, 2.5, 0.75, 4.2
"""Heights of text and of notes on paper, mm; width of a letter over its height, at most about; from note to note."""
_SCALES = [*map(Fraction, ("20", "10", "5", "4", "2.5", "2", "1", "1/2", "0.4", "1/4", "1/5", "1/10", "1/20", "1/50"))]
_WIDE, _HIGH, _TITLE = 420, 297, (185, 55)
_LEFT, _EDGE = 20, 5
"""Margins of the sheet, mm: to the left, and all others."""


class ShopSheet:
    """A sheet around a drawing: places on paper are millimetres from its lower left corner."""

    space: "Modelspace"
    scale = Fraction(1)
    larger = 1.0
    """How much larger dimensions are written than on other sheets."""
    origin = 0.0, 0.0
    """Where on paper the origin of the drawing is."""

    def __init__(
        self, spec: Spec, title: str, said: Sequence[str], *below: str, mass: str = "", material: str | None = ""
    ) -> None:
        """Reserve what title block and notes need: of the spec, as ``said``, and ``below`` without numbers."""
        shop = spec.drawing or ShopNotes()
        told_first = [
            shop.hardness and told("hardness of the pocket walls {hardness}", hardness=shop.hardness),
            shop.tolerance
            and told(
                "limit deviations of dimensions that show none: {tolerance}; the same for the division, along the ball "
                "circle, and for wall angles, across the wall",
                tolerance=shop.tolerance,
            ),
        ]
        numbered = enumerate(filter(None, (*told_first, *said)), 1)
        texts = [*(f"{number}. {text[0].upper()}{text[1:].rstrip('.')}." for number, text in numbered), *below]
        letters = int((_WIDE - _LEFT - _EDGE - _TITLE[0] - 6) / (_SMALL * _LETTER))
        self.notes = [line for text in texts for line in textwrap.wrap(text, letters, subsequent_indent="    ")]
        self.low = _EDGE + max(_TITLE[1], _LINE * len(self.notes) + 4)
        self.free = _WIDE - _LEFT - _EDGE, _HIGH - self.low - _EDGE
        self.spec, self.title, self.mass, self.material = spec, title, mass, material

    @property
    def unit(self) -> float:
        """Millimetres of the drawing that one of the paper is."""
        return float(1 / self.scale)

    def at(self, x: float, y: float) -> Point:
        """Place of the drawing at a place of the paper."""
        return (x - self.origin[0]) * self.unit, (y - self.origin[1]) * self.unit

    def text(
        self, text: str, at: Point, height: float = _TEXT, width: float = math.inf, align: str = "LEFT", turn: float = 0
    ) -> None:
        """Write a text, smaller where it is wider than ``width`` on paper."""
        from ezdxf.enums import TextEntityAlignment

        height = min(height, width / (_LETTER * max(1, len(text)))) * self.unit
        on = {"layer": "DIMENSIONS", "style": _STYLE, "height": height, "rotation": turn}
        self.space.add_text(text, dxfattribs=on).set_placement(at, align=TextEntityAlignment[align])

    def lines(self, layer: str, *points: Point, close: bool = False) -> None:
        """Draw a line through places."""
        self.space.add_lwpolyline(points, close=close, dxfattribs={"layer": layer})

    def circle(self, layer: str, centre: Point, radius: float) -> None:
        """Draw a circle."""
        self.space.add_circle(centre, radius, dxfattribs={"layer": layer})

    def hatch(self, contours: Iterable[Sequence[Point]], angle: float, layer: str = "HATCH", step: float = 3) -> None:
        """Hatch what is within closed contours, a line every ``step`` on paper."""
        from ezdxf.math import Vec2
        from ezdxf.render.hatching import HatchBaseLine, hatch_polygons

        way = Vec2.from_deg_angle(angle)
        base = HatchBaseLine(Vec2(0, 0), way, way.orthogonal() * step * self.unit)
        for line in hatch_polygons(base, [[Vec2(point) for point in points] for points in contours]):
            self.space.add_line(line.start, line.end, dxfattribs={"layer": layer})

    def dimension(self, kind: str, *places: Any, text: str = "<>", shrunk: float = 1.0, **more: Any) -> None:
        """Draw a dimension, of what is drawn ``shrunk``."""
        style = {"dimlfac": 1 / shrunk} | ({"dimtix": 1} if kind == "diameter_dim" else {})
        add = getattr(self.space, f"add_{kind}")
        on = {"layer": "DIMENSIONS"}
        add(*places, text=text, dimstyle="SHOP", override=style, dxfattribs=on, **more).render()

    def leader(self, tip: Point, knee: Point, text: str, *, rough: bool = False) -> None:
        """Draw an arrow from a text to its place, with the sign of a machined surface where it is of roughness."""
        k, (x, y), wide = self.unit, knee, _LETTER * _TEXT * len(text)
        along, across = ((3 * k * (b - a) / math.dist(tip, knee)) for a, b in zip(tip, knee, strict=True))
        foot = tip[0] + along, tip[1] + across
        side = -across / 6, along / 6
        sides = (foot[0] + side[0], foot[1] + side[1]), (foot[0] - side[0], foot[1] - side[1])
        self.space.add_solid((tip, *sides), dxfattribs={"layer": "DIMENSIONS"})
        self.lines("DIMENSIONS", foot, knee, (x + (6 if rough else wide) * k, y))
        if rough:
            sign = (5, 3.5), (1, 3.5), (3, 0), (7, 7), (9 + wide, 7)
            self.lines("DIMENSIONS", *((x + a * k, y + b * k) for a, b in sign))
        self.text(text, (x + 7.5 * k, y + 2.5 * k) if rough else (x + k, y + k))

    def surround(self) -> None:
        """Draw frame, title block and notes."""
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
        x, y = _WIDE - _EDGE - _TITLE[0], _EDGE
        boxes = [("FRAME", _LEFT, y, self.free[0], _HIGH - 2 * _EDGE)]
        for left, low, width, height, text in cells:
            boxes.append(("TITLE", x + left, y + low, width, height))
            middle = self.at(x + left + width / 2, y + low + height / 2)
            self.text(text or "", middle, min(5.0, 0.5 * height), width - 2, "MIDDLE_CENTER")
        for layer, left, low, width, height in boxes:
            corners = (left, low), (left + width, low), (left + width, low + height), (left, low + height)
            self.lines(layer, *(self.at(*corner) for corner in corners), close=True)
        for row, note in enumerate(self.notes, 1):
            self.text(note, self.at(_LEFT + 4, self.low - _LINE * row), _SMALL)


def largest_scale(size: Point, free: Point) -> Fraction:
    """Return the largest scale at which something fits into a part of the paper, or the smallest there is."""
    fits = (scale for scale in _SCALES if all(a * scale <= b for a, b in zip(size, free, strict=True)))
    return next(fits, _SCALES[-1])


def _stated(scale: Fraction) -> str:
    number = localized(f"{float(max(scale, 1 / scale)):g}")
    return f"{number}:1" if scale >= 1 else f"1:{number}"


def written(sheet: ShopSheet, layers: dict[str, Pen], draw: Callable[[], None]) -> bytes:
    """Write a drawing and its sheet: the same one gives the same bytes."""
    import ezdxf
    from ezdxf import units
    from ezdxf.filemanagement import new

    sizes = {
        "dimtxt": _TEXT, "dimasz": 3.0, "dimexo": 0.0, "dimexe": 1.5, "dimgap": 0.8, "dimdec": 3, "dimadec": 3,
        "dimtad": 1, "dimzin": 8, "dimazin": 2, "dimtsz": 0.0, "dimscale": sheet.unit * sheet.larger,
        "dimdsep": ord(localized(".")), "dimtih": 0, "dimtoh": 0, "dimtxsty": _STYLE, "dimblk": "",
    }  # fmt: skip
    options = ezdxf.options  # type: ignore[attr-defined]
    fixed, options.write_fixed_meta_data_for_testing = options.write_fixed_meta_data_for_testing, True
    try:
        document = new("R2010", setup=["linetypes"], units=units.MM)
        document.linetypes.add(HIDDEN, pattern=[3.75, 2.5, -1.25], description="Hidden (.5x) _ _ _ _ _ _ _ _ _ _ _")
        document.styles.add(_STYLE, font=_FONT)
        document.dimstyles.new("SHOP", dxfattribs={**sizes})
        header = {f"${name.upper()}": value for name, value in sizes.items() if value != ""}
        for name, value in (header | {"$DIMSTYLE": "SHOP", "$LTSCALE": sheet.unit / 2, "$LWDISPLAY": 1}).items():
            document.header[name] = value
        for name, pen in (SHEET | layers).items():
            layer = document.layers.add(name, color=pen.colour, linetype=pen.line, lineweight=pen.width)
            layer.description = translate(pen.about)
        sheet.space = document.modelspace()
        draw()
        sheet.surround()
        document.header.custom_vars.append("Creator", CREATOR)
        # else in the order of a set, which changes from run to run
        for kind in sorted({entity.dxftype() for entity in document.entitydb.values()}):
            document.classes.add_class(kind)
        stream = io.StringIO()
        document.write(stream)
    finally:
        options.write_fixed_meta_data_for_testing = fixed
    return stream.getvalue().encode("utf-8")


def pocket(drawing: ShopDrawing) -> bytes:
    """Draw two sleeves that mate in the section at the ball circle, where the origin is, and the first from its end."""
    unit, sleeve = drawing.synthesis, drawing.sleeve
    contours = {each.layer: [(along * 1e3, around * 1e3) for along, around in each.points] for each in drawing.contours}
    (back, side), outer = contours["SLEEVE_1"][-1], sleeve.outer_diameter * 1e3
    said, near = notes(drawing), unit.edge_clearance_standard
    said += [
        told(
            "1 mm around the ball circle is {turn:.5g deg} of a turn: walls and grooves run towards the axis, from "
            "the rim to R {end:.5g mm}",
            turn=1e-3 / unit.ball_circle_radius, end=sleeve.pocket_end,
        ),
        translate(
            "contours to cut in true millimetres on layers POCKET_1 and POCKET_2; "
            "the view of sleeve 1 is to its own scale"
        ),
    ]  # fmt: skip
    if near is not None and near > 0:
        said.append(
            told(
                "edges of the pockets at the face broken by {most:.2g mm} at most: the ball touches as near as "
                "{near:.3g mm}",
                most=near / 5, near=near,
            )
        )  # fmt: skip
    below = [translate("* not in the spec: drawn at a default, for the designer to set")] if sleeve.assumed else []
    mass = "; ".join(localized(f"{each:.3g}") for each in drawing.masses)
    shop, title = drawing.spec.drawing or ShopNotes(), translate("Sleeves with ball pockets")
    sheet = ShopSheet(drawing.spec, title, said, *below, mass=mass, material=shop.material)
    wide, high = sheet.free
    own = largest_scale((outer, outer), (_WIDE / 2 - 33, high - 36))
    left = float(own) * outer + 74
    sheet.scale = largest_scale((2 * back, 2 * side), (wide - left - 60, high - 64))
    middle = (sheet.low + _HIGH - _EDGE) / 2 - 4
    sheet.origin = (left + _WIDE - 18) / 2, middle

    def draw() -> None:
        for contour in drawing.contours:
            sheet.lines(contour.layer, *contours[contour.layer], close=contour.closed)
        sheet.circle("BALL", (0, 0), unit.ball_diameter * 500)
        for name, angle in (("SLEEVE_1", 45), ("SLEEVE_2", 135)):
            sheet.hatch([contours[name]], angle)
            place = contours[name][0][0] / 2, -side - 4 * sheet.unit
            sheet.text(name[-1], place, 5.0, align="TOP_CENTER")
        _section_dimensions(sheet, drawing, contours)
        x = _LEFT + 52 + float(own) * outer / 2
        _end_view(sheet, drawing, sheet.at(x, middle), float(own / sheet.scale))
        title = told("A–A ({scale}), unrolled", scale=_stated(sheet.scale))
        sheet.text(title, (0, side + 32 * sheet.unit), 5.0, align="MIDDLE_CENTER")
        title = told("Sleeve 1, sleeve 2 alike ({scale})", scale=_stated(own))
        if unit.wall is not None:
            title = told("Sleeve 1 ({scale})", scale=_stated(own))
        sheet.text(title, sheet.at(_LEFT + 8, _HIGH - 15), 5.0)

    pens = {name: Pen(about, *_OF_POCKET.get(name, (7, "CONTINUOUS", 50))) for name, (about, *_) in LAYERS.items()}
    return written(sheet, {name: pen for name, pen in pens.items() if name not in SHEET}, draw)


def _section_dimensions(sheet: ShopSheet, drawing: ShopDrawing, contours: dict[str, list[Point]]) -> None:
    """Dimension pockets and sleeves in the section, and say how rough the walls are."""
    unit, sleeve, k = drawing.synthesis, drawing.sleeve, sheet.unit
    (face, half), (back, side) = contours["POCKET_1"][-1], contours["SLEEVE_1"][-1]
    other, groove = contours["POCKET_2"][0], sleeve.groove * 500
    floor = face + unit.pocket_depth_cut * 1e3
    bottom = floor + sleeve.relief * 1e3
    for row, x, y, mark in ((6, floor, groove, ""), (13, bottom, groove, ""), (20, back, side, "depth")):
        text = "<>*" if mark in sleeve.assumed else "<>"
        sheet.dimension("linear_dim", (0, side + row * k), (face, side if mark else half), (x, y), text=text)
    sheet.dimension("linear_dim", (0, -side - 8 * k), (-face, -side), (face, -side))
    sheet.dimension("linear_dim", (back + 8 * k, 0), (bottom, -groove), (bottom, groove), angle=90)
    sheet.dimension("linear_dim", (back + 16 * k, 0), (face, -half), (face, half), angle=90)
    if abs(other[1]) < half:
        sheet.dimension("linear_dim", (-back - 8 * k, 0), (-face, -other[1]), (-face, other[1]), angle=90)
    ball = localized(f"Ø{unit.ball_diameter * 1e3:.6g}")
    sheet.dimension("diameter_dim", (0, 0), radius=unit.ball_diameter * 500, angle=135, text=ball)
    for x, y in ((back + 3 * k, 0), (0, side + 3 * k)):
        sheet.lines("CENTRE", (-x, -y), (x, y))
    slope, reach = math.tan(unit.wall_angle), 0.75 * (floor - face)
    wall, opposite = (((floor, hand * groove), (floor - reach, hand * (groove + reach * slope))) for hand in (-1, 1))
    apex = unit.ball_diameter * 500 / math.sin(unit.wall_angle)
    sheet.dimension("angular_dim_2l", (min(face + reach, apex - 10 * k), 0), wall, opposite)
    if rough := (drawing.spec.drawing or ShopNotes()).roughness:
        x, y = next(point for point in contours["POCKET_1"][1:] if -point[1] > groove + 1e-9)
        tip = (x + floor) / 2, (y - groove) / 2
        sheet.leader(tip, (back + 4 * k, -side - 12 * k), rough, rough=True)


def _end_view(sheet: ShopSheet, drawing: ShopDrawing, centre: Point, shrunk: float) -> None:
    """Draw the first sleeve from its pockets, with all of them on their circle, smaller than the section."""
    unit, sleeve, k, given = drawing.synthesis, drawing.sleeve, sheet.unit, drawing.spec.control_unit
    count, circle = (given and given.balls) or 1, unit.ball_circle_radius
    rim, bore, end, pitch, ball = (
        each * 500 * shrunk
        for each in (sleeve.outer_diameter, sleeve.bore, 2 * sleeve.pocket_end, 2 * circle, unit.ball_diameter)
    )
    up, step = math.pi / 2, 2 * math.pi / count
    wide, groove = unit.pocket_width / 2 / circle, sleeve.groove / 2 / circle

    def at(radius: float, angle: float) -> Point:
        return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)

    def mark(diameter: float, sign: str = "Ø", after: str = "") -> dict[str, Any]:
        # the number too: not every program knows that it is drawn smaller
        return {"text": localized(f"{sign}{diameter * 1e3:.6g}{after}"), "shrunk": shrunk}

    for layer, radius in (("END_VIEW", rim), ("END_VIEW", bore), ("CENTRE", pitch)):
        sheet.circle(layer, centre, radius)
    for turn in (up - number * step for number in range(count)):
        corners = at(rim, turn + wide), at(end, turn + wide), at(end, turn - wide), at(rim, turn - wide)
        bulged = [(*corner, -math.tan(wide / 2) if i == 1 else 0.0) for i, corner in enumerate(corners)]
        sheet.space.add_lwpolyline(bulged, format="xyb", dxfattribs={"layer": "END_VIEW"})
        for side in (-groove, groove):
            sheet.lines("END_VIEW", at(end, turn + side), at(rim, turn + side))
        sheet.lines("CENTRE", at(end - 3 * k, turn), at(rim + 4 * k, turn))
        sheet.circle("BALL", at(pitch, turn), ball)
    for turn in (0.0, up):
        sheet.lines("CENTRE", at(-bore - 4 * k, turn), at(bore + 4 * k, turn))
    sheet.dimension(
        "diameter_dim", centre, radius=bore, angle=30, **mark(sleeve.bore, after="*" * ("bore" in sleeve.assumed))
    )
    left = centre[0] - rim
    depth = mark(sleeve.outer_diameter / 2 - sleeve.pocket_end, "")
    sheet.dimension("linear_dim", (left - 8 * k, 0), at(end, up), at(rim, up), angle=90, **depth)
    for away, radius, said in ((17, pitch, mark(2 * circle)), (26, rim, mark(sleeve.outer_diameter, after="*"))):
        sheet.dimension("linear_dim", (left - away * k, 0), at(-radius, up), at(radius, up), angle=90, **said)
    if count > 2:
        rays = ((centre, at(rim, up)), (centre, at(rim, up - step)))
        sheet.dimension("angular_dim_2l", at(rim + 9 * k, up - step / 2), *rays, text=f"{count}×<>")
    sheet.leader(at(pitch, -up + step / 2 if count > 1 else -up), at(1.2 * rim, -0.3 * math.pi), "A–A")


def section(clutch: ClutchSection, spec: Spec) -> bytes:
    """Draw the whole clutch as ``plot section`` lays it out."""
    page = laid_out(clutch)
    drawing = page.panels[0]
    assert isinstance(drawing, shapes.Drawing)
    shop = spec.drawing or ShopNotes()
    mass = localized(f"{sum(part.row.mass for part in clutch.parts.values()):.3g}")
    of_sleeves = (
        shop.material and told("material of the sleeves with pockets {material}", material=shop.material),
        shop.roughness and told("roughness of the pocket walls {roughness}", roughness=shop.roughness),
    )
    sheet = ShopSheet(spec, page.title, [*filter(None, of_sleeves), page.caption], mass=mass)
    left, low, right, high = drawing.frame
    size = right - left, high - low
    sheet.scale = largest_scale(size, sheet.free)
    x, y = ((room - float(sheet.scale) * wide) / 2 for room, wide in zip(sheet.free, size, strict=True))
    sheet.origin = _LEFT + x - left * float(sheet.scale), sheet.low + y - low * float(sheet.scale)
    letter = 0.7 * shapes.TEXT * drawing.point
    sheet.larger = letter / _TEXT / sheet.unit

    def draw() -> None:
        for shape in drawing.shapes:
            match shape:
                case shapes.Region(contours=contours, hatch=angle) if angle:
                    sheet.hatch(contours, angle)
                case shapes.Region(layer, contours):
                    for points in contours:
                        sheet.lines(layer.upper(), *points, close=True)
                    if layer in ("bypass", "overlap"):
                        sheet.hatch(contours, 45, layer.upper(), 1)
                case shapes.Stroke(layer, points):
                    sheet.lines(layer.upper(), *points)
                case shapes.Circle(layer, centre, radius, hole=hole):
                    for each in filter(None, (radius, hole)):
                        sheet.circle(layer.upper(), centre, each)
                case shapes.Inscription(text, at, anchor, upright):
                    align = {"start": "LEFT", "middle": "CENTER", "end": "RIGHT"}[anchor]
                    sheet.text(
                        text.replace("_", "").replace("Ø ", "Ø"),
                        at,
                        letter / sheet.unit,
                        align=align,
                        turn=90.0 * upright,
                    )
                case shapes.DimensionLine(label=label, start=start, end=end, line=line, upright=upright):
                    base, angle = ((line, 0.0), 90) if upright else ((0.0, line), 0)
                    sheet.dimension(
                        "linear_dim", base, start, end, text=label.replace("_", "").replace("Ø ", "Ø"), angle=angle
                    )

    pens = {name.upper(): Pen(shapes.LAYERS[name].about, *pen) for name, pen in _OF_SECTION.items()}
    return written(sheet, pens, draw)
