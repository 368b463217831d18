"""Discs, springs, key and balls of an indirect clutch at one friction, as the drive meets them."""

from dataclasses import dataclass
from functools import cached_property
from typing import cast

import numpy as np

from ..arrays import V, Values, is_array, larger, smaller
from ..engines.characteristic import root
from ..engines.laws import IndirectLaw
from ..equations import direct, pocket, sleeve

_IDLE = 1e-9
"""κ in an array that stands for none: the law's own limit, an ordinary clutch."""
_ROUNDING = 1e-12
_FAR = 1e6
"""Friction from which a sleeve returns that has been as far off as it can be."""


@dataclass(frozen=True)
class Sleeve:
    """An indirect clutch at one friction; typed as numbers, in a sweep arrays stand in their place."""

    law: IndirectLaw
    closing_force: float
    friction: float
    mass: float = 0.0
    static_ratio: float = 1.0
    decay_rate: float = 0.0
    """R/v_s, s/rad."""
    lever: float = 0.0
    """r/R; 0 where the circle of the balls is not known."""
    branch: int = 0
    """Law at the stop: 0 with the key's play, 1 along κ alone, −1 along κ₊ alone."""

    @cached_property
    def friction_pairs(self) -> float:
        """z f."""
        return cast(float, self.law.pairs * self.friction)

    @cached_property
    def mean_radius(self) -> float:
        """R_cp."""
        return cast(float, self.law.mean_radius)

    @cached_property
    def net_gain(self) -> float:
        """κ at the stop."""
        net = self.law.net_gain
        return cast(float, larger(net, _IDLE) if is_array(net) else net)

    @cached_property
    def net_gain_returning(self) -> float:
        """κ₊ at the stop."""
        return cast(float, self.law.net_gain_returning)

    @cached_property
    def control_force(self) -> float:
        """F_п2."""
        return cast(float, self.law.control_force(self.closing_force))

    @cached_property
    def lift(self) -> float:
        """Torque at which the sleeve leaves its stop, S(0)/κ."""
        return self.moment(0.0) / self.net_gain

    @cached_property
    def _springs(self) -> tuple[float, float, float, float]:
        stiffness = self.law.closing_stiffness, self.law.control_stiffness
        return self.closing_force, self.control_force, cast(float, stiffness[0]), cast(float, stiffness[1])

    @cached_property
    def _pressed_in(self) -> tuple[float, float]:
        """Deflections of disc springs at the stop, closing and control; 0 of a straight one."""
        forces = self.closing_force, self.control_force
        parts = (None, None) if self.law.curved is None else self.law.curved
        at = (0.0 if part is None else part.deflection(force) for part, force in zip(parts, forces, strict=True))
        return cast(tuple[float, float], tuple(at))

    def _stiffnesses(self, travel: V) -> tuple[V | float, V | float]:
        """c_1 and c_2 where the sleeve is."""
        own = self.law.curved
        closing, control = self._springs[2:]
        if own is None:
            return closing, control
        slackened, pressed = self._deflections(travel)
        return (
            closing if own.closing is None else cast(V, own.closing.stiffness(slackened)),
            control if own.control is None else cast(V, own.control.stiffness(pressed)),
        )

    def _deflections(self, travel: V) -> tuple[Values, Values]:
        """Of disc springs, closing and control; a spring that has been left presses no more."""
        return larger(self._pressed_in[0] - travel, 0.0), self._pressed_in[1] + travel

    @property
    def farthest(self) -> float:
        """Travel at which the closing spring has been left, m."""
        own = self.law.curved
        straight = own is None or own.closing is None
        return self.closing_force / self._springs[2] if straight else self._pressed_in[0]

    def torque(self, ratio: float) -> Values:
        """Slip torque that lasts, friction times ``ratio`` and rising, N·m."""
        return self.law.torque(self.closing_force, ratio * self.friction)

    @property
    def least(self) -> Values:
        """Slip torque of a sleeve that returns from far off, N·m."""
        return self.law.torque_returning(self.closing_force, self.friction, _FAR)

    def sticks_up_to(self, turn: Values) -> Values:
        """Torque at which the pack slips, N·m: that at T(r_s f), or less where the sleeve is still farther off.

        Below it swings of the sleeve only lose energy to its key.
        """
        pressed = self.pressed(self.travel(turn))
        held = direct.group_torque(pressed, self.mean_radius, self.static_ratio, self.friction_pairs)
        breakaway = self.torque(self.static_ratio)
        found: Values = np.where(np.asarray(turn) == 0, breakaway, smaller(breakaway, held))
        return found

    def steeper(self, net_gain: Values, travel: V) -> V:
        """A gain at the stop, where the sleeve has travelled to."""
        gain: V = pocket.gain_at(net_gain, self.law.gain_slope, travel)
        return gain

    def gain(self, travel: V) -> V:
        """C where the sleeve is."""
        return self.steeper(cast(float, self.law.gain), travel)

    def moment(self, travel: V) -> V:
        """S(x), N·m."""
        moment: V
        if self.law.curved is None:
            moment = sleeve.spring_moment(self.mean_radius, *self._springs, travel)
        else:
            control = self.law.curved.control
            pressed = self._springs[1] + self._springs[3] * travel
            if control is not None:
                pressed = cast(V, control.force(self._deflections(travel)[1]))
            moment = sleeve.spring_moment(self.mean_radius, self.pressed(travel), pressed, 0.0, 0.0, 0.0)
        return moment

    def work(self, travel: V) -> V:
        """Work stored in both springs, J."""
        if self.law.curved is not None:
            # Simpson's rule: exact, for the force of a disc spring is a cubic
            mean = (self.moment(0 * travel) + 4 * self.moment(travel / 2) + self.moment(travel)) / 6
            return cast(V, mean / self.mean_radius * travel)
        work: V = sleeve.spring_work(*self._springs, travel)
        return work

    def travel(self, turn: V) -> V:
        """Travel for a turn either way, m."""
        travel: V = sleeve.travel(abs(turn), self.mean_radius, self.law.gain, self.law.gain_slope)
        return travel

    def turn_under(self, torque: float) -> Values:
        """Turn of the balls, at rest under a torque that has risen to it; 0 up to T_н."""
        if self.law.curved is None:
            lifted = torque * self.net_gain / self.mean_radius - (self.control_force - self.closing_force)
            off = lifted > _ROUNDING * self.control_force
            stiffness = self._springs[2] + self._springs[3] - torque * self.law.gain_slope / self.mean_radius
            # a constant-torque pocket has no stiffness at T_н, where nothing is lifted
            travel = off * lifted / (stiffness + (1 - 1 * off))
        else:
            travel = root(
                lambda at: self.moment(at) - torque * self.net_gain,
                lambda at: self.mean_radius * sum(self._stiffnesses(at)),
                self.farthest + 0.0 * (torque * self.net_gain),
            )
        turn: Values = sleeve.turn(travel, self.mean_radius, self.law.gain, self.law.gain_slope)
        return turn

    def pressed(self, travel: V) -> V:
        """N off the stop, N: that of the closing spring, which has been slackened."""
        if self.law.curved is not None and self.law.curved.closing is not None:
            return cast(V, self.law.curved.closing.force(self._deflections(travel)[0]))
        force: V = sleeve.slackened_force(self.closing_force, self._springs[2], travel)
        return force

    @cached_property
    def stop_gains(self) -> tuple[float, float]:
        """Net gains at the stop while the torque of the balls rises, and while it falls."""
        gains = self.net_gain, self.net_gain_returning
        return gains if not self.branch else (gains[self.branch < 0],) * 2

    def pressed_at_stop(self, ball_torque: V, net_gain: float) -> V:
        """N at the stop for a gain κ or κ₊, N: that of the closing spring at least."""
        force = sleeve.normal_force_at_stop(self.control_force, net_gain, abs(ball_torque), self.mean_radius)
        return cast(V, larger(force, self.closing_force))

    def play(self, ball_torque: V) -> tuple[V, V]:
        """Normal forces at the stop between which the key sticks, N: beyond them N follows the torque of the balls."""
        rising, falling = self.stop_gains
        return self.pressed_at_stop(ball_torque, falling), self.pressed_at_stop(ball_torque, rising)

    def slipping_at_stop(self, pairs: V, net_gain: V, alone: V, share: V) -> V:
        """Torque of the slipping pack at the stop, N following along κ or κ₊, N·m; along the slip.

        Args:
            pairs: z f.
            net_gain: κ or κ₊, negative where the balls pass their torque against the slip.
            alone: torque of the balls without that of the pack, N·m.
            share: share of the pack's torque that they pass.
        """
        torque = sleeve.slip_torque_at_stop(pairs, self.mean_radius, self.control_force, net_gain, alone, share)
        return cast(V, larger(torque, pairs * self.mean_radius * self.closing_force))

    def inertia(self, travel: V, net_gain: V) -> V:
        """Inertia of the sleeve's mass in the turn, kg·m²."""
        inertia: V = sleeve.sleeve_inertia(self.mass, self.mean_radius, self.gain(travel), net_gain)
        return inertia

    def speed(self, travel: V, rate: V) -> V:
        """Speed of the sleeve for a rate of the turn, m/s."""
        speed: V = sleeve.travel_rate(rate, self.mean_radius, self.gain(travel))
        return speed

    def taken(self, travel: V, rate: V) -> V:
        """Moment that a steepening wall takes from a moving sleeve, N·m; ``rate`` is that of the turn."""
        moment: V = sleeve.centrifugal_moment(
            self.mass, self.mean_radius, self.gain(travel), self.law.gain_slope, self.speed(travel, rate)
        )
        return moment

    def torsional(self, travel: V, net_gain: V, torque: V) -> V:
        """Stiffness against a turn, N·m/rad."""
        stiffness: V = sleeve.torsional_stiffness(
            *self._stiffnesses(travel), self.mean_radius, net_gain, self.gain(travel), self.law.gain_slope, torque
        )
        return stiffness
