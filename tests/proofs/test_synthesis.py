"""Control unit, contact, friction surface (S21 (16)–(24); textbooks), curved walls (handbook, chapter 12), best accuracy."""

import pytest
import sympy as sp
from proofs.symbols import *

from afmcalc.equations import accuracy, control_unit, curved_wall, direct, effects, indirect, pack, pressure

ALPHA = positive("alpha")
BALL, GAP, EDGE = positive("r_b s y")
T0, Q, SLOPE, SLEEVES = positive("t_0 q C_1 m")
XI = positive("xi")
K, T = positive("K T")


@pytest.mark.slow
def ball_and_pocket():
    """S21 (17)–(24): (20) = (22) for the ball of (23); C from (24)."""
    tangent = pack.tan_wall_angle(C, r, R)
    yield "(24) inverts C = (R/r) tan α", pack._gain(R, r, tangent) - C
    sine, cosine = sp.sin(ALPHA), sp.cos(ALPHA)
    ball = control_unit.ball_radius(x, XI, GAP, EDGE, sine)
    yield "(23), with a play", ball * 2 * sine - (x + XI + GAP + 2 * EDGE)
    apex = (BALL / cosine) * BALL / (BALL * sp.tan(ALPHA))
    yield "(20): OC = r_ш OA/AB of (17)–(19), less s/2", control_unit.pocket_depth(BALL, sine, GAP) - (apex - GAP / 2)
    below = apex - BALL * sine
    deep = control_unit.pocket_depth_from_travel(BALL, sine, cosine, x, XI, EDGE)
    yield "(22): CD of (21) with x_max/2 + y", deep - (below + (x + XI) / 2 + EDGE)
    yield (
        "(20) = (22)",
        control_unit.pocket_depth(ball, sine, GAP)
        - control_unit.pocket_depth_from_travel(ball, sine, cosine, x, XI, EDGE),
    )
    yield "y for a given ball inverts (23)", control_unit.edge_clearance_standard(ball, x, XI, GAP, sine) - EDGE


@pytest.mark.slow
def cut_of_the_pockets():
    """Depth, mouth and web from where ball, wall and face lie: the ball's centre at 0, the face at s/2."""
    sine, cosine = sp.sin(ALPHA), sp.cos(ALPHA)
    deepest = sp.solve(sp.diff(BALL * sp.sin(x), x), x)[0]
    lowest = (BALL * sp.sin(x)).subs(x, deepest)
    yield "h_c: lowest point of the ball", control_unit.pocket_depth_cut(BALL, GAP) - (lowest - GAP / 2)
    width = control_unit.pocket_width(control_unit.pocket_depth(BALL, sine, GAP), sp.tan(ALPHA))
    yield "the wall from the mouth touches the ball", GAP / 2 * sine + width / 2 * cosine - BALL
    step = sp.Matrix([sp.cos(2 * ALPHA) - 1, sp.sin(2 * ALPHA)]) * r
    pitch = control_unit.ball_pitch(r, sine)
    yield "chord between balls 2π/n apart", pitch**2 - step.dot(step)
    yield "pitch less a half mouth on either side", control_unit.web(pitch, width) - (pitch - 2 * (width / 2))


@pytest.mark.slow
def contact_force_of_the_balls():
    """S21 contact force (M10): the n normal forces carry T about the axis, and the release force along it."""
    cosine = sp.cos(ALPHA)
    torque = positive("T")
    force = control_unit.contact_force(torque, n, r, cosine)
    yield "moment: n F_n cos α r = T", n * force * cosine * r - torque
    yield "thrust: n F_n sin α = T tan α/r", n * force * sp.sin(ALPHA) - torque * sp.tan(ALPHA) / r
    kappa = indirect.net_gain(C, indirect.gain_threshold(R, fk, d))
    control = indirect.control_force_set(F, z, kappa, fmin)
    stiffness = indirect.sleeve_stiffness(c1, c2, z, fmax, kappa)
    largest = indirect.torque(symbolic(indirect.normal_force_moving)(F, c1, control, c2, stiffness), R, z, fmax)
    bracket = c2 + (1 + z * C * fmin) * c1 - 2 * z * R * c1 * fmin * fk / d
    mended = z * F * R * fmax * bracket / (stiffness * n * r * cosine)
    yield "M10 mended", control_unit.contact_force(largest, n, r, cosine) - mended
    printed = mended / bracket * (c2 + (1 + z * C * fmin) - 2 * z * R * c1 * fmin * fk / d)
    yield Refutation("M10: as printed", control_unit.contact_force(largest, n, r, cosine) - printed)


def hertz_ball_on_flat():
    """Johnson (4.22)–(4.24): contact radius a and pressure p_0 at the allowable force give the allowable pressure."""
    e1, e2, nu1, nu2, pressure, ball, pi = positive("E_1 E_2 nu_1 nu_2 p_0 r_b pi")
    modulus = control_unit.contact_modulus(e1, nu1, e2, nu2)
    yield "1/E*", 1 / modulus - (1 - nu1**2) / e1 - (1 - nu2**2) / e2
    force = symbolic(control_unit.contact_force_hertz, pi)(pressure, ball, q)
    cubed = 3 * force * ball / (4 * q)
    yield "p_0 = 3F/(2πa²), a³ = 3Fr/(4E*)", (3 * force / (2 * pi)) ** 3 - pressure**3 * cubed**2
    most = control_unit.contact_pressure(pressure, F, force)
    of_force = (3 * F / (2 * pi)) ** 3 - sp.nsimplify(most**3) * (3 * F * ball / (4 * q)) ** 2
    yield "the same of any force", of_force


def mean_radii():
    """The friction moment of a ring, ∫ f p 2π r² dr, over f and its thrust ∫ p 2π r dr."""
    inner, width, rho = positive("r_i w rho")
    outer = inner + width
    for law, radius in (
        (p, pack._mean_radius_uniform_pressure(inner, outer)),
        (p / rho, pack.mean_radius(inner, outer)),
    ):
        moment = sp.integrate(law * rho**2, (rho, inner, outer))
        thrust = sp.integrate(law * rho, (rho, inner, outer))
        yield "R_cp = moment/(f·thrust)", radius - moment / thrust


def surface_pressures():
    """Mean pressure of a ring and the peak at the inner edge, from their thrust."""
    inner, width, rho = positive("r_i w rho")
    outer = inner + width
    mean = symbolic(pressure.mean_pressure)(F, inner, outer)
    yield "∫ p 2π r dr = F", sp.integrate(mean * 2 * sp.pi * rho, (rho, inner, outer)) - F
    peak = symbolic(pressure._peak_pressure)(F, inner, outer)
    worn = peak * inner / rho
    yield "uniform wear: p = p_i r_i/r", sp.integrate(worn * 2 * sp.pi * rho, (rho, inner, outer)) - F
    yield Refutation("they differ", mean - peak)


@pytest.mark.slow
def wall_of_a_curved_pocket():
    """r dφ = tan α dx; the wall is an envelope of the ball, convex while the ball is smaller than ρ."""
    steepening = curved_wall.path_steepening(SLOPE, r, R)
    path, tangent = curved_wall.path_around(T0, Q, XI), curved_wall.tan_wall_angle_at_ball(T0, Q, XI)
    yield "tan α = Y'", sp.diff(path, XI) - tangent
    turned = curved_wall.path_around(pack.tan_wall_angle(C, r, R), steepening, x)
    yield "r dφ/dx = tan α of C_0 + C_1 x", pack._gain(R, r, sp.diff(turned, x)) - (C + SLOPE * x)
    secant = sp.sqrt(1 + tangent**2)
    sine, cosine = tangent / secant, 1 / secant
    angle = sp.atan(tangent)
    wall = symbolic(curved_wall.wall_axial), symbolic(curved_wall.wall_around)
    along, around = wall[0](XI, BALL, angle), wall[1](path, BALL, angle)
    yield "the wall is r_ш off the path", (along - XI) ** 2 + (around - path) ** 2 - BALL**2
    yield "across it", (along - XI) + tangent * (around - path)
    depth = -along - GAP / 2
    straight = control_unit.edge_clearance_standard(BALL, 2 * XI, 0, GAP, sine)
    yield "S21 (23) with x = 2 ξ", depth - straight
    radius = curved_wall.undercut_radius(Q, cosine)
    yield "ρ = (1 + Y'²)^{3/2}/Y''", radius - secant**3 / sp.diff(path, XI, 2)
    shrink = 1 - BALL / radius
    yield "the wall runs with the path, axially 1 − r_ш/ρ as fast", sp.diff(along, XI) - shrink
    yield "and around", sp.diff(around, XI) - tangent * shrink
    yield "so the contact rises to the face until it undercuts", sp.diff(depth, XI) + shrink
    yield Refutation("not at the radius of the ball", sp.diff(along, XI))


def best_attainable_accuracy():
    """The best K_т of each variant: at the gain limit, at zC = 5, as the gain grows."""
    limit = direct._gain_limit_breakaway(z1, f1max)
    best = (z1 * f1max + z2 * f2min) / (z1 * f1min + z2 * f2min)
    yield "differentiated", best - accuracy.accuracy_factor_of_path(z1, z2, limit, f1min, f2min, f1max, f2max)
    one = best.subs({f1min: fmin, f2min: fmin, f1max: fmax})
    yield "one material: (m z_1 + z_2)/z", one - (fmax / fmin * z1 + z2) / (z1 + z2)
    driving = fmax / fmin * (1 + 5 * fmin) / (1 + 5 * fmax)
    own = accuracy.accuracy_factor_of_path(0, z, direct._gain_limit_reduced(z), fmin, fmin, fmax, fmax)
    yield "all-driving at zC = 5: m (1 + 5 f_min)/(1 + 5 f_max)", driving - own
    factor = accuracy_as_set(fmin, fset, fmax, c1, c2, z, q)
    yield "indirect: K_т → 1 as the gain grows, whatever the setting", sp.limit(factor, q, sp.oo) - 1


def margin_of_the_balls():
    """With s_0 the allowed force is that of the static limit over s_0; every pair gives the play of its own lining."""
    limit, modulus = positive("p_s E")
    forces = [
        control_unit.contact_force_hertz(control_unit.allowable_pressure(limit, s), BALL, modulus) for s in (1, Q)
    ]
    yield "F(s_0) = F(1)/s_0", sp.nsimplify(forces[1] / forces[0], rational=True) - 1 / Q
    yield "the pressure at s_0 = 1", control_unit.allowable_pressure(limit, 1) - limit
    yield "z pairs, each x", control_unit.wear_play(3, x) - (x + x + x)


def key_of_the_pressure_disc():
    """The torque T = z R f N passes the key as a couple 2 T/d, whose friction holds f_7 times it."""
    couple = 2 * indirect.torque(N, R, f, z) / d
    yield "e N = 2 T f_7/d_7", effects.key_share(z, R, f, fk, d) * N - couple * fk


def trip_of_an_ordinary_clutch():
    """T ∝ f with the same T_min."""
    least = accuracy.trip_ratio_min(direct.torque(F, R, z, 0, C, fmin, fmin), T_n)
    most = accuracy.trip_ratio_max(direct.torque(F, R, z, 0, C, fmax, fmax), T_n)
    yield "k_o", accuracy.trip_ratio_ordinary(least, fmax / fmin) - most
