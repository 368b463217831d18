"""Plots: all texts inside, every value where the axes have it, the numbers of their commands; files of every kind, refusals."""

import io
import itertools
import math
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import CONFIGS, ROOT, overrides, slow
from matplotlib import style
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Annotation, Text
from PIL import Image
from sources import READ, REFUSED, table

from afmcalc import load
from afmcalc.analysis.asking import Answers
from afmcalc.analysis.plot_data import Request, gathered
from afmcalc.engines import build
from afmcalc.messages import ENGLISH, language, named, speaking
from afmcalc.papers import FIGURES
from afmcalc.render.drawing import Circle, Inscription, exploded, text_width
from afmcalc.render.plot import sheet_of
from afmcalc.render.plot.chart import Chart, Sheet
from afmcalc.render.plot.figure import figure_of, inline_svg, save
from afmcalc.render.plot.paint import PARAMETERS
from afmcalc.render.plot.schemes import SCHEMES
from afmcalc.render.symbols import DOWN, UP, marked
from afmcalc.spec import read_spec

LONG = "Предохранительная муфта привода ленточного конвейера, исполнение W, " * 3 + r"_x $y_1$"
SPOKEN = {"ru": language("ru"), "en": ENGLISH}
PRINTED, SMALLEST = 210 - 20 - 14, 9.0
"""Width of a figure of a report on A4, mm, and height of its smallest text except subscripts, points."""
FEW = [*(("ru", kind, "default") for kind in ("torque", "section")), ("en", "pocket", "indirect")]
MANY = [*READ["drawn"], *(("paper", name) for name in [*FIGURES, *SCHEMES][::3])]


def sheet(kind, subject, *changes):
    if subject in SCHEMES:
        return SCHEMES[subject]()
    path = CONFIGS / f"{subject}.toml"
    if kind == "pareto":
        of = read_spec(path, changes)
    else:
        of = subject if kind == "paper" else Answers(build(read_spec(path, changes)))
    return sheet_of(kind, gathered(kind, Request([of])))


def faults(figure):
    """Texts that leave a figure or cover one another, except texts beside points, which may overlap."""
    canvas, texts = FigureCanvasAgg(figure), []

    def noted(text, renderer, own=Text.draw):
        if text.get_visible() and text.get_text().strip():
            texts.append((text, *Text.get_window_extent(text, renderer).extents))
        own(text, renderer)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Text, "draw", noted)
        canvas.draw()
    wide, high = figure.bbox.size
    outside = [text.get_text() for text, x0, y0, x1, y1 in texts if min(x0, y0, wide - x1, high - y1) < -1]
    arrows = [note.arrow_patch.get_window_extent() for note in figure.findobj(Annotation) if note.arrow_patch]
    outside += ["arrow" for box in arrows if not figure.bbox.padded(1).contains(*box.max)]
    apart = [each for each in texts if not isinstance(each[0], Annotation)]
    some = 0.5 * figure.dpi / 72
    covered = [
        (one[0].get_text(), other[0].get_text())
        for one, other in itertools.combinations(apart, 2)
        if min(one[3], other[3]) - max(one[1], other[1]) > some and min(one[4], other[4]) - max(one[2], other[2]) > some
    ]
    return outside, covered


def is_within(drawing):
    """Assert that each text of a drawing is within its frame, at the largest width that its letters may have."""
    left, low, right, top = drawing.frame
    texts = [part for shape in drawing.shapes for part in exploded(shape) if isinstance(part, Inscription)]
    share = {"start": 0.0, "middle": 0.5, "end": 1.0}
    for text in texts:
        wide = text_width(text.text, text.height)
        along, across = text.at[text.upright], text.at[not text.upright]
        start = along - share[text.anchor] * wide
        ends, sides = ((low, top), (left, right)) if text.upright else ((left, right), (low, top))
        assert ends[0] <= start, text
        assert start + wide <= ends[1] + 0.1 * (ends[1] - ends[0]), text
        assert sides[0] <= across <= sides[1], text
    return len(texts)


def joined(texts):
    """Texts without their spaces, and with subscripts as the results have them."""
    return "".join("".join(texts).replace(DOWN, "_").replace(UP, "").split())


def assert_shows(figure, own):
    """Assert that each line, guide and label of the charts is in the figure, at the place of its numbers."""
    shown = joined(text.get_text() for text in figure.findobj(Text))
    for axes, chart in zip(figure.axes, own.panels, strict=True):
        if not isinstance(chart, Chart):
            continue
        drawn = [np.array(line.get_data(orig=True), float) for line in axes.lines]
        wanted = [(chart.x.shown(line.x), chart.y.shown(line.y)) for line in chart.lines]
        wanted += [
            ((0, 1), 2 * chart.y.shown([guide.value])) if guide.across else (2 * chart.x.shown([guide.value]), (0, 1))
            for guide in chart.guides
        ]
        for values in (np.array(pair, float) for pair in wanted):
            assert any(each.shape == values.shape and np.allclose(each, values, equal_nan=True) for each in drawn)
        assert [label for label in map(marked, chart.labels) if joined([label]) not in shown] == []
        assert [axes.xaxis.label.get_text(), axes.yaxis.label.get_text()] != ["", ""]
        assert axes.get_yscale() == ("log" if chart.log else "linear")


@pytest.mark.parametrize(
    ("lang", "kind", "subject", "changes"),
    [*((*case, ()) for case in FEW), *slow(*(("ru", kind, subject, changes) for kind, subject, *changes in MANY))],
)
def test_every_text_is_inside_and_every_value_is_shown(lang, kind, subject, changes):
    """This holds for a clutch with a long name too; the smallest letters on a page have nine points."""
    with speaking(SPOKEN[lang]):
        own = sheet(kind, subject, *changes)
        if not isinstance(own.panels[0], Chart):
            assert is_within(own.panels[0])
            assert is_within(own.panels[0].captioned(own.title, "a name", own.below)) > 5
            return
        with style.context([PARAMETERS], after_reset=True):
            figure = figure_of(Sheet(own.title, own.panels, own.caption, LONG))
            assert faults(figure) == ([], [])
            assert_shows(figure, own)
            assert joined([own.title, named(LONG)]) == joined([figure.get_suptitle()])
        if kind == "torque":
            svg = inline_svg(own.panels[0])
            (width,) = re.findall(r'viewBox="\S+ \S+ (\S+) \S+"', svg)
            sizes = {float(size) for size in re.findall(r"font(?:-size)?: (?:bold )?([\d.]+)px", svg)}
            assert min(sizes) * PRINTED / 25.4 * 72 / float(width) >= SMALLEST
            assert '<tspan dy=".18em" font-size="70%">' in svg
            assert not {DOWN, UP} & {*svg}


@pytest.mark.slow
def test_the_picture_of_the_readme():
    """Root mean square of the differences, of 255: another version of the font engine stays below 4, a curve does not."""
    stored = Path(__file__).parent / "baseline" / "torque.png"
    made = Image.open(io.BytesIO(save(sheet("torque", "default"), "png"))).convert("RGB").reduce(2)
    if os.environ.get("AFMCALC_UPDATE"):
        made.quantize(128, dither=Image.Dither.NONE).save(stored, optimize=True)
    now, then = (np.asarray(image.convert("RGB"), float) for image in (made, Image.open(stored)))
    assert np.sqrt(np.mean((now - then) ** 2)) <= 4


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
    assert chart.lines[0].label.endswith(f"ΔT_1 = {torque(0.8) - torque(0.1):.2f} N·m")
    assert [chart.lines[0].x[0], chart.lines[0].x[-1]] == pytest.approx([0.1, 0.8])
    (chart,) = sheet("accuracy", "default").panels
    assert all(y == pytest.approx(accuracy(x)) for x, y in curve(chart))
    assert sorted(guide.value for guide in chart.guides) == pytest.approx([0.5, 1 / 0.8])


def test_overload_of_eight_driving_pairs_is_s22s():
    """By S22 (12), (15), (18) with zC = 5: expected torque 800 N·m·f/(1 + 5 f); published and equilibrium torque."""
    trip, accuracy = sheet("overload", "all-driving").panels
    expected = dict(curve(trip))
    assert all(y == pytest.approx(800 * x / (1 + 5 * x)) for x, y in expected.items())
    assert all(y == pytest.approx(expected[x]) for x, y in curve(trip, 2))
    assert {line.points for line in trip.lines} == {False, True}
    assert all(y == pytest.approx(8 * (1 + x * 0.1) / (1 + x * 0.8)) for x, y in curve(accuracy))
    assert [guide.value for guide in accuracy.guides] == pytest.approx([5, 1 / 0.8])
    assert [guide.value for guide in trip.guides] == pytest.approx([expected[trip.lines[0].x[0]] / 1.25])


def test_a_front_and_a_study_are_their_commands(answered):
    few = ["search.friction_group.pairs=[8, 10]", "search.control_unit.gain=[0.4, 0.5, 0.6]"]
    front = answered("design", WISHES, *overrides(*few), "--json").json["result"]
    panel, _ = sheet("pareto", "requirements", *few).panels
    shown = {name: (x, y) for line in panel.lines for name, x, y in zip(line.names, line.x, line.y, strict=True)}
    wanted = {str(row["number"]): [row[name] for name in front["objectives"][:2]] for row in front["front"]}
    assert {name: list(place) for name, place in shown.items()} == wanted
    assert [line.names for line in panel.lines if line.filled] == [[str(front["compromise"])]]
    small = ["tolerance.samples=2000", "tolerance.sobol_base=64"]
    asked = ["tolerance", CONFIGS / "tolerance.toml", *overrides(*small)]
    quantiles = answered(*asked, "--json").json["result"]["quantiles"]
    (panel,) = sheet("tolerance", "tolerance", *small).panels
    assert {row["torque"] for row in quantiles} <= {guide.value for guide in panel.guides}
    bars = curve(panel)
    area = sum(y * (after - x) for (x, y), (after, _) in zip(bars, bars[1:], strict=False))
    assert area == pytest.approx(1, abs=0.02)


@pytest.mark.slow
def test_an_event_is_its_command(answered):
    event = answered("simulate", CONFIGS / "drive.toml", "--json").json["result"]
    torque, speed, *_ = sheet("simulate", "drive").panels
    assert [max(line.y) for line in torque.lines] == pytest.approx([*event["peak_torque"].values()], rel=1e-3)
    assert len(speed.lines) == 3


def test_a_life_is_its_command(answered):
    life = answered("life", CONFIGS / "default.toml", "--sweep", "dT=150:300:3", "--json").json["result"]["sweep"][0]
    (panel,) = sheet("life", "default").panels
    assert panel.log
    shown = np.interp(life["values"], *zip(*((x, math.log(y)) for x, y in curve(panel)), strict=True))
    assert np.exp(shown) == pytest.approx(life["protected"], rel=0.02)


def test_the_ball_touches_the_walls_of_its_pockets():
    """No wall as drawn is nearer to the ball's centre than its radius, at the stop and at the largest travel, where the
    sleeves are so much further apart."""
    (drawing,) = sheet("pocket", "indirect").panels
    balls = [shape for shape in drawing.shapes if isinstance(shape, Circle)]
    sleeves = [shape.contours[0] for shape in drawing.shapes if shape.layer in ("sleeve_1", "sleeve_2")]
    assert (len(balls), len(sleeves)) == (2, 4)
    for ball, both in zip(balls, (sleeves[:2], sleeves[2:]), strict=True):
        for wall in both:
            edges = zip(wall, wall[1:], strict=False)
            assert min(distance(ball.centre, *edge) for edge in edges) == pytest.approx(ball.radius)
    pairs = zip(sleeves[::2], sleeves[1::2], strict=True)
    gaps = [min(x for x, _ in one) - max(x for x, _ in other) for one, other in pairs]
    clutch = load(CONFIGS / "indirect.toml")
    gap = clutch.spec.control_unit.face_gap
    assert gaps == pytest.approx([1e3 * gap, 1e3 * (gap + float(clutch["travel_at_f_max"]))])


def distance(point, start, end):
    """Distance of a point from a straight edge."""
    long = math.dist(start, end)
    along = sum((p - a) * (b - a) for p, a, b in zip(point, start, end, strict=True)) / long**2 if long else 0
    return math.dist(point, [a + min(max(along, 0), 1) * (b - a) for a, b in zip(start, end, strict=True)])


@pytest.mark.slow
def test_the_same_bytes_from_another_process(tmp_path, afmcalc):
    """The bytes are the same with another hash seed and time zone, and without a folder of matplotlib."""
    asked = {"a.svg": "plot accuracy", "b.svg": "layout", "b.dxf": "pocket", "b.pdf": "layout"}
    other = {"MPLBACKEND": "svg", "MPLCONFIGDIR": "/proc/none", "HOME": "/proc/none", "TZ": "Asia/Tokyo"}
    environment = {**os.environ, **other, "PYTHONHASHSEED": "7", "PYTHONPATH": str(ROOT)}
    lines = {name: f"{kind} example:envelope --quiet -o {tmp_path / name}" for name, kind in asked.items()}
    each = [sys.executable, "-c", table("programs")["imported"], *lines.values()]
    subprocess.run(each, check=True, env=environment, capture_output=True)
    for name, line in lines.items():
        made = (tmp_path / name).read_bytes()
        assert afmcalc(*line.split(), "--force").code == 0
        assert made == (tmp_path / name).read_bytes(), name


@pytest.mark.parametrize(("arguments", "said"), REFUSED["plot"])
def test_refusals(arguments, said, afmcalc, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run = afmcalc(*arguments.split())
    assert (run.code, run.out, [*tmp_path.iterdir()]) == (2, "", [])
    assert said in run.err
