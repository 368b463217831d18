"""The [tolerance] block: which numbers of a clutch scatter in making and service, and how."""

import re
import sys
from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, FailFast, Field, field_validator

from ..errors import Problem
from ..messages import say
from . import rules
from .fields import Block, Quantity, Torque, key_field
from .quantity import parse_quantity
from .walk import keys_below

Kind = Literal["normal", "uniform", "triangular", "lognormal"]
Setting = Literal["as-made", "each-adjusted"]
SamplingMethod = Literal["auto", "monte-carlo", "quasi-monte-carlo"]

FRICTION = ("friction", "friction.driving", "friction.driven")
"""Names of the friction in service, which is no single key of the spec but the range it wanders in."""

_NOT_OF_THE_CLUTCH = ("tolerance.", "requirements.")

_PERCENT = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*%\s*")


def _number_or_text(value: object) -> object:
    if isinstance(value, bool):
        raise ValueError(say("a boolean is not a number"))
    if not isinstance(value, int | float | str):
        raise ValueError(say("must be a number, or a text with a unit"))
    if not isinstance(value, str) and not abs(value) <= sys.float_info.max:
        raise ValueError(say("must be finite"))
    return value


Number = Annotated[float, BeforeValidator(Quantity("1").read)]
Whole = Annotated[int, BeforeValidator(Quantity("1", whole=True).read)]
Given = Annotated[float | str, BeforeValidator(_number_or_text)]
"""A number in SI or a text with a unit; which unit depends on what scatters."""


class Distribution(Block):
    """How one number scatters about its value in the spec."""

    distribution: Kind = Field(description="kind of the distribution")
    center: Given | None = key_field(
        "mean of normal and lognormal, middle of uniform, peak of triangular; default the value in the spec"
    )
    spread: Given | None = key_field(
        "standard deviation (normal, lognormal) or half-width (uniform, triangular); a quantity or a percentage"
    )
    min: Given | None = key_field("lower end; truncates a normal or lognormal distribution")
    max: Given | None = key_field("upper end; truncates a normal or lognormal distribution")


class Tolerance(Block):
    """What scatters, and how it is calculated."""

    method: SamplingMethod = key_field("auto: exact where only friction varies, else Monte Carlo", default="auto")
    setting: Setting = key_field(
        "as-made: springs set for the nominal clutch and held; each-adjusted: every clutch set on the bench",
        default="as-made",
    )
    samples: Whole = Field(default=1_000_000, ge=1000, le=10**10, description="size of the sample")
    seed: Whole = Field(default=1, ge=0, le=2**63, description="seed: the same seed gives the same digits")
    quantiles: Annotated[tuple[Number, ...], FailFast()] = key_field(
        "probabilities of the quantiles", default=(0.005, 0.05, 0.5, 0.95, 0.995)
    )
    torque_limit: Torque | None = key_field("torque whose exceedance is asked for", "T_lim")
    friction_correlation: Number | None = Field(
        default=None,
        ge=-1,
        le=1,
        description="correlation of the normal scores of f_1 and f_2 (Gaussian copula; Pearson's of the frictions "
        "themselves is nearer 0 unless both are normal): 1 together (F11), 0 independent (default)",
    )
    sobol_base: Whole = Field(default=65536, ge=64, le=2**30, description="base sample of the Sobol indices")
    fields: dict[str, Distribution] = Field(description="spec path (or friction) to its distribution", min_length=1)

    @field_validator("quantiles")
    @classmethod
    def _inside(cls, given: tuple[float, ...]) -> tuple[float, ...]:
        if not given or not all(0 < p < 1 for p in given):
            raise ValueError(say("must be probabilities between 0 and 1, at least one"))
        return tuple(sorted(set(given)))


def in_si(given: Tolerance, spec: type[BaseModel]) -> Tolerance:
    """Turn what the user wrote of each field into SI, by the unit of the key of ``spec`` that scatters.

    Raises:
        RuleError: a field that does not scatter, or not so.
    """
    problems: list[Problem] = []
    fields = {path: _read(path, each, problems, spec) for path, each in given.fields.items()}
    if problems:
        raise rules.RuleError(problems)
    return given.model_copy(update={"fields": fields})


def scattering(path: str, spec: type[BaseModel]) -> Quantity | None:
    """What a number that scatters may be; None when nothing that may scatter is at the path."""
    found = keys_below(spec).get("friction.min" if path in FRICTION else path)
    about = found.about if found else None
    return None if about is None or about.whole or path.startswith(_NOT_OF_THE_CLUTCH) else about


def percentage(value: object) -> float | None:
    """Share in a percentage such as ``"5 %"``; None for anything else.

    >>> percentage("5 %"), percentage("5 mm")
    (0.05, None)
    """
    matched = _PERCENT.fullmatch(value) if isinstance(value, str) else None
    return float(matched[1]) / 100 if matched else None


def _read(path: str, given: Distribution, problems: list[Problem], spec: type[BaseModel]) -> Distribution:
    """Turn quantities into SI; percentages stay, since they follow the spec."""
    about = scattering(path, spec)
    if about is None:
        problems.append(rules.wrong(f"fields.{path}", _unknown(path, spec)))
        return given
    read: dict[str, Any] = {}
    for name in ("center", "spread", "min", "max"):
        value = getattr(given, name)
        if value is None or (name == "spread" and percentage(value) is not None):
            read[name] = value
            continue
        try:
            read[name] = parse_quantity(value, about.unit)
        except ValueError as error:
            problems.append(rules.wrong(f"fields.{path}.{name}", str(error)))
            return given
    for name in ("center", "min", "max"):
        value = read[name]
        if value is not None and about.low is not None and value < about.low:
            message = say("must be at least {low:g}, as {path} itself", low=about.low, path=path)
            problems.append(rules.wrong(f"fields.{path}.{name}", message))
        elif value is not None and about.high is not None and value > about.high:
            message = say("must be at most {high:g}, as {path} itself", high=about.high, path=path)
            problems.append(rules.wrong(f"fields.{path}.{name}", message))
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


def _unknown(path: str, spec: type[BaseModel]) -> str:
    from .suggest import did_you_mean

    known = keys_below(spec)
    if path in known:
        counts = (about := known[path].about) is not None and about.whole
        return say("is a whole number, which does not scatter") if counts else say("is not a number")
    if hint := did_you_mean(path, [*FRICTION, *known]):
        return say("unknown field{hint}", hint=hint)
    return say("unknown field; a spec path, or friction for the friction in service")
