"""Indirect clutches whose sleeve is at its stop: events against steps, against a referee, and the bracket κ … κ₊.

The drive is the issue's: at the friction of the setting, 0.3, the sleeve hammers on its stop.
"""

from dataclasses import replace

import numpy as np
import pytest
from drives import indirect, run
from scipy.integrate import solve_ivp

from afmcalc.analysis.simulate import simulate
from afmcalc.analysis.sweep.axes import parse_axis
from afmcalc.drive.cases import bracket_of, case_of, outcome_of
from afmcalc.drive.lanes import Shaft, SleeveLanes, march
from afmcalc.drive.pack import pack_of
from afmcalc.drive.peaks import peaks_of, step_of
from afmcalc.drive.plant import TURN
from afmcalc.drive.train import train_of
from afmcalc.drive.trip import trip
from afmcalc.engines import build
from afmcalc.spec.read import read_spec

DRIVE = {
    "speed": 30,
    "motor_inertia": 1.5,
    "driven_inertia": 0.01,
    "hub_inertia": 0.004,
    "shaft_stiffness": 4000,
    "damping_ratio": 0.03,
    "event.kind": "stop",
    "event.stop_time": 0.01,
}


def issue(**more: object):
    """example:indirect in the issue's drive."""
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


@pytest.mark.parametrize("f", [0.1, 0.15, 0.2])
def test_events_meet_the_referee(f):
    own, end = issue(), 0.03
    found = trip(case_of(own, f).plant, end, given=True)
    peak, peak_clutch, heat = referee(own, f, end)
    assert (found.peak, found.peak_clutch) == (pytest.approx(peak, rel=1e-3), pytest.approx(peak_clutch, rel=1e-3))
    assert found.heat == pytest.approx(heat, rel=2e-3)


@pytest.mark.every(11)
@pytest.mark.parametrize("f", [0.3, 0.28, 0.285, 0.29, 0.295, 0.305, 0.31, 0.32, 0.5, 0.8, 0.1])
def test_sweeps_take_the_law_of_the_table_at_the_stop(f):
    """In the band f ≈ f_set the sleeve hammers on its stop: 634.68 against 646.29, 670.19 against 498.45 before."""
    own, friction = issue(), np.array([f])
    found, stepped = case_of(own, f).run(), peaks_of(own, friction, friction)
    assert stepped.shaft[0] == pytest.approx(found.peak, rel=1e-3)
    assert stepped.clutch[0] == pytest.approx(found.peak_clutch, rel=5e-3)


@pytest.mark.exhaustive
def test_the_issues_commands():
    """Figures of the issue: those of the table, which an independent solver gave too."""
    own = issue(**{"friction.max": 0.3})
    sweep = simulate(own, sweeps=[parse_axis("friction.min=0.1,0.11", own.spec)])[0].sweep
    assert sweep is not None
    assert sweep[0].peak_torque_mean == pytest.approx([646.29] * 2, rel=1e-3)
    assert sweep[0].peak_torque_clutch == pytest.approx([498.45] * 2, rel=5e-3)


def random_drive(rng):
    """An indirect clutch at a friction about that of its setting, in a drive."""
    u = rng.uniform
    inertia, stiffness = 10 ** u(-2.2, -1.3), 10 ** u(3.3, 4.3)
    train = {"hub_inertia": inertia * u(0.2, 0.8), "driven_inertia": inertia, "stiffness": stiffness}
    train |= {"motor_inertia": 10 ** u(-0.3, 0.7), "speed": u(5, 30), "time": 10 ** u(-2.2, -1.7), "load": 140.0}
    law = {"closing_stiffness": 10 ** u(4.5, 5.7), "control_stiffness": 10 ** u(4.5, 5.7), "friction_set": 0.3}
    law |= {"gain": u(0.6, 1.5)}
    law |= {"key_friction": law["gain"] * u(0.01, 0.06)}
    own = indirect(0.3 * u(0.95, 1.04), law=law, damping=2 * 0.05 * (stiffness * inertia) ** 0.5)
    return replace(own, train=replace(own.train, **train))


@pytest.mark.every(8)
@pytest.mark.parametrize("seed", range(16))
def test_random_drives_in_the_band(seed):
    own = random_drive(np.random.default_rng([22, seed]))
    found, step = run(own, 0.06), float(np.max(step_of(own.train, own.pack)))
    stepped = march(own.train, own.pack, np.array([step]), int(0.06 / step))
    assert stepped.peak[0] == pytest.approx(found.peak, rel=1e-3)
    assert stepped.peak_clutch[0] == pytest.approx(found.peak_clutch, rel=5e-3)


@pytest.mark.every(2)
@pytest.mark.parametrize("key_friction", [0.05, 0.01])
def test_the_bracket_at_the_stop(key_friction):
    """V1 by hand: T = zf R F_п2/(1 + zf κ), run down against the load's torque; with κ₊ and the play too.

    f_min 0.1: zf = 0.8; F_п2 = 2000 (1 + 2.4 κ), T_н = 240·2 N·m, machine torque T_н/1.75.
    """
    own = issue(**{"control_unit.key_friction": key_friction})
    kappa, kappa_back, motor = 1 - 4 * key_friction, 1 + 4 * key_friction, 480 / 1.75
    rising, falling = (0.8 * 0.1 * 2000 * (1 + 2.4 * kappa) / (1 + 0.8 * net) for net in (kappa, kappa_back))
    play, along, against = bracket_of(outcome_of(own, 0.1))
    assert along.slip_time == pytest.approx(1.5 * 30 / (rising - motor), rel=0.02)
    assert along.energy == pytest.approx(0.5 * 1.5 * 30**2 * rising / (rising - motor), rel=0.02)
    assert max(each.trip.residual for each in (play, along, against)) < 1e-6
    if key_friction == 0.01:
        assert against.energy == pytest.approx(0.5 * 1.5 * 30**2 * falling / (falling - motor), rel=0.02)
        assert play.energy == pytest.approx(10_164, rel=2e-3)
        return
    assert along.slip_time == pytest.approx(4.3, abs=0.05)
    assert falling < motor
    result, findings = simulate(own)
    assert ("stop-bracket", "warning") in {(each.code, each.level) for each in findings}
    low, high = result.slip_energy_low, result.slip_energy_high
    assert low is not None
    assert high is not None
    assert (low.min, play.energy, against.energy, high.min) == (pytest.approx(along.energy), None, None, None)
    assert result.peak_torque_low.min <= result.peak_torque.min <= result.peak_torque_high.min
    assert low.max == pytest.approx(high.max), "at f_max the event is off the stop"


def test_without_friction_at_the_key_there_is_no_bracket():
    assert bracket_of(outcome_of(issue(**{"control_unit.key_friction": 0}), 0.1)) == []


@pytest.mark.every(2)
@pytest.mark.parametrize(("key_friction", "gain"), [(0.15, 2.0), (0.01, 1.0)])
def test_the_key_loses_what_the_turns_of_the_sleeve_tell(key_friction, gain):
    """dE = (C/κ − 1) dW on the way out, (1 − C/κ₊) dW back, W = (F_п2 − F_п1) x + ½ (c_1 + c_2) x²: from the travels alone.

    example:indirect: F_п1 2 kN, c_1 400, c_2 200 N/mm, set at f = 0.3: F_п2 = F_п1 (1 + 2.4 κ), 2 R f_1/d = 4 f_1.
    """
    own = issue(**{"control_unit.key_friction": key_friction, "control_unit.gain": gain})
    kappa, kappa_back = gain - 4 * key_friction, gain + 4 * key_friction
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


@pytest.mark.exhaustive
def test_where_no_key_rubs_none_loses_energy():
    assert simulate(issue(**{"control_unit.key_friction": 0}))[0].key_energy is None
    assert simulate(build(read_spec("example:drive")))[0].key_energy is None
    # the motor drives the clutch on at f_min
    endless, _ = simulate(issue(**{"control_unit.key_friction": 0.15, "control_unit.gain": 1}))
    assert (endless.slip_energy.min, endless.key_energy.min) == (None, None)
    assert endless.key_energy.max > 0


def test_slow_slip_is_as_long_as_it_is():
    """example:drive at f_min: 1.87255 s and 3356.19 J by fixed steps (RK4) in quadruple precision; 1.8455 s before.

    The slip ends in judder, whose swings grow from what the event has left of them: double precision gives 1.872.
    """
    own = build(read_spec("example:drive"))
    found = case_of(own, own.friction[0].min).run()
    assert found.slip_time == pytest.approx(1.87255, rel=1e-3)
    assert found.heat == pytest.approx(3356.19, rel=1e-4)
    assert found.residual < 1e-6


def constant_torque(load: float):
    """The spec of the issue, under a load."""
    law = {"friction_set": 0.1, "gain_slope": (2e4 + 1e4) / (8 * 0.1 * 2500.0), "key_friction": 0.02}
    return indirect(0.3, law=law, load=load, kind="load", tool_inertia=0.1, overload=600.0, time=0.0, motor_inertia=0.5)


def test_a_constant_torque_pocket_starts_under_its_nominal_torque():
    """There the control unit has no stiffness, and nothing is lifted: the answer is that of a load a little below."""
    full = constant_torque(200.0)
    assert full.pack.lift == pytest.approx(200.0)
    assert full.pack.torsional(0.0, full.pack.net_gain, full.pack.lift) == pytest.approx(0.0, abs=1e-6)
    assert full.start()[TURN] == 0
    found, near = (trip(own, 0.05, given=True) for own in (full, constant_torque(200.0 / 1.0001)))
    for name in ("peak", "peak_clutch", "heat", "slip_time"):
        assert getattr(found, name) == pytest.approx(getattr(near, name), rel=2e-3), name
    step = np.array([0.05 / 1000])
    assert march(full.train, full.pack, step, 1000).peak[0] == pytest.approx(found.peak, rel=1e-3)


def test_the_energy_of_steps_closes():
    """Each loss by its own law, the key's by κ and κ₊: none is what the others leave."""
    own, friction = issue(), np.array([0.1, 0.285, 0.32, 0.8])
    train, pack = train_of(own), pack_of(own, friction, friction)
    h = np.broadcast_to(step_of(train, pack), friction.shape).astype(float)
    shaft = Shaft(train, h)
    lanes = SleeveLanes(train, pack, h, shaft.per_torque)

    def stored():
        turning = train.motor_inertia * motor**2 + train.hub_inertia * (shaft.driven + lanes.rate) ** 2
        moving = turning + train.driven_inertia * shaft.driven**2 + shaft.elastic**2 / train.stiffness
        return moving / 2 + pack.work(pack.travel(lanes.turn))

    motor, works = shaft.driven, np.zeros((5, friction.size))
    begun, gain = stored(), pack.stop_gain
    for number in range(1200):
        before = motor, lanes.slip, shaft.tool, lanes.rate, lanes.turn, shaft.driven - shaft.tool
        free = shaft.free(number, lanes.balls)
        driven = motor + h / train.motor_inertia * train.engine.torque
        lanes.step(free, driven, shaft.driven)
        motor = driven - h / train.motor_inertia * lanes.torque
        shaft.take(free + shaft.per_torque * lanes.balls)
        after = motor, lanes.slip, shaft.tool, lanes.rate, lanes.turn, shaft.driven - shaft.tool
        speed, slip, tool, rate, turn, twisting = ((a + b) / 2 for a, b in zip(before, after, strict=True))
        net = np.where(turn * rate > 0, pack.net_gain, pack.net_gain_returning)
        held = shaft.torque - train.damping * (shaft.driven - shaft.tool) - train.stiffness * h * twisting / 2
        powers = (
            train.engine.torque * speed,
            lanes.torque * slip,
            train.damping * twisting**2,
            (held + train.damping * twisting) * tool,
            lanes.balls * rate * (1 - net / gain),
        )
        works += h * np.array(powers)
    given, *lost = works
    residual = begun + given - stored() - np.sum(lost, axis=0)
    assert np.all(np.abs(residual) < 1e-3 * np.maximum(begun, given))
    assert np.all(lost[-1][1:] > 0), "the key takes its share"


@pytest.mark.exhaustive
def test_a_peak_that_has_passed_is_not_found_again_beside_others():
    """Stepped on beside slower drives, a drive switched off at rest swung up to 5709 N·m where its peak is 675 N·m."""
    own = issue(**{"drive.cut_off": 0.05})
    friction = np.linspace(0.1, 0.8, 200)[[0, 79, 120, 199]]
    together = peaks_of(own, friction, friction)
    alone = [case_of(own, each).run() for each in friction]
    assert together.passed.all()
    assert together.shaft == pytest.approx([each.peak for each in alone], rel=2e-3)
    assert together.clutch == pytest.approx([each.peak_clutch for each in alone], rel=5e-3)


@pytest.mark.exhaustive
def test_lanes_that_are_stepped_on_stay_where_the_event_is():
    """Balls that one wall alone sends back swing no more: taken for a swing over both, it threw them about at 0.38 s."""
    clutch = issue(**{"drive.cut_off": 0.05, "friction.max": 0.3779})
    train, pack = train_of(clutch), pack_of(clutch, np.array([0.3779]), np.array([0.3779]))
    found = march(train, pack, np.broadcast_to(step_of(train, pack), (1,)).astype(float), 8000)
    event = outcome_of(clutch, 0.3779).trip
    assert found.peak == pytest.approx(event.peak, rel=1e-3)
    assert found.peak_clutch == pytest.approx(event.peak_clutch, rel=5e-3)


@pytest.mark.exhaustive
def test_balls_whose_key_is_free_of_friction_swing_on_but_the_event_ends():
    """Nothing feeds them once the motor is off: the slip is over, and in steps too."""
    own = issue(**{"control_unit.key_friction": 0, "drive.cut_off": 0.05})
    found = case_of(own, 0.8).run()
    assert found.settled
    assert found.ended
    friction = np.array([0.8])
    train, pack = train_of(own), pack_of(own, friction, friction)
    step = np.broadcast_to(step_of(train, pack), (1,)).astype(float)
    stepped = march(train, pack, step, int(0.2 / step[0]))
    assert stepped.heat[0] == pytest.approx(found.heat, rel=2e-3)
    assert stepped.peak[0] == pytest.approx(found.peak, rel=1e-3)
    assert stepped.slip[0] == 0
