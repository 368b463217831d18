"""Files to start from: every kind, examples by name, three machines from the plate to the drawing."""

import re
import tomllib

import pytest
from conftest import CONFIGS, PICKED, overrides

from afmcalc.cli.specs import _COMMAND
from afmcalc.errors import SpecError
from afmcalc.messages import latin
from afmcalc.spec import make_spec, read_spec

LIGHT = overrides("drive.motor_inertia=0.2", "drive.event.duration=0.03")
QUICK = {"machine": overrides("search.friction_group.pairs=8", "search.control_unit.gain=[0.8, 0.9]", "heat.lining=")}
QUICK["tolerance"] = overrides("tolerance.samples=2000", "tolerance.sobol_base=64")


@pytest.mark.parametrize("kind", _COMMAND)
def test_every_kind_is_calculated_as_the_note_says(kind, afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run = afmcalc("init", "--kind", kind, "a.toml")
    told = f"note: wrote a.toml; calculate it with: afmcalc {_COMMAND[kind]} a.toml\n"
    assert (run.code, run.out, run.err) == (0, "", told)
    text = (tmp_path / "a.toml").read_text(encoding="utf-8")
    assert set(tomllib.loads(text)) <= set(afmcalc("schema").json["properties"])
    assert afmcalc(_COMMAND[kind], "a.toml", *(LIGHT if kind == "drive" else QUICK.get(kind, []))).code == 0


def test_a_machine_is_the_template_and_an_example_can_be_copied(afmcalc, answered, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert afmcalc("init").err == "note: wrote clutch.toml; calculate it with: afmcalc design clutch.toml\n"
    assert (tmp_path / "clutch.toml").read_text(encoding="utf-8") == answered("init", "-", "--kind", "machine").out
    run = afmcalc("init", "own.toml", "--from", "indirect")
    assert run.err == "note: wrote own.toml; calculate it with: afmcalc check own.toml\n"
    text = (CONFIGS / "indirect.toml").read_text(encoding="utf-8")
    assert answered("list", "examples", "indirect").out == text
    assert (tmp_path / "own.toml").read_text(encoding="utf-8") == latin(text)
    wrong = afmcalc("init", "x.toml", "--from", "indirekt")
    assert (wrong.code, "did you mean 'indirect'" in wrong.err) == (2, True)


def test_examples_are_sources_by_name(answered):
    rows = answered("list", "examples", "--json").json["result"]["examples"]
    assert [row["name"] for row in rows] == sorted(path.stem for path in CONFIGS.glob("*.toml"))
    for row in rows:
        assert read_spec(f"example:{row['name']}") == read_spec(CONFIGS / f"{row['name']}.toml")


HEAD, OPTIONAL = r"(# )?\[[\w.]+\](?! and)", r"# (\[[\w.]+\](?! and)|[\w.\"]+ = )"
"""Patterns of the head of a block, and of the begin of a key or block that is commented out."""
STARTS = [["--kind", each] for each in _COMMAND]


def taken_up(text):
    """Yield a text once with each key, and once with each whole block, that is commented out in it."""
    lines, block, places = text.splitlines(), None, {}
    for number, line in enumerate(lines):
        if re.match(HEAD, line):
            block = number if line.startswith("#") else None
        if re.match(OPTIONAL, line):
            places.setdefault(number if block is None else block, set()).add(number)
    for first, numbers in places.items():
        yield lines[first], "\n".join(line[2:] if at in numbers else line for at, line in enumerate(lines))


BESIDE = r"excludes|required|(only|not) for|without|beside|give \w+, or"
"""Pattern of the messages that refuse a valid key because of the other keys of the file."""


def test_every_key_that_is_commented_out_can_be_taken_up(answered):
    """This holds for every shipped example and template; Russian templates have the same keys with the same values."""
    texts = [path.read_text(encoding="utf-8") for path in CONFIGS.glob("*.toml")]
    for start in STARTS:
        english, russian = (answered("init", "-", *start, "--lang", name).out for name in ("en", "ru"))
        texts.append(english)
        for (_, one), (_, other) in zip(taken_up(english), taken_up(russian), strict=True):
            assert tomllib.loads(one) | {"name": ""} == tomllib.loads(other) | {"name": ""}
    asked = {}
    for text in texts:
        for line, other in taken_up(text):
            asked.setdefault((tomllib.loads(text).get("variant"), line), tomllib.loads(other))
    assert len(asked) > 60
    taken = 0
    for (variant, line), data in asked.items():
        try:
            make_spec(data)
            taken += 1
        except SpecError as error:
            assert all(re.search(BESIDE, each.message) for each in error.problems), (variant, line, str(error))
    assert taken > len(asked) / 2


PLATE = {
    "conveyor": (11e3, 1460, 1, 1.25),
    "drilling-head": (7.5e3, 1435, 4 * 0.96, 1.5),
    "wood-chipper": (37e3, 1475, 1.475 * 0.95, 2),
}
"""Power of the motor, W, its speed, rpm, torque behind the gear over torque before it, service factor."""
OTHERS = sorted({each.removesuffix("-clutch") for each in PICKED} - {"conveyor"})
UNAVOIDABLE = {"conveyor": {"effect-on-torque"}}
"""Warning that the handbook explains: the spring of the conveyor's clutch must be set again as the lining wears."""


@pytest.mark.parametrize("name", ["conveyor", *(pytest.param(each, marks=pytest.mark.slow) for each in OTHERS)])
def test_the_clutch_that_ships_is_fit_for_its_machine(name, answered):
    """The machine's torque is that of its plate, P/ω, and every requirement of the design is met."""
    check = answered("check", f"example:{name}-clutch", "--json").json
    warned = {each["code"] for each in check["findings"] if each["level"] == "warning"}
    assert warned == UNAVOIDABLE.get(name, set())
    power, speed, geared, service = PLATE[name]
    asked = (row for row in check["result"]["checks"] if row["code"] == "requirement-missed")
    rows = {row["path"].replace("machine.power", "requirements.machine_torque")[13:]: row for row in asked}
    assert rows["machine_torque"]["value"] >= power / (speed * 0.104719755) * geared * service * (1 - 2e-3)
    wanted = tomllib.loads((CONFIGS / f"{name}.toml").read_text(encoding="utf-8"))
    assert {name.partition(".")[0] for name in rows} >= {*wanted["requirements"]}
    assert all(row["passed"] for row in rows.values())
