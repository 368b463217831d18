"""The report in English and in Russian: one calculation, told in the words of people."""

import re

import pytest
from conftest import slow

EXAMPLES = ["default", *slow("tolerance")]
LOWERED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
STANDARD = re.compile(r"ISO 3290-1|ГОСТ 3722-2014")  # Of balls: each language names its own
COUNTED = re.compile(r"(Table|Таблица|Figure|Рисунок) \d+")
CODE = re.compile(r"--[a-z][\w-]*|\[?\b[a-z]{3,}(?:_[a-z]{2,})+|\b(?:friction|fatigue|drive|machine|heat)\.[a-z]+")
"""A key of the spec, or an option of the command line."""
PARTS = ".//td", ".//caption", ".//figure", ".//div[@class='step']", ".//div[@class='formula']", ".//li"


def text_of(element):
    return "".join(element.itertext())


def plain(element):
    """Text without indices, and without numbers of tables, figures, formulas and chapters, in the order of a language."""
    tag, tail = element.tag.rpartition("}")[2], element.tail or ""
    counted = element.get("class") == "count" or (tag == "b" and COUNTED.fullmatch(element.text or ""))
    if tag in ("sub", "msub") or counted or element.get("href", "").startswith("#"):
        return f"_{tail}"
    if tag == "mspace":
        return f"\xa0{tail}"
    inside = (element.text or "") + "".join(map(plain, element))
    if tag in ("sup", "msup") and re.match(r"[−\d]", text_of(element)):
        inside = f"^{inside}"
    return {"mn": " ", "mo": " ", "text": " "}.get(tag, "") + inside + tail


def numbers(element, language):
    """Numbers of a part of a page; a share in % is one of 1, as Russian tells utilisation."""
    text = STANDARD.sub("", plain(element)).replace("−", "-")
    text = re.sub(r"(?<=\d)\xa0 ?(?=\d{3})", "", text)
    text = text.replace(",", "") if language == "en" else re.sub(r"(?<=\d),(?=\d)", ".", text)
    text = re.sub("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda power: f"^{power[0].translate(LOWERED)}", text)
    found = re.findall(r"((?:(?<![\w.)\]])-)?\d+(?:\.\d+)?)(\s?%)?", text)
    return [f"{float(number) / 100:.3g}" if share else number for number, share in found]


@pytest.mark.parametrize("language", ["ru", *slow("en")])
@pytest.mark.parametrize("name", EXAMPLES)
def test_words_stand_in_the_place_of_keys_and_numbers_in_that_of_sources(name, language, report, parsed):
    page = parsed(report(name, *(["--lang", "ru"] if language == "ru" else [])))
    main = page.find(".//main")
    texts = [text_of(page.find(".//p[@id='verdict']")), *(plain(each) for each in main if each.tag == "section")]
    assert CODE.search("give friction.min, or --set") is not None
    assert [found for text in texts for found in CODE.findall(text)] == []
    references = main.find(".//dl[@class='references']")
    listed = [text_of(entry) for entry in references.findall(".//dt")]
    text = "\n".join(text_of(part) for part in main if part.get("id") != "references")
    mentions = re.findall(r"\[(\d+)(?:\]|, (?:eq|формул|chapter|гл|fig|рис|sec|разд|ch))", text)
    assert [*dict.fromkeys(mentions)] == listed == [str(number) for number in range(1, len(listed) + 1)] != []
    assert len({text_of(entry) for entry in references.findall(".//dd")}) == len(listed)
    assert not re.findall(r"\b(?:F11|S19|S21|S22|[A-Z]\w\d\d|CJ|JM|SKS)\b|[Hh]andbook|правочник|ohnson|Marshek", text)


@pytest.mark.parametrize("name", EXAMPLES)
def test_both_languages_have_the_same_numbers(name, report, parsed):
    """In every cell, step and caption, and in what is concluded; and as many of each, and of symbols."""
    pages = {each: parsed(report(name, *(["--lang", "ru"] if each == "ru" else []))) for each in ("en", "ru")}
    english, russian = ({part.get("id"): part for part in page.findall(".//section")} for page in pages.values())
    assert {*english} | {"requirements"} == {*russian}  # a Russian one says that none are stated
    counted = 0
    for key, path in ((key, path) for key in english.keys() - {"calculation", "references"} for path in PARTS):
        for one, other in zip(english[key].findall(path), russian[key].findall(path), strict=True):
            said = numbers(one, "en"), numbers(other, "ru")
            assert said[0] == said[1], (key, path, text_of(one), text_of(other))
            counted += len(said[0])
    assert counted > 1000
    verdicts = [numbers(page.find(".//p[@id='verdict']"), language) for language, page in pages.items()]
    assert verdicts[0] == verdicts[1] != []
    listed = [len(each["symbols"].findall(".//dt")) for each in (english, russian)]
    assert listed[0] == listed[1] > 50
