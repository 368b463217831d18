"""Events simulated until nothing more can come: figures of independent programs; a sleeve that hammers on its stop."""

import numpy as np
import pytest
from drives import indirect, merged
from scipy.integrate import solve_ivp

from afmcalc.analysis.simulate import simulate
from afmcalc.drive.cases import case_of, outcome_of
from afmcalc.drive.integrator import simulate as simulate_event
from afmcalc.engines import build
from afmcalc.spec.read import read_spec

HEAVY = {
    "variant": "conventional",
    "friction": {"min": 0.1, "max": 0.3},
    "friction_group": {"pairs": 8, "mean_radius": 0.1},
    "closing_spring": {"force": 2000},
    "drive": {
        "load_torque": 80, "motor": {"breakdown_torque": 600, "breakdown_slip": 0.2, "synchronous_speed": 15.7},
        "cut_off": 2, "motor_inertia": 0.5, "driven_inertia": 0.05, "shaft_stiffness": 8000, "damping_ratio": 0.03,
        "tool_inertia": 20, "event": {"kind": "load", "torque": 800, "rise_time": 0.02},
    },
}  # fmt: skip
"""A heavy tool slows a Kloss motor, whose torque rises until the clutch trips a second after the load."""


def stepped(friction: float, end: float, step: float = 2e-5) -> tuple[float, float, float]:
    """Peak, slip and heat of HEAVY by semi-implicit Euler steps: stick where the pack can hold both halves."""
    own = HEAVY["drive"]
    J1, J2, J3, k = own["motor_inertia"], own["driven_inertia"], own["tool_inertia"], own["shaft_stiffness"]
    d, T0 = 2 * own["damping_ratio"] * (k * J2) ** 0.5, own["load_torque"]
    Mb, sb, ws = own["motor"].values()
    ratio = Mb / T0
    w1 = w2 = w3 = ws * (1 - sb * (ratio - (ratio**2 - 1) ** 0.5))
    twist, most, off, slip, heat, peak = T0 / k, 8 * 2000 * 0.1 * friction, None, 0.0, 0.0, 0.0
    for number in range(round(end / step)):
        t = number * step
        load = T0 + (own["event"]["torque"] - T0) * min(t / own["event"]["rise_time"], 1)
        s = 1 - w1 / ws
        motor = 0.0 if off is not None and t >= off else 2 * Mb * s * sb / (s * s + sb * sb)
        shaft = k * twist + d * (w2 - w3)
        holds = ((w1 - w2) / step + motor / J1 + shaft / J2) / (1 / J1 + 1 / J2)
        clutch = max(-most, min(most, holds))
        a, b = w1 + step * (motor - clutch) / J1, w2 + step * (clutch - shaft) / J2
        if abs(holds) > most:
            heat, slip = heat + clutch * (w1 - w2 + a - b) / 2 * step, slip + step
            off = t + own["cut_off"] if off is None else off
        w1, w2 = a, b
        free = w3 + step * shaft / J3
        w3 = max(free - step * load / J3, 0.0) if free > 0 else min(free + step * load / J3, 0.0)
        twist, peak = twist + step * (w2 - w3), max(peak, abs(shaft))
    return peak, slip, heat


@pytest.mark.slow
def test_a_heavy_tool_trips_the_clutch_late():
    """At f_max nothing slips in the first swing; it was said never to slip, with a dynamic factor below 1."""
    result, found = simulate(build(HEAVY))
    told = (result.peak_torque.max, result.slip_time.max, result.slip_energy.max)
    assert told == pytest.approx((494.98, 2.01472, 10_887.9), rel=1e-3)
    assert told == pytest.approx(stepped(0.3, 2.3), rel=2e-3)
    assert min(vars(result.dynamic_factor).values()) > 1
    assert result.peak_torque_conventional.max == pytest.approx(result.peak_torque.max), "it is an ordinary clutch"
    assert result.largest_dynamic_factor > 1
    assert "motor-stops-at-cut-off" in {each.code for each in found}


def test_a_duration_is_run_out():
    """With its history to the end; and where something may still come, it is said."""
    own = build(merged(HEAVY, {"drive": {"event": {"duration": 0.05}}}))
    result, found = simulate(own)
    assert result.slip_time.max == 0
    told = [(each.level, each.value) for each in found if each.code == "event-not-settled"]
    assert told == [("warning", pytest.approx(0.05))] * 2
    event = case_of(own, 0.3).history()
    assert event.rows[-1].time == pytest.approx(0.05)
    assert case_of(own, np.array([0.3])).peaks().peak[0] == pytest.approx(event.peak, rel=1e-9), "of a sweep"
    quick = merged(HEAVY, {"drive": {"event": {"kind": "stop", "stop_time": 0.01, "torque": None, "rise_time": None}}})
    quick = merged(quick, {"drive": {"tool_inertia": None, "cut_off": 0.05, "event": {"duration": 0.1}}})
    assert case_of(build(quick), 0.3).history().rows[-1].time == pytest.approx(0.1)
    assert "event-not-settled" not in {each.code for each in simulate(build(quick))[1]}


@pytest.mark.slow
def test_a_stalled_motor_slips_again_until_its_cut_off():
    """A Kloss motor at standstill pulls the harder the faster it turns: it swings a shaft that hardly damps."""
    own = merged(HEAVY, {"closing_spring": {"force": 1500}, "drive": {"damping_ratio": 0.0, "cut_off": 1.0}})
    own = merged(own, {"drive": {"motor": {"breakdown_torque": 340.0}, "tool_inertia": 0.5}})
    found = outcome_of(build(own), 0.3).event
    assert any(row.slip and row.time > 0.5 for row in found.rows), "long after the first slip has ended"
    assert found.settled
    assert found.time > 1.0, "the cut-off"
    never = merged(own, {"drive": {"cut_off": None}})
    assert simulate(build(never))[0].slip_time.max is None


@pytest.mark.slow
def test_the_comparison_covers_the_same_time():
    """An ordinary clutch in the place of one that trips at once is simulated until it trips."""
    own = merged(HEAVY, {"variant": "differentiated", "control_unit": {"gain": 1.0}, "closing_spring": None})
    own["adjustment"] = {"nominal_torque": 160}
    found = outcome_of(build(own), 0.3)
    assert found.event.peak < 300
    assert found.ordinary_peak == pytest.approx(outcome_of(build(HEAVY), 0.3).event.peak, rel=1e-6)


STICKS = {
    "variant": "differentiated",
    "friction": {"min": 0.070027, "mean": 0.094746, "max": 0.76154},
    "friction_group": {"pairs": 3, "mean_radius": 0.053995, "driving_pairs": 2},
    "closing_spring": {"force": 1442.8},
    "adjustment": {"method": "mean-friction", "margin": 1.5038},
    "control_unit": {"gain": 0.81249},
    "drive": {
        "motor_inertia": 0.03331, "driven_inertia": 0.00012986, "shaft_stiffness": 71.607, "damping_ratio": 0.088861,
        "load_torque": 10.973, "speed": 86.764, "motor_torque": 10.973,
        "event": {"kind": "stop", "stop_time": 0.0, "duration": 0.37813},
    },
}  # fmt: skip


def test_slips_are_summed():
    """Of two slips with a stick of 0.2 ms between them; the figures are the independent check's."""
    result, _ = simulate(build(STICKS))
    assert result.slip_time.max == pytest.approx(0.0155011, rel=1e-2)
    assert result.slip_energy.max == pytest.approx(61.7645, rel=1e-3)
    rows = [row for row in case_of(build(STICKS), STICKS["friction"]["max"]).run().rows if row.slip]
    assert rows[-1].time - rows[0].time > 1.01 * result.slip_time.max, "from the first slip to the last it is longer"


def test_balls_that_swing_on_are_left_once_nothing_can_come_of_them():
    """The rest that is left out of an event changes nothing: run on, it gives the same peak, slip and heat."""
    own = indirect(0.4, law={"key_friction": 0.1}, motor_inertia=0.4, damping=1.0)
    found = own.run()
    assert found.settled
    on = simulate_event(own.train, own.pack, found.time + 0.1, full=True)
    assert on.time == pytest.approx(found.time + 0.1)
    assert (on.peak, on.slip_time, on.heat) == pytest.approx((found.peak, found.slip_time, found.heat), rel=1e-2)


DRIVE = {
    "speed": 30, "motor_inertia": 1.5, "driven_inertia": 0.01, "hub_inertia": 0.004, "shaft_stiffness": 4000,
    "damping_ratio": 0.03, "event.kind": "stop", "event.stop_time": 0.01,
}  # fmt: skip


def hammering(**more: object):
    """example:indirect in that drive."""
    given = {**{f"drive.{key}": value for key, value in DRIVE.items()}, **more}
    return build(read_spec("example:indirect", [f"{key}={value}" for key, value in given.items()]))


def referee(clutch, f, end, *, seat=2e-7, slow=2e-3, late=3e-5):
    """Peaks of shaft and clutch, heat: theory-drive 9, steep laws: turn ``seat``, viscous slip ``slow``, play ``late``."""
    spec, drive = clutch.spec, clutch.spec.drive
    z, R, C = spec.friction_group.pairs, clutch.mean_radius, spec.control_unit.gain
    key = 2 * R * spec.control_unit.key_friction / spec.control_unit.hub_diameter
    c1, c2, F1 = spec.closing_spring.stiffness, spec.control_spring.stiffness, clutch.closing_force
    F2 = F1 * (1 + z * spec.friction.mean * (C - key))  # S21 (14), set at the mean friction
    J1, Jh, J2, k = drive.motor_inertia, drive.hub_inertia, drive.driven_inertia, drive.shaft_stiffness
    d, w0, tb, T0 = 2 * drive.damping_ratio * (k * J2) ** 0.5, drive.speed, drive.event.stop_time, clutch.machine_torque

    def torques(t, y):
        w1, wh, w2, twist, phi, held = y[:6]
        x = max(abs(phi) - seat, 0.0) * R / C
        outwards = np.tanh((wh - w2) * np.sign(phi) / slow)
        wall = R * (F2 - F1 + (c1 + c2) * x) * ((1 + outwards) / (C - key) + (1 - outwards) / (C + key)) / 2
        balls = np.clip(phi / seat, -1, 1) * wall
        low, high = (F2 - net * abs(balls) / R for net in (C + key, C - key))
        off = abs(phi) > seat
        normal, balance = (F1 - c1 * x, F1) if off else (held, min(max(held, low), high))
        tool = w0 * max(1 - t / tb, 0.0)
        pack = z * f * R * normal * np.tanh((w1 - wh) / slow)
        return pack, balls, k * twist + d * (w2 - tool), tool, (balance - held) / late

    def rates(t, y):
        pack, balls, shaft, tool, rising = torques(t, y)
        turning = (T0 - pack) / J1, (pack - balls) / Jh, (balls - shaft) / J2
        return [*turning, y[2] - tool, y[1] - y[2], rising, pack * (y[0] - y[1])]

    y, rows = [w0, w0, w0, T0 / k, seat * T0 * (C - key) / (R * (F2 - F1)), F2 - (C - key) * T0 / R, 0.0], []
    for first, last in ((0.0, tb), (tb, end)):
        part = solve_ivp(rates, (first, last), y, "LSODA", rtol=1e-7, atol=[1e-7, 1e-7, 1e-7, 1e-10, 1e-12, 1e-4, 1e-5])
        rows += [[abs(value) for value in torques(*at)[:3]] for at in zip(part.t, part.y.T, strict=True)]
        y = part.y[:, -1]
    clutches, _, shafts = np.array(rows).T
    return shafts.max(), clutches.max(), y[6]


@pytest.mark.parametrize("f", [0.15, pytest.param(0.2, marks=pytest.mark.slow)])
def test_events_meet_the_referee(f):
    own, end = hammering(), 0.03
    case = case_of(own, f)
    found = simulate_event(case.train, case.pack, end, full=True)
    peak, peak_clutch, heat = referee(own, f, end)
    assert (found.peak, found.peak_clutch) == (pytest.approx(peak, rel=3e-3), pytest.approx(peak_clutch, rel=5e-3))
    assert found.heat == pytest.approx(heat, rel=5e-3)


@pytest.mark.slow
def test_the_key_loses_what_the_turns_of_the_sleeve_tell():
    """dE = (C/κ − 1) dW on the way out, (1 − C/κ₊) dW back, W = (F_п2 − F_п1) x + ½ (c_1 + c_2) x², F_п2 = F_п1 (1 + 2.4 κ)."""
    gain, kappa, kappa_back = 2.0, 1.4, 2.6
    own = hammering(**{"control_unit.key_friction": 0.15, "control_unit.gain": gain})
    assert outcome_of(own, 0.1).key_energy == 0, "at f_min the sleeve stays at its stop"
    for friction in (0.3, 0.8):
        event = case_of(own, friction).run()
        slips = [row.time for row in event.rows if row.slip]
        travel = np.array([row.travel for row in event.rows if row.time <= slips[-1]])
        work = np.diff(2000 * 2.4 * kappa * travel + 6e5 * travel**2 / 2)
        lost = np.where(work > 0, (gain / kappa - 1) * work, (1 - gain / kappa_back) * -work)
        assert event.key_heat == pytest.approx(lost.sum(), rel=1e-2)


@pytest.mark.slow
def test_slow_slip_is_as_long_as_it_is():
    """example:drive at f_min, in quadruple precision (RK4): it ends in judder, which grows from the rest of the event."""
    own = build(read_spec("example:drive"))
    found = case_of(own, own.spec.friction.groups[0].min).run()
    assert found.slip_time == pytest.approx(1.87255, rel=5e-3)
    assert found.heat == pytest.approx(3356.19, rel=1e-3)
    assert found.residual < 1e-6
