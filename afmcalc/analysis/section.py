"""What the section through ball and pockets shows."""

import math

from ..equations.synthesis import pocket_depth
from ..result import Result, quantity
from .synthesize import SynthesisResult


class PocketSection(Result):
    """Sizes of one ball and its pockets."""

    ball_diameter: float = quantity("m", "d_ш", "ball drawn: the one chosen, or the smallest where none is standard")
    standard: bool = quantity("", None, "whether there is such a ball")
    wall_angle: float = quantity("rad", "α", "wall angle of the pockets")
    face_gap: float = quantity("m", "s", "gap between the faces")
    pocket_depth: float = quantity("m", "h_1", "pocket depth, to the apex")
    travel_max: float = quantity("m", "x_max", "largest travel of the sleeve")
    synthesis: SynthesisResult = quantity("", None, "the synthesis it is from")
    name: str | None = quantity("", None, "clutch", optional=True)


def pocket_section(name: str | None, found: SynthesisResult) -> PocketSection:
    """Return the sizes of the section through a control unit as synthesized."""
    chosen = found.ball_diameter_standard
    diameter = 2 * found.ball_radius if chosen is None else chosen
    return PocketSection(
        ball_diameter=diameter,
        standard=chosen is not None,
        wall_angle=found.wall_angle,
        face_gap=found.face_gap,
        pocket_depth=pocket_depth(diameter / 2, math.sin(found.wall_angle), found.face_gap),
        travel_max=found.travel_max,
        synthesis=found,
        name=name,
    )
