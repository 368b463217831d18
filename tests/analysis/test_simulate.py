"""The command: findings, sweeps, tolerances, history, the spec it writes."""

import csv
import io
import json
import math

import pytest
from conftest import CONFIGS, overrides
from drives import REFERENCE, VARIANTS, case, clutch, light, merged, run

from afmcalc.analysis.simulate import dynamic_factors, simulate
from afmcalc.analysis.sweep import parse_axis
from afmcalc.drive.cases import case_of, outcome_of
from afmcalc.engines import build
from afmcalc.equations import drive as law

FATIGUE = {"endurance_limit": 4e8, "polar_section_modulus": 15e-6, "exponent": 6, "base_cycles": 1e7}
INDIRECT = {
    "variant": "indirect", "closing_spring": {"stiffness": 2e4}, "control_spring": {"stiffness": 1e4},
    "control_unit": {"gain": 1.0, "hub_diameter": 0.05, "key_friction": 0.15},
    "drive": {"hub_inertia": 0.02, "event": {"duration": 0.05}},
}  # fmt: skip
SHORT = {"drive": {"event": {"duration": 0.05}}}


def codes(own, **options):
    return {found.code: found for found in simulate(own, **options)[1]}


@pytest.mark.parametrize("changes", [VARIANTS["conventional"] | SHORT, pytest.param(INDIRECT, marks=pytest.mark.slow)])
def test_sweep_is_what_single_runs_give(changes):
    own = light(**changes)
    axis = parse_axis("drive.shaft_stiffness=5000,8000,12000", own.spec)
    sweep = simulate(own, sweeps=[axis])[0].sweep
    for number, stiffness in enumerate((5000.0, 8000.0, 12000.0)):
        single = light(**merged(changes, {"drive": {"shaft_stiffness": stiffness}}))
        assert sweep[0].peak_torque_max[number] == pytest.approx(outcome_of(single, 0.8).event.peak, rel=1e-9)
        behind = 0.05 + changes.get("drive", {}).get("hub_inertia", 0.0)
        assert sweep[0].inertia_torque[number] == pytest.approx(15 * math.sqrt(stiffness * behind))


@pytest.mark.parametrize(("share", "grows"), [(0.9, True), (1.1, False)])
def test_v6_judder(share, grows):
    """In a slow slip on a falling characteristic, swings grow if the shaft damps less than the friction excites."""
    pack = {"static_ratio": 1.2, "decay_rate": 0.1 / 0.3}
    sliding = 200.0
    needed = law.judder_damping(sliding, 0.1, 1.2, 0.3)
    drive = case(sliding, pack=pack, motor_inertia=1e12, time=0.0, damping=share * needed)
    creep, swing = 0.02, 1e-4
    torque = sliding * (1 + 0.2 * math.exp(-creep / 3))
    found = run(drive, 0.2, slip=creep, driven=0.0, elastic=torque + swing)
    late = max(abs(row.torque_shaft - torque) for row in found.rows if row.time > 0.17)
    early = max(abs(row.torque_shaft - torque) for row in found.rows if row.time < 0.03)
    assert (late > early) == grows
    assert found.slip_time == pytest.approx(found.time, rel=1e-2), "and slips all the time"


def test_the_command(afmcalc, tmp_path):
    spec = tmp_path / "drive.json"
    spec.write_text(json.dumps(merged(REFERENCE, {"name": "x", "drive": {"motor_inertia": 0.2}})), encoding="utf-8")
    history, written = tmp_path / "history.csv", tmp_path / "factor.toml"
    ended = afmcalc("simulate", spec, "--json", "--history", history, "--save", written)
    assert ended.code == 0
    rows = list(csv.DictReader(io.StringIO(history.read_text(encoding="utf-8"))))
    assert {row["friction [1]"] for row in rows} == {"0.1", "0.3", "0.8"}
    last = [row for row in rows if row["friction [1]"] == "0.8"]
    peak = ended.json["result"]["peak_torque"]["max"]
    assert max(float(row["torque_shaft [N*m]"]) for row in last) == pytest.approx(peak, rel=1e-3)
    assert float(last[-1]["speed_motor [rad/s]"]) == pytest.approx(0, abs=2)
    factor = ended.json["result"]["dynamic_factor"]["min"]
    assert afmcalc("torque", written, "--json").json["spec"]["drive"]["dynamic_factor"] == pytest.approx(factor)


@pytest.mark.slow
def test_above_the_gain_limit_the_peak_judged_is_that_of_the_bypass_pairs(afmcalc):
    """Before the balls take over, the bypass pairs are an ordinary clutch of one pair."""
    sets = ["control_unit.gain=5", "friction.max=0.8", "drive.motor_inertia=0.05", "drive.load_torque=20"]
    own = [CONFIGS / "drive.toml", "--json", *overrides(*sets)]
    made = afmcalc("check", *own, "--set", "requirements.peak_torque=250").json
    (row, *_), spec = made["result"]["checks"], made["spec"]
    ordinary = {key: spec[key] for key in ("friction", "closing_spring", "drive")}
    ordinary |= {"variant": "conventional", "friction_group": {"pairs": 1, "mean_radius": 0.1}}
    single = simulate(build(ordinary))[0].peak_torque.max
    assert row["value"] == pytest.approx(single, rel=1e-6)
    slipping = afmcalc("simulate", *own).json
    assert slipping["result"]["peak_torque"]["max"] < single
    assert slipping["result"]["peak_torque_bypass"] == row["value"]
    assert "bypass-peak" in {each["code"] for each in slipping["findings"]}
    # a sweep has the same peak, or none where the balls hold first; the dynamic factor of a life follows from it
    swept = afmcalc("simulate", *own, "--sweep", "control_unit.gain=0.5,5").json
    assert swept["result"]["sweep"][0]["peak_torque_bypass"] == [None, pytest.approx(single, rel=1e-9)]
    factor = single / slipping["result"]["sliding_torque"]["max"]
    assert afmcalc("life", *own).json["result"]["dynamic_factor"] == pytest.approx(factor, rel=1e-6)
    assert dynamic_factors(build(spec))[0] == pytest.approx(factor, rel=1e-9)


def test_a_load_that_is_carried_but_for_rounding_is_carried():
    """With margin 1 the load is T_н, and the clutch carries just T_н at f_min."""
    own = light()
    carried = case_of(own, own.spec.friction.groups[0].min).pack.breakaway
    assert "slips-before-event" not in codes(light(drive={"load_torque": carried * (1 + 1e-12)}))
    assert "slips-before-event" in codes(light(drive={"load_torque": carried * (1 + 1e-6)}))


def test_a_slow_stop_loads_the_shaft_by_its_deceleration_whatever_the_stiffness():
    """V4 to its end: T + J_2 a + √(J_2 a [J_2 a + 2 (T − T_0)]), 292.45 N·m at f_min, at four stiffnesses alike."""
    slow = {"motor_inertia": 1e6, "damping_ratio": 0.0, "event": {"stop_time": 0.025, "duration": 0.05}}
    peaks, friction = [], 0.1
    for stiffness in (8e3, 32e3):
        own = clutch(friction={"static_ratio": 1.0}, drive={**slow, "shaft_stiffness": stiffness})
        found = outcome_of(own, friction)
        torque, steady = found.case.pack.sliding, 0.05 * 15 / 0.025
        peaks.append(found.event.peak)
        assert found.event.peak == pytest.approx(
            torque + steady + math.sqrt(steady * (steady + 2 * (torque - 150))), rel=1e-3
        )
        said = codes(own)["inertia-torque"]
        assert said.value == pytest.approx(30 + math.sqrt(30 * (30 + 2 * (375 - 150))))
    assert peaks == pytest.approx([292.45] * 2, abs=5e-3)
