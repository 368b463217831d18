"""The discrete space of a design: its axes, how many candidates they span, and the tiles it is cut into."""

from collections.abc import Iterable, Iterator
from functools import cache
from itertools import product
from math import prod
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...errors import given
from ...spec.edit import with_values
from ...spec.lists import diameters
from ...spec.requirements import Choice, Requirements
from ...variants import VARIANTS, Variant

Numbers: TypeAlias = NDArray[np.float64]
Mask: TypeAlias = NDArray[np.bool_]
Places: TypeAlias = NDArray[np.int64]


SAME = 1e-12
"""Relative slack of every limit, and difference of two objectives, that may be due to rounding."""
SAME_CLUTCH = 1e-9
"""Relative distance within which refined clutches are the same one, reached from two grid points."""


class Axes(NamedTuple):
    """Values of the searched parameters, SI: an axis each, or a column of candidates; NaN where a variant has none."""

    pairs: Numbers
    driving_pairs: Numbers
    steering: Numbers
    """Gain, or wall angle where the angle is searched."""
    closing_stiffness: Numbers
    control_stiffness: Numbers
    ball_circle_radius: Numbers
    mean_radius: Numbers
    inner_radius: Numbers
    """One value in a grid; NaN where the mean radius itself is searched."""

    def at(self, places: Places | Mask | slice) -> "Axes":
        """Some of the candidates of columns."""
        return Axes(*(column[places] for column in self))


def joined(parts: Iterable[Axes]) -> Axes:
    """Columns one after the other."""
    return Axes(*map(np.concatenate, zip(*parts, strict=True)))


def curved(need: Requirements, variant: Variant) -> bool:
    """Whether the pockets have a curved wall: what holds along an axis of straight ones need not of them."""
    return variant.travels and need.fixed.pocket is not None


def searched(need: Requirements, variant: Variant) -> dict[str, Choice]:
    """Choice of every axis that a variant has; the mean radius may be searched by the outer one."""
    search = need.search
    choices = {"pairs": search.pairs, "mean_radius": search.radii}
    if variant.chooses_bypass:
        choices["driving_pairs"] = search.driving_pairs
    if variant.controlled:
        choices["steering"] = given(search.gain or search.wall_angle)
        choices["ball_circle_radius"] = given(search.ball_circle_radius)
    if variant.travels:
        choices["closing_stiffness"] = given(search.closing_stiffness)
        choices["control_stiffness"] = given(search.control_stiffness)
    return choices


def grids(need: Requirements, variant: Variant) -> Iterator[Axes]:
    """Lay out the axes of a variant, for every inner radius; an axis it does not have holds one NaN."""
    choices = searched(need, variant)
    laid = Axes(*(choices[name].array() if name in choices else np.array([np.nan]) for name in Axes._fields))
    softest = need.search.closing_stiffness
    if not variant.travels and need.wanted.torque_after_wear is not None and need.springs is None and softest:
        # of a direct clutch nothing but wear asks for it
        laid = laid._replace(closing_stiffness=softest.array()[:1])
    if need.search.inner_radius is None:
        yield laid
        return
    for inner in need.search.inner_radius.array():
        outer = laid.mean_radius[laid.mean_radius > inner]
        if outer.size:
            yield laid._replace(mean_radius=(inner + outer) / 2, inner_radius=np.array([inner]))


LININGS = {
    "material": "friction.material",
    "driving_material": "friction.driving.material",
    "driven_material": "friction.driven.material",
}
"""What a row tells of its linings → key of the requirements."""


def linings(need: Requirements) -> list[Requirements]:
    """The requirements with each friction material that is listed; where it is not known, with the worst of them."""
    if need.friction.unknown:
        return [need]
    blocks = need.friction.blocks.items()
    listed = ([(f"{path}.material", name) for name in block.material_names] for path, block in blocks)
    return [with_values(need, dict(chosen)) for chosen in product(*listed)]


def with_lining(need: Requirements, row: Any) -> Requirements:
    """The requirements with the friction materials of a row of the front."""
    named = {} if need.friction.unknown else {path: getattr(row, key) for key, path in LININGS.items()}
    return with_values(need, {path: name for path, name in named.items() if name is not None})


def forces(need: Requirements) -> int:
    """How many spring forces a catalogue holds."""
    return 1 if need.search.closing_forces is None else need.search.closing_forces.size


def total(need: Requirements) -> int:
    """Number of candidates asked for."""
    radii, inner = need.search.radii, need.search.inner_radius
    faces = radii.size
    if inner is not None:
        faces = int((radii.size - np.searchsorted(radii.array(), inner.array(), "right")).sum())
    others = (
        prod(choice.size for name, choice in searched(need, VARIANTS[variant]).items() if name != "mean_radius")
        for variant in need.variants
    )
    return forces(need) * faces * len(linings(need)) * sum(others)


_shipped = cache(diameters)


def balls(need: Requirements) -> Numbers:
    """Standard ball diameters to choose from, ascending, m."""
    listed = need.search.ball_diameters
    return np.array(need.lists.balls or _shipped()) if listed is None else listed.array()


class Tile(NamedTuple):
    """A part of a grid: every axis in a dimension of its own, so that a piece of a law costs only the axes it needs."""

    axes: Axes
    shape: tuple[int, ...]
    order: tuple[int, ...]
    """Which axis lies along each dimension."""

    @property
    def size(self) -> int:
        """Number of grid points."""
        return prod(self.shape)

    def count(self, mask: Mask) -> int:
        """Number of grid points that a mask over some of the axes selects."""
        return int(np.count_nonzero(mask)) * (self.size // mask.size)

    def dimension(self, name: str) -> int:
        """Dimension along which a parameter varies."""
        return self.order.index(Axes._fields.index(name))

    def points(self, places: Places) -> Axes:
        """Columns of the points at flat places."""
        along = dict(zip(self.order, np.unravel_index(places, self.shape), strict=True))
        return Axes(*(axis.ravel()[along[k]] for k, axis in enumerate(self.axes)))


def tiles(laid: Axes, most: int) -> Iterator[Tile]:
    """Cut a grid into tiles of at most so many points.

    Inner loops run along the longest axis; the next longest are cut, so that a tile has all of the short ones.
    """
    *short, longest = sorted(range(len(laid)), key=lambda k: laid[k].size)
    order = (*reversed(short), longest)
    for parts in _cut([laid[k] for k in order], most):
        # the axis of each dimension, in the order of the fields
        spread = np.ix_(*parts)
        yield Tile(Axes(*(spread[order.index(k)] for k in range(len(order)))), tuple(map(len, parts)), order)


def _cut(laid: list[Numbers], most: int) -> Iterator[list[Numbers]]:
    sizes = [axis.size for axis in laid]
    cut = 0
    while cut < len(laid) - 1 and prod(sizes[cut + 1 :]) > most:
        cut += 1
    step = max(1, most // prod(sizes[cut + 1 :]))
    for outer in np.ndindex(*sizes[:cut]):
        head = [axis[k : k + 1] for axis, k in zip(laid, outer, strict=False)]
        for start in range(0, sizes[cut], step):
            yield [*head, laid[cut][start : start + step], *laid[cut + 1 :]]
