"""Every quantity of the laws stands once in a table of terms, and is used."""

from importlib import import_module
from inspect import signature

from afmcalc.equations.catalogue import equations
from afmcalc.equations.terms import read_terms


def test_a_term_of_one_module_is_used_there_and_differs_from_the_common_one():
    laws = [each.function for each in equations().values()]
    for module in {law.__module__ for law in laws}:
        own = [law for law in laws if law.__module__ == module]
        used = {law.__name__ for law in own} | {name for law in own for name in signature(law).parameters}
        used |= {f"{law.__name__}.{name}" for law in own for name in signature(law).parameters}
        table = read_terms(getattr(import_module(module), "SYMBOLS", ""))
        assert table.keys() <= used, module
    assert all(term.meaning for each in equations().values() for term in each.arguments.values())


def test_a_docstring_tells_source_and_validity_once():
    for equation in equations().values():
        text = equation.function.__doc__
        assert (text.count("Source: "), text.count("Validity: ") <= 1) == (1, True), equation.name
        assert equation.source.endswith("."), equation.name
