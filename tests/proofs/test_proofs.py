"""Every proof runs; every equation, register entry and misprint has what it claims to have."""

import re
from functools import cache

import pytest
from conftest import ROOT

from afmcalc.equations.catalogue import equations
from afmcalc.papers import FIGURES
from afmcalc.papers.claims import paper_figure
from afmcalc.papers.register import data, is_accounted, is_numbered, misprints, register
from afmcalc.proofs import ProofError, Refutation, is_zero, proofs, prove

NUMBERED = {"F11": 22, "S19": 20, "S21": 24, "S22": 24}


proved = cache(prove)


@pytest.mark.parametrize("name", sorted(proofs()))
def test_proof(name):
    assert proved(name)


def test_a_wrong_identity_and_a_right_refutation_fail(monkeypatch):
    import sympy

    x = sympy.Symbol("x")
    monkeypatch.setitem(proofs(), "wrong", lambda: iter([("x = 0", x)]))
    with pytest.raises(ProofError, match="x = 0"):
        prove("wrong")
    assert is_zero((x + 1) ** 2 - x**2 - 2 * x - 1)
    assert not is_zero(x)


def test_every_numbered_formula_is_in_the_register():
    ids = [entry.id for entry in register()]
    assert len(ids) == len(set(ids))
    for paper, count in NUMBERED.items():
        assert [i for i in ids if i.startswith(f"{paper} (")] == [f"{paper} ({k})" for k in range(1, count + 1)]
    numbered = [entry for entry in register() if is_numbered(entry)]
    assert len(numbered) == 90
    assert all(map(is_accounted, numbered))


def test_the_register_claims_nothing_that_is_not_there():
    known_misprints = {m.id for m in misprints()}
    for entry in register():
        assert entry.function is None or entry.function in equations(), entry.id
        assert entry.proof is None or entry.proof in proofs(), entry.id
        if entry.status == "as printed":
            assert entry.function or entry.covered_by or entry.proof or "recommended" in entry.id, entry.id
        if entry.status == "covered":
            assert entry.covered_by, entry.id
        if entry.status == "mended":
            assert entry.correct, entry.id
            assert entry.proof, entry.id
            assert entry.misprint, entry.id
        for misprint in (entry.misprint or "").split(", "):
            assert not misprint or misprint in known_misprints, entry.id


def test_misprints_are_numbered_through_and_their_proofs_exist():
    assert [m.id for m in misprints()] == [f"M{k}" for k in range(1, 54)]
    without = {m.id for m in misprints() if m.proof is None and m.status != "withdrawn"}
    assert without == {"M28", "M37", "M39", "M40", "M41", "M42", "M52", "M53"}, "slips of wording and notation only"
    for misprint in misprints():
        if misprint.proof:
            shown = " ".join(proved(misprint.proof))
            assert re.search(rf"\b{misprint.id}\b", shown), f"{misprint.proof} does not speak of {misprint.id}"


def test_what_does_not_stand_in_print_says_so():
    other = {m.id: m.status for m in misprints() if m.status != "in print"}
    assert {name for name, status in other.items() if status == "as extracted"} == {
        "M15",
        "M16",
        "M31",
        "M39",
        "M41",
        "M45",
    }
    assert {name for name, status in other.items() if status == "criticism"} == {"M22", "M48"}
    withdrawn = {name for name, status in other.items() if status == "withdrawn"}
    assert withdrawn == {"M25", "M34", "M35", "M47"}
    assert all(m.proof is None for m in misprints() if m.id in withdrawn)
    used = {name for entry in register() for name in (entry.misprint or "").split(", ")}
    used |= set(re.findall(r"M\d+", " ".join(text for name in FIGURES for text in paper_figure(name).corrections)))
    claims = " ".join(text for entry in data("claims.toml")["claim"] for text in entry.values())
    used |= set(re.findall(r"M\d+", claims))
    assert used - {""} <= {m.id for m in misprints()}
    assert not withdrawn & used, "nothing rests on a withdrawn one"


def test_the_readme_counts_the_misprints():
    """Standing, proved, and proved by a refutation that names it."""
    standing = [m for m in misprints() if m.status in ("in print", "as extracted")]
    proved = [m for m in standing if m.proof]
    refuted = [m for m in proved if re.search(rf"\b{m.id}\b", _refutations(m.proof))]
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    (counts,) = re.findall(r"`--misprints` \((\d+), of them (\d+) proved, (\d+) by refuting", readme)
    assert tuple(map(int, counts)) == (len(standing), len(proved), len(refuted))


def _refutations(name):
    return " ".join(step.statement for step in proofs()[name]() if isinstance(step, Refutation))


def test_every_equation_of_the_papers_stands_in_the_register():
    """Functions beyond the papers say so in their source; all others are named by an entry or a proof's paper."""
    named = {entry.function for entry in register()}
    for equation in equations().values():
        if equation.name in named:
            continue
        beyond = (
            "andbook",
            "erivative",
            "Definition",
            "Johnson",
            "Juvinall",
            "Goodman",
            "Серенсен",
            "Identity",
            "Geometry",
        )
        assert any(word in equation.source for word in (*beyond, "F11", "S19", "S21", "S22")), equation.name


def test_the_command_counts_90_of_90(afmcalc):
    out = afmcalc("equations").out
    assert "numbered formulas in the papers asked for     90" in out
    assert "of them implemented or covered                90" in out
    result = afmcalc("equations", "--id", "S21 (15)", "--prove", "--json").json["result"]
    assert result["formulas"][0]["misprint"] == "M9"
    assert "M9" in result["proved"][0]["shows"]
    assert len(afmcalc("equations", "--misprints", "--json").json["result"]["misprints"]) == len(misprints())
    assert afmcalc("equations", "--paper", "S20").code == 2
    missing = afmcalc("equations", "--id", "S21 (99)")
    assert missing.code == 2
    assert "did you mean" in missing.err
