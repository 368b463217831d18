"""Motion of the drive: inertias, shaft, motor, sticking and slipping between them (handbook, chapter 9).

All is reduced to the clutch shaft: motor side J_1 – clutch (indirect: J_h between discs and balls) – driven half J_2 –
shaft (k, d) – tool. Every argument may be an array; shapes broadcast. Radians count as pure numbers.
"""


def ring_inertia(mass, outer_diameter, inner_diameter):
    """Moment of inertia of a ring about its axis, J = m (D² + d²)/8.
    Source: Geometry; handbook, chapter 9. Validity: Rectangular section, uniform density."""
    return mass * (outer_diameter * outer_diameter + inner_diameter * inner_diameter) / 8


def shaft_damping(damping_ratio, stiffness, driven_inertia):
    """Damping of the shaft, d = 2 ζ √(k J_2).
    Source: Definition of the damping ratio of the driven half on the shaft. Validity: ζ ≥ 0."""
    return 2 * damping_ratio * (stiffness * driven_inertia) ** 0.5


def shaft_torque(stiffness, twist, damping, twist_rate):
    """Torque in the shaft, T_s = k φ + d φ'.
    Source: Handbook, chapter 9: Kelvin–Voigt shaft. Validity: Linear shaft without backlash."""
    return stiffness * twist + damping * twist_rate


def inertia_torque(speed, stiffness, driven_inertia):
    """Torque with which the driven half alone twists the shaft of a locked tool, T_J = ω_0 √(k J_2).
    Source: Handbook, chapter 9 (V2): energy, ½ J_2 ω_0² = ½ T_J²/k; while the clutch slips it adds to the sliding
    torque. Validity: Sudden lock, no damping; a slower stop gives less. What turns with the driven half belongs to
    J_2."""
    return speed * (stiffness * driven_inertia) ** 0.5


def stop_torque(driven_inertia, deceleration, torque, load_torque):
    """Peak beyond the sliding torque while the tool slows down, T_a = J_2 a + √(J_2 a [J_2 a + 2 (T − T_0)]).
    Source: Handbook, chapter 9 (V4): its swing about T + J_2 a, with the slip that begins at t_1. Validity: The stop
    lasts until the peak: half a swing of the driven half after the slip begins. No damping, r_s = 1, a motor side far
    heavier than the driven half. The stiffness of the shaft has no part in it."""
    steady = driven_inertia * deceleration
    return steady + (steady * (steady + 2 * (torque - load_torque))) ** 0.5


def stribeck_ratio(static_ratio, decay):
    """Friction at a sliding speed over sliding friction, f(v)/f = 1 + (r_s − 1) e, e = exp(−R|v|/v_s).
    Source: Handbook, chapter 9: Stribeck friction, exponential. Validity: r_s ≥ 1."""
    return 1 + (static_ratio - 1) * decay


def motor_slip(speed, synchronous_speed):
    """Slip of an induction motor, s = 1 − ω/ω_s. Source: Definition. Validity: ω_s > 0."""
    return 1 - speed / synchronous_speed


def kloss_torque(breakdown_torque, breakdown_slip, slip):
    """Torque of an induction motor, M = 2 M_b/(s/s_b + s_b/s), written so that s = 0 gives 0.
    Source: Handbook, chapter 9: Kloss' formula, stator resistance neglected. Validity: Quasi-static: no electromagnetic
    transients."""
    return 2 * breakdown_torque * slip * breakdown_slip / (slip * slip + breakdown_slip * breakdown_slip)


def kloss_slip(breakdown_torque, breakdown_slip, torque):
    """Slip at which an induction motor runs under a torque, s = s_b [M_b/M − √((M_b/M)² − 1)].
    Source: Handbook, chapter 9: Kloss' formula solved for the slip, stable branch. Validity: 0 < M ≤ M_b."""
    ratio = breakdown_torque / torque
    return breakdown_slip * (ratio - (ratio * ratio - 1) ** 0.5)


def sticking_torque(drive_torque, drive_inertia, load_torque, load_inertia):
    """Torque between two inertias that turn as one, T = (M J_2 + L J_1)/(J_1 + J_2).
    Source: Handbook, chapter 9: Newton: (M − T)/J_1 = (T − L)/J_2. It is also T* in case V5, two free inertias
    that slip on each other. Validity: Both inertias > 0."""
    return (drive_torque * load_inertia + load_torque * drive_inertia) / (drive_inertia + load_inertia)


def slip_acceleration(drive_torque, drive_inertia, torque, load_torque, load_inertia):
    """Acceleration of one inertia against the other, v' = (M − T)/J_1 − (T − L)/J_2.
    Source: Handbook, chapter 9: Newton. Validity: Both inertias > 0."""
    return (drive_torque - torque) / drive_inertia - (torque - load_torque) / load_inertia


def normal_force_rate(normal_force, balance, lag):
    """Rate of a normal force that follows its balance late, N' = (N_eq − N)/τ.
    Source: Handbook, chapter 9: release force of the first order, S22's open question. Validity: τ > 0; τ → 0 gives the
    direct law."""
    return (balance - normal_force) / lag


def torque_growth(closing_force, mean_radius, bypass_pairs, controlled_pairs, gain, friction_driving, friction_driven):
    """Growth of the torque with friction, ∂T/∂ln f = F_п R (z_1 f_1 + z_2 f_2)/(1 + C z_2 f_2)².
    Source: Derivative of F11 (12), f_1 and f_2 growing together. Validity: Any direct variant."""
    release = 1 + gain * controlled_pairs * friction_driven
    pairs = bypass_pairs * friction_driving + controlled_pairs * friction_driven
    return closing_force * mean_radius * pairs / (release * release)


def judder_damping(torque_growth, mean_radius, static_ratio, stribeck_speed):
    """Damping that keeps a slow slip steady, d > f T'(r_s f) R (r_s − 1)/v_s.
    Source: Handbook, chapter 9: derived (V6): T falls with the sliding speed, −∂T/∂ω = R T'(r_s f) f (r_s − 1)/v_s as
    v → 0. Validity: Steady slip, small swings of the driven half on its shaft."""
    return torque_growth * mean_radius * (static_ratio - 1) / stribeck_speed
