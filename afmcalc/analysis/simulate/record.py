"""What an event did, as one integration of it tells."""

from typing import NamedTuple

from .plant import State


class Heating(NamedTuple):
    """A moment of a slip."""

    time: float
    torque: float
    """Of the pack, N·m; of the sign of the slip."""
    slip: float
    """rad/s."""
    heat: float
    """In the pack so far, J."""


class Moment(NamedTuple):
    """One row of a history."""

    time: float
    torque_shaft: float
    torque_clutch: float
    speed_motor: float
    speed_driven: float
    speed_tool: float
    travel: float


class Trip(NamedTuple):
    """What an event did."""

    peak: float
    """In the shaft, N·m."""
    peak_clutch: float
    peak_wall: float
    """Of the balls over cos α, N·m: what their walls bear, times n r."""
    slip_time: float
    heat: float
    """In the pack, J."""
    key_heat: float
    travel_max: float
    trip_torque: float | None
    """Of the clutch as it began to slip; None where it did not."""
    stuck: bool
    """Whether the pack does not slip at the end."""
    ended: bool
    """Whether the slip ended, and as far as is known for good."""
    settled: bool
    """Whether nothing more can come."""
    endless: bool
    """Whether the motor drives it for ever."""
    last: float
    """Torque of the clutch at the end, N·m."""
    state: State
    """States and work at the end."""
    time: float
    """From which nothing more could come, s."""
    residual: float
    """Error of the energy balance, relative to the largest energy in it."""
    course: list[Heating]
    """Of the slip, in order."""
    history: list[Moment]
