"""The papers: every recorded verdict, numbers worked out by hand, the function and the proof of each formula.

``papers --claims`` judges its claims by the equations, which tests/proofs proves. Here the program answers for clutches
of the papers what a pocket calculator does.
"""

import re
from inspect import getsource

import pytest
from conftest import ROOT
from proofs.symbols import proofs
from sources import table

from afmcalc.equations.catalogue import equations
from afmcalc.papers import FIGURES
from afmcalc.papers.claims import claims, paper_figure
from afmcalc.papers.register import data, misprints, papers, register


@pytest.fixture(scope="module")
def rows():
    return {row.id: row for row in claims([])[0].rows}


def test_every_row_and_its_verdict(rows):
    result, findings = claims([])
    assert list(rows) == [f"P{k}" for k in range(1, 50)]
    assert {key: row.verdict for key, row in rows.items()} == {
        entry["id"]: entry["verdict"] for entry in data("claims.toml")["claim"]
    }
    assert result.as_expected
    assert findings == []


@pytest.mark.parametrize("line", table("papers")["by_hand"])
def test_by_hand(line, answered):
    command, path, number = line.split(" | ")
    found = answered(*command.split(), "--json").json["result"]
    for key in path.split("/"):
        found = found[key]
    assert found == pytest.approx(float(number), rel=4e-4)


def test_the_command(afmcalc, monkeypatch):
    result = afmcalc("papers", "--claims", "--paper", "S22", "--figure", "S22-3", "--json").json["result"]
    lowest = min((point for point in result["points"] if point["curve"] == "1"), key=lambda point: point["y"])
    assert (lowest["x"], lowest["y"]) == (pytest.approx(1.25, abs=0.02), pytest.approx(4.5, abs=0.02))
    curves = {
        row["figure"].replace(" fig. ", "-") for row in afmcalc("papers", "--claims", "--json").json["result"]["curves"]
    }
    assert curves == set(FIGURES)
    assert len(afmcalc("papers", "--claims", "--paper", "S19", "--json").json["result"]["rows"]) == 12
    assert [afmcalc("papers", "--claims", *wrong).code for wrong in (["--paper", "X"], ["--figure", "X-1"])] == [2, 2]
    entry = next(entry for entry in data("claims.toml")["claim"] if entry["id"] == "P9")
    monkeypatch.setitem(entry, "verdict", "not reproduced")
    run = afmcalc("papers", "--claims", "--paper", "S22", "--json")
    assert (run.code, [each["code"] for each in run.json["findings"]]) == (0, ["unexpected-verdict"])


NUMBERED = {"F11": 22, "S19": 20, "S21": 24, "S22": 24}
BEYOND = r"andbook|Convention|ISO|As ``|erivative|Definition|Johnson|Juvinall|Goodman|Серенсен|Identity|Geometry|F11|S19|S21|S22"
"""Words in the source of an equation that is not a formula of the papers, so has no entry in the register."""


def test_every_numbered_formula_is_in_the_register():
    ids = [entry.id for entry in register()]
    assert len(ids) == len(set(ids))
    for paper, count in NUMBERED.items():
        assert [i for i in ids if i.startswith(f"{paper} (")] == [f"{paper} ({k})" for k in range(1, count + 1)]
    result, _ = papers([], [])
    assert result.numbered == result.accounted
    named = {entry.function for entry in register()}
    assert not [e.name for e in equations().values() if e.name not in named and not re.search(BEYOND, e.source)]


def test_the_register_claims_nothing_that_is_not_there():
    known, tests = {m.id for m in misprints()}, proofs()
    for entry in register():
        assert entry.function is None or entry.function in equations(), entry.id
        assert entry.proof is None or entry.proof in tests, entry.id
        assert entry.status != "covered" or entry.covered_by, entry.id
        assert entry.status != "mended" or (entry.correct and entry.proof and entry.misprint), entry.id
        assert {*(entry.misprint or "").split(", ")} - {""} <= known, entry.id


def test_a_misprint_is_shown_by_a_test_that_speaks_of_it():
    tests = proofs()
    for misprint in misprints():
        if misprint.proof:
            shown = getsource(tests[misprint.proof])
            assert re.search(rf"\b{misprint.id}\b", shown), f"{misprint.proof} does not speak of {misprint.id}"


def test_nothing_rests_on_a_withdrawn_misprint():
    used = {name for entry in register() for name in (entry.misprint or "").split(", ")} - {""}
    used |= set(re.findall(r"M\d+", " ".join(text for name in FIGURES for text in paper_figure(name).corrections)))
    used |= set(re.findall(r"M\d+", " ".join(text for each in data("claims.toml")["claim"] for text in each.values())))
    assert used <= {m.id for m in misprints() if m.status != "withdrawn"}


def test_the_command_counts_90_of_90(afmcalc):
    told = afmcalc("papers", "--json").json["result"]
    assert (told["numbered"], told["accounted"]) == (90, 90)
    (only,) = afmcalc("papers", "--id", "S21 (15)", "--json").json["result"]["formulas"]
    assert only["misprint"] == "M9"
    assert (ROOT / only["proof"].partition("::")[0]).is_file()
    assert len(afmcalc("papers", "--misprints", "--json").json["result"]["misprints"]) == len(misprints())
    refused = [afmcalc("papers", *given) for given in (["--paper", "S20"], ["--id", "S21 (99)"])]
    assert [run.code for run in refused] == [2, 2]
    assert "did you mean" in refused[1].err
