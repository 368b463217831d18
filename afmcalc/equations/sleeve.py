"""Motion of the control unit of an indirect clutch: a torsion spring with friction (handbook, chapter 9).

φ is the turn of one half with pockets against the other, x the travel of the sleeve, R φ/C for a straight wall. With
friction at the key the gain is κ while the sleeve moves off its stop, κ₊ while it returns (``indirect.net_gain``).
"""


def travel(turn, mean_radius, gain, gain_slope):
    """Travel of the sleeve for a turn of the balls, x = 2 R φ/[C + √(C² + 2 C_1 R φ)]; R φ/C of a straight wall.
    Source: Handbook, chapter 9: balls roll down the wall, r dφ = tan α dx, with tan α = (r/R)(C + C_1 x) (section 12).
    Validity: C > 0, C_1 ≥ 0."""
    reached = (gain * gain + 2 * gain_slope * mean_radius * turn) ** 0.5
    return 2 * mean_radius * turn / (gain + reached)


def turn(travel, mean_radius, gain, gain_slope):
    """Turn of the balls for a travel of the sleeve, φ = (C + ½ C_1 x) x/R.
    Source: Handbook, chapter 9: inverse of ``travel``. Validity: x ≥ 0."""
    return (gain + gain_slope * travel / 2) * travel / mean_radius


def travel_rate(turn_rate, mean_radius, gain):
    """Speed of the sleeve for a speed of the turn, x' = R φ'/C.
    Source: Handbook, chapter 9: balls roll down the wall, r dφ = tan α dx. Validity: C > 0."""
    return mean_radius * turn_rate / gain


def tensed_force(control_force, control_stiffness, travel):
    """Force of the control spring with the sleeve off its stop, F_2 = F_п2 + c_2 x.
    Source: S21 (6). Validity: x > 0."""
    return control_force + control_stiffness * travel


def spring_moment(mean_radius, closing_force, control_force, closing_stiffness, control_stiffness, travel):
    """Moment of both springs, S(x) = R [F_п2 − F_п1 + (c_1 + c_2) x]; the balls carry S/κ moving off, S/κ₊ returning.
    Source: Handbook, chapter 9: derived from S21 (6)–(8). Validity: x ≥ 0."""
    return mean_radius * (control_force - closing_force + (closing_stiffness + control_stiffness) * travel)


def torsional_stiffness(closing_stiffness, control_stiffness, mean_radius, net_gain, gain, gain_slope, ball_torque):
    """Stiffness of the control unit as a torsion spring, k_T = R [(c_1 + c_2) R − C_1 T_b]/(κ C).
    Source: Handbook, chapter 9: d(S/κ)/dφ; of a wall that holds the torque (section 12) it is 0. Validity: Sleeve off
    its stop."""
    springs = (closing_stiffness + control_stiffness) * mean_radius - gain_slope * ball_torque
    return mean_radius * springs / (net_gain * gain)


def sleeve_inertia(mass, mean_radius, gain, net_gain):
    """Inertia with which a sleeve's mass counts in φ, μ = m R²/(C κ).
    Source: Handbook, chapter 9: T κ/R = F + m x'' with x = R φ/C; with a key free of friction m (R/C)². Validity: The
    balls stay on the wall."""
    return mass * mean_radius * mean_radius / (gain * net_gain)


def ball_torque_moving(spring_moment, net_gain, sleeve_inertia, drive_torque, drive_inertia, load_torque, load_inertia):
    """Torque through the balls while the sleeve moves, T_b = S/κ + μ φ'' with φ'' = (M − T_b)/J_1 − (T_b − L)/J_2.
    Source: Handbook, chapter 9: derived; solved for T_b. Validity: The balls stay on the wall: T_b > 0."""
    free = drive_torque / drive_inertia + load_torque / load_inertia
    return (spring_moment / net_gain + sleeve_inertia * free) / (
        1 + sleeve_inertia * (1 / drive_inertia + 1 / load_inertia)
    )


def normal_force_at_stop(control_force, net_gain, ball_torque, mean_radius):
    """Normal force with the sleeve at its stop, N = F_п2 − κ T_b/R.
    Source: S21, text of fig. 1 (handbook, chapter 5): κ while the torque rises, κ₊ while it falls; between the two the
    key holds N. Validity: T_b ≥ 0, N ≥ F_п1."""
    return control_force - net_gain * ball_torque / mean_radius


def slip_torque_at_stop(friction_pairs, mean_radius, control_force, net_gain, torque_alone, torque_share):
    """Torque of the slipping pack with the sleeve at its stop, T_f = zf R N, N of T_b = T_b0 + j T_f.
    Source: Handbook, chapter 9: derived from ``normal_force_at_stop`` and ``drive.sticking_torque``; solved for T_f.
    Validity: T_f and T_b of one sign."""
    pressed = control_force * mean_radius - net_gain * torque_alone
    return friction_pairs * pressed / (1 + friction_pairs * net_gain * torque_share)


def centrifugal_moment(mass, mean_radius, gain, gain_slope, travel_rate):
    """Moment that a steepening wall takes from a moving sleeve, M_m = m R C_1 x'²/C, beside S.
    Source: Handbook, chapter 9: x'' = (R φ'' − C_1 x'²)/C, from C x' = R φ' with C = C_0 + C_1 x. Validity: The balls
    stay on the wall."""
    return mass * mean_radius * gain_slope * travel_rate * travel_rate / gain
