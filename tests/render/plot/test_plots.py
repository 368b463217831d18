"""Plots show the numbers of their commands; files of every kind, the refusals."""

import math
import os
import subprocess
import sys

import numpy as np
import pytest
from conftest import CONFIGS, ROOT

from afmcalc.render.drawing import Circle

from .test_figures import sheet

SPLINES = [
    "friction_group.spline_friction=0.1",
    "friction_group.inner_spline_radius=0.075",
    "friction_group.outer_spline_radius=0.125",
]

WISHES = CONFIGS / "requirements.toml"


def curve(chart, number=0):
    line = chart.lines[number]
    return list(zip(line.x, line.y, strict=True))


def test_curves_of_the_base_clutch_are_its_closed_forms():
    """Eight pairs, one of them bypass, C 0.5, 2 kN, 100 mm, f 0.1…0.8: F11 (12) and the ratio of its ends."""

    def torque(f, gain=0.5):
        return 200 * 8 * f / (1 + gain * 7 * f)

    def accuracy(gain):
        return torque(0.8, gain) / torque(0.1, gain)

    (chart,) = sheet("torque", "default").panels
    assert all(y == pytest.approx(torque(x)) for x, y in curve(chart))
    assert [guide.value for guide in chart.guides] == pytest.approx([torque(0.1)])
    assert (chart.spans[0].low, chart.spans[0].high) == pytest.approx((torque(0.1), torque(0.8)))
    assert [chart.lines[0].x[0], chart.lines[0].x[-1]] == pytest.approx([0.1, 0.8])
    (chart,) = sheet("accuracy", "default").panels
    assert all(y == pytest.approx(accuracy(x)) for x, y in curve(chart))
    assert sorted(guide.value for guide in chart.guides) == pytest.approx([0.5, 1 / 0.8])
    (chart,) = sheet("effects", "default", *SPLINES).panels
    assert all(y == pytest.approx(torque(x)) for x, y in curve(chart))
    assert len(chart.lines) == 3


def test_overload_of_eight_driving_pairs_is_s22s():
    """S22 (12), (15), (18): zC 5, 80 N·m·f/(1 + 5 f) of the expected torque; published and equilibrium beside it."""
    trip, accuracy = sheet("overload", "all-driving").panels
    expected = dict(curve(trip))
    assert all(y == pytest.approx(800 * x / (1 + 5 * x)) for x, y in expected.items())
    assert all(y == pytest.approx(expected[x]) for x, y in curve(trip, 2))
    assert {line.points for line in trip.lines} == {False, True}
    assert all(y == pytest.approx(8 * (1 + x * 0.1) / (1 + x * 0.8)) for x, y in curve(accuracy))
    assert [guide.value for guide in accuracy.guides] == pytest.approx([5, 1 / 0.8])
    assert [guide.value for guide in trip.guides] == pytest.approx([expected[trip.lines[0].x[0]] / 1.25])


def test_a_front_a_study_and_springs_are_their_commands(answered):
    few = ["search.friction_group.pairs=[8, 10]", "search.control_unit.gain=[0.4, 0.5, 0.6]"]
    front = answered("design", WISHES, *(part for each in few for part in ("--set", each)), "--json").json["result"]
    panel, _ = sheet("pareto", "requirements", *few).panels
    shown = {name: (x, y) for line in panel.lines for name, x, y in zip(line.names, line.x, line.y, strict=True)}
    wanted = {str(row["number"]): [row[name] for name in front["objectives"][:2]] for row in front["front"]}
    assert {name: list(place) for name, place in shown.items()} == wanted
    assert [line.names for line in panel.lines if line.filled] == [[str(front["compromise"])]]
    small = ["tolerance.samples=2000", "tolerance.sobol_base=64"]
    asked = ["tolerance", CONFIGS / "tolerance.toml", *(part for each in small for part in ("--set", each))]
    quantiles = answered(*asked, "--json").json["result"]["quantiles"]
    (panel,) = sheet("tolerance", "tolerance", *small).panels
    assert {row["torque"] for row in quantiles} <= {guide.value for guide in panel.guides}
    bars = curve(panel)
    area = sum(y * (after - x) for (x, y), (after, _) in zip(bars, bars[1:], strict=False))
    assert area == pytest.approx(1, abs=0.02)
    (panel,) = sheet("springs", "default").panels
    ((set_at, force),) = curve(panel, 2)
    assert force == 2000
    below, above = (side(x for x, _ in curve(panel) if way * (x - set_at) >= 0) for side, way in ((max, -1), (min, 1)))
    assert dict(curve(panel))[below] <= force <= dict(curve(panel))[above]


@pytest.mark.slow
def test_an_event_is_its_command(answered):
    event = answered("simulate", CONFIGS / "drive.toml", "--json").json["result"]
    torque, speed, *_ = sheet("simulate", "drive").panels
    assert [max(line.y) for line in torque.lines] == pytest.approx([*event["peak_torque"].values()], rel=1e-3)
    assert len(speed.lines) == 3


def test_a_life_is_its_command(answered):
    life = answered("life", CONFIGS / "default.toml", "--sweep", "dT=150:300:3", "--json").json["result"]["sweep"][0]
    (panel,) = sheet("life", "default").panels
    assert panel.y.log
    shown = np.interp(life["values"], *zip(*((x, math.log(y)) for x, y in curve(panel)), strict=True))
    assert np.exp(shown) == pytest.approx(life["protected"], rel=0.02)


def test_the_ball_touches_the_walls_of_its_pockets():
    """No wall as drawn is nearer to the ball's centre than its radius, at the stop and at the largest travel."""
    (drawing,) = sheet("pocket", "indirect").panels
    balls = [shape for shape in drawing.shapes if isinstance(shape, Circle)]
    sleeves = [shape.contours[0] for shape in drawing.shapes if shape.layer in ("sleeve_1", "sleeve_2")]
    assert (len(balls), len(sleeves)) == (2, 4)
    for ball, both in zip(balls, (sleeves[:2], sleeves[2:]), strict=True):
        for wall in both:
            edges = zip(wall, wall[1:], strict=False)
            assert min(distance(ball.centre, *edge) for edge in edges) == pytest.approx(ball.radius)


def distance(point, start, end):
    """Of a point from a straight edge."""
    long = math.dist(start, end)
    along = sum((p - a) * (b - a) for p, a, b in zip(point, start, end, strict=True)) / long**2 if long else 0
    return math.dist(point, [a + min(max(along, 0), 1) * (b - a) for a, b in zip(start, end, strict=True)])


@pytest.mark.slow
def test_the_same_bytes_from_another_process(tmp_path, afmcalc):
    """With another hash seed and zone, without a home of matplotlib."""
    asked = {"a.svg": "plot accuracy", "b.svg": "layout", "b.dxf": "pocket", "b.pdf": "layout"}
    other = {"MPLBACKEND": "svg", "MPLCONFIGDIR": "/proc/none", "HOME": "/proc/none", "TZ": "Asia/Tokyo"}
    environment = {**os.environ, **other, "PYTHONHASHSEED": "7", "PYTHONPATH": str(ROOT)}
    for name, kind in asked.items():
        line = [*kind.split(), "example:envelope", "--quiet", "-o", str(tmp_path / name)]
        subprocess.run([sys.executable, "-m", "afmcalc", *line], check=True, env=environment)
        made = (tmp_path / name).read_bytes()
        assert afmcalc(*line, "--force").code == 0
        assert made == (tmp_path / name).read_bytes(), name


REFUSED = """
plot torqe | 'torque'
plot torque -o x.gif | .svg
plot pocket | afmcalc pocket
plot section | afmcalc layout
plot torque --sweep C -o x.svg | --sweep
plot torque - - -o x.svg | once
pocket example:conventional -o x.svg | control unit
plot overload example:indirect -o x.svg | S22
plot life --sweep C -o x.svg | dT
plot overload example:default example:default -o x.svg | one SPEC
plot paper -o x.svg | one NAME
plot paper S22-9 -o x.svg | S22-4
plot tolerance example:default -o x.svg | tolerance
plot pareto -o x.svg | one SPEC
plot pareto example:default -o x.svg | required by design
plot pareto example:requirements --set objectives=["pairs"] -o x.svg | two
plot pareto example:requirements --set requirements.accuracy_factor=1 -o x.svg | accuracy factor
"""


@pytest.mark.parametrize("line", REFUSED.strip().splitlines())
def test_refusals(line, afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    arguments, said = line.split(" | ")
    run = afmcalc(*arguments.split())
    assert (run.code, run.out, [*tmp_path.iterdir()]) == (2, "", [])
    assert said in run.err
