"""Life over the clutches: friction from slip to slip, the rest from clutch to clutch; against single clutches."""

import math

import numpy as np
import pytest
from conftest import CONFIGS
from scipy.special import ndtr

from afmcalc.analysis.tolerance.study import tolerance
from afmcalc.engines import build
from afmcalc.spec import make_spec, read_spec, resolved

S21 = {
    "variant": "indirect",
    "friction": {"min": 0.1, "mean": 0.3, "max": 0.8},
    "friction_group": {"pairs": 8, "mean_radius": 0.1},
    "closing_spring": {"force": 2000, "stiffness": 20e3},
    "control_spring": {"stiffness": 10e3},
    "control_unit": {"gain": 1.0, "hub_diameter": 0.05, "key_friction": 0.15},
}
FATIGUE = {"endurance_limit": 400e6, "polar_section_modulus": 15e-6, "exponent": 6, "base_cycles": 1e7}


def scattering(base, fields, **options):
    return make_spec({**base, "tolerance": {"fields": fields, "sobol_base": 64, **options}})


def per_slip_life(spec, friction, slips, rng):
    """Slips to failure of one clutch, slip by slip: one over the mean damage, and its standard error."""
    clutch, part = build(spec), spec.fatigue
    stress = clutch.torque(friction(rng, slips)) / part.polar_section_modulus
    damages = (stress / part.endurance_limit) ** part.exponent / part.base_cycles
    life = 1 / damages.mean()
    return life, life**2 * damages.std() / math.sqrt(slips)


@pytest.mark.parametrize("variant", ["all-driving", "indirect"])
def test_life_of_single_clutches_slip_by_slip(variant):
    """The population: its springs; service: friction. Lives of clutches at three quantiles of the spring."""
    base = S21 if variant == "indirect" else {**resolved(read_spec(CONFIGS / "all-driving.toml"))}
    base = {**base, "fatigue": FATIGUE, "drive": {"dynamic_factor": 1.4}}
    spread = 0.05
    force = float(build(make_spec(base)).closing_force)
    low, high = 0.1, 0.5
    fields = {"friction": {"distribution": "uniform", "min": low, "max": high},
              "closing_spring.force": {"distribution": "uniform", "spread": spread * force}}  # fmt: skip
    found, _ = tolerance(build(scattering(base, fields, samples=200_000)))
    rng = np.random.default_rng(3)
    made = (
        {"control_spring": {**base["control_spring"], "force": float(build(make_spec(base)).control_force)}}
        if variant == "indirect"
        else {}
    )
    for row in found.life_quantiles:
        # life falls as the spring gets stronger: the p-quantile of life belongs to the (1 − p)-quantile of the force
        own = {
            **base,
            **made,
            "closing_spring": {**base["closing_spring"], "force": force * (1 + spread * (1 - 2 * row.probability))},
        }
        life, error = per_slip_life(make_spec(own), lambda r, n: r.uniform(low, high, n), 20_000, rng)
        assert row.protected == pytest.approx(life, abs=4.5 * math.hypot(error, row.protected_standard_error))
        assert row.protected / row.unprotected == pytest.approx(1.4**6, rel=1e-9)
    assert found.life_protected == pytest.approx(found.life_quantiles[-1].protected, rel=0.2)


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
    for correlation in (1, 0.6, 0, -1):
        options = {"samples": 50_000, "friction_correlation": correlation}
        found, _ = tolerance(build(scattering(base, fields, **options)))
        lives = {row.protected for row in found.life_quantiles}
        assert max(lives) == pytest.approx(min(lives), rel=1e-9)
        assert found.life_protected == pytest.approx(max(lives), rel=1e-9)
        # the same by brute force over the two frictions' scores
        rng = np.random.default_rng(2)
        z = rng.standard_normal((2, 400_000))
        scores = z[0], correlation * z[0] + math.sqrt(1 - correlation**2) * z[1]
        clutch = build(make_spec(base))
        share = map(ndtr, scores)
        f = [r.mean * (0.8 + 0.4 * u) for r, u in zip(clutch.friction, share, strict=True)]
        damage = (clutch.torque(*f) / (400e6 * 15e-6)) ** 6 / 1e7
        error = damage.std() / math.sqrt(damage.size) / damage.mean()
        assert found.life_protected * damage.mean() == pytest.approx(1, abs=4.5 * error)
