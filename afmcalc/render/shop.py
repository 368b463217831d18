"""Drawings of the pocket for the shop, in true millimetres: DXF, SVG, and the profile of its wall as CSV."""

import csv
import io
import math
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape

from ..analysis.shop import CutterPoint, ShopDrawing
from ..messages import localized, named, told, translate

if TYPE_CHECKING:
    from ezdxf.layouts.layout import Modelspace

LAYERS = {
    "SLEEVE_1": ("sleeve with the profiled wall", 8, "#6e6e6e"),
    "SLEEVE_2": ("the other sleeve", 8, "#6e6e6e"),
    "POCKET_1": ("pocket of the profiled wall: to cut", 7, "#111111"),
    "POCKET_2": ("pocket of the other sleeve: to cut", 7, "#111111"),
    "PATH": ("path of the ball's centre in the profiled sleeve", 3, "#1a7f37"),
    "CUTTER": ("path of the cutter's centre in the profiled sleeve", 1, "#b3261e"),
    "BALL": ("the ball at the stop", 5, "#0b57d0"),
    "DIMENSIONS": ("dimensions and notes", 8, "#6e6e6e"),
}
"""Layer → what it shows, its number among AutoCAD's colours, its colour."""

_CREATOR = "afmcalc plot"
_MM = 1e3


def _notes(drawing: ShopDrawing) -> list[str]:
    """What stands below a drawing."""
    ball = drawing.synthesis
    if ball.wall_angle_max is None:
        wall = told("straight walls, angle to the axis {angle:.4f deg}", angle=ball.wall_angle)
    else:
        wall = told(
            "curved wall, angle to the axis {angle:.4f deg} at the stop, {most:.4f deg} at x = {travel:.4f mm}; "
            "chords within {chord:g mm}",
            angle=ball.wall_angle, most=ball.wall_angle_max, travel=ball.travel_max, chord=drawing.chord,
        )  # fmt: skip
    return [
        told("{name}: pocket, cylindrical section at the ball circle, radius {radius:.4f mm}, unrolled; mm, sleeves at "
            "the stop", name=named(drawing.name), radius=ball.ball_circle_radius),
        told(
            "pocket {width:.4f mm} wide at the face, cut to {depth:.4f mm}; ball {ball:.4f mm}, gap {gap:g mm}",
            width=ball.pocket_width, depth=ball.pocket_depth_cut, ball=ball.ball_diameter, gap=ball.face_gap,
        ),
        wall,
        told("cutter: diameter {diameter:.4f mm}, its axis across the section", diameter=2 * drawing.cutter_radius),
    ]  # fmt: skip


def profile(drawing: ShopDrawing) -> str:
    """Write path of the ball's centre, wall and path of the cutter as CSV, from floor to face.

    Places below the stop have a travel below 0.
    """
    stream = io.StringIO()
    rows = csv.writer(stream, lineterminator="\n")
    rows.writerow(f"{name} [{'deg' if name == 'wall_angle' else 'mm'}]" for name in CutterPoint.model_fields)
    for point in drawing.profile:
        rows.writerow(repr(math.degrees(value) if name == "wall_angle" else value * _MM) for name, value in point)
    return stream.getvalue()


_MARGIN, _LINE, _TEXT = 8.0, 4.2, 2.8
"""Of an SVG, mm."""


def svg(drawing: ShopDrawing) -> bytes:
    """Write a drawing as SVG whose numbers are millimetres: printed at its own size it is 1:1."""
    sleeve = drawing.contours[0].points
    back, side = sleeve[0][0] * _MM, abs(sleeve[0][1]) * _MM
    notes = _notes(drawing)
    left, top = -back - _MARGIN, -side - _MARGIN
    wide = max(2 * (back + _MARGIN), max(len(note) for note in notes) * _TEXT * 0.55 + 2 * _MARGIN)
    high = 2 * (side + _MARGIN) + _LINE * (len(notes) + 1)
    paths = []
    for contour in drawing.contours:  # y runs down in SVG
        points = " L".join(f"{_coordinate(x * _MM)} {_coordinate(-y * _MM)}" for x, y in contour.points)
        end, colour = " Z" if contour.closed else "", LAYERS[contour.layer][2]
        paths.append(f'<path id="{contour.layer}" stroke="{colour}" d="M{points}{end}"/>')
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_coordinate(wide)}mm" height="{_coordinate(high)}mm" '
        f'viewBox="{" ".join(map(_coordinate, (left, top, wide, high)))}">',
        f"<title>{escape(named(drawing.name))}</title>",
        f"<desc>{_CREATOR}</desc>",
        '<g fill="none" stroke-width="0.18" stroke-linejoin="round">',
        *paths,
        f'<circle id="BALL" r="{_coordinate(drawing.synthesis.ball_diameter / 2 * _MM)}" '
        f'stroke="{LAYERS["BALL"][2]}"/>',
        "</g>",
        f'<g font-family="sans-serif" font-size="{_TEXT}" fill="#111111">',
    ]
    for row, note in enumerate(notes, 1):
        y = _coordinate(side + _MARGIN + _LINE * row)
        lines.append(f'<text x="{_coordinate(-back)}" y="{y}">{escape(note)}</text>')
    return "\n".join([*lines, "</g>", "</svg>", ""]).encode("utf-8")


def _coordinate(value: float) -> str:
    """A coordinate to the millionth of a millimetre."""
    return f"{round(value, 6) + 0.0:.6f}".rstrip("0").rstrip(".")


def dxf(drawing: ShopDrawing) -> bytes:
    """Write a drawing as DXF R2010, one closed polyline a contour: the same drawing gives the same bytes."""
    import ezdxf
    from ezdxf import units
    from ezdxf.filemanagement import new

    options = ezdxf.options  # type: ignore[attr-defined]
    fixed, options.write_fixed_meta_data_for_testing = options.write_fixed_meta_data_for_testing, True
    try:
        document = new("R2010", setup=True, units=units.MM)
        for layer, (about, colour, _) in LAYERS.items():
            document.layers.add(layer, color=colour).description = translate(about)
        space = document.modelspace()
        for contour in drawing.contours:
            points = [(along * _MM, around * _MM) for along, around in contour.points]
            space.add_lwpolyline(points, close=contour.closed, dxfattribs={"layer": contour.layer})
        radius = drawing.synthesis.ball_diameter / 2 * _MM
        space.add_circle((0, 0), radius, dxfattribs={"layer": "BALL"})
        _dimensions(space, drawing, radius)
        document.header.custom_vars.append("Creator", _CREATOR)
        # else in the order of a set, which changes from run to run
        for kind in sorted({entity.dxftype() for entity in document.entitydb.values()}):
            document.classes.add_class(kind)
        stream = io.StringIO()
        document.write(stream)
    finally:
        options.write_fixed_meta_data_for_testing = fixed
    return stream.getvalue().encode("utf-8")


_STYLE = {
    "dimlfac": 1, "dimtxt": 1.2, "dimasz": 1.0, "dimexo": 0.4, "dimexe": 0.6, "dimdec": 3, "dimgap": 0.4, "dimtad": 1,
    "dimblk": "", "dimtsz": 0, "dimclrd": 8, "dimclre": 8, "dimclrt": 8,
}  # fmt: skip
"""Dimensions of a DXF: in its own units, arrows, small."""


def _dimensions(space: "Modelspace", drawing: ShopDrawing, radius: float) -> None:
    """Width and depth of the pocket to cut, gap and ball, and the notes."""
    synthesis = drawing.synthesis
    pocket = next(contour.points for contour in drawing.contours if contour.layer == "POCKET_1")
    sleeve = next(contour.points for contour in drawing.contours if contour.layer == "SLEEVE_1")
    face, floor = synthesis.face_gap / 2 * _MM, max(along for along, _ in pocket) * _MM
    back, side = sleeve[0][0] * _MM, abs(sleeve[0][1]) * _MM
    half = synthesis.pocket_width / 2 * _MM
    on, style = {"layer": "DIMENSIONS"}, _STYLE | {"dimdsep": ord(localized("."))}
    for dimension in (
        space.add_linear_dim((back + 4, 0), (face, -half), (face, half), angle=90, override=style, dxfattribs=on),
        space.add_linear_dim((0, side + 4), (face, half), (floor, half), override=style, dxfattribs=on),
        space.add_linear_dim((0, -side - 4), (-face, -side), (face, -side), override=style, dxfattribs=on),
        space.add_diameter_dim((0, 0), radius=radius, angle=135, override=style, dxfattribs=on),
    ):
        dimension.render()
    text = {"layer": "DIMENSIONS", "height": 1.2}
    for row, note in enumerate(_notes(drawing)):
        space.add_text(note, dxfattribs=text).set_placement((-back, -side - 9 - 2.2 * row))
