"""Explanations: the formula shown is the code that ran; a report asks the analyses that the commands ask."""

import math
import re

import pytest
from conftest import CONFIGS, slow
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import direct_specs, indirect_specs

from afmcalc.analysis.explain.explain import explain
from afmcalc.analysis.explain.formula import FormulaText
from afmcalc.analysis.registry import ANALYSES, EXPLAINED
from afmcalc.engines import build
from afmcalc.equations.catalogue import equations
from afmcalc.errors import AfmcalcError
from afmcalc.formula_tree import text
from afmcalc.messages import native
from afmcalc.spec import make_spec, read_spec, resolved

CASES = {"torque": "indirect", "accuracy": "unlike-materials", "check": "default", "overload": "all-driving"}
CASES |= {"pocket": "indirect", "life": "default"}
CLUTCHES = [path.stem for path in sorted(CONFIGS.glob("*.toml")) if "\n[search]" not in path.read_text("utf-8")]
EVERY = slow(*((command, tuple(CLUTCHES[number % 2 :: 2])) for number, command in enumerate(EXPLAINED)))


@pytest.mark.parametrize(("command", "names"), [*((command, (name,)) for command, name in CASES.items()), *EVERY])
def test_every_formula_shown_evaluates_to_the_value_shown(command, names):
    """The formula with printed numbers and units gives the value to five digits; a difference may have fewer."""
    specs = [read_spec(CONFIGS / f"{name}.toml") for name in names]
    assert (asked := [spec for spec in specs if ANALYSES[command].applies(build(spec))])
    for spec in asked:
        evaluates(explain(command, spec)[0].steps)


SOFT = "{outer_diameter=0.1, inner_diameter=0.05, thickness=2e-3, free_height=4.8e-3, series=10}"


def test_a_sleeve_between_disc_springs_has_its_forces_explained():
    """This holds behind walls that steepen, too."""
    springs = [f"closing_spring.disc={SOFT}", f"control_spring.disc={SOFT.replace('10}', '20, parallel=4}')}"]
    for slope, net in (0, "κ"), (30, "κ(x)"):
        spec = read_spec("example:indirect", [*springs, f"control_unit.gain_slope={slope}"])
        steps = explain("accuracy", spec)[0].steps
        evaluates(steps)
        assert f"F_2(x)/(1 + z·{net}·f_max)" in {step.formula for step in steps if step.symbol == "N"}
    functions = {step.function for step in explain("check", spec)[0].steps}
    assert {"springs.disc_force", "springs.disc_stress", "springs.stack_length"} <= functions


def evaluates(steps):
    assert steps
    for step in steps:
        value = read_as_printed(step.substituted, NUMBER_OF_UNIT)
        unit = read_as_printed(step.unit.replace("*", "·"), NUMBER_OF_UNIT)
        assert value / unit == pytest.approx(step.value, rel=5e-3, abs=1e-6), step.substituted
        assert step.source


OTHERS = {"accuracy_factor": st.floats(1, 20), "torque_max": st.floats(1, 1e6), "reduced_gain": st.floats(0.01, 9)}
WANTED = st.fixed_dictionaries({"nominal_torque": st.floats(1, 1e5)}, optional=OTHERS)


@pytest.mark.parametrize("command", EXPLAINED)
@settings(max_examples=2)
@given(st.one_of(direct_specs(), indirect_specs()), WANTED)
def test_a_clutch_with_requirements_and_nothing_that_is_not_needed_is_explained(command, spec, wanted):
    """A command is explained with its answer or its refusal; a spec needs no contact, fatigue, drive or heat for it."""
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
"""Arbitrary number for each base unit; those of J, N … follow, so that units are factors like any other."""


def read_as_printed(text, names):
    """Value of a printed formula, read from left to right, with a number and its unit as one factor."""

    def plain(text):
        text = re.sub("([²³])", lambda match: f"^{'²³'.index(match[1]) + 2}", text)
        return text.replace(", ", ",").replace("\xa0", " ")

    names = {"π": math.pi} | {plain(name): value for name, value in names.items()}
    token = "|".join(re.escape(each) for each in sorted(names, key=len, reverse=True))
    text = re.sub(r"(?<![\w_^-])(\d[\d.]*) ([A-Za-z]+(?:\^[\d.]+)?)", r"(\1·\2)", plain(text))
    text = re.sub(r"([\d.]+·10\^\(?-?\d+\)?) ([A-Za-z]+(?:\^[\d.]+)?)", r"(\1·\2)", text)
    called = "(?:max|min|arctan|sin|cos|tan)(?=[(])"
    whole = "|".join(re.escape(each) for each in names if each.endswith(")")) or "(?!)"
    parts = re.findall(rf" [-+] |{whole}|{called}|{token}|\d+(?:\.\d+)?|[-·/^(), ]", text)
    assert "".join(parts) == text, text
    symbols, functions = {"·": "*", " ": "*", "^": "**"}, {**vars(math), "arctan": math.atan, "max": max, "min": min}
    return eval("".join(f"({names[part]})" if part in names else symbols.get(part, part) for part in parts), functions)


def printed_forms(equation, sign):
    """Value of the equation, and what each of its printed forms reads as."""
    numbers = {argument: 0.37 + 0.21 * index for index, argument in enumerate(equation.arguments)}
    terms = {argument: (term.symbol, term.unit) for argument, term in equation.arguments.items()}
    if sign < 0 and {unit for _, unit in terms.values()} == {"1"}:
        numbers |= {next(iter(numbers)): -0.37}
    symbols = {argument: native(symbol) for argument, (symbol, _) in terms.items()}
    assert len(set(symbols.values())) == len(symbols)
    units = {name: (symbols[name], unit) for name, (_, unit) in terms.items()}
    formula = FormulaText(equation.function, units, numbers)
    # a symbol of two words, or a ratio, is read as the product or the ratio of its parts
    several = re.compile(r"(?!sin|cos|tan|ln|largest)([^ /()]+)([ /])(\S+)")
    names = {symbol: numbers[argument] for argument, symbol in symbols.items() if not several.fullmatch(symbol)}
    for argument, symbol in symbols.items():
        if match := several.fullmatch(symbol):
            first = names.setdefault(match[1], 1.9)
            names[match[3]] = numbers[argument] / first if match[2] == " " else first / numbers[argument]
    of_result = read_as_printed(equation.result.unit.replace("*", "·"), NUMBER_OF_UNIT)
    shown = (text(formula.with_numbers(line=line)) for line in (False, True))
    read = [read_as_printed(one, NUMBER_OF_UNIT) / of_result for one in shown]
    return complex(equation.function(**numbers)), [read_as_printed(text(formula.tree), names), *read]


def has_formula(equation):
    """True if an equation is a formula, not a choice or a list of values."""
    try:
        FormulaText(
            equation.function, dict.fromkeys(equation.arguments, ("x", "1")), dict.fromkeys(equation.arguments, 1.0)
        )
    except TypeError:
        return False
    return True


@pytest.mark.parametrize("sign", [1, *slow(-1)])
def test_every_printed_form_reads_as_the_equation(sign):
    """This holds for symbols and for numbers with units: m·c·λ/α A_c, without brackets, would be another quantity."""
    for name, equation in equations().items():
        if name != "unlike.bend_of_path" and has_formula(equation):  # that one has a number to avoid 0/0
            value, read = printed_forms(equation, sign)
            assert [complex(each) for each in read] == pytest.approx([value] * 3, rel=1e-9), name


def test_of_a_life_of_slips_the_mean_damage_is_shown_not_its_nodes():
    spec = read_spec(CONFIGS / "indirect.toml", ["fatigue.ultimate_strength=600e6", "fatigue.endurance_limit=10e6"])
    result, _ = ANALYSES["life"].function(build(spec), model="goodman")
    steps = explain("life", spec, model="goodman")[0].steps
    assert not [step for step in steps if "slip" in (step.at or "")]
    lives = {(step.at, step.setting, step.side): step.value for step in steps if step.symbol == "N_c"}
    for side, case in (("protected", None), ("protected_forecast", "f ≥ f_mean")):
        for method in ("min-friction", "mean-friction"):
            setting = None if method == spec.adjustment.method else method
            assert lives[case, setting, None] == getattr(getattr(result, side), method.replace("-", "_"))


def test_the_contact_along_a_wall_is_shown_where_it_is_largest():
    spec = read_spec("example:constant-torque")
    (found, _), (told, _) = ANALYSES["pocket"].function(build(spec)), explain("pocket", spec)
    for symbol, largest in ("F_n", found.contact_force), ("p_0", found.contact_pressure):
        assert max(step.value for step in told.steps if step.symbol == symbol) == pytest.approx(largest, rel=1e-12)
