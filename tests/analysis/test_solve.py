"""Sweeps: each point is a single calculation. Solving: every root that a dense scan finds, whole keys, events, the file."""

import random
from contextlib import suppress

import numpy as np
import pytest
from random_clutches import random_clutches
from sources import REFUSED

from afmcalc import errors, load
from afmcalc.analysis.registry import ANALYSES
from afmcalc.analysis.solve import SEVERAL, parse_target, solve
from afmcalc.engines import build
from afmcalc.engines.evaluate import evaluate
from afmcalc.equations.terms import TERMS
from afmcalc.spec import make_spec, read_spec
from afmcalc.spec.edit import respecified, value_at, with_key
from afmcalc.spec.keys import ALIASES, is_whole

KEYS = ("C", "F", "z", "z1", "R", "c1", "c2", "gain_slope", "f_max", "f1", "d", "T_n", "alpha", "beta")
AIMS = ("accuracy_factor", "accuracy_factor_peak", "nominal_torque", "torque_max", "torque_min", "scatter", "closing_force",
        "travel_max", "control_force", "torque_at_f_mean", "normal_force_at_f_max", "torque_at_setting", "reduced_gain")  # fmt: skip


def scan(spec, path, target, low, high):
    """Return many values of a key and the target there; NaN where the gain is above its limit."""
    dense = np.union1d(np.linspace(low, high, 4001), np.geomspace(max(low, high / 1e6), high, 4001))
    at = np.arange(low, high + 1) if is_whole(path) else dense
    with np.errstate(all="ignore"):
        many = build(with_key(spec, path, at))
        value = np.broadcast_to(np.asarray(many[target], float), at.shape)
        if spec.kind.gain_limit:
            value = np.where(many["gain"] <= np.asarray(many["gain_limit"]) * (1 + 1e-9), value, np.nan)
    return at, value


def questions(seed):
    """Yield random clutches, each with one of its keys, a target that depends on this key, and a wanted value."""
    rnd = random.Random(seed)
    for data in random_clutches(10**6, seed):
        with suppress(errors.AfmcalcError):
            clutch = build(spec := make_spec(data))
            name = rnd.choice([key for key in KEYS if value_at(spec, ALIASES[key]) is not None])
            target, path = rnd.choice(AIMS), ALIASES[name]
            if target not in clutch or (spec.kind.gain_limit and clutch.gain > clutch.gain_limit):
                continue
            now = value_at(spec, path)
            near = round(0.8 * now) if is_whole(path) else 0.8 * now
            here, there = (float(build(respecified(spec, {path: at}))[target]) for at in (now, near))
            if abs(there - here) > 1e-9 * here:
                yield spec, name, target, rnd.choice([here * rnd.choice([0.3, 0.9, 1.1, 4]), there])


def judge(spec, name, target, wanted):
    """Compare an answer with the scan over the range that solve looked at; return the kind of the answer."""
    path = ALIASES[name]
    result, solved, findings = solve(build(spec), name, target, wanted)
    at, value = scan(spec, path, target, result.low, result.high)
    roots, gap = [root.value for root in result.roots], value - wanted
    best = np.nanmin(np.abs(gap))
    if not roots:
        assert findings[-1].code == "not-attainable"
        assert abs(result.reached - wanted) <= best + 1e-6 * wanted
        assert best > 1e-9 * wanted
        return "none"
    assert result.value in roots
    again = build(make_spec(solved.spec.model_dump(exclude_none=True)))
    assert again[target] == pytest.approx(result.reached, rel=1e-9)
    apart = np.minimum(np.abs(gap[:-1]), np.abs(gap[1:])) > 1e-10 * wanted
    crossed = np.flatnonzero((gap[:-1] * gap[1:] < 0) & apart)
    if is_whole(path):
        on = {*at[np.abs(gap) <= 1e-12 * wanted]}
        assert {*roots} == {*at[crossed], *at[crossed + 1], *on}
        return "whole"
    assert all(root.reached == pytest.approx(wanted, rel=1e-8) for root in result.roots)
    now = value_at(spec, path)
    assert abs(result.value - now) == min(abs(root - now) for root in roots), "the nearest"
    for low, high in zip(at[crossed], at[crossed + 1], strict=True):
        fine = scan(spec, path, target, low, high)[1]
        jumps = np.max(np.abs(np.diff(fine))) > 0.5 * abs(fine[-1] - fine[0])
        assert jumps or any(low * (1 - 1e-9) <= root <= high * (1 + 1e-9) for root in roots), f"a root at {low}"
    return "several" if len(roots) > 1 else "one"


def test_both_sides_of_an_optimum():
    """S22: by the published torque K_т,act is best at zC = 1/f_max; beside it two gains give what is wanted, however near."""
    clutch = build(read_spec("example:all-driving", {"C": 0.3}))
    best, _, _ = solve(clutch, "C", "accuracy_factor_actual", 1.0)
    assert best.value == pytest.approx(1 / 0.8 / 4, rel=1e-4)
    for above in (1e-8, 1e-3, 0.1):
        result, _, _ = solve(clutch, "C", "accuracy_factor_actual", best.reached * (1 + above))
        first, second = (root.value for root in result.roots)
        assert first < 1 / 0.8 / 4 < second
        assert result.value == min((first, second), key=lambda gain: abs(gain - 0.3))


@pytest.mark.parametrize("count", [8, pytest.param(40, marks=pytest.mark.slow)])
def test_all_that_a_dense_scan_finds(count):
    seen = {}
    for _, question in zip(range(count), questions(3), strict=False):
        try:
            kind = judge(*question)
        except AssertionError as wrong:
            raise AssertionError(f"{question}: {wrong}") from wrong
        seen[kind] = seen.get(kind, 0) + 1
    assert {"one", "none", "whole"} <= {*seen}, seen


# T = F R z f/(1 + z_2 C f), z = 8 with one bypass pair, R = 0.1, F = 2000, C = 0.5, f = 0.1 ... 0.8
CLOSED = [
    ("C", "accuracy_factor=2", "example:default", 15 / 14),  # 8 (1 + 0.7 C)/(1 + 5.6 C) = 2
    ("F", "T_н=250 N*m", "example:default", 250 * 1.35 / 0.08),
    ("control_unit.gain", "gain_limit=1.25", "example:default", None),
    ("F", "torque_at_f_max=500", "example:default", 500 * 3.8 / 0.64),
    ("F", "closing_spring.force=3 kN", "example:default", 3000),
    ("R", "ΔT=300", "example:default", 0.1 * 300 / (1280 / 3.8 - 160 / 1.35)),
]


@pytest.mark.parametrize(("name", "target", "spec", "value"), CLOSED)
def test_by_hand(name, target, spec, value):
    clutch = build(read_spec(spec))
    if value is None:
        with pytest.raises(errors.CalculationError, match="does not depend"):
            solve(clutch, name, *parse_target(target)[:2])
        return
    assert solve(clutch, name, *parse_target(target)[:2])[0].value == pytest.approx(value, rel=1e-12)


def test_nothing_attains_it():
    """Within C = 1/(z_1 f_1max) the best K_т is 8 (1 + 7·1.25·0.1)/(1 + 7·1.25·0.8) = 1.875; past it there is an answer."""
    result, _, findings = solve(build(read_spec("example:default")), "C", "accuracy_factor", 1.0)
    assert (result.roots, result.value, findings[-1].code) == ([], 1.25, "not-attainable")
    assert result.reached == findings[-1].value == pytest.approx(1.875)
    with pytest.raises(errors.CalculationError, match="the nearest is 1.875, at C = 1.25"):
        load("example:default").solve("accuracy_factor", 1.0)
    past = load("example:default").solve("accuracy_factor", 1.5, beyond_limit=True)
    assert past.value == pytest.approx(6.5 / 2.8)  # 8 (1 + 0.7 C) = 1.5 (1 + 5.6 C)


def test_a_whole_key_has_whole_values(afmcalc):
    """T_max = 2000·0.1·z·0.8/(1 + 0.4 (z − 1)) is nearest to 300 N·m with 4 and 5 pairs; 4 keep it at most 300."""
    result = afmcalc("solve", "torque_max=300", "--for", "z", "--json").json["result"]
    roots = [(z, pytest.approx(160 * z / (1 + 0.4 * (z - 1)))) for z in (4, 5)]
    assert [(root["value"], root["reached"]) for root in result["roots"]] == roots
    assert result["value"] == 4
    least = afmcalc("solve", "nominal_torque=80", "--for", "z", "--json").json
    assert (least["result"]["value"], least["spec"]["friction_group"]["pairs"]) == (5, 5)


def test_a_range_of_values_is_said_to_be_one():
    """With a slope above C_1*, the largest torque is that of the setting for every c_1 up to 1240 N/mm."""
    overrides = {"control_unit.pocket": None, "control_unit.gain_slope": 900}
    result, _, findings = solve(build(read_spec("example:constant-torque", overrides)), "c1", "torque_max", 160.0)
    assert [root.reached for root in result.roots] == pytest.approx([160, 160])
    assert result.roots[1].value == pytest.approx(1.24e6, rel=0.03)
    assert "solve-range" in [each.code for each in findings]


def test_rounding_makes_no_roots():
    """Pockets of constant torque have no scatter whatever the gain, so rounding errors must not count as roots."""
    result, _, findings = solve(build(read_spec("example:constant-torque")), "C", "scatter", 0.0)
    assert ([root.value for root in result.roots], findings[-1].code) == ([result.low, result.high], "solve-range")


def test_a_jump_is_no_root():
    """The next standard ball makes the pocket deeper by a jump: no depth between is attainable."""
    clutch = build(read_spec("example:indirect", {"control_unit.ball_diameter": None}))
    at, depth = scan(clutch.spec, "control_spring.stiffness", "pocket_depth", 1e4, 1e7)
    jump = np.argmax(np.abs(np.diff(depth)))
    wanted = float(depth[jump] + 1e-3 * (depth[jump + 1] - depth[jump]))
    result, _, findings = solve(clutch, "c2", "pocket_depth", wanted)
    assert (result.roots, findings[-1].code) == ([], "not-attainable")


LIFE = ["drive.dynamic_factor=2", "drive.event="]


def test_force_for_a_life():
    """N = N_0 (τ_limb/τ_eq)^m with τ_eq = k_д (T_min + T_max)/2 W; a life above N_0 is unlimited, so no root."""
    spec = read_spec("example:drive", LIFE)
    result, _, _ = solve(build(spec), "F", "cycles", 1e6)
    per_force = sum(0.1 * 8 * f / (1 + 7 * 0.5 * f) for f in (0.1, 0.8)) / 2
    assert result.value == pytest.approx(400e6 * (1e7 / 1e6) ** (1 / 6) * 15e-6 / 2 / per_force, rel=1e-6)
    own = respecified(spec, {"closing_spring.force": result.value}).model_dump(exclude_none=True)
    assert load(own)["cycles"] == pytest.approx(1e6)
    assert load(own).with_(F=100)["cycles"] == np.inf
    none, _, _ = solve(build(spec), "F", "cycles", 1e8)
    assert (none.roots, none.reached) == ([], pytest.approx(1e7, rel=1e-6))


@pytest.mark.slow
def test_a_peak_of_an_event():
    spec = read_spec("example:drive", ["drive.event.duration=0.05"])
    result, solved, _ = solve(build(spec), "F", "peak_torque", 450.0)
    assert load(solved.spec.model_dump(exclude_none=True)).simulate().judged_peak == pytest.approx(450, rel=1e-4)
    assert 0.2 * 2000 < result.value < 2000


@pytest.mark.slow
def test_a_probability_that_falls_steeply_is_met():
    """The root has the probability of the tolerance study; a change of 5 % between two samples is no jump."""
    clutch = build(read_spec("example:tolerance", ["tolerance.samples=5000"]))
    result, solved, _ = solve(clutch, "C", "exceedance", 0.05)
    (root,) = result.roots
    assert root.reached == pytest.approx(0.05, rel=0.02)
    assert ANALYSES["tolerance"].function(solved)[0].probability_above_limit == root.reached


def test_the_file_has_the_value_found(afmcalc, tmp_path):
    file = tmp_path / "solved.toml"
    run = afmcalc("solve", "accuracy_factor=2", "--for", "C", "--save", file, "--json")
    assert read_spec(file).control_unit.gain == pytest.approx(run.json["result"]["value"])
    assert load(file)["accuracy_factor"] == pytest.approx(2)
    assert afmcalc("solve", "accuracy_factor=2", "--save", file).code == 2, "it exists"
    none = afmcalc("solve", "accuracy_factor=1", "--save", tmp_path / "none.toml", "--json")
    assert (none.code, none.json["result"]["roots"], (tmp_path / "none.toml").exists()) == (2, [], False)


def test_a_force_replaces_the_torque_it_was_set_for(afmcalc):
    run = afmcalc("solve", "--for", "F", "nominal_torque=250", "--set", "F=", "--set", "T_n=100", "--json").json
    assert "nominal_torque" not in run["spec"]["adjustment"]
    assert "solve-replaces" in [finding["code"] for finding in run["findings"]]


@pytest.mark.parametrize("arguments", REFUSED["solve"])
def test_what_cannot_be_asked(arguments, afmcalc):
    run = afmcalc("solve", *arguments.split())
    assert (run.code, run.out) == (2, "")


def test_every_number_of_a_clutch_can_be_wanted():
    """Every quantity is a target by its name; the error for one that the clutch lacks names what it needs."""
    clutch = build(read_spec("example:indirect"))
    for name in TERMS.keys() - SEVERAL:
        if TERMS[name].unit:
            assert parse_target(f"{name}=1")[0] == name
    with pytest.raises(errors.AfmcalcError, match="mean_pressure needs inner_radius, outer_radius"):
        solve(clutch, "F", "mean_pressure", 1e6)


SHAFT = [f"--set=fatigue.{key}" for key in ("endurance_limit=20MPa", "polar_section_modulus=15cm^3", "base_cycles=1e7")]


def test_a_value_of_a_step_is_reached_and_an_unlimited_life_is_empty(afmcalc):
    assert afmcalc("solve", "ball_diameter_standard=0.025", "--for", "C", "--json").json["result"]["roots"]
    run = afmcalc("accuracy", *SHAFT, "--sweep", "F=500,3000", "--columns", "cycles", "--json")
    assert [each is None for each in run.json["result"]["sweep"][0]["cycles"]] == [True, False]


@pytest.mark.slow
def test_a_life_beside_an_event_takes_its_dynamic_factor(afmcalc, tmp_path):
    """The solved spec passes the check that requires the life; the quantity by itself needs a given dynamic factor."""
    with pytest.raises(LookupError, match="drive.dynamic_factor"):
        load("example:drive")["cycles"]
    life, found = (*SHAFT, "--set=requirements.cycles=1e6"), str(tmp_path / "found.toml")
    afmcalc("solve", "cycles=1e6", "--for", "F", "example:drive", *life, "--save", found)
    rows = afmcalc("check", found, "--json").json["result"]["checks"]
    assert [row["value"] for row in rows if row["path"] == "requirements.cycles"] == pytest.approx([1e6], rel=1e-3)


def test_sweep_is_the_single_calculations(afmcalc):
    sweep = afmcalc("accuracy", "--sweep", "z=4,8,16", "--sweep", "C=0.2:1:3", "--json").json["result"]["sweep"]
    assert [entry["parameter"] for entry in sweep] == ["z", "C"]
    assert [entry["path"] for entry in sweep] == ["friction_group.pairs", "control_unit.gain"]
    assert len(sweep[0]["values"]) == 9
    for index, (z, c) in enumerate(zip(sweep[0]["values"], sweep[1]["values"], strict=True)):
        single = ["--set", f"z={z:g}", "--set", f"C={c!r}", "--json"]
        torque, accuracy = (afmcalc(command, *single).json["result"] for command in ("torque", "accuracy"))
        assert sweep[0]["accuracy_factor"][index] == accuracy["accuracy_factor"]
        assert sweep[1]["nominal_torque"][index] == torque["nominal_torque"]
        assert sweep[1]["torque_max"][index] == torque["torque"]["max"]


def test_any_quantity_is_a_column(afmcalc):
    """This holds in JSON, table and CSV; a name that is no quantity, or a quantity that is no number, is refused."""
    asked = ["accuracy", "example:indirect", "--sweep", "R=0.08,0.1", "--columns", "travel_max,normal_force_at_f_max"]
    (entry,) = afmcalc(*asked, "--json").json["result"]["sweep"]
    for index, radius in enumerate((0.08, 0.1)):
        clutch = load("example:indirect", {"R": radius})
        own = clutch["travel_max"], clutch.at("f_max").normal_force
        assert (entry["travel_max"][index], entry["normal_force_at_f_max"][index]) == own
    assert "N(f_max)" in afmcalc(*asked).out
    assert "travel_max [m],normal_force_at_f_max [N]" in afmcalc(*asked, "--format", "csv").out
    for wrong, says in (("travle_max", "did you mean 'travel_max'"), ("torque", "f_max"), ("is_locked", "--columns")):
        run = afmcalc("accuracy", "example:indirect", "--sweep", "R", "--columns", wrong)
        assert (run.code, says in run.err) == (2, True), run.err
    assert "--sweep" in afmcalc("accuracy", "--columns", "gain").err


NAMES = ["C", "z", "z1", "R", "F", "f_min", "f_max", "beta", "friction.mean", "drive.dynamic_factor", "alpha=0:0.5:5"]


@pytest.mark.parametrize("name", NAMES)
def test_every_sweep_has_a_sensible_range(name, afmcalc):
    (entry,) = afmcalc("accuracy", "--sweep", name, "--json").json["result"]["sweep"]
    assert len(entry["values"]) == len(entry["accuracy_factor"]) >= 3
    assert min(entry["accuracy_factor"]) >= 1


def test_a_sweep_of_a_stiffness_beside_disc_springs(afmcalc):
    """A straight control spring against a closing spring of discs, behind curved walls."""
    disc = "closing_spring.disc={outer_diameter=0.1,inner_diameter=0.051,thickness=0.005,free_height=0.00775,series=8}"
    walls = ["--set", "control_unit.pocket=", "--set", "gain_slope=200"]
    asked = ["accuracy", "example:constant-torque", "--set", disc, *walls, "--json"]
    sweep = afmcalc(*asked, "--sweep", "c2=2e5,3e5").json["result"]["sweep"][0]
    single = [afmcalc(*asked, "--set", f"c2={value}").json["result"]["accuracy_factor"] for value in (2e5, 3e5)]
    assert sweep["accuracy_factor"] == pytest.approx(single, rel=1e-12)


def test_a_sweep_from_no_gain_on(afmcalc):
    """At κ = 0 nothing moves the sleeve, and nothing holds it back."""
    asked = "accuracy", "example:constant-torque", "--set", "key_friction=0", "--set", "control_spring.force=6000"
    (entry,) = afmcalc(*asked, "--sweep", "C=0,0.5", "--json").json["result"]["sweep"]
    assert entry["accuracy_factor_hysteresis"][0] == pytest.approx(entry["accuracy_factor"][0])


BAD = ["", "x", "n", "variant", "C=", "C=1:2", "C=1:2:1", "C=1:2:x", "C=a,b", "C=-1:1:5", "z=1.5,2", "f_min=0.5:0.9:5",
       "F=1 J,2 J", "C=nan", "z=1,0", "z1=1:9:9", "C=0:1:99999999999", "friction.driving.min"]  # fmt: skip


@pytest.mark.parametrize("sweep", BAD)
def test_bad_sweeps(sweep, afmcalc, tmp_path):
    run = afmcalc("accuracy", "--sweep", sweep, "-o", tmp_path / "x")
    assert run.code == 2, run.out
    assert run.err.strip().splitlines()[-1].startswith("error: ")
    assert not (tmp_path / "x").exists()


def test_a_long_sweep_is_calculated_in_stretches_that_join():
    """More points than one stretch takes, against the formula F11 (14) over all of them."""
    gain = np.linspace(0, 1.25, 96_001)
    found = evaluate(read_spec(), {"control_unit.gain": gain}, {"factor": lambda clutch: clutch.accuracy_factor})
    np.testing.assert_allclose(found["factor"], 8 * (1 + 0.7 * gain) / (1 + 5.6 * gain), rtol=1e-14)


def test_what_is_swept_heads_its_column(afmcalc):
    """The reduced gain, which is no key of the spec, heads its own column; its values are not shown as gains."""
    run = afmcalc("accuracy", "example:all-driving", "--sweep", "zC=1:2:2", "--format", "csv")
    head, first, _ = run.out.splitlines()
    assert head.startswith("reduced_gain [1],accuracy_factor [1]")
    low, high = (getattr(read_spec("example:all-driving").friction.range, end) for end in ("min", "max"))
    told = [float(each) for each in first.split(",")[:2]]
    assert told == pytest.approx([1.0, high * (1 + low) / (low * (1 + high))])
