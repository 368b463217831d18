"""Which clutch is needed: the grid of a spec's [search], held to every check, and what no other candidate beats."""

import math
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import product
from typing import Any, Literal

import numpy as np
from pydantic import ConfigDict, PrivateAttr, SerializeAsAny, create_model

from ..drive.cases import simulate_clutches
from ..engines import Clutch, build
from ..engines.checks import CHECKS, REQUIRED
from ..engines.parts import spring_demands
from ..engines.selection import NAMES
from ..equations.terms import TERMS, term_of
from ..errors import AfmcalcError, CalculationError
from ..findings import Finding, finding
from ..messages import deferred, did_you_mean, measured, say, translate
from ..progress import tell, unwatched
from ..result import Answer, Result, described, quantity, shown_as
from ..spec import Spec
from ..spec.edit import as_written, value_at, with_values
from ..spec.keys import keys
from ..spec.search import SPRINGS
from ..units import ENGINEER
from .check import check, simulating
from .design_grid import (
    Nearest,
    Part,
    Row,
    Survey,
    candidate,
    equal_to,
    holding,
    name_of,
    parts_of_search,
    unbeaten,
    wired,
)
from .solve import is_quantity
from .spring_search import label_of, ranked, springs

_DEFAULT = ("closing_force", "accuracy_factor")
_TOLD = ("closing_force", "control_force", "accuracy_factor", "torque_max", "travel_max", "ball_diameter_standard")
"""Quantities that a row tells beside what is searched and what is small."""
_STACKS = 5
"""Springs of each kind that are tried."""
_FIRST = 10
"""Clutches of a front that are shown beside the compromise."""
_TOGETHER = 20
"""Candidates whose events are simulated together."""
_NO_SPRING = "no-spring"


def _in_words(code: str) -> str:
    """Say what a check is called, by its code or the key of its requirement."""
    return translate(_NAMES.get(code, code))


_NAMES = {
    **{name_of(check): check.name for check in reversed(CHECKS)},
    **{name: keys()[f"requirements.{name}"].description.partition(",")[0] for name in REQUIRED},
    "not-a-clutch": deferred("radii, pairs or friction out of order, or a gain below its threshold"),
    "parts-collide": deferred("parts that collide"),
    _NO_SPRING: deferred("springs to be had"),
}


def _small(objective: str) -> str:
    """Say what an objective is."""
    meaning = translate(term_of(objective.removeprefix("-")).meaning)
    return say("{quantity} (large)", quantity=meaning) if objective.startswith("-") else meaning


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
        """Path → value in the spec of this clutch."""
        return self._changes

    def objective(self, name: str) -> float:
        """Value of an objective; what a variant does not have costs nothing."""
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
    feasible: int = described("candidates that pass; events, heat and springs are judged for the front alone")
    objectives: list[str] = described("what is small on the front", in_words=_small)
    compromise: int | None = described("compromise: its number (least sum of the normalised objectives)", optional=True)
    excluded: dict[str, int] = described(
        "candidates excluded by each check", ranked=True, keys_are="check", in_words=_in_words
    )
    front: list[SerializeAsAny[DesignRow]] = described("the front", folds=True)
    binding: Binding | None = described("what excludes the nearest candidate", optional=True)


@np.errstate(all="ignore")
def design(spec: Spec) -> tuple[DesignResult, list[Finding]]:
    """Search the grid of a spec: the front, or what excludes the nearest candidate.

    Raises SpecError: no [search], or too many candidates; AfmcalcError: an objective that no clutch has.
    """
    objectives = list(spec.objectives or _DEFAULT)
    parts = parts_of_search(spec)
    _check_objectives(parts, objectives)
    survey = Survey(parts, objectives)
    judge = _Judge(spec, survey)
    places = judge.front()
    excluded = {code: count for code, count in (survey.excluded + judge.excluded).items() if count}
    front = _numbered(survey, objectives, places, judge)
    missed = None if front else _binding(spec, survey, judge)
    result = DesignResult(
        candidates=survey.candidates, feasible=survey.feasible - len(judge.failed), objectives=objectives,
        compromise=next((row.number for row in front if row.mark), None), excluded=excluded, front=front,
        binding=missed,
    )  # fmt: skip
    told = [_none(result, missed)] if missed else []
    if equals := equal_to(survey.costs, places):
        told.append(finding("front-equals", "info", value=equals))
    return result, [*spec.label.findings, *told]


def _check_objectives(parts: Sequence[Part], objectives: Sequence[str]) -> None:
    """Refuse an objective that no variant has, or that is no number."""
    clutches = [wired(with_values(part.base, part.values(np.arange(1)))) for part in parts]
    for name in objectives:
        asked = name.removeprefix("-")
        if not (any(asked in own for own in clutches) and is_quantity(asked)):
            hint = did_you_mean(asked, {known for own in clutches for known in own.names()})
            raise AfmcalcError("objectives: no quantity {name!r} of these clutches{hint}", name=asked, hint=hint)


class _Judge:
    """Asks of the members of the front, one by one, what is no array: springs, the event, a whole check."""

    def __init__(self, spec: Spec, survey: Survey) -> None:
        """Judge the feasible candidates of a survey."""
        self.spec, self.survey, self.failed = spec, survey, set[int]()
        self.passed: dict[int, tuple[Spec, dict[str, float], int]] = {}
        self.excluded = Counter[str]()
        self._ranks: list[tuple[int, float, int, Finding]] = []

    def front(self) -> list[int]:
        """Return the feasible candidates that pass and that none that passes beats; events are asked last."""
        alive, waiting = np.arange(self.survey.feasible), dict[int, tuple[Clutch, Iterator[Clutch]]]()
        while True:
            members = [int(member) for member in alive[unbeaten(self.survey.costs[alive])]]
            asked = [member for member in members if member not in self.passed]
            if not asked:
                return members
            new = [member for member in asked if member not in waiting]
            for member in new:
                judging = self._judge(member)
                with unwatched():
                    clutch = next(judging, None)
                if clutch is not None:
                    waiting[member] = clutch, judging
                self._tell(asked)
            for first in () if new else range(0, len(asked), _TOGETHER):
                few = [waiting.pop(member) for member in asked[first : first + _TOGETHER]]
                with unwatched():
                    simulate_clutches(clutch for clutch, _ in few)
                    for _, judging in few:
                        list(judging)
                self._tell(asked)
            alive = alive[~np.isin(alive, [*self.failed])]

    def _tell(self, asked: Sequence[int]) -> None:
        tell(say("checking the front"), len(self.passed), len(self.passed) + len(asked))

    def _judge(self, member: int) -> Iterator[Clutch]:
        """Judge a candidate with the best of the springs that are tried; yield each clutch before its event."""
        missed: list[Finding] = []
        for tried in self._with_springs(candidate(self.spec, self.survey.changes(member))):
            clutch = build(tried)
            slow, unasked = simulating(clutch), _unasked(tried)
            values, warnings, failed = judgement(clutch, slow)
            if slow - unasked and not failed:
                if clutch.spec.drive.event is not None:
                    yield clutch
                values, warnings, failed = judgement(clutch, slow & unasked)
            if not failed:
                self.passed[member] = tried, values, warnings
                return
            missed = min(filter(None, (missed, failed)), key=len)
        missed = missed or [Finding("error", _NO_SPRING, "")]
        self.failed.add(member)
        self.excluded.update({_counted(one) for one in missed})
        self._ranks.append((len(missed), sum(map(_beyond, missed)), member, max(missed, key=_beyond)))

    def nearest(self) -> Finding | None:
        """Return what the candidate misses by the most that misses the least; of springs what the nearest misses."""
        if not self._ranks:
            return None
        _, _, member, missed = min(self._ranks, key=lambda rank: rank[:3])
        if missed.code != _NO_SPRING:
            return missed
        found = springs(build(candidate(self.spec, self.survey.changes(member))), kind=self.kind)[1]
        return next(each for each in found if each.code == _NO_SPRING)

    @property
    def kind(self) -> Any:
        """Kind of springs that is searched; None: none is."""
        return (self.spec.search or {}).get(SPRINGS, (None,))[0]

    def _with_springs(self, plain: Spec) -> Iterator[Spec]:
        """Yield a spec with springs of the kind that is searched, the shortest first; as it is where none is."""
        if self.kind is None:
            yield plain
            return
        demands = spring_demands(build(plain))
        for options in product(*(ranked(demand, self.kind, _STACKS) for demand in demands)):
            springs = {}
            for demand, option in zip(demands, options, strict=True):
                name, update = f"{demand.name}_spring", {option.kind: option.made, "stiffness": option.stiffness}
                springs[name] = getattr(plain, name).model_copy(update=update)
            yield as_written(plain.model_copy(update=springs))


def _unasked(spec: Spec) -> set[str]:
    """Return what is sampled though no requirement asks for it."""
    return set() if spec.requirements is not None and spec.requirements.exceedance is not None else {"tolerance"}


def judgement(clutch: Clutch, without: Collection[str]) -> tuple[dict[str, float], int, list[Finding]]:
    """Return what a clutch has of its requirements, how many warnings, and what fails it, ``without`` some parts."""
    result, findings = check(clutch, without=without)
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
    """Return what a finding is counted as: the key of its requirement, or its code."""
    return (missed.path or "").removeprefix("requirements.") if missed.code.startswith("requirement-") else missed.code


def _beyond(missed: Finding) -> float:
    """Excess of a finding over its limit, as a share of that."""
    if not missed.limit or missed.value is None:
        return 1.0
    return abs(missed.value - missed.limit) / abs(missed.limit)


# rows


def _numbered(survey: Survey, objectives: Sequence[str], places: list[int], judge: _Judge) -> list[DesignRow]:
    """Return the rows of the front by their objectives, the compromise marked."""
    costs = survey.costs[places]
    best = _compromise(costs)
    columns = _columns(survey, objectives, judge)
    kind: Any = create_model("DesignRow", __base__=DesignRow, **columns)
    rows, told = list[DesignRow](), (*(name.removeprefix("-") for name in objectives), *_TOLD)
    for number, place in enumerate(places, 1):
        spec, judged, warnings = judge.passed[place]
        changes = survey.changes(place)
        own = wired(spec)
        values = {_column(path): value for path, value in changes.items()}
        values |= {"variant": spec.variant, "pairs": spec.friction_group.pairs}
        values |= {name: own[name] for name in told if name in own}
        values |= {name: value for name, value in judged.items() if name in columns}
        values |= {f"{name}_part": label_of(part) for name, part in spec.spring_parts.items()}
        known = {name: _known(value) for name, value in values.items() if name in kind.model_fields}
        mark = "compromise" if number - 1 == best else None
        row = kind(number=number, mark=mark, warnings=warnings, **known)
        row._changes = _changes(spec, changes)
        rows.append(row)
    return rows


def _compromise(costs: Any) -> int | None:
    """Return the row with the least sum of the objectives, each over its range; of fewer than three rows none."""
    if len(costs) < 3 or costs.shape[1] < 2:
        return None
    low, span = costs.min(axis=0), np.ptp(costs, axis=0)
    varied = span > _SAME * np.abs(costs).max(axis=0)
    return int(np.argmin(((costs - low) / np.where(varied, span, np.inf)).sum(axis=1)))


_SAME = 1e-8
"""Share of its values by which an objective that only rounding changes may vary."""


def _columns(survey: Survey, objectives: Sequence[str], judge: _Judge) -> dict[str, Any]:
    """Return the fields of a row: what is searched, what is small, what is told beside, what was simulated."""
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
    """Name of the column of a key: the quantity that it gives, else its path."""
    block, _, name = path.rpartition(".")
    if name == "material":
        return f"{block.partition('.')[2]}_material".removeprefix("_")
    return NAMES.get(block, {}).get(name, path.replace(".", "_"))


def _known(value: Any) -> Any:
    """Return a value of a row: None of a number that is not finite."""
    return value if isinstance(value, str) else np.asarray(value).item() if np.all(np.isfinite(value)) else None


def _changes(spec: Spec, changes: Mapping[str, Any]) -> dict[str, Any]:
    """Return the values that make a spec this clutch: those searched with the ball, and the springs."""
    made = {path: _known(value) for path, value in changes.items()}
    for name, part in spec.spring_parts.items():
        own = getattr(spec, f"{name}_spring")
        made |= {f"{name}_spring.stiffness": own.stiffness}
        kind = "disc" if own.disc is not None else "coil"
        made |= {f"{name}_spring.{kind}": part.model_dump(exclude_none=True)}
    return made


def picked(spec: Spec, result: DesignResult, pick: int | str) -> tuple[DesignRow, Spec]:
    """Return a clutch of a front by its number, or as the compromise, and its spec.

    Raises CalculationError: no such number, or a front without a compromise.
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
    """Return the result with its front by a quantity: the first rows and the compromise, or all; their numbers stay.

    Raises AfmcalcError: to be sorted by what is no number of a row.
    """
    ordered = result.front
    if sort is not None and ordered:
        numbers = [name for name, field in type(ordered[0]).model_fields.items() if shown_as(field).unit] + ["number"]
        if sort not in numbers:
            raise AfmcalcError(
                "--sort {name}: no such quantity{hint}; one of {known}",
                name=sort, hint=did_you_mean(sort, numbers), known=", ".join(numbers),
            )  # fmt: skip
        ordered = sorted(ordered, key=lambda row: row.objective(sort))
    if not whole:
        ordered = [row for place, row in enumerate(ordered) if place < _FIRST or row.mark]
    return result.model_copy(update={"front": ordered})


# nothing

_SCALES = [float(f"{scale:.3g}") for scale in np.geomspace(0.25, 4.0, 201)]


def _binding(spec: Spec, survey: Survey, judge: _Judge) -> Binding:
    """Return what excludes the nearest candidate: a check asked of all, or one asked one by one."""
    if (missed := judge.nearest()) is not None:
        name, value, limit, message, path = _counted(missed), missed.value, missed.limit, missed.message, missed.path
        unit = (keys()[f"requirements.{name}"].unit if name in REQUIRED else None) or "1"
        key = None
    else:
        assert survey.nearest is not None
        row, key = survey.nearest.row, _key_that_would_do(spec, survey.nearest)
        name, value, limit, message = name_of(row.check), _known(row.value), _known(row.limit), _missed(row)
        path, unit = row.check.path, row.check.unit
    told: dict[str, Any] = {"check": name, "value": value, "limit": limit, "message": message, "unit": unit}
    if key is not None:
        told |= key
    elif path == f"requirements.{name}" and value is not None:  # what is asked would have to give way
        least = REQUIRED[name].least
        told |= {"key": path, "sign": "≤" if least else "≥", "would_do": _five_digits(value, least), "key_unit": unit}
    return Binding(**{"key_unit": "1"} | told)


def _five_digits(value: float, down: bool) -> float:  # noqa: FBT001
    """Number rounded to five digits, down or up, so that what is printed will do."""
    step = 10.0 ** (math.floor(math.log10(abs(value))) - 4) if value else 1.0
    return float(f"{(math.floor if down else math.ceil)(value / step) * step:.5g}")


def _missed(row: Row) -> str:
    """Say what a candidate has of a check, and what it is to have."""
    check, value, limit = row
    first, _, second = check.value.partition("/")
    if second:
        return say(
            "{first} and {second} collide by at least {missing:.4g mm}",
            first=translate(first), second=translate(second), missing=value,
        )  # fmt: skip
    has, wanted = (measured(number, ENGINEER.get(check.unit, check.unit), 5) for number in (value, limit))
    bound = translate("at least" if check.least else "at most")
    return say("{name} {has}, {bound} {wanted}", name=translate(check.name), has=has, bound=bound, wanted=wanted)


def _key_that_would_do(spec: Spec, near: Nearest) -> dict[str, Any] | None:
    """Return the key, and its value nearest to the candidate's, with which all checks hold, as fields of a binding.

    It is one that is searched, else that of the check, or the circle of the balls.
    """
    base = candidate(spec, near.changes)
    own = "" if near.row.check.requirement else near.row.check.path
    fixed = {path: value_at(base, path) for path in (own, _BALL_CIRCLE) if path in keys()}
    for prefix, paths in (("search.", near.changes), ("", fixed)):
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


_BALL_CIRCLE = "control_unit.ball_circle_radius"


def _none(result: DesignResult, missed: Binding) -> Finding:
    """Say that nothing holds every check, what is nearest, and what would do."""
    told: dict[str, Any] = {"candidates": result.candidates, "missed": missed.message}
    if missed.key is None or missed.would_do is None:
        return finding("no-candidate", "error", value=0.0, **told)
    would = measured(missed.would_do, ENGINEER.get(missed.key_unit, missed.key_unit), 5)
    return finding("no-candidate/key", "error", value=0.0, key=missed.key, sign=missed.sign, would=would, **told)
