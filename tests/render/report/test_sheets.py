"""The report on sheets of paper: what its contents say is where it stands."""

import re
import shutil
import subprocess

import chromium
import pytest
from conftest import CONFIGS, WANTED

from afmcalc.render.report.browser import print_pdf
from afmcalc.render.report.sheets import printed

EXAMPLES = sorted(path.stem for path in CONFIGS.glob("*.toml") if path.stem not in WANTED)
pytestmark = [
    pytest.mark.skipif(chromium.PATH is None, reason=chromium.REASON),
    pytest.mark.skipif(shutil.which("pdftotext") is None, reason="no pdftotext on the path: no sheet is read"),
]


def lines_of(pdf):
    """The lines of each sheet."""
    run = subprocess.run(["pdftotext", "-layout", "-", "-"], input=pdf, capture_output=True, check=True)
    return [[" ".join(line.split()) for line in sheet.splitlines()] for sheet in run.stdout.decode().split("\f")[:-1]]


@pytest.mark.every(1000)
@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("name", ["default", *(name for name in EXAMPLES if name != "default")])
def test_contents_tell_the_sheet_of_each_heading(name, language, afmcalc, drawn, parsed):
    page = drawn(name, "--lang", language)
    sheets = lines_of(printed(chromium.PATH, page))
    entries = ["".join(entry.itertext()).strip() for entry in parsed(page).findall(".//nav//li/div")]
    assert len(entries) > 8
    for entry in entries:
        said = [
            int(found) for line in sheets[0] for found in re.findall(rf"(?:^| ){re.escape(entry)} (\d+)(?: |$)", line)
        ]
        assert said == [number for number, lines in enumerate(sheets, 1) if entry in lines], entry


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
