"""Lists: friction materials and their names, disc springs, balls (ISO 3290-1); those that ship and those of a user."""

import json

import pytest
from conftest import CONFIGS
from sources import DATA, READ, REFUSED

from afmcalc.analysis.clutch_findings import clutch_findings
from afmcalc.engines import build
from afmcalc.errors import AfmcalcError
from afmcalc.messages import language, speaking
from afmcalc.spec import make_spec, read_spec, resolved
from afmcalc.spec.catalogues import (
    ball_designation,
    balls,
    balls_in,
    discs_in,
    friction_materials,
    material_named,
    materials_in,
)

CSV, TOML = ((DATA / f"materials.{form}").read_text(encoding="utf-8") for form in ("csv", "toml"))
NO_RANGE = {"friction.min": None, "friction.mean": None, "friction.max": None}


def file(folder, name, text):
    (folder / name).write_text(text, encoding="utf-8")
    return str(folder / name)


def test_materials_of_ones_own_in_both_forms(tmp_path):
    listed = materials_in(file(tmp_path, "own.csv", CSV))
    assert [*listed] == ["F1", "F2"]
    said = {"description": "felt", "condition": "dry", "friction_min": 0.2, "friction_max": 0.3, "pressure_min": 50e3}
    said |= {"pressure_max": 80e3, "temperature_min": 90, "temperature_max": 95, "source": "Test 12"}
    assert said.items() <= listed["F1"].model_dump().items()
    assert not {"pressure_min", "pressure_max", "temperature_min", "temperature_max"} & listed["F2"].model_fields_set
    assert materials_in(file(tmp_path, "own.toml", TOML)) == listed


@pytest.mark.parametrize(("text", "says"), REFUSED["material"])
def test_what_is_wrong_with_a_row_is_said_in_one_sentence(text, says, tmp_path, afmcalc):
    path = file(tmp_path, "own.csv", "\n".join([*CSV.splitlines()[:2], text]))
    with pytest.raises(AfmcalcError, match="own.csv") as told:
        materials_in(path)
    assert says in str(told.value)
    run = afmcalc(
        "torque", CONFIGS / "default.toml", "--set", f"catalogues.materials={path}", "-o", tmp_path / "out.json"
    )
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
            materials_in(file(tmp_path, name, text))
        assert says in str(told.value)


NAMED = {
    "metal-dry": ("чугун", "закаленная  Сталь", "сч 20", "EN GJL 250", "Cast iron"),
    "metal-oil": ("Чугун в масле",), "sintered-dry": ("металлокерамика",), "cork-dry": ("пробка",),
}  # fmt: skip


def test_names_that_are_read_stand_for_one_material():
    rows = friction_materials()
    assert len(rows) == 13
    for name, names in (*NAMED.items(), *((row.name, (row.name, *row.also)) for row in rows.values())):
        assert [material_named(each, rows).name for each in names] == [name] * len(names)


def test_what_a_name_is_read_as_is_said():
    spec = read_spec(CONFIGS / "default.toml", NO_RANGE | {"friction.material": "чугун"})
    assert spec.friction.range == (0.15, 0.2, 0.25)
    (told,) = (each for each in clutch_findings(build(spec)) if each.code == "material")
    assert "чугун is read as metal-dry (cast iron or hard steel, dry)" in told.message
    assert make_spec(resolved(spec)) == spec


def test_of_several_materials_a_clutch_has_the_worst_in_everything():
    faces = {"mean_radius": None, "inner_radius": "80 mm", "outer_radius": "120 mm"}
    given = NO_RANGE | {f"friction_group.{key}": value for key, value in faces.items()}
    several = ["cork-dry", "sintered-dry", "wood-dry"]
    spec = read_spec(CONFIGS / "default.toml", given | {"friction.material": several})
    assert spec.friction.range == (0.15, 0.325, 0.5)
    (told,) = (each for each in clutch_findings(build(spec)) if each.code == "lining-unknown")
    assert "cork-dry, sintered-dry, wood-dry" in told.message
    alone = [friction_materials()[name] for name in several]
    for names, rows in ((several, alone), (several[1::-1], alone[1::-1])):
        worst = read_spec(CONFIGS / "default.toml", given | {"friction.material": names})
        lining = worst.friction.linings["friction.material"]
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
    assert afmcalc("pocket", path, "--json").json["result"]["ball_diameter_standard"] in (0.007, 0.023, 0.09)
    afmcalc("pocket", path, "--save", "completed.toml")
    assert 'materials = "../lists/own.csv"' in (tmp_path / "picked" / "completed.toml").read_text(encoding="utf-8")
    again = read_spec(tmp_path / "picked" / "completed.toml")
    assert again.friction.range == (0.2, 0.25, 0.3)
    assert again.lists == read_spec(path).lists
    told = afmcalc("torque", path, "--json")
    assert afmcalc("torque", "-", "--json", stdin=told.out).json["result"] == told.json["result"]
    by_option = afmcalc("pocket", CONFIGS / "default.toml", "--set", "catalogues.balls=../lists/balls.csv", "--json")
    assert by_option.json["result"]["ball_diameter_standard"] in (0.007, 0.023, 0.09)


def test_disc_springs_of_ones_own(tmp_path, afmcalc):
    """Disc springs of a user's list are named by their designation, else by name and source."""
    heading, *rows = DISCS.splitlines()
    listed = "\n".join([f"{heading},designation", f"{rows[0]},Пружина 50х25 ТУ 1", f"{rows[1]},"])
    path, sprung = file(tmp_path, "discs.csv", listed), tmp_path / "sprung.toml"
    first, second = discs_in(path)
    sizes = ("outer_diameter", "inner_diameter", "thickness", "reduced_thickness", "free_height")
    assert [getattr(first, name) for name in sizes] == [0.05, 0.0254, 0.002, None, 0.0034]
    assert [first.title, second.title] == ["Пружина 50х25 ТУ 1", "X 60 (Maker's list)"]
    asked = ("springs", CONFIGS / "default.toml", "--set", f"catalogues.discs={path}", "--kind", "disc")
    parts = [each["part"] for each in afmcalc(*asked, "--json").json["result"]["closing"]]
    assert {first.title} <= {*parts} <= {first.title, second.title}
    assert afmcalc(*asked, "--pick", parts.index(first.title) + 1, "--save", sprung).code == 0
    assert first.title in afmcalc("springs", sprung).out
    picked = read_spec(sprung)
    assert (picked.closing_spring.disc.thickness, picked.catalogues.discs) == (first.thickness, path)
    for wrong, says in (
        (f"{listed}Пружина 50х25 ТУ 1", "X 60: every row has a name of its own"),
        (DISCS.replace("3.4", "2"), "X 50: free_height .* must be greater than thickness"),
    ):
        with pytest.raises(AfmcalcError, match=says):
            discs_in(file(tmp_path, "wrong.csv", wrong))


INCH = 25.4
PRINTED = 5e-6
"""Half a unit of the fifth decimal, in mm: the sizes are printed to five."""


def test_sizes_ascend_metric_or_sixty_fourths_of_an_inch():
    sizes = [1000 * size for size in balls()]
    assert sizes == sorted(set(sizes))
    assert (len(sizes), sizes[0], sizes[-1]) == (148, pytest.approx(0.3), pytest.approx(4.125 * INCH))
    for size in sizes:
        of_an_inch = round(64 * size / INCH) * INCH / 64
        assert abs(size - of_an_inch) <= PRINTED * (1 + 1e-6) or abs(size - round(size, 1)) < 1e-12, size


def test_a_makers_list_is_contained():
    sizes = [1000 * size for size in balls()]
    for size in READ["balls"][0]:
        assert min(abs(size - other) for other in sizes) <= 1e-4 / 2 + PRINTED, size


LISTS = {
    "own.toml": 'diameters = [8, "5 mm", 6.35]', "own.csv": "# mine\ndiameter_mm\n8\n5\n6.35\n",
    "OWN.CSV": "\ufeffdiameter_mm\r\n6.35\r\n5\r\n8\r\n", "bom.toml": "\ufeffdiameters = [6.35, 5, 8]",
}  # fmt: skip


@pytest.mark.parametrize("name", LISTS)
def test_a_list_of_the_users_own(tmp_path, name):
    (tmp_path / name).write_bytes(LISTS[name].encode())
    assert [1000 * size for size in balls_in(tmp_path / name)] == pytest.approx([5, 6.35, 8])


@pytest.mark.parametrize(("name", "text", "says"), REFUSED["balls"])
def test_what_is_no_list(tmp_path, name, text, says):
    (tmp_path / name).write_text(text, encoding="utf-8")
    with pytest.raises(AfmcalcError, match=says) as raised:
        balls_in(tmp_path / name)
    assert name in str(raised.value)


def test_a_standard_ball_is_named_as_it_is_ordered():
    assert ball_designation(0.0251) is None
    for size, name in ((25, "25"), (20.6375, "20.638"), (20.638, "20.638"), (5.55625, "5.556")):
        assert ball_designation(size / 1000) == f"ball {name} mm, ISO 3290-1"
        with speaking(language("ru")):
            assert ball_designation(size / 1000) == f"Шарик {name.replace('.', ',')} ГОСТ 3722-2014"
