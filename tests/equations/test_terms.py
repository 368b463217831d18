"""Every quantity of the equations stands once in ``terms``, and is used."""

from typing import get_type_hints

from afmcalc.equations import terms
from afmcalc.equations.catalogue import equations

TERMS = {name: hint.__metadata__ for name, hint in vars(terms).items() if hasattr(hint, "__metadata__")}


def test_every_term_is_named_in_a_signature_and_means_one_quantity():
    assert len(set(TERMS.values())) == len(TERMS)
    hints = [get_type_hints(each.function, include_extras=True) for each in equations().values()]
    named = {hint.__metadata__ for own in hints for hint in own.values()}
    assert sorted(name for name, term in TERMS.items() if term not in named) == []
    assert all(term.meaning for each in equations().values() for term in each.arguments.values())


def test_a_docstring_tells_source_and_validity_once():
    for equation in equations().values():
        text = equation.function.__doc__
        assert (text.count("Source: "), text.count("Validity: ") <= 1) == (1, True), equation.name
        assert equation.source.endswith("."), equation.name
