"""Life over the clutches: friction from slip to slip, the rest from clutch to clutch; against single clutches."""

import math

import numpy as np
import pytest
from conftest import CONFIGS
from scipy.special import ndtr

from afmcalc.analysis.tolerance.study import tolerance
from afmcalc.engines import build
from afmcalc.spec import make_spec, read_spec, resolved

FATIGUE = {"endurance_limit": 400e6, "polar_section_modulus": 15e-6, "exponent": 6, "base_cycles": 1e7}


def scattering(base, fields, **options):
    return make_spec({**base, "tolerance": {"fields": fields, "sobol_base": 64, **options}})


def test_lives_over_the_clutches_in_closed_form():
    """T ∝ F, so ln N is normal where F is lognormal; friction only adds a factor common to all."""
    base = {**resolved(read_spec(CONFIGS / "conventional.toml")), "fatigue": FATIGUE}
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
    harmonic = median * math.exp(-(m**2) * variance / 2)
    assert found.life_protected == pytest.approx(harmonic, abs=4.5 * found.life_protected_standard_error)


def test_one_clutch_has_one_life():
    """Only friction scatters: every quantile is the life of the one clutch; correlated frictions too."""
    base = {**resolved(read_spec(CONFIGS / "unlike-materials.toml")), "fatigue": FATIGUE}
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
