"""The handbook in a real browser and on paper."""

import re
import subprocess

import chromium
import pytest
from test_browser import ALL_SHOWN, IN_ITS_BOX, browser, lines_of, paper

from afmcalc.analysis.handbook import handbook
from afmcalc.messages import ENGLISH, language, speaking
from afmcalc.render.handbook import render

PAPER = 662
"""A4 less its margins, in pixels."""

OUTSIDE = """
[...document.querySelectorAll('table, svg, math, p, pre, li, h2, h3, figcaption, .formula, .worked')].filter(part => {
  const box = part.getBoundingClientRect()
  return box.height > 0 && (box.left < 0 || box.right > innerWidth + 0.5)
}).map(part => part.tagName + ' in ' + part.closest('[id]')?.id)"""

OVER_ITS_NUMBER = """
[...document.querySelectorAll('.formula')].filter(line =>
  line.querySelector('math').getBoundingClientRect().right > line.querySelector('.count').getBoundingClientRect().left
).length"""

LEADING_NOWHERE = """
[...document.querySelectorAll('a')].filter(link => {
  const target = document.getElementById(link.getAttribute('href').slice(1))
  return !target || target.getBoundingClientRect().height == 0
}).map(link => link.outerHTML)"""

HEADINGS = "[...document.querySelectorAll('h1, h2, h3, h4, h5, h6')].map(heading => +heading.tagName[1])"
FORMULA_SIZES = "[...new Set([...document.querySelectorAll('math')].map(e => getComputedStyle(e).fontSize))]"


@pytest.fixture(scope="module", params=["en", "ru"])
def written(request, tmp_path_factory):
    with speaking(language(request.param) if request.param != "en" else ENGLISH):
        text = render(handbook(request.param))
    file = tmp_path_factory.mktemp("handbook") / "handbook.html"
    file.write_text(text, encoding="utf-8")
    return file


@pytest.fixture(scope="module")
def page(written):
    with chromium.opened() as opened:
        opened.open(written)
        yield opened


@browser
@pytest.mark.every(6)
def test_in_a_browser(page, written):
    for scheme in ("light", "dark"):
        page.scheme(scheme)
        for width in (1280, 375):
            page.resize(width)
            assert page.evaluate("document.documentElement.scrollWidth") <= width
            assert page.evaluate(IN_ITS_BOX), (scheme, width)
            assert page.evaluate(ALL_SHOWN) or width == 375
            assert page.evaluate(OVER_ITS_NUMBER) == 0 or width == 375
    assert page.evaluate(LEADING_NOWHERE) == []
    levels = page.evaluate(HEADINGS)
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(level <= before + 1 for before, level in zip(levels, levels[1:], strict=False))
    assert page.requests == [written.as_uri()]
    assert page.problems == []


@browser
@pytest.mark.every(6)
def test_in_print(page):
    """As wide as the paper, and no letter smaller than elsewhere for that."""
    page.scheme("light")
    page.resize(PAPER)
    page.call("Emulation.setEmulatedMedia", media="print")
    try:
        assert page.evaluate("document.documentElement.scrollWidth") <= PAPER
        assert page.evaluate(OUTSIDE) == []
        assert page.evaluate(OVER_ITS_NUMBER) == 0
        sizes = page.evaluate(FORMULA_SIZES)
    finally:
        page.call("Emulation.setEmulatedMedia", media="")
    assert [round(float(size.removesuffix("px")) * 0.75, 2) for size in sizes] == [10.0]


@browser
@paper
@pytest.mark.exhaustive
def test_on_paper(page, written, tmp_path):
    """Every page has its number, and no heading stands without its text."""
    printed = tmp_path / "handbook.pdf"
    printed.write_bytes(page.pdf())
    text = subprocess.run(["pdftotext", "-layout", printed, "-"], capture_output=True, check=True).stdout.decode()
    pages = [lines_of(part) for part in text.split("\f")[:-1]]
    numbers = [[int(number) for number in re.findall(r"\d+", lines[-1])] for lines in pages]
    assert numbers == [[number, len(pages)] for number in range(1, len(pages) + 1)]
    headings = [re.sub("<[^>]*>", "", text) for text in re.findall("<h3[^>]*>(.*?)</h3>", written.read_text("utf-8"))]
    assert len(headings) > 40
    assert [lines[-2] for lines in pages if lines[-2] in headings] == []
