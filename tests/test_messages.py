"""Messages: every one a template in one place, filled with the fields it names."""

import ast
import string
from functools import cache

import pytest
from sources import FILES, calls, nodes

from afmcalc.findings import FINDINGS
from afmcalc.units import per_si

ALWAYS = {"value", "limit", "path", None}
"""What a finding carries whether or not its sentence shows it; None: a dictionary of further values."""

ERRORS = ("AfmcalcError", "FileError", "CalculationError")


@pytest.fixture(scope="module", autouse=True)
def _parsed():
    """Every module is parsed before the time of a test runs."""
    for module in FILES:
        nodes(module)


@cache
def constants() -> set[str]:
    """Strings of the package outside the table of its sentences."""
    everything = (node for module in FILES if module != "findings" for node in nodes(module))
    return {node.value for node in everything if isinstance(node, ast.Constant) and isinstance(node.value, str)}


def fields(template: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(template) if name is not None}


def literal(node: ast.AST) -> str | None:
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def test_every_template_is_a_literal_filled_with_what_it_names():
    found = [*calls("say"), *(each for each in calls(*ERRORS) if literal(each[1].args[0]) is not None)]
    assert len(found) > 100
    for where, call in found:
        if where == "messages":
            continue
        template = literal(call.args[0])
        assert template is not None, f"{where}:{call.lineno}: a catalogue cannot find this template"
        given, named = {each.arg for each in call.keywords}, fields(template)
        assert given - {None} <= named if None in given else given == named, f"{where}:{call.lineno}"
    for where, call in calls("wrong"):
        named = fields(literal(call.args[0]) or "")
        assert named - {"kind", "allowed"} == {each.arg for each in call.keywords}, f"{where}:{call.lineno}"
        assert "allowed" in named


def fits(code: str, call: ast.Call) -> bool:
    """Whether a call gives a sentence what it names, and nothing else."""
    given, named = {each.arg for each in call.keywords}, fields(FINDINGS[code])
    return (None in given or named <= given) and given - ALWAYS <= named


def codes(code: ast.expr) -> set[str]:
    """Codes that a finding may be made with; none where the code is handed over."""
    if isinstance(code, ast.IfExp):
        return codes(code.body) | codes(code.orelse)
    return {text} if (text := literal(code)) else set()


def test_every_finding_has_a_sentence_and_gives_it_what_it_names():
    raised = set()
    for where, call in calls("finding"):
        if found := codes(call.args[0]):
            assert found <= set(FINDINGS), f"{where}:{call.lineno}: {found}"
            assert all(fits(code, call) for code in found), f"{where}:{call.lineno}: {found}"
        else:
            given = {each.arg for each in call.keywords}
            found = {code for code in constants() & set(FINDINGS) if fields(FINDINGS[code]) <= given}
            assert found, f"{where}:{call.lineno}: no sentence is content with {given}"
        raised |= found
    assert set(FINDINGS) == raised, "a sentence that nothing says"


def test_units_of_a_sentence_are_known():
    for sentence in FINDINGS.values():
        for _, _, wanted, _ in string.Formatter().parse(sentence):
            _, _, unit = (wanted or "").partition(" ")
            assert not unit or per_si(unit.removesuffix("…")), sentence


def test_an_error_is_said_in_a_template():
    """Not in a text put together on the spot, which no catalogue could hold."""
    glued = (ast.JoinedStr, ast.BinOp)
    for where, call in calls(*ERRORS):
        assert not any(isinstance(each, glued) for each in call.args), f"{where}:{call.lineno}: {ast.unparse(call)}"
    plain = (*glued, ast.Constant)
    for where, call in calls("ValueError"):
        if where.startswith("spec."):
            assert not any(isinstance(each, plain) for each in call.args), f"{where}:{call.lineno}: {ast.unparse(call)}"
    for where, call in calls("Problem"):
        assert not isinstance(call.args[2], plain), f"{where}:{call.lineno}: {ast.unparse(call)}"
