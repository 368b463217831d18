"""A drawing as DXF R2010, in true millimetres.

LibreCAD takes the font from the name of the text style and the sizes of dimensions from the header, and cannot rotate
hatch patterns: so the text style is named after its font, the header repeats the dimension style, hatches are lines.
"""

import io
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from ..messages import localized, printable, translate
from .drawing import HIDDEN, LAYERS, Angle, Circle, Diameter, Drawing, Inscription, Length, Point, Region, Shape, Stroke
from .plot.figure import CREATOR
from .symbols import split

if TYPE_CHECKING:
    from ezdxf.layouts.layout import Modelspace

_STYLE, _FONT = "lc_opengost-br", "arial.ttf"
"""Text style, named after its font in LibreCAD, and the font elsewhere: both have Greek and Cyrillic letters."""
_TEXT, _STEP, _DENSE = 3.5, 3.0, 1.0
"""Height of dimension texts, distance of hatch lines, and distance of dense hatch lines, mm on paper."""
_CAPITAL = 0.7
"""Height of a capital letter over the font size; the text height in DXF is the height of capitals."""
_ALIGNED = {"start": "LEFT", "middle": "CENTER", "end": "RIGHT"}


def dxf(drawing: Drawing) -> bytes:
    """DXF file of a drawing; the same drawing gives the same bytes."""
    import ezdxf
    from ezdxf import units
    from ezdxf.filemanagement import new

    sizes = {
        "dimtxt": _TEXT, "dimasz": 3.0, "dimexo": 0.0, "dimexe": 1.5, "dimgap": 0.8, "dimdec": 3, "dimadec": 3,
        "dimtad": 1, "dimzin": 8, "dimazin": 2, "dimtsz": 0.0, "dimscale": drawing.unit,
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
        header |= {"$DIMSTYLE": "SHOP", "$LTSCALE": drawing.unit / 2, "$LWDISPLAY": 1}
        for name, value in header.items():
            document.header[name] = value
        for name, shapes in drawing.by_layer():
            look = LAYERS[name]
            layer = document.layers.add(name.upper(), color=look.number, linetype=look.line)
            layer.dxf.lineweight, layer.description = round(100 * look.width), translate(look.about)
            for shape in shapes:
                _add(document.modelspace(), shape, drawing.unit)
        left, bottom, right, top = drawing.frame  # which is in view at first
        document.set_modelspace_vport(top - bottom, ((left + right) / 2, (bottom + top) / 2))
        document.header.custom_vars.append("Creator", CREATOR)
        # sorted, because the order of a set changes from run to run
        for kind in sorted({entity.dxftype() for entity in document.entitydb.values()}):
            document.classes.add_class(kind)
        stream = io.StringIO()
        document.write(stream)
    finally:
        options.write_fixed_meta_data_for_testing = fixed
    return stream.getvalue().encode("utf-8")


def _add(space: "Modelspace", shape: Shape, unit: float) -> None:
    from ezdxf.enums import TextEntityAlignment

    on: dict[str, Any] = {"layer": shape.layer.upper()}
    match shape:
        case Region("hatch", contours, hatch=angle):
            _hatch(space, contours, angle, _STEP * unit, on)
        case Region("dimensions", contours):
            for points in contours:
                space.add_solid(points, dxfattribs=on)
        case Region(layer, contours):
            for points in contours:
                space.add_lwpolyline(points, close=True, dxfattribs=on)
            if layer in ("bypass", "overlap"):
                _hatch(space, contours, 45, _DENSE * unit, on)
        case Stroke(_, points):
            space.add_lwpolyline(points, dxfattribs=on)
        case Circle(_, centre, radius, hole=hole):
            for each in filter(None, (radius, hole)):
                space.add_circle(centre, each, dxfattribs=on)
        case Inscription(words, at, height, anchor, upright, ours):
            shown = _plain(words) if ours else printable(words)
            on |= {"style": _STYLE, "rotation": 90.0 * upright}
            placed = space.add_text(shown, height=_CAPITAL * height, dxfattribs=on)
            placed.set_placement(at, align=TextEntityAlignment[_ALIGNED[anchor]])
        case Length(label, height, start, end, line, upright, shrunk=shrunk):
            base, turn = ((line, 0.0), 90) if upright else ((0.0, line), 0)
            space.add_linear_dim(base, start, end, angle=turn, **_style(label, height, shrunk)).render()
        case Diameter(label, height, centre, radius, angle, shrunk):
            more = _style(label, height, shrunk, dimtix=1)
            space.add_diameter_dim(centre, radius=radius, angle=angle, **more).render()
        case Angle(label, height, apex, first, second, radius):
            x, y = ((a + b) / 2 - c for a, b, c in zip(first, second, apex, strict=True))
            far = radius / (x**2 + y**2) ** 0.5
            base = apex[0] + far * x, apex[1] + far * y
            space.add_angular_dim_2l(base, (apex, second), (apex, first), **_style(label, height)).render()


def _style(label: str, height: float, shrunk: float = 1.0, **more: float) -> dict[str, Any]:
    """Text and style of a dimension; it shows the true lengths of a view drawn at the scale ``shrunk``."""
    override = {"dimscale": _CAPITAL * height / _TEXT, "dimlfac": 1 / shrunk} | more
    on = {"layer": "DIMENSIONS"}
    return {"dimstyle": "SHOP", "override": override, "text": _plain(label), "dxfattribs": on}


def _plain(text: str) -> str:
    """Text with subscripts as plain letters, because DXF has no subscripts."""
    return printable("".join(piece for piece, _ in split(text)))


def _hatch(
    space: "Modelspace", contours: Iterable[Sequence[Point]], angle: float, step: float, on: dict[str, Any]
) -> None:
    """Draw hatch lines inside closed contours."""
    from ezdxf.math import Vec2
    from ezdxf.render.hatching import HatchBaseLine, hatch_polygons

    way = Vec2.from_deg_angle(angle)
    base = HatchBaseLine(Vec2(0, 0), way, way.orthogonal() * step)
    for line in hatch_polygons(base, [[Vec2(point) for point in points] for points in contours]):
        space.add_line(line.start, line.end, dxfattribs=on)
