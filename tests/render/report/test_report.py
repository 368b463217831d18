"""The report: valid, escaped, without what does not apply, its verdict and what it shows of each part."""

import hashlib
import itertools
import re
from pathlib import Path

import pytest
from conftest import CONFIGS, S21

from afmcalc.analysis.dossier import dossier
from afmcalc.findings import Finding
from afmcalc.render.report import Subject, render, words
from afmcalc.render.report.words import REPORT
from afmcalc.render.verdict import SENTENCES, verdict
from afmcalc.spec import read_spec

EVIL = "<script>alert(1)</script>"


def text_of(element):
    return "".join(element.itertext())


@pytest.mark.parametrize("name", ["default", pytest.param("indirect", marks=pytest.mark.slow)])
def test_valid_and_self_contained(name, report, drawn, parsed):
    page = report() if name == "default" else drawn(name)
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
    [("default", {"tolerance"}), ("conventional", {"overload", "synthesize", "tolerance"}),
     pytest.param("indirect", {"overload", "tolerance"}, marks=pytest.mark.slow),
     pytest.param("tolerance", set(), marks=pytest.mark.slow)],
)  # fmt: skip
def test_sections_that_do_not_apply_are_left_out(name, absent, report):
    page = report(name)
    for key in ("torque", "accuracy", "adjust", "overload", "synthesize", "life", "tolerance"):
        assert (f'<section id="{key}">' in page) == (f'href="#{key}"' in page) == (key not in absent), key
    assert "None" not in page


def limits_of(page, parsed):
    """Utilisation of each limit that a page lists."""
    rows = table_rows(parsed(page), "checks")[1:]
    return [float(row[-1].rstrip("*")) for row in rows if len(row) > 4]


def test_a_short_report_shows_the_limits_most_used(report, parsed):
    """As many as there is room for beside the requirements, but four at least: the most used, in their order."""
    every = sorted(limits_of(report(), parsed), reverse=True)
    told = dossier(read_spec(None, ["requirements.nominal_torque=50"]), explained=False)
    (row,) = told.check.requirements
    for many, shown in ((1, 8), (7, 5), (11, 4)):
        check = told.check.model_copy(update={"requirements": many * [row]})
        short = limits_of(render(Subject(told._replace(check=check), "", short=True)), parsed)
        assert short == every[:shown]
    assert len(every) == 8


def test_texts_of_the_user_stay_texts_and_stand_in_the_title_block(framed, tmp_path, parsed):
    """From the spec, under the options; who signs has a place in any case; the hash is that of the file."""
    spec = tmp_path / "evil.toml"
    text = (CONFIGS / "default.toml").read_text(encoding="utf-8").replace("Base clutch", EVIL)
    block = (
        f'[report]\ndrawing = "AFM-17"\nrevision = 2\nauthor = "Ш."\ndate = 2026-02-03\n# {EVIL} </pre> {{{{ 7*7 }}}}'
    )
    spec.write_bytes("\ufeff".encode() + f"{text}\n{block}\n".replace("\n", "\r\n").encode())
    given = "--set", f"name={EVIL}&lt; a_b", "--author", "Ф.", "--project", '7\\"}</style>', "--organisation", EVIL
    page = framed(spec, *given, "--with-source")
    assert "<script" not in page
    assert page.count("</style>") == 1
    assert "a<sub>b" not in page
    tree = parsed(page)
    assert tree.find(".//h1").text == f"{EVIL}&lt; a_b"
    assert f"name={EVIL}&lt; a_b" in [text_of(code) for code in tree.findall(".//code")]
    assert f"# {EVIL} </pre> {{{{ 7*7 }}}}" in text_of(tree.find(".//pre"))
    entries = {text_of(each[0]): text_of(each[1]) for each in tree.findall(".//header/dl/div")}
    assert {
        "Drawing no.": "AFM-17",
        "Revision": "2",
        "Date": "2026-02-03",
        "Organisation": EVIL,
    }.items() <= entries.items()
    assert "AFM-17" not in text_of(tree.find(".//section[@id='spec']")), "nor again among the initial data"
    assert entries["SHA-256 of the spec as given"] == hashlib.sha256(spec.read_bytes()).hexdigest()
    signed = [[text_of(cell) for cell in row[:2]] for row in tree.findall(".//table[@class='signatures']/tbody/tr")]
    assert signed == [["Calculated by", "Ф."], ["Checked by", ""], ["Approved by", ""]]


@pytest.mark.slow
def test_comments_of_a_file_that_ships_are_translated_and_a_users_own_are_not(framed, parsed, tmp_path):
    def source(*given):
        return text_of(parsed(framed(*given, "--lang", "ru", "--with-source")).find(".//pre"))

    english = (CONFIGS / "indirect.toml").read_text(encoding="utf-8")
    (tmp_path / "own.toml").write_text(english, encoding="utf-8")
    assert source(tmp_path / "own.toml").strip() == english.strip()
    first, *shipped = source("example:indirect").strip().splitlines()
    assert first == "# example:indirect, комментарии переведены"
    lines = shipped, english.splitlines()
    keys = [[line.partition("  #")[0] for line in text if not line.startswith(("#", "name"))] for text in lines]
    assert keys[0] == keys[1]


OVERDONE = (CONFIGS / "default.toml", "--set", "C=2", "--set", "control_unit.allowable_contact_force=100")


def test_given_resolved_and_overridden(framed):
    page = framed(*OVERDONE)
    assert page.count("(overridden)") == 2
    assert "<pre>" not in page
    assert "feedback gain; allowable normal force on one ball" in page


def test_checks_have_utilisation_and_verdict(framed, parsed):
    tree = parsed(framed(*OVERDONE))
    rows = [[text_of(cell) for cell in row] for row in tree.findall(".//section[@id='checks']//tr")[1:]]
    found = {row[1]: (row[0], float(row[6].rstrip("*"))) for row in rows}
    assert found["feedback gain"] == ("warning", 1.6)
    shares = [
        float(text_of(line).partition(": ")[2].partition("%")[0])
        for line in tree.findall(".//ul[@class='next']/li")[:2]
    ]
    assert shares[0] > shares[1] > 100, "the gravest first"
    assert found["contact force on one ball"][0] == "fail"
    assert found["contact force on one ball"][1] > 1
    # what holds by choice is marked, and the mark explained: the verdict does not count it
    assert [row[1] for row in rows if row[6].endswith("*")][:1] == ["least torque in service"]
    assert "* holds by what was set or chosen" in text_of(tree.find(".//section[@id='checks']"))


@pytest.mark.slow
def test_friction_of_unlike_materials_is_listed_by_group(report, parsed):
    rows = table_rows(parsed(report("unlike-materials")), "spec")
    symbols = [row[0] for row in rows if len(row) > 1 and row[1].endswith("coefficient of friction")]
    assert symbols == ["f1min", "f1mean", "f1max", "f2min", "f2mean", "f2max"]


def table_rows(tree, section):
    rows = tree.findall(f".//section[@id='{section}']//tr")
    return [[text_of(each) for each in row] for row in rows]


@pytest.mark.slow
def test_tolerance_values_have_their_errors_and_inputs_the_engineers_units(report, framed, answered, parsed):
    result = answered("tolerance", CONFIGS / "tolerance.toml", "--json").json["result"]
    listed = table_rows(parsed(report("tolerance")), "tolerance")
    rows = {row[0]: row[1:] for row in listed if row[-1] in ("N·m", "kN", "mm", "MPa")}
    value, error = map(float, rows["Tm"][1].split(" ± "))
    assert value == pytest.approx(result["mean"], abs=error / 10)
    assert error == float(f"{result['mean_standard_error']:.2g}")
    assert rows["Fcl"] == ["closing-spring force as set", "normal", "–", "2", "–", "0.1", "kN"]
    assert rows["τlimb"][2:] == ["250", "400", "–", "32", "MPa"]
    exact = 'tolerance={fields={friction={distribution="uniform"}}}'
    page = framed(CONFIGS / "default.toml", "--set", exact, "--set", "fatigue=")
    (section,) = re.findall(r'<section id="tolerance">.*?</section>', page, re.DOTALL)
    assert "±" not in section
    assert '<section id="life">' not in page


def derivations(tree):
    """Number, symbol, formula, symbols explained and rows of each derivation of a page."""
    for step in tree.findall(".//div[@class='step']"):
        number = (step.get("id") or "").removeprefix("formula-")
        where = [text_of(each) for each in step.findall("./p[@class='where']/span/b")]
        lines = [[text_of(cell) for cell in row] for row in step.findall(".//tr")]
        yield number, text_of(step.find("./p/b")), text_of(step.find("./p")), where, lines


def test_a_formula_stands_once_and_factors_have_names_of_their_own(report, parsed):
    tree = parsed(report())
    steps = list(derivations(tree))
    numbers = [number for number, *_ in steps if number]
    assert numbers == [str(count + 1) for count in range(len(numbers))]
    assert len(numbers) > 10
    spans = tree.findall(".//p[@class='where']/span")
    assert all(text_of(each) not in (text_of(each[0]), text_of(each[0]) + ";") for each in spans), "a bare symbol"
    named = {symbol: about for _, symbol, about, _, _ in steps if symbol.startswith("KT")}
    assert set(named) == {"KT", "KT,w", "KT,p", "KT,0", "KT,exp", "KT,act", "KT,eq"}
    assert "ordinary clutch in its place" in named["KT,0"]
    assert len(set(named.values())) == len(named)


@pytest.mark.slow
def test_each_case_says_what_it_is(framed, parsed):
    """Friction, branch, setting and side in words, and the numbers of explain."""
    found = {(number, symbol): lines for number, symbol, _, _, lines in derivations(parsed(framed(S21))) if lines}
    stiffness = next(lines for (_, symbol), lines in found.items() if symbol == "D")
    assert [line[:2] for line in stiffness[1:]] == [
        *([f"f{end}", "rising"] for end in ("min", "mean", "max")),
        ["fmin", "falling, the sleeve moves back"],
    ]
    stress = next(lines for (_, symbol), lines in found.items() if symbol == "τ")
    assert stress[0] == ["Friction", "Spring set at", "Side", "Numbers put in"]
    assert {tuple(line[:3]) for line in stress[1:]} == {
        (f"f{end}", setting, side)
        for end in ("min", "mean", "max")
        for setting in ("fmin", "mean f")
        for side in ("protected", "unprotected")
    }


@pytest.mark.parametrize(("spoken", "form"), [("en", ()), ("ru", ()), ("ru", ("--short",))])
def test_a_reviewer_finds_what_he_looks_for(spoken, form, report, parsed):
    """Title, date, cells to sign, what governs; each table and figure captioned and referred to, no key."""
    page = report("default", *(["--lang", "ru"] if spoken == "ru" else []), *form)
    tree = parsed(page)
    assert text_of(tree.find(".//h1"))
    head = text_of(tree.find(".//header"))
    assert {"en": "2026-01-01", "ru": "01.01.2026"}[spoken] in head
    assert {"en": "of that limit", "ru": "коэффициент использования"}[spoken] in head
    assert len(tree.findall(".//table[@class='signatures']/tbody/tr")) == {"en": 3, "ru": 4}[spoken]
    assert {"en": "N·m", "ru": "Н·м"}[spoken] in text_of(tree.find(".//main"))
    for what, parts in (("table", tree.findall(".//caption")), ("figure", tree.findall(".//figure"))):
        numbers = [part.get("id") for part in parts]
        assert numbers == [f"{what}-{number}" for number in range(1, len(numbers) + 1)]
        assert all(page.count(f'href="#{number}"') == 1 for number in numbers)
    assert not tree.findall(".//main//code")
    assert bool(form) == (tree.find(".//nav") is None)
    if spoken == "en":
        cyrillic = [text for text in tree.itertext() if re.search("[а-яА-Я]", text)]
        quoted = (part for key in ("symbols", "misprints") for part in tree.findall(f".//*[@id='{key}']"))
        quoted = "".join(map(text_of, quoted))
        assert all(text in quoted for text in cyrillic)


@pytest.mark.slow
@pytest.mark.parametrize("overrides", [
    ["name=", "friction.mean=", "control_unit.ball_circle_radius="], ["C=0"], ["beta=1"],
])  # fmt: skip
def test_edges_leave_out_what_has_no_curve(overrides, framed):
    page = framed(CONFIGS / "default.toml", *(part for text in overrides for part in ("--set", text)))
    assert page.count("<figure ") == page.count('href="#figure-') < 7


def test_a_verdict_is_a_sentence_for_each_outcome():
    """Requirements alone never fail the checks, checks alone no requirement."""
    told = dossier(read_spec(None, ["requirements.nominal_torque=50"]), explained=False)
    (row,) = told.check.requirements
    outcomes = {"none": [], "met": [True], "open": [True, None], "missed": [False, None]}
    levels = {
        "passed": ["info"],
        "warned": ["info", "warning"],
        "exceeded": ["warning"],
        "failed": ["warning", "error"],
    }
    said, (first, *others) = set(), told.check.limits
    beyond = first.model_copy(update={"utilisation": 1.18, "verdict": "warning"})
    limits = told.check.limits, [beyond, *others]
    for required, checked in itertools.product(outcomes, levels):
        rows = [row.model_copy(update={"passed": passed}) for passed in outcomes[required]]
        own = told._replace(
            check=told.check.model_copy(update={"requirements": rows, "limits": limits[checked == "exceeded"]}),
            findings=[Finding("error", "requirement-missed", ""), *(Finding(own, "x", "") for own in levels[checked])],
        )
        found = verdict(own.check, own.findings)
        assert found.sentence == SENTENCES[f"{required}/{checked}"]
        bad = "missed" in required or checked == "failed"
        doubtful = required == "open" or checked in ("warned", "exceeded")
        assert found.grade == ("fail" if bad else "warning" if doubtful else "pass")
        assert ("beyond" in found.limit) == (checked == "exceeded")
        assert checked != "exceeded" or not {"pass", "passes"} & set(re.findall(r"\w+", found.sentence))
        said.add(found.sentence)
    assert len(said) == 16
    assert "least torque in service" not in verdict(told.check, []).limit, "it holds by choice"
    strict = told.check.model_copy(update={"passed": False, "errors": 0})
    assert verdict(strict, [Finding("warning", "x", "")]).grade == "fail"
    missed = row.model_copy(update={"passed": False, "utilisation": 1.3})
    found = verdict(told.check.model_copy(update={"requirements": [missed]}), [])
    assert "beyond “nominal torque of the clutch”" in found.limit


@pytest.mark.slow
def test_a_conclusion_names_what_limits_and_one_stress(framed, parsed):
    """Disc springs at 1.18 of their least deflection: no passing; one factor, one stress, wherever it is told."""
    tree = parsed(framed(S21.with_name("two-dynamic-factors.toml")))
    assert "passes" not in text_of(tree.find(".//p[@id='verdict']"))
    conclusion = text_of(tree.find(".//section[@id='conclusion']"))
    assert "passes" not in conclusion
    assert "closing spring: deflection of disc springs" in conclusion
    assert re.search(r"11[78]\.\d% of that limit", conclusion)
    assert "5.811 MPa on the unprotected side" in conclusion
    assert "16.43" not in text_of(tree)


def test_every_text_of_a_page_stands_in_the_table():
    """And no other: what a page says of its own is found by a catalogue."""
    folder = Path(words.__file__).parent
    files = [path.read_text(encoding="utf-8") for path in folder.iterdir() if path.suffix in (".html", ".py")]
    asked = {key for text in files for key in re.findall(r'told\("([^"]+)"[,)]', text)}
    assert asked <= set(REPORT)
    template = (folder / "page.html").read_text(encoding="utf-8")
    shown = re.sub(r"<style>.*?</style>|{%.*?%}|{{.*?}}|<[^>]*>|&\w+;", " ", template, flags=re.DOTALL)
    assert not re.findall(r"[A-Za-z]{2,}", shown)
