"""A clutch of a front for a drawing: in round figures, on the right side of every limit."""

import math
from dataclasses import replace
from itertools import product

import numpy as np

from ...engines import build
from ...errors import CalculationError
from ...messages import say
from ...result import Result
from ...spec import Spec
from ...spec.choices import Choice
from ...spec.requirements import Requirements
from ...variants import VARIANTS
from ..answers import Answers
from ..checks.pressure import ring_pressures
from ..registry import ANALYSES
from ..torque import TorqueResult
from ..unit import SynthesisResult
from .by_law import candidates
from .candidates import rounded
from .design import DesignResult
from .limits import feasible, objectives
from .parts import Made, made
from .rows import DesignRow, as_spec, rows
from .space import Axes, given, searched

_DIGITS = range(4, 13)
"""Significant digits that are tried; no written number has more."""
_GIVEN_UP = 0.005
"""Share of an objective that round figures may cost, unless nothing else passes: less than to the next ball."""
_TRIED = 4
"""Roundings to as many digits that are given to a check, the best first."""


def picked(need: Requirements, result: DesignResult, number: int) -> Spec:
    """Return a clutch of the front as a spec of round figures that passes a check.

    Raises:
        CalculationError: no such number.
    """
    return with_picked(need, result, number)[1]


def with_picked(need: Requirements, result: DesignResult, number: int) -> tuple[DesignResult, Spec]:
    """Return the result with the clutch picked as a row of its own, and as a spec; the front stays exact."""
    if not 1 <= number <= len(result.front):
        raise CalculationError(
            say("--pick {number}: the front has the numbers 1 to {count}", number=number, count=len(result.front))
        )
    exact = result.front[number - 1]
    tried = (
        found
        for given_up, digits in product((_GIVEN_UP, math.inf), _DIGITS)
        for row in _rounded(need, exact, digits, given_up)
        if (found := made(need, row)) is not None
    )
    chosen = next(tried, Made(as_spec(need, exact), exact))
    return result.model_copy(update={"picked": [_as_written(*chosen)]}), chosen.spec


@np.errstate(all="ignore")
def _rounded(need: Requirements, row: DesignRow, digits: int, given_up: float) -> list[DesignRow]:
    """Round what is searched between the ends of a range up or down; what holds every limit, the best first."""
    variant = VARIANTS[row.variant]
    choices = searched(need, variant)
    sides = {name: _sides(getattr(row, name), choices.get(name), digits) for name in _PLAIN}
    angle = row.wall_angle is not None
    sides["steering"] = _sides(row.wall_angle if angle else row.gain, choices.get("steering"), digits, in_degrees=angle)
    radii = [(radius, np.nan) for radius in _sides(row.mean_radius, choices["mean_radius"], digits)]
    if need.search.inner_radius is not None:
        inner = _sides(row.inner_radius, need.search.inner_radius, digits)
        outer = _sides(given(row.outer_diameter) / 2, choices["mean_radius"], digits)
        radii = [((one + other) / 2, one) for one, other in product(inner, outer)]
    tried = [
        {**dict(zip(sides, values, strict=True)), "mean_radius": mean, "inner_radius": one}
        for values in product(*sides.values())
        for mean, one in radii
    ]
    at = Axes(*(np.array([each[name] for each in tried], float) for name in Axes._fields))
    every = replace(candidates(need, variant, at), digits=digits)
    values, most = objectives(every), [row.objective(name) * (1 + given_up) for name in need.objectives]
    good = np.flatnonzero(feasible(every, np.asarray((values <= most).all(axis=1))))
    best = good[np.lexsort(values[good].T[::-1])][:_TRIED]
    chosen = rows(replace(every, at=Axes(*(column[best] for column in at))))
    return [each.model_copy(update={"number": row.number, "mark": row.mark}) for each in chosen]


_PLAIN = ("pairs", "driving_pairs", "closing_stiffness", "control_stiffness", "ball_circle_radius")


def _sides(value: float | None, choice: Choice | None, digits: int, *, in_degrees: bool = False) -> list[float]:
    """Return a value of a range rounded down and up, to a digit less too, within the range; any other as it is."""
    if value is None or choice is None or not choice.between:
        return [np.nan if value is None else value]
    shown, back = (math.degrees(value), math.radians) if in_degrees else (value, float)
    ways = product((digits - 1, digits), (False, True))
    near = (back(float(rounded(np.array(shown), count, up=up))) for count, up in ways)
    return sorted({min(max(each, choice.start), choice.stop) for each in near})


def _as_written(spec: Spec, row: DesignRow) -> DesignRow:
    """Return a row with the values of the clutch as written, by the analyses that tell them."""
    clutch, group = build(spec), spec.friction_group
    answers = Answers(clutch)
    torque = answers.of(TorqueResult)
    found: list[Result] = [torque]
    if ANALYSES["synthesize"].applies(clutch):
        found.append(answers.of(SynthesisResult))
    values = {name: getattr(each, name) for each in found for name in DesignRow.model_fields if hasattr(each, name)}
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
