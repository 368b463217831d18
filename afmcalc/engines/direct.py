"""Engine of direct regulation: one law, the variants are pair counts."""

from ..arrays import Values, checked_friction, is_array, larger, smaller
from ..equations import accuracy, direct
from ..findings import Finding, finding
from ..spec.models import Method, Spec
from . import geometry, setting
from .direct_law import DirectLaw
from .protocol import ByGain, Clutch


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

    @property
    def _factor(self) -> Values:
        """T(f_max)/T(f_min) along the common path, below 1 where the torque falls."""
        first, second = self.friction
        factor: Values = accuracy.accuracy_factor(
            self.bypass_pairs, self.controlled_pairs, self.gain, first.min, second.min, first.max, second.max
        )
        return factor

    @property
    def accuracy_factor(self) -> Values:
        """K_т, largest over smallest torque along the common path of f_1 and f_2."""
        factor = self._factor
        # with one material the law rises with f (its slope has the sign of z_1 + z_2), so only unlike ones can fall
        return larger(factor, 1 / factor) if self.spec.friction.unlike else factor

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
        """Largest over smallest breakaway torque; P rises along the common path."""
        first, second = self.friction
        peaks = (self.breakaway_torque(*ends) for ends in ((first.max, second.max), (first.min, second.min)))
        factor: Values = accuracy.accuracy_factor_peak(*peaks)
        return factor

    @property
    def torque_max(self) -> Values:
        """Largest sustained torque along the common path, N·m."""
        first, second = self.friction
        high: Values = self.torque(first.max, second.max)
        return larger(high, self.torque(first.min, second.min)) if self.spec.friction.unlike else high

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
        """Elasticities ∂ln K_т/∂ln p by spec path, from the derivatives of the law."""
        first, second = self.friction
        sign = 1.0 if not self.spec.friction.unlike or self._factor >= 1 else -1.0
        slopes_low, slopes_high = self._elasticities(first.min, second.min), self._elasticities(first.max, second.max)
        shared = {name: sign * (slopes_high[name] - slopes_low[name]) for name in ("pairs", "driving_pairs", "gain")}
        found: dict[str, float] = {}
        for end, slopes, way in (("min", slopes_low, -sign), ("max", slopes_high, sign)):
            if self.spec.friction.unlike:
                found[f"friction.driving.{end}"] = way * slopes["friction_driving"]
                found[f"friction.driven.{end}"] = way * slopes["friction_driven"]
            else:
                found[f"friction.{end}"] = way * (slopes["friction_driving"] + slopes["friction_driven"])
        found["friction_group.pairs"] = shared["pairs"]
        if self.spec.kind.chooses_bypass:
            found["friction_group.driving_pairs"] = shared["driving_pairs"]
        found |= geometry.gain_elasticities(self.spec, shared["gain"])
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
        if not self.spec.friction.unlike or self._factor >= 1:
            return []
        return [finding("torque-falls", "info", value=float(self._factor), limit=1.0)]


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
