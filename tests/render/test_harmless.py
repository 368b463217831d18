"""Texts of the user's show what they are, in every format, and do nothing; what is not needed is not imported."""

import csv
import io
import re

import pytest
from conftest import CONFIGS

from afmcalc.analysis.compare import compare
from afmcalc.engines import build
from afmcalc.findings import Finding
from afmcalc.messages import printable
from afmcalc.render import renderer
from afmcalc.render.formats import FORMATS
from afmcalc.result import Output
from afmcalc.spec import read_spec

SPEC = CONFIGS / "default.toml"
ACTS = "a\x1b[31m\x07\x9b2J\x7f\u202eb\u2066\ufeff\x00\r\n\udcff\U000e0041"
ACTING = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ufeff\ud800-\udfff]")


def test_what_is_printable_stays():
    for text in ("T_н = 5 kN·m, ΔT ≤ 2 °C", "Müller 漢字 😀", "", "a\u00a0b\u2009c"):
        assert printable(text) == text
    shown = printable(ACTS)
    assert shown.isascii()
    assert shown.isprintable()


@pytest.mark.parametrize("name", FORMATS)
@pytest.mark.parametrize("terminal", [False, True])
def test_no_format_lets_a_text_act(name, terminal):
    result, _ = compare([build(read_spec(SPEC))])
    result = result.model_copy(update={"clutches": [result.clutches[0].model_copy(update={"name": ACTS})]})
    output = Output("compare", "1", {"name": ACTS, "variant": ACTS}, result, [Finding("info", "x", ACTS, path=ACTS)])
    text = renderer(name)(output, terminal)
    if terminal:
        text = re.sub("\x1b\\[[\\d;]*m", "", text)  # colours of our own
        assert "[31m" in text
    assert not ACTING.search(text)


def test_arguments_and_keys_are_shown_escaped(afmcalc):
    for arguments in (
        ["torque", f"{ACTS}.toml"], ["torque", f"--{ACTS}"], [ACTS], ["torque", "--set", f"{ACTS}=1"],
        ["accuracy", "--sweep", ACTS], ["solve", f"{ACTS}=1"], ["plot", "paper", ACTS], ["schema", ACTS],
    ):  # fmt: skip
        run = afmcalc(*arguments)
        assert run.code in (2, 3)
        assert not ACTING.search(run.err)
        assert "a\\" in run.err


def test_no_cell_of_csv_is_a_formula(answered):
    for name in ("=1+1", "+x", "-x", "@SUM(A1)"):
        run = answered("compare", SPEC, "--set", f'name="{name}"', "--format", "csv")
        ((shown, *numbers),) = list(csv.reader(io.StringIO(run.out)))[1:]
        assert shown == f"'{name}"
        assert float(numbers[1]) == 2000


def test_a_name_is_no_markup(answered):
    run = answered("torque", "--set", "name=<b>|x|*_`[bold]y[/]", "--format", "markdown")
    assert "## torque: \\<b\\>\\|x\\|\\*\\_\\`\\[bold\\]y\\[/\\]" in run.out
    assert "[bold]y[/]" in answered("torque", "--set", "name=[bold]y[/]").out
