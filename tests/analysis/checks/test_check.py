"""What is wrong with a clutch, how grave it is, and the exit code it ends in."""

import math

import pytest
from conftest import CONFIGS, S21, WANTED

from afmcalc.analysis.answers import Answers
from afmcalc.engines import build
from afmcalc.spec import make_spec, read_spec, resolved

SHIPPED = sorted(
    path for path in CONFIGS.glob("*.toml") if path.stem not in {"fokin2011-fig2", "conveyor-clutch", *WANTED}
)
"""Clutches that can be made; the gain of F11 fig. 2 is above its limit as printed (M4). Of the conveyor's see ``test_machines``."""

QUICK = {"default", "indirect", "constant-torque", "unlike-materials"}


def overridden(changes):
    return [part for change in changes for part in ("--set", change)]


@pytest.mark.parametrize(
    "path",
    [each if each.stem in QUICK else pytest.param(each, marks=pytest.mark.slow) for each in SHIPPED],
    ids=lambda path: path.stem,
)
def test_what_ships_can_be_made(path, afmcalc):
    run = afmcalc("check", path, "--strict", "--json")
    assert run.code == 0, run.out
    # whether a clutch slips at the start of its motor is worth knowing, and no fault
    held = [row for row in run.json["result"]["limits"] if row["name"] != "torque of a direct start"]
    assert {row["verdict"] for row in held} == {"pass"}


def test_a_warning_fails_a_strict_check(afmcalc):
    assert afmcalc("check", "--set", "C=2").code == 0
    run = afmcalc("check", "--set", "C=2", "--strict", "--json")
    assert run.code == 1
    result = run.json["result"]
    assert (result["passed"], result["errors"], result["warnings"]) == (False, 0, 1)
    (beyond,) = [row for row in result["limits"] if row["verdict"] == "warning"]
    assert (beyond["value"], beyond["limit"]) == (2, pytest.approx(1.25))


IMPOSSIBLE = {
    "balls overlap": ("balls-overlap", ["control_unit.balls=13"], 0.025, 0.1 * math.sin(math.pi / 13)),
    "a ball fills the ball circle": ("ball-reaches-axis", ["control_unit.balls=", "r=10 mm"], None, 0.01),
    # C 5: tan α 2.5, balls of 6.5 mm have room, mouths 6.5/cos α − s tan α have not
    "pockets cut into each other": (
        "pockets-overlap", ["C=5", "control_unit.balls=26"], 0.0065 * math.hypot(1, 2.5) - 0.005, 0.1 * math.sin(math.pi / 26),
    ),
    "no ball in the list": ("no-standard-ball", ["C=0.1"], None, 0.104775),
    "deeper than the sleeve": ("depth-beyond-sleeve", ["control_unit.sleeve_depth=11 mm"], 0.0115, 0.011),
    "a ball too small": ("ball-too-small", ["control_unit.ball_diameter=20 mm"], 0.02, 0.006 / math.sin(math.atan(0.25))),
}  # fmt: skip
"""Kind → its code, what makes the base clutch (r 50 mm, s = y = 2 mm) so, value and limit worked out by hand."""


@pytest.mark.parametrize("kind", IMPOSSIBLE)
def test_the_impossible_is_an_error(kind, afmcalc):
    code, changes, value, limit = IMPOSSIBLE[kind]
    run = afmcalc("check", *overridden(changes), "--json")
    assert run.code == 1
    (found,) = [each for each in run.json["findings"] if each["code"] == code]
    assert found["level"] == "error"
    assert found["limit"] == pytest.approx(limit)
    assert value is None or found["value"] == pytest.approx(value)
    for row in run.json["result"]["limits"]:
        assert (row["verdict"] == "pass") == (row["utilisation"] <= 1 + 1e-9)
    failed = [row for row in run.json["result"]["limits"] if row["verdict"] == "fail"]
    assert any((row["value"], row["limit"]) == (found["value"], found["limit"]) for row in failed)
    assert all(row["utilisation"] > 1 for row in failed)


def test_what_is_not_given_is_not_judged(afmcalc):
    for key, code in (("ball_circle_radius", "control-unit-not-judged"), ("balls", "balls-not-given")):
        run = afmcalc("check", "--set", f"control_unit.{key}=", "--json").json
        assert [each["path"] for each in run["findings"] if each["code"] == code] == [f"control_unit.{key}"]
        assert not [row for row in run["result"]["limits"] if "side by side" in row["name"]]


UNUSUAL = {
    "friction.max": (["friction.max=8"], 8, 1),
    "friction.min": (["friction.min=0.001"], 0.001, 0.02),
    "friction_group.mean_radius": (["R=0.1 mm"], 1e-4, 0.01),
    "friction_group.pairs": (["z=50"], 50, 40),
    "adjustment.margin": (["beta=12.5"], 12.5, 3),
    "closing_spring.force": (["F=2 MN"], 2e6 / (math.pi * 0.01), 5e6),
    "control_unit.wall_angle": (["C=", "alpha=80 deg"], math.radians(80), math.radians(60)),
    "control_unit.gain": (["C=0.1"], math.atan(0.05), math.radians(5)),
    "control_unit.ball_circle_radius": (["r=5 mm"], 0.005, 0.02),
}
"""Key → what makes the base clutch strange, the figure, and the end of the usual range it is beyond."""


@pytest.mark.parametrize("path", UNUSUAL)
def test_the_implausible_is_a_warning_that_names_the_usual(path, afmcalc):
    changes, value, limit = UNUSUAL[path]
    found = [
        each for each in afmcalc("check", *overridden(changes), "--json").json["findings"] if each["code"] == "unusual"
    ]
    (own,) = [each for each in found if each["path"] == path]
    assert (own["level"], own["value"], own["limit"]) == ("warning", pytest.approx(value), pytest.approx(limit))
    assert "unusual" in own["message"]
    assert "usual" in own["message"].replace("unusual", "")


def test_a_spring_as_long_as_the_clutch_is_wide_is_unusual():
    found = Answers(build(read_spec(S21))).ask("check")[1]
    (soft,) = [each for each in found if each.code == "unusual"]
    assert (soft.path, soft.value, soft.limit) == ("control_spring.stiffness", pytest.approx(0.264), pytest.approx(0.2))
    constant = resolved(read_spec(S21, ["control_spring.stiffness=0"]))
    assert not [each for each in Answers(build(make_spec(constant))).ask("check")[1] if each.code == "unusual"]


@pytest.mark.parametrize(("name", "value"), [("indirect", 0.5), ("constant-torque", 0.1441)])
def test_a_hub_larger_than_balls_and_discs_leave_room_for(afmcalc, name, value):
    """Balls of 19.84 and 16 mm on circles of 50 and 80 mm radius leave 80.2 and 144 mm; discs with holes leave 2 r_i."""
    hub, spec = ["--set", f"control_unit.hub_diameter={value}"], CONFIGS / f"{name}.toml"
    run = afmcalc("check", spec, *hub, "--json")
    assert run.code == 1
    (said,) = [each for each in run.json["findings"] if each["code"] == "hub-too-large"]
    assert (said["value"], said["limit"]) == (
        value,
        pytest.approx(0.1 - 0.019844 if value == 0.5 else 0.16 - 0.016, abs=1e-6),
    )
    (row,) = [each for each in run.json["result"]["limits"] if each["name"] == "hub within balls and discs"]
    assert row["verdict"] == "fail"
    ring = [f"friction_group.{key}" for key in ("mean_radius=", "inner_radius=0.03", "outer_radius=0.17")]
    run = afmcalc("check", spec, *overridden([*ring, "control_unit.hub_diameter=0.0601"]), "--json")
    (said,) = [each for each in run.json["findings"] if each["code"] == "hub-too-large"]
    assert said["limit"] == pytest.approx(0.06)


RING = ("friction_group.mean_radius=", "friction_group.inner_radius=80 mm", "friction_group.outer_radius=120 mm")
RADII = [part for change in RING for part in ("--set", change)]
CORKS = ("friction.min=", "friction.mean=", "friction.max=", "friction.material=cork-dry")
CORK = [part for change in CORKS for part in ("--set", change)]
LOWER = 55e3
"""Pa, what cork bears at least; 95 kPa at most."""


def findings(run):
    return {finding["code"]: finding for finding in run.json["findings"]}


@pytest.mark.parametrize(
    ("force", "mean", "peak", "code"),
    [(1000, "mean-pressure", "peak-pressure", 0), (1500, "mean-pressure-in-range", "peak-pressure-in-range", 0), (3000, "mean-pressure-exceeded", "peak-pressure-exceeded", 1)],
)  # fmt: skip
def test_pressure(force, mean, peak, code, afmcalc):
    run = afmcalc("check", *RADII, *CORK, "--set", f"F={force}", "--json")
    assert run.code == code
    found = findings(run)
    assert found[mean]["value"] == pytest.approx(force / (math.pi * (0.12**2 - 0.08**2)))
    assert found[peak]["value"] == pytest.approx(force / (2 * math.pi * 0.08 * 0.04))
    assert found[mean]["path"] == "friction.material"
    pressed = findings(
        afmcalc("check", *RADII, *CORK, "--set", "friction_group.radius_model=uniform-pressure", "--json")
    )
    assert not any(code.startswith("peak") for code in pressed)


def test_one_limit_on_both_sides_of_the_allowable_range(afmcalc):
    """The utilisation grows with the load, and row, finding and sentence agree."""
    before = 0.0
    for force, grade in ((1000, "pass"), (1500, "warning"), (2380, "warning"), (2400, "fail"), (3000, "fail")):
        run = afmcalc("check", *RADII, *CORK, "--set", f"F={force}", "--json")
        row = next(row for row in run.json["result"]["limits"] if row["name"] == "surface pressure in the mean")
        said = next(each for code, each in findings(run).items() if code.startswith("mean-pressure"))
        assert row["verdict"] == grade
        assert said["limit"] == row["limit"] == LOWER
        assert row["utilisation"] == pytest.approx(row["value"] / LOWER)
        assert f"utilisation {row['utilisation']:.3g}" in said["message"]
        assert row["utilisation"] > before
        before = row["utilisation"]


def test_no_pressure_without_radii_or_material(afmcalc):
    for arguments in (RADII, CORK):
        assert not any("pressure" in code for code in findings(afmcalc("check", *arguments, "--json")))
