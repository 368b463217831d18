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


@np.errstate(all="ignore")
def held(
    kind: SpringKind, listed: tuple[Disc, ...] | None, room: Room, force: Numbers, stiffness: Numbers | None = None,
    **service: ArrayLike | None,
) -> NDArray[np.bool_]:  # fmt: skip
    """Whether a part of a kind, of discs listed or those that ship, does what is asked as ``checks_of_part`` has it.

    ``stiffness`` may be off by ``TOLERANCE``; of service ``relaxes``, ``compresses`` and ``stroke`` are as of a
    ``SpringDemand``, ``keeps`` is the share of its force that it is to have at its longest.
    """
    asked = {"force": force, "stiffness": stiffness, **service}
    columns = {name: np.asarray(values, float) for name, values in asked.items() if values is not None}
    shape = np.broadcast_shapes(*(column.shape for column in columns.values()))
    flat = {name: np.broadcast_to(column, shape).ravel() for name, column in columns.items()}
    found = np.zeros(flat["force"].size, bool)
    ways = [(_stacks_hold, _stack_table(room, listed or discs()))] if kind != "coil" else []
    if kind != "disc":
        ways.append((coils_hold, coil_table(room, any_turns="stiffness" not in flat)))
    for test, table in ways:
        start = 0
        while start < table.size and (left := np.flatnonzero(~found)).size:
            rows = table[start : (start := start + max(1, _AT_ONCE // left.size)), None]
            found[left] = test(rows, room, **{name: column[left] for name, column in flat.items()}).any(axis=0)
    return found.reshape(shape)


@cache
def _stack_table(room: Room, listed: tuple[Disc, ...]) -> NDArray[Any]:
    """Single packs that go into a room, as rows of numbers."""
    rows = [(pack.part.parallel, pack.free_length, *pack.range, *pack.shape) for pack in packs(room, listed)]
    return np.array(rows, dtype=[(name, float) for name in ("parallel", "free", "low", "high", *_SHAPE)])


def _stacks_hold(
    row: Any, room: Room, force: Numbers, relaxes: Any = 0.0, compresses: Any = 0.0, keeps: Any = 0.0,
    stiffness: Any = None, stroke: Any = None,
) -> NDArray[np.bool_]:  # fmt: skip
    """Stacks of as many packs as stiffness and length allow, who bear the most.

    About flat the force of a pack is a cubic u³ + p u = q, u = s − h_0, p > 0 where no disc snaps through; with
    T = t/K_4: p = 2 T² − h_0², q = 2 T² h_0 (F/F_c − 1), F_c flat.
    """
    shape, parallel, height = {name: row[name] for name in _SHAPE}, row["parallel"], row["cone_height"]
    square = (row["thickness"] / row["factor_flats"]) ** 2
    steep = (2 * square - height**2) / 3
    q = square * height * (force / (parallel * law.disc_force(**shape, deflection=height)) - 1)
    deflection = height + 2 * np.sqrt(steep) * np.sinh(np.arcsinh(q / steep**1.5) / 3)
    down, up, least = deflection - row["low"], row["high"] - deflection, 1.0
    if stiffness is not None:
        series = parallel * law.disc_stiffness(**shape, deflection=deflection) / stiffness
        least = np.fmax(np.ceil(series / (1 + TOLERANCE)), 1.0)
        most = np.fmin(np.floor(series / (1 - TOLERANCE)), MOST_SERIES)
    elif room.length is not None:
        most = np.full(deflection.shape, float(MOST_SERIES))
    else:  # the shortest of those that bear it
        most = np.fmax(np.ceil(np.fmax(relaxes / down, compresses / up) * (1 - SLACK)), 1.0)
    if room.length is not None:
        most = np.fmin(most, np.floor((room.length - relaxes) / (row["free"] - deflection) * (1 + SLACK)))
    good = (least <= most) & (most * down >= relaxes * (1 - SLACK)) & (most * up >= compresses * (1 - SLACK))
    if np.any(keeps):
        good &= parallel * law.disc_force(**shape, deflection=deflection - relaxes / most) >= keeps * force
    return np.asarray(good)
