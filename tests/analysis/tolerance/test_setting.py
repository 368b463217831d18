"""Who is set, what is no clutch, whose life: against single clutches, built and asked one by one, and closed forms."""

import copy
import math

import numpy as np
import pytest
from conftest import CONFIGS
from scipy.special import ndtr

import afmcalc as api
from afmcalc.analysis.tolerance.study import tolerance
from afmcalc.engines import build
from afmcalc.errors import CalculationError, SpecError
from afmcalc.spec import make_spec, read_spec, resolved
from afmcalc.spec.edit import put, value_at

S21 = {
    "variant": "indirect",
    "friction": {"min": 0.1, "mean": 0.3, "max": 0.8},
    "friction_group": {"pairs": 8, "mean_radius": 0.1},
    "closing_spring": {"force": 2000, "stiffness": 20e3},
    "control_spring": {"stiffness": 10e3},
    "control_unit": {"gain": 1.0, "hub_diameter": 0.05, "key_friction": 0.15},
}
"""S21 fig. 2 with a closing spring of 2 kN, the clutch of tests/data/s21-fig2.toml."""
FATIGUE = {"endurance_limit": 400e6, "polar_section_modulus": 15e-6, "exponent": 6, "base_cycles": 1e7}
SETTINGS = ["as-made", "each-adjusted"]


def scattering(base, fields, **options):
    return make_spec({**copy.deepcopy(base), "tolerance": {"fields": fields, "sobol_base": 64, **options}})


CASES = {
    "indirect": (
        S21,
        {"control_unit.gain": ("normal", 0.05), "control_unit.key_friction": ("uniform", 0.05),
         "closing_spring.force": ("normal", 100.0), "closing_spring.stiffness": ("normal", 1e3),
         "friction_group.mean_radius": ("uniform", 1e-3), "friction": ("uniform", 0.25)},
    ),
    "indirect, set by its torque": (
        {**S21, "closing_spring": {"stiffness": 20e3}, "adjustment": {"nominal_torque": 160, "method": "mean-friction"}},
        {"control_unit.gain": ("uniform", 0.1), "friction_group.mean_radius": ("normal", 1e-3), "friction": ("normal", 0.05)},
    ),
    "differentiated, set by its torque": (
        {"variant": "differentiated", "friction": {"min": 0.1, "mean": 0.3, "max": 0.8},
         "friction_group": {"pairs": 8, "inner_radius": 0.08, "outer_radius": 0.12},
         "control_unit": {"wall_angle": 0.25, "ball_circle_radius": 0.05}, "adjustment": {"nominal_torque": 120}},
        {"control_unit.wall_angle": ("normal", 0.02), "friction_group.outer_radius": ("uniform", 2e-3),
         "friction": ("uniform", 0.05)},
    ),
}  # fmt: skip


def single_torques(base, fields, setting, count, seed):
    """Slip torques of clutches built one by one, and how many of them are none."""
    rng, nominal = np.random.default_rng(seed), api.build(base)
    torques, failed = [], 0
    for _ in range(count):
        data, friction = copy.deepcopy(base), 0.3
        if setting == "as-made":
            put(data, "closing_spring.force", float(nominal["closing_force"]))
            data["adjustment"] = {**data.get("adjustment", {})}
            put(data, "adjustment.nominal_torque", None)
            if base["variant"] == "indirect":
                put(data, "control_spring.force", float(nominal["control_force"]))
        for path, (kind, spread) in fields.items():
            drawn = rng.normal(0, spread) if kind == "normal" else rng.uniform(-spread, spread)
            if path == "friction":
                friction += drawn
            else:
                put(data, path, value_at(nominal.spec, path) + drawn)
        try:
            torques.append(float(api.build(data).torque(friction)))
        except SpecError:
            failed += 1
    return np.array(torques), failed


@pytest.mark.parametrize(("name", "setting"), [*zip(CASES, ["as-made", "each-adjusted", "each-adjusted"], strict=True)])
def test_against_single_clutches(name, setting):
    (base, fields), count = CASES[name], 500
    torques, failed = single_torques(base, fields, setting, count, seed=11)
    given = {path: {"distribution": kind, "spread": spread} for path, (kind, spread) in fields.items()}
    found, _ = tolerance(build(scattering(base, given, samples=100_000, seed=5, setting=setting)))
    assert (found.probability_no_clutch or 0.0) == pytest.approx(failed / count, abs=4 / math.sqrt(count))
    deviation = torques.std(ddof=1)
    kurtosis = ((torques - torques.mean()) ** 4).mean() / deviation**4
    assert found.mean == pytest.approx(torques.mean(), abs=4.5 * deviation / math.sqrt(torques.size))
    slack = 4.5 * deviation * math.sqrt((kurtosis - 1) / 4 / torques.size)
    assert found.standard_deviation == pytest.approx(deviation, abs=slack)
    for row in found.quantiles[1:-1]:
        reach = 4.5 * math.sqrt(row.probability * (1 - row.probability) / torques.size)
        assert np.mean(torques < row.torque) == pytest.approx(row.probability, abs=reach)


@pytest.mark.parametrize(("method", "setting"), [("monte-carlo", "as-made"), ("quasi-monte-carlo", "each-adjusted")])
@pytest.mark.slow
def test_what_is_no_clutch_is_counted(method, setting):
    """C uniform on 0.45…1.55 against 2 R f_1/d = 0.6: P(κ ≤ 0) = 0.15/1.1, and torques as of C in 0.6…1.55."""
    options = {"samples": 8_000, "method": method, "setting": setting}
    whole = {"control_unit.gain": {"distribution": "uniform", "spread": 0.55}}
    some = {"control_unit.gain": {"distribution": "uniform", "min": 0.6, "max": 1.55}}
    base = S21 | ({"fatigue": FATIGUE} if setting == "as-made" else {})
    found, findings = tolerance(build(scattering(base, whole, **options)))
    error = found.probability_no_clutch_standard_error
    assert found.probability_no_clutch == pytest.approx(0.15 / 1.1, abs=4.5 * error)
    assert error < 6e-3
    assert [each.value for each in findings if each.code == "no-clutch"] == [found.probability_no_clutch]
    rest, _ = tolerance(build(scattering(base, some, **options)))
    assert found.samples == rest.samples
    for field in ("mean", "standard_deviation", *(["life_protected"] if setting == "as-made" else [])):
        slack = 4.5 * math.hypot(found.estimate(field).standard_error, rest.estimate(field).standard_error)
        assert getattr(found, field) == pytest.approx(getattr(rest, field), abs=slack), field


def test_no_clutch_at_all_is_an_error():
    fields = {"control_unit.gain": {"distribution": "uniform", "min": 0.1, "max": 0.5}}
    with pytest.raises(CalculationError, match="hardly a sample is a clutch"):
        tolerance(build(scattering(S21, fields, samples=1000)))


def test_lives_over_the_clutches_in_closed_form():
    """T ∝ F, so ln N is normal where F is lognormal; friction only adds a factor common to all."""
    base = {**resolved(read_spec(CONFIGS / "conventional.toml")), "fatigue": FATIGUE, "drive": {"dynamic_factor": 1.4}}
    share = 0.1
    fields = {"closing_spring.force": {"distribution": "lognormal", "spread": f"{100 * share} %"},
              "friction": {"distribution": "uniform", "min": 0.2, "max": 0.4}}  # fmt: skip
    found, _ = tolerance(build(scattering(base, fields, samples=200_000)))
    m, variance = 6, math.log1p(share**2)
    # mean of f^6 over 0.2…0.4 against the torque at f = 1
    mean_power = (0.4**7 - 0.2**7) / (7 * 0.2)
    torque = float(build(make_spec(base)).torque(1.0)) * math.exp(-variance / 2)
    median = 1e7 * (400e6 * 15e-6 / torque) ** m / mean_power
    for row, score in zip(found.life_quantiles, (-2.3263478740408408, -1.2815515655446004, 0.0), strict=True):
        expected = median * math.exp(m * score * math.sqrt(variance))
        assert row.protected == pytest.approx(expected, abs=4 * row.protected_standard_error)
        assert row.protected_standard_error < 0.03 * expected
        assert row.protected / row.unprotected == pytest.approx(1.4**6, rel=1e-9)
    harmonic = median * math.exp(-(m**2) * variance / 2)
    assert found.life_protected == pytest.approx(harmonic, abs=4.5 * found.life_protected_standard_error)


def test_one_clutch_has_one_life():
    """Only friction scatters: every quantile is the life of the one clutch; correlated frictions too."""
    base = {**resolved(read_spec(CONFIGS / "unlike-materials.toml")), "fatigue": FATIGUE}
    base["control_unit"] = {"gain": 0.05}  # else the balls even out what friction does
    fields = {f"friction.{group}": {"distribution": "uniform", "spread": "20 %"} for group in ("driving", "driven")}
    for correlation in (1, 0.6):
        options = {"samples": 20_000, "friction_correlation": correlation}
        found, _ = tolerance(build(scattering(base, fields, **options)))
        lives = {row.protected for row in found.life_quantiles}
        assert max(lives) == pytest.approx(min(lives), rel=1e-9)
        assert found.life_protected == pytest.approx(max(lives), rel=1e-9)
        # the same by brute force over the two frictions' scores
        rng = np.random.default_rng(2)
        z = rng.standard_normal((2, 100_000))
        scores = z[0], correlation * z[0] + math.sqrt(1 - correlation**2) * z[1]
        clutch = build(make_spec(base))
        share = map(ndtr, scores)
        f = [r.mean * (0.8 + 0.4 * u) for r, u in zip(clutch.friction, share, strict=True)]
        damage = (clutch.torque(*f) / (400e6 * 15e-6)) ** 6 / 1e7
        error = damage.std() / math.sqrt(damage.size) / damage.mean()
        assert found.life_protected * damage.mean() == pytest.approx(1, abs=4.5 * error)
