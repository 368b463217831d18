"""The chart that is written without matplotlib: every point where the axes say, every text inside, nothing left out."""

import re
from xml.etree import ElementTree

import numpy as np
import pytest

from afmcalc.analysis.answers import Answers
from afmcalc.analysis.figures import Request, gathered
from afmcalc.engines import build
from afmcalc.messages import ENGLISH, language, speaking
from afmcalc.render.plot import sheet_of
from afmcalc.render.plot.chart import Area, Chart, Line
from afmcalc.render.plot.quick import is_plain, svg_of
from afmcalc.render.symbols import split
from afmcalc.spec import read_spec


def torque_chart(name):
    answers = Answers(build(read_spec(f"example:{name}")))
    (chart,) = sheet_of("torque", gathered("torque", Request([answers]))).panels
    return chart


def points(path):
    return np.array([[float(part) for part in pair.split()] for pair in path.get("d")[1:].split("L")])


@pytest.mark.parametrize("name", ["default", "indirect", "unlike-materials"])
def test_curves_lie_where_the_numbers_on_the_axes_say(name):
    chart = torque_chart(name)
    assert is_plain(chart)
    drawing = ElementTree.fromstring(svg_of(chart).replace(' xmlns="http://www.w3.org/2000/svg"', ""))
    texts = [("".join(each.itertext()), each) for each in drawing.iter("text")]
    for anchor, axis in (("end", 1), ("middle", 0)):
        own = [(text, each) for text, each in texts if each.get("anchor", each.get("text-anchor")) == anchor]
        numbers = [(text, each) for text, each in own if re.fullmatch(r"[\d.]+", text)]
        ticks = [(float(text), float(each.get("xy"[axis])) - (3 if axis else 0)) for text, each in numbers]
        slope, start = np.polyfit(*zip(*ticks, strict=True), 1)
        curves = [path for path in drawing.iter("path") if path.get("stroke-width") == "1.7"]
        drawn = [points(path)[:, axis] for path in curves if len(points(path)) > 2]
        values = [(chart.x, chart.y)[axis].shown((line.x, line.y)[axis]) for line in chart.lines]
        for at, wanted in zip(drawn, values, strict=True):
            assert at == pytest.approx(start + slope * np.array(wanted), abs=0.02)
    for each in (*chart.lines, *chart.guides):
        assert "".join(piece for piece, _ in split(each.label)) in dict(texts)


@pytest.mark.parametrize(("name", "spoken"), [("default", language("ru")), ("indirect", ENGLISH)], ids=["ru", "en"])
def test_nothing_stands_outside(name, spoken):
    with speaking(spoken):
        drawing = ElementTree.fromstring(svg_of(torque_chart(name)))
    _, _, width, height = map(float, drawing.get("viewBox").split())
    for each in drawing.iter("{*}text"):
        wide = 0.62 * 9 * len("".join(each.itertext()))
        left = {"start": 0, "middle": wide / 2, "end": wide}[each.get("text-anchor")]
        x, y = float(each.get("x")), float(each.get("y"))
        low, most = (y - left, height) if each.get("transform") else (x - left, width)
        assert 0 <= low < low + wide <= most, "".join(each.itertext())
        assert 0 <= x <= width
        assert 0 <= y <= height


def test_what_it_cannot_draw_is_left_to_matplotlib():
    chart = torque_chart("default")
    (line, *_) = chart.lines
    for more in (
        {"lines": []}, {"lines": [line._replace(y=[None, *line.y[1:]])]}, {"lines": [line._replace(points=True)]},
        {"lines": [Line("T", [0.1], [1.0])]}, {"areas": [Area("a", [0, 1], [0, 1], [1, 2])]}, {"bounds": (0, 1, 0, 1)},
        {"named": True}, {"y": chart.y._replace(log=True)}, {"guides": [chart.guides[0]._replace(across=False)]},
    ):  # fmt: skip
        assert not is_plain(Chart(**{**vars(chart), **more}))
