"""Disc stacks and coil springs that might do, each with what it misses."""

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from ...engines.characteristic import (
    LEAST_USED,
    MOST_USED,
    SHEAR_MODULUS,
    CoilCharacteristic,
    DiscCharacteristic,
    characteristic,
)
from ...equations import springs as law
from ...messages import say
from ...spec.discs import Disc, discs
from ...spec.springs import CoilSprings, DiscStack
from .wish import Wish

MOST_PARALLEL = 6
"""Discs laid into each other; more than three are for friction, not for force."""
COUNTS = (1, 3, 4, 6, 8, 9, 12, 16, 20, 24)
"""Coil springs around the shaft."""
WIRES = tuple(
    each * 1e-3
    for each in (
        1, 1.1, 1.25, 1.4, 1.6, 1.8, 2, 2.2, 2.5, 2.8, 3.2, 3.6, 4, 4.5, 5, 5.6, 6.3, 7.1, 8, 9, 10, 11, 12.5, 14, 16,
    )
)  # fmt: skip
"""Wire diameters, R'20 of ISO 497, m."""
INDEX = (4.0, 20.0)
"""Mean coil diameter over wire diameter (EN 13906-1)."""
TURNS = (2.0, 25.0)
"""Active turns."""
SOLID_SHARE = 0.56
"""Shear stress, pressed solid, over tensile strength: what cold coiled springs bear (EN 13906-1)."""
STEEL = 7850.0
"""kg/m³."""
_FREE_TURNS = (3.0, 4.0, 6.0, 8.0, 12.0, 18.0)
"""Active turns to choose from where any stiffness will do."""
_STEPS = 24
MISSES = ("force", "preload", "deflection", "stiffness", "length", "inner diameter", "outer diameter", "stress")
"""What a part may not have as wished."""


class Candidate(NamedTuple):
    """A part, how far it is deflected as set, and what it misses."""

    part: DiscStack | CoilSprings
    label: str
    deflection: float
    misses: Mapping[str, float]
    """What is not as wished → by how much, relative; empty: it does."""


def disc_candidates(wish: Wish, tolerance: float) -> Iterator[Candidate]:
    """Stacks of every size, n laid into each other, and as many packs as stiffness, travel or room ask for."""
    for disc in discs():
        for parallel in range(1, MOST_PARALLEL + 1):
            single = stack_of(disc, parallel, 1)
            own = DiscCharacteristic(single)
            each = float(own.deflection(wish.force))
            for series in _series(wish, own, each):
                yield _judged(stack_of(disc, parallel, series), f"DIN EN 16983 {disc.name}", wish, tolerance)


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


def _series(wish: Wish, own: DiscCharacteristic, each: float) -> set[int]:
    """How many packs are worth a look: as few as the travel allows, as many as the stiffness or the length asks for."""
    low, high = LEAST_USED * own.cone_height, MOST_USED * own.cone_height
    needs = [
        1,
        math.ceil(wish.relaxes / (each - low)) if each > low else 1,
        math.ceil(wish.compresses / (high - each)) if each < high else 1,
    ]
    found = {max(needs)}
    if wish.stiffness is not None:
        wanted = float(own.stiffness(each)) / wish.stiffness
        found |= {max(1, math.floor(wanted)), max(1, math.ceil(wanted))}
    elif wish.room.length is not None:
        found.add(max(1, math.floor((wish.room.length - wish.relaxes) / (own.free_length - each))))
    return {min(series, 10_000) for series in found}


def coil_candidates(wish: Wish, tolerance: float) -> Iterator[Candidate]:
    """Coil springs around the shaft, or several on a circle, of every wire."""
    for count in COUNTS:
        for wire in WIRES:
            for coil in _coils(wish, count, wire):
                label = say("coil {wire:g} × {coil:g}", wire=wire * 1e3, coil=coil * 1e3)
                for turns in _turns(wish, count, wire, coil):
                    part = _spring(wish, count, wire, coil, turns)
                    yield _judged(part, label, wish, tolerance)


def _coils(wish: Wish, count: int, wire: float) -> list[float]:
    """Mean coil diameters that fit, in steps of whole millimetres at least."""
    inner, outer = wish.room.inner_diameter or 0.0, wish.room.outer_diameter
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


def _turns(wish: Wish, count: int, wire: float, coil: float) -> list[float]:
    """Active turns, in quarters."""
    if wish.stiffness is None:
        return list(_FREE_TURNS)
    wanted = count * float(law.coil_stiffness(SHEAR_MODULUS, wire, coil, 1.0)) / wish.stiffness
    quarters = round(4 * wanted) / 4
    return [quarters] if TURNS[0] <= quarters <= TURNS[1] else []


def _spring(wish: Wish, count: int, wire: float, coil: float, turns: float) -> CoilSprings:
    """As short as the gaps between its turns allow when it is pressed most."""
    rate = count * float(law.coil_stiffness(SHEAR_MODULUS, wire, coil, turns))
    shortest = float(law.coil_solid_length(wire, turns) + law.coil_least_gap(wire, coil, turns))
    free = shortest + wish.force / rate + wish.compresses
    return CoilSprings.model_construct(
        wire_diameter=wire, coil_diameter=coil, turns=turns, free_length=math.ceil(free * 1e4) / 1e4, count=count
    )


def strength(wire: float) -> float:
    """Tensile strength of patented drawn wire SM or DM, Pa (EN 10270-1): 1980 − 740 lg d."""
    return (1980 - 740 * math.log10(wire * 1e3)) * 1e6


def _judged(part: DiscStack | CoilSprings, label: str, wish: Wish, tolerance: float) -> Candidate:
    own = characteristic(part)
    deflection = float(own.deflection(wish.force))
    low, high = own.range
    held = float(own.force(own.end))
    misses = {
        "force": wish.force / held - 1,
        "preload": (low - (deflection - wish.relaxes)) / own.end,
        "deflection": (deflection + wish.compresses - high) / own.end,
        "stiffness": 0.0,
    }
    if wish.stiffness is not None:
        off = abs(float(own.stiffness(deflection)) / wish.stiffness - 1)
        misses["stiffness"] = off if off > tolerance else 0.0
    if wish.room.length is not None:
        misses["length"] = (own.free_length - deflection + wish.relaxes) / wish.room.length - 1
    misses |= _across(part, wish)
    if isinstance(own, CoilCharacteristic):
        misses["stress"] = own.stress(own.end) / (SOLID_SHARE * strength(own.part.wire_diameter)) - 1
    return Candidate(part, label, deflection, {name: by for name, by in misses.items() if by > 1e-9})


def _across(part: DiscStack | CoilSprings, wish: Wish) -> dict[str, float]:
    """By how much a disc is too wide or too narrow; coils are made to fit."""
    inner, outer = wish.room.inner_diameter, wish.room.outer_diameter
    if not isinstance(part, DiscStack):
        return {}
    return {
        "inner diameter": 1 - part.inner_diameter / inner if inner else 0.0,
        "outer diameter": part.outer_diameter / outer - 1 if outer else 0.0,
    }
