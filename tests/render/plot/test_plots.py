"""What plots show is what their commands tell; plots as text, files of every kind, the refusals."""

import math
import os
import re
import subprocess
import sys

import numpy as np
import pytest
from conftest import CONFIGS, ROOT

from afmcalc.render.plot.chart import Chart, ChartAxis, Line
from afmcalc.render.plot.text import draw

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
    (panel,) = sheet("pareto", "requirements", *few).panels
    shown = {name: (x, y) for line in panel.lines for name, x, y in zip(line.names, line.x, line.y, strict=True)}
    wanted = {str(row["number"]): [row[name] for name in front["objectives"][:2]] for row in front["front"]}
    assert {name: list(place) for name, place in shown.items()} == wanted
    assert [line.names for line in panel.lines if line.filled] == [[str(front["compromise"])]]
    assert sorted(line.tag for line in panel.lines if line.tag) == ["z = 10", "z = 8"]
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
    """As painted: no wall is nearer to the ball's centre than its radius, and each dot is there and on a wall."""
    from matplotlib.figure import Figure

    for panel in sheet("pocket", "indirect").panels:
        axes = Figure().add_axes((0, 0, 1, 1))
        panel.paint(axes)
        walls = [patch.get_xy() for patch in axes.patches if hasattr(patch, "get_xy")]
        dots = [(line.get_xdata()[0], line.get_ydata()[0]) for line in axes.lines if line.get_marker() == "o"]
        assert len(walls) == 2
        assert all(math.hypot(*dot) == pytest.approx(panel.radius) for dot in dots)
        near = [distance((0, 0), a, b) for wall in walls for a, b in zip(wall, wall[1:], strict=False)]
        assert min(near) == pytest.approx(panel.radius)
        edges = [edge for wall in walls for edge in zip(wall, wall[1:], strict=False)]
        assert max(min(distance(dot, *edge) for edge in edges) for dot in dots) == pytest.approx(0, abs=1e-9)
        assert len(dots) == (2 if panel.travel else 4)


def distance(point, start, end):
    """Of a point from a straight edge."""
    long = math.dist(start, end)
    along = sum((p - a) * (b - a) for p, a, b in zip(point, start, end, strict=True)) / long**2 if long else 0
    return math.dist(point, [a + min(max(along, 0), 1) * (b - a) for a, b in zip(start, end, strict=True)])


@pytest.mark.slow
def test_the_same_bytes_from_another_process(tmp_path, afmcalc):
    """With another hash seed and zone, without a backend or a home of matplotlib."""
    asked = {"a.svg": "plot accuracy", "b.svg": "layout", "b.dxf": "pocket"}
    other = {"MPLBACKEND": "nonsense", "MPLCONFIGDIR": "/proc/none", "HOME": "/proc/none", "TZ": "Asia/Tokyo"}
    environment = {**os.environ, **other, "PYTHONHASHSEED": "7", "PYTHONPATH": str(ROOT)}
    for name, kind in asked.items():
        line = [*kind.split(), "example:envelope", "--quiet", "-o", str(tmp_path / name)]
        subprocess.run([sys.executable, "-m", "afmcalc", *line], check=True, env=environment)
        made = (tmp_path / name).read_bytes()
        assert afmcalc(*line, "--force").code == 0
        assert made == (tmp_path / name).read_bytes(), name


TEXTS = {
    "torque": ["torque", CONFIGS / "indirect.toml", "--set", f"name={'Муфта с очень длинным именем ' * 9}"],
    "life": ["life", CONFIGS / "default.toml", CONFIGS / "indirect.toml", "--set", "F=1.2345678e-9", "--lang", "ru"],
    "paper": ["paper", "S22-2"],
}


@pytest.mark.parametrize("name", TEXTS)
def test_a_drawing_is_as_wide_as_its_terminal(name, afmcalc, monkeypatch):
    """Frame and curve whole, no word of a text lost; in a pipe 80 columns, never below 40."""
    runs = {}
    for columns in (None, 20, 80, 200):
        monkeypatch.setenv("COLUMNS", str(columns or ""))
        run = afmcalc("plot", *TEXTS[name])
        lines = run.out.splitlines()
        widest = 80 if columns is None else max(columns, 40)
        assert max(map(len, lines)) == widest
        assert {len(line) for line in lines if "└" in line} == {widest}
        frames = [line for line in lines if re.search("[┤│└]", line)]
        marks = {mark for line in frames for mark in re.split("[┤│]", line)[-1].replace(" ", "") if "└" not in line}
        told = [line for place, line in enumerate(lines) if line not in frames and "└" not in lines[place - 1]]
        runs[columns] = len(frames), sorted(marks), "".join("".join(told).split())
    assert runs[None] == runs[20] == runs[80] == runs[200]


def test_the_curve_of_a_sweep(answered, afmcalc, monkeypatch):
    """Small under its table, larger with --plot; a curve for each value of an outer key; as wide as the terminal."""
    sweep = "accuracy", "--sweep", "C=0:1.25:11", "--quiet"
    plain, drawn = answered(*sweep).out, answered(*sweep, "--plot").out
    assert [len(re.findall("[┤│]", run)) for run in (plain, drawn)] == [8, 20]
    assert drawn.splitlines()[:12] == plain.splitlines()[:12]
    assert "┤" not in answered("accuracy", "--sweep", "C=0.5,1").out
    out = answered("accuracy", "--sweep", "z=4,8", "--sweep", "C=0:1:9", "--plot").out
    assert "• z = 4" in out
    assert "x z = 8" in out
    monkeypatch.setenv("COLUMNS", "60")
    for more in ([], ["--plot"]):
        *_, floor, numbers, symbol = afmcalc(*sweep, *more).out.splitlines()
        assert floor.startswith("  └")
        assert (len(floor), numbers.split(), symbol) == (60, ["0", "0.5", "1"], "C".rjust(60))


@pytest.mark.parametrize(
    ("ends", "unicode"), [((2.0, 2.0), True), ((-1e308, 1e308), False), ((1.2e-300, 2e-300), True)]
)
def test_a_curve_of_characters_is_whole(unicode, ends):
    """Of a constant, and from end to end of the floating-point numbers."""
    chart = Chart(ChartAxis("", "x"), ChartAxis("", "y"), [Line("", [0, 1, 2, 3], [*ends, *ends], points=True)])
    lines = draw(chart, unicode=unicode, wide=40, high=8)
    assert (lines[0], lines[-1].strip(), len(lines)) == ("y", "x", 12)
    assert max(map(len, lines)) == 40
    assert sum(line.count("•" if unicode else "*") for line in lines) == 4
    assert unicode or all(line.isascii() for line in lines)


REFUSED = """
plot torqe | 'torque'
plot torque -o x.gif | .svg
plot pocket | afmcalc pocket
plot section | afmcalc layout
plot torque --sweep C | --sweep
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
accuracy --plot | --sweep
accuracy --sweep C --plot --json | --format json
"""


@pytest.mark.parametrize("line", REFUSED.strip().splitlines())
def test_refusals(line, afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    arguments, said = line.split(" | ")
    run = afmcalc(*arguments.split())
    assert (run.code, run.out, [*tmp_path.iterdir()]) == (2, "", [])
    assert said in run.err
