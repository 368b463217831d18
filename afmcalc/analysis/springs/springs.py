"""Springs one can buy or wind: disc stacks and coil springs that give the forces of a clutch."""

from collections.abc import Callable, Mapping, Sequence
from itertools import count, groupby
from typing import Any, Literal

import numpy as np

from ...engines import Clutch
from ...engines.parts import checks_of_part
from ...engines.springs import CoilCharacteristic, DiscCharacteristic, SpringDemand, SpringName, characteristic
from ...equations import springs as law
from ...errors import AfmcalcError, CalculationError
from ...findings import Finding, finding
from ...messages import joined, say, term
from ...result import Answer, Result, Sentence, described, quantity
from ...spec import resolved
from ...spec.catalogues import Disc, discs
from ...spec.models import CoilSprings, DiscStack
from ..clutch_findings import clutch_findings
from ..registry import SpringKind, SpringOrder
from .candidates import TOLERANCE, Candidate, candidates, label_of, stack_of

Kind = Literal["disc", "coil"]
SETTING = 0.05
"""Share of the force that the nut is to set more or less."""
TOP = 10
_BORNE = ("deflection", "stress", "fatigue")
"""Demands that tell how much of what it bears a part uses."""
_CURVE_POINTS = 121


class SpringOption(Result):
    """A part that gives the force, and what else it gives."""

    number: int | None = described("number", optional=True)
    spring: SpringName | None = described("spring", optional=True)
    kind: Kind = described("kind", detail=True)
    part: Sentence = described("part")
    parallel: int | None = quantity("1", "n", "discs nested in each other, in parallel")
    series: int | None = quantity("1", "i", "packs against each other, in series")
    count: int | None = quantity("1", "n_п", "springs around the shaft")
    turns: float | None = quantity("1", "n_w", "active turns")
    outer_diameter: float = quantity("m", "D_e", "outer diameter", detail=True)
    inner_diameter: float = quantity("m", "D_i", "inner diameter", detail=True)
    force: float = quantity("N", "F", "force as set", detail=True)
    force_least: float | None = quantity("N", "F_1", "least force in service", detail=True, null="slack")
    force_largest: float = quantity("N", "F_2", "largest force in service", detail=True)
    stiffness: float = quantity("N/m", "c", "stiffness as set")
    deflection: float = quantity("m", "s", "deflection as set", detail=True)
    length_set: float = quantity("m", "L", "length as set")
    length: float = quantity("m", "L_1", "largest length in service, at the least deflection")
    free_length: float = quantity("m", "L_0", "length without load", detail=True)
    used_low: float = quantity("1", "s_1/s_c", "least deflection in service over that pressed flat or solid")
    used_high: float = quantity("1", "s_2/s_c", "largest deflection in service over that pressed flat or solid")
    loading: Literal["static", "dynamic"] | None = described("loading of a coil", optional=True)
    stress_correction: float | None = quantity(
        "1", "k_τ", "factor of the coil's curvature in the stress, 1 of one that rests", optional=True, detail=True
    )
    stress: float = quantity("Pa", "σ, τ", "largest stress in service: tension of a disc, shear of a wire")
    stress_middle: float | None = quantity(
        "Pa", "σ_OM", "stress where the section of a disc turns", optional=True, detail=True
    )
    stress_solid: float | None = quantity(
        "Pa", "τ_c", "shear stress of a wire, solid, without k_τ", optional=True, detail=True
    )
    utilisation: float = quantity(
        "1", "η", "largest share used: of the range of deflection, of the stress allowed", detail=True
    )
    loss_per_travel: float = quantity("1/m", "c/F", "share of the force lost per travel of the spring")
    loss_per_wear: float | None = quantity(
        "1/m", "c z/F", "share of the force lost per wear of a pair", optional=True, detail=True
    )
    travel_setting: float = quantity("m", "s_5%", "travel of the nut from 95 to 105 % of the force", detail=True)
    turns_setting: float | None = quantity("1", "ν_5%", "turns of the nut from 95 to 105 % of the force")
    force_up: float | None = quantity("N", "F_↓", "force that friction asks for when pressed", detail=True)
    force_down: float | None = quantity("N", "F_↑", "force that friction leaves when let go", detail=True)
    mass: float = quantity("kg", "m_s", "mass")


class SpringsResult(Answer):
    """Parts that give forces and stiffnesses of the springs, the best first."""

    closing_force: float = quantity("N", "F_п", "force wanted of the closing spring")
    closing_stiffness: float | None = quantity("N/m", "c_1", "stiffness wanted", null="any", optional=True)
    closing_found: int = described("number of springs found for it")
    control_force: float | None = quantity("N", "F_п2", "force wanted of the control spring", optional=True)
    control_stiffness: float | None = quantity("N/m", "c_2", "stiffness wanted of it", null="any", optional=True)
    control_found: int | None = described("number of springs found for it", optional=True)
    closing: list[SpringOption] = described("closing spring")
    control: list[SpringOption] | None = described("control spring", optional=True)
    named: list[SpringOption] | None = described("springs that the spec names", optional=True)
    utilisation: float | None = quantity(
        "1",
        "η",
        "largest share that these use: of the range of deflection, of the stress allowed",
        optional=True,
        detail=True,
    )
    nearest: list[SpringOption] | None = described("nearest, where there is none", optional=True)


class SpringCurve(Result):
    """Force over deflection of one spring, and where on it the clutch works."""

    spring: SpringName = described("spring")
    part: Sentence = described("part")
    deflection: list[float] = quantity("m", "s", "deflection")
    force: list[float] = quantity("N", "F", "force")
    tangent: list[float] = quantity("N", "c s", "straight spring of the stiffness as set")
    set_deflection: float = quantity("m", "s", "deflection as set")
    set_force: float = quantity("N", "F", "force as set")
    service: tuple[float, float] = quantity("m", "s", "deflections in service")
    usable: tuple[float, float] = quantity("m", "s", "deflections it may be used between")


class SpringsCurve(Result):
    """The springs of a clutch."""

    name: str | None = described("name of the clutch", optional=True)
    springs: list[SpringCurve] = described("springs")


_BY: Mapping[SpringOrder, Callable[[SpringOption], float]] = {
    "length": lambda option: option.length,
    "wear": lambda option: option.loss_per_travel,
    "mass": lambda option: option.mass,
}


def springs(
    clutch: Clutch,
    sort: SpringOrder | None = None,
    top: int = TOP,
    kind: SpringKind = "any",
    tolerance: float = TOLERANCE,
) -> tuple[SpringsResult, list[Finding]]:
    """Find parts that give the force as set and the stiffness of every spring of a clutch, within the room given.

    Where there is none, the nearest and what it misses; and the parts that the spec names. Small is by default the
    length where a stiffness is wanted, which may be off by ``tolerance``, relative, else the loss of force by wear.
    """
    fields: dict[str, Any] = {}
    nearest: list[SpringOption] = []
    remarks: list[Finding] = []
    number = count(1)
    demands = clutch.spring_demands()
    for demand in demands:
        tried = list(candidates(demand, kind, tolerance))
        options = _best_of_each(demand, [part for part, misses in tried if not misses], sort)
        fields |= {
            f"{demand.name}_force": demand.force,
            f"{demand.name}_stiffness": demand.stiffness,
            f"{demand.name}_found": len(options),
            demand.name: [option.model_copy(update={"number": next(number)}) for option in options[:top]],
        }
        if not options and tried:
            close = min(tried, key=lambda candidate: max(candidate.misses.values()))
            nearest.append(option_of(demand, close.part))
            remarks.append(_none(demand, close))
        if None in (demand.room.inner_diameter, demand.room.outer_diameter, demand.room.length):
            remarks.append(finding("room-not-given", "info", path=f"{demand.name}_spring.room"))
        if demand.stiffness is None:
            remarks.append(finding("any-stiffness", "info", path=f"{demand.name}_spring.stiffness"))
    parts = clutch.spec.spring_parts
    in_use = [
        option_of(demand, parts[demand.name]).model_copy(update={"spring": demand.name})
        for demand in demands
        if demand.name in parts
    ]
    result = SpringsResult(
        **fields,
        nearest=nearest or None,
        named=in_use or None,
        utilisation=max((option.utilisation for option in in_use), default=None),
    )
    return result, [*clutch_findings(clutch.spec, clutch.quantities), *remarks]


def ranked(demand: SpringDemand, kind: SpringKind = "any", top: int | None = None) -> list[SpringOption]:
    """The parts that do, in the order they are told in."""

    def key(part: DiscStack | CoilSprings) -> float:
        spring, force = characteristic(part), demand.force
        at = float(spring.deflection(force))
        return spring.free_length - at if demand.stiffness else float(spring.stiffness(at)) / force

    fitting = [part for part, misses in candidates(demand, kind, fitting=True) if not misses]
    return [option_of(demand, part) for part in sorted(fitting, key=key)[:top]]


def _by(demand: SpringDemand, sort: SpringOrder | None = None) -> Callable[[SpringOption], float]:
    return _BY[sort or ("length" if demand.stiffness else "wear")]


def _best_of_each(
    demand: SpringDemand, parts: list[DiscStack | CoilSprings], sort: SpringOrder | None
) -> list[SpringOption]:
    """The best of every size of disc, of every wire and count, sorted: its neighbours are much the same."""

    def family(part: DiscStack | CoilSprings) -> tuple[str, ...]:
        if isinstance(part, DiscStack):
            return ("disc", label_of(part, demand.catalogue), str(part.parallel))
        return ("coil", str(part.wire_diameter), str(part.count))

    by, families = _by(demand, sort), groupby(sorted(parts, key=family), key=family)
    return sorted((min((option_of(demand, part) for part in alike), key=by) for _, alike in families), key=by)


def option_of(demand: SpringDemand, part: DiscStack | CoilSprings) -> SpringOption:
    """What a part gives as set and in service, and what it bears."""
    spring = characteristic(part)
    deflection = float(spring.deflection(demand.force))
    force, stiffness = float(spring.force(deflection)), float(spring.stiffness(deflection))
    low, high = deflection - demand.relaxes, deflection + demand.compresses
    setting = float(spring.deflection((1 + SETTING) * force) - spring.deflection((1 - SETTING) * force))
    of_kind = (
        _of_coils(spring, demand, high)
        if isinstance(spring, CoilCharacteristic)
        else _of_discs(spring, demand, force, high)
    )
    return SpringOption(
        number=None,
        part=label_of(part, demand.catalogue),
        force=force,
        force_least=None if low < 0 else float(spring.force(low)),
        force_largest=float(spring.force(high)),
        stiffness=stiffness,
        deflection=deflection,
        length_set=spring.free_length - deflection,
        length=spring.free_length - low,
        free_length=spring.free_length,
        used_low=low / spring.end,
        used_high=high / spring.end,
        loss_per_travel=stiffness / force,
        loss_per_wear=None if demand.follows is None else demand.follows * stiffness / force,
        utilisation=max(check.utilisation for check in checks_of_part(demand, part) if check.rule.misses in _BORNE),
        travel_setting=setting,
        turns_setting=None if demand.pitch is None else setting / demand.pitch,
        **of_kind,
    )


def _of_coils(spring: CoilCharacteristic, demand: SpringDemand, high: float) -> dict[str, Any]:
    part, rests = spring.part, demand.stroke is None
    correction = 1.0 if rests else spring.correction
    return {
        **dict.fromkeys(("parallel", "series", "force_up", "force_down")),
        "kind": "coil",
        "count": part.count,
        "turns": part.turns,
        "outer_diameter": part.coil_diameter + part.wire_diameter,
        "inner_diameter": part.coil_diameter - part.wire_diameter,
        "loading": "static" if rests else "dynamic",
        "stress_correction": correction,
        "stress": correction * spring.stress(high),
        "stress_solid": spring.stress(spring.end),
        "mass": float(spring.mass),
    }


def _of_discs(spring: DiscCharacteristic, demand: SpringDemand, force: float, high: float) -> dict[str, Any]:
    part = spring.part
    middle, edge = spring.stresses(high)
    up = down = None
    if demand.friction is not None:
        up, down = (
            float(law.stack_force_with_friction(force, part.parallel, *(sign * share for share in demand.friction)))
            for sign in (1, -1)
        )
    return {
        **dict.fromkeys(("count", "turns", "loading", "stress_correction")),
        "kind": "disc",
        "parallel": part.parallel,
        "series": part.series,
        "outer_diameter": part.outer_diameter,
        "inner_diameter": part.inner_diameter,
        "force_up": up,
        "force_down": down,
        "stress": edge,
        "stress_middle": middle,
        "mass": float(spring.mass),
    }


def part_of(option: SpringOption, catalogue: tuple[Disc, ...] | None = None) -> DiscStack | CoilSprings:
    """The part as a spec says it; a disc from the list it was chosen from."""
    if option.parallel is not None and option.series is not None:
        disc = next(disc for disc in catalogue or discs() if option.part == disc.title)
        return stack_of(disc, option.parallel, option.series)
    wire = (option.outer_diameter - option.inner_diameter) / 2
    return CoilSprings(
        wire_diameter=wire,
        coil_diameter=option.outer_diameter - wire,
        turns=option.turns,
        free_length=option.free_length,
        count=option.count,
    )


def picked(clutch: Clutch, result: SpringsResult, numbers: Sequence[int]) -> dict[str, Any]:
    """Return the spec with force, stiffness and part of the springs picked.

    Raises:
        AfmcalcError: no such number, or two of one spring.
    """
    data = resolved(clutch.spec)
    blocks = {"closing_spring": result.closing, "control_spring": result.control or []}
    numbered = {option.number: (block, option) for block, options in blocks.items() for option in options}
    taken = set()
    for number in numbers:
        if number not in numbered:
            raise AfmcalcError("--pick {number}: there are {most} to pick from", number=number, most=len(numbered))
        block, option = numbered[number]
        if block in taken:
            raise AfmcalcError("--pick {number}: {block} is picked already", number=number, block=block)
        taken.add(block)
        for other in ("disc", "coil"):
            data[block].pop(other, None)
        part = part_of(option, clutch.spec.lists.discs).model_dump(exclude_none=True)
        data[block] |= {"force": option.force, "stiffness": option.stiffness, option.kind: part}
    if "control_spring" in taken:
        data["closing_spring"].setdefault("force", float(clutch.closing_force))
    return data


def _none(demand: SpringDemand, close: Candidate) -> Finding:
    """Say that no part does, and what the nearest misses."""
    misses = joined(
        say("{name} by {by:.1%}", name=term(name), by=by)
        if by < 1
        else say("{name} by {by:.3g} times", name=term(name), by=by)
        for name, by in sorted(close.misses.items(), key=lambda miss: -miss[1])
    )
    part = close.part
    size = f"{part.parallel} × {part.series}" if isinstance(part, DiscStack) else f"{part.count} × {part.turns:g}"
    path = f"{demand.name}_spring"
    return finding(
        "no-spring",
        "warning",
        value=demand.force,
        path=path,
        part=label_of(part, demand.catalogue),
        size=size,
        misses=misses,
    )


def springs_curve(clutch: Clutch) -> SpringsCurve:
    """Calculate the characteristic of the parts that a spec names, else of the best that is found.

    Raises:
        CalculationError: there is no part.
    """
    curves = []
    for demand in clutch.spring_demands():
        part = clutch.spec.spring_parts.get(demand.name)
        if part is None:
            best = ranked(demand)
            if not best:
                raise CalculationError("plot springs: nothing fits: {name}", name=term(f"{demand.name} spring"))
            part = part_of(best[0], demand.catalogue)
        spring = characteristic(part)
        deflections = np.linspace(0.0, spring.end, _CURVE_POINTS)
        at = float(spring.deflection(demand.force))
        curve = SpringCurve(
            spring=demand.name,
            part=label_of(part, demand.catalogue),
            deflection=deflections.tolist(),
            force=np.asarray(spring.force(deflections)).tolist(),
            tangent=(demand.force + float(spring.stiffness(at)) * (deflections - at)).tolist(),
            set_deflection=at,
            set_force=float(spring.force(at)),
            service=(at - demand.relaxes, at + demand.compresses),
            usable=spring.range,
        )
        curves.append(curve)
    return SpringsCurve(name=clutch.spec.name, springs=curves)
