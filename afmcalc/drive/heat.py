"""Temperature of faces and disc during a slip, whose heat flows into disc and lining, layers of a depth."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ..engines import Clutch
from ..engines.quantities import Apply, call
from ..equations import heat as law
from ..equations.arrays import Floats, Values
from ..findings import Finding
from ..spec.models import Drive
from .result import EnergySource

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
        return self.heat[number] + gained + bent

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


_TERMS = 16
"""Terms of the inverse transform: nine digits."""
_DEEP = 20.0
_PANELS = 1024
"""Parts of the time, each of even flux: the largest rise to 1e-4."""
_FINE = 128
"""Panels before which the largest rise is looked for again, in a shorter time."""


class Body(NamedTuple):
    """What is heated, SI."""

    conductivity: float
    density: float
    specific_heat: float
    depth: Values | None
    """To the middle of the disc, or through the lining, m; None: endlessly thick."""

    def admittance(self, variable: Floats) -> Floats:
        """Flux into the face per rise, both transformed."""
        own = self.conductivity, self.density, self.specific_heat
        through = np.ones_like(variable)
        if self.depth is not None:
            deep = law.fourier_number(*own, 1 / variable, self.depth) ** -0.5
            # beyond that it is 1 to the last digit, and its exponentials too large
            through = np.tanh(np.where(deep.real > _DEEP, _DEEP, deep))
        return law.face_admittance(law.effusivity(*own), variable**0.5, through)


def largest_rise(bodies: list[Body], course: Course) -> float:
    """Largest rise of a face, K, under a flux, W/m²; disc, or disc and lining, whose faces are equally hot."""
    end = course.time[-1]
    for _ in range(8):
        ends, rises = _over_time(course, end, lambda p: 1 / (p * sum(each.admittance(p) for each in bodies)))
        best = int(np.argmax(rises))
        if best >= _FINE:
            break
        end = ends[2 * best + 2]
    return float(rises[best])


def most_in_disc(bodies: list[Body], course: Course) -> float:
    """Largest heat per area in the disc, the first of the bodies, J/m².

    Of the flux Y_d/ΣY flows into it, as it is as hot as the lining where they touch. The mean of the disc is never
    above the largest rise of the faces: no place within a body that is heated at its face alone is ever hotter than
    the face has been (maximum principle of the equation of heat).
    """
    disc = bodies[0].admittance
    _, heats = _over_time(
        course, course.time[-1], lambda p: disc(p) / (p * p * sum(each.admittance(p) for each in bodies))
    )
    return float(heats.max())


def least_rise(bodies: Sequence[Body], time: Floats, heat: Floats) -> Floats:
    """Return what faces rise by at least that took so much heat per area in so long a time, arrays, K.

    No course of the flux is gentler than that which keeps the face equally hot all the while: wherever the face is
    cooler, so is all of the body (maximum principle of the equation of heat), and it holds less.
    """
    taken = _inverse(lambda p: sum(each.admittance(p) for each in bodies) / (p * p), np.append(0.0, time))[1:]
    return heat / taken


def least_share(bodies: Sequence[Body], time: Floats) -> Floats:
    """Return the share of the heat of slips of so long a time that is in the disc, the first body, at least, arrays."""
    disc = bodies[0].admittance
    shares = [
        _inverse(lambda p: disc(p) / (p * sum(each.admittance(p) for each in bodies)), np.append(0.0, time / 4**k))[1:]
        for k in range(6)
    ]
    return np.min(shares, axis=0)


def _over_time(course: Course, end: float, transform: Callable[[Floats], Floats]) -> tuple[Floats, Floats]:
    """Times until an end, and what the flux gives at all but the first, of its transform under an even flux of 1."""
    ends = np.linspace(course.time[0], end, _PANELS + 1)
    flux = np.diff(course.heat_at(ends)) / np.diff(ends)
    steps = np.diff(_inverse(transform, ends - ends[0]))
    return ends, np.convolve(flux, steps)[:_PANELS]


def _inverse(transform: Callable[[Floats], Floats], times: Floats) -> Floats:
    """What a transform is of, at several times, the first of them 0 (Abate and Valkó 2004)."""
    angle = np.arange(1, _TERMS) * np.pi / _TERMS
    cot = 1 / np.tan(angle)
    nodes = 0.4 * _TERMS * np.concatenate([[1.0], angle * (cot + 1j)])
    weights = np.exp(nodes) * np.concatenate([[0.5], 1 + 1j * angle * (1 + cot * cot) - 1j * cot])
    values: Floats = 0.4 / times[1:] * (weights[:, None] * transform(nodes[:, None] / times[1:])).real.sum(axis=0)
    return np.concatenate([[0.0], values])


ENDS = ("min", "mean", "max")


class HeatedSlip(NamedTuple):
    """A slip at one friction; a time and an energy of None: it does not end."""

    torque: Values
    time: Values | None
    energy: Values | None
    course: "Course"
    """Its power over time; as far as known of one that does not end."""
    carried: bool = False
    """Whether the motor can carry the slip torque, so that only a cut-off ends it."""
    lining_share: float = 0.0
    """Share of the heat that is in the lining where the discs are hottest."""
    apply: Apply = call
    """Applies a law at the friction of the slip; ``Quantities.apply`` notes it."""


class HeatedSlips(NamedTuple):
    """The trip at f_min, mean and f_max, and where its heat is from."""

    source: EnergySource
    at: Mapping[str, HeatedSlip]
    found: tuple[Finding, ...] = ()
    """What the simulation says of the end of the slip."""


def motor_torque(clutch: Clutch) -> Values:
    """M_1, N·m: as given, else the load before the trip, else that of the machine."""
    drive = clutch.spec.drive
    given = drive.load_torque if drive.motor_torque is None else drive.motor_torque
    return clutch["running_torque"] if given is None else given


def run_down(drive: Drive, torque: Values, motor: Values, apply: Apply = call) -> HeatedSlip:
    """V1 until the motor side stands or is switched off; switched off it runs down against the clutch alone."""
    speed, inertia, off = drive.speed, drive.motor_inertia, drive.cut_off
    assert speed is not None
    if inertia is None:
        assert off is not None
        slipped = _slipped(torque, [(0.0, speed), (off, speed)])
        return slipped._replace(energy=apply(law.slip_energy, torque, speed, speed, off))
    carried = bool(torque <= motor)
    if not carried:
        stands = law.run_down_time(inertia, speed, torque, motor)
        if off is None or stands <= off:
            time = apply(law.run_down_time, inertia, speed, torque, motor)
            energy = apply(law.run_down_energy, inertia, speed, torque, motor)
            return _slipped(torque, [(0.0, speed), (time, 0.0)])._replace(energy=energy)
    if off is None:
        return _slipped(torque, [(0.0, speed)])._replace(time=None, energy=None, carried=carried)
    # a motor that can carry the slip torque goes on at its speed
    end = speed if carried else apply(law.speed_after, speed, inertia, torque, motor, off)
    after, energy = (apply(each, inertia, end, torque, 0.0) for each in (law.run_down_time, law.run_down_energy))
    found = _slipped(torque, [(0.0, speed), (off, end), (off + after, 0.0)])
    until = apply(law.slip_energy, torque, speed, end, off)
    return found._replace(energy=until + energy, carried=carried)


def _slipped(torque: Values, at: Sequence[tuple[Values, Values]]) -> HeatedSlip:
    """A slip whose speed changes evenly between moments: time and speed."""
    moments, energy = [(0.0, float(law.slip_power(torque, at[0][1])), 0.0)], 0.0
    for (before, first), (time, last) in pairwise(at):
        energy = energy + law.slip_energy(torque, first, last, time - before)
        moments.append((float(time), float(law.slip_power(torque, last)), float(energy)))
    return HeatedSlip(torque, at[-1][0], energy, course_of(moments))
