"""The torque law of a direct clutch, as functions of the spring force and the friction: numbers or arrays."""

from dataclasses import dataclass
from typing import Any

from ..arrays import Values
from ..equations import direct


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

    def torque_per_force(self, driving: Values, driven: Values) -> Any:
        """T/F_п, m."""
        return direct.torque_per_force(
            self.mean_radius, self.bypass_pairs, self.controlled_pairs, self.gain, driving, driven
        )

    def torque(self, closing_force: Values, driving: Values, driven: Values) -> Any:
        """Sustained slip torque T, N·m."""
        return direct.torque(
            closing_force, self.mean_radius, self.bypass_pairs, self.controlled_pairs, self.gain, driving, driven
        )

    def normal_force(self, closing_force: Values, driven: Values) -> Any:
        """Normal force N on the pairs, N."""
        return direct.normal_force(closing_force, self.controlled_pairs, self.gain, driven)

    def release_force(self, closing_force: Values, driven: Values) -> Any:
        """Release force F_p, N."""
        return direct.release_force(closing_force, self.controlled_pairs, self.gain, driven)

    def ball_torque(self, closing_force: Values, driven: Values) -> Any:
        """Torque T_2 that passes the balls, N·m."""
        pressed = self.normal_force(closing_force, driven)
        return direct.group_torque(pressed, self.mean_radius, self.controlled_pairs, driven)

    def bypass_torque(self, closing_force: Values, driving: Values) -> Any:
        """Torque of the bypass pairs under the full spring force, N·m."""
        return direct.group_torque(closing_force, self.mean_radius, self.bypass_pairs, driving)
