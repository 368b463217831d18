"""CSV: one header line with units, SI, full precision."""

import csv
import io
from itertools import chain
from typing import Any

from ...messages import printable
from ...result import Output
from ..document import Column, Document, Entry, document
from ..layout import ranked


def render(output: Output, terminal: bool) -> str:
    """Write the result's records or sweep, one row each; without any, all quantities in one row.

    Of a result of several lists, a row for every figure: which, of what, value, standard error, SI unit.
    """
    result, laid_out = output.result, document(output.result)
    if result.findings_first:
        columns = _findings(output, laid_out)
    else:
        columns = (_long if result.many_lists else _columns)(laid_out)
        if result.rows_with_values:
            columns = _with_values(columns, laid_out)
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


def _findings(output: Output, laid_out: Document) -> list[Column]:
    """One row per finding, gravest first, then one per entry of the result's lists, whose name stands for the level."""
    names, found = ("level", "code", "value", "limit", "path", "message"), ranked(output.findings)
    rows: list[dict[str, Any]] = [{name: getattr(finding, name) for name in names} for finding in found]
    for table in laid_out.tables:
        paths = "level", *(column.path for column in table.columns)
        entries = zip(*(column.values for column in table.columns), strict=True)
        rows += [dict(zip(paths, (table.path, *entry), strict=True)) for entry in entries]
    every = dict.fromkeys([*names, *chain(*rows)])
    return [Column(name, "", name, "", [row.get(name) for row in rows]) for name in every]


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


def _with_values(columns: list[Column], laid_out: Document) -> list[Column]:
    """The columns of a list, then the single values that no column is of, the same in every row."""
    known, count = {column.path for column in columns}, len(columns[0].values)
    single = [column for row in laid_out.singles for column in _flat(row) if column.path not in known]
    return columns + [column._replace(values=column.values * count) for column in single]


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
