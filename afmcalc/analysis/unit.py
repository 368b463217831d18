"""A control unit as synthesized: angles, balls, pockets, contact."""

from typing import ClassVar, Literal

from ..result import Answer, quantity
from .contact import Basis
from .wall import WallPoint


class SynthesisResult(Answer):
    """A control unit that fits the clutch."""

    rows_with_values: ClassVar[bool] = True

    wall_angle: float = quantity("rad", "α", "wall angle of the pockets; of a curved wall at the stop")
    wall_angle_max: float | None = quantity("rad", "α_max", "wall angle at the largest travel", optional=True)
    gain_slope: float | None = quantity("1/m", "C_1", "how the gain grows with the sleeve's travel", optional=True)
    profiled: Literal["one", "both"] | None = quantity("", None, "sleeves with the curved wall", optional=True)
    ball_circle_radius: float = quantity("m", "r", "radius of the ball circle")
    travel_max: float = quantity("m", "x_max", "largest travel of the sleeve")
    face_gap: float = quantity("m", "s", "gap between the faces")
    edge_clearance: float = quantity("m", "y", "clearance asked for")
    ball_radius: float = quantity("m", "r_ш", "smallest ball radius")
    undercut_radius: float | None = quantity(
        "m", "ρ_0", "radius of a ball that undercuts the curved wall: all smaller ones run on it", optional=True
    )
    ball_diameter_standard: float | None = quantity("m", "d_ш", "ball chosen: given, or the next standard one")
    edge_clearance_standard: float | None = quantity("m", "y_st", "clearance with the ball chosen")
    pocket_depth: float = quantity(
        "m", "h_1", "pocket depth to the virtual apex, for the ball chosen (the smallest where none is)"
    )
    pocket_depth_cut: float = quantity("m", "h_c", "pocket depth to cut: the ball's lowest point, where the walls end")
    pocket_width: float = quantity("m", "b", "width of the pocket's mouth at the face")
    ball_pitch: float | None = quantity("m", "t_ш", "distance between the centres of neighbouring balls")
    web: float | None = quantity("m", "e", "web between neighbouring pockets at the face")
    contact_force: float | None = quantity("N", "F_n", "largest normal force on one ball")
    contact_force_critical: float | None = quantity(
        "N",
        "F_n,c",
        "normal force on one ball where the contact pressure is largest",
        optional=True,
    )
    contact_force_allowable: float | None = quantity("N", "[F_n]", "allowable normal force on one ball")
    seat_force: float | None = quantity(
        "N", "F_s", "largest force of a wall that seats the ball in the other sleeve", optional=True
    )
    seat_utilisation: float | None = quantity("1", "F_s/[F_n]", "utilisation of the seat", optional=True)
    contact_basis: Basis | None = quantity("", None, "where the allowable force is from")
    contact_utilisation: float | None = quantity("1", "F_n/[F_n]", "utilisation of the contact")
    contact_force_hertz: float | None = quantity(
        "N", "[F_n]_H", "normal force on one ball at the allowable contact pressure", optional=True
    )
    contact_pressure: float | None = quantity(
        "Pa", "p_0", "largest contact pressure of ball and wall (Hertz)", optional=True
    )
    gain_at_least_contact_force: float | None = quantity(
        "1", "C_Fn", "gain of the least contact force at equal spring force; beyond it F_n grows", optional=True
    )

    wall: list[WallPoint] | None = quantity(
        "", None, "curved wall from the stop to the face, from the ball's centre at the stop", optional=True
    )

    @property
    def contact_path(self) -> str:
        """Key of the spec that the allowable force is from, or would be."""
        return "control_unit.allowable_contact_force" if self.contact_basis == "given" else "control_unit.contact"

    @property
    def ball_diameter(self) -> float:
        """The ball chosen, or the smallest where none is."""
        return 2 * self.ball_radius if self.ball_diameter_standard is None else self.ball_diameter_standard
