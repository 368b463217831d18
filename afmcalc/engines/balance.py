"""A sleeve between two springs of any characteristic, behind walls straight or curved: where it is in balance."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from ..arrays import Values, chosen, larger, smaller
from ..equations import pocket
from .characteristic import DiscCharacteristic, root

_PLACES = 32
"""Places among which a wall that lets the sleeve jump is searched for the first balance."""
_FINE = 256
"""Places among which the extremes of torque are looked for: the sum of their steps squared is what is missed."""


@dataclass(frozen=True)
class SetSpring:
    """A spring as it is set; without a disc it is straight."""

    set_force: Values
    """N."""
    straight_stiffness: Values
    """N/m."""
    disc: DiscCharacteristic | None

    @cached_property
    def deflection(self) -> Values:
        """As set, m."""
        return self.set_force / self.straight_stiffness if self.disc is None else self.disc.deflection(self.set_force)

    def force(self, further: Values) -> Values:
        """Force when pressed together so much further than as set, N."""
        if self.disc is None:
            return self.set_force + self.straight_stiffness * further
        return self.disc.force(self.deflection + further)

    def stiffness(self, further: Values) -> Values:
        """Slope of the force there, N/m."""
        return self.straight_stiffness if self.disc is None else self.disc.stiffness(self.deflection + further)

    def secant(self, further: Values) -> Values:
        """Change of the force per deflection from as set, N/m."""
        if self.disc is None:
            return self.straight_stiffness
        return (self.force(further) - self.set_force) / further

    def slackens(self, force: Values) -> Values:
        """How far it lengthens until so much force is left, m."""
        if self.disc is None:
            return (self.set_force - force) / self.straight_stiffness
        return self.deflection - self.disc.deflection(force)


@dataclass(frozen=True)
class Balance:
    """N(x)(1 + zκ(x)f) = F_2(x), with the net gain κ(x) = κ_0 + C_1 x."""

    closing: SetSpring
    control: SetSpring
    pairs: Values
    net_gain: Values
    """κ_0, or κ₊ where the sleeve returns."""
    gain_slope: Values
    """C_1, 1/m."""
    straight: bool
    """Whether C_1 is nought: then there is but one balance."""

    def pressed(self, travel: Values) -> Values:
        """Normal force N, N."""
        return self.closing.force(-travel)

    def net_gain_at(self, travel: Values) -> Values:
        """κ where the sleeve is."""
        if self.straight:
            return self.net_gain
        gain: Values = pocket.gain_at(self.net_gain, self.gain_slope, travel)
        return gain

    def _left(self, friction: Values) -> Callable[[Values], Values]:
        """What the control spring has more than closing spring and balls, N."""
        return lambda at: self.control.force(at) - self.pressed(at) * (1 + self.pairs * self.net_gain_at(at) * friction)

    def _slope(self, friction: Values) -> Callable[[Values], Values]:
        def slope(at: Values) -> Values:
            loop = 1 + self.pairs * self.net_gain_at(at) * friction
            found: Values = self.control.stiffness(at) + self.closing.stiffness(-at) * loop
            if not self.straight:
                found = found - self.pressed(at) * pocket.slope_feedback(self.pairs, friction, self.gain_slope)
            return found

        return slope

    def travel(self, friction: Values) -> Values:
        """Where the sleeve comes to from its stop, friction rising, m: the first place that holds it."""
        left, end = self._left(friction), self.closing.deflection + 0.0 * (self.net_gain * friction)
        if self.straight:
            return root(left, self._slope(friction), end)
        low, high, found = 0.0 * end, end, end < 0
        for place in range(1, _PLACES + 1):
            at, before = end * (place / _PLACES), end * ((place - 1) / _PLACES)
            first = (left(at) >= 0) > found
            low, high = _where(first, before, low), _where(first, at, high)
            found = found | first
        return root(left, self._slope(friction), high, low)

    def travel_returning(self, friction: Values, start: Values) -> Values:
        """Where it comes back to from ``start``, friction falling, m: the last place that holds it; 0 at the stop."""
        left = self._left(friction)
        start = start + 0.0 * (self.net_gain * friction)
        low, high, found = 0.0 * start, 0.0 * start, start < 0
        for place in range(_PLACES, -1, -1):
            at, behind = start * (place / _PLACES), start * (min(place + 1, _PLACES) / _PLACES)
            last = (left(at) <= 0) > found
            low, high = _where(last, at, low), _where(last, behind, high)
            found = found | last
        return root(left, self._slope(friction), high, low)

    def torques(self, start: Values, end: Values, mean_radius: Values, *, rises: bool) -> tuple[Values, Values]:
        """Least and largest torque between two travels, N·m, at places where friction that rises, or falls, leads."""
        reached = least = most = None
        for place in range(_FINE + 1):
            at = start + (end - start) * (place / _FINE)
            pressed, gain = self.pressed(at), self.net_gain_at(at)
            torque = mean_radius * (self.control.force(at) - pressed) / gain
            friction = torque / (mean_radius * pressed) * (1 if rises else -1)
            if reached is None or least is None or most is None:
                reached, least, most = friction, torque, torque
                continue
            here = friction >= reached
            least, most = _where(here, smaller(least, torque), least), _where(here, larger(most, torque), most)
            reached = larger(reached, friction)
        assert least is not None
        assert most is not None
        return least, most


def _where(condition: object, yes: Values, no: Values) -> Values:
    return chosen(condition, lambda: yes, lambda: no)
