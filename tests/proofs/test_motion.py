"""The drive in time: inertias that stick and slip, motor, lag, and the control unit as a torsion spring (section 9)."""

import pytest
import sympy as sp
from proofs.symbols import *

from afmcalc.equations import adjustment, curved, direct, drive, heat, indirect, machine, overload, pack, sleeve

J1, J2, Jh, k, zeta, speed, M, L, T, tau, N = positive("J_1 J_2 J_h k zeta omega M L T tau N")
phi, time, rate = positive("phi t phi_dot")


def shaft():
    """Shaft and driven half are an oscillator; the inertia torque is its energy."""
    damping = exact(drive.shaft_damping(zeta, k, J2))
    natural = sp.sqrt(k / J2)
    yield "J_2 φ'' + d φ' + k φ has the damping ratio ζ", damping / J2 - 2 * zeta * natural
    yield "T_s: elastic part", drive.shaft_torque(k, phi, damping, 0) - k * phi
    yield "T_s: viscous part", drive.shaft_torque(k, 0, damping, rate) - damping * rate
    swing = (speed / natural) * sp.sin(natural * time)
    yield "free swing of a locked tool", sp.diff(swing, time, 2) * J2 + k * swing
    yield "it starts at ω_0", sp.diff(swing, time).subs(time, 0) - speed
    top = drive.shaft_torque(k, swing.subs(time, sp.pi / 2 / natural), 0, 0)
    inertia = exact(drive.inertia_torque(speed, k, J2))
    yield "its peak is the inertia torque (V2)", inertia - top
    a, above = positive("a Delta")
    peak = exact(drive.stop_torque(J2, a, T + above, T) - J2 * a)
    wound = k * a * sp.sqrt(2 * above / (k * a))  # rate of the torque as the slip begins, at t_1
    yield "V4: amplitude about T + J_2 a", peak**2 - (J2 * a) ** 2 - (wound / natural) ** 2
    yield "V4: a shaft that is loaded by T already swings to T + 2 J_2 a", peak.subs(above, 0) - J2 * a


@pytest.mark.slow
def kloss_motor():
    """Kloss' curve: breakdown at s_b, and its inverse on the stable branch."""
    Mb, sb, s, ws = positive("M_b s_b s omega_s")
    torque = drive.kloss_torque(Mb, sb, s)
    yield "as Kloss wrote it", torque - 2 * Mb / (s / sb + sb / s)
    yield "M(s_b) = M_b", torque.subs(s, sb) - Mb
    yield "M' vanishes there", sp.diff(torque, s).subs(s, sb)
    # s = q s_b with q < 1, the stable branch, makes the root rational
    beyond = positive("p")
    q = 1 / (1 + beyond)
    slip = exact(drive.kloss_slip(Mb, sb, 2 * Mb / (q + 1 / q)))
    yield "the inverse is the stable branch", rooted(sp.simplify(slip)) - q * sb
    yield "slip at ω", drive.motor_slip(ws * (1 - s), ws) - s


def two_inertias():
    """Newton's laws of two inertias: one speed, or two."""
    stuck = solved((M - T) / J1 - (T - L) / J2, T)
    yield "T of two inertias that turn as one", drive.sticking_torque(M, J1, L, J2) - stuck
    slip = drive.slip_acceleration(M, J1, T, L, J2)
    yield "v' = ω_1' − ω_2'", slip - ((M - T) / J1 - (T - L) / J2)
    yield "v' = (T* − T)(J_1 + J_2)/(J_1 J_2)", slip - (stuck - T) * (J1 + J2) / (J1 * J2)
    decay, rs = positive("e r_s")
    yield "static friction at rest", drive.stribeck_ratio(rs, 1) - rs
    yield "sliding friction at speed", drive.stribeck_ratio(rs, 0) - 1
    yield "linear in e", sp.diff(drive.stribeck_ratio(rs, decay), decay) - (rs - 1)


def run_down():
    """Slip at a constant torque (V1, V5): time and heat by integration."""
    v0 = positive("v_0")
    reduced = J1 * J2 / (J1 + J2)
    free = drive.sticking_torque(M, J1, L, J2)
    v = v0 + drive.slip_acceleration(M, J1, T, L, J2) * time
    end = solved(v, time)
    yield "V5: time", heat.run_down_time(reduced, v0, T, free) - end
    yield (
        "V5: heat",
        heat.slip_energy(T, v0, 0, heat.run_down_time(reduced, v0, T, free)) - sp.integrate(T * v, (time, 0, end)),
    )
    blocked = v0 + (M - T) / J1 * time
    end = solved(blocked, time)
    yield "V1: time", heat.run_down_time(J1, v0, T, M) - end
    yield (
        "V1: heat",
        heat.slip_energy(T, v0, 0, heat.run_down_time(J1, v0, T, M)) - sp.integrate(T * blocked, (time, 0, end)),
    )


def lag_between_expected_and_potential():
    """The lag's two ends: τ → 0 the law itself, τ → ∞ the potential torque of S22."""

    def loaded(ball_torque):
        """F11 (3), (6), (7) with the torque that the load gives the balls."""
        return F - C * ball_torque / R

    pairs = z1 * f1 + z2 * f2
    late = drive.normal_force_rate(N, loaded(R * N * z2 * f2), tau)
    yield "slipping steadily N is that of the direct law", solved(late, N) - direct.normal_force(F, z2, C, f2)
    yield "it follows with the time τ", sp.diff(drive.normal_force_rate(N, L, tau), N) + 1 / tau
    yield "until it is in balance", drive.normal_force_rate(L, L, tau)
    machine = adjustment.machine_torque(direct.torque(F, R, z1, z - z1, C, fmin, fmin), beta, 1)
    held = indirect.torque(loaded(machine * (z - z1) / z), R, z, f)
    at_min = overload.loop_gain(z - z1, C, fmin)
    yield "τ → ∞: T_п of S22 (22)", held - overload.potential_torque(z, F, R, f, beta, at_min)
    own = direct.torque(F, R, z1, z2, C, f1, f2)
    under = loaded(own * z2 * f2 / pairs)
    yield "under its own torque it slips there", indirect.torque(under, R, 1, pairs) - own


def judder():
    """Growth with friction is a derivative; slip at rest on a falling characteristic (V6)."""
    growth = drive.torque_growth(F, R, z1, z2, C, f1, f2)
    share = positive("g")
    grown = direct.torque(F, R, z1, z2, C, share * f1, share * f2)
    yield "∂T/∂ln f", growth - sp.diff(grown, share).subs(share, 1)
    rs, vs, v = positive("r_s v_s v")
    ratio = drive.stribeck_ratio(rs, sp.exp(-R * v / vs))
    slope = sp.diff(ratio, v).subs(v, 0)
    yield "−∂T/∂v at v = 0", drive.judder_damping(growth, R, rs, vs) + growth * slope
    alike = drive.torque_growth(F, R, 0, z, C, f, f)
    own, ordinary = (direct.torque(F, R, 0, z, gain, fmin, fmin) for gain in (C, 0))
    against = alike / own / (drive.torque_growth(F, R, 0, z, 0, f, f) / ordinary)
    yield "V6: against an ordinary clutch of equal T_н", against - (1 + z * C * fmin) / (1 + z * C * f) ** 2


@pytest.mark.slow
def swing_of_the_control_unit():
    """The control unit as a torsion spring with friction: stiffness, loop, the sleeve's mass (V7)."""
    net, back = (
        indirect.net_gain(C, indirect.gain_threshold(R, fk, d)),
        indirect.net_gain_returning(C, indirect.gain_threshold(R, fk, d)),
    )
    moment = sleeve.spring_moment(R, F1, F2, c1, c2, x)
    # S21 (6)–(8): F_п1 − c_1 x + T tan α/r − F_п2 − c_2 x ∓ 2 T f_1/d = 0, tan α/r = C/R
    for sign, kappa in ((1, net), (-1, back)):
        balance = F1 - c1 * x + T * C / R - F2 - c2 * x - sign * 2 * T * fk / d
        yield "the balance of S21 (6) is T = S/κ", solved(balance, T) - moment / kappa
    work = sp.integrate(moment / R, (x, 0, x))
    r, t, slope = positive("r t C_1")
    per_turn = sleeve.turn(x, R, C, slope)
    # r dφ = tan α dx with tan α = (r/R)(C + C_1 x)
    gain = curved.gain_acting(C, slope, x)
    yield "R dφ/dx = C + C_1 x", R * sp.diff(per_turn, x) - gain
    yield "straight: r φ = x tan α", (sleeve.turn(x, R, C, 0) * r - x * t).subs(C, pack._gain(R, r, t))
    back_again = rooted(exact(sleeve.travel(per_turn, R, C, slope)))
    yield "x of φ is the inverse", back_again - x
    out = sp.integrate(moment / net * C / R, (x, 0, x))
    home = sp.integrate(moment / back * C / R, (x, 0, x))
    yield "V7: loop energy", (C / net - C / back) * work - (out - home)
    yield "share of a swing", 1 - net / back - (out - home) / out
    steep = curved.gain_acting(net, slope, x)
    stiffness = sleeve.torsional_stiffness(c1, c2, R, steep, gain, slope, moment / steep)
    yield "k_T = d(S/κ)/dφ", stiffness - sp.diff(moment / steep, x) / sp.diff(per_turn, x)
    m, rate = positive("m xdot")
    acceleration = sp.Symbol("phi_ddot")
    turning = sp.Symbol("phi_dot")
    yield "x' = φ' dx/dφ", sleeve.travel_rate(turning, R, gain) * sp.diff(per_turn, x) - turning
    # C x' = R φ', differentiated
    xddot = (R * acceleration - slope * rate**2) / gain
    pushed = solved(T * steep / R - moment / R - m * xddot, T)
    inertia = sleeve.sleeve_inertia(m, R, gain, steep)
    taken = sleeve.centrifugal_moment(m, R, gain, slope, rate)
    yield "the sleeve's mass: T = (S − M_m)/κ + μ φ''", pushed - (moment - taken) / steep - inertia * acceleration
    kinetic = m * sleeve.travel(phi, R, C, 0) ** 2 / 2
    ideal = exact((sleeve.sleeve_inertia(m, R, C, net) * phi**2 / 2 - kinetic).subs(fk, 0))
    yield "straight, without friction it is m (R/C)²", ideal


def balls_off_their_stop():
    """Torque through the balls while the sleeve moves: Newton before and behind them."""
    S, kappa, mu = positive("S kappa mu")
    turn = drive.slip_acceleration(M, J1, T, L, J2)
    found = solved(T - S / kappa - mu * turn, T)
    yield "T_b", sleeve.ball_torque_moving(S, kappa, mu, M, J1, L, J2) - found
    yield "without mass S/κ", sleeve.ball_torque_moving(S, kappa, 0, M, J1, L, J2) - S / kappa


def pack_at_the_stop():
    """The seated sleeve: N of the balls' torque, the slipping pack with it."""
    kappa, Tb = positive("kappa T_b")
    pressed = sleeve.normal_force_at_stop(F2, kappa, Tb, R)
    reaction = F2 - F1 - Tb * kappa / R
    yield "N = F_п1 + reaction of the stop", pressed - (F1 + reaction)
    seated = indirect.torque(indirect.normal_force_seated(F2, z, kappa, f), R, z, f)
    yield "steady: the law of S21 at the stop", sleeve.slip_torque_at_stop(z * f, R, F2, kappa, 0, 1) - seated
    off = indirect.sleeve_stiffness(c1, c2, z, f, kappa)
    moved = indirect.travel_as_made(F1, F2, z, f, kappa, off)
    steady = symbolic(indirect.normal_force_moving)(F1, c1, F2, c2, off)
    yield "off it: N where the sleeve is", F1 - c1 * moved - steady
    balls = drive.sticking_torque(T, Jh, L, J2)
    slipping = solved(T - z * f * R * sleeve.normal_force_at_stop(F2, kappa, balls, R), T)
    alone, share = balls.subs(T, 0), J2 / (Jh + J2)
    seated = sleeve.slip_torque_at_stop(z * f, R, F2, kappa, alone, share)
    yield "with the hub's inertia", seated - slipping


def power_from_the_plate():
    """The share that the gear leaves of the motor's power turns the clutch, T_дв ω = η P_н."""
    power, speed, ratio, efficiency = sp.symbols("P omega i eta", positive=True)
    torque = machine.motor_torque_at_clutch(machine.motor_torque(power, speed), ratio, efficiency)
    yield "T_дв ω_н/i = η P_н", torque * speed / ratio - efficiency * power


def shaft_in_torsion():
    """W_p by its integral, and the yield strength in shear by the distortion energy."""
    d, s, x = sp.symbols("d sigma x", positive=True)
    inertia = sp.integrate(2 * sp.pi * x**3, (x, 0, d / 2))
    yield "W_p = I_p/(d/2)", symbolic(machine.polar_section_modulus)(d) - inertia / (d / 2)
    squared = sp.nsimplify(machine.shear_yield_strength(s) ** 2, rational=True, tolerance=1e-12)
    first, third = sp.sqrt(squared), -sp.sqrt(squared)
    yield "σ_1 = τ, σ_3 = −τ", (first**2 + third**2 + (third - first) ** 2) / 2 - s**2


def inertia_of_a_ring():
    """J = ∫ r² dm over the ring."""
    m, a, b, x = sp.symbols("m a b x", positive=True)
    by_radius = sp.integrate(2 * m * x**3 / (a**2 - b**2), (x, b, a))
    yield "J", drive.ring_inertia(m, 2 * a, 2 * b) - by_radius
