"""An indirect clutch in its drive: the pack, and behind the hub the balls with their sleeve, two elements in series."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import exp

import numpy as np

from ..arrays import Values
from ..equations import direct, sleeve
from ..equations import drive as law
from .consistent import SleevePlant, switched
from .plant import DECAYED, Creep, Mode, Sliding, State, Tool, Torques
from .sleeve import Sleeve
from .train import Train

_CLOSE = 1e-9
"""Relative tolerance within which an element at its limit still sticks."""


@dataclass(frozen=True)
class IndirectPlant(SleevePlant):
    """Motor side, pack, hub, balls, driven half, shaft, tool."""

    train: Train
    sleeve: Sleeve

    size = 7

    @cached_property
    def tool(self) -> Tool:  # type: ignore[override]
        """What stands behind the shaft."""
        return Tool(self.train)

    @cached_property
    def sliding(self) -> float:  # type: ignore[override]
        """T(f), friction rising."""
        return float(self.sleeve.torque(1.0))

    @cached_property
    def least(self) -> float:  # type: ignore[override]
        """T(f) as the sleeve returns."""
        return float(self.sleeve.least)

    @cached_property
    def breakaway(self) -> float:  # type: ignore[override]
        """T(r_s f)."""
        return float(self.sleeve.torque(self.sleeve.static_ratio))

    @property
    def growth(self) -> float:
        """∂T/∂(f(v)/f) with the sleeve where its key holds it."""
        return self.breakaway / self.sleeve.static_ratio

    @cached_property
    def _moment_time(self) -> float:
        """Time over which the growth of the balls' torque is taken, s."""
        return 1e-6 * float((self.train.driven_inertia / self.train.stiffness) ** 0.5)

    def start(self) -> State:
        """Running under the load; beyond T_н the sleeve is off its stop."""
        train, own = self.train, self.sleeve
        locked = train.kind == "stop" and not train.time
        turn, held = float(own.turn_under(train.load)), own.pressed_at_stop(train.load, own.stop_gains[0])
        return [0.0, train.speed, train.load / train.stiffness, 0.0 if locked else train.speed, 0.0, turn, held]

    def scales(self) -> State:
        """Size of every state."""
        speed, twist = self.train.speed, self.sliding / self.train.stiffness
        return [speed, speed, twist, speed, speed, twist, self.sleeve.control_force]

    def motor_speed(self, y: Sequence[float]) -> float:
        """ω_1 = ω_2 + w + v."""
        return y[self.DRIVEN] + y[self.RATE] + y[self.V]

    def travel(self, y: Sequence[float]) -> float:
        """x = R |φ|/C."""
        return self.sleeve.travel(y[self.TURN])

    def leaning(self, y: Sequence[float]) -> float:
        """tan α = C r/R, where the sleeve is."""
        return self.sleeve.gain(self.travel(y)) * self.sleeve.lever

    def _pairs(self, slip: float) -> float:
        """z f at a slip."""
        own = self.sleeve
        if own.static_ratio == 1:
            return own.friction_pairs
        return own.friction_pairs * float(law.stribeck_ratio(own.static_ratio, exp(-own.decay_rate * abs(slip))))

    def _net(self, mode: Mode) -> float:
        """κ or κ₊, as the key resists."""
        own = self.sleeve
        if mode.balls == "seat":
            return own.stop_gains[mode.hold < 0]
        return own.net_gain if mode.balls == "out" else own.net_gain_returning

    def normal(self, y: Sequence[float], mode: Mode, balls: float) -> float:
        """Normal force on the pairs; a pack that the springs leave has none."""
        own = self.sleeve
        if mode.balls != "seat":
            return max(0.0, own.pressed(self.travel(y)))
        return own.pressed_at_stop(balls, self._net(mode)) if mode.hold else y[self.HELD]

    def torques(self, t: float, y: Sequence[float], mode: Mode) -> Torques:
        """Torques that follow from states and mode."""
        shaft, motor = self.shaft(y), self.motor(self.motor_speed(y), mode)
        clutch, balls = self._pack_and_balls(y, mode, motor, shaft)
        return Torques(motor, clutch, balls, shaft)

    def _pack_and_balls(self, y: Sequence[float], mode: Mode, motor: float, shaft: float) -> tuple[float, float]:
        train, side = self.train, mode.side
        first, hub, last = train.motor_inertia, train.hub_inertia, train.driven_inertia
        if mode.balls in ("out", "back"):
            if mode.pack:
                clutch = mode.pack * direct.group_torque(
                    self.normal(y, mode, 0.0), self.sleeve.mean_radius, 1.0, self._pairs(y[self.V])
                )
                return clutch, side * self._moving(y, mode, side * clutch, hub, side * shaft)
            balls = side * self._moving(y, mode, side * motor, first + hub, side * shaft)
            return law.sticking_torque(motor, first, balls, hub), balls
        if not mode.pack:
            stuck = law.sticking_torque(motor, first, shaft, hub + last)
            return stuck, law.sticking_torque(motor, first + hub, shaft, last)
        clutch = mode.pack * self._slipping_still(y, mode, mode.pack * shaft)
        return clutch, law.sticking_torque(clutch, hub, shaft, last)

    def _moving(self, y: Sequence[float], mode: Mode, drive: float, inertia: float, load: float) -> float:
        """Torque of the balls on the wall they are on, while the sleeve moves."""
        own, travel = self.sleeve, self.travel(y)
        net = own.steeper(self._net(mode), travel)
        moment = own.moment(travel) - own.taken(travel, y[self.RATE])
        torque: float = sleeve.ball_torque_moving(
            moment, net, own.inertia(travel, net), drive, inertia, load, self.train.driven_inertia
        )
        return torque

    def _slipping_still(self, y: Sequence[float], mode: Mode, load: float) -> float:
        """Torque of the slipping pack while the sleeve stands, along the slip; ``load`` that of the shaft along it."""
        train, own, pairs = self.train, self.sleeve, self._pairs(y[self.V])
        if mode.balls == "seat" and mode.hold:
            net = self._net(mode) * (mode.side * mode.pack)
            alone: float = law.sticking_torque(0.0, train.hub_inertia, load, train.driven_inertia)
            share = train.driven_inertia / (train.hub_inertia + train.driven_inertia)
            return own.slipping_at_stop(pairs, net, alone, share)
        pressed: float = direct.group_torque(self.normal(y, mode, 0.0), own.mean_radius, 1.0, pairs)
        return pressed

    def rates(self, t: float, y: Sequence[float], mode: Mode) -> State:
        """Newton, and the work of motor, pack, shaft, tool and key."""
        train, own = self.train, self.sleeve
        motor, clutch, balls, shaft = self.torques(t, y, mode)
        slip, driven, _, tool, rate, *_ = y
        twisting = driven - tool
        moving = mode.balls in ("out", "back")
        turning = (
            law.slip_acceleration(clutch, train.hub_inertia, balls, shaft, train.driven_inertia) if moving else 0.0
        )
        travel = self.travel(y)
        moment = own.moment(travel) - own.taken(travel, rate)
        speed, growth = (mode.side * own.speed(travel, each) for each in (rate, turning))
        return [
            law.slip_acceleration(motor, train.motor_inertia, clutch, balls, train.hub_inertia) if mode.pack else 0.0,
            (balls - shaft) / train.driven_inertia,
            twisting,
            self.tool.rate(t, mode, shaft),
            turning,
            rate,
            0.0,
            motor * (driven + rate + slip),
            clutch * slip,
            train.damping * twisting * twisting,
            self.tool.power(t, mode, shaft, tool),
            balls * rate - (moment / own.mean_radius + own.mass * growth) * speed,
        ]

    def stored(self, y: Sequence[float]) -> float:
        """Kinetic and elastic energy, J."""
        train, own = self.train, self.sleeve
        moving = (
            train.motor_inertia * self.motor_speed(y) ** 2
            + train.hub_inertia * (y[self.DRIVEN] + y[self.RATE]) ** 2
            + train.driven_inertia * y[self.DRIVEN] ** 2
            + train.tool_inertia * y[self.TOOL] ** 2
            + own.mass * own.speed(self.travel(y), y[self.RATE]) ** 2
        )
        return float(moving + train.stiffness * y[self.TWIST] ** 2) / 2 + own.work(self.travel(y))

    def steadily(self, t: float, y: Sequence[float], mode: Mode) -> Sliding | None:
        """Sliding friction alone, with the sleeve where its key holds it."""
        train, own = self.train, self.sleeve
        if mode.balls not in ("seat", "lock") or (mode.balls == "seat" and mode.hold):
            return None
        pressed = self.normal(y, mode, 0.0)
        torque = float(direct.group_torque(pressed, own.mean_radius, 1.0, own.friction_pairs))
        if mode.balls == "lock":
            low, high = self.limits(y)
        else:
            low, high = (
                (own.control_force - pressed) * own.mean_radius / net for net in (own.net_gain_returning, own.net_gain)
            )
            high = min(high, own.lift)
        both = train.hub_inertia + train.driven_inertia
        most = min(high - torque, torque - low) * both / train.hub_inertia
        slip = DECAYED / own.decay_rate if own.static_ratio > 1 else 0.0
        return Sliding(mode.pack * torque, both, most, slip) if mode.pack == mode.side else None

    def creeping(self, mode: Mode) -> Creep | None:
        """At the stop along κ or κ₊, the balls with the torque of the pack; not so far that the sleeve would leave."""
        own, train = self.sleeve, self.train
        smooth = own.stop_gains[0] == own.stop_gains[1] or (mode.hold > 0 and own.static_ratio > 1)
        if mode.balls != "seat" or mode.pack != mode.side or not mode.hold or not smooth:
            return None
        net, both = self._net(mode), train.hub_inertia + train.driven_inertia

        def torque(slip: Values) -> Values:
            ratio: Values = law.stribeck_ratio(own.static_ratio, np.exp(-own.decay_rate * slip))
            return own.slipping_at_stop(own.friction_pairs * ratio, net, 0.0, 1.0)

        share = own.friction_pairs * net * train.driven_inertia / both
        # a swing of the shaft takes a share of its torque back from the pack
        inertia = both * (1 + share) / (1 + own.friction_pairs * net)
        steep = float(torque(0.0)) * (own.static_ratio - 1) * own.decay_rate
        least = self.creeps_to(steep, inertia, own.decay_rate if own.static_ratio > 1 else 0.0)
        return Creep(torque, inertia, least) if torque(least) < own.lift * (1 - _CLOSE) else None

    def guards(self, t: float, y: Sequence[float], mode: Mode, torques: Torques) -> list[float]:
        """Positive while the mode lasts, in the order of ``Guard``."""
        own = self.sleeve
        along = mode.side * torques.balls
        stuck = self.capacity(y, mode, torques.balls) - abs(torques.clutch)
        pack = mode.pack * y[self.V] if mode.pack else stuck
        tool = self.tool.guard(t, mode, torques.shaft, y[self.TOOL])
        if mode.balls == "seat":
            hold = self._hold_guard(t, y, mode, along)
            return [pack, tool, own.lift - along, hold, 1.0, along + _CLOSE * own.lift]
        if mode.balls == "lock":
            low, high = self.limits(y)
            return [pack, tool, min(high - along, along - low), 1.0, 1.0, 1.0]
        out = mode.side * y[self.RATE]
        if mode.balls == "out":
            return [pack, tool, out, 1.0, 1.0, 1.0]
        return [pack, tool, -out, 1.0, mode.side * y[self.TURN], 1.0]

    def capacity(self, y: Sequence[float], mode: Mode, balls: float) -> float:
        """Largest torque of the pack at rest."""
        pressed = self.normal(y, mode, balls)
        return float(direct.group_torque(pressed, self.sleeve.mean_radius, 1.0, self._pairs(0.0)))

    def swings_out(self, y: Sequence[float], mode: Mode, peak: float) -> bool:
        """Of a constant motor: all the energy left moves neither sleeve nor shaft so far."""
        train, own = self.train, self.sleeve
        if mode.powered and train.engine.slip is not None:
            return False
        rest = train.engine.torque if mode.powered else 0.0
        most = np.float64(min(peak, self.tool.holds(mode)))
        with np.errstate(all="ignore"):
            turn = own.turn_under(np.float64(self.breakaway))
            slipping = own.work(own.travel(turn)) - rest * turn
            higher = (most - rest) ** 2 / (2 * train.stiffness)
            held = rest * rest / (2 * train.stiffness)
            left = self.stored(y) - rest * (y[self.TWIST] + y[self.TURN]) + held
            return bool(rest < most and left <= slipping and left <= higher)

    def sticks_up_to(self, t: float, y: Sequence[float], mode: Mode) -> float:
        """Torque at which the sleeve leaves where it is, or the pack slips."""
        return float(self.sleeve.sticks_up_to(y[self.TURN]))

    def limits(self, y: Sequence[float]) -> tuple[float, float]:
        """Torques between which the key holds the sleeve off its stop."""
        own = self.sleeve
        travel = self.travel(y)
        moment, nets = own.moment(travel), (own.net_gain_returning, own.net_gain)
        low, high = (moment / own.steeper(net, travel) for net in nets)
        return low, high

    def _hold_guard(self, t: float, y: Sequence[float], mode: Mode, along: float) -> float:
        own = self.sleeve
        if own.stop_gains[0] == own.stop_gains[1]:
            return 1.0
        if mode.hold:
            ahead = [a + self._moment_time * rate for a, rate in zip(y, self.rates(t, y, mode), strict=True)]
            later = mode.side * self.torques(t + self._moment_time, ahead, mode).balls
            return mode.hold * (later - along) + 1e-11 * own.lift
        low, high = own.play(along)
        return min(high - y[self.HELD], y[self.HELD] - low) + 1e-10 * own.control_force

    def switched(self, t: float, y: State, mode: Mode, hit: int | None) -> tuple[State, Mode]:
        """Bring to rest what has come to rest, then find the mode in which nothing contradicts."""
        return switched(self, t, list(y), mode, hit)
