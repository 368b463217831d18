"""Content of a report: every analysis that applies to one clutch."""

from collections.abc import Sequence
from contextlib import suppress
from typing import Any, NamedTuple

from ..engines import build
from ..engines.quantities import NotedStep
from ..errors import CalculationError, given
from ..findings import Finding
from ..messages import filled, translate
from ..result import Result
from ..spec import Spec
from .asking import Answers
from .check import CheckResult
from .explain.explain import Derivation, derivations, noting, steps_of
from .explain.mend import steps_to_take
from .plot_data import Request, gathered
from .registry import ANALYSES, Analysis, StressRule


class Topic(NamedTuple):
    """One analysis that applies, as a report shows it."""

    name: str
    title: str
    about: str
    conclusion: str
    sources: Sequence[str]
    result: Result
    derivations: list[Derivation]
    """Derivations; formulas that earlier topics show are left out."""
    plot: str
    """Name of the analysis's plot, or empty; ``figure`` has the data of the plot, None if there is nothing to draw."""
    figure: Any


class Dossier(NamedTuple):
    """Content of a report on one clutch."""

    spec: Spec
    check: CheckResult
    findings: list[Finding]
    steps: list[str]
    """Sentences on how to clear errors and warnings, the gravest first."""
    topics: list[Topic]
    section: Any = None
    """Data of the section drawing; None if the clutch cannot be drawn."""


def dossier(spec: Spec, model: StressRule = "mean-stress", *, explained: bool = True) -> Dossier:
    """Run every analysis that applies to a clutch, once; ``explained`` adds the derivations."""
    answers, derived = Answers(noting(spec) if explained else build(spec), model=model), dict[str, list[NotedStep]]()
    sections = [each for each in ANALYSES.values() if each.section]
    for analysis in sections:
        # what ``applies`` asks is noted too; a formula is shown where it is first used
        if explained and analysis.explained and analysis.applies(answers.clutch):
            before = len(steps_of(answers.clutch))
            answers.ask(analysis.name)
            derived[analysis.name] = steps_of(answers.clutch)[before:]
    shown = derivations(derived)
    applying = [each for each in sections if each.applies(answers.clutch) and each.reported(answers.clutch)]
    verdict, findings = answers.ask("check")
    findings = [*findings, *(finding for analysis in applying for finding in answers.ask(analysis.name)[1])]
    findings = list(dict.fromkeys(findings))
    return Dossier(
        spec=spec, check=verdict, findings=findings, steps=[*steps_to_take(spec, findings)],
        topics=[_topic(analysis, answers, shown.get(analysis.name, [])) for analysis in applying],
        section=_drawn("section", answers),
    )  # fmt: skip


def _topic(analysis: Analysis, answers: Answers, derived: list[Derivation]) -> Topic:
    section, plot, result = given(analysis.section), analysis.plot, answers.ask(analysis.name)[0]
    figure = _drawn(plot.name, answers) if plot and plot.applies(answers.clutch) else None
    return Topic(
        name=analysis.name, title=section.title, about=_said(section.about, result),
        conclusion=_said(section.conclusion[analysis.conclusion(result)], result),
        sources=section.sources_indirect or section.sources if answers.clutch.spec.kind.travels else section.sources,
        result=result, derivations=derived, plot=plot.name if plot else "", figure=figure,
    )  # fmt: skip


def _drawn(plot: str, answers: Answers) -> Any:
    """Data of a plot; None if there is nothing to draw: constant friction, unlimited life, too many pairs."""
    with suppress(CalculationError):
        return gathered(plot, Request([answers]))
    return None


def _said(template: str, result: Result) -> str:
    """Text of a section: its template filled with the fields of the result."""
    values = {name: translate(each) if isinstance(each, str) else each for name, each in dict(result).items()}
    return filled(template, values)
