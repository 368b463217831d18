"""The wall of a curved pocket and its contact (theory, section 12), from the path of the ball's centre."""

import sympy as sp

from ..equations import direct, synthesis, wall
from . import Identity, Refutation, Steps
from .symbols import C, F, R, q, r, x, z

__all__ = ["curved_wall", "curved_wall_contact", "seat_of_the_ball"]

T0, Q, BALL, GAP, SLOPE, SLEEVES = sp.symbols("t_0 q r_b s C_1 m", positive=True)
XI = sp.Symbol("xi", positive=True)


def curved_wall() -> Steps:
    """r dφ = tan α dx; the wall is an envelope of the ball, convex while the ball is smaller than ρ."""
    steepening = wall.path_steepening(SLOPE, r, R, SLEEVES)
    path, tangent = wall.path(T0, Q, XI), wall.path_tangent(T0, Q, XI)
    yield Identity("tan α = Y'", sp.diff(path, XI) - tangent)
    turned = SLEEVES * wall.path(synthesis.tan_wall_angle(C, r, R), steepening, x / SLEEVES)
    yield Identity("r dφ/dx = tan α of C_0 + C_1 x", direct.gain(R, r, sp.diff(turned, x)) - (C + SLOPE * x))
    secant = sp.sqrt(1 + tangent**2)
    sine, cosine = tangent / secant, 1 / secant
    along, around = wall.wall_axial(XI, BALL, sine), wall.wall_around(path, BALL, cosine)
    yield Identity("the wall is r_ш off the path", (along - XI) ** 2 + (around - path) ** 2 - BALL**2)
    yield Identity("across it", (along - XI) + tangent * (around - path))
    depth = wall.contact_depth(BALL, sine, XI, GAP)
    yield Identity("below the face by what is left of s/2", depth + along + GAP / 2)
    straight = synthesis.edge_clearance(BALL, 2 * XI, GAP, sine)
    yield Identity("S21 (23) with x = 2 ξ", depth - straight)
    radius = wall.path_radius(Q, cosine)
    yield Identity("ρ = (1 + Y'²)^{3/2}/Y''", radius - secant**3 / sp.diff(path, XI, 2))
    shrink = 1 - BALL / radius
    yield Identity("the wall runs with the path, axially 1 − r_ш/ρ as fast", sp.diff(along, XI) - shrink)
    yield Identity("and around", sp.diff(around, XI) - tangent * shrink)
    yield Identity("so the contact rises to the face until it undercuts", sp.diff(depth, XI) + shrink)
    yield Refutation("not at the radius of the ball", sp.diff(along, XI))


def seat_of_the_ball() -> Steps:
    """Curved wall at α against both walls of a seat at α_0: two forces bear the one."""
    alpha, seat = sp.symbols("alpha alpha_0", positive=True)
    own = wall.seat_force(F, sp.sin(alpha + seat), sp.sin(seat), sp.cos(seat))
    other = (own * sp.cos(seat) - F * sp.cos(alpha)) / sp.cos(seat)
    along = (own + other) * sp.sin(seat) - F * sp.sin(alpha)
    yield Identity("along the axis, the other wall bearing the rest around", sp.expand_trig(along))
    yield Identity("at the stop one wall bears it all", own.subs(alpha, seat) - F)
    yield Identity("and the other none", sp.simplify(other.subs(alpha, seat)))


def curved_wall_contact() -> Steps:
    """Johnson (4.5), (4.26), (4.27): pressure 3F/(2πab) on an ellipse, (ab)^{3/2} = 3 F R_e φ/(4 E_c)."""
    rho, k, b, d, pressure, modulus, pi = sp.symbols("rho k B D p_0 E_c pi", positive=True)
    ratio = wall.hertz_curvature_ratio(rho, BALL)
    across, along = 1 / (2 * BALL), (1 / BALL + 1 / (rho - BALL)) / 2
    yield Identity("A/B of ball and convex wall", ratio - along / across)
    relative = wall.hertz_relative_radius(BALL, q)
    yield Identity("R_e = 1/(2√(AB))", (2 * relative) ** 2 * (across * across * q) - 1)
    yield Identity("A/B = 1 on a flat", sp.limit(ratio, rho, sp.oo) - 1)
    # (4.26a), (4.27) as printed, in E = K − e²D
    e2 = 1 - k**2
    first, second = b + d, b + d - e2 * d
    printed = (second / k**2 - first) / (first - second)
    yield Identity("(4.26a)", wall.hertz_axes(k, b, d) - printed)
    factor = wall.hertz_ellipse_factor(k, b, d, pi)
    cubed = 4 / (pi * e2) * k ** sp.Rational(3, 2) * sp.sqrt((second / k**2 - first) * (first - second))
    yield Identity("(4.27) squared", sp.nsimplify(factor**2) - sp.simplify(cubed**2))
    circle = {k: 1, b: pi / 4, d: pi / 4}
    yield Identity("a circle: φ = 1", sp.nsimplify(factor.subs(circle)) - 1)
    yield Identity("a circle: A/B = 1", wall.hertz_axes(k, b, d).subs(circle) - 1)
    force = synthesis.hertz_allowable_force(pressure, z * x, modulus, pi)
    area_cubed = (3 * force * z * x / (4 * modulus)) ** 2
    yield Identity("p_0 = 3F/(2πab) at the allowable force", (3 * force / (2 * pi)) ** 3 - pressure**3 * area_cubed)
