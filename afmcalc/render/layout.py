"""From document to blocks of text cells, shared by the terminal and Markdown."""

from collections.abc import Callable
from typing import Any, NamedTuple

from ..findings import Finding
from ..messages import printable, term, told, translate
from ..result import Output
from .document import Column, Document, Table
from .units import display, display_unit, in_numbers


class TextTable(NamedTuple):
    """One table of text cells."""

    title: str
    header: list[str]
    rows: list[list[str]]
    numeric: list[bool]
    """Which columns are set flush right."""
    source: Table | None = None
    legend: str = ""
    """What the symbols in the header mean."""


SweepDrawing = Callable[[TextTable, bool], list[str]]
"""``curve(block, unicode)`` → lines under a table of a sweep, none under any other."""


def title(output: Output) -> str:
    """Heading of an output: what was calculated, for which clutch."""
    spec = output.spec or {}
    variant = translate(str(spec.get("variant") or ""), "value")
    about = " – ".join(printable(str(part)) for part in (spec.get("name"), variant) if part)
    return f"{output.command}: {about}" if about else output.command


def blocks(laid_out: Document) -> list[TextTable]:
    """Return single values, then triples, then tables."""
    found = []
    if laid_out.singles:
        rows = [
            [row.symbol, row.name, _shown(row.values[0], row.unit, row.null), display_unit(row.unit)]
            for row in laid_out.singles
        ]
        found.append(
            TextTable("", [*map(translate, ("Symbol", "Quantity", "Value", "Unit"))], rows, [False, False, True, False])
        )
    if laid_out.triples:
        rows = [
            [row.symbol, row.name, *(_shown(value, row.unit, row.null) for value in row.values), display_unit(row.unit)]
            for row in laid_out.triples
        ]
        header = [*map(translate, ("Symbol", "Quantity", "at f_min", "at mean f", "at f_max", "Unit"))]
        found.append(TextTable("", header, rows, [False, False, True, True, True, False]))
    if not laid_out.steps:
        found += [_table(table) for table in laid_out.tables if not table.data]
    return found


_LONG = 3
"""Rows above which details are left out of a table."""


def step_lines(laid_out: Document) -> list[str]:
    """Steps of an explanation as lines: what, formula, numbers, value with source, what the print has instead."""
    lines = []
    for step in laid_out.steps:
        at = told(" at {place}", place=term(step.at)) if step.at else ""
        lines += ["", f"{step.symbol}{at}: {translate(step.name)}", f"    {step.symbol} = {in_numbers(step.formula)}"]
        indent = " " * (5 + len(step.symbol))
        if step.substituted != step.formula:
            lines.append(f"{indent}= {in_numbers(step.substituted)}")
        lines.append(f"{indent}= {step_value(step)}    [{translate(step.source).rstrip('.')}]")
        if step.note:
            lines.append(f"    {translate(step.note)}")
        if step.print_differs:
            lines.append(told("    print differs: {what}", what=term(step.print_differs)))
    return lines


def step_value(step: Any) -> str:
    """Value of a step in the engineer's unit, with the SI value's unit where they differ."""
    unit = display_unit(step.unit)
    return f"{display(step.value, step.unit)} {unit}".removesuffix(" –")


def _shown(value: Any, unit: str, null: str) -> str:
    return null if value is None else display(value, unit)


def _table(table: Table) -> TextTable:
    if table.columns and len(table.columns[0].values) > _LONG:
        table = table._replace(columns=[column for column in table.columns if not column.detail])
    header = [_heading(column) for column in table.columns]
    cells = [_cells(column) for column in table.columns]
    numeric = [_is_numeric(column) for column in table.columns]
    rows = [list(row) for row in zip(*cells, strict=True)]
    legend = (
        "; ".join(f"{column.symbol}: {column.name}" for column in table.columns if column.symbol) if table.axes else ""
    )
    return TextTable(table.title[:1].upper() + table.title[1:], header, rows, numeric, table, legend)


def _cells(column: Column) -> list[str]:
    if column.is_unit:
        return [display_unit(value) for value in column.values]
    if column.code:
        return [printable(str(value)) for value in column.values]
    units = column.units or [column.unit] * len(column.values)
    return [_shown(value, unit, column.null) for value, unit in zip(column.values, units, strict=True)]


def _heading(column: Column) -> str:
    unit = display_unit(column.unit)
    name = translate(column.symbol or column.name)
    return f"{name}, {unit}" if unit not in ("", "–") else name


def _is_numeric(column: Column) -> bool:
    return any(isinstance(value, int | float) and not isinstance(value, bool) for value in column.values)


def findings_lines(findings: list[Finding]) -> list[str]:
    """One line per finding, gravest first."""
    order = {"error": 0, "warning": 1, "info": 2}
    ranked = sorted(findings, key=lambda finding: order[finding.level])
    return [
        printable(f"{translate(f.level, 'value')}: {translate(f.message)} [{f.code}{', ' + f.path if f.path else ''}]")
        for f in ranked
    ]
