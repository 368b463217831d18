"""The discrete space of a design: its axes, and how many candidates they span."""

from collections.abc import Iterator
from functools import cache
from math import prod
from typing import NamedTuple, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from ...spec.balls import diameters
from ...spec.choices import Choice
from ...spec.requirements import Requirements
from ...variants import VARIANTS, Variant

Numbers: TypeAlias = NDArray[np.float64]
Mask: TypeAlias = NDArray[np.bool_]
Places: TypeAlias = NDArray[np.int64]


SAME = 1e-12
"""Relative slack of every limit: a candidate on the limit holds it."""


class Axes(NamedTuple):
    """Choice of the searched parameters, SI: an axis each, or a column of candidates; NaN where a variant has none."""

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


T = TypeVar("T")


def given(values: T | None) -> T:
    """What the rules of the requirements, or who asks, see to."""
    assert values is not None
    return values


def searched(need: Requirements, variant: Variant) -> dict[str, Choice]:
    """Choice of every axis that a variant has; the mean radius may be searched by the outer one."""
    search = need.search
    found = {"pairs": search.pairs, "mean_radius": search.radii}
    if variant.chooses_bypass:
        found["driving_pairs"] = search.driving_pairs
    if variant.controlled:
        found["steering"] = given(search.gain or search.wall_angle)
        found["ball_circle_radius"] = given(search.ball_circle_radius)
    if variant.travels:
        found["closing_stiffness"] = given(search.closing_stiffness)
        found["control_stiffness"] = given(search.control_stiffness)
    return found


def grids(need: Requirements, variant: Variant) -> Iterator[Axes]:
    """Lay out the axes of a variant, for every inner radius; an axis it does not have holds one NaN."""
    had = searched(need, variant)
    laid = Axes(*(had[name].array() if name in had else np.array([np.nan]) for name in Axes._fields))
    if need.search.inner_radius is None:
        yield laid
        return
    for inner in need.search.inner_radius.array():
        outer = laid.mean_radius[laid.mean_radius > inner]
        if outer.size:
            yield laid._replace(mean_radius=(inner + outer) / 2, inner_radius=np.array([inner]))


def forces(need: Requirements) -> int:
    """How many spring forces a catalogue holds."""
    return 1 if need.search.closing_forces is None else need.search.closing_forces.size


def total(need: Requirements) -> int:
    """Number of candidates asked for."""
    variants = (VARIANTS[name] for name in need.variants)
    radii, inner = need.search.radii, need.search.inner_radius
    both = radii.size
    if inner is not None:
        both = int((radii.size - np.searchsorted(radii.array(), inner.array(), "right")).sum())
    others = (
        prod(values.size for name, values in searched(need, variant).items() if name != "mean_radius")
        for variant in variants
    )
    return forces(need) * both * sum(others)


@cache
def _shipped() -> tuple[float, ...]:
    return tuple(diameters())


def balls(need: Requirements) -> Numbers:
    """Standard ball diameters to choose from, ascending, m."""
    listed = need.search.ball_diameters
    return np.array(_shipped()) if listed is None else listed.array()
