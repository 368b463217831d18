"""Use of the package from Python."""

import copy
import csv
import doctest
import importlib
import json
import math
import pickle
import runpy
import sys
import tomllib
from xml.etree import ElementTree

import numpy as np
import pytest
from conftest import CONFIGS, ROOT, overrides
from sources import FILES, READ

import afmcalc as package
from afmcalc.analysis.registry import ANALYSES
from afmcalc.render import renderer
from afmcalc.spec import resolved


def test_doctests():
    for name in (name for name, file in FILES.items() if ">>> " in file.read_text(encoding="utf-8")):
        results = doctest.testmod(importlib.import_module(f"afmcalc.{name}".rstrip(".")))
        assert (results.attempted > 0, results.failed) == (True, 0), name


def test_public_names():
    assert all(hasattr(package, name) for name in package.__all__)
    assert {"Clutch", "load", "compare", "design", "SpecError", "__version__"} <= set(dir(package))
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        _ = package.nothing
    with pytest.raises(package.SpecError):
        package.read_spec(None, ["C=-1"])


DRIVE = {"drive.event.duration": 0.01}


@pytest.mark.parametrize(("example", "keys", "name", "given", "arguments"), READ["python"])
def test_python_answers_what_a_command_prints(example, keys, name, given, arguments, afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    answer = getattr(package.load(CONFIGS / f"{example}.toml", keys), name)(**given)
    options = overrides(*(f"{key}={value}" for key, value in keys.items()))
    run = afmcalc(name, *arguments, CONFIGS / f"{example}.toml", *options, "--json")
    assert json.loads(renderer("json")(answer._output, False)) == run.json
    assert answer.to_dict() == run.json["result"]
    assert [finding.code for finding in answer.findings] == [finding["code"] for finding in run.json["findings"]]
    assert type(answer) is ANALYSES[name].result_class
    assert renderer("table")(answer._output, False) == str(answer)


def test_clutches_side_by_side_and_designs(afmcalc):
    default = CONFIGS / "default.toml"
    two = package.compare([package.load(), CONFIGS / "indirect.toml"])
    assert two.to_dict() == afmcalc("compare", default, CONFIGS / "indirect.toml", "--json").json["result"]
    variants = package.compare(default, variants=True)
    assert variants.to_dict() == afmcalc("compare", "--variants", "--json").json["result"]
    with pytest.raises(package.AfmcalcError, match="one SPEC"):
        package.compare([default, default], variants=True)
    wanted = CONFIGS / "requirements.toml"
    few = ("search.friction_group.pairs=8", "search.control_unit.gain=[0.8, 0.9]")
    picked = package.design(wanted, pick=1, set=few)
    assert picked.to_dict() == afmcalc("design", wanted, *overrides(*few), "--pick", "1", "--json").json["result"]
    assert package.load(picked.spec)["closing_force"] == pytest.approx(picked.front[0].closing_force)


def test_other_values_of_keys():
    """Keys are given by path, name or symbol, in SI or with a unit; a key replaces those that exclude it."""
    data = tomllib.loads(
        "variant = 'all-driving'\nfriction = {min = 0.1, max = 0.8}\nfriction_group = {pairs = 8, mean_radius = 0.1}\n"
        "closing_spring = {force = 2000}\ncontrol_unit = {wall_angle = '14 deg', ball_circle_radius = 0.05}\n"
    )
    before = copy.deepcopy(data)
    clutch = package.load(data, {"F": "3 kN", "z_1": None, "pairs": np.int64(4), "friction.max": 0.6})
    assert data == before
    nominal = package.load(None, {"fatigue": None, "closing_spring.force": None, "T_n": "200 N*m"})
    assert nominal.torque(0.1) == pytest.approx(200)
    # T = F R z f/(1 + z C f), C = (R/r) tan α
    gain = 2 * math.tan(math.radians(14))
    assert clutch.torque(0.2) == pytest.approx(3000 * 0.1 * 4 * 0.2 / (1 + 4 * gain * 0.2))
    other = clutch.with_({"closing_spring.force": "1 kN"}, gain=1.2, f_max=0.5)
    assert other.torque(0.2) == pytest.approx(1000 * 0.1 * 4 * 0.2 / (1 + 4 * 1.2 * 0.2))
    assert (other.spec.friction.max, other.spec.control_unit.wall_angle) == (0.5, None)
    assert clutch.spec.control_unit.gain is None
    assert other.with_(gain=None, wall_angle=math.radians(14))["gain"] == pytest.approx(gain)
    assert clutch.with_(gain=None)["gain"] == pytest.approx(gain), "nothing takes the place of the angle"
    assert package.load(None, {"margin": None}).spec.adjustment.margin == 1
    assert clutch.with_(nominal_torque=100.0).torque(0.1) == pytest.approx(100)
    for wrong, says in (({"gian": 1}, "did you mean"), ({"gain": -1}, "gain"), ({"pairs": 4.5}, "whole")):
        with pytest.raises(package.AfmcalcError, match=says):
            clutch.with_(**wrong)
        with pytest.raises(package.AfmcalcError, match=says):
            package.load(None, wrong)


def test_a_clutch_and_an_answer_can_be_copied_and_kept():
    clutch = package.load("example:indirect")
    swept = package.load().accuracy(sweep=["C=0,0.5", "z=4,8"])
    for copied in (copy.copy, copy.deepcopy, lambda each: pickle.loads(pickle.dumps(each))):
        other, answer = copied(clutch), copied(swept)
        assert isinstance(other, package.Clutch)
        assert (other.spec, other.torque()) == (clutch.spec, clutch.torque())
        assert (answer, str(answer), answer.findings) == (swept, str(swept), swept.findings)
    assert clutch["accuracy_factor"] == clutch.accuracy().accuracy_factor
    for each, name in ((clutch, "accuracy"), (swept, "accuracy_factor")):
        assert name in dir(each)
        with pytest.raises(AttributeError, match="nothing"):
            _ = each.nothing
    solved = package.load().solve("accuracy_factor", 2.0)
    assert package.build(solved.spec)["accuracy_factor"] == pytest.approx(2)


def test_quantities_are_asked_by_name():
    """A quantity that depends on friction needs a case or a friction; the error on a misspelt name has similar ones."""
    clutch, friction = package.load("example:default"), np.linspace(0.1, 0.8, 1001)
    assert clutch["accuracy_factor"] == clutch.accuracy().accuracy_factor
    assert clutch.at("f_max").torque == clutch["torque_at_f_max"] == clutch.torque(0.8)
    assert clutch.at(friction=friction).torque.tolist() == clutch.torque(friction).tolist()
    assert clutch.at("f_max", gain=0.0).torque > clutch.at("f_max").torque
    assert {"torque", "accuracy_factor", "gain"} <= {*clutch.names()}
    assert {"torque", "gain"} <= {*dir(clutch.at("f_min"))}
    assert "travel" not in clutch.names(), "it has no sleeve"
    for ask, says in (
        (lambda: clutch["torque"], "torque needs friction.* in a case: .*f_min, f_mean, f_max"),
        (lambda: clutch["torqe"], "did you mean 'torque'"),
        (lambda: clutch["travel"], "no quantity 'travel'"),
        (lambda: clutch.at("f_mx"), "did you mean 'f_max'"),
        (lambda: clutch.at(frition=0.2), "did you mean 'friction'"),
    ):
        with pytest.raises(LookupError, match=says):
            ask()
    with pytest.raises(AttributeError, match="did you mean 'torque'"):
        _ = clutch.at("f_max").torqe


def test_an_answer_shows_itself():
    clutch = package.build({**resolved(package.read_spec()), "name": "<b>"})
    swept = clutch.accuracy(sweep=["C=0,0.5", "z=4,8"])
    page = swept._repr_html_()
    ElementTree.fromstring(f"<div>{page}</div>")
    assert "<b>" not in page
    assert all(f">{entry:g}<" in page for entry in swept.sweep[0].values)
    assert swept._repr_markdown_() == renderer("markdown")(swept._output, False)


@pytest.mark.slow
def test_a_frame_has_a_row_per_friction_or_per_point(monkeypatch):
    """Names are those of the fields, units beside them; without pandas an error says how to get it."""
    frame = package.load().torque().to_dataframe()
    assert [*frame.index] == ["min", "mean", "max"]
    # T = F R (z_1 f + z_2 f)/(1 + C z_2 f): 2000 · 0.1 · 8 · 0.1/(1 + 3.5 · 0.1)
    assert frame["torque"]["min"] == pytest.approx(160 / 1.35, rel=1e-14)
    assert frame.attrs["units"]["torque"] == "N*m"
    assert frame.attrs["values"]["nominal_torque"] == frame["torque"]["min"]
    swept = package.load().accuracy(sweep="C=0,0.5")
    rows = swept.to_dataframe()
    # K_т = 8 (1 + 7 C 0.1)/(1 + 7 C 0.8)
    assert [*rows["accuracy_factor"]] == pytest.approx([8, 8 * 1.35 / 3.8], rel=1e-14)
    assert [*rows["control_unit.gain"]] == [0, 0.5]
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(package.AfmcalcError, match="pip install pandas"):
        swept.to_dataframe()


def test_a_clutch_shows_saves_plots_and_reports_itself(tmp_path, undrawn):
    text = (CONFIGS / "default.toml").read_text(encoding="utf-8")
    clutch = package.loads(text)
    shown = ["clutch: Base clutch, differentiated", "T: 118.52 N·m … 336.84 N·m", "K_T: 2.842"]
    assert repr(clutch).splitlines()[:3] == shown
    assert clutch.check().verdict.sentence in repr(clutch)
    ElementTree.fromstring(clutch._repr_html_())
    clutch.save(tmp_path / "same.toml")
    assert (tmp_path / "same.toml").read_text(encoding="utf-8").split() == text.split()
    clutch.with_(gain=0.7).save(tmp_path / "other.toml")
    other = (tmp_path / "other.toml").read_text(encoding="utf-8").splitlines()
    changed = [new for old, new in zip(text.splitlines(), other, strict=True) if old.split() != new.split()]
    assert changed == [line for line in other if line.startswith("gain = 0.7")]
    picture = clutch.plot("torque", tmp_path / "torque.png")
    assert ElementTree.fromstring(picture._repr_svg_()).tag.endswith("svg")
    assert (tmp_path / "torque.png").read_bytes()[:4] == b"\x89PNG"
    with pytest.raises(package.AfmcalcError, match=r"end it in \.svg"):
        clutch.plot("torque", tmp_path / "torque.gif")
    clutch.report(tmp_path / "r.html", short=True)
    assert "Base clutch" in (tmp_path / "r.html").read_text(encoding="utf-8")


def test_an_unknown_language_breaks_no_import(monkeypatch):
    monkeypatch.setenv("AFMCALC_LANG", "tlh")
    importlib.reload(importlib.import_module("afmcalc.python"))
    assert "nominal torque of the clutch" in str(package.load().torque())


def test_a_history_is_arrays(afmcalc, tmp_path):
    clutch = package.load("example:drive", DRIVE)
    one, every = clutch.history(0.3), clutch.history()
    afmcalc("simulate", "example:drive", "--set", "drive.event.duration=0.01", "--history", tmp_path / "h.csv")
    rows = list(csv.reader((tmp_path / "h.csv").read_text(encoding="utf-8").splitlines()))
    assert [name.partition(" ")[0] for name in rows[0]] == list(every)
    assert np.array_equal(np.array(rows[1:], float), np.column_stack(list(every.values())))
    assert np.array_equal(one["torque_shaft"], every["torque_shaft"][every["friction"] == 0.3])
    assert one["torque_shaft"].max() == pytest.approx(clutch.simulate().peak_torque.mean, rel=1e-3)


@pytest.mark.slow
def test_code_as_a_user_writes_it():
    """mypy checks its types."""
    runpy.run_path(str(ROOT / "tests" / "typed.py"))
