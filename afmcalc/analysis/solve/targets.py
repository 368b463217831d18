"""Quantities that a design can be asked for: solve aims at them."""

from collections.abc import Callable
from typing import Literal, NamedTuple

from ...arrays import Values
from ...engines.protocol import Clutch
from ...errors import AfmcalcError
from ...messages import say
from ...spec.quantity import parse_quantity
from ...spec.suggest import did_you_mean, plain


class Target(NamedTuple):
    """One quantity of a clutch, as a function of it."""

    unit: str
    description: str
    value: Callable[[Clutch], Values]
    better: Literal["low", "high"]
    """Which side of the wanted value still meets it, where only whole numbers can be chosen."""
    symbols: tuple[str, ...]
    """What else it is called: symbols, and the path of the key that sets it."""


def _travel(clutch: Clutch) -> Values:
    travel: Values | None = clutch.travel(clutch.friction[0].max)
    if travel is None:
        raise AfmcalcError(say("travel_max is only of an indirect clutch: a direct one has no sleeve"))
    return travel


TARGETS: dict[str, Target] = {
    "accuracy_factor": Target("1", "accuracy factor", lambda c: c.accuracy_factor, "low", ("K_т",)),
    "accuracy_factor_peak": Target(
        "1", "accuracy factor by breakaway peaks", lambda c: c.accuracy_factor_peak, "low", ("K_т,p",)
    ),
    "nominal_torque": Target(
        "N*m", "nominal torque of the clutch", lambda c: c.nominal_torque, "high", ("T_н", "adjustment.nominal_torque")
    ),
    "torque_min": Target("N*m", "smallest torque", lambda c: c.torque_min, "high", ("T_min",)),
    "torque_max": Target("N*m", "largest torque", lambda c: c.torque_max, "low", ("T_max",)),
    "scatter": Target("N*m", "torque scatter band", lambda c: c.scatter, "low", ("ΔT",)),
    "reduced_gain": Target("1", "reduced gain", lambda c: c.reduced_gain, "low", ("zC", "z_2 C", "z_2C")),
    "closing_force": Target(
        "N", "closing-spring force", lambda c: c.closing_force, "low", ("F_п", "F", "closing_spring.force")
    ),
    "travel_max": Target("m", "largest travel of the sleeve", _travel, "low", ("x_max",)),
}
"""Name, as in the JSON of the other commands → what it is."""


def target_of(text: str) -> str | None:
    """Return the target that ``NAME`` or ``NAME=VALUE`` names, by name or symbol; None when it names none."""
    wanted = plain(text.partition("=")[0].strip())
    return next((name for name, each in TARGETS.items() if wanted in map(plain, (name, *each.symbols))), None)


def in_order(target: str, spec: str | None) -> tuple[str, str | None]:
    """Return target and spec, whichever was given first.

    >>> in_order("clutch.toml", "K_т=2")
    ('K_т=2', 'clutch.toml')
    """

    def is_target(text: str) -> tuple[bool, bool]:
        return "=" in text and target_of(text) is not None, "=" in text

    return (spec, target) if spec is not None and is_target(spec) > is_target(target) else (target, spec)


def parse_target(text: str) -> tuple[str, float]:
    """Read ``NAME=VALUE``, the value in SI or with a unit.

    Raises:
        AfmcalcError: no such target, or no such value.
    """
    given, separator, value = (part.strip() for part in text.partition("="))
    name = target_of(given)
    if name is None:
        raise AfmcalcError(
            say(
                "{text!r:.80} is no target{hint}; write NAME=VALUE, NAME one of {known}",
                text=text,
                hint=did_you_mean(given, [*TARGETS, *(symbol for each in TARGETS.values() for symbol in each.symbols)]),
                known=", ".join(f"{name} ({each.symbols[0]})" for name, each in TARGETS.items()),
            )
        )
    if not separator or not value:
        raise AfmcalcError(say("{text:.80}: write {name}=VALUE", text=text, name=given))
    try:
        wanted = parse_quantity(_number_or_text(value), TARGETS[name].unit)
    except ValueError as error:
        raise AfmcalcError(say("{text:.80}: {why}", text=text, why=error)) from None
    if not wanted > 0:
        raise AfmcalcError(say("{text:.80}: must be greater than 0", text=text))
    return name, wanted


def _number_or_text(given: str) -> float | str:
    try:
        return float(given)
    except ValueError:
        return given
