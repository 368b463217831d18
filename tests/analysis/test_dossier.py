"""One registry of analyses, and a report that asks each of them once."""

import functools
import sys
from collections import Counter
from importlib import import_module
from inspect import unwrap

import pytest
from conftest import CONFIGS

from afmcalc.analysis.answers import Answers
from afmcalc.analysis.dossier import dossier
from afmcalc.analysis.figures import Request, gathered
from afmcalc.analysis.registry import ANALYSES, PLOTS
from afmcalc.analysis.tolerance.study import study
from afmcalc.analysis.torque import torque
from afmcalc.cli.main import COMMANDS
from afmcalc.engines import build
from afmcalc.render.plot import _HOMES
from afmcalc.result import Result, Triple, shown_as
from afmcalc.spec import read_spec
from afmcalc.spec.keys import keys

SPECS = ["default", "conventional", "unlike-materials", "all-driving", "indirect", "tolerance"]


def calls_of(functions, work):
    """How often ``work`` calls each of the functions, in whatever module their names were imported."""
    names = {unwrap(function).__code__: function.__name__ for function in functions}
    counted = Counter()

    def note(frame, event, _):
        if event == "call" and frame.f_code in names:
            counted[names[frame.f_code]] += 1

    sys.setprofile(note)
    try:
        work()
    finally:
        sys.setprofile(None)
    return counted


@functools.cache
def explained(name):
    """The dossier of a shipped spec, and how often analyses and engines ran for it."""
    spec, told = read_spec(CONFIGS / f"{name}.toml"), []
    watched = [*(each.function for each in ANALYSES.values()), study, build]
    found = calls_of(watched, lambda: told.append(dossier(spec)))
    return told[0], found


MOST_ENGINES = {"default": 14, "tolerance": 17, "conventional": 7, "indirect": 13}
"""The clutch, both settings for curve, adjustment and life, four to sweep the gain, three the reduced gain (31 before)."""


@pytest.mark.parametrize("name", SPECS)
def test_a_report_runs_each_analysis_that_applies_once_and_explains_that_run(name):
    """Explained or not, the results are the same, and the formulas are of the equations that ran."""
    spec = read_spec(CONFIGS / f"{name}.toml")
    own = build(spec)
    applying = {"check"} | {
        each.name for each in ANALYSES.values() if each.section and each.applies(own) and each.section.applies(own)
    }
    expected = Counter(sorted(applying - {"tolerance"} | ({"study"} if "tolerance" in applying else set())))
    told, found = explained(name)
    assert 0 < found["build"] <= MOST_ENGINES.get(name, 14)
    assert found - Counter(build=found["build"]) == expected
    bare = dossier(spec, explained=False)
    assert [topic.result for topic in told.topics] == [topic.result for topic in bare.topics]
    assert (told.check, told.check.limits, told.findings) == (bare.check, bare.check.limits, bare.findings)
    assert not any(topic.derivations for topic in bare.topics)
    assert told.topics[0].derivations


@pytest.mark.parametrize("name", SPECS)
def test_every_symbol_of_a_report_is_given_explained_or_derived(name):
    """Each formula once; what it uses is told in words or comes from a formula before; no symbol is two quantities."""
    topics = explained(name)[0].topics
    steps = [step for topic in topics for step in topic.derivations]
    known, names = set(), {}
    for step in steps:
        assert bool(step.formula) == (step.number not in known), step
        known.add(step.number)
        assert all(meaning.text or meaning.number for meaning in step.where), step
        assert all(meaning.number is None or meaning.number in known for meaning in step.where), step
        names.setdefault(step.symbol, set()).add(step.number)
        # cases of one quantity can be told apart by what they are for, or by the numbers put in
        assert len({(row.case, row.numbers) for row in step.rows}) == len(step.rows)
    several = {symbol for symbol, numbers in names.items() if len(numbers) > 1}
    assert several <= {"N", "K_т", "r_ш"}, "N at the stop and off it; K_т of torques and of ratios; the smallest ball"
    derived = set(names)
    for topic in topics:
        for field, info in type(topic.result).model_fields.items():
            own, value = shown_as(info).symbol, getattr(topic.result, field)
            if own and isinstance(value, float | Triple) and topic.derivations:
                assert {own, STANDS_FOR.get(own)} & (derived | GIVEN), (topic.name, own)


def test_a_report_has_the_number_of_the_command_where_it_is_rounding_too():
    """At f_min the stop of configs/constant-torque.toml carries 4176 − 2000 − 160 · 1.36/0.1 = 0 N."""
    spec = read_spec(CONFIGS / "constant-torque.toml")
    (reaction,) = (step for topic in dossier(spec).topics for step in topic.derivations if step.symbol == "S")
    told, _ = torque(build(spec))
    assert [row.value for row in reaction.rows] == [told.stop_reaction.min] == pytest.approx([0.0], abs=1e-9)


STANDS_FOR = {
    "N(0)": "N", "T_ret": "T", "T_н.муф": "T_муф", "τ_eq": "τ_m", "τ'_eq": "τ_m", "2R f_1/d": "C_thr",
    "y_st": "y", "K_т,w": "K_т", "K_т,p": "K_т",
}  # fmt: skip
"""Symbol of a result → that of the step it is one case of."""

GIVEN = {
    *(key.symbol for key in keys().values()),
    *("f", "f_1", "f_2", "d_ш", "x_max"),
    # of two numbers that stand beside it
    *("ΔT_2/ΔT_1", "F_n/[F_n]", "z_2 C"),
}
"""What needs no step: it is given, chosen from a list, or told in its own line."""


def test_answers_are_kept():
    answers = Answers(build(read_spec(CONFIGS / "default.toml")))
    for name in ("torque", "life", "check"):
        assert answers.ask(name)[0] is answers.of(ANALYSES[name].result_class)


@pytest.mark.parametrize("name", SPECS)
def test_no_life_without_fatigue(name):
    spec = read_spec(CONFIGS / f"{name}.toml", ["fatigue="])
    asked = Answers(build(spec))
    assert "life" not in {each.name for each in ANALYSES.values() if each.section and each.applies(asked.clutch)}


@pytest.mark.parametrize("name", ANALYSES)
def test_every_record_finds_its_parts(name):
    analysis = ANALYSES[name]
    assert callable(analysis.function)
    assert issubclass(analysis.result_class, Result)
    assert callable(getattr(import_module(f"afmcalc.cli.{COMMANDS[name]}"), name))


@pytest.mark.parametrize("name", sorted(set(PLOTS) - {"paper", "pareto"}))
def test_every_plot_of_a_clutch_is_gathered_and_drawn(name):
    worn = ["heat.lining=0.5 mm", "closing_spring.stiffness=2e4"] if name == "effects" else []
    spec = read_spec(CONFIGS / ("drive.toml" if name == "simulate" else "tolerance.toml"), worn)
    drawn = gathered(name, Request([Answers(build(spec))]))
    assert callable(getattr(import_module(f"afmcalc.render.plot.{_HOMES.get(name, 'curves')}"), name))
    assert drawn
