"""The report: valid, escaped, without what does not apply, its verdict and what it shows of each part; the same in Russian."""

import hashlib
import re
from html import unescape

import html5lib
import pytest
from conftest import CONFIGS, slow

from afmcalc.analysis.dossier import dossier
from afmcalc.render.report import Subject, render
from afmcalc.spec import read_spec

EVIL = "<script>alert(1)</script>"


def text_of(element):
    return "".join(element.itertext())


@pytest.mark.parametrize("name", ["default", pytest.param("indirect", marks=pytest.mark.slow)])
def test_valid_and_self_contained(name, report, drawn, parsed):
    page = report() if name == "default" else drawn(name, "--short")
    html5lib.HTMLParser(strict=True).parse(page)
    tree = parsed(page)
    assert not [tree.findall(f".//{element}") for element in ("script", "link", "img") if tree.findall(f".//{element}")]
    attributes = {name for part in tree.findall(".//math//*") for name in part.attrib}
    assert not {name for name in attributes if name in ("href", "src", "style") or name.startswith("on")}
    ids = re.findall(r'\bid="([^"]+)"', page)
    assert len(ids) == len(set(ids))
    for target in re.findall(r'href="([^"]*)"|url\(([^)]*)\)', page):
        assert "".join(target).startswith("#")
        assert "".join(target)[1:] in ids


@pytest.mark.parametrize(
    ("name", "absent"),
    [("conventional", {"overload", "pocket", "tolerance"}), pytest.param("tolerance", set(), marks=pytest.mark.slow)],
)
def test_sections_that_do_not_apply_are_left_out(name, absent, report):
    page = report(name)
    for key in ("torque", "accuracy", "adjust", "overload", "pocket", "life", "tolerance"):
        assert (f'<section id="{key}">' in page) == (f'href="#{key}"' in page) == (key not in absent), key
    assert "None" not in page


def test_the_first_lines_tell_where_it_trips(report, parsed):
    """Seven of eight pairs pass C = 0.5; at f = 0.1 and 0.8 an ordinary clutch slips at 160 and 1280 N·m; margin 1.25."""
    least, largest = 160 / (1 + 7 * 0.5 * 0.1), 1280 / (1 + 7 * 0.5 * 0.8)
    rated = least / 1.25
    torques, ratios = (f"{low:.5g} … {high:.5g}" for low, high in ((least, largest), (1.25, largest / rated)))
    trip = f"{torques} N·m: {ratios} times the rated torque at the clutch, T0 = {rated:.5g} N·m."
    first = [text_of(line).replace("\xa0", " ") for line in parsed(report()).findall(".//header/p")]
    assert first[-1] == f"It slips at Tmin … Tmax = {trip}"


def limits_of(page, parsed):
    """Utilisation of each limit that a page lists."""
    rows = table_rows(parsed(page), "checks")[1:]
    return [float(row[-1]) for row in rows if len(row) > 4]


def test_a_short_report_shows_the_limits_most_used(report, parsed):
    """It shows as many limits as there is room for besides the requirements, but at least four."""
    every = sorted(limits_of(report(), parsed), reverse=True)
    told = dossier(read_spec(None, ["requirements.nominal_torque=50"]), explained=False)
    (row,) = told.check.requirements
    for many, shown in ((1, 8), (7, 5), (11, 4)):
        others = [each for each in told.check.checks if not each.is_requirement]
        check = told.check.model_copy(update={"checks": [*many * [row], *others]})
        short = limits_of(render(Subject(told._replace(check=check), short=True)), parsed)
        assert short == every[:shown]
    assert len(every) == 8


@pytest.fixture(scope="module")
def overridden(framed, tmp_path_factory):
    """A spec with markup in its texts, and its report with overrides by which a check fails."""
    spec = tmp_path_factory.mktemp("evil") / "evil.toml"
    text = (CONFIGS / "default.toml").read_text(encoding="utf-8").replace("Base clutch", EVIL)
    block = (
        f'[report]\ndrawing = "AFM-17"\nrevision = 2\nauthor = "Ш."\ndate = 2026-02-03\n# {EVIL} </pre> {{{{ 7*7 }}}}'
    )
    spec.write_bytes("\ufeff".encode() + f"{text}\n{block}\n".replace("\n", "\r\n").encode())
    given = "--set", f"name={EVIL}&lt; a_b", "--set", "report.author=Ф.", "--set", 'report.project=7\\"}</style>'
    more = "--set", f"report.organisation={EVIL}"
    more += "--set", "C=2", "--set", "control_unit.allowable_contact_force=100"
    return spec, framed(spec, *given, *more, "--with-source")


def test_texts_of_the_user_stay_texts_and_stand_in_the_title_block(overridden, parsed):
    spec, page = overridden
    assert "<script" not in page
    assert page.count("</style>") == 1
    assert "a<sub>b" not in page
    tree = parsed(page)
    assert tree.find(".//h1").text == f"{EVIL}&lt; a_b"
    assert f"name={EVIL}&lt; a_b" in [text_of(code) for code in tree.findall(".//code")]
    assert f"# {EVIL} </pre> {{{{ 7*7 }}}}" in text_of(tree.find(".//pre"))
    entries = {text_of(each[0]): text_of(each[1]) for each in tree.findall(".//header/dl/div")}
    asked = {"Drawing no.": "AFM-17", "Revision": "2", "Date": "2026-02-03", "Organisation": EVIL}
    assert asked.items() <= entries.items()
    assert "AFM-17" not in text_of(tree.find(".//section[@id='spec']")), "nor again among the initial data"
    assert entries["SHA-256 of the spec as given"] == hashlib.sha256(spec.read_bytes()).hexdigest()
    signed = [[text_of(cell) for cell in row[:2]] for row in tree.findall(".//table[@class='signatures']/tbody/tr")]
    assert signed == [["Calculated by", "Ф."], ["Checked by", ""], ["Approved by", ""]]


def test_checks_have_utilisation_and_verdict(overridden, parsed):
    _, page = overridden
    assert (page.count("(overridden)"), page.count("<pre>")) == (2, 1)
    tree = parsed(page)
    rows = [[text_of(cell) for cell in row] for row in tree.findall(".//section[@id='checks']//tr")[1:]]
    found = {row[1]: (row[0], float(row[6])) for row in rows}
    assert found["feedback gain"] == ("warning", 1.6)
    steps = [text_of(line) for line in tree.findall(".//ul[@class='next']/li")[:2]]
    assert steps[0].startswith("Increase “number of balls” from "), "the gravest first"
    assert steps[1].startswith("Decrease “feedback gain” from 2\xa0to 1.25: ")
    assert found["contact force on one ball"][0] == "fail"
    assert found["contact force on one ball"][1] > 1


@pytest.mark.slow
def test_comments_of_a_file_that_ships_are_translated_and_a_users_own_are_not(framed, tmp_path):
    english = (CONFIGS / "default.toml").read_text(encoding="utf-8").strip()
    (tmp_path / "own.toml").write_text(english, encoding="utf-8")
    pages = (framed(each, "--lang", "ru", "--with-source") for each in (tmp_path / "own.toml", "example:default"))
    own, shipped = (unescape(re.search("<pre[^>]*>(.*?)</pre>", page, re.DOTALL)[1]).strip() for page in pages)
    assert own == english
    assert re.search("# .*[а-я]", shipped)
    keys = [re.findall(r"^(?!name)[a-z_]+ = [^#]*[^# ]", text, re.MULTILINE) for text in (shipped, english)]
    assert keys[0] == keys[1] != []


def table_rows(tree, section):
    rows = tree.findall(f".//section[@id='{section}']//tr")
    return [[text_of(each) for each in row] for row in rows]


@pytest.mark.slow
def test_tolerance_values_have_their_errors_and_inputs_the_engineers_units(report, answered, parsed):
    result = answered("tolerance", CONFIGS / "tolerance.toml", "--json").json["result"]
    listed = table_rows(parsed(report("tolerance")), "tolerance")
    rows = {row[0]: row[1:] for row in listed if row[-1] in ("N·m", "kN", "mm", "MPa")}
    value, error = map(float, rows["Tm"][1].split(" ± "))
    assert value == pytest.approx(result["mean"], abs=error / 10)
    assert error == float(f"{result['mean_standard_error']:.2g}")
    assert rows["Fcl"] == ["closing-spring force as set", "normal", "–", "2", "–", "0.1", "kN"]
    assert rows["τlimb"][2:] == ["250", "400", "–", "32", "MPa"]


def test_a_formula_stands_once_and_factors_have_names_of_their_own(report, parsed):
    tree = parsed(report())
    steps = tree.findall(".//div[@class='step']")
    numbers = [step.get("id").removeprefix("formula-") for step in steps if step.get("id")]
    assert numbers == [str(count + 1) for count in range(len(numbers))]
    assert len(numbers) > 10
    named = {text_of(step.find("./p/b")): text_of(step.find("./p")) for step in steps}
    named = {symbol: about for symbol, about in named.items() if symbol.startswith("KT")}
    assert set(named) == {"KT", "KT,w", "KT,p", "KT,0", "KT,exp", "KT,act", "KT,eq"}
    assert "ordinary clutch in its place" in named["KT,0"]
    assert len(set(named.values())) == len(named)


@pytest.mark.parametrize(("spoken", "form"), [("en", ()), ("ru", ()), ("ru", ("--short",))])
def test_a_reviewer_finds_what_he_looks_for(spoken, form, report, parsed):
    page = report("default", *(["--lang", "ru"] if spoken == "ru" else []), *form)
    tree = parsed(page)
    assert text_of(tree.find(".//h1"))
    head = text_of(tree.find(".//header"))
    assert {"en": "2026-01-01", "ru": "01.01.2026"}[spoken] in head
    assert {"en": "of its limit", "ru": "предела"}[spoken] in head
    assert len(tree.findall(".//table[@class='signatures']/tbody/tr")) == {"en": 3, "ru": 4}[spoken]
    assert {"en": "N·m", "ru": "Н·м"}[spoken] in text_of(tree.find(".//main"))
    for what, parts in (("table", tree.findall(".//caption")), ("figure", tree.findall(".//figure"))):
        numbers = [part.get("id") for part in parts]
        assert numbers == [f"{what}-{number}" for number in range(1, len(numbers) + 1)]
        assert all(page.count(f'href="#{number}"') == 1 for number in numbers)
    assert not tree.findall(".//main//code")
    assert bool(form) == (tree.find(".//nav") is None)
    if spoken == "en":  # what the papers write is quoted
        quoted = "".join(text_of(tree.find(f".//*[@id='{key}']")) for key in ("symbols", "misprints"))
        assert all(text in quoted for text in tree.itertext() if re.search("[а-яА-Я]", text))


def test_what_is_searched_for_is_no_part_of_a_report(report):
    assert "friction_group.pairs" not in report("requirements", "--short")


EXAMPLES = ["default", *slow("tolerance")]
LOWERED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
STANDARD = re.compile(r"ISO 3290-1|ГОСТ 3722-2014")  # Of balls: each language names its own
COUNTED = re.compile(r"(Table|Таблица|Figure|Рисунок) \d+")
CODE = re.compile(r"--[a-z][\w-]*|\[?\b[a-z]{3,}(?:_[a-z]{2,})+|\b(?:friction|fatigue|drive|machine|heat)\.[a-z]+")
"""A key of the spec, or an option of the command line."""
PARTS = ".//td", ".//caption", ".//figure", ".//div[@class='step']", ".//div[@class='formula']", ".//li"


def plain(element):
    """Text of an element without indices and numbers of tables, figures, formulas and chapters."""
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
    """Numbers of a part of a page; percentages are divided by 100, as Russian texts give utilisation as a share."""
    text = STANDARD.sub("", plain(element)).replace("−", "-")
    text = re.sub(r"(?<=\d)\xa0 ?(?=\d{3})", "", text)
    text = text.replace(",", "") if language == "en" else re.sub(r"(?<=\d),(?=\d)", ".", text)
    text = re.sub("[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda power: f"^{power[0].translate(LOWERED)}", text)
    found = re.findall(r"((?:(?<![\w.)\]])-)?\d+(?:\.\d+)?)(\s?%)?", text)
    return [f"{float(number) / 100:.3g}" if share else number for number, share in found]


@pytest.mark.parametrize("name", EXAMPLES)
def test_words_stand_in_the_place_of_keys_and_numbers_in_that_of_sources(name, report, parsed):
    page = parsed(report(name, "--lang", "ru"))
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
    """Every cell, step, caption and the conclusions have the same numbers; there are as many symbols."""
    pages = {each: parsed(report(name, *(["--lang", "ru"] if each == "ru" else []))) for each in ("en", "ru")}
    english, russian = ({part.get("id"): part for part in page.findall(".//section")} for page in pages.values())
    assert {*english} | {"requirements"} == {*russian}  # the Russian section may say that none are stated
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
