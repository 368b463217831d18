"""Release lag of direct clutches: S22's open question, between the law at once and the force of an earlier load."""

import math

import pytest
from drives import clutch, light, plant, run
from scipy.optimize import brentq

from afmcalc.drive.cases import outcome_of
from afmcalc.drive.train import Engine
from afmcalc.laws import overload

ALL_DRIVING = {"variant": "all-driving", "control_unit": {"gain": 0.625}, "friction": {"static_ratio": None, "stribeck_speed": None}}  # fmt: skip


def trip_torque(lag: float, rate: float, friction: float = 0.3) -> float:
    """All-driving pack under a load that rises evenly from 150 N·m (tool locked, motor endless, no swing)."""
    pack = {"closing_force": 3750.0, "bypass_pairs": 0.0, "controlled_pairs": 8.0, "gain": 0.625, "driving": friction, "driven": friction, "lag": lag}  # fmt: skip
    drive = plant(1.0, pack=pack, motor_inertia=1e15, time=0.0, stiffness=8000.0, speed=rate / 8000, engine=Engine(150.0, None, 0.0))  # fmt: skip
    found = run(drive, 2000.0 / rate).trip_torque
    assert found is not None
    return found


@pytest.mark.parametrize(("lag", "rate"), [(5e-3, 1e4), (5e-3, 1e5), (0.05, 3e4), (2e-3, 5e4)])
def test_even_rise_against_the_solved_equation(lag, rate):
    """N = F − (C/R)[T_0 + s t − s τ (1 − e^(−t/τ))]; slip where T_0 + s t = z f R N."""

    def beyond(t: float) -> float:
        normal = 3750 - 6.25 * (150 + rate * t - rate * lag * (1 - math.exp(-t / lag)))
        return 150 + rate * t - 8 * 0.3 * 0.1 * normal

    expected = 150 + rate * brentq(beyond, 0, 1, xtol=1e-15)
    assert trip_torque(lag, rate) == pytest.approx(expected, rel=1e-8)


def test_limits_of_the_lag():
    """s τ → 0 gives T_муф, s τ → ∞ T_п of S22 (5)."""
    own = clutch(**ALL_DRIVING)
    expected = own.torque(0.3)
    at_min = overload.loop_gain(8, 0.625, 0.1)
    potential = overload.potential_torque(8, own.closing_force, 0.1, 0.3, 4 / 3, at_min)
    assert trip_torque(1e-8, 1e4) == pytest.approx(expected, rel=1e-6)
    assert trip_torque(1e4, 1e5) == pytest.approx(potential, rel=1e-6)
    assert expected < trip_torque(1e-3, 1e5) < potential


def test_where_the_drive_trips_is_a_number():
    found = outcome_of(light(control_unit={"release_lag": 0.005}), 0.8)
    expected = light().torque(1.2 * 0.8)
    assert found.potential is not None
    assert found.trip_position == pytest.approx((found.trip.trip_torque - expected) / (found.potential - expected))
    assert 0 < found.trip_position < 1
    assert outcome_of(light(), 0.8).trip_position == pytest.approx(0, abs=1e-9)
    assert outcome_of(
        light(control_unit={"release_lag": 100.0}, drive={"motor_inertia": 0.8}), 0.3
    ).trip_position == pytest.approx(1, abs=1e-3)
