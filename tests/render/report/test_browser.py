"""The report in a real browser and on paper."""

import re

import chromium
import pytest

VARIANTS = ["default", "conventional", "unlike-materials", "all-driving", "indirect", "tolerance"]

browser = pytest.mark.skipif(chromium.PATH is None, reason=chromium.REASON)


@pytest.fixture(scope="module")
def page():
    with chromium.opened() as opened:
        yield opened


@pytest.fixture
def opened(page, report, tmp_path):
    """Open the report of a shipped spec."""

    def open_(name):
        file = tmp_path / "report.html"
        file.write_text(report(name), encoding="utf-8")
        page.requests.clear()
        page.open(file)
        assert page.requests == [file.as_uri()]
        return page

    return open_


@browser
@pytest.mark.parametrize("name", VARIANTS)
def test_in_a_browser(name, opened):
    page = opened(name)
    for scheme in ("light", "dark"):
        page.scheme(scheme)
        for width in (375, 1280):
            page.resize(width)
            assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert page.evaluate("getComputedStyle(document.documentElement).backgroundColor") == "rgb(21, 23, 26)"
    laid_out = "(e => e.getBoundingClientRect().height)(document.querySelector('{}'))"
    assert page.evaluate(laid_out.format("mfrac")) > 1.4 * page.evaluate(laid_out.format("mfrac mi"))
    assert page.problems == []


@browser
@pytest.mark.parametrize("name", VARIANTS)
def test_on_paper(name, opened):
    """A4 less its margins is 658 px wide: no table is wider, no figure higher than a page."""
    page = opened(name)
    page.scheme("light")
    page.resize(658)
    page.call("Emulation.setEmulatedMedia", media="print")
    try:
        assert page.evaluate("[...document.querySelectorAll('table, pre, svg')].every(e => e.scrollWidth <= 658)")
        assert page.evaluate("Math.max(...[...document.querySelectorAll('figure')].map(e => e.offsetHeight))") < 986
    finally:
        page.call("Emulation.setEmulatedMedia", media="")
    printed = page.pdf()
    assert printed.startswith(b"%PDF")
    assert len(re.findall(rb"/Type\s*/Page\b", printed)) >= 5


@browser
def test_pdf_beside_the_report(afmcalc, tmp_path):
    assert afmcalc("report", "-o", tmp_path / "r.html", "--pdf").code == 0
    assert (tmp_path / "r.pdf").read_bytes().startswith(b"%PDF")


def test_pdf_refusals(afmcalc, monkeypatch, tmp_path):
    assert "-o report.html" in afmcalc("report", "--pdf").err
    assert "x.html --pdf" in afmcalc("report", "--pdf", "-o", "x.pdf").err
    monkeypatch.setenv("PATH", str(tmp_path))
    run = afmcalc("report", "--pdf", "-o", tmp_path / "x.html")
    assert run.code == 2
    assert "no headless browser found" in run.err
    assert not (tmp_path / "x.html").exists()


def test_a_date_that_is_none(afmcalc, monkeypatch):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "x")
    run = afmcalc("report")
    assert (run.code, run.out) == (2, "")
    assert "SOURCE_DATE_EPOCH" in run.err
