"""The spec: examples, round trips, every rule."""

import json
import re
import tomllib

import pytest
import tomli_w
from conftest import CONFIGS, S21, WANTED
from hypothesis import given
from pydantic import TypeAdapter, ValidationError
from strategies import direct_specs

from afmcalc.engines import build
from afmcalc.errors import AfmcalcError, FileError, SpecError
from afmcalc.spec import make_spec, models, read_spec, resolved, to_toml
from afmcalc.spec.catalogues import friction_materials
from afmcalc.spec.edit import put
from afmcalc.spec.parse import parse
from afmcalc.spec.source import Source

EXAMPLES = sorted(path for path in CONFIGS.glob("*.toml") if path.stem not in WANTED)
BASE = tomllib.loads((CONFIGS / "default.toml").read_text())


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
    (finding,) = [f for f in build(spec).findings() if f.code == "material"]
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


BAD = {
    "energy in a force field": ({"closing_spring__force": "5 J"}, "closing_spring.force", '"5 J"', "energy"),
    "misspelt unit": ({"closing_spring__force": "5 kn"}, "closing_spring.force", '"5 kn"', "did you mean 'kN'"),
    "unknown key": ({"friction__maxx": 1}, "friction.maxx", "1", "did you mean 'max'"),
    "key of another block": ({"gain": 1}, "gain", "1", "did you mean control_unit.gain"),
    "unknown block": ({"frction": {"min": 1}}, "frction", "", "did you mean 'friction'"),
    "min over max": ({"friction__mean": None, "friction__min": 0.9}, "friction.max", "0.8", "not be below min (0.9)"),
    "mean over max": ({"friction__mean": 0.9}, "friction.mean", "0.9", "not be above max"),
    "mean under min": ({"friction__mean": 0.05}, "friction.mean", "0.05", "not be below min"),
    "no friction": ({"friction__min": 0}, "friction.min", "0", "greater than 0"),
    "no pairs": ({"friction_group__pairs": 0}, "friction_group.pairs", "0", "at least 1"),
    "half a pair": ({"friction_group__pairs": 2.5}, "friction_group.pairs", "2.5", "whole"),
    "all pairs driving": ({"friction_group__driving_pairs": 8}, "friction_group.driving_pairs", "8", "less than"),
    "one pair only": (
        {"friction_group__driving_pairs": None, "friction_group__pairs": 1},
        "friction_group.pairs",
        "1",
        "at least 2",
    ),
    "negative spring": ({"closing_spring__force": -1}, "closing_spring.force", "-1", "greater than 0"),
    "nan": ({"closing_spring__force": float("nan")}, "closing_spring.force", "NaN", "finite"),
    "inf": ({"closing_spring__force": float("inf")}, "closing_spring.force", "Infinity", "finite"),
    "boolean": ({"closing_spring__force": True}, "closing_spring.force", "true", "boolean"),
    "boolean count": ({"friction_group__pairs": True}, "friction_group.pairs", "true", "whole"),
    "both gains": (
        {"control_unit__wall_angle": "10 deg"},
        "control_unit.wall_angle",
        '"10 deg"',
        "excludes control_unit.gain",
    ),
    "no gain": ({"control_unit__gain": None}, "control_unit.gain", "", "required (or give wall_angle"),
    "angle without radius": (
        {"control_unit__gain": None, "control_unit__wall_angle": 0.2, "control_unit__ball_circle_radius": None},
        "control_unit.ball_circle_radius",
        "",
        "required beside",
    ),
    "right angle": (
        {"control_unit__gain": None, "control_unit__wall_angle": "90 deg"},
        "control_unit.wall_angle",
        '"90 deg"',
        "less than 90 deg",
    ),
    "both radii": ({"friction_group__inner_radius": 0.1}, "friction_group.inner_radius", "0.1", "excludes"),
    "no radius": ({"friction_group__mean_radius": None}, "friction_group.mean_radius", "", "required (or give"),
    "one radius": (
        {"friction_group__mean_radius": None, "friction_group__inner_radius": 0.1},
        "friction_group.outer_radius",
        "",
        "required beside",
    ),
    "radii inverted": (
        {"friction_group__mean_radius": None, "friction_group__inner_radius": 0.2, "friction_group__outer_radius": 0.1},
        "friction_group.outer_radius",
        "0.1",
        "greater than friction_group.inner_radius",
    ),
    "radii equal": (
        {"friction_group__mean_radius": None, "friction_group__inner_radius": 0.1, "friction_group__outer_radius": 0.1},
        "friction_group.outer_radius",
        "0.1",
        "greater than friction_group.inner_radius",
    ),
    "neither force nor torque": (
        {"closing_spring__force": None},
        "closing_spring.force",
        "",
        "adjustment.nominal_torque",
    ),
    "friction twice": (
        {"friction__driving": {"min": 0.1, "max": 0.2}, "friction__driven": {"min": 0.1, "max": 0.2}},
        "friction.min",
        "0.1",
        "not both",
    ),
    "one group": ({"friction": {"driving": {"min": 0.1, "max": 0.2}}}, "friction.driven", "", "required beside"),
    "material and range": ({"friction__material": "moulded-dry"}, "friction.min", "0.1", "excludes material"),
    "unknown material": ({"friction": {"material": "molded-dry"}}, "friction.material", '"molded-dry"', "moulded-dry"),
    "no max": ({"friction__max": None}, "friction.max", "", "required"),
    "no friction block": ({"friction": None}, "friction", "", "required"),
    "misspelt variant": ({"variant": "diferentiated"}, "variant", '"diferentiated"', "did you mean 'differentiated'"),
    "variant missing": ({"variant": None}, "variant", "", "one of conventional, differentiated, all-driving, indirect"),
    "control unit on an ordinary clutch": ({"variant": "conventional"}, "control_unit", "", "not for variant"),
    "control spring on a direct clutch": (
        {"control_spring": {"stiffness": 1}},
        "control_spring",
        "",
        "only for indirect",
    ),
    "temperature without a unit": ({"heat": {"ambient": 20}}, "heat.ambient", "20", "at least 173.15"),
    "mass for a temperature": ({"heat": {"ambient": "20 kg"}}, "heat.ambient", '"20 kg"', "no unit of a temperature"),
    "half a lining": ({"heat": {"lining_density": 2e3}}, "heat.lining_conductivity", "", "beside heat.lining_density"),
    "driving pairs all-driving": ({"variant": "all-driving"}, "friction_group.driving_pairs", "1", "only for differ"),
    "indirect lacks its keys": (
        {"variant": "indirect", "friction_group__driving_pairs": None},
        "control_spring",
        "",
        "required for variant",
    ),
    "block that is a number": ({"friction": 3}, "friction", "3", "must be a table with the keys"),
    "margin below 1": ({"adjustment__margin": 0.9}, "adjustment.margin", "0.9", "at least 1"),
    "control characters in a name": ({"name": "\x1b[31mred"}, "name", "", "printable"),
    "poisson over a half": (
        {"control_unit__contact": {"ball_poisson": 0.7}},
        "control_unit.contact.ball_poisson",
        "0.7",
        "at most 0.5",
    ),
    "name that is a number": ({"name": 3}, "name", "3", "text"),
    "revision that is a fraction": ({"report__revision": 1.5}, "report.revision", "1.5", "text"),
    "truth of an author": ({"report__author": True}, "report.author", "true", "text"),
    "title block of two lines": ({"report__project": "a\nb"}, "report.project", "", "printable"),
}


@pytest.mark.parametrize("case", BAD, ids=BAD)
def test_bad_input_names_file_key_value_and_what_is_allowed(case, tmp_path, afmcalc):
    changes, path, value, says = BAD[case]
    file = tmp_path / "bad.toml"
    file.write_text(tomli_w.dumps(changed(**changes)), encoding="utf-8")
    run = afmcalc("torque", file, "--output", tmp_path / "out")
    assert (run.code, run.out) == (2, "")
    assert not (tmp_path / "out").exists()
    wanted = f"{path} = {value}" if value else path
    lines = [line for line in run.err.splitlines() if wanted in line]
    assert any(says in line and str(file) in line for line in lines), run.err


def test_a_spec_knows_where_it_was_read_and_is_no_other_for_it():
    here, there = make_spec(BASE, "here.toml"), make_spec(BASE, "there.toml")
    assert (here.label, there.label, make_spec(BASE).label) == ("here.toml", "there.toml", "spec")
    assert here == there
    assert here.model_dump() == there.model_dump()
    assert here.model_dump_json() == there.model_dump_json()
    assert "here" not in repr(here)
    assert here.model_copy(update={"name": "copy"}).label == "here.toml"
    assert here != make_spec(changed(name="another"), "here.toml")


@pytest.mark.parametrize(
    ("command", "changes"),
    [
        (["torque"], {"control_unit__gain": 0.01}),
        (["accuracy", "--sweep", "C=0.01:0.02:3"], {}),
        (["solve", "--for", "C", "accuracy_factor=2"], {"control_unit__gain": 0.01}),
        (["explain", "life"], {"fatigue": None}),
        (["life"], {"fatigue": None}),
        (["synthesize"], {"control_unit__ball_circle_radius": None}),
        (["tolerance"], {}),
    ],
)
def test_what_a_calculation_finds_wrong_names_the_file(command, changes, tmp_path, afmcalc):
    file = tmp_path / "some.toml"
    data = tomllib.loads((S21).read_text(encoding="utf-8"))
    for path, value in changes.items():
        put(data, path.replace("__", "."), value)
    file.write_text(tomli_w.dumps(data), encoding="utf-8")
    run = afmcalc(*command, file)
    assert run.code == 2
    where = "sweep at control_unit.gain = 0.01" if "--sweep" in command else str(file)
    assert re.match(rf"error: {re.escape(where)}(:\d+:\d+)?: ", run.err), run.err


def test_a_title_block_takes_text_and_a_revision_and_a_date_without_quotes():
    text = 'organisation = "ООО «Муфта»"\nrevision = 2\ndate = 2026-01-31\n'
    data = resolved(make_spec(changed(report=tomllib.loads(text))))
    assert data["report"] == {"organisation": "ООО «Муфта»", "revision": "2", "date": "2026-01-31"}
    assert resolved(make_spec(tomllib.loads(to_toml(data)))) == data


def test_every_problem_is_shown_at_once():
    data = changed(friction__maxx=1, friction_group__pairs=0, closing_spring__force=None, control_unit__wall_angle=0.1)
    with pytest.raises(SpecError) as error:
        make_spec(data, "x.toml")
    paths = {problem.path for problem in error.value.problems}
    assert paths == {
        "friction.maxx",
        "friction_group.pairs",
        "closing_spring.force",
        "control_unit.wall_angle",
        "friction_group.driving_pairs",
    }
    assert all(line.startswith("x.toml: ") for line in str(error.value).splitlines())


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "is empty"),
        ("variant =", "not valid TOML"),
        ("{", "not valid JSON"),
        ('{"a": 1, "a": 2}', "stands twice"),
        ("a = 1\na = 2", "not valid TOML"),
        ('{"command": "x", "result": {}, "spec": null}', "carries no clutch"),
        ('{"spec": [1]}', "spec block is no object"),
        ("a = " + "1" * 5000, "too many digits"),
        ('{"a": ' + "1" * 5000 + "}", "too many digits"),
        ("[" * 100_000, "TOML"),
        ('{"a":' * 100_000, "nested more than 32 levels"),
    ],
)
def test_text_that_is_no_spec(text, says):
    with pytest.raises(AfmcalcError, match=says):
        parse(Source("text", text))


def test_files_that_cannot_be_read(tmp_path):
    for path in (tmp_path / "missing.toml", tmp_path):
        with pytest.raises(FileError, match="cannot be read"):
            read_spec(path)
    (tmp_path / "latin").write_bytes(b"name = '\xe9'")
    with pytest.raises(AfmcalcError, match="not UTF-8"):
        read_spec(tmp_path / "latin")
    (tmp_path / "bom.toml").write_bytes(b"\xef\xbb\xbf" + (CONFIGS / "default.toml").read_bytes())
    assert read_spec(tmp_path / "bom.toml") == read_spec()


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
