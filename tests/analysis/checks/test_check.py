"""Faults of a clutch, their levels, the exit code; checks of an event for balls, pockets, springs, shaft, discs."""

import math

import pytest
from conftest import CONFIGS, S21, WANTED, overrides
from drives import merged
from sources import CLUTCHES

from afmcalc.analysis.asking import Answers
from afmcalc.analysis.check import check
from afmcalc.analysis.drive_result import SimulateResult
from afmcalc.analysis.simulate import simulate
from afmcalc.analysis.synthesize import SynthesisResult
from afmcalc.engines import build
from afmcalc.engines.parts import checks_of_springs
from afmcalc.spec import make_spec, read_spec, resolved

QUICK = ["default", "indirect", "constant-torque", "unlike-materials"]
OTHERS = sorted({path.stem for path in CONFIGS.glob("*.toml")} - {"fokin2011-fig2", "conveyor-clutch", *WANTED, *QUICK})
"""Clutches that can be made; the gain of F11 fig. 2 is above its limit as printed (M4)."""


@pytest.mark.parametrize("name", [*QUICK, *(pytest.param(each, marks=pytest.mark.slow) for each in OTHERS)])
def test_what_ships_can_be_made(name, afmcalc):
    run = afmcalc("check", CONFIGS / f"{name}.toml", "--strict", "--json")
    assert run.code == 0, run.out
    # whether a clutch slips at the start of its motor is worth knowing, and no fault
    assert {row["passed"] for row in run.json["result"]["checks"] if row["level"] != "info"} == {True}


def test_a_warning_fails_a_strict_check(afmcalc):
    steep = ["check", *overrides(*["C=2", "control_unit.balls=8"])]
    assert afmcalc(*steep).code == 0
    run = afmcalc(*steep, "--strict", "--json")
    result = run.json["result"]
    assert (run.code, result["passed"], result["errors"], result["warnings"]) == (1, False, 0, 1)
    (beyond,) = [row for row in result["checks"] if not row["passed"]]
    assert (beyond["value"], beyond["limit"]) == (2, pytest.approx(1.25))


IMPOSSIBLE = {
    "balls-overlap": (["control_unit.balls=13"], 0.025, 0.1 * math.sin(math.pi / 13)),
    "ball-reaches-axis": (["control_unit.balls=", "r=10 mm"], None, 0.01),
    # C 5: tan α 2.5, balls of 6.5 mm have room, mouths 6.5/cos α − s tan α have not
    "pockets-overlap": (["C=5", "control_unit.balls=26"], 0.0065 * math.hypot(1, 2.5) - 0.005, 0.1 * math.sin(math.pi / 26)),
    "no-standard-ball": (["C=0.1"], None, 0.104775),
    "depth-beyond-sleeve": (["control_unit.sleeve_depth=11 mm"], 0.0115, 0.011),
    "ball-too-small": (["control_unit.ball_diameter=20 mm"], 0.02, 0.006 / math.sin(math.atan(0.25))),
}  # fmt: skip
"""Code → what makes the base clutch (r 50 mm, s = y = 2 mm) so, value and limit worked out by hand."""


@pytest.mark.parametrize("code", IMPOSSIBLE)
def test_the_impossible_is_an_error(code, afmcalc):
    changes, value, limit = IMPOSSIBLE[code]
    run = afmcalc("check", *overrides(*changes), "--json")
    (found,) = [each for each in run.json["findings"] if each["code"] == code]
    assert (run.code, found["level"], found["limit"]) == (1, "error", pytest.approx(limit))
    assert value is None or found["value"] == pytest.approx(value)


def test_what_is_not_given_is_not_judged(afmcalc):
    for key, code in (("ball_circle_radius", "control-unit-not-judged"), ("balls", "balls-not-given")):
        run = afmcalc("check", "--set", f"control_unit.{key}=", "--json").json
        assert [each["path"] for each in run["findings"] if each["code"] == code] == [f"control_unit.{key}"]
        assert not [row for row in run["result"]["checks"] if "side by side" in row["name"]]


UNUSUAL = {
    "friction.max": (["friction.max=8"], 8, 1), "friction.min": (["friction.min=0.001"], 0.001, 0.02),
    "friction_group.mean_radius": (["R=0.1 mm"], 1e-4, 0.01), "friction_group.pairs": (["z=50"], 50, 40),
    "adjustment.margin": (["beta=12.5"], 12.5, 3), "closing_spring.force": (["F=2 MN"], 2e6 / (math.pi * 0.01), 5e6),
    "control_unit.wall_angle": (["C=", "alpha=80 deg"], math.radians(80), math.radians(60)),
    "control_unit.gain": (["C=0.1"], math.atan(0.05), math.radians(5)),
    "control_unit.ball_circle_radius": (["r=5 mm"], 0.005, 0.02),
}  # fmt: skip
"""Key → what makes the base clutch strange, the figure, and the end of the usual range it is beyond."""


@pytest.mark.parametrize("path", UNUSUAL)
def test_the_implausible_is_a_warning_that_names_the_usual(path, afmcalc):
    changes, value, limit = UNUSUAL[path]
    found = afmcalc("check", *overrides(*changes), "--json").json["findings"]
    (own,) = [each for each in found if (each["code"], each["path"]) == ("unusual", path)]
    assert (own["level"], own["value"], own["limit"]) == ("warning", pytest.approx(value), pytest.approx(limit))


def test_a_spring_as_long_as_the_clutch_is_wide_is_unusual():
    found = Answers(build(read_spec(S21))).ask("check")[1]
    (soft,) = [each for each in found if each.code == "unusual"]
    assert (soft.path, soft.value, soft.limit) == ("control_spring.stiffness", pytest.approx(0.264), pytest.approx(0.2))
    constant = resolved(read_spec(S21, ["control_spring.stiffness=0"]))
    assert not [each for each in Answers(build(make_spec(constant))).ask("check")[1] if each.code == "unusual"]


RING = [f"friction_group.{key}" for key in ("mean_radius=", "inner_radius=0.03", "outer_radius=0.17")]


@pytest.mark.parametrize(
    ("name", "hub", "limits"),
    [
        ("indirect", "0.5", [0.2, 0.1 - 0.01984375]),
        ("constant-torque", "0.1441", [0.144]),
        ("constant-torque", "0.0601", [0.06]),
    ],
)
def test_a_hub_larger_than_balls_and_discs_leave_room_for(afmcalc, name, hub, limits):
    """Balls of 19.84 and 16 mm on circles of 50 and 80 mm radius leave 80.2 and 144 mm; discs with holes leave 2 r_i."""
    changes = [*(RING if hub == "0.0601" else []), f"control_unit.hub_diameter={hub}"]
    run = afmcalc("check", CONFIGS / f"{name}.toml", *overrides(*changes), "--json")
    said = [(each["value"], each["limit"]) for each in run.json["findings"] if each["code"] == "hub-too-large"]
    assert (run.code, said) == (1, [(float(hub), pytest.approx(limit, abs=1e-5)) for limit in limits])


RADII = overrides(*(f"friction_group.{key}" for key in ("mean_radius=", "inner_radius=0.08", "outer_radius=0.12")))
CORK = overrides(*(f"friction.{key}" for key in ("min=", "mean=", "max=", "material=cork-dry")))


def findings(run):
    return {finding["code"]: finding for finding in run.json["findings"]}


def test_both_ends_of_an_allowable_range(afmcalc):
    """Cork bears 55 to 95 kPa: beyond the lower end there is only a warning, beyond the upper end only an error."""
    for force in (1000, 1500, 2380, 2400, 3000):
        run = afmcalc("check", *RADII, *CORK, "--set", f"F={force}", "--json")
        reached = {"mean": force / (math.pi * (0.12**2 - 0.08**2)), "peak": force / (2 * math.pi * 0.08 * 0.04)}
        told = {code: each for code, each in findings(run).items() if "pressure" in code}
        want = {name: "exceeded" if at > 95e3 else "in-range" if at > 55e3 else "" for name, at in reached.items()}
        assert set(told) == {f"{name}-pressure-{end}" for name, end in want.items() if end}
        assert all(each["value"] == pytest.approx(reached[code[:4]]) for code, each in told.items())
        assert run.code == ("exceeded" in want.values())
    even = afmcalc("check", *RADII, *CORK, "--set", "friction_group.radius_model=uniform-pressure", "--json")
    assert not any(code.startswith("peak") for code in findings(even))
    for arguments in (RADII, CORK):
        assert not any("pressure" in code for code in findings(afmcalc("check", *arguments, "--json")))


PRESS = CLUTCHES["press"]


def row_of(result, name):
    (row,) = (row for row in result.checks if str(row.name) == name)
    return row


@pytest.mark.slow
def test_an_event_is_held_against_balls_and_pockets():
    """In the event the sleeve travels farther than by the law; at 2 r_ш sin α − s the ball leaves its pocket."""
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
    # at the largest travel the walls bear S(x)/κ; as the ball leaves its seat, no more than the peak at the clutch
    force = row_of(result, "contact force on one ball in the event").value
    assert force == event.contact_force.max
    assert 0 < force <= event.peak_torque_clutch.max * 1.001 / (6 * 0.045 * math.cos(made.wall_angle))
    assert force > 1.2 * made.contact_force


@pytest.mark.slow
def test_disc_springs_are_held_where_the_sleeve_swings():
    """Disc springs that are picked for the travel by the law hold that travel, but are let go in the event."""
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
    """An event with a motor curve gives the heat; if a slip does not end, the largest temperature is not known."""
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
