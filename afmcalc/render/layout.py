"""From document to blocks of text cells, shared by the terminal and Markdown."""

import re
from collections.abc import Callable, Mapping, Sequence
from itertools import compress
from typing import Any, NamedTuple

from ..findings import Finding
from ..messages import named, printable, term, told, translate, with_unit
from ..result import Output
from .document import Column, Document, Entry, Table
from .units import display, display_unit, estimate, in_numbers, worded


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


SweepDrawing = Callable[[TextTable, bool, int | None], list[str]]
"""``curve(block, unicode, width)`` → lines under a table of a sweep, none under any other."""


def title(output: Output) -> str:
    """Heading of an output: what was calculated, for which clutch."""
    spec = {} if output.result.of_several else output.spec or {}
    variant = translate(str(spec.get("variant") or ""), "value")
    about = " – ".join(printable(str(part)) for part in (named(spec.get("name")), variant) if part)
    return f"{output.command}: {about}" if about else output.command


def blocks(laid_out: Document) -> list[TextTable]:
    """Return single values, then triples, then tables."""
    found = []
    errors = {row.error_of: row.values[0] for row in laid_out.singles if row.error_of}
    singles = [row for row in laid_out.singles if not row.error_of and not row.told]
    if singles:
        rows = [
            [row.symbol, row.name, _single(row, errors.get(row.path)), display_unit(row.shown_unit or row.unit)]
            for row in singles
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
        found += [_table(part) for table in laid_out.tables if not table.data for part in _parts(table)]
    return found


def _single(row: Entry, error: float | None) -> str:
    if row.said or row.values[0] is None:
        return translate(row.said) or worded(row.null)
    unit = row.shown_unit or row.unit
    return display(row.values[0], unit) if error is None else estimate(row.values[0], error, unit)


def _parts(table: Table) -> list[Table]:
    """Tables that a table is for people: one for every value of the column that it is divided by."""
    divided = next((column.values for column in table.columns if column.path == table.by), None)
    if divided is None:
        return [table]
    chosen = ([own == value for own in divided] for value in dict.fromkeys(divided))
    return [table._replace(columns=[_only(column, mask) for column in table.columns]) for mask in chosen]


def _only(column: Column, mask: list[bool]) -> Column:
    units = column.units and [*compress(column.units, mask)]
    said = column.said and [*compress(column.said, mask)]
    return column._replace(values=[*compress(column.values, mask)], units=units, said=said)


_LONG = 3
"""Rows above which details are left out of a table."""


def step_lines(laid_out: Document) -> list[str]:
    """Steps of an explanation as lines: what, formula, numbers, value with source, what the print has instead."""
    lines = []
    for step in laid_out.steps:
        at = told(" at {place}", place=in_numbers(translate(step.at))) if step.at else ""
        at = ", ".join([at, *told_apart(step, laid_out.steps)])
        lines += ["", f"{step.symbol}{at}: {translate(step.name)}", f"    {step.symbol} = {in_numbers(step.formula)}"]
        indent = " " * (5 + len(step.symbol))
        if step.substituted != step.formula:
            lines.append(f"{indent}= {in_numbers(step.substituted)}")
        lines.append(f"{indent}= {step_value(step)}    [{translate(step.source).rstrip('.')}]")
        if step.print_differs:
            lines.append(told("    print differs: {what}", what=term(step.print_differs)))
    return lines


def told_apart(step: Any, steps: Sequence[Any]) -> list[str]:
    """Setting of the spring and side of a step, where steps of the same quantity differ in them."""
    alike = [each for each in steps if (each.function, each.symbol) == (step.function, step.symbol)]
    names = [name for name in _APART if len({getattr(each, name) for each in alike} - {None}) > 1]
    return [told(_APART[name][own]) for name in names if (own := getattr(step, name))]


_APART: Mapping[str, Mapping[str, str]] = {
    "setting": {"min-friction": "set at f_min", "mean-friction": "set at mean f"},
    "side": {"protected": "protected side", "unprotected": "unprotected side"},
}


def step_value(step: Any) -> str:
    """Value of a step in the engineer's unit, with the SI value's unit where they differ."""
    return with_unit(display(step.value, step.unit), display_unit(step.unit))


def _cells(column: Column, errors: list[float] | None) -> list[str]:
    if column.is_unit:
        return [display_unit(unit) for unit in column.units or column.values]
    if column.code:
        return [printable(str(value)) for value in column.values]
    units = column.units or [column.unit] * len(column.values)
    if errors:
        return [estimate(*each) for each in zip(column.values, errors, units, strict=True)]
    said = column.said or [None] * len(column.values)
    return [
        translate(own or "") or _shown(value, unit, column.null)
        for value, unit, own in zip(column.values, units, said, strict=True)
    ]


def _shown(value: Any, unit: str, null: str) -> str:
    return worded(null) if value is None else display(value, unit)


def _table(table: Table) -> TextTable:
    errors = {column.error_of: column.values for column in table.columns if column.error_of}
    long = bool(table.columns) and len(table.columns[0].values) > _LONG
    shown = [column for column in table.columns if not column.error_of and not (long and column.detail)]
    table = table._replace(columns=shown)
    header = [_heading(column) for column in table.columns]
    cells = [_cells(column, errors.get(column.path)) for column in table.columns]
    numeric = [_is_numeric(column) for column in table.columns]
    rows = [list(row) for row in zip(*cells, strict=True)]
    legend = (
        "; ".join(f"{column.symbol}: {column.name}" for column in table.columns if column.symbol) if table.axes else ""
    )
    return TextTable(table.title[:1].upper() + table.title[1:], header, rows, numeric, table, legend)


def _heading(column: Column) -> str:
    unit = display_unit(column.unit)
    name = translate(column.symbol or column.name)
    return f"{name}, {unit}" if unit not in ("", "–") else name


def _is_numeric(column: Column) -> bool:
    return any(isinstance(value, int | float) and not isinstance(value, bool) for value in column.values)


_NUMBER = re.compile(r"(\(?[-−]?\d+|–)(.*)")


def padded(block: TextTable) -> TextTable:
    """Pad the cells of numeric columns to one width, their decimal points below each other."""
    columns = [list(cells) for cells in zip(block.header, *block.rows, strict=True)]
    for cells, right in zip(columns, block.numeric, strict=True):
        if right:
            cells[:] = _pointed(cells)
    header, *rows = ([*line] for line in zip(*columns, strict=True))
    return block._replace(header=header, rows=rows)


def _pointed(cells: list[str]) -> list[str]:
    """Set a heading and numbers flush right by their decimal points; text below them flush right as it is."""
    parts = [matched.groups() if (matched := _NUMBER.fullmatch(cell)) else None for cell in cells[1:]]
    tail = max((len(part[1]) for part in parts if part), default=0)
    set_ = [
        cell if part is None else part[0] + part[1].ljust(tail) for cell, part in zip(cells[1:], parts, strict=True)
    ]
    width = max(len(cell) for cell in (cells[0], *set_))
    return [cell.rjust(width) for cell in (cells[0], *set_)]


def unfolded(found: list[TextTable]) -> list[TextTable]:
    """Tables for a page of any width: records side by side where they always stand so."""
    return [part for block in found for part in (turned(block) if is_across(block) else [block])]


_SHORT = 24
"""Cells up to this width may stand side by side for many records."""


def is_across(block: TextTable) -> bool:
    """Whether the records of a table always stand side by side."""
    return block.source is not None and block.source.across


def may_turn(block: TextTable) -> bool:
    """Whether the records of a table may stand side by side where its columns do not fit."""
    short = all(len(cell) <= _SHORT for row in block.rows for cell in row)
    return is_across(block) or (block.source is not None and not block.source.axes and short)


def turned(block: TextTable, width: int | None = None, gap: int = 3) -> list[TextTable]:
    """Set the records of a table side by side, quantities as rows, in as many tables as a width asks for.

    Text that all records share is said in the title, and the first that they do not share heads the columns.

    Args:
        block: a table of records.
        width: columns of characters there are; None for as many as it takes.
        gap: characters between two columns.

    Returns:
        The tables; none where not even one record has room.
    """
    assert block.source is not None
    columns = [[*cells] for cells in zip(*block.rows, strict=True)]
    told = [number for number, cells in enumerate(columns) if len(block.rows) > 1 and _is_shared(block, number, cells)]
    said = "; ".join(f"{block.header[number]}: {columns[number][0]}" for number in told)
    first, *rest = (number for number in range(len(columns)) if number not in told)
    heads = columns[first]
    about = [block.source.columns[number] for number in rest]
    names = [[column.symbol, column.name] for column in about]
    units = [display_unit(column.unit) for column in about]
    widths = [max(map(len, (head, *(columns[number][record] for number in rest)))) for record, head in enumerate(heads)]
    title = f"{block.title} ({said})" if said else block.title
    whole = [max(len(name[0]) for name in names), max(len(name[1]) for name in names), max(map(len, units))]
    if width is None or sum(whole) + sum(widths) + gap * (len(widths) + 2) <= width:
        rows = [[*name, *columns[number], unit] for name, number, unit in zip(names, rest, units, strict=True)]
        numeric = [False, False, *(True for _ in heads), False]
        return [
            TextTable(title, [translate("Symbol"), translate("Quantity"), *heads, translate("Unit")], rows, numeric)
        ]
    labels = [block.header[number] for number in rest]
    corner = block.header[first]
    room = width - max(map(len, (corner, *labels)))
    if max(widths) + gap > room:
        return []
    found, start = [], 0
    while start < len(heads):
        stop, left = start, room
        while stop < len(heads) and left >= widths[stop] + gap:
            left -= widths[stop] + gap
            stop += 1
        rows = [[label, *columns[number][start:stop]] for label, number in zip(labels, rest, strict=True)]
        numeric = [False, *(True for _ in range(start, stop))]
        found.append(TextTable("" if start else title, [corner, *heads[start:stop]], rows, numeric))
        start = stop
    return found


def _is_shared(block: TextTable, number: int, cells: list[str]) -> bool:
    """Whether a column is text that says the same of every record."""
    return not block.numeric[number] and len(set(cells)) == 1


def ranked(findings: list[Finding]) -> list[Finding]:
    """Return findings, the gravest first."""
    order = {"error": 0, "warning": 1, "info": 2}
    return sorted(findings, key=lambda finding: order[finding.level])


def findings_lines(findings: list[Finding]) -> list[str]:
    """One line per finding, gravest first."""
    return [
        printable(f"{translate(f.level, 'value')}: {translate(f.message)} [{f.code}{', ' + f.path if f.path else ''}]")
        for f in ranked(findings)
    ]
