"""A wrong dimension is refused in every key that has one."""

import copy

import pytest
from conftest import several
from hostile import RESOLVED

from afmcalc.errors import SpecError
from afmcalc.spec import make_spec
from afmcalc.spec.fields import keys_below
from afmcalc.spec.keys import keys
from afmcalc.spec.make import validated
from afmcalc.spec.requirements import Requirements

UNITS = {
    "N": "N", "m": "mm", "m^3": "cm^3", "N/m": "N/mm", "N*m": "N*m", "rad": "deg", "Pa": "MPa", "1/(N*m)": "1/(N*m)",
    "s": "s", "kg": "kg", "m^2": "cm^2", "J": "J", "W": "W", "Hz": "Hz", "rad/s": "rpm", "K": "K",
}  # fmt: skip
"""SI unit of a key → how it is written; and some that no key has."""
FIELDS = [("spec", key) for key in keys().values() if key.unit]
FIELDS += [("requirements", key) for key in keys_below(Requirements).values() if key.unit]


def said_of(model, path, value):
    """What is wrong with a value at a path."""
    data = {}
    if model == "spec":
        data = copy.deepcopy(RESOLVED["indirect"] | {"tolerance": RESOLVED["tolerance"]["tolerance"]})
    block = data
    *blocks, last = path.split(".")
    for name in blocks:
        block = block.setdefault(name, {})
    block[last] = value
    try:
        make_spec(data) if model == "spec" else validated(Requirements, data, "x")
    except SpecError as error:
        return {problem.message for problem in error.problems if problem.path == path}
    return set()


@pytest.mark.every(3)
@pytest.mark.parametrize(("model", "key"), FIELDS, ids=lambda each: getattr(each, "path", each))
def test_a_wrong_dimension_is_refused(model, key):
    as_number = said_of(model, key.path, 3)
    wrong = [written for own, written in UNITS.items() if own not in (key.unit, key.unit.removesuffix(" abs"))]
    for unit in wrong[: several(2, None)]:
        assert said_of(model, key.path, f"3 {unit}") - as_number, unit
