"""Unit strings: what is read, and what is refused rather than guessed."""

import math
import subprocess
import sys

import pytest
from conftest import CONFIGS
from hypothesis import given
from hypothesis import strategies as st
from strategies import CHARACTERS

from afmcalc.spec.lookup import looked_up
from afmcalc.spec.quantity import parse_quantity
from afmcalc.spec.units import EXAMPLES, KNOWN


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("5 kN", "N", 5000.0),
        ("20 N/mm", "N/m", 20000.0),
        ("100 mm", "m", 0.1),
        ("100mm", "m", 0.1),
        ("30 deg", "rad", math.radians(30)),
        ("30°", "rad", math.radians(30)),
        ("15 cm^3", "m^3", 15e-6),
        ("15 cm³", "m^3", 15e-6),
        ("400 MPa", "Pa", 4e8),
        ("7 N*m", "N*m", 7.0),
        ("7 N·m", "N*m", 7.0),
        ("7 N m", "N*m", 7.0),
        ("7 Nm", "N*m", 7.0),
        ("7 kNm", "N*m", 7000.0),
        ("7 Н·м", "N*m", 7.0),
        ("7 Нм", "N*m", 7.0),
        ("7 Н", "N", 7.0),
        ("7 кН", "N", 7000.0),
        ("7 мм", "m", 0.007),
        ("7 Н/мм", "N/m", 7000.0),
        ("7 МПа", "Pa", 7e6),
        ("2 N mm^-1", "N/m", 2000.0),
        ("2 N·mm⁻¹", "N/m", 2000.0),
        ("1 lbf", "N", 4.4482216152605),
        ("1 in", "m", 0.0254),
        ("20 degC", "K abs", 293.15),
        ("-40 °C", "K abs", 233.15),
        ("300 K", "K abs", 300.0),
        ("1500 rpm", "rad/s", 50 * math.pi),
        ("1500 об/мин", "rad/s", 50 * math.pi),
        ("2e-5 mm^3/J", "m^3/J", 2e-14),
        ("480 J/(kg*K)", "J/kg/K", 480.0),
        ("0.5 min", "s", 30.0),
        ("-3 N", "N", -3.0),
        ("1e3 N", "N", 1000.0),
        (3, "N", 3.0),
        (0.5, "1", 0.5),
    ],
)
def test_read(text, unit, value):
    assert parse_quantity(text, unit) == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize(
    ("value", "unit", "says"),
    [
        ("200 J", "N*m", "J is an energy, not a torque"),
        ("200 J", "N", "J is an energy, not a force"),
        ("5 Nm", "N", "Nm is a torque, not a force"),
        ("5 kg", "N", "kg is a mass, not a force"),
        ("20 degC", "s", "give a time"),
        ("20 kg", "K abs", "is no unit of a temperature"),
        ("5 W", "W/K", "a power"),
        ("5 kn", "N", "did you mean 'kN'"),
        ("5 Mpa", "Pa", "did you mean 'MPa'"),
        ("5 mmm", "m", "unknown unit 'mmm'"),
        ("5 newtn", "N", "did you mean 'newton'"),
        ("5", "N", "has no unit"),
        ("5,5 mm", "m", "decimal comma"),
        ("abc", "N", "cannot be read"),
        ("", "N", "cannot be read"),
        ("nan N", "N", "cannot be read"),
        ("1e400 N", "N", "must be finite"),
        (float("nan"), "N", "must be finite"),
        (float("inf"), "N", "must be finite"),
        (10**400, "N", "must be finite"),
        (True, "N", "boolean"),
        ([1], "N", "a force is wanted"),
        ("0.3", "1", "has no unit"),
        ("0.3 rad", "1", "dimensionless"),
        ("5 mm*2", "m", "is not a unit"),
        ("5 N/", "N/m", "is not a unit"),
        ("5 ((N)", "N", "is not a unit"),
        ("5 m + 3 m", "m", "is not a unit"),
        ("5 __import__('os')", "N", "is not a unit"),
        ("5 m^2", "m", "an area, not a length"),
    ],
)
def test_refused(value, unit, says):
    with pytest.raises(ValueError, match="give|decimal|finite") as error:
        parse_quantity(value, unit)
    assert says in str(error.value)


@given(st.text(CHARACTERS, max_size=12), st.sampled_from(sorted(EXAMPLES)))
def test_any_text_is_read_or_refused(text, unit):
    """Nothing but a number or a ValueError comes out, whatever pint makes of the text."""
    for candidate in (text, f"5 {text}"):
        try:
            assert math.isfinite(parse_quantity(candidate, unit))
        except ValueError as error:
            assert str(error)


@given(st.floats(-1e300, 1e300), st.sampled_from(sorted(EXAMPLES)))
def test_numbers_are_si(value, unit):
    assert parse_quantity(value, unit) == value


@pytest.mark.parametrize("unit", KNOWN)
def test_units_known_by_heart_are_as_pint_reads_them(unit):
    """To the last digit, so that it makes no difference which of the two reads a unit."""
    assert {text: looked_up(text, unit) for text in KNOWN[unit]} == KNOWN[unit]


def test_shipped_specs_are_read_without_pint():
    """Every unit of the examples is known by heart."""
    code = "import sys; from afmcalc.spec import read_spec; [read_spec(path) for path in sys.argv[1:]]; print('pint' in sys.modules)"
    shipped = [str(path) for path in CONFIGS.glob("*.toml") if path.stem != "requirements"]
    ended = subprocess.run([sys.executable, "-c", code, *shipped], capture_output=True, text=True, check=True)
    assert ended.stdout == "False\n"
