"""Overload with a torque margin (S22; handbook, chapter 6)."""

import sympy as sp
from proofs.symbols import *

from afmcalc.equations import accuracy, adjustment, direct, overload

U = overload.loop_gain(z - z1, C, fmin)
V = overload.loop_gain(z - z1, C, f)
EXPECTED = overload.expected_torque(z, F, R, f, V)
CLUTCH = overload.expected_torque(z, F, R, fmin, U)
MACHINE = adjustment.machine_torque(CLUTCH, beta, 1)
POTENTIAL = overload.potential_torque(z, F, R, f, beta, U)
RISE = overload.load_rise(POTENTIAL, MACHINE, V)
PUBLISHED = overload.actuation_torque_published(POTENTIAL, RISE)
EQUILIBRIUM = overload.actuation_torque_equilibrium(MACHINE, RISE)
LIMIT = overload.distance_to_gain_limit(z1, C, f)
FACTOR = overload.actuation_factor(V, U, f, fmin, beta)


def _all(expression):
    """The all-driving case: z_1 = 0."""
    return expression.subs(z1, 0)


def _capacity(load, friction):
    """Torque the pack can carry while it carries ``load``, shared z_1 : z_2: z f R (F_п − load (z − z_1)/z tan α/r)."""
    release = load * (z - z1) / z * (C * r / R) / r
    return z * friction * R * (F - release)


def nominal_torques():
    """S22 (1)–(4): the clutch's and the machine's nominal torque; (16)."""
    release = positive("T")
    balance = release - z * R * fmin * (F - release * t / r)
    yield "(4) from (2), (3)", _all(CLUTCH) - solved(balance, release).subs(t, C * r / R)
    yield "(1)", MACHINE * beta - CLUTCH
    yield "(16): T_муф is the slip torque", EXPECTED - direct.torque(F, R, z1, z - z1, C, f, f)
    yield "v = (z − z_1) C f", V - (z - z1) * C * f


def potential_torque_from_the_shares():
    """S22 (5), (8), (22) from the release force at T_н.маш; (6), (9) for a risen load."""
    yield "(22)", POTENTIAL - _capacity(MACHINE, f)
    printed = z * F * R * f * (beta + (beta - 1) * z * C * fmin) / (beta * (1 + z * C * fmin))
    yield "(8); (5) at f_min", _all(POTENTIAL) - printed
    risen = _capacity(MACHINE + q, f)
    yield "(6), (9): it falls by (z − z_1) C f ΔT", risen - overload.potential_torque_risen(POTENTIAL, V, q)


def potential_torque_bypass_first():
    """F11's loading: the bypass pairs hold z_1 f R N, the balls the rest, which takes C/R of it from the spring."""
    force = positive("N")
    relieved = solved(force - (F - C * (MACHINE - z1 * f * R * force) / R), force)
    own = symbolic(overload.force_bypass_first)(F, C, R, LIMIT, MACHINE)
    yield "N", relieved - own
    half, tenth = sp.Rational(1, 2), sp.Rational(1, 10)
    yield (
        "N below the gain limit",
        overload.force_bypass_first(2000, half, tenth, 17 * half * tenth, 100) - sp.Rational(30000, 17),
    )
    yield "F_п above it", overload.force_bypass_first(2000, 5, tenth, -half, 100) - 2000
    yield "no force is larger", overload.potential_torque_bound(z, F, R, f) - z * R * f * F
    carried = overload.potential_torque_bypass_first(z, symbolic(overload.force_bypass_first)(F, C, R, LIMIT, q), R, f)
    yield "a load risen up to slip is T_муф", solved(q - carried, q) - EXPECTED


def potential_torque_without_margin():
    """S22 (20) mended (M16): 1 + zC f_min in the denominator."""
    bare = _all(POTENTIAL).subs(beta, 1)
    yield "(20) mended", bare - z * F * R * f / (1 + z * C * fmin)
    yield Refutation("M16: as extracted", bare - z * F * R * f / (1 + z * C * f))


def slip_at_the_clutch_torque():
    """S22 (7), (12), (13), and the paper's own check (M17)."""
    own = solved(MACHINE + q - (POTENTIAL - (z - z1) * C * f * q), q)
    yield "(13) solves (12)", RISE - own
    at_min = {f: fmin}
    rise = overload.load_rise_max(z, F, R, fmin, beta, U)
    yield "(7)", rise - (CLUTCH - MACHINE)
    yield "(13) at f_min is (7): slip at T_н.муф (M17)", RISE.subs(at_min) - rise
    yield "slip at T_max for f_max (M17)", _capacity(EXPECTED, f) - EXPECTED


def equilibrium_torque():
    """Handbook, chapter 6: T_н.маш + ΔT' = T_муф(f) for every β_н; T_п − ΔT' is not (M12)."""
    yield "M12: equilibrium is T_муф", EQUILIBRIUM - EXPECTED
    yield "independent of β_н", sp.diff(EQUILIBRIUM, beta)
    yield Refutation("M12: published T_ср", PUBLISHED - EXPECTED)
    yield "its weights: (v T_п + T_н.маш)/(1 + v)", PUBLISHED - (V * POTENTIAL + MACHINE) / (1 + V)
    yield "swapped: (T_п + v T_н.маш)/(1 + v)", EQUILIBRIUM - (POTENTIAL + V * MACHINE) / (1 + V)


def actuation_as_published():
    """S22 (14), (15) mended (M11), (21), (23)."""
    printed_14 = z * F * R * fmin * (1 + z * C * fmin * (beta - 1)) / (beta * (1 + z * C * fmin))
    yield "(14)", _all(PUBLISHED.subs(f, fmin)) - printed_14
    yield "(23)", EXPECTED * FACTOR - PUBLISHED
    yield "(15) mended: z_1 = 0", _all(EXPECTED * FACTOR) - _all(PUBLISHED)
    bare = _all(FACTOR.subs(beta, 1))
    v, u = z * C * f, z * C * fmin
    yield "(21): β_н = 1", bare - (v * (1 + u) + (1 - v**2) * fmin / f) / (1 + u)
    printed_15 = (beta * v * (1 + u) + (1 - v**2) * fmin) / (beta * (1 + u))
    yield Refutation("M11: printed (15) without ÷ f", _all(FACTOR) - printed_15)
    yield (
        "M19: at β_н = 1 T_ср = T_муф at f_min and at 1/(zC)",
        (bare - 1).subs(f, fmin) ** 2 + (bare - 1).subs(f, 1 / (z * C)) ** 2,
    )
    yield Refutation("M36: below 1/(zC) the published torque is the smaller one", bare - 1)
    yield "M36: A − 1 = (v − 1)(f − f_min)/[f (1 + u)]", bare - 1 - (v - 1) * (f - fmin) / (f * (1 + u))


def actuation_interval():
    """S22 (17): its discriminant is a perfect square, its ends in closed form."""
    u = z * C * fmin
    printed = (beta * (1 + u)) ** 2 - 4 * z * C * (beta * (1 + u) - u) * fmin
    yield "D = (β_н + (β_н − 2) u)²", overload.discriminant(beta, u) - printed
    root = beta + (beta - 2) * u
    yield "a perfect square", overload.discriminant(beta, u) - root**2
    ends = [(beta * (1 + u) + sign * root) / (2 * z * C * (beta * (1 + u) - u)) for sign in (-1, 1)]
    low, high = overload.friction_at_equal_potential(fmin, beta, u), overload.friction_at_unit_loop_gain(z * C)
    yield "the ends are those of (17)", (low - ends[0]) ** 2 + (high - ends[1]) ** 2
    for end in (overload.friction_at_equal_potential(fmin, beta, U), overload.friction_at_unit_loop_gain((z - z1) * C)):
        yield "A = 1 at the end", (FACTOR - 1).subs(f, end)
    yield (
        "at the lower end T_п = T_н.маш",
        (POTENTIAL - MACHINE).subs(f, overload.friction_at_equal_potential(fmin, beta, U)),
    )


def actuation_optimum():
    """S22, the optimum (M13): A = 1 at (z − z_1) C = 1/f_max, where K_т = (f_max + f_min)/(2 f_min)."""
    at_max = _all(FACTOR.subs(f, fmax))
    optimum = overload.optimal_reduced_gain(fmax)
    yield "A = 1", (at_max - 1).subs(C, optimum / z)
    expected = _all(EXPECTED.subs(f, fmax) / CLUTCH)
    own = accuracy.accuracy_factor(EXPECTED.subs(f, fmax), CLUTCH)
    yield "(18) is the ratio of expected torques", _all(own) - expected
    trip = accuracy.accuracy_factor(FACTOR.subs(f, fmax) * EXPECTED.subs(f, fmax), CLUTCH)
    yield "(19) is A times (18)", _all(trip) - at_max * expected
    load = accuracy.accuracy_factor(EXPECTED.subs(f, fmax), EXPECTED.subs(f, fmin))
    yield "at equilibrium (18) once more", _all(load) - expected
    yield "K_т there", expected.subs(C, optimum / z) - (fmax + fmin) / (2 * fmin)
    v, u = z * C * fmax, z * C * fmin
    factored = (v - 1) * (1 - (1 + v) * fmin / (fmax * beta * (1 + u)))
    yield "A − 1 changes sign only there (and at T_п = T_н.маш)", at_max - 1 - factored
    values = {beta: sp.Rational(5, 4), fmin: sp.Rational(1, 10), fmax: sp.Rational(8, 10)}
    yield Refutation("M13: not at zC = 1.6", (at_max - 1).subs(C, sp.Rational(8, 5) / z).subs(values))


def difference_of_potential_torques():
    """S22 (22) less (8) (M15, M18)."""
    own = overload.potential_torque_gain(z, z1, F, R, f, fmin, C, beta)
    yield "M15", own - (POTENTIAL - _all(POTENTIAL))
    yield Refutation("M18: z_1 C f_max is no torque", own - z1 * C * f)


def lost_formulas_of_figure_1():
    """S22 (10), (11) as their symbols allow: Δ = 1 + z(z − 1)(β_н − 1)(1 − C f); fig. 1 follows."""
    delta = 1 + z * (z - 1) * (beta - 1) * (1 - C * f)
    bound = overload.friction_bound(z, beta, 5)
    yield "(11) as printed", bound - (1 / (5 * (z - 1) * (beta - 1)) + z / 5)
    yield "(10) = 0 at any zC", delta.subs(C, q / z).subs(f, overload.friction_bound(z, beta, q))
    yield "(11) is (10) = 0 at zC = 5", delta.subs(C, 5 / z).subs(f, bound)
    slope = sp.diff(bound, z)
    values = {beta: sp.Rational(5, 4)}
    yield "P19: least at z = 3 for β_н = 1.25", slope.subs(values).subs(z, 3)
    yield "P19: f = 1 there", bound.subs(values).subs(z, 3) - 1
    own = overload.potential_torque_gain(z, 1, F, R, f, fmin, C, beta)
    yield Refutation("M15: as a torque difference it is wrong", own - delta)


def margin_effect_changes_sign():
    """S22, text (M31): ∂A/∂β_н has the sign of (v − 1)(v + 1): a smaller margin raises T_ср for f < 1/(zC)."""
    slope = sp.diff(FACTOR, beta)
    yield "M31", slope - fmin * (V - 1) * (V + 1) / (beta**2 * f * (1 + U))
