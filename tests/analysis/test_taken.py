"""What the plate of a motor, the diameter of a shaft and the rest of a file tell, by hand; the lines to paste for what they do not."""

import json
import math
import tomllib

import pytest
from conftest import CONFIGS
from drives import merged
from sources import REFUSED

from afmcalc.analysis.asking import Answers
from afmcalc.analysis.check import check_at_once
from afmcalc.analysis.clutch_findings import speed_findings
from afmcalc.analysis.fatigue import life
from afmcalc.analysis.neglected import effects
from afmcalc.analysis.simulate import simulate
from afmcalc.analysis.trip_heat import STEEL, heat
from afmcalc.drive.train import train_of
from afmcalc.engines import build
from afmcalc.errors import SpecError
from afmcalc.spec import make_spec, resolved

MACHINE = tomllib.loads((CONFIGS / "machine-clutch.toml").read_text(encoding="utf-8"))
GEAR = {"machine": {"ratio": 2}, "heat": {"lining": "0.5 mm", "ambient": "20 degC", "cooling": 2.5}}
EVENT = {"motor_inertia": 0.05, "shaft_stiffness": 4000, "event": {"kind": "stop", "stop_time": 0.01, "duration": 0.01}}
# 965 rpm through the gear; discs of 3 mm, less the lining of 0.5 mm each
INNER, OUTER = (float(MACHINE["friction_group"][f"{end}_radius"].split()[0]) / 1e3 for end in ("inner", "outer"))
MASS = 7850 * MACHINE["friction_group"]["pairs"] * 2.5e-3 * math.pi * (OUTER**2 - INNER**2)
QUICK = {
    "simulate": ["--set", "drive.event.duration=0.002"],
    "tolerance": ["--set", "tolerance.samples=2000", "--set", "tolerance.sobol_base=64"],
}
GIVEN = {"drive": {"speed": "482.5 rpm"}, "heat": {"disc_mass": MASS, **STEEL}}


def told(answer):
    result, found = answer
    return result.to_dict(), [each.code for each in found if "-from-" in each.code or each.code == "discs-of-steel"]


@pytest.mark.parametrize(
    ("analysis", "drive", "codes"),
    [
        (heat, {"cut_off": 0.3}, ["speed-from-plate", "discs-of-steel", "discs-from-layout"]),
        (effects, {}, ["speed-from-plate"]),
        (
            lambda own: simulate(own, heated=True), EVENT,
            ["speed-from-plate", "inertia-from-layout", "discs-of-steel", "discs-from-layout"],
        ),
    ],
)  # fmt: skip
def test_what_the_file_has_is_taken_and_said_once(analysis, drive, codes):
    data = merged(MACHINE, {**GEAR, "drive": drive})
    result, said = told(analysis(build(make_spec(data))))
    assert said == codes
    own, none = told(analysis(build(make_spec(merged(data, GIVEN)))))
    assert [code for code in none if code != "inertia-from-layout"] == []
    assert json.loads(json.dumps(result), parse_float=lambda text: f"{float(text):.9g}") == json.loads(
        json.dumps(own), parse_float=lambda text: f"{float(text):.9g}"
    )


def test_the_curve_of_a_motor_tells_the_speed_before_its_plate_does():
    motor = {"breakdown_torque": 200, "breakdown_slip": 0.15, "synchronous_speed": "1000 rpm"}
    own = build(make_spec(merged(MACHINE, {"drive": {**EVENT, "motor": motor}})))
    assert [*speed_findings(own.spec)] == []
    assert 0.85 < train_of(own).speed / (1000 * math.pi / 30) < 1


@pytest.mark.parametrize(("command", "example", "keys"), REFUSED["missing"])
def test_what_is_missing_is_asked_for_at_once_with_lines_that_may_be_pasted(command, example, keys, afmcalc, tmp_path):
    ended = afmcalc(command, f"example:{example}")
    assert (ended.code, ended.err.count("error: ")) == (2, 2)
    kind = "tolerance" if command == "tolerance" else "drive"
    asked, how = (part.partition("\n") for part in ended.err.split("error: ")[1:])
    assert f"afmcalc init --kind {kind}" in how[0]
    assert all(key in "".join(asked) for key in keys)
    data = tomllib.loads((CONFIGS / f"{example}.toml").read_text(encoding="utf-8"))
    spec = tmp_path / "pasted.json"
    spec.write_text(json.dumps(merged(data, tomllib.loads(how[2]))), encoding="utf-8")
    assert afmcalc(command, spec, *QUICK.get(command, ())).code == 0


def test_estimates_have_three_digits_for_people_and_all_for_programs(afmcalc):
    arguments = ("simulate", "example:machine-clutch", "--set", "drive.cut_off=0.5")
    energy = afmcalc(*arguments, "--json").json["result"]["energy"]["min"]
    torque = afmcalc("torque", "example:machine-clutch", "--json").json["result"]["torque"]["min"]
    assert energy == pytest.approx(torque * 965 * math.pi / 30 * 0.5)
    assert "4.3 " in next(line for line in afmcalc(*arguments).out.splitlines() if line.startswith("Q "))
    materials = afmcalc("list", "materials", "--json").json["result"]["materials"]
    assert materials[0]["temperature_max"] == 533.15


DEFAULT = tomllib.loads((CONFIGS / "default.toml").read_text(encoding="utf-8"))
# the base clutch by hand: T(f) = F R z f/(1 + z_2 C f), F 2 kN, R 100 mm, z 8, z_2 C 3.5; margin 1.25
LOW, HIGH = (1600 * f / (1 + 3.5 * f) for f in (0.1, 0.8))
PLATE = {"power": "3 kW", "speed": "1430 rpm", "ratio": 5, "efficiency": 0.9}
RATED = 3000 / (1430 * math.pi / 30) * 5 * 0.9
DRIVE = {
    "speed": "286 rpm", "motor_inertia": 1.5, "driven_inertia": 0.01, "shaft_stiffness": 4000,
    "event": {"kind": "stop", "stop_time": 0.01},
}  # fmt: skip


def checked(**blocks):
    answers = Answers(build(make_spec(DEFAULT | blocks)))
    result, findings = answers.ask("check")
    rows, found = {row.name: row for row in result.checks}, {each.code: each for each in findings}
    return answers, rows, result.requirements, found


def test_the_torque_of_a_plate():
    """9550 P/n to the four digits that 9550 has; it is a requirement, a row, and the load before an event."""
    answers, limits, (required,), findings = checked(machine=PLATE)
    torque = answers.ask("torque")[0]
    assert torque.motor_torque == pytest.approx(9550 * 3 / 1430, rel=1e-4)
    assert torque.torque_asked_for == pytest.approx(RATED, rel=1e-12)
    assert torque.starting_torque is None
    assert (required.value, required.passed) == (answers.clutch["machine_torque"], True)
    assert (required.value, required.limit) == (pytest.approx(LOW / 1.25), pytest.approx(RATED))
    assert limits["torque that the machine asks for"].utilisation == pytest.approx(RATED / LOW)
    assert findings["service-factor-assumed"].value == 1
    heavy = PLATE | {"service_factor": 1.5}
    clutch = build(make_spec(DEFAULT | {"machine": heavy, "drive": DRIVE}))
    result, told = check_at_once(Answers(clutch))
    (required,), findings = result.requirements, {each.code: each for each in told}
    assert not {"service-factor-assumed"} & set(findings)
    assert (findings["requirement-missed"].level, findings["machine-not-driven"].level) == ("error", "warning")
    assert findings["machine-not-driven"].limit == required.limit == pytest.approx(1.5 * RATED)
    # without a load of its own the motor runs at its rated torque
    assert train_of(clutch).load == pytest.approx(RATED)


def test_a_direct_start_slips_or_not():
    for start, said in ((LOW - 0.01, False), (LOW + 0.01, True)):
        _, limits, _, findings = checked(machine=PLATE | {"starting_torque_ratio": start / RATED})
        row = limits["torque of a direct start"]
        assert (row.value, row.limit) == (pytest.approx(start), pytest.approx(LOW))
        assert row.grade == ("note" if said else "pass")
        assert ("slips-at-start" in findings) == said


def test_a_shaft_by_its_diameter_lives_as_one_by_its_modulus(afmcalc):
    part = DEFAULT["fatigue"] | {"polar_section_modulus": None}
    own = build(make_spec(DEFAULT | {"fatigue": part | {"polar_section_modulus": math.pi * 0.03**3 / 16}}))
    by_diameter = build(make_spec(DEFAULT | {"fatigue": part, "shaft": {"diameter": 0.03}}))
    assert life(by_diameter)[0] == life(own)[0]
    assert make_spec(resolved(by_diameter.spec)) == by_diameter.spec
    moduli = ",".join(str(math.pi * diameter**3 / 16) for diameter in (0.03, 0.04))
    swept = ("shaft.diameter=0.03,0.04", f"fatigue.polar_section_modulus={moduli}")
    found = [afmcalc("life", "example:machine-clutch", "--sweep", each, "--json").json["result"] for each in swept]
    lives = [result["sweep"][0]["unprotected"] for result in found]
    assert lives[0] == pytest.approx(lives[1])


def test_a_shaft_yields_by_von_mises():
    """At T_max times the dynamic factor, or at the peak of the event; 400 MPa over √3 at the diameter that it says."""
    modulus = HIGH * 1.4 / (400e6 / math.sqrt(3))
    diameter = (16 * modulus / math.pi) ** (1 / 3)
    name = "largest stress of the shaft, by von Mises"
    for factor, verdict in ((1 - 1e-6, "fail"), (1 + 1e-6, "pass")):
        shaft = {"diameter": diameter * factor, "yield_strength": "400 MPa"}
        _, limits, _, findings = checked(shaft=shaft, fatigue=None)
        assert limits[name].grade == verdict
        assert ("shaft-yields" in findings) == (verdict == "fail")
        assert name not in checked(shaft={"diameter": diameter}, fatigue=None)[1]


@pytest.mark.slow
def test_a_shaft_is_held_against_the_peak_of_the_event():
    answers, limits, _, _ = checked(shaft={"diameter": 0.04, "yield_strength": 4e8}, fatigue=None, drive=DRIVE)
    peak = answers.ask("simulate")[0].peak_torque.max
    assert peak > HIGH
    own = limits["largest stress of the shaft in the event, by von Mises"]
    assert own.value == pytest.approx(16 * peak / (math.pi * 0.04**3))


SPACE = tomllib.loads((CONFIGS / "envelope.toml").read_text(encoding="utf-8"))


def test_a_hub_is_bored_for_its_shaft():
    """Without a bore of its own, and never narrower."""
    free = {name: value for name, value in SPACE["envelope"].items() if name != "bore"}
    shaft = {"shaft": {"diameter": "30 mm"}, "fatigue": None}
    by_shaft = Answers(build(make_spec(SPACE | shaft | {"envelope": free}))).ask("layout")[0]
    by_bore = Answers(build(make_spec(SPACE | shaft | {"envelope": free | {"bore": "30 mm"}}))).ask("layout")[0]
    assert by_shaft == by_bore
    assert by_shaft.mass < Answers(build(make_spec(SPACE | {"envelope": free}))).ask("layout")[0].mass
    for wrong in ({"bore": "29 mm"}, {"outer_diameter": "30 mm"}):
        with pytest.raises(SpecError, match="shaft.diameter"):
            make_spec(SPACE | shaft | {"envelope": free | wrong})
