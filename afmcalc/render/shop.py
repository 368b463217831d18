"""The pocket for the shop in true millimetres: SVG, and what is said beside it."""

from html import escape

from ..analysis.shop import ShopDrawing
from ..messages import named, told

LAYERS = {
    "SLEEVE_1": ("sleeve with the profiled wall", 8, "#6e6e6e"),
    "SLEEVE_2": ("the other sleeve", 8, "#6e6e6e"),
    "POCKET_1": ("pocket of the profiled wall: to cut", 7, "#111111"),
    "POCKET_2": ("pocket of the other sleeve: to cut", 7, "#111111"),
    "PATH": ("path of the ball's centre in the profiled sleeve", 3, "#1a7f37"),
    "BALL": ("the ball at the stop", 5, "#0b57d0"),
    "DIMENSIONS": ("dimensions and notes", 8, "#6e6e6e"),
}
"""Layer → what it shows, its number among AutoCAD's colours, its colour."""

CREATOR = "afmcalc plot"
_MM = 1e3


def notes(drawing: ShopDrawing) -> list[str]:
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
        *([told("{ball}, of a grade for the designer to set", ball=ball.ball_designation)]
            if ball.ball_designation else []),
        wall,
        told("relief under the ball {groove:.4g mm} wide and {relief:g mm} deep, corners R {corner:g mm} at most: "
            "the ball touches the walls only", groove=drawing.sleeve.groove, relief=drawing.sleeve.relief,
            corner=drawing.sleeve.relief / 2),
    ]  # fmt: skip


_MARGIN, _LINE, _TEXT = 8.0, 4.2, 2.8
"""Of an SVG, mm."""


def svg(drawing: ShopDrawing) -> bytes:
    """Write a drawing as SVG whose numbers are millimetres: printed at its own size it is 1:1."""
    sleeve = drawing.contours[0].points
    back, side = sleeve[0][0] * _MM, abs(sleeve[0][1]) * _MM
    told_below = notes(drawing)
    left, top = -back - _MARGIN, -side - _MARGIN
    wide = max(2 * (back + _MARGIN), max(len(note) for note in told_below) * _TEXT * 0.55 + 2 * _MARGIN)
    high = 2 * (side + _MARGIN) + _LINE * (len(told_below) + 1)
    paths = []
    for contour in drawing.contours:  # y runs down in SVG
        points = " L".join(f"{_coordinate(x * _MM)} {_coordinate(-y * _MM)}" for x, y in contour.points)
        end, colour = " Z" if contour.closed else "", LAYERS[contour.layer][2]
        paths.append(f'<path id="{contour.layer}" stroke="{colour}" d="M{points}{end}"/>')
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_coordinate(wide)}mm" height="{_coordinate(high)}mm" '
        f'viewBox="{" ".join(map(_coordinate, (left, top, wide, high)))}">',
        f"<title>{escape(named(drawing.name), quote=False)}</title>",
        f"<desc>{CREATOR}</desc>",
        '<g fill="none" stroke-width="0.18" stroke-linejoin="round">',
        *paths,
        f'<circle id="BALL" r="{_coordinate(drawing.synthesis.ball_diameter / 2 * _MM)}" '
        f'stroke="{LAYERS["BALL"][2]}"/>',
        "</g>",
        f'<g font-family="sans-serif" font-size="{_TEXT}" fill="#111111">',
    ]
    for row, note in enumerate(told_below, 1):
        y = _coordinate(side + _MARGIN + _LINE * row)
        lines.append(f'<text x="{_coordinate(-back)}" y="{y}">{escape(note, quote=False)}</text>')
    return "\n".join([*lines, "</g>", "</svg>", ""]).encode("utf-8")


def _coordinate(value: float) -> str:
    """A coordinate to the millionth of a millimetre."""
    return f"{round(value, 6) + 0.0:.6f}".rstrip("0").rstrip(".")
