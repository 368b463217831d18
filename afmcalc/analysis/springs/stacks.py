"""Which forces and travels stacks of disc springs give within a room, for arrays of forces at once."""

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arrays import Values
from ...engines.characteristic import DiscCharacteristic
from ...equations import springs as law
from ...spec.catalogues import Disc, discs
from ...spec.springs import DiscStack, Room

Numbers = NDArray[np.float64]

MOST_PARALLEL = 6
"""Discs laid into each other; more than three are for friction, not for force."""
MOST_SERIES = 10_000
"""Packs against each other: a bound for searches."""
TOLERANCE = 0.1
"""How far a stiffness may be off, relative."""
NONE = -1.0
"""Travel where there is no stack, m."""
_ROUNDING = 1e-12


def stack_of(disc: Disc, parallel: int, series: int) -> DiscStack:
    """A stack of a size."""
    return DiscStack.model_construct(
        outer_diameter=disc.outer_diameter,
        inner_diameter=disc.inner_diameter,
        thickness=disc.thickness,
        reduced_thickness=disc.reduced_thickness,
        free_height=disc.free_height,
        parallel=parallel,
        series=series,
    )


def fits_across(disc: Disc, room: Room) -> bool:
    """Whether a size goes into a room, whatever its length."""
    inner, outer = room.inner_diameter or 0.0, room.outer_diameter or np.inf
    return inner <= disc.inner_diameter and disc.outer_diameter <= outer


@cache
def packs(room: Room) -> tuple[tuple[Disc, DiscCharacteristic], ...]:
    """Every single pack that goes into a room, with its size."""
    sizes, parallel = [disc for disc in discs() if fits_across(disc, room)], range(1, MOST_PARALLEL + 1)
    return tuple((disc, DiscCharacteristic(stack_of(disc, n, 1))) for disc in sizes for n in parallel)


def used(pack: DiscCharacteristic, room: Room) -> tuple[float, float]:
    """Deflections between which a single pack may rest: of its range, those for which it is short enough."""
    low, high = pack.range
    return (low if room.length is None else max(low, pack.free_length - room.length)), high


@cache
def forces_held(room: Room) -> Numbers:
    """Ends of the intervals of force that a stack holds as set, whatever its stiffness, N: ascending, low and high."""
    merged: list[tuple[float, float]] = []
    for low, high in sorted(zip(_rows(room)["least"], _rows(room)["most"], strict=True)):
        if merged and low <= merged[-1][1]:
            merged[-1] = (merged[-1][0], max(high, merged[-1][1]))
        else:
            merged.append((low, high))
    return np.array(merged).ravel()


def holds_force(force: Numbers, room: Room) -> NDArray[np.bool_]:
    """Whether a stack holds a force as set, whatever its stiffness."""
    return np.asarray(np.searchsorted(forces_held(room), force, "right") % 2 == 1)


def travel_held(
    force: Numbers, stiffness: Numbers, room: Room, tolerance: float = TOLERANCE, *, relaxes: bool
) -> Numbers:
    """How far a stack that gives a force and a stiffness as set may go from there, m; ``NONE`` where there is none.

    Args:
        force: as set, N.
        stiffness: as set, N/m; broadcasts with the force.
        room: for the stack, as set and as long as it gets.
        tolerance: how far the stiffness may be off, relative.
        relaxes: whether it lengthens or is pressed together.
    """
    shape = np.broadcast_shapes(force.shape, stiffness.shape)
    found = np.full(shape, NONE)
    every = _rows(room)
    near = every[(every["most"] >= np.nanmin(force)) & (every["least"] <= np.nanmax(force))]
    for start in range(0, near.size, step := max(1, _AT_ONCE // found.size)):
        rows = near[start : start + step].reshape(-1, *(1 for _ in shape))
        np.fmax(found, _travel(rows, force, stiffness, room, tolerance, relaxes=relaxes).max(axis=0), out=found)
    return found


def _travel(row: Any, force: Numbers, stiffness: Numbers, room: Room, tolerance: float, *, relaxes: bool) -> Numbers:
    """The largest over the numbers of packs that give the stiffness: it grows with them until the length is used up."""
    held = (force >= row["least"]) & (force <= row["most"])
    each = _deflection(row, np.where(held, force, row["least"]))
    slope = row["parallel"] * law.disc_stiffness(**{name: row[name] for name in _SHAPE}, deflection=each)
    least, most = fewest_and_most(slope / stiffness, tolerance)
    per = each - row["low"] if relaxes else row["high"] - each
    rest = row["free"] - each

    def reached(series: Numbers) -> Numbers:
        moves: Numbers = series * per
        if room.length is None:
            return moves
        left = room.length - series * rest
        return np.where(left >= 0, np.minimum(moves, left) if relaxes else moves, NONE)

    if room.length is None:
        best = reached(most)
    else:
        longest = np.floor(room.length / (rest + per if relaxes else rest) * (1 + _ROUNDING))
        best = np.fmax(*(reached(np.clip(longest + more, least, most)) for more in (0, 1)))
    return np.where(held & (least <= most), best, NONE)


def _deflection(row: Any, force: Numbers) -> Numbers:
    """Deflection of a single pack, m: about flat the force is a cubic u³ + p u = q, p > 0 where no disc snaps through.

    With T = t/K_4, u = s − h_0: p = 2 T² − h_0², q = 2 T² h_0 (F/F_c − 1), F_c flat.
    """
    square, height = (row["thickness"] / row["factor_flats"]) ** 2, row["cone_height"]
    steep = (2 * square - height**2) / 3
    q = square * height * (force / row["flat"] - 1)
    found: Numbers = height + 2 * np.sqrt(steep) * np.sinh(np.arcsinh(q / steep**1.5) / 3)
    return found


@cache
def _rows(room: Room) -> NDArray[Any]:
    """Every single pack that goes into a room, as a row of numbers."""
    names = ("parallel", "free", "low", "high", "least", "most", "flat", *_SHAPE)
    rows = []
    for _, pack in packs(room):
        low, high = used(pack, room)
        if low <= high:
            forces = (float(pack.force(s)) for s in (low, high, pack.end))
            rows.append((pack.part.parallel, pack.free_length, *pack.range, *forces, *pack.shape))
    return np.array(rows, dtype=[(name, float) for name in names])


_SHAPE = (
    "modulus", "poisson", "factor_load", "factor_flats", "outer_diameter", "thickness", "cone_height",
)  # fmt: skip
"""What the force of a disc depends on."""
_AT_ONCE = 1 << 20
"""Numbers worked on together."""


def fewest_and_most(wanted: Values, tolerance: float) -> tuple[Numbers, Numbers]:
    """Whole numbers of packs whose stiffness is near enough, where ``wanted`` packs would have it exactly."""
    least = np.maximum(np.ceil(wanted / (1 + tolerance) * (1 + _ROUNDING)), 1.0)
    most = np.floor(wanted / (1 - tolerance) * (1 - _ROUNDING)) if tolerance < 1 else np.full_like(least, np.inf)
    return least, np.minimum(most, MOST_SERIES)
