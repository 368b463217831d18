"""Specs as they are written for people: units, comments, no digits but those that count."""

import re
import tomllib

import pytest
from conftest import CONFIGS, WANTED
from hypothesis import given
from hypothesis import strategies as st
from sources import READ
from strategies import direct_specs, indirect_specs

from afmcalc.engines import build
from afmcalc.errors import SpecError
from afmcalc.spec import make_spec, read_spec, resolved, to_toml
from afmcalc.spec.edit import as_written
from afmcalc.spec.keys import keys
from afmcalc.spec.parse import Source, example_names
from afmcalc.spec.quantity import parse_quantity
from afmcalc.spec.write import WRITTEN

LINE = re.compile(r"(?P<key>\w+) = (?P<value>.+?)\s+# .+")


@given(st.one_of(direct_specs(), indirect_specs()))
def test_a_written_spec_has_few_digits_and_answers_the_same(spec):
    text = to_toml(resolved(spec))
    digits = [each.replace(".", "").lstrip("0") for each in re.findall(r"\d+\.?\d*", re.sub(r"#.*", "", text))]
    assert max(map(len, digits)) <= 12
    again = make_spec(tomllib.loads(text))
    assert again == as_written(spec) == as_written(again)
    before, after = build(spec), build(again)
    for own, old in zip(after.spec.friction.groups, before.spec.friction.groups, strict=True):
        assert own == pytest.approx(old, rel=1e-11)
    for name in ("nominal_torque", "torque_max", "accuracy_factor", "reduced_gain"):
        assert getattr(after, name) == pytest.approx(getattr(before, name), rel=1e-8), name


@pytest.mark.parametrize("name", sorted(set(example_names()) - WANTED))
def test_every_key_has_its_unit_and_says_what_it_is(name):
    text = to_toml(resolved(read_spec(CONFIGS / f"{name}.toml")), "What it is.")
    assert text.startswith("# What it is.\n# A quantity is a number in SI or a string with a unit")
    table = ""
    for line in filter(None, text.splitlines()[2:]):
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
