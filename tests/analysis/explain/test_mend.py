"""Sections of the handbook on errors and warnings: each code has one, and the keys that it names clear the finding."""

import ast

import pytest
from conftest import slow
from sources import calls, table

from afmcalc.analysis.explain.mend import mend, remedies, steps_to_take
from afmcalc.analysis.registry import ANALYSES
from afmcalc.engines import build
from afmcalc.engines.checks import CHECKS
from afmcalc.engines.parts import RULES
from afmcalc.papers.handbook_text import sections
from afmcalc.spec import read_spec
from afmcalc.spec.keys import keys

MENDED = table("mended")
RAISED, EVENTS, SHARED, IN_WORDS = MENDED["raised"], MENDED["events"], MENDED["shared"], {*MENDED["none"]["codes"]}
QUICK = MENDED["asked"]["quick"]
ASKED = [*QUICK, *slow(*(each for each in RAISED if each not in QUICK), *EVENTS)]


@pytest.mark.usefixtures("parsed_package")
def test_every_error_and_warning_has_a_section_that_names_keys_or_says_why_none():
    told = {check.code for check in (*CHECKS, *RULES) if check.level != "info"}
    for _, call in calls("finding"):
        level = call.args[1] if len(call.args) > 1 else None
        if isinstance(level, ast.Constant) and level.value == "info":
            continue
        told |= {part.value for part in ast.walk(call.args[0]) if isinstance(part, ast.Constant)}
    told |= {"motor-never-stops", "torque-falls-with-travel", "torque-jumps", "unusual"}  # their codes are put together
    own = sections("en")
    assert own.keys() == {code.partition("/")[0] for code in told}
    assert {code for code, section in own.items() if not section.ways} == IN_WORDS
    assert {*RAISED, *EVENTS} == own.keys() - IN_WORDS
    assert sections("ru").keys() == own.keys()
    for section in own.values():
        assert section.meaning
        named = [path for ways in section.ways.values() for path, _ in ways if not path.startswith("*")]
        assert {*named} <= keys().keys()
        assert {about for about in section.ways if about} <= keys().keys()


def changed(code):
    """Example spec, and changes of it with which it has the finding of a code."""
    name, *changes = (RAISED | EVENTS)[code]
    return f"example:{name}", [own for each in changes for own in (SHARED[each[1:]] if each[0] == "+" else [each])]


@pytest.mark.parametrize("code", ASKED)
def test_a_key_that_is_named_clears_the_finding(code):
    """A spec that is read anew with the proposed change no longer has the finding."""
    source, changes = changed(code)
    clutch = build(read_spec(source, changes))
    command = ANALYSES[{"narrower-below-nominal": "adjust"}.get(code, "check")].function
    if code in EVENTS:  # of which one remedy is sought
        before = command(clutch)[1]
        own = next(each for each in before if each.code == code)
        ways = remedies(clutch.spec, own, before, quick=False, about=True)
        clearing = [next(each for each in ways if each.clears is not None)]
    else:
        result, _ = mend(clutch, code)
        assert result.told, "the clutch has it"
        assert (clearing := [each for each in result.remedies if each.clears is not None])
    for each in clearing:
        assert each.way == ("+" if each.clears > each.value else "-")
        value = round(each.clears) if keys()[each.path].about.whole else each.clears
        settings = [*changes, *(each.along.split(", ") if each.along else ()), f"{each.path}={value}"]
        found = [other.path for other in command(build(read_spec(source, settings)))[1] if other.code == code]
        assert (each.about not in found) if each.about else not found, (each, settings)


def test_a_clutch_that_does_not_have_it_and_a_code_that_there_is_not(afmcalc):
    told = afmcalc("explain", "balls-overlap")
    assert (told.code, "This clutch does not have it." in told.out, "What clears it" in told.out) == (0, True, False)
    assert afmcalc("explain", "balls-overlap", "--json").json["result"]["remedies"] == []
    assert "does not have it" not in afmcalc("explain", "no-candidate").out, "it is not of a clutch"
    wrong = afmcalc("explain", "balls-overlaps")
    assert (wrong.code, "did you mean 'balls-overlap'?" in wrong.err) == (2, True)


def test_a_report_says_what_is_to_be_done():
    """A step names the value of a key, if that takes no event, and of several keys one that brings no other finding."""
    spec = read_spec("example:default", ["control_unit.allowable_contact_force=500", "requirements.accuracy_factor=2"])
    findings = ANALYSES["check"].function(build(spec))[1]
    steps = [*steps_to_take(spec, findings)]
    assert len(steps) == len([each for each in findings if each.level != "info"])
    assert all(step.startswith(("Increase ", "Decrease ")) for step in steps), steps
    force = next(step for step in steps if "contact force" in step)
    assert force.startswith("Increase control_unit.ball_circle_radius from 50 mm to "), force
