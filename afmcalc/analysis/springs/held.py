"""Which forces, stiffnesses and strokes there are springs for in a room, for arrays of them."""

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...equations import springs as law
from ...spec.catalogues import Disc, discs
from ...spec.models import Room
from ..registry import SpringKind
from .candidates import MOST_SERIES, SLACK, TOLERANCE, Numbers, coil_table, coils_hold, packs

_AT_ONCE = 1 << 19
"""Numbers worked on together."""
_SHAPE = (
    "modulus", "poisson", "factor_load", "factor_flats", "outer_diameter", "thickness", "cone_height",
)  # fmt: skip
"""What the force of a disc depends on."""
_ROUNDING = 1e-12


@np.errstate(all="ignore")
def held(
    kind: SpringKind, listed: tuple[Disc, ...] | None, room: Room, force: Numbers, stiffness: Numbers | None = None, *,
    relaxes: ArrayLike = 0.0, compresses: ArrayLike = 0.0, keeps: ArrayLike = 0.0, stroke: Numbers | None = None,
) -> NDArray[np.bool_]:  # fmt: skip
    """Whether a part of a kind gives a force as set and bears what comes, as ``checks_of_part`` has it.

    Args:
        kind: disc springs, coil springs, or both.
        listed: sizes of discs to choose from; None: those that ship.
        room: where it is.
        force: as set, N.
        stiffness: which may be off by ``TOLERANCE``, N/m; None: any.
        relaxes: how much longer it gets in service, m.
        compresses: how much shorter, m.
        keeps: share of the force that it is to have at its longest.
        stroke: how far it goes at every trip, m; None: it rests.
    """
    given = {"force": force, "stiffness": stiffness, "relaxes": relaxes, "compresses": compresses}
    asked = {name: values for name, values in {**given, "keeps": keeps, "stroke": stroke}.items() if values is not None}
    shape = np.broadcast_shapes(*(np.shape(values) for values in asked.values()))
    flat = {name: np.broadcast_to(np.asarray(values, float), shape).ravel() for name, values in asked.items()}
    found = np.zeros(flat["force"].size, bool)
    ways = [(_stacks, _stack_table(room, listed or discs()))] if kind != "coil" else []
    if kind != "disc":
        ways.append((coils_hold, coil_table(room, any_turns=stiffness is None)))
    for test, table in ways:
        start = 0
        while start < table.size and (left := np.flatnonzero(~found)).size:
            rows = table[start : (start := start + max(1, _AT_ONCE // left.size)), None]
            found[left] = test(rows, room, **{name: column[left] for name, column in flat.items()}).any(axis=0)
    return found.reshape(shape)


@cache
def _stack_table(room: Room, listed: tuple[Disc, ...]) -> NDArray[Any]:
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


def _stacks(
    row: Any, room: Room, force: Numbers, relaxes: Numbers, compresses: Numbers, keeps: Numbers,
    stiffness: Numbers | None = None, stroke: Numbers | None = None,
) -> NDArray[np.bool_]:  # fmt: skip
    """Stacks of as many packs as stiffness and length allow, who bear the most."""
    bears = (force >= row["least"]) & (force <= row["most"])
    deflection = _deflection(row, np.where(bears, force, row["least"]))
    down, up = deflection - row["low"], row["high"] - deflection
    least = np.ones(bears.shape)
    if stiffness is not None:
        slope = row["parallel"] * law.disc_stiffness(**{name: row[name] for name in _SHAPE}, deflection=deflection)
        least = np.maximum(np.ceil(slope / stiffness / (1 + TOLERANCE) * (1 + _ROUNDING)), 1.0)
        most = np.minimum(np.floor(slope / stiffness / (1 - TOLERANCE) * (1 - _ROUNDING)), MOST_SERIES)
    elif room.length is not None:
        most = np.full(bears.shape, float(MOST_SERIES))
    else:  # the shortest of those that bear it
        most = np.fmax(np.ceil(np.fmax(relaxes / down, compresses / up) * (1 - SLACK)), 1.0)
    if room.length is not None:
        most = np.minimum(most, np.floor((room.length - relaxes) / (row["free"] - deflection) * (1 + SLACK)))
    good = bears & (least <= most) & (most * down >= relaxes * (1 - SLACK)) & (most * up >= compresses * (1 - SLACK))
    if keeps.any():
        shape = {name: row[name] for name in _SHAPE}
        good &= row["parallel"] * law.disc_force(**shape, deflection=deflection - relaxes / most) >= keeps * force
    return np.asarray(good)


def _deflection(row: Any, force: Numbers) -> Numbers:
    """Deflection of a single pack, m: about flat the force is a cubic u³ + p u = q, p > 0 where no disc snaps through.

    With T = t/K_4, u = s − h_0: p = 2 T² − h_0², q = 2 T² h_0 (F/F_c − 1), F_c flat.
    """
    square, height = (row["thickness"] / row["factor_flats"]) ** 2, row["cone_height"]
    steep = (2 * square - height**2) / 3
    q = square * height * (force / row["flat"] - 1)
    return height + 2 * np.sqrt(steep) * np.sinh(np.arcsinh(q / steep**1.5) / 3)
