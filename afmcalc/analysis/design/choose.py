"""What helps to choose: what to relax, and of a front the neighbours of a clutch with what each of them gives up."""

import math
from collections import Counter
from collections.abc import Callable
from itertools import groupby

import numpy as np

from ...result import shown_as
from ...spec.edit import with_values
from ...spec.requirements import Requirements
from .candidates import rounded
from .pick import number_of
from .rows import Attainable, DesignResult, DesignRow, OfVariant, Trade
from .search import Survey
from .space import SAME_CLUTCH, Numbers


def focused(result: DesignResult) -> DesignResult:
    """Return only what is asked for by number: the clutch that is picked, or explained with its neighbours."""
    kept = {result.explained, *(trade.number for trade in result.neighbours or ())}
    shown = [row for row in result.front if row.number in kept]
    return result.model_copy(update={"front": shown, "excluded": {}, "of_variants": None})


def over_range(values: Numbers) -> Numbers:
    """Objectives of the rows of a front from their least on, each in parts of its range; far away what is infinite."""
    known = np.isfinite(values)
    low, high = (way(values, axis=0, where=known, initial=end) for way, end in ((np.min, np.inf), (np.max, -np.inf)))
    return np.where(known, (values - low) / np.where(high > low, high - low, np.inf), _FAR)


@np.errstate(all="ignore")
def with_neighbours(result: DesignResult, asked: int | str) -> DesignResult:
    """Return the result with the neighbours of a clutch: for each objective the nearest that is better in it.

    Near is measured in the objectives, each over its range on the front.

    Raises:
        CalculationError: no such number, or no knee.
    """
    number = number_of(result, "--explain", asked)
    values = np.array([[row.objective(name) for name in result.objectives] for row in result.front])
    here, scaled = values[number - 1], over_range(values)
    away = np.square(scaled - scaled[number - 1]).sum(axis=1)
    equal = (values == here) | (np.abs(values - here) <= SAME_CLUTCH * np.abs(here))
    nearest = [np.where(better, away, np.inf).argmin() for better in ((values < here) & ~equal).T if better.any()]
    trades = [
        Trade(
            number=result.front[place].number, variant=result.front[place].variant, objective=name,
            value=_known(there), instead_of=_known(now), change=_known(there / now - 1),
            unit=shown_as(DesignRow.model_fields[name]).unit, verdict="gains" if there < now else "gives up",
        )
        for place in dict.fromkeys(nearest)
        for name, there, now, same in zip(result.objectives, values[place], here, equal[place], strict=True)
        if not same
    ]  # fmt: skip
    return result.model_copy(update={"explained": number, "neighbours": trades})


_FAR = 1e9
"""Place of what is infinite, in ranges of an objective."""


def _known(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None


def of_variants(survey: Survey, on_front: list[DesignRow]) -> list[OfVariant] | None:
    """Count the candidates of each variant, where there are several, what excludes most of them first."""
    if len(survey.parts) < 2:
        return None
    front = Counter(row.variant for row in on_front)
    return [
        OfVariant(
            variant=name, candidates=part.candidates, feasible=part.feasible, on_front=front[name],
            excluded={reason: part.excluded[reason] for reason, count in survey.excluded.most_common() if count},
        )
        for name, part in survey.parts.items()
    ]  # fmt: skip


def relaxed(
    need: Requirements, feasible: int, misses: list[Attainable], again: Callable[[Requirements], DesignResult]
) -> list[Attainable]:
    """Say of each miss which key to relax and to what, in few digits; leave out what was tried and brings no clutch.

    What is missed together is relaxed together; what follows from the requirements, or from a catalogue, has no key.
    """
    told = []
    for _, together in groupby(misses, lambda row: row.together or row):
        rows = list(together)
        keys = [key for row in rows if (key := _key(need, row))]
        if len(keys) < len(rows):
            told += rows
            continue
        # what the gain may be is limited or not
        limits = [
            row.requirement != "gain_limit" and float(rounded(np.array(row.best), _DIGITS, up=row.sense == "at most"))
            for row in rows
        ]
        easier = again(with_values(need, dict(zip(keys, limits, strict=True))))
        if easier.on_front and easier.feasible > feasible:
            told += [
                row.model_copy(update={"key": key, "relax_to": limit or None, "feasible": easier.feasible})
                for row, key, limit in zip(rows, keys, limits, strict=True)
            ]
    return told


def _key(need: Requirements, row: Attainable) -> str | None:
    """Key of the requirements that holds the limit of a row."""
    if row.requirement == "closing_force" and need.search.closing_force is not None:
        return f"search.closing_force.{'max' if row.sense == 'at most' else 'min'}"
    if row.requirement == "housing_diameter":
        return "envelope.outer_diameter"
    for name in type(need).model_fields:
        if getattr(getattr(need, name), row.requirement, None) == row.limit:
            return f"{name}.{row.requirement}"
    return None


_DIGITS = 4
"""Digits of a limit that is proposed."""
