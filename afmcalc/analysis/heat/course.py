"""How the power of a slip goes over time."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from ...arrays import Floats

_BETWEEN = np.linspace(0.0, 1.0, 9)
"""Places between two moments at which the power is looked at."""


class Course(NamedTuple):
    """Power and heat over time; between its moments the heat is a cubic, the power a parabola."""

    time: Floats
    power: Floats
    heat: Floats
    """So far."""

    def times(self, factor: float) -> "Course":
        """The course of a share of the power."""
        return Course(self.time, self.power * factor, self.heat * factor)

    def heat_at(self, times: Floats) -> Floats:
        """Heat up to several times."""
        number = np.clip(np.searchsorted(self.time, times, side="right") - 1, 0, self.time.size - 2)
        long = self.time[number + 1] - self.time[number]
        share = (times - self.time[number]) / long
        left, right = share * share * (3 - 2 * share), share * (1 - share)
        gained = (self.heat[number + 1] - self.heat[number]) * left
        bent = right * long * (self.power[number] * (1 - share) - self.power[number + 1] * share)
        found: Floats = self.heat[number] + gained + bent
        return found

    @property
    def largest(self) -> float:
        """Largest power."""
        long, share = np.diff(self.time), _BETWEEN[:, None]
        mean = np.diff(self.heat) / long
        first, last = self.power[:-1], self.power[1:]
        power = 6 * share * (1 - share) * mean + first * (1 - share) * (1 - 3 * share) + last * share * (3 * share - 2)
        return float(power.max(initial=0.0))


def course_of(moments: Iterable[tuple[float, float, float]]) -> Course:
    """Return the course through moments: time, power and heat so far; of two at one time the later."""
    last = {time: (time, power, heat) for time, power, heat in moments}
    time, power, heat = np.array(sorted(last.values()) or [(0.0, 0.0, 0.0)]).T
    return Course(time, power, heat)
