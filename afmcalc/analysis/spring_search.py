"""Springs to buy or wind: stacks of disc springs and coil springs that give the forces of a clutch."""

import math
from collections.abc import Mapping, Sequence
from functools import cache
from itertools import count, product
from typing import Any, Literal, NamedTuple

import numpy as np
from pydantic import PrivateAttr

from ..engines import Clutch
from ..engines.characteristics import DiscCharacteristic, characteristic
from ..engines.parts import INDEX, SpringDemand, SpringName, checks_of_part, spring_demands, values_of_part
from ..equations import springs as law
from ..equations.arrays import Floats
from ..errors import AfmcalcError
from ..findings import Finding, finding
from ..messages import say, translate
from ..result import Answer, Result, described, quantity
from ..spec import Spec
from ..spec.catalogues import Disc, discs
from ..spec.edit import respecified
from ..spec.models import SHEAR_MODULUS, CoilSprings, DiscStack, Room
from .clutch_findings import clutch_findings
from .registry import SpringKind, SpringOrder

Kind = Literal["disc", "coil"]
Part = DiscStack | CoilSprings
SETTING = 0.05
"""Share of the spring force by which turning the nut is to raise or lower the force."""
TOP = 10
TOLERANCE = 0.1
"""Relative deviation that is allowed to a stiffness."""
MOST_PARALLEL = 6
"""Largest number of disc springs nested in parallel; more than three add friction rather than force."""
MOST_SERIES = 10_000
"""Largest number of packs in series."""
COUNTS = (1, 3, 4, 6, 8, 9, 12, 16, 20, 24)
"""Numbers of coil springs to try: one spring around the shaft, or several on a circle."""
WIRES = tuple(
    diameter * 1e-3
    for diameter in (
        1, 1.1, 1.25, 1.4, 1.6, 1.8, 2, 2.2, 2.5, 2.8, 3.2, 3.6, 4, 4.5, 5, 5.6, 6.3, 7.1, 8, 9, 10, 11, 12.5, 14, 16,
    )
)  # fmt: skip
"""Wire diameters, R'20 of ISO 497, m."""
TURNS = (2.0, 25.0)
"""Smallest and largest number of active turns."""
_FREE_TURNS = (3.0, 4.0, 6.0, 8.0, 12.0, 18.0)
"""Numbers of active turns to try if any stiffness will do."""
_STEPS = 24
"""Number of mean coil diameters to try for each wire diameter."""
_SIZES = ("outer_diameter", "inner_diameter", "thickness", "reduced_thickness", "free_height")
"""Dimensions of a disc spring."""
_SLACK = 1e-9
"""Relative excess over a limit that counts as a rounding error."""
_BORNE = ("deflection", "stress", "fatigue")
"""Topics of those checks that give the utilisation of a spring part."""


class SpringOption(Result):
    """A part that gives the force, and what else it gives."""

    number: int | None = described("number", optional=True)
    spring: SpringName | None = described("spring", optional=True)
    kind: Kind = described("kind", detail=True)
    part: str = described("part")
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

    _made: DiscStack | CoilSprings = PrivateAttr()

    @property
    def made(self) -> DiscStack | CoilSprings:
        """The spring part as a block of the spec."""
        return self._made


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
        "1", "η", "largest share that these use: of the range of deflection, of the stress allowed", optional=True,
        detail=True,
    )  # fmt: skip
    nearest: list[SpringOption] | None = described("nearest, where there is none", optional=True)


class Table(NamedTuple):
    """Spring parts of one kind: columns of their sizes and of their deviations from the demand, a row for each part."""

    parts: Part
    values: dict[str, Any]
    misses: dict[str, Floats]
    """Quantity → relative deviations of the parts from the demand; 0 where a part meets it."""

    def worst(self) -> Floats:
        """Largest deviation of each part."""
        return np.max(list(self.misses.values()), axis=0)

    def part(self, row: int) -> Part:
        """Return the part in a row; the reduced thickness of a disc spring without flats is None."""
        sizes = {name: column[row].item() for name, column in vars(self.parts).items()}
        if isinstance(self.parts, DiscStack) and sizes["reduced_thickness"] == sizes["thickness"]:
            sizes["reduced_thickness"] = None
        return self.parts.model_construct(**sizes)


_BY: Mapping[SpringOrder, str] = {"length": "length", "wear": "stiffness", "mass": "mass"}
"""Order of the spring parts → quantity by which they are sorted, the smallest first."""


def springs(
    clutch: Clutch,
    sort: SpringOrder | None = None,
    top: int = TOP,
    kind: SpringKind = "any",
    tolerance: float = TOLERANCE,
) -> tuple[SpringsResult, list[Finding]]:
    """Find parts that give the set force and the stiffness of every spring of a clutch and fit in its room.

    The result also has the parts that the spec names and, if no part fits, the nearest part. By default parts are
    sorted by length if a stiffness is wanted (it may deviate by the share ``tolerance``), else by force lost by wear.
    """
    fields, nearest, remarks, number = dict[str, Any](), list[SpringOption](), list[Finding](), count(1)
    demands, named = bounded_demands(clutch), clutch.spec.spring_parts
    for demand in demands:
        tables = _tables(demand, kind, tolerance)
        found = _fitting(demand, tables, sort, families=True)
        fields |= {
            f"{demand.name}_force": demand.force,
            f"{demand.name}_stiffness": demand.stiffness,
            f"{demand.name}_found": len(found),
            demand.name: [option_of(demand, table.part(row), number=next(number)) for table, row in found[:top]],
        }
        if not found and (worst := [(table.worst().min(), table) for table in tables if table.worst().size]):
            table = min(worst, key=lambda each: each[0])[1]
            row = int(table.worst().argmin())
            nearest.append(option_of(demand, table.part(row)))
            misses = {name: float(by[row]) for name, by in table.misses.items() if by[row] > _SLACK}
            remarks.append(_none(demand, table.part(row), misses))
    for demand in spring_demands(clutch):
        if None in (demand.room.inner_diameter, demand.room.outer_diameter, demand.room.length):
            path = f"{demand.name}_spring.room"
            remarks.append(finding("room-not-given", "info", limit=_width(clutch), path=path))
        if demand.stiffness is None:
            remarks.append(finding("any-stiffness", "info", path=f"{demand.name}_spring.stiffness"))
    in_use = [option_of(demand, named[demand.name], spring=demand.name) for demand in demands if demand.name in named]
    result = SpringsResult(
        **fields, nearest=nearest or None, named=in_use or None,
        utilisation=max((option.utilisation for option in in_use), default=None),
    )  # fmt: skip
    return result, [*clutch_findings(clutch), *remarks]


def bounded_demands(clutch: Clutch) -> list[SpringDemand]:
    """Return the demand on each spring; a room without diameter or length has the outer diameter of the clutch."""

    def bounded(room: Room) -> Room:
        width = {"outer_diameter": _width(clutch), "length": _width(clutch)}
        return room.model_copy(update={name: value for name, value in width.items() if getattr(room, name) is None})

    return [demand._replace(room=bounded(demand.room)) for demand in spring_demands(clutch)]


def _width(clutch: Clutch) -> float:
    """Outer diameter of the friction faces, m; if it is not given, the diameter in the drawing."""
    return float(clutch.get("outer_diameter") or 2.4 * clutch.mean_radius)


def ranked(demand: SpringDemand, kind: SpringKind = "any", top: int | None = None) -> list[SpringOption]:
    """Return at most ``top`` parts that fit, in the order of ``springs``."""
    found = _fitting(demand, _tables(demand, kind, TOLERANCE), None, families=False)
    return [option_of(demand, table.part(row)) for table, row in found[:top]]


@np.errstate(all="ignore")
def _tables(demand: SpringDemand, kind: SpringKind, tolerance: float) -> list[Table]:
    """Return a table for each kind of spring parts: all parts of the kind and their deviations from the demand."""
    tables = []
    for columns in ([] if kind == "coil" else [stacks(demand)]) + ([] if kind == "disc" else [coils(demand)]):
        values = values_of_part(demand, columns)
        off = np.abs(values["stiffness"] / (demand.stiffness or values["stiffness"]) - 1)
        misses = {"stiffness": np.where(off > tolerance, off, 0.0)}
        for check in checks_of_part(values):
            name = check.rule.topic
            misses[name] = np.fmax(misses.get(name, 0.0), np.where(check.beyond > _SLACK, check.beyond, 0.0))
        tables.append(Table(columns, values, misses))
    return tables


def _fitting(
    demand: SpringDemand, tables: list[Table], sort: SpringOrder | None, *, families: bool
) -> list[tuple[Table, int]]:
    """Return the rows that meet the demand, sorted; with ``families`` only the best of each disc stack or coil wire."""
    by, found = _BY[sort or ("length" if demand.stiffness else "wear")], list[tuple[float, Table, int]]()
    for table in tables:
        small = np.broadcast_to(table.values[by], table.worst().shape)
        (rows,) = np.nonzero(table.worst() == 0)
        rows = rows[np.argsort(small[rows], kind="stable")]
        if families:
            discs_or_wires = (*_SIZES, "parallel") if isinstance(table.parts, DiscStack) else ("wire_diameter", "count")
            family = np.stack([getattr(table.parts, name)[rows] for name in discs_or_wires], axis=1)
            rows = rows[np.sort(np.unique(family, axis=0, return_index=True)[1])]
        found += [(float(small[row]), table, int(row)) for row in rows]
    return [(table, row) for _, table, row in sorted(found, key=lambda each: each[0])]


def stacks(demand: SpringDemand) -> Part:
    """Return disc stacks as columns: all sizes, all numbers of discs in parallel, useful numbers of packs in series.

    Useful numbers of packs are the smallest that the travel allows and those with nearly the wanted stiffness or, if
    no stiffness is wanted, the largest that fits.
    """
    listed = [disc for disc in demand.catalogue or discs() for _ in range(MOST_PARALLEL)]
    sizes: dict[str, Any] = {name: np.array([getattr(disc, name) for disc in listed], float) for name in _SIZES}
    made = sizes["reduced_thickness"]
    sizes["reduced_thickness"] = np.where(np.isnan(made), sizes["thickness"], made)
    sizes["parallel"] = np.arange(len(listed)) % MOST_PARALLEL + 1
    pack = DiscCharacteristic(DiscStack.model_construct(**sizes, series=1))
    deflection, (low, high) = pack.deflection(np.full(len(listed), demand.force)), pack.range
    needs = np.ones(len(listed))
    for travel, each in ((demand.relaxes, deflection - low), (demand.compresses, high - deflection)):
        needs = np.where(each > 0, np.maximum(needs, np.ceil(travel / each * (1 - _SLACK))), needs)
    most = np.full(len(listed), float(MOST_SERIES))
    if demand.room.length is not None:
        left = demand.room.length - demand.relaxes
        most = np.maximum(1, np.floor(left / (pack.free_length - deflection) * (1 + _SLACK)))
    numbers = [needs]
    if demand.stiffness is not None:
        wanted = pack.stiffness(deflection) / demand.stiffness
        numbers += [np.maximum(needs, np.minimum(most, near)) for near in (np.floor(wanted), np.ceil(wanted))]
    elif demand.room.length is not None:
        numbers.append(most)
    series = np.minimum(numbers, MOST_SERIES)
    rows = np.unique([(row, int(each)) for column in series for row, each in enumerate(column)], axis=0)
    sizes = {name: column[rows[:, 0]] for name, column in sizes.items()} | {"series": rows[:, 1]}
    return DiscStack.model_construct(**sizes)


def coils(demand: SpringDemand) -> Part:
    """Return coil springs as columns: one around the shaft or several on a circle, all wires, turns in quarters."""
    number, wire, coil = _coil_sizes(demand.room)
    if demand.stiffness is None:
        number, wire, coil = (np.repeat(column, len(_FREE_TURNS)) for column in (number, wire, coil))
        turns = np.resize(_FREE_TURNS, len(wire))
    else:
        wanted = number * law.coil_stiffness(SHEAR_MODULUS, wire, coil, 1.0) / demand.stiffness
        turns = np.rint(4 * wanted) / 4
    good = (turns >= TURNS[0]) & (turns <= TURNS[1])
    number, wire, coil, turns = (column[good] for column in (number, wire, coil, turns))
    rate = number * law.coil_stiffness(SHEAR_MODULUS, wire, coil, turns)
    # shortest free length, in tenths of a millimetre, that leaves gaps between the turns at the largest force
    shortest = law.coil_solid_length(wire, turns) + law.coil_least_gap(wire, coil, turns)
    free = np.ceil((shortest + demand.force / rate + demand.compresses) * 1e4) / 1e4
    sizes = {"wire_diameter": wire, "coil_diameter": coil, "turns": turns, "free_length": free, "count": number}
    return CoilSprings.model_construct(**sizes)


@cache
def _coil_sizes(room: Room) -> tuple[Any, Any, Any]:
    """Return number, wire diameter and mean diameter of the coil springs that fit between the diameters of a room."""
    rows = [
        (number, wire, coil) for number, wire in product(COUNTS, WIRES) for coil in coil_diameters(room, number, wire)
    ]
    number, wire, coil = np.array(rows).reshape(-1, 3).T
    return number.astype(int), wire, coil


def coil_diameters(room: Room, number: int, wire: float) -> list[float]:
    """Return the mean coil diameters that fit, m, in steps of whole millimetres."""
    inner, outer = room.inner_diameter or 0.0, room.outer_diameter
    low, high = INDEX[0] * wire, INDEX[1] * wire
    if number == 1:
        low = max(low, inner + wire)
        high = high if outer is None else min(high, outer - wire)
    elif outer is None or not inner:
        return []
    else:
        circle = (inner + outer) / 2
        high = min(high, (outer - inner) / 2 - wire, circle * math.sin(math.pi / number) - wire)
    step = max(1e-3, math.ceil((high - low) / _STEPS * 1e3) * 1e-3)
    first = math.ceil(round(low / 1e-3, 6))
    return [each * 1e-3 for each in range(first, math.floor(round(high / 1e-3, 6)) + 1, round(step / 1e-3))]


def option_of(demand: SpringDemand, part: Part, **called: Any) -> SpringOption:
    """Return a part as a ``SpringOption``, with its forces, lengths and stresses as set and in service.

    ``called``: its number, or the name of its spring.
    """
    spring, known = characteristic(part), values_of_part(demand, part)
    deflection, low, high = (known[name] for name in ("deflection", "deflection_least", "deflection_most"))
    force, stiffness = float(spring.force(deflection)), known["stiffness"]
    setting = float(spring.deflection((1 + SETTING) * force) - spring.deflection((1 - SETTING) * force))
    told: dict[str, Any] = dict.fromkeys(("parallel", "series", "count", "turns", "force_up", "force_down"))
    told |= {name: value for name, value in (vars(part) | known).items() if name in SpringOption.model_fields}
    told |= {"kind": "coil", "force": force, **called}
    if isinstance(part, DiscStack):
        told["kind"] = "disc"
        if demand.friction is not None:
            for name, sign in (("force_up", 1), ("force_down", -1)):
                shares = (sign * share for share in demand.friction)
                told[name] = float(law.stack_force_with_friction(force, part.parallel, *shares))
    elif demand.stroke is None:
        told |= {"loading": "static", "stress_correction": 1.0}
    else:
        correction = law.coil_correction(part.wire_diameter, part.coil_diameter)
        told |= {"loading": "dynamic", "stress_correction": correction}
    option = SpringOption(
        **told, part=label_of(part, demand.catalogue), force_least=None if low < 0 else float(spring.force(low)),
        force_largest=float(spring.force(high)), length_set=spring.free_length - deflection,
        used_low=low / spring.end, used_high=high / spring.end, loss_per_travel=stiffness / force,
        loss_per_wear=None if demand.follows is None else demand.follows * stiffness / force,
        utilisation=max(check.utilisation for check in checks_of_part(known) if check.rule.topic in _BORNE),
        travel_setting=setting, turns_setting=None if demand.pitch is None else setting / demand.pitch,
    )  # fmt: skip
    option._made = part
    return option


def label_of(part: Part, catalogue: tuple[Disc, ...] | None = None) -> str:
    """Return the name of a part; a disc spring has the name in its catalogue or its standard, if it is listed there."""
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


def picked(clutch: Clutch, result: SpringsResult, numbers: Sequence[int]) -> tuple[dict[str, Any], Spec]:
    """Return key → value of the spec for the picked springs (None removes a key), and the changed spec.

    Raises AfmcalcError if no option has a number, or if two numbers are options for the same spring.
    """
    changes: dict[str, Any] = {}
    blocks = {"closing_spring": result.closing, "control_spring": result.control or []}
    rooms = {f"{demand.name}_spring": demand.room for demand in bounded_demands(clutch)}
    numbered = {option.number: (block, option) for block, options in blocks.items() for option in options}
    for number in numbers:
        if number not in numbered:
            raise AfmcalcError("--pick {number}: there are {most} to pick from", number=number, most=len(numbered))
        block, option = numbered[number]
        if f"{block}.force" in changes:
            raise AfmcalcError("--pick {number}: {block} is picked already", number=number, block=block)
        part = option.made.model_dump(exclude_none=True)
        changes |= {f"{block}.force": option.force, f"{block}.stiffness": option.stiffness}
        changes |= {f"{block}.disc": None, f"{block}.coil": None, f"{block}.{option.kind}": part}
        if (option.count or 1) > 1:  # circle on which the springs stand
            across = {"inner_diameter", "outer_diameter"}
            given = rooms[block].model_dump(include=across)
            changes |= {f"{block}.room.{name}": value for name, value in given.items()}
    if "control_spring.force" in changes and clutch.spec.closing_spring.force is None:
        changes.setdefault("closing_spring.force", clutch.closing_force)
    return changes, respecified(clutch.spec, changes)


def _none(demand: SpringDemand, part: Part, missed: Mapping[str, float]) -> Finding:
    """Return the finding that no part fits, with the demands that the nearest part misses."""
    misses = ", ".join(
        say("{name} by {by:.1%}", name=translate(name), by=by)
        if by < 1
        else say("{name} by {by:.3g} times", name=translate(name), by=by)
        for name, by in sorted(missed.items(), key=lambda miss: -miss[1])
    )
    size = f"{part.parallel} × {part.series}" if isinstance(part, DiscStack) else f"{part.count} × {part.turns:g}"
    label, path = label_of(part, demand.catalogue), f"{demand.name}_spring"
    return finding("no-spring", "warning", value=demand.force, path=path, part=label, size=size, misses=misses)
