"""Check of a clutch: a row for each check and requirement, one verdict, and findings for the designer."""

import math
from collections.abc import Collection, Iterator, Mapping
from typing import Any, Literal

from ..engines import Clutch
from ..engines.checks import Beside, Check, Known, Part, checks_of, failures
from ..engines.parts import checks_of_springs
from ..engines.quantities import Quantities
from ..engines.selection import by_rule
from ..errors import CalculationError, SpecError
from ..findings import Finding, Level, finding
from ..messages import deferred, percent, say, translate
from ..result import Answer, Result, described, quantity
from ..spec.catalogues import friction_materials
from ..spec.edit import value_at
from .asking import Answers, Asking, answer, asked
from .clutch_findings import clutch_findings
from .drive_result import SimulateResult
from .fatigue import UNLIMITED
from .registry import ANALYSES
from .simulate import event_values
from .trip_heat import heat_values

Grade = Literal["pass", "note", "warning", "fail", "not judged"]
_GRADES: Mapping[Level, Grade] = {"info": "note", "warning": "warning", "error": "fail"}


class CheckRow(Result):
    """One check or requirement, and how much of its limit the clutch uses."""

    code: str = described("code of its finding", details=True)
    name: str = described("check")
    symbol: str = described("condition", details=True)
    value: float | None = described("value", unit_in="shown_unit")
    limit: float | None = described("limit", unit_in="shown_unit", digits=5)
    unit: str = described("unit", is_unit=True, unit_in="shown_unit")
    least: bool = described("whether the limit is the least", details=True)
    utilisation: float | None = quantity("1", "η", "utilisation, 1 at the limit")
    passed: bool | None = described("verdict")
    level: Level = described("how grave it is to be beyond", details=True)
    path: str | None = described("spec key", details=True)
    needs: str | None = described("part that tells it", details=True)

    @property
    def shown_unit(self) -> str:
        """Unit to show; ``K abs`` for kelvin, since value and limit are temperatures, not differences."""
        return "K abs" if self.unit == "K" else self.unit

    @property
    def is_requirement(self) -> bool:
        """True if the row judges a requirement, of [requirements] or of the rating plate in [machine]."""
        return self.code == "requirement-missed"

    @property
    def grade(self) -> Grade:
        """Grade of the row; a failed row has the grade of its level, error or warning."""
        return "not judged" if self.passed is None else "pass" if self.passed else _GRADES[self.level]

    def words(self, name: str) -> str | None:
        """Words for the verdict, and "unlimited" for a life that passes without a number; None: the value is shown."""
        if name == "value" and self.value is None and self.passed:
            return translate(UNLIMITED)
        return translate(self.grade) if name == "passed" else None


class Verdict(Result):
    """Verdict on a clutch, in one sentence."""

    passed: bool | None = described("whether the check passed; null: a part is not yet judged")
    sentence: str = described("verdict")
    not_judged: list[str] = described("not yet judged")


class CheckResult(Asking, Answer):
    """The verdict on a clutch, and every check."""

    passed: bool = described("whether the check passed")
    errors: int = described("findings that must be put right", details=True)
    warnings: int = described("findings to think about", details=True)
    notes: int = described("findings worth knowing", details=True)
    torque_min: float | None = asked(optional=True)
    torque_max: float | None = asked(optional=True)
    running_torque: float | None = asked(description="rated torque at the clutch", optional=True)
    trip_ratio_min: float | None = asked(optional=True)
    trip_ratio_max: float | None = asked(optional=True)
    verdict: Verdict = described("verdict")
    checks: list[CheckRow] = described("requirements and checks")

    def words(self, name: str) -> str | None:
        """Empty text for fields that the sentence above the table contains, to hide them; None for other fields."""
        return "" if name in ("passed", "verdict") else None

    @property
    def requirements(self) -> list[CheckRow]:
        """Rows that judge requirements."""
        return [row for row in self.checks if row.is_requirement]

    @property
    def grade(self) -> Grade:
        """Grade of the clutch; it is also a warning if some checks are not yet judged."""
        if self.errors or not self.passed:
            return "fail"
        return "warning" if self.warnings or self.verdict.not_judged else "pass"


def check(
    clutch: Clutch, *, strict: bool = False, answers: Answers | None = None, without: Collection[str] = ()
) -> tuple[CheckResult, list[Finding]]:
    """Return the verdict on a clutch, and its findings.

    Args:
        clutch: the clutch.
        strict: True if warnings also make the clutch fail.
        answers: cache of the analyses of this clutch; None: an empty cache.
        without: analyses to skip because they take long; their checks are listed as not judged.
    """
    answers = answers or Answers(clutch)
    rows, failed, open_parts = _judged(answers, without)
    findings = list(dict.fromkeys([*_remarks(answers, without), *failed]))
    levels = [remark.level for remark in findings]
    passed = "error" not in levels and not (strict and "warning" in levels)
    not_judged = [*(row.name for row in rows if row.passed is None), *open_parts]
    sentence = _sentence(rows, findings, not_judged)
    verdict = Verdict(passed=None if passed and open_parts else passed, sentence=sentence, not_judged=not_judged)
    counts = {"errors": levels.count("error"), "warnings": levels.count("warning"), "notes": levels.count("info")}
    return answer(CheckResult, answers.quiet, passed=passed, **counts, verdict=verdict, checks=rows), findings


_NEAR = 0.9
"""Utilisation above which ``brief`` keeps a passed check."""
_NEAREST = 3
"""Number of passed checks that ``brief`` keeps at any utilisation."""
_ON_LIMIT = 1 - 1e-9
"""Utilisation from which a passed check counts as set exactly on its limit and is therefore not shown."""


def brief(result: CheckResult, findings: list[Finding]) -> tuple[CheckResult, list[Finding]]:
    """Return a check shortened for people: checks that fail or are near their limits; each error and warning once."""
    graver = [each for each in findings if each.level != "info" and each.code != "requirement-missed"]
    worst = next((each for each in graver if each.message in result.verdict.sentence), None)
    told = {(each.code, each.path) for each in graver}
    failed = [row for row in result.checks if not row.passed and (row.code, row.path) not in told]
    passed = [row for row in result.checks if row.passed and row.utilisation]
    passed = [row for row in passed if row.is_requirement or (row.utilisation or 0.0) < _ON_LIMIT]
    passed.sort(key=lambda row: -(row.utilisation or 0.0))
    near = [row for place, row in enumerate(passed) if place < _NEAREST or (row.utilisation or 0.0) > _NEAR]
    counts = say("{checks} checks, {notes} notes in all: -v tells them.", checks=len(result.checks), notes=result.notes)
    code = f" [{', '.join(filter(None, (worst.code, worst.path)))}]" if worst else ""
    verdict = result.verdict.model_copy(update={"sentence": f"{counts}\n{result.verdict.sentence}{code}"})
    shown = result.model_copy(update={"checks": [*failed, *near], "verdict": verdict})
    return shown, [each for each in graver if each is not worst]


def check_at_once(answers: Answers) -> tuple[CheckResult, list[Finding]]:
    """Check a clutch without the analyses that simulate or sample; their checks are listed as not judged."""
    return check(answers.clutch, answers=answers, without=simulating(answers.clutch))


def simulating(clutch: Clutch) -> set[str]:
    """Names of the analyses in a check that take long: simulation and heat of an event, tolerance."""
    of_event = {"simulate", "heat"} if clutch.spec.drive.event is not None else set()
    return of_event | ({"tolerance"} if clutch.spec.tolerance is not None else set())


def refused(error: SpecError) -> tuple[CheckResult, list[Finding]]:
    """Failed verdict on an invalid spec, with a finding for each of its problems."""
    problems = [
        finding("bad-spec", "error", path=problem.path or None, where=problem.where, problem=str(problem))
        for problem in error.problems
    ]
    verdict = Verdict(passed=False, sentence=_sentence([], problems, []), not_judged=[])
    errors = len(problems) + error.more
    return CheckResult(passed=False, errors=errors, warnings=0, notes=0, verdict=verdict, checks=[]), problems


def _remarks(answers: Answers, without: Collection[str]) -> list[Finding]:
    """Findings on the law and on unusual values, and those of each ``judged`` analysis that applies and may run."""
    clutch, own = answers.clutch, answers.quiet
    findings = clutch_findings(own)
    linings = (clutch.spec.lists.materials or friction_materials()).values()
    span = {"least": min(one.friction_min for one in linings), "most": max(one.friction_max for one in linings)}
    for code, path, value, low, high in _usual_ranges(own):
        if not low * (1 - 1e-9) <= value <= high * (1 + 1e-9):
            limit = low if value < low else high
            findings.append(finding(code, "warning", value=value, limit=limit, path=path, low=low, high=high, **span))
    unit = clutch.spec.control_unit
    if unit is not None and unit.ball_circle_radius is None:
        findings.append(finding("control-unit-not-judged", "info", path="control_unit.ball_circle_radius"))
    if "simulate" in without and clutch.spec.drive.dynamic_factor is None:
        without = {*without, "life"}  # life needs the dynamic factor of the event
    for analysis in ANALYSES.values():
        if analysis.judged and analysis.applies(clutch) and analysis.name not in without:
            findings += answers.ask(analysis.name)[1]
    return findings


def _usual_ranges(clutch: Clutch) -> Iterator[tuple[str, str, float, float, float]]:
    """Yield code of the finding, key, value, and the ends of the usual range; beyond it a typing error is likely.

    The ranges are no limits of a design: they are wide, and detect values typed in a wrong unit, such as mm for m.
    """
    spec, radius = clutch.spec, clutch["mean_radius"]
    blocks = ("friction.driving", "friction.driven") if spec.friction.unlike else ("friction",)
    for path, friction in zip(blocks, spec.friction.groups, strict=False):
        # the papers use 0.1 to 0.8; outside are dry rubber and clean metal in a vacuum, neither is a friction lining
        yield "unusual/friction", f"{path}.min", friction.min, 0.02, 1.0
        yield "unusual/friction", f"{path}.max", friction.max, 0.02, 1.0
    yield "unusual/mean-radius", "friction_group.mean_radius", radius, 0.01, 1.0
    yield "unusual/pairs", "friction_group.pairs", spec.friction_group.pairs, 1, 40
    yield "unusual/margin", "adjustment.margin", spec.adjustment.margin, 1.0, 3.0
    # pressure on a full circular area of the mean radius; linings bear 0.05 to 2 MPa
    pressure = clutch["pack_force_at_rest"] / (math.pi * radius**2)
    yield "unusual/pressure", "closing_spring.force", pressure, 1e3, 5e6
    for name in ("closing", "control") if spec.kind.travels else ("closing",):
        key, force = f"{name}_spring.stiffness", clutch[f"{name}_force"]
        if stiffness := value_at(spec, key):
            deflection = force / stiffness
            if math.isinf(deflection):
                raise CalculationError(
                    "{key} = {stiffness:.5g N/m}: a spring as soft as that has {force:.5g N} at a deflection beyond "
                    "the range of numbers",
                    key=key,
                    stiffness=stiffness,
                    force=force,
                )
            # a spring with a larger deflection is longer than the clutch is wide
            yield "unusual/deflection", key, deflection, 0.0, 2 * radius
    if "ball_circle_radius" in clutch and clutch["gain"] > 0:
        path = "control_unit.wall_angle" if value_at(spec, "control_unit.gain") is None else "control_unit.gain"
        # the contact force is almost tangential at a smaller wall angle, almost axial at a larger angle
        yield "unusual/wall-angle", path, clutch["wall_angle"], math.radians(5), math.radians(60)
        circle = clutch["ball_circle_radius"]
        yield "unusual/ball-circle", "control_unit.ball_circle_radius", circle, 0.2 * radius, 2 * radius


# the rows


def _judged(answers: Answers, without: Collection[str]) -> tuple[list[CheckRow], list[Finding], list[str]]:
    """Return a row for each check that applies, a finding for each failed check, and the names of skipped checks."""
    spec = answers.clutch.spec
    rows, findings, left_out = list[CheckRow](), list[Finding](), dict[str, None]()
    known, needed = dict[Part | None, Known](), dict[Part | None, list[Check]]()
    for check in checks_of(spec):
        if check.needs in without:
            left_out[translate(check.name if check.requirement else _PARTS[check.needs])] = None
            continue
        if check.needs not in known:
            known[check.needs] = told(answers, check.needs)
        needed.setdefault(check.needs, []).append(check)
        value, limit = check.value_of(known[check.needs]), check.limit_of(known[check.needs])
        passed, used = None, None
        if value is not None and limit is not None:
            zero = ((spec.heat and spec.heat.ambient) or 0.0) if check.unit == "K abs" else 0.0
            passed, used = bool(check.passes(value, limit)), check.utilisation(value, limit, zero)
        if not check.requirement and (passed is None or (passed and (math.isinf(limit) or not limit))):
            continue  # without value or effective limit only a requirement has a row
        if passed and check.value in (known[check.needs].get("open") or ()):
            passed = None  # the slip has not ended, so the value may still grow
        rows.append(row := _told(check, translate(check.name), value, limit, used, passed))
        if row.passed is None:
            needs = lacks(answers.quiet, check) if row.value is None else translate(_SLIP_ENDS)
            about: dict[str, Any] = {"name": row.name, "needs": needs}
            findings.append(finding("requirement-not-judged", "warning", limit=row.limit, path=row.path, **about))
    for part, checks in needed.items():
        findings += failures(spec, known[part], checks)
    rows += _spring_rows(answers, without)
    return rows, findings, [*left_out]


_PARTS: Mapping[Part | None, str] = {
    "simulate": deferred("the event"), "heat": deferred("heat of a trip"), "tolerance": deferred("scatter"),
}  # fmt: skip
_SLIP_ENDS = deferred("an end of the slip: drive.cut_off, or a longer drive.event.duration")


def lacks(clutch: Clutch, check: Check) -> str:
    """Text on what a check without a value needs: missing quantities of the clutch, else a block of the spec."""
    missing = clutch.missing(check.value) if check.needs is None or check.value in clutch.laws.laws else ()
    return ", ".join(missing) or translate(_BLOCKS.get(check.needs, f"`{check.needs}`"))


_BLOCKS: Mapping[Part | None, str] = {
    "simulate": deferred("[drive] with an event"), "heat": deferred("[drive] with an event and [heat]"),
    "tolerance": deferred("[tolerance]"), "effects": deferred("heat.lining"),
}  # fmt: skip
"""Analysis → text that names the blocks of the spec that it needs."""


def told(answers: Answers, part: Part | None) -> Known:
    """Name → value that the analysis ``part`` gives to checks (None: the clutch itself); empty if it does not apply."""
    clutch = answers.quiet
    own: Quantities = by_rule(clutch, answers.model)
    if part is None:
        undercut = "undercut_radius" in own and own["ball_radius_chosen"] >= own["undercut_radius"]
        return Beside({"contact_force_hertz": None, "contact_pressure": None}, own) if undercut else own
    if not ANALYSES[part].applies(clutch):
        return {}
    result = answers.ask(part)[0]
    if part == "simulate":
        if clutch.spec.drive.dynamic_factor is None:
            own = own.at(dynamic_factor=result.largest_dynamic_factor)
        return Beside(event_values(clutch, result), own)
    if part == "heat":
        return heat_values(result)
    if part == "tolerance":
        required = clutch.spec.requirements
        of_limit = required is not None and result.torque_limit == required.torque_max
        return {"exceedance": result.probability_above_limit if of_limit else None}
    if part == "effects":
        from .neglected import torque_after_wear

        return {"torque_after_wear": torque_after_wear(clutch, result)}
    return {"outer_diameter": result.outer_diameter, "length": result.length}


def _told(check: Check, name: str, value: Any, limit: Any, used: Any, passed: bool | None) -> CheckRow:
    """Row of a check with its value, limit and utilisation; a number that is not finite becomes None."""
    value, limit, used = (each if each is not None and math.isfinite(each) else None for each in (value, limit, used))
    return CheckRow(
        code=check.code.partition("/")[0], name=name, symbol=translate(check.symbol), value=value, limit=limit,
        unit=check.unit.removesuffix(" abs"), utilisation=used, passed=passed,
        **{name: getattr(check, name) for name in ("least", "level", "path", "needs")},
    )  # fmt: skip


def _spring_rows(answers: Answers, without: Collection[str]) -> Iterator[CheckRow]:
    """Yield rows for the checks of the spring parts, at the largest travel of the event if the event is simulated."""
    clutch, travel = answers.quiet, 0.0
    if not clutch.spec.spring_parts:
        return
    if ANALYSES["simulate"].applies(clutch) and "simulate" not in without:
        travels = answers.of(SimulateResult).travel_max
        travel = 0.0 if travels is None else max(vars(travels).values())
    for path, each in checks_of_springs(clutch, travel, answers.clutch.apply):
        rule, used = each.rule, each.utilisation
        if math.isfinite(used):
            spring = translate("closing spring" if path.startswith("closing") else "control spring")
            name = say("{spring}: {what}", spring=spring, what=translate(rule.name))
            rule = rule._replace(path=path, needs="springs")
            yield _told(rule, name, each.value, each.limit, used, used <= 1 + 1e-9)


# the sentence of the verdict


def _sentence(rows: list[CheckRow], findings: list[Finding], not_judged: list[str]) -> str:
    """Sentence on the worst finding: a missed requirement, else an error, else a warning; else ``_passed``."""
    beyond = sorted((row for row in rows if row.passed is False), key=lambda row: row.utilisation or math.inf)
    used = {(row.code, row.path): row.utilisation or math.inf for row in beyond}

    def gravity(remark: Finding) -> tuple[bool, bool, float]:
        share = used.get((remark.code, remark.path), 0.0)
        return remark.code == "requirement-missed", remark.level == "error", share

    grave = [each for each in findings if each.level != "info" and each.code != "requirement-not-judged"]
    if grave:
        worst = max(grave, key=gravity)
        if worst.code == "requirement-missed":
            said = say("The clutch misses a requirement: {what}.", what=worst.message)
        elif worst.level == "error":
            said = say("The clutch must not be made so: {what}.", what=worst.message)
        else:
            said = say("To be weighed: {what}.", what=worst.message)
    else:
        said = _passed(rows, so_far=bool(not_judged))
    if not not_judged:
        return said
    return say("{sentence} Not yet judged: {names}.", sentence=said, names=", ".join(not_judged))


def _passed(rows: list[CheckRow], *, so_far: bool) -> str:
    """Sentence on a clutch that passes, with the check nearest to its limit; checks set on their limit do not count."""
    shares = {
        row.utilisation: row for row in rows if row.utilisation is not None and row.passed and row.level != "info"
    }
    nearest = max((share for share in shares if share < _ON_LIMIT), default=0.0)
    required = any(row.is_requirement for row in rows)
    if not nearest and so_far:
        return say("What is judged so far passes.")
    if not nearest:
        return say("The clutch meets every requirement.") if required else say("The clutch passes every check.")
    name, share = shares[nearest].name, percent(nearest)
    if so_far:
        return say("What is judged so far passes; nearest: {name}, {share} of its limit.", name=name, share=share)
    if required:
        return say("The clutch meets every requirement; nearest: {name}, {share} of its limit.", name=name, share=share)
    return say("The clutch passes every check; nearest: {name}, {share} of its limit.", name=name, share=share)
