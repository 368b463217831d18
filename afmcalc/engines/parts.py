"""Demands on a spring, and the checks of a spring part that meets them; for one part, or for many parts as arrays."""

import math
from collections.abc import Iterator
from typing import Any, Literal, NamedTuple

from ..equations import springs as law
from ..equations.arrays import Values, chosen, is_array, logarithm, sin, smaller
from ..equations.effects import force_lost_by_wear
from ..findings import Finding, finding
from ..messages import translate
from ..spec.catalogues import Disc
from ..spec.models import ROUNDED, SHEAR_MODULUS, CoilSprings, DiscStack, Room
from .characteristics import (
    LEAST_USED,
    MODULUS,
    MOST_USED,
    CoilCharacteristic,
    DiscCharacteristic,
    SetSpring,
    characteristic,
)
from .checks import ROUNDING, Check, check_of
from .quantities import Apply, call
from .rings import rooms_of
from .selection import Clutch

QUASI_STATIC = 1e4
"""Number of strokes up to which a spring counts as statically loaded (EN 13906-1)."""
INDEX = (4.0, 20.0)
"""Smallest and largest spring index, mean coil diameter over wire diameter (EN 13906-1)."""
SOLID_SHARE = 0.56
"""Ratio of allowable shear stress of a solid, cold coiled spring to tensile strength (EN 13906-1)."""
OM_STRENGTH = 1600e6
"""Allowable compressive stress at a disc spring's centre of rotation OM (Machinery's Handbook, 31st ed.), Pa."""
ZIMMERLI = (241e6, 379e6)
"""Amplitude and mean of the shear stress at the endurance limit, wire not shot peened (Shigley, sec. 10-9), Pa."""
SHEAR_SHARE = 0.67
"""Ratio of shear strength of wire to its tensile strength (Shigley, sec. 10-9)."""
WIRE = (0.3e-3, 20e-3)
"""Smallest and largest wire diameter of EN 10270-1, m."""
SEATING = 0.5
"""Seating coefficient ν of a spring between parallel plates (EN 13906-1)."""

SpringName = Literal["closing", "control"]


class SpringDemand(NamedTuple):
    """Required force and stiffness of one spring of a clutch, its room and its service."""

    name: SpringName
    force: float
    """Force as set, N."""
    stiffness: float | None
    """Required stiffness, N/m; None: any stiffness will do."""
    relaxes: float
    """Extension in service, m."""
    room: Room
    pitch: float | None
    """Thread pitch of the nut, m."""
    friction: tuple[float, float] | None
    """Friction factors of a stack of disc springs, w_M between the cones and w_R at the edges."""
    compresses: float = 0.0
    """Compression in service, m."""
    follows: int | None = None
    """Number of friction pairs whose wear extends the spring; None if wear does not extend it."""
    stroke: float | None = None
    """Stroke at every trip, m; None: static or quasi-static load (EN 13906-1)."""
    cycles: float | None = None
    """Required number of trips; None: not stated."""
    catalogue: tuple[Disc, ...] | None = None
    """Disc springs to choose from; None: the list that ships with the program."""


def spring_demands(clutch: Clutch, travel: float = 0.0) -> list[SpringDemand]:
    """Return the demand on each spring of a clutch, for the travel by the torque law or, if larger, for ``travel``.

    The closing spring of a direct clutch extends as the pack wears and does not move otherwise. In an indirect clutch
    the travel of the sleeve extends the closing spring and compresses the control spring at every trip; wear extends
    the control spring.
    """
    spec, pairs = clutch.spec, clutch.spec.friction_group.pairs
    rooms = {} if spec.envelope is None else rooms_of(clutch)
    worn = pairs * ((spec.heat and spec.heat.lining) or 0.0)

    def demand(name: SpringName, relaxes: float, **service: Any) -> SpringDemand:
        spring: Any = getattr(spec, f"{name}_spring")
        left = rooms.get(name, Room())
        if left.length is not None:
            left = left.model_copy(update={"length": left.length + relaxes})
        given = {} if spring.room is None else spring.room.model_dump(exclude_none=True)
        surface, edge = spring.surface_friction, spring.edge_friction
        return SpringDemand(
            name=name, force=float(clutch[f"{name}_force"]), stiffness=spring.stiffness or None, relaxes=relaxes,
            room=left.model_copy(update=given), pitch=spring.thread_pitch,
            friction=None if surface is None or edge is None else (surface, edge), catalogue=spec.lists.discs,
            **service,
        )  # fmt: skip

    if not spec.kind.travels:
        return [demand("closing", worn, follows=pairs)]
    travel = max(travel, float(clutch["travel_max"]))
    cycles = spec.requirements.cycles if spec.requirements is not None else None
    moves: dict[str, Any] = {"stroke": travel if cycles is None or cycles > QUASI_STATIC else None, "cycles": cycles}
    return [demand("closing", travel, **moves), demand("control", worn, compresses=travel, follows=pairs, **moves)]


_TABLE = """\
spring-too-weak | force of the spring | F ≤ F_c | N | force ≤ force_at_end | error | | springs | force |
spring-slack | travel by which the spring is let go | Δs ≤ s | m | relaxes ≤ deflection | error | | springs | preload |
spring-beyond-range | deflection of disc springs | s ≥ s_min | m | deflection_least ≥ cone_least | warning | | springs | preload |
spring-beyond-range | deflection of disc springs | s ≤ s_max | m | deflection_most ≤ cone_most | warning | | springs | deflection |
disc-overstressed | stress where a disc turns | |σ_OM| ≤ [σ] | Pa | pressure_turning ≤ om_strength | error | | springs | stress |
coil-index | index of a coil | w ≥ 4 | 1 | index ≥ index_least | warning | | springs | index |
coil-index | index of a coil | w ≤ 20 | 1 | index ≤ index_most | warning | | springs | index |
coil-solid | deflection of coil springs | s ≤ s_c | m | deflection_most ≤ deflection_solid | error | | springs | deflection |
coil-gaps-closed | deflection of coil springs | s ≤ s_n | m | deflection_most ≤ deflection_of_gaps | warning | | springs | deflection |
coil-buckles | deflection of coil springs without guide | s ≤ s_K | m | deflection_most ≤ deflection_buckling | warning | | springs | buckling |
coil-overstressed | shear stress of a wire in service | τ_2 ≤ [τ] | Pa | stress_static ≤ wire_strength | error | | springs | stress |
coil-stress-solid | shear stress of a wire, solid | τ_c ≤ [τ] | Pa | stress_solid ≤ wire_strength | warning | | springs | stress |
coil-fatigue | shear stress, with k_τ, of a wire that moves at every trip | τ_k2 ≤ τ_kO | Pa | stress ≤ endurance | warning | | springs | fatigue |
coil-fatigue | shear stress, with k_τ, of a wire that moves at every trip | τ_k2 ≤ τ_kO | Pa | stress ≤ endurance_required | error | | springs | fatigue |
spring-does-not-fit | length of the spring | L ≤ [L] | m | length ≤ room_length | error | | springs | length |
spring-does-not-fit | deflection of the spring as set | s ≤ [L] | m | deflection ≤ room_length | error | | springs | length |
spring-does-not-fit | outer diameter of the spring | D_e ≤ (D_2 − D_1)/2 | m | outer_diameter ≤ room_ring | error | | springs | outer diameter |
spring-does-not-fit | outer diameter of the spring | D_e ≤ t_п | m | outer_diameter ≤ room_pitch | error | | springs | outer diameter |
spring-does-not-fit | outer diameter of the spring | D_e ≤ D_2 | m | outer_diameter ≤ room_outer | error | | springs | outer diameter |
spring-does-not-fit | inner diameter of the spring | D_i ≥ D_1 | m | inner_diameter ≥ room_inner | error | | springs | inner diameter |
"""  # noqa: E501
"""Rows for ``check_of``; the topic of a check is the property of the spring part that it limits."""

RULES = tuple(map(check_of, _TABLE.splitlines()))
"""Checks of a spring part."""


class PartCheck(NamedTuple):
    """A check with value and limit of one spring part, or with arrays of values and limits for many parts."""

    rule: Check
    value: Any
    limit: Any
    scale: Any
    """Value to which the excess over the limit is related."""

    @property
    def utilisation(self) -> float:
        """Value over upper limit, or lower limit over value (infinite for a value of 0): 1 at the limit."""
        return self.rule.utilisation(self.value, self.limit)

    @property
    def beyond(self) -> Any:
        """Relative excess over the limit; ≤ 0 if the check passes."""
        over = self.limit - self.value if self.rule.least else self.value - self.limit
        return over / self.scale


def checks_of_part(known: dict[str, Any]) -> list[PartCheck]:
    """Return the checks of a spring part, passed or failed, except checks whose value or limit is None or a NaN."""
    return [
        PartCheck(
            rule, known[rule.value], known[rule.limit],
            known["deflection_end" if rule.topic in ("preload", "deflection") else rule.limit],
        )
        for rule in RULES
        if isinstance(rule.limit, str) and _asked(known.get(rule.value)) and _asked(known.get(rule.limit))
    ]  # fmt: skip


def _asked(value: Any) -> bool:
    return value is not None and (is_array(value) or value == value)


def values_of_part(demand: SpringDemand, part: DiscStack | CoilSprings, apply: Apply = call) -> dict[str, Any]:
    """Return values and limits of a spring part as set and in service; a value that does not exist is NaN or None.

    ``part`` may have arrays in place of numbers, with an element for each of many parts.
    """
    own = characteristic(part, apply)
    deflection = own.deflection(demand.force)
    least, most = deflection - demand.relaxes, deflection + demand.compresses
    known = {
        "force": demand.force, "force_at_end": own.force(own.end), "relaxes": demand.relaxes or None,
        "deflection": deflection, "deflection_least": least, "deflection_most": most, "deflection_end": own.end,
        "stiffness": own.stiffness(deflection), "free_length": own.free_length, "length": own.free_length - least,
        "mass": own.mass,
    }  # fmt: skip
    of_kind = _of_discs(own, most) if isinstance(own, DiscCharacteristic) else _of_coils(own, demand, most)
    known |= of_kind
    return known | _of_room(demand.room, getattr(part, "count", 1), known["outer_diameter"])


def _of_discs(own: DiscCharacteristic, most: Values) -> dict[str, Any]:
    (low, high), (middle, edge) = own.range, own.stresses(most)
    return {
        "cone_least": low, "cone_most": high, "stress": edge, "stress_middle": middle, "pressure_turning": abs(middle),
        "om_strength": OM_STRENGTH, "outer_diameter": own.part.outer_diameter,
        "inner_diameter": own.part.inner_diameter,
    }  # fmt: skip


def _of_coils(own: CoilCharacteristic, demand: SpringDemand, most: Values) -> dict[str, Any]:
    part, room, ratio = own.part, demand.room, SHEAR_MODULUS / MODULUS
    wire, coil, tensile = part.wire_diameter, part.coil_diameter, strength(part.wire_diameter)
    # a shaft inside or a bore around the spring guides it if the play is at most a wire diameter
    play = smaller(coil - (room.inner_diameter or 0.0), (room.outer_diameter or math.inf) - coil)
    root = own.apply(law.coil_buckling_root, coil, part.free_length, ratio, SEATING, math.pi)
    buckles = (root >= 0) & ((part.count != 1) | (play > 2 * wire * (1 + ROUNDING)))
    known = {
        "index": coil / wire,
        "index_least": INDEX[0],
        "index_most": INDEX[1],
        "deflection_solid": own.end,
        "deflection_of_gaps": own.range[1],
        "deflection_buckling": chosen(
            buckles, lambda: own.apply(law.coil_buckling_deflection, part.free_length, ratio, root), lambda: math.nan
        ),
        "stress": own.stress(most),
        "stress_static": own.stress(most),
        "stress_solid": own.stress(own.end),
        "wire_strength": SOLID_SHARE * tensile,
        "outer_diameter": coil + wire,
        "inner_diameter": coil - wire,
    }
    if demand.stroke is None:
        return known
    lower, upper = (own.correction * own.stress(at) for at in (most - demand.stroke, most))
    ultimate = SHEAR_SHARE * tensile
    endurance = own.apply(law.coil_endurance, *ZIMMERLI, ultimate)
    name = "endurance" if demand.cycles is None else "endurance_required"
    return known | {"stress": upper, name: own.apply(law.coil_upper_stress, lower, endurance, ultimate)}


def _of_room(room: Room, count: Any, outer_diameter: Any) -> dict[str, Any]:
    """Return the limits that the room sets to a spring, or to each of several coil springs: length and diameters."""
    inner, outer = room.inner_diameter or math.nan, math.nan if room.outer_diameter is None else room.outer_diameter
    alone = (count == 1) & (outer_diameter > 0)
    return {
        "room_length": room.length,
        "room_ring": chosen(alone, lambda: math.nan, lambda: (outer - inner) / 2),
        "room_pitch": chosen(alone, lambda: math.nan, lambda: (inner + outer) / 2 * sin(math.pi / count)),
        "room_outer": chosen(alone, lambda: outer, lambda: math.nan),
        "room_inner": chosen(alone, lambda: inner, lambda: math.nan),
    }


def strength(wire: Values) -> Values:
    """Tensile strength of patented drawn wire SM or DM, 1980 − 740 lg d, Pa; NaN outside ``WIRE`` (EN 10270-1)."""
    there = (wire >= WIRE[0] * (1 - ROUNDING)) & (wire <= WIRE[1] * (1 + ROUNDING))
    return chosen(there, lambda: (1980 - 740 / math.log(10) * logarithm(wire * 1e3)) * 1e6, lambda: math.nan)


def checks_of_springs(clutch: Clutch, travel: float = 0.0, apply: Apply = call) -> Iterator[tuple[str, PartCheck]]:
    """Yield the checks of the spring parts in a spec, each with the path of its part."""
    parts = clutch.spec.spring_parts
    for demand in spring_demands(clutch, travel) if parts else ():
        if (part := parts.get(demand.name)) is not None:
            path = f"{demand.name}_spring.{'disc' if isinstance(part, DiscStack) else 'coil'}"
            yield from ((path, each) for each in checks_of_part(values_of_part(demand, part, apply)))


def part_findings(clutch: Clutch) -> list[Finding]:
    """Findings on the spring parts of a clutch: too weak, too large, overstressed, or used outside their range."""
    missed = [(path, each) for path, each in checks_of_springs(clutch) if each.beyond > ROUNDING]
    weak, found = {path for path, each in missed if each.rule.topic == "force"}, list[Finding]()
    for path, each in missed:
        rule, value, limit, _ = each
        if rule.topic == "force":
            value, limit = limit, value
        elif path in weak:
            continue
        elif rule.code == "spring-beyond-range":
            share = LEAST_USED if rule.least else MOST_USED
            value, limit = value / limit * share, share
        found.append(finding(rule.code, rule.level, value=value, limit=limit, path=path, what=translate(rule.name)))
    found += (each for demand in spring_demands(clutch) for each in _remarks(clutch, demand))
    return list({(each.code, each.path): each for each in found}.values())


def _remarks(clutch: Clutch, demand: SpringDemand) -> Iterator[Finding]:
    """Yield warnings of a wire of unknown strength, and of a given stiffness that the disc springs do not have."""
    part = clutch.spec.spring_parts.get(demand.name)
    if isinstance(part, CoilSprings):
        if math.isnan(strength(part.wire_diameter)):
            path = f"{demand.name}_spring.coil.wire_diameter"
            yield finding("wire-not-judged", "warning", value=part.wire_diameter, path=path)
    elif part is not None and demand.stiffness is not None:
        own = DiscCharacteristic(part)
        slope = float(own.stiffness(own.deflection(demand.force)))
        if abs(demand.stiffness / slope - 1) > ROUNDED:
            path = f"{demand.name}_spring.stiffness"
            yield finding("stiffness-of-the-discs", "warning", value=demand.stiffness, limit=slope, path=path)


def following_spring(clutch: Clutch) -> SetSpring:
    """Return the spring that extends as the pack wears: the closing or, in an indirect clutch, the control spring."""
    travels, coil = clutch.spec.kind.travels, clutch.spec.closing_spring.coil
    name = "control" if travels else "closing"
    stiffness = clutch.get(f"{name}_stiffness", None if travels or coil is None else coil.rate)
    disc = clutch.given.get(f"{name}_disc")
    noted = disc and DiscCharacteristic(disc.part, clutch.apply)
    return SetSpring(clutch["pack_force_at_rest"], stiffness, noted)


def following_stiffness(clutch: Clutch) -> Any:
    """Return the stiffness of the spring that extends as the pack wears, N/m; None if the spec does not give it."""
    spring = following_spring(clutch)
    return spring.straight_stiffness if spring.disc is None else spring.stiffness(0.0)


def lost_by_wear(clutch: Clutch, wear: Any) -> Any:
    """Return the force that the pack loses when every pair wears by ``wear``, N; needs ``following_stiffness``."""
    spring, pairs = following_spring(clutch), clutch.spec.friction_group.pairs
    if spring.disc is None:
        return clutch.apply(force_lost_by_wear, spring.straight_stiffness, pairs, wear)
    return spring.set_force - spring.force(-smaller(pairs * wear, spring.deflection))
