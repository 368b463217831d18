"""The print of the papers: every verdict on record, and numbers worked by hand.

``reproduce`` judges its claims by the equations, which tests/proofs proves. Here the program answers for clutches of the
papers what a pocket calculator does.
"""

import tomllib

import pytest
from sources import DATA

from afmcalc.papers import FIGURES
from afmcalc.papers.claims import claims, recorded_claims


@pytest.fixture(scope="module")
def rows():
    return {row.id: row for row in claims([])[0].rows}


def test_every_row_and_its_verdict(rows):
    result, findings = claims([])
    assert list(rows) == [f"P{k}" for k in range(1, 38)]
    assert {key: row.verdict for key, row in rows.items()} == {
        entry["id"]: entry["verdict"] for entry in recorded_claims()
    }
    assert result.as_expected
    assert findings == []


NUMBERS = tomllib.loads((DATA / "papers.toml").read_text(encoding="utf-8"))["by_hand"]


@pytest.mark.parametrize("line", NUMBERS)
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
    assert len(afmcalc("papers", "--claims", "--paper", "S19", "--json").json["result"]["rows"]) == 8
    assert [afmcalc("papers", "--claims", *wrong).code for wrong in (["--paper", "X"], ["--figure", "X-1"])] == [2, 2]
    entry = next(entry for entry in recorded_claims() if entry["id"] == "P9")
    monkeypatch.setitem(entry, "verdict", "not reproduced")
    run = afmcalc("papers", "--claims", "--paper", "S22", "--json")
    assert (run.code, [each["code"] for each in run.json["findings"]]) == (0, ["unexpected-verdict"])
