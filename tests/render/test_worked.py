"""Every number of the handbook is calculated again from what stands on the page, or from a closed form written here."""

import math
import re

import pytest

from afmcalc.analysis.handbook import handbook
from afmcalc.render.symbols import value_latex
from afmcalc.render.units import measured

SHOWN = {
    "kN": 1e3,
    "kJ": 1e3,
    "mm": 1e-3,
    "MPa": 1e6,
    "N/mm": 1e3,
    "W/mm²": 1e6,
    "J/mm²": 1e6,
    "1/mm": 1e3,
    "cm³": 1e-6,
    "N²/mm²": 1e6,
}
"""Units of the engineer that values are shown in; every other one is SI."""
SI = {"", "N", "m", "m²", "K", "s", "J", "N·m", "1/s"}
NUMBER = re.compile(r"(\d+(?:\.\d+)?)(?:\\cdot 10\^\{(-?\d+)\})?(?:\\,\\text\{([^}]*)\})?")
VALUE = re.compile(r"(-?\d+(?:\.\d+)?)(?: \\cdot 10\^\{(-?\d+)\})?(?:\\,\\text\{([^}]*)\})?")
DIGITS = 5


def half_digit(value: float) -> float:
    """Half a unit of the fifth digit, to which all numbers are shown."""
    return 0.5 * 10.0 ** (math.floor(math.log10(abs(value))) + 1 - DIGITS) if value else 0.0


def arithmetic(latex: str) -> tuple[str, list[float], list[float]]:
    """Formula with numbers as Python arithmetic on ``n``, those numbers, and by how much each may be off."""
    numbers, slack = [], []

    def noted(match: re.Match[str]) -> str:
        text, power, unit = match.groups()
        numbers.append(float(text) * 10.0 ** int(power or 0))
        counted = unit is None and power is None and "." not in text
        slack.append(0.0 if counted else half_digit(numbers[-1]))
        return f" n[{len(numbers) - 1}] "

    text, before = NUMBER.sub(noted, latex), ""
    text = text.replace(r"\left(", "(").replace(r"\right)", ")").replace(r"\cdot", "*")
    while text != before:
        before = text
        text = re.sub(r"\\frac\{([^{}]*)\}\{([^{}]*)\}", r"((\1)/(\2))", text)
        text = re.sub(r"\\sqrt\{([^{}]*)\}", r"((\1)**(1/2))", text)
        text = re.sub(r"\^\{([^{}]*)\}", r"**(\1)", text)
    assert re.fullmatch(r"(?:n\[\d+\]|[-+*/() ]|\b[12]\b)+", text), latex
    return text.strip(), numbers, slack


def shown_value(latex: str) -> float:
    """Value that the page shows, SI."""
    text, power, unit = VALUE.fullmatch(latex).groups()
    assert (unit or "") in SHOWN.keys() | SI, unit
    return float(text) * 10.0 ** int(power or 0) * SHOWN.get(unit, 1.0)


def evaluated(latex: str) -> tuple[float, float]:
    """Value of a formula with numbers, and what the digits that are not shown may change of it."""
    text, numbers, slack = arithmetic(latex)

    def value(n: list[float]) -> float:
        return eval(text, {"__builtins__": {}}, {"n": n})  # noqa: S307 only brackets, signs and numbers

    middle, moved = value(numbers), 0.0
    for place, by in enumerate(slack):
        moved += max(
            abs(value([*numbers[:place], numbers[place] + side, *numbers[place + 1 :]]) - middle) for side in (by, -by)
        )
    return middle, moved


@pytest.fixture(scope="module")
def book():
    return handbook("en")


def test_every_worked_formula_gives_its_value(book):
    """The right side is arithmetic on the numbers that stand there; it gives the value to the digits shown."""
    worked = {name: entry for name, entry in book.formulas.items() if entry.worked}
    assert len(worked) >= 90
    loose = []
    for name, entry in worked.items():
        right = entry.worked.partition(" = ")[2]
        shown = shown_value(value_latex(measured(entry.value, entry.equation.result.unit)))
        value, moved = evaluated(right)
        assert abs(value - shown) <= moved + half_digit(shown) * (1 + 1e-9) + 1e-15, (name, right, shown, value)
        if moved > 1e-3 * abs(shown):
            loose.append(name)
    # a small difference of rounded numbers says less
    assert len(loose) <= 3, loose


def test_a_wrong_digit_is_seen():
    value, moved = evaluated(r"\frac{2000\,\text{N} \cdot 0.5 \cdot 7 \cdot 0.1}{1 + 0.5 \cdot 7 \cdot 0.1}")
    assert value == pytest.approx(700 / 1.35, rel=1e-12)
    assert abs(value - shown_value(r"0.51852\,\text{kN}")) <= moved + half_digit(518.52)
    assert abs(value - shown_value(r"0.51952\,\text{kN}")) > moved + half_digit(519.52)
    cubed, _ = evaluated(r"- \left(\frac{1012.7\,\text{N}}{4\cdot 10^{3}\,\text{N}}\right)^{\frac{1}{3}} + 2")
    assert cubed == pytest.approx(2 - (1012.7 / 4000) ** (1 / 3))


def peak_of_the_drive(at, friction):
    """Peak in the shaft of example:drive by fixed steps (RK4); ``at``: sliding torque of a friction, N·m.

    Motor side 1.5, driven half 0.01 kg·m², shaft 4 kN·m/rad, ζ 0.03, 30 rad/s, tool stopped within 10 ms; r_s 1.15,
    v_s 0.1 m/s at 0.1 m. The motor has the load before the event, T_н/1.25.
    """
    front, half, stiffness, speed, stopped = 1.5, 0.01, 4000.0, 30.0, 0.01
    damping, motor, step = 2 * 0.03 * math.sqrt(stiffness * half), at(0.1) / 1.25, 5e-6

    def shaft(time, state):
        return stiffness * state[2] + damping * (state[1] - speed * max(0.0, 1 - time / stopped))

    def rates(time, state, slips):
        slip, driven, _ = state
        turned = driven - speed * max(0.0, 1 - time / stopped)
        if not slips:
            return 0.0, (motor - shaft(time, state)) / (front + half), turned
        clutch = at(friction * (1 + 0.15 * math.exp(-0.1 * slip / 0.1)))
        growth = (clutch - shaft(time, state)) / half
        return (motor - clutch) / front - growth, growth, turned

    state, slips, peak = (0.0, speed, motor / stiffness), False, 0.0
    for number in range(round(0.03 / step)):
        time = number * step
        needed = motor - front * (motor - shaft(time, state)) / (front + half)
        slips = state[0] > 0 or needed > at(1.15 * friction)
        first = rates(time, state, slips)
        second = rates(time + step / 2, [a + step / 2 * b for a, b in zip(state, first, strict=True)], slips)
        third = rates(time + step / 2, [a + step / 2 * b for a, b in zip(state, second, strict=True)], slips)
        fourth = rates(time + step, [a + step * b for a, b in zip(state, third, strict=True)], slips)
        weighed = zip(state, first, second, third, fourth, strict=True)
        state = [a + step / 6 * (b + 2 * c + 2 * d + e) for a, b, c, d, e in weighed]
        state[0] = max(state[0], 0.0)
        peak = max(peak, shaft(time + step, state))
    return peak


def direct(z1, z2, gain, f1, f2=None, arm=200.0):
    """F11 (12): F_п R (z_1 f_1 + z_2 f_2)/(1 + C z_2 f_2)."""
    f2 = f1 if f2 is None else f2
    return arm * (z1 * f1 + z2 * f2) / (1 + gain * z2 * f2)


def published(reduced, least=0.1, most=0.8, margin=1.25):
    """S22 (15) mended, (21), (23) for f_max: A."""
    v, u = reduced * most, reduced * least
    return (margin * v * (1 + u) + (1 - v * v) * least / most) / (margin * (1 + u))


def indirect_accuracy(f, at_set, kappa, c1, c2, z=8):
    """S21 (15) mended, with the sleeve at its stop below the setting."""
    stiff = [c1 + c2 + z * c1 * friction * kappa for friction in (at_set, f[1])]
    return f[1] * stiff[0] * (1 + z * kappa * f[0]) / (f[0] * stiff[1] * (1 + z * kappa * at_set))


def off_the_stop(friction, kappa=0.96):
    """N of example:indirect, S21 (11): F_п2 = 2 kN·(1 + 2.4·0.96) = 6608 N; with κ₊ = 1.04 as the sleeve returns."""
    return (2000 * 2e5 + 6608 * 4e5) / (6e5 + 8 * friction * 4e5 * kappa)


def in_s19(friction):
    """S19 fig. 2, z 12, C 1.6: f z/(1 + 11 C f)."""
    return 12 * friction / (1 + 17.6 * friction)


ENDS = (0.1, 0.8)
BASE = [direct(1, 7, 0.5, friction) for friction in ENDS]
CONVEYOR = [direct(1, 3, 1.6, friction, arm=3805 * 0.065) for friction in (0.25, 0.45)]
CLOSED = {
    "default torque.closing_force": 2000.0,
    "default torque.gain": 0.5,
    "default torque.reduced_gain": 7 * 0.5,
    "default accuracy.gain_limit": 1 / 0.8,
    "default accuracy.accuracy_factor": BASE[1] / BASE[0],
    "default accuracy.conventional_accuracy_factor": 8.0,
    "default adjust.min_friction.torque.mean": direct(1, 7, 0.5, 0.3),
    "machine-clutch torque.torque_asked_for": 1.25 * 5500 / (965 * math.pi / 30),
    "machine-clutch torque.starting_torque": 2.2 * 5500 / (965 * math.pi / 30),
    "machine-clutch torque.torque.min": 2153 * 0.0675 * 8 * 0.15 / (1 + 1 * 7 * 0.15),
    "conveyor-clutch torque.nominal_torque": CONVEYOR[0],
    "conveyor-clutch simulate.sliding_torque.max": CONVEYOR[1],
    "conveyor-clutch torque.accuracy_factor": CONVEYOR[1] / CONVEYOR[0],
    "drilling-head-clutch torque.nominal_torque": direct(1, 11, 1.6, 0.05, arm=14160 * 0.07),
    "wood-chipper-clutch simulate.sliding_torque.max": direct(1, 3, 1.0, 0.45, arm=11330 * 0.14),
    "fokin2011-fig2 accuracy.gain_limit": 1 / (2 * 0.6),
    "fokin2011-fig2 accuracy.accuracy_factor": direct(2, 6, 1.25, 0.6, 0.9) / direct(2, 6, 1.25, 0.1, 0.1033),
    "shishkarev2019-fig2 adjust.pairs_threshold": (1 / 0.15 - 1.25 / 0.33) / (0.25 * 1.6) + 1,
    "shishkarev2019-fig2 adjust.min_friction.scatter": 200 * (in_s19(0.625) / in_s19(0.15) - 1),
    "shishkarev2019-fig2 adjust.mean_friction.scatter": 250 * (in_s19(0.625) - in_s19(0.15)) / in_s19(0.33),
    "indirect accuracy.accuracy_factor": indirect_accuracy(ENDS, 0.3, 0.96, 400, 200),
    "indirect accuracy.accuracy_factor_hysteresis": 0.64 * off_the_stop(0.8) / (0.08 * 6608 / (1 + 0.8 * 1.04)),
    "indirect accuracy.gain_threshold": 2 * 0.1 * 0.01 / 0.05,
    "indirect torque.closing_force": 2000.0,
    "indirect torque.control_force": 2000 * (1 + 2.4 * 0.96),
    "indirect torque.gain": 1.0,
    "indirect torque.nominal_torque": 0.8 * 0.3 * 2000 / 1.75,
    "indirect torque.pack_force_at_rest": 2000 * (1 + 2.4 * 0.96),
    "shishkarev2021 accuracy.accuracy_factor": indirect_accuracy(ENDS, 0.1, 0.4, 20, 10),
    "shishkarev2022-fig3 overload.accuracy_factor_expected": 8 * 1.16 / 2.28,
    "shishkarev2022-fig3 overload.accuracy_factor_actual": published(1.6) * 8 * 1.16 / 2.28,
    "all-driving overload.accuracy_factor_expected": 2.4,
    "all-driving overload.accuracy_factor_actual": published(5.0) * 2.4,
    "shishkarev2022-fig4 overload.actuation_factor.max": published(1.6),
    "constant-torque accuracy.accuracy_factor": 1.0,
    "default torque.onset_torque.min": 1 * 0.1 * 0.1 * 2000,
    # n 1, p 1.2, m 6, z_1 1, z_2 6, C 1.25: (18) and (22) as mended
    "unlike-materials accuracy.slope_in_ratio_max": 6 * 6 * (1 + 7.5 * 0.12) * (1 - 1.25 * 0.6) / (8.2 * 5.5**2),
    "unlike-materials accuracy.slope_in_ratio_min": 6 * 6 * 7 * (1.25 * 0.1 - 1) / (8.2**2 * 5.5),
}
CLOSED |= {
    f"{example} torque.friction.{end}": friction
    for example in ("default", "indirect")
    for end, friction in (("min", 0.1), ("mean", 0.3), ("max", 0.8))
}
# F_p and N are 2 kN·3.5 f and 2 kN over 1 + 3.5 f
CLOSED |= {
    f"default torque.{name}.{end}": force / (1 + 3.5 * friction)
    for end, friction in (("min", 0.1), ("mean", 0.3), ("max", 0.8))
    for name, force in (("release_force", 7000 * friction), ("normal_force", 2000), ("torque", 1600 * friction))
}
# at its stop at 0.1 and 0.3; falling from 0.8 the sleeve returns below 0.8·0.96/1.04 and is seated at 0.3·0.96/1.04
for _end, _friction, _pressed, _back in (
    ("min", 0.1, 6608 / (1 + 0.8 * 0.96), 6608 / (1 + 0.8 * 1.04)),
    ("mean", 0.3, 2000.0, off_the_stop(0.3, 1.04)),
    ("max", 0.8, off_the_stop(0.8), off_the_stop(0.8)),
):
    CLOSED |= {
        f"indirect torque.normal_force.{_end}": _pressed,
        f"indirect torque.torque.{_end}": 0.8 * _friction * _pressed,
        f"indirect torque.torque_returning.{_end}": 0.8 * _friction * _back,
        f"indirect torque.travel.{_end}": max(2000 - _pressed, 0.0) / 4e5,
    }
"""What stands in ``{value …}`` → the same by a closed form, SI."""


def test_every_number_in_the_text_is_that_of_a_closed_form(book):
    simulated = {
        "drive simulate.peak_torque.max": peak_of_the_drive(lambda friction: direct(1, 7, 0.5, friction), 0.8),
        "drive simulate.peak_torque_conventional.max": peak_of_the_drive(lambda f: BASE[0] * f / 0.1, 0.8),
    }
    wanted = {name: (value, 1e-9) for name, value in CLOSED.items()}
    wanted |= {name: (value, 1e-4) for name, value in simulated.items()}
    assert book.values.keys() == wanted.keys(), "a number without a closed form, or one that no chapter shows any more"
    for name, (value, to) in wanted.items():
        assert book.values[name][0] == pytest.approx(value, rel=to), name
