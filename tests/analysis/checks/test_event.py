"""An event in the drive is held against what the rest of the clutch bears: balls, pockets, springs, shaft, discs."""

import math

import pytest
from conftest import CONFIGS
from drives import merged

from afmcalc.analysis.asking import Answers
from afmcalc.analysis.check import check
from afmcalc.analysis.drive_result import SimulateResult
from afmcalc.analysis.simulate import simulate
from afmcalc.analysis.synthesize import SynthesisResult
from afmcalc.engines import build
from afmcalc.engines.parts import checks_of_springs
from afmcalc.spec import read_spec

PRESS = {
    "variant": "indirect",
    "friction": {"min": 0.15, "max": 0.5},
    "friction_group": {"pairs": 6, "mean_radius": 0.085},
    "closing_spring": {"force": 3200.0, "stiffness": 2.5e5},
    "control_spring": {"stiffness": 1.2e5},
    "control_unit": {
        "gain": 1.6, "ball_circle_radius": 0.045, "balls": 6, "face_gap": 0.002, "edge_clearance": 0.002,
        "allowable_contact_force": 8000.0, "hub_diameter": 0.06, "key_friction": 0.12,
    },
    "adjustment": {"method": "min-friction", "margin": 1.3},
    "drive": {
        "dynamic_factor": 1.5, "speed": 60.0, "motor_inertia": 0.3, "driven_inertia": 0.03, "shaft_stiffness": 1.2e4,
        "damping_ratio": 0.02, "hub_inertia": 0.01, "event": {"kind": "stop", "stop_time": 0.008, "duration": 0.05},
    },
    "fatigue": {"endurance_limit": 220e6, "polar_section_modulus": 6e-6, "exponent": 6, "base_cycles": 5e6},
}  # fmt: skip


def row_of(result, name):
    (row,) = (row for row in result.checks if str(row.name) == name)
    return row


@pytest.mark.slow
def test_an_event_is_held_against_balls_and_pockets():
    """The sleeve swings farther than the law has it travel: 2 r_ш sin α − s is where the ball leaves its pocket."""
    own = build(PRESS)
    answers = Answers(own)
    result, found = check(own, answers=answers)
    made, event = answers.of(SynthesisResult), answers.of(SimulateResult)
    edge = made.ball_diameter_standard * math.sin(made.wall_angle) - 0.002
    travel = event.travel_max.max
    row = row_of(result, "travel in the event, the ball in its pocket")
    assert (row.value, row.limit, row.grade) == (travel, pytest.approx(edge, rel=1e-9), "fail")
    assert travel > edge > made.travel_max
    assert "event-ball-leaves-pocket" in {each.code for each in found}
    # farthest off the walls bear S(x)/κ; as the ball leaves its seat no more than the peak at the clutch
    force = row_of(result, "contact force on one ball in the event").value
    assert force == event.contact_force.max
    assert 0 < force <= event.peak_torque_clutch.max * 1.001 / (6 * 0.045 * math.cos(made.wall_angle))
    assert force > 1.2 * made.contact_force


@pytest.mark.slow
@pytest.mark.parametrize(
    ("code", "changes"),
    [
        ("event-contact-force", {"control_unit": {"allowable_contact_force": 2.2e3}}),
        ("event-spring-let-go", {"drive": {"event": {"stop_time": 0.001}}}),
        ("event-clearance", {"drive": {"speed": 20.0}, "control_unit": {"edge_clearance": 0.0022}}),
    ],
)
def test_an_event_that_asks_too_much_is_told(code, changes):
    """While the static force on a ball passes."""
    assert {code, "contact-force-exceeded"} & {each.code for each in check(build(merged(PRESS, changes)))[1]} == {code}


@pytest.mark.slow
def test_disc_springs_are_held_where_the_sleeve_swings():
    """Picked for the travel of the law, which they hold, they are let go in the event."""
    discs = {"outer_diameter": 0.045, "inner_diameter": 0.0224, "thickness": 1.75e-3, "free_height": 3.05e-3}
    springs = {"closing_spring": {"stiffness": 262792.529, "disc": discs | {"series": 11}}}
    clutch = build(merged(PRESS, {**springs, "drive": {"event": {"stop_time": 0.005}}}))
    answers = Answers(clutch)
    result, found = check(clutch, answers=answers)
    assert all(rule.beyond <= 0 for _, rule in checks_of_springs(clutch))
    row = row_of(result, "closing spring: travel by which the spring is let go")
    assert (row.value, row.grade) == (answers.of(SimulateResult).travel_max.max, "fail")
    assert "event-spring" in {each.code for each in found}


@pytest.mark.slow
def test_a_temperature_is_judged_as_far_as_slips_end(afmcalc):
    """A motor with a curve and an event tell the heat; a slip that does not end leaves the largest open."""
    motor = "drive.motor={breakdown_torque=100.0, breakdown_slip=0.2, synchronous_speed=32.0}"
    light = ["--set", "drive.load_torque=50", "--set", "drive.motor_inertia=0.1"]
    own = ["check", CONFIGS / "drive.toml", "--json", *light]
    off = ["--set", "drive.cut_off=0.3", "--set", "drive.speed=", "--set", "requirements.peak_torque="]
    ended = afmcalc(*own, "--set", motor, *off).json["result"]
    (row,) = (row for row in ended["checks"] if row["code"] == "requirement-missed")
    assert (row["path"], row["passed"]) == ("requirements.temperature", True)
    assert row["value"] > 293
    endless = ["--set", "drive.motor_torque=150", "--set", "requirements.peak_torque="]
    for limit, passed in ((477.0, None), (293.2, False)):
        left = afmcalc(*own, *endless, "--set", f"requirements.temperature={limit}").json
        (row,) = (row for row in left["result"]["checks"] if row["code"] == "requirement-missed")
        assert (row["passed"], row["value"] > 293.3) == (passed, True), "of the frictions at which it ends"


def test_the_balls_of_a_direct_clutch_bear_their_share_of_the_peak():
    """F_n = z_2/z T_peak,c/(n r cos α), tan α = C r/R; a release force that lags lets the peak rise."""
    own = read_spec(CONFIGS / "drive.toml", ["control_unit.release_lag=0.02", "drive.motor_inertia=0.1"])
    found = simulate(build(own))[0]
    cosine = 1 / math.hypot(1, 0.5 * 50 / 100)
    share = 7 / 8 * found.peak_torque_clutch.max / (6 * 0.05 * cosine)
    assert found.contact_force.max == pytest.approx(share, rel=1e-9)
    assert found.peak_torque_clutch.max > 1.5 * found.sliding_torque.max
