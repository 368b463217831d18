"""One list of checks that every command shows, numbers and arrays alike; requirements, and what a miss amounts to."""

import json
import math
import re
from html import unescape

import numpy as np
import pytest
from conftest import CONFIGS, overrides, slow
from random_clutches import random_clutches
from sources import DATA

from afmcalc.analysis.asking import Answers
from afmcalc.analysis.check import brief, check, check_at_once
from afmcalc.analysis.compare import compare
from afmcalc.analysis.dossier import dossier
from afmcalc.engines import build
from afmcalc.engines.checks import CHECKS, REQUIRED, apart, checks_of
from afmcalc.errors import CalculationError, SpecError
from afmcalc.messages import percent
from afmcalc.render.report import Subject, render
from afmcalc.spec import make_spec, read_spec, resolved
from afmcalc.spec.edit import with_key, with_values
from afmcalc.spec.keys import keys
from afmcalc.web.form import Base, State
from afmcalc.web.replies import answer as page_of

ASKED = {"nominal_torque": 50.0, "accuracy_factor": 2.5, "torque_max": 900.0, "reduced_gain": 6.0, "cycles": 1e5}


def specs(count, seed):
    """Valid specs of every variant, each with requirements, of which some are missed."""
    for number, data in enumerate(random_clutches(count, seed)):
        asked = {name: limit for place, (name, limit) in enumerate(ASKED.items()) if (number + place) % 3}
        try:
            spec = make_spec(data | {"requirements": asked})
            check(build(spec))
        except (SpecError, CalculationError, ZeroDivisionError):
            continue
        yield spec


def letters(text):
    """Letters and digits of a text or a page, without the markup."""
    return re.sub(r"[\W_]+", "", unescape(re.sub("<[^>]*>", "", text)))


@pytest.mark.parametrize(("seed", "count"), [(0, 4), *slow((1, 8), (2, 8))])
def test_every_command_shows_the_same(seed, count, undrawn):
    """Rows and sentence are the same in check, compare, the page and the report; each failed row has one finding."""
    for number, spec in enumerate(specs(count, seed)):
        result, findings = check(build(spec))
        assert check_at_once(Answers(build(spec)))[0] == result
        (row,) = compare([build(spec)])[0].clutches
        assert (row.checks, row.sentence, row.passed) == (result.checks, result.verdict.sentence, result.passed)
        told = {(each.code, each.path) for each in findings}
        graver = {(code.replace("exceeded", "in-range"), path) for code, path in told}
        assert {(each.code, each.path) for each in result.checks if each.passed is False} <= told | graver
        assert len(findings) == len(set(findings))
        if number % 4 == 0 and not spec.kind.travels:
            state = State(Base("spec", json.dumps(resolved(spec)), "-"))
            page = page_of(state, {"name": "check", "pinned": None, "options": {}})["html"]
            report = render(Subject(dossier(spec, explained=False), "", short=True))
            table = page.partition("all-checks")[2].partition("</details>")[0]
            grades = re.findall('span class="verdict ([a-z ]+)"', table)
            assert grades == [each.grade for each in result.checks]
            for shown in (page, report):
                assert letters(result.verdict.sentence) in letters(shown)
                assert all(letters(each.name) in letters(shown) for each in result.requirements)


@pytest.mark.parametrize(("seed", "count"), [(0, 12), *slow((1, 40), (2, 40))])
def test_numbers_and_arrays_pass_alike(seed, count):
    """Each check of quantities passes or fails for an array of spring forces as it does for each force alone."""
    asked = {"surface_pressure": 1e5, "outer_diameter": 0.2, "accuracy_factor_hysteresis": 1.5, "torque_max": 300.0}
    seen = set()
    for spec in specs(count, 10 + seed):
        if spec.closing_spring.force is None or spec.closing_spring.disc is not None:
            continue
        more = spec.requirements.model_copy(update=asked)
        own = spec.model_copy(update={"requirements": more})
        forces = spec.closing_spring.force * np.array([0.8, 1.0, 1.3])
        many = build(with_values(own, {"closing_spring.force": forces}))
        for place, force in enumerate(forces):
            one = build(with_key(own, "closing_spring.force", float(force)))
            for each in (each for each in checks_of(own) if each.needs is None):
                value, limit = each.value_of(one), each.limit_of(one)
                assert (value is None) == (each.value_of(many) is None)
                if value is None or limit is None:
                    continue
                with np.errstate(invalid="ignore"):
                    passes = np.broadcast_to(each.passes(each.value_of(many), each.limit_of(many)), 3)[place]
                assert passes == each.passes(value, limit), each.code
                seen.add((each.code, bool(passes)))
    assert len(seen) > 20


def test_the_list_is_whole():
    """Every requirement is a check; every check has a name, a limit and a side."""
    assert {f"requirements.{name}" for name in REQUIRED} == {
        path for path in keys() if path.startswith("requirements.")
    }
    assert len({(each.code, each.value, each.limit, each.path) for each in CHECKS}) == len(CHECKS)


def checked(*overrides):
    result, findings = check(build(read_spec(None, overrides)))
    return result, findings, result.verdict.sentence


def test_the_sentence_names_what_counts_most():
    """It names a missed requirement, else the worst error or warning, else the check nearest to its limit; no note."""
    grave = ["control_unit.balls=13", "C=2", "control_unit.allowable_contact_force=100"]
    result, _, sentence = checked(*grave, "requirements.torque_max=300", "requirements.nominal_torque=1000")
    assert re.fullmatch(
        r"The clutch misses a requirement: nominal torque .*, but at least 1000 N·m is required\.", sentence
    )
    assert (result.passed, result.verdict.passed, result.grade) == (False, False, "fail")
    worst = max((row for row in checked(*grave)[0].checks if row.grade == "fail"), key=lambda row: row.utilisation)
    assert worst.code in ("contact-force-exceeded", "balls-overlap")
    assert checked(*grave)[2].startswith("The clutch must not be made so: the contact force")
    result, findings, sentence = checked("C=2", "control_unit.balls=8", "requirements.torque_max=900")
    assert (result.grade, sentence.partition(": ")[0]) == ("warning", "To be weighed")
    assert "C = 2 is above" in sentence
    # a note, such as that the clutch may slip at the start of its motor, is not named even far beyond its limit
    plate = "machine={power=3000, speed=150, ratio=4, service_factor=1, starting_torque_ratio=9}"
    result, findings, sentence = checked(plate)
    assert "slips-at-start" in {each.code for each in findings}
    assert (result.passed, result.grade) == (True, "pass")
    assert re.fullmatch(r"The clutch meets every requirement; nearest: .*, \d\d\.\d% of its limit\.", sentence)
    assert "start" not in sentence
    assert checked()[2] == "The clutch passes every check; nearest: pockets side by side, 50.5% of its limit."


def test_nothing_short_of_a_limit_is_the_whole_of_it(undrawn):
    torque = 2000 * 0.1 * 8 * 0.8 / (1 + 3.5 * 0.8)
    _, _, sentence = checked(f"requirements.torque_max={torque / 0.99952!r}")
    assert sentence.endswith("largest sustained torque, 99.95% of its limit.")
    shares = (0.5, 0.99952, 0.9999999, 1.00001)
    assert [percent(share) for share in shares] == ["50.0%", "99.95%", "99.99999%", "100.001%"]
    assert apart(900.0001, 900.0, "N*m") == ("900.0001 N·m", "900 N·m")
    spec = read_spec(None, [f"requirements.torque_max={torque / 0.99952!r}"])
    assert ">0.9995<" in render(Subject(dossier(spec, explained=False), "", short=True))


def test_a_part_that_is_not_calculated_is_named():
    """Without simulation the peak and the temperature of an event are not known, and never count as passed."""
    clutch = build(read_spec("example:drive", ["drive.event.duration=0.05"]))
    result, _ = check_at_once(Answers(clutch))
    assert result.verdict.not_judged == [
        "peak torque in the shaft",
        "mean temperature of the discs after one trip",
        "the event",
    ]
    assert result.verdict.sentence.endswith(f"Not yet judged: {', '.join(result.verdict.not_judged)}.")
    assert result.verdict.sentence.startswith("What is judged so far passes; nearest: ")
    assert (result.requirements, result.verdict.passed, result.grade) == ([], None, "warning")


@pytest.mark.parametrize("ends", [(1.5, 2.0), (1.6, 1.9), (1.5, None), (None, 1.9)])
def test_the_trip_is_required_as_a_multiple_of_the_rated_torque(ends):
    """The rated torque is the motor's at the clutch, without service factor; both ends of the range are judged."""
    at_clutch = 11e3 / (1460 * np.pi / 30)
    asked = [f"requirements.trip_ratio.{name}={end}" for name, end in zip(("min", "max"), ends, strict=True) if end]
    spec = read_spec("example:conveyor-clutch", ["requirements.trip_ratio=", *asked])
    result = check(build(spec), without={"simulate", "heat", "life", "tolerance"})[0]
    rows = {row.path.rpartition(".")[2]: row.passed for row in result.checks if "trip_ratio" in (row.path or "")}
    trips = {"min": result.torque_min / at_clutch, "max": result.torque_max / at_clutch}
    assert (result.trip_ratio_min, result.trip_ratio_max) == pytest.approx((trips["min"], trips["max"]))
    holds = {"min": ends[0] is None or trips["min"] >= ends[0], "max": ends[1] is None or trips["max"] <= ends[1]}
    assert rows == {name: holds[name] for name, end in zip(("min", "max"), ends, strict=True) if end}
    clutch = build(read_spec(None))
    assert clutch["trip_ratio_max"] == clutch["torque_max"] / clutch["machine_torque"]


def test_people_see_what_decides_once_and_the_verdict_last(answered, monkeypatch):
    """One screen has what is missed or near its limit, errors and warnings once; -v and JSON have everything."""
    monkeypatch.setenv("COLUMNS", "80")
    changes = ["requirements.torque_max=120 N*m", "C=2.4", "drive.event="]
    grave = ["check", "example:conveyor-clutch", *overrides(*changes)]
    whole = json.loads(answered(*grave, "--json").out)
    told, all_told = answered(*grave).out, answered(*grave, "-v").out
    for language in ("en", "ru"):
        assert len(answered(*grave[:2], "--lang", language).out.splitlines()) <= 45
    assert len(told.splitlines()) <= 60 < len(all_told.splitlines())
    sentence = whole["result"]["verdict"]["sentence"]
    assert letters(told).endswith(letters(sentence))
    for each in whole["findings"]:
        grave_but_missed = each["level"] != "info" and each["code"] != "requirement-missed"
        assert letters(told).count(letters(each["message"])) == grave_but_missed or each["message"] in sentence
    spec = read_spec("example:conveyor-clutch", changes)
    result, findings = check(build(spec))
    shown, said = brief(result, findings)
    beyond = {row.path for row in result.checks if row.passed is False and row.level != "info"}
    assert {row.path for row in shown.checks} | {each.path for each in said} >= beyond


# the base clutch by hand: T(f) = F R f (z_1 + z_2)/(1 + z_2 C f), F 2 kN, R 100 mm, z 8, z_1 1, C 0.5
TORQUE = {f: 2000 * 0.1 * 8 * f / (1 + 3.5 * f) for f in (0.1, 0.8)}
RADII = ["friction_group.mean_radius=", "friction_group.inner_radius=80 mm", "friction_group.outer_radius=120 mm"]
WEAK = "fatigue.endurance_limit=12 MPa"
# a motor of 10 kg·m² that a load of 50 N·m drives runs down from 20 rad/s; 0.5 mm of 8 pairs slacken 100 N/mm by 400 N
WARM = ["heat.disc_mass=6 kg", "heat.specific_heat=480 J/kg/K", "heat.ambient=20 degC", "heat.cooling=2.5 W/K",
        "heat.lining=0.5 mm", "closing_spring.stiffness=100 N/mm", "drive.speed=20", "drive.motor_inertia=10",
        "drive.motor_torque=50", "requirements.temperature=200 degC"]  # fmt: skip
HELD = {
    "nominal_torque": (TORQUE[0.1], "at least"),
    "machine_torque": (TORQUE[0.1] / 1.25, "at least"),
    "accuracy_factor": (TORQUE[0.8] / TORQUE[0.1], "at most"),
    "accuracy_factor_hysteresis": (TORQUE[0.8] / TORQUE[0.1], "at most"),  # a direct clutch has no hysteresis
    "torque_max": (TORQUE[0.8], "at most"),
    "outer_diameter": (0.24, "at most"),
    "surface_pressure": (2000 / (math.pi * (0.12**2 - 0.08**2)), "at most"),
    "reduced_gain": (7 * 0.5, "at most"),
    # Q = J ω²/2 · T/(T − M), most where the clutch is weakest
    "trips_per_hour": (3600 * 2.5 * 180 / (10 * 20**2 / 2 * TORQUE[0.1] / (TORQUE[0.1] - 50)), "at least"),
    "torque_after_wear": (TORQUE[0.1] * (2000 - 1e5 * 8 * 0.5e-3) / 2000, "at least"),
    # the mean-stress rule on the unprotected side, where the dynamic factor raises the load
    "cycles": (1e7 * (2 * 12e6 * 15e-6 / 1.4 / (TORQUE[0.1] + TORQUE[0.8])) ** 6, "at least"),
}
"""Key → value that the base clutch has, and whether the limit is the least or the most."""


def rows_of(spec):
    result, findings = Answers(build(spec)).ask("check")
    return result.passed, {row.path.partition(".")[2]: row for row in result.requirements}, findings


@pytest.mark.parametrize("share", [0.999, 1.0, 1.001])
@pytest.mark.parametrize("name", HELD)
def test_a_requirement_is_held_up_to_its_limit(name, share):
    value, bound = HELD[name]
    limit = value * share
    passed, rows, findings = rows_of(read_spec(None, [*RADII, WEAK, *WARM, f"requirements.{name}={limit!r}"]))
    holds = share <= 1 if bound == "at least" else share >= 1
    row = rows[name]
    assert (row.value, row.limit, row.least, row.passed) == (pytest.approx(value), limit, bound == "at least", holds)
    assert row.utilisation == pytest.approx(share if bound == "at least" else 1 / share)
    missed = [each for each in findings if each.code == "requirement-missed"]
    assert passed == holds == (not missed)
    assert all((each.level, each.path) == ("error", f"requirements.{name}") for each in missed)


def test_accuracy_under_a_load_that_lasts(afmcalc):
    def checked(*changes):
        found = afmcalc("check", DATA / "lasting.toml", *overrides(*changes), "--json").json
        told = [each for each in found["findings"] if each["code"] == "accuracy-not-lasting"]
        return {
            row["path"].partition(".")[2]: (row["passed"], row["value"])
            for row in found["result"]["checks"]
            if row["code"] == "requirement-missed"
        }, told

    rising, lasting = "requirements.accuracy_factor", "requirements.accuracy_factor_hysteresis"
    rows, (one,) = checked(f"{rising}=2.5")
    assert rows["accuracy_factor"] == (True, pytest.approx(2.08, abs=5e-3))
    assert (one["level"], one["limit"], one["value"]) == ("warning", 2.5, pytest.approx(2.81, abs=5e-3))
    rows, told = checked(f"{rising}=2.5", f"{lasting}=2.7")
    assert (rows["accuracy_factor_hysteresis"][0], told) == (False, [])
    assert not checked(f"{rising}=2.9")[1], "within both"


UNKNOWN = {"outer_diameter": 0.2, "surface_pressure": 1e6, "travel": 0.01, "exceedance": 0.01, "cycles": 1e6,
           "trips_per_hour": 5, "torque_after_wear": 90}  # fmt: skip


def test_what_cannot_be_judged_is_no_pass(afmcalc):
    wanted = overrides(*(f"requirements.{name}={limit}" for name, limit in UNKNOWN.items()))
    spec = [*wanted, *overrides("requirements.torque_max=400", "fatigue=")]
    run = afmcalc("check", *spec, "--json")
    rows = {
        row["path"].partition(".")[2]: row
        for row in run.json["result"]["checks"]
        if row["code"] == "requirement-missed"
    }
    assert {tuple(rows[name][key] for key in ("value", "utilisation", "passed")) for name in UNKNOWN} == {(None,) * 3}
    told = [(each["level"], each["path"]) for each in run.json["findings"] if each["code"] == "requirement-not-judged"]
    assert sorted(told) == sorted(("warning", f"requirements.{name}") for name in UNKNOWN)
    assert (run.code, afmcalc("check", *spec, "--strict").code) == (0, 1)


def test_a_lining_that_takes_all_the_force_leaves_no_torque():
    _, rows, _ = rows_of(read_spec(None, [*WARM, "heat.lining=3 mm", "requirements.torque_after_wear=1"]))
    row = rows["torque_after_wear"]
    assert (row.value, row.utilisation, row.passed) == (0, None, False)


def test_life_without_a_limit_is_held():
    """Amplitude and Goodman give no number below the endurance limit: the requirement passes without a value."""
    spec = read_spec(None, ["requirements.cycles=1e30", "fatigue.mean_stress_sensitivity=0.1"])
    result, _ = Answers(build(spec), model="amplitude").ask("check")
    (row,) = result.requirements
    assert (row.value, row.utilisation, row.passed) == (None, 0, True)


def test_exceedance_is_of_the_torque_required():
    """P(T > 300 N·m) with friction uniform over 0.1…0.8 follows from the friction at which T is 300 N·m."""
    beyond, blocks = (
        300 / (1600 - 3.5 * 300),
        {"fields": {"friction": {"distribution": "uniform"}}, "samples": 50_000, "sobol_base": 64},
    )
    data = resolved(read_spec(CONFIGS / "default.toml"))
    data |= {"tolerance": blocks, "requirements": {"torque_max": 300.0, "exceedance": 0.5}}
    assert rows_of(make_spec(data))[1]["exceedance"].value == pytest.approx(
        (0.8 - beyond) / 0.7, abs=0.008
    )  # 4 standard errors of this number of samples
    data["tolerance"] = {**blocks, "torque_limit": 250.0}
    assert rows_of(make_spec(data))[1]["exceedance"].passed is None
    del data["requirements"]["torque_max"]
    with pytest.raises(SpecError, match=r"requirements\.torque_max.*required beside requirements.exceedance"):
        make_spec(data)
