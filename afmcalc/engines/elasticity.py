"""Elasticities of a quantity of a clutch by spec path, from one vectorised difference."""

from typing import Any, NamedTuple

from .quantities import Quantities
from .selection import NAMES

STEP = 2.0**-16
"""Of ln p; the error is of its fourth power."""
_KINK = 1e-5
"""Difference of the slopes on both sides above which there is a kink."""
PATHS = {name: f"{path}.{key}" for path, names in NAMES.items() for key, name in names.items() if key != "margin"}
"""Quantity that a spec gives → its key; the margin is of the setting, not of the clutch."""


class Elasticity(NamedTuple):
    """Relative slope of a quantity in a key of the spec, ∂ln y/∂ln p."""

    slope: float
    """At a kink that on the side where the key is smaller."""
    larger: float
    """The slope on the side where the key is larger; that of ``slope`` but at a kink."""

    @property
    def kink(self) -> bool:
        """True if the slopes on both sides differ."""
        return self.slope != self.larger


def elasticities(clutch: Quantities) -> dict[str, Elasticity]:
    """Return the elasticities of K_т by spec path, in every key that the clutch gives and it needs.

    A pocket is kept as it is cut.
    """
    import numpy as np

    laws, given = clutch.laws, dict(clutch.given)
    function, variant, method, keys = clutch.laws.made_by or ()
    if "constant-torque" in keys:
        given["gain_slope"] = clutch["gain_slope"]
    if variant == "differentiated":
        given["bypass_pairs"] = clutch["bypass_pairs"]
    needs = laws.needs("accuracy_factor", frozenset(given))
    varied = [one for one in PATHS if one in needs and given.get(one)]
    shares = np.array([-5, -4, -3, -2, -1, 1, 2, 3, 4, 5]) * STEP
    arrays: dict[str, Any] = {}
    for place, one in enumerate(varied):
        arrays[one] = np.full((len(varied), len(shares)), float(given[one]))
        arrays[one][place] *= np.exp(shares)
        arrays[one] = arrays[one].ravel()
    with np.errstate(all="ignore"):
        values = np.log(np.broadcast_to(Quantities(laws, given | arrays)["accuracy_factor"], len(varied) * len(shares)))
    beside = values.reshape(len(varied), len(shares)).tolist()
    found = dict(zip(varied, map(_slopes, beside), strict=True))
    return {PATHS[one]: found[one] for one in varied} | {
        PATHS[one]: Elasticity(0.0, 0.0) for one in PATHS if one in needs and one in given and not given[one]
    }


def _slopes(beside: list[float]) -> Elasticity:
    """Slopes between ten values: by the four in the middle, or by those on each side where they differ."""
    below, lower, upper, above = beside[3:7]
    left, right = -_one_sided(beside[4::-1]), _one_sided(beside[5:])
    if abs(left - right) > _KINK * max(1.0, abs(left), abs(right)):
        return Elasticity(left, right)
    slope = (8 * (upper - lower) - (above - below)) / (12 * STEP)
    return Elasticity(slope, slope)


def _one_sided(ahead: list[float]) -> float:
    """Slope where five values on one side begin, without that place: a kink may lie just beside it."""
    weights = -77, 214, -234, 122, -25
    return sum(weight * value for weight, value in zip(weights, ahead, strict=True)) / (12 * STEP)
