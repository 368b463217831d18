"""Quantities of a hundred random clutches against those of the engine of 0.3.0, which calculated them another way."""

import json
from functools import cache
from pathlib import Path

import pytest
from conftest import slow

from afmcalc.engines.elasticity import elasticities
from afmcalc.engines.selection import quantities_of
from afmcalc.spec import make_spec
from afmcalc.spec.catalogues import balls


@cache
def stored():
    """Stored specs, and quantity → its value for each spec, null if a clutch has none or rounding errors decide."""
    return json.loads((Path(__file__).parents[1] / "data" / "quantities.json").read_text(encoding="utf-8"))


def value(clutch, name):
    """Value of a quantity by its name in the stored data: cases, frictions and quantity."""
    *cases, quantity = name.replace("cycles", "cycles_extrapolated").split()
    frictions = {key: float(number) for key, at, number in (case.partition("=") for case in cases) if at}
    for case in cases:
        clutch = clutch if "=" in case else clutch.at(case)
    return float((clutch.at(**frictions) if frictions else clutch)[quantity])


def compare(number):
    """Compare every stored quantity of a clutch; return their number."""
    clutch = quantities_of(make_spec(stored()["specs"][number]))
    slopes = elasticities(clutch)
    if "balls_listed" in clutch.laws.names:
        clutch = clutch.at(balls_listed=balls())
    own = {name: values[number] for name, values in stored()["values"].items() if values[number] is not None}
    for name, old in own.items():
        if name.startswith("∂ "):  # at a kink the old engine has the slope of one side
            sides = slopes.get(name[2:], (0.0, 0.0))
            assert min(abs(side - old) for side in sides) < 2e-7, (number, name)
        else:
            assert value(clutch, name) == pytest.approx(old, rel=1e-9, abs=0), (number, name)
    return len(own)


@pytest.mark.parametrize("first", [0, 30, 50, 80, *slow(10, 20, 40, 60, 70, 90)])
def test_quantities_are_those_of_the_old_engine(first):
    assert sum(compare(number) for number in range(first, first + 10)) > 600
