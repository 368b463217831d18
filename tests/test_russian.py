"""Russian: everything has it, in whole sentences, and only people see it."""

import io
import json
import os
import re
import string
import sys
from gettext import GNUTranslations
from pathlib import Path
from types import SimpleNamespace

import pytest
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po
from sources import READ
from texts import texts

from afmcalc.cli.main import without_lang
from afmcalc.errors import AfmcalcError, chosen_language
from afmcalc.messages import FOLDER, language, localized, say, say_many, speaking


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
        said = [
            say_many("{count} driving pair{default}", "{count} driving pairs{default}", count=count, default="")
            for count in (1, 3, 5, 11, 21)
        ]
    assert said == ["1 ведущая пара", "3 ведущие пары", "5 ведущих пар", "11 ведущих пар", "21 ведущая пара"]


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


def test_windows_has_a_setting_of_its_own(monkeypatch):
    monkeypatch.setattr(sys, "platform", "win32")
    own = ((0x0419, {}, "ru"), (0x0409, {}, "en"), (0x0419, {"LANG": "de_DE.UTF-8"}, "en"))
    for number, environment, name in own:
        library = SimpleNamespace(kernel32=SimpleNamespace(GetUserDefaultUILanguage=lambda number=number: number))
        monkeypatch.setattr("ctypes.windll", library, raising=False)
        assert chosen_language("", environment).name == name


READ_BY_PROGRAMS = (
    "check --set C=2",
    "compare --variants",
    "check --set friction.max=2N",
)


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
def test_russian_without_its_texts_is_an_error_where_asked_for_else_a_note(left, afmcalc, tmp_path, monkeypatch):
    """Their file is lost, empty, or cut off."""
    if left is not None:
        (tmp_path / "ru.mo").write_bytes(Path(FOLDER, "ru.mo").read_bytes()[:left])
    monkeypatch.setattr("afmcalc.messages.FOLDER", str(tmp_path))
    monkeypatch.delenv("AFMCALC_LANG")
    monkeypatch.setenv("LC_ALL", RU)
    try:
        for arguments, code, said in ((["--lang", "ru"], 2, "error"), ([], 0, "note")):
            language.cache_clear()
            run = afmcalc(*arguments, "list", "examples")
            assert (run.code, bool(run.out), run.err.count("\n")) == (code, code == 0, 1)
            assert run.err.startswith(f"{said}: the texts of the language ru cannot be read")
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
