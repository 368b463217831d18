"""Indirect clutches whose sleeve is at its stop: events against steps, against a referee, and the bracket κ … κ₊.

At the friction of the setting, 0.3, the sleeve of this drive hammers on its stop.
"""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from afmcalc.analysis.simulate import simulate
from afmcalc.drive.cases import bracket_of, case_of, outcome_of
from afmcalc.drive.trip import trip
from afmcalc.engines import build
from afmcalc.spec.read import read_spec

DRIVE = {
    "speed": 30, "motor_inertia": 1.5, "driven_inertia": 0.01, "hub_inertia": 0.004, "shaft_stiffness": 4000,
    "damping_ratio": 0.03, "event.kind": "stop", "event.stop_time": 0.01,
}  # fmt: skip


def hammering(**more: object):
    """example:indirect in that drive."""
    given = {**{f"drive.{key}": value for key, value in DRIVE.items()}, **more}
    return build(read_spec("example:indirect", [f"{key}={value}" for key, value in given.items()]))


def referee(clutch, f, end, *, seat=2e-7, slow=2e-3, late=3e-5):
    """Peaks of shaft and clutch, heat: theory-drive, section 9, every set-valued law a steep one.

    ``seat``: turn within which the balls are at their stop; ``slow``: slip below which friction is viscous; ``late``:
    time in which N comes to the edge of its play.
    """
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
    found = trip(case_of(own, f).plant, end, given=True)
    peak, peak_clutch, heat = referee(own, f, end)
    assert (found.peak, found.peak_clutch) == (pytest.approx(peak, rel=1e-3), pytest.approx(peak_clutch, rel=1e-3))
    assert found.heat == pytest.approx(heat, rel=2e-3)


@pytest.mark.slow
def test_the_bracket_at_the_stop():
    """V1 by hand: T = zf R F_п2/(1 + zf κ), run down against the load's torque; with κ₊ and the play too.

    f_min 0.1: zf = 0.8; F_п2 = 2000 (1 + 2.4 κ), T_н = 240·2 N·m, machine torque T_н/1.75.
    """
    own = hammering(**{"control_unit.key_friction": 0.05})
    kappa, kappa_back, motor = 0.8, 1.2, 480 / 1.75
    rising, falling = (0.8 * 0.1 * 2000 * (1 + 2.4 * kappa) / (1 + 0.8 * net) for net in (kappa, kappa_back))
    play, along, against = bracket_of(outcome_of(own, 0.1))
    assert along.slip_time == pytest.approx(1.5 * 30 / (rising - motor), rel=0.02)
    assert along.energy == pytest.approx(0.5 * 1.5 * 30**2 * rising / (rising - motor), rel=0.02)
    assert max(each.trip.residual for each in (play, along, against)) < 1e-6
    assert falling < motor
    result, findings = simulate(own)
    assert ("stop-bracket", "warning") in {(each.code, each.level) for each in findings}
    low, high = result.slip_energy_low, result.slip_energy_high
    assert (low.min, play.energy, against.energy, high.min) == (pytest.approx(along.energy), None, None, None)
    assert result.peak_torque_low.min <= result.peak_torque.min <= result.peak_torque_high.min
    assert low.max == pytest.approx(high.max), "at f_max the event is off the stop"


@pytest.mark.slow
def test_the_key_loses_what_the_turns_of_the_sleeve_tell():
    """dE = (C/κ − 1) dW on the way out, (1 − C/κ₊) dW back, W = (F_п2 − F_п1) x + ½ (c_1 + c_2) x²: from the travels alone.

    example:indirect: F_п1 2 kN, c_1 400, c_2 200 N/mm, set at f = 0.3: F_п2 = F_п1 (1 + 2.4 κ), 2 R f_1/d = 4 f_1.
    """
    gain, kappa, kappa_back = 2.0, 1.4, 2.6
    own = hammering(**{"control_unit.key_friction": 0.15, "control_unit.gain": gain})
    result, _ = simulate(own)
    assert result.energy_residual < 1e-6
    assert result.key_energy.min == 0, "at f_min the sleeve stays at its stop"
    for friction, told in ((0.3, result.key_energy.mean), (0.8, result.key_energy.max)):
        event = case_of(own, friction).run(recorded=True)
        travel, time = (np.array([getattr(row, name) for row in event.history]) for name in ("travel", "time"))
        work = np.diff(2000 * 2.4 * kappa * travel + 6e5 * travel**2 / 2)
        lost = np.where(work > 0, (gain / kappa - 1) * work, (1 - gain / kappa_back) * -work)
        assert event.key_heat == pytest.approx(lost.sum(), rel=2e-5)
        assert told == pytest.approx(lost[time[1:] <= event.course[-1].time].sum(), rel=1e-4)
        assert 0 < told < event.key_heat, "the drive that sticks swings on"
        assert trip(case_of(own, friction).plant, event.course[-1].time).residual < 1e-6, "it closes at that time too"


def test_slow_slip_is_as_long_as_it_is():
    """example:drive at f_min: 1.87255 s and 3356.19 J by fixed steps (RK4) in quadruple precision; 1.8455 s before.

    The slip ends in judder, whose swings grow from what the event has left of them: double precision gives 1.872.
    """
    own = build(read_spec("example:drive"))
    found = case_of(own, own.friction[0].min).run()
    assert found.slip_time == pytest.approx(1.87255, rel=1e-3)
    assert found.heat == pytest.approx(3356.19, rel=1e-4)
    assert found.residual < 1e-6
