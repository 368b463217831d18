"""The keys of a clutch's spec, and the symbols that stand for them."""

import math

from . import tolerance
from .models import Spec
from .walk import Key, keys_below

ALIASES = {
    "C": "control_unit.gain",
    "z": "friction_group.pairs",
    "z1": "friction_group.driving_pairs",
    "R": "friction_group.mean_radius",
    "F": "closing_spring.force",
    "f_min": "friction.min",
    "f_cp": "friction.mean",
    "f_mean": "friction.mean",
    "f_max": "friction.max",
    "c1": "closing_spring.stiffness",
    "c2": "control_spring.stiffness",
    "beta": "adjustment.margin",
    "T_n": "adjustment.nominal_torque",
    "r": "control_unit.ball_circle_radius",
    "alpha": "control_unit.wall_angle",
    "f1": "control_unit.key_friction",
    "d": "control_unit.hub_diameter",
    "gain_slope": "control_unit.gain_slope",
}
"""Symbols that stand for a path on the command line."""


def keys() -> dict[str, Key]:
    """Every value key of a spec by dotted path."""
    return keys_below(Spec)


def is_whole(path: str) -> bool:
    """Whether the key counts something."""
    found = keys().get(path)
    return found is not None and found.about is not None and found.about.whole


def unit_at(path: str) -> str | None:
    """SI unit of what may scatter; None when the path is none of it."""
    found = tolerance.scattering(path, Spec)
    return found.unit if found else None


def physical_limits(path: str) -> tuple[float, float]:
    """Bounds that the spec sets to what may scatter, which no scatter passes.

    >>> physical_limits("closing_spring.force"), physical_limits("friction")
    ((0.0, inf), (0.0, inf))
    """
    found = tolerance.scattering(path, Spec)
    low, high = (found.low, found.high) if found else (None, None)
    return -math.inf if low is None else float(low), math.inf if high is None else float(high)
