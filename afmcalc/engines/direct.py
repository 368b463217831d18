"""Engine of direct regulation: one law, the variants are pair counts."""

from typing import Literal

from ..arrays import Values, checked_friction, is_array, larger, smaller
from ..equations import accuracy, direct
from ..findings import Finding, finding
from ..spec.models import Method, Spec
from . import geometry, setting
from .direct_law import DirectLaw
from .protocol import ByGain, Clutch, Slip, extremes


class DirectClutch(Clutch):
    """Clutch whose release force acts on the pack itself."""

    law: DirectLaw

    @classmethod
    def from_spec(cls, spec: Spec) -> "DirectClutch":
        """Build the engine of a spec whose values may be arrays."""
        bypass = spec.bypass_pairs
        controlled = direct.controlled_pairs(spec.friction_group.pairs, bypass)
        law = DirectLaw(geometry.mean_radius(spec), bypass, controlled, geometry.feedback_gain(spec))
        force = setting.closing_force(spec, lambda: law.torque_per_force(*setting.friction_at_setting(spec)))
        return cls(spec, law, spec.friction.groups, force)

    @property
    def bypass_pairs(self) -> Values:
        """z_1."""
        return self.law.bypass_pairs

    @property
    def controlled_pairs(self) -> Values:
        """z_2."""
        return self.law.controlled_pairs

    def torque_per_force(self, method: Method | None = None) -> Values:
        """T/F_п at the friction of a setting, m; by default the spec's own."""
        return self.law.torque_per_force(*setting.friction_at_setting(self.spec, method))

    def torque(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Sustained slip torque T, N·m (F11 (12))."""
        first, second = _pair(friction, friction_driven)
        return self.law.torque(self.closing_force, first, second)

    def normal_force(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Normal force N on the pairs, N; arguments as ``torque``."""
        _, second = _pair(friction, friction_driven)
        return self.law.normal_force(self.closing_force, second)

    def release_force(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Release force F_p of the control unit, N; arguments as ``torque``."""
        _, second = _pair(friction, friction_driven)
        return self.law.release_force(self.closing_force, second)

    def ball_torque(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Torque T_2 that passes the balls, N·m; arguments as ``torque``."""
        _, second = _pair(friction, friction_driven)
        return self.law.ball_torque(self.closing_force, second)

    def breakaway_torque(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Upper bound P of the breakaway torque, N·m (theory, section 3); arguments as ``torque``."""
        first, second = _pair(friction, friction_driven)
        if _is_zero(self.bypass_pairs):
            return self.torque(first, second)
        bypass: Values = self.law.bypass_torque(self.closing_force, first)
        if not self.spec.kind.controlled:
            return bypass
        return larger(bypass, self.torque(first, second))

    def _extremes(self, start: Literal["min", "mean"] = "min") -> tuple[Slip, Slip]:
        """At the ends: with one material the torque rises with f; with unlike ones it may also turn at the mean."""
        first, second = self.friction
        names = (start, "mean", "max") if self.spec.friction.unlike else (start, "max")
        points = ((getattr(first, name), getattr(second, name)) for name in names)
        slips = [(self.torque(*point), *point) for point in points]
        return extremes(slips) if self.spec.friction.unlike else (slips[0], slips[1])

    @property
    def accuracy_factor(self) -> Values:
        """K_т, largest over smallest torque along the common path of f_1 and f_2."""
        (_, *low), (_, *high) = self._extremes()
        factor: Values = accuracy.accuracy_factor(self.bypass_pairs, self.controlled_pairs, self.gain, *low, *high)
        return factor

    @property
    def accuracy_factor_worst_case(self) -> Values:
        """K_т over the rectangle of both ranges; T is monotone in each, so its extremes are corners."""
        first, second = self.friction
        corners = [self.torque(f1, f2) for f1 in (first.min, first.max) for f2 in (second.min, second.max)]
        low: Values = corners[0]
        high: Values = corners[0]
        for corner in corners[1:]:
            low, high = smaller(low, corner), larger(high, corner)
        factor: Values = accuracy.accuracy_factor_worst_case(high, low)
        return factor

    @property
    def accuracy_factor_peak(self) -> Values:
        """Largest over smallest breakaway torque: T falls with f_2 only where P > T, so that P rises with both."""
        first, second = self.friction
        peaks = (self.breakaway_torque(*ends) for ends in ((first.max, second.max), (first.min, second.min)))
        factor: Values = accuracy.accuracy_factor_peak(*peaks)
        return factor

    @property
    def gain_limit(self) -> Values | None:
        """Largest gain at which the law describes the whole slip, where the variant has one."""
        rule = self.spec.kind.gain_limit
        if rule is None:
            return None
        limit: Values = rule.gain(self.bypass_pairs, self.controlled_pairs, self.friction[0].max)
        return limit

    def ball_torque_by_gain(self) -> ByGain:
        """T_2 ∝ 1/(1 + z_2 f_2 C)."""
        return ByGain((1.0, 0.0), (1.0, float(self.reduced_gain / self.gain) * self.friction[1].max), 0.0)

    def sensitivity(self) -> dict[str, float]:
        """Elasticities ∂ln K_т/∂ln p by spec path, from the derivatives of the law where the extremes are."""
        (_, *low), (_, *high) = self._extremes()
        ways = [(sign, point, self._elasticities(*map(float, point))) for sign, point in ((-1, low), (1, high))]
        pairs, driving_pairs, gain = (
            sum(sign * slopes[name] for sign, _, slopes in ways) for name in ("pairs", "driving_pairs", "gain")
        )
        given, unlike = self.spec.friction, self.spec.friction.unlike
        paths = ("friction.driving", "friction.driven") if unlike else ("friction", "friction")
        found = {f"{path}.{end}": 0.0 for end in ("min", "max") for path in paths}
        for sign, point, slopes in ways:
            ends = ("min", "max", "mean") if sign < 0 else ("max", "min", "mean")
            for place, path in enumerate(paths):
                block = (given.driving, given.driven)[place] or given
                end = next(end for end in ends if getattr(block.range, end) == point[place])
                slope = slopes["friction_driven" if place else "friction_driving"]
                geometry.spread(found, block, path, end, sign * slope)
        found["friction_group.pairs"] = pairs
        if self.spec.kind.chooses_bypass:
            found["friction_group.driving_pairs"] = driving_pairs
        found |= geometry.gain_elasticities(self.spec, gain)
        return found | {geometry.force_path(self.spec): 0.0}

    def _elasticities(self, at_driving: float, at_driven: float) -> dict[str, float]:
        """∂ln T/∂ln p at one point."""
        z1, z2 = self.bypass_pairs, self.controlled_pairs
        driving = accuracy.torque_elasticity_in_friction_driving(z1, z2, at_driving, at_driven)
        driven = accuracy.torque_elasticity_in_friction_driven(z1, z2, self.gain, at_driving, at_driven)
        return {
            "friction_driving": driving,
            "friction_driven": driven,
            "gain": accuracy.torque_elasticity_in_gain(z2, self.gain, at_driven),
            **_pair_elasticities(float(z1), float(z2), driving, driven),
        }

    def _law_findings(self) -> list[Finding]:
        """Gain limits, idle feedback, a torque that falls with friction."""
        return [*self._gain_findings(), *self._path_findings()]

    def _gain_findings(self) -> list[Finding]:
        path = geometry.gain_path(self.spec)
        if self.spec.kind.controlled and self.gain == 0:
            return [finding("feedback-idle", "warning", value=0.0, limit=0.0, path=path)]
        rule, limit = self.spec.kind.gain_limit, self.gain_limit
        if rule is None or limit is None or self.gain <= limit * (1 + 1e-9):
            return []
        value, bound = map(float, rule.stated(self.gain, self.reduced_gain, limit))
        first, second = (own.max for own in self.friction)
        peak, sustained = self.breakaway_torque(first, second), self.torque(first, second)
        return [finding(rule.code, "warning", value=value, limit=bound, path=path, peak=peak, sustained=sustained)]

    def _path_findings(self) -> list[Finding]:
        first, second = self.friction
        most, at = float(self.torque_range.high), float(self.torque_range.at_high)
        factor = float(self.torque(first.max, second.max)) / most
        if factor >= 1:
            return []
        return [finding("torque-falls", "info", value=factor, limit=1.0, most=most, at=at)]


def _pair(friction: Values, friction_driven: Values | None) -> tuple[Values, Values]:
    first = checked_friction(friction)
    return first, first if friction_driven is None else checked_friction(friction_driven)


def _is_zero(pairs: Values) -> bool:
    return not is_array(pairs) and pairs == 0


def _pair_elasticities(bypass: float, controlled: float, driving: float, driven: float) -> dict[str, float]:
    """Elasticities in z (z_1 kept) and z_1 (z kept) from those in f_1 and f_2, which equal those in z_1 and z_2."""
    if bypass == 0:
        return {"pairs": driven, "driving_pairs": 0.0}
    if controlled == 0:
        return {"pairs": driving, "driving_pairs": 0.0}
    return {
        "pairs": (bypass + controlled) / controlled * driven,
        "driving_pairs": driving - bypass / controlled * driven,
    }
