"""A report asks the analyses that the commands ask."""

import pytest
from conftest import CONFIGS

from afmcalc.analysis.dossier import dossier
from afmcalc.analysis.registry import ANALYSES
from afmcalc.engines import build
from afmcalc.spec import read_spec


@pytest.mark.parametrize("name", ["default", "indirect", pytest.param("tolerance", marks=pytest.mark.slow)])
def test_a_report_has_each_analysis_that_applies_explained_or_not(name):
    """The results are those of the commands, and the same with and without their formulas."""
    spec = read_spec(CONFIGS / f"{name}.toml")
    own = build(spec)
    sections = [each for each in ANALYSES.values() if each.section and each.applies(own) and each.section.applies(own)]
    told, bare = dossier(spec), dossier(spec, explained=False)
    assert {topic.name for topic in told.topics} == {each.name for each in sections} - {"check"}
    for topic, plain in zip(told.topics, bare.topics, strict=True):
        assert topic.result == plain.result == ANALYSES[topic.name].function(own)[0]
    assert (told.check, told.check.limits, told.findings) == (bare.check, bare.check.limits, bare.findings)
    assert not any(topic.derivations for topic in bare.topics)
    assert told.topics[0].derivations


def test_no_life_without_fatigue():
    told = dossier(read_spec(CONFIGS / "default.toml", ["fatigue="]), explained=False)
    assert "life" not in {topic.name for topic in told.topics}
