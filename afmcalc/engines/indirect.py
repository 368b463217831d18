"""Engine of indirect regulation: a thrust sleeve between two springs (S21)."""

from dataclasses import replace
from typing import Literal

from ..arrays import Values, checked_friction, is_array, larger, smaller
from ..equations import accuracy, indirect
from ..findings import Finding
from ..messages import say
from ..spec.models import Method, Spec
from . import geometry, pockets, setting
from .characteristic import DiscCharacteristic, curved
from .laws import IndirectLaw
from .protocol import ByGain, Clutch, Slip, extremes
from .sensitivity import sensitivity
from .sleeve_findings import sleeve_findings


class IndirectClutch(Clutch):
    """Clutch whose release force slackens the closing spring by way of a sleeve."""

    law: IndirectLaw

    @classmethod
    def from_spec(cls, spec: Spec) -> "IndirectClutch":
        """Build the engine of a spec whose values may be arrays.

        Raises:
            SpecError: a gain below the threshold 2 R f_1/d.
        """
        unit, control = spec.control_unit, spec.control_spring
        assert unit is not None
        assert control is not None
        law = IndirectLaw(
            mean_radius=geometry.mean_radius(spec),
            pairs=spec.friction_group.pairs,
            gain=geometry.feedback_gain(spec),
            closing_stiffness=_given(spec.closing_spring.stiffness),
            control_stiffness=control.stiffness,
            key_friction=_given(unit.key_friction),
            hub_diameter=_given(unit.hub_diameter),
            friction_set=setting.friction_at_setting(spec)[0],
            made_control_force=control.force,
            curved=curved(spec),
        )
        pockets.refuse_negative_net_gain(spec, law)
        force = setting.closing_force(spec, lambda: law.torque_per_force)
        return cls(spec, replace(law, gain_slope=pockets.gain_slope(spec, law, force)), spec.friction.groups, force)

    @property
    def pairs(self) -> Values:
        """z."""
        return self.law.pairs

    @property
    def closing_stiffness(self) -> Values:
        """c_1, N/m."""
        return self.law.closing_stiffness

    @property
    def following(self) -> tuple[Values | None, DiscCharacteristic | None]:
        """The control spring: the stop is the pressure disc's, which takes sleeve and closing spring along."""
        return self.law.control_stiffness, None if self.law.curved is None else self.law.curved.control

    @property
    def control_stiffness(self) -> Values:
        """c_2, N/m."""
        return self.law.control_stiffness

    @property
    def gain_threshold(self) -> Values:
        """2 R f_1/d: the gain at which feedback begins."""
        return self.law.gain_threshold

    @property
    def net_gain(self) -> Values:
        """κ, moving off the stop."""
        return self.law.net_gain

    @property
    def net_gain_returning(self) -> Values:
        """κ₊, moving back."""
        return self.law.net_gain_returning

    @property
    def gain_slope(self) -> Values:
        """C_1 of the pockets, 1/m."""
        return self.law.gain_slope

    @property
    def constant_torque_slope(self) -> Values:
        """C_1* at which torque would not depend on friction once the sleeve is off its stop, 1/m."""
        return self.law.constant_torque_slope(self.closing_force, self.friction[0].max)

    @property
    def friction_set(self) -> Values:
        """Friction at the setting."""
        return self.law.friction_set

    @property
    def leaving_friction(self) -> Values:
        """Friction at which the sleeve leaves its stop."""
        return self.law.leaving_friction(self.closing_force)

    def torque_per_force(self, method: Method | None = None) -> Values:
        """T/F_п1 at the friction of a setting, m; by default the spec's own."""
        return replace(self.law, friction_set=setting.friction_at_setting(self.spec, method)[0]).torque_per_force

    @property
    def bypass_pairs(self) -> Values:
        """z_1 = 0: all torque passes the balls."""
        return 0

    @property
    def control_force(self) -> Values:
        """F_п2, N (S21 (14))."""
        force: Values = self.law.control_force(self.closing_force)
        return force

    @property
    def equivalent_gain(self) -> Values | None:
        """Gain of the all-driving clutch with the same torque curve; curved springs or pockets have no such twin."""
        if self.law.curved is not None or not self.law.straight:
            return None
        gain: Values = indirect.equivalent_gain(self.net_gain, self.closing_stiffness, self.control_stiffness)
        return gain

    def normal_force(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Normal force N on the pairs, N: from F_п2 at rest down to F_п1 at the setting, then by S21 (9)."""
        return self.law.normal_force(self.closing_force, _one(friction, friction_driven))

    @property
    def pack_force_at_rest(self) -> Values:
        """Force on the pack of the clutch at rest, N: what the control spring presses through sleeve and stop."""
        return self.law.normal_force(self.closing_force, 0.0)

    def torque(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Slip torque T, N·m, friction rising (S21 (11); at the stop a direct clutch of gain κ)."""
        return self.law.torque(self.closing_force, _one(friction, friction_driven))

    def torque_returning(self, friction: Values) -> Values:
        """Torque when friction falls again from f_max under load, N·m (theory, section 5).

        The key's friction holds the sleeve where f_max put it until f has fallen by κ₊/κ; then it moves back.
        """
        friction = checked_friction(friction)
        return self.law.torque_returning(self.closing_force, friction, self.friction[0].max)

    def release_force(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Release force F_p of the balls on the sleeve, N."""
        gain = self.gain if self.law.straight else self.law.gain_at(self.travel(friction))
        found: Values = indirect.release_force(self.torque(friction, friction_driven), gain, self.mean_radius)
        return found

    def travel(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Axial travel x of the sleeve, m; 0 at the stop (S21 (16))."""
        friction = _one(friction, friction_driven)
        return self.law.travel(self.closing_force, friction)

    def ball_torque(self, friction: Values, friction_driven: Values | None = None) -> Values:
        """Torque that passes the balls, N·m: all of it."""
        return self.torque(friction, friction_driven)

    @property
    def accuracy_factor(self) -> Values:
        """K_т (S21 (15), with the stop)."""
        own = self.friction[0]
        if self.law.made_control_force is not None or self.law.curved is not None or not self.law.straight:
            ratio: Values = accuracy.accuracy_factor_of_torques(self.torque_max, self.torque_min)
            return ratio
        factor: Values = indirect.accuracy_factor(
            own.min,
            self.friction_set,
            own.max,
            self.closing_stiffness,
            self.control_stiffness,
            self.pairs,
            self.net_gain,
        )
        return factor

    @property
    def accuracy_factor_hysteresis(self) -> Values:
        """K_т under a load that lasts: friction falls from f_max to f_min, the key holding the sleeve back."""
        factor: Values = indirect.accuracy_factor_hysteresis(self.torque_max, self.torque_returning_min)
        return factor

    def _extremes(self, start: Literal["min", "mean"] = "min") -> tuple[Slip, Slip]:
        """At the ends: the torque rises with friction; a curved pocket may let it fall, or the sleeve jump."""
        low, high = getattr(self.friction[0], start), self.friction[0].max
        first, last = (self.torque(low), low), (self.torque(high), high)
        if self.law.straight:
            return first, last
        leaving = smaller(larger(self.leaving_friction, low), high)
        between = self.law.turns_rising(self.closing_force, low, high) if self._bent else []
        return extremes([first, (self.torque(leaving), leaving), *between, last])

    @property
    def _bent(self) -> bool:
        """Whether springs and walls are both curved: the torque may then have its extremes anywhere."""
        return self.law.curved is not None and not self.law.straight

    @property
    def torque_returning_min(self) -> Values:
        """Smallest torque as friction falls from f_max to f_min under load, N·m.

        At f_min, unless a curved pocket lets the torque rise from where the sleeve begins to return.
        """
        own = self.friction[0]
        least: Values = self.torque_returning(own.min)
        if self.law.straight:
            return least
        least = smaller(least, self.torque_returning(larger(own.max / self.hysteresis_ratio, own.min)))
        if not self._bent:
            return least
        return smaller(least, self.law.least_returning(self.closing_force, own.min, own.max))

    @property
    def hysteresis_ratio(self) -> Values:
        """How many times friction must fall from f_max before the sleeve returns, κ₊/κ where it is."""
        there = self.law if self.law.straight else self.law.steepened(self.travel(self.friction[0].max))
        ratio: Values = indirect.hysteresis_ratio(there.net_gain, there.net_gain_returning)
        return ratio

    @property
    def nominal_torque_ratio(self) -> Values:
        """K_п against the base clutch of equal spring and gain, all pairs controlled."""
        at_setting = self.pairs, self.gain, self.friction_set
        ratio: Values
        if self.law.made_control_force is None:
            ratio = indirect.nominal_torque_ratio(*at_setting)
        else:
            pressed = self.normal_force(self.friction_set)
            ratio = indirect.nominal_torque_ratio_as_made(*at_setting, pressed, self.closing_force)
        return ratio

    def ball_torque_by_gain(self) -> ByGain | None:
        """T ∝ D(f_set)/D(f_max), with F_п2 as made 1/D(f_max); D = (c_1 + c_2 − z c_1 f·threshold) + (z c_1 f)·C."""
        if not self.law.straight:
            return None
        springs = float(self.closing_stiffness + self.control_stiffness)
        start = float(self.gain_threshold)
        slopes = [
            float(self.pairs * self.closing_stiffness) * f for f in (float(self.friction_set), self.friction[0].max)
        ]
        at_set, at_max = (((springs - slope * start) / springs, slope / springs) for slope in slopes)
        return ByGain(at_set if self.law.made_control_force is None else (1.0, 0.0), at_max, start)

    def sensitivity(self) -> dict[str, float]:
        """Elasticities ∂ln K_т/∂ln p by spec path."""
        return sensitivity(self.spec, self.law, self.closing_force, self.torque_range)

    def _law_findings(self) -> list[Finding]:
        """Springs that are curved, idle feedback, the key's hysteresis, a pocket that lets the torque fall."""
        return sleeve_findings(self, self.law, lambda: self.hysteresis_ratio)


def _given(value: Values | None) -> Values:
    """Return a value that the rules of the spec require of this variant."""
    assert value is not None
    return value


def _one(friction: Values, friction_driven: Values | None) -> Values:
    """Return the one friction of all pairs."""
    friction = checked_friction(friction)
    if friction_driven is None or friction_driven is friction:
        return friction
    same = friction == checked_friction(friction_driven)
    if not (bool(same.all()) if is_array(same) else same):
        raise ValueError(say("an indirect clutch has one friction for all pairs"))
    return friction
