"""Design of a clutch: the grid of a spec's [search], every check, and the Pareto front of the clutches that pass."""

import math
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import chain, islice, product
from typing import Any, Literal

import numpy as np
from pydantic import ConfigDict, PrivateAttr, SerializeAsAny, create_model

from ..drive.cases import simulate_clutches
from ..engines import Clutch, build
from ..engines.checks import CHECKS, REQUIRED
from ..engines.selection import NAMES
from ..equations.terms import TERMS, term_of
from ..errors import AfmcalcError, CalculationError
from ..findings import Finding, finding
from ..messages import deferred, did_you_mean, measured, say, translate
from ..progress import tell, unwatched
from ..result import Answer, Result, described, quantity, shown_as
from ..spec import Spec
from ..spec.edit import as_written, candidate, value_at, with_values
from ..spec.keys import keys
from ..spec.search import SPRINGS
from ..units import ENGINEER
from .asking import Answers
from .check import check, simulating
from .design_grid import (
    WARNINGS,
    Survey,
    equal_to,
    holding,
    name_of,
    parts_of_search,
    unbeaten,
    wired,
    with_ball,
)
from .solve import is_quantity
from .spring_search import bounded_demands, label_of, ranked, springs

_DEFAULT = ("closing_force", "accuracy_factor")
_SAME = 1e-8
"""Range of an objective, relative to its largest magnitude, up to which it counts as a rounding error."""
_TOLD = (
    "closing_force", "control_force", "accuracy_factor", "torque_max", "trip_ratio_min", "trip_ratio_max", "travel_max",
    "ball_diameter_standard",
)  # fmt: skip
"""Quantities that a row shows besides the searched keys and the objectives."""
_STACKS = 5
"""Number of parts that are tried for each spring."""
_FIRST = 10
"""Number of clutches of a front that are shown, besides the compromise."""
_TOGETHER = 50
"""Number of candidates whose events are simulated together."""
_NO_SPRING = "no-spring"


def _in_words(code: str) -> str:
    """Return the name of a check in words; ``code`` is the code of the check, or the key of its requirement."""
    return translate(_NAMES.get(code, code))


_NAMES = {
    **{name_of(check): check.name for check in reversed(CHECKS)},
    **{name: keys()[f"requirements.{name}"].description.partition(",")[0] for name in REQUIRED},
    "not-a-clutch": deferred("radii, pairs or friction out of order, or a gain below its threshold"),
    "parts-collide": deferred("parts that collide"),
    _NO_SPRING: deferred("springs to be had"),
}
_UNITS = {name_of(check): check.unit for check in CHECKS}


def _small(objective: str) -> str:
    """Return the name of a quantity in words."""
    return translate(term_of(objective).meaning)


class DesignRow(Result):
    """One clutch of the front; beside the number what is searched, what is small, and what else it has."""

    model_config = ConfigDict(json_schema_extra={"additionalProperties": True})

    number: int = quantity("", "no.", "number, for --pick")
    mark: Literal["compromise"] | None = described("mark", optional=True, null="")
    variant: str = described("variant")
    pairs: int = quantity("1", "z", "friction pairs")
    warnings: int = described("warnings of check")

    _changes: dict[str, Any] = PrivateAttr(default_factory=dict)

    @property
    def changes(self) -> dict[str, Any]:
        """Path → value of the keys that the design sets in the spec of this clutch."""
        return self._changes

    def objective(self, name: str) -> float:
        """Value of an objective; 0 if the clutch has no such quantity."""
        return float(getattr(self, name.removeprefix("-"), None) or 0.0)


class Binding(Result):
    """Constraint that excludes the candidate nearest to all checks, and the value that would do."""

    check: str = described("check that excludes the nearest candidate", in_words=_in_words)
    message: str = described("what it misses")
    value: float | None = described("its value", unit_in="unit", optional=True)
    limit: float | None = described("limit", unit_in="unit", optional=True)
    unit: str = described("unit", is_unit=True)
    key: str | None = described("key to change", code=True, optional=True)
    sign: Literal["≥", "≤"] | None = described("to be at least, or at most", code=True, optional=True)
    would_do: float | None = described("value of the key that would do", unit_in="key_unit", optional=True)
    key_unit: str = described("unit of the key", is_unit=True)


class DesignResult(Answer):
    """The front of a design: points of the grid."""

    candidates: int = described("candidates searched")
    feasible: int = described(
        "candidates not excluded; only those that come to the front are asked for events, heat and springs"
    )
    objectives: list[str] = described(
        "what is small on the front",
        in_words=lambda name: say("{quantity} (large)", quantity=_small(name[1:])) if name[0] == "-" else _small(name),
    )
    compromise: int | None = described("compromise: its number (least sum of the normalised objectives)", optional=True)
    excluded: dict[str, int] = described(
        "candidates excluded by each check", ranked=True, keys_are="check", in_words=_in_words
    )
    front: list[SerializeAsAny[DesignRow]] = described("the front", folds=True)
    binding: list[Binding] = described("what excludes the nearest candidate")


@np.errstate(all="ignore")
def design(spec: Spec, sort: str | None = None) -> tuple[DesignResult, list[Finding]]:
    """Search the grid of a spec; return the front or, if it is empty, the checks that exclude the nearest candidate.

    Raises SpecError if there is no [search], or if it has too many candidates; AfmcalcError if an objective is no
    quantity of any candidate, or if ``sort`` is not a number in the rows of the front.
    """
    objectives = list(spec.objectives or _DEFAULT)
    parts = parts_of_search(spec)
    clutches = [wired(with_values(part.base, part.values(np.arange(1)))) for part in parts]
    for name in (objective.removeprefix("-") for objective in objectives):
        if not any(name in own for own in clutches):
            try:
                clutches[0][name]
            except LookupError as error:
                raise AfmcalcError("objectives: {why}", why=error.args[0]) from None
        if not is_quantity(name):
            raise AfmcalcError("objectives: {name} is no number", name=name)
    survey = Survey(parts, objectives)
    judge = _Judge(spec, survey)
    numbers = [name for name, (_, field) in _columns(survey, objectives, judge).items() if shown_as(field).unit]
    numbers += [name for name, row in REQUIRED.items() if row.needs and getattr(spec.requirements, name, None)]
    if sort is not None and sort not in (numbers := ["number", "pairs", *numbers]):
        raise AfmcalcError(
            "--sort {name}: no such quantity{hint}; one of {known}",
            name=sort, hint=did_you_mean(sort, numbers), known=", ".join(numbers),
        )  # fmt: skip
    places = judge.front()
    excluded = {code: count for code, count in (survey.excluded + judge.excluded).items() if count}
    front = _numbered(survey, objectives, places, judge)
    missed = [] if front else _binding(spec, survey, judge)
    result = DesignResult(
        candidates=survey.candidates, feasible=survey.feasible - len(judge.failed), objectives=objectives,
        compromise=next((row.number for row in front if row.mark), None), excluded=excluded, front=front,
        binding=missed,
    )  # fmt: skip
    told = [] if front else [_none(result)]
    if front:  # the torque at which an ordinary clutch in place of the compromise would trip
        number = result.compromise or 1
        own = wired(judge.passed[places[number - 1]][0])
        least, ordinary, largest = (own[f"trip_ratio_{name}"] for name in ("min", "ordinary", "max"))
        told = [finding("ordinary-trips-at", "info", value=ordinary, limit=largest, least=least, number=number)]
    if equals := equal_to(survey.costs, places):
        told.append(finding("front-equals", "info", value=equals))
    return result, [*spec.label.findings, *told]


class _Judge:
    """Judge of the candidates on the front, one by one: springs, events, the whole check, all impossible by arrays."""

    def __init__(self, spec: Spec, survey: Survey) -> None:
        """Judge the feasible candidates of a survey."""
        self.spec, self.survey, self.failed = spec, survey, set[int]()
        self.passed: dict[int, tuple[Spec, dict[str, float], int]] = {}
        self.excluded = Counter[str]()
        self._ranks: list[tuple[int, float, int, list[Finding]]] = []

    def front(self) -> list[int]:
        """Return the passing candidates that no other passing candidate dominates."""
        alive = np.arange(self.survey.feasible)
        while True:
            members = [int(member) for member in alive[unbeaten(self.survey.costs[alive])]]
            asked = [member for member in members if member not in self.passed]
            if not asked:
                return members
            for first in range(0, len(asked), _TOGETHER):
                judging = [self._judge(member) for member in asked[first : first + _TOGETHER]]
                with unwatched():
                    simulate_clutches(list(chain(*(islice(each, 1) for each in judging))))
                    for each in judging:
                        list(each)
                tell(say("checking the front"), len(self.passed), len(self.passed) + len(asked))
            alive = alive[~np.isin(alive, [*self.failed])]

    def _judge(self, member: int) -> Iterator[Clutch]:
        """Judge a candidate with each choice of springs until it passes; a clutch is yielded before it is simulated."""
        missed: list[Finding] = []
        for tried in self._with_springs(candidate(self.spec, self.survey.changes(member))):
            clutch, required = build(tried), tried.requirements
            answers, slow = Answers(clutch), simulating(clutch)
            unasked = set() if required and required.exceedance is not None else {"tolerance"}
            values, warnings, failed = judgement(answers, slow)
            if slow - unasked and not failed:
                if tried.drive.event is not None:
                    yield clutch
                values, warnings, failed = judgement(answers, slow & unasked)
            if not failed:
                self.passed[member] = tried, values, warnings
                return
            missed = min(filter(None, (missed, failed)), key=len)
        missed = missed or [Finding("error", _NO_SPRING, "")]
        self.failed.add(member)
        self.excluded.update({_counted(one) for one in missed})
        self._ranks.append((len(missed), sum(map(_beyond, missed)), member, missed))

    def nearest(self) -> list[Finding]:
        """Return the findings on the candidate that fails the fewest checks, or on its nearest springs if none fit."""
        if not self._ranks:
            return []
        _, _, member, missed = min(self._ranks, key=lambda rank: rank[:3])
        if missed[0].code == _NO_SPRING:
            found = springs(build(candidate(self.spec, self.survey.changes(member))), kind=self.kind)[1]
            return [each for each in found if each.code == _NO_SPRING]
        return missed

    @property
    def kind(self) -> Any:
        """Kind of springs that is searched, disc or coil; None if no springs are searched."""
        return (self.spec.search or {}).get(SPRINGS, (None,))[0]

    def _with_springs(self, plain: Spec) -> Iterator[Spec]:
        """Yield the spec with each choice of springs, the best first; unchanged if no springs are searched."""
        if self.kind is None:
            yield plain
            return
        demands = bounded_demands(build(plain))
        for options in product(*(ranked(demand, self.kind, _STACKS) for demand in demands)):
            springs = {}
            for demand, option in zip(demands, options, strict=True):
                name, update = f"{demand.name}_spring", {option.kind: option.made, "stiffness": option.stiffness}
                springs[name] = getattr(plain, name).model_copy(update=update)
            yield as_written(plain.model_copy(update=springs))


def judgement(answers: Answers, without: Collection[str]) -> tuple[dict[str, float], int, list[Finding]]:
    """Return the values of requirements by analyses, the number of warnings, and the findings that exclude a clutch."""
    result, findings = check(answers.clutch, answers=answers, without=without)
    rows = {row.path: row for row in result.checks if row.is_requirement and row.needs}
    unknown = {path for path, row in rows.items() if row.passed is None}
    failed = [
        each
        for each in findings
        if each.level == "error" or (each.code == "requirement-not-judged" and each.path in unknown)
    ]
    told = {str(path).rpartition(".")[2]: row.value for path, row in rows.items()}
    return {name: value for name, value in told.items() if value is not None}, result.warnings, failed


def _counted(missed: Finding) -> str:
    """Return the name under which a finding is counted: the key of its requirement, or its code."""
    return (missed.path or "").removeprefix("requirements.") if missed.code.startswith("requirement-") else missed.code


def _beyond(missed: Finding) -> float:
    """Excess of the value of a finding over its limit, relative to the limit; 1 if the finding has no limit."""
    if not missed.limit or missed.value is None:
        return 1.0
    return abs(missed.value - missed.limit) / abs(missed.limit)


# rows


def _numbered(survey: Survey, objectives: Sequence[str], places: list[int], judge: _Judge) -> list[DesignRow]:
    """Return the rows of the front, numbered, with the compromise marked."""
    costs, best = survey.costs[places], None
    if len(costs) > 2 and costs.shape[1] > 1:  # least sum of the normalised objectives
        low, span = costs.min(axis=0), np.ptp(costs, axis=0)
        varied = span > _SAME * np.abs(costs).max(axis=0)
        best = int(np.argmin(((costs - low) / np.where(varied, span, np.inf)).sum(axis=1)))
    kind: Any = create_model("DesignRow", __base__=DesignRow, **_columns(survey, objectives, judge))
    rows, told = list[DesignRow](), (*(name.removeprefix("-") for name in objectives), *_TOLD)
    for number, place in enumerate(places, 1):
        spec, judged, warnings = judge.passed[place]
        changes = survey.changes(place)
        own = wired(spec)
        values = {_column(path): value for path, value in changes.items()}
        values |= {"variant": spec.variant, "pairs": spec.friction_group.pairs}
        values |= {name: own[name] for name in told if name in own}
        values |= judged
        values |= {f"{name}_part": label_of(part) for name, part in spec.spring_parts.items()}
        known = {name: _known(value) for name, value in values.items() if name in kind.model_fields}
        mark = "compromise" if number - 1 == best else None
        row = kind(number=number, mark=mark, warnings=warnings, **known)
        row._changes = _changes(spec, changes)
        rows.append(row)
    return rows


def _columns(survey: Survey, objectives: Sequence[str], judge: _Judge) -> dict[str, Any]:
    """Return the fields of a row: searched keys, objectives, the quantities of ``_TOLD``, requirements, springs."""
    told: dict[str, tuple[type, str, str | None, str]] = {}
    for path in dict.fromkeys(path for part in survey.parts for path in (*part.names, *part.axes)):
        name, key = _column(path), keys()[path]
        if key.about is None:
            told[name] = str, "", None, name.replace("_", " ")
        else:
            meaning = TERMS[name].meaning if name in TERMS else path
            told[name] = int if key.about.whole else float, key.unit or "1", key.symbol, meaning
    for name in (*(name.removeprefix("-") for name in objectives), *_TOLD):
        symbol, unit, meaning = term_of(name)
        told.setdefault(name, (float, unit, symbol, meaning))
    for name in sorted({name for _, values, _ in judge.passed.values() for name in values}):
        key = keys()[f"requirements.{name}"]
        told.setdefault(name, (float, key.unit or "1", key.symbol, key.description.partition(",")[0]))
    for name in (name for spec, *_ in judge.passed.values() for name in spec.spring_parts):
        told.setdefault(f"{name}_part", (str, "", None, f"{name} spring"))
    return {
        name: (kind | None, quantity(unit, symbol, meaning, optional=True, code=kind is str))
        for name, (kind, unit, symbol, meaning) in told.items()
        if name not in DesignRow.model_fields
    }


def _column(path: str) -> str:
    """Name of the column for a key: the name of the quantity that the key gives, else the path of the key."""
    block, _, name = path.rpartition(".")
    if name == "material":
        return f"{block.partition('.')[2]}_material".removeprefix("_")
    return NAMES.get(block, {}).get(name, path.replace(".", "_"))


def _known(value: Any) -> Any:
    """Return a value as stored in a row; None for a number that is not finite."""
    return value if isinstance(value, str) else np.asarray(value).item() if np.all(np.isfinite(value)) else None


def _changes(spec: Spec, changes: Mapping[str, Any]) -> dict[str, Any]:
    """Return key → value of a candidate: the searched keys, its ball, and its springs."""
    made = {path: _known(value) for path, value in changes.items()}
    for name, part in spec.spring_parts.items():
        own = getattr(spec, f"{name}_spring")
        made |= {f"{name}_spring.stiffness": own.stiffness}
        kind = "disc" if own.disc is not None else "coil"
        made |= {f"{name}_spring.{kind}": part.model_dump(exclude_none=True)}
    return made


def picked(spec: Spec, result: DesignResult, pick: int | str) -> tuple[DesignRow, Spec]:
    """Return the row of a clutch, chosen by its number or as the compromise, and its spec.

    Raises CalculationError if no row has the number, or if the front has no compromise.
    """
    number = result.compromise if pick == "compromise" else pick
    for row in result.front:
        if str(row.number) == str(number):
            return row, candidate(spec, row.changes)
    if number is None:
        raise CalculationError("--pick compromise: it takes two objectives and three clutches")
    raise CalculationError(
        "--pick {number}: the front has the numbers 1 to {count}, and the compromise",
        number=number,
        count=len(result.front),
    )


def shown(result: DesignResult, sort: str | None = None, *, whole: bool = False) -> DesignResult:
    """Return the result with its front sorted: the first rows and the compromise, or all rows, with their numbers."""
    ordered = result.front
    if sort is not None:
        ordered = sorted(ordered, key=lambda row: row.objective(sort))
    if not whole:
        ordered = [row for place, row in enumerate(ordered) if place < _FIRST or row.mark]
    return result.model_copy(update={"front": ordered})


# no candidate passes

_SCALES = [float(f"{scale:.3g}") for scale in np.geomspace(0.25, 4.0, 201)]


def _binding(spec: Spec, survey: Survey, judge: _Judge) -> list[Binding]:
    """Return the checks that exclude the nearest candidate of those judged one by one, else of the whole grid."""
    failed, changes = judge.nearest(), None
    if not failed and survey.nearest is not None:
        _, changes, ball = survey.nearest
        clutch = build(candidate(spec, changes | with_ball(ball)))
        found = check(clutch, without=simulating(clutch))[1]
        failed = [each for each in found if each.level == "error" or each.code in WARNINGS]
    failed.sort(key=_beyond, reverse=True)
    missed = [_missed(each) for each in failed]
    would_do = None if changes is None else _key_that_would_do(spec, changes, failed[0].path)
    if would_do is not None:
        return [each.model_copy(update=would_do if each is missed[0] else _NO_KEY) for each in missed]
    # easing requirements to the candidate's values helps only if every missed check is a requirement
    return missed if all(each.key for each in missed) else [each.model_copy(update=_NO_KEY) for each in missed]


_NO_KEY: dict[str, Any] = {"key": None, "sign": None, "would_do": None, "key_unit": "1"}


def _missed(found: Finding) -> Binding:
    """Return a missed check; a requirement also gets the limit that the candidate's value would meet."""
    name, eased = _counted(found), _NO_KEY
    unit = (keys()[f"requirements.{name}"].unit if name in REQUIRED else _UNITS.get(name)) or "1"
    if found.path == f"requirements.{name}" and found.value is not None:
        least = REQUIRED[name].least
        would_do = _five_digits(found.value, least)
        eased = {"key": found.path, "sign": "≤" if least else "≥", "would_do": would_do, "key_unit": unit}
    return Binding(check=name, message=found.message, value=found.value, limit=found.limit, unit=unit, **eased)


def _five_digits(value: float, down: bool) -> float:  # noqa: FBT001
    """Value rounded down or up to five digits, so that the printed number still passes the check."""
    step = 10.0 ** (math.floor(math.log10(abs(value))) - 4) if value else 1.0
    return float(f"{(math.floor if down else math.ceil)(value / step) * step:.5g}")


def _key_that_would_do(spec: Spec, changes: Mapping[str, Any], worst: str | None) -> dict[str, Any] | None:
    """Return a key and its value nearest to the candidate's with which all checks pass, as fields of a ``Binding``.

    The key is a searched key, else the key of the worst check or one that sizes the clutch.
    """
    base = candidate(spec, changes)
    fixed = {path: value_at(base, path) for path in (worst, *_SIZES) if path in keys() and path not in _REQUIRED}
    for prefix, paths in (("search.", changes), ("", fixed)):
        found = []
        for path, value in paths.items():
            about = keys()[path].about
            if about is None or not value:
                continue
            tried = np.array(_SCALES) * value
            tried = np.unique(np.round(tried)) if about.whole else np.array([float(f"{one:.3g}") for one in tried])
            low, high = about.limits
            tried = tried[(tried > low) & (tried < high)]
            many = with_values(base, {path: tried})
            good = holding(many, wired(many), tried.shape)
            found += [(abs(math.log(one / value)), path, float(one), value) for one in tried[good]]
        if found:
            _, path, would_do, value = min(found)
            sign = "≥" if would_do > value else "≤"
            return {"key": prefix + path, "sign": sign, "would_do": would_do, "key_unit": keys()[path].unit or "1"}
    return None


_SIZES = (
    "control_unit.ball_circle_radius", "control_unit.balls", "friction_group.inner_radius",
    "friction_group.outer_radius", "friction_group.pairs", "adjustment.nominal_torque",
)  # fmt: skip
_REQUIRED = {f"requirements.{name}" for name in REQUIRED}


def _none(result: DesignResult) -> Finding:
    """Return the finding that no candidate passes: checks that the nearest fails, and values with which it passes."""
    missed = "; ".join(each.message for each in result.binding)
    would_do = ", ".join(
        f"{each.key} {each.sign} {measured(each.would_do, ENGINEER.get(each.key_unit, each.key_unit), 5)}"
        for each in result.binding
        if each.would_do is not None
    )
    told: dict[str, Any] = {"value": 0.0, "candidates": result.candidates, "missed": missed}
    if would_do:
        return finding("no-candidate/key", "error", would_do=would_do, **told)
    return finding("no-candidate", "error", **told)
