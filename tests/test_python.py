"""The package from Python."""

import doctest
import importlib
import pkgutil

import pytest

import afmcalc


@pytest.mark.parametrize(
    "name", [m.name for m in pkgutil.walk_packages(afmcalc.__path__, "afmcalc.") if not m.name.endswith("__main__")]
)
def test_doctests(name):
    results = doctest.testmod(importlib.import_module(name))
    assert results.failed == 0


def test_public_names():
    names: dict[str, object] = {}
    exec("from afmcalc import *", names)
    assert set(afmcalc.__all__) <= set(names)
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        _ = afmcalc.nothing
    assert doctest.testmod(afmcalc).failed == 0
    with pytest.raises(afmcalc.SpecError):
        afmcalc.read_spec(None, ["C=-1"])
