"""Which clutch is needed: the Pareto front of everything that meets the requirements."""

from collections.abc import Iterator
from itertools import product

import numpy as np

from ...errors import AfmcalcError
from ...findings import Finding, doubts, finding
from ...messages import joined, measured, say, term
from ...progress import tell
from ...result import Answer, quantity
from ...spec.requirements import Requirements
from ...spec.suggest import did_you_mean
from .attainable import Attainable, attainable
from .by_law import candidates
from .found import Found
from .limits import OBJECTIVES
from .pareto import front
from .parts import made
from .refine import refined
from .rows import DesignRow, rows
from .search import search
from .space import Numbers, total

MOST = 10_000_000_000
"""Candidates beyond which a search is refused."""


class DesignResult(Answer):
    """The front of a design: the best between the grid points."""

    candidates: int = quantity("", None, "candidates searched")
    feasible: int = quantity("", None, "candidates that meet every requirement")
    objectives: list[str] = quantity("", None, "what is small on the front")
    on_front: int = quantity("", None, "clutches on the front: none beats another in everything")
    knee: int | None = quantity(
        "", None, "number of the knee: least sum of the objectives, each over its range",
        optional=True,
    )  # fmt: skip
    excluded: dict[str, int] = quantity(
        "", None, "candidates excluded by each constraint", ranked=True, of="constraint"
    )
    attainable: list[Attainable] | None = quantity(
        "", None, "what could be had instead, with all other requirements held", optional=True
    )
    front: list[DesignRow] = quantity("", None, "the front")
    picked: list[DesignRow] | None = quantity(
        "", None, "the clutch picked, calculated from the round values as written", optional=True
    )


def design(need: Requirements) -> tuple[DesignResult, list[Finding]]:
    """Search everything the requirements allow.

    Args:
        need: the requirements.

    Returns:
        The front, empty where nothing meets the requirements, and findings.

    Raises:
        AfmcalcError: more candidates than are searched.
    """
    count = total(need)
    if count > MOST:
        raise AfmcalcError(
            say(
                "the search asks for {count:,} candidates; at most {most:,} are searched: coarser ranges, please",
                count=count,
                most=MOST,
            )
        )
    found = search(need, lambda done: tell(say("searching"), done, count))
    best = numbered(need, [fine for _, fine in refinement(need, found)])
    unsprung = 0
    if need.springs is not None:
        sprung = list(_sprung(need, best))
        unsprung, best = len(best) - len(sprung), numbered(need, sprung)
    missing = None
    if not best:
        missing = attainable(need, lambda done, of: tell(say("looking for what is attainable"), done, of))
    result = DesignResult(
        candidates=found.candidates,
        feasible=found.feasible,
        objectives=list(need.objectives),
        on_front=len(best),
        knee=next((row.number for row in best if row.mark), None),
        excluded={name: number for name, number in (found.excluded | {"springs": unsprung}).items() if number},
        attainable=missing,
        front=best,
    )
    missed = [finding("springs-miss", "warning", value=float(unsprung), path="springs")] if unsprung else []
    return result, [*doubts(need.label.doubts), *_findings(result), *missed]


def refinement(need: Requirements, found: Found) -> list[tuple[DesignRow, DesignRow]]:
    """Return every member of the front on the grid, and what it becomes between the grid points.

    With the ball an objective twice: with the smallest that gives nothing up, and as good as can be with its own.
    """
    both: list[tuple[DesignRow, DesignRow]] = []
    ways = (False, True) if "ball_diameter" in need.objectives else (False,)
    count = len(ways) * sum(len(values) for _, _, values in found.members)
    for (variant, at, _), ball_first in product(found.members, ways):
        behind = len(both)

        def told(done: int, behind: int = behind) -> None:
            tell(say("refining"), behind + done, count)

        best = refined(need, variant, at, told, ball_first=ball_first and variant.controlled)
        both += zip(*(rows(candidates(need, variant, each)) for each in (at, best)), strict=True)
    return both


def numbered(need: Requirements, found: list[DesignRow]) -> list[DesignRow]:
    """Leave out what is beaten, or the same as another, number the others by their objectives and mark the knee."""
    if not found:
        return []
    values = np.array([[row.objective(name) for name in need.objectives] for row in found])
    kept = front(values, SAME)
    order = kept[np.lexsort(values[kept].T[::-1])]
    knee = _knee(values[order])
    return [
        found[place].model_copy(update={"number": number, "mark": "knee" if number == knee else None})
        for number, place in enumerate(order, 1)
    ]


SAME = 1e-9
"""Relative distance within which refined clutches are the same one, reached from two grid points."""


@np.errstate(all="ignore")
def _knee(values: Numbers) -> int | None:
    """Number of the row farthest below the plane through the ends of a front (Das, 1999); of one objective none.

    Source: Das, On characterizing the "knee" of the Pareto curve, Structural Optimization 18 (1999), 107-115.
    """
    known = np.where(np.isfinite(values), values, np.nan)
    low, high = np.nanmin(known, axis=0), np.nanmax(known, axis=0)
    spread = np.where(high > low, high - low, np.inf)
    if values.shape[1] < 2 or len(values) < 3:
        return None
    return int(np.argmin(((values - low) / spread).sum(axis=1))) + 1


def check_objective(name: str | None) -> None:
    """Refuse what is no objective.

    Raises:
        AfmcalcError: it is none.
    """
    if name is not None and name not in OBJECTIVES:
        hint, known = did_you_mean(name, OBJECTIVES), ", ".join(OBJECTIVES)
        raise AfmcalcError(
            say("--sort {name}: no such objective{hint}; one of {known}", name=name, hint=hint, known=known)
        )


def shown(result: DesignResult, sort: str | None, top: int | None, pick: int | None = None) -> DesignResult:
    """Return the result with so many rows of its front and the one picked, by an objective; their numbers stay."""
    found = result.front if sort is None else sorted(result.front, key=lambda row: row.objective(sort))
    kept = [row for place, row in enumerate(found) if top is None or place < top or row.number == pick]
    return result.model_copy(update={"front": kept})


def _sprung(need: Requirements, front: list[DesignRow]) -> Iterator[DesignRow]:
    for number, row in enumerate(front, 1):
        if (sprung := made(need, row)) is not None:
            yield sprung.row
        tell(say("choosing springs"), number, len(front))


def _findings(result: DesignResult) -> list[Finding]:
    if result.front:
        return []
    most = sorted(result.excluded.items(), key=lambda item: -item[1])
    listed = joined(say("{name} excludes {number:,}", name=name, number=number) for name, number in most)
    given_up = _given_up(result.attainable or [])
    if given_up:
        names = joined(given_up, say(" or "))
        return [
            finding(
                "no-candidate/attainable", "error", value=0.0, candidates=result.candidates, listed=listed, names=names
            )
        ]
    return [finding("no-candidate", "error", value=0.0, candidates=result.candidates, listed=listed)]


def _given_up(found: list[Attainable]) -> list[str]:
    """What to give up: one requirement, or several together, and what there is of it instead."""
    alone = [each for each in found if each.together is None]
    together = dict.fromkeys(each.together for each in found if each.together)
    return [_instead(each) for each in alone] or [text for text in together if text]


def _instead(each: Attainable) -> str:
    unit = _UNITS[each.unit]
    limit, best = (measured(value, unit, 5) for value in (each.limit, each.best))
    return say(
        "{name} ({sense} {limit}; there is {best})",
        name=each.requirement,
        sense=term(each.sense),
        limit=limit,
        best=best,
    )


_UNITS = {"N": "kN", "m": "mm", "Pa": "MPa", "N*m": "N·m", "1": ""}
"""SI unit of what is bounded → the engineer's."""
