"""The file that is saved: its content, its place, and that it is whole whatever happens."""

import os
import random
import signal
import threading
import time

import pytest
from conftest import CONFIGS
from pages import Site, sets, spec_in, web
from serving import proc

pytestmark = web
FIELDS = {"control_unit.gain": "0.7", "closing_spring.force": "2.5 kN", "friction.mean": ""}
OTHER = FIELDS | {"control_unit.gain": "0.9"}


def test_without_permission_nothing_is_written(afmcalc, tmp_path):
    """Without --save or --force no file is written, whatever the form says: no example, no file of the user."""
    spec, elsewhere = spec_in(tmp_path), {"file": "x.toml", "output": "x.toml", "saved": "x.toml", "force": True}
    for arguments in ([], [spec], ["example:indirect", "--force"]):
        site = Site(afmcalc, *arguments)
        for fields in (FIELDS, {}):
            told = site.save(fields, **elsewhere)
            assert "nothing to save to" in str(told["problems"])
            assert told.keys() == {"errors", "problems"}
    assert spec.read_bytes() == (CONFIGS / "default.toml").read_bytes()
    assert [*tmp_path.iterdir()] == [spec]


@pytest.mark.parametrize("output", [["--force"], ["--save", "other.toml"], ["--save", "other.json"]])
def test_what_is_saved_is_the_clutch_shown(output, afmcalc, tmp_path, monkeypatch):
    """A file that was saved is saved again; an invalid state is not written; files that SPEC names stay in it."""
    monkeypatch.chdir(tmp_path)
    head = "name,description,condition,friction_min,friction_max,source\n"
    (tmp_path / "own.csv").write_text(f"{head}felt,felt,dry,0.2,0.3,Test 12\n", encoding="utf-8")
    spec, name = spec_in(tmp_path), "clutch.toml" if output == ["--force"] else output[1]
    spec.write_bytes(spec.read_bytes() + b'\n[catalogues]\nmaterials = "own.csv"\n')
    (tmp_path / "shipped.toml").write_bytes(before := spec.read_bytes())
    site = Site(afmcalc, "clutch.toml", *output)
    for fields in (FIELDS, OTHER, {}):
        told = site.save(fields)
        assert (told["saved"], name in told["message"]) == (name, True)
        one, other = (afmcalc("torque", *each, "--json").json for each in ([name], ["shipped.toml", *sets(fields)]))
        assert (one["spec"], one["result"]) == (other["spec"], other["result"])
        assert "own.csv" in (written := (tmp_path / name).read_text("utf-8"))
        for key, text in (
            ("control_unit.gain", "x"),
            ("friction.min", ""),
            ("control_unit.gian", "1"),
            ("friction.max", "0.05"),
        ):
            assert site.save({key: text}).keys() == {"errors", "problems"}
        assert (tmp_path / name).read_text("utf-8") == written
    assert written.count("#") >= 15 or name.endswith("json")  # a comment explains each key
    assert name == "clutch.toml" or spec.read_bytes() == before
    assert set(os.listdir()) == {"clutch.toml", "own.csv", "shipped.toml", name}


def test_a_file_made_meanwhile_is_not_replaced(afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    site = Site(afmcalc, spec_in(tmp_path), "--save", "other.toml")
    (tmp_path / "other.toml").write_text("mine", encoding="utf-8")
    for _ in range(2):
        assert "--force" in str(site.save(FIELDS)["problems"])
    assert (tmp_path / "other.toml").read_text(encoding="utf-8") == "mine"
    assert "gone/other.toml: cannot be written" in Site(afmcalc, "clutch.toml", "--save", "gone/other.toml").run.err


def test_what_an_editor_changed_is_not_overwritten(afmcalc, tmp_path):
    """Unless the user confirms it; the second of two pages that save is warned as well; a pipe is refused at once."""
    spec = spec_in(tmp_path)
    site, edited = Site(afmcalc, spec, "--force"), f"{spec.read_text(encoding='utf-8')}# mine\n"
    spec.write_text(edited, encoding="utf-8")
    told = site.save(FIELDS)
    assert told.keys() == {"message"}
    assert "another program" in told["message"]
    assert spec.read_text(encoding="utf-8") == edited
    assert site.save(FIELDS, anyway=True)["saved"]
    first, site.known = site.known, {}
    assert site.save(OTHER).keys() == {"message"}
    site.known = first
    assert site.save(OTHER)["saved"]
    assert "gain = 0.9" in spec.read_text(encoding="utf-8")
    spec.unlink()
    os.mkfifo(spec)
    for more in ({}, {"anyway": True}, {"known": ""}):
        assert "could be replaced" in str(site.save(OTHER, **more)["problems"])


@proc
@pytest.mark.tool
def test_killed_while_saving_the_file_is_whole(serve, tmp_path):
    """If the server is ended by SIGKILL at any moment, the file is the old one or a saved one, whole."""
    states = [{"name": letter * 900, "control_unit.gain": f"0.{number}"} for number, letter in enumerate("abc", 4)]
    draw, whole = random.Random(7), {(CONFIGS / "default.toml").read_bytes()}
    for number in range(3):
        served = serve("default", "--force")
        if not number:
            for fields in states:
                assert served.post("save", {"base": 0, "fields": fields, "anyway": True})["saved"]
                whole.add(served.spec.read_bytes())
        ended = threading.Event()

        def save(served=served, ended=ended):
            while not ended.is_set():
                served.post("save", {"base": 0, "fields": draw.choice(states), "anyway": True})

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
