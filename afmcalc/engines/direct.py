"""Engine of direct regulation: one law, the variants are pair counts."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal

from ..equations import accuracy, direct
from ..equations.arrays import Values, is_array, larger, smaller
from ..findings import Finding, finding
from ..messages import say
from ..spec.models import Method, Spec
from . import parameters
from .protocol import Clutch, TorqueAt, extremes


@dataclass(frozen=True)
class DirectClutch(Clutch):
    """Clutch whose release force acts on the pack itself."""

    @classmethod
    def from_spec(cls, spec: Spec) -> "DirectClutch":
        """Build the engine of a spec whose values may be arrays."""
        bypass, friction = spec.bypass_pairs, parameters.frictions(spec)
        controlled = direct.controlled_pairs(spec.friction_group.pairs, bypass)
        pack = parameters.mean_radius(spec), bypass, controlled, parameters.feedback_gain(spec)
        at_setting = parameters.at_setting(friction, spec)
        force = parameters.closing_force(spec, lambda: direct.torque_per_force(*pack, *at_setting))
        return cls(force, *pack, friction=friction, spec=spec)

    @property
    def _pack(self) -> tuple[Values, Values, Values, Values]:
        return self.mean_radius, self.bypass_pairs, self.controlled_pairs, self.gain

    def torque_per_force(self, method: Method | None = None) -> Values:
        """T/F_п at the friction of a setting, m; by default the spec's own."""
        return direct.torque_per_force(*self._pack, *self.friction_at_setting(method))

    def torque(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Sustained slip torque T, N·m (F11 (12))."""
        return direct.torque(self.closing_force, *self._pack, *both_frictions(friction, friction_driven))

    def normal_force(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Normal force N on the pairs, N; arguments as ``torque``."""
        driven = both_frictions(friction, friction_driven)[1]
        return direct.normal_force(self.closing_force, self.controlled_pairs, self.gain, driven)

    def release_force(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Release force F_p of the control unit, N; arguments as ``torque``."""
        driven = both_frictions(friction, friction_driven)[1]
        return direct.release_force(self.closing_force, self.controlled_pairs, self.gain, driven)

    def ball_torque(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Torque T_2 that passes the balls, N·m; arguments as ``torque``."""
        pressed, driven = self.normal_force(friction, friction_driven), both_frictions(friction, friction_driven)[1]
        return direct.group_torque(pressed, self.mean_radius, self.controlled_pairs, driven)

    def breakaway_torque(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Upper bound P of the breakaway torque, N·m (handbook, chapter 3); arguments as ``torque``."""
        if not is_array(self.bypass_pairs) and self.bypass_pairs == 0:
            return self.torque(friction, friction_driven)
        driving = both_frictions(friction, friction_driven)[0]
        bypass = direct.group_torque(self.closing_force, self.mean_radius, self.bypass_pairs, driving)
        return larger(bypass, self.torque(friction, friction_driven)) if self.spec.kind.controlled else bypass

    def _turning_points(self, start: Literal["min", "mean"] = "min") -> list[tuple[Values, Values]]:
        """Ends of the path, between which the torque rises with one material; with unlike ones also the mean."""
        first, second = self.friction
        names = (start, "mean", "max") if self.spec.friction.unlike else (start, "max")
        return [(getattr(first, name), getattr(second, name)) for name in names]

    def extreme_torques(self, start: Literal["min", "mean"] = "min") -> tuple[TorqueAt, TorqueAt]:
        """At the ends: with one material the torque rises with f; with unlike ones it may also turn at the mean."""
        slips = [(self.torque(*point), *point) for point in self._turning_points(start)]
        return extremes(slips) if self.spec.friction.unlike else (slips[0], slips[1])

    @property
    def torque_max(self) -> Values:
        """Largest sustained torque along the common path, N·m; with one material that at f_max."""
        return super().torque_max if self.spec.friction.unlike else self.torque(*self._turning_points()[1])

    @property
    def accuracy_factor(self) -> Values:
        """K_т, largest over smallest torque along the common path of f_1 and f_2."""
        if self.spec.friction.unlike:
            (_, *low), (_, *high) = self.extreme_torques()
        else:
            low, high = map(list, self._turning_points())
        return accuracy.accuracy_factor(self.bypass_pairs, self.controlled_pairs, self.gain, *low, *high)

    @property
    def accuracy_factor_worst_case(self) -> Values:
        """K_т over the rectangle of both ranges; T is monotone in each, so its extremes are corners."""
        first, second = self.friction
        corners = [self.torque(f1, f2) for f1 in (first.min, first.max) for f2 in (second.min, second.max)]
        low = high = corners[0]
        for corner in corners[1:]:
            low, high = smaller(low, corner), larger(high, corner)
        return accuracy.accuracy_factor_worst_case(high, low)

    @property
    def accuracy_factor_peak(self) -> Values:
        """Largest over smallest breakaway torque: T falls with f_2 only where P > T, so that P rises with both."""
        first, second = self.friction
        peaks = (self.breakaway_torque(*ends) for ends in ((first.max, second.max), (first.min, second.min)))
        return accuracy.accuracy_factor_peak(*peaks)

    def _law_findings(self) -> Iterator[Finding]:
        """Gain limits, idle feedback, a torque that falls with friction."""
        path, largest = parameters.gain_path(self.spec), [group.max for group in self.friction]
        rule, limit = self.spec.kind.gain_limit, self.gain_limit
        if self.spec.kind.controlled and self.gain == 0:
            yield finding("feedback-idle", "warning", value=0.0, limit=0.0, path=path)
        elif rule is not None and limit is not None and self.gain > limit * (1 + 1e-9):
            value, bound = map(float, rule.stated(self.gain, self.reduced_gain, limit))
            peak, sustained = self.breakaway_torque(*largest), self.torque(*largest)
            yield finding(rule.code, "warning", value=value, limit=bound, path=path, peak=peak, sustained=sustained)
        if self.spec.friction.unlike:
            most, at = float(self.torque_range.high), float(self.torque_range.at_high)
            if (factor := float(self.torque(*largest)) / most) < 1:
                yield finding("torque-falls", "info", value=factor, limit=1.0, most=most, at=at)


def both_frictions(friction: Values, friction_driven: Values | None) -> tuple[Values, Values]:
    """f_1 and f_2, checked.

    Raises:
        ValueError: negative or no number.
    """
    first = _checked(friction)
    return first, first if friction_driven is None or friction_driven is friction else _checked(friction_driven)


def _checked(friction: Any) -> Any:
    if isinstance(friction, list | tuple):
        import numpy as np

        friction = np.asarray(friction, float)
    if isinstance(friction, int | float) and not isinstance(friction, bool):
        if 0 <= friction < math.inf:
            return friction
    elif is_array(friction):
        if friction.dtype.kind not in "fiu":
            raise ValueError(say("friction must be numbers, not an array of {dtype}", dtype=friction.dtype))
        if friction.size and not friction.min() >= 0:
            raise ValueError(say("friction must be at least 0 everywhere"))
        return friction
    raise ValueError(
        say("friction must be a finite number, at least 0, or an array of such; got {value!r}", value=friction)
    )
