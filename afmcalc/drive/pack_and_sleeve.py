"""Clutch at one friction, as the simulation of the drive uses it: the pack and, in an indirect clutch, the sleeve.

The law of what sticks and slips, written once for numbers (one event) and arrays (many drives). At its stop an indirect
clutch is a direct one of gain κ while the torque rises, κ₊ while it falls; a direct clutch never leaves its stop.
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
"""Replaces κ = 0 in an array, so that nothing is divided by 0; the clutch still acts as an ordinary one."""
_ROUNDING = 1e-12
_FAR = 1e6
"""Friction so large that the sleeve has its largest travel."""


class Pack(ABC):
    """Discs with their balls at the stop."""

    travels: ClassVar[bool]
    """True if the balls can leave their stop."""
    mean_radius: Any
    closing_force: Any
    """F_п, of an indirect clutch F_п1, N."""
    static_ratio: Any
    decay_rate: Any
    lag: Any
    friction_pairs: Any
    """Σ z f."""
    resting_force: Any
    """Normal force at the stop without load, N."""
    least_force: Any
    """Normal force at the stop at least, N."""
    stop_gains: tuple[Any, Any]
    """Net gains at the stop while the torque rises, and while it falls."""
    net_gain: Any
    """κ at the stop of an indirect clutch; κ₊ is ``net_gain_returning``."""
    net_gain_returning: Any
    straight_springs: tuple[Any, Any] | None
    """c_1 and c_2 of springs that are not disc springs: asked for so often that their law is written out."""
    ball_share: Any
    """Share of the torque that passes the balls of a direct clutch, z_2 f_2/Σ z f."""
    lift: Any
    """Torque of the balls at which they leave the stop, N·m."""

    def ratio(self, slip: Any) -> Any:
        """Friction at a slip over sliding friction."""
        if not is_array(slip) and self.static_ratio == 1:
            return 1.0
        decay = np.exp(-self.decay_rate * np.abs(slip)) if is_array(slip) else math.exp(-self.decay_rate * abs(slip))
        return drive.stribeck_ratio(self.static_ratio, decay)

    def carried(self, normal_force: Any, ratio: Any) -> Any:
        """Torque at which a normal force slips, friction times ``ratio``."""
        return indirect.torque(normal_force, self.mean_radius, ratio, self.friction_pairs)

    def pressed_at_stop(self, torque: Any, net_gain: float) -> Any:
        """Normal force at the stop for a gain κ or κ₊, N."""
        return larger(
            sleeve.normal_force_at_stop(self.resting_force, net_gain, abs(torque), self.mean_radius), self.least_force
        )

    def play(self, torque: Any) -> tuple[Any, Any]:
        """Smallest and largest normal force at the stop while the key sticks, N; beyond them N follows the balls."""
        rising, falling = self.stop_gains
        return self.pressed_at_stop(torque, falling), self.pressed_at_stop(torque, rising)

    def slipping_at_stop(self, ratio: Any, net_gain: Any, alone: Any, share: Any) -> Any:
        """Slip torque with the balls at the stop, where N follows their torque by κ or κ₊, N·m; positive along slip.

        Args:
            ratio: friction at the slip over sliding friction.
            net_gain: κ or κ₊, negative where the balls pass their torque against the slip.
            alone: torque that the balls would pass without friction of the pack, N·m.
            share: share of the pack's torque that the balls pass.
        """
        pairs = self.friction_pairs * ratio
        torque = sleeve.slip_torque_at_stop(pairs, self.mean_radius, self.resting_force, net_gain, alone, share)
        return larger(torque, pairs * self.mean_radius * self.least_force)

    @abstractmethod
    def torque(self, ratio: Any) -> Any:
        """Slip torque that lasts, friction times ``ratio`` and rising, N·m."""

    @cached_property
    def sliding(self) -> Any:
        """Sliding torque T(f), friction rising, N·m."""
        return self.torque(1.0)

    @cached_property
    def breakaway(self) -> Any:
        """Torque at which the clutch at rest slips under a load that rises slowly, T(r_s f), N·m."""
        return self.torque(self.static_ratio)

    @property
    def least(self) -> Values:
        """Smallest slip torque, N·m; of an indirect clutch that of a sleeve that moves back to its stop."""
        return self.sliding

    @property
    @abstractmethod
    def growth(self) -> float:
        """Derivative ∂T/∂(f(v)/f) of the slip torque by the friction ratio where slip begins, N·m."""

    def turn_under(self, torque: float) -> Values:
        """Turn of the balls at rest after the torque has risen to ``torque``, rad; 0 at the stop."""
        return 0.0

    def judder(self, slip: Any) -> Any:
        """Damping of the driven half below which slip swings more and more (V6), N·m·s/rad."""
        decay = self.decay_rate * (np.asarray(self.static_ratio) > 1)
        return self.growth * (self.static_ratio - 1) * decay * np.exp(-decay * slip)

    def juddering_slip(self, damping: Any) -> Any:
        """Slip below which it judders, rad/s; 0 where it never does."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(self.judder(0.0) > damping, np.log(self.judder(0.0) / damping) / self.decay_rate, 0.0)

    @abstractmethod
    def sticks_up_to(self, turn: Values, normal: Values) -> Values:
        """Torque up to which nothing of a stuck clutch slips or moves, N·m."""

    @abstractmethod
    def leaning(self, turn: Any) -> Any:
        """Normal force of the pocket walls times the radius of the ball circle, over the torque of the clutch."""


@dataclass(frozen=True)
class DirectPack(Pack):
    """Discs of a direct clutch at one friction; numbers, or arrays in a sweep."""

    closing_force: Any
    mean_radius: Any
    bypass_pairs: Any
    controlled_pairs: Any
    gain: Any
    driving: Any
    """f_1."""
    driven: Any
    """f_2."""
    static_ratio: Any = 1.0
    decay_rate: Any = 0.0
    """R/v_s, s/rad."""
    lag: Any = 0.0
    """τ, s."""
    lever: float = 0.0
    """r/R; 0 where the circle of the balls is not known."""

    travels = False
    least_force = -math.inf
    lift = math.inf

    def __post_init__(self) -> None:
        """Calculate what does not change; no key makes rise and fall of the torque differ."""
        through_balls = self.controlled_pairs * self.driven
        pairs = self.bypass_pairs * self.driving + through_balls
        # of the torque, below slip too (S22 for one material)
        share = through_balls / pairs
        vars(self).update(
            friction_pairs=pairs,
            resting_force=self.closing_force,
            ball_share=share,
            stop_gains=(self.gain * share, self.gain * share),
        )

    def _law(self, ratio: Any) -> tuple[Any, ...]:
        """Arguments of the direct law, friction times ``ratio``."""
        pairs = self.bypass_pairs, self.controlled_pairs
        return self.closing_force, self.mean_radius, *pairs, self.gain, ratio * self.driving, ratio * self.driven

    def torque(self, ratio: Any) -> Any:
        """Slip torque with friction times ``ratio`` and without lag, N·m."""
        return direct.torque(*self._law(ratio))

    def potential(self, torque: float, ratio: float) -> float:
        """T_п: torque at which the pack slips under the release force of ``torque``, friction times ``ratio``."""
        return self.carried(self.pressed_at_stop(torque, self.stop_gains[0]), ratio)

    @property
    def growth(self) -> float:
        """∂T/∂(f(v)/f) where the release force follows the torque, N·m."""
        return drive.torque_growth(*self._law(self.static_ratio)) / self.static_ratio

    def sticks_up_to(self, turn: Values, normal: Values) -> Values:
        """T(r_s f); with lag no more than the present normal force carries, N·m."""
        breakaway = self.torque(self.static_ratio)
        return smaller(breakaway, self.carried(normal, self.static_ratio)) if np.any(self.lag) else breakaway

    def leaning(self, turn: Any) -> Any:
        """Share of the torque that passes the balls, divided by cos α, where tan α = C r/R."""
        return self.ball_share * (1 + (self.gain * self.lever) ** 2) ** 0.5


@dataclass(frozen=True)
class Sleeve(Pack):
    """Discs, springs, key and balls of an indirect clutch at one friction; numbers, or arrays in a sweep."""

    law: Quantities
    friction: Any
    mass: Any = 0.0
    static_ratio: Any = 1.0
    decay_rate: Any = 0.0
    """R/v_s, s/rad."""
    lever: float = 0.0
    """r/R; 0 where the circle of the balls is not known."""

    travels = True
    lag = 0.0
    closing_spring: ClassVar[SetSpring]
    control_spring: ClassVar[SetSpring]
    stop_gain: ClassVar[Any]
    """C at the stop."""
    gain_slope: ClassVar[Any]
    """C_1, 1/m; 0 of a straight wall."""

    def __post_init__(self) -> None:
        """Ask the law once for what does not change."""
        law, returning = self.law, self.law["net_gain_returning"]
        net = larger(law["net_gain"], _IDLE) if is_array(law["net_gain"]) else law["net_gain"]
        springs = {
            name: SetSpring(law[f"{name}_force"], law[f"{name}_stiffness"], law.given.get(f"{name}_disc"))
            for name in ("closing", "control")
        }
        straight = all(spring.disc is None for spring in springs.values())
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
            straight_springs=tuple(spring.straight_stiffness for spring in springs.values()) if straight else None,
            stop_gains=(net, returning),
            **{f"{name}_spring": spring for name, spring in springs.items()},
        )

    @cached_property
    def lift(self) -> Any:
        """S(0)/κ."""
        return self.moment(0.0) / self.net_gain

    @cached_property
    def farthest(self) -> Any:
        """Travel at which the closing spring is slack, m."""
        return self.closing_spring.deflection

    def torque(self, ratio: Any) -> Any:
        """Slip torque that lasts, friction times ``ratio`` and rising, N·m."""
        return self.law.at(friction=ratio * self.friction)["torque"]

    @property
    def least(self) -> Values:
        """Slip torque while the sleeve moves back from its largest travel, N·m."""
        own = self.law
        # they may follow from f_max, which is not meant here
        fixed = {name: own[name] for name in ("friction_mean", "gain_slope") if name in own}
        return own.at(friction=self.friction, friction_max=_FAR, **fixed)["torque_returning"]

    @property
    def growth(self) -> float:
        """∂T/∂(f(v)/f) while the key keeps the sleeve in its place, N·m."""
        return self.torque(self.static_ratio) / self.static_ratio

    def sticks_up_to(self, turn: Values, normal: Values) -> Values:
        """T(r_s f); off the stop no more than the present normal force carries, N·m.

        Below this torque a swing of the sleeve only loses energy to the key.
        """
        breakaway = self.torque(self.static_ratio)
        off_stop = self.carried(self.pressed(self.travel(turn)), self.static_ratio)
        return np.where(np.asarray(turn) == 0, breakaway, smaller(breakaway, off_stop))

    def leaning(self, turn: Any) -> Any:
        """1/cos α at a turn of the balls, where tan α = C r/R."""
        return (1 + (self.gain(self.travel(turn)) * self.lever) ** 2) ** 0.5

    def steeper(self, net_gain: Any, travel: Any) -> Any:
        """C, κ or κ₊ at a travel, from its value at the stop."""
        return curved.gain_acting(net_gain, self.gain_slope, travel)

    def gain(self, travel: Any) -> Any:
        """C at a travel."""
        return self.steeper(self.stop_gain, travel)

    def moment(self, travel: Any) -> Any:
        """S(x), N·m."""
        if self.straight_springs is not None:
            springs = self.closing_force, self.resting_force, *self.straight_springs
            return sleeve.spring_moment(self.mean_radius, *springs, travel)
        control = self.control_spring.force(travel)
        return sleeve.spring_moment(self.mean_radius, self._slackened(travel), control, 0.0, 0.0, 0.0)

    def work(self, travel: Any) -> Any:
        """Work stored in both springs, J; Simpson's rule is exact, for the force of a disc spring is a cubic."""
        mean = (self.moment(0 * travel) + 4 * self.moment(travel / 2) + self.moment(travel)) / 6
        return mean / self.mean_radius * travel

    def pressed(self, travel: Any) -> Any:
        """Normal force off the stop, N: that of the closing spring, 0 once the spring is slack."""
        return larger(self._slackened(travel), 0.0)

    def _slackened(self, travel: Any) -> Any:
        return self.closing_spring.force(-self._slackening(travel))

    def _slackening(self, travel: Any) -> Any:
        """How far the closing spring has lengthened, m: a slack disc spring no more."""
        return travel if self.closing_spring.disc is None else smaller(travel, self.farthest)

    def _stiffnesses(self, travel: Any) -> tuple[Any, Any]:
        """c_1 and c_2 at a travel, N/m."""
        closing, control = self.closing_spring, self.control_spring
        return closing.stiffness(-self._slackening(travel)), control.stiffness(travel)

    def travel(self, turn: Any) -> Any:
        """Travel of the sleeve for a turn of the balls in either direction, m."""
        return sleeve.travel(abs(turn), self.mean_radius, self.stop_gain, self.gain_slope)

    def turn_under(self, torque: float) -> Values:
        """Turn of the balls at rest after the torque has risen to ``torque``, rad; 0 up to T_н."""
        if self.straight_springs is None:
            travel = root(
                lambda at: self.moment(at) - torque * self.net_gain,
                lambda at: self.mean_radius * sum(self._stiffnesses(at)),
                self.farthest + 0.0 * (torque * self.net_gain),
            )
        else:
            lifted = torque * self.net_gain / self.mean_radius - (self.resting_force - self.closing_force)
            off = lifted > _ROUNDING * self.resting_force
            stiffness = sum(self._stiffnesses(0.0)) - torque * self.gain_slope / self.mean_radius
            # at the stop the 1 prevents 0/0: there a constant-torque pocket has no stiffness
            travel = off * lifted / (stiffness + (1 - 1 * off))
        return sleeve.turn(travel, self.mean_radius, self.stop_gain, self.gain_slope)

    def inertia(self, travel: Any, net_gain: Any) -> Any:
        """Moment of inertia that the sleeve's mass adds to the turn of the balls, kg·m²."""
        return sleeve.sleeve_inertia(self.mass, self.mean_radius, self.gain(travel), net_gain)

    def speed(self, travel: Any, rate: Any) -> Any:
        """Speed of the sleeve for a rate of the turn, m/s."""
        return sleeve.travel_rate(rate, self.mean_radius, self.gain(travel))

    def driving_moment(self, travel: Any, rate: Any) -> Any:
        """Moment of both springs minus the inertia moment of a sleeve that moves along a curved wall, N·m."""
        moment = self.moment(travel)
        if not is_array(self.mass) and not self.mass:
            return moment
        slope, speed = self.gain_slope, self.speed(travel, rate)
        return moment - sleeve.centrifugal_moment(self.mass, self.mean_radius, self.gain(travel), slope, speed)

    def key_limits(self, travel: Any) -> tuple[Any, Any]:
        """Smallest and largest ball torque at which the key keeps a sleeve off its stop at rest, S/κ₊ and S/κ, N·m."""
        moment = self.moment(travel)
        return (
            moment / self.steeper(self.net_gain_returning, travel),
            moment / self.steeper(self.net_gain, travel),
        )

    def torsional(self, travel: Any, net_gain: Any, torque: Any) -> Any:
        """Stiffness against a turn, N·m/rad."""
        slope = self.gain_slope
        return sleeve.torsional_stiffness(
            *self._stiffnesses(travel), self.mean_radius, net_gain, self.gain(travel), slope, torque
        )


def pack_of(clutch: Clutch, driving: Values, driven: Values) -> "DirectPack | Sleeve":
    """Return the clutch at one friction.

    Raises:
        CalculationError: a sleeve that would be off its stop without load.
    """
    bypass, controlled, gain = (clutch[name] for name in ("bypass_pairs", "controlled_pairs", "gain"))
    if not clutch.spec.kind.travels:
        return _discs(clutch, clutch["closing_force"], bypass, controlled, gain, driving, driven)
    net, control, closing = (clutch[name] for name in ("net_gain", "control_force", "closing_force"))
    if not is_array(net) and not net:
        # κ = 0: the key's friction equals the feedback, and the clutch acts as an ordinary one
        return _discs(clutch, closing, clutch["pairs"], 0.0, 0.0, driving, driven)
    below = np.asarray(control < closing)
    if below.any():
        raise CalculationError(
            "simulate: the control spring ({control:.5g N}) must press more than the closing spring "
            "({closing:.5g N}), else the sleeve is off its stop without load",
            control=np.broadcast_to(control, below.shape)[below].flat[0],
            closing=np.broadcast_to(closing, below.shape)[below].flat[0],
        )
    return Sleeve(clutch, driving, _of_unit(clutch, "sleeve_mass"), *_static_and_lever(clutch))


def ordinary_pack(clutch: Clutch, driving: Values, driven: Values) -> DirectPack:
    """Return the same discs without control unit, set for the same nominal torque."""
    bypass = clutch["bypass_pairs"]
    pack = bypass, clutch["pairs"] - bypass, 0.0
    at_setting = clutch["friction_driving_set"], clutch["friction_driven_set"]
    arm = direct.torque_per_force(clutch["mean_radius"], *pack, *at_setting)
    force = adjustment.closing_force(clutch["nominal_torque"], clutch["margin_in_spring"], arm)
    return replace(_discs(clutch, force, *pack, driving, driven), lag=0.0)


def _discs(
    clutch: Clutch, force: Any, bypass: Any, controlled: Any, gain: Any, driving: Values, driven: Values
) -> DirectPack:
    ratio, decay, lever = _static_and_lever(clutch)
    pack = force, clutch["mean_radius"], bypass, controlled, gain
    return DirectPack(*pack, driving, driven, ratio, decay, _of_unit(clutch, "release_lag"), lever)


def _of_unit(clutch: Clutch, key: str) -> Any:
    """A value of the control unit; 0 where there is none."""
    value = getattr(clutch.spec.control_unit, key, None)
    return 0.0 if value is None else value


def _static_and_lever(clutch: Clutch) -> tuple[Any, Any, Any]:
    """Static over sliding friction, R/v_s by which it decays with the slip, and r/R; 0 what is not known."""
    friction, radius = clutch.spec.friction, clutch["mean_radius"]
    ratio = 1.0 if friction.static_ratio is None else friction.static_ratio
    decay = 0.0 if friction.stribeck_speed is None else radius / friction.stribeck_speed
    return ratio, decay, _of_unit(clutch, "ball_circle_radius") / radius
