"""A clutch of a front for a drawing: in round figures, with springs that exist if wanted, right of every limit."""

import math
from dataclasses import replace
from functools import cache, partial
from itertools import product
from typing import NamedTuple

import numpy as np
from pydantic import BaseModel

from ...engines import Clutch, build
from ...errors import CalculationError, given
from ...findings import Finding
from ...messages import joined
from ...result import Result
from ...spec import Spec
from ...spec.edit import as_written
from ...spec.models import Drive
from ...spec.requirements import Choice, Requirements
from ...variants import VARIANTS
from ..answers import Answers
from ..check import check, found_unsimulated
from ..clutch_findings import clutch_findings
from ..limits import ring_pressures, shaft_findings
from ..registry import ANALYSES
from ..requirements import JUDGED, requirement_rows, simulates
from ..springs.springs import part_of, ranked
from ..synthesize import SynthesisResult
from ..torque import TorqueResult
from .candidates import candidates
from .limits import feasible, objectives
from .rows import DesignResult, DesignRow, as_spec, in_words, rows
from .space import SAME_CLUTCH, Axes, searched, with_lining

_LEVELS = (*range(9), *range(11, 33, 3))
"""Steps of round figures that are tried: of 5, 2 and 1 in the second digit, in the third, …; none has more than 12."""
_FINE = 8
"""The first with four digits: the spring force, which is set, has no fewer."""
_GIVEN_UP = 0.005
"""Share of an objective that round figures may cost, unless nothing else passes: less than to the next ball."""
_TRIED = 4
"""Roundings to as many digits that are given to a check, the best first."""
_STACKS = 5
"""Stacks of each spring that are tried."""
_PLAIN = ("pairs", "driving_pairs", "closing_stiffness", "control_stiffness", "ball_circle_radius", "mean_radius")
"""What is searched as it is told in a row; steering and an inner radius are told in other terms."""


def with_picked(need: Requirements, result: DesignResult, pick: int | str) -> tuple[DesignResult, Spec]:
    """Return the result with a clutch of its front in round figures as a row of its own, and as a spec that passes.

    Raises:
        CalculationError: no such number, no knee, or what fails a check, as it is and in round figures.
    """
    number = number_of(result, "--pick", pick)
    exact = result.front[number - 1]
    need = with_lining(need, exact)
    checked = cache(partial(made, need))  # the same figures come of several levels
    tried = (
        clutch
        for given_up, least in ((_GIVEN_UP, 0), (math.inf, _FINE))
        for level in _LEVELS
        if level >= least
        for row in _rounded(need, exact, level, given_up)
        if (clutch := checked(row)) is not None
    )
    chosen = next(tried, None) or checked(exact)
    if chosen is None:
        missed = judgement_of(build(as_spec(need, exact))).missed or ("springs",)
        raise CalculationError(
            "--pick {number}: a check fails it, as it is and in round figures: {missed}",
            number=number,
            missed=joined(map(in_words, missed)),
        )
    return result.model_copy(update={"picked": [_as_written(*chosen)]}), chosen.spec


def with_verdict(result: DesignResult, spec: Spec) -> tuple[DesignResult, list[Finding]]:
    """Return the result with what a check says of the clutch picked, and the findings of that check."""
    verdict, findings = check(build(spec))
    return result.model_copy(update={"verdict": verdict}), findings


def number_of(result: DesignResult, option: str, asked: int | str) -> int:
    """Number of a clutch of the front that an option asks for by it, or as the knee.

    Raises:
        CalculationError: no such number, or a front without a knee.
    """
    if asked == "knee":
        if result.knee is None:
            raise CalculationError(
                "{option} knee: the front has none; it takes two objectives and three clutches", option=option
            )
        return result.knee
    text = str(asked)
    for row in result.front:
        if str(row.number) == text.lstrip("0"):
            return row.number
    raise CalculationError(
        "{option} {number}: the front has the numbers 1 to {count}, and the knee",
        option=option, number=text, count=len(result.front),
    )  # fmt: skip


@np.errstate(all="ignore")
def _rounded(need: Requirements, row: DesignRow, level: int, given_up: float) -> list[DesignRow]:
    """Round what is searched between the ends of a range up or down; what holds every limit, with fewest digits first.

    Where an objective may be given up altogether, the best first.
    """
    variant = VARIANTS[row.variant]
    choices = searched(need, variant)
    angle, inner = row.wall_angle is not None, need.search.inner_radius
    values_of: dict[str, float | None] = {name: getattr(row, name) for name in _PLAIN}
    values_of |= {"steering": row.wall_angle if angle else row.gain, "inner_radius": None}
    if inner is not None:  # the mean radius is searched by the outer one
        values_of |= {"mean_radius": given(row.outer_diameter) / 2, "inner_radius": row.inner_radius}
        choices["inner_radius"] = inner
    sides = (
        _sides(value, choices.get(name), level, in_degrees=angle and name == "steering")
        for name, value in values_of.items()
    )
    tried = list(product(*sides))
    columns = dict(zip(values_of, np.array([[value for value, _ in each] for each in tried], float).T, strict=True))
    if inner is not None:
        columns["mean_radius"] = (columns["inner_radius"] + columns["mean_radius"]) / 2
    at = Axes(**columns)
    every = replace(candidates(need, variant, at), digits=max(4, level // 3 + 2))
    values, most = objectives(every), [row.objective(name) * (1 + given_up) for name in need.objectives]
    good = np.flatnonzero(feasible(every, np.asarray((values <= most).all(axis=1))))
    digits = np.array([sum(count for _, count in each) for each in tried]) * math.isfinite(given_up)
    best = good[np.lexsort((*values[good].T[::-1], digits[good]))][:_TRIED]
    chosen = rows(replace(every, at=at.at(best)))
    return [round_row.model_copy(update={"number": row.number, "mark": row.mark}) for round_row in chosen]


def _sides(value: float | None, choice: Choice | None, level: int, *, in_degrees: bool) -> list[tuple[float, int]]:
    """Round a value of a range down and up, by a decade larger steps too, within the range; any other stays.

    Beside each value stands how many digits it has; of what is not rounded they do not count.
    """
    if not value or choice is None or not choice.between:
        return [(np.nan if value is None else value, 0)]
    shown, back = (math.degrees, math.radians) if in_degrees else (float, float)
    near, whole = set(), shown(value)
    for decade, part in (divmod(each, 3) for each in (level - 3, level) if each >= 0):
        step = (5, 2, 1)[part] * 10.0 ** (math.floor(math.log10(whole)) - decade - 1)
        nearest = round(whole / step)
        is_one = math.isclose(whole, nearest * step, rel_tol=SAME_CLUTCH)
        counts = {nearest} if is_one else {math.floor(whole / step), math.ceil(whole / step)}
        near |= {min(max(back(float(f"{count * step:.12g}")), choice.start), choice.stop) for count in counts}
    return [(side, len(f"{shown(side):.12g}".partition("e")[0].replace(".", "").strip("0"))) for side in near]


def _as_written(spec: Spec, row: DesignRow) -> DesignRow:
    """Return a row with the values of the clutch as written, by the analyses that tell them."""
    clutch, group = build(spec), spec.friction_group
    answers = Answers(clutch)
    torque = answers.of(TorqueResult)
    results: list[Result] = [torque]
    if ANALYSES["synthesize"].applies(clutch):
        results.append(answers.of(SynthesisResult))
    values = {
        name: getattr(result, name) for result in results for name in DesignRow.model_fields if hasattr(result, name)
    }
    values |= {
        "mean_radius": float(clutch.mean_radius),
        "inner_radius": group.inner_radius,
        "outer_diameter": group.outer_radius and 2 * group.outer_radius,
        "torque_max": float(clutch.torque_max),
        "travel": torque.travel and max(vars(torque.travel).values()),
        "surface_pressure": ring_pressures(clutch).get("mean"),
    }
    for name, spring in (("closing", spec.closing_spring), ("control", spec.control_spring)):
        if spring is not None and spring.stiffness:
            values |= {f"{name}_stiffness": spring.stiffness}
            values |= {f"{name}_deflection": values[f"{name}_force"] / spring.stiffness}
    return row.model_copy(update={name: value for name, value in values.items() if getattr(row, name) is not None})


class Made(NamedTuple):
    """A clutch as it is written, with springs that exist where they are wanted, and its row."""

    spec: Spec
    row: DesignRow


def made(need: Requirements, row: DesignRow, *, simulated: bool = True, whole: bool = True) -> Made | None:
    """Write a row as a spec that passes a check, with the first springs, if wanted, with which it does.

    Springs that stay in their range come first: with them the sleeve travels farther, or less, than with straight ones.
    None where a check fails with all that are tried.
    """
    plain = as_spec(need, row)
    if need.springs is None:
        missed, told = judgement_of(build(plain), simulated=simulated, whole=whole)
        return None if missed else Made(plain, row.model_copy(update=told))
    lists = {demand.name: ranked(demand, need.springs, _STACKS) for demand in build(plain).spring_demands()}
    strayed = None
    for stacks in product(*lists.values()):
        springs, shown = {}, dict[str, str | float]()
        for name, stack in zip(lists, stacks, strict=True):
            # the forces stay
            spring = {stack.kind: part_of(stack, plain.lists.discs), "stiffness": stack.stiffness}
            springs[f"{name}_spring"] = getattr(plain, f"{name}_spring").model_copy(update=spring)
            numbers = (stack.parallel, stack.series) if stack.kind == "disc" else (stack.turns, stack.count)
            shown[f"{name}_part"] = "{}, {:g} × {:g}".format(stack.part, *numbers)
        clutch = build(as_written(plain.model_copy(update=springs)))
        missed, told = judgement_of(clutch, simulated=simulated, whole=whole)
        if missed:
            continue
        shown |= told
        if clutch.spec.kind.travels:
            # the force of disc springs is no straight line
            shown["torque_max_sprung"] = float(clutch.torque_max)
            shown["accuracy_factor_sprung"] = float(clutch.accuracy_factor)
        sprung = Made(clutch.spec, row.model_copy(update=shown))
        remarks = clutch_findings(clutch.spec, clutch.quantities)
        if not any(remark.level == "warning" and "_spring." in (remark.path or "") for remark in remarks):
            return sprung
        strayed = strayed or sprung
    return strayed


def judged(need: Requirements, row: DesignRow) -> tuple[DesignRow, tuple[str, ...]]:
    """Return a row with what is asked for of it as it is written, and what it misses of that."""
    if need.springs is not None:
        sprung = made(need, row, whole=False)
        return (row, ("springs",)) if sprung is None else (sprung.row, ())
    missed, told = judgement_of(build(as_spec(need, row)), whole=False)
    return row.model_copy(update=told), missed


class Judgement(NamedTuple):
    """What a check says of a clutch."""

    missed: tuple[str, ...]
    """Requirements missed or not judged, and the codes of other errors."""
    told: dict[str, float]
    """What it has of the requirements that a simulation or a sample answers, or the heat of a trip."""


def asked(required: BaseModel | None, drive: Drive | None) -> list[str]:
    """Requirements given that a simulation or a sample answers, or the heat of a trip."""
    names = {} if required is None else required.model_dump(exclude_none=True)
    answering = {"simulate", "heat", "tolerance"}
    if drive is not None and drive.event is not None and drive.dynamic_factor is None:
        answering.add("life")  # by the dynamic factor of the event
    return [name for name in names if name in JUDGED and JUDGED[name].analysis in answering]


def judgement_of(clutch: Clutch, *, simulated: bool = True, whole: bool = True) -> Judgement:
    """Give a clutch to a check, which simulates only what else passes, and only where that is asked for.

    Without ``whole`` of what takes long only those analyses are asked that answer what is required.
    """
    findings, told = found_unsimulated(clutch), dict[str, float]()
    names = asked(clutch.spec.requirements, clutch.spec.drive) if simulated else []
    if names and not _missed(findings, names):
        answers = Answers(clutch, scattered_peaks=False)  # no requirement is of these
        if whole:
            result, findings = check(clutch, answers=answers)
            required = result.requirements
        else:
            required, findings = requirement_rows(answers)
            analyses = {JUDGED[name].analysis for name in names}
            if simulates("heat", clutch) and analyses & {"simulate", "heat"}:
                analyses.add("simulate")
                findings += shaft_findings(answers)
            findings += [remark for analysis in sorted(analyses) for remark in answers.ask(analysis)[1]]
        told = {row.requirement: row.value for row in required if row.requirement in names and row.value is not None}
    return Judgement(_missed(findings, names), told)


def _missed(findings: list[Finding], names: list[str]) -> tuple[str, ...]:
    """What fails a clutch of a design: errors, a material beyond what it bears, what is asked for and not told."""
    failing = dict[str, None]()
    for remark in findings:
        name, code = (remark.path or "").removeprefix("requirements."), remark.code
        untold = code == "requirement-not-judged" and name in names
        if remark.level == "error" or code.endswith("-pressure-in-range") or untold:
            failing[name if code.startswith("requirement-") else code] = None
    return tuple(failing)
