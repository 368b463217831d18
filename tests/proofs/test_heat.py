"""Heat and wear of a trip, and what the torque law neglects (handbook, chapters 9, 10, 13)."""

import sympy as sp
from proofs.symbols import *

from afmcalc.equations import effects, heat, indirect, pressure

J, M, w0, tau = positive("J_1 M_1 omega_0 tau")
k, rho, c, m, A = positive("k rho c m A")
mu, fn, rs = positive("mu f_next r_s")
SPEED = sp.Function("omega")


def slip_until_the_motor_stands():
    """V1, from the balance of the motor side J_1 dω/dt = M_1 − T and the power T ω turned into heat."""
    speed = heat.speed_after(w0, J, T_n, M, t)
    yield "J_1 dω/dt = M_1 − T", J * sp.diff(speed, t) - (M - T_n)
    yield "ω(0) = ω_0", speed.subs(t, 0) - w0
    stop = heat.run_down_time(J, w0, T_n, M)
    yield "it stands", speed.subs(t, stop)
    total = sp.integrate(T_n * speed, (t, 0, stop))
    yield "Q = ∫ T ω dt", heat.slip_energy(T_n, w0, 0, stop) - total
    turned = sp.integrate(speed, (t, 0, stop))
    yield "kinetic energy and motor work = Q", J * w0**2 / 2 + M * turned - total
    part = sp.integrate(T_n * speed.subs(t, tau), (tau, 0, t))
    yield "until any time", heat.slip_energy(T_n, w0, speed, t) - part
    yield "at an even speed", heat.slip_energy(T_n, w0, w0, t) - T_n * w0 * t


def temperature_of_the_discs():
    """Heat, area, rise: what comes in stays in the discs; in the mean of many trips it goes to the air."""
    inner, width, radius = positive("r_i w rho_r")
    face = heat.friction_area(inner, inner + width, sp.pi)
    yield "A = ∫ 2π r dr", face - sp.integrate(2 * sp.pi * radius, (radius, inner, inner + width))
    yield "F = p A", symbolic(pressure.mean_pressure)(F, inner, inner + width) * face - F
    energy, rise = positive("Q Delta")
    yield "z A q_A = Q", z * A * heat.specific_work(energy, z, A) - energy
    yield "z A q = T ω", z * A * heat.power_density(heat.slip_power(T_n, w0), z, A) - T_n * w0
    yield "m c ΔΘ = Q", m * c * heat.temperature_rise(energy, m, c) - energy
    limit, ambient = positive("Theta_m Theta_0")
    trips = heat.trips_without_cooling(limit, ambient, rise)
    yield "Θ_0 + n ΔΘ = Θ_max", ambient + trips * rise - limit
    yield "η n = 1", heat.share_of_rise(ambient + rise, ambient, limit) * trips - 1
    rate = heat.trips_per_time(k, limit, ambient, energy)
    yield "heat in = heat out", rate * energy - k * (limit - ambient)
    headroom = positive("H")
    between = heat.time_between_trips(m, c, k, -sp.log(1 - rise / headroom))
    # what cooling leaves of the headroom, and the next trip's rise, make it up again
    left = headroom * sp.exp(-between * k / (m * c))
    yield "the limit again after every trip", left + rise - headroom
    depth = heat.heated_depth(m, rho, z, A)
    yield "z A l ρ = m", z * A * depth * rho - m


def wear_of_a_lining():
    """Volume worn and thickness lost; the spring follows the pack."""
    depth, worn, energy = positive("s_w w_v Q")
    trips = heat.trips_to_wear_out(z, A, depth, worn, energy)
    yield "trips × volume of one = z A s_w", trips * worn * energy - z * A * depth
    lost = effects.force_lost_by_wear(k, z, depth)
    yield "ΔF = c Σ δ", lost - k * sum(depth for _ in range(3)) * z / 3
    yield "ΔF/(F δ)", heat.setting_loss_per_wear(k, z, F) * F * depth - lost


def discs_in_their_splines():
    """A disc between two pairs: what both turn it with presses it on its spline, whose friction holds it."""
    near = effects.spline_share(mu, f, R, rs)
    far = effects.spline_share(mu, fn, R, rs)
    grip = mu * (indirect.torque(N, R, 1, f)) / rs
    for sign, law in ((1, effects.next_force_closing), (-1, effects.next_force_opening)):
        after = law(N, near, far)
        turned = grip + mu * indirect.torque(after, R, 1, fn) / rs
        yield "N − N' = ± μ_s (T + T')/r_s", N - after - sign * turned
        yield "without friction nothing is held", law(N, 0 * near, 0 * far) - N


def centrifugal_force_of_the_balls():
    """A ball thrown outward leans on both cones alike; each gives back the axial part of its normal force."""
    angle, ball = positive("alpha r_b")
    mass = effects.ball_mass(rho, ball, sp.pi)
    yield "m = ρ V", mass - sp.integrate(rho * sp.pi * (ball**2 - tau**2), (tau, -ball, ball))
    half = m * w0**2 * r / 2
    normal = half / sp.cos(angle)
    thrust = effects.centrifugal_thrust(n, m, w0, r, sp.tan(angle))
    yield "n half reactions", thrust - n * normal * sp.sin(angle)
