"""Clutch at one friction, as the simulation of the drive uses it: the pack and, in an indirect clutch, the sleeve.

One stick-slip law for numbers (one event) and arrays (many drives). While its sleeve is at the stop, an indirect clutch
acts as a direct clutch with the gain κ if the torque rises, κ₊ if it falls; a direct clutch is always at the stop.
"""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from ..engines import Clutch
from ..engines.characteristics import SetSpring, root
from ..engines.quantities import Quantities
from ..equations import adjustment, curved, direct, drive, indirect, sleeve
from ..equations.arrays import Values, is_array, larger, smaller
from ..errors import CalculationError

_IDLE = 1e-9
"""Replacement for κ = 0 in an array, to avoid division by 0; the clutch still acts as an ordinary one."""


class Pack(ABC):
    """Discs of a clutch at one friction, balls at their stop; numbers, or arrays of many clutches."""

    travels: ClassVar[bool]
    """True if the balls can leave their stop."""
    mean_radius: Any
    static_ratio: Any
    decay_rate: Any
    """Decay rate R/v_s, s/rad: the friction ratio falls with the slip speed as exp(−R|slip|/v_s)."""
    friction_pairs: Any
    """Sum of z f over both groups of pairs."""
    resting_force: Any
    least_force: Any
    """Normal force at the stop without load (``resting_force``), and its smallest value at the stop, N."""
    stop_gains: tuple[Any, Any]
    """Net gains at the stop: κ while the torque rises, κ₊ while the torque falls."""

    def ratio(self, slip: Any) -> Any:
        """Ratio of the friction at a slip speed, rad/s, to sliding friction."""
        decay = np.exp(-self.decay_rate * np.abs(slip)) if is_array(slip) else math.exp(-self.decay_rate * abs(slip))
        return drive.stribeck_ratio(self.static_ratio, decay)

    def carried(self, normal_force: Any, ratio: Any) -> Any:
        """Slip torque under a normal force, with friction multiplied by ``ratio``, N·m."""
        return indirect.torque(normal_force, self.mean_radius, ratio, self.friction_pairs)

    def pressed_at_stop(self, torque: Any, net_gain: float) -> Any:
        """Normal force at the stop under a torque, with the gain κ or κ₊, N."""
        return larger(
            sleeve.normal_force_at_stop(self.resting_force, net_gain, abs(torque), self.mean_radius), self.least_force
        )

    def play(self, torque: Any) -> tuple[Any, Any]:
        """Smallest and largest normal force N at the stop while the feather key sticks; outside, N follows torque."""
        rising, falling = self.stop_gains
        return self.pressed_at_stop(torque, falling), self.pressed_at_stop(torque, rising)

    def slipping_at_stop(self, ratio: Any, net_gain: Any, alone: Any, share: Any) -> Any:
        """Slip torque with the balls at the stop, where N follows the ball torque by κ or κ₊, N·m; positive along slip.

        The balls pass ``alone`` and a share of the pack's torque; ``net_gain`` is negative if that is against the slip.
        """
        pairs = self.friction_pairs * ratio
        torque = sleeve.slip_torque_at_stop(pairs, self.mean_radius, self.resting_force, net_gain, alone, share)
        return larger(torque, pairs * self.mean_radius * self.least_force)

    @abstractmethod
    def torque(self, ratio: Any) -> Any:
        """Sustained slip torque at friction times ``ratio``, on the branch of rising friction, N·m."""

    @cached_property
    def sliding(self) -> Any:
        """Sliding torque T(f), on the branch of rising friction, N·m."""
        return self.torque(1.0)

    @cached_property
    def breakaway(self) -> Any:
        """Torque at which the clutch at rest slips under a load that rises slowly, T(r_s f), N·m."""
        return self.torque(self.static_ratio)

    @cached_property
    @abstractmethod
    def growth(self) -> float:
        """Derivative of the slip torque with respect to the friction ratio f(v)/f where slip begins, N·m."""

    def turn_under(self, torque: float) -> Values:
        """Turn of the balls at rest after the torque has risen to ``torque``, rad; 0 at the stop."""
        return 0.0

    def travel(self, turn: Any) -> Any:
        """Travel of the sleeve for a turn of the balls in either direction, m."""
        return turn

    def judder(self, slip: Any) -> Any:
        """Damping of the driven half below which swings grow at the slip speed ``slip``, N·m·s/rad."""
        return self.growth * (self.static_ratio - 1) * self.decay_rate * np.exp(-self.decay_rate * slip)

    def juddering_slip(self, damping: Any) -> Any:
        """Slip speed below which swings grow despite ``damping``, rad/s; 0 where they never grow."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(self.judder(0.0) > damping, np.log(self.judder(0.0) / damping) / self.decay_rate, 0.0)


@dataclass(frozen=True)
class DirectPack(Pack):
    """Discs of a direct clutch at one friction; numbers, or arrays in a sweep."""

    closing_force: Any
    mean_radius: Any
    bypass_pairs: Any
    controlled_pairs: Any
    gain: Any
    driving: Any
    """Friction of the bypass pairs, f_1."""
    driven: Any
    """Friction of the controlled pairs, f_2."""
    static_ratio: Any = 1.0
    decay_rate: Any = 0.0
    lag: Any = 0.0
    """Time lag τ of the release force, s."""
    lever: float = 0.0
    """Ratio r/R of ball circle to mean friction radius; 0 if the ball circle is not known."""

    travels = False
    least_force = -math.inf
    ball_share: ClassVar[Any]
    """Share z_2 f_2/Σ z f of the torque that passes the balls, with or without slip (S22 for one material)."""

    def __post_init__(self) -> None:
        """Set the constants of the pack; a direct clutch has no feather key, so both gains at the stop are equal."""
        through_balls = self.controlled_pairs * self.driven
        pairs = self.bypass_pairs * self.driving + through_balls
        share = through_balls / pairs
        gains = self.gain * share, self.gain * share
        vars(self).update(friction_pairs=pairs, resting_force=self.closing_force, ball_share=share, stop_gains=gains)

    def _law(self, ratio: Any) -> tuple[Any, ...]:
        """Arguments of the direct law, with both frictions multiplied by ``ratio``."""
        pairs = self.bypass_pairs, self.controlled_pairs
        return self.closing_force, self.mean_radius, *pairs, self.gain, ratio * self.driving, ratio * self.driven

    def torque(self, ratio: Any) -> Any:
        """Slip torque with friction multiplied by ``ratio`` and without lag, N·m."""
        return direct.torque(*self._law(ratio))

    @cached_property
    def growth(self) -> float:
        """Derivative ∂T/∂(f(v)/f) if the release force follows the torque without lag, N·m."""
        return drive.torque_growth(*self._law(self.static_ratio)) / self.static_ratio

    def sticks_up_to(self, turn: Values, normal: Values) -> Values:
        """Torque up to which the discs stick, N·m: T(r_s f), with a lag at most what the normal force now carries."""
        breakaway = self.breakaway
        return smaller(breakaway, self.carried(normal, self.static_ratio)) if np.any(self.lag) else breakaway

    def leaning(self, turn: Any) -> Any:
        """Share of the torque that passes the balls, divided by cos α, with tan α = C r/R."""
        return self.ball_share * (1 + (self.gain * self.lever) ** 2) ** 0.5


@dataclass(frozen=True)
class Sleeve(Pack):
    """Discs, springs, feather key and balls of an indirect clutch at one friction; numbers, or arrays in a sweep."""

    law: Quantities
    friction: Any
    mass: Any = 0.0
    static_ratio: Any = 1.0
    decay_rate: Any = 0.0
    lever: float = 0.0
    """Ratio r/R of ball circle to mean friction radius; 0 if the ball circle is not known."""

    travels = True
    lag = 0.0
    closing_force: ClassVar[Any]
    """Closing-spring force F_п1 at the setting, N."""
    closing_spring: ClassVar[SetSpring]
    control_spring: ClassVar[SetSpring]
    stop_gain: ClassVar[Any]
    net_gain: ClassVar[Any]
    net_gain_returning: ClassVar[Any]
    """Gain C, net gain κ, and net gain κ₊ of a returning sleeve, all at the stop."""
    gain_slope: ClassVar[Any]
    """Slope C_1 of the gain over the travel, 1/m; 0 for a straight wall."""

    def __post_init__(self) -> None:
        """Take the constants of the sleeve from the quantities in ``law``."""
        law, returning = self.law, self.law["net_gain_returning"]
        net = larger(law["net_gain"], _IDLE) if is_array(law["net_gain"]) else law["net_gain"]
        springs = {
            name: SetSpring(law[f"{name}_force"], law[f"{name}_stiffness"], law.given.get(f"{name}_disc"))
            for name in ("closing", "control")
        }
        vars(self).update(
            mean_radius=law["mean_radius"],
            friction_pairs=law["pairs"] * self.friction,
            closing_force=law["closing_force"],
            least_force=law["closing_force"],
            resting_force=law["control_force"],
            net_gain=net,
            net_gain_returning=returning,
            stop_gain=law["gain"],
            gain_slope=law.get("gain_slope", 0.0),
            stop_gains=(net, returning),
            **{f"{name}_spring": spring for name, spring in springs.items()},
        )

    @cached_property
    def lift(self) -> Any:
        """Torque S(0)/κ at which the balls leave the stop, N·m."""
        return self.moment(0.0) / self.net_gain

    def torque(self, ratio: Any) -> Any:
        """Sustained slip torque at friction times ``ratio``, on the branch of rising friction, N·m."""
        return self.law.at(friction=ratio * self.friction)["torque"]

    @cached_property
    def growth(self) -> float:
        """Derivative ∂T/∂(f(v)/f) while the feather key holds the sleeve in place, N·m."""
        return self.breakaway / self.static_ratio

    def sticks_up_to(self, turn: Values, normal: Values) -> Values:
        """Torque up to which the discs stick, N·m: T(r_s f), off the stop at most what the closing spring allows.

        Up to this torque a swing of the sleeve only loses energy, by friction at the feather key.
        """
        off_stop = self.carried(self.pressed(self.travel(turn)), self.static_ratio)
        return np.where(np.asarray(turn) == 0, self.breakaway, smaller(self.breakaway, off_stop))

    def leaning(self, turn: Any) -> Any:
        """Factor 1/cos α from tangential to contact force at a turn of the balls, with tan α = C r/R."""
        return (1 + (self.gain(self.travel(turn)) * self.lever) ** 2) ** 0.5

    def steeper(self, net_gain: Any, travel: Any) -> Any:
        """Gain C, κ or κ₊ at a travel of the sleeve, from the gain at the stop."""
        return curved.gain_acting(net_gain, self.gain_slope, travel)

    def gain(self, travel: Any) -> Any:
        """Gain C at a travel of the sleeve."""
        return self.steeper(self.stop_gain, travel)

    def moment(self, travel: Any) -> Any:
        """Moment of both springs S(x), N·m."""
        control = self.control_spring.force(travel)
        return sleeve.spring_moment(self.mean_radius, self._slackened(travel), control, 0.0, 0.0, 0.0)

    def work(self, travel: Any) -> Any:
        """Energy that both springs store between the stop and a travel, J; Simpson's rule, exact for cubic forces."""
        mean = (self.moment(0 * travel) + 4 * self.moment(travel / 2) + self.moment(travel)) / 6
        return mean / self.mean_radius * travel

    def pressed(self, travel: Any) -> Any:
        """Normal force off the stop, N: the force of the closing spring, 0 once the spring is slack."""
        return larger(self._slackened(travel), 0.0)

    def _slackened(self, travel: Any) -> Any:
        return self.closing_spring.force(-self._slackening(travel))

    def _slackening(self, travel: Any) -> Any:
        """Extension of the closing spring from its setting, m; for a disc spring at most until it is slack."""
        return travel if self.closing_spring.disc is None else smaller(travel, self.closing_spring.deflection)

    def _stiffnesses(self, travel: Any) -> tuple[Any, Any]:
        """Stiffnesses c_1 of the closing and c_2 of the control spring at a travel, N/m."""
        closing, control = self.closing_spring, self.control_spring
        return closing.stiffness(-self._slackening(travel)), control.stiffness(travel)

    def travel(self, turn: Any) -> Any:
        """Travel of the sleeve for a turn of the balls in either direction, m."""
        return sleeve.travel(abs(turn), self.mean_radius, self.stop_gain, self.gain_slope)

    def turn_under(self, torque: float) -> Values:
        """Turn of the balls at rest after the torque has risen to ``torque``, rad; 0 up to T_н."""
        if self.closing_spring.disc or self.control_spring.disc:
            travel = root(
                lambda at: self.moment(at) - torque * self.net_gain,
                lambda at: self.mean_radius * sum(self._stiffnesses(at)),
                self.closing_spring.deflection + 0.0 * (torque * self.net_gain),
            )
        else:
            lifted = torque * self.net_gain / self.mean_radius - (self.resting_force - self.closing_force)
            off = lifted > 1e-12 * self.resting_force  # beyond rounding
            stiffness = sum(self._stiffnesses(0.0)) - torque * self.gain_slope / self.mean_radius
            # the 1 prevents 0/0 at the stop, where a constant-torque pocket has no stiffness
            travel = off * lifted / (stiffness + (1 - 1 * off))
        return sleeve.turn(travel, self.mean_radius, self.stop_gain, self.gain_slope)

    def inertia(self, gain: Any, net_gain: Any) -> Any:
        """Moment of inertia of the sleeve's mass, reduced to the turn of the balls, kg·m²."""
        return sleeve.sleeve_inertia(self.mass, self.mean_radius, gain, net_gain)

    def speed(self, travel: Any, rate: Any) -> Any:
        """Axial speed of the sleeve while the balls turn at ``rate``, m/s."""
        return sleeve.travel_rate(rate, self.mean_radius, self.gain(travel))

    def driving_moment(self, travel: Any, rate: Any) -> Any:
        """Moment of both springs, less what the inertia of the sleeve takes up along a curved wall, N·m."""
        moment = self.moment(travel)
        if not is_array(self.mass) and not self.mass:
            return moment
        slope, speed = self.gain_slope, self.speed(travel, rate)
        return moment - sleeve.centrifugal_moment(self.mass, self.mean_radius, self.gain(travel), slope, speed)

    def torsional(self, travel: Any, gain: Any, net_gain: Any, torque: Any) -> Any:
        """Stiffness of the control unit against a turn of the balls, N·m/rad."""
        springs = self._stiffnesses(travel)
        return sleeve.torsional_stiffness(*springs, self.mean_radius, net_gain, gain, self.gain_slope, torque)


def pack_of(clutch: Clutch, driving: Values, driven: Values) -> "DirectPack | Sleeve":
    """Return the pack of a clutch at one friction, with its sleeve if the clutch is indirect.

    Raises CalculationError if the sleeve would be off its stop without load.
    """
    bypass, controlled, gain = (clutch[name] for name in ("bypass_pairs", "controlled_pairs", "gain"))
    if not clutch.spec.kind.travels:
        return _discs(clutch, clutch["closing_force"], bypass, controlled, gain, driving, driven)
    net, control, closing = (clutch[name] for name in ("net_gain", "control_force", "closing_force"))
    if not is_array(net) and not net:
        # κ = 0: friction at the feather key cancels the feedback, and the clutch acts as an ordinary one
        return _discs(clutch, closing, clutch["pairs"], 0.0, 0.0, driving, driven)
    below = np.asarray(control < closing)
    if below.any():
        raise CalculationError(
            "simulate: the control spring ({control:.5g N}) must press more than the closing spring "
            "({closing:.5g N}), else the sleeve is off its stop without load",
            control=np.broadcast_to(control, below.shape)[below].flat[0],
            closing=np.broadcast_to(closing, below.shape)[below].flat[0],
        )
    return Sleeve(clutch, driving, _of_unit(clutch, "sleeve_mass"), **_static_and_lever(clutch))


def ordinary_pack(clutch: Clutch, driving: Values, driven: Values) -> DirectPack:
    """Return the discs of a clutch without its control unit, set for the same nominal torque."""
    bypass = clutch["bypass_pairs"]
    pack = bypass, clutch["pairs"] - bypass, 0.0
    at_setting = clutch["friction_driving_set"], clutch["friction_driven_set"]
    arm = direct.torque_per_force(clutch["mean_radius"], *pack, *at_setting)
    force = adjustment.closing_force(clutch["nominal_torque"], clutch["margin_in_spring"], arm)
    return replace(_discs(clutch, force, *pack, driving, driven), lag=0.0)


def _discs(clutch: Clutch, force: Any, *law: Any) -> DirectPack:
    """Discs under a closing force; ``law``: number of pairs of both groups, gain, friction of both groups."""
    options = _static_and_lever(clutch) | {"lag": _of_unit(clutch, "release_lag")}
    return DirectPack(force, clutch["mean_radius"], *law, **options)


def _of_unit(clutch: Clutch, key: str) -> Any:
    """Value of a key of [control_unit]; 0 if the spec does not give it."""
    value = getattr(clutch.spec.control_unit, key, None)
    return 0.0 if value is None else value


def _static_and_lever(clutch: Clutch) -> dict[str, Any]:
    """Ratio of static to sliding friction, its decay R/v_s with slip speed, and r/R; 1, 0 and 0 if not given."""
    friction, radius = clutch.spec.friction, clutch["mean_radius"]
    ratio = 1.0 if friction.static_ratio is None else friction.static_ratio
    decay = 0.0 if friction.stribeck_speed is None else radius / friction.stribeck_speed
    lever = _of_unit(clutch, "ball_circle_radius") / radius
    return {"static_ratio": ratio, "decay_rate": decay, "lever": lever}
