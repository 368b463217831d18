"""Control unit, contact and friction surface (S21 (16)–(24); textbooks)."""

import sympy as sp

from ..equations import direct, indirect, synthesis
from . import Identity, Refutation, Steps
from .symbols import C, F, R, c1, c2, d, fk, fmax, fmin, n, p, q, r, x, z

__all__ = [
    "ball_and_pocket",
    "contact_force_of_the_balls",
    "cut_of_the_pockets",
    "hertz_ball_on_flat",
    "least_contact_force",
    "mean_radii",
    "surface_pressures",
]

ALPHA = sp.Symbol("alpha", positive=True)
BALL, GAP, EDGE = sp.symbols("r_b s y", positive=True)


def ball_and_pocket() -> Steps:
    """S21 (17)–(24): (20) = (22) for the ball of (23); C from (24)."""
    tangent = synthesis.tan_wall_angle(C, r, R)
    yield Identity("(24) inverts C = (R/r) tan α", direct.gain(R, r, tangent) - C)
    sine, cosine = sp.sin(ALPHA), sp.cos(ALPHA)
    ball = synthesis.ball_radius(x, GAP, EDGE, sine)
    yield Identity("(23)", ball * 2 * sine - (x + GAP + 2 * EDGE))
    apex = (BALL / cosine) * BALL / (BALL * sp.tan(ALPHA))
    yield Identity(
        "(20): OC = r_ш OA/AB of (17)–(19), less s/2", synthesis.pocket_depth(BALL, sine, GAP) - (apex - GAP / 2)
    )
    below = apex - BALL * sine
    deep = synthesis.pocket_depth_from_travel(BALL, sine, cosine, x, EDGE)
    yield Identity("(22): CD of (21) with x_max/2 + y", deep - (below + x / 2 + EDGE))
    yield Identity(
        "(20) = (22)",
        synthesis.pocket_depth(ball, sine, GAP) - synthesis.pocket_depth_from_travel(ball, sine, cosine, x, EDGE),
    )
    yield Identity("y for a given ball inverts (23)", synthesis.edge_clearance(ball, x, GAP, sine) - EDGE)


def cut_of_the_pockets() -> Steps:
    """Depth, mouth and web from where ball, wall and face lie: the ball's centre at 0, the face at s/2."""
    sine, cosine = sp.sin(ALPHA), sp.cos(ALPHA)
    deepest = sp.solve(sp.diff(BALL * sp.sin(x), x), x)[0]
    lowest = (BALL * sp.sin(x)).subs(x, deepest)
    yield Identity("h_c: lowest point of the ball", synthesis.pocket_depth_cut(BALL, GAP) - (lowest - GAP / 2))
    width = synthesis.pocket_width(synthesis.pocket_depth(BALL, sine, GAP), sp.tan(ALPHA))
    yield Identity("the wall from the mouth touches the ball", GAP / 2 * sine + width / 2 * cosine - BALL)
    step = sp.Matrix([sp.cos(2 * ALPHA) - 1, sp.sin(2 * ALPHA)]) * r
    pitch = synthesis.ball_pitch(r, sine)
    yield Identity("chord between balls 2π/n apart", pitch**2 - step.dot(step))
    yield Identity("pitch less a half mouth on either side", synthesis.web(pitch, width) - (pitch - 2 * (width / 2)))


def contact_force_of_the_balls() -> Steps:
    """S21 contact force (M10): the n normal forces carry T about the axis, and the release force along it."""
    cosine = sp.cos(ALPHA)
    torque = sp.Symbol("T", positive=True)
    force = synthesis.contact_force(torque, n, r, cosine)
    yield Identity("moment: n F_n cos α r = T", n * force * cosine * r - torque)
    yield Identity("thrust: n F_n sin α = T tan α/r", n * force * sp.sin(ALPHA) - torque * sp.tan(ALPHA) / r)
    kappa = indirect.net_gain(C, R, fk, d)
    control = indirect.control_force(F, z, kappa, fmin)
    stiffness = indirect.sleeve_stiffness(c1, c2, z, fmax, kappa)
    largest = direct.group_torque(indirect.normal_force_moving(F, c1, control, c2, stiffness), R, z, fmax)
    bracket = c2 + (1 + z * C * fmin) * c1 - 2 * z * R * c1 * fmin * fk / d
    mended = z * F * R * fmax * bracket / (stiffness * n * r * cosine)
    yield Identity("M10 mended", synthesis.contact_force(largest, n, r, cosine) - mended)
    printed = mended / bracket * (c2 + (1 + z * C * fmin) - 2 * z * R * c1 * fmin * fk / d)
    yield Refutation("M10: as printed", synthesis.contact_force(largest, n, r, cosine) - printed)


def least_contact_force() -> Steps:
    """The cubic is where F_n ∝ (a + bC)·√(1 + q²C²)/(a' + b'C) is stationary."""
    a, b, a2, b2 = sp.symbols("a b a_2 b_2", positive=True)
    squared = ((a + b * C) / (a2 + b2 * C)) ** 2 * (1 + q**2 * C**2)
    coefficients = synthesis.least_contact_force_cubic(a, b, a2, b2, q)
    cubic = sum(coefficient * C ** (3 - power) for power, coefficient in enumerate(coefficients))
    slope = sp.diff(squared, C)
    yield Identity("d(F_n²)/dC ∝ the cubic", slope - 2 * (a + b * C) * cubic / (a2 + b2 * C) ** 3)


def hertz_ball_on_flat() -> Steps:
    """Johnson (4.22)–(4.24): contact radius a and pressure p_0 at the allowable force give the allowable pressure."""
    e1, e2, nu1, nu2, pressure, ball, pi = sp.symbols("E_1 E_2 nu_1 nu_2 p_0 r_b pi", positive=True)
    modulus = synthesis.hertz_contact_modulus(e1, nu1, e2, nu2)
    yield Identity("1/E*", 1 / modulus - (1 - nu1**2) / e1 - (1 - nu2**2) / e2)
    force = synthesis.hertz_allowable_force(pressure, ball, q, pi)
    cubed = 3 * force * ball / (4 * q)
    yield Identity("p_0 = 3F/(2πa²), a³ = 3Fr/(4E*)", (3 * force / (2 * pi)) ** 3 - pressure**3 * cubed**2)
    most = synthesis.hertz_pressure(pressure, F, force)
    of_force = (3 * F / (2 * pi)) ** 3 - sp.nsimplify(most**3) * (3 * F * ball / (4 * q)) ** 2
    yield Identity("the same of any force", of_force)


def mean_radii() -> Steps:
    """The friction moment of a ring, ∫ f p 2π r² dr, over f and its thrust ∫ p 2π r dr."""
    inner, width, rho = sp.symbols("r_i w rho", positive=True)
    outer = inner + width
    for pressure, radius in (
        (p, direct.mean_radius_uniform_pressure(inner, outer)),
        (p / rho, direct.mean_radius_uniform_wear(inner, outer)),
    ):
        moment = sp.integrate(pressure * rho**2, (rho, inner, outer))
        thrust = sp.integrate(pressure * rho, (rho, inner, outer))
        yield Identity("R_cp = moment/(f·thrust)", radius - moment / thrust)


def surface_pressures() -> Steps:
    """Mean pressure of a ring and the peak at the inner edge, from their thrust."""
    inner, width, rho = sp.symbols("r_i w rho", positive=True)
    outer = inner + width
    mean = direct.mean_pressure(F, inner, outer, sp.pi)
    yield Identity("∫ p 2π r dr = F", sp.integrate(mean * 2 * sp.pi * rho, (rho, inner, outer)) - F)
    peak = direct.peak_pressure_uniform_wear(F, inner, outer, sp.pi)
    worn = peak * inner / rho
    yield Identity("uniform wear: p = p_i r_i/r", sp.integrate(worn * 2 * sp.pi * rho, (rho, inner, outer)) - F)
    yield Refutation("they differ", mean - peak)
