"""Russian: everything has it, in whole sentences, only people see it, and nothing shown in it is English."""

import html
import io
import itertools
import json
import os
import re
import string
from gettext import GNUTranslations
from pathlib import Path

import pytest
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po
from conftest import slow
from sources import READ, REFUSED
from texts import texts

from afmcalc.analysis.registry import ANALYSES, EXPLAINED, PLOTS
from afmcalc.cli.main import COMMANDS, without_lang
from afmcalc.cli.options import DRAWINGS
from afmcalc.errors import AfmcalcError, chosen_language
from afmcalc.messages import FOLDER, language, localized, say, speaking
from afmcalc.papers import FIGURES


@pytest.fixture(scope="module")
def catalogue():
    with open(os.path.join(FOLDER, "ru.po"), "rb") as file:
        read = read_po(file)
    return {(each.context or "", each.id if isinstance(each.id, str) else each.id[0]): each for each in read if each.id}


@pytest.fixture(scope="module")
def listed():
    return texts()


def test_every_text_has_russian(catalogue, listed):
    assert not listed - set(catalogue)


def fields(template: str) -> set[str]:
    try:
        return {name for _, name, _, _ in string.Formatter().parse(template) if name is not None}
    except ValueError:  # no template: what is shown may hold braces
        return set()


def test_a_translation_is_whole(catalogue):
    """A translation has the fields of the English text, and every plural form."""
    for (context, text), each in catalogue.items():
        forms = [each.string] if isinstance(each.string, str) else each.string
        assert len(forms) == (1 if isinstance(each.id, str) else 3), text
        for form in forms:
            assert form, text
            if context != "comment":
                assert fields(form) == fields(text), text


def test_numbers():
    shown = {
        "1.5": "1,5", "1,234": "1234", "12345.6": "12\xa0345,6", "0.0012345": "0,0012345", "1e+12": "10¹²", "2.5e-07": "2,5·10⁻⁷", "-3": "−3",
    }  # fmt: skip
    assert [*map(localized, shown)] == [*shown]
    with speaking(language("ru")):
        assert [*map(localized, shown)] == [*shown.values()]
        assert say("{values:g}", values=[0.5, 1.5]) == "0,5; 1,5"


RU = "ru_RU.UTF-8"


@pytest.mark.parametrize(("line", "environment", "name"), READ["language"])
def test_the_language_is_the_options_else_the_variables_else_the_locales(line, environment, name):
    assert chosen_language(without_lang(line.split())[1], environment).name == name


def test_the_option_may_stand_anywhere_and_names_a_language_that_there_is():
    assert without_lang(["--lang", "ru", "torque", "a.toml", "--lang=en"]) == (["torque", "a.toml"], "en")
    for arguments, environment in ((["--lang", "xx"], {}), (["--lang"], {}), ([], {"AFMCALC_LANG": "Russian"})):
        with pytest.raises(AfmcalcError, match="known are en, ru"):
            chosen_language(without_lang(arguments)[1], environment)


def test_windows_has_names_of_its_own(monkeypatch):
    for own, environment, name in (
        ("Russian_Russia", {}, "ru"),
        ("English_United States", {}, "en"),
        (None, {}, "en"),
        ("Russian_Russia", {"LANG": "de_DE.UTF-8"}, "en"),
    ):
        monkeypatch.setattr("afmcalc.errors.getlocale", lambda own=own: (own, "cp1251"))
        assert chosen_language("", environment).name == name


READ_BY_PROGRAMS = ("check --set C=2", "compare --variants", "check --set friction.max=2N")


@pytest.mark.parametrize("line", READ_BY_PROGRAMS)
def test_programs_read_the_same_in_every_language_but_for_sentences(line, answered):
    english, russian = (answered(*line.split(), "--json", "--lang", name) for name in ("en", "ru"))
    assert russian.code == english.code
    assert _without_russian(json.loads(russian.out), json.loads(english.out)) == json.loads(english.out)


def _without_russian(part, english):
    """Data with the English text in place of every Russian one."""
    if isinstance(part, dict):
        return {name: _without_russian(value, english[name]) for name, value in part.items()}
    if isinstance(part, list):
        return [_without_russian(*pair) for pair in zip(part, english, strict=True)]
    return english if isinstance(part, str) and re.search("[а-яё]", part) else part


def test_sentences_of_json_are_in_the_language_of_the_user(afmcalc):
    run = afmcalc("check", "--set", "C=2", "--json", "--lang", "ru")
    findings = json.loads(run.out)["findings"]
    assert findings
    assert all(re.search("[а-яё]{3}", each["message"]) for each in findings)


@pytest.mark.parametrize("left", [None, 0, 1000])
def test_russian_without_its_texts_is_an_error(left, afmcalc, tmp_path, monkeypatch):
    """The file of the Russian texts is lost, empty, or cut off."""
    if left is not None:
        (tmp_path / "ru.mo").write_bytes(Path(FOLDER, "ru.mo").read_bytes()[:left])
    monkeypatch.setattr("afmcalc.messages.FOLDER", str(tmp_path))
    monkeypatch.delenv("AFMCALC_LANG")
    monkeypatch.setenv("LC_ALL", RU)
    try:
        for arguments in (["--lang", "ru"], []):
            language.cache_clear()
            run = afmcalc(*arguments, "list", "examples")
            assert (run.code, run.out, run.err.count("\n")) == (2, "", 1)
            assert run.err.startswith("error: the texts of the language ru cannot be read")
    finally:
        language.cache_clear()


def test_a_catalogue_is_compiled():
    """``AFMCALC_UPDATE=1 pytest tests/test_russian.py`` compiles it."""
    compiled, target = io.BytesIO(), Path(FOLDER, "ru.mo")
    with Path(FOLDER, "ru.po").open("rb") as file:
        write_mo(compiled, read_po(file, abort_invalid=True))
    if os.environ.get("AFMCALC_UPDATE"):
        target.write_bytes(compiled.getvalue())
    files = (io.BytesIO(each) for each in (target.read_bytes(), compiled.getvalue()))
    read, wanted = (vars(GNUTranslations(each))["_catalog"] for each in files)
    # what its head says of the version of Babel is not compared
    assert read | {"": ""} == wanted | {"": ""}, "AFMCALC_UPDATE=1 pytest tests/test_russian.py compiles it"


pytestmark = pytest.mark.usefixtures("libraries")
ABOUT = ("torque", "accuracy", "adjust", "overload", "pocket", "life", "check", "compare", "layout")
BOTH = ("default", "indirect")
WALK = {part: [line.split() for line in lines] for part, lines in READ["shown"].items()} | {
    "law": [[each, f"example:{name}"] for each, name in zip(ABOUT, itertools.cycle(BOTH))],
    "other law": [[each, f"example:{name}"] for each, name in zip(ABOUT, itertools.cycle(("indirect", "default")))],
    "other steps": [["explain", each, f"example:{name}"] for each, name in zip(EXPLAINED, itertools.cycle(BOTH))],
    "plots": [["plot", name, "example:default"] for name, each in PLOTS.items() if each.takes == "clutch" and name not in ("springs", *DRAWINGS)],
    "figures": [["plot", "paper", name] for name in [*FIGURES][::4]],
    "help": [["--help"], *(["help", each] for each in ("options", "plots")), *([name, "--help"] for name in COMMANDS)],
    "spec": [*(["init", "-", "--kind", kind] for kind in ("clutch", "tolerance", "drive")), *(["schema", name] for name in ANALYSES)],
    "mistakes": [["check", "--set", each] for each in REFUSED["mistakes"]] + [each.split() for each in REFUSED["arguments"]],
}  # fmt: skip

PROSE = re.compile(r"[a-z]{3,}[,;:]? [a-z]{3,}|^[A-Z][a-z]+$")
UNIT = re.compile("^(mm|kN|MPa|kJ|kg|rpm)$|^[A-Za-z]*([·/²³⁻¹]+[A-Za-z]*)+$")
ENGLISH = re.compile(r"(?<!--)\b(?:the|is|are|must|has|not|with|which|than|from|unknown)\b (?!=)")
"""English words, which no Russian text may have."""


class Noting:
    """A catalogue that records the texts looked up in it."""

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
    """Text of an output that people read, without styles, markup, quotations, bibliography and errors of the parser."""
    text = re.sub(r"(?s)<(style|pre|code|math|script)\b.*?</\1>|<dl class=.references.*?</dl>", " ", run.out + run.err)
    no_text = r"(?m)<[^>]*>|^.*(?:Juvinall| // |EN 13906).*$|^ *\d* \| .*$|'[^']*'|\"[^\"]*\""
    of_parser = r"--from|(?m:^ошибка: (?:Invalid value|Missing|No such|Got|Option|Argument) .*$)"
    return re.sub(no_text, " ", re.sub(of_parser, " ", html.unescape(text)))


@pytest.mark.parametrize("part", ["law", "steps", *slow(*sorted(WALK.keys() - {"law", "steps"}))])
def test_nothing_that_is_shown_is_english(part, known, noting, afmcalc, undrawn):
    """All texts looked up are in the catalogue; what is shown has no English words and no untranslated text."""
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
