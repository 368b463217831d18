"""SVG of a drawing; numbers in the SVG are millimetres, and the y axis points downwards."""

from collections.abc import Iterable
from html import escape

from ..errors import need
from ..messages import printable
from .drawing import DASHES, LAYERS, Circle, Drawing, Inscription, Length, Point, Region, Simple, Stroke, exploded
from .symbols import lowered, marked


def svg(drawing: Drawing, title: str = "") -> str:
    """SVG of a drawing, as wide as it is on paper."""
    left, bottom, right, top = drawing.frame
    unit = drawing.unit
    hatches = {shape.hatch for shape in drawing.shapes if isinstance(shape, Region) and shape.hatch}
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_n(drawing.width)}mm" height="{_n((top - bottom) / unit)}mm" '
        f'viewBox="{_path([(left, top)])} {_n(right - left)} {_n(top - bottom)}" '
        f'font-family="DejaVu Sans, sans-serif">',
        f"<title>{escape(printable(title), quote=False)}</title>" if title else "",
        *(_pattern(angle, unit) for angle in sorted(hatches)),
    ]
    for name, shapes in drawing.by_layer():
        look = LAYERS[name]
        dashes = " ".join(_n(length * unit) for length in DASHES.get(look.line, ())) or "none"
        parts.append(
            f'<g class="{name}" stroke="{look.colour}" stroke-width="{_n(look.width * unit)}" '
            f'stroke-dasharray="{dashes}" stroke-linejoin="round" '
            f'fill="{look.face or look.colour}" fill-opacity="{look.fill:g}" fill-rule="evenodd">'
        )
        for shape in shapes:
            simple = "\n".join(map(_simple, exploded(shape)))
            if isinstance(shape, Length) and shape.key:
                about = f"<title>{escape(shape.about, quote=False)}</title>"
                simple = f'<g data-key="{shape.key}">{about}{simple}</g>'
            parts.append(simple)
        parts.append("</g>")
    return "\n".join([*filter(None, parts), "</svg>", ""])


def picture(text: str, ending: str) -> bytes:
    """File of an SVG on white: the SVG itself, or PNG or PDF set by Typst with the fonts of matplotlib."""
    if ending == "svg":
        return text.encode()
    need("pdf")
    import typst
    from matplotlib import get_data_path

    source = b"#set page(width: auto, height: auto, margin: 0pt)\n#image(bytes(sys.inputs.svg))"
    return typst.compile(  # type: ignore[call-overload]
        source, format=ending, ppi=150, sys_inputs={"svg": text}, ignore_system_fonts=True, timestamp=0,
        font_paths=[f"{get_data_path()}/fonts/ttf"],
    )  # fmt: skip


def _simple(shape: Simple) -> str:
    if isinstance(shape, Inscription):
        letters, at = marked(shape.text) if shape.ours else printable(shape.text), _path([shape.at])
        turn = f' transform="rotate(-90 {at})"' if shape.upright else ""
        left, top = at.split()
        look = f'font-size="{_n(shape.height)}" stroke="none" text-anchor="{shape.anchor}"{turn}'
        return f'<text x="{left}" y="{top}" {look}>{lowered(escape(letters, quote=False))}</text>'
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


def _pattern(angle: float, unit: float) -> str:
    look, step = LAYERS["hatch"], _n(1.4 * unit)
    lines = f'<path d="M0 0H{step}" stroke="{look.colour}" stroke-width="{_n(2 * look.width * unit)}"/>'
    size = f'width="{step}" height="{step}" patternUnits="userSpaceOnUse" patternTransform="rotate({-angle:g})"'
    return f'<pattern id="hatch{angle:g}" {size}>{lines}</pattern>'


def _path(points: Iterable[Point]) -> str:
    return "L".join(f"{_n(x)} {_n(-y)}" for x, y in points)


def _n(value: float) -> str:
    """Number as text, to 0.1 µm."""
    return f"{round(value, 4) + 0.0:.4f}".rstrip("0").rstrip(".")
