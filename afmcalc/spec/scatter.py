"""The [tolerance] block: numbers of a clutch that scatter in manufacture and in service, and their distributions."""

import re
from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, FailFast, WithJsonSchema, field_validator

from ..messages import did_you_mean, say
from .fields import Block, Broken, Torque, key, keys_below, required, rule_error
from .quantity import NUMBER, Quantity, parse_quantity

Kind = Literal["normal", "uniform", "triangular", "lognormal"]
Setting = Literal["as-made", "each-adjusted"]

FRICTION = ("friction", "friction.driving", "friction.driven")
"""Names of the friction in service in [tolerance.fields]; elsewhere in the spec friction is not a key but a range."""

_NOT_OF_THE_CLUTCH = ("tolerance.", "requirements.")

Number = Annotated[float, BeforeValidator(Quantity("1").read)]
Whole = Annotated[int, BeforeValidator(Quantity("1", whole=True).read)]
Given = Annotated[Any, WithJsonSchema({"anyOf": [{"type": "number"}, {"type": "string"}]})]
"""Number in SI, or text with a unit that suits the scattering key."""


class Distribution(Block):
    """Scatter of one number about its value in the spec."""

    distribution: Kind = required("kind of the distribution")
    center: Given | None = key(
        "mean of normal and lognormal, middle of uniform, peak of triangular; default the value in the spec"
    )
    spread: Given | None = key(
        "standard deviation (normal, lognormal) or half-width (uniform, triangular); a quantity or a percentage"
    )
    min: Given | None = key("lower end; truncates a normal or lognormal distribution")
    max: Given | None = key("upper end; truncates a normal or lognormal distribution")


class Tolerance(Block):
    """Fields that scatter, and the method of the calculation."""

    setting: Setting = key(
        "how the springs of a sample are set; as-made: for the nominal clutch, and held; each-adjusted: on the bench",
        default="as-made",
    )
    samples: Whole = key("size of the sample", default=200_000, ge=1000, le=2_000_000)
    seed: Whole = key("start of the random numbers; the same seed gives the same digits", default=1, ge=0, le=2**63)
    quantiles: Annotated[tuple[Number, ...], FailFast()] = key(
        "probabilities of the quantiles", default=(0.005, 0.05, 0.5, 0.95, 0.995)
    )
    torque_limit: Torque | None = key("torque limit whose exceedance is asked for", "T_lim")
    friction_correlation: Number | None = key(
        "correlation of the normal scores of f_1 and f_2 (Gaussian copula; Pearson's of the frictions "
        "themselves is nearer 0 unless both are normal): 1 together (F11), 0 independent (default)",
        ge=-1,
        le=1,
    )
    sobol_base: Whole = key("base sample of the Sobol indices", default=16384, ge=64, le=2**20)
    fields: dict[str, Distribution] = required("spec path (or friction) to its distribution", min_length=1)

    @field_validator("quantiles")
    @classmethod
    def _inside(cls, given: tuple[float, ...]) -> tuple[float, ...]:
        if not given or not all(0 < p < 1 for p in given):
            raise ValueError(say("must be probabilities between 0 and 1, at least one"))
        return tuple(sorted(set(given)))


def in_si(given: Tolerance, spec: type[BaseModel]) -> Tolerance:
    """Tolerances with the numbers of each field in SI, by the unit of its key; ValidationError with every problem."""
    broken: list[Broken] = []
    fields: dict[str, Distribution] = {}
    for path, distribution in given.fields.items():
        about = scattering(path, spec)
        if about is None:
            broken.append((f"fields.{path}", _unknown(path, spec)))
            continue
        numbers: dict[str, float] = {}
        wrong: list[Broken] = []
        for name in ("center", "spread", "min", "max"):
            value = getattr(distribution, name)
            if value is None or percentage(value) is not None and name == "spread":
                continue  # a percentage stays relative to the value in the spec
            try:
                numbers[name] = parse_quantity(value, about.unit)
            except ValueError as error:
                wrong.append((name, str(error)))
        fields[path] = distribution.model_copy(update=numbers)
        wrong = wrong or [*_broken_rules(path, fields[path], about)]
        broken += ((f"fields.{path}.{key}", message) for key, message in wrong)
    if broken:
        raise rule_error(broken)
    return given.model_copy(update={"fields": fields})


def scattering(path: str, spec: type[BaseModel]) -> Quantity | None:
    """Unit and bounds of the number at a path, if it may scatter; None if it may not."""
    key = keys_below(spec).get("friction.min" if path in FRICTION else path)
    about = key.about if key else None
    return None if about is None or about.whole or path.startswith(_NOT_OF_THE_CLUTCH) else about


def percentage(value: object) -> float | None:
    """Percentage such as ``"5 %"`` as a share; None for any other value.

    >>> percentage("5 %"), percentage("5 mm")
    (0.05, None)
    """
    matched = re.fullmatch(rf"\s*({NUMBER})\s*%\s*", value) if isinstance(value, str) else None
    return float(matched[1]) / 100 if matched else None


def _broken_rules(path: str, given: Distribution, about: Quantity) -> Iterator[Broken]:
    """Violations of rules by a distribution whose numbers are in SI."""
    low: Any = given.min
    high: Any = given.max
    kind = given.distribution
    least, most = about.limits
    for name in ("center", "min", "max"):
        value: Any = getattr(given, name)
        if value is not None and value < least:
            yield name, say("must be at least {low:g}, as {path} itself", low=least, path=path)
        elif value is not None and value > most:
            yield name, say("must be at most {high:g}, as {path} itself", high=most, path=path)
    share = percentage(given.spread)
    size: Any = given.spread if share is None else share
    ends = (low is not None) + (high is not None)
    if size is not None and not size >= 0:
        yield "spread", say("must be at least 0")
    if ends == 2 and not low < high:
        yield "max", say("must be greater than min ({low:g})", low=low)
    if size is None and kind in ("normal", "lognormal"):
        yield "spread", say("required for {kind!r}", kind=kind)
    elif size is None and ends < 2 and path not in FRICTION:
        yield "spread", say("required for {kind!r} (or give min and max)", kind=kind)
    elif size is not None and ends and kind in ("uniform", "triangular"):
        yield "spread", say("excludes min and max: give a half-width or both ends")


def _unknown(path: str, spec: type[BaseModel]) -> str:
    known = keys_below(spec)
    if path in known:
        counts = (about := known[path].about) is not None and about.whole
        return say("is a whole number, which does not scatter") if counts else say("is not a number")
    if hint := did_you_mean(path, [*FRICTION, *known]):
        return say("unknown field{hint}", hint=hint)
    return say("unknown field; a spec path, or friction for the friction in service")
