"""Springs of a clutch: force of a spring part over its deflection, and the spring as set; numbers or arrays."""

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
"""Density of steel, kg/m³."""
LEAST_USED, MOST_USED = 0.15, 0.75
"""Smallest and largest permitted deflection of a disc spring, relative to its cone height (DIN EN 16984)."""
_STEPS = 60
_CLOSE = 1e-13
"""Tolerance of ``root``, relative to ``end``."""


def root(
    rising: Callable[[Values], Values], slope: Callable[[Values], Values], end: Values, start: Values = 0.0
) -> Values:
    """Zero of an increasing function between ``start`` and ``end``, elementwise; without a zero, the nearer end.

    Newton's method, with bisection where a step would leave the bracket; all elements at once, whereas SciPy's
    bracketed searches take one number at a time.
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
    """Characteristic of a stack of disc springs without friction; force (N) and deflection (m) are of the stack."""

    part: DiscStack
    apply: Apply = field(default=call, compare=False)

    @property
    def ratio(self) -> float:
        """Diameter ratio δ = D_e/D_i."""
        return self.part.outer_diameter / self.part.inner_diameter

    @property
    def thickness(self) -> float:
        """Thickness of a disc spring as made, m: t, or t' with contact flats."""
        own = self.part
        return own.thickness if own.reduced_thickness is None else own.reduced_thickness

    @property
    def factors(self) -> tuple[float, float]:
        """Factors K_1 and K_4 of a disc spring; K_4 = 1 without contact flats."""
        load = self.apply(law.disc_factor_load, self.ratio, logarithm(self.ratio), math.pi)
        reduced = self.part.reduced_thickness
        if reduced is None:
            return load, 1.0
        sizes = self.part.thickness, reduced, self.part.free_height
        first = self.apply(law.disc_flats_first, *sizes)
        return load, self.apply(law.disc_factor_flats, first, self.apply(law.disc_flats_second, first, *sizes))

    @property
    def free_length(self) -> float:
        """Free length L_0 of the stack, m."""
        return self.apply(law.stack_length, self.part.parallel, self.part.series, self.part.free_height, self.thickness)

    @property
    def mass(self) -> float:
        """Mass of all disc springs of the stack, kg."""
        own = self.part
        disc = self.apply(law.ring_mass, STEEL, own.outer_diameter, own.inner_diameter, self.thickness, math.pi)
        return own.parallel * own.series * disc

    @property
    def range(self) -> tuple[float, float]:
        """Smallest and largest permitted deflection of the stack, m; shares of t as if without contact flats."""
        whole = self.part.series * (self.part.free_height - self.part.thickness)
        return LEAST_USED * whole, MOST_USED * whole

    @property
    def end(self) -> float:
        """Deflection of the stack at which all disc springs are flat, m."""
        return self.part.series * (self.part.free_height - self.thickness)

    @cached_property
    def shape(self) -> tuple[float, float, float, float, float, float, float]:
        """Arguments E, ν, K_1, K_4, D_e, t, h_0 of a disc spring's laws; contact flats: t' and l_0 − t' for t, h_0."""
        height = self.part.free_height - self.thickness
        return (MODULUS, POISSON, *self.factors, self.part.outer_diameter, self.thickness, height)

    def force(self, deflection: Values) -> Values:
        """Force of the stack, N."""
        each = deflection / self.part.series
        return self.part.parallel * self.apply(law.disc_force, *self.shape, each)

    def stiffness(self, deflection: Values) -> Values:
        """Tangent stiffness of the stack, N/m."""
        own = self.part
        return own.parallel / own.series * self.apply(law.disc_stiffness, *self.shape, deflection / own.series)

    def deflection(self, force: Values) -> Values:
        """Deflection at a force, m, at most the deflection at which all disc springs are flat."""
        plain = DiscCharacteristic(self.part)
        return root(lambda at: plain.force(at) - force, plain.stiffness, self.end + 0.0 * force)

    def stresses(self, deflection: Values) -> tuple[Values, Values]:
        """Stress at the centre of rotation OM, and the largest tensile stress at the edges II and III, Pa."""
        ratio, each = self.ratio, deflection / self.part.series
        membrane = self.apply(law.disc_factor_membrane, ratio, logarithm(ratio), math.pi)
        bending = self.apply(law.disc_factor_bending, ratio, logarithm(ratio), math.pi)
        middle = self.apply(law.disc_stress, *self.shape, each, 0.0, 3 / math.pi)
        edges = (membrane, -bending), ((membrane - 2 * bending) / ratio, -bending / ratio)
        return middle, larger(*(self.apply(law.disc_stress, *self.shape, each, *edge) for edge in edges))


@dataclass(frozen=True)
class CoilCharacteristic:
    """Characteristic of coil springs in parallel; a force (N) is the force of all springs together."""

    part: CoilSprings
    apply: Apply = field(default=call, compare=False)

    @property
    def free_length(self) -> float:
        """Free length L_0, m."""
        return self.part.free_length

    @property
    def mass(self) -> float:
        """Mass of all springs together, kg."""
        own = self.part
        return own.count * self.apply(law.coil_mass, STEEL, own.wire_diameter, own.coil_diameter, own.turns, math.pi)

    @property
    def rate(self) -> float:
        """Stiffness of all springs together, N/m."""
        own = self.part
        return own.count * self.apply(
            law.coil_stiffness, SHEAR_MODULUS, own.wire_diameter, own.coil_diameter, own.turns
        )

    @property
    def range(self) -> tuple[float, float]:
        """Smallest (0) and largest permitted deflection, m; the largest leaves the minimum gaps between the turns."""
        own = self.part
        return 0.0, self.end - self.apply(law.coil_least_gap, own.wire_diameter, own.coil_diameter, own.turns)

    @property
    def end(self) -> float:
        """Deflection at which the springs are solid, m."""
        return self.part.free_length - self.apply(law.coil_solid_length, self.part.wire_diameter, self.part.turns)

    def force(self, deflection: Values) -> Values:
        """Force of all springs together, N."""
        return self.rate * deflection

    def stiffness(self, deflection: Values) -> Values:
        """Stiffness at every deflection, N/m."""
        return self.rate + 0.0 * deflection

    def deflection(self, force: Values) -> Values:
        """Deflection at a force, m, at most the deflection at which the springs are solid."""
        return smaller(force / self.rate, self.end)

    @property
    def correction(self) -> float:
        """Stress correction factor k_τ for the curvature of the wire, used for springs that move at every trip."""
        return self.apply(law.coil_correction, self.part.wire_diameter, self.part.coil_diameter)

    def stress(self, deflection: Values) -> Values:
        """Shear stress of the wire without the factor k_τ, as for a spring at rest, Pa."""
        each = self.rate * deflection / self.part.count
        return self.apply(law.coil_stress, each, self.part.wire_diameter, self.part.coil_diameter, 1.0, math.pi)


Characteristic: TypeAlias = DiscCharacteristic | CoilCharacteristic


def characteristic(part: DiscStack | CoilSprings, apply: Apply = call) -> Characteristic:
    """Return the characteristic (force over deflection) of a spring part."""
    return DiscCharacteristic(part, apply) if isinstance(part, DiscStack) else CoilCharacteristic(part, apply)


@dataclass(frozen=True)
class SetSpring:
    """Spring as set in a clutch; linear unless it has disc springs."""

    set_force: Values
    """Force as set, N."""
    straight_stiffness: Any
    """Stiffness of a linear spring, N/m; None if only the force is known."""
    disc: DiscCharacteristic | None = None

    @cached_property
    def deflection(self) -> Values:
        """Deflection as set, m."""
        if self.disc is None:
            return self.set_force / self.straight_stiffness
        return self.disc.deflection(self.set_force)

    def force(self, further: Values) -> Values:
        """Force when compressed by ``further`` beyond the setting, N."""
        if self.disc is None:
            return self.set_force + self.straight_stiffness * further
        return self.disc.force(self.deflection + further)

    def stiffness(self, further: Values) -> Values:
        """Tangent stiffness when compressed by ``further`` beyond the setting, N/m."""
        return self.straight_stiffness if self.disc is None else self.disc.stiffness(self.deflection + further)

    def secant(self, further: Values) -> Values:
        """Secant stiffness from the setting to ``further``, N/m."""
        return self.straight_stiffness if self.disc is None else (self.force(further) - self.set_force) / further

    def slackens(self, force: Values) -> Values:
        """Extension from the setting at which the spring force has fallen to ``force``, m."""
        if self.disc is None:
            return (self.set_force - force) / self.straight_stiffness
        return self.deflection - self.disc.deflection(force)
