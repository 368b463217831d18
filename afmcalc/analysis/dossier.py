"""All that is to be said of one clutch, gathered for a report."""

from typing import Any, NamedTuple

from ..engines import build
from ..errors import CalculationError
from ..findings import Finding
from ..result import Result
from ..spec import Spec
from ..watch import Progress, unwatched
from .answers import Answers
from .checks.check import CheckResult
from .checks.limits import Utilisation
from .checks.requirements import RequirementRow
from .explain.explain import Step, steps_of
from .explain.trace import recording, with_roles
from .figures import Request, gathered
from .registry import ANALYSES, Analysis, Plot, StressRule


class Topic(NamedTuple):
    """One analysis that applies, as a report shows it."""

    name: str
    title: str
    about: str
    sources: tuple[str, ...]
    result: Result
    steps: list[Step]
    """How it was calculated, less what topics before it show."""
    plot: str
    """Kind of its plot, and what is drawn; empty and None where there is no curve."""
    figure: Any


class Dossier(NamedTuple):
    """All that is to be said of one clutch."""

    spec: Spec
    check: CheckResult
    findings: list[Finding]
    topics: list[Topic]

    @property
    def requirements(self) -> list[RequirementRow]:
        """Every requirement, and whether the clutch holds it."""
        return self.check.requirements

    @property
    def limits(self) -> list[Utilisation]:
        """Every limit, and how much of it is used."""
        return self.check.limits


def dossier(
    spec: Spec, model: StressRule = "mean-stress", *, explained: bool = True, progress: Progress = unwatched
) -> Dossier:
    """Ask everything of a clutch that applies to it, each thing once.

    Args:
        spec: the clutch.
        model: rule for the damaging stress of the life.
        explained: whether to say how it was calculated, of the same run.
        progress: is told how far what takes long is.

    Returns:
        Results, findings of all of them, each once, steps, and what there is to draw.
    """
    if explained:
        answers, steps = _explained(spec, model, progress)
    else:
        answers, steps = Answers(build(spec), model=model, progress=progress), {}
    applying = [each for each in ANALYSES.values() if each.section and each.applies(answers.clutch)]
    verdict, findings = answers.ask("check")
    findings = list(dict.fromkeys([*findings, *(each for own in applying for each in answers.ask(own.name)[1])]))
    return Dossier(
        spec=spec,
        check=verdict,
        findings=findings,
        topics=[_topic(each, answers, steps.get(each.name, [])) for each in applying],
    )


def _explained(spec: Spec, model: StressRule, progress: Progress) -> tuple[Answers, dict[str, list[Step]]]:
    """Ask what can be explained, and note the equations that ran; each step is shown where it first occurs."""
    wanted = [each for each in ANALYSES.values() if each.section and each.explained]
    # imported before anything is recorded, so that none keeps a recording function
    assert all(each.function for each in wanted)
    ends = {}
    with recording() as calls:
        answers = Answers(build(with_roles(spec)), model=model, progress=progress)
        for each in wanted:
            if each.applies(answers.clutch):
                answers.ask(each.name)
                ends[each.name] = len(calls)
    seen: set[tuple[str, str | None, float]] = set()
    found = {}
    start = 0
    for name, end in ends.items():
        own = steps_of(calls[start:end])
        start = end
        found[name] = [step for step in own if (step.function, step.at, step.value) not in seen]
        seen |= {(step.function, step.at, step.value) for step in own}
    return answers, found


def _topic(analysis: Analysis, answers: Answers, steps: list[Step]) -> Topic:
    section, plot, result = analysis.section, analysis.plot, answers.ask(analysis.name)[0]
    assert section is not None
    return Topic(
        name=analysis.name,
        title=section.title,
        about=section.about(result) if callable(section.about) else section.about,
        sources=section.sources_indirect or section.sources if answers.clutch.spec.kind.travels else section.sources,
        result=result,
        steps=steps,
        plot=plot.name if plot else "",
        figure=_figure(plot, answers) if plot and plot.applies(answers.clutch) else None,
    )


def _figure(plot: Plot, answers: Answers) -> Any:
    """What is drawn; None where there is no curve (friction that does not wander, no limit of life)."""
    try:
        return gathered(plot.name, Request([answers]))
    except CalculationError:
        return None
