"""The command: findings, sweeps, tolerances, history, the spec it writes."""

import csv
import io
import json
import math

import numpy as np
import pytest
from conftest import CONFIGS
from drives import REFERENCE, VARIANTS, begun, clutch, light, merged, plant, run

from afmcalc.analysis.simulate import dynamic_factors, simulate
from afmcalc.analysis.sweep.axes import parse_axis
from afmcalc.analysis.tolerance.study import DRIVES, tolerance
from afmcalc.drive.cases import case_of, outcome_of
from afmcalc.engines import build
from afmcalc.equations import drive as law

FATIGUE = {"endurance_limit": 4e8, "polar_section_modulus": 15e-6, "exponent": 6, "base_cycles": 1e7}
INDIRECT = {
    "variant": "indirect",
    "closing_spring": {"stiffness": 2e4},
    "control_spring": {"stiffness": 1e4},
    "control_unit": {"gain": 1.0, "hub_diameter": 0.05, "key_friction": 0.15},
    "drive": {"hub_inertia": 0.02, "event": {"duration": 0.05}},
}


def codes(own, **options):
    return {found.code: found for found in simulate(own, **options)[1]}


@pytest.mark.slow
def test_motor_too_strong_for_the_clutch():
    told = codes(light(drive={"motor_torque": 210.0}))
    assert (told["motor-never-stops"].level, told["motor-never-stops"].path) == ("error", "drive.cut_off")
    result, findings = simulate(light(drive={"motor_torque": 210.0, "cut_off": 0.3}))
    told = {found.code: found for found in findings}
    assert told["motor-stops-at-cut-off"].level == "info"
    assert "motor-never-stops" not in told
    assert result.slip_energy.min > 200 * 15 * 0.3


@pytest.mark.parametrize(
    "changes", [VARIANTS["conventional"], *(pytest.param(each, marks=pytest.mark.slow) for each in (INDIRECT,))]
)
def test_sweep_is_what_single_runs_give(changes):
    own = light(**changes)
    axis = parse_axis("drive.shaft_stiffness=5000,8000,12000", own.spec)
    sweep = simulate(own, sweeps=[axis])[0].sweep
    assert sweep is not None
    for number, stiffness in enumerate((5000.0, 8000.0, 12000.0)):
        single = light(**merged(changes, {"drive": {**changes.get("drive", {}), "shaft_stiffness": stiffness}}))
        assert sweep[0].peak_torque_max[number] == pytest.approx(outcome_of(single, 0.8).trip.peak, rel=2e-3)
        behind = 0.05 + changes.get("drive", {}).get("hub_inertia", 0.0)
        assert sweep[0].inertia_torque[number] == pytest.approx(15 * math.sqrt(stiffness * behind))


@pytest.mark.slow
def test_peaks_over_tolerances():
    """Samples of the peak against single runs at their quantiles: the peak rises with friction alone."""
    spread = {"friction": {"distribution": "uniform"}}
    own = light(tolerance={"fields": spread, "quantiles": [0.25, 0.5, 0.75]}, requirements={"peak_torque": 600.0})
    result, _ = tolerance(own)
    assert result.method == "exact"
    assert result.peak_samples == DRIVES
    assert result.peak_quantiles is not None
    for row in result.peak_quantiles:
        single = outcome_of(own, 0.1 + 0.7 * row.probability).trip.peak
        assert row.peak_torque == pytest.approx(single, abs=4 * row.standard_error + 1e-3 * single)
    frictions = np.linspace(0.1, 0.8, 8)
    peaks = [outcome_of(own, float(friction)).trip.peak for friction in frictions]
    share = 1 - (np.interp(600.0, peaks, frictions) - 0.1) / 0.7
    assert result.probability_peak_above == pytest.approx(share, abs=0.03)


@pytest.mark.parametrize(("share", "grows"), [(0.9, True), (1.1, False)])
def test_v6_judder(share, grows):
    """A slow slip on a falling characteristic: swings grow where the shaft damps less than the friction drives."""
    pack = {"static_ratio": 1.2, "decay_rate": 0.1 / 0.3}
    sliding = 200.0
    needed = law.judder_damping(sliding, 0.1, 1.2, 0.3)
    drive = plant(sliding, pack=pack, motor_inertia=1e12, time=0.0, damping=share * needed)
    creep, swing = 0.02, 1e-4
    torque = sliding * (1 + 0.2 * math.exp(-creep / 3))
    found = run(begun(drive, creep, 0.0, (torque + swing) / 8000, 0.0, 4000.0), 0.2, recorded=True)
    late = max(abs(row.torque_shaft - torque) for row in found.history if row.time > 0.17)
    early = max(abs(row.torque_shaft - torque) for row in found.history if row.time < 0.03)
    assert (late > early) == grows
    assert found.slip_time == pytest.approx(0.2), "and slips all the time"


def test_the_command(afmcalc, tmp_path):
    spec = tmp_path / "drive.json"
    spec.write_text(json.dumps(merged(REFERENCE, {"name": "x", "drive": {"motor_inertia": 0.2}})), encoding="utf-8")
    history, written = tmp_path / "history.csv", tmp_path / "factor.toml"
    ended = afmcalc("simulate", spec, "--json", "--history", history, "--output", written)
    assert ended.code == 0
    rows = list(csv.DictReader(io.StringIO(history.read_text(encoding="utf-8"))))
    assert {row["friction [1]"] for row in rows} == {"0.1", "0.3", "0.8"}
    last = [row for row in rows if row["friction [1]"] == "0.8"]
    peak = ended.json["result"]["peak_torque"]["max"]
    assert max(float(row["torque_shaft [N*m]"]) for row in last) == pytest.approx(peak, rel=1e-9)
    assert float(last[-1]["speed_motor [rad/s]"]) == pytest.approx(0, abs=2)
    factor = ended.json["result"]["dynamic_factor"]["min"]
    assert afmcalc("torque", written, "--json").json["spec"]["drive"]["dynamic_factor"] == pytest.approx(factor)
    assert afmcalc("simulate", spec, "--history", spec).code == 2
    drawn = afmcalc("simulate", spec, "--plot").out
    assert "Travel" not in drawn
    assert "Torque in the shaft" in drawn


def test_check_holds_the_peak_against_the_requirement(afmcalc):
    light = [CONFIGS / "drive.toml", "--set", "drive.motor_inertia=0.1", "--json"]
    ended = afmcalc("check", *light, "--set", "requirements.peak_torque=300")
    row, *_ = ended.json["result"]["requirements"]
    assert (ended.code, row["requirement"]) == (1, "peak_torque")
    assert row["value"] == pytest.approx(afmcalc("simulate", *light).json["result"]["peak_torque"]["max"])


@pytest.mark.slow
def test_above_the_gain_limit_the_peak_judged_is_that_of_the_bypass_pairs(afmcalc):
    """Which are, before the balls take over, an ordinary clutch of one pair."""
    own = [
        *("--set", "control_unit.gain=5", "--set", "friction.max=0.8", "--set", "drive.motor_inertia=0.05"),
        *("--set", "drive.load_torque=20"),
    ]  # fmt: skip
    made = afmcalc("check", CONFIGS / "drive.toml", *own, "--set", "requirements.peak_torque=250", "--json").json
    row, *_ = made["result"]["requirements"]
    spec = made["spec"]
    ordinary = {key: spec[key] for key in ("friction", "closing_spring", "drive")} | {
        "variant": "conventional",
        "friction_group": {"pairs": 1, "mean_radius": 0.1},
    }
    single = simulate(build(ordinary))[0].peak_torque.max
    assert row["value"] == pytest.approx(single, rel=1e-6)
    slipping = afmcalc("simulate", CONFIGS / "drive.toml", *own, "--json").json
    assert slipping["result"]["peak_torque"]["max"] < single
    assert slipping["result"]["peak_torque_bypass"] == row["value"]
    assert "bypass-peak" in {each["code"] for each in slipping["findings"]}
    # the same peak in the column of a sweep, none where the balls hold first; the dynamic factor of a life is by it
    swept = afmcalc("simulate", CONFIGS / "drive.toml", *own, "--sweep", "control_unit.gain=0.5,5", "--json").json
    below, above = swept["result"]["sweep"][0]["peak_torque_bypass"]
    assert (below, above) == (None, pytest.approx(single, rel=1e-3))
    factor = single / slipping["result"]["sliding_torque"]["max"]
    lasting = afmcalc("life", CONFIGS / "drive.toml", *own, "--json").json["result"]
    assert lasting["dynamic_factor"] == pytest.approx(factor, rel=1e-6)
    assert dynamic_factors(build(spec))[0] == pytest.approx(factor, rel=1e-3)


def test_a_load_that_is_carried_but_for_rounding_is_carried():
    """Margin 1: a load of T_н, which is also what the clutch carries at f_min."""
    own = light()
    carried = case_of(own, own.friction[0].min).plant.breakaway
    assert "slips-before-event" not in codes(light(drive={"load_torque": carried * (1 + 1e-12)}))
    assert "slips-before-event" in codes(light(drive={"load_torque": carried * (1 + 1e-6)}))


def test_a_slow_stop_loads_the_shaft_by_its_deceleration_whatever_the_stiffness():
    """V4 to its end: T + J_2 a + √(J_2 a [J_2 a + 2 (T − T_0)]), 292.45 N·m at f_min, at four stiffnesses alike."""
    slow = {"motor_inertia": 1e6, "damping_ratio": 0.0, "event": {"stop_time": 0.025, "duration": 0.1}}
    peaks, friction = [], 0.1
    for stiffness in (8e3, 32e3):
        own = clutch(friction={"static_ratio": 1.0}, drive={**slow, "shaft_stiffness": stiffness})
        found = outcome_of(own, friction)
        torque, steady = found.case.plant.sliding, 0.05 * 15 / 0.025
        peaks.append(found.trip.peak)
        assert found.trip.peak == pytest.approx(torque + steady + math.sqrt(steady * (steady + 2 * (torque - 150))))
        said = codes(own)["inertia-torque"]
        assert said.value == pytest.approx(30 + math.sqrt(30 * (30 + 2 * (375 - 150))))
        assert "a softer shaft does not lower it" in said.message
        assert "only a softer shaft" not in said.message
    assert peaks == pytest.approx([292.45] * 2, abs=5e-3)


@pytest.mark.slow
def test_a_sudden_stop_loads_the_shaft_by_the_speed_of_all_behind_the_discs():
    """ω_0 √(k (J_2 + J_h)) bounds what is beyond the clutch's own peak, and J_2 alone does not."""
    sudden = {"motor_inertia": 1e4, "damping_ratio": 0.0, "event": {"stop_time": 0.0, "duration": 0.1}}
    direct = light(friction={"static_ratio": 1.0}, drive={**sudden, "driven_inertia": 0.1})
    sleeved = light(**merged(INDIRECT, {"friction": {"static_ratio": 1.0}, "drive": {**sudden, "hub_inertia": 0.05}}))
    bound = 15 * math.sqrt(8000 * 0.1)
    for own in (direct, sleeved):
        said = codes(own)["inertia-torque"]
        assert said.value == pytest.approx(bound)
        assert "softer shaft" in said.message
    found, held = outcome_of(direct, 0.1), outcome_of(sleeved, 0.1)
    assert found.trip.peak - found.case.plant.sliding == pytest.approx(bound, rel=1e-3)
    assert bound / math.sqrt(2) < held.trip.peak - held.case.plant.sliding < bound
