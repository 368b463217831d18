"""The printed figures: every row's verdict is the one on record, and rows hold the numbers of theory, section 8."""

import math
import re

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
    "P8": ["0.70, 0.98, 1.04", "39.5, 18.2, 16.3"],
    "P14": ["1.909", "1.640", "1.540", "1.794", "1.553", "1.467", "1.033", "1.018", "1.020", "1.117, 1.061, 1.068"],
    "P15": ["0.039", "-0.429", "0.182", "0.571"],
    "P16": ["0.213", "0.074", "0.055", "0.037", "1.846, 1.909, 1.922, 1.935"],
    "P17": ["1.264", "1.144", "4.167", "440", "3.5, 4.5, 5.5, 6.5"],
    "P18": ["0.800, 0.400, 0.200 with f_min 0.1", "0.800, 0.400, 0.200 with 0.2"],
    "P19": ["z = 3", "1.00"],
    "P20": ["0.267", "0.800", "2.400"],
    "P21": ["384.0", "386.9", "375.5", "320.0", "4.99, 4.50, 2.62"],
    "P22": ["8.197"],
    "P26": ["1.063, 1.094, 1.122, 1.137", "0.996"],
    "P27": ["1.790, 1.195", "1.088, 1.052", "80.0"],
    "P30": ["3.586, 3.397, 3.297", "1.946"],
    "P31": ["0.50"],
    "P32": ["0.50", "4.00"],
    "P33": ["6.000, 4.500, 5.428, 7.200"],
    "P34": ["2.40", "7.20", "2.75, 2.40, 2.17, 1.88", "6.65, 7.20, 7.63, 8.33"],
    "P36": ["0.200", "0.121"],
}


def test_every_row_and_its_verdict():
    result, findings = reproduce([])
    assert [row.id for row in result.rows] == [f"P{k}" for k in range(1, 38)]
    assert {row.id: row.verdict for row in result.rows} == {entry["id"]: entry["verdict"] for entry in claims()}
    assert result.as_expected
    assert (result.reproduced, result.corrected, result.not_reproduced, result.undecided) == (16, 12, 7, 2)
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


def numbers(text):
    return [float(number) for number in re.findall(r"(?<![\w.])-?\d+(?:\.\d+)?", text)]


def direct(f, z1, z2, gain):
    """T/(F_п R)."""
    return (z1 + z2) * f / (1 + z2 * gain * f)


def test_p14_and_p23_of_f11(computed):
    """With p where curve and line meet at n = 1.5, K_т(n) lies below its line for smaller n; larger p lowers K_т."""

    def factor(n, p, low, high, z1):
        return (z1 + 6 * n) * high * (1 + 7.5 * p * low) / ((z1 + 6 * p) * low * (1 + 7.5 * n * high))

    limits = ((0.10, 0.6), (0.14, 0.7), (0.16, 0.7), (0.16, 0.8))
    for (low, high), printed in zip(limits[:3], (1.033, 1.018, 1.020), strict=True):
        line = high * (1 + 7.5 * low) / (low * (1 + 7.5 * high))
        at_end = 10 * high / (low * (1 + 11.25 * high))
        p = (at_end - line) / (6 * line - 7.5 * low * at_end)
        assert p == pytest.approx(printed, abs=5e-4)
        assert f"{p:.3f}" in computed["P14"]
        assert factor(1.5, p, low, high, 1) == pytest.approx(line)
        assert all(factor(n, p, low, high, 1) < line for n in (0.5, 1, 1.4))
        # not for every p > 1: nearer to 1 the curve is above its line before n = 1.5
        assert factor(1.4, 1.01, low, high, 1) > line
    slopes = [
        (factor(1, 1 + 1e-6, *ends, z1) - factor(1, 1 - 1e-6, *ends, z1)) / 2e-6 for z1 in (2, 1) for ends in limits
    ]
    assert [f"{slope:.3f}" for slope in slopes] == re.findall(r"-0\.\d{3}", computed["P23"])


def test_p24_to_p26_of_s19(computed):
    """Both methods at T_н = 1: force 1/g(f_min), or 1.25/g(f_cp)."""
    middles = []
    for z in (12, 15, 19, 22, 8):
        least, mean, most = (direct(f, 1, z - 1, 1.6) for f in (0.15, 0.33, 0.625))
        middles.append(1.25 / mean * (least + most) / (1 / least * (least + most)))
    assert numbers(computed["P26"])[:4] == pytest.approx(middles[:4], abs=5e-4)
    assert f"{middles[4]:.3f} for z = 8" in computed["P26"]
    assert computed["P24"].endswith("= 1.000, 1.000, 1.000, 1.000")
    assert "940" in computed["P25"]
    assert "750" in computed["P25"]


def sleeve(gain, f, c1=20e3):
    """Torque, travel (S21 (10), (11), set at 0.1 with F_п1 = 1 kN), with the key's friction as printed."""
    control = 1000 * (1 + 0.8 * gain) - 2 * 8 * 1000 * 0.1 * 0.1 * 0.15 / 0.05
    stiffness = (1 + 8 * gain * f) * c1 + 10e3 - 2 * 8 * 0.1 * c1 * f * 0.15 / 0.05
    travel = ((1 + 8 * gain * f) * 1000 - control - 2 * 8 * 1000 * 0.1 * f * 0.15 / 0.05) / stiffness
    return 8 * 0.1 * f * (1000 - c1 * travel), travel


def test_p27_to_p30_of_s21(computed):
    """By the balance (9), (10) as printed: torques, pockets and contact force on a grid of the gain."""
    for gain in (1, 4, 12):
        assert sleeve(gain, 0.1)[0] == pytest.approx(80)
        assert f"{sleeve(gain, 0.8)[0] / 80:.3f}" in computed["P27"]
        assert f"{sleeve(gain, 0.8)[0] * gain / 0.1 / 1000:.2f} kN" in computed["P28"]
    for stiffness in (20e3, 30e3, 40e3):
        assert f"{sleeve(1, 0.8, stiffness)[0] / 80:.3f}" in computed["P30"]

    def depth(gain):
        sine = math.sin(math.atan(gain / 2))
        return (sleeve(gain, 0.8)[1] + 0.006) / (2 * sine**2) - 0.001

    deepest, shallowest = 0.79, 37.8
    assert f"from C = {deepest} to {shallowest};" in computed["P28"]
    assert depth(deepest) > max(depth(deepest - 0.02), depth(deepest + 0.02))
    assert depth(shallowest) < min(depth(shallowest - 1), depth(shallowest + 1))

    def contact(gain):
        return sleeve(gain, 0.8)[0] / (0.05 * math.cos(math.atan(gain / 2)))

    assert contact(2.24) < min(contact(2.2), contact(2.28))
    assert f"{contact(2.24) / 1000:.2f} kN, and {contact(60) / 1000:.2f} kN" in computed["P29"]


def overload(f, reduced, margin=1.25, low=0.1):
    """T_п, T_муф and the published T_ср = T_п − ΔT', over z F_п R, from S22 (1)–(13)."""
    nominal = low / (1 + reduced * low)
    machine = nominal / margin
    potential = f * (1 - reduced * machine)
    return potential, f / (1 + reduced * f), potential - (potential - machine) / (1 + reduced * f)


def test_p21_and_p31_to_p37_of_s22(computed):
    """From the balance: N = F_п − zC T/(z R), with the load T; not from (15) or (23)."""
    for reduced in (5, 1.6):
        torques = [800 * overload(0.8, reduced * (1 - z1 / 4))[2] for z1 in range(4)]
        for torque in torques:
            assert f"{torque:.1f}" in computed["P21"]
        assert (torques[1] > torques[0]) == (reduced == 5)
        assert max(torques[2:]) < torques[0]
    # T_ср is larger with z_1 up to 3z/8
    assert overload(0.8, 5 * (1 - 0.374))[2] > overload(0.8, 5)[2] > overload(0.8, 5 * (1 - 0.376))[2]

    def actual(reduced):
        return max(overload(0.8, reduced)[1:]) / overload(0.1, reduced)[1]

    assert [actual(k) for k in (0.5, 1.25, 2, 5)] == pytest.approx([6, 4.5, 5.428, 7.2], abs=5e-4)
    for z in (4, 5, 6, 8):
        reduced = 1.25 * (z - 1)
        expected = overload(0.8, reduced)[1] / overload(0.1, reduced)[1]
        for accuracy in (expected, actual(reduced)):
            assert any(abs(number - accuracy) < 0.0051 for number in numbers(computed["P34"]))
        # never both: more accurate than K_т 2.4 and 7.2 of the all-driving clutch at zC = 5
        assert not (expected > 2.4 + 1e-9 and actual(reduced) > 7.2 + 1e-9)
    assert [round(800 * overload(0.8, 5 * (1 - z1 / 4))[0]) for z1 in range(4)] == [469, 500, 538, 583]
    assert "469 N·m; z_1 = 1, 2, 3: 500 N·m, 538 N·m, 583 N·m" in computed["P35"]
    # 55 f² − 5 f − 0.2 = 0 is T_ср = T_н.муф at zC = 5
    assert (5 + math.sqrt(69)) / 110 == pytest.approx(0.121, abs=5e-5)
    assert overload(0.121, 5)[2] == pytest.approx(overload(0.1, 5)[1], rel=1e-3)
    assert overload(0.2, 5)[2] == pytest.approx(overload(0.2, 5)[1])
    for margin in (1, 1.25):
        assert f"{800 * overload(0.8, 5, margin)[0]:.0f} N·m" in computed["P37"]
        for f in (0.1, 0.15, 0.2, 0.4, 0.8):
            _, expected, published = overload(f, 5, margin)
            assert f"{published / expected:.3f}" in computed["P37"]


def test_inputs_stand_in_the_table(afmcalc):
    """What is assumed is told beside each verdict, with a mark where the paper does not print it."""
    assert "(not printed)" in afmcalc("reproduce", "--paper", "S19").out


def test_the_command(afmcalc):
    assert afmcalc("reproduce").code == 0
    assert len(afmcalc("reproduce", "--paper", "S19", "--json").json["result"]["rows"]) == 8
    assert len(afmcalc("reproduce", "--format", "csv").out.splitlines()) == 38
    assert afmcalc("reproduce", "--paper", "X").code == 2
