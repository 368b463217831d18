"""Springs one can buy or wind: disc stacks and coil springs that give the forces of a clutch."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import groupby
from typing import Any

from ...engines.characteristic import CoilCharacteristic, characteristic
from ...engines.protocol import Clutch
from ...equations import springs as law
from ...errors import AfmcalcError
from ...findings import Finding, finding
from ...messages import joined, say, term
from ...spec import resolved
from ...spec.springs import CoilSprings, DiscStack
from ..registry import SpringKind, SpringOrder
from .candidates import STEEL, Candidate, coil_candidates, disc_candidates, stack_of
from .result import SpringOption, SpringsResult
from .wish import Wish, wishes

_BY: Mapping[SpringOrder, Callable[[SpringOption], float]] = {
    "length": lambda option: option.length,
    "wear": lambda option: option.loss_per_travel,
    "mass": lambda option: option.mass,
}
TOP = 10
TOLERANCE = 0.1
SETTING = 0.05
"""Share of the force that the nut is to set more or less."""


def springs(
    clutch: Clutch,
    sort: SpringOrder | None = None,
    top: int = TOP,
    kind: SpringKind = "any",
    tolerance: float = TOLERANCE,
) -> tuple[SpringsResult, list[Finding]]:
    """Find parts that give the force as set and the stiffness of every spring of a clutch, within the room given.

    Args:
        clutch: the clutch.
        sort: what is to be small: length in service, loss of force by wear, mass; by default the length where a
            stiffness is wanted, else the loss.
        top: how many to tell of each spring.
        kind: disc springs, coil springs, or both.
        tolerance: how far the stiffness may be off, relative.

    Returns:
        The parts and the findings; where there is none, the nearest and what it misses.
    """
    listed: dict[str, list[SpringOption]] = {}
    nearest: list[SpringOption] = []
    counts: dict[str, int] = {}
    said: list[Finding] = []
    number = 1
    wanted = wishes(clutch)
    for wish in wanted:
        every = list(_candidates(wish, kind, tolerance))
        order = sort or ("length" if wish.stiffness else "wear")
        options = sorted(_best_of_each(wish, [each for each in every if not each.misses], order), key=_BY[order])
        counts[wish.name] = len(options)
        listed[wish.name] = _numbered(options[:top], number)
        number += len(listed[wish.name])
        if not options and every:
            close = min(every, key=lambda each: max(each.misses.values()))
            nearest.append(_option(wish, close))
            said.append(_none(wish, close))
        said += _remarks(wish)
    result = SpringsResult(
        **{f"{wish.name}_{key}": getattr(wish, key) for wish in wanted for key in ("force", "stiffness")},
        **{f"{name}_found": count for name, count in counts.items()},
        **listed,
        nearest=nearest or None,
    )
    return result, [*clutch.findings(), *said]


def best_of(wish: Wish, tolerance: float) -> Candidate | None:
    """The part that would be told first."""
    every = [each for each in _candidates(wish, "any", tolerance) if not each.misses]
    order = _BY["length" if wish.stiffness else "wear"]
    return min(every, key=lambda each: order(_option(wish, each)), default=None)


def picked(clutch: Clutch, result: SpringsResult, numbers: Sequence[int]) -> dict[str, Any]:
    """Return the spec with force, stiffness and part of the springs picked.

    Raises:
        AfmcalcError: no such number, or two of one spring.
    """
    data = resolved(clutch.spec)
    lists = {"closing_spring": result.closing, "control_spring": result.control or []}
    taken = set()
    for number in numbers:
        found = [(block, option) for block, options in lists.items() for option in options if option.number == number]
        if not found:
            most = sum(map(len, lists.values()))
            raise AfmcalcError(say("--pick {number}: there are {most} to pick from", number=number, most=most))
        ((block, option),) = found
        if block in taken:
            raise AfmcalcError(say("--pick {number}: {block} is picked already", number=number, block=block))
        taken.add(block)
        for other in ("disc", "coil"):
            data[block].pop(other, None)
        data[block] |= {"force": option.force, "stiffness": option.stiffness, option.kind: _part_of(option)}
    if "control_spring" in taken:
        data["closing_spring"].setdefault("force", float(clutch.closing_force))
    return data


def _candidates(wish: Wish, kind: SpringKind, tolerance: float) -> Iterable[Candidate]:
    if kind != "coil":
        yield from disc_candidates(wish, tolerance)
    if kind != "disc":
        yield from coil_candidates(wish, tolerance)


def _best_of_each(wish: Wish, found: list[Candidate], sort: SpringOrder) -> list[SpringOption]:
    """The best of every size of disc, of every wire and count: its neighbours are much the same."""

    def family(each: Candidate) -> tuple[Any, ...]:
        if isinstance(each.part, DiscStack):
            return ("disc", each.label, each.part.parallel)
        return ("coil", each.part.wire_diameter, each.part.count)

    groups = groupby(sorted(found, key=lambda each: tuple(map(str, family(each)))), key=family)
    return [min((_option(wish, each) for each in group), key=_BY[sort]) for _, group in groups]


def _numbered(options: list[SpringOption], first: int) -> list[SpringOption]:
    return [each.model_copy(update={"number": number}) for number, each in enumerate(options, first)]


def _option(wish: Wish, found: Candidate) -> SpringOption:
    own, part, deflection = characteristic(found.part), found.part, found.deflection
    force, stiffness = float(own.force(deflection)), float(own.stiffness(deflection))
    low, high = deflection - wish.relaxes, deflection + wish.compresses
    setting = float(own.deflection((1 + SETTING) * force) - own.deflection((1 - SETTING) * force))
    common = {
        "number": 0,
        "part": found.label,
        "force": force,
        "force_least": float(own.force(low)),
        "force_largest": float(own.force(high)),
        "stiffness": stiffness,
        "deflection": deflection,
        "length": own.free_length - low,
        "free_length": own.free_length,
        "used_low": low / own.end,
        "used_high": high / own.end,
        "loss_per_travel": stiffness / force,
        "loss_per_wear": None if wish.follows is None else wish.follows * stiffness / force,
        "travel_setting": setting,
        "turns_setting": None if wish.pitch is None else setting / wish.pitch,
    }
    if isinstance(own, CoilCharacteristic):
        return SpringOption(**common, **_coil(own, high))
    assert isinstance(part, DiscStack)
    middle, edge = own.stresses(high)
    return SpringOption(
        **common,
        **_friction(wish, force, part.parallel),
        kind="disc",
        parallel=part.parallel,
        series=part.series,
        count=None,
        turns=None,
        outer_diameter=part.outer_diameter,
        inner_diameter=part.inner_diameter,
        stress=edge,
        stress_middle=middle,
        mass=part.parallel
        * part.series
        * float(law.ring_mass(STEEL, part.outer_diameter, part.inner_diameter, own.thickness, math.pi)),
    )


def _coil(own: CoilCharacteristic, high: float) -> dict[str, Any]:
    part = own.part
    mass = law.coil_mass(STEEL, part.wire_diameter, part.coil_diameter, part.turns, math.pi)
    return {
        "kind": "coil",
        "parallel": None,
        "series": None,
        "count": part.count,
        "turns": part.turns,
        "outer_diameter": part.coil_diameter + part.wire_diameter,
        "inner_diameter": part.coil_diameter - part.wire_diameter,
        "stress": own.stress(high),
        "stress_solid": own.stress(own.end),
        "force_up": None,
        "force_down": None,
        "mass": part.count * float(mass),
    }


def _friction(wish: Wish, force: float, parallel: int) -> dict[str, float | None]:
    if wish.friction is None:
        return {"force_up": None, "force_down": None}
    surface, edge = wish.friction
    return {
        "force_up": float(law.stack_force_with_friction(force, parallel, surface, edge)),
        "force_down": float(law.stack_force_with_friction(force, parallel, -surface, -edge)),
    }


def _part_of(option: SpringOption) -> dict[str, Any]:
    """The part as a spec says it."""
    if option.kind == "disc":
        from ...spec.discs import discs

        (disc,) = (each for each in discs() if option.part.endswith(f" {each.name}"))
        assert option.parallel is not None
        assert option.series is not None
        return stack_of(disc, option.parallel, option.series).model_dump(exclude_none=True)
    wire = (option.outer_diameter - option.inner_diameter) / 2
    return CoilSprings(
        wire_diameter=wire,
        coil_diameter=option.outer_diameter - wire,
        turns=option.turns,
        free_length=option.free_length,
        count=option.count,
    ).model_dump()


def _none(wish: Wish, close: Candidate) -> Finding:
    ranked = sorted(close.misses.items(), key=lambda each: -each[1])
    misses = joined(_missed(name, by) for name, by in ranked)
    part = close.part
    size = f"{part.parallel} × {part.series}" if isinstance(part, DiscStack) else f"{part.count} × {part.turns:g}"
    path = f"{wish.name}_spring"
    return finding("no-spring", "warning", value=wish.force, path=path, part=close.label, size=size, misses=misses)


def _missed(name: str, by: float) -> str:
    if by < 1:
        return say("{name} by {by:.1%}", name=term(name), by=by)
    return say("{name} by {by:.3g} times", name=term(name), by=by)


def _remarks(wish: Wish) -> list[Finding]:
    room, path = wish.room, f"{wish.name}_spring.room"
    said = []
    if room.inner_diameter is None or room.outer_diameter is None or room.length is None:
        said.append(finding("room-not-given", "info", path=path))
    if wish.stiffness is None:
        said.append(finding("any-stiffness", "info", path=f"{wish.name}_spring.stiffness"))
    return said
