"""What springs that are known as parts are to bear: the one law of those searched for and of those a spec names."""

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from ..equations import springs as law
from ..findings import Finding, Level, finding
from ..messages import term
from ..spec.models import ROUNDED, SHEAR_MODULUS, CoilSprings, DiscStack, Spec
from .quantities import Apply, call
from .springs import (
    LEAST_USED,
    MODULUS,
    MOST_USED,
    Characteristic,
    CoilCharacteristic,
    DiscCharacteristic,
    SpringDemand,
    characteristic,
)

INDEX = (4.0, 20.0)
"""Mean coil diameter over wire diameter (EN 13906-1)."""
SOLID_SHARE = 0.56
"""Shear stress, pressed solid, over tensile strength: what cold coiled springs bear (EN 13906-1)."""
OM_STRENGTH = 1600e6
"""Pressure that the section of a disc bears where it turns (Machinery's Handbook, 31st ed.), Pa."""
ZIMMERLI = (241e6, 379e6)
"""Amplitude and mean of the shear stress that wire, not shot peened, bears for ever (Shigley, sec. 10-9), Pa."""
SHEAR_SHARE = 0.67
"""Shear strength of wire over its tensile strength (Shigley, sec. 10-9)."""
WIRE = (0.3e-3, 20e-3)
"""Diameters of EN 10270-1, m."""
SEATING = 0.5
"""ν of a spring between parallel plates (EN 13906-1)."""
_ROUNDING = 1e-9


class PartRule(NamedTuple):
    """One thing that a part is to hold."""

    misses: str
    """What it misses where it does not."""
    code: str
    """Code of the finding that says so."""
    level: Level
    what: str
    symbol: str
    unit: str
    least: bool = False
    """Whether the value must reach the limit, instead of keeping below it."""


FORCE = PartRule("force", "spring-too-weak", "error", "force of the spring", "F ≤ F_c", "N")
SLACK = PartRule("preload", "spring-slack", "error", "travel by which the spring is let go", "Δs ≤ s", "m")
_OF_DISC, _OF_COIL = "deflection of disc springs", "deflection of coil springs"
LEAST = PartRule("preload", "spring-beyond-range", "warning", _OF_DISC, "s ≥ s_min", "m", least=True)
MOST = PartRule("deflection", "spring-beyond-range", "warning", _OF_DISC, "s ≤ s_max", "m")
TURNED = PartRule("stress", "disc-overstressed", "error", "stress where a disc turns", "|σ_OM| ≤ [σ]", "Pa")
SLENDER = PartRule("index", "coil-index", "warning", "index of a coil", "w ≤ 20", "1")
TIGHT = PartRule("index", "coil-index", "warning", "index of a coil", "w ≥ 4", "1", least=True)
SOLID = PartRule("deflection", "coil-solid", "error", _OF_COIL, "s ≤ s_c", "m")
GAPS = PartRule("deflection", "coil-gaps-closed", "warning", _OF_COIL, "s ≤ s_n", "m")
BUCKLING = PartRule("buckling", "coil-buckles", "warning", "deflection of coil springs without guide", "s ≤ s_K", "m")
STRESS = PartRule("stress", "coil-overstressed", "error", "shear stress of a wire in service", "τ_2 ≤ [τ]", "Pa")
STRESS_SOLID = PartRule("stress", "coil-stress-solid", "warning", "shear stress of a wire, solid", "τ_c ≤ [τ]", "Pa")
_MOVING = "shear stress, with k_τ, of a wire that moves at every trip"
FATIGUE = PartRule("fatigue", "coil-fatigue", "warning", _MOVING, "τ_k2 ≤ τ_kO", "Pa")
LENGTH = PartRule("length", "spring-does-not-fit", "error", "length of the spring", "L ≤ [L]", "m")
_OUTER = "outer diameter of the spring"
OUTER = PartRule("outer diameter", "spring-does-not-fit", "error", _OUTER, "D_e ≤ D_2", "m")
INNER = PartRule(
    "inner diameter", "spring-does-not-fit", "error", "inner diameter of the spring", "D_i ≥ D_1", "m", least=True
)
RING = PartRule("outer diameter", "spring-does-not-fit", "error", _OUTER, "D_e ≤ (D_2 − D_1)/2", "m")
PITCH = PartRule("outer diameter", "spring-does-not-fit", "error", _OUTER, "D_e ≤ t_п", "m")


class PartCheck(NamedTuple):
    """A rule, and the numbers of one part."""

    rule: PartRule
    value: float
    limit: float
    scale: float = 0.0
    """What a miss is told by; 0: the limit."""

    @property
    def utilisation(self) -> float:
        """1 at the limit; of what must reach it, infinite where there is nothing."""
        if self.rule.least:
            return self.limit / self.value if self.value > 0 else math.inf
        return self.value / self.limit

    @property
    def beyond(self) -> float:
        """By how much it is missed, relative; not positive: it is held."""
        over = self.limit - self.value if self.rule.least else self.value - self.limit
        return over / (self.scale or self.limit)


def checks_of_part(demand: SpringDemand, part: DiscStack | CoilSprings, apply: Apply = call) -> list[PartCheck]:
    """What a part is to hold as a spring of a clutch, held or not."""
    own = characteristic(part, apply)
    held, deflection = float(own.force(own.end)), float(own.deflection(demand.force))
    found = [PartCheck(FORCE, demand.force, held)]
    least, most = deflection - demand.relaxes, deflection + demand.compresses
    if demand.relaxes:
        found.append(PartCheck(SLACK, demand.relaxes, deflection, own.end))
    found += _of_discs(own, least, most) if isinstance(own, DiscCharacteristic) else _of_coils(own, demand, most)
    return [*found, *_of_room(own, demand, own.free_length - least)]


def _of_discs(own: DiscCharacteristic, least: float, most: float) -> Iterator[PartCheck]:
    low, high = own.range
    yield PartCheck(LEAST, least, low, own.end)
    yield PartCheck(MOST, most, high, own.end)
    yield PartCheck(TURNED, abs(own.stresses(most)[0]), OM_STRENGTH)


def _of_coils(own: CoilCharacteristic, demand: SpringDemand, most: float) -> Iterator[PartCheck]:
    part = own.part
    index = part.coil_diameter / part.wire_diameter
    yield PartCheck(TIGHT, index, INDEX[0])
    yield PartCheck(SLENDER, index, INDEX[1])
    yield PartCheck(SOLID, most, own.end)
    yield PartCheck(GAPS, most, own.range[1], own.end)
    yield from _buckling(own, demand, most)
    tensile = strength(part.wire_diameter)
    if tensile is None:
        return
    limit = SOLID_SHARE * tensile
    yield PartCheck(STRESS, own.stress(most), limit)
    yield PartCheck(STRESS_SOLID, own.stress(own.end), limit)
    if demand.stroke is not None:
        lower, upper = (own.correction * own.stress(at) for at in (most - demand.stroke, most))
        ultimate = SHEAR_SHARE * tensile
        endurance = own.apply(law.coil_endurance, *ZIMMERLI, ultimate)
        limit = float(own.apply(law.coil_upper_stress, lower, endurance, ultimate))
        yield PartCheck(FATIGUE if demand.cycles is None else FATIGUE._replace(level="error"), upper, limit)


def _buckling(own: CoilCharacteristic, demand: SpringDemand, most: float) -> Iterator[PartCheck]:
    """A spring is guided by a shaft in it, or a bore around it, that is within a wire's thickness."""
    part, room, ratio = own.part, demand.room, SHEAR_MODULUS / MODULUS
    if part.count == 1:
        shaft, bore = room.inner_diameter or 0.0, room.outer_diameter or math.inf
        if min(part.coil_diameter - shaft, bore - part.coil_diameter) <= 2 * part.wire_diameter * (1 + _ROUNDING):
            return
    root = float(own.apply(law.coil_buckling_root, part.coil_diameter, part.free_length, ratio, SEATING, math.pi))
    if root >= 0:
        yield PartCheck(BUCKLING, most, float(own.apply(law.coil_buckling_deflection, part.free_length, ratio, root)))


def _of_room(own: Characteristic, demand: SpringDemand, length: float) -> Iterator[PartCheck]:
    """What there is room for along the shaft, around it and, of several coils, side by side."""
    part, room = own.part, demand.room
    inner, outer = room.inner_diameter or 0.0, room.outer_diameter
    if room.length is not None:
        yield PartCheck(LENGTH, length, room.length)
    if isinstance(part, DiscStack):
        across, within = part.outer_diameter, part.inner_diameter
    else:
        across, within = part.coil_diameter + part.wire_diameter, part.coil_diameter - part.wire_diameter
    if isinstance(part, CoilSprings) and part.count > 1:
        if outer is not None and inner:
            yield PartCheck(RING, across, (outer - inner) / 2)
            yield PartCheck(PITCH, across, (inner + outer) / 2 * math.sin(math.pi / part.count))
        return
    if outer is not None:
        yield PartCheck(OUTER, across, outer)
    if inner:
        yield PartCheck(INNER, within, inner)


def strength(wire: float) -> float | None:
    """Tensile strength of patented drawn wire SM or DM, 1980 − 740 lg d, Pa; None of no such wire (EN 10270-1)."""
    low, high = WIRE
    if not low * (1 - _ROUNDING) <= wire <= high * (1 + _ROUNDING):
        return None
    return (1980 - 740 * math.log10(wire * 1e3)) * 1e6


def checks_of_spec(spec: Spec, demands: Iterable[SpringDemand], apply: Apply = call) -> Iterator[tuple[str, PartCheck]]:
    """What the springs that a spec names are to hold, each with the path of its part."""
    for demand in demands:
        if (part := spec.spring_parts.get(demand.name)) is not None:
            path = f"{demand.name}_spring.{'disc' if isinstance(part, DiscStack) else 'coil'}"
            yield from ((path, each) for each in checks_of_part(demand, part, apply))


def part_findings(spec: Spec, demands: Sequence[SpringDemand]) -> list[Finding]:
    """Springs that cannot give their force, do not fit, bear too much, or are used as they should not be."""
    missed = [(path, each) for path, each in checks_of_spec(spec, demands) if each.beyond > _ROUNDING]
    weak = {path for path, each in missed if each.rule is FORCE}
    found = [_finding(path, each) for path, each in missed if path not in weak or each.rule is FORCE]
    found += (each for demand in demands for each in _remarks(demand, spec.spring_parts.get(demand.name)))
    return list({(each.code, each.path): each for each in found}.values())


def _finding(path: str, missed: PartCheck) -> Finding:
    rule, value, limit = missed.rule, missed.value, missed.limit
    if rule is FORCE:
        value, limit = limit, value
    elif rule in (LEAST, MOST):
        share = LEAST_USED if rule.least else MOST_USED
        value, limit = value / limit * share, share
    return finding(rule.code, rule.level, value=value, limit=limit, path=path, what=term(rule.what))


def _remarks(demand: SpringDemand, part: DiscStack | CoilSprings | None) -> Iterator[Finding]:
    """A wire whose strength is not known, and a stiffness beside discs, whose curve the law takes."""
    if isinstance(part, CoilSprings):
        if strength(part.wire_diameter) is None:
            path = f"{demand.name}_spring.coil.wire_diameter"
            yield finding("wire-not-judged", "warning", value=part.wire_diameter, path=path)
    elif part is not None and demand.stiffness is not None:
        own = DiscCharacteristic(part)
        slope = float(own.stiffness(own.deflection(demand.force)))
        if abs(demand.stiffness / slope - 1) > ROUNDED:
            path = f"{demand.name}_spring.stiffness"
            yield finding("stiffness-of-the-discs", "warning", value=demand.stiffness, limit=slope, path=path)
