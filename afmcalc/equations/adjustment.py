"""Adjustment: the closing-spring force for a nominal torque (theory, section 4)."""

from ._types import Number


def closing_force(nominal_torque: Number, margin: Number, torque_per_force: Number) -> Number:
    """Closing-spring force that gives the nominal torque at the setting, β_н T_н/[R g(f_set)].

    Source: S19 (1), (2), (5) with β_н = 1 and f_set = f_min; (3), (4), (6) with f_set = f_cp.

    Args:
        nominal_torque: T_н [N*m].
        margin: β_н; 1 for min-friction [1].
        torque_per_force: R g(f_set) = T(f_set)/F_п [m].

    Returns:
        F_п [N].

    Validity:
        T proportional to F_п, as in every variant.
    """
    return margin * nominal_torque / torque_per_force


def nominal_torque(closing_force: Number, margin: Number, torque_per_force: Number) -> Number:
    """Nominal torque that a closing force gives, F_п R g(f_set)/β_н: the inverse of ``closing_force``.

    Source: S19 (1)–(4).

    Args:
        closing_force: F_п as set [N].
        margin: β_н; 1 for min-friction [1].
        torque_per_force: R g(f_set) = T(f_set)/F_п [m].

    Returns:
        T_н [N*m].

    Validity:
        As ``closing_force``.
    """
    return closing_force * torque_per_force / margin
