"""The report in a real browser and on paper."""

import re
import shutil
import subprocess

import chromium
import pytest

VARIANTS = ["indirect", "default", "conventional", "unlike-materials", "all-driving", "tolerance"]
"""The first has the widest formulas."""
MOST_PAGES = {"default": 20, "all-driving": 20, "tolerance": 22}
"""One of them is the section of the clutch, three are the lists of symbols and misprints."""

browser = pytest.mark.skipif(chromium.PATH is None, reason=chromium.REASON)
TOOLS = [shutil.which(name) for name in ("pdftotext", "pdftoppm")]
paper = pytest.mark.skipif(None in TOOLS, reason="no pdftotext and pdftoppm on the path: no printed page is read")


@pytest.fixture(scope="module")
def page():
    with chromium.opened() as opened:
        yield opened


@pytest.fixture(scope="module", params=VARIANTS)
def opened(request, page, drawn, tmp_path_factory):
    """The name of a shipped spec, and its report, opened once."""
    file = tmp_path_factory.mktemp("report") / "report.html"
    file.write_text(drawn(request.param), encoding="utf-8")
    page.requests.clear()
    page.open(file)
    assert page.requests == [file.as_uri()]
    return request.param, page


IN_ITS_BOX = """
[...document.querySelectorAll('.scroll')].every(box => {
  const own = box.getBoundingClientRect(), right = own.left + box.scrollWidth
  return box.scrollHeight <= box.clientHeight && [...box.querySelectorAll('math, math *')].every(each => {
    const it = each.getBoundingClientRect()
    return it.top >= own.top && it.bottom <= own.bottom && it.left >= own.left && it.right <= right + 0.5
  })
})"""
"""No formula is cut off, nothing scrolls up and down."""

ALL_SHOWN = "[...document.querySelectorAll('.scroll')].every(box => box.scrollWidth <= box.clientWidth)"


SMALLEST = """
Math.min(...[...document.querySelectorAll('figure text, figcaption')].map(text => {
  const figure = text.closest('svg'), scale = figure ? figure.getScreenCTM().a * 665 / document.body.clientWidth : 1
  return scale * parseFloat(getComputedStyle(text).fontSize)
}))"""
"""Size of the smallest text of a figure, subscripts apart, on paper, whose text is 665 px wide."""


@browser
@pytest.mark.every(6)
def test_in_a_browser(opened):
    name, page = opened
    for scheme, width in (("light", 1280), ("dark", 1280), ("dark", 375)):
        page.scheme(scheme)
        page.resize(width)
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        assert page.evaluate(IN_ITS_BOX), (scheme, width)
        assert width < 1280 or page.evaluate(ALL_SHOWN)
    assert page.evaluate("getComputedStyle(document.documentElement).backgroundColor") == "rgb(21, 23, 26)"
    laid_out = "(e => e.getBoundingClientRect().height)(document.querySelector('{}'))"
    assert page.evaluate(laid_out.format("mfrac")) > 1.4 * page.evaluate(laid_out.format("mfrac mi"))
    upright = "[...document.querySelectorAll('mi')].filter(e => /^(sin|cos|tan|ln)$/.test(e.textContent)).length"
    assert page.evaluate(upright) > 0 or name == "conventional"
    assert page.problems == []
    page.scheme("light")
    # A4 less its margins is 662 px wide: no table is wider, no figure higher than a page
    page.resize(662)
    page.call("Emulation.setEmulatedMedia", media="print")
    try:
        assert page.evaluate("[...document.querySelectorAll('table, pre, svg, math')].every(e => e.scrollWidth <= 662)")
        assert page.evaluate(SMALLEST) >= 12  # px, 9 pt
        assert page.evaluate("Math.max(...[...document.querySelectorAll('figure')].map(e => e.offsetHeight))") < 986
    finally:
        page.call("Emulation.setEmulatedMedia", media="")


def lines_of(page_text):
    return [line.strip() for line in page_text.splitlines() if line.strip()]


def used(file):
    """How far down each page is filled, of the room between header and footer."""
    run = subprocess.run(["pdftoppm", "-gray", "-r", "30", file], capture_output=True, check=True)
    for size, data in re.findall(rb"P5\n(\d+ \d+)\n255\n(.*?)(?=P5\n|\Z)", run.stdout, re.DOTALL):
        width, height = map(int, size.split())
        rows = [min(data[row * width : (row + 1) * width]) < 245 for row in range(height)]
        top, bottom = round(17 / 297 * height), round((297 - 15) / 297 * height)
        yield (max(row for row in range(top, bottom) if rows[row]) - top) / (bottom - top)


@browser
@paper
@pytest.mark.exhaustive
def test_on_paper(opened, drawn, tmp_path):
    """Contents, page numbers, no half-empty page, no heading without its text."""
    name, page = opened
    printed = tmp_path / "report.pdf"
    printed.write_bytes(page.pdf())
    text = subprocess.run(["pdftotext", "-layout", printed, "-"], capture_output=True, check=True).stdout.decode()
    pages = [lines_of(each) for each in text.split("\f")[:-1]]
    assert 5 <= len(pages) <= MOST_PAGES.get(name, 18)
    assert [page[-1] for page in pages] == [f"Sheet {number} of {len(pages)}" for number in range(1, len(pages) + 1)]
    source = drawn(name)
    plain = re.compile("<[^>]*>")
    listed = [plain.sub("", each) for each in re.findall(r'<div>[\d.]+ <a href="#[a-z]+">(.*?)</a>', source)]
    assert "Contents" in pages[0]
    assert all(any(title in line for line in pages[0]) for title in listed)
    headings = [plain.sub("", each).split(None, 1)[-1] for each in re.findall(r"<h[234]>(.*?)</h[234]>", source)]
    assert len(headings) > 10
    for own in pages[:-1]:
        assert not own[-2].endswith(tuple(headings)), own[-2]
    assert min([*used(printed)][:-1]) > 0.5


@browser
def test_the_command_prints_beside_the_page(afmcalc, monkeypatch, tmp_path):
    monkeypatch.setattr("afmcalc.render.report.render", lambda *given: "<!doctype html><p>all of it</p>")
    assert afmcalc("report", "--pdf", "-o", tmp_path / "x.html").code == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == ["x.html", "x.pdf"]
    assert (tmp_path / "x.pdf").read_bytes().startswith(b"%PDF")
    assert afmcalc("report", "-o", tmp_path / "y.PDF").code == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == ["x.html", "x.pdf", "y.PDF"]
    assert (tmp_path / "y.PDF").read_bytes().startswith(b"%PDF")


def test_pdf_refusals(afmcalc, monkeypatch, tmp_path):
    assert "-o FILE.html" in afmcalc("report", "--pdf").err
    monkeypatch.setenv("PATH", str(tmp_path))
    for name in ("x.html", "x.pdf"):
        run = afmcalc("report", "--pdf", "-o", tmp_path / name)
        assert run.code == 2
        assert "no headless browser found" in run.err
        assert not (tmp_path / name).exists()


def test_a_date_that_is_none(afmcalc, monkeypatch):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "x")
    run = afmcalc("report")
    assert (run.code, run.out) == (2, "")
    assert "SOURCE_DATE_EPOCH" in run.err
