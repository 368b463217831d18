"""Continuous refinement of a front: from each grid point downhill in one objective, none of the others given up."""

from typing import Any

from ...spec.requirements import Choices, Requirements
from .candidates import Axes, evaluate, feasible, objectives

_ROUNDS = 150
_CONTINUOUS = ("closing_force", "accuracy_factor", "travel")


def refined(need: Requirements, variant: str, rows: Any) -> Any:
    """Move candidates between the grid points of the parameters that were given as ranges.

    A pattern search with a step of its own per candidate; it starts at the grid's own spacing and halves the step
    where no neighbour is better. Whole numbers, lists and balls stay.

    Args:
        need: the requirements.
        variant: variant of the candidates.
        rows: one row of axis values per candidate.

    Returns:
        Rows of the same shape, each no worse than its own in any objective.
    """
    import itertools

    import numpy as np

    free = _free(need, variant)
    goal = next((need.objectives.index(name) for name in _CONTINUOUS if name in need.objectives), None)
    if not free or goal is None or len(rows) == 0:
        return rows
    best = rows.copy()
    bounds, spacing = _scales(free)
    limit = objectives(need, evaluate(need, variant, Axes(*rows.T)), rows[:, 0]) * (1 + 1e-12)
    reached = limit[:, goal].copy()
    step = np.ones(len(rows))
    ways = np.array([way for way in itertools.product((-1, 0, 1), repeat=len(free)) if any(way)], float)
    columns = [column for column, _ in free]
    for _ in range(_ROUNDS):
        tried = np.repeat(best[:, None, :], len(ways), axis=1)
        moved = tried[:, :, columns] + ways * spacing * step[:, None, None]
        tried[:, :, columns] = np.clip(moved, bounds[0], bounds[1])
        flat = tried.reshape(-1, rows.shape[1])
        state = evaluate(need, variant, Axes(*flat.T))
        values = objectives(need, state, flat[:, 0]).reshape(len(rows), len(ways), -1)
        good = feasible(state).reshape(len(rows), len(ways)) & (values <= limit[:, None, :]).all(axis=2)
        score = np.where(good, values[:, :, goal], np.inf)
        choice = score.argmin(axis=1)
        each = np.arange(len(rows))
        better = score[each, choice] < reached * (1 - 1e-13)
        best[better] = tried[each, choice][better]
        reached[better] = score[each, choice][better]
        step[~better] /= 2
        if step.max() < 1e-10:
            break
    return best


def _free(need: Requirements, variant: str) -> list[tuple[int, Any]]:
    """Columns of the axes that were given as ranges of real numbers, with their ranges."""
    search = need.search
    given: dict[int, Choices | None] = {6: search.mean_radius}
    if variant != "conventional":
        given |= {2: search.gain or search.wall_angle, 5: search.ball_circle_radius}
    if variant == "indirect":
        given |= {3: search.closing_stiffness, 4: search.control_stiffness}
    return [(column, values) for column, values in given.items() if values and not values.listed and values.length > 1]


def _scales(free: list[tuple[int, Any]]) -> tuple[Any, Any]:
    """Bounds and grid spacing of the free columns."""
    import numpy as np

    bounds = np.array([[values.start for _, values in free], [values.stop for _, values in free]])
    spacing = np.array([(values.stop - values.start) / (values.length - 1) for _, values in free])
    return bounds, spacing
