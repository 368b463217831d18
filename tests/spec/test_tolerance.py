"""The [tolerance] block: what it refuses, and how it says so."""

import pytest
from conftest import CONFIGS
from sources import REFUSED


@pytest.mark.parametrize(("fields", "settings_", "says"), REFUSED["tolerance"])
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
