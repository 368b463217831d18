"""The handbook: it shows every formula, leads nowhere that is not there, and says the same in both languages."""

import re
import tomllib
from pathlib import Path

import pytest

import afmcalc
from afmcalc.analysis.handbook import chapter_texts, commands_of
from afmcalc.analysis.registry import ANALYSES
from afmcalc.equations.catalogue import equations
from afmcalc.papers.register import misprints, register

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


def test_citations_lead_to_the_chapter_that_shows_the_formula():
    """``handbook, chapter 5`` of a docstring: the formula is in that chapter, or a formula that chapter names is."""
    texts = chapter_texts("en")
    shown = {name: number for number, text in texts.items() for _, name in DIRECTIVE.findall(text)}
    cited = 0
    for name, equation in equations().items():
        chapters = {int(number) for number in re.findall(r"chapter (\d+)", equation.source)}
        cited += bool(chapters)
        assert chapters <= texts.keys(), name
        assert not chapters or name not in shown or shown[name] in chapters or shown[name] > 8, name
    assert cited > 50
    shipped = (file for file in PACKAGE.rglob("*") if file.suffix in (".py", ".toml", ".html", ".md", ".po"))
    assert [file for file in shipped if "heory, section" in file.read_text("utf-8")] == []


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


def test_the_equations_that_stand_are_those_of_the_register():
    right = {entry.id for entry in register() if entry.status in ("as printed", "covered")}
    listed = re.findall(r"^- (\w+): (.*)$", chapter_texts("en")[7], re.MULTILINE)
    assert len(listed) == 4
    for paper, ranges in listed:
        spans = [[int(number) for number in re.findall(r"\d+", part)] for part in ranges.split(", ")]
        numbers = [number for span in spans for number in range(span[0], span[-1] + 1)]
        assert {f"{paper} ({n})" for n in numbers} == {
            each for each in right if re.fullmatch(rf"{paper} \(\d+\)", each)
        }


@pytest.mark.slow
@pytest.mark.parametrize("language", ["en", "ru"])
def test_every_link_of_the_page_leads_somewhere_in_it(language, handbook_page):
    page = handbook_page(language)
    ids = re.findall(r'\bid="([^"]+)"', page)
    assert len(ids) == len(set(ids)) > 200
    assert set(re.findall(r'<a [^>]*\bhref="#([^"]*)"', page)) <= set(ids)
    assert not re.search(r'(?:src|href)="(?!#)|@import|url\((?!#)', page)
    assert not re.search(r"\{(?:see|value|equation|misprint|figure|list) ", page)
    assert not re.search(r"chapters? <a[^>]*>chapter", page, re.IGNORECASE), "the link says so itself"


@pytest.mark.slow
def test_russian_leaves_no_english_in_it(handbook_page):
    """No Latin word of four letters but those of sources, of the table of terms, and in code, formulas and indices."""
    page = re.sub(r"(?s)<(style|script|code|math)\b.*?</\1>|<section id=\"chapter-16\".*", " ", handbook_page("ru"))
    page = re.sub(r"example:\S+", " ", re.sub(r"<[^>]*>", " ", page.replace("<sub>", "_")))
    words = {word.strip(".,") for word in re.findall(r"\b[a-zA-Z]{4,}", page)}
    terms = chapter_texts("ru")[1].partition("## Термины")[2]
    sources = " ".join(each.source for each in equations().values())
    names = {*re.findall("[A-Z][a-z]{3,}", sources), "damage", "fatigue", "afmcalc", "Budynas", "Nisbett"}
    assert words <= names | {*re.findall("[a-z]{4,}", terms)}
