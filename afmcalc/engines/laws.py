"""The two torque laws, as functions of the spring force and the friction; parameters are numbers or arrays.

A law knows neither a spec nor how the spring is set: engines, sweeps and searches ask the same one.
"""

from dataclasses import dataclass
from typing import Any

from ..arrays import Values, larger, smaller
from ..equations import direct, indirect


@dataclass(frozen=True)
class DirectLaw:
    """The release force acts on the pack itself; the variants differ in their pair counts."""

    mean_radius: Values
    """R_cp, m."""
    bypass_pairs: Values
    """z_1."""
    controlled_pairs: Values
    """z_2."""
    gain: Values
    """C."""

    @property
    def reduced_gain(self) -> Values:
        """z_2 C."""
        reduced: Values = direct.reduced_gain(self.controlled_pairs, self.gain)
        return reduced

    def torque_per_force(self, driving: Any, driven: Any) -> Any:
        """T/F_п, m."""
        return direct.torque_per_force(
            self.mean_radius, self.bypass_pairs, self.controlled_pairs, self.gain, driving, driven
        )

    def torque(self, closing_force: Any, driving: Any, driven: Any) -> Any:
        """Sustained slip torque T, N·m."""
        return direct.torque(
            closing_force, self.mean_radius, self.bypass_pairs, self.controlled_pairs, self.gain, driving, driven
        )

    def normal_force(self, closing_force: Any, driven: Any) -> Any:
        """Normal force N on the pairs, N."""
        return direct.normal_force(closing_force, self.controlled_pairs, self.gain, driven)

    def release_force(self, closing_force: Any, driven: Any) -> Any:
        """Release force F_p, N."""
        return direct.release_force(closing_force, self.controlled_pairs, self.gain, driven)

    def ball_torque(self, closing_force: Any, driven: Any) -> Any:
        """Torque T_2 that passes the balls, N·m."""
        pressed = self.normal_force(closing_force, driven)
        return direct.group_torque(pressed, self.mean_radius, self.controlled_pairs, driven)

    def bypass_torque(self, closing_force: Any, driving: Any) -> Any:
        """Torque of the bypass pairs under the full spring force, N·m."""
        return direct.group_torque(closing_force, self.mean_radius, self.bypass_pairs, driving)


@dataclass(frozen=True)
class IndirectLaw:
    """The release force moves a thrust sleeve between two springs; friction at its key resists (S21)."""

    mean_radius: Values
    """R_cp, m."""
    pairs: Values
    """z."""
    gain: Values
    """C."""
    closing_stiffness: Values
    """c_1, N/m."""
    control_stiffness: Values
    """c_2, N/m."""
    key_friction: Values
    """f_1 at the key."""
    hub_diameter: Values
    """d, m."""
    friction_set: Values
    """Friction at which the sleeve just stays at its stop."""

    @property
    def reduced_gain(self) -> Values:
        """z C."""
        return self.pairs * self.gain

    @property
    def gain_threshold(self) -> Values:
        """2 R f_1/d: the gain at which feedback begins."""
        threshold: Values = indirect.gain_threshold(self.mean_radius, self.key_friction, self.hub_diameter)
        return threshold

    @property
    def net_gain(self) -> Values:
        """κ, moving off the stop."""
        net: Values = indirect.net_gain(self.gain, self.mean_radius, self.key_friction, self.hub_diameter)
        return net

    @property
    def net_gain_returning(self) -> Values:
        """κ₊, moving back."""
        net: Values = indirect.net_gain_returning(self.gain, self.mean_radius, self.key_friction, self.hub_diameter)
        return net

    @property
    def torque_per_force(self) -> Any:
        """T/F_п1 at the setting, m: the sleeve rests, so the pack is pressed by the closing spring."""
        return indirect.torque_per_force(self.pairs, self.mean_radius, self.friction_set)

    def control_force(self, closing_force: Any) -> Any:
        """F_п2, N (S21 (14))."""
        return indirect.control_force(closing_force, self.pairs, self.net_gain, self.friction_set)

    def stiffness(self, friction: Any, net_gain: Any) -> Any:
        """D(f), N/m."""
        return indirect.sleeve_stiffness(self.closing_stiffness, self.control_stiffness, self.pairs, friction, net_gain)

    def moving_force(self, closing_force: Any, friction: Any, net_gain: Any) -> Any:
        """Normal force with the sleeve moving, N; κ or κ₊ in force."""
        return indirect.normal_force_moving(
            closing_force,
            self.closing_stiffness,
            self.control_force(closing_force),
            self.control_stiffness,
            self.stiffness(friction, net_gain),
        )

    def normal_force(self, closing_force: Any, friction: Any) -> Any:
        """Normal force N on the pairs, N: F_п1 at the stop, then falling (S21 (9))."""
        return smaller(closing_force, self.moving_force(closing_force, friction, self.net_gain))

    def torque(self, closing_force: Any, friction: Any) -> Any:
        """Slip torque T, N·m, friction rising (S21 (11))."""
        return direct.group_torque(self.normal_force(closing_force, friction), self.mean_radius, self.pairs, friction)

    def torque_returning(self, closing_force: Any, friction: Any, friction_max: Any) -> Any:
        """Torque when friction falls again from ``friction_max`` under load, N·m (theory, section 5)."""
        locked = self.normal_force(closing_force, friction_max)
        moving = larger(locked, self.moving_force(closing_force, friction, self.net_gain_returning))
        return direct.group_torque(smaller(closing_force, moving), self.mean_radius, self.pairs, friction)

    def travel(self, closing_force: Any, friction: Any) -> Any:
        """Axial travel x of the sleeve, m; 0 at the stop (S21 (16))."""
        net = self.net_gain
        stiffness = self.stiffness(friction, net)
        moved = indirect.travel(self.pairs, closing_force, friction, self.friction_set, net, stiffness)
        return larger(0.0, moved)
