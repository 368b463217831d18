"""Accuracy factor: largest over smallest torque in several cases, and its value without feedback (chapter 3)."""

from .arrays import larger, place_of_largest, place_of_smallest, smaller
from .wiring import Same


def scatter(torque_max, torque_min):
    """Torque scatter band, ΔT = T_max − T_min. Source: S19 (10), (11). Validity: Any clutch."""
    return torque_max - torque_min


def mid_torque(torque_max, torque_min):
    """Torque at the middle of the scatter band, (T_min + T_max)/2. Source: S19, conclusions. Validity: Any variant."""
    return (torque_min + torque_max) / 2


def accuracy_factor(torque_max, torque_min):
    """Accuracy factor, K_т = T_max/T_min.
    Source: F11 (14); S21 (15); S22 (18), (19). Validity: Any clutch; torque_max and torque_min are those of the
    case."""
    return torque_max / torque_min


accuracy_factor_worst_case = Same("accuracy_factor_at_worst_case")
accuracy_factor_peak = Same("accuracy_factor_at_peak")


def conventional_accuracy_factor(
    bypass_pairs, controlled_pairs, friction_driving_min, friction_driven_min, friction_driving_max, friction_driven_max
):
    """Accuracy factor of an ordinary clutch in its place, K_т at C = 0; with one material f_max/f_min.
    Source: F11 (14) at C = 0. Validity: f_1 and f_2 move together (F11's working hypothesis)."""
    largest = bypass_pairs * friction_driving_max + controlled_pairs * friction_driven_max
    return largest / (bypass_pairs * friction_driving_min + controlled_pairs * friction_driven_min)


def accuracy_factor_of_path(bypass_pairs, controlled_pairs, gain, friction_driving_min, friction_driven_min,
                            friction_driving_max, friction_driven_max):  # fmt: skip
    """Accuracy factor along the common path, K_т = T(f_1max, f_2max)/T(f_1min, f_2min).
    Source: F11 (14); with one material S19 and S22 (18). Validity: f_1 and f_2 move together (F11's working
    hypothesis). Below 1 where the torque falls with friction (unlike materials, z_1 C f_1 > 1); the ratio
    largest/smallest torque is then 1/K_т."""
    largest = bypass_pairs * friction_driving_max + controlled_pairs * friction_driven_max
    least = bypass_pairs * friction_driving_min + controlled_pairs * friction_driven_min
    feedback = controlled_pairs * gain
    return largest * (1 + feedback * friction_driven_min) / (least * (1 + feedback * friction_driven_max))


def trip_ratio_min(torque_min, running_torque):
    """Least trip torque as a multiple of the rated torque, k_min = T_min/T_0.
    Source: Definition; T_0 by the plate of the motor, without it the nominal torque of the machine. Validity: Slipping
    clutch, friction within its range, set once."""
    return torque_min / running_torque


def trip_ratio_max(torque_max, running_torque):
    """Largest trip torque as a multiple of the rated torque, k_max = T_max/T_0.
    Source: Definition; T_0 by the plate of the motor, without it the nominal torque of the machine. Validity: As
    k_min."""
    return torque_max / running_torque


def trip_ratio_ordinary(trip_ratio_min, conventional_accuracy_factor):
    """Largest trip torque of an ordinary clutch in its place, as a multiple of the rated torque, k_о = k_min
    K_т(C = 0).
    Source: Identity: K_т of the ordinary clutch on the same least torque. Validity: Same least torque and friction;
    with one material K_т(C = 0) = f_max/f_min."""
    return trip_ratio_min * conventional_accuracy_factor


# the torque may have an extreme within the range: with unlike materials at their means, behind curved pockets at f_L;
# on either side of it T is monotone


def _torque_min(torque_at_f_min, torque_between, torque_at_f_max):
    """Smallest slip torque, at an end of the range or at the one point inside where the torque may have an extreme.
    Source: F11 (12); handbook, chapters 3 and 12. Validity: f_1 and f_2 move together; straight springs."""
    return smaller(torque_at_f_min, torque_between, torque_at_f_max)


def _torque_max(torque_at_f_min, torque_between, torque_at_f_max):
    """Largest slip torque, at an end of the range or at a possible extreme inside; at a jump the value before it.
    Source: F11 (12); handbook, chapters 3 and 12. Validity: f_1 and f_2 move together; straight springs."""
    return larger(torque_at_f_min, torque_between, torque_at_f_max)


def _friction_of_torque_min(torque_at_f_min, torque_between, torque_at_f_max, friction_driving_min, friction_between,
                            friction_driving_max):  # fmt: skip
    """Friction (f_1) where the torque is smallest.
    Source: F11 (12); handbook, chapters 3 and 12. Validity: f_1 and f_2 move together; straight springs."""
    frictions = friction_driving_min, friction_between, friction_driving_max
    return place_of_smallest((torque_at_f_min, torque_between, torque_at_f_max), frictions)


def _friction_of_torque_max(torque_at_f_min, torque_between, torque_at_f_max, friction_driving_min, friction_between,
                            friction_driving_max):  # fmt: skip
    """Friction (f_1) where the torque is largest.
    Source: F11 (12); handbook, chapters 3 and 12. Validity: f_1 and f_2 move together; straight springs."""
    frictions = friction_driving_min, friction_between, friction_driving_max
    return place_of_largest((torque_at_f_min, torque_between, torque_at_f_max), frictions)


TURNING = {
    "torque_min": _torque_min, "torque_max": _torque_max, "friction_of_torque_min": _friction_of_torque_min,
    "friction_of_torque_max": _friction_of_torque_max,
}  # fmt: skip

CASES = {
    "worst_case": {"torque_max": "torque_max_worst_case", "torque_min": "torque_min_worst_case"},
    "peak": {"torque_max": "breakaway_torque_at_f_max", "torque_min": "breakaway_torque_at_f_min"},
}
