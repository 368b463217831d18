"""F11's ratios of the frictions of unlike materials, n, p and m: swept and solved for like keys of the spec."""

from collections.abc import Mapping
from typing import Any, NamedTuple

from ...arrays import Values
from ...messages import say
from ...spec import Spec
from ...spec.edit import value_at
from ...spec.fields import Key
from ...spec.keys import keys


class Ratio(NamedTuple):
    """One ratio of two coefficients of friction."""

    path: str
    """Coefficient that moves with the ratio."""
    over: str
    """Coefficient that the ratio is taken over."""
    description: str

    @property
    def quotient(self) -> str:
        """What it is of the keys of the spec."""
        return f"{self.path}/{self.over}"

    def key(self, name: str) -> Key:
        """Return the coefficient that moves, called as the ratio."""
        return keys()[self.path]._replace(symbol=name, description=self.description)


_F1_MIN, _F1_MAX = "friction.driving.min", "friction.driving.max"
_F2_MIN, _F2_MAX = "friction.driven.min", "friction.driven.max"
RATIOS = {
    "n": Ratio(_F2_MAX, _F1_MAX, "ratio f_2max/f_1max; f_2max moves (unlike materials)"),
    "p": Ratio(_F2_MIN, _F1_MIN, "ratio f_2min/f_1min; f_2min moves (unlike materials)"),
    "m": Ratio(_F1_MAX, _F1_MIN, "ratio f_1max/f_1min; f_1max moves, f_2max = n f_1max with it (unlike materials)"),
}
"""F11 (15), (16) and the width of the interval of f_1."""


def paths_moved(name: str) -> tuple[str, ...]:
    """Return the keys that move with a ratio."""
    return (_F1_MAX, _F2_MAX) if name == "m" else (RATIOS[name].path,)


def no_ratio(name: str) -> str:
    """Return the hint for a ratio where the materials are not unlike; nothing for other names."""
    if name not in RATIOS:
        return ""
    about = say("; {name} is a ratio of unlike materials (friction.driving, friction.driven)", name=name)
    return about + say("; did you mean {paths}?", paths="control_unit.balls") if name == "n" else about


def coefficient(spec: Spec, path: str) -> float:
    """Return a coefficient of friction of one group, looked up in the catalogue where it names a material."""
    group, _, end = path.rpartition(".")
    return float(getattr(value_at(spec, group).range, end))


def current_ratio(spec: Spec, name: str) -> float:
    """Return what the ratio is in the spec."""
    return coefficient(spec, RATIOS[name].path) / coefficient(spec, RATIOS[name].over)


def moved(spec: Spec, ratios: Mapping[str, Values]) -> dict[str, Any]:
    """Return the coefficients of friction that given ratios stand for, by path; a ratio not given stays as it is."""
    values = {RATIOS[name].path: value * coefficient(spec, RATIOS[name].over) for name, value in ratios.items()}
    if "m" in ratios:
        values[_F2_MAX] = ratios.get("n", current_ratio(spec, "n")) * values[_F1_MAX]
    return values


def ends_of_ratio(spec: Spec, name: str) -> tuple[float, float]:
    """Return the ends of what a ratio may be: min ≤ mean ≤ max of either group, a mean as far as it is given."""

    def inner(group: str, end: str) -> float:
        return value_at(spec, f"{group}.mean") or coefficient(spec, f"{group}.{end}")

    over = coefficient(spec, RATIOS[name].over)
    if name == "p":
        return 0.0, inner("friction.driven", "max") / over
    low = inner("friction.driven", "min") / over
    if name == "m":
        return max(inner("friction.driving", "min") / over, low / current_ratio(spec, "n")), float("inf")
    return low, float("inf")
