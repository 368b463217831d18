"""The register: every formula and misprint has the function and the test that it names."""

import re
from inspect import getsource

from conftest import ROOT
from proofs.symbols import proofs

from afmcalc.equations.catalogue import equations
from afmcalc.papers import FIGURES
from afmcalc.papers.claims import paper_figure
from afmcalc.papers.register import data, is_accounted, is_numbered, misprints, register

NUMBERED = {"F11": 22, "S19": 20, "S21": 24, "S22": 24}
BEYOND = r"andbook|Convention|ISO|As ``|erivative|Definition|Johnson|Juvinall|Goodman|Серенсен|Identity|Geometry|F11|S19|S21|S22"
"""References of the source of an equation that no entry of the register has."""


def test_every_numbered_formula_is_in_the_register():
    ids = [entry.id for entry in register()]
    assert len(ids) == len(set(ids))
    for paper, count in NUMBERED.items():
        assert [i for i in ids if i.startswith(f"{paper} (")] == [f"{paper} ({k})" for k in range(1, count + 1)]
    assert all(map(is_accounted, filter(is_numbered, register())))
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
