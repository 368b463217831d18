"""The printed figures: every row's verdict is the one on record, and rows hold the numbers of theory, section 8."""

import pytest

from afmcalc.papers.claims import claims, reproduce

FIGURES = {
    "P1": ["8.197", "9.225"],
    "P2": ["21.43"],
    "P3": ["1.444", "1.267", "9.08", "4.13"],
    "P4": ["1.063", "1.094", "1.122", "1.137"],
    "P5": ["1.088", "1.052", "1.034, 1.031"],
    "P6": ["1.790", "1.381", "1.180, 1.179"],
    "P7": ["1.946", "3.586"],
    "P9": ["3.000"],
    "P10": ["1.250", "1.225"],
    "P11": ["0.200"],
    "P14": ["1.909", "1.640", "1.540", "1.794", "1.553", "1.467", "1.033", "1.018", "1.020", "1.117, 1.061, 1.068"],
    "P15": ["0.039", "-0.429", "0.182", "0.571"],
    "P16": ["0.213", "0.055", "0.037"],
    "P17": ["1.264", "1.144", "4.167", "440"],
    "P19": ["z = 3", "1.00"],
    "P20": ["0.267", "0.800", "2.400"],
    "P21": ["4.99", "4.50", "2.62", "6.25"],
    "P22": ["8.197"],
}


def test_every_row_and_its_verdict():
    result, findings = reproduce([])
    assert [row.id for row in result.rows] == [f"P{k}" for k in range(1, 23)]
    assert {row.id: row.verdict for row in result.rows} == {entry["id"]: entry["verdict"] for entry in claims()}
    assert result.as_expected
    assert (result.reproduced, result.corrected, result.not_reproduced, result.undecided) == (6, 6, 8, 2)
    assert {row.id for row in result.rows if row.verdict == "undecided"} == {"P5", "P6"}
    assert findings == []


@pytest.fixture(scope="module")
def computed():
    return {row.id: row.computed for row in reproduce([])[0].rows}


@pytest.mark.parametrize("name", FIGURES)
def test_figures_of_the_theory(name, computed):
    for figure in FIGURES[name]:
        assert figure in computed[name]


def test_an_unexpected_verdict_is_an_error_that_only_check_would_fail_on(afmcalc, monkeypatch):
    entry = next(entry for entry in claims() if entry["id"] == "P9")
    monkeypatch.setitem(entry, "verdict", "not reproduced")
    run = afmcalc("reproduce", "--paper", "S22")
    assert run.code == 0
    assert "error: P9: reproduced; on record is: not reproduced [unexpected-verdict]" in run.out


def test_curves_of_the_figures(afmcalc):
    result = afmcalc("reproduce", "--paper", "S22", "--figure", "S22-3", "--json").json["result"]
    actual = [point for point in result["points"] if point["curve"] == "1"]
    lowest = min(actual, key=lambda point: point["y"])
    assert (lowest["x"], lowest["y"]) == (pytest.approx(1.25, abs=0.02), pytest.approx(4.5, abs=0.02))
    rows = {(row["figure"], row["curve"]): row for row in afmcalc("reproduce", "--json").json["result"]["curves"]}
    assert {figure for figure, _ in rows} == {
        f"{paper} fig. {n}"
        for paper, n in (("F11", 2), ("S19", 2), ("S21", 2), ("S21", 4), ("S22", 1), ("S22", 2), ("S22", 3), ("S22", 4))
    }
    assert rows["F11 fig. 2", "5"]["first"] == pytest.approx(1.909, abs=5e-4)
    assert rows["S19 fig. 2", "a"]["first"] / rows["S19 fig. 2", "a"]["last"] == pytest.approx(21.43, abs=5e-3)
    csv = afmcalc("reproduce", "--figure", "S22-1", "--format", "csv").out.splitlines()
    assert csv[0].startswith("figure,curve")
    assert afmcalc("reproduce", "--figure", "X-1").code == 2


@pytest.mark.parametrize("row", ["P5", "P6"])
def test_an_undecided_average_depends_on_the_axis(row):
    """Some ranges of C give the printed average to its last place, others do not: nothing is decided."""
    printed, doubled = {"P5": (1.03, False), "P6": (1.18, True)}[row]

    def ratio(gain):
        def factor(gain, c1):
            least, most = (c1 + 10e3 + 8 * c1 * f * (gain - 0.6) for f in (0.1, 0.8))
            return 8 * least / most

        return factor(gain, 20e3) / (factor(2 * gain, 20e3) if doubled else factor(gain, 40e3))

    def average(low, high):
        grid = [low + (high - low) * (k + 0.5) / 4000 for k in range(4000)]
        return sum(map(ratio, grid)) / len(grid)

    half = 2 if doubled else 1
    for low, high in ((3, 12), (1.5, 19)):
        assert abs(average(low, high / half) - printed) < 0.005
    for low, high in ((1, 6), (6, 20)):
        assert abs(average(low, high / half) - printed) > 0.005


def test_the_command(afmcalc):
    assert afmcalc("reproduce").code == 0
    assert len(afmcalc("reproduce", "--paper", "S19", "--json").json["result"]["rows"]) == 5
    assert len(afmcalc("reproduce", "--format", "csv").out.splitlines()) == 23
    assert afmcalc("reproduce", "--paper", "X").code == 2
