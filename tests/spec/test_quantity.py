"""Unit strings: what is read, and what is refused rather than guessed."""

import math
from decimal import Decimal
from pathlib import Path

import pint
import pytest
from babel.messages.pofile import read_po
from hypothesis import given
from hypothesis import strategies as st
from sources import READ, REFUSED
from strategies import CHARACTERS

from afmcalc.messages import FOLDER
from afmcalc.spec.quantity import EXAMPLES, factor, parse_quantity
from afmcalc.units import ENGINEER, PLAIN, PREFIXED, PREFIXES, RUSSIAN, RUSSIAN_PREFIXES, ZEROS, in_unit, product

CASES = [(text, unit, value) for unit, value, texts in READ["quantity"] for text in texts]


@pytest.mark.parametrize(("text", "unit", "value"), [*CASES, (3, "N", 3.0), (0.5, "1", 0.5)])
def test_read(text, unit, value):
    assert parse_quantity(text, unit) == pytest.approx(value, rel=1e-15)


def test_a_decimal_number_is_read_to_the_last_bit():
    for text, value in (("20.1 mm", 0.0201), ("0.3 mm", 0.0003), ("1.1 cm^3", 1.1e-6), ("20.3 degC", 293.45)):
        assert parse_quantity(text, {"mm": "m", "cm^3": "m^3", "degC": "K abs"}[text.split()[1]]) == value


NO_TEXTS = {"finite": (math.nan, math.inf, 10**400), "boolean": (True,), "a force is wanted": ([1],)}
NUMBERS = [(each, "N", says) for says, values in NO_TEXTS.items() for each in values]


@pytest.mark.parametrize(("value", "unit", "says"), [*REFUSED["quantity"], *NUMBERS])
def test_refused(value, unit, says):
    with pytest.raises(ValueError, match="give|or|finite") as error:
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


UNITS = (Path(__file__).parents[1] / "data" / "units.txt").read_text(encoding="utf-8")
REFEREE = pint.UnitRegistry(UNITS.splitlines(), non_int_type=Decimal)
"""The same units as pint reads them, an independent program."""


def by_pint(text, unit):
    return REFEREE.Quantity(Decimal(1), REFEREE.parse_units(text)).to(REFEREE.parse_units(unit)).magnitude


WORDS = [
    *(prefix + name for prefix in ("", *PREFIXES) for name in PREFIXED),
    *PLAIN,
    *(prefix + name for prefix in ("", *RUSSIAN_PREFIXES) for name, latin in RUSSIAN.items() if latin in PREFIXED),
    *RUSSIAN,
]
FIELDS = sorted(EXAMPLES.keys() - {"1", "K abs"})


def test_every_unit_is_what_pint_says():
    fields = {REFEREE.parse_units(unit).dimensionality: unit for unit in ("K", "J/s", "J", *reversed(FIELDS))}
    for word in {*WORDS}:
        unit = fields[REFEREE.parse_units(word).dimensionality]
        assert float(factor(word, unit)) == pytest.approx(float(by_pint(word, unit)), rel=1e-15), word


@pytest.mark.parametrize(("unit", "shown"), sorted(ENGINEER.items()))
def test_every_unit_shown_is_what_pint_says(unit, shown):
    si = REFEREE.Quantity(Decimal(300), REFEREE.parse_units(unit.removesuffix(" abs")))
    assert in_unit(300.0, shown) == pytest.approx(float(si.to(REFEREE.parse_units(shown)).magnitude), rel=1e-15)


def test_every_scale_of_temperature_is_what_pint_says():
    for name, zero in ZEROS.items():
        scale = name.translate(str.maketrans("КС", "KC")).replace("°", "deg")
        assert zero == REFEREE.Quantity(Decimal(0), scale).to("K").magnitude
        assert parse_quantity(f"0 {name}", "K abs") == float(zero)


def test_every_unit_of_a_catalogue_is_the_same_unit():
    """The numbers of a Russian table are read as those of the English one."""
    with open(f"{FOLDER}/ru.po", "rb") as file:
        units = {each.id: each.string for each in read_po(file) if each.context == "unit"}
    assert len(units) > 50
    for english, russian in units.items():
        if english not in ZEROS and "^0," not in russian:  # no field has a root in its unit
            assert product(russian)[:2] == product(english)[:2], english


@given(
    st.lists(st.tuples(st.sampled_from("*/ ·"), st.sampled_from(WORDS), st.integers(-3, 3)), min_size=1, max_size=4), st.sampled_from(FIELDS)
)  # fmt: skip
def test_products_are_what_pint_says(parts, unit):
    """Random products, drawn to a field's dimension by one more factor: the same number, or refused by both."""
    words = [(sign, word + (f"^{power}" if power not in (0, 1) else "")) for sign, word, power in parts]
    text = "".join((sign if at else "") + word for at, (sign, word) in enumerate(words))
    for own in (text, f"{unit} {text}/({text})" if "/" not in text else text):
        try:
            expected = by_pint(own.replace("·", "*"), unit)
        except pint.DimensionalityError:
            expected = None
        try:
            assert float(factor(own, unit)) == pytest.approx(float(expected), rel=1e-12)
        except ValueError as error:
            assert expected is None, (own, str(error))  # 1/min is a speed of rotation here
