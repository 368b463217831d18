"""One clutch in its drive during an event: states and their rates, what sticks or slips, and when that changes.

Between two switches every element either sticks or slips, and the equations are smooth. A *mode* says which; a *guard*
is positive while the mode lasts. Pack and balls share the hub, so that both are decided together: of the modes
that the states allow, the next one is the mode without a contradiction. A contradiction is a torque too large for an
element that sticks, or an acceleration against the slip. After the state machine of Otter, Elmqvist and
Mattsson (1999).
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property
from itertools import product
from typing import Any, Literal, NamedTuple

from ..equations import drive, sleeve
from .pack import Pack
from .train import Train

State = list[float]
V, DRIVEN, TWIST, TOOL, RATE, TURN, NORMAL = range(7)
"""Places in the state: slip v of the pack, ω_2, twist of the shaft, ω_3, w = ω_h − ω_2, turn φ of the balls, and the
normal force, which is a state while the key sticks at the stop, or with lag."""
SIZE = 7
WORKS = 5
"""Number of works that are integrated after the states: of motor, pack, shaft, tool, key."""
FAST = 20.0
"""Decays per radian of the shaft's swing above which an implicit method is used."""
_ROUNDING = 1e-9
"""Relative contradiction up to which rounding is the cause."""
_NOTHING = 1e-8
"""Share of the drive's energy below which a swing of the balls at their stop is ended: 0.005 % of a peak."""
_CLOSE = 1e-9
"""Relative tolerance within which an element at its limit still sticks."""


class Mode(NamedTuple):
    """Which elements stick, which slip, and the stage of the event."""

    pack: int = 0
    """Sign of the slip of the friction pack; 0 where it sticks."""
    tool: int = 1
    """Sign of the tool's motion; 0 where it stands."""
    over: bool = False
    """Whether the tool has been stopped, or the load has risen."""
    powered: bool = True
    balls: Literal["seat", "lock", "out", "back"] = "seat"
    """At the stop, or off the stop: at rest by the key, moving out, or moving back; in a direct clutch "seat"."""
    side: int = 1
    """Wall on which the balls are, or the sign of their torque at the stop."""
    hold: int = 1
    """At the stop: 1 while the torque rises (κ), −1 while it falls (κ₊), 0 where N is a state (key sticks, N lags)."""

    @property
    def moving(self) -> bool:
        """Whether the balls move."""
        return self.balls in ("out", "back")

    @property
    def still(self) -> bool:
        """Whether motor side, hub and driven half turn at one speed."""
        return not self.pack and not self.moving


class Guard(IntEnum):
    """What may end a mode; a direct clutch has the first two."""

    PACK = 0
    TOOL = 1
    BALLS = 2
    HOLD = 3
    STOP = 4
    SIDE = 5


_GUARDS = {
    "seat": (Guard.PACK, Guard.TOOL, Guard.BALLS, Guard.HOLD, Guard.SIDE),
    "lock": (Guard.PACK, Guard.TOOL, Guard.BALLS),
    "out": (Guard.PACK, Guard.TOOL, Guard.BALLS),
    "back": (Guard.PACK, Guard.TOOL, Guard.BALLS, Guard.STOP),
}


class Torques(NamedTuple):
    """Torques at one moment, N·m."""

    motor: float
    clutch: float
    """Of the friction pack."""
    balls: float
    """Between hub and driven half: of the balls, or all that a direct clutch passes."""
    shaft: float


@dataclass(frozen=True)
class Plant:
    """Motor side, pack, hub, balls, driven half, shaft, tool; a direct clutch has no hub."""

    train: Train
    pack: Any
    """Its ``Pack``."""

    @cached_property
    def sliding(self) -> float:
        """Sliding torque T(f), friction rising."""
        return float(self.pack.torque(1.0))

    @cached_property
    def breakaway(self) -> float:
        """Torque at which the clutch at rest slips under a load that rises slowly, T(r_s f)."""
        return float(self.pack.torque(self.pack.static_ratio))

    @cached_property
    def least(self) -> float:
        """Smallest sliding torque; of an indirect clutch that of a sleeve that moves back to its stop."""
        return float(self.pack.least)

    @cached_property
    def natural(self) -> float:
        """Natural frequency of the driven half alone on the shaft, rad/s."""
        return math.sqrt(float(self.train.stiffness / self.train.driven_inertia))

    @cached_property
    def moment(self) -> float:
        """Time step by which ``_key_guard`` sees whether a torque rises, s."""
        return 1e-6 / self.natural

    @property
    def stiff(self) -> bool:
        """Whether something decays so much faster than the shaft swings that an explicit method would crawl."""
        train = self.train
        damped = train.damping > FAST * math.sqrt(train.stiffness * train.driven_inertia)
        return damped or 0 < self.pack.lag * self.natural < 1 / FAST

    def start(self) -> State:
        """States before the event: steady running under the load; beyond T_н the sleeve is off its stop."""
        train, pack = self.train, self.pack
        tool = 0.0 if train.kind == "stop" and not train.time else train.speed
        turn, normal = pack.turn_under(train.load), pack.pressed_at_stop(train.load, pack.stop_gains[0])
        return [0.0, train.speed, train.load / train.stiffness, tool, 0.0, float(turn), normal]

    def scales(self) -> State:
        """Size of every state and work, for the tolerance of the integration."""
        speed, twist, turn = self.train.speed, self.sliding / self.train.stiffness, float(self.pack.farthest_turn)
        return [speed, speed, twist, speed, speed, turn, self.pack.resting_force, *[self.stored(self.start())] * WORKS]

    def swing(self, mode: Mode) -> float:
        """Period of the oscillation on the shaft while pack and balls stick, s."""
        inertia, tool = self.train.front, self.train.tool_inertia
        if self.train.kind == "load" and mode.tool:
            inertia = inertia * tool / (inertia + tool)
        return 2 * math.pi * math.sqrt(inertia / self.train.stiffness)

    def motor_speed(self, y: Sequence[float]) -> float:
        """ω_1 = ω_2 + w + v, rad/s."""
        return y[DRIVEN] + y[RATE] + y[V]

    def motor(self, speed: float, mode: Mode) -> float:
        """Torque of the motor, N·m."""
        return float(self.train.engine.at(speed)) if mode.powered else 0.0

    def travel(self, y: Sequence[float]) -> float:
        """Travel of the sleeve, m."""
        return self.pack.travel(y[TURN]) if y[TURN] else 0.0

    def _along(self, y: Sequence[float], mode: Mode) -> float:
        """Travel along the wall of a mode, m; it goes on smoothly past the stop, as a step of the integration may."""
        turn = mode.side * y[TURN]
        return self.pack.travel(turn) if turn > 0 else self.pack.speed(0.0, turn)

    def shaft(self, y: Sequence[float]) -> float:
        """Torque in the shaft, N·m."""
        return drive.shaft_torque(self.train.stiffness, y[TWIST], self.train.damping, y[DRIVEN] - y[TOOL])

    def resistance(self, t: float, mode: Mode) -> float:
        """Torque of the load, N·m."""
        return self.train.overload if mode.over else self.train.load_at(t)

    @property
    def holds(self) -> float:
        """Torque up to which a tool that has come to rest stands, N·m."""
        return math.inf if self.train.kind == "stop" else self.train.overload

    def net_gain(self, mode: Mode) -> float:
        """κ or κ₊ at the stop, by the direction in which the key resists."""
        if mode.balls == "seat":
            return self.pack.stop_gains[mode.hold < 0]
        return self.pack.net_gain if mode.balls == "out" else self.pack.net_gain_returning

    def normal(self, y: Sequence[float], mode: Mode, balls: float) -> float:
        """Normal force on the pairs."""
        if mode.balls != "seat":
            return self.pack.pressed(self._along(y, mode))
        return self.pack.pressed_at_stop(balls, self.net_gain(mode)) if mode.hold else y[NORMAL]

    def capacity(self, y: Sequence[float], mode: Mode, balls: float) -> float:
        """Largest torque of the pack at rest."""
        return self.pack.carried(self.normal(y, mode, balls), self.pack.static_ratio)

    def torques(self, t: float, y: Sequence[float], mode: Mode) -> Torques:
        """Torques in a mode at given states."""
        train, pack, side = self.train, self.pack, mode.side
        shaft, motor = self.shaft(y), self.motor(self.motor_speed(y), mode)
        first, hub, last = train.motor_inertia, train.hub_inertia, train.driven_inertia
        if mode.moving:
            travel = self._along(y, mode)
            if mode.pack:
                clutch = mode.pack * pack.carried(pack.pressed(travel), pack.ratio(y[V]))
                balls = side * self._on_wall(travel, y[RATE], mode, side * clutch, hub, side * shaft)
                return Torques(motor, clutch, balls, shaft)
            balls = side * self._on_wall(travel, y[RATE], mode, side * motor, first + hub, side * shaft)
            return Torques(motor, drive.sticking_torque(motor, first, balls, hub), balls, shaft)
        if not mode.pack:
            balls = drive.sticking_torque(motor, first + hub, shaft, last)
            clutch = drive.sticking_torque(motor, first, shaft, hub + last) if hub else balls
            return Torques(motor, clutch, balls, shaft)
        if mode.balls == "seat" and mode.hold:
            net = self.net_gain(mode) * (side * mode.pack if pack.travels else 1)
            alone, share = mode.pack * shaft * hub / (hub + last), last / (hub + last)
            clutch = mode.pack * pack.slipping_at_stop(pack.ratio(y[V]), net, alone, share)
        else:
            clutch = mode.pack * pack.carried(self.normal(y, mode, 0.0), pack.ratio(y[V]))
        return Torques(motor, clutch, drive.sticking_torque(clutch, hub, shaft, last) if hub else clutch, shaft)

    def _on_wall(self, travel: float, rate: float, mode: Mode, drive: float, inertia: float, load: float) -> float:
        """Torque of the balls on the wall they are on, while the sleeve moves."""
        pack = self.pack
        net, moment = pack.steeper(self.net_gain(mode), travel), pack.driving_moment(travel, rate)
        if not pack.mass:
            return moment / net
        mass = pack.inertia(travel, net)
        return sleeve.ball_torque_moving(moment, net, mass, drive, inertia, load, self.train.driven_inertia)

    def _behind(self, balls: float, shaft: float) -> tuple[float, float]:
        """Torque and inertia behind the pack: those of the hub, or of the driven half."""
        train = self.train
        return (balls, train.hub_inertia) if train.hub_inertia else (shaft, train.driven_inertia)

    def rates(self, t: float, y: Sequence[float], mode: Mode) -> State:
        """Time derivatives of the states, then the powers of motor, pack, shaft, tool and key."""
        train, pack = self.train, self.pack
        motor, clutch, balls, shaft = self.torques(t, y, mode)
        slip, driven, _, tool, rate, _, normal = y[:SIZE]
        twisting, turning, key, slipping, late = driven - tool, 0.0, 0.0, 0.0, 0.0
        if mode.moving:
            turning = (clutch - balls) / train.hub_inertia - (balls - shaft) / train.driven_inertia
            travel = self._along(y, mode)
            moment, gain = pack.driving_moment(travel, rate), pack.gain(travel)
            speed, growth = (mode.side * pack.mean_radius * each / gain for each in (rate, turning))
            key = balls * rate - (moment / pack.mean_radius + pack.mass * growth) * speed
        if mode.pack:
            behind, inertia = self._behind(balls, shaft)
            slipping = drive.slip_acceleration(motor, train.motor_inertia, clutch, behind, inertia)
        if pack.lag:
            late = drive.normal_force_rate(normal, pack.pressed_at_stop(clutch, pack.stop_gains[0]), pack.lag)
        if train.kind == "stop":
            stopping, power = (0.0 if mode.over else -train.speed / train.time), shaft * tool
        else:
            load = mode.tool * self.resistance(t, mode)
            stopping, power = ((shaft - load) / train.tool_inertia if mode.tool else 0.0), load * tool
        return [
            slipping,
            (balls - shaft) / train.driven_inertia,
            twisting,
            stopping,
            turning,
            rate,
            late,
            motor * (driven + rate + slip),
            clutch * slip,
            train.damping * twisting * twisting,
            power,
            key,
        ]

    def stored(self, y: Sequence[float]) -> float:
        """Kinetic and elastic energy, J."""
        train, travel = self.train, self.travel(y)
        energy = (
            train.motor_inertia * self.motor_speed(y) ** 2
            + train.hub_inertia * (y[DRIVEN] + y[RATE]) ** 2
            + train.driven_inertia * y[DRIVEN] ** 2
            + train.tool_inertia * y[TOOL] ** 2
            + train.stiffness * y[TWIST] ** 2
        ) / 2
        if self.pack.travels:
            energy += self.pack.mass * self.pack.speed(travel, y[RATE]) ** 2 / 2 + self.pack.work(travel)
        return float(energy)

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """What may end a mode."""
        return _GUARDS[mode.balls][: None if self.pack.travels else 2]

    def guard(self, which: Guard, t: float, y: Sequence[float], mode: Mode, torques: Torques) -> float:
        """Value of a guard, positive while the mode lasts; ``torques``: those of states and mode."""
        pack, along = self.pack, mode.side * torques.balls
        if which == Guard.PACK:
            stuck = not mode.pack
            return self.capacity(y, mode, torques.balls) - abs(torques.clutch) if stuck else mode.pack * y[V]
        if which == Guard.TOOL:
            if self.train.kind == "stop":
                return 1.0
            return mode.tool * y[TOOL] if mode.tool else self.resistance(t, mode) - abs(torques.shaft)
        if which == Guard.HOLD:
            return self._key_guard(t, y, mode, along)
        if which == Guard.STOP:
            return mode.side * y[TURN]
        if which == Guard.SIDE:
            return along + _CLOSE * pack.lift
        if mode.balls == "seat":
            return pack.lift - along
        if mode.balls == "lock":
            low, high = pack.key_limits(self.travel(y))
            return min(high - along, along - low)
        return mode.side * y[RATE] * (1 if mode.balls == "out" else -1)

    def _key_guard(self, t: float, y: Sequence[float], mode: Mode, along: float) -> float:
        """At the stop: positive while the torque keeps its direction, or while the key sticks."""
        pack = self.pack
        if pack.stop_gains[0] == pack.stop_gains[1]:
            return 1.0
        if mode.hold:
            ahead = [a + self.moment * rate for a, rate in zip(y, self.rates(t, y, mode), strict=False)]
            later = mode.side * self.torques(t + self.moment, ahead, mode).balls
            return mode.hold * (later - along) + 1e-11 * pack.lift
        low, high = pack.play(along)
        return min(high - y[NORMAL], y[NORMAL] - low) + 1e-10 * pack.resting_force

    def switched(self, t: float, y: State, mode: Mode, hit: Guard | None) -> tuple[State, Mode]:
        """Return states and mode after the guard ``hit`` fell below 0; None: after a stage of the event ended."""
        y, torques = list(y), self.torques(t, y, mode)
        normal = self.normal(y, mode, torques.balls)
        # what has come to rest
        if hit == Guard.PACK:
            y[V] = 0.0
        elif hit == Guard.TOOL and mode.tool:
            y[TOOL] = 0.0
        elif hit == Guard.BALLS and mode.moving:
            y[RATE] = 0.0
        elif hit == Guard.STOP:
            # the balls roll on to the other wall, unless the energy of their swing is negligible
            y[TURN] = 0.0
            self._seat(y, mode)
        # where the shaft tears a standing tool loose
        shaft, torn = self.shaft(y), hit == Guard.TOOL and not mode.tool
        loose = self.train.kind == "load" and (torn or abs(shaft) > self.resistance(t, mode))
        tool = _sign(y[TOOL] or shaft) if y[TOOL] or loose else 0
        if not self.pack.lag:
            y[NORMAL] = normal
        # the mode that a guard has ended is left out: else rounding could re-enter the same mode for ever
        modes = [
            new._replace(tool=tool)
            for new in self._allowed(y, mode, hit, torques, normal)
            if new != mode or hit in (None, Guard.TOOL)
        ]
        least = math.inf
        for each in modes:
            contradiction = self._contradiction(t, y, each)
            if contradiction < least:
                least, new = contradiction, each
            if not least:
                break
        return y, new

    def _seat(self, y: State, mode: Mode) -> None:
        """Give hub and driven half one speed if the energy of their swing is negligible; the key takes this energy."""
        train, stored = self.train, self.stored(y)
        hub = train.hub_inertia if mode.pack else train.motor_inertia + train.hub_inertia
        both = hub + train.driven_inertia
        if hub * train.driven_inertia / both * y[RATE] ** 2 > _NOTHING * self.stored(self.start()):
            return
        lost = y[RATE] * train.driven_inertia / both
        y[V] += lost if mode.pack else 0.0
        y[DRIVEN] += y[RATE] - lost
        y[RATE] = 0.0
        y[-1] += stored - self.stored(y)

    def _allowed(self, y: State, mode: Mode, hit: Guard | None, torques: Torques, normal: float) -> Iterator[Mode]:
        """Modes that the states allow, first those with more elements that stick; an element torn loose does not."""
        if y[V]:
            packs = [_sign(y[V])]
        elif hit == Guard.PACK and not mode.pack:
            packs = [_sign(torques.clutch)]
        else:
            packs = [0, 1, -1]
        at_stop = self._balls(y, mode, hit, torques, normal) if self.pack.travels else [("seat", 1, not self.pack.lag)]
        for pack, (balls, side, hold) in product(packs, at_stop):
            yield mode._replace(pack=pack, balls=balls, side=side, hold=int(hold))

    def _balls(
        self, y: State, mode: Mode, hit: Guard | None, torques: Torques, normal: float
    ) -> list[tuple[Any, int, int]]:
        """Possible motions of the balls, each with its side and ``Mode.hold``."""
        rate, turn = y[RATE], y[TURN]
        torn = hit == Guard.BALLS and not mode.moving
        if turn:
            side = _sign(turn)
            if rate:
                return [("out" if side * rate > 0 else "back", side, 1)]
            return [*([] if torn else [("lock", side, 1)]), ("out", side, 1), ("back", side, 1)]
        if rate:
            return [("out", _sign(rate), 1)]
        if torn:
            return [("out", mode.side, 1)]
        if hit == Guard.SIDE:
            return [("seat", -mode.side, 1)]
        if hit == Guard.HOLD:
            low, high = self.pack.play(torques.balls)
            reached = 1 if high - normal < normal - low else -1
            return [("seat", mode.side, 0 if mode.hold else reached)]
        sides, holds = (mode.side, -mode.side), dict.fromkeys((mode.hold, 1, 0, -1))
        at_stop = [("seat", side, hold) for side, hold in product(sides, holds)]
        return [*at_stop, *(("out", side, 1) for side in sides)]

    def _contradiction(self, t: float, y: State, mode: Mode) -> float:
        """Largest contradiction of a mode, relative to the sliding torque; 0 where there is none."""
        train, pack = self.train, self.pack
        torques = self.torques(t, y, mode)
        motor, clutch, balls, shaft = torques
        along, hub, wrong = mode.side * balls, train.hub_inertia, [0.0]
        if not mode.pack:
            wrong.append(abs(clutch) - self.capacity(y, mode, balls))
        elif not y[V]:
            behind, inertia = self._behind(balls, shaft)
            rate = drive.slip_acceleration(motor, train.motor_inertia, clutch, behind, inertia)
            wrong.append(-mode.pack * rate * inertia)
        if mode.balls == "seat" and pack.travels:
            # of ``mode.hold`` and the normal force, as a torque
            normal, (low, high) = y[NORMAL], pack.play(along)
            off = {1: high - normal, -1: normal - low, 0: max(normal - high, low - normal)}[
                mode.hold
            ] * pack.mean_radius
            if pack.stop_gains[0] == pack.stop_gains[1]:
                off = 0.0 if mode.hold > 0 else self.sliding
            wrong += [along - pack.lift, -along, off]
        elif mode.balls == "lock":
            low, high = pack.key_limits(self.travel(y))
            wrong += [along - high, low - along]
        elif mode.moving and not y[RATE]:
            rate = drive.slip_acceleration(clutch, hub, balls, shaft, train.driven_inertia)
            outwards = mode.side * rate * train.driven_inertia
            wrong.append(-outwards if mode.balls == "out" else outwards)
        worst = max(wrong) / self.sliding
        return worst if worst > _ROUNDING else 0.0


def _sign(value: float) -> int:
    """Sign of a torque that tears something loose, or of a motion."""
    return 1 if value > 0 else -1


def plant_of(train: Train, pack: Pack) -> Plant:
    """Put a clutch into its drive; without control unit the hub belongs to the driven half."""
    return Plant(train if pack.travels else train.without_hub, pack)
