"""Springs of a clutch: the force of a part over its deflection, and a spring as it is set; numbers or arrays."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, TypeAlias

from ..equations import springs as law
from ..equations.arrays import Values, chosen, greatest, larger, logarithm, smaller
from ..spec.models import SHEAR_MODULUS, CoilSprings, DiscStack
from .quantities import Apply, call

MODULUS = 206e9
"""Young's modulus of disc springs (DIN EN 16984), Pa."""
POISSON = 0.3
STEEL = 7850.0
"""Density, kg/m³."""
LEAST_USED, MOST_USED = 0.15, 0.75
"""Shares of the cone height that a disc spring is used in (DIN EN 16984)."""
_STEPS = 60
_CLOSE = 1e-13
"""Relative to the whole deflection."""


def root(
    rising: Callable[[Values], Values], slope: Callable[[Values], Values], end: Values, start: Values = 0.0
) -> Values:
    """Where a function that rises from ``start`` to ``end`` is 0, number by number; the nearer end where it is not.

    Newton's steps, and halves of what is left where one would leave it: arrays as fast as numbers, of which SciPy's
    bracketed searches take one at a time.
    """
    at = low = chosen(rising(end) < 0, lambda: end, lambda: start + 0.0 * end)
    high = end
    for _ in range(_STEPS):
        value = rising(at)
        below = value < 0
        low, high = chosen(below, lambda: at, lambda: low), chosen(below, lambda: high, lambda: at)  # noqa: B023
        step = at - value / slope(at)
        there = chosen((step >= low) & (step <= high), lambda: step, lambda: (low + high) / 2)  # noqa: B023
        moved, at = greatest(larger(there - at, at - there)), there
        if not moved > _CLOSE * greatest(end):
            break
    return at


@dataclass(frozen=True)
class DiscCharacteristic:
    """A stack of disc springs, without the friction between them; deflections are of the whole, m."""

    part: DiscStack
    apply: Apply = field(default=call, compare=False)

    @property
    def ratio(self) -> float:
        """δ."""
        return self.part.outer_diameter / self.part.inner_diameter

    @property
    def thickness(self) -> float:
        """Thickness as made: t, with flats t', m."""
        own = self.part
        return own.thickness if own.reduced_thickness is None else own.reduced_thickness

    @property
    def factors(self) -> tuple[float, float]:
        """K_1 and K_4."""
        load = self.apply(law.disc_factor_load, self.ratio, logarithm(self.ratio), math.pi)
        reduced = self.part.reduced_thickness
        if reduced is None:
            return load, 1.0
        sizes = self.part.thickness, reduced, self.part.free_height
        first = self.apply(law.disc_flats_first, *sizes)
        return load, self.apply(law.disc_factor_flats, first, self.apply(law.disc_flats_second, first, *sizes))

    @property
    def free_length(self) -> float:
        """L_0 of the stack, m."""
        return self.apply(law.stack_length, self.part.parallel, self.part.series, self.part.free_height, self.thickness)

    @property
    def mass(self) -> float:
        """Of all discs, kg."""
        own = self.part
        disc = self.apply(law.ring_mass, STEEL, own.outer_diameter, own.inner_diameter, self.thickness, math.pi)
        return own.parallel * own.series * disc

    @property
    def cone_height(self) -> float:
        """l_0 − t of the disc without flats, m."""
        return self.part.free_height - self.part.thickness

    @property
    def range(self) -> tuple[float, float]:
        """Deflections it may be used between, by its cone height, m."""
        whole = self.part.series * self.cone_height
        return LEAST_USED * whole, MOST_USED * whole

    @property
    def end(self) -> float:
        """Deflection at which all discs are flat, m."""
        return self.part.series * (self.part.free_height - self.thickness)

    @cached_property
    def shape(self) -> tuple[float, float, float, float, float, float, float]:
        """E, ν, K_1, K_4, D_e, t and h_0 of a disc, with flats t' and l_0 − t'."""
        height = self.part.free_height - self.thickness
        return (MODULUS, POISSON, *self.factors, self.part.outer_diameter, self.thickness, height)

    def force(self, deflection: Values) -> Values:
        """Force of the stack, N."""
        each = deflection / self.part.series
        return self.part.parallel * self.apply(law.disc_force, *self.shape, each)

    def stiffness(self, deflection: Values) -> Values:
        """Slope of the force, N/m."""
        own = self.part
        return own.parallel / own.series * self.apply(law.disc_stiffness, *self.shape, deflection / own.series)

    def deflection(self, force: Values) -> Values:
        """Deflection that gives a force, m; all discs flat where none does."""
        plain = DiscCharacteristic(self.part)
        return root(lambda at: plain.force(at) - force, plain.stiffness, self.end + 0.0 * force)

    def stresses(self, deflection: Values) -> tuple[Values, Values]:
        """Stress where the section turns (OM), and the largest tension at the edges II and III, Pa."""
        ratio, each = self.ratio, deflection / self.part.series
        membrane = self.apply(law.disc_factor_membrane, ratio, logarithm(ratio), math.pi)
        bending = self.apply(law.disc_factor_bending, ratio, logarithm(ratio), math.pi)
        middle = self.apply(law.disc_stress, *self.shape, each, 0.0, 3 / math.pi)
        edges = (membrane, -bending), ((membrane - 2 * bending) / ratio, -bending / ratio)
        return middle, larger(*(self.apply(law.disc_stress, *self.shape, each, *edge) for edge in edges))


@dataclass(frozen=True)
class CoilCharacteristic:
    """Coil springs side by side; forces are those of all together, N."""

    part: CoilSprings
    apply: Apply = field(default=call, compare=False)

    @property
    def free_length(self) -> float:
        """L_0, m."""
        return self.part.free_length

    @property
    def mass(self) -> float:
        """Of all together, kg."""
        own = self.part
        return own.count * self.apply(law.coil_mass, STEEL, own.wire_diameter, own.coil_diameter, own.turns, math.pi)

    @property
    def rate(self) -> float:
        """Stiffness of all together, N/m."""
        own = self.part
        return own.count * self.apply(
            law.coil_stiffness, SHEAR_MODULUS, own.wire_diameter, own.coil_diameter, own.turns
        )

    @property
    def range(self) -> tuple[float, float]:
        """From nothing to where the gaps between the turns are the least that must stay, m."""
        own = self.part
        return 0.0, self.end - self.apply(law.coil_least_gap, own.wire_diameter, own.coil_diameter, own.turns)

    @property
    def end(self) -> float:
        """Deflection at which it is pressed solid, m."""
        return self.part.free_length - self.apply(law.coil_solid_length, self.part.wire_diameter, self.part.turns)

    def force(self, deflection: Values) -> Values:
        """Force, N."""
        return self.rate * deflection

    def stiffness(self, deflection: Values) -> Values:
        """Stiffness at every deflection, N/m."""
        return self.rate + 0.0 * deflection

    def deflection(self, force: Values) -> Values:
        """Deflection that gives a force, m; pressed solid where none does."""
        return smaller(force / self.rate, self.end)

    @property
    def correction(self) -> float:
        """k_τ, by which a curved wire bears more at its inside: it counts where the spring moves."""
        return self.apply(law.coil_correction, self.part.wire_diameter, self.part.coil_diameter)

    def stress(self, deflection: Values) -> Values:
        """Shear stress of the wire, without the correction for the curve as for a spring that rests, Pa."""
        each = self.rate * deflection / self.part.count
        return self.apply(law.coil_stress, each, self.part.wire_diameter, self.part.coil_diameter, 1.0, math.pi)


Characteristic: TypeAlias = DiscCharacteristic | CoilCharacteristic


def characteristic(part: DiscStack | CoilSprings, apply: Apply = call) -> Characteristic:
    """Return the characteristic of a part."""
    return DiscCharacteristic(part, apply) if isinstance(part, DiscStack) else CoilCharacteristic(part, apply)


@dataclass(frozen=True)
class SetSpring:
    """A spring as it is set; without a disc it is straight."""

    set_force: Values
    """N."""
    straight_stiffness: Any
    """N/m; None where only its force is known."""
    disc: DiscCharacteristic | None = None

    @cached_property
    def deflection(self) -> Values:
        """Deflection as set, m."""
        if self.disc is None:
            return self.set_force / self.straight_stiffness
        return self.disc.deflection(self.set_force)

    def force(self, further: Values) -> Values:
        """Force when pressed together so much further than as set, N."""
        if self.disc is None:
            return self.set_force + self.straight_stiffness * further
        return self.disc.force(self.deflection + further)

    def stiffness(self, further: Values) -> Values:
        """Slope of the force there, N/m."""
        return self.straight_stiffness if self.disc is None else self.disc.stiffness(self.deflection + further)

    def secant(self, further: Values) -> Values:
        """Change of the force per deflection from as set, N/m."""
        return self.straight_stiffness if self.disc is None else (self.force(further) - self.set_force) / further

    def slackens(self, force: Values) -> Values:
        """Extension until so much force is left, m."""
        if self.disc is None:
            return (self.set_force - force) / self.straight_stiffness
        return self.deflection - self.disc.deflection(force)
