"""The [tolerance] block: what it refuses, and how it says so."""

import pytest
from conftest import CONFIGS


@pytest.mark.parametrize(
    ("fields", "settings_", "says"),
    [
        ('"closing_spring.forse" = { distribution = "normal", spread = 1 }', "", "did you mean 'closing_spring.force'?"),
        ('"friction_group.pairs" = { distribution = "normal", spread = 1 }', "", "whole number, which does not scatter"),
        ('"name" = { distribution = "normal", spread = 1 }', "", "is not a number"),
        ('"closing_spring.force" = { distribution = "normal", spread = "-5 %" }', "", "must be at least 0"),
        ('"closing_spring.force" = { distribution = "uniform", min = 3, max = 1 }', "", "must be greater than min"),
        ('"closing_spring.force" = { distribution = "normal" }', "", "required for 'normal'"),
        ('"closing_spring.force" = { distribution = "uniform" }', "", "or give min and max"),
        ('"closing_spring.force" = { distribution = "uniform", spread = 1, min = 1, max = 2 }', "", "excludes min and max"),
        ('"closing_spring.force" = { distribution = "normal", spread = "5 mm" }', "", "is a length, not a force"),
        ('"closing_spring.force" = { distribution = "gauss", spread = 5 }', "", "must be one of normal"),
        ('"closing_spring.force" = { distribution = "normal", sigma = 5 }', "", "unknown key"),
        ('"closing_spring.force" = { distribution = "normal", spread = 1, max = 1 }', "", "leave nothing"),
        ('"closing_spring.force" = { distribution = "triangular", min = 1, max = 2 }', "", "the peak 2000 is not between"),
        ('"closing_spring.stiffness" = { distribution = "normal", spread = 1 }', "", "no closing_spring.stiffness to scatter"),
        ('"friction.driving" = { distribution = "triangular" }', "", "this clutch has friction instead"),
        ('"friction" = { distribution = "triangular" }', "samples = 10", "must be at least 1000"),
        ('"friction" = { distribution = "triangular" }', "quantiles = [0.5, 1.5]", "between 0 and 1"),
        ('"friction" = { distribution = "triangular" }', "friction_correlation = 2", "at most 1"),
        ("", "", "fields"),
        ('"closing_spring.force" = { distribution = "normal", spread = true }', "", "spread = true: a boolean is not a number"),
        ('"friction" = { distribution = "uniform", min = false, max = 1 }', "", "min = false: a boolean is not a number"),
        ('"friction" = { distribution = "uniform", min = -5, max = 1 }', "", "must be at least 0, as friction itself"),
        ('"control_unit.wall_angle" = { distribution = "uniform", min = 0, max = 90 }', "", "must be at most 1.5708"),
        ('"friction" = { distribution = "triangular" }', "seed = true", "seed = true: must be a whole number"),
        ('"friction" = { distribution = "triangular" }', 'samples = "2_000"', "must be a whole number"),
        ('"friction" = { distribution = "triangular" }', "samples = 20_000_000_000", "at most 1e+10"),
        ('"friction" = { distribution = "triangular" }', "sobol_base = 64.5", "sobol_base = 64.5: must be a whole number"),
        ('"friction" = { distribution = "triangular" }', "friction_correlation = true", "a boolean is not a plain number"),
        ('"friction" = { distribution = "triangular" }', "quantiles = [true]", "a boolean is not a plain number"),
        ('"friction" = { distribution = "triangular" }', 'setting = "bench"', "as-made, each-adjusted"),
        ('"friction" = { distribution = "triangular" }', "quantiles = 3", "quantiles = 3: must be a list in brackets"),
        ('"friction" = { distribution = "normal", spread = [1] }', "", "spread = [1]: must be a number, or a text with a unit"),
        ('"friction" = { distribution = "normal", spread = inf }', "", "spread = Infinity: must be finite"),
        ('"friction" = { distribution = "normal", center = -5, spread = 1 }', "", "center = -5: must be at least 0, as friction"),
        ('"friction" = { distribution = "uniform", spread = 5.45 }', "", "from -5.15 to 5.75, beyond what it may be, 0 to inf"),
        ('"closing_spring.force" = { distribution = "normal", spread = 0, max = 1 }', "", "leave nothing"),
        ('"control_spring.force" = { distribution = "normal", center = 1, spread = 0 }', "", "the spec has no such table"),
    ],
)  # fmt: skip
def test_what_is_refused(fields, settings_, says, afmcalc):
    text = (CONFIGS / "default.toml").read_text(encoding="utf-8")
    result = afmcalc("tolerance", "-", stdin=f"{text}\n[tolerance]\n{settings_}\n[tolerance.fields]\n{fields}\n")
    assert (result.code, result.out) == (2, "")
    assert says in result.err


@pytest.mark.parametrize("samples", ["2_000", "2000.0", "2e3"])
def test_whole_numbers_however_written(samples, afmcalc):
    text = (CONFIGS / "default.toml").read_text(encoding="utf-8")
    block = f'[tolerance]\nsamples = {samples}\n[tolerance.fields]\nfriction = {{ distribution = "uniform" }}\n'
    assert afmcalc("torque", "-", "--json", stdin=f"{text}\n{block}").json["spec"]["tolerance"]["samples"] == 2000
