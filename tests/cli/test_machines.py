"""Three machines from the plate to the drawing: the command lines of the handbook's chapter, run as they stand."""

import os
import re
import shlex
import tomllib

import pytest
from conftest import CONFIGS, PICKED

from afmcalc.analysis.design.design import design
from afmcalc.analysis.handbook import chapter_texts

CHAPTER = next(text for text in chapter_texts("en").values() if text.startswith("# Three machines"))
SCRIPTS = re.findall(r"```sh\n(.*?)```", CHAPTER, re.DOTALL)
MACHINES = sorted(name.removesuffix("-clutch") for name in PICKED)
PLATE = {
    "conveyor": (11e3, 1460, 1, 1.25),
    "drilling-head": (7.5e3, 1435, 4 * 0.96, 1.5),
    "wood-chipper": (37e3, 1475, 1.475 * 0.95, 2),
}
"""Power, W, and speed, rpm, of the motor, torque behind the gear over that before it, service factor."""
UNAVOIDABLE = {"effect-on-torque"}
"""Warning of the conveyor that the chapter speaks of: its spring is to be set again as the lining wears."""


@pytest.fixture(autouse=True)
def patient(monkeypatch):
    """A machine that is busy refuses nothing."""
    monkeypatch.setattr("afmcalc.progress.LONG", 3600.0)


@pytest.fixture
def calculated_once(monkeypatch):
    """A design that is asked for twice is calculated once."""
    known = {}

    def remembered(need, **options):
        asked = need.model_dump_json(), str(options)
        if asked not in known:
            known[asked] = design(need, **options)
        return known[asked]

    monkeypatch.setattr("afmcalc.analysis.design.design.design", remembered)


def lines(script, afmcalc):
    """Run the lines of a script; what each left."""
    return [afmcalc(*shlex.split(line)[1:]) for line in script.splitlines()]


def test_the_way(afmcalc, undrawn, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert [run.code for run in lines(SCRIPTS[0], afmcalc)] == [0] * 6


@pytest.mark.every(3)
@pytest.mark.parametrize("name", MACHINES)
def test_from_plate_to_dxf(name, afmcalc, undrawn, calculated_once, tmp_path, monkeypatch):
    (script,) = (each for each in SCRIPTS if f"example:{name} " in each)
    monkeypatch.chdir(tmp_path)
    runs = lines(script, afmcalc)
    assert [run.code for run in runs] == [0] * len(runs), [run.err for run in runs]
    the_clutch_that_ships_is_the_one_picked(name, (tmp_path / f"{name}.toml").read_text(encoding="utf-8"))
    check = afmcalc("check", f"{name}.toml", "--json").json
    warned = {each["code"] for each in check["findings"] if each["level"] == "warning"}
    assert warned == (UNAVOIDABLE if name == "conveyor" else set())

    # the machine's torque from its plate, P/ω, and every requirement with room to spare
    power, speed, geared, service = PLATE[name]
    rows = {row["requirement"]: row for row in check["result"]["requirements"]}
    assert rows["machine_torque"]["value"] >= power / (speed * 0.104719755) * geared * service * (1 - 2e-3)
    wanted = tomllib.loads((CONFIGS / f"{name}.toml").read_text(encoding="utf-8"))
    assert set(rows) >= {*wanted["wanted"], *wanted["limits"]} - {"method", "margin", "nominal_torque"}
    assert all(row["passed"] for row in rows.values())

    page = (tmp_path / f"{name}.html").read_text(encoding="utf-8")
    assert wanted["name"] in page
    drawing = (tmp_path / f"{name}.dxf").read_text(encoding="utf-8")
    assert drawing.startswith("  0\nSECTION")
    assert drawing.rstrip().endswith("EOF")


def the_clutch_that_ships_is_the_one_picked(name, picked):
    shipped = CONFIGS / f"{name}-clutch.toml"
    about, _, _ = shipped.read_text(encoding="utf-8").partition("\n")
    if os.environ.get("AFMCALC_UPDATE"):
        plain = re.sub(r", no\. \d+| +#.*", "", picked.partition("\n\n")[2])
        shipped.write_text(f"{about}\n\n{plain}", encoding="utf-8")
    stored, made = tomllib.loads(shipped.read_text(encoding="utf-8")), tomllib.loads(picked)
    assert stored | {"name": ""} == made | {"name": ""}
