"""From subject to page."""

import hashlib
import json
from pathlib import Path
from typing import Any, NamedTuple

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from ...messages import printable, translate
from ...papers.references import REFERENCES
from ...spec import resolved
from ...spec.paths import keys, unit_at
from ..plot.figure import inline_svg
from ..units import display, display_unit
from .chapters import chapters
from .interface import Chapter, Subject
from .markup import cell, drawing, mathml, symbol

_LEVELS = {"error": 0, "warning": 1, "info": 2}


class _SpecLine(NamedTuple):
    """A key of the spec as resolved."""

    path: str
    symbol: str
    about: str
    value: str
    unit: str
    numeric: bool


def render(subject: Subject) -> str:
    """Write the page; the same subject gives the same text."""
    environment = Environment(
        loader=FileSystemLoader(Path(__file__).parent),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        finalize=lambda value: printable(value, lines=True) if type(value) is str else value,
    )
    environment.filters |= {
        "symbol": symbol,
        "cell": cell,
        "mathml": mathml,
        "display": display,
        "display_unit": display_unit,
    }
    found = chapters(subject.dossier)
    page: str = environment.get_template("page.html").render(
        subject=subject,
        name=subject.dossier.spec.name or "Adaptive friction clutch",
        digest=digest(subject),
        keys=_keys(subject),
        chapters=found,
        drawings=_drawings(found),
        findings=sorted(subject.dossier.findings, key=lambda finding: _LEVELS[finding.level]),
        references=_references(found),
    )
    return page


def digest(subject: Subject) -> str:
    """Return the SHA-256 of the spec as resolved: two reports of the same clutch have the same."""
    text = json.dumps(resolved(subject.dossier.spec), sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def _keys(subject: Subject) -> list[_SpecLine]:
    known = keys()
    found: list[_SpecLine] = []
    for path, value in _flat(resolved(subject.dossier.spec), ""):
        if isinstance(value, dict):
            found += [_scatter(path, name, each) for name, each in value.items()]
            continue
        key = known[path]
        shown = list(value) if isinstance(value, tuple) else str(value) if key.unit is None else value
        found.append(
            _SpecLine(
                path,
                key.symbol or "",
                translate(key.description),
                display(shown, key.unit or ""),
                display_unit(key.unit or ""),
                key.unit is not None,
            )
        )
    return found


def _scatter(path: str, name: str, given: dict[str, Any]) -> _SpecLine:
    """Show a distribution of [tolerance.fields]: its kind, then its numbers in the unit of what scatters."""
    unit = unit_at(name) or ""
    numbers = [f"{part} {display(value, unit)}" for part, value in given.items() if part != "distribution"]
    key = keys().get(name)
    about = f"scatter: {translate(key.description).partition(';')[0]}" if key else "scatter of the friction in service"
    value = ", ".join([given["distribution"], *numbers])
    return _SpecLine(f'{path}."{name}"', key.symbol or "" if key else "f", about, value, display_unit(unit), False)


def _flat(data: dict[str, Any], prefix: str) -> list[tuple[str, Any]]:
    """Value keys with their values; a key that holds a table of the user's own keys keeps it."""
    found: list[tuple[str, Any]] = []
    for name, value in data.items():
        path = prefix + name
        deeper = isinstance(value, dict) and path not in keys()
        found += _flat(value, f"{path}.") if deeper else [(path, value)]
    return found


def _drawings(found: list[Chapter]) -> dict[str, list[Any]]:
    """Chapter key → its drawings, numbered through."""
    made: dict[str, list[Any]] = {}
    number = 0
    for chapter in found:
        made[chapter.key] = []
        for sheet in chapter.sheets:
            number += 1
            made[chapter.key].append((number, sheet, drawing(inline_svg(sheet), sheet.title, number)))
    return made


def _references(found: list[Chapter]) -> list[tuple[str, str]]:
    cited = {source for chapter in found for source in chapter.sources}
    return [(key, text) for key, text in REFERENCES.items() if key in cited]
