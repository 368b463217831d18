"""Texts of the user's show what they are, in every format, and do nothing."""

import csv
import io
import re

import pytest
from conftest import CONFIGS

from afmcalc.findings import Finding
from afmcalc.messages import printable
from afmcalc.render import renderer
from afmcalc.render.formats import FORMATS
from afmcalc.result import Output

SPEC = CONFIGS / "default.toml"
ACTS = "a\x1b[31m\x07\x9b2J\x7f\u202eb\u2066\ufeff\x00\r\n\udcff\U000e0041"


def test_what_is_printable_stays():
    for text in ("T_н = 5 kN·m, ΔT ≤ 2 °C", "Müller 漢字 😀", "", "a\u00a0b\u2009c"):
        assert printable(text) == text
    assert printable("a\nb", lines=True) == "a\nb"
    shown = printable(ACTS)
    assert shown.isascii()
    assert shown.isprintable()
    assert printable(shown) == shown


@pytest.mark.parametrize("name", FORMATS)
@pytest.mark.parametrize("terminal", [False, True])
def test_no_format_lets_a_text_act(name, terminal):
    from afmcalc import load
    from afmcalc.analysis.compare import compare

    clutch = load(SPEC)
    result, _ = compare([clutch])
    result = result.model_copy(update={"clutches": [result.clutches[0].model_copy(update={"name": ACTS})]})
    output = Output("compare", "1", {"name": ACTS, "variant": ACTS}, result, [Finding("info", "x", ACTS, path=ACTS)])
    text = renderer(name)(output, terminal)
    if terminal:
        text = re.sub("\x1b\\[[\\d;]*m", "", text)  # colours of our own
        assert "[31m" in text
    assert not re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ufeff\ud800-\udfff]", text)


def test_arguments_and_keys_are_shown_escaped(afmcalc):
    for arguments in (
        ["torque", f"{ACTS}.toml"],
        ["torque", f"--{ACTS}"],
        [ACTS],
        ["torque", "--set", f"{ACTS}=1"],
        ["accuracy", "--sweep", ACTS],
        ["solve", f"{ACTS}=1"],
        ["explain", ACTS],
        ["plot", "paper", ACTS],
        ["equations", "--id", ACTS],
        ["schema", ACTS],
    ):
        run = afmcalc(*arguments)
        assert run.code in (2, 3)
        assert not re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202e\u2066\ufeff\ud800-\udfff]", run.err)
        assert "a\\" in run.err


@pytest.mark.parametrize("name", ["=1+1", "+x", "-x", "@SUM(A1)"])
def test_no_cell_of_csv_is_a_formula(name, afmcalc):
    run = afmcalc("compare", SPEC, "--set", f'name="{name}"', "--format", "csv")
    ((shown, *numbers),) = list(csv.reader(io.StringIO(run.out)))[1:]
    assert shown == f"'{name}"
    assert float(numbers[1]) == 2000


@pytest.mark.every(2)
@pytest.mark.parametrize("name", ["_x", "a_b", "a_b_c $x$", "__"])
def test_a_name_is_in_the_legend_as_it_is(name, afmcalc, tmp_path, monkeypatch):
    monkeypatch.setattr("afmcalc.render.plot.paint.PARAMETERS", {"svg.fonttype": "none"})
    monkeypatch.setattr("afmcalc.render.plot.figure.PARAMETERS", {"svg.fonttype": "none"})
    own = tmp_path / "own.toml"
    own.write_text(
        re.sub("^name.*", f'name = "{name}"', SPEC.read_text(encoding="utf-8"), flags=re.MULTILINE), encoding="utf-8"
    )
    target = tmp_path / "x.svg"
    assert afmcalc("plot", "accuracy", own, CONFIGS / "all-driving.toml", "-o", target).code == 0
    texts = [text.strip() for text in re.findall(r"<text[^>]*>([^<]*)</text>", target.read_text(encoding="utf-8"))]
    assert name in texts
    assert name in afmcalc("plot", "accuracy", own, CONFIGS / "all-driving.toml").out


def test_a_name_is_in_a_report_as_it_is(undrawn, afmcalc):
    page = afmcalc("report", SPEC, "--set", "name=a_b", "--set", "fatigue=").out
    assert "a<sub>b" not in page
    assert page.count("a_b") >= 2
