"""One registry of analyses, and a report that asks each of them once."""

import functools
import sys
from collections import Counter
from inspect import unwrap

import pytest
from conftest import CONFIGS

from afmcalc.analysis.dossier import dossier
from afmcalc.analysis.registry import ANALYSES
from afmcalc.analysis.tolerance.study import study
from afmcalc.engines import build
from afmcalc.spec import read_spec

SPECS = ["default", "indirect", pytest.param("tolerance", marks=pytest.mark.slow)]


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
