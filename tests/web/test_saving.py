"""What is saved, where, and that it is whole whatever happens."""

import os
import random
import signal
import threading
import time
import tomllib

import pytest
from conftest import CONFIGS
from pages import Site, sets, spec_in, web
from serving import proc

pytestmark = web
FIELDS = {"control_unit.gain": "0.7", "closing_spring.force": "2.5 kN", "friction.mean": ""}
OTHER = FIELDS | {"control_unit.gain": "0.9"}


@pytest.fixture
def is_saved(afmcalc):
    """A saved file gives what the command line gives for the fields."""

    def judge(file, spec, fields):
        written, expected = (
            afmcalc("torque", file, "--json").json,
            afmcalc("torque", spec, *sets(fields), "--json").json,
        )
        assert (written["spec"], written["result"]) == (expected["spec"], expected["result"])

    return judge


def test_without_permission_nothing_is_written(afmcalc, tmp_path):
    """Neither what is built in nor an example nor a file of the user; wherever the form says to write."""
    spec, elsewhere = spec_in(tmp_path), {"file": "x.toml", "output": "x.toml", "saved": "x.toml", "force": True}
    for arguments in ([], [spec], ["example:indirect", "--force"]):
        site = Site(afmcalc, *arguments)
        for fields in (FIELDS, {}):
            told = site.save(fields, **elsewhere)
            assert "nothing to save to" in str(told["problems"])
            assert told.keys() == {"errors", "problems"}
    assert spec.read_bytes() == (CONFIGS / "default.toml").read_bytes()
    assert [*tmp_path.iterdir()] == [spec]


@pytest.mark.parametrize("output", [["--force"], ["-o", "other.toml"], ["-o", "other.json"]])
def test_what_is_saved_is_the_clutch_shown(output, afmcalc, is_saved, tmp_path, monkeypatch):
    """Twice: what was saved is saved over; a state that is no clutch is not written."""
    monkeypatch.chdir(tmp_path)
    spec, shipped = spec_in(tmp_path), CONFIGS / "default.toml"
    name = "clutch.toml" if output == ["--force"] else output[1]
    site = Site(afmcalc, "clutch.toml", *output)
    assert os.listdir() == ["clutch.toml"]
    for fields in (FIELDS, OTHER, {}):
        told = site.save(fields)
        assert told["saved"] == name
        assert name in told["message"]
        is_saved(name, shipped, fields)
        written = (tmp_path / name).read_bytes()
        for wrong in (
            {"control_unit.gain": "x"},
            {"friction.min": ""},
            {"control_unit.gian": "1"},
            {"friction.max": "0.05"},
        ):
            assert site.save(wrong).keys() == {"errors", "problems"}
        assert (tmp_path / name).read_bytes() == written
    assert written.count(b"#") >= 15 or name.endswith("json")  # what each key is stands beside it
    assert name == "clutch.toml" or spec.read_bytes() == shipped.read_bytes()
    assert set(os.listdir()) == {"clutch.toml", name}
    assert cells_of(Site(afmcalc, name)) == cells_of(site)


def cells_of(site):
    return site.live({})["fragments"]["numbers"]


def test_a_file_made_meanwhile_is_not_replaced(afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    site = Site(afmcalc, spec_in(tmp_path), "-o", "other.toml")
    (tmp_path / "other.toml").write_text("mine", encoding="utf-8")
    for _ in range(2):
        assert "--force" in str(site.save(FIELDS)["problems"])
    assert (tmp_path / "other.toml").read_text(encoding="utf-8") == "mine"
    assert "gone" in str(Site(afmcalc, "clutch.toml", "-o", "gone/other.toml").save(FIELDS)["problems"])


def test_its_own_catalogue_is_kept(afmcalc, is_saved, tmp_path, monkeypatch):
    """What SPEC itself names is read, and written again, relative to where it is saved."""
    monkeypatch.chdir(tmp_path)
    spec = spec_in(tmp_path)
    (tmp_path / "lists").mkdir()
    head = "name,description,condition,friction_min,friction_max,source\n"
    (tmp_path / "lists" / "own.csv").write_text(f"{head}felt,felt,dry,0.2,0.3,Test 12\n", encoding="utf-8")
    text = spec.read_text(encoding="utf-8").replace("min = 0.10", 'material = "felt"')
    lines = [line for line in text.splitlines() if not line.startswith(("mean = ", "max = "))]
    spec.write_text("\n".join([*lines, "[catalogues]", 'materials = "lists/own.csv"', ""]), encoding="utf-8")
    assert Site(afmcalc, "clutch.toml", "-o", "lists/other.toml").save({"control_unit.gain": "0.7"})["saved"]
    is_saved("lists/other.toml", "clutch.toml", {"control_unit.gain": "0.7"})
    written = tomllib.loads((tmp_path / "lists" / "other.toml").read_text(encoding="utf-8"))
    assert written["catalogues"] == {"materials": "own.csv"}


@proc
@pytest.mark.tool
def test_killed_while_saving_the_file_is_whole(serve, tmp_path):
    """Ended by SIGKILL at any moment, the file is the old one or one of those saved."""
    states = [{"name": letter * 900, "control_unit.gain": f"0.{number}"} for number, letter in enumerate("abc", 4)]
    draw, whole = random.Random(7), {(CONFIGS / "default.toml").read_bytes()}
    for number in range(3):
        served = serve("default", "--force")
        if not number:
            for fields in states:
                assert served.post("save", {"base": 0, "fields": fields})["saved"]
                whole.add(served.spec.read_bytes())
        ended = threading.Event()

        def save(served=served, ended=ended):
            while not ended.is_set():
                served.post("save", {"base": 0, "fields": draw.choice(states)})

        threads = [threading.Thread(target=save) for _ in range(2)]
        for thread in threads:
            thread.start()
        time.sleep(0.1 + 0.2 * draw.random())
        os.killpg(served.process.pid, signal.SIGKILL)
        ended.set()
        for thread in threads:
            thread.join()
        served.process.wait(5)
        assert served.spec.read_bytes() in whole
    assert len(whole) == 4
