"""The report in English and in Russian: one calculation, told in the words of people."""

import re

import pytest

from afmcalc.findings import FINDINGS
from afmcalc.spec.keys import keys

EXAMPLES = ["default", pytest.param("tolerance", marks=pytest.mark.slow)]
LOWERED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
STANDARD = re.compile(r"ISO 3290-1|ГОСТ 3722-2014")
"""Of balls: each language names its own."""
COUNTED = re.compile(r"(Table|Таблица|Figure|Рисунок) \d+")


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


CODES = {
    *(path for path in keys() if "." in path),
    *(part for path in keys() for part in path.split(".") if "_" in part),
    *(code.partition("/")[0] for code in FINDINGS if "-" in code),
    *(f"[{path.rpartition('.')[0]}]" for path in keys() if "." in path),
}
CODE = re.compile(rf"--[a-z][\w-]*|(?<![\w.])(?:{'|'.join(map(re.escape, sorted(CODES, reverse=True)))})(?![\w-])")
"""A key of the spec of more than one word, a table of it, a code of a finding, an option of the command line."""


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("name", EXAMPLES)
def test_what_people_read_has_words_in_the_place_of_keys(name, language, report, parsed):
    """In Russian its own quotation marks; sources have numbers in the order of their mention."""
    page = parsed(report(name, *(["--lang", "ru"] if language == "ru" else [])))
    main = page.find(".//main")
    read = [*main.iter(), *page.find(".//header/div").iter(), page.find(".//h1")]
    whole = "p", "li", "td", "th", "dt", "dd", "caption", "figcaption", "text", "h1", "h2", "h3", "h4"
    texts = [plain(part) for part in read if part.tag.rpartition("}")[2] in whole]
    assert len(texts) > 500
    assert CODE.search("give friction.min, or --set") is not None
    assert [(found, text) for text in texts for found in CODE.findall(text)] == []
    assert language == "en" or not [text for text in texts if re.search('[“”„"]', text)]
    references = main.find(".//dl[@class='references']")
    listed = [text_of(entry) for entry in references.findall(".//dt")]
    text = "\n".join("".join(part.itertext()) for part in main if part.get("id") != "references")
    mentions = re.findall(r"\[(\d+)(?:\]|, (?:eq|формул|chapter|гл|fig|рис|sec|разд|ch))", text)
    assert [*dict.fromkeys(mentions)] == listed == [str(number) for number in range(1, len(listed) + 1)] != []
    sources = {text_of(entry) for entry in references.findall(".//dd")}
    assert len(sources) == len(listed)
    assert not re.findall(r"\b(?:F11|S19|S21|S22|[A-Z]\w\d\d|CJ|JM|SKS)\b|[Hh]andbook|правочник|ohnson|Marshek", text)


PARTS = {
    "tables": ".//td", "captions": ".//caption", "figures": ".//figure", "steps": ".//div[@class='step']",
    "formulas": ".//div[@class='formula']", "sentences": ".//li",
}  # fmt: skip


@pytest.mark.parametrize("name", EXAMPLES)
def test_both_languages_have_the_same_numbers(name, report, parsed):
    """In every cell, step and caption, and in what is concluded; and as many of each, and of symbols."""
    pages = {each: parsed(report(name, *(["--lang", "ru"] if each == "ru" else []))) for each in ("en", "ru")}
    sections = [
        {part.get("id"): part for part in page.findall(".//section") if part.get("id") not in ("calculation", "references")}
        for page in pages.values()
    ]  # fmt: skip
    assert {*sections[0]} | {"requirements"} == {*sections[1]}  # a Russian one says that none are stated
    counted = 0
    for key, section in sections[0].items():
        for what, path in PARTS.items():
            english, russian = section.findall(path), sections[1][key].findall(path)
            assert len(english) == len(russian), (key, what)
            for one, other in zip(english, russian, strict=True):
                said = numbers(one, "en"), numbers(other, "ru")
                assert said[0] == said[1], (key, what, text_of(one), text_of(other))
                counted += len(said[0])
    assert counted > 1000
    verdicts = [numbers(page.find(".//header/div"), language) for language, page in pages.items()]
    assert verdicts[0] == verdicts[1] != []
    listed = [len(each["symbols"].findall(".//dt")) for each in sections]
    assert listed[0] == listed[1] > 50


def indices(page):
    """Every index of a symbol in text and formulas, but for those of the papers that are quoted as such."""
    quoted = {id(part) for key in ("symbols", "misprints") for part in page.find(f".//section[@id='{key}']").iter()}
    parts = [part for part in page.find(".//main").iter() if id(part) not in quoted]
    bases = {text_of(part) for part in parts if part.tag == "sub"}
    return bases | {text_of(part[1]) for part in parts if part.tag.endswith("}msub")}


@pytest.mark.slow
def test_latin_letters_are_the_same_in_both_languages(report, parsed):
    """In Russian sentences too, which write words of their own in indices; what the papers write stands beside."""
    pages = [parsed(report("default", "--lang", each, "--symbols", "latin")) for each in ("en", "ru")]
    english, russian = (
        sorted(text_of(each).replace("tg ", "tan ") for each in page.findall(".//section[@id='symbols']//dt"))
        for page in pages
    )
    assert english == russian
    assert "Fcl (Fп)" in russian
    assert not [index for page in pages for index in indices(page) if re.search("[а-яё]", index)]
    assert {"cl", "mean"} <= indices(pages[1])
    papers = text_of(parsed(report("default", "--symbols", "papers")).find(".//main"))
    assert "Fп" in papers
    assert "Fcl" not in papers
