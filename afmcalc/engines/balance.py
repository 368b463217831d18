"""A sleeve between two springs of any characteristic, behind walls straight or curved: where it is in balance."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from ..equations import curved
from ..equations.arrays import Floats, Values, chosen, quiet_division, smaller
from .characteristics import SetSpring, root

_PLACES = 32
"""Places among which a wall that lets the sleeve jump is searched for the first balance."""
_HALVINGS = 45
_ROUNDING = 1e-12


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
    """True if C_1 is nought: then there is but one balance."""

    @cached_property
    def nought(self) -> Values:
        """0 in the common shape of all that the balance depends on but friction."""
        straight = (spring.straight_stiffness for spring in (self.closing, self.control) if spring.disc is None)
        return 0.0 * math.prod(
            (self.net_gain, self.gain_slope, self.closing.set_force, self.control.set_force, *straight)
        )

    def pressed(self, travel: Values) -> Values:
        """Normal force N, N."""
        return self.closing.force(-travel)

    def net_gain_at(self, travel: Values) -> Values:
        """κ where the sleeve is."""
        return self.net_gain if self.straight else curved.gain_acting(self.net_gain, self.gain_slope, travel)

    def _left(self, friction: Values) -> Callable[[Values], Values]:
        """Force of the control spring less that of closing spring and balls, N."""
        return lambda at: self.control.force(at) - self.pressed(at) * (1 + self.pairs * self.net_gain_at(at) * friction)

    def _slope(self, friction: Values) -> Callable[[Values], Values]:
        def slope(at: Values) -> Values:
            loop = 1 + self.pairs * self.net_gain_at(at) * friction
            slope = self.control.stiffness(at) + self.closing.stiffness(-at) * loop
            if self.straight:
                return slope
            return slope - self.pressed(at) * curved.slope_feedback(self.pairs, friction, self.gain_slope)

        return slope

    def travel(self, friction: Values) -> Values:
        """Where the sleeve comes to from its stop, friction rising, m: the first place that holds it."""
        left = self._left(friction)
        if self.straight:
            end = self.closing.deflection + 0.0 * (self.net_gain * friction)
            return root(left, self._slope(friction), end)
        tried = self._tried(self.closing.deflection, friction)
        # at the stop itself it is not: a steep wall lets it jump off from there
        holds: Any = (left(tried) >= 0) & (tried > 0)
        low, high = _first(tried, holds)
        return root(left, self._slope(friction), high, low)

    def travel_returning(self, friction: Values, start: Values) -> Values:
        """Where it comes back to from ``start``, friction falling, m: the last place that holds it; 0 at the stop."""
        if self.straight:
            return smaller(self.travel(friction), start)
        left = self._left(friction)
        tried = self._tried(start, friction)[::-1]
        holds: Any = left(tried) <= 0
        high, low = _first(tried, holds)
        slope = self._slope(friction)
        return chosen(holds.any(axis=0), lambda: root(left, slope, high, low), lambda: 0.0 * tried[0])

    def _tried(self, end: Values, friction: Values) -> Floats:
        """Places up to ``end`` between which the friction that holds the sleeve does not turn, for each friction."""
        import numpy as np

        grid = places(end + self.nought, _PLACES)
        with np.errstate(all="ignore"):  # nothing presses where the closing spring is let out
            found = np.sort(np.concatenate([grid, turned(self._friction_slope, grid)]), axis=0)
        found = found.reshape(len(found), *(1,) * max(np.ndim(friction) - np.ndim(grid[0]), 0), *found.shape[1:])
        return found + 0.0 * friction

    def _friction_slope(self, travel: Values) -> Values:
        """Of the sign of df/dx where the sleeve is held."""
        return self._slope(self.friction(travel))(travel)

    def friction(self, travel: Values) -> Values:
        """Friction that holds the sleeve at a travel."""
        with quiet_division(travel):  # where the balls move nothing none does
            return (self.control.force(travel) / self.pressed(travel) - 1) / (self.pairs * self.net_gain_at(travel))

    def way(self, start: Values, end: Values) -> Floats:
        """Places that hold the sleeve on its way as friction changes, along a first axis.

        Among them is every one where the torque turns, and those between which the sleeve jumps.
        """
        import numpy as np

        ahead = np.where(np.asarray(end) >= start, 1.0, -1.0)

        def torque_slope(at: Floats) -> Values:
            """T = R (F_2 − N)/κ."""
            pressed, control = self.pressed(at), self.control.force(at)
            stiffness = self.control.stiffness(at) + self.closing.stiffness(-at)
            return stiffness * self.net_gain_at(at) - self.gain_slope * (control - pressed)

        def ordered(*places: Floats) -> tuple[Floats, Floats, Floats]:
            """Places in the order of the way, friction there, and the farthest that friction has gone before."""
            way = np.sort(ahead * np.concatenate(places), axis=0) * ahead
            friction = ahead * self.friction(way)
            return way, friction, np.maximum.accumulate(friction, axis=0)

        tried = start + places(end - start, _PLACES)
        way, friction, farthest = ordered(
            tried, *(turned(slope, tried) for slope in (torque_slope, self._friction_slope))
        )
        if (friction < farthest).any():
            landed = turned(lambda at: ahead * self.friction(at) - farthest[:-1], way)
            way, friction, farthest = ordered(way, landed)
        return np.where(friction >= farthest - _ROUNDING * np.abs(farthest), way, way[0])


def turned(function: Callable[[Floats], Values], at: Floats) -> Floats:
    """Where a function has changed its sign between one place and the next along a first axis, else the former."""
    import numpy as np

    low, sign = at[:-1], function(at[:-1]) > 0
    high = np.where(sign == (function(at[1:]) > 0), low, at[1:])
    for _ in range(_HALVINGS if (low != high).any() else 0):
        middle = (low + high) / 2
        before = (function(middle) > 0) == sign
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    return high


def places(end: Values, count: int) -> Floats:
    """From 0 to ``end`` in so many steps, along a first axis."""
    import numpy as np

    return np.multiply.outer(np.linspace(0.0, 1.0, count + 1), end)


def _first(tried: Floats, good: Any) -> tuple[Values, Values]:
    """The place before the first good one, and that one."""
    import numpy as np

    first = np.argmax(good, axis=0)[None]
    before, there = (np.take_along_axis(tried, np.maximum(first - each, 0), axis=0)[0] for each in (1, 0))
    return before, there
