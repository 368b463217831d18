"""Which clutch is needed: the Pareto front of everything that meets the requirements, and what helps to choose."""

import math
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import reduce
from itertools import groupby, product
from operator import and_

import numpy as np
from numpy.typing import ArrayLike

from ...errors import AfmcalcError
from ...findings import Finding, finding
from ...messages import did_you_mean, joined, measured, say, term
from ...progress import tell
from ...result import shown_as
from ...spec.edit import with_values
from ...spec.requirements import Requirements
from ...units import ENGINEER
from ...variants import VARIANTS, Variant
from ..clutch_findings import material_findings
from .candidates import candidates, rounded
from .limits import Constraint, constraints
from .pick import asked, made, number_of
from .refine import refined
from .rows import Attainable, DesignResult, DesignRow, OfVariant, Trade, in_words, rows
from .search import TILE, Survey, front, search
from .service import held
from .space import SAME_CLUTCH, Numbers, Tile, grids, linings, tiles, total

MOST = 10_000_000_000
"""Candidates beyond which a search is refused."""
MOST_AGAIN = 30_000_000
"""Candidates that are looked through again for what is attainable; of a larger space every so many radii."""


def design(
    need: Requirements, *, misses: bool | None = None, simulate: bool = True
) -> tuple[DesignResult, list[Finding]]:
    """Search everything the requirements allow: the front, empty where nothing meets them, and findings.

    ``misses`` asks for the nearest miss of each requirement; None: only where nothing meets them all. Without
    ``simulate`` what has to be simulated or sampled is left to a check of what is picked.

    Raises:
        AfmcalcError: more candidates than are searched.
    """
    count = total(need)
    if count > MOST:
        raise AfmcalcError(
            "the search asks for {count:,} candidates; at most {most:,} are searched: coarser ranges, please",
            count=count,
            most=MOST,
        )
    names = asked(need.wanted, need.drive)
    simulated = simulate and bool(names)
    survey = search(need, lambda done: tell(say("searching"), done, count), every=simulated)
    of_service = held(need, survey) if simulated else None
    found = of_service.front if of_service else [fine for _, fine in refinement(need, survey)]
    best = numbered(need, found)
    unsprung = 0
    if need.springs is not None and not simulated:
        sprung = []
        for number, row in enumerate(best, 1):
            if (with_springs := made(need, row, simulated=False)) is not None:
                sprung.append(with_springs.row)
            tell(say("choosing springs"), number, len(best))
        unsprung, best = len(best) - len(sprung), numbered(need, sprung)
    missing = None
    if of_service and not best and of_service.attainable:
        missing = of_service.attainable
    elif misses if misses is not None else not best:
        missing = attainable(need, lambda done, of: tell(say("looking for what is attainable"), done, of))
    if missing:
        missing = relaxed(
            need, survey.feasible, missing, lambda easier: design(easier, misses=False, simulate=simulate)[0]
        )
    result = DesignResult(
        candidates=survey.candidates,
        feasible=survey.feasible,
        unasked=of_service and of_service.unasked,
        objectives=list(need.objectives),
        on_front=len(best),
        knee=next((row.number for row in best if row.mark), None),
        excluded={name: number for name, number in (survey.excluded | {"springs": unsprung}).items() if number},
        attainable=missing,
        front=best,
        of_variants=of_variants(survey, best),
    )
    missed = [finding("springs-miss", "warning", value=float(unsprung), path="springs")] if unsprung else []
    if names:
        code = "front-of-grid" if simulated else "front-not-simulated"
        missed.append(finding(code, "info", path="wanted", names=joined(map(in_words, names))))
    materials = (each for lined in linings(need) for each in material_findings(lined.friction))
    told = [*need.label.findings, *dict.fromkeys(materials), *_of_machine(need)]
    return result, [*told, *_findings(result), *missed]


def refinement(need: Requirements, survey: Survey) -> list[tuple[DesignRow, DesignRow]]:
    """Return every member of the front on the grid, and what it becomes between the grid points.

    With the ball an objective twice: with the smallest that gives nothing up, and as good as can be with its own.
    """
    both: list[tuple[DesignRow, DesignRow]] = []
    ways = (False, True) if "ball_diameter" in need.objectives else (False,)
    count = len(ways) * sum(len(member.values) for member in survey.members)
    for (variant, at, _, need), ball_first in product(survey.members, ways):
        behind = len(both)

        def progress(done: int, behind: int = behind) -> None:
            tell(say("refining"), behind + done, count)

        best = refined(need, variant, at, progress, ball_first=ball_first and variant.controlled)
        both += zip(*(rows(candidates(need, variant, columns)) for columns in (at, best)), strict=True)
    return both


def numbered(need: Requirements, unordered: list[DesignRow]) -> list[DesignRow]:
    """Leave out what is beaten, or the same as another, number the others by their objectives and mark the knee."""
    if not unordered:
        return []
    values = np.array([[row.objective(name) for name in need.objectives] for row in unordered])
    kept = front(values, SAME_CLUTCH)
    order = kept[np.lexsort(values[kept].T[::-1])]
    knee = _knee(values[order])
    return [
        unordered[place].model_copy(update={"number": number, "mark": "knee" if number == knee else None})
        for number, place in enumerate(order, 1)
    ]


@np.errstate(all="ignore")
def _knee(values: Numbers) -> int | None:
    """Number of the row farthest below the plane through the ends of a front (Das, 1999); of one objective none.

    Source: Das, On characterizing the "knee" of the Pareto curve, Structural Optimization 18 (1999), 107-115.
    """
    if values.shape[1] < 2 or len(values) < 3:
        return None
    return int(np.argmin(over_range(values).sum(axis=1))) + 1


def check_sort(name: str | None) -> None:
    """Refuse to sort by what is no number of a row.

    Raises:
        AfmcalcError: it is none.
    """
    numbers = [each for each, field in DesignRow.model_fields.items() if shown_as(field).unit] + ["number"]
    if name is not None and name not in numbers:
        hint, known = did_you_mean(name, numbers), ", ".join(numbers)
        raise AfmcalcError("--sort {name}: no such quantity{hint}; one of {known}", name=name, hint=hint, known=known)


def shown(result: DesignResult, sort: str | None, top: int | None) -> DesignResult:
    """Return the result with so many rows of its front, by a quantity of theirs; their numbers stay."""
    ordered = result.front if sort is None else sorted(result.front, key=lambda row: row.objective(sort))
    return result.model_copy(update={"front": ordered[:top]})


@np.errstate(all="ignore")
def attainable(need: Requirements, progress: Callable[[int, int], None] = lambda done, of: None) -> list[Attainable]:
    """Return a row for each requirement missed, alone or together, by the candidates on the grid that miss the fewest.

    What misses none is none of them.
    ``progress`` is told how many candidates are behind, of how many.
    """
    count = total(need)
    step, done, fewest = -(-count // MOST_AGAIN), 0, 1 << 30
    best: dict[tuple[str, ...], tuple[list[Constraint], list[float]]] = {}
    for lined, name in product(linings(need), dict.fromkeys(need.variants)):
        variant = VARIANTS[name]
        for laid in grids(lined, variant):
            few = laid._replace(mean_radius=np.unique(np.append(laid.mean_radius[::step], laid.mean_radius[-1])))
            for tile in tiles(few, TILE):
                for missed, values in _nearest(lined, variant, tile, fewest):
                    if len(missed) < fewest:
                        fewest = len(missed)
                        best.clear()
                    if not np.isfinite(values).all():
                        continue  # what has no number is nothing to bargain for
                    names = tuple(f"{bound.name} {bound.sense}" for bound in missed)
                    known = best.get(names, (missed, values))[1]
                    best[names] = missed, min(known, values, key=lambda each: float(_excess(missed, each)))
                done += tile.size
                progress(done * step, count)
    return [
        Attainable(
            together=" + ".join(bound.name for bound in missed) if len(missed) > 1 else None,
            requirement=bound.name, sense=bound.sense, limit=bound.limit, best=value, unit=bound.unit,
        )
        for missed, values in best.values()
        for bound, value in zip(missed, values, strict=True)
    ]  # fmt: skip


def _nearest(
    need: Requirements, variant: Variant, tile: Tile, most: int
) -> Iterator[tuple[list[Constraint], list[float]]]:
    """Bounds missed by the candidates of a tile that miss the fewest, at most so many, and the nearest of each."""
    at_points, every = candidates(need, variant, tile.axes), constraints(need, variant)
    bounds = [(bound, bound.value) for bound in every if bound.value]
    misses = np.stack([np.broadcast_to(~bound.holds(at_points), tile.shape).ravel() for bound, _ in bounds])
    built = np.broadcast_to(at_points.is_clutch, tile.shape).ravel()
    number = np.where(built, misses.sum(axis=0), len(bounds) + 1)
    number[number == 0] = len(bounds) + 1
    costly, near = [bound for bound in every if not bound.value], np.empty(0, np.int64)
    while not near.size:
        fewest = int(number.min())
        if fewest > min(most, len(bounds)):
            return
        near = np.flatnonzero(number == fewest)
        few = candidates(need, variant, tile.points(near))
        holds = reduce(and_, (bound.holds(few) for bound in costly), np.ones(near.size, bool))
        number[near[~holds]], near = len(bounds) + 1, near[holds]
    for row in np.unique(misses[:, near], axis=1).T:
        alike = near[(row == misses[:, near].T).all(axis=1)]
        both = [(bound, value(at_points)) for (bound, value), out in zip(bounds, row, strict=True) if out]
        missed, columns = (
            [bound for bound, _ in both],
            [np.broadcast_to(each, tile.shape).ravel()[alike] for _, each in both],
        )
        nearest = np.nan_to_num(_excess(missed, columns), nan=np.inf).argmin()
        yield missed, [float(column[nearest]) for column in columns]


def _excess(missed: Sequence[Constraint], values: Sequence[ArrayLike]) -> Numbers:
    """How far values are beyond their limits, in parts of these, all together."""
    both = zip(missed, map(np.asarray, values), strict=True)
    return np.sum([abs(value - bound.limit) / (abs(bound.limit) or 1.0) for bound, value in both], axis=0)


def _findings(result: DesignResult) -> list[Finding]:
    """Say what excludes the candidates where there is no front, and what to give up: alone, else together."""
    if result.front:
        return []
    most = sorted(result.excluded.items(), key=lambda item: -item[1])
    listed = joined(say("{name} ({number:,})", name=in_words(name), number=number) for name, number in most)
    missed = result.attainable or []
    alone = [
        say(
            "{name} ({sense} {limit}; there is {best})",
            name=in_words(row.requirement),
            sense=term(row.sense),
            limit=measured(row.limit, ENGINEER.get(row.unit, row.unit), 5),
            best=measured(row.relax_to or row.best, ENGINEER.get(row.unit, row.unit), 5),
        )
        for row in missed
        if row.together is None
    ]
    if given_up := alone or [*map(in_words, dict.fromkeys(row.together for row in missed if row.together))]:
        names, count = joined(given_up, say(" or ")), result.candidates
        return [finding("no-candidate/attainable", "error", value=0.0, candidates=count, listed=listed, names=names)]
    return [finding("no-candidate", "error", value=0.0, candidates=result.candidates, listed=listed)]


def _of_machine(need: Requirements) -> Iterator[Finding]:
    """Say what is assumed of the machine, and that a search does not hold its shaft against the peaks of an event."""
    if need.machine is not None and need.machine.service_factor is None:
        yield finding("service-factor-assumed", "info", value=1.0, path="machine.service_factor")
    event = need.drive is not None and need.drive.event is not None
    if event and need.shaft_torque < (need.wanted.peak_torque or np.inf):
        yield finding("shaft-not-at-peaks", "info", value=need.shaft_torque, path="shaft.yield_strength")


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
