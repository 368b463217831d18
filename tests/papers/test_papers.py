"""What the papers print: every verdict on record, and numbers worked by hand.

``reproduce`` judges its claims by the equations, which tests/proofs proves. Here the program answers for clutches of the
papers what a pocket calculator does, and tells what the theory has in its section 8.
"""

import re

import numpy as np
import pytest

from afmcalc.papers import FIGURES
from afmcalc.papers.claims import claims, paper_figure, recorded_claims


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


COMPUTED = """
P1: 8.197 9.225 | P2: 21.43 | P3: 1.444 1.267 9.08 4.13 | P4: 1.063 1.094 1.122 1.137 | P5: 1.088 1.052 1.034 1.031
P6: 1.790 1.381 1.180 1.179 | P7: 1.946 3.586 | P8: 0.70 0.98 1.04 39.5 18.2 16.3 | P9: 3.000 | P10: 1.250 1.225
P11: 0.200 | P14: 1.909 1.640 1.540 1.794 1.553 1.467 1.033 1.018 1.020 1.117 1.061 1.068 | P15: 0.039 -0.429 0.182 0.571
P16: 0.213 0.074 0.055 0.037 1.846 1.909 1.922 1.935 | P17: 1.264 1.144 4.167 440 3.5 4.5 5.5 6.5 | P18: 0.800 0.400 0.200
P19: 3 1.00 | P20: 0.267 0.800 2.400 | P21: 384.0 386.9 375.5 320.0 4.99 4.50 2.62 | P24: 1.000 | P25: 940 750
P26: 1.063 1.094 1.122 1.137 0.996 | P27: 1.790 1.195 1.088 1.052 80.0 | P28: 0.79 37.8 | P30: 3.586 3.397 3.297 1.946
P31: 0.50 | P32: 0.50 4.00 | P33: 6.000 4.500 5.428 7.200 | P34: 2.40 7.20 2.75 2.17 1.88 6.65 7.63 8.33
P35: 469 500 538 583 | P36: 0.200 0.121
"""
"""Row → numbers it tells, from the theory, section 8."""


def test_figures_of_the_theory(rows):
    for entry in COMPUTED.replace("\n", " | ").strip(" |").split(" | "):
        key, _, numbers = entry.partition(": ")
        assert set(numbers.split()) <= set(re.findall(r"-?\d+(?:\.\d+)?", str(rows[key].computed))), key


NUMBERS = """
# S21 (15), 8 (30 + 16·0.4)/(30 + 128·0.4), with C = 2, 4 and with c_1 doubled; hysteresis by the theory, section 5
accuracy example:shishkarev2021 --set C=2 | accuracy_factor | 2.0038
accuracy example:shishkarev2021 --set C=4 | accuracy_factor | 1.4513
accuracy example:shishkarev2021 --set c1=40e3 | accuracy_factor | 3.2966
accuracy example:shishkarev2021 | accuracy_factor_hysteresis | 5.478
# (4), (14): T_н = z F_п1 R f_min whatever C; F_п2 = 400 (1 + 8·0.1·0.4); set at 0.3 the stop still bears at 0.1
torque example:shishkarev2021 --set C=3 | nominal_torque | 32
torque example:shishkarev2021 | control_force | 528
torque example:shishkarev2021 --set adjustment.method=mean-friction --set friction.mean=0.3 | torque/min | 47.515
# S22 figs 3, 4 (M13, M14): 1.225 apart at zC = 1.6, level at 1.25, 3 times at 5
overload example:shishkarev2022-fig3 | optimal_reduced_gain | 1.25
overload example:shishkarev2022-fig3 --set C=0.3125 | accuracy_factor_actual | 4.5
overload example:shishkarev2022-fig3 --set C=1.25 | accuracy_factor_actual | 7.2
overload example:shishkarev2022-fig3 --set C=1.25 | accuracy_factor_expected | 2.4
overload example:shishkarev2022-fig4 --set z1=2 --set C=0.625 | actuation_factor/max | 1
overload example:shishkarev2022-fig4 --set z1=3 --set C=0.4166667 | actuation_factor/max | 0.4187
# F11 fig. 2 (M4): 66 (1 + 7.5·0.1033)/(8.198·7.75) as printed, and with z_1 = 1 at n = 1.5, line 5
accuracy example:fokin2011-fig2 --set z=7 --set z1=1 | accuracy_factor | 1.909
# S19: P1 (M7), P4; without feedback ΔT = 200 (f_max/f_min − 1) is 500 N·m: N = 10⁷ (12000/900)⁶
adjust example:shishkarev2019-fig2 --set C=1.4 | pairs_threshold | 9.225
adjust example:shishkarev2019-fig2 --set z=22 | scatter_ratio | 1.137
life example:shishkarev2019-fig2 --model mean-stress --set C=0 --set friction.max=0.525 | protected/min_friction | 5.61866e13
# theory, section 3: z_1 f_max (1 + z_2 C f_min)/(z f_min) by peaks; (14) below 1
accuracy example:default --set C=2.5 | accuracy_factor | 1.467
accuracy example:default --set C=2.5 | accuracy_factor_peak | 2.75
accuracy example:unlike-materials --set z=7 --set C=3 --set friction.driving={min=0.5,max=0.6} --set friction.driven={min=0.1,max=0.6} | accuracy_factor | 1.104
"""


@pytest.mark.parametrize("line", [line for line in NUMBERS.strip().splitlines() if not line.startswith("#")])
def test_by_hand(line, answered):
    command, path, number = line.split(" | ")
    found = answered(*command.split(), "--json").json["result"]
    for key in path.split("/"):
        found = found[key]
    assert found == pytest.approx(float(number), rel=4e-4)


CURVES = [
    ("F11-2", "5", 0, {1: 1.9091}), ("F11-2", "6", 0, {1: 1.64}), ("F11-2", "7", 0, {1: 1.54}),
    # (17) with p = 1.03271 for curve 1; p = 1.01961 of curve 3 for line 4, which is then 5 (1 + 1.2 p)/(1 + 6 p)
    ("F11-2", "1", 0, {n: 6 * (1 + 6 * n) * 1.774533 / (7.19626 * (1 + 4.5 * n)) for n in (0.5, 1, 1.5)}),
    ("F11-2", "4", 0, dict.fromkeys((0.5, 1, 1.5), 5 * 2.223532 / 7.11766)),
    # N = 10⁷ (12000/(400 + ΔT))⁶
    ("S19-2", "a", 0, {band: 1e7 * (12000 / (400 + band)) ** 6 for band in (500, 700, 1100)}),
    ("S19-2", "2", 0, {band: 1e7 * (12000 / (800 + band)) ** 6 for band in (500, 700, 1100)}),
    ("S21-2", "1", 0, {2: 2.004, 4: 1.451, 8: 1.215}), ("S21-2", "3", 0, {2: 1.857, 4: 1.38, 8: 1.18}),
    ("S21-2", "4", 0, {2: 2.6, 4: 4.2, 8: 7.4}), ("S21-2", "5", 0, {2: 1.507, 4: 1.263, 8: 1.134}),
    ("S21-4", "1", 0, {18.2: 0.02474}),
    ("S22-2", "1", 0, {5: 0.765625}), ("S22-2", "2", 0, {5: 0.25}),
    ("S22-2", "3", 1, {5: 0.0727}), ("S22-2", "5", 1, {5: 0.1333}), ("S22-2", "4, 6", 1, {5: 0.2}),
    ("S22-3", "1", 0, {0.5: 6, 1: 44 / 9, 1.25: 4.5, 2: 5.428, 5: 7.2}),
    ("S22-3", "2", 0, {0.5: 6, 1: 44 / 9, 1.25: 4.5, 2: 3.692, 5: 2.4}),
    ("S22-4", "2", 0, {1: 1.225, 2: 1.0, 3: 0.4187}), ("S22-4", "1", 0, {1: 1.225}), ("S22-4", "1'", 0, {1: 3.0}),
]  # fmt: skip
"""Figure, curve, panel, ordinates by hand."""


@pytest.mark.parametrize(("name", "number", "panel", "points"), CURVES)
def test_curves_by_hand(name, number, panel, points):
    (curve,) = (curve for curve in paper_figure(name).panels[panel] if curve.number == number)
    assert np.interp(list(points), curve.x, curve.y) == pytest.approx(list(points.values()), rel=1.5e-3)


@pytest.mark.parametrize(("printed", "doubled"), [(1.03, False), (1.18, True)])
def test_an_undecided_average_depends_on_the_axis(printed, doubled):
    """P5, P6: some ranges of C give the printed average to its last place, others do not: nothing is decided."""

    def factor(gain, c1):
        least, most = (c1 + 10e3 + 8 * c1 * f * (gain - 0.6) for f in (0.1, 0.8))
        return 8 * least / most

    def average(low, high):
        gain = low + (high - low) * (np.arange(4000) + 0.5) / 4000
        return (factor(gain, 20e3) / (factor(2 * gain, 20e3) if doubled else factor(gain, 40e3))).mean()

    half = 2 if doubled else 1
    off = [abs(average(low, high / half) - printed) for low, high in ((3, 12), (1.5, 19), (1, 6), (6, 20))]
    assert [each < 0.005 for each in off] == [True, True, False, False]


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
