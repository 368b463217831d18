"""Direct regulation: the release force acts on the spring-loaded pack (handbook, chapter 2).

One law for every direct variant. The pairs form two groups: the *bypass* (driving) pairs z_1 carry torque straight
between the half-couplings, the *controlled* (driven) pairs z_2 carry theirs through the balls. Conventional: z_2 = 0.
All-driving: z_1 = 0.
"""

from .arrays import larger, smaller
from .wiring import Same


def torque_per_force(mean_radius, bypass_pairs, controlled_pairs, gain, friction_driving, friction_driven):
    """Slip torque per spring force, T/F_п = R (z_1 f_1 + z_2 f_2)/(1 + C z_2 f_2).
    Source: F11 (12); R g(f) of S19 (1)–(4). Validity: As ``torque``."""
    carried = bypass_pairs * friction_driving + controlled_pairs * friction_driven
    return mean_radius * carried / (1 + gain * controlled_pairs * friction_driven)


def torque(closing_force, mean_radius, bypass_pairs, controlled_pairs, gain, friction_driving, friction_driven):
    """Sustained slip torque, T = F_п R (z_1 f_1 + z_2 f_2)/(1 + C z_2 f_2).
    Source: F11 (9), (12), (13); S19 (1), (2); S22 (4), (16). Validity: Up to C = 1/(z_1 f_1max) this is also the
    largest torque of the slip; above it the bypass pairs may give a higher breakaway peak first (see
    ``breakaway_torque``)."""
    carried = bypass_pairs * friction_driving + controlled_pairs * friction_driven
    return closing_force * mean_radius * carried / (1 + gain * controlled_pairs * friction_driven)


def normal_force(closing_force, controlled_pairs, gain, friction_driven):
    """Normal force on the friction pairs, N = F_п/(1 + C z_2 f_2).
    Source: F11 (3) with (11) mended (M1). Validity: C, f_2 ≥ 0; balls and thrust bearing without friction."""
    return closing_force / (1 + gain * controlled_pairs * friction_driven)


def release_force(closing_force, controlled_pairs, gain, friction_driven):
    """Release force of the control unit, F_p = F_п C z_2 f_2/(1 + C z_2 f_2).
    Source: F11 (11), mended (M1: the print has lost C from the numerator). Validity: C, f_2 ≥ 0."""
    feedback = gain * controlled_pairs * friction_driven
    return closing_force * feedback / (1 + feedback)


def pack_force_at_rest(closing_force):
    """Force on the pack of the clutch at rest, F_п. Source: F11 (3) with F_p = 0. Validity: Direct regulation."""
    return closing_force


# what each group bears


def _driving_torque(normal_force, mean_radius, bypass_pairs, friction_driving):
    """Torque of the bypass pairs, T_1 = R z_1 f_1 N. Source: F11 (2), (4). Validity: Slipping pairs."""
    return normal_force * mean_radius * bypass_pairs * friction_driving


def _driven_torque(normal_force, mean_radius, controlled_pairs, friction_driven):
    """Torque of the controlled pairs, which passes the balls, T_2 = R z_2 f_2 N.
    Source: F11 (2), (6). Validity: Slipping pairs."""
    return normal_force * mean_radius * controlled_pairs * friction_driven


def _onset_torque(closing_force, mean_radius, bypass_pairs, friction_driving):
    """Torque that the bypass pairs carry alone, before the balls take a share, T_1(0) = R z_1 f_1 F_п.
    Source: F11, text of fig. 1 (the first torque is carried by the driving group alone), with (2) and N = F_п.
    Validity: The balls have not been driven up their walls yet, so that nothing unloads the pack."""
    return closing_force * mean_radius * bypass_pairs * friction_driving


def _driven_torque_max(driven_torque_at_f_min, driven_torque_at_f_max):
    """Largest torque that passes the balls, max[T_2(f_min), T_2(f_max)].
    Source: T_2 is monotone in f (F11 (6) with (11) mended). Validity: Straight walls."""
    return larger(driven_torque_at_f_min, driven_torque_at_f_max)


breakaway_torque = Same("torque")


def _breakaway_torque(onset_torque, torque):
    """Upper bound of the breakaway torque, P = max[T_1(0), T].
    Source: Handbook, chapter 3; F11, after (20). Validity: It depends on how much the balls carried before the slip."""
    return larger(onset_torque, torque)


# over the range

torque_min, torque_max = Same("torque_at_f_min"), Same("torque_at_f_max")
friction_of_torque_min, friction_of_torque_max = Same("friction_min"), Same("friction_max")
torque_min_from_mean, torque_max_from_mean = Same("torque_at_f_mean"), Same("torque_at_f_max")
running_torque = Same("machine_torque")


def torque_max_worst_case(torque_at_f_min, torque_at_f_min_max, torque_at_f_max_min, torque_at_f_max):
    """Largest torque with f_1 and f_2 independent, the largest of the four corners of their ranges.
    Source: Handbook, chapter 3 (beyond F11). Validity: T is monotone in f_1 and in f_2."""
    return larger(torque_at_f_min, torque_at_f_min_max, torque_at_f_max_min, torque_at_f_max)


def torque_min_worst_case(torque_at_f_min, torque_at_f_min_max, torque_at_f_max_min, torque_at_f_max):
    """Smallest torque with f_1 and f_2 independent, the smallest of the four corners of their ranges.
    Source: Handbook, chapter 3 (beyond F11). Validity: T is monotone in f_1 and in f_2."""
    return smaller(torque_at_f_min, torque_at_f_min_max, torque_at_f_max_min, torque_at_f_max)


def _gain_limit_breakaway(bypass_pairs, friction_driving_max):
    """Gain above which the bypass pairs alone carry more than the regulated torque, 1/(z_1 f_1max).
    Source: F11, after (20); S22 (24); S19 has C = 1/f_max, that is z_1 = 1. Validity: z_1 ≥ 1."""
    return 1 / (bypass_pairs * friction_driving_max)


def _gain_limit_reduced(controlled_pairs):
    """Recommended largest gain of the all-driving clutch, from zC ≤ 5.
    Source: S22, after (6), from its reference [4]. Validity: z_1 = 0. A recommendation, not a law."""
    return 5 / controlled_pairs


_BYPASS = {"driving_torque": _driving_torque}
_BALLS = {"driven_torque": _driven_torque, "driven_torque_max": _driven_torque_max}
CONVENTIONAL = {"bypass_pairs": Same("pairs"), "gain": 0.0, **_BYPASS, "breakaway_torque": _onset_torque}
DIFFERENTIATED = {
    "bypass_pairs": 1, **_BYPASS, **_BALLS, "onset_torque": _onset_torque, "breakaway_torque": _breakaway_torque,
    "gain_limit": _gain_limit_breakaway,
}  # fmt: skip
ALL_DRIVING = {"bypass_pairs": 0, **_BALLS, "gain_limit": _gain_limit_reduced}

CASES = {
    "f_min_max": {"friction_driving": "friction_driving_min", "friction_driven": "friction_driven_max"},
    "f_max_min": {"friction_driving": "friction_driving_max", "friction_driven": "friction_driven_min"},
    "by_min": {"closing_force": "closing_force_by_min", "friction_set": "friction_min", "margin_in_spring": "unity"},
    "by_mean": {
        "closing_force": "closing_force_by_mean",
        "friction_set": "friction_mean",
        "margin_in_spring": "margin",
    },
}
