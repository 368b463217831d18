"""Every figure of every shipped example, in every language, measured as it is drawn: its texts, their places and sizes."""

import itertools
import re

import pytest
from conftest import CONFIGS
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Annotation, Text

from afmcalc.analysis.answers import Answers
from afmcalc.analysis.figures import Request, gathered
from afmcalc.analysis.registry import PLOTS
from afmcalc.engines import build
from afmcalc.errors import AfmcalcError
from afmcalc.messages import ENGLISH, language, speaking
from afmcalc.papers import FIGURES
from afmcalc.render.plot import sheet_of
from afmcalc.render.plot.chart import Sheet
from afmcalc.render.plot.figure import _LOW, _figure, _settings, inline_svg
from afmcalc.render.plot.schemes import SCHEMES
from afmcalc.spec import read_spec
from afmcalc.spec.requirements import read_requirements

LONG = "Предохранительная муфта привода ленточного конвейера, исполнение W, " * 3
SPOKEN = {"ru": language("ru"), "en": ENGLISH}
SMALLEST = 9.0
"""Points, as printed."""


def figures_of(example):
    """What there is to draw of an example: kind and data."""
    path = CONFIGS / f"{example}.toml"
    for kind in sorted(set(PLOTS) - {"paper"}):
        try:
            subject = read_requirements(path) if kind == "pareto" else Answers(build(read_spec(path)))
            yield kind, gathered(kind, Request([subject]))
        except AfmcalcError:
            pass


def measured(figure, dpi=150):
    """What a figure draws: its texts and the lines of its dimensions with their boxes, all in points, and its size."""
    drawn = []

    def draw(text, renderer, own=Text.draw):
        if text.get_visible() and text.get_text().strip():
            drawn.append((text.get_text(), Text.get_window_extent(text, renderer)))
        own(text, renderer)

    figure.set_dpi(dpi)
    canvas = FigureCanvasAgg(figure)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Text, "draw", draw)
        canvas.draw()
    renderer = canvas.get_renderer()
    spans = [
        ("", note.arrow_patch.get_window_extent(renderer))
        for note in figure.findobj(Annotation)
        if note.arrow_patch and not note.get_text()
    ]
    for axes in figure.axes:  # the thin lines from a curve to its dimension, as far as they stand beside the axes
        for line in axes.lines:
            box = line.get_window_extent(renderer)
            if line.get_transform() == axes.get_yaxis_transform() and box.x1 > axes.bbox.x1:
                spans.append(("", type(box).from_extents(axes.bbox.x1, box.y0, box.x1, box.y1)))

    def points(named):
        return [(name, *(end * 72 / dpi for end in box.extents)) for name, box in named]

    return points(drawn), points(spans), figure.bbox.size * 72 / dpi


def faults(figure, dpi=150):
    """Texts that leave the figure, or cover one another or a dimension."""
    texts, spans, (width, height) = measured(figure, dpi)
    outside = [text for text, x0, y0, x1, y1 in texts if min(x0, y0, width - x1, height - y1) < 0]
    pairs = [*itertools.combinations(texts, 2), *itertools.product(texts, spans)]
    covered = [
        (one[0], other[0])
        for one, other in pairs
        if min(one[3], other[3]) - max(one[1], other[1]) > 0.3 and min(one[4], other[4]) - max(one[2], other[2]) > 0.3
    ]
    return outside, covered


def assert_free(sheet, dpi=150):
    """As a picture of its own, with a long name too, and as one of a page."""
    for each, height in ((sheet, None), (Sheet("", sheet.panels), _LOW)):
        figure = _figure(each, *filter(None, [height]))
        assert faults(figure, dpi) == ([], []), sheet.title


@pytest.mark.every(23)
@pytest.mark.parametrize("lang", ["ru", "en"])
@pytest.mark.parametrize("example", sorted(path.stem for path in CONFIGS.glob("*.toml")))
def test_no_text_leaves_its_figure_or_covers_another(example, lang):
    drawn = dict(figures_of(example))
    assert len(drawn) >= (1 if "clutch" in example or "pareto" in drawn else 3)
    with speaking(SPOKEN[lang]), _settings():
        for kind, found in drawn.items():
            assert_free(sheet_of(kind, found))


@pytest.mark.every(7)
@pytest.mark.parametrize("lang", ["ru", "en"])
@pytest.mark.parametrize("name", [*FIGURES, *SCHEMES])
def test_no_text_covers_another_in_a_figure_of_the_papers(name, lang):
    with speaking(SPOKEN[lang]), _settings():
        own = sheet_of("paper", gathered("paper", Request([name]))) if name in FIGURES else SCHEMES[name]()
        for dpi in (64, 150):
            assert_free(own, dpi)


EXTREMES = [
    ("torque", "default", ["F=1e-18"], None),
    ("torque", "default", ["F=1e15"], None),
    ("torque", "default", ["f_min=0.79999", "friction.mean="], None),
    ("torque", "indirect", [f"name={LONG}"], None),
    ("accuracy", "default", [f"name={'W' * 200}"], "F=1e-9:1e-3:5"),
    ("accuracy", "default", [], "control_unit.ball_circle_radius=0.01:0.1:5"),
    ("overload", "default", ["F=1e15"], None),
    ("life", "default", ["F=3e5"], None),
    ("pocket", "default", ['control_unit.ball_circle_radius="923.456789 mm"'], None),
    ("pocket", "indirect", ["control_unit.ball_circle_radius=0.0623456"], None),
    ("simulate", "drive", ["drive.motor_inertia=0.2"], None),
    ("tolerance", "tolerance", ["F=1e-9"], None),
    ("tolerance", "tolerance", ["F=1e12"], None),
]


@pytest.mark.every(9)
@pytest.mark.parametrize("lang", ["ru", "en"])
@pytest.mark.parametrize(("kind", "example", "changes", "sweep"), EXTREMES)
def test_no_text_covers_another_however_large_or_long(kind, example, changes, sweep, lang):
    subject = Answers(build(read_spec(CONFIGS / f"{example}.toml", changes)))
    with speaking(SPOKEN[lang]), _settings():
        assert_free(sheet_of(kind, gathered(kind, Request([subject], sweep))))


def test_names_of_several_clutches_are_folded():
    names = [f"name={LONG}", "name=" + "W" * 200, "name=_x $y_1$"]
    subjects = [Answers(build(read_spec(CONFIGS / "default.toml", [name]))) for name in names]
    with speaking(ENGLISH), _settings():
        own = sheet_of("torque", gathered("torque", Request(subjects)))
        assert_free(own)
        shown = "".join(text.get_text() for text in _figure(own).legends[0].get_texts())
        assert "".join(shown.split()) == "".join("".join((LONG, "W" * 200, r"_x \$y_1\$")).split())


def test_a_fault_is_found():
    """What is measured is what is drawn: a text moved over another, or over the edge, or over a dimension, is told."""
    with _settings():
        own = sheet_of("torque", dict(figures_of("default"))["torque"])
        for fault in ("covered", "outside", "dimension"):
            figure = _figure(own)
            (axes,) = figure.axes
            if fault == "outside":
                figure.texts[0].set_x(0.9)
                assert len(faults(figure)[0]) == 1
                continue
            # A lies on B, inside the axes; or on the first dimension line, beside them
            x = 0.5 if fault == "covered" else 1 + 12 / axes.bbox.width
            for name in "AB":
                axes.text(x, 0.6, name, transform=axes.transAxes)
            assert ("A", "B") in faults(figure)[1]
            assert (("A", "") in faults(figure)[1]) == (fault == "dimension")


def test_spans_stand_inside_the_figure_beside_the_axes():
    with _settings():
        figure = _figure(sheet_of("torque", dict(figures_of("default"))["torque"]))
        texts, spans, (width, _) = measured(figure)
        right = figure.axes[0].bbox.x1 * 72 / 150
        beside = [text for text in texts if "ΔT" in text[0] and text[1] > right]
        assert len(beside) == 2
        assert len(spans) == 6
        assert all(right <= x0 + 0.5 and x1 <= width for _, x0, _, x1, _ in [*beside, *spans])


PRINTED = 210 - 20 - 14
"""Millimetres that text and figures of a report are wide on A4."""


@pytest.mark.every(8)
@pytest.mark.parametrize("lang", ["ru", "en"])
@pytest.mark.parametrize("example", ["default", "indirect", "drive", "tolerance", "conveyor-clutch", "constant-torque"])
def test_texts_of_a_page_are_of_nine_points_as_printed(example, lang):
    """Subscripts apart, which are at 70 %."""
    for kind, found in figures_of(example):
        with speaking(SPOKEN[lang]):
            svg = inline_svg(sheet_of(kind, found))
        (width,) = re.findall(r'viewBox="\S+ \S+ (\S+) \S+"', svg)
        scale = PRINTED / 25.4 * 72 / float(width)
        sizes = [float(size) for size in re.findall(r'font(?:-size)?[:=][^;"]*?"?([\d.]+)(?:px|")', svg)]
        assert svg.count("<text ") > 5
        assert min(sizes) * scale >= SMALLEST
        assert set(re.findall(r'font-size="([\d.]+%)"', svg)) <= {"70%"}
