"""Files to start from: every kind and variant, with the schema beside them, and the examples by name."""

import json
import tomllib

import pytest
from conftest import CONFIGS

from afmcalc.cli.specs import _EXAMPLES, _KINDS
from afmcalc.variants import VARIANTS


@pytest.mark.parametrize("kind", _KINDS)
def test_every_kind_is_calculated_as_the_note_says(kind, afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run = afmcalc("init", "--kind", kind, "a.toml", "--schema")
    beside, *_ = tmp_path.glob("*.schema.json")
    told = f"note: wrote a.toml, {beside.name}; calculate it with: afmcalc {_KINDS[kind]} a.toml\n"
    assert (run.code, run.out, run.err) == (0, "", told)
    first, text = (tmp_path / "a.toml").read_text(encoding="utf-8").split("\n", 1)
    assert first == f"#:schema ./{beside.name}"
    schema = json.loads(beside.read_text(encoding="utf-8"))
    assert set(tomllib.loads(text)) <= set(schema["properties"])
    light = ["--set", "drive.motor_inertia=0.2"] if kind == "drive" else []
    assert afmcalc(_KINDS[kind], "a.toml", *light).code == 0


@pytest.mark.parametrize("variant", _EXAMPLES)
def test_every_variant(variant, afmcalc):
    text = afmcalc("init", "-", "--variant", variant).out
    assert tomllib.loads(text)["variant"] == (variant if variant in VARIANTS else "differentiated")
    assert afmcalc("torque", "-", stdin=text).code == 0


@pytest.mark.parametrize("variant", _EXAMPLES)
def test_every_variant_in_a_drive(variant, afmcalc):
    """The clutch is the variant's own, the drive that of the example; an indirect one has an inertia of its hub."""
    text = afmcalc("init", "-", "--kind", "drive", "--variant", variant).out
    spec, alone = tomllib.loads(text), tomllib.loads(afmcalc("init", "-", "--variant", variant).out)
    assert spec["friction_group"]["pairs"] == alone["friction_group"]["pairs"]
    assert spec["variant"] == alone["variant"]
    assert spec["drive"]["event"]["kind"] == "stop"
    assert ("hub_inertia" in spec["drive"]) == ("# hub_inertia" not in text) == (spec["variant"] == "indirect")
    light = ["--set", "drive.motor_inertia=0.2", "--set", "drive.event.duration=0.03"]
    assert afmcalc("simulate", "-", *light, stdin=text).code == 0
    checked = afmcalc("check", "-", *light, "--json", stdin=text)
    assert (checked.code, checked.json["result"]["errors"]) == (0, 0)


def test_what_makes_no_sense_is_refused(afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for arguments, said in (
        (["--kind", "requirements", "--variant", "indirect"], "--variant belongs to --kind clutch or drive"),
        (["-", "--schema"], "--schema writes a file beside FILE: name one"),
        (["a.toml", "-o", "b.toml"], "give FILE or --output, not both"),
    ):
        run = afmcalc("init", *arguments)
        assert (run.code, run.err) == (2, f"error: {said}\n")
    (tmp_path / "afmcalc.schema.json").write_text("mine")
    assert afmcalc("init", "--schema").code == 2
    assert [path.name for path in tmp_path.iterdir()] == ["afmcalc.schema.json"]
    assert (tmp_path / "afmcalc.schema.json").read_text() == "mine"


def test_examples_are_sources_by_name(afmcalc):
    rows = afmcalc("examples", "--json").json["result"]["examples"]
    assert [row["name"] for row in rows] == sorted(path.stem for path in CONFIGS.glob("*.toml"))
    for row in rows:
        command = "design" if row["variant"] is None else "torque"
        by_name, by_path = (
            afmcalc(command, source, "--json") for source in (f"example:{row['name']}", CONFIGS / f"{row['name']}.toml")
        )
        assert by_name.code == by_path.code == 0
        assert by_name.json == by_path.json
    wrong = afmcalc("torque", "example:indirekt")
    assert (wrong.code, wrong.err) == (2, "error: example:indirekt: no such example; did you mean 'indirect'?\n")
