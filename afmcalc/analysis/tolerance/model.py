"""What scatters, and the torque of a clutch as a function of it, its springs as made or adjusted for each sample."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...drive.result import dynamic_factor
from ...engines import Clutch, build
from ...engines.selection import quantities_of
from ...equations.arrays import Values
from ...errors import CalculationError
from ...messages import say
from ...spec import Spec
from ...spec.edit import value_at, with_key, with_values
from ...spec.keys import scatter_at
from ...spec.tolerance import FRICTION, Distribution, Tolerance, percentage

Array: TypeAlias = NDArray[np.float64]
_NEVER = 1e-20
"""Probability that no sample is large enough to meet."""
_LEAST_MASS = 1e-3
"""Share of a distribution that its limits must leave for it to be drawn at all."""


@dataclass(frozen=True)
class Input:
    """One number that scatters, SI."""

    path: str
    unit: str
    kind: Literal["normal", "uniform", "triangular", "lognormal"]
    center: float
    spread: float
    """Standard deviation, or half-width; for ends given, half their distance."""
    ends: tuple[float, float]
    """Ends of a uniform or triangular distribution before truncation."""
    limits: tuple[float, float]
    """Truncation."""

    @property
    def has_ends(self) -> bool:
        """Whether the distribution ends by itself."""
        return self.kind in ("uniform", "triangular")

    @property
    def bounds(self) -> tuple[float | None, float | None]:
        """Least and largest value there can be; None where there is none but what physics sets."""
        if self.has_ends:
            return max(self.ends[0], self.limits[0]), min(self.ends[1], self.limits[1])
        quantity = scatter_at(self.path)
        assert quantity is not None
        low, high = (None if limit == free else limit for limit, free in zip(self.limits, quantity.limits, strict=True))
        return low, high

    @cached_property
    def scores(self) -> tuple[float, float]:
        """Parameters of the normal score: the value is ``a + b·z``, or its exponential for lognormal."""
        if self.kind == "normal":
            return self.center, self.spread
        variance = math.log1p((self.spread / self.center) ** 2)
        return math.log(self.center) - variance / 2, math.sqrt(variance)

    def cdf(self, x: float) -> float:
        """Probability below x, before truncation."""
        low, high = self.ends
        if not self.has_ends:
            a, b = self.scores
            if self.kind == "lognormal":
                x = -math.inf if x <= 0 else math.log(x)
            return float(x >= a) if b == 0 else float(normal_probability((x - a) / b))
        if x <= low:
            return 0.0
        if x >= high:
            return 1.0
        if self.kind == "uniform":
            return (x - low) / (high - low)
        if x < self.center:
            return (x - low) ** 2 / ((high - low) * (self.center - low))
        return 1 - (high - x) ** 2 / ((high - low) * (high - self.center))

    @cached_property
    def mass(self) -> tuple[float, float]:
        """Probabilities at the limits; the part between them is what remains."""
        return self.cdf(self.limits[0]), self.cdf(self.limits[1])

    @property
    def kinks(self) -> list[float]:
        """Probabilities at which the quantile function has a kink."""
        return [self.share_below(self.center)] if self.kind == "triangular" else []

    def share_below(self, x: float) -> float:
        """Probability below x, truncation included."""
        below, above = self.mass
        share = (self.cdf(x) - below) / (above - below) if above > below else float(x >= self.center)
        return min(max(share, 0.0), 1.0)

    def quantiles(self, u: Array) -> Array:
        """Value at each probability of an array, truncation included."""
        below, above = self.mass
        u = below + u * (above - below)
        low, high = self.ends
        if not self.has_ends:
            a, b = self.scores
            values = a + b * normal_score(u)
            values = np.exp(values) if self.kind == "lognormal" else values
        elif self.kind == "uniform" or high == low:
            values = low + (high - low) * u
        else:
            rising = low + np.sqrt(u * ((high - low) * (self.center - low)))
            falling = high - np.sqrt((1 - u) * ((high - low) * (high - self.center)))
            values = np.where(u < (self.center - low) / (high - low), rising, falling)
        return np.clip(values, *self.limits)

    def draw(self, stream: np.random.Generator, size: int) -> Array:
        """Draw values from a stream of random numbers; of a normal one, what falls outside the limits again."""
        if self.spread == 0:
            return np.full(size, self.center)
        if self.has_ends:
            return self.quantiles(stream.random(size))
        values = self._draw_untruncated(stream, size)
        low, high = self.limits
        while (self.mass[0] > _NEVER and values.min() < low) or (high < math.inf and values.max() > high):
            outside = np.flatnonzero((values < low) | (values > high))
            values[outside] = self._draw_untruncated(stream, outside.size)
        return values

    def _draw_untruncated(self, stream: np.random.Generator, size: int) -> Array:
        a, b = self.scores
        values = stream.standard_normal(size)
        values *= b
        values += a
        return np.exp(values) if self.kind == "lognormal" else values


def inputs_of(spec: Spec) -> list[Input]:
    """Return what scatters in a spec, in the order of its [tolerance] block.

    Raises:
        CalculationError: a number that the spec does not have, or a distribution that leaves what it may be.
    """
    assert spec.tolerance is not None
    return [_input(spec, path, given) for path, given in spec.tolerance.fields.items()]


def _input(spec: Spec, path: str, given: Distribution) -> Input:
    """Center, spread and ends as given, else by the spec: the range of friction, or the value of the key."""
    quantity = scatter_at(path)
    assert quantity is not None
    unit, limits = quantity.unit, quantity.limits
    center, spread, low, high = (
        None if number is None or percentage(number) is not None else float(number)
        for number in (given.center, given.spread, given.min, given.max)
    )
    if path in FRICTION:
        friction = value_at(spec, path).range
        if given.distribution in ("uniform", "triangular") and given.spread is None:
            low = friction.min if low is None else low
            high = friction.max if high is None else high
        center = friction.mean if center is None else center
    elif value_at(spec, path.rpartition(".")[0]) is None:
        raise CalculationError("tolerance.fields.{path}: the spec has no such table to scatter in", path=path)
    elif center is None:
        center = value_at(spec, path)
        if center is None and low is not None and high is not None:
            center = (low + high) / 2
        if center is None:
            raise CalculationError("tolerance.fields.{path}: the spec has no {path} to scatter; give center", path=path)
    if (share := percentage(given.spread)) is not None:
        spread = abs(center) * share
    if spread is None:
        assert low is not None
        assert high is not None
        ends, spread = (low, high), (high - low) / 2
        if given.distribution == "triangular" and not low <= center <= high:
            raise CalculationError(
                "tolerance.fields.{path}: the peak {center:g} is not between min {low:g} and max {high:g}",
                path=path,
                center=center,
                low=low,
                high=high,
            )
    else:
        ends = center - spread, center + spread
        if given.distribution in ("uniform", "triangular") and not limits[0] <= ends[0] <= ends[1] <= limits[1]:
            raise CalculationError(
                "tolerance.fields.{path}: it would scatter from {low:g} to {high:g}, beyond what it may be, "
                "{least:g} to {most:g}",
                path=path,
                low=ends[0],
                high=ends[1],
                least=limits[0],
                most=limits[1],
            )
        limits = max(limits[0], -math.inf if low is None else low), min(limits[1], math.inf if high is None else high)
    if given.distribution == "lognormal" and not center > 0:
        raise CalculationError("tolerance.fields.{path}: a lognormal center must be greater than 0", path=path)
    scattering = Input(path, unit, given.distribution, center, spread, ends, limits)
    below, above = scattering.mass
    if not (above - below > _LEAST_MASS if spread > 0 else limits[0] <= center <= limits[1]):
        raise CalculationError(
            "tolerance.fields.{path}: the limits {low:g} to {high:g} leave nothing of the distribution",
            path=path,
            low=limits[0],
            high=limits[1],
        )
    return scattering


def normal_score(u: Array) -> Array:
    """Inverse of the normal distribution, of a number or an array."""
    from scipy.special import ndtri

    # 0 and 1 have no score; a probability so near to them is not told apart anyway
    return ndtri(np.clip(u, 1e-300, 1 - 2**-53))


def normal_probability(z: float | Array) -> Array:
    """Normal distribution of a number or an array."""
    from scipy.special import ndtr

    return ndtr(z)


_ONLY_SETTING = ("adjustment.", *(f"friction.{end}" for end in ("min", "mean", "max", "driving.", "driven.")))
"""Keys that act on a clutch through its setting alone."""
_CONTROL_FORCE = "control_spring.force"


@dataclass(frozen=True)
class Model:
    """A clutch and the numbers of it that scatter."""

    spec: Spec
    inputs: Sequence[Input]
    correlation: float = 0.0
    """Of the normal scores of f_1 and f_2."""

    @property
    def pair(self) -> tuple[int, ...]:
        """Places of the two correlated frictions; empty where they are independent."""
        paths = [scattering.path for scattering in self.inputs]
        if self.correlation and "friction.driving" in paths and "friction.driven" in paths:
            return paths.index("friction.driving"), paths.index("friction.driven")
        return ()

    @cached_property
    def centers(self) -> list[float]:
        """Center of each number that scatters."""
        return [scattering.center for scattering in self.inputs]

    @cached_property
    def may_fail(self) -> bool:
        """Whether there may be samples that are no clutch."""
        causes: tuple[str, ...] = ("friction_group.inner_radius", "friction_group.outer_radius")
        if self.spec.kind.law == "indirect":
            causes = ("friction_group.", "control_unit.")  # whatever the net gain depends on
        return any(scattering.path.startswith(causes) for scattering in self.inputs)

    def possible(self, values: Sequence[Values]) -> NDArray[np.bool_]:
        """Which samples are a clutch: feedback overcomes the friction at the key, the faces have a width."""
        spec = self._spec(values)
        group = spec.friction_group
        possible: NDArray[np.bool_] = np.ones(np.shape(values[0]), np.bool_)
        if group.inner_radius is not None and group.outer_radius is not None:
            possible &= group.inner_radius < group.outer_radius
        if spec.kind.travels:
            possible &= quantities_of(spec).net_gain > 0
        return possible

    def clutches_of(self, values: Sequence[Array]) -> Sequence[Array]:
        """Leave out the samples that are no clutch."""
        if not self.may_fail:
            return values
        possible = self.possible(values)
        return values if possible.all() else [column[possible] for column in values]

    def clutch(self, values: Sequence[Values]) -> Clutch:
        """Engine with values (numbers or arrays) in place of those of the spec."""
        return build(self._spec(values))

    def _spec(self, values: Sequence[Values]) -> Spec:
        keys = {path: value for path, value in self.by_path(values).items() if path not in FRICTION}
        return with_values(self.spec, keys)

    def by_path(self, values: Sequence[Values]) -> dict[str, Values]:
        """Values by the path of what scatters."""
        return {scattering.path: value for scattering, value in zip(self.inputs, values, strict=True)}

    def torque(self, values: Sequence[Values]) -> Values:
        """Slip torque, N·m."""
        return self.clutch(values).torque(*self.frictions(self.by_path(values)))

    def torque_along(self, u: Array) -> Array:
        """Slip torque with every number that scatters at each probability of an array, N·m."""
        return np.broadcast_to(self.torque([scattering.quantiles(u) for scattering in self.inputs]), u.shape)

    def frictions(self, named: Mapping[str, Values]) -> tuple[Values, Values]:
        """f_1 and f_2 as named, twice the same with one material; the mean where none is."""
        driving, driven = self.spec.friction.groups
        if self.spec.friction.unlike:
            return named.get("friction.driving", driving.mean), named.get("friction.driven", driven.mean)
        alike = named.get("friction", driving.mean)
        return alike, alike


def with_setting(clutch: Clutch, given: Tolerance) -> Spec:
    """Return the spec of the samples: as-made the springs of the nominal clutch, each-adjusted those a sample needs.

    Raises:
        SpecError: a field scatters that this clutch does not have, or that could have no effect.
    """
    as_made, unlike = given.setting == "as-made", clutch.spec.friction.unlike
    for path in given.fields:
        if path in FRICTION and (path == "friction") == unlike:
            use = say("friction.driving and friction.driven") if unlike else "friction"
            message = say("this clutch has {use} instead", use=use)
        elif as_made and path.startswith(_ONLY_SETTING):
            message = say(
                'acts through the setting alone, which "as-made" holds: give tolerance.setting = "each-adjusted"'
            )
        elif not as_made and path == _CONTROL_FORCE:
            message = say('follows from the setting of each clutch: give tolerance.setting = "as-made"')
        else:
            continue
        raise clutch.spec.refused(f"tolerance.fields.{path}", message)
    spec = clutch.spec
    if spec.fatigue is not None and spec.drive.dynamic_factor is None:
        # the life of every sample takes that of the nominal clutch
        from ..simulate import simulate

        spec = with_values(spec, {"drive.dynamic_factor": dynamic_factor(spec.drive, lambda: simulate(clutch)[0])})
    if as_made:
        spec = with_key(spec, "closing_spring.force", float(clutch.closing_force))
    if clutch.spec.kind.travels:
        spec = with_values(spec, {_CONTROL_FORCE: float(clutch.control_force) if as_made else None})
    if "gain_slope" in clutch.quantities:
        # pockets are cut once, for the nominal clutch
        spec = with_key(spec, "control_unit.gain_slope", float(clutch.gain_slope))
    return spec
