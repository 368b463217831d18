"""What a stuck or slipping drive can still reach, against the swing itself: torques of an undamped shaft over a period."""

from dataclasses import replace

import numpy as np
import pytest
from drives import TRAIN

from afmcalc.drive.rest import Slipping, Stuck, settled, slips_below
from afmcalc.drive.train import Engine

PHASE = np.linspace(0, 2 * np.pi, 100_001)
BEHIND, FRONT = 0.05, 8.05


def largest(about: float, torque: float, speed: float, inertia: float) -> float:
    """Of a shaft that begins at a torque and a speed of twist."""
    swing = (torque - about) * np.cos(PHASE) + speed * (8000 * inertia) ** 0.5 * np.sin(PHASE)
    return float(np.max(about + swing))


def stuck(torque: float, speed: float) -> Stuck:
    return Stuck(speed, 0.0, torque, standing=True, powered=True, pending=False)


@pytest.mark.parametrize(("torque", "speed"), [(250.0, 0.5), (40.0, 1.0), (-60.0, -0.2)])
def test_a_stuck_drive_is_left_where_its_swing_passes_no_peak(torque, speed):
    """All turn on the shaft of a standing tool, about the torque of the motor."""
    top = largest(150.0, torque, speed, FRONT)
    assert settled(TRAIN, stuck(torque, speed), 1e9, top * 1.0001)
    assert not settled(TRAIN, stuck(torque, speed), 1e9, top * 0.9999)
    assert not settled(TRAIN, stuck(torque, speed), 100.0, top * 1.0001), "the motor alone makes it slip"


@pytest.mark.parametrize(("torque", "speed"), [(250.0, 0.5), (90.0, 3.0)])
def test_a_slipping_drive_is_left_where_the_driven_half_passes_no_peak(torque, speed):
    """The driven half alone swings about the torque of the clutch."""
    slipping = Slipping(torque=180.0, speed=speed, sliding=180.0, breakaway=180.0)
    top = largest(180.0, torque, speed, BEHIND)
    assert slips_below(TRAIN, stuck(torque, 20.0), slipping, top * 1.001)
    assert not slips_below(TRAIN, stuck(torque, 20.0), slipping, top * 0.999)


def test_a_motor_that_feeds_the_swing_makes_the_clutch_slip_again():
    """All swing about the stalled motor's torque as far as breakaway; what the driven half then has goes on alone."""
    driven = replace(TRAIN, engine=Engine(250.0, 0.2, 15.7))
    stalled = 2 * 250 / (1 / 0.2 + 0.2)
    speed = (200 - stalled) / (8000 * FRONT) ** 0.5
    top = largest(200.0, 200.0, speed, BEHIND)
    slipping = Slipping(torque=180.0, speed=0.0, sliding=180.0, breakaway=200.0)
    assert slips_below(driven, stuck(180.0, 5.0), slipping, top * 1.001)
    assert not slips_below(driven, stuck(180.0, 5.0), slipping, top * 0.999)


def test_a_motor_to_be_switched_off_does_not_leave_a_turning_tool_settled():
    """A stuck drive swings about a load that it carries, until the cut-off takes its motor away."""
    train = replace(TRAIN, kind="load", tool_inertia=2.0, overload=120.0)
    turning = Stuck(15.0, 15.0, 120.0, standing=False, powered=True, pending=False)
    assert settled(train, turning, 300.0, 200.0)
    assert not settled(train, turning._replace(pending=True), 300.0, 200.0)
