"""The report: valid, escaped, the same bytes every time, without what does not apply."""

import hashlib
import html
import itertools
import os
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from conftest import CONFIGS, ROOT, S21, WANTED
from texts import models

from afmcalc.analysis.dossier import dossier
from afmcalc.equations.catalogue import equations
from afmcalc.findings import FINDINGS, Finding
from afmcalc.messages import translate
from afmcalc.render.report import words
from afmcalc.render.report.page import in_words
from afmcalc.render.report.words import REPORT
from afmcalc.render.symbols import latin_symbols, native
from afmcalc.render.verdict import SENTENCES, verdict
from afmcalc.result import shown_as
from afmcalc.spec import read_spec
from afmcalc.spec.keys import keys

EVIL = "<script>alert(1)</script>"
MATH = "{http://www.w3.org/1998/Math/MathML}math"
PANDOC = shutil.which("pandoc")
EXAMPLES = sorted(path.stem for path in CONFIGS.glob("*.toml") if path.stem not in WANTED)
VARIANTS = ["indirect", "tolerance", "default", "conventional", "unlike-materials", "all-driving"]


def text_of(element):
    return "".join(element.itertext())


DRAWN = ("indirect", "tolerance")
"""Specs whose pages have a drawing of every kind between them."""


@pytest.mark.every(6)
@pytest.mark.parametrize("name", VARIANTS)
def test_valid_and_self_contained(name, report, drawn, parsed):
    page = drawn(name) if name in DRAWN else report(name)
    tree = parsed(page)
    for element in ("script", "link", "img"):
        assert not tree.findall(f".//{element}")
    attributes = {name for part in tree.findall(".//math//*") for name in part.attrib}
    assert not {name for name in attributes if name in ("href", "src", "style") or name.startswith("on")}
    ids = re.findall(r'\bid="([^"]+)"', page)
    assert len(ids) == len(set(ids))
    for target in re.findall(r'href="([^"]*)"|url\(([^)]*)\)', page):
        assert "".join(target).startswith("#")
        assert "".join(target)[1:] in ids
    assert "2026-01-01" in page


@pytest.mark.parametrize(
    ("name", "absent"),
    [
        ("default", ["tolerance"]),
        ("conventional", ["overload", "synthesize", "tolerance"]),
        ("unlike-materials", ["overload", "tolerance"]),
        ("all-driving", ["tolerance"]),
        ("indirect", ["overload", "tolerance"]),
        ("tolerance", []),
    ],
)
def test_sections_that_do_not_apply_are_left_out(name, absent, report):
    page = report(name)
    for key in ("torque", "accuracy", "adjust", "overload", "synthesize", "life", "tolerance"):
        assert (f'<section id="{key}">' in page) == (key not in absent)
        assert (f'href="#{key}"' in page) == (key not in absent)
    assert "None" not in page


@pytest.mark.exhaustive
def test_same_spec_same_bytes(drawn):
    run = subprocess.run(
        [sys.executable, "-m", "afmcalc", "report", str(CONFIGS / "indirect.toml")],
        capture_output=True, check=True, cwd=ROOT, env={**os.environ, "PYTHONHASHSEED": "5", "TZ": "Asia/Tokyo"},
    )  # fmt: skip
    assert run.stdout.decode() == drawn("indirect")


def test_a_spec_named_script_stays_text(framed, tmp_path, parsed):
    spec = tmp_path / "evil.toml"
    text = (CONFIGS / "default.toml").read_text(encoding="utf-8").replace("Base clutch", EVIL)
    spec.write_text(text + f"\n# {EVIL} </pre> {{{{ 7*7 }}}}\n", encoding="utf-8")
    page = framed(spec, "--set", f"name={EVIL}&lt;", "--author", EVIL, "--drawing", '7\\"}</style>', "--with-source")
    assert "<script" not in page
    assert page.count("</style>") == 1
    assert "{{ 7*7 }}" in page
    tree = parsed(page)
    assert tree.find(".//h1").text == f"{EVIL}&lt;"
    assert f"name={EVIL}&lt;" in [text_of(code) for code in tree.findall(".//code")]
    assert f"# {EVIL} </pre>" in text_of(tree.find(".//pre"))


def test_comments_of_a_file_that_ships_are_translated_and_a_users_own_are_not(undrawn, afmcalc, parsed, tmp_path):
    def source(*given):
        return text_of(parsed(afmcalc("--lang", "ru", "report", *given, "--with-source").out).find(".//pre"))

    english = (CONFIGS / "indirect.toml").read_text(encoding="utf-8")
    own = tmp_path / "own.toml"
    own.write_text(english, encoding="utf-8")
    assert source(own).strip() == english.strip()
    first, *shipped = source("example:indirect").strip().splitlines()
    assert first == "# example:indirect, комментарии переведены"
    keys = [[line.partition("  #")[0] for line in text if not line.startswith(("#", "name"))] for text in
            (shipped, english.splitlines())]  # fmt: skip
    assert keys[0] == keys[1]
    assert "springs" not in "".join(shipped).split("[friction]")[0]
    assert source().startswith("# встроенная муфта, комментарии переведены")


OVERDONE = (CONFIGS / "default.toml", "--set", "C=2", "--set", "control_unit.allowable_contact_force=100")


def test_given_resolved_and_overridden(framed, afmcalc):
    page = framed(*OVERDONE, "--with-source")
    assert "gain = 0.5" in page
    assert "<code>C=2</code>" in page
    assert page.count("(overridden)") == 2
    plain = framed(*OVERDONE)
    assert "<pre>" not in plain
    assert "feedback gain; allowable normal force on one ball" in plain
    piped = framed("-", "--with-source", stdin=afmcalc("accuracy", "--sweep", "C", "--json").out)
    assert "accuracy_factor_peak" not in piped
    assert "&#34;gain&#34;: 0.5" in piped


def test_checks_have_utilisation_and_verdict(framed, report, parsed):
    tree = parsed(framed(*OVERDONE))
    rows = tree.findall(".//section[@id='checks']//tr")[1:]
    found = {text_of(row[1]): (text_of(row[0]), float(row[6].text.rstrip("*"))) for row in rows}
    assert found["feedback gain"] == ("warning", 1.6)
    # what holds by choice is marked, and the mark explained: the verdict does not count it
    assert [text_of(row[1]) for row in rows if row[6].text.endswith("*")][:1] == ["least torque in service"]
    assert "* holds by what was set or chosen" in text_of(tree.find(".//section[@id='checks']"))
    verdict, used = found["contact force on one ball"]
    assert verdict == "fail"
    assert used > 1
    assert "fails the checks" in text_of(tree.find(".//p[@id='verdict']"))
    assert "passes every check" in text_of(parsed(report("default")).find(".//p[@id='verdict']"))


def test_each_group_of_unlike_materials_has_its_own_symbols(report, parsed):
    rows = table_rows(parsed(report("unlike-materials")), "spec")
    symbols = [row[0] for row in rows if len(row) > 1 and row[1].endswith("coefficient of friction")]
    assert symbols == ["f1min", "f1mean", "f1max", "f2min", "f2mean", "f2max"]
    # of a material: 0.25…0.45 of moulded-dry, the mean between them
    rows = table_rows(parsed(report("wood-chipper-clutch")), "spec")
    assert [row[2] for row in rows if row[0] in ("fmin", "fmean", "fmax")] == ["0.25", "0.35", "0.45"]


def table_rows(tree, section):
    rows = tree.findall(f".//section[@id='{section}']//tr")
    return [[text_of(each) for each in row] for row in rows]


def test_tolerance_values_have_their_errors_and_inputs_the_engineers_units(report, afmcalc, parsed):
    result = afmcalc("tolerance", CONFIGS / "tolerance.toml", "--json").json["result"]
    tree = parsed(report("tolerance"))
    listed = table_rows(tree, "tolerance")
    rows = {row[0]: row[1:] for row in listed if row[-1] in ("N·m", "kN", "mm", "MPa")}
    name, mean, _ = rows["Tm"]
    value, error = map(float, mean.split(" ± "))
    assert (name, value) == ("mean torque", pytest.approx(result["mean"], abs=error / 10))
    assert error == float(f"{result['mean_standard_error']:.2g}")
    assert rows["Fcl"] == ["closing-spring force as set", "normal", "–", "2", "–", "0.1", "kN"]
    assert rows["τlimb"][2:] == ["250", "400", "–", "32", "MPa"]
    quantiles = {row[0]: float(row[1].partition(" ")[0]) for row in listed if len(row) == 2 and row[0] != "probability"}
    assert quantiles["0.995"] == pytest.approx(result["quantiles"][-1]["torque"], rel=1e-4)
    largest = max(result["sobol"], key=lambda row: row["total"])
    shares = listed[next(n for n, row in enumerate(listed) if row[2:] == ["S1", "ST"]) + 1]
    assert shares[:2] == ["f", "friction in service"]
    assert float(shares[3].partition(" ")[0]) == pytest.approx(largest["total"], rel=1e-3)
    spec = {row[1]: row[2:] for row in table_rows(tree, "spec") if len(row) > 1}
    assert spec["scatter: endurance limit in shear"] == ["normal, spread 8 %, min 250", "MPa"]


def test_an_exact_tolerance_has_no_errors(framed):
    exact = 'tolerance={fields={friction={distribution="uniform"}}}'
    page = framed(CONFIGS / "default.toml", "--set", exact, "--set", "fatigue=")
    assert '<section id="life">' not in page
    (section,) = re.findall(r'<section id="tolerance">.*?</section>', page, re.DOTALL)
    assert "the answer is exact" in section
    assert "±" not in section


def derivations(tree):
    """Number, symbol, formula, symbols explained and rows of each derivation of a page."""
    for step in tree.findall(".//div[@class='step']"):
        number = (step.get("id") or "").removeprefix("formula-")
        where = [text_of(each) for each in step.findall("./p[@class='where']/span/b")]
        lines = [[text_of(cell) for cell in row] for row in step.findall(".//tr")]
        yield number, text_of(step.find("./p/b")), text_of(step.find("./p")), where, lines


@pytest.mark.every(6)
@pytest.mark.parametrize("name", VARIANTS)
def test_a_formula_stands_once_and_every_link_finds_one(name, report, parsed):
    tree = parsed(report(name))
    numbers = [number for number, *_ in derivations(tree) if number]
    assert numbers == [str(count + 1) for count in range(len(numbers))]
    assert len(numbers) > 10
    spans = tree.findall(".//p[@class='where']/span")
    assert all(text_of(each) not in (text_of(each[0]), text_of(each[0]) + ";") for each in spans), "a bare symbol"


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


def test_factors_of_accuracy_have_names_of_their_own(report, parsed):
    named = {
        symbol: about for _, symbol, about, _, _ in derivations(parsed(report("default"))) if symbol.startswith("KT")
    }
    assert set(named) == {"KT", "KT,w", "KT,p", "KT,0", "KT,exp", "KT,act", "KT,eq"}
    assert "ordinary clutch in its place" in named["KT,0"]
    assert len(set(named.values())) == len(named)


@pytest.mark.every(5)
@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("form", [(), ("--short",)])
@pytest.mark.parametrize("name", ["default", "drive", "indirect"])
def test_a_reviewer_finds_what_he_looks_for(name, form, language, framed, parsed):
    """Title, date, cells to sign, what governs; each table and figure captioned and referred to, no key."""
    page = framed(CONFIGS / f"{name}.toml", "--lang", language, *form)
    tree = parsed(page)
    assert text_of(tree.find(".//h1"))
    assert {"en": "2026-01-01", "ru": "01.01.2026"}[language] in text_of(tree.find(".//header"))
    assert len(tree.findall(".//table[@class='signatures']/tbody/tr")) == {"en": 3, "ru": 4}[language]
    assert {"en": "of that limit", "ru": "коэффициент использования"}[language] in text_of(tree.find(".//header"))
    assert {"en": "N·m", "ru": "Н·м"}[language] in text_of(tree.find(".//main"))
    for what, parts in (("table", tree.findall(".//caption")), ("figure", tree.findall(".//figure"))):
        numbers = [part.get("id") for part in parts]
        assert numbers == [f"{what}-{number}" for number in range(1, len(numbers) + 1)]
        assert all(page.count(f'href="#{number}"') == 1 for number in numbers)
    assert not tree.findall(".//main//code")
    assert bool(form) == (tree.find(".//nav") is None)
    if language == "en":
        cyrillic = [text for text in tree.itertext() if re.search("[а-яА-Я]", text)]
        quoted = "".join(
            text_of(part) for key in ("symbols", "misprints") for part in tree.findall(f".//*[@id='{key}']")
        )
        assert all(text in quoted for text in cyrillic)


@pytest.mark.every(7)
@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("form", [(), ("--short",)])
@pytest.mark.parametrize("name", EXAMPLES)
def test_sources_have_numbers_in_the_order_of_their_mention(name, form, language, drawn, parsed):
    """Each number stands in the list, each entry is cited, and no text names a source by its key."""
    main = parsed(drawn(name, "--lang", language, *form)).find(".//main")
    listed = [text_of(entry) for entry in main.findall(".//dl[@class='references']//dt")]
    sources = [text_of(entry) for entry in main.findall(".//dl[@class='references']//dd")]
    for part in main.iter():
        if part.get("class") == "references":
            part.clear()
    text = "\n".join(main.itertext())
    mentions = re.findall(r"\[(\d+)(?:\]|, (?:eq|формул|chapter|гл|fig|рис|sec|разд|ch))", text)
    assert [*dict.fromkeys(mentions)] == listed == [str(number) for number in range(1, len(listed) + 1)]
    assert (main.find(".//*[@id='references']") is None) == (not listed)
    assert len(set(sources)) == len(sources)
    assert bool(form) or len(sources) > 3
    assert not re.findall(r"\b(?:F11|S19|S21|S22|[A-Z]\w\d\d|CJ|JM|SKS)\b|[Hh]andbook|правочник|ohnson|Marshek", text)


KEYS = sorted((re.escape(key) for key in keys() if re.search("[._]", key)), key=len, reverse=True)
TYPED = re.compile(
    rf"(?<![\w.])(?:{'|'.join(KEYS)})(?!\.?\w)|--[a-z][\w-]*|\[(?!p\])[a-z_.]+\]|``|\b[a-z]{{3,}}_[a-z_]{{3,}}\b"
)
"""What one writes in a spec or on a command line: keys, tables, options, names of fields; [p] is an allowable pressure."""


@pytest.mark.parametrize("language", ["en", "ru"])
def test_no_finding_of_a_clutch_is_for_who_writes_the_spec(language, monkeypatch):
    """Whatever is found, a report names what the keys mean."""
    monkeypatch.setenv("AFMCALC_LANG", language)
    shown = {code: in_words(translate(text)) for code, text in FINDINGS.items() if code not in OF_A_SEARCH}
    paths = {code: re.sub(r"\{path\}[\w.]*", "", text) for code, text in shown.items()}
    assert not {code: found for code, text in paths.items() if (found := TYPED.findall(text))}


OF_A_SEARCH = ("shaft-not-at-peaks", "front-not-simulated")


def test_latin_symbols_stay_apart():
    """No two symbols of equations, results or keys become one."""
    terms = [each for equation in equations().values() for each in (*equation.arguments.values(), equation.result)]
    symbols = {each.symbol for each in terms} | {key.symbol for key in keys().values() if key.symbol}
    symbols |= {shown_as(info).symbol or "" for model in models() for info in model.model_fields.values()}
    with latin_symbols():
        assert len({native(symbol) for symbol in symbols}) == len(symbols)
        assert not [symbol for symbol in symbols if re.search("[а-яА-Я]", native(symbol))]


def test_the_letters_of_the_papers(framed):
    assert "F<sub>cl</sub>" in framed(CONFIGS / "default.toml")
    papers = framed(CONFIGS / "default.toml", "--symbols", "papers")
    assert "F<sub>п</sub>" in papers
    assert "F<sub>cl</sub>" not in papers


def test_title_block(framed, parsed, tmp_path):
    """From the spec, under the options; who signs has a place in any case; the hash is that of the file."""
    spec = tmp_path / "titled.toml"
    text = (CONFIGS / "default.toml").read_text(encoding="utf-8")
    block = '[report]\ndrawing = "AFM-17"\nrevision = 2\nauthor = "Ш."\ndate = 2026-02-03\n'
    raw = "\ufeff" + f"{text}\n{block}".replace("\n", "\r\n")
    spec.write_bytes(raw.encode())
    page = parsed(framed(spec, "--author", "Ф.", "--project", "Mill"))
    entries = {text_of(each[0]): text_of(each[1]) for each in page.findall(".//header/dl/div")}
    shown = {"Drawing no.": "AFM-17", "Revision": "2", "Date": "2026-02-03", "Project": "Mill"}
    assert shown.items() <= entries.items()
    signed = [[text_of(cell) for cell in row] for row in page.findall(".//table[@class='signatures']//tr")]
    assert signed == [
        ["Responsible", "Name", "Signature", "Date"],
        ["Calculated by", "Ф.", "", ""],
        ["Checked by", "", "", ""],
        ["Approved by", "", "", ""],
    ]
    assert "Organisation" not in entries
    assert entries["SHA-256 of the spec as given"] == hashlib.sha256(spec.read_bytes()).hexdigest()


@pytest.mark.parametrize(
    "overrides",
    [
        ["f_min=0.3", "f_max=0.3"],
        ["C=0"],
        ["beta=1"],
        ["name=", "friction.mean=", "control_unit.ball_circle_radius="],
    ],
)
def test_edges_leave_out_what_has_no_curve(overrides, framed):
    page = framed(CONFIGS / "default.toml", *(part for text in overrides for part in ("--set", text)))
    assert page.count("<figure ") == page.count('href="#figure-') < 7


def test_a_life_is_by_the_rule_that_was_asked_for(framed, report):
    sensitivity = ["--set", "fatigue.mean_stress_sensitivity=0.1"]
    page = framed(CONFIGS / "default.toml", *sensitivity, "--model", "amplitude")
    rule = "the paper's rule takes the mean stress"
    for own, model, said in ((page, "amplitude", False), (report("default"), "mean-stress", True)):
        assert f"by the rule {model}" in own
        assert (rule in html.unescape(own)) == said


@pytest.mark.skipif(PANDOC is None, reason="no pandoc on the path: no page is made a document of Word")
@pytest.mark.exhaustive
def test_equations_of_a_word_document_can_be_edited(report, tmp_path):
    page = report("indirect")
    source, target = tmp_path / "report.html", tmp_path / "report.docx"
    source.write_text(page, encoding="utf-8")
    run = subprocess.run([PANDOC, source, "-o", target], capture_output=True, check=True)
    assert b"math" not in run.stderr.lower()
    text = zipfile.ZipFile(target).read("word/document.xml").decode()
    assert text.count("<m:oMath>") == page.count("<math") > 40
    assert text.count("<m:f>") == page.count("<mfrac>") > 20


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
        bad, doubtful = (
            "missed" in required or checked == "failed",
            required == "open" or checked in ("warned", "exceeded"),
        )
        assert found.grade == ("fail" if bad else "warning" if doubtful else "pass")
        assert ("beyond" in found.limit) == (checked == "exceeded")
        assert checked != "exceeded" or not {"pass", "passes"} & set(re.findall(r"\w+", found.sentence))
        said.add(found.sentence)
    assert len(said) == 16
    strict = told.check.model_copy(update={"passed": False, "errors": 0})
    assert verdict(strict, [Finding("warning", "x", "")]).grade == "fail"
    missed = row.model_copy(update={"passed": False, "utilisation": 1.3})
    assert (
        "beyond “nominal torque of the clutch”"
        in verdict(told.check.model_copy(update={"requirements": [missed]}), []).limit
    )


def test_a_check_begins_with_the_verdict_of_the_report(afmcalc, report, parsed):
    sentence = text_of(parsed(report("default")).find(".//p[@id='verdict']"))
    for form, line in (("table", 1), ("markdown", 2)):
        run = afmcalc("check", CONFIGS / "default.toml", "--format", form)
        assert run.out.splitlines()[line].startswith(f"{sentence} What limits the clutch first is “")


@pytest.mark.every(2)
@pytest.mark.parametrize(
    ("change", "stress", "other"), [([], "5.811", "16.43"), (["--set", "drive.dynamic_factor="], "16.43", "no other")]
)
def test_a_conclusion_names_what_limits_and_one_stress(change, stress, other, framed, parsed):
    """Disc springs at 1.18 of their least deflection: no passing; one factor, one stress, wherever it is told."""
    tree = parsed(framed(S21.with_name("two-dynamic-factors.toml"), *change))
    assert "passes" not in text_of(tree.find(".//p[@id='verdict']"))
    conclusion = text_of(tree.find(".//section[@id='conclusion']"))
    assert "passes" not in conclusion
    assert "closing spring: deflection of disc springs" in conclusion
    assert re.search(r"11[78]\.\d% of that limit", conclusion)
    assert f"{stress} MPa on the unprotected side" in conclusion
    assert other not in text_of(tree)


def test_every_text_of_a_page_stands_in_the_table():
    """And no other: what a page says of its own is found by a catalogue."""
    folder = Path(words.__file__).parent
    files = [path.read_text(encoding="utf-8") for path in folder.iterdir() if path.suffix in (".html", ".py")]
    asked = {key for text in files for key in re.findall(r'told\("([^"]+)"[,)]', text)}
    assert asked <= set(REPORT)
    template = (folder / "page.html").read_text(encoding="utf-8")
    shown = re.sub(r"<style>.*?</style>|{%.*?%}|{{.*?}}|<[^>]*>|&\w+;", " ", template, flags=re.DOTALL)
    assert not re.findall(r"[A-Za-z]{2,}", shown)
