"""The report: valid, escaped, the same bytes every time, without what does not apply."""

import hashlib
import json
import os
import re
import subprocess
import sys

import html5lib
import pytest
from conftest import CONFIGS, ROOT

from afmcalc.render.report.markup import mathml

EVIL = "<script>alert(1)</script>"
MATH = "{http://www.w3.org/1998/Math/MathML}math"
VARIANTS = ["default", "conventional", "unlike-materials", "all-driving", "indirect", "tolerance"]


def parse(page):
    return html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse(page)


def text_of(element):
    return "".join(element.itertext())


@pytest.mark.parametrize("name", VARIANTS)
def test_valid_and_self_contained(name, report):
    page = report(name)
    tree = parse(page)
    for element in ("script", "link", "img"):
        assert not tree.findall(f".//{element}")
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


@pytest.mark.parametrize("name", sorted({*VARIANTS} - {"tolerance"}))
def test_no_life_without_fatigue(name, report):
    assert '<section id="life">' not in report(name, "fatigue=")


def test_same_spec_same_bytes(report):
    run = subprocess.run(
        [sys.executable, "-m", "afmcalc", "report", str(CONFIGS / "default.toml")],
        capture_output=True, check=True, cwd=ROOT, env={**os.environ, "PYTHONHASHSEED": "5", "TZ": "Asia/Tokyo"},
    )  # fmt: skip
    assert run.stdout.decode() == report("default")


@pytest.mark.parametrize("name", ["default", "indirect"])
def test_the_hash_is_of_the_spec(name, report, afmcalc):
    (shown,) = re.findall(r'title="([0-9a-f]{64})"', report(name))
    spec = afmcalc("check", CONFIGS / f"{name}.toml", "--json").json["spec"]
    text = json.dumps(spec, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    assert shown == hashlib.sha256(text.encode()).hexdigest()


def test_a_spec_named_script_stays_text(afmcalc, tmp_path):
    spec = tmp_path / "evil.toml"
    text = (CONFIGS / "default.toml").read_text(encoding="utf-8").replace("Base clutch", EVIL)
    spec.write_text(text + f"\n# {EVIL} </pre> {{{{ 7*7 }}}}\n", encoding="utf-8")
    page = afmcalc("report", spec, "--set", f"name={EVIL}&lt;").out
    assert "<script" not in page
    assert "{{ 7*7 }}" in page
    tree = parse(page)
    assert tree.find(".//h1").text == f"{EVIL}&lt;"
    assert f"name={EVIL}&lt;" in [text_of(code) for code in tree.findall(".//code")]
    assert f"# {EVIL} </pre>" in text_of(tree.find(".//pre"))


OVERDONE = ("default", "control_unit.gain=2", "control_unit.allowable_contact_force=100")


def test_given_resolved_and_overridden(report, afmcalc):
    page = report(*OVERDONE)
    assert "gain = 0.5" in page
    assert "<code>control_unit.gain=2</code>" in page
    piped = afmcalc("report", "-", stdin=afmcalc("accuracy", "--sweep", "C", "--json").out).out
    assert "accuracy_factor_peak" not in piped
    assert "&#34;gain&#34;: 0.5" in piped


def test_checks_have_utilisation_and_verdict(report):
    tree = parse(report(*OVERDONE))
    rows = tree.findall(".//section[@id='checks']//tr")[1:]
    found = {text_of(row[1]): (text_of(row[0]), float(row[6].text)) for row in rows}
    assert found["feedback gain"] == ("warning", 1.6)
    verdict, used = found["contact force on one ball"]
    assert verdict == "fail"
    assert used > 1
    assert "failed" in text_of(tree.find(".//dl"))


def table_rows(tree, section):
    rows = tree.findall(f".//section[@id='{section}']//tr")
    return [[text_of(each) for each in row] for row in rows]


def test_tolerance_values_have_their_errors_and_inputs_the_engineers_units(report, afmcalc):
    result = afmcalc("tolerance", CONFIGS / "tolerance.toml", "--json").json["result"]
    tree = parse(report("tolerance"))
    listed = table_rows(tree, "tolerance")
    rows = {row[0]: row[1:] for row in listed if len(row) < 6 or row[-1] in ("–", "kN", "mm", "MPa")}
    assert rows["Tm"] == ["mean torque", f"{result['mean']:.5g}", f"{result['mean_standard_error']:.2g}", "N·m"]
    assert rows["Fп"] == ["closing-spring force as set", "normal", "2", "0.1", "kN"]
    assert rows["τlimb"][2:] == ["400", "32", "MPa"]
    assert float(rows["T99.5"][1]) == pytest.approx(result["quantiles"][-1]["torque"], rel=1e-4)
    shares = listed[-len(result["sobol"]) :]
    assert shares[0][:3] == ["f", "friction in service", f"{result['sobol'][0]['first_order']:.5g}"]
    spec = {row[1]: row[2:] for row in table_rows(tree, "spec")}
    assert spec['scatter: endurance limit in shear tolerance.fields."fatigue.endurance_limit"'] == [
        "normal, spread 8 %, min 250",
        "MPa",
    ]


def test_an_exact_tolerance_has_no_errors(report):
    page = report("default", 'tolerance={fields={friction={distribution="uniform"}}}', "fatigue=")
    assert '<section id="life">' not in page
    (section,) = re.findall(r'<section id="tolerance">.*?</section>', page, re.DOTALL)
    assert "the answer is exact" in section
    assert "±" not in section
    still = 'tolerance={fields={"closing_spring.force"={distribution="normal", spread=0}}}'
    (section,) = re.findall(r'<section id="tolerance">.*?</section>', report("default", still), re.DOTALL)
    assert "<figure" not in section


def test_explained_steps(report, afmcalc):
    """Formula and numbers of each step, as explain gives them, and where the print differs."""
    tree = parse(report("default"))
    steps = afmcalc("explain", "torque", CONFIGS / "default.toml", "--json").json["result"]["steps"]
    section = tree.find(".//section[@id='torque']")
    assert len(section.findall(f".//{MATH}")) >= len(steps) > 5
    assert "F11 (11) prints Fp = z2 Fп f2/(1 + z2 C f2) (M1)" in text_of(section)


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


@pytest.mark.parametrize(
    "overrides",
    [
        ["f_min=0.3", "f_max=0.3"],
        ["C=0"],
        ["beta=1"],
        ["name="],
        ["friction.mean=", "control_unit.ball_circle_radius="],
    ],
)
def test_edges_leave_out_what_has_no_curve(overrides, report):
    parse(report("default", *overrides))


def test_a_life_by_amplitude(afmcalc):
    sensitivity = ["--set", "fatigue.mean_stress_sensitivity=0.1"]
    run = afmcalc("report", CONFIGS / "default.toml", *sensitivity, "--model", "amplitude")
    assert (run.code, run.err) == (0, "")
    assert "by the rule amplitude" in text_of(parse(run.out).find(".//section[@id='life']"))
