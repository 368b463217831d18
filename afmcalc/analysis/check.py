"""Check of a design: its findings, what is unusual about it, and whether it passes."""

import math
from collections.abc import Collection, Iterator
from typing import ClassVar

from ..engines import Clutch
from ..errors import CalculationError, SpecError
from ..findings import Finding, finding
from ..result import Answer, described
from ..spec.catalogues import friction_materials
from ..spec.edit import value_at
from .answers import Answers
from .clutch_findings import clutch_findings
from .limits import Utilisation, hub_findings, pressure_findings, shaft_findings, utilisations
from .registry import ANALYSES
from .requirements import RequirementRow, requirement_rows, simulating
from .synthesize import SynthesisResult


class CheckResult(Answer):
    """Whether a design passes, and how many findings of each level it has."""

    findings_first: ClassVar[bool] = True

    passed: bool = described("whether the check passed")
    errors: int = described("findings that must be put right")
    warnings: int = described("findings to think about")
    notes: int = described("findings worth knowing")
    requirements: list[RequirementRow] = described("requirements")
    limits: list[Utilisation] = described("every limit, and how much of it is used")

    def words(self, name: str) -> str | None:
        """Leave out of the table what the verdict tells in a sentence above it."""
        return "" if name == "passed" else None


def check(
    clutch: Clutch, *, strict: bool = False, answers: Answers | None = None, without: Collection[str] = ()
) -> tuple[CheckResult, list[Finding]]:
    """Return the verdict on a design and its findings.

    Args:
        clutch: the design.
        strict: whether warnings fail it too.
        answers: what was asked of it already.
        without: analyses that are not asked, because they take long: what they judge is left out.
    """
    answers = answers or Answers(clutch)
    findings = _findings(answers, without)
    requirements, missed = requirement_rows(answers, without=without)
    findings += missed
    levels = [remark.level for remark in findings]
    result = CheckResult(
        passed="error" not in levels and not (strict and "warning" in levels),
        errors=levels.count("error"),
        warnings=levels.count("warning"),
        notes=levels.count("info"),
        requirements=requirements,
        limits=utilisations(answers, findings, without),
    )
    return result, findings


def check_at_once(answers: Answers) -> tuple[CheckResult, list[Finding]]:
    """Return the verdict but for what has to be simulated or sampled first; a life may take the factor of its event."""
    spec, without = answers.clutch.spec, simulating(answers.clutch)
    if spec.drive.event is not None and spec.drive.dynamic_factor is None:
        without |= {"life"}
    return check(answers.clutch, answers=answers, without=without)


def refused(error: SpecError) -> tuple[CheckResult, list[Finding]]:
    """Verdict on what is no spec, each of its problems a finding."""
    problems = [
        finding("bad-spec", "error", path=problem.path or None, where=error.where(problem), problem=str(problem))
        for problem in error.problems
    ]
    errors = len(problems) + error.more
    return CheckResult(passed=False, errors=errors, warnings=0, notes=0, requirements=[], limits=[]), problems


def found_unsimulated(clutch: Clutch) -> list[Finding]:
    """Return what a check finds but for what has to be simulated or sampled first; a life takes its event's factor."""
    answers = Answers(clutch)
    without = simulating(clutch)
    return [*_findings(answers, without), *requirement_rows(answers, without=without)[1]]


def _findings(answers: Answers, without: Collection[str]) -> list[Finding]:
    """Return the findings of every analysis that a check takes in and that applies to the clutch, each once."""
    clutch = answers.clutch
    findings = [
        *clutch_findings(clutch.spec, clutch.quantities),
        *pressure_findings(clutch),
        *hub_findings(answers),
        *_unusual(answers),
    ]
    findings += shaft_findings(answers, simulated="simulate" not in without)
    unit = clutch.spec.control_unit
    if unit is not None and unit.ball_circle_radius is None:
        findings.append(finding("control-unit-not-judged", "info", path="control_unit.ball_circle_radius"))
    for analysis in ANALYSES.values():
        if analysis.judged and analysis.applies(clutch) and analysis.name not in without:
            findings += answers.ask(analysis.name)[1]
    return list(dict.fromkeys(findings))


def _unusual(answers: Answers) -> Iterator[Finding]:
    """Say what can be made, yet is so unusual that a slip of the pen is likelier than a purpose.

    The ranges are wide: they are no limits of a design, they find a millimetre written for a metre.
    """
    linings = (answers.clutch.spec.lists.materials or friction_materials()).values()
    least, most = min(lining.friction_min for lining in linings), max(lining.friction_max for lining in linings)
    for code, path, value, low, high in _figures(answers):
        if not low * (1 - 1e-9) <= value <= high * (1 + 1e-9):
            limit = low if value < low else high
            yield finding(
                code, "warning", value=value, limit=limit, path=path, low=low, high=high, least=least, most=most
            )


def _figures(answers: Answers) -> Iterator[tuple[str, str, float, float, float]]:
    """Figures of the design: code of its finding, key, value, and between what it usually lies."""
    clutch = answers.clutch
    spec, own = clutch.spec, clutch.quantities
    radius = float(own["mean_radius"])
    blocks = ("friction.driving", "friction.driven") if spec.friction.unlike else ("friction",)
    for path, friction in zip(blocks, spec.friction.groups, strict=False):
        # the papers have 0.1 to 0.8; dry rubber and clean metal in a vacuum are beyond, neither is a friction lining
        yield "unusual/friction", f"{path}.min", friction.min, 0.02, 1.0
        yield "unusual/friction", f"{path}.max", friction.max, 0.02, 1.0
    yield "unusual/mean-radius", "friction_group.mean_radius", radius, 0.01, 1.0
    yield "unusual/pairs", "friction_group.pairs", spec.friction_group.pairs, 1, 40
    yield "unusual/margin", "adjustment.margin", spec.adjustment.margin, 1.0, 3.0
    # over a full disc of the mean radius; linings bear 0.05 to 2 MPa
    pressure = float(own["pack_force_at_rest"]) / (math.pi * radius**2)
    yield "unusual/pressure", "closing_spring.force", pressure, 1e3, 5e6
    springs = {"closing_spring": own["closing_force"]}
    if spec.kind.travels:
        springs["control_spring"] = own["control_force"]
    for name, force in springs.items():
        if stiffness := value_at(spec, f"{name}.stiffness"):
            deflection, key = float(force) / stiffness, f"{name}.stiffness"
            if math.isinf(deflection):
                raise CalculationError(
                    "{key} = {stiffness:.5g N/m}: a spring as soft as that has {force:.5g N} at a deflection beyond "
                    "the range of numbers",
                    key=key,
                    stiffness=stiffness,
                    force=float(force),
                )
            # a spring deflected by more is longer than the clutch is wide
            yield "unusual/deflection", key, deflection, 0.0, 2 * radius
    if ANALYSES["synthesize"].applies(clutch):
        unit = answers.of(SynthesisResult)
        path = "control_unit.wall_angle" if value_at(spec, "control_unit.gain") is None else "control_unit.gain"
        # steeper the ball hardly bears along the axis, flatter it hardly bears around it
        yield "unusual/wall-angle", path, unit.wall_angle, math.radians(5), math.radians(60)
        circle = unit.ball_circle_radius
        yield "unusual/ball-circle", "control_unit.ball_circle_radius", circle, 0.2 * radius, 2 * radius
