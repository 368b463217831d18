"""One list of checks: every command shows the same rows and the same sentence; numbers and arrays pass alike."""

import json
import re
from html import unescape

import numpy as np
import pytest
from conftest import slow
from random_clutches import random_clutches

from afmcalc.analysis.asking import Answers
from afmcalc.analysis.check import check, check_at_once
from afmcalc.analysis.compare import compare
from afmcalc.analysis.dossier import dossier
from afmcalc.engines import build
from afmcalc.engines.checks import CHECKS, REQUIRED, apart, checks_of
from afmcalc.errors import CalculationError, SpecError
from afmcalc.messages import percent
from afmcalc.render.report import Subject, render
from afmcalc.spec import make_spec, read_spec, resolved
from afmcalc.spec.edit import with_key, with_values
from afmcalc.spec.models import Required
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
    """Letters and digits of a text or of a page, whatever the markup of its symbols."""
    return re.sub(r"[\W_]+", "", unescape(re.sub("<[^>]*>", "", text)))


@pytest.mark.parametrize(("seed", "count"), [(0, 4), *slow((0, 8), (1, 8), (2, 8))])
def test_every_command_shows_the_same(seed, count, undrawn):
    """Rows and sentence of check, compare, the page and the report; each row that fails is one finding."""
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


@pytest.mark.parametrize(("seed", "count"), [(0, 12), *slow((0, 40), (1, 40), (2, 40))])
def test_numbers_and_arrays_pass_alike(seed, count):
    """Each check that the quantities tell, over the spring force: as the number, so the element."""
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
    assert set(REQUIRED) == set(Required.model_fields)
    assert len({(each.code, each.value, each.limit, each.path) for each in CHECKS}) == len(CHECKS)


def checked(*overrides):
    result, findings = check(build(read_spec(None, overrides)))
    return result, findings, result.verdict.sentence


def test_the_sentence_names_what_counts_most():
    """A missed requirement, else the worst error, else the worst warning, else the nearest; never a note."""
    grave = ["control_unit.balls=13", "C=2", "control_unit.allowable_contact_force=100"]
    result, _, sentence = checked(*grave, "requirements.torque_max=300", "requirements.nominal_torque=1000")
    assert re.fullmatch(
        r"The clutch misses a requirement: nominal torque .*, but at least 1000 N·m is required\.", sentence
    )
    assert (result.passed, result.verdict.passed, result.grade) == (False, False, "fail")
    worst = max((row for row in checked(*grave)[0].checks if row.grade == "fail"), key=lambda row: row.utilisation)
    assert worst.code in ("contact-force-exceeded", "balls-overlap")
    assert checked(*grave)[2].startswith("The clutch must not be made so: the contact force")
    result, findings, sentence = checked("C=2", "requirements.torque_max=900")
    assert (result.grade, sentence.partition(": ")[0]) == ("warning", "To be weighed")
    assert "C = 2 is above" in sentence
    # a motor that may slip at its start is a note, beyond its limit by far
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
    """Never counted as passed: at once neither the peak of an event nor a temperature is known."""
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
