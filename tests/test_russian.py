"""Russian: everything has it, in whole sentences, and only people see it."""

import copy
import inspect
import io
import json
import os
import pickle
import re
import string
import subprocess
import sys
from gettext import GNUTranslations
from pathlib import Path
from types import SimpleNamespace

import pytest
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po
from conftest import CONFIGS, ROOT
from hypothesis import given
from hypothesis import strategies as st
from texts import models, texts

from afmcalc.cli.main import without_lang
from afmcalc.errors import AfmcalcError, chosen_language
from afmcalc.findings import Finding
from afmcalc.messages import FOLDER, joined, known, language, localized, say, say_many, speaking, term, translate


@pytest.fixture(scope="module")
def catalogue():
    with open(os.path.join(FOLDER, "ru.po"), "rb") as file:
        read = read_po(file)
    return {(each.context or "", each.id if isinstance(each.id, str) else each.id[0]): each for each in read if each.id}


@pytest.fixture
def russian(monkeypatch):
    monkeypatch.setenv("AFMCALC_LANG", "ru")


def test_every_text_has_russian_and_nothing_is_left_over(catalogue):
    found = texts()
    assert not {key: where for key, where in found.items() if key not in catalogue}
    # an old pydantic leaves some docstrings out of its schemas
    documented = {("", inspect.getdoc(model)) for model in (*models(), Finding)}
    assert not {key for key in catalogue if key not in found} - documented


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


STRUCK = (
    *("спецификац", "эластичн", "дробеструй", "нормальные метки", "скользящей шпон", "скользящая шпон", "ничего не стоит"),
    *("не более чем на −", "Поле уже", "Поля двух", "превышение пикового", "текущий расчёт", "Критерий сортировки"),
    *("длящейся", "прямого действия", "косвенного действия", "Витые пружины", "иск трения", "врезаются", "пересилив"),
    *("опорные площадки", "опорными площадками", "над моментом машины", "у упора по", "смотря по", "пружины как есть"),
    *("не прочитать:", "не записать:", "нельзя развернуть", "перевёрнут", "спросите изготовителя", "T_cp"),
)  # fmt: skip
"""Words that were mended once: of everyday speech, false friends, what is a parts list to a designer."""

FOREIGN = (
    *(r"``", r"\b(tan|cot|arctan)\b", r"(?<![,.\d])\d*([05-9]|1\d) раза\b", r"\{[^}]*g\} раза\b"),
    *(r"(?<![\w.])-\d", r"\d (kN|mm|MPa|kJ|kg|rpm)\b", r"\[default: ", "<=", ">=", " — ", "[“”]"),
)  # fmt: skip
"""English functions, signs and units outside quotation marks, and the wrong form after a number."""


def test_what_was_mended_does_not_come_back(catalogue):
    chapters = [path.read_text(encoding="utf-8") for path in (ROOT / "afmcalc/papers/handbook/ru").glob("*.md")]
    said = [
        form for each in catalogue.values() for form in ([each.string] if isinstance(each.string, str) else each.string)
    ]
    found = [(word, text) for word in STRUCK for text in (*said, *chapters) if word in text]
    bare = [re.sub('"[^"]*"', "", text) for text in said]
    found += [(sign, text) for sign in FOREIGN for text in bare if re.search(sign, text)]
    found += [
        (quoted, text) for text in said for quoted in re.findall('"([^"]*)"', text) if re.search("[а-яё]{4}", quoted)
    ]
    assert not found


@pytest.mark.parametrize(
    ("count", "said"), [(1, "1 день"), (3, "3 дня"), (5, "5 дней"), (11, "11 дней"), (21, "21 день")]
)
def test_plural_forms(count, said):
    with speaking(language("ru")):
        assert translate(say_many("{count} day", "{count} days", count=count)) == said


def test_a_sentence_is_said_again_with_all_that_it_names():
    with speaking(language("ru")):
        inner = say("{stress:.4g MPa} ({method})", stress=1.25e6, method=term("min-friction"))
        outer = say("not calculated: what the spec does not give the data for, {listed}", listed=joined([inner, inner]))
        assert (
            outer
            == "not calculated: what the spec does not give the data for, 1.25 MPa (min-friction), 1.25 MPa (min-friction)"
        )
        expected = "часть величин не рассчитана, так как не задано: 1,25 МПа (при f_min), 1,25 МПа (при f_min)"
        assert translate(outer) == expected
        assert translate(copy.deepcopy(outer)) == translate(pickle.loads(pickle.dumps(outer))) == expected
        assert translate("no such text") == "no such text"
    assert translate(outer) == outer


@given(st.recursive(st.text(max_size=5), lambda parts: st.lists(parts, min_size=1, max_size=3)))
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


@pytest.mark.parametrize(
    ("number", "shown"),
    [
        ("1.5", "1,5"),
        ("1,234", "1234"),
        ("12345.6", "12\xa0345,6"),
        ("0.0012345", "0,0012345"),
        ("1e+12", "10¹²"),
        ("2.5e-07", "2,5·10⁻⁷"),
        ("-3", "−3"),
    ],
)
def test_numbers(number, shown):
    with speaking(language("ru")):
        assert localized(number) == shown
    assert localized(number) == number


@pytest.mark.parametrize(
    ("arguments", "environment", "name"),
    [
        ([], {}, "en"),
        ([], {"LANG": "ru_RU.UTF-8"}, "ru"),
        ([], {"LANG": "ru_RU.UTF-8", "LC_ALL": "C.UTF-8"}, "en"),
        ([], {"LANG": "de_DE.UTF-8"}, "en"),
        ([], {"LANG": "ru_RU.UTF-8", "AFMCALC_LANG": "en"}, "en"),
        ([], {"AFMCALC_LANG": "ru"}, "ru"),
        (["torque", "--lang", "ru"], {"AFMCALC_LANG": "en"}, "ru"),
        (["--lang=en", "torque"], {"AFMCALC_LANG": "ru"}, "en"),
        (["torque", "--", "--lang", "ru"], {}, "en"),
        ([], {"LANGUAGE": "de:ru_RU:en"}, "ru"),
        ([], {"LANGUAGE": "en:ru", "LANG": "ru_RU.UTF-8"}, "en"),
        ([], {"LANGUAGE": "ru", "LANG": "de_DE.UTF-8"}, "ru"),
        ([], {"LANGUAGE": "ru", "LC_ALL": "C.UTF-8", "LANG": "ru_RU.UTF-8"}, "en"),
        ([], {"LANGUAGE": "ru", "AFMCALC_LANG": "en"}, "en"),
        ([], {"LANGUAGE": "", "LC_MESSAGES": "ru_RU"}, "ru"),
    ],
)
def test_the_language_is_the_options_else_the_variables_else_the_locales(arguments, environment, name):
    assert chosen_language(without_lang(arguments)[1], environment).name == name


def test_an_unknown_language_is_refused():
    for arguments, environment in ((["--lang", "xx"], {}), (["--lang"], {}), ([], {"AFMCALC_LANG": "Russian"})):
        with pytest.raises(AfmcalcError, match="known are en, ru"):
            chosen_language(without_lang(arguments)[1], environment)


@pytest.mark.parametrize(
    ("number", "environment", "name"),
    [
        (0x0419, {}, "ru"),
        (0x0819, {}, "ru"),
        (0x0409, {}, "en"),
        (0x0419, {"LANG": "de_DE.UTF-8"}, "en"),
        (0x0419, {"LANGUAGE": "en"}, "en"),
    ],
)
def test_windows_has_a_setting_of_its_own(monkeypatch, number, environment, name):
    library = SimpleNamespace(kernel32=SimpleNamespace(GetUserDefaultUILanguage=lambda: number))
    monkeypatch.setattr("ctypes.windll", library, raising=False)
    monkeypatch.setattr(sys, "platform", "win32")
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


_ASKED = """
import afmcalc, json
answer = afmcalc.load().adjust()
try:
    afmcalc.load(set={"friction.minn": 1})
except afmcalc.AfmcalcError as error:
    print(json.dumps([str(error), str(answer), list(answer.to_dict())]))
"""


def test_python_speaks_the_language_of_the_variable():
    def said(name):
        environment = {**os.environ, "PYTHONPATH": str(ROOT), "AFMCALC_LANG": name, "LC_ALL": "ru_RU.UTF-8"}
        return subprocess.run([sys.executable, "-c", _ASKED], capture_output=True, env=environment, check=False)

    (english, table, keys), (russian, in_russian, same) = (json.loads(said(name).stdout) for name in ("", "ru"))
    assert "unknown key" in english
    assert "неизвестный ключ" in russian
    assert "spring" in table
    assert "пружин" in in_russian
    assert keys == same
    assert b"AFMCALC_LANG xx: known are en, ru" in said("xx").stderr


def test_the_option_may_stand_anywhere():
    assert without_lang(["--lang", "ru", "torque", "a.toml", "--lang=en"]) == (["torque", "a.toml"], "en")
    assert without_lang(["report", "--", "--lang", "ru"]) == (["report", "--", "--lang", "ru"], "")


@pytest.mark.parametrize(
    "arguments",
    [
        ["torque", CONFIGS / "indirect.toml"],
        ["check", CONFIGS / "default.toml", "--set", "C=2"],
        ["compare", CONFIGS / "default.toml", "--variants"],
        ["explain", "life", CONFIGS / "default.toml"],
        ["check", CONFIGS / "default.toml", "--set", "friction.max=2 N"],
        ["reproduce", "--paper", "S21"],
    ],
)
@pytest.mark.parametrize("format_", ["json", "csv"])
def test_programs_read_the_same_in_every_language(arguments, format_, afmcalc):
    english, russian = (afmcalc(*arguments, "--format", format_, "--lang", name) for name in ("en", "ru"))
    assert (russian.code, russian.out) == (english.code, english.out)


SNAPSHOTS = Path(__file__).parent / "render" / "formats" / "snapshots"
SHOWN = {
    "torque": ["torque", CONFIGS / "indirect.toml"],
    "accuracy": ["accuracy", CONFIGS / "default.toml", "--sweep", "C=0:1:3"],
    "check": ["check", CONFIGS / "default.toml", "--set", "C=2"],
    "explain": ["explain", "synthesize", CONFIGS / "indirect.toml"],
}


@pytest.mark.parametrize(("name", "format_"), [*((name, "table") for name in SHOWN), ("explain", "markdown")])
def test_snapshot(name, format_, afmcalc, russian):
    run = afmcalc(*SHOWN[name], "--format", format_)
    path = SNAPSHOTS / f"{name}.ru.{'txt' if format_ == 'table' else 'md'}"
    if os.environ.get("AFMCALC_UPDATE"):
        path.write_text(run.out, encoding="utf-8")
    assert run.out == path.read_text(encoding="utf-8"), f"{path.name} differs; AFMCALC_UPDATE=1 writes it anew: read it"


def test_help_fits_a_narrow_terminal(afmcalc, russian, monkeypatch):
    monkeypatch.setenv("COLUMNS", "60")
    for arguments in ([], ["torque"], ["report"], ["plot"]):
        run = afmcalc(*arguments, "--help")
        assert run.code == 0
        assert "Ключи" in run.out
        assert not re.search(r"\b(Usage|Options|Show|the)\b", run.out)


def test_what_is_wrong_is_told_in_russian(afmcalc, russian):
    for arguments, said in (
        (["torque", "--hepl"], "нет ключа --hepl"),
        (["solve"], "не хватает аргумента"),
        (["torque", "example:default", "--set", "friction.max=2 N"], "безразмерно"),
        (["torque", "example:defualt"], "возможно, 'default'"),
    ):
        run = afmcalc(*arguments)
        assert run.code == 2
        assert run.err.splitlines()[-1].startswith(("ошибка: ", " ")), run.err
        assert said in run.err, run.err


def test_a_russian_spec_is_the_english_one_with_other_comments(afmcalc):
    import tomllib

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


@pytest.mark.parametrize("name", ["en", "ru"])
def test_no_library_is_loaded_for_it(name):
    program = "import sys; from afmcalc.cli.main import main\ntry: main(['torque'])\nexcept SystemExit: pass\n"
    asked = "print('babel' in sys.modules, file=sys.stderr)"
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "AFMCALC_LANG": name}
    run = subprocess.run([sys.executable, "-c", program + asked], capture_output=True, env=environment, check=True)
    assert run.stderr.split()[-1] == b"False"
