"""Rules for the laws of every variant and option before anything is calculated, of each law, and of their stub."""

import ast
import inspect
import itertools
import math
import os
import re
from importlib import import_module
from importlib.resources import files
from inspect import signature
from pathlib import Path

import numpy as np
import pint
import pytest
from random_clutches import random_clutches
from sources import table

from afmcalc.engines import named, selection
from afmcalc.engines.quantities import Laws, Quantities, laws_in
from afmcalc.engines.selection import NAMES, laws_for, quantities_of
from afmcalc.equations.catalogue import equations
from afmcalc.equations.terms import CASES, TERMS, term_of
from afmcalc.equations.wiring import Either, Same
from afmcalc.errors import AfmcalcError
from afmcalc.spec import make_spec, read_spec
from afmcalc.variants import VARIANTS

NAMED = "accuracy adjustment control_unit curved curved_wall direct indirect life machine overload pack pressure unlike"
MODULES = [import_module(f"afmcalc.equations.{name}") for name in NAMED.split()]
KEYS = {name for names in NAMES.values() for name in names.values()} | {"closing_disc", "control_disc", "balls_listed"}
FROM_OUTSIDE = {"risen_load"}
"""Quantity that an analysis gives: a load that has risen."""
KNOWN = table("laws")
ALTERNATIVES, OF_SLEEVE, ASKED_OF = {*KNOWN["alternatives"]}, {*KNOWN["of_sleeve"]}, KNOWN["asked_of"]
OPTIONS = [*KNOWN["options"], *KNOWN["of_sleeve"]]


def combinations():
    """Yield every variant with up to three options that it can have."""
    for variant, count in itertools.product(VARIANTS, range(4)):
        for options in itertools.combinations(OPTIONS, count):
            if (variant == "indirect" or not {*options} & OF_SLEEVE) and (
                variant == "differentiated" or "friction_driving_min" not in options
            ):
                yield variant, options


def laws_of(variant, options, method="min-friction"):
    return laws_for(variant, method, frozenset(options))


def problems(laws, given):
    bound = {name for case in laws.cases.values() for name in case}
    for name, arguments in laws.arguments.items():
        for argument in arguments:
            if not (argument in laws.laws or argument in KEYS | FROM_OUTSIDE | bound or laws.case_of(argument)):
                yield f"{name}: no law, key or case gives {argument}"
        if name in KEYS - ALTERNATIVES:
            yield f"{name}: the key of a spec hides this law"
        try:
            laws.needs(name, given)
        except RecursionError as error:
            yield f"cycle {error}"
    for name in laws.names:
        if name not in TERMS and laws.case_of(name) is None:
            yield f"{name} has no term"
    for case, targets in laws.cases.items():
        if case not in CASES:
            yield f"case {case} has no words"
        for target in targets.values():
            if target not in laws.laws and target not in KEYS | {"nothing"} and laws.case_of(target) is None:
                yield f"case {case}: nothing gives {target}"


def collisions(laws, given):
    """Yield a law that takes a name set by one case, and a source of this name that another case sets."""
    for (one, first), (two, second) in itertools.permutations(laws.cases.items(), 2):
        asked = laws.needs(ASKED_OF[one], given.union(first)) if one in ASKED_OF else laws.laws
        for name in first.keys() - second.keys():
            source = laws.needs(name, given) & second.keys()
            for law, arguments in laws.arguments.items():
                if law in asked and name in arguments and source & {*arguments}:
                    yield f"{law} takes {name} of the case {one} and {sorted(source)} of {two}, from which it follows"


@pytest.mark.parametrize("variant", VARIANTS)
def test_laws_are_closed_without_cycles_and_have_terms(variant):
    for own, options in combinations():
        if own == variant and len(options) < 2:
            given = frozenset({*options, "closing_force"})
            assert [*problems(laws_of(variant, options), given)] == [], options


@pytest.mark.slow
@pytest.mark.parametrize("variant", VARIANTS)
def test_laws_of_all_options(variant):
    for (own, options), method in zip(combinations(), itertools.cycle(selection.METHODS), strict=False):
        if own == variant:
            given = frozenset({*options, "closing_force"})
            laws = laws_of(variant, options, method)
            assert [*problems(laws, given), *collisions(laws, given)] == [], options


@pytest.mark.parametrize("variant", VARIANTS)
def test_cases_do_not_collide(variant):
    for options in ((), ("friction_driving_min",)) if variant == "differentiated" else ((), ("wall_angle",)):
        assert [*collisions(laws_of(variant, options), frozenset({*options, "closing_force"}))] == []


def test_what_is_set_last_displaces_what_follows_from_it():
    clutch = quantities_of(read_spec("example:default"))
    corner = clutch.at("f_min_max")
    assert corner.torque != clutch.at("f_max").torque
    assert corner.at("f_max").torque == corner["torque_at_f_max"] == clutch["torque_at_f_max"]
    assert clutch.at("f_max").at("f_min_max").torque == corner.torque


# each law


def functions():
    found = {}
    for module in MODULES:
        tables = (part for name, part in vars(module).items() if name.isupper() and isinstance(part, dict))
        for part in (laws_in(module), *tables):
            found |= {f"{module.__name__}.{name}": (name, law) for name, law in part.items() if callable(law)}
    return found


LAWS = functions()
UNITS = pint.UnitRegistry()
ALONG = {"mean_damage", "contact_force", "friction_along_wall", "ball_diameter_standard"}
"""Quantities whose laws work on arrays or lists."""


def test_a_law_is_short_and_says_its_source():
    for name, (_, law) in LAWS.items():
        text = inspect.getdoc(law)
        assert text.count("Source: ") == 1, name
        assert not re.search(r"``|[a-z]{3,}[._][a-z]{3,}", text.partition("Source: ")[2].partition("Validity: ")[0]), (
            name
        )
        assert text.partition("Source: ")[0].rstrip().endswith("."), name
        body = ast.parse(inspect.getsource(law)).body[0]
        assert body.end_lineno - body.body[0].end_lineno <= 10, name
        assert not body.args.defaults, name
        assert body.args.kwarg is None, name
        assert body.body[0].lineno <= 4, name  # the signature stands on two lines at most, its brackets on further ones


def unit(name):
    return term_of(name).unit.replace("^", "**")


def test_dimension_is_that_of_its_term():
    for name, (quantity, law) in LAWS.items():
        if "slips" in name or "bend" in name or quantity in ALONG or not unit(quantity):
            continue
        arguments = {}
        for place, argument in enumerate(law.__code__.co_varnames[: law.__code__.co_argcount]):
            value, own = 0.31 + 0.17 * place, unit(argument)
            arguments[argument] = value if own in ("1", "") else UNITS.Quantity(value, own)
        value = law(**arguments)
        found = value if isinstance(value, UNITS.Quantity) else UNITS.Quantity(value, "")
        expected = UNITS.Quantity(1, "" if unit(quantity) == "1" else unit(quantity))
        assert dict(found.dimensionality) == pytest.approx(dict(expected.dimensionality)), name


def test_terms_are_used():
    used = set().union(*(laws_of(*each).names for each in combinations())) | KEYS
    assert sorted(name for name in TERMS if name not in used) == []
    assert sorted(CASES.keys() - {case for each in combinations() for case in laws_of(*each).cases}) == []


def test_a_term_of_one_module_is_used_there():
    table = files("afmcalc.equations").joinpath("terms.txt").read_text(encoding="utf-8")
    names = [name for row in table.splitlines() for name in row.partition("|")[0].split()]
    assert len(names) == len(set(names))
    used = set()
    for law in equations().values():
        module, own = law.name.split(".")[0], [*signature(law.function).parameters]
        used |= {law.name, *(f"{module}.{name}" for name in own), *(f"{law.name}.{name}" for name in own)}
    assert {name for name in names if "." in name} <= used
    assert all(term.meaning for each in equations().values() for term in each.arguments.values())


# quantities


@pytest.mark.parametrize(
    "variant", ["default", "unlike-materials", "all-driving", "conventional", "indirect", "constant-torque"]
)
def test_arrays_equal_numbers(variant):
    clutch = quantities_of(read_spec(f"example:{variant}"))
    names = [name for name in clutch.names() if name not in ("pairs_threshold", "scatter_ratio", "bend_of_path")]
    names = [name for name in names if isinstance(clutch[name], float) and math.isfinite(clutch[name])]
    varied = {
        name: value
        for name, value in clutch.given.items()
        if name in ("pairs", "closing_force", "gain", "closing_stiffness")
    }
    many = clutch.at(**{name: value * np.array([1.0, 1.25]) for name, value in varied.items()})
    one = clutch.at(**{name: value * 1.25 for name, value in varied.items()})
    with np.errstate(all="ignore"):
        for name in names:
            values = np.broadcast_to(many[name], 2)
            assert values[0] == pytest.approx(clutch[name], rel=1e-12, abs=1e-300, nan_ok=True), name
            assert values[1] == pytest.approx(one[name], rel=1e-12, abs=1e-12, nan_ok=True), name


def test_scopes_of_values_are_not_kept():
    clutch = quantities_of(read_spec("example:default"))
    _ = clutch.at("f_max").torque
    kept = len(clutch._family)
    for friction in np.linspace(0.1, 0.8, 50):
        _ = clutch.at(friction=float(friction)).torque
    assert len(clutch._family) == kept


def test_steps_are_noted_once_each_in_its_case():
    clutch = quantities_of(read_spec("example:indirect"), noted=True)
    _ = clutch["accuracy_factor_hysteresis"]
    steps = [(step.name, step.case) for step in clutch.steps]
    assert len({*steps}) == len(steps)
    assert ("torque", "f_max") in steps
    step = next(step for step in clutch.steps if (step.name, step.case) == ("normal_force_seated", "f_min returning"))
    assert step.arguments["friction"] == "friction_min"
    assert step.arguments["net_gain_acting"] == "net_gain_returning"
    assert step.law(**step.values) == step.value


def test_given_wins_and_a_part_replaces():
    def double(half):
        return 2 * half

    laws = Laws({"double": double, "half": 3.0, "twice": Same("double"), "any": Either("half", "twice", "half")})
    assert Quantities(laws, {})["any"] == 6.0
    assert Quantities(laws, {"half": 4.0})["twice"] == 8.0
    assert Quantities(laws, {"double": 1.0})["twice"] == 1.0
    assert Quantities(Laws({"double": double}, {"double": Same("half")}), {"half": 4.0})["double"] == 4.0


def test_a_spec_gives_every_name_of_its_keys():
    for data in random_clutches(30, 3):
        try:
            spec = make_spec(data)
        except AfmcalcError:
            continue
        clutch = quantities_of(spec)
        assert clutch.given.keys() <= KEYS
        assert clutch["torque_max"] >= clutch["torque_min"] > 0


HEAD = '''# ruff: noqa: E501
"""Quantities by name. AFMCALC_UPDATE=1 pytest tests/engines/test_laws.py writes this file from equations/terms.txt."""

from typing import Any

from ..equations.arrays import Values

class Named:
'''


def test_the_stub_has_every_quantity():
    rows = []
    for name, term in TERMS.items():
        kind, symbol = ("Values", f"{term.symbol}, {term.unit}: ") if term.unit else ("Any", "")
        rows.append(f"    {name}: {kind}  # {symbol}{term.meaning}\n")
    path, text = Path(named.__file__).with_suffix(".pyi"), HEAD + "".join(rows)
    if os.environ.get("AFMCALC_UPDATE"):
        path.write_text(text, encoding="utf-8")
    assert text == path.read_text(encoding="utf-8"), "a quantity has changed; AFMCALC_UPDATE=1 writes the stub"
