"""Springs one can buy or wind: disc stacks and coil springs that give the forces of a clutch."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import groupby
from typing import Any

from ...engines.protocol import Clutch
from ...engines.wish import Wish
from ...errors import AfmcalcError
from ...findings import Finding, finding
from ...messages import joined, say, term
from ...spec import resolved
from ...spec.springs import DiscStack
from ..registry import SpringKind, SpringOrder
from .candidates import Candidate, coil_candidates, disc_candidates, disc_springs
from .options import named, option_of, part_of
from .result import SpringOption, SpringsResult
from .stacks import TOLERANCE

_BY: Mapping[SpringOrder, Callable[[SpringOption], float]] = {
    "length": lambda option: option.length,
    "wear": lambda option: option.loss_per_travel,
    "mass": lambda option: option.mass,
}
TOP = 10


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
        The parts and the findings; where there is none, the nearest and what it misses; the parts that the spec names.
    """
    listed: dict[str, list[SpringOption]] = {}
    nearest: list[SpringOption] = []
    counts: dict[str, int] = {}
    said: list[Finding] = []
    number = 1
    wanted = clutch.wishes()
    for wish in wanted:
        every = list(_candidates(wish, kind, tolerance))
        order = sort or ("length" if wish.stiffness else "wear")
        options = sorted(_best_of_each(wish, [each for each in every if not each.misses], order), key=_BY[order])
        counts[wish.name] = len(options)
        listed[wish.name] = _numbered(options[:top], number)
        number += len(listed[wish.name])
        if not options and every:
            close = min(every, key=lambda each: max(each.misses.values()))
            nearest.append(option_of(wish, close))
            said.append(_none(wish, close))
        said += _remarks(wish)
    parts = clutch.spec.spring_parts
    in_use = [named(wish, parts[wish.name]) for wish in wanted if wish.name in parts]
    result = SpringsResult(
        **{f"{wish.name}_{key}": getattr(wish, key) for wish in wanted for key in ("force", "stiffness")},
        **{f"{name}_found": count for name, count in counts.items()},
        **listed,
        nearest=nearest or None,
        named=in_use or None,
        utilisation=max((each.utilisation for each in in_use), default=None),
    )
    return result, [*clutch.findings(), *said]


def ranked(wish: Wish, kind: SpringKind = "any", tolerance: float = TOLERANCE) -> list[SpringOption]:
    """Every part that does, in the order they are told in."""
    every = [] if kind == "coil" else list(disc_springs(wish, tolerance))
    if kind != "disc":
        every += [each for each in coil_candidates(wish, tolerance) if not each.misses]
    return sorted((option_of(wish, each) for each in every), key=_BY["length" if wish.stiffness else "wear"])


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
        part = part_of(option).model_dump(exclude_none=True)
        data[block] |= {"force": option.force, "stiffness": option.stiffness, option.kind: part}
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
    return [min((option_of(wish, each) for each in group), key=_BY[sort]) for _, group in groups]


def _numbered(options: list[SpringOption], first: int) -> list[SpringOption]:
    return [each.model_copy(update={"number": number}) for number, each in enumerate(options, first)]


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
