"""Every quantity of the equations stands once in ``terms``, and is used."""

from collections import Counter
from typing import get_type_hints

from afmcalc.equations import terms
from afmcalc.equations.catalogue import equations

TERMS = {name: hint.__metadata__ for name, hint in vars(terms).items() if hasattr(hint, "__metadata__")}


def test_no_quantity_has_two_names():
    assert [term for term, count in Counter(TERMS.values()).items() if count > 1] == []


def test_every_term_is_named_in_a_signature():
    named = {
        hint.__metadata__
        for equation in equations().values()
        for hint in get_type_hints(equation.function, include_extras=True).values()
    }
    assert sorted(name for name, term in TERMS.items() if term not in named) == []


def test_an_argument_says_what_it_means():
    assert all(term.meaning for equation in equations().values() for term in equation.arguments.values())


def test_source_and_validity_are_sentences():
    """One after the other, so that the catalogue reads the source by its prefix."""
    for equation in equations().values():
        text = equation.function.__doc__
        assert text.count("Source: ") == 1, equation.name
        assert text.count("Validity: ") <= 1, equation.name
        assert equation.source.endswith("."), equation.name
