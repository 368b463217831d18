"""What is shown in SI is what JSON has; a stream without our letters gets them spelled, in columns."""

import json
import re
from collections import Counter

import pytest
from conftest import CONFIGS

from afmcalc.analysis.registry import ANALYSES
from afmcalc.messages import fitting
from afmcalc.render.symbols import latin_symbols, native
from afmcalc.render.units import display, display_unit, shown_in
from afmcalc.result import Result, shown_as
from afmcalc.spec.fields import Block
from afmcalc.spec.keys import keys

ASKED = {
    "torque": "indirect", "synthesize": "indirect", "accuracy": "unlike-materials", "adjust": "all-driving",
    "life": "default",
}  # fmt: skip


def numbers(value):
    """Every number of a JSON value."""
    if isinstance(value, dict | list):
        for each in value.values() if isinstance(value, dict) else value:
            yield from numbers(each)
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield value


@pytest.mark.parametrize("command", ASKED)
def test_every_number_shown_in_si_is_one_of_the_result(command, answered):
    path = CONFIGS / f"{ASKED[command]}.toml"
    known = list(numbers(answered(command, path, "--json").json["result"]))
    table = answered(command, path, "--units", "si").out.partition("\nwarning:")[0].partition("\ninfo:")[0]
    words = [cell for line in table.splitlines()[3:] for cell in re.split(r"\s{2,}", line)]
    shown = [float(word) for word in words if re.fullmatch(r"-?[\d.]+(e[+-]\d+)?", word)]
    assert len(shown) >= 4
    assert all(any(abs(each - value) <= 1e-4 * abs(value) for value in known) for each in shown)
    # a ball is ordered by its millimetres
    assert not re.search(r"\b(kN|mm|MPa|deg|N/mm)\b", re.sub(r"ball \S+ mm, ISO", "", table))
    assert answered(command, path).out == answered(command, path, "--units", "engineer").out


def test_units_hold_until_the_end_of_the_block():
    def shown():
        return display(0.1, "m"), display_unit("m"), display(300.0, "K abs"), display_unit("K abs")

    with shown_in("si"):
        assert shown() == ("0.1", "m", "300", "K")
        with shown_in("engineer"):
            assert shown() == ("100", "mm", "26.85", "°C")
        assert shown() == ("0.1", "m", "300", "K")
    assert shown() == ("100", "mm", "26.85", "°C")


@pytest.mark.parametrize("command", ["torque", "synthesize", "explain torque"])
def test_an_ascii_stream_gets_letters_and_columns(command, answered):
    asked = *command.split(), CONFIGS / f"{ASKED.get(command, 'default')}.toml", "--quiet"
    whole, spelled = answered(*asked), answered(*asked, encoding="ascii")
    assert spelled.out.isascii()
    assert "\\u" not in spelled.out
    assert "T_n" in spelled.out or "T_н" not in whole.out
    assert len(spelled.out.splitlines()) == len(whole.out.splitlines())
    if header := next((line for line in spelled.out.splitlines() if line.startswith("Symbol")), ""):
        at = header.index("Quantity")
        table = spelled.out.split(header)[1].split("\n\n")[0].splitlines()[1:]
        assert all(line[at - 2 : at] == "  " and line[at] != " " for line in table)


def test_json_for_an_ascii_stream_says_the_same(answered):
    arguments = "torque", CONFIGS / "default.toml", "--json", "--set", 'name="Муфта 😀 ½"'
    whole, spelled = answered(*arguments), answered(*arguments, encoding="ascii")
    assert spelled.out.isascii()
    assert json.loads(spelled.out) == json.loads(whole.out)


def symbols():
    """Symbol of every field of a result, of every key of a spec and of requirements."""
    assert all(analysis.result_class for analysis in ANALYSES.values())  # imports them

    def classes(base):
        for each in base.__subclasses__():
            yield from (each, *classes(each))

    for field in (field for each in (*classes(Result), *classes(Block)) for field in each.model_fields.values()):
        more = field.json_schema_extra if isinstance(field.json_schema_extra, dict) else {}  # of a spec
        yield shown_as(field).symbol or more.get("symbol")
    yield from (key.symbol for key in keys().values())


def test_no_two_symbols_are_spelled_alike():
    """F_п, the spring's, and F_p, the release force, stand in one table; in ASCII and in Latin letters."""
    known = set(filter(None, symbols()))
    assert {"F_п", "F_п2", "F_p", "T_п", "K_т,п", "β_н"} <= known
    spelled = {symbol: fitting(symbol, "ascii") for symbol in known}
    assert len(set(spelled.values())) == len(known), Counter(spelled.values()).most_common(3)
    assert (spelled["F_п"], spelled["F_п2"], spelled["F_p"]) == ("F_sp", "F_sp2", "F_p")
    with latin_symbols():
        latin = {native(symbol) for symbol in known}
    assert len(latin) == len(known)
    assert not [symbol for symbol in latin if re.search("[а-яА-Я]", symbol)]
