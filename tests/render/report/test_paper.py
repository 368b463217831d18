"""Report and handbook in a browser and on sheets of paper; what the command says where it cannot print."""

import io
import re

import pytest
from conftest import CONFIGS
from pypdf import PdfReader

from afmcalc.messages import language, speaking
from afmcalc.render.report.sheets import find_browser, printed

IN_ITS_BOX = """[...document.querySelectorAll('.scroll')].every(box => {
  const own = box.getBoundingClientRect(), right = own.left + box.scrollWidth
  return box.scrollHeight <= box.clientHeight && [...box.querySelectorAll('math, math *')].every(each => {
    const it = each.getBoundingClientRect()
    return it.top >= own.top && it.bottom <= own.bottom && it.left >= own.left && it.right <= right + 0.5 }) })"""
SMALLEST = """Math.min(...[...document.querySelectorAll('figure text, figcaption')].map(text => {
  const figure = text.closest('svg'), scale = figure ? figure.getScreenCTM().a * 665 / document.body.clientWidth : 1
  return scale * parseFloat(getComputedStyle(text).fontSize) }))"""
PAPER = 662
"""A4 less its margins, in pixels."""


@pytest.fixture(scope="module")
def browser():
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=find_browser(), args=["--no-sandbox"])
        yield opened
        opened.close()


@pytest.mark.tool
@pytest.mark.parametrize("what", ["report", "handbook"])
def test_in_a_browser(what, browser, drawn, handbook_page, tmp_path):
    """Nothing is loaded, nothing wider than the window, no formula cut off; in print 9 points and as wide as the paper."""
    file = tmp_path / "page.html"
    file.write_text(drawn("indirect") if what == "report" else handbook_page("en"), encoding="utf-8")
    page, asked, problems = browser.new_page(), [], []
    page.on("request", lambda request: asked.append(request.url))
    page.on("console", lambda line: problems.append(line.text))
    page.on("pageerror", lambda error: problems.append(str(error)))
    page.goto(file.as_uri())
    assert (asked, problems) == ([file.as_uri()], [])
    for scheme, width in (("light", 1280), ("dark", 375)):
        page.emulate_media(color_scheme=scheme)
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        assert page.evaluate(IN_ITS_BOX), scheme
    assert page.evaluate("getComputedStyle(document.documentElement).backgroundColor") == "rgb(21, 23, 26)"
    page.set_viewport_size({"width": PAPER, "height": 900})
    page.emulate_media(color_scheme="light", media="print")
    assert page.evaluate("document.documentElement.scrollWidth") <= PAPER
    assert page.evaluate("Math.max(...[...document.querySelectorAll('figure')].map(e => e.offsetHeight))") < 986
    assert what == "handbook" or page.evaluate(SMALLEST) >= 12  # px, 9 pt
    page.close()


@pytest.mark.tool
def test_on_paper(report, parsed):
    """Each heading is on the sheet that the contents tell, and ends none; a table that goes on says so."""
    page = report("default", "--lang", "ru")
    with speaking(language("ru")):
        pdf = printed(find_browser(), page)
    sheets = [" ".join(sheet.extract_text().split()) for sheet in PdfReader(io.BytesIO(pdf)).pages]
    tree = parsed(page)
    entries = [" ".join("".join(entry.itertext()).split()) for entry in tree.findall(".//nav//li/div")]
    assert len(entries) > 8
    for entry in entries:
        (told,) = re.findall(rf"(?:^| ){re.escape(entry)} (\d+)(?= |$)", sheets[0])
        assert f" {entry} " in sheets[int(told) - 1].replace(f" {entry} {told}", "", told == "1"), entry
        assert not [sheet for sheet in sheets if sheet.endswith(entry)]
    parted = [int(number) for sheet in sheets for number in re.findall(r"Продолжение таблицы (\d+)", sheet)]
    assert set() < {*parted} <= {int(table.get("id").removeprefix("table-")) for table in tree.findall(".//caption")}


@pytest.mark.tool
def test_the_command_prints_beside_the_page(afmcalc, monkeypatch, tmp_path):
    monkeypatch.setattr("afmcalc.render.report.render", lambda *given: "<!doctype html><p>all of it</p>")
    assert afmcalc("report", "--pdf", "-o", tmp_path / "x.html").code == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == ["x.html", "x.pdf"]
    assert (tmp_path / "x.pdf").read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize("name", ["x.html", "x.pdf"])
def test_without_a_browser_nothing_is_written(name, afmcalc, monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    run = afmcalc("report", "--pdf", "-o", tmp_path / name)
    assert (run.code, "AFMCALC_BROWSER" in run.err) == (2, True)
    assert not [*tmp_path.iterdir()]


def test_what_is_refused_before_anything_is_calculated(afmcalc, monkeypatch, tmp_path):
    assert "-o FILE.html" in afmcalc("report", "--pdf").err
    run = afmcalc("report", "--form", "letter", "-o", tmp_path / "x.html")
    assert (run.code, 'form = "letter"' in run.err, "calculation" in run.err) == (2, True, True)
    monkeypatch.setattr("afmcalc.errors.find_spec", lambda name: None if name == "pypdf" else object())
    run = afmcalc("report", "--pdf", "-o", tmp_path / "x.html")
    assert (run.code, "afmcalc[report]" in run.err, "pypdf" in run.err) == (2, True, True)
    assert not [*tmp_path.iterdir()]
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "x")
    run = afmcalc("report")
    assert (run.code, "SOURCE_DATE_EPOCH" in run.err) == (2, True)


@pytest.mark.parametrize(("version", "noted"), [(130, True), pytest.param(131, False, marks=pytest.mark.slow)])
def test_a_browser_that_prints_no_margins_is_named(version, noted, afmcalc, monkeypatch, tmp_path, undrawn):
    pdf = f"%PDF-1.4 /Producer (Skia/PDF m{version}) %%EOF".encode()
    monkeypatch.setattr("afmcalc.render.report.sheets.printed", lambda *given: pdf)
    monkeypatch.setattr("afmcalc.render.report.sheets.find_browser", lambda: "browser")
    run = afmcalc("report", CONFIGS / "default.toml", "-o", tmp_path / "x.pdf")
    assert (run.code, (tmp_path / "x.pdf").read_bytes()) == (0, pdf)
    assert ("Chromium 131" in run.err) == noted
