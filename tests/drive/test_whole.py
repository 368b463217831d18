"""An event is simulated until nothing more can come: by located switches and in steps, with an ordinary clutch too.

The figures are those of two programs that share no code with this one: an independent check (solve_ivp, DOP853, 1e-10),
and the fixed steps below.
"""

import numpy as np
import pytest
from drives import indirect, merged

from afmcalc.analysis.simulate import simulate, with_dynamic_factor
from afmcalc.drive.cases import case_of, outcome_of
from afmcalc.drive.peaks import peaks_of
from afmcalc.drive.trip import trip
from afmcalc.engines import build

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
    assert result.peak_torque.max == pytest.approx(494.98, rel=1e-4)
    assert result.slip_time.max == pytest.approx(2.01472, rel=1e-4)
    assert result.slip_energy.max == pytest.approx(10_887.9, rel=1e-4)
    assert min(vars(result.dynamic_factor).values()) > 1
    assert result.peak_torque_conventional.max == pytest.approx(result.peak_torque.max), "it is an ordinary clutch"
    assert with_dynamic_factor(build(HEAVY).spec, result)["drive"]["dynamic_factor"] > 1
    assert "motor-stops-at-cut-off" in {each.code for each in found}


@pytest.mark.slow
def test_a_heavy_tool_in_steps():
    found = case_of(build(HEAVY), 0.3).run()
    assert stepped(0.3, 2.3) == pytest.approx((found.peak, found.slip_time, found.heat), rel=2e-3)


def test_sweeps_end_with_the_duration():
    cut = build(merged(HEAVY, {"drive": {"event": {"duration": 0.05}}}))
    stepped = peaks_of(cut, np.array([0.3]), np.array([0.3])).shaft[0]
    assert stepped == pytest.approx(case_of(cut, 0.3).run().peak, rel=5e-4)
    assert stepped < 490


def test_a_duration_is_run_out():
    """With its history to the end; and where something may still come, it is said."""
    own = build(merged(HEAVY, {"drive": {"event": {"duration": 0.05}}}))
    result, found = simulate(own)
    assert result.slip_time.max == 0
    told = [each for each in found if each.code == "event-not-settled"]
    assert [(each.level, each.value) for each in told] == [("warning", 0.05)] * 2
    assert case_of(own, 0.3).run(recorded=True).history[-1].time == 0.05
    quick = merged(HEAVY, {"drive": {"event": {"kind": "stop", "stop_time": 0.01, "torque": None, "rise_time": None}}})
    quick = merged(quick, {"drive": {"tool_inertia": None, "cut_off": 0.1, "event": {"duration": 0.5}}})
    assert case_of(build(quick), 0.3).run(recorded=True).history[-1].time == 0.5
    assert "event-not-settled" not in {each.code for each in simulate(build(quick))[1]}


@pytest.mark.slow
def test_a_stalled_motor_slips_again_until_its_cut_off():
    """A Kloss motor at standstill pulls the harder the faster it turns: it swings a shaft that hardly damps."""
    own = merged(HEAVY, {"closing_spring": {"force": 1500}, "drive": {"damping_ratio": 0.0, "cut_off": 1.0}})
    own = merged(own, {"drive": {"motor": {"breakdown_torque": 340.0}, "tool_inertia": 0.5}})
    found = outcome_of(build(own), 0.3)
    slips = [row for row in found.trip.course if row.time > 0.5]
    assert slips, "long after the first slip has ended"
    assert found.trip.settled
    assert found.trip.time > 1.0, "the cut-off"
    never = merged(own, {"drive": {"cut_off": None}})
    assert simulate(build(never))[0].slip_time.max is None


@pytest.mark.slow
def test_the_comparison_covers_the_same_time():
    """An ordinary clutch in the place of one that trips at once is simulated until it trips."""
    own = merged(HEAVY, {"variant": "differentiated", "control_unit": {"gain": 1.0}, "closing_spring": None})
    own["adjustment"] = {"nominal_torque": 160}
    found = outcome_of(build(own), 0.3)
    assert found.trip.peak < 300
    assert found.ordinary_peak == pytest.approx(outcome_of(build(HEAVY), 0.3).trip.peak, rel=1e-6)


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
    assert result.slip_time.max == pytest.approx(0.0155011, rel=2e-5)
    assert result.slip_energy.max == pytest.approx(61.7645, rel=2e-5)
    rows = case_of(build(STICKS), STICKS["friction"]["max"]).run().course
    first, last = rows[0].time, rows[-1].time
    assert last - first > 1.01 * result.slip_time.max, "from the first slip to the last stick it is longer"


def test_balls_that_swing_on_are_left_once_nothing_can_come_of_them():
    """What is left out of an event changes nothing: run on, it gives the same peak, slip and heat."""
    own = indirect(0.4, law={"key_friction": 0.1}, motor_inertia=0.4, damping=1.0)
    found = trip(own, 60.0)
    on = trip(own, found.time + 0.3, recorded=True, given=True)
    assert found.settled
    assert on.history[-1].time == pytest.approx(found.time + 0.3)
    assert (on.peak, on.slip_time, on.heat) == pytest.approx((found.peak, found.slip_time, found.heat), rel=1e-7)
