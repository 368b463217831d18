"""What is shown in SI is what JSON has; a stream without our letters gets them spelled, in columns."""

import json
import pkgutil
import re
from collections import Counter
from importlib import import_module

import pytest
from conftest import CONFIGS

import afmcalc as afmcalc_package
from afmcalc.messages import fitting
from afmcalc.render.units import display, display_unit, shown_in
from afmcalc.result import Result, shown_as
from afmcalc.spec.fields import Block
from afmcalc.spec.keys import keys

ASKED = [
    ("torque", "indirect"), ("synthesize", "indirect"), ("accuracy", "unlike-materials"), ("adjust", "all-driving"),
    ("life", "default"), ("overload", "all-driving"), ("tolerance", "tolerance"), ("explain torque", "default"),
]  # fmt: skip


def numbers(value):
    """Every number of a JSON value."""
    if isinstance(value, dict | list):
        for each in value.values() if isinstance(value, dict) else value:
            yield from numbers(each)
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield value


@pytest.mark.parametrize(("command", "name"), ASKED[:-2])
def test_every_number_shown_in_si_is_one_of_the_result(command, name, afmcalc):
    path = CONFIGS / f"{name}.toml"
    known = list(numbers(afmcalc(command, path, "--json").json["result"]))
    table = afmcalc(command, path, "--units", "si").out.partition("\nwarning:")[0].partition("\ninfo:")[0]
    shown = [
        float(cell)
        for line in table.splitlines()[3:]
        for cell in re.split(r"\s{2,}", line)
        if re.fullmatch(r"-?[\d.]+(e[+-]\d+)?", cell)
    ]
    assert len(shown) >= 4
    assert all(any(abs(each - value) <= 1e-4 * abs(value) for value in known) for each in shown)
    # a ball is ordered by its millimetres
    assert not re.search(r"\b(kN|mm|MPa|deg|N/mm)\b", re.sub(r"ball \S+ mm, ISO", "", table))
    assert afmcalc(command, path).out == afmcalc(command, path, "--units", "engineer").out


def test_units_hold_until_the_end_of_the_block():
    with shown_in("si"):
        assert (display(0.1, "m"), display_unit("m"), display(300.0, "K abs"), display_unit("K abs")) == (
            "0.1",
            "m",
            "300",
            "K",
        )
        with shown_in("engineer"):
            assert display(0.1, "m") == "100"
        assert display(0.1, "m") == "0.1"
    assert (display(0.1, "m"), display(300.0, "K abs")) == ("100", "26.85")


@pytest.mark.parametrize(("command", "name"), ASKED)
def test_an_ascii_stream_gets_letters_and_columns(command, name, afmcalc):
    path = CONFIGS / f"{name}.toml"
    whole = afmcalc(*command.split(), path, "--quiet")
    ascii_ = afmcalc(*command.split(), path, "--quiet", encoding="ascii")
    assert ascii_.out.isascii()
    assert "\\u" not in ascii_.out
    assert "T_n" in ascii_.out or "T_н" not in whole.out
    assert len(ascii_.out.splitlines()) == len(whole.out.splitlines())
    header = next(line for line in ascii_.out.splitlines() if line.startswith("Symbol"))
    at = header.index("Quantity")
    table = ascii_.out.split(header)[1].split("\n\n")[0].splitlines()[1:]
    assert all(line[at - 2 : at] == "  " and line[at] != " " for line in table)


def symbols():
    """Symbol of every field of a result, of every key of a spec and of requirements."""
    for module in pkgutil.walk_packages(afmcalc_package.__path__, "afmcalc."):
        if "__main__" not in module.name:
            import_module(module.name)

    def classes(base):
        for each in base.__subclasses__():
            yield from (each, *classes(each))

    for each in (*classes(Result), *classes(Block)):
        for field in each.model_fields.values():
            if symbol := shown_as(field).symbol:
                yield symbol
            elif isinstance(field.json_schema_extra, dict):  # of a spec
                yield from filter(None, [field.json_schema_extra.get("symbol")])
    yield from (key.symbol for key in keys().values() if key.symbol)


def test_no_two_symbols_are_spelled_alike():
    """F_п, the spring's, and F_p, the release force, stand in one table."""
    known = set(symbols())
    assert {"F_п", "F_п2", "F_p", "T_п", "K_т,п", "β_н"} <= known
    spelled = {symbol: fitting(symbol, "ascii") for symbol in known}
    assert len(set(spelled.values())) == len(known), Counter(spelled.values()).most_common(3)
    assert (spelled["F_п"], spelled["F_п2"], spelled["F_p"]) == ("F_sp", "F_sp2", "F_p")


def test_json_for_an_ascii_stream_says_the_same(afmcalc):
    arguments = "torque", CONFIGS / "default.toml", "--json", "--set", 'name="Муфта 😀 ½"'
    whole, ascii_ = afmcalc(*arguments), afmcalc(*arguments, encoding="ascii")
    assert ascii_.out.isascii()
    assert json.loads(ascii_.out) == json.loads(whole.out)
