"""Parts that might do as springs: each with what it misses, or for arrays of demands whether there is one."""

import math
from collections.abc import Iterator, Mapping
from functools import cache
from itertools import chain, product
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...engines.parts import INDEX, SEATING, SHEAR_SHARE, SOLID_SHARE, ZIMMERLI, checks_of_part, strength
from ...engines.springs import MODULUS, DiscCharacteristic, SpringDemand, characteristic
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
_SIZES = ("outer_diameter", "inner_diameter", "thickness", "reduced_thickness", "free_height")
"""What makes a disc one of a size."""
SLACK = 1e-9
"""Share by which a part may be beyond a limit by rounding."""


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
    """Parts of a kind, each with what it misses; with ``fitting`` none that cannot do by size or force."""
    parts: list[Iterator[DiscStack | CoilSprings]] = []
    if kind != "coil":
        parts.append(_stacks(demand, fitting=fitting))
    if kind != "disc":
        parts.append(coil_springs(demand, fitting=fitting))
    for part in chain(*parts):
        spring = characteristic(part)
        misses = {"stiffness": 0.0}
        for check in checks_of_part(demand, part):
            name = check.rule.misses
            misses[name] = max(check.beyond, misses.get(name, 0.0))
        if demand.stiffness is not None:
            off = abs(float(spring.stiffness(spring.deflection(demand.force))) / demand.stiffness - 1)
            misses["stiffness"] = off if off > tolerance else 0.0
        yield Candidate(part, {name: by for name, by in misses.items() if by > SLACK})


def _stacks(demand: SpringDemand, *, fitting: bool) -> Iterator[DiscStack]:
    """Stacks of every size, n laid into each other, and as many packs as stiffness, travel or room ask for."""
    for pack in packs(demand.room if fitting else Room(), demand.catalogue or discs()):
        low, high = pack.range
        if not fitting or pack.force(low) * (1 - SLACK) <= demand.force <= pack.force(high) * (1 + SLACK):
            for series in _series(demand, pack, float(pack.deflection(demand.force))):
                yield pack.part.model_copy(update={"series": series})


def _series(demand: SpringDemand, pack: DiscCharacteristic, deflection: float) -> set[int]:
    """How many packs are worth a look: as few as the travel allows, as many as the length does or the stiffness asks.

    Each bound is one-sided, so that where any number does, one of these does.
    """
    low, high = pack.range
    needs = max(
        1,
        math.ceil(demand.relaxes / (deflection - low) * (1 - SLACK)) if deflection > low else 1,
        math.ceil(demand.compresses / (high - deflection) * (1 - SLACK)) if deflection < high else 1,
    )
    most = MOST_SERIES
    if demand.room.length is not None:
        left = demand.room.length - demand.relaxes
        most = max(1, math.floor(left / (pack.free_length - deflection) * (1 + SLACK)))
    counts = {needs}
    if demand.stiffness is not None:
        wanted = float(pack.stiffness(deflection)) / demand.stiffness
        counts |= {max(needs, min(series, most)) for series in (math.floor(wanted), math.ceil(wanted))}
    elif demand.room.length is not None:
        counts.add(most)
    return {min(series, MOST_SERIES) for series in counts}


def coil_springs(demand: SpringDemand, *, fitting: bool = False) -> Iterator[CoilSprings]:
    """Coil springs around the shaft, or several on a circle, of every wire, their turns in quarters."""
    table = coil_table(demand.room, any_turns=demand.stiffness is None)
    if fitting:
        asked = {name: getattr(demand, name) for name in ("force", "relaxes", "compresses", "stiffness", "stroke")}
        table = table[coils_hold(table, demand.room, **asked)]
    turns, _, free = wound(table, demand.force, demand.stiffness, demand.compresses)
    columns = (table["wire"], table["coil"], turns, free, table["count"])
    for wire, coil, active, length, number in zip(*(column.tolist() for column in columns), strict=True):
        if TURNS[0] <= active <= TURNS[1]:
            yield CoilSprings.model_construct(
                wire_diameter=wire, coil_diameter=coil, turns=active, free_length=length, count=int(number)
            )


@cache
def coil_table(room: Room, *, any_turns: bool) -> NDArray[Any]:
    """Coils that go into a room, as rows of numbers; with turns to choose from where any stiffness will do."""
    choice = _FREE_TURNS if any_turns else (math.nan,)
    rows = [
        (number, wire, coil, turns, strength(wire) or math.nan)
        for number, wire in product(COUNTS, WIRES)
        for coil, turns in product(_coils(room, number, wire), choice)
    ]
    return np.array(rows, dtype=[(name, float) for name in ("count", "wire", "coil", "turns", "strength")])


@np.errstate(all="ignore")
def wound(row: Any, force: Any, stiffness: Any, compresses: Any) -> tuple[Numbers, Numbers, Numbers]:
    """Active turns for a stiffness, None: those of the rows; the stiffness that they give; length without load."""
    wire, coil = row["wire"], row["coil"]
    turns = row["turns"]
    if stiffness is not None:
        turns = np.rint(4 * row["count"] * law.coil_stiffness(SHEAR_MODULUS, wire, coil, 1.0) / stiffness) / 4
    rate = row["count"] * law.coil_stiffness(SHEAR_MODULUS, wire, coil, turns)
    # as short as the gaps between its turns allow when it is pressed most
    shortest = law.coil_solid_length(wire, turns) + law.coil_least_gap(wire, coil, turns)
    return turns, rate, np.ceil((shortest + force / rate + compresses) * 1e4) / 1e4


@np.errstate(all="ignore")
def coils_hold(
    row: Any, room: Room, force: Any, relaxes: Any = 0.0, compresses: Any = 0.0, keeps: Any = 0.0,
    stiffness: Any = None, stroke: Any = None,
) -> NDArray[np.bool_]:  # fmt: skip
    """Whether coil springs wound for demands hold what ``checks_of_part`` has of them, for arrays."""
    wire, coil, ratio, over = row["wire"], row["coil"], SHEAR_MODULUS / MODULUS, 1 + SLACK
    turns, rate, free = wound(row, force, stiffness, compresses)
    deflection, end = force / rate, free - law.coil_solid_length(wire, turns)
    most, per = deflection + compresses, law.coil_stress(rate / row["count"], wire, coil, 1.0, math.pi)
    allowed = SOLID_SHARE * row["strength"] * over
    good = (turns >= TURNS[0]) & (turns <= TURNS[1]) & (relaxes - deflection <= SLACK * end) & (per * end <= allowed)
    good &= force - rate * relaxes >= keeps * force
    if stiffness is not None:
        good &= np.abs(rate / stiffness - 1) <= TOLERANCE
    if room.length is not None:
        good &= free - deflection + relaxes <= room.length * over
    if stroke is not None:
        corrected, ultimate = per * law.coil_correction(wire, coil), SHEAR_SHARE * row["strength"]
        endured = law.coil_endurance(*ZIMMERLI, ultimate)
        good &= corrected * most <= law.coil_upper_stress(corrected * (most - stroke), endured, ultimate) * over
    shaft, bore = room.inner_diameter or 0.0, room.outer_diameter or math.inf
    guided = (row["count"] == 1) & (np.minimum(coil - shaft, bore - coil) <= 2 * wire * over)
    root = law.coil_buckling_root(coil, free, ratio, SEATING, math.pi)
    stable = guided | (root < 0) | (most <= law.coil_buckling_deflection(free, ratio, np.maximum(root, 0.0)) * over)
    return np.asarray(good & stable & (per * most <= allowed))


def _coils(room: Room, count: int, wire: float) -> list[float]:
    """Mean coil diameters that fit, in steps of whole millimetres at least."""
    inner, outer = room.inner_diameter or 0.0, room.outer_diameter
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
