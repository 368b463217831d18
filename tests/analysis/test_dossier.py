"""One registry of analyses, and a report that asks each of them once."""

import sys
from collections import Counter
from importlib import import_module

import pytest
from conftest import CONFIGS

from afmcalc.analysis.answers import Answers
from afmcalc.analysis.dossier import dossier
from afmcalc.analysis.figures import gathered
from afmcalc.analysis.registry import ANALYSES, PLOTS
from afmcalc.analysis.tolerance.study import study
from afmcalc.cli.main import COMMANDS
from afmcalc.engines import build
from afmcalc.render.report import Subject, render
from afmcalc.result import Result
from afmcalc.spec import read_spec

SPECS = ["default", "conventional", "unlike-materials", "all-driving", "indirect", "tolerance"]


def calls_of(functions, work):
    """How often ``work`` calls each of the functions, in whatever module their names were imported."""
    names = {function.__code__: function.__name__ for function in functions}
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


@pytest.mark.parametrize("name", SPECS)
def test_a_report_runs_each_analysis_that_applies_once(name):
    spec = read_spec(CONFIGS / f"{name}.toml")
    applying = {each.name for each in ANALYSES.values() if each.section and each.applies(build(spec))} | {"check"}
    expected = Counter(sorted(applying - {"tolerance"} | ({"study"} if "tolerance" in applying else set())))
    watched = [*(each.function for each in ANALYSES.values()), study]
    assert calls_of(watched, lambda: render(Subject(dossier(spec), ""))) == expected


@pytest.mark.parametrize(("name", "most"), [("default", 14), ("conventional", 7), ("indirect", 13)])
def test_a_report_builds_few_engines(name, most):
    """The clutch, both settings for curve, adjustment and life, four to sweep the gain, three the reduced gain (31 before)."""
    spec = read_spec(CONFIGS / f"{name}.toml")
    assert 0 < calls_of([build], lambda: render(Subject(dossier(spec), "")))["build"] <= most


@pytest.mark.parametrize("name", SPECS)
def test_a_report_explains_the_run_it_shows(name):
    """Explained or not, the results are the same, and the steps are of the equations that ran."""
    spec = read_spec(CONFIGS / f"{name}.toml")
    told, bare = dossier(spec), dossier(spec, explained=False)
    assert [topic.result for topic in told.topics] == [topic.result for topic in bare.topics]
    assert (told.check, told.limits, told.findings) == (bare.check, bare.limits, bare.findings)
    assert not any(topic.steps for topic in bare.topics)
    assert told.topics[0].steps


def test_answers_are_kept():
    answers = Answers(build(read_spec(CONFIGS / "default.toml")))
    for name in ("torque", "life", "check"):
        assert answers.ask(name)[0] is answers.of(ANALYSES[name].result_class)


def test_a_verdict_is_by_the_rule_that_was_asked_for():
    spec = read_spec(CONFIGS / "default.toml", ["fatigue.mean_stress_sensitivity=0.1"])
    for model, said in (("mean-stress", True), ("amplitude", False)):
        codes = [finding.code for finding in dossier(spec, model, explained=False).findings]
        assert ("mean-stress-rule" in codes) == said


@pytest.mark.parametrize("name", ANALYSES)
def test_every_record_finds_its_parts(name):
    analysis = ANALYSES[name]
    assert callable(analysis.function)
    assert issubclass(analysis.result_class, Result)
    assert callable(getattr(import_module(f"afmcalc.cli.{COMMANDS[name]}"), name))


@pytest.mark.parametrize("name", PLOTS)
def test_every_plot_is_gathered_and_laid_out(name):
    assert f"_{name}" in gathered.__globals__
    assert callable(import_module(f"afmcalc.render.plot.kinds.{name}").sheet)
