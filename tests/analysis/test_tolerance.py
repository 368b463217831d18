"""Distributions and figures against closed forms, clutches built one by one and single events; standard errors."""

import contextlib
import copy
import itertools
import math
from functools import partial
from statistics import NormalDist

import numpy as np
import pytest
from conftest import CONFIGS, slow
from drives import light
from random_clutches import random_clutches
from scipy import special, stats
from strategies import p5

from afmcalc.analysis.tolerance_study import estimate, input_of, tolerance
from afmcalc.drive.cases import outcome_of
from afmcalc.engines import build
from afmcalc.errors import CalculationError, SpecError
from afmcalc.spec import make_spec, read_spec, resolved
from afmcalc.spec.edit import value_at
from afmcalc.spec.read import put
from afmcalc.spec.scatter import FRICTION

BASE = {"variant": "conventional", "friction": {"min": 0.1, "mean": 0.2, "max": 0.4},
        "friction_group": {"pairs": 4, "mean_radius": 0.1}, "closing_spring": {"force": 1000}}  # fmt: skip
FATIGUE = {"endurance_limit": 400e6, "polar_section_modulus": 15e-6, "exponent": 6, "base_cycles": 1e7}
FORCE, RADIUS = "closing_spring.force", "friction_group.mean_radius"


def study(data, fields, **options):
    """Result and findings of a spec with a block of tolerances; a small sample for the Sobol indices."""
    data = data if isinstance(data, dict) else resolved(data)
    block = {"fields": fields, "sobol_base": 64, "samples": 20_000, **options}
    return tolerance(build(make_spec({**data, "tolerance": block})))


def agrees(result, name, expected):
    """Assert that a figure is the expected one within 3 of its standard errors."""
    value, error = (getattr(result, part) for part in (name, f"{name}_standard_error"))
    assert value == pytest.approx(expected, abs=3 * error, rel=1e-12), name


MOMENTS = [
    ({"distribution": "lognormal", "spread": 300}, 1000, 300),
    ({"distribution": "uniform", "min": 900, "max": 1300}, 1100, 400 / math.sqrt(12)),
    # peak 1000 in 900…1300: (a + b + c)/3 and (a² + b² + c² − ab − ac − bc)/18
    ({"distribution": "triangular", "min": 900, "max": 1300}, 3200 / 3, math.sqrt(130000 / 18)),
    ({"distribution": "normal", "spread": 0}, 1000, 0),
    # half a normal distribution: σ √(2/π) above its centre, σ √(1 − 2/π) about its mean
    ({"distribution": "normal", "spread": 100, "min": 1000}, 1000 + 100 * math.sqrt(2 / math.pi), 100 * math.sqrt(1 - 2 / math.pi)),
]  # fmt: skip


@pytest.mark.parametrize(("given", "mean", "sigma"), MOMENTS)
def test_textbook_moments(given, mean, sigma):
    spec = make_spec({**BASE, "tolerance": {"fields": {FORCE: given}}})
    values = input_of(spec, FORCE, spec.tolerance.fields[FORCE])[1]((np.arange(100_000) + 0.5) / 100_000)
    assert (values.mean(), values.std()) == (pytest.approx(mean, rel=1e-5), pytest.approx(sigma, rel=2e-4))


@pytest.mark.parametrize("percent", [50, 300, *slow(1)])
def test_a_lognormal_torque(percent):
    """T = z R f F is lognormal as its force."""
    base, share = read_spec(CONFIGS / "conventional.toml"), percent / 100
    fields = {FORCE: {"distribution": "lognormal", "spread": f"{percent} %"}}
    nominal, variance = float(build(base).at(friction=base.friction.range.mean)["torque"]), math.log1p(share**2)
    limit = nominal * math.exp(math.sqrt(variance) - variance / 2)
    tails = [0.005, 0.05, 0.5, 0.95, 0.995]
    result, findings = study(base, fields, samples=100_000, quantiles=tails, torque_limit=limit)
    for row in result.quantiles:
        score = NormalDist().inv_cdf(row.probability)
        agrees(row, "torque", nominal * math.exp(score * math.sqrt(variance) - variance / 2))
        assert 0 < row.torque_standard_error < 0.05 * row.torque
    agrees(result, "mean", nominal)
    agrees(result, "probability_above_limit", NormalDist().cdf(-1))
    assert ("heavy-tails" in {each.code for each in findings}) == (percent == 300)
    if percent < 300:
        agrees(result, "standard_deviation", nominal * share)
        agrees(result, "accuracy_factor_robust", math.exp(2 * NormalDist().inv_cdf(0.995) * math.sqrt(variance)))


def test_lives_of_a_lognormal_torque():
    """Friction, uniform over 0.2…0.4 from slip to slip, is one factor common to all clutches."""
    base, variance = read_spec(CONFIGS / "conventional.toml"), math.log1p(0.1**2)
    data = {**resolved(base), "fatigue": FATIGUE, "drive": {"dynamic_factor": 1.4}}
    fields = {"friction": {"distribution": "uniform", "min": 0.2, "max": 0.4}}
    fields[FORCE] = {"distribution": "lognormal", "spread": "10 %"}
    result, _ = study(data, fields, quantiles=[0.01, 0.5])
    per_friction = float(build(base).at(friction=1.0)["torque"]) * math.exp(-variance / 2)
    median = 1e7 * (400e6 * 15e-6 / per_friction) ** 6 / ((0.4**7 - 0.2**7) / (7 * 0.2))
    for row in result.quantiles:
        expected = median * math.exp(6 * NormalDist().inv_cdf(row.probability) * math.sqrt(variance))
        agrees(row, "life_protected", expected)
        assert row.life_protected / row.life_unprotected == pytest.approx(1.4**6, rel=1e-9)
    agrees(result, "life_protected", median * math.exp(-18 * variance))


def test_error_bars_are_the_errors():
    """Over many samples, the root mean square of the errors is that of the distances from the true figure."""
    runs, rng, size = 100, np.random.default_rng(7), 1600
    normal, truth = NormalDist(), {np.mean: math.exp(0.045), np.std: math.sqrt(math.expm1(0.09)) * math.exp(0.045)}
    truth |= {partial(np.quantile, q=0.05): math.exp(0.3 * normal.inv_cdf(0.05))}
    samples = rng.lognormal(0, 0.3, (runs, size))
    for figure, true in truth.items():
        found = [estimate("x", figure, sample) for sample in samples]
        told = np.mean(np.square([one["x_standard_error"] for one in found]))
        own = np.mean(np.square([one["x"] - true for one in found]))
        assert math.sqrt(told / own) == pytest.approx(1, abs=3 / math.sqrt(2 * runs))


def test_sobol_indices_of_a_product():
    """T = F R z f: the shares are v_i over Π(1 + v) − 1, v = (σ/m)², the totals times Π(1 + v) of the others."""
    shares = {"friction": 0.15, FORCE: 0.1, RADIUS: 0.05}
    fields = {path: {"distribution": "lognormal", "spread": f"{100 * share} %"} for path, share in shares.items()}
    rows = study(BASE, fields, sobol_base=1 << 16)[0].sobol
    whole = math.prod(1 + share**2 for share in shares.values()) - 1
    for row, share in zip(rows, shares.values(), strict=True):
        others = math.prod(1 + other**2 for other in shares.values() if other != share)
        agrees(row, "first_order", share**2 / whole)
        agrees(row, "total", share**2 * others / whole)
        assert 0 < row.first_order_standard_error < 0.03
    (alone,) = study(BASE, {FORCE: fields[FORCE]}, sobol_base=1 << 12)[0].sobol
    agrees(alone, "total", 1)


@pytest.mark.parametrize("correlation", [-0.6, 0, *slow(1)])
def test_the_two_frictions_of_unlike_materials(correlation):
    """σ_T² = a² + b² + 2ρab for small spreads; correlated, they share one Sobol index."""
    base = read_spec(CONFIGS / "unlike-materials.toml")
    fields = {f"friction.{g}": {"distribution": "normal", "spread": "1 %"} for g in ("driving", "driven")}
    result, _ = study(base, fields, friction_correlation=correlation)
    first, second = (own.mean for own in base.friction.groups)
    clutch = build(base)

    def torque(*friction):
        return clutch.at_friction(*friction)["torque"]

    a = (torque(first * 1.01, second) - torque(first * 0.99, second)) / 2
    b = (torque(first, second * 1.01) - torque(first, second * 0.99)) / 2
    assert result.standard_deviation == pytest.approx(math.sqrt(a**2 + b**2 + 2 * correlation * a * b), rel=1e-2)
    assert [row.path for row in result.sobol] == ([" + ".join(fields)] if correlation else [*fields])


def spreads_of(spec):
    """Standard deviations of what scatters in a random clutch, by path."""
    paths = (RADIUS, FORCE, "control_unit.gain", "control_unit.key_friction")
    frictions = zip(FRICTION[1:] if spec.friction.unlike else FRICTION[:1], spec.friction.groups, strict=False)
    spreads = {path: 0.03 * value for path in paths if (value := value_at(spec, path))}
    return spreads | {path: 0.1 * own.mean for path, own in frictions}


def own_torques(spec, spreads, setting, count, rng):
    """Slip torques of clutches built one by one; NaN where there is none."""
    nominal, torques, base = build(spec), np.full(count, math.nan), resolved(spec)
    as_made = setting == "as-made"
    made = {FORCE: float(nominal.closing_force), "adjustment.nominal_torque": None} if as_made else {}
    if not (as_made or spec.kind.travels):  # the force follows from the torque that each is set to
        made = {FORCE: None, "adjustment.nominal_torque": float(nominal.nominal_torque)}
    if spec.kind.travels:
        made |= {"control_spring.force": float(nominal.control_force) if as_made else None}
    if "gain_slope" in nominal:  # pockets are cut once
        made |= {"control_unit.gain_slope": float(nominal.gain_slope), "control_unit.pocket": None}
    for path, value in made.items():
        put(base, path, value)
    for number in range(count):
        data, frictions = copy.deepcopy(base), [own.mean for own in spec.friction.groups]
        for path, spread in spreads.items():
            drawn = rng.normal(0, spread)
            if path not in FRICTION:
                put(data, path, value_at(spec, path) + drawn)
            for group in {"friction": (0, 1), "friction.driving": (0,), "friction.driven": (1,)}.get(path, ()):
                frictions[group] += drawn
        with contextlib.suppress(SpecError):
            torques[number] = float(build(data).at_friction(*frictions)["torque"])
    return torques


def buildable():
    for data in random_clutches(60, seed=5):
        with contextlib.suppress(SpecError):
            yield build(make_spec(data)).spec


@pytest.mark.parametrize("number", [0, 1, *slow(*range(2, 8))])
def test_against_clutches_built_one_by_one(number):
    spec = next(itertools.islice(buildable(), number, None))
    setting, count = ("as-made", "each-adjusted")[number % 2], 60 if number < 2 else 400
    spreads = spreads_of(spec)
    if setting == "each-adjusted" and not spec.kind.travels:
        spreads.pop(FORCE, None)
    own = own_torques(spec, spreads, setting, count, np.random.default_rng(number))
    given = {path: {"distribution": "normal", "spread": spread} for path, spread in spreads.items()}
    result, _ = study(resolved(spec), given, setting=setting, quantiles=[0.1, 0.5, 0.9])
    lost = result.probability_no_clutch or 0.0
    assert lost == pytest.approx(np.isnan(own).mean(), abs=3 * math.sqrt(max(lost * (1 - lost), 1 / count) / count))
    own = own[~np.isnan(own)]
    deviation, size = own.std(ddof=1), math.sqrt(own.size)
    assert result.mean == pytest.approx(own.mean(), abs=3 * math.hypot(deviation / size, result.mean_standard_error))
    spread = deviation * math.sqrt((stats.kurtosis(own, fisher=False) - 1) / 4) / size
    assert result.standard_deviation == pytest.approx(deviation, abs=3 * spread + 1e-9 * result.mean)
    for row in result.quantiles:
        low, high = (np.mean(own < row.torque * (1 + rounding)) for rounding in (-1e-9, 1e-9))
        slack = 3 * math.sqrt(row.probability * (1 - row.probability)) / size
        assert low - slack <= row.probability <= high + slack


def test_what_is_no_clutch_is_counted():
    """C is uniform on 0.45…1.55, 2 R f_1/d = 0.6: P(κ ≤ 0) = 0.15/1.1; torques are those of C in 0.6…1.55."""
    whole, findings = study(p5(), {"control_unit.gain": {"distribution": "uniform", "spread": 0.55}}, samples=20_000)
    rest, _ = study(p5(), {"control_unit.gain": {"distribution": "uniform", "min": 0.6, "max": 1.55}}, samples=20_000)
    agrees(whole, "probability_no_clutch", 0.15 / 1.1)
    assert rest.probability_no_clutch is None
    assert [each.value for each in findings if each.code == "no-clutch"] == [whole.probability_no_clutch]
    for name in ("mean", "standard_deviation"):
        slack = math.hypot(*(getattr(each, f"{name}_standard_error") for each in (whole, rest)))
        assert getattr(whole, name) == pytest.approx(getattr(rest, name), abs=3 * slack)
    with pytest.raises(CalculationError, match="hardly a sample is a clutch"):
        study(p5(), {"control_unit.gain": {"distribution": "uniform", "min": 0.1, "max": 0.5}}, samples=1000)


@pytest.mark.parametrize("correlation", [1, 0.6])
def test_one_clutch_has_one_life(correlation):
    """If only friction scatters, every quantile is the life of the one clutch, by brute force over the frictions."""
    base = resolved(read_spec(CONFIGS / "unlike-materials.toml"))
    base |= {"fatigue": FATIGUE, "control_unit": {"gain": 0.05}}
    fields = {f"friction.{group}": {"distribution": "uniform", "spread": "20 %"} for group in ("driving", "driven")}
    result, _ = study(base, fields, samples=2000, friction_correlation=correlation)
    lives = [result.life_protected, *(row.life_protected for row in result.quantiles)]
    assert max(lives) == pytest.approx(min(lives), rel=1e-9)
    z, clutch = np.random.default_rng(2).standard_normal((2, 100_000)), build(make_spec(base))
    scores = z[0], correlation * z[0] + math.sqrt(1 - correlation**2) * z[1]
    pairs = zip(clutch.spec.friction.groups, scores, strict=True)
    frictions = [own.mean * (0.8 + 0.4 * special.ndtr(score)) for own, score in pairs]
    damage = (clutch.at_friction(*frictions)["torque"] / (400e6 * 15e-6)) ** 6 / 1e7
    error = damage.std() / math.sqrt(damage.size) / damage.mean()
    assert result.life_protected * damage.mean() == pytest.approx(1, abs=3 * error)


def test_peaks_are_interpolated_between_single_events():
    """Quantiles of the peak are peaks of events at quantiles of friction; for a force, of events of other clutches."""
    block = {"fields": {"friction": {"distribution": "uniform"}}, "quantiles": [0.25, 0.75]}
    block |= {"sobol_base": 64, "samples": 20_000}
    own = light(tolerance=block, requirements={"peak_torque": outcome_of(light(), 0.45).event.peak})
    result, findings = tolerance(own)
    assert "peaks-interpolated" in {each.code for each in findings}
    for row in result.quantiles:
        single = outcome_of(own, 0.1 + 0.7 * row.probability).event.peak
        assert row.peak_torque == pytest.approx(single, abs=3 * row.peak_torque_standard_error + 1e-3 * single)
    assert result.probability_peak_above == pytest.approx(0.5, abs=0.01)
    force, load = float(own.closing_force), {"load_torque": float(own.running_torque)}
    forced, _ = tolerance(light(tolerance=block | {"fields": {FORCE: {"distribution": "uniform", "spread": "5 %"}}}))
    low, high = (light(closing_spring={"force": force * share}, drive=load) for share in (0.95, 1.05))
    width = outcome_of(high, 0.3).event.peak - outcome_of(low, 0.3).event.peak
    assert forced.peak_torque_deviation == pytest.approx(width / math.sqrt(12), rel=0.1)


def test_the_same_seed_gives_the_same_digits():
    fields = {"friction": {"distribution": "uniform"}, FORCE: {"distribution": "normal", "spread": "5 %"}}
    first, again, other = (study(BASE, fields, samples=6000, seed=seed) for seed in (1, 1, 2))
    assert first == again
    assert first[0].mean != other[0].mean
    said = [[each.code for each in study(BASE, fields, samples=size, quantiles=[0.005])[1]] for size in (6000, 6400)]
    assert ["few-samples" in codes for codes in said] == [True, False]


def test_springs_set_on_the_bench_are_those_of_the_nominal_torque():
    """Whether the spec gives the force or the torque, each sample is set to the torque of the nominal clutch."""
    fields = {"friction_group.mean_radius": {"distribution": "uniform", "spread": 0.006}}
    study = {"tolerance": {"setting": "each-adjusted", "samples": 1000, "sobol_base": 64, "fields": fields}}
    by_force = build(read_spec("example:default", study))
    torque = {"closing_spring.force": None, "adjustment.nominal_torque": float(by_force.nominal_torque)}
    by_torque = build(read_spec("example:default", study | torque))
    means = [tolerance(clutch)[0].mean for clutch in (by_force, by_torque)]
    assert means[0] == pytest.approx(means[1], rel=1e-12)
    assert tolerance(by_force)[0].standard_deviation < 1e-9
