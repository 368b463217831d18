"""The torque law of an indirect clutch, as functions of the spring force and the friction: numbers or arrays.

A law knows neither a spec nor how the spring is set: engines, sweeps and searches ask the same one.
"""

import math
from dataclasses import dataclass, replace
from typing import Any

from ..arrays import Floats, Values, chosen, is_array, larger, quiet_division, smaller, square_root
from ..equations import indirect, pocket
from ..recorders import larger_of, marked, solved, unrecorded
from .balance import Balance, SetSpring
from .characteristic import CurvedSprings

_ROUNDING = 1e-12


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
    gain_slope: Values = 0.0
    """C_1, 1/m: how the gain grows with the travel of the sleeve; 0 for a straight wall (theory, section 12)."""

    @property
    def straight(self) -> bool:
        """Whether the walls are straight: the gain is the same wherever the sleeve is."""
        return not is_array(self.gain_slope) and bool(self.gain_slope == 0)

    @property
    def reduced_gain(self) -> Values:
        """z C."""
        return self.pairs * self.gain

    @property
    def gain_threshold(self) -> Values:
        """2 R f_1/d: the gain at which feedback begins."""
        threshold: Values = indirect.gain_threshold(self.mean_radius, self.key_friction, self.hub_diameter)
        return threshold

    def gain_at(self, travel: Values) -> Values:
        """C where the sleeve has travelled to."""
        if self.straight:
            return self.gain
        gain: Values = pocket.gain_at(self.gain, self.gain_slope, travel)
        return gain

    @property
    def net_gain(self) -> Values:
        """κ at the stop, moving off it."""
        net: Values = indirect.net_gain(self.gain, self.mean_radius, self.key_friction, self.hub_diameter)
        return net

    @property
    def net_gain_returning(self) -> Values:
        """κ₊ at the stop, moving back."""
        net: Values = indirect.net_gain_returning(self.gain, self.mean_radius, self.key_friction, self.hub_diameter)
        return net

    def steepened(self, travel: Values) -> "IndirectLaw":
        """The law with the gain of the place where the sleeve has travelled to."""
        return self if self.straight else replace(self, gain=self.gain_at(travel))

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

    def leaving_friction(self, closing_force: Values) -> Values:
        """Friction at which the sleeve leaves its stop."""
        if self.made_control_force is None:
            return self.friction_set
        made, net = self.made_control_force, self.net_gain
        if not is_array(net) and net == 0:
            # the balls move nothing: it rests for ever, or never
            return chosen(made >= closing_force, lambda: math.inf, lambda: -math.inf)
        with quiet_division(net):  # arrays come to the same
            friction: Values = pocket.leaving_friction(closing_force, made, self.pairs, net)
        return friction

    def constant_torque_slope(self, closing_force: Values, friction_max: Values) -> Values:
        """C_1* at which torque does not depend on friction once the sleeve is off its stop, 1/m.

        With disc springs no C_1 does: that at which it is the same at ``friction_max`` as where the sleeve leaves.
        """
        leaving = self.leaving_friction(closing_force)
        stiffness = self.closing_stiffness, self.control_stiffness
        if self.curved is not None:
            first, second = self.set_springs(closing_force)
            # a little beyond where it leaves at least, so that there is a way to go
            travel = first.slackens(closing_force * leaving / larger(friction_max, leaving * (1 + 1e-6)))
            stiffness = first.secant(-travel), second.secant(travel)
        slope: Values = pocket.constant_torque_slope(*stiffness, self.pairs, leaving, closing_force)
        return slope

    def jumping_slope(self, closing_force: Values) -> Values:
        """C_1 above which the sleeve jumps off its stop as friction rises, 1/m."""
        leaving = self.leaving_friction(closing_force)
        first, second = (spring.stiffness(0.0) for spring in self.set_springs(closing_force))
        stiffness = indirect.sleeve_stiffness(first, second, self.pairs, leaving, self.net_gain)
        slope: Values = pocket.jumping_slope(stiffness, self.pairs, leaving, closing_force)
        return slope

    def _straight_stiffness(self, friction: Values, net_gain: Values) -> Values:
        """D(f) with the gain of the stop, N/m."""
        stiffness: Values = indirect.sleeve_stiffness(
            self.closing_stiffness, self.control_stiffness, self.pairs, friction, net_gain
        )
        return stiffness

    def _squared(self, closing_force: Values, friction: Values, net_gain: Values) -> Values:
        """k_t², N²/m²: negative where the sleeve has no place but its stop."""
        squared: Values = pocket.tangent_stiffness_squared(
            closing_force,
            self.closing_stiffness,
            self.control_force(closing_force),
            self.control_stiffness,
            self._straight_stiffness(friction, net_gain),
            pocket.slope_feedback(self.pairs, friction, self.gain_slope),
        )
        return squared

    def tangent_stiffness(self, closing_force: Values, friction: Values, net_gain: Values) -> Values:
        """k_t, N/m: how stiff the balance is where the sleeve, off its stop, is; D(f) of a straight pocket."""
        if self.straight:
            return self._straight_stiffness(friction, net_gain)
        # at the verge of a jump rounding may take the square below 0
        return square_root(larger(self._squared(closing_force, friction, net_gain), 0.0))

    def _stiffness(self, closing_force: Values, friction: Values, net_gain: Values) -> Values:
        """(F_п1 c_2 + F_п2 c_1)/N with the sleeve off its stop, N/m; D(f) of a straight pocket."""
        straight = self._straight_stiffness(friction, net_gain)
        if self.straight:
            return straight
        slope = pocket.slope_feedback(self.pairs, friction, self.gain_slope)
        tangent = self.tangent_stiffness(closing_force, friction, net_gain)
        stiffness: Values = pocket.sleeve_stiffness(straight, closing_force, slope, tangent)
        return stiffness

    def is_seated(self, closing_force: Values, friction: Values) -> Any:
        """Whether, friction rising, the stop carries: the control spring has more than closing spring and balls."""
        leaving = self.leaving_friction(closing_force)
        # just there both branches meet, unless a steep wall lets the sleeve jump off
        return friction < leaving if self.straight else friction <= leaving

    def _holds(self, closing_force: Values, friction: Values, net_gain: Values) -> Any:
        """Whether the control spring holds a sleeve that is at its stop."""
        return self.control_force(closing_force) > closing_force * (1 + self.pairs * net_gain * friction)

    def _is_reseated(self, closing_force: Values, friction: Values, locked: Values) -> Any:
        """Whether, friction falling, the sleeve is back at its stop; ``locked``: the normal force it returns from.

        A wall so steep that the sleeve jumps off its stop also holds it off until it jumps back.
        """
        net = self.net_gain_returning
        home = self._holds(closing_force, friction, net)
        if self.straight:
            return home
        weight = pocket.slope_feedback(self.pairs, friction, self.gain_slope) * closing_force
        off = (self._straight_stiffness(friction, net) < weight) & (locked < closing_force)
        # True > False: home, and not held off
        return home > (off & (self._squared(closing_force, friction, net) >= 0))

    def _pressed(self, closing_force: Values, friction: Values, net_gain: Values, seated: Any) -> Values:
        """Normal force, N: F_п2/(1 + zκf) at the stop, else S21 (9)."""
        control = self.control_force(closing_force)

        def at_stop() -> Values:
            force: Values = indirect.normal_force_seated(control, self.pairs, net_gain, friction)
            return force

        def moving() -> Values:
            if self.curved is not None:
                own = self.balance(closing_force, net_gain)
                return own.shown(friction, lambda: own.travel(friction), closing_force)
            springs = closing_force, self.closing_stiffness, control, self.control_stiffness
            force: Values = indirect.normal_force_moving(*springs, self._stiffness(closing_force, friction, net_gain))
            return smaller(closing_force, force)

        return chosen(seated, at_stop, moving)

    def normal_force(self, closing_force: Values, friction: Values) -> Values:
        """Normal force N on the pairs, N, friction rising."""
        return self._pressed(closing_force, friction, self.net_gain, self.is_seated(closing_force, friction))

    def torque(self, closing_force: Values, friction: Values) -> Values:
        """Slip torque T, N·m, friction rising (S21 (11); theory, section 5)."""
        pressed = self.normal_force(closing_force, friction)
        torque: Values = indirect.torque(pressed, self.mean_radius, self.pairs, friction)
        return torque

    def torque_returning(self, closing_force: Values, friction: Values, friction_max: Values) -> Values:
        """Torque when friction falls again from ``friction_max`` under load, N·m (theory, section 5).

        The key locks the sleeve where ``friction_max`` put it until f has fallen by κ₊/κ.
        """
        if self.curved is not None and not self.straight:
            return self._returned(closing_force, friction, friction_max)
        locked = self.normal_force(closing_force, friction_max)
        seated = self._is_reseated(closing_force, friction, locked)

        def moving() -> Values:
            return self._pressed(closing_force, friction, self.net_gain_returning, seated)

        pressed = larger_of(locked, moving)
        torque: Values = indirect.torque(pressed, self.mean_radius, self.pairs, friction)
        return torque

    def _returned(self, closing_force: Values, friction: Values, friction_max: Values) -> Values:
        """The same between curved springs, behind curved walls."""
        net = self.net_gain_returning
        with unrecorded():
            start = self.travel(closing_force, friction_max)
        place = self.travel_returning(closing_force, friction, friction_max)
        home = (place <= 0) & self._holds(closing_force, friction, net)

        def seated() -> Values:
            force: Values = indirect.normal_force_seated(self.control_force(closing_force), self.pairs, net, friction)
            return force

        def steps() -> Values:
            if home:
                return seated()
            if place >= start:  # the key holds it
                return self.normal_force(closing_force, friction_max)
            return self.balance(closing_force, net).shown(friction, lambda: place)

        pressed = solved(lambda: chosen(home, seated, lambda: self.balance(closing_force, net).pressed(place)), steps)
        torque: Values = indirect.torque(pressed, self.mean_radius, self.pairs, friction)
        return torque

    def travel(self, closing_force: Values, friction: Values) -> Values:
        """Axial travel x of the sleeve, m; 0 at the stop (S21 (10), (16))."""

        def moved() -> Values:
            if self.curved is not None:
                with unrecorded():
                    place = self.balance(closing_force, self.net_gain).travel(friction)
                return marked(place, friction, closing_force)
            net, made = self.net_gain, self.made_control_force
            stiffness = self._straight_stiffness(friction, net)
            travel: Values
            if not self.straight:
                pressed = self.normal_force(closing_force, friction)
                travel = pocket.travel(closing_force, pressed, self.closing_stiffness)
            elif made is None:
                travel = indirect.travel(self.pairs, closing_force, friction, self.friction_set, net, stiffness)
            else:
                travel = indirect.travel_as_made(closing_force, made, self.pairs, friction, net, stiffness)
            return travel

        return chosen(self.is_seated(closing_force, friction), lambda: 0.0, moved)

    def balance(self, closing_force: Values, net_gain: Values) -> Balance:
        """What holds the sleeve off its stop, springs and walls as they are."""
        first, second = self.set_springs(closing_force)
        return Balance(first, second, self.pairs, net_gain, self.gain_slope, self.straight)

    def set_springs(self, closing_force: Values) -> tuple[SetSpring, SetSpring]:
        """The closing and the control spring."""
        discs = self.curved or CurvedSprings(None, None)
        control = self.control_force(closing_force)
        return (
            SetSpring(closing_force, self.closing_stiffness, discs.closing),
            SetSpring(control, self.control_stiffness, discs.control),
        )

    def travel_returning(self, closing_force: Values, friction: Values, friction_max: Values) -> Values:
        """Travel of a sleeve when friction falls again from ``friction_max``, m; of curved springs or walls."""
        net = self.net_gain_returning
        with unrecorded():
            start = self.travel(closing_force, friction_max)
            place = self.balance(closing_force, net).travel_returning(friction, start)
        return marked(place, friction, net, closing_force)

    def turns_rising(self, closing_force: Values, low: Values, high: Values) -> list[tuple[Values, Values]]:
        """Least and largest torque off the stop while friction rises, N·m, each with its friction."""
        balance = self.balance(closing_force, self.net_gain)
        ends = (self.travel(closing_force, friction) for friction in (low, high))
        return self._turns(balance, balance.way(*ends), low, high)

    def least_returning(self, closing_force: Values, low: Values, high: Values) -> Values:
        """Least torque off the stop while friction falls, N·m."""
        balance = self.balance(closing_force, self.net_gain_returning)
        ends = self.travel(closing_force, high), self.travel_returning(closing_force, low, high)
        return self._turns(balance, balance.way(*ends), low, high)[0][0]

    def _turns(self, balance: Balance, way: Floats, low: Values, high: Values) -> list[tuple[Values, Values]]:
        """Of the places on the way of the sleeve those of least and of largest torque, within the frictions."""
        import numpy as np

        friction = np.asarray(balance.friction(way))
        torque = indirect.torque(balance.pressed(way), self.mean_radius, self.pairs, friction)
        inside = (friction >= low * (1 - _ROUNDING)) & (friction <= high * (1 + _ROUNDING))
        torque = np.where(inside, torque, self.torque(balance.closing.set_force, high))
        friction = np.where(inside, friction, high)
        turns = [
            [np.take_along_axis(values, place[None], axis=0)[0] for values in (torque, friction)]
            for place in (torque.argmin(axis=0), torque.argmax(axis=0))
        ]
        return [(one, two) if way.ndim > 1 else (float(one), float(two)) for one, two in turns]
