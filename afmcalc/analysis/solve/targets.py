"""Quantities that a design can be asked for: solve aims at them."""

from collections.abc import Callable
from typing import Literal, NamedTuple

from ...arrays import Values, larger, smaller
from ...engines.protocol import Clutch
from ...errors import AfmcalcError
from ...messages import say
from ...spec.quantity import parse_quantity
from ...spec.suggest import did_you_mean


class Target(NamedTuple):
    """One quantity of a clutch, as a function of it."""

    unit: str
    description: str
    value: Callable[[Clutch], Values]
    better: Literal["low", "high"]
    """Which side of the wanted value still meets it, where only whole numbers can be chosen."""


def _ends(clutch: Clutch) -> tuple[Values, Values]:
    first, second = clutch.friction
    return clutch.torque(first.min, second.min), clutch.torque(first.max, second.max)


def torque_min(clutch: Clutch) -> Values:
    """Smallest sustained torque along the common path, N·m."""
    return smaller(*_ends(clutch))


def scatter(clutch: Clutch) -> Values:
    """Width of the torque scatter band ΔT, N·m."""
    low, high = _ends(clutch)
    return larger(low, high) - smaller(low, high)


def _travel(clutch: Clutch) -> Values:
    travel: Values | None = clutch.travel(clutch.friction[0].max)
    if travel is None:
        raise AfmcalcError(say("travel_max is only of an indirect clutch: a direct one has no sleeve"))
    return travel


TARGETS: dict[str, Target] = {
    "accuracy_factor": Target("1", "accuracy factor", lambda c: c.accuracy_factor, "low"),
    "accuracy_factor_peak": Target("1", "accuracy factor by breakaway peaks", lambda c: c.accuracy_factor_peak, "low"),
    "accuracy_factor_worst_case": Target(
        "1", "accuracy factor, f_1 and f_2 independent", lambda c: c.accuracy_factor_worst_case, "low"
    ),
    "nominal_torque": Target("N*m", "nominal torque of the clutch", lambda c: c.nominal_torque, "high"),
    "torque_min": Target("N*m", "smallest torque", torque_min, "high"),
    "torque_max": Target("N*m", "largest torque", lambda c: c.torque_max, "low"),
    "scatter": Target("N*m", "torque scatter band", scatter, "low"),
    "reduced_gain": Target("1", "reduced gain", lambda c: c.reduced_gain, "low"),
    "closing_force": Target("N", "closing-spring force", lambda c: c.closing_force, "low"),
    "travel_max": Target("m", "largest travel of the sleeve", _travel, "low"),
}
"""Name, as in the JSON of the other commands → what it is."""


def parse_target(text: str) -> tuple[str, float]:
    """Read ``NAME=VALUE``, the value in SI or with a unit.

    Raises:
        AfmcalcError: no such target, or no such value.
    """
    name, separator, given = (part.strip() for part in text.partition("="))
    if name not in TARGETS:
        known = ", ".join(TARGETS)
        raise AfmcalcError(
            say(
                "{text!r} is no target{hint}; write NAME=VALUE, NAME one of {known}",
                text=text,
                hint=did_you_mean(name, TARGETS),
                known=known,
            )
        )
    if not separator or not given:
        raise AfmcalcError(say("{text}: write {name}=VALUE", text=text, name=name))
    unit = TARGETS[name].unit
    try:
        value = parse_quantity(_number_or_text(given), unit)
    except ValueError as error:
        raise AfmcalcError(say("{text}: {why}", text=text, why=error)) from None
    if not value > 0:
        raise AfmcalcError(say("{text}: must be greater than 0", text=text))
    return name, value


def _number_or_text(given: str) -> float | str:
    try:
        return float(given)
    except ValueError:
        return given
