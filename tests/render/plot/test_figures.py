"""Every figure as it is drawn: all texts inside, every value of its sheet where the axes have it."""

import io
import itertools
import os
import re
from pathlib import Path

import numpy as np
import pytest
from conftest import CONFIGS, slow
from matplotlib import style
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Annotation, Text
from PIL import Image

from afmcalc.analysis.asking import Answers
from afmcalc.analysis.plot_data import Request, gathered
from afmcalc.engines import build
from afmcalc.messages import ENGLISH, language, named, speaking
from afmcalc.papers import FIGURES
from afmcalc.render.drawing import Inscription, exploded, text_width
from afmcalc.render.plot import sheet_of
from afmcalc.render.plot.chart import Chart, Sheet
from afmcalc.render.plot.figure import figure_of, inline_svg
from afmcalc.render.plot.paint import PARAMETERS
from afmcalc.render.plot.schemes import SCHEMES
from afmcalc.render.symbols import mathtext
from afmcalc.spec import read_spec

LONG = "Предохранительная муфта привода ленточного конвейера, исполнение W, " * 3 + r"_x $y_1$"
SPOKEN = {"ru": language("ru"), "en": ENGLISH}
PRINTED, SMALLEST = 210 - 20 - 14, 9.0
"""Millimetres that a figure of a report is wide on A4, and points of its smallest text but for subscripts."""
FEW = [
    ("ru", "torque", "default"), ("ru", "springs", "default"), ("ru", "section", "default"),
    ("en", "pocket", "indirect"),
]  # fmt: skip
MANY = [
    *((kind, "default") for kind in ("overload", "life", "pocket")), ("torque", "indirect"), ("accuracy", "default"),
    ("torque", "default", "F=1e-18"), ("torque", "default", "f_min=0.79999", "friction.mean="),
    ("overload", "default", "F=1e15"), ("pocket", "default", 'control_unit.ball_circle_radius="923.456789 mm"'),
    ("tolerance", "tolerance", "F=1e12"), ("simulate", "drive"), ("effects", "drive"), ("pareto", "requirements"),
    ("section", "envelope"), ("life", "indirect"), ("springs", "indirect"), ("section", "indirect"), ("accuracy", "indirect"), ("pocket", "constant-torque"), ("torque", "unlike-materials"),
    *(("paper", name) for name in (*FIGURES, *SCHEMES)),
]  # fmt: skip


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
    """Texts that leave a figure, or cover one another: but for what stands beside a point, which nothing keeps apart."""
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
    """Each text of a drawing is within its frame, as wide as letters are at most."""
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
    """Texts without their spaces, and without what marks a subscript or escapes a sign."""
    plain = re.sub(r"\$_\{(.*?)\}\$", r"_\1", "".join(texts))
    return "".join(plain.replace("\\", "").split())


def assert_shows(figure, own):
    """Each line, guide and label of the charts is in the figure, where its numbers say."""
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
        assert [label for label in map(mathtext, chart.labels) if joined([label]) not in shown] == []
        assert [axes.xaxis.label.get_text(), axes.yaxis.label.get_text()] != ["", ""]
        assert axes.get_yscale() == ("log" if chart.y.log else "linear")


@pytest.mark.parametrize(
    ("lang", "kind", "subject", "changes"),
    [
        *((*case, ()) for case in FEW),
        *slow(*(("ru", kind, subject, changes) for kind, subject, *changes in MANY)),
    ],
)
def test_every_text_is_inside_and_every_value_is_shown(lang, kind, subject, changes):
    """Of a clutch with a long name too; letters of a page are nine points."""
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
        if kind in ("torque", "effects"):
            svg = inline_svg(own.panels[0])
            (width,) = re.findall(r'viewBox="\S+ \S+ (\S+) \S+"', svg)
            sizes = {float(size) for size in re.findall(r"font(?:-size)?: (?:bold )?([\d.]+)px", svg)}
            assert {size for size in sizes if size * PRINTED / 25.4 * 72 / float(width) < SMALLEST} <= {6.3}, (
                "subscripts"
            )
            assert set(joined(map(mathtext, own.panels[0].labels))) <= set(joined([svg]))


def test_a_fault_is_found():
    """A text moved over another, or over the edge, is told."""
    with style.context([PARAMETERS], after_reset=True):
        figure = figure_of(sheet("torque", "default"))
        figure.text(0.98, 0.5, "beyond the edge")
        for name in "AB":
            figure.text(0.5, 0.6, name)
        outside, covered = faults(figure)
        assert (outside, covered) == (["beyond the edge"], [("A", "B")])


@pytest.mark.slow
def test_the_picture_of_the_readme():
    """Root mean square of the differences, of 255: another version of the font engine stays below 4, a curve does not."""
    made, stored = io.BytesIO(), Path(__file__).parent / "baseline" / "torque.png"
    with style.context([PARAMETERS], after_reset=True):
        figure_of(sheet("torque", "default")).savefig(made, format="png", dpi=64)
    if os.environ.get("AFMCALC_UPDATE"):
        picture = Image.open(made).convert("RGB").quantize(128, dither=Image.Dither.NONE)
        picture.save(stored, optimize=True)
    now, then = (np.asarray(Image.open(file).convert("RGB"), float) for file in (made, stored))
    assert np.sqrt(np.mean((now - then) ** 2)) <= 4
