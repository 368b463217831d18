"""Lists of one's own: friction materials, disc springs, balls; and the names that materials are read by."""

import json

import pytest
from conftest import CONFIGS

from afmcalc.analysis.clutch_findings import clutch_findings
from afmcalc.engines import build
from afmcalc.errors import AfmcalcError
from afmcalc.spec import make_spec, read_spec, resolved
from afmcalc.spec.catalogues import friction_materials, material_named
from afmcalc.spec.lists import discs
from afmcalc.spec.lists import friction_materials as own_materials

CSV = """# from the works' laboratory
name,description,condition,friction_min,friction_max,pressure_min_kPa,pressure_max_MPa,temperature_min_C,temperature_max,source,also
F1,felt,dry,0.2,0.3,50,0.08,90,368.15 K,Test 12,войлок; felt pad
F2,resin,in oil,0.05,0.1,,,,,Maker's sheet,
"""
TOML = """
[materials.F1]
description = "felt"
condition = "dry"
friction = [0.2, 0.3]
pressure = ["50 kPa", "80 kPa"]
temperature_C = [90, 95]
source = "Test 12"
also = ["войлок", "felt pad"]
[materials.F2]
description = "resin"
condition = "in oil"
friction_min = 0.05
friction_max = 0.1
source = "Maker's sheet"
"""
NO_RANGE = {"friction.min": None, "friction.mean": None, "friction.max": None}


def file(folder, name, text):
    (folder / name).write_text(text, encoding="utf-8")
    return str(folder / name)


def test_materials_of_ones_own_in_both_forms(tmp_path):
    listed = own_materials(file(tmp_path, "own.csv", CSV))
    assert [*listed] == ["F1", "F2"]
    assert listed["F1"][1:11] == ("felt", "dry", 0.2, 0.3, 50e3, 80e3, 90, 95, "Test 12", "Test 12")
    assert listed["F2"][5:9] == (None, None, None, None)
    assert own_materials(file(tmp_path, "own.toml", TOML)) == listed


ROW = CSV.splitlines()[2]
WRONG = {
    "no source": (ROW.replace("Test 12", ""), "F1: source: required"),
    "no friction": (ROW.replace("0.2,0.3", ",0.3"), "F1: friction_min: required"),
    "ends": (ROW.replace("0.2,0.3", "0.3,0.2"), "the lower one first"),
    "one end": (ROW.replace("0.08", ""), "pressure_min and pressure_max: both"),
    "condition": (ROW.replace("dry", "wet"), 'condition = "wet": must be one of dry, in oil'),
    "unit": (ROW.replace("368.15 K", "368.15 m"), 'temperature_max = "368.15 m"'),
    "negative": (ROW.replace(",50,", ",-50,"), 'pressure_min = "-50 kPa": must be greater than 0'),
    "twice": (f"{ROW}\n{ROW}", "a name of its own"),
    "other name twice": (f"{ROW}\n{ROW.replace('F1', 'F3')}", "F3: every row has a name of its own"),
    "a sign that is none": (ROW.replace("felt pad", "felt\x1bpad"), "printable"),
    "cells beyond the heading": (ROW + ",,x", '["", "x"]: unknown key'),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_with_a_row_is_said_in_one_sentence(case, tmp_path, afmcalc):
    text, says = WRONG[case]
    path = file(tmp_path, "own.csv", "\n".join([*CSV.splitlines()[:2], text]))
    with pytest.raises(AfmcalcError, match="own.csv") as told:
        own_materials(path)
    assert says in str(told.value)
    run = afmcalc("torque", CONFIGS / "default.toml", "--materials", path, "-o", tmp_path / "out.json")
    assert (run.code, run.out, (tmp_path / "out.json").exists()) == (2, "", False)
    assert "own.csv" in run.err
    assert says in run.err


def test_a_heading_that_is_not_known_and_a_list_that_is_none(tmp_path):
    for name, text, says in (
        ("a.csv", CSV.replace("condition,", "conditon,"), "did you mean 'condition'"),
        ("b.csv", CSV.replace("_MPa", "_mm"), 'pressure_max = "0.08 mm"'),
        ("c.csv", CSV.splitlines()[1], "is no list of materials"),
        ("d.toml", TOML.replace("[materials.", "[material."), "is no list of materials"),
    ):
        with pytest.raises(AfmcalcError, match=name) as told:
            own_materials(file(tmp_path, name, text))
        assert says in str(told.value)


@pytest.mark.parametrize(
    ("row", "names"),
    [
        ("metal-dry", ("чугун", "закаленная  Сталь", "сч 20", "EN GJL 250", "Cast iron")),
        ("metal-oil", ("Чугун в масле",)), ("sintered-dry", ("металлокерамика",)), ("cork-dry", ("пробка",)),
    ],
)  # fmt: skip
def test_names_that_are_read(row, names):
    assert [material_named(name, friction_materials()).name for name in names] == [row] * len(names)


def test_no_name_stands_for_two_materials():
    names = [each for row in friction_materials().values() for each in (row.name, *row.also)]
    for each in names:
        row = material_named(each, friction_materials())
        assert each in (row.name, *row.also)


def test_what_a_name_is_read_as_is_said():
    spec = read_spec(CONFIGS / "default.toml", NO_RANGE | {"friction.material": "чугун"})
    assert spec.friction.range == (0.15, 0.2, 0.25)
    (told,) = (each for each in clutch_findings(spec, build(spec).quantities) if each.code == "material")
    assert "чугун is read as metal-dry (cast iron or hard steel, dry)" in told.message
    assert make_spec(resolved(spec)) == spec


def test_of_several_materials_a_clutch_has_the_worst_in_everything():
    faces = {
        "friction_group.mean_radius": None,
        "friction_group.inner_radius": "80 mm",
        "friction_group.outer_radius": "120 mm",
    }
    given = NO_RANGE | faces | {"friction.unknown": True}
    several = ["cork-dry", "sintered-dry", "wood-dry"]
    spec = read_spec(CONFIGS / "default.toml", given | {"friction.material": several})
    assert spec.friction.range == (0.15, 0.325, 0.5)
    (told,) = (each for each in clutch_findings(spec, build(spec).quantities) if each.code == "lining-unknown")
    assert "cork-dry, sintered-dry, wood-dry" in told.message
    alone = [friction_materials()[name] for name in several]
    for names, rows in ((several, alone), (several[1::-1], alone[1::-1])):
        lining = read_spec(CONFIGS / "default.toml", given | {"friction.material": names}).friction.linings[
            "friction.material"
        ]
        assert lining.friction_max == max(row.friction_max for row in rows)
        for limit in ("friction_min", "pressure_min", "pressure_max", "temperature_min", "temperature_max"):
            assert getattr(lining, limit) == min(getattr(row, limit) for row in rows), limit


def test_materials_that_contradict_each_other(afmcalc):
    removed = [f"--set={key}=" for key in NO_RANGE]
    for several, says in (
        (["чугун", "чугун в масле"], "contradict each other (чугун: dry, чугун в масле: in oil)"),
        (["cork-dry", "corc"], "unknown material"),
        (["cork-dry", "cork-dry"], "each once"),
        ([], "or a list of such names"),
    ):
        run = afmcalc("torque", *removed, f"--set=friction.material={json.dumps(several, ensure_ascii=False)}")
        assert (run.code, run.out) == (2, "")
        assert "friction.material" in run.err
        assert says in run.err
    run = afmcalc("torque", *removed, "--set=friction.material=cork-dry", "--set=friction.unknown=true")
    assert (run.code, "friction.unknown" in run.err) == (2, True)


DISCS = """name,outer_diameter_mm,inner_diameter_mm,thickness_mm,reduced_thickness_mm,free_height_mm,source
X 50,50,25.4,2,,3.4,Maker's list
X 60,60,30.5,2.5,,4.25,Maker's list
"""


def test_paths_are_relative_to_the_file_that_names_them(tmp_path, afmcalc, monkeypatch):
    (tmp_path / "lists").mkdir()
    (tmp_path / "picked").mkdir()
    file(tmp_path / "lists", "own.csv", CSV)
    file(tmp_path / "lists", "discs.csv", DISCS)
    file(tmp_path / "lists", "balls.csv", "diameter_mm\n7\n23\n90\n")
    spec = (CONFIGS / "default.toml").read_text(encoding="utf-8").replace("min = 0.10", 'material = "войлок"')
    spec = "\n".join(line for line in spec.splitlines() if not line.startswith(("mean = ", "max = ")))
    named = '[catalogues]\nmaterials = "lists/own.csv"\ndiscs = "lists/discs.csv"\nballs = "lists/balls.csv"\n'
    path = file(tmp_path, "clutch.toml", f"{spec}\n{named}")
    monkeypatch.chdir(tmp_path / "picked")
    told = json.loads(afmcalc("synthesize", path, "--json").out)
    assert told["result"]["ball_diameter_standard"] in (0.007, 0.023, 0.09)
    afmcalc("synthesize", path, "-o", "completed.toml")
    assert 'materials = "../lists/own.csv"' in (tmp_path / "picked" / "completed.toml").read_text(encoding="utf-8")
    again = read_spec(tmp_path / "picked" / "completed.toml")
    assert again.friction.range == (0.2, 0.25, 0.3)
    assert again.lists == read_spec(path).lists
    piped = afmcalc("torque", "-", "--json", stdin=afmcalc("torque", path, "--json").out)
    assert json.loads(piped.out)["result"] == json.loads(afmcalc("torque", path, "--json").out)["result"]
    file(tmp_path / "lists", "works' own.csv", "diameter_mm\n7\n23\n90\n")
    by_option = afmcalc("synthesize", CONFIGS / "default.toml", "--balls", "../lists/works' own.csv", "--json")
    assert json.loads(by_option.out)["result"]["ball_diameter_standard"] in (0.007, 0.023, 0.09)


def test_a_disc_of_ones_own_is_called_by_its_designation(tmp_path, afmcalc):
    heading, *rows = DISCS.splitlines()
    listed = "\n".join([f"{heading},designation", f"{rows[0]},Пружина 50х25 ТУ 1", f"{rows[1]},"])
    path = file(tmp_path, "discs.csv", listed)
    assert [each.title for each in discs(path)] == ["Пружина 50х25 ТУ 1", "X 60 (Maker's list)"]
    asked = "springs", CONFIGS / "default.toml", "--discs", path, "--kind", "disc"
    parts = [each["part"] for each in json.loads(afmcalc(*asked, "--json").out)["result"]["closing"]]
    number = parts.index("Пружина 50х25 ТУ 1") + 1
    sprung = tmp_path / "sprung.toml"
    assert afmcalc(*asked, "--pick", number, "-o", sprung).code == 0
    assert "Пружина 50х25 ТУ 1" in afmcalc("springs", sprung).out
    twice = file(tmp_path, "twice.csv", f"{listed}Пружина 50х25 ТУ 1")
    with pytest.raises(AfmcalcError, match="X 60: every row has a name of its own"):
        discs(twice)


def test_disc_springs_of_ones_own(tmp_path, afmcalc):
    path = file(tmp_path, "discs.csv", DISCS)
    first, second = discs(path)
    assert first[:7] == ("X 50", 0.05, 0.0254, 0.002, None, 0.0034, None)
    asked = ("springs", CONFIGS / "default.toml", "--discs", path, "--kind", "disc")
    run = afmcalc(*asked, "--json")
    parts = {each["part"] for each in json.loads(run.out)["result"]["closing"]}
    assert parts
    assert parts <= {f"{each.name} (Maker's list)" for each in (first, second)}
    picked = afmcalc(*asked, "--pick", "1", "-o", tmp_path / "sprung.toml")
    assert picked.code == 0, picked.err
    sprung = read_spec(tmp_path / "sprung.toml")
    assert sprung.closing_spring.disc.thickness in (first.thickness, second.thickness)
    assert sprung.catalogues.discs == path
    flat = file(tmp_path, "flat.csv", DISCS.replace("3.4", "2"))
    with pytest.raises(AfmcalcError, match="X 50: free_height .* must be greater than thickness"):
        discs(flat)
