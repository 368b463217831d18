"""CSV: one header line with units, SI, full precision."""

import csv
import io
from typing import Any

from ...messages import printable
from ...result import Output
from ..document import Column, Document, Entry, document


def render(output: Output, terminal: bool) -> str:
    """Write the result's records or sweep, one row each; without any, all quantities in one row.

    Of a result of several lists, a row for every figure: which, of what, value, standard error, SI unit.
    """
    result = output.result
    if result.findings_first:
        columns = _findings(output)
    else:
        columns = (_long if result.many_lists else _columns)(document(result))
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([_header(column.path, column.unit) for column in columns])
    writer.writerows(
        [_cell(value) for value in row] for row in zip(*(column.values for column in columns), strict=True)
    )
    return text.getvalue()


def _cell(value: Any) -> Any:
    """Write a list (an interval) into one cell."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        text = " ".join(map(str, value))
        return _inert(text) if any(isinstance(item, str) for item in value) else text
    return _inert(value) if isinstance(value, str) else value


def _inert(text: str) -> str:
    """Keep a spreadsheet from reading a formula into a text of the user's (the name of a spec)."""
    shown = printable(text)
    return f"'{shown}" if shown.startswith(("=", "+", "-", "@")) else shown


def _findings(output: Output) -> list[Column]:
    """One row per finding."""
    names = ("level", "code", "value", "limit", "path", "message")
    return [Column(name, "", name, "", [getattr(finding, name) for finding in output.findings]) for name in names]


def _columns(laid_out: Document) -> list[Column]:
    listed = [table for table in laid_out.tables if not _is_mapping(table.columns)]
    if listed:
        # what was asked for by name, else the first list: the one the command is for
        return next((table.columns for table in listed if table.data), listed[0].columns)
    wide = [column for row in laid_out.singles for column in _flat(row)]
    wide += [column for row in laid_out.triples for column in _flat(row)]
    for table in laid_out.tables:
        names, values = table.columns
        wide += [
            Column(f"{values.path}.{name}", "", name, values.unit, [value])
            for name, value in zip(names.values, values.values, strict=True)
        ]
    return wide


def _long(laid_out: Document) -> list[Column]:
    """Every figure of every list, with what it is of: the first column of the list."""
    errors = {row.error_of: row.values[0] for row in laid_out.singles if row.error_of}
    rows: list[tuple[Any, ...]] = [
        (row.path, None, row.values[0], errors.get(row.path), row.unit) for row in laid_out.singles if not row.error_of
    ]
    for table in laid_out.tables:
        of, *others = table.columns
        spread = {column.error_of: column.values for column in others if column.error_of}
        rows += [
            (
                f"{table.path}.{column.path}", name, column.values[number],
                spread[column.path][number] if column.path in spread else None,
                column.units[number] if column.units else column.unit,
            )
            for number, name in enumerate(of.values)
            for column in others
            if not column.error_of and not column.is_unit and column.values[number] is not None
        ]  # fmt: skip
    names = ("quantity", "of", "value", "standard_error", "unit")
    return [
        Column(name, "", name, "", list(values)) for name, values in zip(names, zip(*rows, strict=True), strict=True)
    ]


def _is_mapping(columns: list[Column]) -> bool:
    return columns[0].path.endswith(".key")


def _flat(row: Entry) -> list[Column]:
    if len(row.values) == 1 and isinstance(row.values[0], list) and row.unit:
        bounds = zip((".low", ".high"), row.values[0], strict=True)
        return [Column(row.path + end, row.symbol, row.name, row.unit, [value]) for end, value in bounds]
    ends = ("",) if len(row.values) == 1 else (".min", ".mean", ".max")
    return [
        Column(row.path + end, row.symbol, row.name, row.unit, [value])
        for end, value in zip(ends, row.values, strict=True)
    ]


def _header(path: str, unit: str) -> str:
    return _inert(f"{path} [{unit}]" if unit else path)
