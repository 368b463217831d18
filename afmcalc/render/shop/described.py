"""What stands below a drawing for the shop."""

from ...analysis.shop import ShopDrawing
from ...messages import named, told


def described(drawing: ShopDrawing) -> list[str]:
    """What stands below a drawing."""
    found = drawing.synthesis
    if found.wall_angle_max is None:
        wall = told("straight walls, angle to the axis {angle:.4f deg}", angle=found.wall_angle)
    else:
        wall = told(
            "curved wall, angle to the axis {angle:.4f deg} at the stop, {most:.4f deg} at x = {travel:.4f mm}; "
            "chords within {chord:g mm}",
            angle=found.wall_angle,
            most=found.wall_angle_max,
            travel=found.travel_max,
            chord=drawing.chord,
        )
    return [
        told("{name}: pocket, cylindrical section at the ball circle, radius {radius:.4f mm}, unrolled; mm, sleeves at "
            "the stop", name=named(drawing.name), radius=found.ball_circle_radius),
        told(
            "pocket {width:.4f mm} wide at the face, cut to {depth:.4f mm}; ball {ball:.4f mm}, gap {gap:g mm}",
            width=found.pocket_width, depth=found.pocket_depth_cut, ball=found.ball_diameter, gap=found.face_gap,
        ),
        wall,
        told("cutter: diameter {diameter:.4f mm}, its axis across the section", diameter=2 * drawing.cutter_radius),
    ]  # fmt: skip
