"""The papers' figures: what the formulas give at points calculated independently, and what is mended named."""

import re

import numpy as np
import pytest

from afmcalc.papers import FIGURES
from afmcalc.papers.claims import paper_figure


def at(name, number, x, panel=0):
    """Ordinate of a curve, by its number, where it is at x."""
    curve = next(curve for curve in paper_figure(name).panels[panel] if curve.number == number)
    return float(np.interp(x, curve.x, curve.y))


def test_f11_fig_2():
    """P13, P14: curves 1–3 rise, 4 is level, lines 5–7 at 1.909, 1.640, 1.540."""
    assert [at("F11-2", line, 1) for line in "567"] == pytest.approx([1.9091, 1.64, 1.54], abs=5e-5)
    for curve, line in (("1", "5"), ("2", "6"), ("3", "7")):
        assert at("F11-2", curve, 1.5) == pytest.approx(at("F11-2", line, 1.5), abs=1e-6)
        assert at("F11-2", curve, 0.5) < at("F11-2", curve, 1) < at("F11-2", line, 1)
    # (17) by hand: p = 1.03271 for curve 1; p = 1.01961 of curve 3 for line 4, which is then 5 (1 + 1.2 p)/(1 + 6 p)
    by_hand = [6 * (1 + 6 * n) * 1.774533 / (7.19626 * (1 + 4.5 * n)) for n in (0.5, 1, 1.5)]
    assert [at("F11-2", "1", n) for n in (0.5, 1, 1.5)] == pytest.approx(by_hand, abs=5e-5)
    assert [at("F11-2", "4", n) for n in (0.5, 1, 1.5)] == pytest.approx([5 * 2.223532 / 7.11766] * 3, abs=5e-5)


def test_s19_fig_2():
    """P2, P3: N = 10⁷ (12000/(400 + ΔT))⁶."""
    for band in (500, 700, 1100):
        assert at("S19-2", "a", band) == pytest.approx(1e7 * (12000 / (400 + band)) ** 6)
        assert at("S19-2", "2", band) == pytest.approx(1e7 * (12000 / (800 + band)) ** 6)
    assert at("S19-2", "b", 627) == pytest.approx(1e7 * (12000 / 1027) ** 6)


def test_s21_fig_2():
    gains = (2, 4, 8)
    assert [at("S21-2", "1", gain) for gain in gains] == pytest.approx([2.004, 1.451, 1.215], abs=2e-3)
    assert [at("S21-2", "3", gain) for gain in gains] == pytest.approx([1.857, 1.38, 1.18], abs=2e-3)
    assert [at("S21-2", "4", gain) for gain in gains] == pytest.approx([2.6, 4.2, 7.4])
    assert [at("S21-2", "5", gain) for gain in gains] == pytest.approx([1.507, 1.263, 1.134], abs=2e-3)


def test_s21_fig_4():
    """P8: travel grows, the ball radius rises to 37.6 mm near C = 1 and falls to 24.7 mm near C = 18."""
    radius, travel = paper_figure("S21-4").panels[0]
    assert np.all(np.diff(travel.y) > 0)
    assert max(radius.y) == pytest.approx(0.03757, abs=5e-5)
    assert radius.x[int(np.argmax(radius.y))] == pytest.approx(0.979, abs=0.06)
    assert at("S21-4", "1", 18.2) == pytest.approx(0.02474, abs=1e-5)


def test_s22_fig_1():
    """P19: reconstructed, the minimum at z = 3 is f = 1.0."""
    points = next(curve for curve in paper_figure("S22-1").panels[0] if curve.points)
    assert dict(zip(points.x, points.y, strict=True))[3.0] == pytest.approx(1.0)
    assert min(points.y) == pytest.approx(1.0)
    assert points.y[:6] == pytest.approx([1.2, 1.0, 1.0667, 1.2, 1.36, 1.5333], abs=5e-5)


def test_s22_fig_2():
    assert [at("S22-2", curve, 5) for curve in "12"] == pytest.approx([0.765625, 0.25])
    assert [at("S22-2", curve, 5, panel=1) for curve in "35"] == pytest.approx([0.0727, 0.1333], abs=5e-5)
    assert at("S22-2", "4, 6", 5, panel=1) == pytest.approx(0.2)


def test_s22_fig_3():
    reduced = (0.5, 1, 1.25, 2, 5)
    assert [at("S22-3", "1", w) for w in reduced] == pytest.approx([6, 44 / 9, 4.5, 5.428, 7.2], abs=5e-4)
    assert [at("S22-3", "2", w) for w in reduced] == pytest.approx([6, 44 / 9, 4.5, 3.692, 2.4], abs=5e-4)


def test_s22_fig_4():
    assert [at("S22-4", "2", z1) for z1 in (1, 2, 3)] == pytest.approx([1.225, 1.0, 0.4187], abs=5e-5)
    assert [at("S22-4", line, 1) for line in ("1", "1'")] == pytest.approx([1.225, 3.0], abs=5e-5)


@pytest.mark.parametrize("name", FIGURES)
def test_corrections_are_named(name):
    found = paper_figure(name)
    assert re.search(r"M\d+", " ".join(found.corrections))
    assert all(curve.label for curves in found.panels for curve in curves)
    assert paper_figure(name.lower().replace("-", " ")) == found
