"""Explanations: the formula shown is the code that ran."""

import math
import re
from concurrent.futures import ThreadPoolExecutor

import pytest
import sympy
from afmcalc.analysis.explain.trace import CallReader, distinct
from afmcalc.equations.calls import noted
from conftest import CONFIGS, S21, fewer
from hypothesis import given
from hypothesis import strategies as st
from strategies import direct_specs, indirect_specs

from afmcalc.analysis.accuracy import accuracy
<<<<<<< HEAD
from afmcalc.analysis.explain.explain import explain, noting, shown, steps_of
from afmcalc.analysis.explain.formula import Expression, FormulaText, Leaf
from afmcalc.analysis.registry import ANALYSES, EXPLAINED
from afmcalc.engines import build
from afmcalc.equations.catalogue import equation_of, equations
=======
from afmcalc.analysis.explain.explain import explain
from afmcalc.analysis.explain.formula import FormulaText
from afmcalc.analysis.registry import ANALYSES, EXPLAINED
from afmcalc.engines import build
from afmcalc.equations.catalogue import equations
>>>>>>> w-t3
from afmcalc.errors import AfmcalcError
from afmcalc.spec import make_spec, read_spec, resolved

CASES = [(c, n) for c in ("torque", "accuracy", "adjust", "check") for n in ("default", "conventional", "unlike-materials", "all-driving", "indirect")]  # fmt: skip
CASES += [("overload", "default"), ("overload", "all-driving"), ("synthesize", "indirect"), ("synthesize", "default"), ("life", "default"), ("heat", "drive")]  # fmt: skip


@pytest.mark.parametrize(("command", "name"), CASES)
def test_every_formula_shown_evaluates_to_the_value_shown(command, name):
    """With its numbers and units as they are printed, to five digits; a difference of two may have fewer."""
    result, _ = explain(command, read_spec(CONFIGS / f"{name}.toml"))
    assert result.steps
    for step in result.steps:
        value = read_as_printed(step.substituted, NUMBER_OF_UNIT)
        unit = read_as_printed(step.unit.replace("*", "·"), NUMBER_OF_UNIT)
        assert value / unit == pytest.approx(step.value, rel=5e-3, abs=1e-6), step.substituted
        assert step.source


WANTED = st.fixed_dictionaries(
    {"nominal_torque": st.floats(1, 1e5)},
    optional={"accuracy_factor": st.floats(1, 20), "torque_max": st.floats(1, 1e6), "reduced_gain": st.floats(0.01, 9)},
)


@pytest.mark.parametrize("command", EXPLAINED)
@fewer(2)
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


@pytest.mark.parametrize("name", ["default", "unlike-materials", "all-driving", "indirect", "constant-torque"])
def test_no_two_steps_of_the_torque_look_alike(name):
    """Branches of a curved pocket too: what falls back is not said to rise."""
    steps = explain("torque", read_spec(CONFIGS / f"{name}.toml"))[0].steps
    told = [(step.function, step.symbol, step.at, step.setting) for step in steps]
    assert len(told) == len(set(told))


def has_formula(equation):
    """Whether it is one, not a choice or a list of values."""
    try:
        result = equation.function(**{name: Leaf(name, value=1.0) for name in equation.arguments})
    except (TypeError, AttributeError):
        return False
    return isinstance(result, Expression)


FORMULAS = sorted(name for name, equation in equations().items() if has_formula(equation))
FORMULAS.remove("unlike.bend_of_path")  # it has a number to avoid 0/0


@pytest.mark.parametrize("name", FORMULAS)
def test_the_text_of_every_equation_evaluates_to_the_equation(name):
    """Read the one-line text back and put the numbers in: the same value."""
    equation = equations()[name]
    letters = {argument: f"a{index}" for index, argument in enumerate(equation.arguments)}
    values = {argument: 0.37 + 0.21 * index for index, argument in enumerate(equation.arguments)}
    units = {argument: term.unit for argument, term in equation.arguments.items()}
    text = FormulaText(equation.function, letters, values, units).text()
    text = text.replace("·", "*").replace("^", "**").replace("π", "pi")
    read = sympy.sympify(text.replace("max", "Max").replace("min", "Min"))
    value = read.subs({letters[argument]: values[argument] for argument in letters})
    assert complex(value) == pytest.approx(complex(equation.function(**values)), rel=1e-12), text


NUMBER_OF_UNIT = {"m": 1.3, "kg": 1.7, "s": 2.3, "K": 2.9, "rad": 1.0}
NUMBER_OF_UNIT["N"] = NUMBER_OF_UNIT["kg"] * NUMBER_OF_UNIT["m"] / NUMBER_OF_UNIT["s"] ** 2
NUMBER_OF_UNIT["J"] = NUMBER_OF_UNIT["N"] * NUMBER_OF_UNIT["m"]
NUMBER_OF_UNIT["W"] = NUMBER_OF_UNIT["J"] / NUMBER_OF_UNIT["s"]
NUMBER_OF_UNIT["Pa"] = NUMBER_OF_UNIT["N"] / NUMBER_OF_UNIT["m"] ** 2
"""A number for each unit, those of J, N … following from m, kg, s: units are factors like any other."""


def read_as_printed(text, names):
    """Value of a line of text read as anyone reads it: left to right, a number with one unit as a whole."""

    def plain(text):
        text = re.sub("([²³])", lambda match: f"^{'²³'.index(match[1]) + 2}", text)
        return text.replace(", ", ",")

    names = {"π": math.pi} | {plain(name): value for name, value in names.items()}
    token = "|".join(re.escape(each) for each in sorted(names, key=len, reverse=True))
    text = re.sub(r"(?<![\w_])(\d[\d.]*) ([A-Za-z]+(?:\^[\d.]+)?)", r"(\1·\2)", plain(text))
    text = re.sub(r"\(([\d.]+·10\^-?\d+)\) ([A-Za-z]+(?:\^[\d.]+)?)", r"((\1)·\2)", text)
    called = "(?:max|min|atan|sin|cos|tan)(?=[(])"
    whole = "|".join(re.escape(each) for each in names if each.endswith(")")) or "(?!)"
    parts = re.findall(rf" [-+] |{whole}|{called}|{token}|\d+(?:\.\d+)?|[-·/^(), ]", text)
    assert "".join(parts) == text, text
    symbols, functions = {"·": "*", " ": "*", "^": "**"}, {**vars(math), "max": max, "min": min}
    return eval("".join(f"({names[part]})" if part in names else symbols.get(part, part) for part in parts), functions)


def from_latex(text):
    """One line of text from LaTeX: a fraction's parts, and what is raised, in brackets; of what is innermost first."""
    text = re.sub(r"\\(?:arc|a)?(max|min|sin|cos|tan) ", lambda match: match[0][1:-1].replace("arc", "a"), text)
    text = text.replace("\\pi ", "π")
    text = re.sub(r"\\,\\text\{([^{}]*)\}", r" \1", text).replace("\\left", "").replace("\\right", "")
    while match := re.search(r"\\frac\{([^{}]*)\}\{([^{}]*)\}|\^\{([^{}]*)\}|\\sqrt\{([^{}]*)\}", text):
        above, below, raised, root = match.groups()
        shown = f"^({raised})" if raised else f"(({root})^(0.5))" if root else f"(({above})/({below}))"
        text = text[: match.start()] + shown + text[match.end() :]
    return re.sub(r"(?<! )- ", "-", text.replace(" \\cdot ", "·").replace("\\cdot ", "·"))


@pytest.mark.parametrize("name", FORMULAS)
@pytest.mark.parametrize("sign", [1, -1])
def test_every_printed_form_reads_as_the_equation(name, sign):
    """With its own symbols and with numbers and units, as text and as LaTeX: m·c·λ/α A_c is another quantity."""
    equation = equations()[name]
    numbers = {argument: 0.37 + 0.21 * index for index, argument in enumerate(equation.arguments)}
    if sign < 0 and all(unit == "1" for unit in (term.unit for term in equation.arguments.values())):
        numbers |= {next(iter(numbers)): -0.37}
    symbols = {argument: term.symbol for argument, term in equation.arguments.items()}
    assert len(set(symbols.values())) == len(symbols)
    units = {argument: term.unit for argument, term in equation.arguments.items()}
    text = FormulaText(equation.function, symbols, numbers, units)
    value = complex(equation.function(**numbers))
    # a symbol of several letters, or a ratio, is read as the product or ratio of them
    several = re.compile(r"(?!sin|cos|tan|ln|largest)([^ /()]+)([ /])(\S+)")
    names = {symbol: numbers[argument] for argument, symbol in symbols.items() if not several.fullmatch(symbol)}
    for argument, symbol in symbols.items():
        if match := several.fullmatch(symbol):
            first = names.setdefault(match[1], 1.9)
            names[match[3]] = numbers[argument] / first if match[2] == " " else first / numbers[argument]
    assert complex(read_as_printed(text.text(), names)) == pytest.approx(value, rel=1e-9), text.text()
    of_result = read_as_printed(equation.result.unit.replace("*", "·"), NUMBER_OF_UNIT)
    for line in (text.text_with_numbers(), *(from_latex(text.latex_with_numbers(line=on)) for on in (False, True))):
        read = complex(read_as_printed(line, NUMBER_OF_UNIT))
        assert read == pytest.approx(value * of_result, rel=1e-9), line


def test_threads_explain_beside_each_other_and_a_torque_beside_them_is_a_plain_number():
    """Four at once: each explanation is whole, and other threads note nothing."""
    spec = read_spec(S21)
    whole = [step.to_dict() for step in explain("torque", spec)[0].steps]
    clutch, torques = build(spec), []

    def ask(number):
        if number % 2:
            torques.extend(clutch.torque(0.3) for _ in range(200))
            return None
        return [step.to_dict() for step in explain("torque", spec)[0].steps]

    with ThreadPoolExecutor(4) as threads:
        explained = [steps for steps in threads.map(ask, range(16)) if steps is not None]
    assert explained == [whole] * 8
    assert len(whole) > 20
    assert {(type(torque), torque) for torque in torques} == {(float, clutch.torque(0.3))}


def test_a_mended_formula_is_marked(afmcalc):
    out = afmcalc("explain", "torque").out
    assert "F_p = F_п·C·z_2·f_min/(1 + C·z_2·f_min)" in out
    assert "= 2000 N·0.5·7·0.1/(1 + 0.5·7·0.1)" in out
    assert "print differs: F11 (11) prints F_p = z_2 F_п f_2/(1 + z_2 C f_2) (M1)" in out


def test_a_force_of_one_newton_hides_no_step(afmcalc):
    out = afmcalc("explain", "torque", "--set", "F=1").out
    for head in (*(f"{symbol} at f_{end}:" for symbol in ("T", "N", "F_p") for end in ("min", "cp", "max")), "T_н"):
        assert f"\n{head}" in out, head
    assert "= 1 N·0.1 m·(1·0.8 + 7·0.8)/(1 + 0.5·7·0.8)" in out


def test_the_key_keeps_its_own_friction(afmcalc):
    """Also where it is the number of f_min."""
    indirect = S21
    out = afmcalc("explain", "torque", indirect, "--set", "control_unit.key_friction=0.1").out
    assert "κ = C - 2R f_1/d" in out
    assert "κ₊ = C + 2R f_1/d" in out
    assert "f_1min" not in out
    # without friction at the key κ and κ₊ are one number, not one quantity
    steps = afmcalc("explain", "torque", indirect, "--set", "control_unit.key_friction=0", "--json").json["result"]
    stiffness = {(step["at"], step["formula"]) for step in steps["steps"] if step["symbol"] == "D"}
    assert {("f_max", "c_1 + c_2 + z·c_1·f_max·κ"), ("f_cp, returning", "c_1 + c_2 + z·c_1·f_cp·κ₊")} <= stiffness


def test_a_mean_that_is_the_largest_hides_neither(afmcalc):
    out = afmcalc("explain", "torque", "--set", "friction.mean=0.8").out
    assert "\nT at f_cp:" in out
    assert "\nT at f_max:" in out
    assert "z_1·f_cp + z_2·f_cp" in out
    assert "z_1·f_max + z_2·f_max" in out


def test_the_ordinary_clutch_in_its_place_has_a_symbol_of_its_own(afmcalc):
    steps = afmcalc("explain", "accuracy", "--json").json["result"]["steps"]
    values = {
        symbol: [step["value"] for step in steps if step["symbol"] == symbol and step["at"] is None]
        for symbol in ("K_т", "K_т,0")
    }
    assert values == {"K_т": [pytest.approx(8 * 1.35 / 3.8)], "K_т,0": [pytest.approx(8)]}
    markdown = afmcalc("explain", "accuracy", "--format", "markdown").out
    assert "K_{\\text{т,0}}" in markdown


def test_both_groups_have_their_own_ends(afmcalc):
    """The balls carry the driven pairs' torque: their friction is f_2, whatever f_1 is."""
    unlike = CONFIGS / "unlike-materials.toml"
    steps = afmcalc("explain", "synthesize", unlike, "--json").json["result"]["steps"]
    assert {step["at"] for step in steps if step["symbol"] == "T_2"} == {"f_min", "f_max"}


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
    if draw(st.booleans()):
        data["friction_group"]["mean_radius"] = 1.0
    unit = data.get("control_unit", {})
    if "key_friction" in unit:
        unit["key_friction"] = draw(st.sampled_from([0.0, 0.25, 1.0]))
        unit["hub_diameter"] = 4 * data["friction_group"]["mean_radius"]
        unit["gain"] = unit["key_friction"] / 2 + draw(st.sampled_from([0.25, 1.0]))
    elif unit:
        unit["gain"] = draw(st.sampled_from([0.25, 1.0]))
    return make_spec(data)


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
    refused = afmcalc("explain", "overload", S21)
    assert refused.code == 2
    monkeypatch.setattr("afmcalc.errors.find_spec", lambda name: None)
    assert afmcalc("explain", "torque").code == 0


def test_explain_shows_the_stop_the_corners_and_the_cycles(afmcalc):
    indirect = afmcalc("explain", "torque", S21, "--set", "adjustment.method=mean-friction", "--json")
    assert all(step["value"] >= 0 for step in indirect.json["result"]["steps"] if step["symbol"] == "x")
    corners = {step["at"] for step in afmcalc("explain", "accuracy", "--json").json["result"]["steps"]}
    assert {"f_1min, f_2max", "f_1max, f_2min"} <= corners
    life = afmcalc("explain", "life", "--json").json["result"]["steps"]
    assert [step for step in life if step["function"] == "life.cycles_of_line"]
    goodman = ["--model", "goodman", "--set", "fatigue.ultimate_strength=900 MPa"]
    assert "equivalent_stress_goodman" in afmcalc("explain", "life", *goodman, "--json").out
    assert afmcalc("explain", "torque", "--model", "goodman").code == 2
    stress = next(step for step in life if step["function"] == "life.shear_stress")
    assert "/((1.5·10^-5) m³)" in stress["substituted"] or "(1.5·10^-5)" in stress["substituted"]


def test_falling_torque_is_explained(afmcalc):
    falling = ["--set", "friction.driving.min=0.5", "--set", "friction.driven.min=0.1", "--set", "C=3"]
    steps = afmcalc("explain", "accuracy", CONFIGS / "unlike-materials.toml", *falling, "--json").json["result"][
        "steps"
    ]
    (factor,) = (step for step in steps if step["function"] == "accuracy.accuracy_factor" and step["at"] is None)
    assert factor["value"] == pytest.approx(1.1037, rel=1e-4)
    assert factor["formula"] == "T_max/T_min"
    largest = next(step for step in steps if step["symbol"] == "T_max")
    assert largest["formula"].startswith("max(T(f_min)")


RUN_DOWN = {"motor_inertia": 1.5, "speed": 30.0, "motor_torque": 90.0}


def test_the_heat_of_a_trip_is_explained_by_its_own_numbers():
    """Each at its friction; the power is that of the slip, not a unit by which the surface's is scaled."""
    drive = resolved(read_spec(CONFIGS / "drive.toml"))
    steps = explain("heat", make_spec(drive))[0].steps
    per_trip = {"q_A", "ΔΘ", "q", "n_Θ", "ν", "t_p", "n_w"}
    told = [(step.symbol, step.at) for step in steps if step.symbol in per_trip]
    assert sorted(told) == sorted((symbol, f"f_{end}") for symbol in per_trip for end in ("min", "cp", "max"))
    assert not any(" 1 W" in step.substituted or step.substituted.startswith("1 W") for step in steps)
    # nothing leads from depth and effusivity to a value that is shown
    assert not {"l", "b", "t", "Q"} & {step.symbol for step in steps}
    run_down = make_spec(
        drive | {"drive": RUN_DOWN, "requirements": {"temperature": drive["requirements"]["temperature"]}}
    )
    result, _ = ANALYSES["heat"].function(build(run_down))
    steps = explain("heat", run_down)[0].steps
    for symbol, values in (("t", result.slip_time), ("Q", result.energy), ("q", result.power_density)):
        own = {step.at: step.value for step in steps if step.symbol == symbol}
        assert own == {"f_min": values.min, "f_cp": values.mean, "f_max": values.max}
    assert all(step.value > 0 for step in steps if step.symbol == "P")


def test_the_heat_of_a_trip_that_is_switched_off_is_told_at_its_friction():
    drive = resolved(read_spec(CONFIGS / "drive.toml"))
    spec = make_spec(drive | {"drive": RUN_DOWN | {"cut_off": 0.1}, "requirements": {}})
    steps = explain("heat", spec)[0].steps
    told = [(step.function, step.at) for step in steps]
    assert len(told) == len(set(told))
    assert {step.at for step in steps if step.symbol == "q_A"} == {"f_min", "f_cp", "f_max"}


@pytest.mark.parametrize("name", ["drive", "indirect"])
def test_of_a_life_of_slips_the_mean_damage_is_shown_not_its_nodes(name):
    data = resolved(read_spec(CONFIGS / f"{name}.toml"))
    data["fatigue"] |= {"ultimate_strength": 600e6, "endurance_limit": 10e6}
    spec = make_spec(data)
    result, _ = ANALYSES["life"].function(build(spec), model="goodman")
    steps = explain("life", spec, model="goodman")[0].steps
    assert not [step for step in steps if "slip" in (step.at or "")]
    lives = {(step.at, step.setting, step.side): step.value for step in steps if step.symbol == "N_ц"}
    for side, case in (("protected", None), ("protected_forecast", "from f_cp")):
        for method in ("min-friction", "mean-friction"):
            assert lives.get((case, method, None)) == getattr(getattr(result, side), method.replace("-", "_"))


def test_a_check_does_not_explain_the_nodes_of_a_tolerance_study():
    steps = explain("check", read_spec(CONFIGS / "tolerance.toml"))[0].steps
    assert steps
    assert not [step for step in steps if "f_2 = " in (step.at or "")]


@pytest.mark.parametrize("command", ["torque", "accuracy", "adjust", "synthesize", "life", "check"])
@pytest.mark.parametrize("name", ["indirect", "constant-torque"])
def test_a_quantity_is_defined_before_it_is_used(command, name):
    """Every κ, D, N and F_п2 that a step puts in stands above it, also where κ is taken anew at the sleeve's place."""
    steps = explain(command, read_spec(CONFIGS / f"{name}.toml"))[0].steps
    for symbol in ("κ", "κ₊", "F_п2", "D", "N"):
        users = [n for n, step in enumerate(steps) if symbol in re.split(r"[^\w₊']+", step.formula) and n > 0]
        first = next((n for n, each in enumerate(steps) if each.symbol == symbol), None)
        assert first is None or all(first <= user for user in users), symbol


def test_what_the_returning_sleeve_would_press_with_is_not_shown_where_the_key_holds_it():
    """T_ret at f_max and the mean takes the force that f_max left; κ₊ counts at f_min alone."""
    data = resolved(read_spec(CONFIGS / "indirect.toml"))
    data |= {"friction": {"min": 0.15, "max": 0.5}, "adjustment": {"method": "min-friction", "margin": 1.3}}
    data["friction_group"] = {"pairs": 6, "mean_radius": 0.085}
    data["closing_spring"] = {"force": 3200.0, "stiffness": 250e3}
    data["control_spring"] = {"stiffness": 120e3}
    data["control_unit"] |= {"gain": 1.6, "hub_diameter": 0.06, "key_friction": 0.12}
    steps = explain("torque", make_spec(data))[0].steps
    returning = {(step.symbol, step.at) for step in steps if (step.at or "").endswith("returning")}
    assert {at for _, at in returning} == {"f_min, returning"}
    held = next(step for step in steps if (step.symbol, step.at) == ("T_ret", "f_cp"))
    pressed = next(step for step in steps if (step.symbol, step.at) == ("N", "f_max"))
    assert held.value == pytest.approx(pressed.value * 0.085 * 6 * 0.325)


@pytest.mark.parametrize("name", ["unlike-materials", "fokin2011-fig2"])
def test_a_direct_clutch_has_no_key_that_holds_anything(name):
    """Its f_1 and f_2 at one end of their ranges are one case, not a friction that falls after another."""
    steps = explain("torque", read_spec(CONFIGS / f"{name}.toml"))[0].steps
    assert [step.at for step in steps if step.symbol == "T_1"] == ["f_min", "f_cp", "f_max"]
    assert not [step.at for step in steps if "after" in (step.at or "")]


def test_settings_and_sides_are_told_apart(afmcalc):
    heads = [line.partition(": ")[0] for line in afmcalc("explain", "life").out.splitlines() if line.startswith("N_ц")]
    assert len(heads) == len(set(heads)) == 12
    for words in ("set at f_min", "set at mean f", "unprotected side", "from f_cp"):
        assert any(words in head for head in heads)
    assert "set at" not in afmcalc("explain", "torque").out


def test_the_search_for_a_gain_that_can_be_cut_is_not_explained(afmcalc):
    """Not the thousand steps of the gains that are tried."""
    wide = ["--set", "control_unit.edge_clearance=4"]
    told = afmcalc("explain", "synthesize", CONFIGS / "constant-torque.toml", *wide, "--json").json
    assert "wall-undercut" in {each["code"] for each in told["findings"]}
    assert len(told["result"]["steps"]) < 70


def test_a_special_quantity_goes_by_its_symbol_where_it_is_used(afmcalc):
    """D' is no D, C(x) no C, T' no T, τ_m no τ; c is not two things."""
    curved = afmcalc("explain", "accuracy", CONFIGS / "constant-torque.toml").out
    assert "N = min(F_п, (F_п·c_2 + F_п2·c_1)/D')" in curved
    life = afmcalc("explain", "life").out
    assert "τ = T'/W_p" in life
    assert "N_ц = N_0·(τ_limb/τ_m)^m_τ" in life
    heat = afmcalc("explain", "heat", CONFIGS / "drive.toml", "--set", "closing_spring.stiffness=20 N/mm").out
    assert "= m·c·λ/(α A_c)" in heat
    assert "= c_п·z/F" in heat


@pytest.mark.parametrize("name", ["default", "drive", "indirect", "constant-torque", "all-driving", "unlike-materials"])
def test_no_symbol_stands_for_quantities_of_different_units(name):
    spec = read_spec(CONFIGS / f"{name}.toml", ["drive.motor_inertia=0.2"] if name == "drive" else [])
    clutch = build(spec)
    for command in EXPLAINED:
        if not ANALYSES[command].applies(clutch):
            continue
        own = noting(spec)
        ANALYSES[command].function(own)
        units = {}
        for step in shown(steps_of(own)):
            equation = equation_of(step.name, step.law)
            for symbol, unit, _ in (*equation.arguments.values(), equation.result):
                units.setdefault(symbol, set()).add(unit)
        assert not {symbol: own for symbol, own in units.items() if len(own) > 1}


def test_a_number_with_its_unit_is_raised_as_a_whole_in_a_report():
    """π ((0.12 m)² − (0.08 m)²), not π (0.12 m² − 0.08 m²)."""
    area = equations()["heat.friction_area"]
    values = {"inner_radius": 0.08, "outer_radius": 0.12, "pi": 3.14159}
    terms = {name: area.arguments[name] for name in values}
    text = FormulaText(
        area.function, {n: t.symbol for n, t in terms.items()}, values, {n: t.unit for n, t in terms.items()}
    )
    for line in (False, True):
        assert text.latex_with_numbers(line=line).count("m}") == 2
        assert re.search(r"\(0\.12.{0,12}m\}.{0,7}\)\^\{2\}", text.latex_with_numbers(line=line))


@pytest.mark.parametrize("force", [2500, 5500, 9000])
def test_accuracy_of_springs_as_made_has_a_step(force):
    spec = read_spec("example:indirect", [f"control_spring.force={force}"])
    found, _ = explain("accuracy", spec)
    values = {step.symbol: step.value for step in found.steps if step.at is None}
    assert values["K_т"] == pytest.approx(accuracy(build(spec))[0].accuracy_factor, rel=1e-12)
