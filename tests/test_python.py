"""The package from Python."""

import copy
import doctest
import importlib
import json
import pickle
from xml.etree import ElementTree

import pytest
from conftest import CONFIGS
from sources import FILES

import afmcalc as package
from afmcalc.analysis.registry import ANALYSES
from afmcalc.render import renderer
from afmcalc.spec import resolved


@pytest.mark.parametrize("name", [name for name, file in FILES.items() if ">>> " in file.read_text(encoding="utf-8")])
def test_doctests(name):
    results = doctest.testmod(importlib.import_module(f"afmcalc.{name}".rstrip(".")))
    assert results.attempted > 0
    assert results.failed == 0


def test_public_names():
    names: dict[str, object] = {}
    exec("from afmcalc import *", names)
    assert set(package.__all__) <= set(names)
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        _ = package.nothing
    assert doctest.testmod(package).failed == 0
    with pytest.raises(package.SpecError):
        package.read_spec(None, ["C=-1"])


FEW = ("default", "drive", "indirect", "requirements")
"""Examples to which every analysis applies between them."""


@pytest.mark.parametrize(
    "spec",
    [
        pytest.param(path, id=path.stem, marks=[] if path.stem in FEW else pytest.mark.exhaustive)
        for path in sorted(CONFIGS.glob("*.toml"))
    ],
)
def test_what_python_answers_is_what_the_command_prints(spec, afmcalc):
    light = ["drive.event.duration=0.05"] if spec.stem == "drive" else []
    if spec.stem == "requirements":
        answers = {"design": package.design(spec)}
    else:
        clutch = package.build(package.read_spec(spec, light)) if light else package.load(spec)
        asked = [name for name in dir(clutch) if name in ANALYSES and ANALYSES[name].applies(clutch.engine)]
        assert {"torque", "accuracy", "check"} <= set(asked)
        answers = {name: getattr(clutch, name)() for name in asked if name not in ("solve", "explain", "tolerance")}
    for name, answer in answers.items():
        run = afmcalc(name, spec, "--json", *(part for each in light for part in ("--set", each)))
        assert json.loads(renderer("json")(answer, False)) == run.json
        assert answer.result.model_dump(mode="json") == run.json["result"]
        assert renderer("table")(answer, False) == str(answer)


def test_an_answer_shows_itself():
    clutch = package.build({**resolved(package.read_spec()), "name": "<b>"})
    swept = clutch.accuracy(sweep=["C=0,0.5", "z=4,8"])
    page = swept._repr_html_()
    ElementTree.fromstring(f"<div>{page}</div>")
    assert "<b>" not in page
    for entry in swept.sweep[0].values:
        assert f">{entry:g}<" in page
    assert swept.accuracy_factor == clutch.accuracy_factor == swept.result.accuracy_factor
    assert "accuracy_factor" in dir(swept)
    assert "accuracy" in dir(clutch)
    assert "accuracy_factor" in dir(clutch)
    with pytest.raises(AttributeError, match="nothing"):
        _ = clutch.nothing
    with pytest.raises(AttributeError, match="nothing"):
        _ = swept.nothing
    assert clutch.explain("torque").steps
    solved = clutch.solve("C", "accuracy_factor", 2.0)
    assert package.build(solved.spec).accuracy_factor == pytest.approx(2)
    assert [row.accuracy_factor for row in package.compare(clutch, CONFIGS / "default.toml").clutches] == [
        pytest.approx(clutch.accuracy_factor)
    ] * 2
    assert copy.copy(swept) == pickle.loads(pickle.dumps(swept)) == swept
