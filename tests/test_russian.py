"""Russian: everything has it, in whole sentences, and only people see it."""

import copy
import io
import os
import pickle
import re
import string
import sys
import tomllib
from gettext import GNUTranslations
from pathlib import Path
from types import SimpleNamespace

import pytest
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po
from hypothesis import given
from hypothesis import strategies as st
from strategies import CHARACTERS
from texts import in_one_line, texts, written

import afmcalc as package
from afmcalc.cli.main import without_lang
from afmcalc.errors import AfmcalcError, chosen_language
from afmcalc.messages import FOLDER, joined, known, language, localized, say, say_many, speaking, term, translate


@pytest.fixture(scope="module")
def catalogue():
    with open(os.path.join(FOLDER, "ru.po"), "rb") as file:
        read = read_po(file)
    return {(each.context or "", each.id if isinstance(each.id, str) else each.id[0]): each for each in read if each.id}


@pytest.fixture
def russian(monkeypatch):
    monkeypatch.setenv("AFMCALC_LANG", "ru")


@pytest.fixture(scope="module")
def listed():
    return texts(), written()


def test_every_text_has_russian_and_none_has_it_that_there_is_not(catalogue, listed):
    """A text of the catalogue stands in the package, its numbers and lists of names aside."""
    found, package = listed
    assert not found - set(catalogue)
    left = {text for context, text in catalogue if context not in ("unit", "symbol", "date")} - {
        text for _, text in found
    }
    pieces = {text: re.split(r"[\d.…,()]+| or ", in_one_line(text)) for text in left}
    unknown = {text for text, parts in pieces.items() if not all(part in package for part in parts)}
    assert not {text for text in unknown if not text.startswith(("Install completion", "Show completion"))}  # typer's


def fields(template: str) -> set[str]:
    try:
        return {name for _, name, _, _ in string.Formatter().parse(template) if name is not None}
    except ValueError:  # no template: what is shown may hold braces
        return set()


def test_a_translation_is_whole(catalogue):
    """The fields of the English, each plural form, and letters of its own."""
    for (context, text), each in catalogue.items():
        forms = [each.string] if isinstance(each.string, str) else each.string
        assert len(forms) == (1 if isinstance(each.id, str) else 3), text
        for form in forms:
            assert form, text
            if context != "comment":
                assert fields(form) == fields(text), text


def test_plural_forms():
    with speaking(language("ru")):
        said = [translate(say_many("{count} day", "{count} days", count=count)) for count in (1, 3, 5, 11, 21)]
    assert said == ["1 день", "3 дня", "5 дней", "11 дней", "21 день"]


def test_a_sentence_is_said_again_with_all_that_it_names():
    with speaking(language("ru")):
        inner = say("{stress:.4g MPa} ({method})", stress=1.25e6, method=term("min-friction"))
        outer = say("not calculated: what the spec does not give the data for, {listed}", listed=joined([inner, inner]))
        assert outer.endswith("give the data for, 1.25 MPa (min-friction), 1.25 MPa (min-friction)")
        expected = "часть величин не рассчитана, так как не задано: 1,25 МПа (при f_min), 1,25 МПа (при f_min)"
        assert translate(outer) == expected
        assert translate(copy.deepcopy(outer)) == translate(pickle.loads(pickle.dumps(outer))) == expected
        assert translate("no such text") == "no such text"
    assert translate(outer) == outer


@given(st.recursive(st.text(CHARACTERS, max_size=5), lambda parts: st.lists(parts, min_size=1, max_size=3)))
def test_sentences_in_sentences_end_and_plain_texts_in_them_stay(nested):
    """However alike they look: only what was said is said again, never what looks like it."""

    def said(parts):
        if isinstance(parts, str):
            return say("unknown key{hint}", hint=parts)
        return say("{where}: {message}", where="unknown key", message=joined(map(said, parts)))

    def expected(parts):
        inside = "".join if isinstance(parts, str) else ", ".join
        return f"неизвестный ключ{parts}" if isinstance(parts, str) else f"unknown key: {inside(map(expected, parts))}"

    with speaking(language("ru")):
        assert translate(said(nested)) == expected(nested)


def test_numbers():
    shown = {
        "1.5": "1,5", "1,234": "1234", "12345.6": "12\xa0345,6", "0.0012345": "0,0012345", "1e+12": "10¹²", "2.5e-07": "2,5·10⁻⁷", "-3": "−3",
    }  # fmt: skip
    assert [*map(localized, shown)] == [*shown]
    with speaking(language("ru")):
        assert [*map(localized, shown)] == [*shown.values()]
        assert translate(say("{values:g}", values=[0.5, 1.5])) == "0,5; 1,5"


RU = "ru_RU.UTF-8"
CHOSEN = [
    # command line, environment, name of the language
    ("", {}, "en"), ("", {"LANG": RU}, "ru"), ("", {"LANG": RU, "LC_ALL": "C.UTF-8"}, "en"), ("", {"LANG": "de_DE.UTF-8"}, "en"),
    ("", {"LANG": RU, "AFMCALC_LANG": "en"}, "en"), ("", {"AFMCALC_LANG": "ru"}, "ru"),
    ("torque --lang ru", {"AFMCALC_LANG": "en"}, "ru"), ("--lang=en torque", {"AFMCALC_LANG": "ru"}, "en"), ("torque -- --lang ru", {}, "en"),
    ("", {"LANGUAGE": "de:ru_RU:en"}, "ru"), ("", {"LANGUAGE": "en:ru", "LANG": RU}, "en"), ("", {"LANGUAGE": "ru", "LANG": "de_DE.UTF-8"}, "ru"),
    ("", {"LANGUAGE": "ru", "LC_ALL": "C.UTF-8", "LANG": RU}, "en"), ("", {"LANGUAGE": "ru", "AFMCALC_LANG": "en"}, "en"),
    ("", {"LANGUAGE": "", "LC_MESSAGES": "ru_RU"}, "ru"),
]  # fmt: skip


@pytest.mark.parametrize(("line", "environment", "name"), CHOSEN)
def test_the_language_is_the_options_else_the_variables_else_the_locales(line, environment, name):
    assert chosen_language(without_lang(line.split())[1], environment).name == name


def test_an_unknown_language_is_refused():
    for arguments, environment in ((["--lang", "xx"], {}), (["--lang"], {}), ([], {"AFMCALC_LANG": "Russian"})):
        with pytest.raises(AfmcalcError, match="known are en, ru"):
            chosen_language(without_lang(arguments)[1], environment)


def test_windows_has_a_setting_of_its_own(monkeypatch):
    monkeypatch.setattr(sys, "platform", "win32")
    for number, environment, name in (
        (0x0419, {}, "ru"), (0x0819, {}, "ru"), (0x0409, {}, "en"), (0x0419, {"LANG": "de_DE.UTF-8"}, "en"), (0x0419, {"LANGUAGE": "en"}, "en"),
    ):  # fmt: skip
        library = SimpleNamespace(kernel32=SimpleNamespace(GetUserDefaultUILanguage=lambda number=number: number))
        monkeypatch.setattr("ctypes.windll", library, raising=False)
        assert chosen_language("", environment).name == name


@pytest.fixture(params=["none", "empty", "cut off"])
def lost(request, monkeypatch, tmp_path):
    """The file of Russian texts is lost."""
    whole = Path(FOLDER, "ru.mo").read_bytes()
    if request.param != "none":
        (tmp_path / "ru.mo").write_bytes(whole[: 1000 if request.param == "cut off" else 0])
    monkeypatch.setattr("afmcalc.messages.FOLDER", str(tmp_path))
    for cached in (language, known):
        cached.cache_clear()
    yield
    for cached in (language, known):
        cached.cache_clear()


def test_russian_without_its_texts_is_an_error_where_asked_for_else_a_note(lost, afmcalc, monkeypatch):
    monkeypatch.delenv("AFMCALC_LANG")
    asked = afmcalc("--lang", "ru", "examples")
    assert (asked.code, asked.out, asked.err.count("\n")) == (2, "", 1)
    assert asked.err.startswith("error: the texts of the language ru cannot be read")
    monkeypatch.setenv("LC_ALL", "ru_RU.UTF-8")
    found = afmcalc("examples")
    assert (found.code, found.err.count("\n")) == (0, 1)
    assert found.err.startswith("note: the texts of the language ru cannot be read")


def test_the_option_may_stand_anywhere():
    assert without_lang(["--lang", "ru", "torque", "a.toml", "--lang=en"]) == (["torque", "a.toml"], "en")
    assert without_lang(["report", "--", "--lang", "ru"]) == (["report", "--", "--lang", "ru"], "")


@pytest.mark.parametrize(
    "line",
    ["check --set C=2", "compare --variants", "explain life", "check --set friction.max=2N", "reproduce --paper S21"],
)
def test_programs_read_the_same_in_every_language(line, answered):
    for format_ in ("json", "csv"):
        english, russian = (answered(*line.split(), "--format", format_, "--lang", name) for name in ("en", "ru"))
        assert (russian.code, russian.out) == (english.code, english.out)


def test_python_speaks_the_language_of_the_variable(russian):
    adjusted = package.load().adjust()
    assert re.search("пружин", str(adjusted))
    assert "closing_force" in adjusted.to_dict()["min_friction"]
    with pytest.raises(package.AfmcalcError, match="неизвестный ключ"):
        package.load(set={"friction.minn": 1})


def test_a_russian_spec_is_the_english_one_with_other_comments(afmcalc):
    for kind in ("clutch", "tolerance", "requirements"):
        english, russian = (afmcalc("init", "-", "--kind", kind, "--lang", name).out for name in ("en", "ru"))
        same, other = tomllib.loads(english), tomllib.loads(russian)
        assert re.search("[а-я]", other.pop("name"))
        assert same.pop("name")
        assert same == other
        assert len(english.splitlines()) == len(russian.splitlines())
        assert "коэффициент трения" in russian or kind == "requirements"
        assert english != russian


@pytest.mark.parametrize("path", [*Path(FOLDER).glob("*.po")], ids=lambda path: path.name)
def test_a_catalogue_is_compiled(path):
    """``AFMCALC_UPDATE=1 pytest tests/test_russian.py`` compiles them."""
    with path.open("rb") as file:
        catalogue = read_po(file, abort_invalid=True)
    compiled = io.BytesIO()
    write_mo(compiled, catalogue)
    target = path.with_suffix(".mo")
    if os.environ.get("AFMCALC_UPDATE"):
        target.write_bytes(compiled.getvalue())
    compiled.seek(0)
    with target.open("rb") as file:
        read, wanted = (vars(GNUTranslations(each))["_catalog"] for each in (file, compiled))
    # what its head says of the version of Babel is not compared
    assert read | {"": ""} == wanted | {"": ""}, "AFMCALC_UPDATE=1 pytest tests/test_russian.py compiles it"
