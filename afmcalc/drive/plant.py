"""What a drive is to the integration: states, modes, rates, and the guards that end a mode.

Between two events every element either sticks or slips, and the equations are smooth. A *mode* says which; a *guard* is
positive while the mode lasts. Derived after the state machine of Otter, Elmqvist and Mattsson (1999).
"""

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

from ..arrays import Values
from ..equations import drive as law
from .train import Train

State = list[float]
Balls = Literal["seat", "lock", "out", "back"]


class Mode(NamedTuple):
    """Which elements stick, which slip, and how far the event is."""

    pack: int = 0
    """Sign of the slip of the friction pack; 0 where it sticks."""
    tool: int = 1
    """Sign of the tool's motion; 0 where it stands."""
    over: bool = False
    """Whether the tool has been stopped, or the load has risen."""
    powered: bool = True
    balls: Balls = "seat"
    """Indirect: at their stop, or off it held by the key, moving out or back."""
    side: int = 1
    """Wall on which the balls are, or the sign of their torque at the seat."""
    hold: int = 1
    """At the seat: 1 while the torque rises (κ), −1 while it falls (κ₊), 0 where the key holds N between."""


class Sliding(NamedTuple):
    """A pack that slides at a constant torque."""

    torque: float
    """N·m, with the sign of the slip."""
    inertia: float
    """Of what swings on the shaft, kg·m²."""
    most: float
    """Swing of the shaft's torque about it up to which the torque stays constant, N·m."""
    slip: float
    """Slip above which static friction is nothing, rad/s."""


class Creep(NamedTuple):
    """A pack whose torque rises slowly as its slip falls."""

    torque: Callable[[Values], Values]
    """Slip → torque, N·m, both without a sign."""
    inertia: float
    """Of what follows the shaft's twist, kg·m²."""
    least: float
    """Slip down to which friction rises slowly against a swing of the shaft, rad/s."""


FAST = 20.0
"""Decays in a radian of the shaft's swing beyond which an implicit method is taken."""
_SLOW = 0.3
"""Growth of a swing by falling friction, relative to its frequency, up to which a slip is slow."""
DECAYED = 20.0
"""Exponent at which static friction is nothing, e^−20 = 2e-9."""


class Torques(NamedTuple):
    """Torques at one moment, N·m."""

    motor: float
    clutch: float
    """Of the friction pack."""
    balls: float
    shaft: float


@dataclass(frozen=True)
class Tool:
    """The tool behind the shaft: led by its stop, or with an inertia of its own under a load that resists."""

    train: Train

    def resistance(self, t: float, mode: Mode) -> float:
        """Torque of the load, N·m."""
        train = self.train
        if mode.over:
            return train.overload
        return float(train.load + (train.overload - train.load) * t / train.time)

    def rate(self, t: float, mode: Mode, shaft: float) -> float:
        """Acceleration, rad/s²."""
        train = self.train
        if train.kind == "stop":
            return 0.0 if mode.over else float(-train.speed / train.time)
        return float((shaft - mode.tool * self.resistance(t, mode)) / train.tool_inertia) if mode.tool else 0.0

    def power(self, t: float, mode: Mode, shaft: float, speed: float) -> float:
        """Power that leaves the drive here, W."""
        if self.train.kind == "stop":
            return shaft * speed
        return self.resistance(t, mode) * mode.tool * speed

    def guard(self, t: float, mode: Mode, shaft: float, speed: float) -> float:
        """Positive while the tool keeps moving, or standing."""
        if self.train.kind == "stop":
            return 1.0
        return mode.tool * speed if mode.tool else self.resistance(t, mode) - abs(shaft)

    def holds(self, mode: Mode) -> float:
        """Torque up to which a standing tool stands, N·m."""
        return math.inf if self.train.kind == "stop" else self.train.overload

    def settled(self, t: float, mode: Mode, shaft: float, speed: float, *, torn: bool) -> int:
        """Sign of the motion that follows; ``torn`` off its rest it moves."""
        if speed:
            return 1 if speed > 0 else -1
        if self.train.kind == "stop" or (not torn and abs(shaft) <= self.resistance(t, mode)):
            return 0
        return sign(shaft)


def sign(value: float) -> int:
    """Sign of a torque that tears something loose."""
    return 1 if value > 0 else -1


class Plant(ABC):
    """A drive with its clutch at one friction; its states: the slip v of the pack, ω_2, φ, ω_3, what the kind adds."""

    V, DRIVEN, TWIST, TOOL = range(4)
    train: Train
    tool: Tool
    size: int
    """How many states; the work of motor, pack, shaft, tool and key comes after them."""
    sliding: float
    """Sliding torque T(f)."""

    least: float
    """Sliding torque at least: that of a sleeve that its key holds back."""
    breakaway: float
    """Torque at which the clutch at rest slips under a load that rises slowly, T(r_s f)."""

    @property
    @abstractmethod
    def growth(self) -> float:
        """Growth of the torque with the share of friction, ∂T/∂(f(v)/f) as slip begins, N·m."""

    @abstractmethod
    def start(self) -> State:
        """States before the event: steady running under the load."""

    @abstractmethod
    def torques(self, t: float, y: Sequence[float], mode: Mode) -> Torques:
        """Torques that follow from states and mode."""

    @abstractmethod
    def rates(self, t: float, y: Sequence[float], mode: Mode) -> State:
        """Rates of the states and of the work."""

    @abstractmethod
    def guards(self, t: float, y: Sequence[float], mode: Mode, torques: Torques) -> list[float]:
        """Positive while the mode lasts; ``torques`` those of states and mode."""

    @abstractmethod
    def switched(self, t: float, y: State, mode: Mode, hit: int | None) -> tuple[State, Mode]:
        """States and mode after guard ``hit`` has fallen to 0, or after a stage of the event."""

    @abstractmethod
    def stored(self, y: Sequence[float]) -> float:
        """Kinetic and elastic energy, J."""

    @abstractmethod
    def scales(self) -> State:
        """Size of every state, for the tolerance of the integration."""

    @abstractmethod
    def motor_speed(self, y: Sequence[float]) -> float:
        """ω_1, rad/s."""

    @property
    def stiff(self) -> bool:
        """Whether something decays so much faster than the shaft swings that an explicit method would crawl."""
        train = self.train
        return train.damping > FAST * math.sqrt(train.stiffness * train.driven_inertia)

    @abstractmethod
    def steadily(self, t: float, y: Sequence[float], mode: Mode) -> Sliding | None:
        """How the pack slides if its torque is constant from now on; None where it is not."""

    @abstractmethod
    def creeping(self, mode: Mode) -> Creep | None:
        """How the pack slips where friction rises as it slows down; None where that is not smooth."""

    def creeps_to(self, steep: float, inertia: float, decay: float) -> float:
        """Slip down to which friction rises slowly, ``steep`` its growth at rest over the decay of the slip, rad/s."""
        fast = 2 * _SLOW * math.sqrt(self.train.stiffness * inertia) + self.train.damping
        return max(math.log(max(steep, fast) / fast) / decay, 0.1 / decay) if decay else 0.01 * self.train.speed

    @abstractmethod
    def sticks_up_to(self, t: float, y: Sequence[float], mode: Mode) -> float:
        """Torque of the clutch up to which nothing of a stuck one slips or moves, N·m."""

    def swing(self, mode: Mode) -> float:
        """Time of a swing of the stuck drive on its shaft, s."""
        train = self.train
        inertia = train.motor_inertia + train.hub_inertia + train.driven_inertia
        if train.kind == "load" and mode.tool:
            inertia = inertia * train.tool_inertia / (inertia + train.tool_inertia)
        return 2 * math.pi * math.sqrt(inertia / train.stiffness)

    def swings_out(self, y: Sequence[float], mode: Mode, peak: float) -> bool:
        """Whether balls that swing on a standing tool have no energy for a slip, nor for a torque above the peak."""
        return False

    def travel(self, y: Sequence[float]) -> float:
        """Travel of the sleeve, m."""
        return 0.0

    def leaning(self, y: Sequence[float]) -> float:
        """tan α of the wall where the balls are; 0 where their circle is not known."""
        return 0.0

    def shaft(self, y: Sequence[float]) -> float:
        """Torque in the shaft, N·m."""
        train = self.train
        torque = law.shaft_torque(train.stiffness, y[self.TWIST], train.damping, y[self.DRIVEN] - y[self.TOOL])
        return float(torque)

    def motor(self, speed: float, mode: Mode) -> float:
        """Torque of the motor, N·m."""
        return float(self.train.engine.at(speed)) if mode.powered else 0.0
