"""The spec: examples, round trips, every rule, former keys, text for people; units that are read, and those refused."""

import json
import math
import re
import tomllib
from decimal import Decimal
from pathlib import Path

import pint
import pytest
from babel.messages.pofile import read_po
from conftest import CONFIGS, WANTED
from hypothesis import given
from hypothesis import strategies as st
from sources import READ, REFUSED
from strategies import CHARACTERS, direct_specs, indirect_specs

from afmcalc.engines import build
from afmcalc.errors import AfmcalcError, SpecError
from afmcalc.messages import FOLDER
from afmcalc.spec import Spec, make_spec, read_spec, resolved, to_toml
from afmcalc.spec.edit import as_written
from afmcalc.spec.fields import keys_below
from afmcalc.spec.keys import keys
from afmcalc.spec.parse import Source, example_names
from afmcalc.spec.problems import REMOVED
from afmcalc.spec.quantity import EXAMPLES, factor, parse_quantity
from afmcalc.spec.read import put
from afmcalc.spec.write import WRITTEN
from afmcalc.units import ENGINEER, PLAIN, PREFIXED, PREFIXES, RUSSIAN, RUSSIAN_PREFIXES, ZEROS, in_unit, product

SHIPPED = sorted(path for path in CONFIGS.glob("*.toml") if path.stem not in WANTED)
DEFAULT = (CONFIGS / "default.toml").read_text(encoding="utf-8")
BASE = tomllib.loads(DEFAULT)


def at(path, value):
    data = {}
    put(data, path, value)
    return data


def changed(**changes):
    """The base clutch with values at dotted paths (``__`` for the dot); None removes."""
    data = json.loads(json.dumps(BASE))
    for path, value in changes.items():
        put(data, path.replace("__", "."), value)
    return data


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_examples_round_trip(path):
    spec = read_spec(path)
    data = resolved(spec)
    assert resolved(make_spec(data)) == data
    assert resolved(make_spec(tomllib.loads(to_toml(data)))) == data
    assert resolved(make_spec(json.loads(json.dumps(data)))) == data


def test_defaults():
    spec = make_spec(changed(friction__mean=None, friction_group__driving_pairs=None, adjustment=None))
    data = resolved(spec)
    assert spec.friction.range.mean == (0.1 + 0.8) / 2
    assert data["friction"] == {"min": 0.1, "max": 0.8}, "what follows from other keys stays free to follow"
    assert data["friction_group"]["driving_pairs"] == 1
    assert data["adjustment"] == {"method": "min-friction", "margin": 1.0}


@pytest.mark.parametrize(("changes", "path", "value", "says"), REFUSED["spec"])
def test_bad_input_names_file_key_value_and_what_is_allowed(changes, path, value, says):
    with pytest.raises(SpecError) as told:
        make_spec(changed(**{key: None if value == "none" else value for key, value in changes.items()}), "bad.toml")
    problems = [each for each in told.value.problems if each.path == path and says in each.message]
    assert problems, told.value
    assert not value or problems[0].given == value
    assert all(line.startswith("bad.toml: ") for line in str(told.value).splitlines())


def fields_of_each_unit():
    """Three keys of each unit of a spec."""
    by_unit = {}
    for key in keys_below(Spec).values():
        by_unit.setdefault(key.unit, []).append(key.path)
    for unit, paths in by_unit.items():
        yield from ((unit, path) for path in {paths[0], paths[len(paths) // 2], paths[-1]} if unit)


def test_a_wrong_dimension_is_refused_in_every_unit():
    def problems(path, value):
        with pytest.raises(SpecError) as told:
            make_spec(at(path, value))
        return {each.message for each in told.value.problems if each.path == path}

    for unit, path in fields_of_each_unit():
        for wrong in {"kg": "N", "N*m": "J", "J": "N*m"}.get(unit, "kg"), "mm^4":
            assert problems(path, f"3 {wrong}") - problems(path, 3), (path, wrong)


def test_a_title_block_takes_text_and_a_revision_and_a_date_without_quotes():
    text = 'organisation = "ООО «Муфта»"\nrevision = 2\ndate = 2026-01-31\n'
    data = resolved(make_spec(changed(report=tomllib.loads(text))))
    assert data["report"] == {"organisation": "ООО «Муфта»", "revision": "2", "date": "2026-01-31"}
    assert resolved(make_spec(tomllib.loads(to_toml(data)))) == data


def test_overrides():
    spec = read_spec(None, ["C=0.75", "closing_spring.force=5 kN", "friction.mean=", "name=other"])
    assert (spec.name, spec.control_unit.gain, spec.closing_spring.force) == ("other", 0.75, 5000.0)
    assert spec.friction.range.mean == pytest.approx(0.45)
    for bad in ("C", "=3", "variant.x=1", "foo=", "friction.foo=", ".=1"):
        with pytest.raises(AfmcalcError, match="--set"):
            read_spec(None, [bad])
    with pytest.raises(AfmcalcError, match="did you mean 'gain'"):
        read_spec(None, ["control_unit.gian=1"])


def test_a_table_is_not_shadowed_by_a_key_of_its_name():
    drawing = ('drawing={tolerance="H7", material=20}', "hardness=58…62 HRC")
    spec = read_spec(CONFIGS / "default.toml", ('tolerance={fields={friction={distribution="uniform"}}}', *drawing))
    assert list(spec.tolerance.fields) == ["friction"]
    assert spec.drawing.model_dump(exclude_none=True) == {"tolerance": "H7", "material": "20", "hardness": "58…62 HRC"}


@pytest.mark.parametrize(("fields", "settings_", "says"), REFUSED["tolerance"])
def test_what_is_refused_of_a_study(fields, settings_, says, afmcalc):
    result = afmcalc("tolerance", "-", stdin=f"{DEFAULT}\n[tolerance]\n{settings_}\n[tolerance.fields]\n{fields}\n")
    assert (result.code, result.out) == (2, "")
    assert says in result.err


@pytest.mark.parametrize("samples", ["2_000", "2000.0", "2e3"])
def test_whole_numbers_however_written(samples, afmcalc):
    block = f'[tolerance]\nsamples = {samples}\n[tolerance.fields]\nfriction = {{ distribution = "uniform" }}\n'
    assert afmcalc("torque", "-", "--json", stdin=f"{DEFAULT}\n{block}").json["spec"]["tolerance"]["samples"] == 2000


@pytest.mark.parametrize("path", REMOVED)
def test_a_removed_key_says_what_to_do(path):
    assert path not in keys()
    block, name = path.split(".")
    data = resolved(read_spec())
    data.setdefault(block, {})[name] = 1
    for refused in (lambda: make_spec(data), lambda: read_spec(None, [f"{path}=1"])):
        with pytest.raises(AfmcalcError, match="unknown key.* since 0.4: .*leave the key out"):
            refused()


LINE = re.compile(r"(?P<key>\w+) = (?P<value>.+)")


@given(st.one_of(direct_specs(), indirect_specs()))
def test_a_written_spec_has_few_digits_and_answers_the_same(spec):
    text = to_toml(resolved(spec))
    digits = [each.replace(".", "").lstrip("0") for each in re.findall(r"\d+\.?\d*", text)]
    assert max(map(len, digits)) <= 12
    again = make_spec(tomllib.loads(text))
    assert again == as_written(spec) == as_written(again)
    before, after = build(spec), build(again)
    for own, old in zip(after.spec.friction.groups, before.spec.friction.groups, strict=True):
        assert own == pytest.approx(old, rel=1e-11)
    for name in ("nominal_torque", "torque_max", "accuracy_factor", "reduced_gain"):
        assert getattr(after, name) == pytest.approx(getattr(before, name), rel=1e-8), name


@pytest.mark.parametrize("name", sorted(set(example_names()) - WANTED))
def test_every_key_has_its_unit(name):
    table = ""
    for line in filter(None, to_toml(resolved(read_spec(CONFIGS / f"{name}.toml"))).splitlines()):
        if line.startswith("["):
            table = line.strip("[]") + "."
        elif not table.startswith("tolerance.fields.") and not line.startswith((" ", "]")):
            matched = LINE.fullmatch(line)
            assert matched, line
            key = keys()[table + matched["key"]]
            is_text = not key.unit and matched["value"][0] not in "[0123456789"
            assert matched["value"].startswith('"') == (key.unit in WRITTEN or is_text)


def test_text_stays_text():
    name = 'a "b" \\ c # d é Ф\t\x7f\n[x]\ny = 1'
    assert tomllib.loads(to_toml({"name": name})) == {"name": name}


def test_paths_and_lists_are_read_back():
    spec = read_spec(CONFIGS / "tolerance.toml")
    text = to_toml(resolved(spec))
    assert '[tolerance.fields."closing_spring.force"]' in text
    wrong = Source("x.toml", text.replace('spread = "1 mm"', 'spread = "1 kN"'))
    with pytest.raises(SpecError, match=r'x\.toml:\d+: tolerance\.fields\."?friction_group'):
        make_spec(tomllib.loads(wrong.text), wrong)


@pytest.mark.parametrize(("path", "given", "written"), READ["written"])
def test_what_stands_on_a_plate_is_written_as_it_was_given(path, given, written):
    table, key = path.split(".")
    number = parse_quantity(given, keys()[path].unit)
    text = to_toml({table: {key: number}})
    assert f'{key} = "{written}"' in text
    assert parse_quantity(written, keys()[path].unit) == pytest.approx(number, rel=1e-12)


READABLE = [(text, unit, value) for unit, value, texts in READ["quantity"] for text in texts]


@pytest.mark.parametrize(("text", "unit", "value"), [*READABLE, (3, "N", 3.0), (0.5, "1", 0.5)])
def test_read(text, unit, value):
    assert parse_quantity(text, unit) == pytest.approx(value, rel=1e-15)


def test_a_decimal_number_is_read_to_the_last_bit():
    for text, value in (("20.1 mm", 0.0201), ("0.3 mm", 0.0003), ("1.1 cm^3", 1.1e-6), ("20.3 degC", 293.45)):
        assert parse_quantity(text, {"mm": "m", "cm^3": "m^3", "degC": "K abs"}[text.split()[1]]) == value


NO_TEXTS = {"finite": (math.nan, math.inf, 10**400), "boolean": (True,), "a force is wanted": ([1],)}
NO_NUMBERS = [(each, "N", says) for says, values in NO_TEXTS.items() for each in values]


@pytest.mark.parametrize(("value", "unit", "says"), [*REFUSED["quantity"], *NO_NUMBERS])
def test_refused(value, unit, says):
    with pytest.raises(ValueError, match="give|or|finite") as error:
        parse_quantity(value, unit)
    assert says in str(error.value)


@given(st.text(CHARACTERS, max_size=12), st.sampled_from(sorted(EXAMPLES)))
def test_any_text_is_read_or_refused(text, unit):
    """The outcome is a number or a ValueError, whatever pint makes of the text."""
    for candidate in (text, f"5 {text}"):
        try:
            assert math.isfinite(parse_quantity(candidate, unit))
        except ValueError as error:
            assert str(error)


PINT_UNITS = (Path(__file__).parents[1] / "data" / "units.txt").read_text(encoding="utf-8")
REFEREE = pint.UnitRegistry(PINT_UNITS.splitlines(), non_int_type=Decimal)
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
    """Random products of units, completed to the dimension of a field: both give the same number, or refuse it."""
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
