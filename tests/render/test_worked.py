"""The handbook: its numbers are those of closed forms; every formula is shown, no link is dead, in both languages."""

import math
import re
import tomllib
from pathlib import Path

import pytest
from conftest import CONFIGS, FRAME

import afmcalc
from afmcalc.analysis.handbook_content import commands_of
from afmcalc.analysis.registry import ANALYSES
from afmcalc.equations.catalogue import equations
from afmcalc.messages import language, speaking
from afmcalc.papers.handbook_text import chapter_texts
from afmcalc.papers.register import misprints, register
from afmcalc.render.report.book import render


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
CONVEYOR = 0.45 / 0.25 * (1 + 1.4 * 3 * 0.25) / (1 + 1.4 * 3 * 0.45)
"""Accuracy factor of the conveyor's clutch, one material."""
CHIPPER = 906.5 * 1.8 * (1 + 1.25 * 5 * 0.25) / (1 + 1.25 * 5 * 0.45)


def rated(power, speed, geared=1.0):
    """Rated torque of a motor, W and rpm, behind its gear."""
    return power / (speed * math.pi / 30) * geared


GIVEN = {
    "default torque": {
        "closing_force": 2000.0, "gain": 0.5, "reduced_gain": 7 * 0.5, "onset_torque.min": 1 * 0.1 * 0.1 * 2000,
    },
    "default accuracy": {
        "gain_limit": 1 / 0.8, "accuracy_factor": BASE[1] / BASE[0], "conventional_accuracy_factor": 8.0,
    },
    "default adjust": {"min_friction.torque.mean": direct(1, 7, 0.5, 0.3)},
    "machine-clutch torque": {
        "torque_asked_for": 1.25 * 5500 / (965 * math.pi / 30), "starting_torque": 2.2 * 5500 / (965 * math.pi / 30),
        "torque.min": 1834 * 0.0675 * 10 * 0.15 / (1 + 0.875 * 9 * 0.15),
    },
    "conveyor-clutch torque": {
        "nominal_torque": 112.5, "accuracy_factor": CONVEYOR, "torque_range.high": 112.5 * CONVEYOR,
        "trip_ratio_min": 112.5 / rated(11e3, 1460), "trip_ratio_max": 112.5 * CONVEYOR / rated(11e3, 1460),
    },
    "drilling-head-clutch torque": {
        "nominal_torque": 316.3, "trip_ratio_min": 316.3 / rated(7.5e3, 1435, 4 * 0.96),
        "trip_ratio_max": 316.3 * 1.6 * (1 + 1.8 * 11 * 0.05) / (1 + 1.8 * 11 * 0.08) / rated(7.5e3, 1435, 4 * 0.96),
    },
    "wood-chipper-clutch torque": {
        "torque_range.high": CHIPPER, "trip_ratio_min": 906.5 / rated(37e3, 1475, 1.475 * 0.95),
        "trip_ratio_max": CHIPPER / rated(37e3, 1475, 1.475 * 0.95),
    },
    "fokin2011-fig2 accuracy": {
        "gain_limit": 1 / (2 * 0.6), "accuracy_factor": direct(2, 6, 1.25, 0.6, 0.9) / direct(2, 6, 1.25, 0.1, 0.1033),
    },
    "shishkarev2019-fig2 adjust": {
        "pairs_threshold": (1 / 0.15 - 1.25 / 0.33) / (0.25 * 1.6) + 1,
        "min_friction.scatter": 200 * (in_s19(0.625) / in_s19(0.15) - 1),
        "mean_friction.scatter": 250 * (in_s19(0.625) - in_s19(0.15)) / in_s19(0.33),
    },
    "indirect accuracy": {
        "accuracy_factor": indirect_accuracy(ENDS, 0.3, 0.96, 400, 200),
        "accuracy_factor_hysteresis": 0.64 * off_the_stop(0.8) / (0.08 * 6608 / (1 + 0.8 * 1.04)),
        "gain_threshold": 2 * 0.1 * 0.01 / 0.05,
    },
    "indirect torque": {
        "closing_force": 2000.0, "control_force": 2000 * (1 + 2.4 * 0.96), "gain": 1.0,
        "nominal_torque": 0.8 * 0.3 * 2000 / 1.75, "pack_force_at_rest": 2000 * (1 + 2.4 * 0.96),
    },
    "shishkarev2021 accuracy": {"accuracy_factor": indirect_accuracy(ENDS, 0.1, 0.4, 20, 10)},
    "shishkarev2022-fig3 overload": {
        "accuracy_factor_expected": 8 * 1.16 / 2.28, "accuracy_factor_actual": published(1.6) * 8 * 1.16 / 2.28,
    },
    "default overload": {
        "potential_torque.max": 1280 * (1.25 + 0.25 * 0.35) / (1.25 * 1.35), "potential_torque_bypass_first.max": 1280,
    },
    "all-driving overload": {"accuracy_factor_expected": 2.4, "accuracy_factor_actual": published(5.0) * 2.4},
    "shishkarev2022-fig4 overload": {"actuation_factor.max": published(1.6)},
    "constant-torque accuracy": {"accuracy_factor": 1.0},
    # n 1, p 1.2, m 6, z_1 1, z_2 6, C 1.25: (18) and (22) as mended
    "unlike-materials accuracy": {
        "slope_in_ratio_max": 6 * 6 * (1 + 7.5 * 0.12) * (1 - 1.25 * 0.6) / (8.2 * 5.5**2),
        "slope_in_ratio_min": 6 * 6 * 7 * (1.25 * 0.1 - 1) / (8.2**2 * 5.5),
    },
}  # fmt: skip
CLOSED = {f"{asked}.{name}": value for asked, own in GIVEN.items() for name, value in own.items()}
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
"""Text in ``{value …}`` → value by a closed form, SI."""


@pytest.mark.parametrize("asked", sorted({name.partition(".")[0] for name in CLOSED if "simulate" not in name}))
def test_a_command_gives_what_the_closed_form_does(asked, answered):
    """The command line gives the numbers that the handbook shows."""
    example, command = asked.split()
    result = answered(command, CONFIGS / f"{example}.toml", "--json").json["result"]
    for name, wanted in ((name, value) for name, value in CLOSED.items() if name.partition(".")[0] == asked):
        found = result
        for part in name.split(".")[1:]:
            found = found[part]
        assert found == pytest.approx(wanted, rel=1e-9), name


@pytest.mark.slow
def test_every_number_in_the_text_is_that_of_a_closed_form(book):
    """Each number of a chapter has a closed form here, except peaks of events, and each closed form is shown."""
    found = {name: value for name, (value, _) in book("en").values.items() if "peak_torque" not in name}
    assert found == pytest.approx(CLOSED, rel=1e-9)


PACKAGE = Path(afmcalc.__file__).parent
USES = PACKAGE / "papers" / "handbook" / "uses.toml"
DIRECTIVE = re.compile(r"\{(\w+) ([^{}]+)\}")


def uses():
    """Equation → the commands that calculate it."""
    found = tomllib.loads(USES.read_text(encoding="utf-8"))
    return {name: use["commands"] if isinstance(use, dict) else use for name, use in found.items()}


def test_uses_are_of_equations_and_name_commands():
    for name, commands in uses().items():
        assert name in equations()
        assert {*commands} <= ANALYSES.keys()
        assert commands == sorted(set(commands))


@pytest.mark.slow
def test_every_formula_is_reached_or_says_why_not():
    """A command calculates the function of an entry; an entry without one is covered by others, or says why not."""
    reached = {entry.id: bool(entry.function and commands_of(entry.function)) for entry in register()}
    for entry in register():
        assert entry.not_reached is None or not reached[entry.id], f"{entry.id} is reached"
        assert reached[entry.id] or entry.not_reached or (entry.covered_by and not entry.function), entry.id


def test_each_formula_and_misprint_stands_once():
    """Every formula and misprint of the register is shown once; other laws may be shown, but not twice."""
    shown = DIRECTIVE.findall("".join(chapter_texts("en").values()))
    formulas = [name for key, name in shown if key == "equation"]
    assert len(formulas) == len(set(formulas))
    assert {entry.function for entry in register() if entry.function} <= {*formulas} <= equations().keys()
    assert sorted(name for key, name in shown if key == "misprint") == sorted(entry.id for entry in misprints())


def test_both_languages_have_the_same_parts():
    english, russian = (chapter_texts(language) for language in ("en", "ru"))
    assert english.keys() == russian.keys()
    for own in ((english[number], russian[number]) for number in english):
        for part in (r"^#+ ", r"^\|", r"^```", r"^- "):
            assert len({len(re.findall(part, text, re.MULTILINE)) for text in own}) == 1, (part, own[0][:40])
        assert DIRECTIVE.findall(own[0]) == DIRECTIVE.findall(own[1])
        plain = (DIRECTIVE.sub("", text).replace(",", ".") for text in own)
        first, second = (sorted(re.findall(r"\d+(?:\.\d+)?", text)) for text in plain)
        assert first == second, own[0][:40]


@pytest.mark.slow
def test_every_link_of_the_page_leads_somewhere_in_it(book, monkeypatch):
    """The Russian page has no Latin words of four letters, except in sources, terms, code, formulas and indices."""
    monkeypatch.setattr("afmcalc.render.report.page.inline_svg", lambda sheet: FRAME)
    with speaking(language("ru")):
        page = render(book("ru"))
    ids = re.findall(r'\bid="([^"]+)"', page)
    assert len(ids) == len(set(ids)) > 200
    assert set(re.findall(r'<a [^>]*\bhref="#([^"]*)"', page)) <= set(ids)
    assert not re.search(r'(?:src|href)="(?!#)|@import|url\((?!#)', page)
    assert not re.search(r"\{(?:see|value|equation|misprint|figure|list) ", page)
    page = re.sub(
        r"(?s)<(style|script|code|pre|math)\b.*?</\1>|<section id=\"chapter-16\".*?(?=<section id=\"chapter-17\")",
        " ",
        page,
    )
    page = re.sub(r"example:\S+", " ", re.sub(r"<[^>]*>", " ", page.replace("<sub>", "_")))
    words = {word.strip(".,") for word in re.findall(r"\b[a-zA-Z]{4,}", page)}
    terms = chapter_texts("ru")[1].partition("## Термины")[2]
    sources = " ".join(each.source for each in equations().values())
    names = {*re.findall("[A-Z][a-z]{3,}", sources), "damage", "fatigue", "amplitude", "afmcalc", "Budynas", "Nisbett"}
    names |= {"Carslaw", "Jaeger", "Conduction", "Heat", "Solids"}
    assert words <= names | {*re.findall("[a-z]{4,}", terms)}
