"""The handbook: it shows every formula, leads nowhere that is not there, and says the same in both languages."""

import json
import os
import re
import tomllib
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from conftest import FRAME

import afmcalc
from afmcalc.analysis.handbook import chapter_texts
from afmcalc.analysis.registry import ANALYSES
from afmcalc.analysis.solve.search import closed_inverse
from afmcalc.analysis.solve.solve import PARAMETERS, TARGETS
from afmcalc.drive import cases
from afmcalc.engines import build
from afmcalc.equations.catalogue import equations
from afmcalc.errors import AfmcalcError
from afmcalc.messages import language, speaking
from afmcalc.papers.claims import reproduce
from afmcalc.papers.register import misprints, register
from afmcalc.render.handbook import render
from afmcalc.spec import read_spec
from afmcalc.spec.edit import respecified

PACKAGE = Path(afmcalc.__file__).parent
USES = PACKAGE / "papers" / "handbook" / "uses.toml"
DIRECTIVE = re.compile(r"\{(\w+) ([^{}]+)\}")
WALL, SPRING = ("control_unit.wall_angle", 0.5), ("control_spring.force", 5000.0)
EVENT = ("drive.event.duration", 0.03)
RUNS = [
    ("envelope", "synthesize accuracy adjust layout"),
    ("conveyor-clutch", "overload accuracy adjust effects synthesize layout heat simulate"),
    ("constant-torque", "life adjust accuracy synthesize springs"),
    ("machine-clutch", "life springs"),
    ("fokin2011-fig2", "accuracy adjust springs"),
    ("indirect", "accuracy synthesize adjust life springs", SPRING),
    ("drilling-head-clutch", "life"),
    ("shishkarev2022-fig3", "accuracy overload torque adjust synthesize springs"),
    ("default", "adjust life", WALL),
    ("drive", "effects heat simulate life", EVENT),
    ("all-driving", "life"),
    ("shishkarev2021", "springs"),
]
"""Examples and commands that use every equation between them that any example's command does."""


def uses():
    """Equation → the commands that calculate it."""
    found = tomllib.loads(USES.read_text(encoding="utf-8"))
    return {name: use["commands"] if isinstance(use, dict) else use for name, use in found.items()}


@pytest.mark.slow
def test_uses_are_those_of_the_program():
    """Commands are run on clutches that use all of it between them, reproduce on the papers; the calls are noted."""
    found, user = {name: set() for name in equations()}, ""

    def watched(name, function):
        def call(*args, **kwargs):
            if user:
                found[name].add(user)
            return function(*args, **kwargs)

        return call

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(cases, "run_of", cases.run_of.__wrapped__)
        for name, equation in equations().items():
            # what ``@equation`` calls, wherever its function was imported to
            inner = equation.function.__wrapped__
            (cell,) = (each for each in equation.function.__closure__ if each.cell_contents is inner)
            patch.setattr(cell, "cell_contents", watched(name, inner))
        for example, commands, *changes in RUNS:
            user = ""
            clutch = build(respecified(read_spec(f"example:{example}"), dict(changes)))
            for user in ("torque", *commands.split()):
                ANALYSES[user].function(clutch)
            user = "solve"
            for target in TARGETS:
                with suppress(AfmcalcError), np.errstate(all="ignore"):
                    now = float(TARGETS[target].value(clutch))
                    for name in PARAMETERS:
                        with suppress(AfmcalcError):
                            closed_inverse(clutch, name, target, now, np.float64(1.01 * now))
        user = "reproduce"
        reproduce([])
    if os.environ.get("AFMCALC_UPDATE"):
        lines = (f"{json.dumps(name)} = {json.dumps(sorted(use))}\n" for name, use in found.items())
        USES.write_text("".join(("# Equation → commands that calculate it.\n", *lines)), encoding="utf-8")
    assert uses() == {name: sorted(use) for name, use in found.items()}


def test_every_formula_is_reached_or_says_why_not():
    """A command calculates it, or others cover a formula without a function; else the entry says why."""
    known = uses()
    reached = {entry.id: bool(entry.function and known[entry.function]) for entry in register()}
    for entry in register():
        assert entry.not_reached is None or not reached[entry.id], f"{entry.id} is reached"
        assert reached[entry.id] or entry.not_reached or (entry.covered_by and not entry.function), entry.id


def test_each_formula_and_misprint_stands_once():
    shown = DIRECTIVE.findall("".join(chapter_texts("en").values()))
    for kind, wanted in (("equation", equations()), ("misprint", [entry.id for entry in misprints()])):
        assert sorted(name for key, name in shown if key == kind) == sorted(wanted)


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
    monkeypatch.setattr("afmcalc.render.handbook.inline_svg", lambda sheet: FRAME)
    with speaking(language("ru")):
        page = render(book("ru"))
    ids = re.findall(r'\bid="([^"]+)"', page)
    assert len(ids) == len(set(ids)) > 200
    assert set(re.findall(r'<a [^>]*\bhref="#([^"]*)"', page)) <= set(ids)
    assert not re.search(r'(?:src|href)="(?!#)|@import|url\((?!#)', page)
    assert not re.search(r"\{(?:see|value|equation|misprint|figure|list) ", page)
    page = re.sub(r"(?s)<(style|script|code|math)\b.*?</\1>|<section id=\"chapter-16\".*", " ", page)
    page = re.sub(r"example:\S+", " ", re.sub(r"<[^>]*>", " ", page.replace("<sub>", "_")))
    words = {word.strip(".,") for word in re.findall(r"\b[a-zA-Z]{4,}", page)}
    terms = chapter_texts("ru")[1].partition("## Термины")[2]
    sources = " ".join(each.source for each in equations().values())
    names = {*re.findall("[A-Z][a-z]{3,}", sources), "damage", "fatigue", "afmcalc", "Budynas", "Nisbett"}
    assert words <= names | {*re.findall("[a-z]{4,}", terms)}
