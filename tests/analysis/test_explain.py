"""Explanations: the formula shown is the code that ran."""

import pytest
import sympy
from conftest import CONFIGS

from afmcalc.analysis.explain.explain import explain
from afmcalc.analysis.explain.formula import Formula
from afmcalc.analysis.explain.trace import distinct, recording
from afmcalc.analysis.registry import ANALYSES
from afmcalc.engines import build
from afmcalc.equations import direct
from afmcalc.equations.catalogue import equations
from afmcalc.spec import read_spec

CASES = [(c, n) for c in ("torque", "accuracy", "adjust", "check") for n in ("default", "conventional", "unlike-materials", "all-driving", "indirect")]  # fmt: skip
CASES += [("overload", "default"), ("overload", "all-driving"), ("synthesize", "indirect"), ("synthesize", "default"), ("life", "default")]  # fmt: skip


@pytest.mark.parametrize(("command", "name"), CASES)
def test_every_value_shown_is_the_value_calculated(command, name):
    """Each step names an equation, and that equation on the step's own numbers gives the step's value."""
    spec = read_spec(CONFIGS / f"{name}.toml")
    result, _ = explain(command, spec)
    assert result.steps
    with recording() as calls:
        ANALYSES[command].function(build(spec))
    values = {(call.equation.name, call.value) for call in calls if isinstance(call.value, float)}
    for step in result.steps:
        assert any(step.function == function and step.value == pytest.approx(value) for function, value in values)
        assert step.source
        assert step.unit == equations()[step.function].result.unit


@pytest.mark.parametrize("name", sorted(n for n in equations() if n != "synthesis.least_contact_force_cubic"))
def test_the_text_of_every_equation_evaluates_to_the_equation(name):
    """Read the one-line text back and put the numbers in: the same value, whatever SymPy did to the order."""
    equation = equations()[name]
    letters = {argument: f"a{index}" for index, argument in enumerate(equation.arguments)}
    values = {argument: 0.37 + 0.21 * index for index, argument in enumerate(equation.arguments)}
    units = {argument: term.unit for argument, term in equation.arguments.items()}
    text = Formula(equation.function, letters, values, units).text()
    read = sympy.sympify(text.replace("·", "*").replace("^", "**"))
    value = read.subs({letters[argument]: values[argument] for argument in letters})
    assert float(value) == pytest.approx(float(equation.function(**values)), rel=1e-12), text


def test_recording_restores_the_functions_and_lists_outermost_calls():
    before = direct.torque
    with recording() as calls:
        assert direct.torque is not before
        clutch = build(read_spec(CONFIGS / "indirect.toml"))
        _ = clutch.accuracy_factor
    assert direct.torque is before
    names = [call.equation.name for call in distinct(calls)]
    assert "indirect.accuracy_factor" in names
    assert names.count("indirect.accuracy_factor") == 1


def test_a_mended_formula_is_marked(afmcalc):
    out = afmcalc("explain", "torque").out
    assert "F_p = F_п·C·z_2·f_2min/(1 + C·z_2·f_2min)" in out
    assert "= 2000 N·0.5·7·0.1/(1 + 0.5·7·0.1)" in out
    assert "print differs: F11 (11) prints F_p = z_2 F_п f_2/(1 + z_2 C f_2) (M1)" in out


def test_formats(afmcalc):
    steps = afmcalc("explain", "overload", CONFIGS / "all-driving.toml", "--json").json["result"]["steps"]
    assert {step["symbol"] for step in steps} >= {"T_п", "T_муф", "A"}
    markdown = afmcalc("explain", "torque", "--format", "markdown").out
    assert "\\frac{" in markdown
    assert markdown.count("$$") % 2 == 0
    assert len(afmcalc("explain", "torque", "--format", "csv").out.splitlines()) > 5
    assert "\x1b" not in afmcalc("explain", "torque").out


def test_errors(afmcalc, monkeypatch):
    run = afmcalc("explain", "torqe")
    assert (run.code, "did you mean 'torque'" in run.err) == (2, True)
    refused = afmcalc("explain", "overload", CONFIGS / "indirect.toml")
    assert refused.code == 2
    monkeypatch.setattr("afmcalc.extras.find_spec", lambda name: None)
    missing = afmcalc("explain", "torque")
    assert missing.code == 2
    assert "pip install 'afmcalc[explain]'" in missing.err
