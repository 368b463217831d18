"""Explanations: the formula shown is the code that ran; a report asks the analyses that the commands ask."""

import math
import re

import pytest
from conftest import CONFIGS
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import direct_specs, indirect_specs

from afmcalc.analysis.accuracy import accuracy
from afmcalc.analysis.dossier import dossier
from afmcalc.analysis.explain.explain import explain
from afmcalc.analysis.explain.formula import FormulaText
from afmcalc.analysis.explain.trace import CallReader
from afmcalc.analysis.registry import ANALYSES, EXPLAINED
from afmcalc.engines import build
from afmcalc.equations.calls import noted
from afmcalc.equations.catalogue import equations
from afmcalc.errors import AfmcalcError
from afmcalc.spec import make_spec, read_spec, resolved

CASES = [("torque", "conventional"), ("torque", "indirect"), ("accuracy", "unlike-materials"), ("adjust", "indirect")]
CASES += [("check", "default"), ("overload", "all-driving"), ("synthesize", "indirect"), ("life", "default")]


@pytest.mark.parametrize(("command", "name"), [*CASES, pytest.param("heat", "drive", marks=pytest.mark.slow)])
def test_every_value_shown_is_the_value_calculated(command, name):
    """Each step names an equation, and that equation on the step's own numbers gives the step's value."""
    spec = read_spec(CONFIGS / f"{name}.toml")
    result, _ = explain(command, spec)
    assert result.steps
    with noted() as notes:
        ANALYSES[command].function(build(spec))
    calls = CallReader().calls(notes)
    values = {(call.equation.name, call.value) for call in calls if isinstance(call.value, int | float)}
    for step in result.steps:
        assert any(step.function == function and step.value == pytest.approx(value) for function, value in values)
        assert step.source
        assert step.unit == equations()[step.function].result.unit


OTHERS = {"accuracy_factor": st.floats(1, 20), "torque_max": st.floats(1, 1e6), "reduced_gain": st.floats(0.01, 9)}
WANTED = st.fixed_dictionaries({"nominal_torque": st.floats(1, 1e5)}, optional=OTHERS)


@pytest.mark.parametrize("command", EXPLAINED)
@settings(max_examples=4)
@given(st.one_of(direct_specs(), indirect_specs()), WANTED)
def test_a_clutch_with_requirements_and_nothing_that_is_not_needed_is_explained(command, spec, wanted):
    """By the answer that the command itself gives, or by its refusal: no contact, no fatigue, no drive, no heat."""
    own = make_spec({**resolved(spec), "requirements": wanted})
    try:
        _, findings = ANALYSES[command].function(build(own))
    except AfmcalcError as refused:
        with pytest.raises(type(refused)) as again:
            explain(command, own)
        assert str(again.value) == str(refused)
    else:
        told, same = explain(command, own)
        assert same == findings
        assert told.steps
        assert all(math.isfinite(step.value) for step in told.steps)


M, KG, S = 1.3, 1.7, 2.3
N = KG * M / S**2
NUMBER_OF_UNIT = {"m": M, "kg": KG, "s": S, "K": 2.9, "rad": 1.0, "N": N, "J": N * M, "W": N * M / S, "Pa": N / M**2}
"""A number for each unit, those of J, N … following from m, kg, s: units are factors like any other."""


def read_as_printed(text, names):
    """Value of a line of text read as anyone reads it: left to right, a number with one unit as a whole."""
    token = "|".join(re.escape(each) for each in sorted(names, key=len, reverse=True))
    text = re.sub("([²³])", lambda match: f"^{'²³'.index(match[1]) + 2}", text)
    text = re.sub(r"(\d[\d.]*) ([A-Za-z]+(?:\^[\d.]+)?)", r"(\1·\2)", text)
    parts = re.findall(rf" [-+] |{token}|\d+(?:\.\d+)?|[-·/^() ]", text)
    assert "".join(parts) == text, text
    symbols = {"·": "*", " ": "*", "^": "**"}
    return eval("".join(f"({names[part]})" if part in names else symbols.get(part, part) for part in parts))


def from_latex(text):
    """One line of text from LaTeX: a fraction's parts, and what is raised, in brackets; of what is innermost first."""
    text = re.sub(r"\\,\\text\{([^{}]*)\}", r" \1", text).replace("\\left", "").replace("\\right", "")
    while match := re.search(r"\\frac\{([^{}]*)\}\{([^{}]*)\}|\^\{([^{}]*)\}|\\sqrt\{([^{}]*)\}", text):
        above, below, raised, root = match.groups()
        shown = f"^({raised})" if raised else f"(({root})^(0.5))" if root else f"(({above})/({below}))"
        text = text[: match.start()] + shown + text[match.end() :]
    return re.sub(r"(?<! )- ", "-", text.replace(" \\cdot ", "·").replace("\\cdot ", "·"))


def printed_forms(equation, sign):
    """Value of the equation, and what each of its printed forms reads as."""
    numbers = {argument: 0.37 + 0.21 * index for index, argument in enumerate(equation.arguments)}
    units = {argument: term.unit for argument, term in equation.arguments.items()}
    if sign < 0 and set(units.values()) == {"1"}:
        numbers |= {next(iter(numbers)): -0.37}
    symbols = {argument: term.symbol for argument, term in equation.arguments.items()}
    assert len(set(symbols.values())) == len(symbols)
    text = FormulaText(equation.function, symbols, numbers, units)
    # a symbol of several letters, or a ratio, is read as the product or ratio of them
    several = re.compile(r"(?!sin|cos|tan|ln|largest)([^ /()]+)([ /])(\S+)")
    names = {symbol: numbers[argument] for argument, symbol in symbols.items() if not several.fullmatch(symbol)}
    for argument, symbol in symbols.items():
        if match := several.fullmatch(symbol):
            first = names.setdefault(match[1], 1.9)
            names[match[3]] = numbers[argument] / first if match[2] == " " else first / numbers[argument]
    of_result = read_as_printed(equation.result.unit.replace("*", "·"), NUMBER_OF_UNIT)
    shown = (text.text_with_numbers(), *(from_latex(text.latex_with_numbers(line=line)) for line in (False, True)))
    read = [read_as_printed(one, NUMBER_OF_UNIT) / of_result for one in shown]
    return complex(equation.function(**numbers)), [read_as_printed(text.text(), names), *read]


@pytest.mark.parametrize("sign", [1, -1])
def test_every_printed_form_reads_as_the_equation(sign):
    """With its own symbols and with numbers and units, as text and as LaTeX: m·c·λ/α A_c is another quantity."""
    for name, equation in equations().items():
        if name != "synthesis.least_contact_force_cubic":
            value, read = printed_forms(equation, sign)
            assert [complex(each) for each in read] == pytest.approx([value] * 4, rel=1e-9), name


def test_a_mended_formula_is_marked(afmcalc):
    out = afmcalc("explain", "torque").out
    assert "print differs: F11 (11) prints F_p = z_2 F_п f_2/(1 + z_2 C f_2) (M1)" in out


@st.composite
def coinciding(draw):
    """A clutch in which numbers of different meaning are equal."""
    data = resolved(draw(st.one_of(direct_specs(), indirect_specs())))
    for block in [data["friction"], *(data["friction"].get(group, {}) for group in ("driving", "driven"))]:
        if "min" in block:
            low = draw(st.sampled_from([block["min"], 0.25, 1.0]))
            high = low * draw(st.sampled_from([1, 2]))
            block |= {"min": low, "max": high, "mean": draw(st.sampled_from([low, high]))}
    data["closing_spring"]["force"] = draw(st.sampled_from([1.0, 0.25, data["closing_spring"]["force"]]))
    data["friction_group"]["mean_radius"] = draw(st.sampled_from([1.0, data["friction_group"]["mean_radius"]]))
    unit = data.get("control_unit", {})
    if "key_friction" in unit:
        unit["key_friction"] = draw(st.sampled_from([0.0, 0.25, 1.0]))
        unit["hub_diameter"] = 4 * data["friction_group"]["mean_radius"]
        unit["gain"] = unit["key_friction"] / 2 + draw(st.sampled_from([0.25, 1.0]))
    elif unit:
        unit["gain"] = draw(st.sampled_from([0.25, 1.0]))
    return make_spec(data)


@settings(max_examples=4)
@given(coinciding())
def test_every_result_has_its_steps_whatever_numbers_coincide(spec):
    """Torque and forces at the smallest, mean and largest friction: a step for each, with its value and symbols."""
    steps = explain("torque", spec)[0].steps
    clutch = build(spec)
    group = "2" if spec.friction.unlike else ""
    results = {"T": clutch.torque, "F_p": clutch.release_force, "N": clutch.normal_force}
    for end, name in (("min", "min"), ("mean", "cp"), ("max", "max")):
        at = f"f_{group}{name}"
        pair = [getattr(own, end) for own in clutch.friction]
        for symbol, result in results.items():
            own = [s for s in steps if s.symbol in (symbol, f"{symbol}_i") and s.at == at]
            assert any(s.value == pytest.approx(result(*pair), rel=1e-12) for s in own), (symbol, at)
            others = {f"f_{digit}{other}" for digit in ("", "1", "2") for other in {"min", "cp", "max"} - {name}}
            assert not any(other in s.formula for s in own for other in others)
        returning = clutch.sleeve and clutch.sleeve.torque_returning(pair[0])
        back = [s.value for s in steps if s.symbol == "T" and (s.at or "").partition(" ")[0].rstrip(",") == at]
        assert returning is None or any(value == pytest.approx(returning, rel=1e-12) for value in back)
    assert any(s.symbol == "T_н" for s in steps)
    for step in steps:
        if step.symbol == "D":
            assert ("κ₊" in step.formula) == (step.at or "").endswith(", returning")


def test_of_a_life_of_slips_the_mean_damage_is_shown_not_its_nodes():
    spec = read_spec(CONFIGS / "indirect.toml", ["fatigue.ultimate_strength=600e6", "fatigue.endurance_limit=10e6"])
    result, _ = ANALYSES["life"].function(build(spec), model="goodman")
    steps = explain("life", spec, model="goodman")[0].steps
    assert not [step for step in steps if "= 0." in (step.at or "")]
    means = [step for step in steps if step.function == "life.cycles_of_mean_damage"]
    lives = {(step.at, step.setting, step.side): step.value for step in means}
    for side, over in (("protected", "f_min … f_max"), ("protected_forecast", "f_cp … f_max")):
        for method in ("min-friction", "mean-friction"):
            value = getattr(getattr(result, side), method.replace("-", "_"))
            assert lives.get((over, method, "protected")) == value


def test_accuracy_of_springs_as_made_has_a_step():
    for force in (2500, 5500, 9000):
        spec = read_spec("example:indirect", [f"control_spring.force={force}"])
        values = {step.symbol: step.value for step in explain("accuracy", spec)[0].steps}
        assert values["K_т"] == pytest.approx(accuracy(build(spec))[0].accuracy_factor, rel=1e-12)


@pytest.mark.parametrize("name", ["default", "indirect", pytest.param("tolerance", marks=pytest.mark.slow)])
def test_a_report_has_each_analysis_that_applies_explained_or_not(name):
    """The results are those of the commands, and the same with and without their formulas."""
    spec = read_spec(CONFIGS / f"{name}.toml")
    own = build(spec)
    sections = [each for each in ANALYSES.values() if each.section and each.applies(own) and each.section.applies(own)]
    told, bare = dossier(spec), dossier(spec, explained=False)
    assert {topic.name for topic in told.topics} == {each.name for each in sections} - {"check"}
    for topic, plain in zip(told.topics, bare.topics, strict=True):
        assert topic.result == plain.result == ANALYSES[topic.name].function(own)[0]
    assert (told.check, told.check.limits, told.findings) == (bare.check, bare.check.limits, bare.findings)
    assert not any(topic.derivations for topic in bare.topics)
    assert told.topics[0].derivations


def test_no_life_without_fatigue():
    told = dossier(read_spec(CONFIGS / "default.toml", ["fatigue="]), explained=False)
    assert "life" not in {topic.name for topic in told.topics}
