"""What every clutch can be asked, whatever its torque law."""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from ..equations import accuracy, adjustment, direct, effects, overload
from ..equations.arrays import Values, chosen, larger, smaller
from ..findings import Finding
from ..spec.models import Method, Range, Spec
from . import parameters

if TYPE_CHECKING:
    # not imported at run time: a direct clutch needs neither module
    from .indirect import IndirectClutch
    from .quantities import Quantities
    from .springs import SetSpring, SpringDemand


class TorqueRange(NamedTuple):
    """Smallest and largest sustained torque over the friction range, N·m, and the friction f_1 where each lies.

    Where the sleeve jumps, the torque just before the jump counts.
    """

    low: Any
    high: Any
    at_low: Any
    at_high: Any


TorqueAt = tuple[Values, ...]
"""A torque, N·m, followed by the friction f_1 at which it occurs, and f_2 where the clutch has two."""
_ALIKE = 1e-12
"""Relative difference up to which two torques count as equal."""


def extremes(slips: Sequence[TorqueAt]) -> tuple[TorqueAt, TorqueAt]:
    """Return the points of smallest and of largest torque; of equal ones the first smallest and the last largest."""
    low, high = slips[0], slips[-1]
    for slip, back in zip(slips[1:], slips[-2::-1], strict=True):
        low = smaller(low[0], slip[0]), *_chosen(slip[0] < low[0] * (1 - _ALIKE), slip, low)
        high = larger(high[0], back[0]), *_chosen(back[0] > high[0] * (1 + _ALIKE), back, high)
    return low, high


def _chosen(condition: Any, yes: TorqueAt, no: TorqueAt) -> TorqueAt:
    """Return the frictions of ``yes`` where the condition holds, else those of ``no``."""
    places = range(1, len(yes))
    return tuple(chosen(condition, partial(yes.__getitem__, at), partial(no.__getitem__, at)) for at in places)


@dataclass(frozen=True)
class Clutch(ABC):
    """A clutch and its law; its numbers are floats or, in a sweep or a search, arrays."""

    closing_force: Values
    """F_п as set, N."""
    mean_radius: Values
    """R_cp, m."""
    bypass_pairs: Values
    """z_1, pairs that bypass the control unit."""
    controlled_pairs: Values
    """z_2, pairs whose torque passes it."""
    gain: Values
    """C."""
    # the candidates of a search need neither: only their torque and forces are calculated
    friction: tuple[Range, Range] = field(kw_only=True, default=())  # type: ignore[assignment]
    """Ranges of f_1 and f_2 (twice the same with one material)."""
    spec: Spec = field(kw_only=True, default=None)  # type: ignore[assignment]
    """The spec from which the clutch was built."""

    @classmethod
    @abstractmethod
    def from_spec(cls, spec: Spec) -> "Clutch":
        """Build the engine of a spec whose values may be arrays."""

    @property
    def sleeve(self) -> "IndirectClutch | None":
        """The clutch itself if it is an indirect one, which has a thrust sleeve; None for a direct clutch."""
        return None

    @cached_property
    def quantities(self) -> "Quantities":
        """The same clutch by its laws, for the analyses that ask by name."""
        from .selection import quantities_of

        return quantities_of(self.spec)

    # springs and setting

    @property
    def pack_force_at_rest(self) -> Values:
        """Force on the pack of the clutch at rest, N: the closing spring's."""
        return self.closing_force

    @property
    def following_spring(self) -> "SetSpring":
        """The spring that extends as the pack wears, as it is set."""
        from .springs import DiscCharacteristic, SetSpring

        given = self.spec.closing_spring
        stiffness = given.coil.rate if given.stiffness is None and given.coil is not None else given.stiffness
        disc = None if given.disc is None else DiscCharacteristic(given.disc)
        return SetSpring(self.closing_force, stiffness, disc)

    @property
    def following_stiffness(self) -> Values | None:
        """Stiffness of ``following_spring``, N/m; None where the spec does not give it."""
        spring = self.following_spring
        return spring.straight_stiffness if spring.disc is None else spring.stiffness(0.0)

    def lost_by_wear(self, wear: Values) -> Values:
        """Force that the pack loses when every pair wears by ``wear``, N; needs the stiffness of the spring."""
        pairs, spring = self.spec.friction_group.pairs, self.following_spring
        if spring.disc is None:
            return effects.force_lost_by_wear(spring.straight_stiffness, pairs, wear)
        return spring.set_force - spring.force(-smaller(pairs * wear, spring.deflection))

    def friction_at_setting(self, method: Method | None = None) -> tuple[Values, Values]:
        """f_1 and f_2 at which the spring is set, by ``method`` or that of the spec: the smallest, or the mean."""
        return parameters.at_setting(self.friction, self.spec, method)

    @cached_property
    def nominal_torque(self) -> Values:
        """T_н of the clutch that the setting gives, N·m."""
        return adjustment.nominal_torque(self.torque(*self.friction_at_setting()), parameters.margin(self.spec))

    @property
    def machine_torque(self) -> Values:
        """T_н.маш of the machine, N·m: T_н over the margin; T_н itself if set at mean friction, margin included."""
        return overload.machine_torque(self.nominal_torque, self.spec.adjustment.margin / parameters.margin(self.spec))

    @property
    def running_torque(self) -> Values:
        """Load before an event where [drive] has none, N·m: that of the plate in rated running, else T_н.маш."""
        plate = self.spec.machine
        return self.machine_torque if plate is None else plate.torque_at_clutch

    @abstractmethod
    def torque_per_force(self, method: Method | None = None) -> Any:
        """T/F_п at the friction of a setting, m; by default at the setting of the spec."""

    # limits of the gain

    @property
    def reduced_gain(self) -> Values:
        """z_2 C."""
        return direct.reduced_gain(self.controlled_pairs, self.gain)

    @property
    def gain_threshold(self) -> Values:
        """Gain at which feedback begins."""
        return 0.0

    @property
    def gain_limit(self) -> Values | None:
        """Largest gain at which the law describes the whole slip, where the variant has one."""
        rule = self.spec.kind.gain_limit
        return None if rule is None else rule.gain(self.bypass_pairs, self.controlled_pairs, self.friction[0].max)

    # torque and forces at one friction

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

    # over the friction range

    def path(self, share: Values) -> tuple[Values, Values]:
        """f_1 and f_2 at a share (0…1) of the common path, on which both rise from minimum through mean to maximum."""
        first, second = self.friction
        if not self.spec.friction.unlike:
            alike = first.min + share * (first.max - first.min)
            return alike, alike
        bend = larger(smaller(self.path_bend, 1 - _ALIKE), _ALIKE)
        below, above = smaller(share / bend, 1.0), larger((share - bend) / (1 - bend), 0.0)
        one, two = (
            part.min + below * (part.mean - part.min) + above * (part.max - part.mean) for part in (first, second)
        )
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
        low, high = self.extreme_torques()
        return TorqueRange(low[0], high[0], low[1], high[1])

    @abstractmethod
    def extreme_torques(self, start: Literal["min", "mean"] = "min") -> tuple[TorqueAt, TorqueAt]:
        """Points of the smallest and of the largest torque along the common path, from its start or its mean on."""

    @property
    def torque_max(self) -> Values:
        """Largest sustained torque along the common path, N·m."""
        return self.torque_range.high

    @property
    def torque_min(self) -> Values:
        """Smallest sustained torque along the common path, N·m."""
        return self.torque_range.low

    @property
    def scatter(self) -> Values:
        """Width of the torque scatter band ΔT, N·m."""
        return accuracy.scatter_band(self.torque_range.high, self.torque_range.low)

    @property
    @abstractmethod
    def accuracy_factor(self) -> Values:
        """K_т along the common path."""

    @property
    def accuracy_factor_worst_case(self) -> Values:
        """K_т with f_1 and f_2 independent."""
        return self.accuracy_factor

    @property
    def accuracy_factor_peak(self) -> Values:
        """K_т by breakaway peaks."""
        return self.accuracy_factor

    def sensitivity(self) -> dict[str, float]:
        """Elasticities ∂ln K_т/∂ln p by spec path."""
        from .sensitivity import sensitivity

        return sensitivity(self)

    # findings

    def findings(self) -> list[Finding]:
        """Findings on the limits of the law, on the setting, and on springs given as parts."""
        found = [*self.spec.label.findings, *self._law_findings()]
        found += parameters.setting_findings(self.spec, float(self.nominal_torque), float(self.torque_min))
        found += parameters.machine_findings(self.spec, float(self.torque_min), float(self.torque_max))
        if self.spec.spring_parts:
            from .parts import part_findings

            found += part_findings(self.spec, self.spring_demands())
        return found

    @abstractmethod
    def _law_findings(self) -> Iterable[Finding]:
        """Findings on the limits of the law."""

    def spring_demands(self, travel: float = 0.0) -> "list[SpringDemand]":
        """Demand on each spring: force as set and stroke; ``travel`` counts where it exceeds that of the law."""
        from .springs import spring_demands

        sleeve = self.sleeve
        if sleeve is None:
            return spring_demands(self.spec, float(self.closing_force), None, travel)
        control = float(sleeve.control_force)
        return spring_demands(self.spec, float(self.closing_force), control, max(travel, float(sleeve.travel_max)))
