"""The spec: examples, round trips, every rule."""

import json
import math
import re
import tomllib

import pytest
import tomli_w
from conftest import CONFIGS, S21, WANTED
from hypothesis import given
from pydantic import TypeAdapter, ValidationError
from sources import REFUSED
from strategies import direct_specs

from afmcalc.analysis.clutch_findings import clutch_findings
from afmcalc.engines import build
from afmcalc.errors import AfmcalcError, FileError, SpecError
from afmcalc.spec import Spec, make_spec, models, read_spec, resolved, to_toml
from afmcalc.spec.catalogues import friction_materials
from afmcalc.spec.edit import put
from afmcalc.spec.fields import keys_below
from afmcalc.spec.parse import parse
from afmcalc.spec.requirements import Requirements, make_requirements
from afmcalc.spec.source import Source

EXAMPLES = sorted(path for path in CONFIGS.glob("*.toml") if path.stem not in WANTED)
BASE = tomllib.loads((CONFIGS / "default.toml").read_text())


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


@given(direct_specs())
def test_round_trip_keeps_every_result(spec):
    """Through JSON and TOML text the clutch answers to the last bit as before."""
    data = resolved(spec)
    first, second = build(spec).friction
    for text in (json.dumps(data), tomli_w.dumps(data)):
        again = build(make_spec(parse(Source("text", text))))
        assert again.torque(first.max, second.max) == build(spec).torque(first.max, second.max)
        assert again.accuracy_factor_worst_case == build(spec).accuracy_factor_worst_case
        assert again.friction == build(spec).friction


def test_defaults():
    spec = make_spec(changed(friction__mean=None, friction_group__driving_pairs=None, adjustment=None))
    data = resolved(spec)
    assert spec.friction.range.mean == (0.1 + 0.8) / 2
    assert data["friction"] == {"min": 0.1, "max": 0.8}, "what follows from other keys stays free to follow"
    assert data["friction_group"]["driving_pairs"] == 1
    assert data["adjustment"] == {"method": "min-friction", "margin": 1.0}


def test_radius_models():
    two = {
        "friction_group__mean_radius": None,
        "friction_group__inner_radius": 0.08,
        "friction_group__outer_radius": 0.12,
    }
    assert build(make_spec(changed(**two))).mean_radius == pytest.approx(0.1)
    pressed = build(make_spec(changed(**two, friction_group__radius_model="uniform-pressure"))).mean_radius
    assert pressed == pytest.approx(2 / 3 * (0.12**3 - 0.08**3) / (0.12**2 - 0.08**2), rel=1e-14)


def test_material_gives_the_range_and_is_echoed():
    spec = make_spec(changed(friction={"material": "moulded-dry"}))
    assert spec.friction.range == (0.25, 0.35, 0.45)
    (finding,) = [f for f in clutch_findings(spec, build(spec).quantities) if f.code == "material"]
    assert "0.25…0.45" in finding.message
    assert "Juvinall" in finding.message
    assert resolved(make_spec(resolved(spec))) == resolved(spec)


def test_catalogue_entries_have_sources_and_ordered_ranges():
    assert len(friction_materials()) == 13
    for entry in friction_materials().values():
        assert entry.source
        assert 0 < entry.friction_min < entry.friction_max < 1
        for low, high in ((entry.pressure_min, entry.pressure_max), (entry.temperature_min, entry.temperature_max)):
            assert (low is None) == (high is None)
            assert low is None or low <= high
        assert (entry.condition == "dry") == (entry.pressure_max is not None)


@pytest.mark.parametrize(("changes", "path", "value", "says"), REFUSED["spec"])
def test_bad_input_names_file_key_value_and_what_is_allowed(changes, path, value, says):
    with pytest.raises(SpecError) as told:
        make_spec(changed(**{key: None if value == "none" else value for key, value in changes.items()}), "bad.toml")
    problems = [each for each in told.value.problems if each.path == path and says in each.message]
    assert problems, told.value
    assert not value or problems[0].given == value
    assert all(line.startswith("bad.toml: ") for line in str(told.value).splitlines())
    assert not re.search("Field|Input should|pydantic", str(told.value))


def fields_of_each_unit():
    """Three keys of each unit of a spec and of requirements."""
    for make, model in ((make_spec, Spec), (make_requirements, Requirements)):
        by_unit = {}
        for key in keys_below(model).values():
            by_unit.setdefault(key.unit, []).append(key.path)
        for unit, paths in by_unit.items():
            yield from ((make, unit, path) for path in {paths[0], paths[len(paths) // 2], paths[-1]} if unit)


def test_a_wrong_dimension_is_refused_in_every_unit():
    def problems(make, path, value):
        with pytest.raises(SpecError) as told:
            make(at(path, value))
        return {each.message for each in told.value.problems if each.path == path}

    for make, unit, path in fields_of_each_unit():
        for wrong in {"kg": "N", "N*m": "J", "J": "N*m"}.get(unit, "kg"), "mm^4":
            assert problems(make, path, f"3 {wrong}") - problems(make, path, 3), (path, wrong)


@pytest.mark.parametrize(
    ("line", "changes"),
    [
        ("torque", {"control_unit__gain": 0.01}), ("accuracy --sweep C=0.01:0.02:3", {}), ("tolerance", {}),
        ("solve --for C accuracy_factor=2", {"control_unit__gain": 0.01}), ("explain life", {"fatigue": None}), ("life", {"fatigue": None}),
    ],
)  # fmt: skip
def test_what_a_calculation_finds_wrong_names_the_file(line, changes, tmp_path, afmcalc):
    file = tmp_path / "some.toml"
    data = tomllib.loads(S21.read_text(encoding="utf-8"))
    for path, value in changes.items():
        put(data, path.replace("__", "."), value)
    file.write_text(tomli_w.dumps(data), encoding="utf-8")
    run = afmcalc(*line.split(), file)
    where = "sweep at control_unit.gain = 0.01" if "--sweep" in line else str(file)
    assert (run.code, bool(re.match(rf"error: {re.escape(where)}(:\d+:\d+)?: ", run.err))) == (2, True), run.err


def test_a_title_block_takes_text_and_a_revision_and_a_date_without_quotes():
    text = 'organisation = "ООО «Муфта»"\nrevision = 2\ndate = 2026-01-31\n'
    data = resolved(make_spec(changed(report=tomllib.loads(text))))
    assert data["report"] == {"organisation": "ООО «Муфта»", "revision": "2", "date": "2026-01-31"}
    assert resolved(make_spec(tomllib.loads(to_toml(data)))) == data


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "is empty"), ("variant =", "not valid TOML"), ("{", "not valid JSON"), ('{"a": 1, "a": 2}', "stands twice"),
        ("a = 1\na = 2", "not valid TOML"), ('{"command": "x", "result": {}, "spec": null}', "carries no clutch"),
        ('{"spec": [1]}', "spec block is no object"), ("a = " + "1" * 5000, "too many digits"), ('{"a": ' + "1" * 5000 + "}", "too many digits"),
        ("[" * 100_000, "TOML"), ('{"a":' * 100_000, "nested more than 32 levels"),
    ],
)  # fmt: skip
def test_text_that_is_no_spec(text, says):
    with pytest.raises(AfmcalcError, match=says):
        parse(Source("text", text))


def test_files_that_cannot_be_read(tmp_path):
    for path in (tmp_path / "missing.toml", tmp_path):
        with pytest.raises(FileError, match="cannot be read"):
            read_spec(path)


def test_overrides():
    spec = read_spec(None, ["C=0.75", "closing_spring.force=5 kN", "friction.mean=", "name=other"])
    assert spec.control_unit.gain == 0.75
    assert spec.closing_spring.force == 5000.0
    assert spec.friction.range.mean == pytest.approx(0.45)
    assert spec.name == "other"
    for bad in ("C", "=3", "variant.x=1", "foo=", "friction.foo=", ".=1"):
        with pytest.raises(AfmcalcError, match="--set"):
            read_spec(None, [bad])
    with pytest.raises(AfmcalcError, match="did you mean 'gain'"):
        read_spec(None, ["control_unit.gian=1"])


@pytest.mark.parametrize(
    ("kinds", "within", "beyond"),
    [
        ((models.Coefficient, models.Force, models.Length, models.Torque, models.Stiffness, models.Stress, models.Time),
         [1e-12, 0.5, 1e12], [0, -1e-12]),
        ((models.Ratio, models.Gap, models.TorqueOrNone, models.StiffnessOrNone, models.TimeOrNone), [0, 0.5], [-1e-12]),
        ((models.AtLeastOne,), [1, 1.5], [0.999]),
        ((models.Count,), [1, 2], [0, -1, 1.5]),
        ((models.WallAngle,), [0, 0.5, 1.5707], [-1e-12, 1.5708]),
        ((models.Temperature,), [173.15, 293.15], [173.1]),
    ],
)  # fmt: skip
def test_a_number_is_within_the_bounds_of_its_kind(kinds, within, beyond):
    for kind in kinds:
        read = TypeAdapter(kind).validate_python
        assert [read(value) for value in within] == within
        for value in beyond:
            with pytest.raises(ValidationError):
                read(value)


def test_a_table_is_not_shadowed_by_a_key_of_its_name():
    given = (
        'tolerance={fields={friction={distribution="uniform"}}}',
        'drawing={tolerance="H7", material=20}',
        "hardness=58…62 HRC",
    )
    spec = read_spec(CONFIGS / "default.toml", given)
    assert list(spec.tolerance.fields) == ["friction"]
    assert spec.drawing.model_dump(exclude_none=True) == {"tolerance": "H7", "material": "20", "hardness": "58…62 HRC"}


def wanted(**changes):
    data = tomllib.loads((CONFIGS / "requirements.toml").read_text(encoding="utf-8"))
    for path, value in changes.items():
        put(data, path.replace("__", "."), value)
    return make_requirements(data)


def test_a_shaft_yields_at_the_torque_that_reaches_it():
    """That of the clutch times the dynamic factor, where no event is simulated that has the peaks itself."""
    shaft = {"shaft__diameter": "40 mm", "shaft__yield_strength": "300 MPa"}
    static = wanted(**shaft).shaft_torque
    assert static == pytest.approx(300e6 / math.sqrt(3) * math.pi * 0.04**3 / 16)
    assert wanted(**shaft, drive__dynamic_factor=2).shaft_torque == pytest.approx(static / 2)
    drive = tomllib.loads((CONFIGS / "drive.toml").read_text(encoding="utf-8"))["drive"] | {"dynamic_factor": 2}
    assert wanted(**shaft, drive=drive).shaft_torque == pytest.approx(static)


def test_a_wanted_contact_pressure_never_raises_that_of_the_material():
    steel = dict(ball_modulus=206e9, ball_poisson=0.3, wall_modulus=206e9, wall_poisson=0.3, allowable_pressure=3e9)  # noqa: C408
    for pressure, least in ((None, 3e9), (2e9, 2e9), (4e9, 3e9)):
        assert wanted(fixed__contact=steel, wanted__contact_pressure=pressure).bearing.allowable_pressure == least
    assert wanted(wanted__contact_pressure=5e9).bearing.allowable_pressure == 4.2e9  # hardened steel, ISO 76
