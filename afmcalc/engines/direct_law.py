"""The torque law of a direct clutch, as functions of the spring force and the friction: numbers or arrays."""

from dataclasses import dataclass

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

    def torque_per_force(self, driving: Values, driven: Values) -> Values:
        """T/F_п, m."""
        found: Values = direct.torque_per_force(
            self.mean_radius, self.bypass_pairs, self.controlled_pairs, self.gain, driving, driven
        )
        return found

    def torque(self, closing_force: Values, driving: Values, driven: Values) -> Values:
        """Sustained slip torque T, N·m."""
        found: Values = direct.torque(
            closing_force, self.mean_radius, self.bypass_pairs, self.controlled_pairs, self.gain, driving, driven
        )
        return found

    def normal_force(self, closing_force: Values, driven: Values) -> Values:
        """Normal force N on the pairs, N."""
        found: Values = direct.normal_force(closing_force, self.controlled_pairs, self.gain, driven)
        return found

    def release_force(self, closing_force: Values, driven: Values) -> Values:
        """Release force F_p, N."""
        found: Values = direct.release_force(closing_force, self.controlled_pairs, self.gain, driven)
        return found

    def ball_torque(self, closing_force: Values, driven: Values) -> Values:
        """Torque T_2 that passes the balls, N·m."""
        pressed = self.normal_force(closing_force, driven)
        found: Values = direct.group_torque(pressed, self.mean_radius, self.controlled_pairs, driven)
        return found

    def bypass_torque(self, closing_force: Values, driving: Values) -> Values:
        """Torque of the bypass pairs under the full spring force, N·m."""
        found: Values = direct.group_torque(closing_force, self.mean_radius, self.bypass_pairs, driving)
        return found
