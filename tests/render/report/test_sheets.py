"""The report on sheets of paper: what its contents say is where it stands."""

import functools
import html
import re
import shutil
import subprocess

import chromium
import numpy as np
import pytest
from conftest import CONFIGS, WANTED

from afmcalc.messages import ENGLISH, language, speaking
from afmcalc.render.report.sheets import print_pdf, printed

EXAMPLES = sorted(path.stem for path in CONFIGS.glob("*.toml") if path.stem not in WANTED)
pytestmark = [
    pytest.mark.skipif(chromium.PATH is None, reason=chromium.REASON),
    pytest.mark.skipif(shutil.which("pdftotext") is None, reason="no pdftotext on the path: no sheet is read"),
]


def lines_of(pdf):
    """The lines of each sheet."""
    run = subprocess.run(["pdftotext", "-layout", "-", "-"], input=pdf, capture_output=True, check=True)
    return [[" ".join(line.split()) for line in sheet.splitlines()] for sheet in run.stdout.decode().split("\f")[:-1]]


@pytest.fixture(scope="session")
def on_paper(drawn, parsed):
    """The tree of the report of a shipped spec, and its PDF."""

    @functools.cache
    def printed_once(name, spoken, *options):
        page = drawn(name, "--lang", spoken, *options)
        with speaking(ENGLISH if spoken == "en" else language(spoken)):
            return parsed(page), printed(chromium.PATH, page)

    return printed_once


def every_report(test):
    """A test of the report of each shipped spec in each language; of one of them by default."""
    test = pytest.mark.parametrize("language", ["en", "ru"])(test)
    test = pytest.mark.parametrize("name", ["default", *(name for name in EXAMPLES if name != "default")])(test)
    return pytest.mark.every(1000)(test)


@every_report
def test_contents_tell_the_sheet_of_each_heading(name, language, on_paper):
    tree, pdf = on_paper(name, language)
    sheets = lines_of(pdf)
    entries = ["".join(entry.itertext()).strip() for entry in tree.findall(".//nav//li/div")]
    assert len(entries) > 8
    for entry in entries:
        said = [
            int(found) for line in sheets[0] for found in re.findall(rf"(?:^| ){re.escape(entry)} (\d+)(?: |$)", line)
        ]
        assert said == [number for number, lines in enumerate(sheets, 1) if entry in lines], entry


def squeezed(element):
    """The text of a part of a page, without its spaces."""
    return "".join("".join(element.itertext()).split())


def fields_of(pdf, language):
    """What the field of each sheet says, without spaces, in the order of the page."""
    for number, words in enumerate(words_of(pdf, "-raw")):
        left, top, _, bottom = FRAME[number == 0] if language == "ru" else (0, 14, 210, 283)
        yield "".join(word[4] for word in words if word[0] > left and top < word[1] and word[3] < bottom)


@every_report
def test_nothing_is_parted_from_what_it_is_of(name, language, on_paper):
    """No sheet ends with a heading, the caption or head of a table, what a formula is of, or begins with the caption of a figure."""
    tree, pdf = on_paper(name, language)
    tables = [(table.find("caption"), table.find("thead")) for table in tree.findall(".//table")]
    tables = [tuple(map(squeezed, parts)) for parts in tables if None not in parts]
    ends = [squeezed(part) for level in ("h2", "h3", "h4") for part in tree.findall(f".//{level}")]
    ends += [caption for caption, _ in tables] + [caption + head for caption, head in tables]
    ends += [squeezed(part) for part in tree.findall(".//p[@class='what']")]
    begins = [squeezed(part) for part in tree.findall(".//figcaption")]
    fields = [*fields_of(pdf, language)]
    assert [part for part in (*ends, *begins) if not any(part in field for field in fields)] == []
    assert [part for part in ends for field in fields if field.endswith(part)] == []
    assert [part for part in begins for field in fields if field.startswith(part[:14])] == []


@every_report
def test_a_table_that_goes_on_says_so_with_its_head(name, language, on_paper):
    """On each sheet that it reaches; one of few rows stays on its sheet."""
    tree, pdf = on_paper(name, language)
    caption = {"en": "Table{}–", "ru": "Таблица{}–"}[language]
    again = {"en": "Table{},continued", "ru": "Продолжениетаблицы{}"}[language]
    fields = [*fields_of(pdf, language)]
    parted = 0
    for number, table in enumerate((part for part in tree.findall(".//table") if part.find("caption") is not None), 1):
        head, rows = squeezed(table.find("thead")), [squeezed(row) for row in table.findall("tbody/tr")]
        (place,) = [place for place, field in enumerate(fields) if caption.format(number) in field]
        _, _, rest = fields[place].partition(caption.format(number))
        assert head in rest
        for row in rows:
            if row not in rest:
                parted += 1
                place, begin = place + 1, again.format(number) + head
                assert fields[place].startswith(begin + row), (number, row)
                assert len(rows) > 5
                rest = fields[place].removeprefix(begin)
            rest = rest[rest.index(row) + len(row) :]
    assert len(re.findall(again.format(r"\d+"), "".join(fields))) == parted
    assert parted or (name, language) != ("default", "en")


@every_report
def test_each_table_and_figure_on_paper_is_referred_to(name, language, on_paper):
    tree, pdf = on_paper(name, language)
    text = "".join(fields_of(pdf, language))
    words = {"en": ("table", "figure"), "ru": ("таблица", "рисунок")}[language]
    for word, parts in zip(words, (tree.findall(".//caption"), tree.findall(".//figure")), strict=True):
        captions = [int(number) for number in re.findall(rf"{word.capitalize()}(\d+)–", text)]
        assert captions == [*range(1, len(parts) + 1)]
        assert {int(number) for number in re.findall(rf"{word}(\d+)[.,]", text)} == {*captions}


@pytest.mark.every(20)
@pytest.mark.parametrize("name", ["wood-chipper-clutch", *(name for name in EXAMPLES if name != "wood-chipper-clutch")])
@pytest.mark.parametrize("language", ["ru", "en"])
def test_a_short_report_has_two_sheets(language, name, on_paper):
    _, pdf = on_paper(name, language, "--short")
    fields = [*fields_of(pdf, "en")]
    assert len(fields) <= 2
    assert {"en": "Whatistobedonenext", "ru": "Чтоследуетсделать"}[language] in fields[-1]


MM = 25.4 / 72
FRAME = {True: (20, 5, 205, 252), False: (20, 5, 205, 277)}
"""Field for text of the first sheet, and of all others, mm from the upper left corner."""


def words_of(pdf, *order):
    """The words of each sheet: left, top, right, bottom in mm, and the text."""
    run = subprocess.run(["pdftotext", *order, "-bbox", "-", "-"], input=pdf, capture_output=True, check=True)
    word = re.compile(r'<word xMin="(.*?)" yMin="(.*?)" xMax="(.*?)" yMax="(.*?)">(.*?)</word>')
    for sheet in run.stdout.decode().split("<page ")[1:]:
        yield [
            (*(float(number) * MM for number in found.groups()[:4]), html.unescape(found[5]))
            for found in word.finditer(sheet)
        ]


def dark(pdf):
    """Each sheet: which tenths of a millimetre, row by row, are not white."""
    run = subprocess.run(["pdftoppm", "-gray", "-r", "254"], input=pdf, capture_output=True, check=True)
    data = run.stdout
    while data:
        _, size, _, data = data.split(b"\n", 3)
        wide, high = map(int, size.split())
        yield np.frombuffer(data[: wide * high], np.uint8).reshape(high, wide) < 128
        data = data[wide * high :]


def line_near(profile, at):
    """Middle of the line near a place, mm; NaN where there is none."""
    near = slice(10 * at - 20, 10 * at + 20)
    return np.flatnonzero(profile[near] > 0.9).mean() / 10 + 0.05 + at - 2


def within(word, left, top, right, bottom):
    return left <= word[0] and top <= word[1] and word[2] <= right and word[3] <= bottom


@pytest.mark.every(1000)
@pytest.mark.parametrize("name", EXAMPLES)
def test_a_frame_surrounds_each_sheet_and_nothing_touches_it(name, afmcalc, tmp_path):
    """Fields of 20 and 5 mm; text 3 mm from the sides, 10 mm from top and title block; a number on each sheet."""
    title = {"drawing": "АФМ.0217.00.000 РР", "author": "Шишкарёв М.П.", "organisation": "Завод «Муфта»"}
    options = [part for key, text in title.items() for part in (f"--{key}", text)]
    run = afmcalc("report", CONFIGS / f"{name}.toml", "--lang", "ru", "--pdf", "-o", tmp_path / "x.html", *options)
    assert run.code == 0, run.err
    pdf = (tmp_path / "x.pdf").read_bytes()
    sheets = list(zip(words_of(pdf), dark(pdf), strict=True))
    for number, (words, inked) in enumerate(sheets, 1):
        left, top, right, bottom = FRAME[number == 1]
        field = left + 3, top + 9.5, right - 3, bottom - 9.5
        block = [word for word in words if within(word, left, bottom, right, 292)]
        margin = [word for word in words if within(word, 8, 147, 20, 292)]
        assert {word[4] for word in margin} == {"Подп.", "и", "дата", "Инв.", "инв.", "№", "дубл.", "Взам.", "подл."}
        rest = [word for word in words if word not in block and word not in margin]
        assert [word for word in rest if not within(word, *field)] == []
        assert " ".join(word[4] for word in block if 85 <= word[0] < 195 and word[3] < bottom + 15).startswith(
            title["drawing"]
        )
        cell = (185, 272, 205, 277) if number == 1 else (195, 284, 205, 292)
        assert [word[4] for word in block if within(word, *cell)] == [str(len(sheets) if number == 1 else number)]
        upright, level = inked[100:1400].mean(0), inked[:, 300:2000].mean(1)
        for line, at in ((upright, left), (upright, right), (level, top), (level, bottom), (level, 292)):
            assert line_near(line, at) == pytest.approx(at, abs=0.3)
        assert not inked[60 : 10 * bottom - 10, 10 * left + 6 : 10 * left + 30].any()
        assert not inked[60 : 10 * bottom - 10, 10 * right - 30 : 10 * right - 6].any()
    assert "Шишкарёв" in {word[4] for word in sheets[0][0] if within(word, 37, 267, 60, 272)}


@pytest.mark.every(1000)
@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("name", ["indirect", "constant-torque", "conveyor-clutch", "envelope", "drive"])
def test_the_form_of_a_report_has_its_fields_and_a_number_below(name, language, afmcalc, tmp_path):
    """Fields of 30, 15, 20 and 20 mm within 0.3; no number on the title sheet; the same from the spec as from the option, which goes before it."""
    spec = tmp_path / "x.toml"
    text = (CONFIGS / f"{name}.toml").read_text(encoding="utf-8")
    pages = []
    for form, options in (("report", ()), ("calculation", ("--form", "report"))):
        spec.write_text(f'{text}\n[report]\nform = "{form}"\n', encoding="utf-8")
        run = afmcalc("report", spec, "--lang", language, "--pdf", "-o", tmp_path / "x.html", "--force", *options)
        assert run.code == 0, run.err
        pages.append((tmp_path / "x.html").read_text(encoding="utf-8"))
    assert len({page[page.index("@page") : page.index("</style>")] for page in pages}) == 1
    pdf = (tmp_path / "x.pdf").read_bytes()
    sheets = list(zip(words_of(pdf), dark(pdf), strict=True))
    for number, (words, inked) in enumerate(sheets, 1):
        assert not inked[:197].any()
        assert not inked[:, :297].any()
        assert not inked[:, 1953:].any()
        below = [word for word in words if word[3] > 277.5]
        assert [word[4] for word in below] == [str(number)] * (number > 1)
        assert all(abs((left + right) / 2 - 112.5) < 1 for left, _, right, _, _ in below)


def test_a_form_that_there_is_not(afmcalc, tmp_path):
    run = afmcalc("report", "--form", "letter", "-o", tmp_path / "x.html")
    assert (run.code, run.out) == (2, "")
    assert 'form = "letter"' in run.err
    assert "calculation" in run.err
    assert not [*tmp_path.iterdir()]


def test_numbers_that_move_a_heading_are_told_anew():
    """Contents of four sheets where the numbers have two digits, of three where they have one."""
    entry = '<span class="page" data-of="here"></span> '
    page = f'<!doctype html><a href="#here">.</a><p>{entry * 8000}</p><h2 id="here">Here</h2>'
    *contents, last = lines_of(printed(chromium.PATH, page))
    said = "".join(line for lines in (*contents, last[: last.index("Here")]) for line in lines)
    assert said.strip(".").replace(" ", "") == str(len(contents) + 1) * 8000
    first = lines_of(print_pdf(chromium.PATH, page.replace("</span>", "88</span>")))
    assert len(first) > len(contents) + 1


def test_without_a_reader_of_pdf_it_is_said_before_anything_is_calculated(afmcalc, monkeypatch, tmp_path):
    monkeypatch.setattr("afmcalc.errors.find_spec", lambda name: None if name == "pypdf" else object())
    run = afmcalc("report", "--pdf", "-o", tmp_path / "x.html")
    assert (run.code, run.out) == (2, "")
    assert run.err.splitlines()[-1] == "error: this needs pypdf, not installed here: pip install 'afmcalc[report]'"
    assert not [*tmp_path.iterdir()]


@pytest.mark.parametrize(("version", "noted"), [(130, True), (131, False)])
def test_a_browser_that_prints_no_margins_is_named(version, noted, afmcalc, monkeypatch, tmp_path, undrawn):
    pdf = f"%PDF-1.4 /Producer (Skia/PDF m{version}) %%EOF".encode()
    monkeypatch.setattr("afmcalc.render.report.sheets.printed", lambda *given: pdf)
    run = afmcalc("report", CONFIGS / "default.toml", "-o", tmp_path / "x.pdf")
    assert (run.code, (tmp_path / "x.pdf").read_bytes()) == (0, pdf)
    assert ("Chromium 131" in run.err) == noted
