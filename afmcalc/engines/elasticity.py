"""What a quantity of a clutch is sensitive to: elasticities by spec path, from one vectorised difference."""

from typing import Any, NamedTuple

from .quantities import Quantities
from .selection import DISCS, NAMES

STEP = 2.0**-13
"""Of ln p; by five points the error is of its fourth power, on one side of its third."""
_KINK = 1e-5
"""Difference of the slopes on both sides above which there is a kink."""
_KEYS = {
    name: f"{path}.{key}"
    for path in (
        "friction",
        "friction.driving",
        "friction.driven",
        "friction_group",
        "closing_spring",
        "control_spring",
    )
    for key, name in NAMES[path].items()
} | {
    "nominal_torque_wanted": "adjustment.nominal_torque",
    **{
        name: f"control_unit.{key}"
        for key, name in NAMES["control_unit"].items()
        if key in ("gain", "gain_slope", "wall_angle", "ball_circle_radius", "hub_diameter", "key_friction")
    },
}


class Elasticity(NamedTuple):
    """Relative slope of a quantity in a key of the spec, ∂ln y/∂ln p."""

    slope: float
    """At a kink that on the side where the key is smaller."""
    larger: float
    """The slope on the side where the key is larger; that of ``slope`` but at a kink."""

    @property
    def kink(self) -> bool:
        """Whether the slopes on both sides differ."""
        return self.slope != self.larger


def elasticities(clutch: Quantities, name: str = "accuracy_factor") -> dict[str, Elasticity]:
    """Return the elasticities of a quantity by spec path, in every key that the clutch gives and the quantity needs.

    A disc spring counts as a straight one of its stiffness, a pocket as it is cut.
    """
    import numpy as np

    function, variant, method, keys = clutch.laws.made_by or ()
    laws = function(variant, method, keys - {*DISCS})
    given = {one: value for one, value in clutch.given.items() if one not in DISCS}
    if "constant-torque" in keys:
        given["gain_slope"] = clutch["gain_slope"]
    if variant == "differentiated":
        given["bypass_pairs"] = clutch["bypass_pairs"]
    needs = laws.needs(name, frozenset(given))
    varied = [one for one in _KEYS if one in needs and given.get(one)]
    shares = np.array([-3, -2, -1, 1, 2, 3]) * STEP
    arrays: dict[str, Any] = {}
    for place, one in enumerate(varied):
        arrays[one] = np.full(6 * len(varied) + 1, float(given[one]))
        arrays[one][6 * place : 6 * place + 6] *= np.exp(shares)
    with np.errstate(all="ignore"):
        values = np.log(np.broadcast_to(Quantities(laws, given | arrays)[name], 6 * len(varied) + 1))
    found = {one: _slopes(values[6 * at : 6 * at + 6].tolist(), float(values[-1])) for at, one in enumerate(varied)}
    return {_KEYS[one]: found[one] for one in varied} | {
        _KEYS[one]: Elasticity(0.0, 0.0) for one in _KEYS if one in needs and one in given and not given[one]
    }


def _slopes(beside: list[float], here: float) -> Elasticity:
    """Slopes of seven values: by the five in the middle, or on each side of a kink by four."""
    lowest, below, lower, upper, above, highest = beside
    left = (11 * here - 18 * lower + 9 * below - 2 * lowest) / (6 * STEP)
    right = (18 * upper - 11 * here - 9 * above + 2 * highest) / (6 * STEP)
    if abs(left - right) > _KINK * max(1.0, abs(left), abs(right)):
        return Elasticity(left, right)
    slope = (8 * (upper - lower) - (above - below)) / (12 * STEP)
    return Elasticity(slope, slope)
