"""Unlike materials in the groups of a differentiated clutch: torque may have an extreme at the mean friction (F11)."""

from .arrays import along_path, larger, smaller, spread
from .wiring import Same


def friction_driving_mean(friction_driving_min, friction_driving_max):
    """Mean friction of the bypass pairs where none is given, f_1cp = (f_1min + f_1max)/2.
    Source: Convention: the middle of the range. Validity: 0 < f_1min ≤ f_1max."""
    return (friction_driving_min + friction_driving_max) / 2


def friction_driven_mean(friction_driven_min, friction_driven_max):
    """Mean friction of the controlled pairs where none is given, f_2cp = (f_2min + f_2max)/2.
    Source: Convention: the middle of the range. Validity: 0 < f_2min ≤ f_2max."""
    return (friction_driven_min + friction_driven_max) / 2


torque_between, friction_between = Same("torque_at_f_mean"), Same("friction_driving_mean")


def torque_min_from_mean(torque_at_f_mean, torque_at_f_max):
    """Smallest slip torque from the mean friction on.
    Source: F11 (12): between them T is a quotient of linear functions (handbook, chapter 3). Validity: f_1 and f_2 move
    together."""
    return smaller(torque_at_f_mean, torque_at_f_max)


def torque_max_from_mean(torque_at_f_mean, torque_at_f_max):
    """Largest slip torque from the mean friction on.
    Source: F11 (12): between them T is a quotient of linear functions (handbook, chapter 3). Validity: f_1 and f_2 move
    together."""
    return larger(torque_at_f_mean, torque_at_f_max)


# F11's ratios of the two frictions


def friction_ratio_max(friction_driven_max, friction_driving_max):
    """Ratio of the largest frictions, n = f_2max/f_1max. Source: F11 (15). Validity: f_1max > 0."""
    return friction_driven_max / friction_driving_max


def friction_ratio_min(friction_driven_min, friction_driving_min):
    """Ratio of the smallest frictions, p = f_2min/f_1min. Source: F11 (16). Validity: f_1min > 0."""
    return friction_driven_min / friction_driving_min


def accuracy_factor_by_ratios(bypass_pairs, controlled_pairs, gain, friction_ratio_max, friction_ratio_min,
                              friction_driving_min, friction_driving_max):  # fmt: skip
    """Accuracy factor in ratios, n = f_2max/f_1max, p = f_2min/f_1min, m = f_1max/f_1min.
    Source: F11 (17) with (15), (16). Validity: As ``accuracy_factor``; n and p are free as long as f_2min ≤ f_2max."""
    growth = friction_driving_max / friction_driving_min
    largest = bypass_pairs + controlled_pairs * friction_ratio_max
    least = bypass_pairs + controlled_pairs * friction_ratio_min
    at_min = 1 + controlled_pairs * gain * friction_ratio_min * friction_driving_min
    at_max = 1 + controlled_pairs * gain * friction_ratio_max * friction_driving_max
    return growth * largest * at_min / (least * at_max)


def slope_in_ratio_max(bypass_pairs, controlled_pairs, gain, friction_ratio_max, friction_ratio_min,
                       friction_driving_min, friction_driving_max):  # fmt: skip
    """Slope ∂K_т/∂n; its sign is that of 1 − z_1 C f_1max for every n.
    Source: F11 (18), mended (M2: printed with the factor z_1 − C f_1max). Validity: As
    ``accuracy_factor_by_ratios``."""
    growth = friction_driving_max / friction_driving_min
    at_min = 1 + controlled_pairs * gain * friction_ratio_min * friction_driving_min
    at_max = 1 + controlled_pairs * gain * friction_ratio_max * friction_driving_max
    sign = 1 - bypass_pairs * gain * friction_driving_max
    least = bypass_pairs + controlled_pairs * friction_ratio_min
    return controlled_pairs * growth * at_min * sign / (least * at_max**2)


def slope_in_ratio_min(bypass_pairs, controlled_pairs, gain, friction_ratio_max, friction_ratio_min,
                       friction_driving_min, friction_driving_max):  # fmt: skip
    """Slope ∂K_т/∂p; its sign is that of z_1 C f_1min − 1 for every p.
    Source: F11 (22), mended (M3: printed with the factor C f_1min − z_1). Validity: As
    ``accuracy_factor_by_ratios``."""
    growth = friction_driving_max / friction_driving_min
    largest = bypass_pairs + controlled_pairs * friction_ratio_max
    least = bypass_pairs + controlled_pairs * friction_ratio_min
    at_max = 1 + controlled_pairs * gain * friction_ratio_max * friction_driving_max
    sign = bypass_pairs * gain * friction_driving_min - 1
    return controlled_pairs * growth * largest * sign / (least**2 * at_max)


# frictions of the slips of a life


friction_driving_least, friction_driven_least = Same("friction_driving_min"), Same("friction_driven_min")


def friction_driving_slips(friction_driving_least, friction_driving_mean, friction_driving_max, bend_of_path):
    """Frictions f_1 of slips that are uniformly distributed along the common path, or from the means on, 256 of them.
    Source: Handbook, chapter 4; S19 forecasts from the mean friction on. Validity: f_1 and f_2 move together, to their
    means and on from there."""
    share = spread(0.0, 1.0, 256, ends=False)
    return along_path(share, friction_driving_least, friction_driving_mean, friction_driving_max, bend_of_path)


def friction_driven_slips(friction_driven_least, friction_driven_mean, friction_driven_max, bend_of_path):
    """Frictions f_2 of slips that are uniformly distributed along the common path, or from the means on, 256 of them.
    Source: Handbook, chapter 4; S19 forecasts from the mean friction on. Validity: f_1 and f_2 move together, to their
    means and on from there."""
    share = spread(0.0, 1.0, 256, ends=False)
    return along_path(share, friction_driven_least, friction_driven_mean, friction_driven_max, bend_of_path)


def bend_of_path(friction_driving_least, friction_driving_mean, friction_driving_max, friction_driven_least,
                 friction_driven_mean, friction_driven_max):  # fmt: skip
    """Share of the common path at which both frictions have their means.
    Source: Handbook, chapter 4. Validity: Within the path, not at its ends."""
    first = friction_driving_mean - friction_driving_least + friction_driven_mean - friction_driven_least
    second = friction_driving_max - friction_driving_mean + friction_driven_max - friction_driven_mean
    return larger(smaller(first / larger(first + second, 1e-300), 1 - 1e-12), 1e-12)


SET_AT_MIN = {f"friction_{group}_set": Same(f"friction_{group}_min") for group in ("driving", "driven")}
SET_AT_MEAN = {f"friction_{group}_set": Same(f"friction_{group}_mean") for group in ("driving", "driven")}
OF_SLIPS = {f"friction_{group}": f"friction_{group}_slips" for group in ("driving", "driven")}
OF_SLIPS_FROM_MEAN = {f"friction_{group}_least": f"friction_{group}_mean" for group in ("driving", "driven")}

CASES = {
    **{
        case: {f"friction_{group}": f"friction_{group}_{end}" for group in ("driving", "driven")}
        for case, end in {"f_min": "min", "f_mean": "mean", "f_max": "max", "setting": "set"}.items()
    },
    "by_min": {
        "closing_force": "closing_force_by_min", "margin_in_spring": "unity",
        "friction_driving_set": "friction_driving_min", "friction_driven_set": "friction_driven_min",
    },
    "by_mean": {
        "closing_force": "closing_force_by_mean", "margin_in_spring": "margin",
        "friction_driving_set": "friction_driving_mean", "friction_driven_set": "friction_driven_mean",
    },
}  # fmt: skip
