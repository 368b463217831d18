"""Disc springs as cones that turn about a circle, stacks, coil springs as wires in torsion (handbook, chapter 11)."""

import pytest
import sympy as sp
from proofs.symbols import Refutation, exact, positive

from afmcalc.equations import springs

E, nu, a, b, t, h, s, k4 = positive("E nu a b t h s K_4")
x, y, w, n, i, F, G, d, D, rho, force = positive("x y w n i F G d D rho F_1")
RATIO, LOG = a / b, positive("Lambda")
"""δ, and ln δ, which nothing but the integrals knows to be that."""


def _cross_section():
    """Radius of the circle that keeps its length, turn and cone angle (small)."""
    return (a - b) / LOG, s / (a - b), h / (a - b)


def _k1():
    return springs.disc_factor_load(RATIO, LOG, sp.pi)


def _force(square=1):
    return springs.disc_force(E, nu, _k1(), sp.sqrt(square), 2 * a, t, h, s)


@pytest.mark.slow
def cone_that_turns():
    """Almen & László: hoop strains of a section that turns by φ about c; their moment holds the load at the edges."""
    centre, turn, cone = _cross_section()
    lever = 2 * sp.pi * E / ((1 - nu**2) * (a - b))
    # hoop strain φ[(c − r)(β − φ/2) + y]/r at r and height y, with its lever (c − r)(β − φ) + y; terms odd in y vanish
    squares = centre**2 * LOG - 2 * centre * (a - b) + (a**2 - b**2) / 2
    yield "∫ (c − r)²/r dr", sp.diff(y**2 * sp.log(x) - 2 * y * x + x**2 / 2, x) - (y - x) ** 2 / x
    turned = lever * turn * (cone - turn / 2) * (cone - turn) * t * squares
    bent = lever * turn * t**3 / 12 * LOG
    whole = sp.expand(_force())
    yield "the part that is linear in t", whole.coeff(t, 1) * t - turned
    # the standard takes the same factor for the bending part: exact for narrow rings
    ratio = sp.factor(sp.together(whole.coeff(t, 3) * t**3 / bent)).subs({a: b * sp.exp(w), LOG: w})
    yield "the part in t³ for narrow rings", sp.limit(sp.simplify(ratio), w, 0) - 1
    yield Refutation("only for those", sp.simplify(ratio.subs(w, 1)) - 1)
    stiffness = springs.disc_stiffness(E, nu, _k1(), k4, 2 * a, t, h, s)
    yield "k = dF/ds", stiffness - sp.diff(_force(k4**2), s)


def disc_with_flats_in_numbers():
    """The force at ¾ of the cone height is that of the disc without flats: of 10 mm, ground to 9.4, 14 high."""
    thick, thin, high = 10.0, 9.4, 14.0
    first = springs.disc_flats_first(thick, thin, high)
    factor = springs.disc_factor_flats(first, springs.disc_flats_second(first, thick, thin, high))
    at = 0.75 * (high - thick)
    plain = springs.disc_force(1.0, 0.3, 1.0, 1.0, 200.0, thick, high - thick, at)
    own = springs.disc_force(1.0, 0.3, 1.0, factor, 200.0, thin, high - thin, at)
    yield "F(¾ h_0), to 10⁻⁹", round(1e9 * (own / plain - 1))


def disc_with_flats():
    """K_4 is what keeps the force at ¾ of the cone height of the disc without flats."""
    thinner, height = positive("t_r l_0")
    first = exact(springs.disc_flats_first(t, thinner, height))
    square = exact(springs.disc_factor_flats(first, springs.disc_flats_second(first, t, thinner, height))) ** 2
    (under,) = (part.base for part in square.atoms(sp.Pow) if part.exp == sp.Rational(1, 2))
    half = sp.sqrt(under) - square
    deflection = sp.Rational(3, 4) * (height - t)
    plain = springs.disc_force(E, nu, 1, 1, 2 * a, t, height - t, deflection)
    own = springs.disc_force(E, nu, 1, 1, 2 * a, thinner, height - thinner, deflection)
    bending = 4 * E * thinner**3 * deflection / ((1 - nu**2) * (2 * a) ** 2)
    turning = own - bending

    def made(of):
        return of * (of * turning + bending)

    # K_4² = √D − h in (K_4²)² turning + K_4² bending = plain: what stands with the root, and what without
    yield "F(¾ h_0) is kept: with the root", bending - 2 * half * turning
    yield "F(¾ h_0) is kept: without", turning * (half**2 + under) - bending * half - plain
    root = positive("q")
    stiffer = springs.disc_force(E, nu, 1, root, 2 * a, thinner, height - thinner, deflection)
    yield "K_4 in the force", stiffer - made(root**2)
    yield "no flats", square.subs({thinner: t, height: sp.Rational(7, 5) * t}) - 1


def stresses_at_the_edges():
    """The hoop stress of the turned section at its four corners, up to the factor K_1 the standard took anew."""
    centre, turn, cone = _cross_section()
    old = 6 * ((RATIO - 1) / RATIO) ** 2 / (sp.pi * LOG)
    k2 = springs.disc_factor_membrane(RATIO, LOG, sp.pi)
    k3 = springs.disc_factor_bending(RATIO, LOG, sp.pi)
    outer = (k2 - 2 * k3) / RATIO
    for name, radius, side, membrane, bending in (
        ("I", b, 1, k2, k3),
        ("II", b, -1, k2, -k3),
        ("III", a, -1, outer, -k3 / RATIO),
        ("IV", a, 1, outer, k3 / RATIO),
    ):
        hoop = -E / (1 - nu**2) * turn * k4 * (k4 * (centre - radius) * (cone - turn / 2) + side * t / 2) / radius
        found = springs.disc_stress(E, nu, old, k4, 2 * a, t, h, s, membrane, bending)
        yield f"σ_{name}", found - hoop
    middle = springs.disc_stress(E, nu, old, k4, 2 * a, t, h, s, 0, 3 / sp.pi)
    hoop = -E / (1 - nu**2) * turn * k4 * t / (2 * centre)
    yield "σ_OM: bending where the section turns", middle - hoop
    new = springs.disc_stress(E, nu, 2 * old, k4, 2 * a, t, h, s, 0, 1)
    yield "∝ 1/K_1", new * 2 - springs.disc_stress(E, nu, old, k4, 2 * a, t, h, s, 0, 1)


def stacks_of_discs():
    """Lengths, friction and mass of a stack."""
    length = springs.stack_length(n, i, h + t, t)
    yield "a pack: one free height and n − 1 thicknesses more", length / i - (h + n * t)
    rim, surface = positive("w_R w_M")
    there = springs.stack_force_with_friction(F, n, surface, rim)
    # what friction takes is the share of the force that is there
    yield "F = nF + friction", there - F - there * (surface * (n - 1) + rim)
    mass = springs.ring_mass(rho, 2 * a, 2 * b, t, sp.pi)
    yield "volume of a ring", mass - rho * t * sp.integrate(2 * sp.pi * x, (x, b, a))


def wire_in_torsion():
    """A coil's wire is twisted by F D/2 over its length π D n."""
    polar = sp.pi * d**4 / 32
    twist = (F * D / 2) * sp.pi * D * n / (G * polar)
    yield "s = ϑ D/2", springs.coil_stiffness(G, d, D, n) * twist * D / 2 - F
    index = D / d
    correction = exact(springs.coil_correction(d, D))
    yield "1 + 5/(4w − 3)", correction - 1 - 5 / (4 * index - 3)
    straight = springs.coil_stress(F, d, D, 1, sp.pi)
    yield "straight wire: M/(J/(d/2))", straight - F * D / 2 * (d / 2) / polar
    yield "∝ k_τ", springs.coil_stress(F, d, D, correction, sp.pi) - correction * straight
    turns = springs.coil_solid_length(d, n) / d
    yield "n + 2 turns of wire", turns - n - 2
    gap = exact(springs.coil_least_gap(d, D, n))
    yield "S_a", gap * 2000 * d - n * (3 * D**2 + 200 * d**2)
    volume = sp.pi * d**2 / 4 * sp.pi * D * turns
    yield "mass of the wire", springs.coil_mass(rho, d, D, n, sp.pi) - rho * volume


def wire_that_lasts():
    """Goodman's line τ_a/S_se + τ_m/S_su = 1 through a point known."""
    amplitude, mean, ultimate, lower, endurance = positive("S_sa S_sm S_su tau_U S_se")
    yield "the point", amplitude / springs.coil_endurance(amplitude, mean, ultimate) + mean / ultimate - 1
    upper = springs.coil_upper_stress(lower, endurance, ultimate)
    line = (upper - lower) / 2 / endurance + (upper + lower) / 2 / ultimate
    yield "the line", line - 1


@pytest.mark.slow
def coil_that_buckles():
    """Haringx: P (1 + P/γ) = π² β/(ν L)², bending and shear stiffness of the coil falling as its length L."""
    length, q, seating, share = positive("L_0 q nu_K u")
    # wire of the coil in torsion, bent, and its turns sheared
    spring = G * d**4 / (8 * D**3 * n)
    young, left = G / q, length * (1 - share)
    bending = left * 2 * young * G * d**4 / (32 * n * D * (2 * G + young))
    shear = left * young * d**4 / (8 * D**3 * n)
    load = spring * share * length
    euler = load * (1 + load / shear) * (seating * left) ** 2 - sp.pi**2 * bending
    root = exact(springs.coil_buckling_root(D, length, q, seating, sp.pi))
    square = positive("r")
    at = exact(springs.coil_buckling_deflection(length, q, square**2)) / length
    reduced = sp.cancel(sp.together(euler.subs(share, at)))
    # what is left holds where r² is the root
    yield "s_K/L_0", sp.rem(sp.numer(reduced), sp.numer(sp.together(square**2 - root)), square)
    yield "a slender one at once", springs.coil_buckling_deflection(length, q, 1)
    yield Refutation("only there", reduced)
