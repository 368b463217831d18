"""Torque and strength from the plate of a motor and the drawing of a shaft (handbook, chapter 4)."""

import math

from .wiring import Same

service_factor = 1.0
drive_ratio = drive_efficiency = 1.0


def motor_torque(motor_power, motor_speed):
    """Rated torque of the motor, M_н = P_н/ω_н: 9550 N·m times P in kW over n in rpm.
    Source: Definition of power; the plate of the motor (IEC 60034-1) has P_н and n. Validity: Power at the shaft of the
    motor, running at its rated speed."""
    return motor_power / motor_speed


def motor_torque_at_clutch(motor_torque, drive_ratio, drive_efficiency):
    """Rated torque of the motor at the clutch, T_дв = M_н i η.
    Source: Identity: power balance of the gear between motor and clutch, i = ω_н/ω. Validity: Steady running."""
    return motor_torque * drive_ratio * drive_efficiency


def torque_asked_for(motor_torque_at_clutch, service_factor):
    """Torque that the machine asks of the clutch, T_маш = K_р T_дв.
    Source: Juvinall & Marshek, Fundamentals of Machine Component Design: a service factor for shocks of the machine.
    Validity: K_р ≥ 1, by the makers of clutches or by experience with such machines."""
    return service_factor * motor_torque_at_clutch


def starting_torque(motor_torque_at_clutch, starting_torque_ratio):
    """Largest torque at the clutch as the motor starts directly, T_пуск = m_п T_дв.
    Source: Definition of m_п in catalogues of motors (IEC 60034-12): starting or breakdown over rated torque. Validity:
    An upper bound: what the motor's own inertia takes of it does not reach the clutch."""
    return starting_torque_ratio * motor_torque_at_clutch


def polar_section_modulus(shaft_diameter):
    """Polar section modulus of a round shaft, W_p = π d_в³/16.
    Source: Theory of elasticity, torsion of a round bar; Juvinall & Marshek, ch. 4. Validity: Solid round section; a
    keyway or a step weakens it."""
    return math.pi * shaft_diameter**3 / 16


def shear_yield_strength(yield_strength):
    """Yield strength in shear, τ_т = σ_т/√3.
    Source: Von Mises: distortion energy of pure shear and of pure tension; Juvinall & Marshek, ch. 6. Validity: Ductile
    material, static load."""
    return (yield_strength**2 / 3) ** 0.5


GIVEN = {"running_torque": Same("motor_torque_at_clutch")}
"""Laws for a motor with a plate: the load before an event is its rated torque."""
BREAKDOWN_GIVEN = {"starting_torque": Same("breakdown_torque")}
"""Laws for a motor with a curve: while starting it passes its breakdown torque, more than at standstill."""
