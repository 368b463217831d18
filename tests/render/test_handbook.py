"""The handbook: it shows every formula, leads nowhere that is not there, and says the same in both languages."""

import json
import os
import re
import tomllib
from contextlib import suppress
from html.parser import HTMLParser
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from conftest import WANTED

import afmcalc
from afmcalc.analysis.handbook import chapter_texts, handbook
from afmcalc.analysis.registry import ANALYSES
from afmcalc.analysis.solve.search import closed_inverse
from afmcalc.analysis.solve.solve import PARAMETERS, TARGETS
from afmcalc.drive.cases import run_of
from afmcalc.engines import build
from afmcalc.equations.catalogue import equations
from afmcalc.errors import AfmcalcError
from afmcalc.messages import ENGLISH, language, speaking
from afmcalc.papers.claims import reproduce
from afmcalc.papers.register import misprints, register
from afmcalc.render.handbook import render
from afmcalc.spec import read_spec
from afmcalc.spec.edit import respecified
from afmcalc.spec.parse import example_names

PACKAGE = Path(afmcalc.__file__).parent
USES = PACKAGE / "papers" / "handbook" / "uses.toml"
HEAD = "Equation → commands that calculate it; renewed by AFMCALC_UPDATE=1."
COMMANDS = [name for name, entry in ANALYSES.items() if entry.group in ("clutch", "drive") and name != "compare"]
DIRECTIVE = re.compile(r"\{(\w+) ([^{}]+)\}")


def directives(text):
    return DIRECTIVE.findall(text)


@pytest.fixture(scope="module", params=["en", "ru"])
def page(request):
    with speaking(language(request.param) if request.param != "en" else ENGLISH):
        return render(handbook(request.param))


@pytest.mark.exhaustive
def test_uses_are_those_of_the_program():
    """Commands are run on clutches, reproduce on the papers; the equations passed are noted."""
    uses = {name: set() for name in equations()}
    user = ""

    def watched(name, function):
        def call(*args, **kwargs):
            if user:
                uses[name].add(user)
            return function(*args, **kwargs)

        return call

    with pytest.MonkeyPatch.context() as patch:
        for name, equation in equations().items():
            # what ``@equation`` calls, wherever its function was imported to
            (cell,) = (
                each for each in equation.function.__closure__ if each.cell_contents is equation.function.__wrapped__
            )
            patch.setattr(cell, "cell_contents", watched(name, equation.function.__wrapped__))
        specs = [read_spec(f"example:{name}") for name in sorted(set(example_names()) - WANTED)]
        # what no example gives: the gain by its wall angle, and the control spring as made
        specs.append(respecified(read_spec("example:default"), {"control_unit.wall_angle": 0.5}))
        specs.append(respecified(read_spec("example:indirect"), {"control_spring.force": 5000.0}))
        for spec in specs:
            user = ""
            clutch = build(spec)
            for user in COMMANDS:
                run_of.cache_clear()
                if ANALYSES[user].applies(clutch):
                    ANALYSES[user].function(clutch)
            user = "solve"
            for name, target in product(PARAMETERS, TARGETS):
                with suppress(AfmcalcError), np.errstate(all="ignore"):
                    now = float(TARGETS[target].value(clutch))
                    closed_inverse(clutch, name, target, now, np.float64(1.01 * now))
        user = "reproduce"
        reproduce([])
    found = {name: sorted(use) for name, use in uses.items()}
    if os.environ.get("AFMCALC_UPDATE"):
        lines = [f"{json.dumps(name)} = {json.dumps(use)}\n" for name, use in found.items()]
        USES.write_text(f"# {HEAD}\n{''.join(lines)}", encoding="utf-8")
    assert tomllib.loads(USES.read_text(encoding="utf-8")) == found


def test_every_formula_is_reached_or_says_why_not():
    """A function is calculated by a command; a formula without one is covered by others. Else the entry says why."""
    uses = tomllib.loads(USES.read_text(encoding="utf-8"))
    reached = {entry.id: bool(entry.function and uses[entry.function]) for entry in register()}
    assert len(register()) == 130
    for entry in register():
        assert entry.function is None or entry.function in uses, entry.id
        assert entry.not_reached is None or not reached[entry.id], f"{entry.id} is reached"
        assert reached[entry.id] or entry.not_reached or (entry.covered_by and not entry.function), entry.id


@pytest.mark.parametrize("kind", ["equation", "misprint"])
def test_each_stands_once(kind):
    text = "".join(chapter_texts("en").values())
    wanted = sorted(equations()) if kind == "equation" else sorted(entry.id for entry in misprints())
    assert sorted(name for key, name in directives(text) if key == kind) == wanted


def test_citations_lead_to_the_chapter_that_shows_the_formula():
    """``handbook, chapter 5`` of a docstring: the formula is in that chapter, or a formula that chapter names is."""
    shown = {name: number for number, text in chapter_texts("en").items() for _, name in directives(text)}
    numbers = set(chapter_texts("en"))
    cited = 0
    for name, equation in equations().items():
        chapters = {int(number) for number in re.findall(r"chapter (\d+)", equation.source)}
        cited += bool(chapters)
        assert chapters <= numbers, name
        assert not chapters or shown[name] in chapters or shown[name] > 8, name
    assert cited > 50


def test_no_page_cites_a_theory_that_does_not_ship():
    citing = [
        str(file.relative_to(PACKAGE))
        for file in PACKAGE.rglob("*")
        if file.suffix in (".py", ".toml", ".html", ".md", ".po") and "heory, section" in file.read_text("utf-8")
    ]
    assert citing == []


@pytest.mark.parametrize("number", sorted(chapter_texts("en")))
def test_both_languages_have_the_same_parts(number):
    english, russian = (chapter_texts(language)[number] for language in ("en", "ru"))
    for part in (r"^#+ ", r"^\|", r"^```", r"^- "):
        assert len(re.findall(part, english, re.M)) == len(re.findall(part, russian, re.M)), part
    assert directives(english) == directives(russian)
    digits = [
        sorted(re.findall(r"\d+(?:[.,]\d+)?", DIRECTIVE.sub("", text).replace(",", "."))) for text in (english, russian)
    ]
    assert digits[0] == digits[1]


class _Links(HTMLParser):
    def __init__(self):
        super().__init__()
        self.ids, self.targets = [], []

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.ids += [given["id"]] if "id" in given else []
        self.targets += [given["href"][1:]] if tag == "a" and given.get("href", "").startswith("#") else []


def test_every_link_leads_somewhere(page):
    links = _Links()
    links.feed(page)
    assert len(links.ids) == len(set(links.ids))
    assert set(links.targets) <= set(links.ids)
    assert not re.search(r"\{(?:see|value|equation|misprint|figure|list) ", page)
    assert not re.search(r"chapters? <a[^>]*>chapter", page, re.IGNORECASE), "the link says so itself"


def test_the_page_needs_nothing_else(page):
    assert not re.search(r'(?:src|href)="(?!#)|@import|url\((?!#)', page)


def test_the_equations_that_stand_are_those_of_the_register():
    right = {(entry.id.split()[0], entry.id) for entry in register() if entry.status in ("as printed", "covered")}
    listed = re.findall(r"^- (\w+): (.*)$", chapter_texts("en")[7], re.M)
    assert len(listed) == 4
    for paper, ranges in listed:
        spans = [[int(number) for number in re.findall(r"\d+", part)] for part in ranges.split(", ")]
        numbers = [number for span in spans for number in range(span[0], span[-1] + 1)]
        printed = {entry for key, entry in right if key == paper and re.fullmatch(r"\w+ \(\d+\)", entry)}
        assert {f"{paper} ({number})" for number in numbers} == printed


def test_the_worked_clutches_by_hand(page):
    """Both clutches from what their text gives: 8 pairs, 100 mm, 2 kN; C 0.5, one bypass; C 1, κ 0.96, 400 and 200 N/mm."""
    numbers = re.sub(r"(?<=\d),(?=\d)", ".", re.sub("<[^>]*>", " ", page))
    force, radius, stop = 2000, 0.1, 2000 * (1 + 8 * 0.96 * 0.3)
    for f in (0.1, 0.3, 0.8):
        normal = force / (1 + 0.5 * 7 * f)
        stiffness = 400e3 * (1 + 8 * 0.96 * f) + 200e3
        seated = stop / (1 + 8 * 0.96 * f)
        sleeve = seated if f <= 0.3 else (force * 200e3 + stop * 400e3) / stiffness
        for value in (8 * f * radius * normal, 8 * f * radius * sleeve):
            assert f" {value:.5g} " in numbers
        for value in (normal, force - normal, sleeve):
            assert f" {value / 1000:.5g} " in numbers or f" {value:.5g} " in numbers


def test_russian_leaves_no_english_in_it():
    """No Latin word of four letters but those of sources, of the table of terms, and in code, formulas and indices."""
    with speaking(language("ru")):
        page = render(handbook("ru"))
    page = re.sub(r"(?s)<(style|script|code|math)\b.*?</\1>|<section id=\"chapter-16\".*", " ", page)
    page = re.sub(r"example:\S+", " ", re.sub(r"<[^>]*>", " ", page.replace("<sub>", "_")))
    words = {word.strip(".,") for word in re.findall(r"\b[a-zA-Z]{4,}", page)}
    terms = chapter_texts("ru")[1].partition("## Термины")[2]
    sources = " ".join(each.source for each in equations().values())
    names = {*re.findall("[A-Z][a-z]{3,}", sources), "damage", "fatigue", "afmcalc", "Budynas", "Nisbett"}
    assert words <= names | {*re.findall("[a-z]{4,}", terms)}
