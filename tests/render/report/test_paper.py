"""Report and handbook in a browser and on sheets of paper; what the command says where it cannot print."""

import re
import subprocess

import pytest
from conftest import CONFIGS
from sources import SCRIPTS

from afmcalc.analysis.dossier import dossier
from afmcalc.messages import ENGLISH, language, speaking
from afmcalc.render.report import Subject
from afmcalc.render.report import book as handbook
from afmcalc.render.report import report as laid_out
from afmcalc.render.report.blocks import Section
from afmcalc.render.report.sheets import print_pdf
from afmcalc.spec import read_spec
from afmcalc.spec.models import TitleBlock


@pytest.mark.tool
@pytest.mark.parametrize("what", ["report", "handbook"])
def test_in_a_browser(what, chromium, drawn, book, tmp_path):
    """The page loads nothing, is no wider than the window, and cuts off no formula."""
    file = tmp_path / "page.html"
    with speaking(ENGLISH):
        made = drawn("indirect") if what == "report" else handbook.render(book("en"))
    file.write_text(made, encoding="utf-8")
    page, asked, problems = chromium.new_page(), [], []
    page.on("request", lambda request: asked.append(request.url))
    page.on("console", lambda line: problems.append(line.text))
    page.on("pageerror", lambda error: problems.append(str(error)))
    page.goto(file.as_uri())
    assert (asked, problems) == ([file.as_uri()], [])
    for scheme, width in (("light", 1280), ("dark", 375)):
        page.emulate_media(color_scheme=scheme)
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        assert page.evaluate(SCRIPTS["in_its_box"]), scheme
    assert page.evaluate("getComputedStyle(document.documentElement).backgroundColor") == "rgb(21, 23, 26)"
    page.close()


def document(name="default", **more):
    """Document of the report on a shipped clutch."""
    form = more.pop("form", "calculation")
    title = TitleBlock(drawing="AFM-17", author="Ш.", date="2026-02-03", revision="4", form=form)
    spec = read_spec(f"example:{name}").model_copy(update={"report": title})
    return laid_out(Subject(dossier(spec, explained=not more.get("short")), **more))


def sheets(pdf):
    """Text of each sheet, with hyphenated words joined."""
    read = subprocess.run(["pdftotext", "-layout", "-", "-"], input=pdf, capture_output=True, check=True)
    shown = read.stdout.decode().replace("\u2060", "")
    return [" ".join(each.split()).replace("\xad ", "") for each in shown.split("\f")[:-1]]


@pytest.mark.slow
@pytest.mark.tool
@pytest.mark.parametrize("form", ["calculation", "report"])
def test_on_paper(form):
    """Each heading is on the sheet that the contents name; continued tables and the numbers of sheets are marked."""
    with speaking(language("ru")):
        given = document("indirect", form=form)
        pdf, _ = print_pdf(given)
        assert form == "report" or pdf == print_pdf(given)[0], "the same bytes"
    found = sheets(pdf)
    sections = [part for whole in given.body for part in (whole, *whole.body) if isinstance(part, Section)]
    contents = next(each for each in found if "Содержание" in each)
    for section in sections:
        (number,) = re.findall(rf"{re.escape(f'{section.label} {section.title}')} [. ]*(\d+)(?= |$)", contents)
        assert f"{section.label} {section.title}" in found[int(number) - 1], section.key
        assert not found[int(number) - 1].endswith(str(section.title))
    assert any(f"Продолжение таблицы {number}" in each for number in range(1, 11) for each in found[1:])
    framed = [each for each in found if "AFM-17" in each]
    assert len(framed) == (len(found) if form == "calculation" else 1)
    assert b"/PDFA" in pdf or b"pdfaid" in pdf


@pytest.mark.tool
@pytest.mark.parametrize("name", ["default", "indirect"])
def test_a_short_report_has_two_sheets(name):
    for spoken in (ENGLISH, language("ru")):
        with speaking(spoken):
            assert len(sheets(print_pdf(document(name, short=True))[0])) == 2


HOSTILE = (
    '#read("/etc/passwd") $x$ *b* @ref </style><script>alert(1)</script> {{7*7}} \u202eabc \x1b[31m \x00 \\u{41} <a>'
)


@pytest.mark.tool
def test_texts_of_the_user_stay_texts():
    title = TitleBlock(drawing=HOSTILE[:60], author=HOSTILE[:40], organisation=HOSTILE[:50], date="soon")
    told = dossier(read_spec("example:default").model_copy(update={"report": title}), explained=False)
    told.spec.label.text = HOSTILE
    for spoken in (ENGLISH, language("ru")):
        with speaking(spoken):
            found = " ".join(sheets(print_pdf(laid_out(Subject(told, with_source=True)))[0]))
        shown = found.replace(" ", "")
        assert '#read("/etc/passwd")$x$*b*@ref</style><script>alert(1)</script>{{7*7}}\\u202eabc' in shown
        assert "root:" not in found


@pytest.mark.tool
def test_a_character_that_no_font_has_is_named(afmcalc, undrawn, tmp_path):
    run = afmcalc("report", CONFIGS / "default.toml", "--short", "--set", "name=齒 A", "-o", tmp_path / "x.pdf")
    assert run.code == 0
    assert "boxes in the place of 齒: no font" in run.err


def test_what_is_refused_before_anything_is_calculated(afmcalc, monkeypatch, tmp_path):
    """Refused are an unknown form, a missing Typst, an invalid date; nothing is written."""

    def said(*given):
        run = afmcalc("report", *given)
        assert (run.code, run.out, [*tmp_path.iterdir()]) == (2, "", [])
        return run.err

    assert "'letter' is not one of" in said("--form", "letter", "-o", tmp_path / "x.html")
    with monkeypatch.context() as patch:
        patch.setattr("afmcalc.errors.find_spec", lambda name: None if name == "typst" else object())
        assert "afmcalc[pdf]" in said("-o", tmp_path / "x.pdf")
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "x")
    assert "SOURCE_DATE_EPOCH" in said()
