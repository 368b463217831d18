"""The control unit of an indirect clutch in motion: a torsion spring that loses a share of every swing (section 9).

φ is the turn of the balls' one half against the other, x the travel of the sleeve, R φ/C of a straight wall. While the
sleeve moves off its stop the friction at the key counts as κ, while it returns as κ₊ (``indirect.net_gain``).
"""

from ._types import Number


def travel(turn: Number, mean_radius: Number, gain: Number, gain_slope: Number) -> Number:
    """Travel of the sleeve for a turn of the balls, x = 2 R φ/[C + √(C² + 2 C_1 R φ)]; R φ/C of a straight wall.

    Source: Theory, section 9: balls roll down the wall, r dφ = tan α dx, with tan α = (r/R)(C + C_1 x) (section 12).

    Args:
        turn: φ [rad].
        mean_radius: R_cp, mean friction radius [m].
        gain: C, feedback gain at the stop [1].
        gain_slope: C_1, how the gain grows with travel [1/m].

    Returns:
        x [m].

    Validity:
        C > 0, C_1 ≥ 0.
    """
    reached = (gain * gain + 2 * gain_slope * mean_radius * turn) ** 0.5
    return 2 * mean_radius * turn / (gain + reached)


def turn(travel: Number, mean_radius: Number, gain: Number, gain_slope: Number) -> Number:
    """Turn of the balls for a travel of the sleeve, φ = (C + ½ C_1 x) x/R.

    Source: Theory, section 9: inverse of ``travel``.

    Args:
        travel: x [m].
        mean_radius: R_cp, mean friction radius [m].
        gain: C, feedback gain at the stop [1].
        gain_slope: C_1, how the gain grows with travel [1/m].

    Returns:
        φ [rad].

    Validity:
        x ≥ 0.
    """
    return (gain + gain_slope * travel / 2) * travel / mean_radius


def travel_rate(turn_rate: Number, mean_radius: Number, gain: Number) -> Number:
    """Speed of the sleeve for a speed of the turn, x' = R φ'/C.

    Source: Theory, section 9: balls roll down the wall, r dφ = tan α dx.

    Args:
        turn_rate: φ' [rad/s].
        mean_radius: R_cp, mean friction radius [m].
        gain: C, feedback gain where the sleeve is [1].

    Returns:
        x' [m/s].

    Validity:
        C > 0.
    """
    return mean_radius * turn_rate / gain


def slackened_force(closing_force: Number, closing_stiffness: Number, travel: Number) -> Number:
    """Normal force with the sleeve off its stop, N = F_п1 − c_1 x.

    Source: S21 (9).

    Args:
        closing_force: F_п1, closing-spring force at the stop [N].
        closing_stiffness: c_1 [N/m].
        travel: x, travel of the sleeve [m].

    Returns:
        N [N].

    Validity:
        x > 0; where it would be negative the springs leave the pack.
    """
    return closing_force - closing_stiffness * travel


def tensed_force(control_force: Number, control_stiffness: Number, travel: Number) -> Number:
    """Force of the control spring with the sleeve off its stop, F_2 = F_п2 + c_2 x.

    Source: S21 (9).

    Args:
        control_force: F_п2, control-spring force at the stop [N].
        control_stiffness: c_2 [N/m].
        travel: x, travel of the sleeve, where springs and balls balance [m].

    Returns:
        F_2 [N].

    Validity:
        x > 0.
    """
    return control_force + control_stiffness * travel


def spring_moment(
    mean_radius: Number,
    closing_force: Number,
    control_force: Number,
    closing_stiffness: Number,
    control_stiffness: Number,
    travel: Number,
) -> Number:
    """Moment of both springs, S(x) = R [F_п2 − F_п1 + (c_1 + c_2) x]; the balls carry S/κ moving off, S/κ₊ returning.

    Source: Theory, section 9: derived from S21 (6)–(8).

    Args:
        mean_radius: R_cp, mean friction radius [m].
        closing_force: F_п1, closing-spring force at the stop [N].
        control_force: F_п2, control-spring force at the stop [N].
        closing_stiffness: c_1 [N/m].
        control_stiffness: c_2 [N/m].
        travel: x, travel of the sleeve [m].

    Returns:
        S [N*m].

    Validity:
        x ≥ 0.
    """
    return mean_radius * (control_force - closing_force + (closing_stiffness + control_stiffness) * travel)


def spring_work(
    closing_force: Number, control_force: Number, closing_stiffness: Number, control_stiffness: Number, travel: Number
) -> Number:
    """Work stored in both springs, W = (F_п2 − F_п1) x + ½ (c_1 + c_2) x².

    Source: Theory, section 9: integral of ``spring_moment``/R over the travel.

    Args:
        closing_force: F_п1, closing-spring force at the stop [N].
        control_force: F_п2, control-spring force at the stop [N].
        closing_stiffness: c_1 [N/m].
        control_stiffness: c_2 [N/m].
        travel: x, travel of the sleeve [m].

    Returns:
        W [J].

    Validity:
        x ≥ 0.
    """
    stiffness = closing_stiffness + control_stiffness
    return (control_force - closing_force) * travel + stiffness * travel * travel / 2


def loop_energy(spring_work: Number, gain: Number, net_gain: Number, net_gain_returning: Number) -> Number:
    """Energy that one swing out and back loses at the key, (C/κ − C/κ₊) W.

    Source: Theory, section 9: derived (V7): T dφ = (C/κ) dW outwards, (C/κ₊) dW back.

    Args:
        spring_work: W, stored in the springs at the turning point [J].
        gain: C, feedback gain [1].
        net_gain: κ [1].
        net_gain_returning: κ₊ [1].

    Returns:
        E [J].

    Validity:
        From the stop and back to it.
    """
    return (gain / net_gain - gain / net_gain_returning) * spring_work


def damped_share(net_gain: Number, net_gain_returning: Number) -> Number:
    """Share of a swing that the key damps, ψ = 1 − κ/κ₊.

    Source: Theory, section 9: derived: loop energy over the work of the way out.

    Args:
        net_gain: κ [1].
        net_gain_returning: κ₊ [1].

    Returns:
        ψ [1].

    Validity:
        κ > 0.
    """
    return 1 - net_gain / net_gain_returning


def torsional_stiffness(
    closing_stiffness: Number,
    control_stiffness: Number,
    mean_radius: Number,
    net_gain: Number,
    gain: Number,
    gain_slope: Number,
    ball_torque: Number,
) -> Number:
    """Stiffness of the control unit as a torsion spring, k_T = R [(c_1 + c_2) R − C_1 T_b]/(κ C).

    Source: Theory, section 9: d(S/κ)/dφ; of a wall that holds the torque (section 12) it is 0.

    Args:
        closing_stiffness: c_1 [N/m].
        control_stiffness: c_2 [N/m].
        mean_radius: R_cp, mean friction radius [m].
        net_gain: κ, κ₊ while it returns, where it is [1].
        gain: C, feedback gain where the sleeve is [1].
        gain_slope: C_1, how the gain grows with travel [1/m].
        ball_torque: T_b = S/κ [N*m].

    Returns:
        k_T [N*m/rad].

    Validity:
        Sleeve off its stop.
    """
    springs = (closing_stiffness + control_stiffness) * mean_radius - gain_slope * ball_torque
    return mean_radius * springs / (net_gain * gain)


def sleeve_inertia(mass: Number, mean_radius: Number, gain: Number, net_gain: Number) -> Number:
    """Inertia with which a sleeve's mass counts in φ, μ = m R²/(C κ).

    Source: Theory, section 9: T κ/R = F + m x'' with x = R φ/C; with a key free of friction m (R/C)².

    Args:
        mass: m, mass of the sleeve [kg].
        mean_radius: R_cp, mean friction radius [m].
        gain: C, feedback gain [1].
        net_gain: κ, κ₊ while it returns [1].

    Returns:
        μ [kg*m^2].

    Validity:
        The balls stay on the wall.
    """
    return mass * mean_radius * mean_radius / (gain * net_gain)


def ball_torque_moving(
    spring_moment: Number,
    net_gain: Number,
    sleeve_inertia: Number,
    drive_torque: Number,
    drive_inertia: Number,
    load_torque: Number,
    load_inertia: Number,
) -> Number:
    """Torque through the balls while the sleeve moves, T_b = S/κ + μ φ'' with φ'' = (M − T_b)/J_1 − (T_b − L)/J_2.

    Source: Theory, section 9: derived; solved for T_b.

    Args:
        spring_moment: S [N*m].
        net_gain: κ, κ₊ while it returns [1].
        sleeve_inertia: μ [kg*m^2].
        drive_torque: M, torque on the inertia before the balls [N*m].
        drive_inertia: J_1, inertia before the balls [kg*m^2].
        load_torque: L, torque of the load on the inertia behind them [N*m].
        load_inertia: J_2, inertia behind the balls [kg*m^2].

    Returns:
        T_b [N*m].

    Validity:
        The balls stay on the wall: T_b > 0.
    """
    free = drive_torque / drive_inertia + load_torque / load_inertia
    return (spring_moment / net_gain + sleeve_inertia * free) / (
        1 + sleeve_inertia * (1 / drive_inertia + 1 / load_inertia)
    )


def normal_force_at_stop(control_force: Number, net_gain: Number, ball_torque: Number, mean_radius: Number) -> Number:
    """Normal force with the sleeve at its stop, N = F_п2 − κ T_b/R.

    Source: S21 p. 2 (theory, section 5): κ while the torque rises, κ₊ while it falls; between the two the key holds N.

    Args:
        control_force: F_п2, control-spring force at the stop [N].
        net_gain: κ, κ₊ while it returns [1].
        ball_torque: T_b, torque through the balls [N*m].
        mean_radius: R_cp, mean friction radius [m].

    Returns:
        N [N].

    Validity:
        T_b ≥ 0, N ≥ F_п1.
    """
    return control_force - net_gain * ball_torque / mean_radius


def slip_torque_at_stop(
    friction_pairs: Number,
    mean_radius: Number,
    control_force: Number,
    net_gain: Number,
    torque_alone: Number,
    torque_share: Number,
) -> Number:
    """Torque of the slipping pack with the sleeve at its stop, T_f = zf R N, N of T_b = T_b0 + j T_f.

    Source: Theory, section 9: derived from ``normal_force_at_stop`` and ``drive.sticking_torque``; solved for T_f.

    Args:
        friction_pairs: zf, pairs times friction [1].
        mean_radius: R_cp, mean friction radius [m].
        control_force: F_п2, control-spring force at the stop [N].
        net_gain: κ or κ₊ [1].
        torque_alone: T_b0, torque that the balls would pass without friction of the pack [N*m].
        torque_share: j, share of the pack's torque that the balls pass [1].

    Returns:
        T_f [N*m].

    Validity:
        T_f and T_b of one sign.
    """
    pressed = control_force * mean_radius - net_gain * torque_alone
    return friction_pairs * pressed / (1 + friction_pairs * net_gain * torque_share)


def centrifugal_moment(
    mass: Number, mean_radius: Number, gain: Number, gain_slope: Number, travel_rate: Number
) -> Number:
    """Moment that a steepening wall takes from a moving sleeve, M_m = m R C_1 x'²/C, beside S.

    Source: Theory, section 9: x'' = (R φ'' − C_1 x'²)/C, from C x' = R φ' with C = C_0 + C_1 x.

    Args:
        mass: m, mass of the sleeve [kg].
        mean_radius: R_cp, mean friction radius [m].
        gain: C, feedback gain where the sleeve is [1].
        gain_slope: C_1, how the gain grows with travel [1/m].
        travel_rate: x' [m/s].

    Returns:
        M_m [N*m].

    Validity:
        The balls stay on the wall.
    """
    return mass * mean_radius * gain_slope * travel_rate * travel_rate / gain
