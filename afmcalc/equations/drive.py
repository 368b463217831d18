"""The drive in time: inertias, shaft, motor, and what sticks and slips between them (theory of the drive, section 9).

All is reduced to the clutch shaft: motor side J_1 – clutch (indirect: J_h between discs and balls) – driven half J_2 –
shaft (k, d) – tool. Every argument may be an array; shapes broadcast. Radians count as pure numbers.
"""

from ._types import Number


def shaft_damping(damping_ratio: Number, stiffness: Number, driven_inertia: Number) -> Number:
    """Damping of the shaft, d = 2 ζ √(k J_2).

    Source: Definition of the damping ratio of the driven half on the shaft.

    Args:
        damping_ratio: ζ [1].
        stiffness: k, torsional stiffness of the shaft [N*m/rad].
        driven_inertia: J_2, inertia of the driven half [kg*m^2].

    Returns:
        d [N*m*s/rad].

    Validity:
        ζ ≥ 0.
    """
    return 2 * damping_ratio * (stiffness * driven_inertia) ** 0.5


def shaft_torque(stiffness: Number, twist: Number, damping: Number, twist_rate: Number) -> Number:
    """Torque in the shaft, T_s = k φ + d φ'.

    Source: Theory, section 9: Kelvin–Voigt shaft.

    Args:
        stiffness: k, torsional stiffness of the shaft [N*m/rad].
        twist: φ, twist of the shaft [rad].
        damping: d [N*m*s/rad].
        twist_rate: φ' = ω_2 − ω_3 [rad/s].

    Returns:
        T_s [N*m].

    Validity:
        Linear shaft without backlash.
    """
    return stiffness * twist + damping * twist_rate


def inertia_torque(speed: Number, stiffness: Number, driven_inertia: Number) -> Number:
    """Torque with which the driven half alone twists the shaft of a locked tool, T_J = ω_0 √(k J_2).

    Source: Theory, section 9 (V2): energy, ½ J_2 ω_0² = ½ T_J²/k; while the clutch slips it adds to the sliding torque.

    Args:
        speed: ω_0, speed before the lock [rad/s].
        stiffness: k, torsional stiffness of the shaft [N*m/rad].
        driven_inertia: J_2, inertia of the driven half [kg*m^2].

    Returns:
        T_J [N*m].

    Validity:
        Sudden lock, no damping; a slower stop gives less. What turns with the driven half belongs to J_2.
    """
    return speed * (stiffness * driven_inertia) ** 0.5


def stop_torque(driven_inertia: Number, deceleration: Number, torque: Number, load_torque: Number) -> Number:
    """Peak beyond the sliding torque while the tool slows down, T_a = J_2 a + √(J_2 a [J_2 a + 2 (T − T_0)]).

    Source: Theory of the drive, section 9 (V4): its swing about T + J_2 a, with the slip that begins at t_1.

    Args:
        driven_inertia: J_2, inertia of the driven half [kg*m^2].
        deceleration: a, deceleration of the tool, ω_0/t_b [rad/s^2].
        torque: T, sliding torque [N*m].
        load_torque: T_0, load before the event [N*m].

    Returns:
        T_a [N*m].

    Validity:
        The stop lasts until the peak: half a swing of the driven half after the slip begins. No damping, r_s = 1, a
        motor side far heavier than the driven half. The stiffness of the shaft has no part in it.
    """
    steady = driven_inertia * deceleration
    return steady + (steady * (steady + 2 * (torque - load_torque))) ** 0.5


def stribeck_ratio(static_ratio: Number, decay: Number) -> Number:
    """Friction at a sliding speed over sliding friction, f(v)/f = 1 + (r_s − 1) e, e = exp(−R|v|/v_s).

    Source: Theory, section 9: Stribeck friction, exponential.

    Args:
        static_ratio: r_s, static over sliding friction [1].
        decay: e, 1 at rest, 0 at high sliding speed [1].

    Returns:
        f(v)/f [1].

    Validity:
        r_s ≥ 1.
    """
    return 1 + (static_ratio - 1) * decay


def motor_slip(speed: Number, synchronous_speed: Number) -> Number:
    """Slip of an induction motor, s = 1 − ω/ω_s.

    Source: Definition.

    Args:
        speed: ω [rad/s].
        synchronous_speed: ω_s [rad/s].

    Returns:
        s [1].

    Validity:
        ω_s > 0.
    """
    return 1 - speed / synchronous_speed


def kloss_torque(breakdown_torque: Number, breakdown_slip: Number, slip: Number) -> Number:
    """Torque of an induction motor, M = 2 M_b/(s/s_b + s_b/s), written so that s = 0 gives 0.

    Source: Theory, section 9: Kloss' formula, stator resistance neglected.

    Args:
        breakdown_torque: M_b [N*m].
        breakdown_slip: s_b [1].
        slip: s [1].

    Returns:
        M_1 [N*m].

    Validity:
        Quasi-static: no electromagnetic transients.
    """
    return 2 * breakdown_torque * slip * breakdown_slip / (slip * slip + breakdown_slip * breakdown_slip)


def kloss_slip(breakdown_torque: Number, breakdown_slip: Number, torque: Number) -> Number:
    """Slip at which an induction motor runs under a torque, s = s_b [M_b/M − √((M_b/M)² − 1)].

    Source: Theory, section 9: Kloss' formula solved for the slip, stable branch.

    Args:
        breakdown_torque: M_b [N*m].
        breakdown_slip: s_b [1].
        torque: M [N*m].

    Returns:
        s [1].

    Validity:
        0 < M ≤ M_b.
    """
    ratio = breakdown_torque / torque
    return breakdown_slip * (ratio - (ratio * ratio - 1) ** 0.5)


def sticking_torque(drive_torque: Number, drive_inertia: Number, load_torque: Number, load_inertia: Number) -> Number:
    """Torque between two inertias that turn as one, T = (M J_2 + L J_1)/(J_1 + J_2).

    Source: Theory, section 9: Newton: (M − T)/J_1 = (T − L)/J_2. It is also T* of two inertias that slip on each other.

    Args:
        drive_torque: M, torque on the driving inertia [N*m].
        drive_inertia: J_1 [kg*m^2].
        load_torque: L, torque of the load on the driven inertia [N*m].
        load_inertia: J_2 [kg*m^2].

    Returns:
        T* [N*m].

    Validity:
        Both inertias > 0.
    """
    return (drive_torque * load_inertia + load_torque * drive_inertia) / (drive_inertia + load_inertia)


def slip_acceleration(
    drive_torque: Number, drive_inertia: Number, torque: Number, load_torque: Number, load_inertia: Number
) -> Number:
    """Acceleration of one inertia against the other, v' = (M − T)/J_1 − (T − L)/J_2.

    Source: Theory, section 9: Newton.

    Args:
        drive_torque: M, torque on the driving inertia [N*m].
        drive_inertia: J_1 [kg*m^2].
        torque: T, torque between the two [N*m].
        load_torque: L, torque of the load on the driven inertia [N*m].
        load_inertia: J_2 [kg*m^2].

    Returns:
        v' [rad/s^2].

    Validity:
        Both inertias > 0.
    """
    return (drive_torque - torque) / drive_inertia - (torque - load_torque) / load_inertia


def normal_force_under_load(closing_force: Number, gain: Number, ball_torque: Number, mean_radius: Number) -> Number:
    """Normal force of a direct clutch that carries a torque without slip, N = F_п − C T_2/R.

    Source: F11 (3), (6), (7), with the torque that the load gives the balls; S22 (5).

    Args:
        closing_force: F_п, closing-spring force as set [N].
        gain: C, feedback gain [1].
        ball_torque: T_2, torque through the balls [N*m].
        mean_radius: R_cp, mean friction radius [m].

    Returns:
        N [N].

    Validity:
        In balance; a torque of the balls of either sign counts positive.
    """
    return closing_force - gain * ball_torque / mean_radius


def normal_force_rate(normal_force: Number, balance: Number, lag: Number) -> Number:
    """Rate of a normal force that follows its balance late, N' = (N_eq − N)/τ.

    Source: Theory, section 9: release force of the first order, S22's open question.

    Args:
        normal_force: N [N].
        balance: N_eq, normal force in balance with the load [N].
        lag: τ [s].

    Returns:
        N' [N/s].

    Validity:
        τ > 0; τ → 0 gives the direct law.
    """
    return (balance - normal_force) / lag


def torque_growth(
    closing_force: Number,
    mean_radius: Number,
    bypass_pairs: Number,
    controlled_pairs: Number,
    gain: Number,
    friction_driving: Number,
    friction_driven: Number,
) -> Number:
    """Growth of the torque with friction, ∂T/∂ln f = F_п R (z_1 f_1 + z_2 f_2)/(1 + C z_2 f_2)².

    Source: Derivative of F11 (12), f_1 and f_2 growing together.

    Args:
        closing_force: F_п, closing-spring force as set [N].
        mean_radius: R_cp, mean friction radius [m].
        bypass_pairs: z_1, pairs that bypass the control unit [1].
        controlled_pairs: z_2, pairs whose torque passes the balls [1].
        gain: C, feedback gain [1].
        friction_driving: f_1 [1].
        friction_driven: f_2 [1].

    Returns:
        f T'(f) [N*m].

    Validity:
        Any direct variant.
    """
    release = 1 + gain * controlled_pairs * friction_driven
    pairs = bypass_pairs * friction_driving + controlled_pairs * friction_driven
    return closing_force * mean_radius * pairs / (release * release)


def judder_damping(torque_growth: Number, mean_radius: Number, static_ratio: Number, stribeck_speed: Number) -> Number:
    """Damping that keeps a slow slip steady, d > f T'(f) R (r_s − 1)/v_s.

    Source: Theory, section 9: derived (V6): T falls with the sliding speed, −∂T/∂ω = R T'(f) f (r_s − 1)/v_s as v → 0.

    Args:
        torque_growth: f T'(f), growth of the torque with friction [N*m].
        mean_radius: R_cp, mean friction radius [m].
        static_ratio: r_s, static over sliding friction [1].
        stribeck_speed: v_s [m/s].

    Returns:
        d_min [N*m*s/rad].

    Validity:
        Steady slip, small swings of the driven half on its shaft.
    """
    return torque_growth * mean_radius * (static_ratio - 1) / stribeck_speed
