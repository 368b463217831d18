"""What every engine offers to the analyses."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from ..arrays import Values, chosen, larger, smaller
from ..equations import accuracy, adjustment, effects, overload
from ..findings import Finding
from ..recorders import unrecorded
from ..spec.models import Method, Range, Spec
from . import setting

if TYPE_CHECKING:
    # what only some clutches have is no part of every start
    from .characteristic import DiscCharacteristic
    from .direct_law import DirectLaw
    from .laws import IndirectLaw
    from .wish import Wish


class Point(NamedTuple):
    """State of the slipping clutch at one friction, SI."""

    torque: Any
    normal_force: Any
    release_force: Any
    travel: Any | None
    """Axial travel of the thrust sleeve, m; None where there is no sleeve."""


class TorqueRange(NamedTuple):
    """Smallest and largest sustained torque over the friction range, N·m, and the friction f_1 where each lies.

    Where the sleeve jumps, the torque just before the jump counts.
    """

    low: Any
    high: Any
    at_low: Any
    at_high: Any


Slip = tuple[Values, ...]
"""A torque, then the frictions that it is for."""
_ALIKE = 1e-12
"""Relative difference of torques that is rounding."""


def extremes(slips: Sequence[Slip]) -> tuple[Slip, Slip]:
    """Slips of the smallest and of the largest torque; of those alike but for rounding the first and the last."""
    low, high = slips[0], slips[-1]
    for slip, back in zip(slips[1:], slips[-2::-1], strict=True):
        low = smaller(low[0], slip[0]), *_chosen(slip[0] < low[0] * (1 - _ALIKE), slip, low)
        high = larger(high[0], back[0]), *_chosen(back[0] > high[0] * (1 + _ALIKE), back, high)
    return low, high


def _chosen(condition: Any, yes: Slip, no: Slip) -> Slip:
    """Frictions of one slip, or of another."""
    places = range(1, len(yes))
    return tuple(chosen(condition, partial(yes.__getitem__, at), partial(no.__getitem__, at)) for at in places)


class ByGain(NamedTuple):
    """Ball torque at f_max and fixed spring force over the gain C: ∝ (a_0 + a_1 C)/(b_0 + b_1 C)."""

    numerator: tuple[float, float]
    denominator: tuple[float, float]
    start: float
    """Gain at which feedback begins."""


@dataclass(frozen=True)
class Clutch(ABC):
    """A clutch that can be asked; parameters are floats or, in a sweep, arrays.

    What a law does not have is None: a clutch without sleeve has no travel, no threshold of the gain.
    """

    spec: Spec
    """The spec it was built from."""
    law: "DirectLaw | IndirectLaw"
    """Torque and forces as functions of the spring force and the friction."""
    friction: tuple[Range, Range]
    """Ranges of f_1 and f_2 (twice the same with one material)."""
    closing_force: Values
    """F_п as set, N."""

    @classmethod
    @abstractmethod
    def from_spec(cls, spec: Spec) -> "Clutch":
        """Build the engine of a spec whose values may be arrays."""

    @property
    def pack_force_at_rest(self) -> Values:
        """Force on the pack of the clutch at rest, N: the closing spring's."""
        return self.closing_force

    @property
    def following(self) -> "tuple[Values | None, DiscCharacteristic | None]":
        """The spring that follows the pack as it wears: its stiffness if given, its part where it is a curved one."""
        own = self.spec.closing_spring
        stiffness = own.coil.rate if own.stiffness is None and own.coil is not None else own.stiffness
        if own.disc is None:
            return stiffness, None
        from .characteristic import DiscCharacteristic

        return stiffness, DiscCharacteristic(own.disc)

    @property
    def following_stiffness(self) -> Values | None:
        """Stiffness of the spring that follows a pack as it wears, N/m; None where the spec does not give it."""
        stiffness, part = self.following
        return stiffness if part is None else part.stiffness(part.deflection(self.pack_force_at_rest))

    def lost_by_wear(self, wear: Values) -> Values:
        """Force that the pack loses as each pair wears by so much, N; needs the stiffness of the spring."""
        pairs, (_, part) = self.spec.friction_group.pairs, self.following
        if part is None:
            lost: Values = effects.force_lost_by_wear(self.following_stiffness, pairs, wear)
            return lost
        rest = self.pack_force_at_rest
        left = larger(part.deflection(rest) - pairs * wear, 0.0)
        return rest - part.force(left)

    @property
    def mean_radius(self) -> Values:
        """R_cp, m."""
        return self.law.mean_radius

    @property
    def gain(self) -> Values:
        """C."""
        return self.law.gain

    @property
    def reduced_gain(self) -> Values:
        """z C or z_2 C."""
        return self.law.reduced_gain

    @property
    @abstractmethod
    def bypass_pairs(self) -> Values:
        """z_1, pairs that bypass the control unit."""

    @property
    def gain_limit(self) -> Values | None:
        """Largest gain at which the law describes the whole slip."""
        return None

    @property
    def gain_threshold(self) -> Values | None:
        """Gain at which feedback begins."""
        return None

    @property
    def equivalent_gain(self) -> Values | None:
        """Gain of the all-driving clutch with the same torque curve."""
        return None

    @property
    def nominal_torque_ratio(self) -> Values | None:
        """K_п against the base clutch of equal spring and gain, all pairs controlled."""
        return None

    @property
    def friction_set(self) -> Values | None:
        """Friction at which the control spring is set so that the sleeve just stays at its stop."""
        return None

    @property
    def torque_returning_min(self) -> Values | None:
        """Smallest torque as friction falls from f_max to f_min under load, N·m."""
        return None

    @property
    def leaving_friction(self) -> Values | None:
        """Friction at which the sleeve leaves its stop: the law bends there."""
        return None

    @property
    def gain_slope(self) -> Values | None:
        """C_1, how the gain grows with the travel of the sleeve, 1/m."""
        return None

    @property
    def constant_torque_slope(self) -> Values | None:
        """C_1* at which torque does not depend on friction once the sleeve is off its stop, 1/m."""
        return None

    @property
    def control_force(self) -> Values | None:
        """F_п2 of the control spring, N."""
        return None

    @property
    def nominal_torque(self) -> Values:
        """T_н of the clutch that the setting gives, N·m."""
        at_setting = self.torque(*setting.friction_at_setting(self.spec))
        torque: Values = adjustment.nominal_torque(at_setting, setting.margin(self.spec))
        return torque

    @property
    def machine_torque(self) -> Values:
        """T_н.маш of the machine, N·m: T_н over the margin, unless that is in the spring already (mean-friction)."""
        torque: Values = overload.machine_torque(self.nominal_torque, setting.margin_over_machine(self.spec))
        return torque

    def path(self, share: Values) -> tuple[Values, Values]:
        """f_1 and f_2 at a share (0…1) of the common path, on which both rise from their minima by their means."""
        first, second = self.friction
        if not self.spec.friction.unlike:
            alike = first.min + share * (first.max - first.min)
            return alike, alike
        bend = larger(smaller(self.path_bend, 1 - _ALIKE), _ALIKE)
        below, above = smaller(share / bend, 1.0), larger((share - bend) / (1 - bend), 0.0)
        one, two = (own.min + below * (own.mean - own.min) + above * (own.max - own.mean) for own in (first, second))
        return one, two

    @property
    def path_bend(self) -> Values:
        """Share of the common path at which both frictions have their mean."""
        first, second = self.friction
        whole = first.max - first.min + (second.max - second.min)
        return (first.mean - first.min + (second.mean - second.min)) / larger(whole, 1e-300)

    @cached_property
    def torque_range(self) -> TorqueRange:
        """Extremes of the sustained torque along the common path."""
        return self.torque_range_from("min")

    def torque_range_from(self, start: Literal["min", "mean"]) -> TorqueRange:
        """Extremes of the sustained torque along the common path, from its start or from the mean on."""
        low, high = self._extremes(start)
        return TorqueRange(low[0], high[0], low[1], high[1])

    @abstractmethod
    def _extremes(self, start: Literal["min", "mean"] = "min") -> tuple[Slip, Slip]:
        """Slips of the smallest and of the largest torque along the common path."""

    @property
    def torque_max(self) -> Values:
        """Largest sustained torque along the common path, N·m."""
        most: Values = self.torque_range.high
        return most

    @property
    def torque_min(self) -> Values:
        """Smallest sustained torque along the common path, N·m."""
        least: Values = self.torque_range.low
        return least

    @property
    def scatter(self) -> Values:
        """Width of the torque scatter band ΔT, N·m."""
        band: Values = accuracy.scatter_band(self.torque_max, self.torque_min)
        return band

    @property
    @abstractmethod
    def accuracy_factor(self) -> Values:
        """K_т along the common path."""

    @property
    def accuracy_factor_hysteresis(self) -> Values | None:
        """K_т under a load that lasts, where the torque depends on whether friction rises or falls."""
        return None

    @property
    def accuracy_factor_worst_case(self) -> Values:
        """K_т with f_1 and f_2 independent."""
        return self.accuracy_factor

    @property
    def accuracy_factor_peak(self) -> Values:
        """K_т by breakaway peaks."""
        return self.accuracy_factor

    @abstractmethod
    def torque_per_force(self, method: Method | None = None) -> Any:
        """T/F_п at the friction of a setting, m; by default the spec's own."""

    @abstractmethod
    def torque(self, friction: Values, friction_driven: Values | None = None) -> Any:
        """Sustained slip torque, N·m.

        Args:
            friction: f of all pairs, or f_1 of the driving pairs when ``friction_driven`` is given;
                a float or an array of any shape.
            friction_driven: f_2 of the driven pairs.

        Returns:
            T, N·m, in the broadcast shape of the arguments.

        Raises:
            ValueError: negative friction, or two different ones where all pairs are alike.
        """

    @abstractmethod
    def normal_force(self, friction: Values, friction_driven: Values | None = None) -> Any:
        """Normal force N on the pairs, N; arguments as ``torque``."""

    @abstractmethod
    def release_force(self, friction: Values, friction_driven: Values | None = None) -> Any:
        """Release force F_p of the control unit, N; arguments as ``torque``."""

    @abstractmethod
    def ball_torque(self, friction: Values, friction_driven: Values | None = None) -> Any:
        """Torque that passes the balls, N·m; arguments as ``torque``."""

    def breakaway_torque(self, friction: Values, friction_driven: Values | None = None) -> Any:
        """Upper bound P of the breakaway torque, N·m; arguments as ``torque``."""
        return self.torque(friction, friction_driven)

    def torque_returning(self, friction: Values) -> Any | None:
        """Torque when friction falls again from f_max under load, N·m."""
        return None

    def travel(self, friction: Values, friction_driven: Values | None = None) -> Any | None:
        """Axial travel of the sleeve, m; arguments as ``torque``."""
        return None

    def point(self, friction: Values, friction_driven: Values | None = None) -> Point:
        """Torque, forces and travel at one friction."""
        return Point(
            torque=self.torque(friction, friction_driven),
            normal_force=self.normal_force(friction, friction_driven),
            release_force=self.release_force(friction, friction_driven),
            travel=self.travel(friction, friction_driven),
        )

    @abstractmethod
    def ball_torque_by_gain(self) -> ByGain | None:
        """How the torque on the balls at f_max depends on the gain; None where not by a ratio of linear functions."""

    @abstractmethod
    def sensitivity(self) -> dict[str, float]:
        """Elasticities ∂ln K_т/∂ln p by spec path."""

    def findings(self) -> list[Finding]:
        """What a designer should know: what the law says of it, and the setting; no steps of a calculation."""
        with unrecorded():
            found, nominal = self._law_findings(), float(self.nominal_torque)
            found = [*found, *setting.findings(self.spec, nominal, float(self.torque_min))]
            return [*self.spec.label.findings, *found, *self._part_findings()]

    def wishes(self, travel: float = 0.0) -> "list[Wish]":
        """What each spring is to give, and what happens to it where the sleeve travels by the law, or farther."""
        from .wish import wishes

        control, own = self.control_force, float(self.travel(self.friction[0].max) or 0.0)
        held = None if control is None else float(control)
        return wishes(self.spec, float(self.closing_force), held, max(travel, own))

    def _part_findings(self) -> list[Finding]:
        if not self.spec.spring_parts:
            return []
        from .parts import part_findings

        return part_findings(self.spec, self.wishes())

    @abstractmethod
    def _law_findings(self) -> list[Finding]:
        """What the law says of its limits."""
