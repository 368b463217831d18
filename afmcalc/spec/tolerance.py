"""The [tolerance] block: which numbers of a clutch scatter in making and service, and how."""

import re
from typing import Any, Literal

from pydantic import Field, field_validator, model_validator

from ..errors import Problem
from ..messages import say
from . import rules
from .fields import Block, Torque, key_field
from .quantity import parse_quantity

Kind = Literal["normal", "uniform", "triangular", "lognormal"]
SamplingMethod = Literal["auto", "monte-carlo", "quasi-monte-carlo"]

FRICTION = ("friction", "friction.driving", "friction.driven")
"""Names of the friction in service, which is no single key of the spec but the range it wanders in."""

_PERCENT = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*%\s*")


class Distribution(Block):
    """How one number scatters about its value in the spec."""

    distribution: Kind = Field(description="kind of the distribution")
    center: float | str | None = key_field(
        "mean of normal and lognormal, middle of uniform, peak of triangular; default the value in the spec"
    )
    spread: float | str | None = key_field(
        "standard deviation (normal, lognormal) or half-width (uniform, triangular); a quantity or a percentage"
    )
    min: float | str | None = key_field("lower end; truncates a normal or lognormal distribution")
    max: float | str | None = key_field("upper end; truncates a normal or lognormal distribution")


class Tolerance(Block):
    """What scatters, and how it is calculated."""

    method: SamplingMethod = key_field(
        "auto: exact where only friction varies, else Monte Carlo; quasi-Monte Carlo needs SciPy", default="auto"
    )
    samples: int = Field(default=1_000_000, ge=1000, description="size of the sample")
    seed: int = Field(default=1, ge=0, description="seed: the same seed gives the same digits")
    quantiles: tuple[float, ...] = key_field("probabilities of the quantiles", default=(0.005, 0.05, 0.5, 0.95, 0.995))
    torque_limit: Torque | None = key_field("torque whose exceedance is asked for", "T_lim")
    friction_correlation: float | None = Field(
        default=None, ge=-1, le=1, description="correlation of f_1 and f_2: 1 together (F11), 0 independent (default)"
    )
    sobol_base: int = Field(default=65536, ge=64, description="base sample of the Sobol indices")
    fields: dict[str, Distribution] = Field(description="spec path (or friction) to its distribution", min_length=1)

    @field_validator("quantiles")
    @classmethod
    def _inside(cls, given: tuple[float, ...]) -> tuple[float, ...]:
        if not given or not all(0 < p < 1 for p in given):
            raise ValueError(say("must be probabilities between 0 and 1, at least one"))
        return tuple(sorted(set(given)))

    @model_validator(mode="after")
    def _read_quantities(self) -> "Tolerance":
        problems: list[Problem] = []
        fields = {path: _read(path, each, problems) for path, each in self.fields.items()}
        if problems:
            raise rules.RuleError(problems)
        object.__setattr__(self, "fields", fields)
        return self


def unit_at(path: str) -> str | None:
    """SI unit of what may scatter; None when the path is none of it."""
    from .paths import is_whole, keys

    if path in FRICTION:
        return "1"
    found = keys().get(path)
    return None if found is None or is_whole(path) or path.startswith("tolerance.") else found.unit


def percentage(value: object) -> float | None:
    """Share in a percentage such as ``"5 %"``; None for anything else.

    >>> percentage("5 %"), percentage("5 mm")
    (0.05, None)
    """
    matched = _PERCENT.fullmatch(value) if isinstance(value, str) else None
    return float(matched[1]) / 100 if matched else None


def physical_limits(path: str) -> tuple[float, float]:
    """Bounds that the spec sets to a field, which no scatter passes.

    >>> physical_limits("closing_spring.force"), physical_limits("friction")
    ((0.0, inf), (0.0, inf))
    """
    import math

    from .paths import quantity_at

    found = quantity_at("friction.min" if path in FRICTION else path)
    low, high = (found.low, found.high) if found else (None, None)
    return -math.inf if low is None else float(low), math.inf if high is None else float(high)


def _read(path: str, given: Distribution, problems: list[Problem]) -> Distribution:
    """Turn quantities into SI; percentages stay, since they follow the spec."""
    unit = unit_at(path)
    if unit is None:
        problems.append(rules.wrong(f"fields.{path}", _unknown(path)))
        return given
    read: dict[str, Any] = {}
    for name in ("center", "spread", "min", "max"):
        value = getattr(given, name)
        if value is None or (name == "spread" and percentage(value) is not None):
            read[name] = value
            continue
        try:
            read[name] = parse_quantity(value, unit)
        except ValueError as error:
            problems.append(rules.wrong(f"fields.{path}.{name}", str(error)))
            return given
    share = percentage(read["spread"])
    size = read["spread"] if share is None else share
    if size is not None and not size >= 0:
        problems.append(rules.wrong(f"fields.{path}.spread", say("must be at least 0")))
    low, high = read["min"], read["max"]
    if low is not None and high is not None and not low < high:
        problems.append(rules.wrong(f"fields.{path}.max", say("must be greater than min ({low:g})", low=low)))
    if given.distribution in ("normal", "lognormal") and size is None:
        problems.append(rules.wrong(f"fields.{path}.spread", say("required for {kind!r}", kind=given.distribution)))
    if given.distribution in ("uniform", "triangular") and size is None and path not in FRICTION:
        if low is None or high is None:
            message = say("required for {kind!r} (or give min and max)", kind=given.distribution)
            problems.append(rules.wrong(f"fields.{path}.spread", message))
    elif given.distribution in ("uniform", "triangular") and size is not None and (low is not None or high is not None):
        problems.append(
            rules.wrong(f"fields.{path}.spread", say("excludes min and max: give a half-width or both ends"))
        )
    return given.model_copy(update=read)


def _unknown(path: str) -> str:
    from .paths import is_whole, keys
    from .suggest import did_you_mean

    if path in keys():
        return say("is a whole number, which does not scatter") if is_whole(path) else say("is not a number")
    if hint := did_you_mean(path, [*FRICTION, *keys()]):
        return say("unknown field{hint}", hint=hint)
    return say("unknown field; a spec path, or friction for the friction in service")
