"""English texts that people read, as far as they can be listed; the rest is noted while shown."""

import ast
import os
import re
import string
import tomllib
from collections.abc import Iterator
from errno import EACCES, EBADF, EIO, EISDIR, ELOOP, ENAMETOOLONG, ENOENT, ENOSPC, ENOTDIR, EPERM, EPIPE, EROFS
from functools import cache
from typing import Any, get_args

from conftest import CONFIGS
from sources import PACKAGE, called, calls

Key = tuple[str, str]  # Context and text

FAILURES = (ENOENT, EACCES, EPERM, EISDIR, ENOTDIR, ENOSPC, EROFS, ENAMETOOLONG, ELOOP, EBADF, EIO, EPIPE)
"""Why files cannot be read or written, as the system says it."""
SAYING = ["say", "filled", "translate", "deferred", "heard", "wrong", "AfmcalcError", "FileError", "CalculationError"]


@cache
def texts() -> set[Key]:
    """Context and text of every literal and every table entry that has words."""
    sources = (_literals(), _tables(), _pages(), _fields(), _equations(), _terms(), _papers(), _examples())
    return {key for source in sources for key in source if worded(key[1])}


def worded(text: str) -> bool:
    """True if a text has words, units or decimal points besides its fields."""
    bare = "".join(part for part, *_ in string.Formatter().parse(text)) if "{" in text else text
    bare = re.sub(r"\w+_\w+|\b(sin|cos|tan|ln|zC|pi)\b|\b[FSM]\d+\b", "", bare)
    return re.search(r"[A-Za-z]{2}|\d\.\d|N·m|N/mm", bare) is not None


def _literals() -> Iterator[Key]:
    """First arguments of all calls of the functions in ``SAYING``."""
    for _, node in calls(*SAYING):
        if node.args:
            second = node.args[1] if called(node) == "translate" and len(node.args) > 1 else None
            context = str(second.value) if isinstance(second, ast.Constant) else ""
            yield from ((context, text) for text in _strings(node.args[0]))


def _strings(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    elif isinstance(node, ast.IfExp):
        yield from (*_strings(node.body), *_strings(node.orelse))


def _tables() -> Iterator[Key]:
    from afmcalc.analysis.check import Grade
    from afmcalc.analysis.registry import ANALYSES, PLOTS
    from afmcalc.engines.checks import CHECKS
    from afmcalc.engines.parts import RULES
    from afmcalc.findings import FINDINGS
    from afmcalc.render.report import words
    from afmcalc.spec.quantity import EXAMPLES
    from afmcalc.spec.rules import KEY_RULES
    from afmcalc.variants import VARIANTS

    tables = (FINDINGS.values(), words.REPORT.values(), map(os.strerror, FAILURES))
    abouts = (kind for kind, _ in EXAMPLES.values()), (plot.about for plot in PLOTS.values())
    rules = (message for *_, message, _ in KEY_RULES)
    checks = (text for check in (*CHECKS, *RULES) for text in (check.name, check.symbol))
    sections = [each.section for each in ANALYSES.values() if each.section]
    titles = (text for each in sections for text in (each.title, each.about, *each.conclusion.values()))
    yield from (("", text) for table in (*tables, *abouts, rules, checks, get_args(Grade), titles) for text in table)
    yield from (("value", name) for name in VARIANTS)


def _pages() -> Iterator[Key]:
    for page in (*PACKAGE.rglob("*.html"), *PACKAGE.rglob("*.css")):
        yield from (("", text) for text in re.findall(r'\b_\("([^"]+)"', page.read_text(encoding="utf-8")))


def _fields() -> Iterator[Key]:
    """Descriptions of tables and keys in the schemas, and words that a value may be."""
    from afmcalc.analysis.registry import ANALYSES, schema

    for each in map(schema, (None, *ANALYSES)):
        yield from (("", text) for text in below(each, "description") if isinstance(text, str))
        yield from (("value", word) for words in below(each, "enum") for word in words if isinstance(word, str))


def below(part: Any, key: str) -> Iterator[Any]:
    """Yield every value of a key anywhere in a part of a schema."""
    if isinstance(part, dict):
        if key in part:
            yield part[key]
        part = list(part.values())
    if isinstance(part, list):
        for each in part:
            yield from below(each, key)


def _equations() -> Iterator[Key]:
    from afmcalc.engines import curved_disc_balance, disc_balance
    from afmcalc.equations.catalogue import equation_of, equations
    from afmcalc.equations.terms import TERMS

    for name, law in (vars(disc_balance) | vars(curved_disc_balance)).items():
        if name in TERMS and callable(law) and TERMS[name].unit:
            yield "", equation_of(name, law).source
    for each in equations().values():
        terms = (term.meaning for term in (*each.arguments.values(), each.result))
        yield from (("", text) for text in (each.about, each.validity, each.source, *terms) if text)


def _terms() -> Iterator[Key]:
    """Meanings of quantities with a unit (others are not shown), and the names of cases."""
    from afmcalc.equations.terms import CASES, TERMS

    meanings = (each.meaning for each in TERMS.values() if each.unit)
    yield from (("", text) for text in (*meanings, *CASES.values()))


def _papers() -> Iterator[Key]:
    from afmcalc.papers import FIGURES, register
    from afmcalc.papers.claims import paper_figure

    entries = (*register.misprints(), *register.register())
    names = ["where", "printed", "correct", "why", "reading", "says", "covered_by", "not_reached"]
    yield from (("", text) for each in entries for name in names if (text := getattr(each, name, None)))
    claims = register.data("claims.toml")["claim"]
    names = ["source", "inputs", "printed", "computed", "why", "correction"]
    yield from (("", claim[name]) for claim in claims for name in names if name in claim)
    for figure in map(paper_figure, FIGURES):
        labels = (curve.label for panel in figure.panels for curve in panel)
        axes = (axis.name for axis in (figure.x, *figure.y))
        own = (figure.title, figure.inputs, figure.assumed, *figure.corrections)
        yield from (("", text) for text in (*own, *labels, *axes))


def _examples() -> Iterator[Key]:
    """Names and comments of the specs that ship."""
    from afmcalc.spec.write import comment

    for path in sorted(CONFIGS.glob("*.toml")):
        text = path.read_text(encoding="utf-8")
        yield ("name", tomllib.loads(text)["name"])
        yield from (("comment", words) for line in text.splitlines() if (words := comment(line)))
