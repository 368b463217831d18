"""Every equation, called with pint quantities, gives the dimension its docstring states."""

import numpy as np
import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st

from afmcalc.equations.catalogue import equations

UNITS = pint.UnitRegistry()
MODULES = {"drive", "effects", "heat", "sleeve", "springs"}
OWN = sorted(name for name in equations() if name.partition(".")[0] in MODULES)
"""Equations that are not wired as laws; tests/engines/test_laws.py checks the laws."""

OTHERS = {
    "m": "inch", "N": "kgf", "N*m": "kgf*cm", "N/m": "kgf/cm", "Pa": "psi", "m^3": "inch**3", "m^2": "inch**2", "1/m": "1/inch",
    "s": "minute", "kg": "pound", "rad/s": "rpm", "kg*m^2": "pound*foot**2", "kg/m^3": "g/cm**3", "K": "millikelvin",
    "J": "foot*lbf", "J/kg/K": "cal/g/K", "W/K": "cal/s/K", "m^3/J": "mm**3/cal",
    "m/s": "km/hour", "m/s^2": "cm/minute**2", "N/s": "kgf/minute", "rad": "deg", "rad/s^2": "rpm/minute", "N*m/rad": "kgf*cm/deg",
    "N*m*s/rad": "kgf*cm*minute/deg", "W/m^2": "cal/s/inch**2", "W": "kgf*cm/minute",
}  # fmt: skip
"""SI unit → another of the same dimension."""


def quantities(equation, values=None):
    """Arguments with the units of the docstring; pure numbers stay plain (they may be exponents)."""
    found = {}
    for index, (name, term) in enumerate(equation.arguments.items()):
        value = values[index] if values else 0.31 + 0.17 * index
        found[name] = value if term.unit == "1" else UNITS.Quantity(value, term.unit.replace("^", "**"))
    return found


def unit_of(equation):
    return UNITS.Quantity(1, equation.result.unit.replace("^", "**") if equation.result.unit != "1" else "")


@pytest.mark.parametrize("name", OWN)
def test_dimension_is_as_documented(name):
    equation = equations()[name]
    assert equation.summary.endswith(".")
    assert equation.source
    value = equation.function(**quantities(equation))
    for part in value if isinstance(value, tuple) else (value,):
        quantity = part if isinstance(part, UNITS.Quantity) else UNITS.Quantity(part, "")
        assert quantity.dimensionality == unit_of(equation).dimensionality, name


@pytest.mark.parametrize("name", [name for name in OWN if equations()[name].result.unit != "1"])
def test_numbers_do_not_depend_on_the_units(name):
    """The same arguments in other units give the same quantity; a constant with a hidden unit would break this."""
    equation = equations()[name]
    si = equation.function(**quantities(equation))
    other = {
        key: value.to(OTHERS[equation.arguments[key].unit]) if isinstance(value, UNITS.Quantity) else value
        for key, value in quantities(equation).items()
    }
    converted = equation.function(**other).to(equation.result.unit.replace("^", "**"))
    assert converted.magnitude == pytest.approx(
        si.to_base_units().to(equation.result.unit.replace("^", "**")).magnitude
    )


POWERS = {"life.cycles", "life.damage", "life.cycles_of_band"}


@given(st.lists(st.floats(0.05, 3), min_size=10, max_size=10))
def test_floats_and_arrays_agree(values):
    """A function of an array of one element gives the same as of a float; laws with powers are left out."""
    for equation in (equations()[name] for name in OWN):
        arguments = dict(zip(equation.arguments, values, strict=False))
        if equation.name in POWERS:
            continue
        arrays = {name: np.array([value]) for name, value in arguments.items()}
        try:
            expected = equation.function(**arguments)
        except ZeroDivisionError:
            continue
        if isinstance(expected, complex):
            continue  # the root of a negative number: arguments beyond the validity of an inverse
        found = equation.function(**arrays)[0]
        assert found == pytest.approx(expected, rel=1e-13, nan_ok=True), equation.name
