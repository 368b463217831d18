"""Indirect clutches in their drive: the swing of the control unit (V7), quasi-static loading, the stop."""

import pytest
from drives import indirect, run

from afmcalc.drive.train import Engine
from afmcalc.engines.characteristics import DiscCharacteristic
from afmcalc.equations import sleeve as law
from afmcalc.spec.models import DiscStack

FREE = {"time": 0.0, "stiffness": 1e-6, "load": 0.0, "engine": Engine(0.0, None, 0.0)}
"""Behind a shaft as soft as air, without motor."""


@pytest.mark.parametrize("rate", [10.0, pytest.param(2.0, marks=pytest.mark.slow)])
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


SLOW = {"stiffness": 2000.0, "driven_inertia": 2000.0, "motor_inertia": 1e12, "damping": 2000.0, "speed": 4e-3,
        "time": 600.0}  # fmt: skip
"""A tool that slows down for so long that inertia is nothing."""
LASTING = {"motor_inertia": 1e12, "driven_inertia": 1e9, "speed": 5.0, "time": 0.0, "load": 150.0}


@pytest.mark.slow
def test_quasi_static_loading_trips_at_the_torque_of_the_law():
    drive = indirect(0.1, **SLOW)
    F1, F2, c1, c2, zf, R, kappa = 2500.0, 3300.0, 2e4, 1e4, 8 * 0.1, 0.1, 0.4
    expected = zf * R * (F1 * c2 + F2 * c1) / (c1 + c2 + zf * c1 * kappa)
    assert (drive.pack.sliding, run(drive, 600.0).trip_torque) == pytest.approx((expected, expected), rel=1e-3)


@pytest.mark.parametrize("slope", [0.0, 15.0])
@pytest.mark.parametrize("friction", [0.6, 0.16, 0.05])
def test_returning_it_slides_at_the_torque_of_the_law(friction, slope):
    """A hair less friction under a lasting load: held by its key, or back by a hair, it carries what `torque` says."""
    drive = indirect(friction, law={"gain_slope": slope}, **LASTING)
    own, before = drive.pack.law, friction * (1 + 2e-7)
    expected, torque = (own.at(friction=each, friction_max=0.8)["torque_returning"] for each in (friction, before))
    travel = (2500 - torque / (0.8 * before)) / 2e4
    turn = law.turn(travel, 0.1, 1.0, slope)
    found = run(drive, 0.2, finer=1e5, slip=5.0, driven=0.0, elastic=torque, turn=turn, normal=2500.0)
    assert found.last == pytest.approx(expected, rel=1e-5)


@pytest.mark.slow
def test_the_stop_carries_what_the_springs_do_not():
    """At the stop N = F_п2 − κ T/R while the load rises: below T_н a direct clutch of gain κ (theory, section 5)."""
    drive = indirect(0.05, time=0.0, motor_inertia=1e12, load=50.0)
    assert drive.pack.sliding == pytest.approx(8 * 0.05 * 0.1 * 3300 / (1 + 8 * 0.05 * 0.4))
    found = run(indirect(0.05, **SLOW, load=20.0), 600.0)  # fmt: skip
    assert found.trip_torque == pytest.approx(drive.pack.sliding, rel=1e-3)
    assert found.travel_max == 0


CURVED = {"gain_slope": 3e4 / (8 * 0.1 * 2500)}
"""C_1* of a wall that holds the torque (theory, section 12)."""


@pytest.mark.slow
def test_a_wall_that_holds_the_torque():
    """Whatever the friction, quasi-static loading trips at T_н: the control unit is a spring without stiffness."""
    drive = indirect(0.5, law=CURVED, **SLOW | {"speed": 8e-3})  # fmt: skip
    assert drive.pack.sliding == pytest.approx(200.0, rel=1e-12)
    found = run(drive, 600.0)
    assert found.trip_torque == pytest.approx(200.0, rel=1e-3)
    # off its stop the sleeve is driven on by what the torque has over T_н, until the pack slips
    assert found.travel_max >= 2500 / 2e4 * (1 - 0.1 / 0.5) * (1 - 1e-3)


def test_a_swing_against_a_curved_wall():
    """Energy: T κ(x)/R = F + m x'' on the way, so that dE = (C/κ)(dW + m x'' dx) with gains of the place."""
    drive = indirect(0.3, law=CURVED | {"key_friction": 0.0}, mass=2.0, motor_inertia=1e12, **FREE)
    found = run(drive, 0.2, finer=2e5, driven=-5.0, rate=5.0, turn=1e-12, elastic=0.0)
    kinetic = 0.5 * 0.05 * 25 + 0.5 * 2.0 * law.travel_rate(5.0, 0.1, 1.0) ** 2
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
    """Loaded slowly or returning it carries what ``torque`` says; a frictionless key gives all energy back."""
    own = {"closing_disc": DISC, "control_disc": DISC}
    drive = indirect(0.3, law=own, **SLOW | {"speed": 16e-3, "time": 300.0})
    assert drive.pack.sliding != pytest.approx(indirect(0.3).pack.sliding, rel=1e-3)
    assert run(drive, 300.0).trip_torque == pytest.approx(drive.pack.sliding, rel=1e-3)

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
