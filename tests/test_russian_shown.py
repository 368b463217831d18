"""All that is shown in Russian holds no English: commands, plots, reports, helps, errors."""

import html
import itertools
import re

import pytest
from babel.messages.pofile import read_po
from conftest import slow
from sources import READ, REFUSED

from afmcalc.analysis.registry import ANALYSES, EXPLAINED, PLOTS
from afmcalc.cli.main import COMMANDS
from afmcalc.cli.names import DRAWINGS
from afmcalc.messages import FOLDER, language
from afmcalc.papers import FIGURES

pytestmark = pytest.mark.usefixtures("libraries")
ABOUT = ("torque", "accuracy", "adjust", "overload", "pocket", "life", "check", "compare", "layout")
BOTH = ("default", "indirect")
WALK = {part: [line.split() for line in lines] for part, lines in READ["shown"].items()} | {
    "law": [[each, f"example:{name}"] for each, name in zip(ABOUT, itertools.cycle(BOTH))],
    "other law": [[each, f"example:{name}"] for each, name in zip(ABOUT, itertools.cycle(("indirect", "default")))],
    "other steps": [["explain", each, f"example:{name}"] for each, name in zip(EXPLAINED, itertools.cycle(BOTH))],
    "plots": [["plot", name, "example:default"] for name, each in PLOTS.items() if each.takes == "clutch" and name not in ("springs", *DRAWINGS)],
    "figures": [["plot", "paper", name] for name in FIGURES],
    "help": [["--help"], *(["help", each] for each in ("options", "plots")), *([name, "--help"] for name in COMMANDS)],
    "spec": [*(["init", "-", "--kind", kind] for kind in ("clutch", "tolerance", "drive")), *(["schema", name] for name in ANALYSES)],
    "mistakes": [["check", "--set", each] for each in REFUSED["mistakes"]] + [each.split() for each in REFUSED["arguments"]],
}  # fmt: skip

PROSE = re.compile(r"[a-z]{3,}[,;:]? [a-z]{3,}|^[A-Z][a-z]+$")
UNIT = re.compile("^(mm|kN|MPa|kJ|kg|rpm)$|^[A-Za-z]*([·/²³⁻¹]+[A-Za-z]*)+$")
ENGLISH = re.compile(r"(?<!--)\b(?:the|is|are|must|has|not|with|which|than|from|unknown)\b (?!=)")
"""Words that no Russian text has."""


class Noting:
    """A catalogue that keeps what it is asked for."""

    def __init__(self, whole) -> None:
        self.whole, self.asked = whole, set()

    def gettext(self, text):
        self.asked.add(("", text))
        return self.whole.gettext(text)

    def pgettext(self, context, text):
        self.asked.add((context, text))
        return self.whole.pgettext(context, text)

    def ngettext(self, one, many, count):
        self.asked.add(("", one))
        return self.whole.ngettext(one, many, count)


@pytest.fixture(scope="module")
def known():
    """English texts of the catalogue."""
    with open(f"{FOLDER}/ru.po", "rb") as file:
        return {each.id if isinstance(each.id, str) else each.id[0] for each in read_po(file) if each.id}


@pytest.fixture
def noting(monkeypatch):
    monkeypatch.setenv("AFMCALC_LANG", "ru")
    noting = Noting(language("ru").catalogue)
    monkeypatch.setattr(language("ru"), "catalogue", noting)
    return noting


def shown_by(run) -> str:
    """The text that people read of an output: no styles, no markup, no quotations, no bibliography, no error of the parser."""
    text = re.sub(r"(?s)<(style|pre|code|math|script)\b.*?</\1>|<dl class=.references.*?</dl>", " ", run.out + run.err)
    no_text = r"(?m)<[^>]*>|^.*(?:Juvinall| // |EN 13906).*$|^ *\d* \| .*$|'[^']*'|\"[^\"]*\""
    of_parser = r"--from|(?m:^ошибка: (?:Invalid value|Missing|No such|Got|Option|Argument) .*$)"
    return re.sub(no_text, " ", re.sub(of_parser, " ", html.unescape(text)))


@pytest.mark.parametrize("part", ["law", "steps", *slow(*sorted(WALK.keys() - {"law", "steps"}))])
def test_nothing_that_is_shown_is_english(part, known, noting, afmcalc, undrawn):
    """All that is looked up is there, and what is shown has no English words and no text as the catalogue has it."""
    sentences = [text for text in known if PROSE.search(text) and "{" not in text and len(text) > 17]
    wrong = []
    for command in WALK[part]:
        noting.asked.clear()
        run = afmcalc(*command)
        assert run.code in (0, 1, 2, 3), run.err
        asked = [(PROSE, UNIT)[context == "unit"].search(text) and text for context, text in noting.asked]
        english = [text for text in {*filter(None, asked)} - known if not text.startswith(("\b", "Juvinall"))]
        shown = shown_by(run)
        english += [line for line in shown.splitlines() if ENGLISH.search(line)]
        english += [text for text in sentences if text in shown]
        wrong += [(command, text) for text in english]
    assert not wrong


def test_a_spec_is_utf_8_on_a_stream_that_has_not_all_letters(afmcalc):
    assert afmcalc("init", "-", encoding="ascii").out == afmcalc("init", "-").out
