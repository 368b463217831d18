"""Disc stacks and coil springs that might do, each with what it misses."""

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from ...engines.characteristic import DiscCharacteristic, characteristic
from ...engines.parts import INDEX, demands
from ...engines.wish import Wish
from ...equations import springs
from ...messages import say
from ...spec.catalogues import Disc, discs
from ...spec.springs import SHEAR_MODULUS, CoilSprings, DiscStack, Room
from .stacks import MOST_SERIES, packs, stack_of

COUNTS = (1, 3, 4, 6, 8, 9, 12, 16, 20, 24)
"""Coil springs around the shaft."""
WIRES = tuple(
    each * 1e-3
    for each in (
        1, 1.1, 1.25, 1.4, 1.6, 1.8, 2, 2.2, 2.5, 2.8, 3.2, 3.6, 4, 4.5, 5, 5.6, 6.3, 7.1, 8, 9, 10, 11, 12.5, 14, 16,
    )
)  # fmt: skip
"""Wire diameters, R'20 of ISO 497, m."""
TURNS = (2.0, 25.0)
"""Active turns."""
STEEL = 7850.0
"""kg/m³."""
_FREE_TURNS = (3.0, 4.0, 6.0, 8.0, 12.0, 18.0)
"""Active turns to choose from where any stiffness will do."""
_STEPS = 24
_ROUNDING = 1e-9
MISSES = (
    "force", "preload", "deflection", "stiffness", "length", "inner diameter", "outer diameter", "index", "stress",
    "fatigue", "buckling",
)  # fmt: skip
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
    for disc, own in packs(Room()):
        yield from _stacks(disc, own, wish, tolerance)


def disc_springs(wish: Wish, tolerance: float) -> Iterator[Candidate]:
    """Of those the ones that do."""
    for disc, own in packs(wish.room):
        low, high = own.range
        if own.force(low) * (1 - _ROUNDING) <= wish.force <= own.force(high) * (1 + _ROUNDING):
            yield from (each for each in _stacks(disc, own, wish, tolerance) if not each.misses)


def _stacks(disc: Disc, own: DiscCharacteristic, wish: Wish, tolerance: float) -> Iterator[Candidate]:
    for series in _series(wish, own, float(own.deflection(wish.force))):
        part = stack_of(disc, own.part.parallel, series)
        yield _judged(part, f"DIN EN 16983 {disc.name}", wish, tolerance)


def label_of(part: DiscStack | CoilSprings) -> str:
    """What a part is called: a disc by its standard, if it is of one."""
    if isinstance(part, CoilSprings):
        return say("coil {wire:g} × {coil:g}", wire=part.wire_diameter * 1e3, coil=part.coil_diameter * 1e3)
    for disc in discs():
        if stack_of(disc, part.parallel, part.series) == part:
            return f"DIN EN 16983 {disc.name}"
    outer, inner, thickness = (each * 1e3 for each in (part.outer_diameter, part.inner_diameter, part.thickness))
    return say("disc {outer:g} × {inner:g} × {thickness:g}", outer=outer, inner=inner, thickness=thickness)


def _series(wish: Wish, own: DiscCharacteristic, each: float) -> set[int]:
    """How many packs are worth a look: as few as the travel allows, as many as the length does or the stiffness asks.

    Each bound is one-sided, so that where any number does, one of these does.
    """
    low, high = own.range
    needs = max(
        1,
        math.ceil(wish.relaxes / (each - low) * (1 - _ROUNDING)) if each > low else 1,
        math.ceil(wish.compresses / (high - each) * (1 - _ROUNDING)) if each < high else 1,
    )
    most = MOST_SERIES
    if wish.room.length is not None:
        left = wish.room.length - wish.relaxes
        most = max(1, math.floor(left / (own.free_length - each) * (1 + _ROUNDING)))
    found = {needs}
    if wish.stiffness is not None:
        wanted = float(own.stiffness(each)) / wish.stiffness
        found |= {max(needs, min(series, most)) for series in (math.floor(wanted), math.ceil(wanted))}
    elif wish.room.length is not None:
        found.add(most)
    return {min(series, MOST_SERIES) for series in found}


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
    wanted = count * float(springs.coil_stiffness(SHEAR_MODULUS, wire, coil, 1.0)) / wish.stiffness
    quarters = round(4 * wanted) / 4
    return [quarters] if TURNS[0] <= quarters <= TURNS[1] else []


def _spring(wish: Wish, count: int, wire: float, coil: float, turns: float) -> CoilSprings:
    """As short as the gaps between its turns allow when it is pressed most."""
    rate = count * float(springs.coil_stiffness(SHEAR_MODULUS, wire, coil, turns))
    shortest = float(springs.coil_solid_length(wire, turns) + springs.coil_least_gap(wire, coil, turns))
    free = shortest + wish.force / rate + wish.compresses
    return CoilSprings.model_construct(
        wire_diameter=wire, coil_diameter=coil, turns=turns, free_length=math.ceil(free * 1e4) / 1e4, count=count
    )


def _judged(part: DiscStack | CoilSprings, label: str, wish: Wish, tolerance: float) -> Candidate:
    own = characteristic(part)
    deflection, misses = float(own.deflection(wish.force)), {"stiffness": 0.0}
    for each in demands(wish, part):
        name = each.rule.misses
        misses[name] = max(each.beyond, misses.get(name, 0.0))
    if wish.stiffness is not None:
        off = abs(float(own.stiffness(deflection)) / wish.stiffness - 1)
        misses["stiffness"] = off if off > tolerance else 0.0
    return Candidate(part, label, deflection, {name: by for name, by in misses.items() if by > _ROUNDING})
