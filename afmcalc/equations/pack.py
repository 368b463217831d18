"""Friction and the pack: the pairs, their mean radius and gain, whatever the variant."""

from .arrays import tan
from .wiring import Same

nothing = 0.0
unity = 1.0
never = False


def friction_mean(friction_min, friction_max):
    """Mean coefficient of friction where none is given, f_cp = (f_min + f_max)/2.
    Source: Convention: the middle of the range. Validity: 0 < f_min ≤ f_max."""
    return (friction_min + friction_max) / 2


def mean_radius(inner_radius, outer_radius):
    """Mean friction radius at uniform wear (p·r constant), (r_i + r_o)/2.
    Source: Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 18. Validity: 0 < r_i < r_o; discs worn
    in."""
    return (inner_radius + outer_radius) / 2


def _mean_radius_uniform_pressure(inner_radius, outer_radius):
    """Mean friction radius at uniform pressure, ⅔ (r_o³ − r_i³)/(r_o² − r_i²).
    Source: Juvinall & Marshek, Fundamentals of Machine Component Design, ch. 18. Validity: 0 < r_i < r_o; new, stiff
    discs."""
    return 2 * (outer_radius**3 - inner_radius**3) / (3 * (outer_radius**2 - inner_radius**2))


def controlled_pairs(pairs, bypass_pairs):
    """Pairs whose torque passes the balls, z_2 = z − z_1.
    Source: S22 (22). Validity: z_1 ≤ z; none of a conventional clutch."""
    return pairs - bypass_pairs


def reduced_gain(controlled_pairs, gain):
    """Reduced gain, z_2 C: the gain of the whole feedback loop per unit of friction.
    Source: S22 (zC of the all-driving clutch); S19 ((z − 1)C). Validity: Any direct variant; 0 for the conventional
    clutch."""
    return controlled_pairs * gain


def tan_wall_angle(gain, ball_circle_radius, mean_radius):
    """Tangent of the wall angle that gives a gain, tan α = C r/R. Source: S21 (24). Validity: C ≥ 0."""
    return gain * ball_circle_radius / mean_radius


def _gain(mean_radius, ball_circle_radius, tan_wall_angle):
    """Feedback gain C = (R_cp/r)·tan α.
    Source: F11, after (11); S19 and S21 use the same definition. Validity: 0 ≤ α < 90°; α = 0 gives no release
    force."""
    return mean_radius / ball_circle_radius * tan_wall_angle


def _tan_of_wall_angle(wall_angle):
    """Tangent of the wall angle, tan α. Source: Definition. Validity: 0 ≤ α < 90°."""
    return tan(wall_angle)


UNIFORM_PRESSURE = {"mean_radius": _mean_radius_uniform_pressure}
WALL_ANGLE_GIVEN = {"gain": _gain, "tan_wall_angle": _tan_of_wall_angle}
ONE_FRICTION = {
    f"friction_{group}{end}": Same(f"friction{end}")
    for group in ("driving", "driven")
    for end in ("", "_min", "_mean", "_max", "_set")
}
"""Both groups of pairs are of one material."""
SET_AT_MIN = {"friction_set": Same("friction_min"), "margin_in_spring": 1.0}
SET_AT_MEAN = {"friction_set": Same("friction_mean"), "margin_in_spring": Same("margin")}

CASES = {
    "f_min": {"friction": "friction_min"},
    "f_mean": {"friction": "friction_mean"},
    "f_max": {"friction": "friction_max"},
    "setting": {"friction": "friction_set"},
}
