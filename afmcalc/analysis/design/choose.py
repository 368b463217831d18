"""What helps to choose: what to relax, and of a front the neighbours of a clutch with what each of them gives up."""

import math
from collections import Counter
from collections.abc import Callable
from itertools import groupby
from typing import TypeVar

import numpy as np
from pydantic import BaseModel

from ...result import shown_as
from ...spec.requirements import Requirements
from .candidates import rounded
from .pick import number_of
from .rows import Attainable, DesignResult, DesignRow, OfVariant, Trade
from .search import Survey
from .space import SAME_CLUTCH, Numbers, given

T = TypeVar("T", bound=BaseModel)


def with_neighbours(result: DesignResult, asked: int | str) -> DesignResult:
    """Return the result with the neighbours of a clutch of its front.

    Raises:
        CalculationError: no such number, or no knee.
    """
    number = number_of(result, "--explain", asked)
    return result.model_copy(update={"explained": number, "neighbours": trades(result, number)})


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
def trades(result: DesignResult, number: int) -> list[Trade]:
    """Return what the neighbours of a clutch gain and give up: for each objective the nearest that is better in it.

    Near is measured in the objectives, each over its range on the front.
    """
    values = np.array([[row.objective(name) for name in result.objectives] for row in result.front])
    here, scaled = values[number - 1], over_range(values)
    away = np.square(scaled - scaled[number - 1]).sum(axis=1)
    equal = (values == here) | (np.abs(values - here) <= SAME_CLUTCH * np.abs(here))
    nearest = [np.where(better, away, np.inf).argmin() for better in ((values < here) & ~equal).T if better.any()]
    return [
        Trade(
            number=result.front[place].number,
            variant=result.front[place].variant,
            objective=name,
            value=_known(there),
            instead_of=_known(now),
            change=_known(there / now - 1),
            unit=shown_as(DesignRow.model_fields[name]).unit,
            verdict="gains" if there < now else "gives up",
        )
        for place in dict.fromkeys(nearest)
        for name, there, now, same in zip(result.objectives, values[place], here, equal[place], strict=True)
        if not same
    ]


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
    need: Requirements, feasible: int, misses: list[Attainable], again: Callable[[Requirements], DesignResult] | None
) -> list[Attainable]:
    """Say of each miss which key to relax and to what, in few digits; leave out what was tried and brings no clutch.

    What is missed together is relaxed together; what follows from the requirements, or from a catalogue, has no key.
    Without ``again``, which searches, nothing is tried: the misses are those of a clutch that a check has judged.
    """
    told = []
    for _, together in groupby(misses, lambda row: row.together or row):
        rows = list(together)
        named = [row.model_copy(update={"key": _key(need, row), "relax_to": _outward(row)}) for row in rows]
        if not all(row.key for row in named):
            told += rows
            continue
        easier = need
        for row in named:
            easier = _with(easier, given(row.key).split("."), row.relax_to if row.relax_to is not None else False)
        found = again(easier) if again else None
        if found is None:
            told += named
        elif found.on_front and found.feasible > feasible:
            told += [row.model_copy(update={"feasible": found.feasible}) for row in named]
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


def _outward(row: Attainable) -> float | None:
    """Limit that lets the best of a row pass, in as few digits as a reader takes in; None: only its absence does."""
    if row.requirement == "gain_limit":
        return None
    return float(rounded(np.array(row.best), _DIGITS, up=row.sense == "at most"))


def _with(block: T, path: list[str], value: object) -> T:
    """Return a block with another value in it."""
    name, *inner = path
    return block.model_copy(update={name: _with(getattr(block, name), inner, value) if inner else value})


_DIGITS = 4
"""Digits of a limit that is proposed."""
