"""Scatter of torque, life and peak torque under tolerances: a random sample, its quantiles, risks, Sobol indices."""

import math
from collections import ChainMap
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from typing import Any, ClassVar, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from ..drive.cases import case_of
from ..engines import Clutch, build
from ..engines.evaluate import BLOCK
from ..equations import life as law
from ..equations.arrays import Values
from ..errors import CalculationError
from ..findings import Finding, finding
from ..messages import say
from ..progress import counted
from ..result import Answer, Result, described, quantity, shown_as
from ..spec import Spec
from ..spec.edit import value_at, with_key, with_values
from ..spec.keys import scatter_at
from ..spec.scatter import FRICTION, Distribution, Kind, Setting, Tolerance, percentage
from ..spec.write import lacking
from .clutch_findings import clutch_findings
from .drive_result import dynamic_factor
from .registry import ANALYSES

Array: TypeAlias = NDArray[np.float64]
Sample: TypeAlias = Mapping[str, Array]
"""Path of a key that scatters → its values, one for each clutch."""
Quantile: TypeAlias = Callable[[Array], Array]
"""Quantile function of a truncated distribution: probability → value that is not exceeded with this probability."""

BATCHES = 32
"""Number of batches of a sample; the spread of a statistic over the batches gives its standard error."""
EVENTS = 64
"""Number of friction values at which the event is simulated."""
SLIPS = 2_500_000
"""Largest number of slips whose damage is calculated; it limits the number of clutches in the sample."""
ROBUST = (0.995, 0.005)
"""Probabilities whose quantiles stand for the largest and smallest torque."""
CENTRAL = (0.0005, 0.9995)
"""Probabilities whose quantiles are the ends of the histogram: a whole long tail would make its bars too wide."""
_BARS, _LEAST_MASS = 60, 1e-3
_UNSURE, _HEAVY = 0.025, 10.0
"""Relative standard error of the standard deviation, and kurtosis: if both are larger, the error is underestimated."""
_ONLY_SETTING = ("adjustment.", *(f"friction.{end}" for end in ("min", "mean", "max", "driving.", "driven.")))
"""Beginnings of the keys that affect a clutch only through its setting."""
_CLOSING_FORCE, _CONTROL_FORCE = "closing_spring.force", "control_spring.force"


def _error(of: str, figure: Any) -> Any:
    """Declare the field for the standard error of the field ``figure``, whose name is ``of``."""
    shown = shown_as(figure)
    optional = not figure.is_required()
    return quantity(shown.unit, f"± {shown.symbol}", "standard error of it", optional=optional, error_of=of)


def _optional(unit: str, symbol: str, description: str) -> Any:
    return quantity(unit, symbol, description, optional=True)


class InputRow(Result):
    """One number that scatters."""

    path: str = described("parameter")
    distribution: str = described("distribution")
    min: float | None = described("min", optional=True, unit_in="unit")
    center: float = described("mean or peak", unit_in="unit")
    max: float | None = described("max", optional=True, unit_in="unit")
    spread: float = described("deviation or half-width", unit_in="unit")
    unit: str = described("unit", is_unit=True)


class QuantileRow(Result):
    """Quantiles at one probability: torque, life of the shaft, peak torque."""

    probability: float = quantity("1", None, "probability")
    torque: float = quantity("N*m", "T_p", "torque not exceeded with this probability")
    torque_standard_error: float = _error("torque", torque)
    life_protected: float | None = _optional("1", "N_ц,p", "slips, protected side")
    life_protected_standard_error: float | None = _error("life_protected", life_protected)
    life_unprotected: float | None = _optional("1", "N'_ц,p", "slips, unprotected side")
    life_unprotected_standard_error: float | None = _error("life_unprotected", life_unprotected)
    peak_torque: float | None = _optional("N*m", "T_peak,p", "peak torque not exceeded with this probability")
    peak_torque_standard_error: float | None = _error("peak_torque", peak_torque)


class IndexRow(Result):
    """Sobol indices of one input."""

    path: str = described("parameter")
    first_order: float = quantity("1", "S_1", "first-order Sobol index")
    first_order_standard_error: float = _error("first_order", first_order)
    total: float = quantity("1", "S_T", "total Sobol index")
    total_standard_error: float = _error("total", total)


class Bar(Result):
    """One bar of the histogram of the torque."""

    low: float = quantity("N*m", None, "lower end of the bar")
    high: float = quantity("N*m", None, "upper end of the bar")
    density: float = quantity("1/(N*m)", None, "probability density")


class ToleranceResult(Answer):
    """Distribution of the slip torque, of life and of peak torque."""

    many_lists: ClassVar[bool] = True

    setting: Setting = described("how the springs are set")
    samples: int = described("sample size")
    probability_no_clutch: float | None = _optional(
        "1", "P(–)", "share of samples that make no working clutch; all other figures are of those that do"
    )
    probability_no_clutch_standard_error: float | None = _error("probability_no_clutch", probability_no_clutch)
    mean: float = quantity("N*m", "T_m", "mean torque")
    mean_standard_error: float = _error("mean", mean)
    standard_deviation: float = quantity("N*m", "s_T", "standard deviation of the torque")
    standard_deviation_standard_error: float = _error("standard_deviation", standard_deviation)
    accuracy_factor_robust: float = quantity("1", "K_т,r", "robust accuracy factor q(99.5 %)/q(0.5 %)")
    accuracy_factor_robust_standard_error: float = _error("accuracy_factor_robust", accuracy_factor_robust)
    torque_limit: float | None = _optional("N*m", "T_lim", "torque limit whose exceedance is asked for")
    probability_above_limit: float | None = _optional("1", "P(T>T_lim)", "probability above the limit")
    probability_above_limit_standard_error: float | None = _error("probability_above_limit", probability_above_limit)
    machine_torque: float = quantity("N*m", "T_н.маш", "nominal torque of the machine")
    probability_below_machine: float = quantity("1", "P(T<T_н.маш)", "probability below the machine's nominal torque")
    probability_below_machine_standard_error: float = _error("probability_below_machine", probability_below_machine)
    life_protected: float | None = _optional(
        "1", "N_ц", "slips to failure at the clutches' mean damage, protected side (harmonic mean of lives)"
    )
    life_protected_standard_error: float | None = _error("life_protected", life_protected)
    life_unprotected: float | None = _optional(
        "1", "N'_ц", "slips to failure at the clutches' mean damage, unprotected side"
    )
    life_unprotected_standard_error: float | None = _error("life_unprotected", life_unprotected)
    peak_torque_mean: float | None = _optional("N*m", "T_peak,m", "mean peak torque in the shaft")
    peak_torque_mean_standard_error: float | None = _error("peak_torque_mean", peak_torque_mean)
    peak_torque_deviation: float | None = _optional("N*m", "s_peak", "standard deviation of the peak torque")
    peak_torque_deviation_standard_error: float | None = _error("peak_torque_deviation", peak_torque_deviation)
    probability_peak_above: float | None = _optional(
        "1", "P(T_peak)", "probability of a peak above requirements.peak_torque"
    )
    probability_peak_above_standard_error: float | None = _error("probability_peak_above", probability_peak_above)
    inputs: list[InputRow] = described("what scatters")
    sobol: list[IndexRow] = described("share in the variance of the torque")
    quantiles: list[QuantileRow] = described("quantiles of torque, life of the shaft and peak torque")
    histogram: list[Bar] = described("histogram of the middle 99.9 % of the torques", data=True)


def _distribution(kind: Kind, center: float, spread: float, low: float, high: float) -> Any:
    from scipy import stats

    match kind:
        case "normal":
            return stats.norm(center, spread)
        case "uniform":
            return stats.uniform(low, high - low)
        case "triangular":
            return stats.triang((center - low) / (high - low), low, high - low)
        case "lognormal":
            variance = math.log1p((spread / center) ** 2) if center > 0 else math.nan
            return stats.lognorm(variance**0.5, scale=center * math.exp(-variance / 2))


def input_of(spec: Spec, path: str, given: Distribution) -> tuple[InputRow, Quantile]:
    """Return row and quantile function of a key; numbers not given follow from the key's value or range in the spec.

    Raises CalculationError if the spec does not have the key, or if the distribution exceeds the limits of the key.
    """
    about, kind, bounded = scatter_at(path), given.distribution, given.distribution in ("uniform", "triangular")
    assert about is not None
    least, most = about.limits
    ends: Any = (end if end is None else float(end) for end in (given.center, given.min, given.max))
    center, low, high = ends
    if path in FRICTION:
        friction = value_at(spec, path).range
        center = friction.mean if center is None else center
        if bounded and given.spread is None:
            low, high = friction.min if low is None else low, friction.max if high is None else high
    elif value_at(spec, path.rpartition(".")[0]) is None:
        raise CalculationError("tolerance.fields.{path}: the spec has no such table to scatter in", path=path)
    center = value_at(spec, path) if center is None else center
    if center is None and (low is None or high is None):
        raise CalculationError("tolerance.fields.{path}: the spec has no {path} to scatter; give center", path=path)
    center = (low + high) / 2 if center is None else center
    if given.spread is None:
        spread = (high - low) / 2
    else:
        share = percentage(given.spread)
        spread = float(given.spread) if share is None else abs(center) * share
        if bounded:
            low, high = center - spread, center + spread
    row = InputRow(path=path, distribution=kind, center=center, spread=spread, unit=about.unit, min=low, max=high)
    low, high = least if low is None else low, most if high is None else high
    distribution = _distribution(kind, center, spread, low, high) if spread else None
    below, above = distribution.cdf((low, high)) if distribution else (0.0, float(low <= center <= high))
    if (bounded and not least <= low <= high <= most) or not above - below > _LEAST_MASS:
        raise CalculationError(
            "tolerance.fields.{path}: no {kind} distribution about {center:g} lies from {low:g} to {high:g} (what it "
            "may be: {least:g} to {most:g})",
            path=path, kind=kind, center=center, low=low, high=high, least=least, most=most,
        )  # fmt: skip

    def quantile(probability: Array) -> Array:
        if distribution is None:
            return np.full(probability.shape, center)
        inside = np.clip(below + probability * (above - below), 1e-300, 1 - 2**-53)
        return np.clip(distribution.ppf(inside), low, high)

    return row, quantile


def with_setting(clutch: Clutch, given: Tolerance) -> Spec:
    """Return the spec of the samples, with springs of the nominal clutch (as-made) or set anew (each-adjusted).

    Raises SpecError if a key scatters that the clutch does not have, or that cannot have an effect.
    """
    spec, as_made, unlike = clutch.spec, given.setting == "as-made", clutch.spec.friction.unlike
    follows = _CONTROL_FORCE if spec.kind.travels else _CLOSING_FORCE
    for path in given.fields:
        if path in FRICTION and (path == "friction") == unlike:
            use = say("friction.driving and friction.driven") if unlike else "friction"
            message = say("this clutch has {use} instead", use=use)
        elif as_made and path.startswith(_ONLY_SETTING):
            message = say(
                'acts through the setting alone, which "as-made" holds: give tolerance.setting = "each-adjusted"'
            )
        elif not as_made and path == follows:
            message = say('follows from the setting of each clutch: give tolerance.setting = "as-made"')
        else:
            continue
        raise spec.refused(f"tolerance.fields.{path}", message)
    if spec.fatigue is not None and spec.drive.dynamic_factor is None:
        # the dynamic factor of the nominal clutch holds for all samples
        from .simulate import simulate

        spec = with_values(spec, {"drive.dynamic_factor": dynamic_factor(spec.drive, lambda: simulate(clutch)[0])})
    if as_made:
        spec = with_key(spec, _CLOSING_FORCE, float(clutch.closing_force))
    elif not spec.kind.travels:
        spec = with_key(spec, "adjustment.nominal_torque", float(clutch.nominal_torque))
    if spec.kind.travels:
        spec = with_values(spec, {_CONTROL_FORCE: float(clutch.control_force) if as_made else None})
    if "gain_slope" in clutch:
        # the pockets of the nominal clutch hold for all samples
        spec = with_key(spec, "control_unit.gain_slope", float(clutch.gain_slope))
    return spec


@dataclass(frozen=True)
class Model:
    """Spec of a clutch, and the quantile functions of the keys that scatter."""

    spec: Spec
    inputs: Mapping[str, Quantile]
    correlation: float = 0.0
    """Correlation of the normal scores of f_1 and f_2."""

    @property
    def groups(self) -> dict[str, list[int]]:
        """Name → indices of one input, or of both correlated frictions; groups scatter independently of each other."""
        frictions = " + ".join(path for path in self.inputs if path in FRICTION)
        groups: dict[str, list[int]] = {}
        for place, path in enumerate(self.inputs):
            name = frictions if self.correlation and path in FRICTION else path
            groups.setdefault(name, []).append(place)
        return groups

    def sample(self, probabilities: Array) -> Sample:
        """Return a sample from independent probabilities, one row per input; a Gaussian copula links f_1 and f_2."""
        from scipy.special import ndtr, ndtri

        rows = list(probabilities)
        for first, *others in self.groups.values():
            for second in others:
                one, two = ndtri(rows[first]), ndtri(rows[second])
                rows[second] = ndtr(self.correlation * one + (1 - self.correlation**2) ** 0.5 * two)
        return {path: quantile(row) for (path, quantile), row in zip(self.inputs.items(), rows, strict=True)}

    def over(self, sample: Sample, output: Callable[[Clutch, Sample], Values], block: int = BLOCK) -> Array:
        """Return ``output`` for each clutch of a sample, calculated in blocks of clutches."""
        size, parts = next(iter(sample.values())).size, []
        with np.errstate(all="ignore"):
            for start in counted(say("sampling"), range(0, size, block)):
                part = {path: values[start : start + block] for path, values in sample.items()}
                keys = {path: values for path, values in part.items() if path not in FRICTION}
                clutch = build(with_values(self.spec, keys))
                parts.append(np.broadcast_to(output(clutch, part), min(block, size - start)))
        return np.concatenate(parts)


def _at(clutch: Clutch, sample: Sample) -> tuple[Values, Values]:
    """Frictions f_1 and f_2 of a sample, equal for one material; the mean of the spec if friction does not scatter."""
    names = FRICTION[1:] if clutch.spec.friction.unlike else FRICTION[:1] * 2
    first, second = (sample.get(name, own.mean) for name, own in zip(names, clutch.spec.friction.groups, strict=True))
    return first, second


def _torque(clutch: Clutch, sample: Sample) -> Values:
    """Slip torque, N·m; NaN if the feedback does not overcome feather-key friction, or the faces have no width."""
    group, possible = clutch.spec.friction_group, np.array(True)
    if group.inner_radius is not None and group.outer_radius is not None:
        possible = possible & (group.inner_radius < group.outer_radius)
    if clutch.spec.kind.travels:
        possible = possible & (clutch["net_gain"] > 0)
    return np.where(possible, clutch.at_friction(*_at(clutch, sample))["torque"], np.nan)


def lives(model: Model, sample: Sample) -> tuple[Array, Array]:
    """Return each clutch's number of slips to failure of the shaft, on the protected and unprotected side (Miner).

    Friction varies from slip to slip, and each slip does the damage 1/N(T). The mean damage is integrated by the
    trapezoidal rule over the normal scores of friction. Torques on the unprotected side are k_д times as large.
    """
    from scipy.special import ndtr

    frictions = replace(model, inputs={path: own for path, own in model.inputs.items() if path in FRICTION})
    scores = np.linspace(-8, 8, 65 if len(frictions.inputs) < 2 else 33)
    nodes = np.array([*product(scores, repeat=len(frictions.inputs))])
    shares = np.exp(-(nodes**2).sum(axis=1) / 2)[:, None]
    slips = {path: values[:, None] for path, values in frictions.sample(ndtr(nodes.T)).items()}
    sample = {path: values[: SLIPS // len(nodes)] for path, values in sample.items()}

    def damage(clutch: Clutch, _: Sample) -> Values:
        stress = clutch.at_friction(*_at(clutch, slips))["shear_stress"]
        return (shares * clutch.at(damaging_stress=stress)["damage"]).sum(axis=0) / shares.sum()

    protected = law.cycles_of_mean_damage(model.over(sample, damage, max(BLOCK // len(nodes), 1)))
    keys = ("drive.dynamic_factor", "fatigue.exponent")
    factor, exponent = (sample.get(path, value_at(model.spec, path)) for path in keys)
    return protected, protected / factor**exponent


def peaks(model: Model, clutch: Clutch, sample: Sample, torque: Array) -> Array:
    """Return the peak torque in the shaft of each sample, N·m, from events of the nominal clutch over its friction.

    The peak is interpolated over friction, then extrapolated to the torque of the sample by the slope of peak over
    torque. The load is the load of the spec, else the rated torque at the nominal clutch.
    """
    load = clutch.spec.drive.load_torque
    given = {path: float(np.median(values)) for path, values in sample.items() if path not in FRICTION}
    given["drive.load_torque"] = float(clutch.running_torque) if load is None else load
    nominal, share, sampled = build(with_values(model.spec, given)), np.linspace(0, 1, EVENTS), _at(clutch, sample)
    spans = zip(clutch.spec.friction.groups, sampled, strict=True)
    ends = [(min(own.min, np.min(values)), max(own.max, np.max(values))) for own, values in spans]
    path = [low + share * (high - low) for low, high in ends]
    peak, own = case_of(nominal, *path).peaks().peak, nominal.at_friction(*path)["torque"]
    places = [(values - low) / ((high - low) or 1.0) for values, (low, high) in zip(sampled, ends, strict=True)]
    with np.errstate(all="ignore"):
        # slope between 0 (the clutch sticks and the peak does not grow) and proportional (the clutch slips)
        slope = np.fmin(np.fmax(np.gradient(peak) / np.gradient(own), 0.0), peak / own)
    at_sample = partial(np.interp, (places[0] + places[1]) / 2, share)
    return at_sample(peak) + at_sample(slope) * (torque - at_sample(own))


def sobol_rows(model: Model, base: int, random: np.random.Generator) -> list[IndexRow]:
    """Return first-order and total Sobol indices of the torque; ``base`` samples are rounded up to a power of two."""
    from scipy.stats import sobol_indices

    size = BATCHES << max(math.ceil(math.log2(base / BATCHES)), 1)
    one, other = random.random((2, len(model.inputs), size))
    places = np.arange(len(model.inputs))[:, None]
    mixed = [np.where(np.isin(places, group), other, one) for group in model.groups.values()]
    torques = np.array([model.over(model.sample(drawn), _torque) for drawn in (one, other, *mixed)])
    kept = np.isfinite(torques).all(axis=0)
    # rows with an impossible clutch are set to the mean, so that they add to no variance
    torques = np.where(kept, torques, torques[:2, kept].mean() if kept.any() else 0.0)

    def indices(batches: int) -> Array:
        first, second, *others = torques.reshape(-1, batches, size // batches)
        # a dummy input is added and dropped below: for a single input SciPy gives no list
        found = sobol_indices(func={"f_A": first, "f_B": second, "f_AB": np.array([*others, first])}, n=size // batches)
        orders = [order.reshape(batches, -1) for order in (found.first_order, found.total_order)]
        return np.round(np.nan_to_num(orders)[:, :, :-1], 12)  # rounding errors of 1e-18 become 0

    with np.errstate(all="ignore"):
        values, errors = indices(1)[:, 0], np.std(indices(BATCHES), axis=1, ddof=1) / BATCHES**0.5
    names = "first_order", "total", "first_order_standard_error", "total_standard_error"
    columns = np.concatenate([values, errors]).T.tolist()
    rows = zip(model.groups, columns, strict=True)
    return [IndexRow(path=path, **dict(zip(names, column, strict=True))) for path, column in rows]


def estimate(name: str, figure: Callable[..., Any], values: Array, least: float = 0.0) -> dict[str, Any]:
    """Return a statistic of a sample and its standard error (from the spread over batches), as fields of the result.

    Raises OverflowError if the statistic or its error is not finite.
    """
    batches = values[: values.size - values.size % BATCHES].reshape(BATCHES, -1)
    spread = np.std(figure(batches, axis=-1), ddof=1)
    value, error = float(figure(values)), max(float(spread) / BATCHES**0.5, least)
    if not math.isfinite(value + error):
        raise OverflowError
    return {name: value, f"{name}_standard_error": error}


def _share(name: str, counts: NDArray[np.bool_]) -> dict[str, Any]:
    """Estimate a probability; its standard error is at least 1/n, even if all samples count, or no sample does."""
    return estimate(name, np.mean, counts.astype(float), least=1 / counts.size)


def histogram(torques: Array) -> list[Bar]:
    """Return 2·∛n bars of equal width, at most 60; an empty list if the torque does not scatter."""
    low, high = np.quantile(torques, CENTRAL)
    if high - low <= 1e-9 * abs(high):
        return []
    counts, edges = np.histogram(torques, min(_BARS, round(2 * torques.size ** (1 / 3))), (low, high))
    densities = counts / (torques.size * np.diff(edges))
    bars = zip(edges.tolist(), edges[1:].tolist(), densities.tolist(), strict=False)
    return [Bar(low=start, high=end, density=density) for start, end, density in bars]


def tolerance(clutch: Clutch) -> tuple[ToleranceResult, list[Finding]]:
    """Calculate the distribution of torque, life and peaks by the [tolerance] block of the spec.

    Raises SpecError if there is no [tolerance] block, or if the clutch lacks one of the keys that are to scatter;
    CalculationError if hardly any sample is a possible clutch.
    """
    given, machine = _block(clutch.spec), float(clutch.machine_torque)
    random = np.random.default_rng(given.seed)
    inputs, model, sample, torque = _sampled(clutch, given, random)
    spec = model.spec
    possible = ~np.isnan(torque)
    if possible.sum() < 2 * BATCHES:
        raise CalculationError(
            "tolerance: hardly a sample is a clutch (feedback must overcome the key's friction, faces have a width)"
        )
    fields = {} if possible.all() else _share("probability_no_clutch", ~possible)
    torque, sample = torque[possible], {path: values[possible] for path, values in sample.items()}
    quantities, deviation = {"torque": torque}, partial(np.std, ddof=1)
    fields |= estimate("mean", np.mean, torque) | estimate("standard_deviation", deviation, torque)
    fields |= estimate(
        "accuracy_factor_robust", lambda own, axis=None: np.divide(*np.quantile(own, ROBUST, axis)), torque
    )
    fields |= _share("probability_below_machine", torque < machine)
    if given.torque_limit is not None:
        fields |= _share("probability_above_limit", torque > given.torque_limit)
    if spec.fatigue is not None:
        for name, cycles in zip(("life_protected", "life_unprotected"), lives(model, sample), strict=True):
            quantities[name] = cycles
            fields |= estimate(name, lambda own, axis=None: 1 / np.mean(1 / own, axis), cycles)
    if ANALYSES["simulate"].applies(clutch):
        quantities["peak_torque"] = peak = peaks(model, clutch, sample, torque)
        fields |= estimate("peak_torque_mean", np.mean, peak) | estimate("peak_torque_deviation", deviation, peak)
        if spec.requirements is not None and spec.requirements.peak_torque is not None:
            fields |= _share("probability_peak_above", peak > spec.requirements.peak_torque)
    quantiles = []
    for p in given.quantiles:
        rows = (estimate(name, partial(np.quantile, q=p), values) for name, values in quantities.items())
        quantiles.append(QuantileRow(probability=p, **dict(ChainMap(*rows))))
    result = ToleranceResult(
        setting=given.setting, samples=given.samples, torque_limit=given.torque_limit, machine_torque=machine,
        inputs=inputs, sobol=sobol_rows(model, given.sobol_base, random),
        quantiles=quantiles, histogram=histogram(torque), **fields,
    )  # fmt: skip
    return result, [*clutch_findings(clutch), *_findings(given, result, torque)]


def exceedance(clutch: Clutch) -> float:
    """Return the probability of a torque above the limit, as in ``tolerance``, without life, peaks and indices."""
    given = _block(clutch.spec)
    *_, torque = _sampled(clutch, given, np.random.default_rng(given.seed))
    return float(np.mean(torque[~np.isnan(torque)] > cast(float, given.torque_limit)))


def _sampled(
    clutch: Clutch, given: Tolerance, random: np.random.Generator
) -> tuple[list[InputRow], Model, Sample, Array]:
    """Return rows of the inputs that scatter, model of the clutches, sample of the inputs, and its torques, N·m."""
    spec = with_setting(clutch, given)
    inputs = {path: input_of(spec, path, field) for path, field in given.fields.items()}
    quantiles = {path: quantile for path, (_, quantile) in inputs.items()}
    model = Model(spec, quantiles, given.friction_correlation or 0.0)
    sample = model.sample(random.random((len(inputs), given.samples)))
    return [row for row, _ in inputs.values()], model, sample, model.over(sample, _torque)


def _block(spec: Spec) -> Tolerance:
    """The [tolerance] block, its default torque limit requirements.torque_max; SpecError if there is no such block."""
    given = spec.tolerance
    if given is None:
        fields = [] if spec.friction.unlike else ["tolerance.fields.friction"]
        fields += ["tolerance.fields.closing_spring.force"]
        raise lacking(spec, "tolerance", say("[tolerance.fields]: what scatters, and how"), "tolerance", fields)
    if given.torque_limit is None and spec.requirements is not None:
        return given.model_copy(update={"torque_limit": spec.requirements.torque_max})
    return given


def _findings(given: Tolerance, result: ToleranceResult, torque: Array) -> Iterator[Finding]:
    """Yield findings on the keys of the [tolerance] block, then on the statistics."""
    paths = given.fields.keys()
    if not paths <= set(FRICTION):
        yield finding(given.setting, "info", path="tolerance.setting")
    if not paths & set(FRICTION):
        yield finding("friction-fixed", "info", path="tolerance.fields")
    if {"friction.driving", "friction.driven"} <= paths and given.friction_correlation is None:
        yield finding("friction-independent", "info", path="tolerance.friction_correlation")
    if result.life_protected is not None:
        yield finding("miner", "info", path="fatigue")
    if result.peak_torque_mean is not None:
        yield finding("peaks-interpolated", "info", value=EVENTS, path="drive.event")
    if result.probability_no_clutch:
        yield finding("no-clutch", "warning", value=result.probability_no_clutch, limit=0.0, path="tolerance.fields")
    deviation, error = result.standard_deviation, result.standard_deviation_standard_error
    if error > _UNSURE * deviation and np.mean((torque - result.mean) ** 4) > _HEAVY * deviation**4:
        yield finding("heavy-tails", "warning", value=error / deviation, limit=_UNSURE, path="tolerance.samples")
    least = math.ceil(BATCHES / min(min(p, 1 - p) for p in given.quantiles))
    if result.samples < least:
        yield finding("few-samples", "warning", value=result.samples, limit=least, path="tolerance.samples")
