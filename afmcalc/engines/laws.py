"""The two torque laws, as functions of the spring force and the friction; parameters are numbers or arrays.

A law knows neither a spec nor how the spring is set: engines, sweeps and searches ask the same one.
"""

from dataclasses import dataclass
from typing import Any

from ..arrays import Values, chosen, larger, smaller
from ..equations import direct, indirect
from .characteristic import CurvedSprings, root


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
    """Friction at which the control spring is set so that the sleeve just stays at its stop."""
    made_control_force: Values | None = None
    """F_п2 as made, N; None where it is set by S21 (14)."""
    curved: CurvedSprings | None = None
    """Springs whose force is not proportional to their deflection; None where both are straight."""

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
    def torque_per_force(self) -> Values:
        """T/F_п1 at the setting, m: there the pack is pressed by the closing spring alone."""
        per_force: Values = indirect.torque_per_force(self.pairs, self.mean_radius, self.friction_set)
        return per_force

    def control_force(self, closing_force: Values) -> Values:
        """F_п2, N: as made, or by S21 (14)."""
        if self.made_control_force is not None:
            return self.made_control_force
        force: Values = indirect.control_force(closing_force, self.pairs, self.net_gain, self.friction_set)
        return force

    def stiffness(self, friction: Values, net_gain: Values) -> Values:
        """D(f), N/m."""
        stiffness: Values = indirect.sleeve_stiffness(
            self.closing_stiffness, self.control_stiffness, self.pairs, friction, net_gain
        )
        return stiffness

    def is_seated(self, closing_force: Values, friction: Values, *, returning: bool = False) -> Any:
        """Whether the stop carries: the control spring has more over the closing one than the balls take."""
        if self.made_control_force is None and not returning:
            return friction < self.friction_set
        net = self.net_gain_returning if returning else self.net_gain
        return self.control_force(closing_force) > closing_force * (1 + self.pairs * net * friction)

    def normal_force(self, closing_force: Values, friction: Values, *, returning: bool = False) -> Values:
        """Normal force N on the pairs, N: F_п2/(1 + zκf) at the stop, then S21 (9); ``returning`` has κ₊ for κ."""
        net = self.net_gain_returning if returning else self.net_gain
        control = self.control_force(closing_force)

        def seated() -> Values:
            force: Values = indirect.normal_force_seated(control, self.pairs, net, friction)
            return force

        def moving() -> Values:
            if self.curved is not None:
                return smaller(closing_force, self._balanced(closing_force, friction, net)[1])
            springs = closing_force, self.closing_stiffness, control, self.control_stiffness
            force: Values = indirect.normal_force_moving(*springs, self.stiffness(friction, net))
            return smaller(closing_force, force)

        return chosen(self.is_seated(closing_force, friction, returning=returning), seated, moving)

    def torque(self, closing_force: Values, friction: Values) -> Values:
        """Slip torque T, N·m, friction rising (S21 (11); theory, section 5)."""
        pressed = self.normal_force(closing_force, friction)
        torque: Values = indirect.torque(pressed, self.mean_radius, self.pairs, friction)
        return torque

    def torque_returning(self, closing_force: Values, friction: Values, friction_max: Values) -> Values:
        """Torque when friction falls again from ``friction_max`` under load, N·m (theory, section 5).

        The key locks the sleeve where ``friction_max`` put it until f has fallen by κ₊/κ.
        """
        locked = self.normal_force(closing_force, friction_max)
        moving = self.normal_force(closing_force, friction, returning=True)
        torque: Values = indirect.torque(larger(locked, moving), self.mean_radius, self.pairs, friction)
        return torque

    def travel(self, closing_force: Values, friction: Values) -> Values:
        """Axial travel x of the sleeve, m; 0 at the stop (S21 (10), (16))."""

        def moved() -> Values:
            if self.curved is not None:
                return self._balanced(closing_force, friction, self.net_gain)[0]
            net, made = self.net_gain, self.made_control_force
            stiffness = self.stiffness(friction, net)
            travel: Values = (
                indirect.travel(self.pairs, closing_force, friction, self.friction_set, net, stiffness)
                if made is None
                else indirect.travel_as_made(closing_force, made, self.pairs, friction, net, stiffness)
            )
            return travel

        return chosen(self.is_seated(closing_force, friction), lambda: 0.0, moved)

    def _balanced(self, closing_force: Values, friction: Values, net: Values) -> tuple[Values, Values]:
        """Travel of a sleeve between curved springs, and the normal force there: N(x)(1 + zκf) = F_2(x)."""
        assert self.curved is not None
        closing, control = self.curved
        held, loop = self.control_force(closing_force), 1 + self.pairs * net * friction
        reach = closing_force / self.closing_stiffness if closing is None else closing.deflection(closing_force)
        start = None if control is None else control.deflection(held)

        def pressed(travel: Values) -> Values:
            return closing_force - self.closing_stiffness * travel if closing is None else closing.force(reach - travel)

        def pushed(travel: Values) -> Values:
            if control is None or start is None:
                return held + self.control_stiffness * travel
            return control.force(start + travel)

        def slope(travel: Values) -> Values:
            first = self.closing_stiffness if closing is None else closing.stiffness(reach - travel)
            second = self.control_stiffness if control is None or start is None else control.stiffness(start + travel)
            return second + first * loop

        travel = root(lambda at: pushed(at) - pressed(at) * loop, slope, reach + 0.0 * loop)
        return travel, pressed(travel)
