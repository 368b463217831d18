"""Temperature of disc and lining during a slip: two layers that are heated where they touch."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from ..equations.arrays import Floats

_CELLS, _RATIO = 50, 1.12
"""Number of cells of a layer, and ratio of thickness of a cell to the next one towards the face; error 0.1 %."""
_STEPS = 400
"""Half the number of time steps; the shares of time and heat that pass in a step have the same sum in each step."""
_POINTS = 1000
"""Smallest number of points in a ``Course``."""
_REACH = 4.0
"""Depth that the heat reaches, over √(k t/(ρ c)); a deeper layer stays cold (its rise is erfc 2 of the face's)."""


class Course(NamedTuple):
    """Friction power of a slip, and heat since its start, at many close times, SI."""

    time: Floats
    power: Floats
    heat: Floats


def course_of(moments: Iterable[tuple[float, float, float]]) -> Course:
    """Course through moments (time, power, heat so far); of two moments at the same time the later one counts.

    Between two moments the heat is a cubic and the power a parabola.
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
    """Body heated at its face, SI; its back is insulated."""

    conductivity: float
    density: float
    specific_heat: float
    depth: float | None
    """Half the thickness of a disc, or the thickness of the lining, m; None: infinite."""


class Warming(NamedTuple):
    """Temperature rise of the faces, K, and heat in the disc, J, over time."""

    time: Floats
    face: Floats
    disc: Floats


def warming(layers: Sequence[Layer], area: float, course: Course) -> Warming:
    """Warming of a disc, or of disc and lining, whose faces have the same temperature.

    No place is ever hotter than the faces have been (maximum principle of the heat equation).

    Args:
        layers: the disc, and the lining if it takes heat.
        area: friction area of all pairs together, m².
        course: power and heat of a slip; the heat is not 0.
    """
    gone = (course.time - course.time[0]) / np.ptp(course.time) + course.heat / course.heat[-1]
    time = np.interp(np.linspace(0, 2, 2 * _STEPS + 1), gone, course.time)
    steps = np.diff(time)[:, None]
    power = np.diff(np.interp(time, course.time, course.heat))[:, None] / steps
    rate, face, disc = _modes(layers, area, np.ptp(course.time))
    # each mode takes up power and decays at its rate: exact for a constant power in each step
    lost = -np.expm1(-steps * rate)
    kept, taken = 1 - lost, power * np.append(steps, lost[:, 1:] / rate[1:], axis=1)
    state = np.zeros((time.size, rate.size))
    for number in range(steps.size):
        state[number + 1] = kept[number] * state[number] + taken[number]
    return Warming(time, state @ face, state @ disc)


def _modes(layers: Sequence[Layer], area: float, time: float) -> tuple[Floats, Floats, Floats]:
    """Modes of heat conduction in layers of finite volumes: decay rate, rise of the faces per heat, disc's share."""
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
    # a node between two cells has half the capacity of both; the faces are the node where the layers touch
    stored = (np.append(capacity, 0) + np.append(0, capacity)) / 2
    in_disc = np.append(stored[:_CELLS], capacities[0][-1] / 2)
    flow, root = np.append(conductance, 0) + np.append(0, conductance), np.sqrt(stored)
    coupling = conductance / (root[1:] * root[:-1])
    rate, shape = np.linalg.eigh(np.diag(flow / stored) - np.diag(coupling, -1))  # eigh reads the lower half
    rate[0] = 0.0  # decay rate of the mean temperature: no heat leaves the insulated layers
    face = shape[_CELLS] / root[_CELLS]
    return rate, face**2, face * (in_disc / root[: _CELLS + 1] @ shape[: _CELLS + 1])
