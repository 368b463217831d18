"""A direct clutch in its drive: one element that sticks or slips, its normal force at once or late."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import cast

import numpy as np

from ..arrays import V, Values
from ..equations import direct
from ..equations import drive as law
from .plant import DECAYED, FAST, Creep, Mode, Plant, Sliding, State, Tool, Torques, sign
from .train import Train

_STEP = 1e-6
"""Of friction, relative, over which the growth of the torque is taken."""


@dataclass(frozen=True)
class DirectPack:
    """Discs of a direct clutch at one friction; numbers, or arrays in a sweep."""

    closing_force: float
    mean_radius: float
    bypass_pairs: float
    controlled_pairs: float
    gain: float
    driving: float
    """f_1."""
    driven: float
    """f_2."""
    static_ratio: float = 1.0
    decay_rate: float = 0.0
    """R/v_s, s/rad."""
    lag: float = 0.0
    """τ, s."""
    lever: float = 0.0
    """r/R; 0 where the circle of the balls is not known."""

    @cached_property
    def friction_pairs(self) -> float:
        """Σ z f."""
        return self.bypass_pairs * self.driving + self.controlled_pairs * self.driven

    @cached_property
    def ball_share(self) -> float:
        """Share of the torque that passes the balls, z_2 f_2/Σ z f; below slip too (S22 for one material)."""
        return self.controlled_pairs * self.driven / self.friction_pairs

    def torque(self, ratio: V) -> V:
        """Slip torque with friction times ``ratio``, no lag."""
        torque: V = direct.torque(
            self.closing_force,
            self.mean_radius,
            self.bypass_pairs,
            self.controlled_pairs,
            self.gain,
            ratio * self.driving,
            ratio * self.driven,
        )
        return torque

    def under(self, torque: V) -> V:
        """Normal force in balance with a torque either way, without slip."""
        force: V = law.normal_force_under_load(
            self.closing_force, self.gain, self.ball_share * torque, self.mean_radius
        )
        return force

    def potential(self, torque: float, ratio: float) -> float:
        """T_п: torque at which it slips with the release force of ``torque``, friction times ``ratio``."""
        return self.carried(self.under(torque), ratio)

    def carried(self, normal_force: V, ratio: V) -> V:
        """Torque at which a normal force slips, friction times ``ratio``."""
        torque: V = direct.group_torque(normal_force, self.mean_radius, ratio, self.friction_pairs)
        return torque


@dataclass(frozen=True)
class DirectPlant(Plant):
    """Motor side, pack, driven half, shaft, tool; N is a state where it is late."""

    train: Train
    pack: DirectPack

    NORMAL = 4
    size = 5

    @cached_property
    def tool(self) -> Tool:  # type: ignore[override]
        """What stands behind the shaft."""
        return Tool(self.train)

    @cached_property
    def sliding(self) -> float:  # type: ignore[override]
        """T(f)."""
        return self.pack.torque(1.0)

    @cached_property
    def least(self) -> float:  # type: ignore[override]
        """T(f)."""
        return self.sliding

    @cached_property
    def breakaway(self) -> float:  # type: ignore[override]
        """T(r_s f)."""
        return self.pack.torque(self.pack.static_ratio)

    @property
    def growth(self) -> float:
        """∂T/∂(f(v)/f), release force following."""
        own, ratio = self.pack, self.pack.static_ratio
        grown: float = law.torque_growth(
            own.closing_force,
            own.mean_radius,
            own.bypass_pairs,
            own.controlled_pairs,
            own.gain,
            ratio * own.driving,
            ratio * own.driven,
        )
        return grown / ratio

    def start(self) -> State:
        """Running under the load; a tool that stops at once stands."""
        train = self.train
        locked = train.kind == "stop" and not train.time
        tool = 0.0 if locked else train.speed
        return [0.0, train.speed, float(train.load / train.stiffness), tool, self.pack.under(train.load)]

    def scales(self) -> State:
        """Size of every state."""
        train = self.train
        speed = train.speed
        return [speed, speed, self.sliding / train.stiffness, speed, self.pack.closing_force]

    def leaning(self, y: Sequence[float]) -> float:
        """tan α = C r/R."""
        return self.pack.gain * self.pack.lever

    def motor_speed(self, y: Sequence[float]) -> float:
        """ω_1 = ω_2 + v."""
        return y[self.DRIVEN] + y[self.V]

    def _ratio(self, slip: float) -> float:
        """Friction at a slip over sliding friction."""
        own = self.pack
        if own.static_ratio == 1:
            return 1.0
        ratio: float = law.stribeck_ratio(own.static_ratio, math.exp(-own.decay_rate * abs(slip)))
        return ratio

    def capacity(self, y: Sequence[float], slip: float) -> float:
        """Largest torque of the pack at a slip."""
        own, ratio = self.pack, self._ratio(slip)
        if not own.lag:
            return own.torque(ratio)
        return own.carried(y[self.NORMAL], ratio)

    def sticking(self, motor: float, shaft: float) -> float:
        """Torque of the pack that keeps both halves together."""
        train = self.train
        torque: float = law.sticking_torque(motor, train.motor_inertia, shaft, train.driven_inertia)
        return torque

    def torques(self, t: float, y: Sequence[float], mode: Mode) -> Torques:
        """Torques that follow from states and mode."""
        shaft, motor = self.shaft(y), self.motor(self.motor_speed(y), mode)
        clutch = mode.pack * self.capacity(y, y[self.V]) if mode.pack else self.sticking(motor, shaft)
        return Torques(motor, clutch, clutch * self.pack.ball_share, shaft)

    def rates(self, t: float, y: Sequence[float], mode: Mode) -> State:
        """Newton, the lag, and the work of motor, pack, shaft and tool."""
        train, own = self.train, self.pack
        motor, clutch, _, shaft = self.torques(t, y, mode)
        slip, driven, _, tool, normal = y[: self.size]
        twisting = driven - tool
        slipping = law.slip_acceleration(motor, train.motor_inertia, clutch, shaft, train.driven_inertia)
        late = law.normal_force_rate(normal, own.under(abs(clutch)), own.lag) if own.lag else 0.0
        return [
            slipping if mode.pack else 0.0,
            (clutch - shaft) / train.driven_inertia,
            twisting,
            self.tool.rate(t, mode, shaft),
            late,
            motor * (driven + slip),
            clutch * slip,
            train.damping * twisting * twisting,
            self.tool.power(t, mode, shaft, tool),
            0.0,
        ]

    @property
    def stiff(self) -> bool:
        """A short lag decays fast too."""
        natural = (self.train.stiffness / self.train.driven_inertia) ** 0.5
        return super().stiff or 0 < self.pack.lag * natural < 1 / FAST

    def steadily(self, t: float, y: Sequence[float], mode: Mode) -> Sliding | None:
        """Sliding friction alone, and a normal force that has come to its balance."""
        own, late = self.pack, self.rates(t, y, mode)[self.NORMAL]
        if abs(late) * own.lag > 1e-10 * y[self.NORMAL]:
            return None
        slip = DECAYED / own.decay_rate if own.static_ratio > 1 else 0.0
        return Sliding(mode.pack * self.sliding, self.train.driven_inertia, math.inf, slip)

    def creeping(self, mode: Mode) -> Creep | None:
        """Static friction that comes back."""
        own, inertia = self.pack, self.train.driven_inertia
        if own.lag or own.static_ratio == 1:
            return None

        def torque(slip: Values) -> Values:
            return own.torque(cast(Values, law.stribeck_ratio(own.static_ratio, np.exp(-own.decay_rate * slip))))

        growth = max(self.growth, (own.torque(1 + _STEP) - own.torque(1.0)) / _STEP)
        steep = growth * (own.static_ratio - 1) * own.decay_rate
        return Creep(torque, inertia, self.creeps_to(steep, inertia, own.decay_rate))

    def sticks_up_to(self, t: float, y: Sequence[float], mode: Mode) -> float:
        """T(r_s f), or less while the normal force lags."""
        return min(self.breakaway, self.capacity(y, 0.0))

    def guards(self, t: float, y: Sequence[float], mode: Mode, torques: Torques) -> list[float]:
        """Pack, tool."""
        pack = mode.pack * y[self.V] if mode.pack else self.capacity(y, 0.0) - abs(torques.clutch)
        return [pack, self.tool.guard(t, mode, torques.shaft, y[self.TOOL])]

    def switched(self, t: float, y: State, mode: Mode, hit: int | None) -> tuple[State, Mode]:
        """Bring to rest what has come to rest, then see what sticks."""
        y = list(y)
        if hit == 0:
            y[self.V] = 0.0
        if hit == 1 and mode.tool:
            y[self.TOOL] = 0.0
        shaft, motor = self.shaft(y), self.motor(self.motor_speed(y), mode)
        needed = self.sticking(motor, shaft)
        tool = self.tool.settled(t, mode, shaft, y[self.TOOL], torn=hit == 1 and not mode.tool)
        if y[self.V]:
            pack = sign(y[self.V])
        else:
            torn = hit == 0 and not mode.pack
            pack = sign(needed) if torn or abs(needed) > self.capacity(y, 0.0) else 0
        return y, mode._replace(pack=pack, tool=tool)

    def stored(self, y: Sequence[float]) -> float:
        """Kinetic and elastic energy, J."""
        train = self.train
        moving = (
            train.motor_inertia * self.motor_speed(y) ** 2
            + train.driven_inertia * y[self.DRIVEN] ** 2
            + train.tool_inertia * y[self.TOOL] ** 2
        )
        return float(moving + train.stiffness * y[self.TWIST] ** 2) / 2
