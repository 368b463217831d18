"""The spec: examples, round trips, every rule."""

import json
import tomllib

import pytest
from conftest import CONFIGS, WANTED
from sources import REFUSED

from afmcalc.errors import AfmcalcError, SpecError
from afmcalc.spec import Spec, make_spec, read_spec, resolved, to_toml
from afmcalc.spec.fields import keys_below
from afmcalc.spec.read import put

EXAMPLES = sorted(path for path in CONFIGS.glob("*.toml") if path.stem not in WANTED)
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


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
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
