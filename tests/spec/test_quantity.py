"""Unit strings: what is read, and what is refused rather than guessed."""

import math
import re
from decimal import Decimal
from pathlib import Path

import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import CHARACTERS
from texts import texts

from afmcalc.messages import language, speaking
from afmcalc.spec.quantity import EXAMPLES, factor, parse_quantity, unread_number
from afmcalc.units import ENGINEER, PLAIN, PREFIXED, PREFIXES, RUSSIAN, RUSSIAN_PREFIXES, ZEROS, in_unit, product


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
        *((f"1500 {unit}", "rad/s", 50 * math.pi) for unit in ("1/min", "min^-1", "min⁻¹", "/min", "U/min", "1/мин")),
        ("1500 мин⁻¹", "rad/s", 50 * math.pi),
        ("1500/min", "rad/s", 50 * math.pi),
        *((f"300 {unit}", "1/m", 300.0) for unit in ("1/m", "1 / m", "m^-1", "m-1", "m⁻¹", "м⁻¹", "/m")),
        ("0.3 1/mm", "1/m", 300.0),
        *((f"5 {unit}", "Pa", 5e6) for unit in ("N/mm2", "N/mm^2", "N/mm²", "N/mm**2", "Н/мм2", "N mm-2")),
        *((f"8 {unit}", "kg*m^2", 8.0) for unit in ("kgm2", "kgm²", "kg·m²", "kg m^2", "кгм2", "кг·м²")),
        ("8 gmm2", "kg*m^2", 8e-9),
        *((f"8 {unit}", "N*m/rad", 8e3) for unit in ("kNm/rad", "kN·m/rad", "кН·м/рад")),
        ("480 Дж/(кг·К)", "J/kg/K", 480.0),
        ("5 newtons", "N", 5.0),
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
        ("5 N//m", "N/m", "is not a unit"),
        ("5 *N", "N", "is not a unit"),
        ("5 mm22", "m", "is not a unit"),
        ("5 W/(m*(K))", "W/m/K", "is not a unit"),
        ("5 s^-1", "rad/s", "is of dimension s^-1"),
        ("5 N^2/m^4", "N", "is of dimension m^-4*N^2"),
        ("2 МPa", "Pa", "did you mean 'MPa' (all Latin)"),
        ("20 N/mmm", "N/m", "did you mean 'mm'"),
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


REFEREE = pint.UnitRegistry(
    (Path(__file__).parents[1] / "data" / "units.txt").read_text(encoding="utf-8").splitlines(), non_int_type=Decimal
)
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


@pytest.mark.parametrize("word", sorted(set(WORDS)))
def test_every_unit_is_what_pint_says(word):
    dimension = REFEREE.parse_units(word).dimensionality
    unit = next(each for each in (*FIELDS, "J", "J/s", "K") if REFEREE.parse_units(each).dimensionality == dimension)
    assert float(factor(word, unit)) == pytest.approx(float(by_pint(word, unit)), rel=1e-15)


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
    """What a Russian table shows is read as what the English one shows."""
    for context, text in texts():
        if context == "unit" and text not in (*ZEROS, ""):
            russian = language("ru").translated(text, "unit")
            if "^0," not in russian:  # no field has a root in its unit
                assert product(russian)[:2] == product(text)[:2], text


@given(
    st.lists(
        st.tuples(st.sampled_from(["*", "/", " ", "·", " / "]), st.sampled_from(WORDS), st.integers(-3, 3)),
        min_size=1,
        max_size=4,
    ),
    st.sampled_from(FIELDS),
)
def test_products_are_what_pint_says(parts, unit):
    """Random products, drawn to a field's dimension by one more factor: the same number, or refused by both."""
    text = "".join(
        (sign if at else "") + word + (f"^{power}" if power not in (0, 1) else "")
        for at, (sign, word, power) in enumerate(parts)
    )
    pints = re.sub("·", "*", text)
    for own, theirs in (
        (text, pints),
        (
            f"{unit} {text}/({text})" if "/" not in text else text,
            f"{unit}*({pints})/({pints})" if "/" not in text else pints,
        ),
    ):
        try:
            expected = by_pint(theirs, unit)
        except pint.DimensionalityError:
            expected = None
        try:
            assert float(factor(own, unit)) == pytest.approx(float(expected), rel=1e-12)
        except ValueError as error:
            # 1/min is a speed of rotation here
            assert expected is None, (own, str(error))


NUMBERS = ("300", "-2.5", "1e3", "2,5", "2 000", "1,000", "1.000,5", "12 345,6", "0,125")
SLIPS = ("", "1/", "/", " ")


@given(
    st.sampled_from(NUMBERS),
    st.sampled_from(["", " ", "  "]),
    st.one_of(
        st.sampled_from([each for _, each in EXAMPLES.values()]).map(lambda example: example.partition(" ")[2]),
        st.sampled_from(WORDS),
        st.sampled_from(
            ["1/m", "1/min", "min^-1", "N/mn", "kn", "Mpa", "кH", "МPa", "N/mМ", "newtn", "Kgm2", "mmm", "degc"]
        ),
    ),
    st.sampled_from(FIELDS),
)
def test_what_is_advised_is_accepted(number, space, unit_text, unit):
    """Advice followed, again where it leads to more advice, ends with a number."""
    text = f"{number}{space}{unit_text}"
    for _ in range(4):
        try:
            parse_quantity(text, unit)
        except ValueError as error:
            said = str(error)
        else:
            return
        if written := re.search("read: write (.*?)(?: or .*)?$|commas: write (.*)$", said):
            text = written[1] or written[2]
            if re.fullmatch(r"[-+\d.]+", text):  # without a unit, as a number
                assert math.isfinite(parse_quantity(float(text), unit))
                return
        elif meant := re.search("write '(.*?)', or '(.*?)' in Cyrillic", said):
            for each in meant.groups():
                assert math.isfinite(parse_quantity(f"2 {each}", unit)), said
            return
        elif near := re.search("unknown unit '(.*?)'; did you mean '(.*?)'", said):
            text = text.replace(near[1], near[2])
            assert math.isfinite(parse_quantity(text, unit)), said
            return
        else:
            text = re.search('such as "(.*?)"', said)[1]
    raise AssertionError(text)


@pytest.mark.parametrize("text", ["2,5 кН", "2,5 kN", "2,5кН", "0,125 кН", "-1,5 кН", "2,125 кН"])
def test_a_decimal_comma_is_read_in_russian_only(text):
    with pytest.raises(ValueError, match="comma"):
        parse_quantity(text, "N")
    with speaking(language("ru")):
        if text == "2,125 кН":  # it may be that of thousands
            assert unread_number(text) == "a comma is not read: write 2125 кН or 2.125 кН, whichever is meant"
            with pytest.raises(ValueError, match="whichever is meant"):
                parse_quantity(text, "N")
        else:
            number = float(re.match(r"[-\d,]+", text)[0].replace(",", "."))
            assert parse_quantity(text, "N") == pytest.approx(1000 * number, rel=1e-15)
        for bare in ("2,5", "1.000,5 кН", "1,2,3 кН"):
            with pytest.raises(ValueError, match="comma|unit"):
                parse_quantity(bare, "N")
