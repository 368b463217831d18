"""Force over deflection of a spring that is known as a part: a stack of disc springs, or coil springs."""

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from ..arrays import Values, chosen, greatest, larger, smaller
from ..equations import springs as law
from ..recorders import marked, unrecorded
from ..spec.models import Spec
from ..spec.springs import CoilSprings, DiscStack

MODULUS = 206e9
"""Young's modulus of disc springs (DIN EN 16984), Pa."""
POISSON = 0.3
LEAST_USED, MOST_USED = 0.15, 0.75
"""Shares of the cone height that a disc spring is used in (DIN EN 16984)."""
_STEPS = 60
_CLOSE = 1e-13
"""Relative to the whole deflection."""


def root(
    rising: Callable[[Values], Values], slope: Callable[[Values], Values], end: Values, start: Values = 0.0
) -> Values:
    """Where a function that rises from ``start`` to ``end`` is 0, number by number; the nearer end where it is not.

    Newton's steps, and halves of what is left where one would leave it.
    """
    at = low = start + 0.0 * end
    high = end
    for _ in range(_STEPS):
        value = rising(at)
        below = value < 0
        low, high = chosen(below, _is(at), _is(low)), chosen(below, _is(high), _is(at))
        step = at - value / slope(at)
        there: Values = chosen((step >= low) & (step <= high), _is(step), _is((low + high) / 2))
        moved, at = greatest(larger(there - at, at - there)), there
        if not moved > _CLOSE * greatest(end):
            break
    return at


def _is(value: Values) -> Callable[[], Values]:
    return lambda: value


class Characteristic(ABC):
    """A spring as a part; deflections are of the whole, in m, numbers or arrays."""

    @property
    @abstractmethod
    def free_length(self) -> float:
        """L_0, m."""

    @property
    @abstractmethod
    def range(self) -> tuple[float, float]:
        """Deflections that it may be used between, m."""

    @property
    @abstractmethod
    def end(self) -> float:
        """Deflection at which it is flat or solid, m."""

    @property
    @abstractmethod
    def straight(self) -> bool:
        """Whether the force is proportional to the deflection."""

    @abstractmethod
    def force(self, deflection: Values) -> Values:
        """Force, N."""

    @abstractmethod
    def stiffness(self, deflection: Values) -> Values:
        """Slope of the force, N/m."""

    def deflection(self, force: Values) -> Values:
        """Deflection that gives a force, m; the end where none does.

        The force grows ever slower, so that Newton's steps from nothing never go too far.
        """
        at = 0.0 * force
        with unrecorded():
            for _ in range(_STEPS):
                there: Values = smaller(at + (force - self.force(at)) / self.stiffness(at), self.end)
                moved, at = greatest(there - at), there
                if not moved > _CLOSE * self.end:
                    break
        return at


@dataclass(frozen=True)
class DiscCharacteristic(Characteristic):
    """A stack of disc springs, without the friction between them."""

    part: DiscStack

    @property
    def ratio(self) -> float:
        """δ."""
        return self.part.outer_diameter / self.part.inner_diameter

    @property
    def thickness(self) -> float:
        """As made: t, with flats t', m."""
        return self.part.reduced_thickness or self.part.thickness

    @property
    def cone_height(self) -> float:
        """l_0 − t of the disc without flats, by which its use is measured, m."""
        return self.part.free_height - self.part.thickness

    @property
    def factors(self) -> tuple[float, float]:
        """K_1 and K_4."""
        load = law.disc_factor_load(self.ratio, math.log(self.ratio), math.pi)
        reduced = self.part.reduced_thickness
        if reduced is None:
            return float(load), 1.0
        return float(load), float(law.disc_factor_flats(self.part.thickness, reduced, self.part.free_height))

    @property
    def free_length(self) -> float:
        """L_0 of the stack, m."""
        own = self.part
        return float(law.stack_length(own.parallel, own.series, own.free_height, self.thickness))

    @property
    def range(self) -> tuple[float, float]:
        """Between 0.15 and 0.75 of the cone height, m."""
        whole = self.part.series * self.cone_height
        return LEAST_USED * whole, MOST_USED * whole

    @property
    def end(self) -> float:
        """All discs flat, m."""
        return self.part.series * (self.part.free_height - self.thickness)

    @property
    def straight(self) -> bool:
        """Disc springs never are."""
        return False

    def deflection(self, force: Values) -> Values:
        """Deflection that gives a force, m; all discs flat where none does."""
        _ = self.shape  # of the calculation, unlike the search
        return super().deflection(force)

    def force(self, deflection: Values) -> Values:
        """Force of the stack, N."""
        each = marked(deflection / self.part.series, deflection)
        force: Values = self.part.parallel * law.disc_force(*self.shape, each)
        return force

    def stiffness(self, deflection: Values) -> Values:
        """Slope of the force, N/m."""
        own = self.part
        slope: Values = own.parallel / own.series * law.disc_stiffness(*self.shape, deflection / own.series)
        return slope

    def explain(self, deflection: Values) -> None:
        """Run the equations of force and stiffness at a deflection once more, from the factors on, to be recorded."""
        shape, each = self._shape(), deflection / self.part.series
        law.disc_force(*shape, each)
        law.disc_stiffness(*shape, each)

    def stresses(self, deflection: float) -> tuple[float, float]:
        """Stress where the section turns (OM), and the largest tension at the edges II and III, Pa."""
        logarithm, each = math.log(self.ratio), deflection / self.part.series
        membrane = law.disc_factor_membrane(self.ratio, logarithm, math.pi)
        bending = law.disc_factor_bending(self.ratio, logarithm, math.pi)
        middle = law.disc_stress(*self.shape, each, 0.0, 3 / math.pi)
        edges = (membrane, -bending), ((membrane - 2 * bending) / self.ratio, -bending / self.ratio)
        return float(middle), max(float(law.disc_stress(*self.shape, each, *edge)) for edge in edges)

    @cached_property
    def shape(self) -> tuple[float, float, float, float, float, float, float]:
        """E, ν, K_1, K_4, D_e, t and h_0 of a disc, with flats t' and l_0 − t'."""
        return self._shape()

    def _shape(self) -> tuple[float, float, float, float, float, float, float]:
        height = self.part.free_height - self.thickness
        return (MODULUS, POISSON, *self.factors, self.part.outer_diameter, self.thickness, height)


@dataclass(frozen=True)
class CoilCharacteristic(Characteristic):
    """Coil springs side by side."""

    part: CoilSprings

    @property
    def free_length(self) -> float:
        """L_0, m."""
        return self.part.free_length

    @property
    def rate(self) -> float:
        """Stiffness of all together, N/m."""
        return self.part.rate

    @property
    def range(self) -> tuple[float, float]:
        """From nothing to where the gaps between the turns are the least that must stay, m."""
        own = self.part
        gap = law.coil_least_gap(own.wire_diameter, own.coil_diameter, own.turns)
        return 0.0, self.end - float(gap)

    @property
    def end(self) -> float:
        """Pressed solid, m."""
        return self.part.free_length - float(law.coil_solid_length(self.part.wire_diameter, self.part.turns))

    @property
    def straight(self) -> bool:
        """Coil springs are."""
        return True

    def force(self, deflection: Values) -> Values:
        """Force of all together, N."""
        return self.rate * deflection

    def deflection(self, force: Values) -> Values:
        """Deflection that gives a force, m; pressed solid where none does."""
        return smaller(force / self.rate, self.end)

    def stiffness(self, deflection: Values) -> Values:
        """The same at every deflection, N/m."""
        return self.rate + 0.0 * deflection

    @property
    def correction(self) -> float:
        """k_τ, by which a curved wire bears more at its inside: it counts where the spring moves."""
        return float(law.coil_correction(self.part.wire_diameter, self.part.coil_diameter))

    def stress(self, deflection: float) -> float:
        """Shear stress of the wire, without the correction for the curve as for a spring that rests, Pa."""
        own = self.part
        each = self.rate * deflection / own.count
        return float(law.coil_stress(each, own.wire_diameter, own.coil_diameter, 1.0, math.pi))


def characteristic(part: DiscStack | CoilSprings) -> DiscCharacteristic | CoilCharacteristic:
    """Return the characteristic of a part."""
    return DiscCharacteristic(part) if isinstance(part, DiscStack) else CoilCharacteristic(part)


class CurvedSprings(NamedTuple):
    """The two springs of a sleeve; None: straight, of the stiffness that the law has."""

    closing: DiscCharacteristic | None
    control: DiscCharacteristic | None


def curved(spec: Spec) -> CurvedSprings | None:
    """The springs of a spec whose force is not proportional to their deflection; None where both are straight."""
    control = spec.control_spring
    discs = spec.closing_spring.disc, control.disc if control is not None else None
    if discs == (None, None):
        return None
    return CurvedSprings(*(None if disc is None else DiscCharacteristic(disc) for disc in discs))
