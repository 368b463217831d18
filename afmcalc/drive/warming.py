"""Temperature of disc and lining during a slip: two layers that are heated where they touch."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from ..equations.arrays import Floats

_CELLS, _RATIO = 50, 1.12
"""Of a layer, and how much thicker each is than its neighbour towards the face: rises to 0.1 %."""
_STEPS = 400
"""Of time, and as many of heat, in which the layers are heated."""
_POINTS = 1000
"""Of a course, at least."""
_REACH = 4.0
"""Of the heat, in √(k t/(ρ c)): what is deeper stays cold, erfc 2."""


class Course(NamedTuple):
    """Power and heat so far of a slip, SI, at times close to each other."""

    time: Floats
    power: Floats
    heat: Floats


def course_of(moments: Iterable[tuple[float, float, float]]) -> Course:
    """Course through moments: time, power and heat so far; of two at one time the later.

    Between them the heat is a cubic, the power a parabola.
    """
    last = {time: (time, power, heat) for time, power, heat in moments}
    ends = np.array(sorted(last.values()) or [(0.0, 0.0, 0.0)]).T
    (time, before, heat), (long, _, gained), after = ends[:, :-1], np.diff(ends), ends[1, 1:]
    parts = 8 + _POINTS // ends.shape[1]
    gone = np.arange(parts)[:, None] / parts
    left = 1 - gone
    power = 6 * gone * left * gained / long + before * left * (1 - 3 * gone) + after * gone * (3 * gone - 2)
    heats = heat + gained * gone**2 * (3 - 2 * gone) + long * gone * left * (before * left - after * gone)
    columns = zip((time + long * gone, power, heats), ends[:, -1], strict=True)
    return Course(*(np.append(inside.ravel("F"), end) for inside, end in columns))


class Layer(NamedTuple):
    """Body that is heated at its face, SI; nothing leaves it at its back."""

    conductivity: float
    density: float
    specific_heat: float
    depth: float | None
    """To the middle of the disc, or through the lining; None: endlessly thick."""


class Warming(NamedTuple):
    """Rise of the faces, K, and heat in the disc, J, over time."""

    time: Floats
    face: Floats
    disc: Floats


def warming(layers: Sequence[Layer], area: float, course: Course) -> Warming:
    """Warming of a disc, or of disc and lining whose faces are equally hot.

    No place is ever hotter than the faces have been (maximum principle of the equation of heat).

    Args:
        layers: the disc, and the lining if it takes heat.
        area: of all pairs.
        course: of a slip that gives heat.
    """
    gone = (course.time - course.time[0]) / np.ptp(course.time) + course.heat / course.heat[-1]
    time = np.interp(np.linspace(0, 2, 2 * _STEPS + 1), gone, course.time)
    steps = np.diff(time)[:, None]
    power = np.diff(np.interp(time, course.time, course.heat))[:, None] / steps
    rate, face, disc = _modes(layers, area, np.ptp(course.time))
    # a mode takes up power and dies away at its rate: exact for an even power in each step
    kept = np.exp(-steps * rate)
    taken = power * np.append(steps, -np.expm1(-steps * rate[1:]) / rate[1:], axis=1)
    state = np.zeros((time.size, rate.size))
    for number in range(steps.size):
        state[number + 1] = kept[number] * state[number] + taken[number]
    return Warming(time, state @ face, state @ disc)


def _modes(layers: Sequence[Layer], area: float, time: float) -> tuple[Floats, Floats, Floats]:
    """Modes of the conduction in layers of finite volumes: rate, rise of the faces per heat, share in the disc."""
    from scipy.linalg import eigh_tridiagonal

    # cells from the middle of the disc to the face, and on to the back of the lining
    capacities, conductances = [], []
    for layer, way in zip(layers, (-1, 1), strict=False):
        volumetric = layer.density * layer.specific_heat
        reach = _REACH * (layer.conductivity * time / volumetric) ** 0.5
        thickness = _RATIO ** np.arange(_CELLS)[::way]
        thickness *= (reach if layer.depth is None else min(layer.depth, reach)) / thickness.sum()
        capacities.append(volumetric * area * thickness)
        conductances.append(layer.conductivity * area / thickness)
    capacity, conductance = np.concatenate(capacities), np.concatenate(conductances)
    # a node between two cells stores half of what they do; the faces are the node where the layers touch
    stored = (np.append(capacity, 0) + np.append(0, capacity)) / 2
    in_disc = np.append(stored[:_CELLS], capacities[0][-1] / 2)
    flow, root = np.append(conductance, 0) + np.append(0, conductance), np.sqrt(stored)
    rate, shape = eigh_tridiagonal(flow / stored, -conductance / (root[1:] * root[:-1]))
    rate[0] = 0.0  # of the mean, which nothing leaves
    face = shape[_CELLS] / root[_CELLS]
    return rate, face**2, face * (in_disc / root[: _CELLS + 1] @ shape[: _CELLS + 1])
