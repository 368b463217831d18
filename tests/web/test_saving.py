"""What is saved, where, and that it is whole whatever happens."""

import json
import os
import random
import signal
import threading
import time
import tomllib
from contextlib import suppress
from http.client import HTTPException

import pytest
from serving import CONFIGS, Served, command_line, proc, spec_in, until, web

pytestmark = web
FIELDS = {"control_unit.gain": "0.7", "closing_spring.force": "2.5 kN", "friction.mean": ""}
SETS = [part for key, text in FIELDS.items() for part in ("--set", f"{key}={text}")]

MATERIALS = "name,description,condition,friction_min,friction_max,source\nfelt,felt,dry,0.2,0.3,Test 12\n"


def saved(served, fields=FIELDS, base=0):
    answer = served.post("save", {"base": base, "fields": fields})
    assert answer.status in (200, 403, 409, 422), answer
    return answer.json


def spec_of(file, *arguments):
    run = command_line("torque", file, *arguments, "--json")
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout)


def test_without_permission_nothing_is_written(served):
    before = (served.folder / "clutch.toml").read_bytes()
    answer = saved(served)
    assert answer["problems"]
    assert "saved" not in answer
    assert any("--force" in sentence for sentence in answer["problems"])
    assert (served.folder / "clutch.toml").read_bytes() == before


def test_with_force_the_spec_is_written(forced, spec):
    expected = spec_of(CONFIGS / "default.toml", *SETS)
    answer = saved(forced)
    assert answer["saved"].endswith("clutch.toml")
    assert answer["message"]
    written = spec_of(spec)
    assert written["spec"] == expected["spec"]
    assert written["result"] == expected["result"]
    comments = [line for line in spec.read_text(encoding="utf-8").splitlines() if "#" in line]
    assert len(comments) >= 15, "what each key is stands beside it"
    assert "saved" in saved(forced, {**FIELDS, "control_unit.gain": "0.9"})
    assert tomllib.loads(spec.read_text(encoding="utf-8"))["control_unit"]["gain"] == 0.9


@pytest.mark.exhaustive
def test_what_is_saved_opens_again(serve, tmp_path):
    spec = spec_in(tmp_path)
    first = serve(spec.name, "--force")
    shown = first.live(FIELDS)["fragments"]["numbers"]
    saved(first)
    first.end()
    second = serve(spec.name)
    assert second.live({})["fragments"]["numbers"] == shown
    assert 'value="0.7"' in second.get().body.decode()


@pytest.mark.exhaustive
def test_saving_without_a_change_keeps_the_clutch(serve, tmp_path):
    spec = spec_in(tmp_path, "indirect")
    before = spec_of(spec)
    saved(serve(spec.name, "--force"), {})
    after = spec_of(spec)
    assert (after["spec"], after["result"]) == (before["spec"], before["result"])


@pytest.mark.exhaustive
def test_an_output_is_written_beside_the_spec(serve, tmp_path):
    spec = spec_in(tmp_path)
    served = serve(spec.name, "-o", "other.toml")
    assert not (tmp_path / "other.toml").exists(), "nothing is written before it is asked for"
    assert saved(served)["saved"].endswith("other.toml")
    assert spec.read_bytes() == (CONFIGS / "default.toml").read_bytes()
    assert spec_of(tmp_path / "other.toml")["spec"] == spec_of(spec, *SETS)["spec"]


@pytest.mark.exhaustive
def test_an_output_may_be_json(serve, tmp_path):
    spec = spec_in(tmp_path)
    assert "saved" in saved(serve(spec.name, "-o", "other.json"))
    json.loads((tmp_path / "other.json").read_text(encoding="utf-8"))
    assert spec_of(tmp_path / "other.json")["result"] == spec_of(spec, *SETS)["result"]


@pytest.mark.exhaustive
def test_a_file_that_is_there_is_not_replaced(serve, tmp_path):
    """Said at the start or when it is to be written."""
    spec = spec_in(tmp_path)
    (tmp_path / "there.toml").write_text("mine", encoding="utf-8")
    try:
        served = serve(spec.name, "-o", "there.toml")
    except AssertionError as ended:
        assert "--force" in str(ended)
        assert "ended with 2" in str(ended)
    else:
        assert saved(served)["problems"]
    assert (tmp_path / "there.toml").read_text(encoding="utf-8") == "mine"


@pytest.mark.exhaustive
def test_one_made_meanwhile_is_not_replaced(serve, tmp_path):
    served = serve(spec_in(tmp_path).name, "-o", "other.toml")
    (tmp_path / "other.toml").write_text("mine", encoding="utf-8")
    assert saved(served)["problems"]
    assert (tmp_path / "other.toml").read_text(encoding="utf-8") == "mine"


def test_a_wrong_state_is_not_written(forced, spec):
    for fields in (
        {"control_unit.gain": "x"},
        {"friction.min": ""},
        {"control_unit.gian": "1"},
        {"friction.max": "0.05"},
    ):
        answer = saved(forced, fields)
        assert answer.get("problems") or answer.get("errors")
        assert "saved" not in answer
    assert spec.read_bytes() == (CONFIGS / "default.toml").read_bytes()


@pytest.mark.exhaustive
def test_what_cannot_be_written_is_a_sentence(serve, tmp_path):
    served = serve(spec_in(tmp_path).name, "-o", "gone/other.toml")
    answer = saved(served)
    assert answer["problems"]
    assert "Traceback" not in str(answer)
    assert served.live({})["fragments"]


def test_the_form_cannot_say_where(forced, spec):
    body = {
        "base": 0,
        "fields": FIELDS,
        "file": "evil.toml",
        "output": "evil.toml",
        "saved": "evil.toml",
        "force": True,
    }
    forced.post("save", body)
    assert spec.is_file()


@pytest.mark.exhaustive
def test_the_shipped_spec_is_never_written(serve, tmp_path):
    """Without SPEC the built-in clutch is shown."""
    served = serve()
    assert served.live({})["fragments"]
    assert saved(served)["problems"]
    with_force = serve("example:indirect", "--force")
    assert with_force.live({})["fragments"]
    assert saved(with_force, {})["problems"]
    assert not list(tmp_path.iterdir())


@pytest.mark.exhaustive
def test_its_own_catalogue_is_kept(serve, tmp_path):
    """What the SPEC itself names is read, and written again, relative to where it is saved."""
    spec = spec_in(tmp_path)
    (tmp_path / "lists").mkdir()
    (tmp_path / "lists" / "own.csv").write_text(MATERIALS, encoding="utf-8")
    text = spec.read_text(encoding="utf-8").replace("min = 0.10", 'material = "felt"')
    lines = [line for line in text.splitlines() if not line.startswith(("mean = ", "max = "))]
    spec.write_text("\n".join([*lines, "[catalogues]", 'materials = "lists/own.csv"', ""]), encoding="utf-8")
    assert spec_of(spec)["result"]["friction"]["max"] == 0.3
    served = serve(spec.name, "-o", "lists/other.toml")
    assert served.live({"control_unit.gain": "0.7"})["fragments"]
    assert "saved" in saved(served, {"control_unit.gain": "0.7"})
    written = spec_of(tmp_path / "lists" / "other.toml")
    assert written["result"] == spec_of(spec, "--set", "control_unit.gain=0.7")["result"]


@proc
@pytest.mark.exhaustive
def test_killed_while_saving_the_file_is_whole(tmp_path):
    """Ended by SIGKILL at any moment, the file is the old one or one of those saved."""
    spec = spec_in(tmp_path)
    whole = {spec.read_bytes()}
    first = Served(tmp_path, spec.name, "--force")
    states = [{"name": letter * 900, "control_unit.gain": f"0.{number}"} for number, letter in enumerate("abc", 4)]
    for fields in states:
        saved(first, fields)
        whole.add(spec.read_bytes())
    first.end()
    assert len(whole) == 4
    draw = random.Random(7)
    for _ in range(12):
        served = Served(tmp_path, spec.name, "--force")
        ended = threading.Event()

        def save(served=served, ended=ended):
            while not ended.is_set():
                with suppress(OSError, ValueError):
                    saved(served, draw.choice(states))

        threads = [threading.Thread(target=save) for _ in range(2)]
        for thread in threads:
            thread.start()
        time.sleep(0.2 + 0.3 * draw.random())
        os.killpg(served.process.pid, signal.SIGKILL)
        ended.set()
        for thread in threads:
            thread.join()
        served.process.wait(5)
        until(lambda served=served: not served.family())
        assert spec.read_bytes() in whole
        served.end()


@proc
@pytest.mark.exhaustive
def test_killed_a_moment_after_a_save_was_asked_for(serve, tmp_path):
    """One save and one kill, many times: so soon that some are not written yet."""
    spec = spec_in(tmp_path)
    served = serve(spec.name, "--force")
    saved(served, {"name": "b" * 900})
    new, old = spec.read_bytes(), (CONFIGS / "default.toml").read_bytes()
    served.end()
    draw, seen = random.Random(8), set()
    for _ in range(25):
        spec.write_bytes(old)
        served = serve(spec.name, "--force")
        served.live({})
        thread = threading.Thread(target=lambda served=served: _save(served))
        thread.start()
        time.sleep(draw.random() * 0.03)
        os.killpg(served.process.pid, signal.SIGKILL)
        thread.join()
        served.process.wait(5)
        until(lambda served=served: not served.family())
        assert spec.read_bytes() in (old, new)
        seen.add(spec.read_bytes())
    assert seen == {old, new}, "the moments were ill chosen"


def _save(served):
    with suppress(OSError, ValueError, HTTPException):
        saved(served, {"name": "b" * 900})
