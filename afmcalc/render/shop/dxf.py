"""DXF of the pockets: millimetres, one closed polyline a contour, layers, dimensions."""

import io

import ezdxf
from ezdxf import units
from ezdxf.filemanagement import new
from ezdxf.layouts.layout import Modelspace

from ...analysis.shop import ShopDrawing
from ...messages import localized, translate
from .described import described
from .layers import CREATOR, LAYERS, MM

_STYLE = {
    "dimlfac": 1, "dimtxt": 1.2, "dimasz": 1.0, "dimexo": 0.4, "dimexe": 0.6, "dimdec": 3, "dimgap": 0.4, "dimtad": 1,
    "dimblk": "", "dimtsz": 0, "dimclrd": 8, "dimclre": 8, "dimclrt": 8,
}  # fmt: skip
"""Dimensions of the drawing: in its own units, arrows, small."""


def dxf(drawing: ShopDrawing) -> bytes:
    """Write a drawing as DXF R2010: the same drawing gives the same bytes."""
    options = ezdxf.options  # type: ignore[attr-defined]
    fixed, options.write_fixed_meta_data_for_testing = options.write_fixed_meta_data_for_testing, True
    try:
        document = new("R2010", setup=True, units=units.MM)
        for layer, (about, colour, _) in LAYERS.items():
            document.layers.add(layer, color=colour).description = translate(about)
        space = document.modelspace()
        for contour in drawing.contours:
            points = [(along * MM, around * MM) for along, around in contour.points]
            space.add_lwpolyline(points, close=contour.closed, dxfattribs={"layer": contour.layer})
        radius = drawing.synthesis.ball_diameter / 2 * MM
        space.add_circle((0, 0), radius, dxfattribs={"layer": "BALL"})
        _dimensions(space, drawing, radius)
        document.header.custom_vars.append("Creator", CREATOR)
        # else in the order of a set, which changes from run to run
        for kind in sorted({entity.dxftype() for entity in document.entitydb.values()}):
            document.classes.add_class(kind)
        stream = io.StringIO()
        document.write(stream)
    finally:
        options.write_fixed_meta_data_for_testing = fixed
    return stream.getvalue().encode("utf-8")


def _dimensions(space: Modelspace, drawing: ShopDrawing, radius: float) -> None:
    """Width and depth of the pocket to cut, gap, ball, and the angle at the stop."""
    found = drawing.synthesis
    pocket = next(each.points for each in drawing.contours if each.layer == "POCKET_1")
    sleeve = next(each.points for each in drawing.contours if each.layer == "SLEEVE_1")
    face, floor = found.face_gap / 2 * MM, max(along for along, _ in pocket) * MM
    back, side = sleeve[0][0] * MM, abs(sleeve[0][1]) * MM
    half = found.pocket_width / 2 * MM
    on, style = {"layer": "DIMENSIONS"}, _STYLE | {"dimdsep": ord(localized("."))}
    across = space.add_linear_dim((back + 4, 0), (face, -half), (face, half), angle=90, override=style, dxfattribs=on)
    deep = space.add_linear_dim((0, side + 4), (face, half), (floor, half), override=style, dxfattribs=on)
    gap = space.add_linear_dim((0, -side - 4), (-face, -side), (face, -side), override=style, dxfattribs=on)
    ball = space.add_diameter_dim((0, 0), radius=radius, angle=135, override=style, dxfattribs=on)
    for each in (across, deep, gap, ball):
        each.render()
    text = {"layer": "DIMENSIONS", "height": 1.2}
    for row, line_text in enumerate(described(drawing)):
        space.add_text(line_text, dxfattribs=text).set_placement((-back, -side - 9 - 2.2 * row))
