"""Equilibrium of a sleeve between two springs of any characteristic, behind straight or curved walls."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ..equations import curved
from ..equations.arrays import Floats, Values, chosen, quotient, smaller
from .characteristics import SetSpring, root

_PLACES = 32
"""Number of intervals into which the travel behind a curved wall is divided to search for equilibria."""
_HALVINGS = 45
_ROUNDING = 1e-12


@dataclass(frozen=True)
class Balance:
    """Balance of the forces on the sleeve, N(x)(1 + zκ(x)f) = F_2(x), with the net gain κ(x) = κ_0 + C_1 x."""

    closing: SetSpring
    control: SetSpring
    pairs: Values
    net_gain: Values
    """Net gain at the stop: κ, or κ₊ for a sleeve that moves back."""
    gain_slope: Values
    """Slope C_1 of the gain over the travel, 1/m."""
    straight: bool
    """True if C_1 = 0 (straight walls): then there is only one equilibrium."""

    @cached_property
    def nought(self) -> Values:
        """Zeros in the shape to which all values of the balance except friction broadcast."""
        straight = (spring.straight_stiffness for spring in (self.closing, self.control) if spring.disc is None)
        return 0.0 * math.prod(
            (self.net_gain, self.gain_slope, self.closing.set_force, self.control.set_force, *straight)
        )

    def pressed(self, travel: Values) -> Values:
        """Normal force on the pack at a travel, N."""
        return self.closing.force(-travel)

    def net_gain_at(self, travel: Values) -> Values:
        """Net gain κ at a travel."""
        return self.net_gain if self.straight else curved.gain_acting(self.net_gain, self.gain_slope, travel)

    def _left(self, friction: Values) -> Callable[[Values], Values]:
        """Function of travel: residual of the balance at a friction, F_2 − N (1 + zκf), N."""
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
        """Travel from the stop after friction has risen to a value, m: the smallest equilibrium travel."""
        left = self._left(friction)
        if self.straight:
            end = self.closing.deflection + 0.0 * (self.net_gain * friction)
            return root(left, self._slope(friction), end)
        tried = self._tried(self.closing.deflection, friction)
        # the stop itself is left out: behind a steep wall the sleeve jumps off its stop
        holds: Any = (left(tried) >= 0) & (tried > 0)
        low, high = _first(tried, holds)
        return root(left, self._slope(friction), high, low)

    def travel_returning(self, friction: Values, start: Values) -> Values:
        """Travel after friction has fallen, m: the largest equilibrium travel up to ``start``, or 0 without any."""
        if self.straight:
            return smaller(self.travel(friction), start)
        left = self._left(friction)
        tried = self._tried(start, friction)[::-1]
        holds: Any = left(tried) <= 0
        high, low = _first(tried, holds)
        slope = self._slope(friction)
        return chosen(holds.any(axis=0), lambda: root(left, slope, high, low), lambda: 0.0 * tried[0])

    def _tried(self, end: Values, friction: Values) -> Floats:
        """Grid of travels to ``end`` along the first axis; between neighbours the equilibrium friction is monotone."""
        grid = places(end + self.nought, _PLACES)
        with np.errstate(all="ignore"):  # division by N = 0 where the closing spring is slack
            found = np.sort(np.concatenate([grid, turned(self._friction_slope, grid)]), axis=0)
        found = found.reshape(len(found), *(1,) * max(np.ndim(friction) - np.ndim(grid[0]), 0), *found.shape[1:])
        return found + 0.0 * friction

    def _friction_slope(self, travel: Values) -> Values:
        """Number with the sign of df/dx along the equilibria."""
        return self._slope(self.friction(travel))(travel)

    def friction(self, travel: Values) -> Values:
        """Friction at which the sleeve is in equilibrium at a travel."""
        held = quotient(self.control.force(travel), self.pressed(travel)) - 1
        return quotient(held, self.pairs * self.net_gain_at(travel))  # infinite where κ = 0

    def way(self, start: Values, end: Values) -> Floats:
        """Equilibrium travels between ``start`` and ``end`` as friction changes, along the first axis.

        They include every extreme of the torque and both ends of every jump; travels inside a jump become ``start``.
        """
        ahead = np.where(np.asarray(end) >= start, 1.0, -1.0)

        def torque_slope(at: Floats) -> Values:
            """Number with the sign of dT/dx, where T = R (F_2 − N)/κ."""
            pressed, control = self.pressed(at), self.control.force(at)
            stiffness = self.control.stiffness(at) + self.closing.stiffness(-at)
            return stiffness * self.net_gain_at(at) - self.gain_slope * (control - pressed)

        def ordered(*places: Floats) -> tuple[Floats, Floats, Floats]:
            """Sorted travels, the friction at each (negated if the sleeve moves back), and its running maximum."""
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
    """Zero of a function in each interval of the first axis, by bisection; without a zero, the interval's start."""
    low, sign = at[:-1], function(at[:-1]) > 0
    high = np.where(sign == (function(at[1:]) > 0), low, at[1:])
    for _ in range(_HALVINGS if (low != high).any() else 0):
        middle = (low + high) / 2
        before = (function(middle) > 0) == sign
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    return high


def places(end: Values, count: int) -> Floats:
    """``count`` + 1 equally spaced values from 0 to ``end``, along the first axis."""
    return np.multiply.outer(np.linspace(0.0, 1.0, count + 1), end)


def _first(tried: Floats, good: Any) -> tuple[Values, Values]:
    """Last value before the first ``good`` value along the first axis, and this first good value."""
    first = np.argmax(good, axis=0)[None]
    before, there = (np.take_along_axis(tried, np.maximum(first - each, 0), axis=0)[0] for each in (1, 0))
    return before, there
