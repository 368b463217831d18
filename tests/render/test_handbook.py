"""The handbook: it shows every formula, leads nowhere that is not there, and says the same in both languages."""

import re
import tomllib
from pathlib import Path

import pytest
from conftest import FRAME

import afmcalc
from afmcalc.analysis.handbook_content import chapter_texts, commands_of
from afmcalc.analysis.registry import ANALYSES
from afmcalc.equations.catalogue import equations
from afmcalc.messages import language, speaking
from afmcalc.papers.register import misprints, register
from afmcalc.render.report.book import render

PACKAGE = Path(afmcalc.__file__).parent
USES = PACKAGE / "papers" / "handbook" / "uses.toml"
DIRECTIVE = re.compile(r"\{(\w+) ([^{}]+)\}")


def uses():
    """Equation → the commands that calculate it."""
    found = tomllib.loads(USES.read_text(encoding="utf-8"))
    return {name: use["commands"] if isinstance(use, dict) else use for name, use in found.items()}


def test_uses_are_of_equations_and_name_commands():
    for name, commands in uses().items():
        assert name in equations()
        assert {*commands} <= ANALYSES.keys()
        assert commands == sorted(set(commands))


@pytest.mark.slow
def test_every_formula_is_reached_or_says_why_not():
    """A function is calculated by a command; a formula without one is covered by others. Else the entry says why."""
    reached = {entry.id: bool(entry.function and commands_of(entry.function)) for entry in register()}
    for entry in register():
        assert entry.not_reached is None or not reached[entry.id], f"{entry.id} is reached"
        assert reached[entry.id] or entry.not_reached or (entry.covered_by and not entry.function), entry.id


def test_each_formula_and_misprint_stands_once():
    """Of the laws those that are formulas: a choice, a mean, the larger of two torques needs no number."""
    shown = DIRECTIVE.findall("".join(chapter_texts("en").values()))
    formulas = [name for key, name in shown if key == "equation"]
    assert len(formulas) == len(set(formulas))
    assert {entry.function for entry in register() if entry.function} <= {*formulas} <= equations().keys()
    assert sorted(name for key, name in shown if key == "misprint") == sorted(entry.id for entry in misprints())


def test_both_languages_have_the_same_parts():
    english, russian = (chapter_texts(language) for language in ("en", "ru"))
    assert english.keys() == russian.keys()
    for own in ((english[number], russian[number]) for number in english):
        for part in (r"^#+ ", r"^\|", r"^```", r"^- "):
            assert len({len(re.findall(part, text, re.MULTILINE)) for text in own}) == 1, (part, own[0][:40])
        assert DIRECTIVE.findall(own[0]) == DIRECTIVE.findall(own[1])
        plain = (DIRECTIVE.sub("", text).replace(",", ".") for text in own)
        first, second = (sorted(re.findall(r"\d+(?:\.\d+)?", text)) for text in plain)
        assert first == second, own[0][:40]


@pytest.mark.slow
def test_every_link_of_the_page_leads_somewhere_in_it(book, monkeypatch):
    """And the Russian one has no Latin word of four letters but of sources, terms, code, formulas and indices."""
    monkeypatch.setattr("afmcalc.render.report.page.inline_svg", lambda sheet: FRAME)
    with speaking(language("ru")):
        page = render(book("ru"))
    ids = re.findall(r'\bid="([^"]+)"', page)
    assert len(ids) == len(set(ids)) > 200
    assert set(re.findall(r'<a [^>]*\bhref="#([^"]*)"', page)) <= set(ids)
    assert not re.search(r'(?:src|href)="(?!#)|@import|url\((?!#)', page)
    assert not re.search(r"\{(?:see|value|equation|misprint|figure|list) ", page)
    page = re.sub(r"(?s)<(style|script|code|pre|math)\b.*?</\1>|<section id=\"chapter-16\".*", " ", page)
    page = re.sub(r"example:\S+", " ", re.sub(r"<[^>]*>", " ", page.replace("<sub>", "_")))
    words = {word.strip(".,") for word in re.findall(r"\b[a-zA-Z]{4,}", page)}
    terms = chapter_texts("ru")[1].partition("## Термины")[2]
    sources = " ".join(each.source for each in equations().values())
    names = {*re.findall("[A-Z][a-z]{3,}", sources), "damage", "fatigue", "amplitude", "afmcalc", "Budynas", "Nisbett"}
    names |= {"Carslaw", "Jaeger", "Conduction", "Heat", "Solids"}
    assert words <= names | {*re.findall("[a-z]{4,}", terms)}
