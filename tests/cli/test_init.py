"""Files to start from: every kind and variant, with the schema beside them, and the examples by name."""

import json
import random
import re
import tomllib

import pytest
from conftest import CONFIGS

from afmcalc.cli.specs import _EXAMPLES, _KINDS
from afmcalc.spec import read_spec
from afmcalc.spec.requirements import read_requirements
from afmcalc.variants import VARIANTS

LIGHT = ["--set", "drive.motor_inertia=0.2", "--set", "drive.event.duration=0.03"]
QUICK = dict.fromkeys(("requirements", "machine"), ["--set", "search.pairs=8", "--no-simulate"])
QUICK["tolerance"] = ["--set", "tolerance.samples=2000", "--set", "tolerance.sobol_base=64"]


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
    assert afmcalc(_KINDS[kind], "a.toml", *(LIGHT if kind == "drive" else QUICK.get(kind, []))).code == 0


@pytest.mark.parametrize("variant", _EXAMPLES)
def test_every_variant_alone_and_in_a_drive(variant, afmcalc):
    """The clutch is the variant's own, the drive that of the example; an indirect one has an inertia of its hub."""
    alone = afmcalc("init", "-", "--variant", variant).out
    assert tomllib.loads(alone)["variant"] == (variant if variant in VARIANTS else "differentiated")
    assert afmcalc("torque", "-", stdin=alone).code == 0
    text = afmcalc("init", "-", "--kind", "drive", "--variant", variant).out
    spec, alone = tomllib.loads(text), tomllib.loads(alone)
    assert spec["friction_group"]["pairs"] == alone["friction_group"]["pairs"]
    assert spec["variant"] == alone["variant"]
    assert spec["drive"]["event"]["kind"] == "stop"
    assert ("hub_inertia" in spec["drive"]) == ("# hub_inertia" not in text) == (spec["variant"] == "indirect")
    checked = afmcalc("check", "-", *LIGHT, "--json", stdin=text)
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


def test_examples_are_sources_by_name(answered):
    rows = answered("examples", "--json").json["result"]["examples"]
    assert [row["name"] for row in rows] == sorted(path.stem for path in CONFIGS.glob("*.toml"))
    for row in rows:
        read = read_spec if row["variant"] else read_requirements
        assert read(f"example:{row['name']}") == read(CONFIGS / f"{row['name']}.toml")
    wrong = answered("torque", "example:indirekt")
    assert (wrong.code, wrong.err) == (2, "error: example:indirekt: no such example; did you mean 'indirect'?\n")


OPTIONAL = re.compile(r"# (?=\[[\w.]+\](?! and)|[\w.\"]+ = )")
"""Before a key or block that is there to be taken up."""
SPRUNG = ["springs", "closing_room"]
INDIRECT = [*SPRUNG, "control_room", "closing_stiffness", "control_stiffness", "hub_diameter", "key_friction"]
RADII = ["inner_radius", "outer_radius", "radius_model"]
TOGETHER = (
    {"material": (["material"], ["min", "mean", "max"]), "wall_angle": (["wall_angle"], ["gain"])}
    | {"gain_slope": (["gain_slope"], ["pocket"])}
    | dict.fromkeys(RADII, (RADII, ["mean_radius"]))
    | dict.fromkeys(INDIRECT, (INDIRECT, ["variants"]))
    | dict.fromkeys(SPRUNG, (SPRUNG, []))
)
"""Key → keys that are taken up with it, and those that they stand in for."""


def optional(text):
    """Places of what may be taken up: (table, key) of a key, (table, "") of a block with all below it → lines."""
    found, table, block = {}, "", None
    for number, line in enumerate(text.splitlines()):
        if head := re.match(r"(# )?\[([\w.]+)\](?! and)", line):
            table, block = head[2], (head[2], "") if head[1] else None
            if block:
                found[block] = [number]
        elif OPTIONAL.match(line):
            key = (table, line[2:].partition(" = ")[0])
            found.setdefault(block or key, []).append(number)
    return found


def taken_up(text, table, key):
    """A text with a key taken up, and what belongs to it, without what that stands in for."""
    many, gone = TOGETHER.get(key, ([key], []))
    anywhere = many[0] == "springs"
    places = {of: numbers for of, numbers in optional(text).items() if of[0] == table or anywhere}
    chosen = {number for (_, name), numbers in places.items() if name in many for number in numbers}
    lines, inside = [], ""
    for number, line in enumerate(text.splitlines()):
        if head := re.match(r"\[([\w.]+)\]", line):
            inside = head[1]
        if line.partition(" = ")[0] in gone and (inside == table or anywhere):
            lines.append('variants = ["indirect"]' if "variants" in gone else f"# {line}")
        else:
            lines.append(line[2:] if number in chosen else line)
    return "\n".join(lines)


STARTS = [
    *(["--kind", "clutch", "--variant", each] for each in _EXAMPLES),
    *(["--kind", "drive", "--variant", each] for each in _EXAMPLES),
    *(["--kind", each] for each in _KINDS),
]


@pytest.mark.slow
def test_every_key_that_is_commented_out_can_be_taken_up(afmcalc):
    """In every file that ships and every template; those in Russian have the same keys with the same values."""
    texts = [path.read_text(encoding="utf-8") for path in sorted(CONFIGS.glob("*.toml"))]
    for start in STARTS:
        english, russian = (afmcalc("init", "-", *start, "--lang", name).out for name in ("en", "ru"))
        texts.append(english)
        assert optional(russian) == optional(english)
        for table, key in optional(russian):
            data, other = (tomllib.loads(taken_up(text, table, key)) for text in (english, russian))
            assert {**data, "name": ""} == {**other, "name": ""}
    asked = {}
    for text in dict.fromkeys(texts):
        for table, key in optional(text):
            variant = tomllib.loads(text).get("variant")
            if (table, key) == ("drive", "hub_inertia"):
                assert variant != "indirect"
                continue
            (value, *_), made = optional(text)[table, key], taken_up(text, table, key)
            asked.setdefault((variant, table, key, text.splitlines()[value].partition("   ")[0]), made)
    assert {("indirect", "control_unit", "gain_slope"), (None, "fixed", "control_room")} <= {each[:3] for each in asked}
    assert len(asked) > 80
    for (variant, table, key, _), text in random.Random(2).sample(sorted(asked.items(), key=str), 25):
        few = ["search.pairs=8"]
        if "\ninner_radius = [" in text:
            few += ["fixed.face_width=", "search.outer_radius=0.1"]
        small = [part for each in few for part in ("--set", each)]
        run = afmcalc("torque" if variant else "design", "-", *([] if variant else small), "-q", stdin=text)
        assert run.code == 0 or not variant and "meets every requirement" in run.err, (variant, table, key, run.err)
        assert "number-without-unit" not in run.out
