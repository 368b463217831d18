"""Elasticities of K_т by spec path, from finite differences calculated with one array."""

from typing import NamedTuple

import numpy as np

from .quantities import Quantities
from .selection import NAMES

STEP = 2.0**-15
"""Step of ln p, where p is the value of a key; the error grows with the square of the step."""
_KINK = 1e-5
"""Difference between left and right slope above which there is a kink."""
PATHS = {name: f"{path}.{key}" for path, names in NAMES.items() for key, name in names.items() if key != "margin"}
"""Quantity given by a spec → path of its key; without the margin, which belongs to the setting, not to the clutch."""


class Elasticity(NamedTuple):
    """Relative change of a quantity per relative change of a key, ∂ln y/∂ln p."""

    slope: float
    """Slope towards smaller values of the key."""
    larger: float
    """Slope towards larger values of the key; equals ``slope`` except at a kink."""

    @property
    def kink(self) -> bool:
        """True if left and right slope differ."""
        return self.slope != self.larger


def elasticities(clutch: Quantities) -> dict[str, Elasticity]:
    """Return path of a key → elasticity of K_т, for every given key on which K_т depends.

    A constant-torque pocket keeps its present slope C_1.
    """
    laws, given = clutch.laws, dict(clutch.given)
    variant, _, keys = clutch.laws.choice
    if "constant-torque" in keys:
        given["gain_slope"] = clutch["gain_slope"]
    if variant == "differentiated":
        given["bypass_pairs"] = clutch["bypass_pairs"]
    needs, fixed = laws.needs("accuracy_factor", frozenset(given)), Quantities(laws, given)
    shares, found = np.exp(np.array([-2, -1, 0, 1, 2]) * STEP), dict[str, Elasticity]()
    for one in sorted((one for one in PATHS if one in needs and one in given), key=lambda one: not given[one]):
        found[PATHS[one]] = Elasticity(0.0, 0.0)
        if given[one]:
            with np.errstate(all="ignore"):
                values = np.log(fixed.at(**{one: float(given[one]) * shares})["accuracy_factor"])
            found[PATHS[one]] = _slopes(np.broadcast_to(values, shares.shape).tolist())
    return found


def _slopes(beside: list[float]) -> Elasticity:
    """Elasticity from five values of ln K_т: by the two beside the middle or, at a kink, by the three on each side."""
    below, lower, middle, upper, above = beside
    left, right = (3 * middle - 4 * lower + below) / (2 * STEP), (4 * upper - 3 * middle - above) / (2 * STEP)
    if abs(left - right) > _KINK * max(1.0, abs(left), abs(right)):
        return Elasticity(left, right)
    slope = (upper - lower) / (2 * STEP)
    return Elasticity(slope, slope)
