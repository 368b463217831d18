"""Which clutch is needed: the Pareto front of everything that meets the requirements."""

from ...errors import AfmcalcError, CalculationError
from ...findings import Finding, finding
from ...messages import say
from ...result import Result, quantity
from ...spec import Spec
from ...spec.requirements import Requirements
from ...watch import Progress, unwatched
from .by_law import candidates
from .found import Found
from .refine import refined
from .rows import DesignRow, as_spec, rows
from .search import search
from .space import total

MOST = 10_000_000_000
"""Candidates beyond which a search is refused."""


class DesignResult(Result):
    """The front of a design, on the grid and refined between its points."""

    candidates: int = quantity("", None, "candidates searched")
    feasible: int = quantity("", None, "candidates that meet every requirement")
    objectives: list[str] = quantity("", None, "what is small on the front")
    excluded: dict[str, int] = quantity("", None, "candidates excluded by each constraint", ranked=True)
    refined: list[DesignRow] = quantity("", None, "the front refined between the grid points, same numbers")
    front: list[DesignRow] = quantity("", None, "the front on the grid")


def design(need: Requirements, progress: Progress = unwatched) -> tuple[DesignResult, list[Finding]]:
    """Search everything the requirements allow.

    Args:
        need: the requirements.
        progress: is told how far the search, then the refinement is.

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
    found = search(need, lambda done: progress("searching", done, count))
    grid, fine = _laid_out(need, found, progress)
    result = DesignResult(
        candidates=found.candidates,
        feasible=found.feasible,
        objectives=list(need.objectives),
        excluded={name: number for name, number in found.excluded.items() if number},
        refined=fine,
        front=grid,
    )
    return result, _findings(result)


def _laid_out(need: Requirements, found: Found, progress: Progress) -> tuple[list[DesignRow], list[DesignRow]]:
    """Lay out the front by its objectives, and the refined one in the same order."""
    both: list[tuple[list[float], DesignRow, DesignRow]] = []
    count = sum(len(values) for _, _, values in found.members)
    for variant, at, values in found.members:
        behind = len(both)

        def told(done: int, behind: int = behind) -> None:
            progress("refining", behind + done, count)

        best = refined(need, variant, at, told)
        grid, fine = (rows(candidates(need, variant, each)) for each in (at, best))
        both += zip(values.tolist(), grid, fine, strict=True)
    both.sort(key=lambda each: each[0])
    return _numbered([row for _, row, _ in both]), _numbered([row for _, _, row in both])


def _numbered(found: list[DesignRow]) -> list[DesignRow]:
    return [row.model_copy(update={"number": number}) for number, row in enumerate(found, 1)]


def _findings(result: DesignResult) -> list[Finding]:
    if result.front:
        return []
    most = sorted(result.excluded.items(), key=lambda item: -item[1])
    listed = ", ".join(say("{name} excludes {number:,}", name=name, number=number) for name, number in most)
    return [finding("no-candidate", "error", value=0.0, candidates=result.candidates, listed=listed)]


def picked(need: Requirements, result: DesignResult, number: int, *, fine: bool = False) -> Spec:
    """Return a clutch of the front as a spec.

    Raises:
        CalculationError: no such number.
    """
    front = result.refined if fine else result.front
    if not 1 <= number <= len(front):
        raise CalculationError(
            say("--pick {number}: the front has the numbers 1 to {count}", number=number, count=len(front))
        )
    return as_spec(need, front[number - 1])
