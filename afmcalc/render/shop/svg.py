"""SVG of the pockets in true millimetres: printed at its own size it is 1:1, and its numbers are millimetres."""

from xml.sax.saxutils import escape

from ...analysis.shop import Contour, ShopDrawing
from ...messages import named
from .described import described
from .layers import CREATOR, LAYERS, MM

_MARGIN, _LINE, _TEXT = 8.0, 4.2, 2.8


def svg(drawing: ShopDrawing) -> bytes:
    """Write a drawing as SVG; the same drawing gives the same bytes."""
    sleeve = drawing.contours[0].points
    back, side = sleeve[0][0] * MM, abs(sleeve[0][1]) * MM
    notes = described(drawing)
    left, top = -back - _MARGIN, -side - _MARGIN
    wide = max(2 * (back + _MARGIN), max(len(note) for note in notes) * _TEXT * 0.55 + 2 * _MARGIN)
    high = 2 * (side + _MARGIN) + _LINE * (len(notes) + 1)
    found = drawing.synthesis
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_mm(wide)}mm" height="{_mm(high)}mm" '
        f'viewBox="{_mm(left)} {_mm(top)} {_mm(wide)} {_mm(high)}">',
        f"<title>{escape(named(drawing.name))}</title>",
        f"<desc>{CREATOR}</desc>",
        '<g fill="none" stroke-width="0.18" stroke-linejoin="round">',
        *map(_path, drawing.contours),
        f'<circle id="BALL" r="{_mm(found.ball_diameter / 2 * MM)}" stroke="{LAYERS["BALL"][2]}"/>',
        "</g>",
        f'<g font-family="sans-serif" font-size="{_TEXT}" fill="#111111">',
    ]
    for row, note in enumerate(notes, 1):
        lines.append(f'<text x="{_mm(-back)}" y="{_mm(side + _MARGIN + _LINE * row)}">{escape(note)}</text>')
    return "\n".join([*lines, "</g>", "</svg>", ""]).encode("utf-8")


def _path(contour: Contour) -> str:
    # y runs down in SVG
    points = " L".join(f"{_mm(along * MM)} {_mm(-around * MM)}" for along, around in contour.points)
    end = " Z" if contour.closed else ""
    return f'<path id="{contour.layer}" stroke="{LAYERS[contour.layer][2]}" d="M{points}{end}"/>'


def _mm(value: float) -> str:
    """A coordinate to the millionth of a millimetre."""
    return f"{round(value, 6) + 0.0:.6f}".rstrip("0").rstrip(".")
