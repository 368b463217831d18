"""What a quantity of a clutch is sensitive to: elasticities by spec path, from one vectorised difference."""

from typing import Any, NamedTuple

from .quantities import Quantities
from .selection import DISCS, NAMES

STEP = 2.0**-13
"""Of ln p; by five points the error is of its fourth power, on one side of its second."""
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
    shares = np.array([-2, -1, 1, 2]) * STEP
    arrays: dict[str, Any] = {}
    for place, one in enumerate(varied):
        arrays[one] = np.full(4 * len(varied) + 1, float(given[one]))
        arrays[one][4 * place : 4 * place + 4] *= np.exp(shares)
    with np.errstate(all="ignore"):
        values = np.log(np.broadcast_to(Quantities(laws, given | arrays)[name], 4 * len(varied) + 1))
    found = {one: _slopes(values[4 * at : 4 * at + 4].tolist(), float(values[-1])) for at, one in enumerate(varied)}
    return {_KEYS[one]: found[one] for one in varied} | {
        _KEYS[one]: Elasticity(0.0, 0.0) for one in _KEYS if one in needs and one in given and not given[one]
    }


def _slopes(beside: list[float], here: float) -> Elasticity:
    """Slopes of five values, by all of them or on each side of a kink by three."""
    below, lower, upper, above = beside
    left, right = (3 * here - 4 * lower + below) / (2 * STEP), (4 * upper - 3 * here - above) / (2 * STEP)
    if abs(left - right) > _KINK * max(1.0, abs(left), abs(right)):
        return Elasticity(left, right)
    slope = (8 * (upper - lower) - (above - below)) / (12 * STEP)
    return Elasticity(slope, slope)
