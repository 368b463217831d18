"""Which forces and travels stacks of disc springs give within a room, for arrays of forces at once."""

from functools import cache

import numpy as np
from numpy.typing import NDArray

from ...arrays import Values
from ...engines.characteristic import LEAST_USED, MOST_USED, DiscCharacteristic
from ...spec.discs import Disc, discs
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
    low, high = LEAST_USED * pack.cone_height, MOST_USED * pack.cone_height
    return (low if room.length is None else max(low, pack.free_length - room.length)), high


@cache
def forces_held(room: Room) -> Numbers:
    """Ends of the intervals of force that a stack holds as set, whatever its stiffness, N: ascending, low and high."""
    spans = []
    for _, pack in packs(room):
        low, high = used(pack, room)
        if low <= high:
            spans.append((float(pack.force(low)), float(pack.force(high))))
    merged: list[tuple[float, float]] = []
    for low, high in sorted(spans):
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
    found = np.full(np.broadcast_shapes(force.shape, stiffness.shape), NONE)
    for _, pack in packs(room):
        low, high = used(pack, room)
        within = (force >= pack.force(low)) & (force <= pack.force(high))
        if not within.any():
            continue
        each = np.where(within, pack.deflection(np.where(within, force, pack.force(low))), np.nan)
        np.fmax(found, _travel(pack, each, stiffness, room, tolerance, relaxes=relaxes), out=found)
    return found


def _travel(
    pack: DiscCharacteristic, each: Numbers, stiffness: Numbers, room: Room, tolerance: float, *, relaxes: bool
) -> Numbers:
    """The largest over the numbers of packs that give the stiffness: it grows with them until the length is used up."""
    least, most = fewest_and_most(pack.stiffness(each) / stiffness, tolerance)
    free = pack.free_length
    per = each - LEAST_USED * pack.cone_height if relaxes else MOST_USED * pack.cone_height - each
    rest = free - each

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
    return np.where(least <= most, best, NONE)


def fewest_and_most(wanted: Values, tolerance: float) -> tuple[Numbers, Numbers]:
    """Whole numbers of packs whose stiffness is near enough, where ``wanted`` packs would have it exactly."""
    least = np.maximum(np.ceil(wanted / (1 + tolerance) * (1 + _ROUNDING)), 1.0)
    most = np.floor(wanted / (1 - tolerance) * (1 - _ROUNDING)) if tolerance < 1 else np.full_like(least, np.inf)
    return least, np.minimum(most, MOST_SERIES)
