"""The report: valid, escaped, the same bytes every time, without what does not apply; and in a real browser."""

import os
import re
import subprocess
import sys

import chromium
import html5lib
import pytest
from conftest import CONFIGS, ROOT

from afmcalc.analysis.dossier import dossier
from afmcalc.render.report import Subject, render
from afmcalc.render.report.markup import mathml
from afmcalc.render.report.page import digest
from afmcalc.spec import read_spec

VARIANTS = ["default", "conventional", "unlike-materials", "all-driving", "indirect", "tolerance"]
EVIL = "<script>alert(1)</script>"


@pytest.fixture(autouse=True)
def _a_day(monkeypatch):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1767225600")


def subject(name="default", *, explained=False):
    path = CONFIGS / f"{name}.toml"
    found = dossier(read_spec(path), explained=explained)
    return Subject(found, path.read_text(encoding="utf-8"), version="0", date="2026-01-01")


def parse(page):
    return html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse(page)


@pytest.mark.parametrize("name", VARIANTS)
def test_valid_and_self_contained(name, afmcalc):
    run = afmcalc("report", CONFIGS / f"{name}.toml")
    assert run.code == 0
    tree = parse(run.out)
    assert not tree.findall(".//script")
    assert not tree.findall(".//link")
    assert not tree.findall(".//img")
    ids = re.findall(r'\bid="([^"]+)"', run.out)
    assert len(ids) == len(set(ids))
    for target in re.findall(r'href="([^"]*)"|url\(([^)]*)\)', run.out):
        assert "".join(target).startswith("#")
        assert "".join(target)[1:] in ids
    assert "2026-01-01" in run.out
    assert re.search(r'title="[0-9a-f]{64}"', run.out)


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
def test_sections_that_do_not_apply_are_left_out(name, absent, afmcalc):
    page = afmcalc("report", CONFIGS / f"{name}.toml").out
    for key in ("torque", "accuracy", "adjust", "overload", "synthesize", "life", "tolerance"):
        assert (f'<section id="{key}">' in page) == (key not in absent)
        assert (f'href="#{key}"' in page) == (key not in absent)
    bare = afmcalc("report", CONFIGS / f"{name}.toml", "--set", "fatigue=").out
    assert '<section id="life">' not in bare
    assert "None" not in page


def test_same_spec_same_bytes(afmcalc, tmp_path):
    target = tmp_path / "a.html"
    assert afmcalc("report", CONFIGS / "default.toml", "-o", target).code == 0
    run = subprocess.run(
        [sys.executable, "-m", "afmcalc", "report", str(CONFIGS / "default.toml")],
        capture_output=True, check=True, cwd=ROOT, env={**os.environ, "PYTHONHASHSEED": "5", "TZ": "Asia/Tokyo"},
    )  # fmt: skip
    assert run.stdout == target.read_bytes()


def test_the_hash_is_of_the_spec(afmcalc):
    shown = re.search(r'title="([0-9a-f]{64})"', afmcalc("report").out)[1]
    assert shown == digest(subject())
    assert shown != digest(subject("indirect"))


def test_a_spec_named_script_stays_text(afmcalc, tmp_path):
    spec = tmp_path / "evil.toml"
    text = (CONFIGS / "default.toml").read_text(encoding="utf-8").replace("Base clutch", f"{EVIL}&lt;")
    spec.write_text(text + f"\n# {EVIL} </pre> {{{{ 7*7 }}}}\n", encoding="utf-8")
    page = afmcalc("report", spec, "--set", "control_unit.gain=0.6").out
    assert "<script" not in page
    assert "{{ 7*7 }}" in page
    heading = parse(page).find(".//h1")
    assert heading.text == f"{EVIL}&lt;"
    assert afmcalc("report", "--set", f"name={EVIL}").out.count("<script") == 0


def test_given_resolved_and_overridden(afmcalc):
    page = afmcalc("report", "--set", "control_unit.gain=0.6").out
    assert "gain = 0.5" in page
    assert "<code>control_unit.gain=0.6</code>" in page
    piped = afmcalc("report", "-", stdin=afmcalc("accuracy", "--sweep", "C", "--json").out).out
    assert "accuracy_factor_peak" not in piped
    assert "&#34;gain&#34;: 0.5" in piped


def test_checks_have_utilisation_and_verdict(afmcalc):
    tree = parse(afmcalc("report", "--set", "C=2", "--set", "control_unit.allowable_contact_force=100").out)
    rows = tree.findall(".//section[@id='checks']//tr")[1:]
    found = {"".join(row[1].itertext()): ("".join(row[0].itertext()), float(row[6].text)) for row in rows}
    assert found["feedback gain"] == ("warning", 1.6)
    verdict, used = found["contact force on one ball"]
    assert verdict == "fail"
    assert used > 1
    assert "failed" in "".join(tree.find(".//dl").itertext())


def table_rows(tree, section):
    rows = tree.findall(f".//section[@id='{section}']//tr")
    return [["".join(each.itertext()) for each in row] for row in rows]


def test_tolerance_values_have_their_errors_and_inputs_the_engineers_units():
    found = subject("tolerance")
    (result,) = (topic.result for topic in found.dossier.topics if topic.name == "tolerance")
    tree = parse(render(found))
    listed = table_rows(tree, "tolerance")
    rows = {row[0]: row[1:] for row in listed if len(row) < 6 or row[-1] in ("–", "kN", "mm", "MPa")}
    assert rows["Tm"] == ["mean torque", f"{result.mean:.5g}", f"{result.mean_standard_error:.2g}", "N·m"]
    assert rows["Fп"] == ["closing-spring force as set", "normal", "2", "0.1", "kN"]
    assert rows["τlimb"][2:] == ["400", "32", "MPa"]
    assert float(rows["T99.5"][1]) == pytest.approx(result.quantiles[-1].torque, rel=1e-4)
    shares = listed[-len(result.sobol) :]
    assert shares[0][:3] == ["f", "friction in service", f"{result.sobol[0].first_order:.5g}"]
    spec = {row[1]: row[2:] for row in table_rows(tree, "spec")}
    assert spec['scatter: endurance limit in shear tolerance.fields."fatigue.endurance_limit"'] == [
        "normal, spread 8 %, min 250",
        "MPa",
    ]


def test_an_exact_tolerance_has_no_errors(afmcalc):
    only = 'tolerance={fields={friction={distribution="uniform"}}}'
    page = afmcalc("report", CONFIGS / "default.toml", "--set", only).out
    (section,) = re.findall(r'<section id="tolerance">.*?</section>', page, re.DOTALL)
    assert "the answer is exact" in section
    assert "±" not in section
    still = 'tolerance={fields={"closing_spring.force"={distribution="normal", spread=0}}}'
    page = afmcalc("report", CONFIGS / "default.toml", "--set", still).out
    (section,) = re.findall(r'<section id="tolerance">.*?</section>', page, re.DOTALL)
    assert "<figure" not in section


def test_every_step_is_shown_once_with_its_numbers():
    found = subject(explained=True)
    tree = parse(render(found))
    for topic in found.dossier.topics:
        shown = tree.findall(f".//section[@id='{topic.name}']//div[@class='step']")
        assert len(shown) == len(topic.steps)
        assert all(step.findall(".//{http://www.w3.org/1998/Math/MathML}math") for step in shown)
    every = [(step.function, step.at, step.value) for topic in found.dossier.topics for step in topic.steps]
    assert len(every) == len(set(every)) > 30


@pytest.mark.parametrize(
    "bad",
    [
        "",
        "<math><script>1</script></math>",
        '<math><mi href="x">a</mi></math>',
        '<math onclick="1"/>',
        "<svg/>",
        "<math>",
    ],
)
def test_only_mathml_is_taken_as_markup(bad):
    with pytest.raises(ValueError, match="MathML"):
        mathml(bad)


def test_pdf_refusals(afmcalc, monkeypatch, tmp_path):
    assert "-o report.html" in afmcalc("report", "--pdf").err
    assert "x.html --pdf" in afmcalc("report", "--pdf", "-o", "x.pdf").err
    monkeypatch.setenv("PATH", str(tmp_path))
    run = afmcalc("report", "--pdf", "-o", tmp_path / "x.html")
    assert run.code == 2
    assert "no headless browser found" in run.err
    assert not (tmp_path / "x.html").exists()
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "x")
    assert afmcalc("report").code == 2


browser = pytest.mark.skipif(chromium.PATH is None, reason=chromium.REASON)


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    with chromium.opened() as opened:
        yield opened


@browser
@pytest.mark.parametrize("name", VARIANTS)
def test_in_a_browser(name, page, tmp_path):
    file = tmp_path / "report.html"
    file.write_text(render(subject(name, explained=True)), encoding="utf-8")
    page.requests.clear()
    page.open(file)
    for scheme in ("light", "dark"):
        page.scheme(scheme)
        for width in (375, 1280):
            page.resize(width)
            assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert page.evaluate("getComputedStyle(document.documentElement).backgroundColor") == "rgb(21, 23, 26)"
    laid_out = "(e => e.getBoundingClientRect().height)(document.querySelector('{}'))"
    assert page.evaluate(laid_out.format("mfrac")) > 1.4 * page.evaluate(laid_out.format("mfrac mi"))
    assert page.problems == []
    assert page.requests == [file.as_uri()]


@browser
@pytest.mark.parametrize("name", VARIANTS)
def test_on_paper(name, page, tmp_path):
    """A4 less its margins is 658 px wide: no table is wider, no figure higher than a page."""
    file = tmp_path / "report.html"
    file.write_text(render(subject(name)), encoding="utf-8")
    page.scheme("light")
    page.resize(658)
    page.open(file)
    page.call("Emulation.setEmulatedMedia", media="print")
    try:
        assert page.evaluate("[...document.querySelectorAll('table, pre, svg')].every(e => e.scrollWidth <= 658)")
        assert page.evaluate("Math.max(...[...document.querySelectorAll('figure')].map(e => e.offsetHeight))") < 986
    finally:
        page.call("Emulation.setEmulatedMedia", media="")
    printed = page.pdf()
    assert printed.startswith(b"%PDF")
    assert len(re.findall(rb"/Type\s*/Page\b", printed)) >= 5


@browser
def test_pdf_beside_the_report(afmcalc, tmp_path):
    assert afmcalc("report", "-o", tmp_path / "r.html", "--pdf").code == 0
    assert (tmp_path / "r.pdf").read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize(
    "overrides",
    [
        ["f_min=0.3", "f_max=0.3"],
        ["C=0"],
        ["beta=1"],
        ["fatigue.mean_stress_sensitivity=0.1"],
        ["name="],
        ["friction.mean=", "control_unit.ball_circle_radius="],
    ],
)
def test_edges_leave_out_what_has_no_curve(overrides, afmcalc):
    model = ["--model", "amplitude"] if "sensitivity" in overrides[0] else []
    run = afmcalc("report", *(part for text in overrides for part in ("--set", text)), *model)
    assert (run.code, [line for line in run.err.splitlines() if "base clutch" not in line]) == (0, [])
    parse(run.out)
