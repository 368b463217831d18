"""Parts that might do, each with what it misses; which forces and travels stacks of discs give, for arrays of them."""

import math
from collections.abc import Iterator, Mapping
from functools import cache
from itertools import chain, product
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...engines.parts import INDEX, checks_of_part
from ...engines.springs import DiscCharacteristic, SpringDemand, characteristic
from ...equations import springs as law
from ...messages import say
from ...spec.catalogues import Disc, discs
from ...spec.models import SHEAR_MODULUS, CoilSprings, DiscStack, Room
from ..registry import SpringKind

Numbers = NDArray[np.float64]

MOST_PARALLEL = 6
"""Discs laid into each other; more than three are for friction, not for force."""
MOST_SERIES = 10_000
"""Packs against each other: a bound for searches."""
TOLERANCE = 0.1
"""How far a stiffness may be off, relative."""
NONE = -1.0
"""Travel where there is no stack, m."""
COUNTS = (1, 3, 4, 6, 8, 9, 12, 16, 20, 24)
"""Coil springs around the shaft."""
WIRES = tuple(
    diameter * 1e-3
    for diameter in (
        1, 1.1, 1.25, 1.4, 1.6, 1.8, 2, 2.2, 2.5, 2.8, 3.2, 3.6, 4, 4.5, 5, 5.6, 6.3, 7.1, 8, 9, 10, 11, 12.5, 14, 16,
    )
)  # fmt: skip
"""Wire diameters, R'20 of ISO 497, m."""
TURNS = (2.0, 25.0)
"""Active turns."""
_FREE_TURNS: tuple[float, ...] = (3.0, 4.0, 6.0, 8.0, 12.0, 18.0)
"""Active turns to choose from where any stiffness will do."""
_STEPS = 24
"""Mean coil diameters that are tried of a wire."""
_AT_ONCE = 1 << 20
"""Numbers worked on together."""
_SHAPE = (
    "modulus", "poisson", "factor_load", "factor_flats", "outer_diameter", "thickness", "cone_height",
)  # fmt: skip
"""What the force of a disc depends on."""
_SIZES = ("outer_diameter", "inner_diameter", "thickness", "reduced_thickness", "free_height")
"""What makes a disc one of a size."""
_ROUNDING, _SLACK = 1e-12, 1e-9


class Candidate(NamedTuple):
    """A part, and what it misses."""

    part: DiscStack | CoilSprings
    misses: Mapping[str, float]
    """What is not as wished → by how much, relative; empty: it does."""


def label_of(part: DiscStack | CoilSprings, catalogue: tuple[Disc, ...] | None = None) -> str:
    """What a part is called: a disc by its standard, or its catalogue, if it is of one."""
    if isinstance(part, CoilSprings):
        return say("coil {wire:g} × {coil:g}", wire=part.wire_diameter * 1e3, coil=part.coil_diameter * 1e3)
    sizes = tuple(getattr(part, size) for size in _SIZES)
    title = _titles(catalogue or discs()).get(sizes) or _titles(discs()).get(sizes)
    if title is not None:
        return title
    outer, inner, thickness = (size * 1e3 for size in (part.outer_diameter, part.inner_diameter, part.thickness))
    return say("disc {outer:g} × {inner:g} × {thickness:g}", outer=outer, inner=inner, thickness=thickness)


@cache
def _titles(listed: tuple[Disc, ...]) -> dict[tuple[float | None, ...], str]:
    return {tuple(getattr(disc, size) for size in _SIZES): disc.title for disc in listed}


def stack_of(disc: Disc, parallel: int, series: int) -> DiscStack:
    """A stack of a size."""
    sizes = {size: getattr(disc, size) for size in _SIZES}
    return DiscStack.model_construct(**sizes, parallel=parallel, series=series)


def candidates(
    demand: SpringDemand, kind: SpringKind, tolerance: float = TOLERANCE, *, fitting: bool = False
) -> Iterator[Candidate]:
    """Parts of a kind, each with what it misses; with ``fitting`` no discs that cannot do by their size or force."""
    parts: list[Iterator[DiscStack | CoilSprings]] = []
    if kind != "coil":
        parts.append(_stacks(demand, fitting=fitting))
    if kind != "disc":
        parts.append(coil_springs(demand))
    for part in chain(*parts):
        spring = characteristic(part)
        misses = {"stiffness": 0.0}
        for check in checks_of_part(demand, part):
            name = check.rule.misses
            misses[name] = max(check.beyond, misses.get(name, 0.0))
        if demand.stiffness is not None:
            off = abs(float(spring.stiffness(spring.deflection(demand.force))) / demand.stiffness - 1)
            misses["stiffness"] = off if off > tolerance else 0.0
        yield Candidate(part, {name: by for name, by in misses.items() if by > _SLACK})


def _stacks(demand: SpringDemand, *, fitting: bool) -> Iterator[DiscStack]:
    """Stacks of every size, n laid into each other, and as many packs as stiffness, travel or room ask for."""
    for pack in packs(demand.room if fitting else Room(), demand.catalogue or discs()):
        low, high = pack.range
        if not fitting or pack.force(low) * (1 - _SLACK) <= demand.force <= pack.force(high) * (1 + _SLACK):
            for series in _series(demand, pack, float(pack.deflection(demand.force))):
                yield pack.part.model_copy(update={"series": series})


def _series(demand: SpringDemand, pack: DiscCharacteristic, deflection: float) -> set[int]:
    """How many packs are worth a look: as few as the travel allows, as many as the length does or the stiffness asks.

    Each bound is one-sided, so that where any number does, one of these does.
    """
    low, high = pack.range
    needs = max(
        1,
        math.ceil(demand.relaxes / (deflection - low) * (1 - _SLACK)) if deflection > low else 1,
        math.ceil(demand.compresses / (high - deflection) * (1 - _SLACK)) if deflection < high else 1,
    )
    most = MOST_SERIES
    if demand.room.length is not None:
        left = demand.room.length - demand.relaxes
        most = max(1, math.floor(left / (pack.free_length - deflection) * (1 + _SLACK)))
    counts = {needs}
    if demand.stiffness is not None:
        wanted = float(pack.stiffness(deflection)) / demand.stiffness
        counts |= {max(needs, min(series, most)) for series in (math.floor(wanted), math.ceil(wanted))}
    elif demand.room.length is not None:
        counts.add(most)
    return {min(series, MOST_SERIES) for series in counts}


def coil_springs(demand: SpringDemand) -> Iterator[CoilSprings]:
    """Coil springs around the shaft, or several on a circle, of every wire, their turns in quarters."""
    for count, wire in product(COUNTS, WIRES):
        for coil in _coils(demand, count, wire):
            choice = _FREE_TURNS
            if demand.stiffness is not None:
                wanted = count * float(law.coil_stiffness(SHEAR_MODULUS, wire, coil, 1.0)) / demand.stiffness
                quarters = round(4 * wanted) / 4
                choice = (quarters,) if TURNS[0] <= quarters <= TURNS[1] else ()
            for turns in choice:
                rate = count * float(law.coil_stiffness(SHEAR_MODULUS, wire, coil, turns))
                # as short as the gaps between its turns allow when it is pressed most
                shortest = float(law.coil_solid_length(wire, turns) + law.coil_least_gap(wire, coil, turns))
                free = math.ceil((shortest + demand.force / rate + demand.compresses) * 1e4) / 1e4
                yield CoilSprings.model_construct(
                    wire_diameter=wire, coil_diameter=coil, turns=turns, free_length=free, count=count
                )


def _coils(demand: SpringDemand, count: int, wire: float) -> list[float]:
    """Mean coil diameters that fit, in steps of whole millimetres at least."""
    inner, outer = demand.room.inner_diameter or 0.0, demand.room.outer_diameter
    low, high = INDEX[0] * wire, INDEX[1] * wire
    if count == 1:
        low = max(low, inner + wire)
        high = high if outer is None else min(high, outer - wire)
    elif outer is None or not inner:
        return []
    else:
        circle = (inner + outer) / 2
        high = min(high, (outer - inner) / 2 - wire, circle * math.sin(math.pi / count) - wire)
    step = max(1e-3, math.ceil((high - low) / _STEPS * 1e3) * 1e-3)
    first = math.ceil(round(low / 1e-3, 6))
    return [number * 1e-3 for number in range(first, math.floor(round(high / 1e-3, 6)) + 1, round(step / 1e-3))]


@cache
def packs(room: Room, listed: tuple[Disc, ...]) -> list[DiscCharacteristic]:
    """Every single pack of a list that goes into a room, whatever its length."""
    inner, outer = room.inner_diameter or 0.0, room.outer_diameter or math.inf
    sizes = [disc for disc in listed if inner <= disc.inner_diameter and disc.outer_diameter <= outer]
    return [DiscCharacteristic(stack_of(disc, n, 1)) for disc in sizes for n in range(1, MOST_PARALLEL + 1)]


@cache
def _rows(room: Room, listed: tuple[Disc, ...]) -> NDArray[Any]:
    """Every single pack that goes into a room, as a row of numbers.

    ``least`` and ``most`` are its forces as it rests in its range, as far as it is short enough there.
    """
    names = ("parallel", "free", "low", "high", "least", "most", "flat", *_SHAPE)
    rows = []
    for pack in packs(room, listed):
        low, high = pack.range
        if room.length is not None:
            low = max(low, pack.free_length - room.length)
        if low <= high:
            forces = (float(pack.force(s)) for s in (low, high, pack.end))
            rows.append((pack.part.parallel, pack.free_length, *pack.range, *forces, *pack.shape))
    return np.array(rows, dtype=[(name, float) for name in names])


@cache
def forces_held(room: Room, listed: tuple[Disc, ...]) -> Numbers:
    """Ends of the intervals of force that a stack holds as set, whatever its stiffness, N: ascending, low and high."""
    merged: list[tuple[float, float]] = []
    rows = _rows(room, listed)
    for low, high in sorted(zip(rows["least"], rows["most"], strict=True)):
        if merged and low <= merged[-1][1]:
            merged[-1] = (merged[-1][0], max(high, merged[-1][1]))
        else:
            merged.append((low, high))
    return np.array(merged).ravel()


def holds_force(force: Numbers, room: Room, catalogue: tuple[Disc, ...] | None = None) -> NDArray[np.bool_]:
    """Whether a stack holds a force as set, whatever its stiffness."""
    return np.asarray(np.searchsorted(forces_held(room, catalogue or discs()), force, "right") % 2 == 1)


def travel_held(
    force: Numbers, stiffness: Numbers, room: Room, *, relaxes: bool, catalogue: tuple[Disc, ...] | None = None
) -> Numbers:
    """How far a stack that gives a force and a stiffness as set may go from there, m; ``NONE`` where there is none.

    The stack lengthens if it ``relaxes``, else it is pressed together; its stiffness may be off by ``TOLERANCE``.
    """
    shape = np.broadcast_shapes(force.shape, stiffness.shape)
    travel = np.full(shape, NONE)
    every = _rows(room, catalogue or discs())
    near = every[(every["most"] >= np.nanmin(force)) & (every["least"] <= np.nanmax(force))]
    for start in range(0, near.size, step := max(1, _AT_ONCE // travel.size)):
        rows = near[start : start + step].reshape(-1, *(1 for _ in shape))
        np.fmax(travel, _travel(rows, force, stiffness, room, relaxes=relaxes).max(axis=0), out=travel)
    return travel


def _travel(row: Any, force: Numbers, stiffness: Numbers, room: Room, *, relaxes: bool) -> Numbers:
    """The largest over the numbers of packs that give the stiffness: it grows with them until the length is used up."""
    bears = (force >= row["least"]) & (force <= row["most"])
    deflection = _deflection(row, np.where(bears, force, row["least"]))
    slope = row["parallel"] * law.disc_stiffness(**{name: row[name] for name in _SHAPE}, deflection=deflection)
    # whole numbers of packs whose stiffness is near enough
    least = np.maximum(np.ceil(slope / stiffness / (1 + TOLERANCE) * (1 + _ROUNDING)), 1.0)
    most = np.minimum(np.floor(slope / stiffness / (1 - TOLERANCE) * (1 - _ROUNDING)), MOST_SERIES)
    per = deflection - row["low"] if relaxes else row["high"] - deflection
    if room.length is None:
        return np.where(bears & (least <= most), most * per, NONE)
    rest = row["free"] - deflection
    longest = np.floor(room.length / (rest + per if relaxes else rest) * (1 + _ROUNDING))
    best = np.full_like(least, NONE)
    for series in (np.clip(longest + more, least, most) for more in (0, 1)):
        left, moves = room.length - series * rest, series * per
        best = np.fmax(best, np.where(left >= 0, np.minimum(moves, left) if relaxes else moves, NONE))
    return np.where(bears & (least <= most), best, NONE)


def _deflection(row: Any, force: Numbers) -> Numbers:
    """Deflection of a single pack, m: about flat the force is a cubic u³ + p u = q, p > 0 where no disc snaps through.

    With T = t/K_4, u = s − h_0: p = 2 T² − h_0², q = 2 T² h_0 (F/F_c − 1), F_c flat.
    """
    square, height = (row["thickness"] / row["factor_flats"]) ** 2, row["cone_height"]
    steep = (2 * square - height**2) / 3
    q = square * height * (force / row["flat"] - 1)
    return height + 2 * np.sqrt(steep) * np.sinh(np.arcsinh(q / steep**1.5) / 3)
