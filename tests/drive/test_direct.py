"""Clutches in their drive against closed forms: direct ones (V1 to V6), indirect ones (V7), quasi-static loading, the stop."""

import math
from dataclasses import replace

import numpy as np
import pytest
from conftest import slow
from drives import TRAIN, VARIANTS, case, clutch, indirect, light, merged, run
from scipy.integrate import trapezoid
from scipy.optimize import brentq

from afmcalc.drive import cases
from afmcalc.drive.cases import case_of, outcome_of, simulate_clutches
from afmcalc.drive.integrator import peak_time, simulate
from afmcalc.drive.train import Engine
from afmcalc.engines.characteristics import DiscCharacteristic
from afmcalc.equations import drive as law
from afmcalc.equations import heat, overload, sleeve
from afmcalc.spec.models import DiscStack

CLOSE = 1e-3


def test_v1_tool_blocked_motor_side_runs_down():
    """The shaft is already twisted to the sliding torque, so that only J_1 moves."""
    drive = case(300.0, time=0.0)
    found = run(drive, 60.0, full=False, slip=15.0, driven=0.0, elastic=300.0)
    time = 8 * 15 / (300 - 150)
    assert (found.slip_time, found.heat) == pytest.approx((time, 0.5 * 8 * 15**2 * 300 / 150), rel=CLOSE)
    assert (heat.run_down_time(8, 15, 300, 150), heat.slip_energy(300, 15, 0, time)) == (time, pytest.approx(1800.0))


def test_v2_sudden_lock_of_an_endless_motor():
    """The peak is T_c + ω_0 √(k J_2) for an ordinary clutch and for the best one alike."""
    found = run(case(300.0, motor_inertia=1e12, time=0.0, load=300.0, engine=Engine(300.0, None, 0.0)), 0.1)
    assert found.peak == pytest.approx(300 + 15 * math.sqrt(8000 * 0.05), rel=CLOSE)
    assert not found.stuck


def test_the_hub_of_an_indirect_clutch_is_stopped_with_the_driven_half():
    """The hub adds its inertia to the peak: ω_0 √(k (J_2 + J_h))."""
    assert replace(TRAIN, hub_inertia=0.05).inertia_torque == pytest.approx(15 * math.sqrt(8000 * 0.1))


def test_v3_sudden_lock():
    """Stuck until T_1, where the clutch carries T_c; then the driven half swings about T_c."""
    J1, J2, k, M, Tc, w0 = 0.4, 0.05, 8000.0, 150.0, 300.0, 5.0
    T1 = M + (Tc - M) * (J1 + J2) / J1
    w1 = math.sqrt(w0**2 - (T1 - M) ** 2 / (k * (J1 + J2)))
    found = run(case(Tc, motor_inertia=J1, time=0.0, speed=w0), 0.2)
    assert found.peak == pytest.approx(Tc + math.sqrt((T1 - Tc) ** 2 + k * J2 * w1**2), rel=CLOSE)
    assert found.trip_torque == pytest.approx(Tc, rel=CLOSE)


STOPS = [(8000.0, 0.05, 0.02), (8000.0, 0.05, 0.031), (3e4, 0.02, 0.01), (2e4, 0.2, 0.05)]


@pytest.mark.parametrize(("stiffness", "inertia", "stop"), STOPS)
def test_v4_stop_of_an_endless_motor(stiffness, inertia, stop):
    """The tool decelerates with a; slip at t_1, then a driven oscillation about T_c, then a free one."""
    T0, Tc, w0 = 150.0, 300.0, 15.0
    a, wn = w0 / stop, math.sqrt(stiffness / inertia)
    t1 = math.sqrt(2 * (Tc - T0) / (stiffness * a))
    left = stop - t1

    def q(tau: float) -> float:
        return inertia * a * (1 - math.cos(wn * tau)) + stiffness * a * t1 / wn * math.sin(wn * tau)

    def q_dot(tau: float) -> float:
        return inertia * a * wn * math.sin(wn * tau) + stiffness * a * t1 * math.cos(wn * tau)

    # inside the stop the swing about J_2 a has its top where q' = 0; after it the amplitude is that of q and q'
    top = (math.pi - math.atan2(stiffness * t1, inertia * wn)) / wn
    after = math.hypot(q(left), q_dot(left) / wn)
    expected = Tc + max(after, q(top) if top <= left else 0.0)
    found = run(case(Tc, motor_inertia=1e12, stiffness=stiffness, driven_inertia=inertia, time=stop), 0.1)
    assert found.peak == pytest.approx(expected, rel=CLOSE)


def test_v5_two_free_inertias():
    """Behind a shaft as soft as air the driven half meets a constant load: two inertias come to one speed."""
    J1, J2, M, L, T, w0 = 0.4, 0.3, 20.0, 80.0, 300.0, 15.0
    soft = case(T, motor_inertia=J1, driven_inertia=J2, stiffness=1e-6, load=L, engine=Engine(M, None, 0.0), time=0.0)
    found = run(soft, 10.0, finer=1e5, full=False, slip=w0, driven=0.0, elastic=L)
    reduced, free = J1 * J2 / (J1 + J2), (J2 * M + J1 * L) / (J1 + J2)
    assert law.sticking_torque(M, J1, L, J2) == pytest.approx(free)
    assert found.slip_time == pytest.approx(reduced * w0 / (T - free), rel=CLOSE)
    assert found.heat == pytest.approx(0.5 * reduced * w0**2 * T / (T - free), rel=CLOSE)


TABLE = {
    "conventional": ((200, 415), (601, 952), (1602, 2078)),
    "differentiated": ((200, 397), (310, 556), (375, 636)),
    "all-driving": ((200, 402), (360, 629), (480, 764)),
}
"""Sliding and peak torque of the reference drive at f 0.1, 0.3, 0.8 (theory-drive.md, section 9)."""


@pytest.mark.parametrize("variant", TABLE)
def test_reference_drive(variant):
    own = clutch(**merged(VARIANTS[variant], {"drive": {"event": {"duration": 0.05}}}))
    for friction, (sliding, peak) in zip((0.1, 0.3, 0.8), TABLE[variant], strict=True):
        found = outcome_of(own, friction)
        assert (found.case.pack.sliding, found.event.peak) == pytest.approx((sliding, peak), rel=5e-3)
        assert found.event.residual < 1e-6
        # the clutch trips at its static friction, and never carries more
        assert found.event.peak_clutch == pytest.approx(own.at(friction=1.2 * friction).torque, rel=2e-3)


def test_the_ordinary_clutch_is_the_conventional_variant():
    """The peak of an ordinary clutch, shown with every result, is that of the conventional variant."""
    for friction in (0.1, 0.8):
        beside = outcome_of(light(), friction).ordinary_peak
        assert beside == pytest.approx(outcome_of(light(**VARIANTS["conventional"]), friction).event.peak, rel=1e-9)


def test_events_simulated_together_are_those_of_each_alone():
    """Clutches of three variants at once, with their courses, and ordinary clutches in their place."""
    own = [light(**VARIANTS[name], drive={"cut_off": 0.01 + 0.0013 * number}) for number, name in enumerate(VARIANTS)]
    simulate_clutches(own)
    for each in own:
        assert cases.kept(case_of(each, 0.8), True, False), "it was simulated with the others"
        found = outcome_of(each, 0.8)
        alone = simulate(*found.case)
        figures, own_figures = (one._replace(rows=()) for one in (found.event, alone))
        assert figures[:-6] == pytest.approx(own_figures[:-6], rel=1e-6, abs=1e-9)
        np.testing.assert_allclose(found.event.rows, alone.rows, rtol=1e-6, atol=1e-6)
        assert found.ordinary_peak == pytest.approx(simulate(*found.ordinary, whole=False).peak, rel=1e-9)


def test_slow_slip_takes_static_friction_back():
    """A heavy motor side swings hundreds of times while static friction comes back: quadrature of J_1 dω/(T − M)."""
    own = clutch(
        drive={"damping_ratio": 3.0, "driven_inertia": 0.005, "motor_inertia": 15.0, "event": {"stop_time": 2e-3}}
    )
    found = outcome_of(own, 0.3).event
    assert found.settled
    speeds = np.linspace(0, 15, 200_001)[1:]
    torque = own.at(friction=0.3 * (1 + 0.2 * np.exp(-0.1 * speeds / 0.3))).torque
    # but for the stop of the tool
    assert found.slip_time == pytest.approx(trapezoid(15 / (torque - 150), speeds), rel=1e-3)
    assert found.heat == pytest.approx(trapezoid(15 * speeds * torque / (torque - 150), speeds), rel=5e-3)


def test_kloss_motor_against_its_own_equation_of_motion():
    """Against a blocked tool the motor alone moves: time by quadrature of J_1 dω/(T − M_1(ω))."""
    engine = Engine(250.0, 0.2, 16.0)
    # damped, as a stalled motor pulls harder the faster it turns, and would excite the shaft
    drive = case(300.0, engine=engine, time=0.0, damping=6.0)
    found = run(drive, 60.0, full=False, slip=15.0, driven=0.0, elastic=300.0)
    speeds = np.linspace(0, 15, 200_001)
    slip = 1 - speeds / 16
    motor = 2 * 250 / (slip / 0.2 + 0.2 / slip)
    time = trapezoid(8 / (300 - motor), speeds)
    assert found.slip_time == pytest.approx(time, rel=CLOSE)
    assert found.heat == pytest.approx(trapezoid(300 * speeds * 8 / (300 - motor), speeds), rel=CLOSE)


def test_load_event_stops_the_tool_and_holds_it():
    """A load beyond the clutch brings the tool to rest; it resists, it does not drive backwards."""
    drive = case(300.0, kind="load", tool_inertia=2.0, overload=500.0, time=0.01)
    found = run(drive, 1.0)
    assert found.stuck
    assert min(row.speed_tool for row in found.rows) > -1e-9
    assert (found.rows[-1].speed_tool, found.rows[-1].torque_shaft) == (0, pytest.approx(150, abs=160))


def test_a_slow_stop_is_stepped_no_longer_than_its_swings_last():
    """The drive slows down with the tool: two swings of the shaft, M ± 2 J a, in the end those about rest."""
    own = case(300.0, time=100.0)
    event = own.run()
    assert event.peak == pytest.approx(150.0 + 2 * own.train.front * own.train.speed / 100.0, rel=1e-3)
    assert event.settled
    assert event.time > 100.0
    assert len(event.rows) < 5000


@pytest.mark.slow
def test_a_motor_past_its_breakdown_feeds_swings_which_no_long_step_may_make_or_hide():
    motor = Engine(300.0, 0.2, 15.5)
    event = case(400.0, time=20.0, load=float(motor.at(15.0)), engine=motor).run()
    assert event.peak == pytest.approx(300.0 + TRAIN.front * 15.0 / 20.0, rel=1e-4)
    assert event.slip_time == 0


@pytest.mark.slow
def test_a_motor_that_is_slowed_pulls_harder():
    """Tool, drive and Kloss motor slow down as one, long after the first swing, until the motor carries the load."""
    engine = Engine(270.0, 0.16, 7.43)
    drive = case(2000.0, kind="load", tool_inertia=10.0, motor_inertia=0.34, driven_inertia=0.01, stiffness=5e4,
                  damping=4.0, speed=7.118, load=132.67, engine=engine, time=0.02, overload=250.0)  # fmt: skip
    assert run(drive, float(peak_time(drive.train, drive.pack.sliding))).peak == pytest.approx(250.0, rel=2e-3)


def test_lock_of_a_damped_shaft_jumps():
    """A tool that stops at once puts d ω_0 on the shaft in no time."""
    drive = case(1000.0, damping=2.0, time=0.0)
    assert run(drive, 0.001).peak >= 150 + 2 * 15
    assert run(drive._replace(train=replace(drive.train, damping=40.0)), 0.3).peak_clutch <= 1000 * (1 + 1e-9)


def trip_torque(lag: float, rate: float, friction: float = 0.3) -> float:
    """All-driving pack under a load that rises evenly from 150 N·m (tool locked, motor endless, no swing)."""
    pack = {"closing_force": 3750.0, "bypass_pairs": 0.0, "controlled_pairs": 8.0, "gain": 0.625, "driving": friction, "driven": friction, "lag": lag}  # fmt: skip
    drive = case(1.0, pack=pack, motor_inertia=1e15, time=0.0, stiffness=8000.0, speed=rate / 8000, engine=Engine(150.0, None, 0.0))  # fmt: skip
    return run(drive, 2000.0 / rate, finer=8).trip_torque


@pytest.mark.parametrize(("lag", "rate"), [(5e-3, 1e5), (2e-3, 5e4), *slow((5e-3, 1e4), (0.05, 3e4))])
def test_even_rise_against_the_solved_equation(lag, rate):
    """N = F − (C/R)[T_0 + s t − s τ (1 − e^(−t/τ))]; slip where T_0 + s t = z f R N."""

    def beyond(t: float) -> float:
        normal = 3750 - 6.25 * (150 + rate * t - rate * lag * (1 - math.exp(-t / lag)))
        return 150 + rate * t - 8 * 0.3 * 0.1 * normal

    expected = 150 + rate * brentq(beyond, 0, 1, xtol=1e-15)
    assert trip_torque(lag, rate) == pytest.approx(expected, rel=CLOSE)


@pytest.mark.slow
def test_limits_of_the_lag():
    """s τ → 0 gives T_муф, s τ → ∞ T_п of S22 (5)."""
    own = clutch(**VARIANTS["all-driving"], friction={"static_ratio": None, "stribeck_speed": None})
    expected = own.at(friction=0.3).torque
    at_min = overload.loop_gain(8, 0.625, 0.1)
    potential = overload.potential_torque(8, own.closing_force, 0.1, 0.3, 4 / 3, at_min)
    assert trip_torque(1e-8, 1e4) == pytest.approx(expected, rel=CLOSE)
    assert trip_torque(1e4, 1e5) == pytest.approx(potential, rel=CLOSE)
    assert expected < trip_torque(1e-3, 1e5) < potential


SHORT = {"event": {"duration": 0.05}}


def test_where_the_drive_trips_is_a_number():
    found = outcome_of(light(control_unit={"release_lag": 0.005}, drive=SHORT), 0.8)
    expected = light().at(friction=1.2 * 0.8).torque
    assert found.potential is not None
    assert found.trip_position == pytest.approx((found.event.trip_torque - expected) / (found.potential - expected))
    assert 0 < found.trip_position < 1
    assert outcome_of(light(drive=SHORT), 0.8).trip_position == pytest.approx(0, abs=1e-3)
    slow = light(control_unit={"release_lag": 100.0}, drive={"motor_inertia": 0.8, **SHORT})
    assert outcome_of(slow, 0.3).trip_position == pytest.approx(1, abs=2e-3)


FREE = {"time": 0.0, "stiffness": 1e-6, "load": 0.0, "engine": Engine(0.0, None, 0.0)}
"""Behind a shaft as soft as air, without motor."""


@pytest.mark.slow
@pytest.mark.parametrize("rate", [10.0, 2.0])
def test_v7_one_swing_of_the_control_unit(rate):
    """The hub, immovable, is turned against the driven half: out to where κ has taken the speed, back with κ₊."""
    drive = indirect(0.3, motor_inertia=1e12, **FREE)
    kinetic = 0.5 * drive.train.driven_inertia * rate**2
    top = run(drive, 0.2, finer=2e5 if rate < 5 else 6e4, driven=-rate, rate=rate, turn=1e-12, elastic=0.0)
    work = (3300.0 - 2500.0) * top.travel_max + (2e4 + 1e4) * top.travel_max**2 / 2
    assert 1.0 / 0.4 * work == pytest.approx(kinetic, rel=1e-2), "the work of the way out"
    # back at the stop the way out and back has left the share κ/κ₊ of the energy
    moving = [row.travel > top.travel_max / 2 for row in top.rows]
    back = next(
        n
        for n in range(moving.index(True), len(moving))
        if top.rows[n + 1].travel > top.rows[n].travel < top.travel_max / 50
    )
    lost = kinetic - 0.5 * drive.train.driven_inertia * top.rows[back].speed_driven ** 2
    assert lost == pytest.approx((1.0 / 0.4 - 1.0 / 1.6) * work, rel=1e-2)
    assert lost / kinetic == pytest.approx(1 - 0.4 / 1.6, rel=1e-2)
    assert top.key_heat == pytest.approx(kinetic, rel=1e-2), "all of it in the end"


SLOW = {"stiffness": 2000.0, "driven_inertia": 2000.0, "motor_inertia": 1e12, "damping": 2000.0, "speed": 16e-3,
        "time": 150.0}  # fmt: skip
"""A tool that slows down so slowly that inertia plays no part."""
LASTING = {"motor_inertia": 1e12, "driven_inertia": 1e9, "speed": 5.0, "time": 0.0, "load": 150.0}


@pytest.mark.slow
def test_quasi_static_loading_trips_at_the_torque_of_the_law():
    drive = indirect(0.1, **SLOW)
    F1, F2, c1, c2, zf, R, kappa = 2500.0, 3300.0, 2e4, 1e4, 8 * 0.1, 0.1, 0.4
    expected = zf * R * (F1 * c2 + F2 * c1) / (c1 + c2 + zf * c1 * kappa)
    assert (drive.pack.sliding, run(drive, 150.0).trip_torque) == pytest.approx((expected, expected), rel=1e-3)


@pytest.mark.parametrize("slope", [0.0, 15.0])
@pytest.mark.parametrize("friction", [0.6, 0.16, 0.05])
def test_returning_it_slides_at_the_torque_of_the_law(friction, slope):
    """With slightly less friction under a lasting load the key holds the sleeve, or it returns a little, by the law."""
    drive = indirect(friction, law={"gain_slope": slope}, **LASTING)
    own, before = drive.pack.law, friction * (1 + 2e-7)
    expected, torque = (own.at(friction=each, friction_max=0.8)["torque_returning"] for each in (friction, before))
    travel = (2500 - torque / (0.8 * before)) / 2e4
    turn = sleeve.turn(travel, 0.1, 1.0, slope)
    found = run(drive, 0.2, finer=1e5, slip=5.0, driven=0.0, elastic=torque, turn=turn, normal=2500.0)
    assert found.last == pytest.approx(expected, rel=1e-5)


@pytest.mark.slow
def test_the_stop_carries_what_the_springs_do_not():
    """At the stop N = F_п2 − κ T/R while the load rises: below T_н a direct clutch of gain κ (theory, section 5)."""
    drive = indirect(0.05, time=0.0, motor_inertia=1e12, load=50.0)
    assert drive.pack.sliding == pytest.approx(8 * 0.05 * 0.1 * 3300 / (1 + 8 * 0.05 * 0.4))
    found = run(indirect(0.05, **SLOW, load=20.0), 150.0)  # fmt: skip
    assert found.trip_torque == pytest.approx(drive.pack.sliding, rel=1e-3)
    assert found.travel_max == 0


CURVED = {"gain_slope": 3e4 / (8 * 0.1 * 2500)}
"""C_1* of a wall that holds the torque (theory, section 12)."""


@pytest.mark.slow
def test_a_wall_that_holds_the_torque():
    """Whatever the friction, quasi-static loading trips at T_н: the control unit is a spring without stiffness."""
    drive = indirect(0.5, law=CURVED, **SLOW | {"speed": 32e-3})  # fmt: skip
    assert drive.pack.sliding == pytest.approx(200.0, rel=1e-12)
    found = run(drive, 150.0)
    assert found.trip_torque == pytest.approx(200.0, rel=1e-3)
    # off its stop the sleeve is driven on by what the torque has over T_н, until the pack slips
    assert found.travel_max >= 2500 / 2e4 * (1 - 0.1 / 0.5) * (1 - 1e-3)


def test_a_swing_against_a_curved_wall():
    """Energy: T κ(x)/R = F + m x'' on the way, so that dE = (C/κ)(dW + m x'' dx) with gains of the place."""
    drive = indirect(0.3, law=CURVED | {"key_friction": 0.0}, mass=2.0, motor_inertia=1e12, **FREE)
    found = run(drive, 0.2, finer=2e5, driven=-5.0, rate=5.0, turn=1e-12, elastic=0.0)
    kinetic = 0.5 * 0.05 * 25 + 0.5 * 2.0 * sleeve.travel_rate(5.0, 0.1, 1.0) ** 2
    own = drive.pack
    assert own.work(found.travel_max) == pytest.approx(kinetic, rel=1e-2)
    assert max(row.travel for row in found.rows[len(found.rows) // 2 :]) == pytest.approx(found.travel_max, rel=1e-2)
    assert abs(found.key_heat) < 1e-2 * kinetic


DISC = DiscCharacteristic(
    DiscStack(outer_diameter=0.04, inner_diameter=0.0204, thickness=1.5e-3, free_height=2.65e-3, parallel=2, series=20)
)
"""Discs B 40 of DIN EN 16983."""


@pytest.mark.slow
def test_disc_springs():
    """Loaded slowly or returning, the clutch carries the torque of the law; without key friction no energy is lost."""
    own = {"closing_disc": DISC, "control_disc": DISC}
    drive = indirect(0.3, law=own, **SLOW | {"speed": 32e-3})
    assert drive.pack.sliding != pytest.approx(indirect(0.3).pack.sliding, rel=1e-3)
    assert run(drive, 150.0).trip_torque == pytest.approx(drive.pack.sliding, rel=1e-3)

    drive = indirect(0.1, law=own, **LASTING)
    before = 0.1 * (1 + 2e-7)
    expected, torque = (
        drive.pack.law.at(friction=each, friction_max=0.8)["torque_returning"] for each in (0.1, before)
    )
    turn = (DISC.deflection(2500.0) - DISC.deflection(torque / (0.8 * before))) / 0.1
    found = run(drive, 0.2, finer=1e5, slip=5.0, driven=0.0, elastic=torque, turn=turn, normal=2500.0)
    assert found.last == pytest.approx(expected, rel=1e-5)

    drive = indirect(0.3, law=own, load=230.0)
    assert run(drive, 0.1).peak == pytest.approx(run(drive, 0.1, finer=4).peak, rel=5e-4)
    assert drive.pack.torque(1.0) > 230 > drive.pack.lift, "it began off its stop"
