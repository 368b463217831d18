"""What stands below a drawing for the shop."""

import math

from ...analysis.shop import ShopDrawing
from ...messages import say


def described(drawing: ShopDrawing) -> list[str]:
    """What stands below a drawing."""
    found = drawing.synthesis
    angle = f"{math.degrees(found.wall_angle):.4f}"
    if found.wall_angle_max is None:
        wall = say("straight walls, angle to the axis {angle} deg", angle=angle)
    else:
        wall = say(
            "curved wall, angle to the axis {angle} deg at the stop, {most} deg at x = {travel:.4f mm}; chords within "
            "{chord:g mm}",
            angle=angle,
            most=f"{math.degrees(found.wall_angle_max):.4f}",
            travel=found.travel_max,
            chord=drawing.chord,
        )
    return [
        say("{name}: pocket, cylindrical section at the ball circle, radius {radius:.4f mm}, unrolled; mm, sleeves at "
            "the stop", name=drawing.name, radius=found.ball_circle_radius),
        say(
            "pocket {width:.4f mm} wide at the face, cut to {depth:.4f mm}; ball {ball:.4f mm}, gap {gap:g mm}",
            width=found.pocket_width, depth=found.pocket_depth_cut, ball=found.ball_diameter, gap=found.face_gap,
        ),
        wall,
        say("cutter: diameter {diameter:.4f mm}, its axis across the section", diameter=2 * drawing.cutter_radius),
    ]  # fmt: skip
