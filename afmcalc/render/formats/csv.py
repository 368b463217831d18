"""CSV: one header line with units, SI, full precision."""

import csv
import io
from itertools import chain
from typing import Any

from ...messages import localized, printable
from ...result import Output
from ..document import ENDS, Column, Document, document


def render(output: Output, terminal: bool) -> str:
    """Write a row for each record of a result, or each point of its sweep; without both, all quantities in one row.

    A result with several lists has a row for every number: quantity, record, value, standard error, SI unit.
    """
    # where the language has a decimal comma spreadsheets expect semicolons, and the byte order mark of UTF-8
    mark, separator, decimal = ("", ",", ".") if localized("0.5") == "0.5" else ("\ufeff", ";", ",")
    result, laid_out = output.result, document(output.result)
    columns = _figures(laid_out) if result.many_lists else _columns(laid_out)
    if result.rows_with_values:
        # single values that have no column yet are repeated in every row
        known, count = {column.path for column in columns}, len(columns[0].values)
        singles = chain(*(_flat(column) for column in laid_out.singles if column.path not in known))
        columns = columns + [column._replace(values=column.values * count) for column in singles]
    text = io.StringIO()
    writer = csv.writer(text, delimiter=separator, lineterminator="\n")
    writer.writerow(_inert(f"{column.path} [{column.unit}]" if column.unit else column.path) for column in columns)
    rows = zip(*(column.values for column in columns), strict=True)
    writer.writerows([_cell(value, decimal) for value in row] for row in rows)
    return mark + text.getvalue()


def _cell(value: Any, decimal: str) -> Any:
    """Cell of a value; the items of a list are joined by spaces."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        text = " ".join(str(_cell(item, decimal)) if isinstance(item, float) else str(item) for item in value)
        return _inert(text) if any(isinstance(item, str) for item in value) else text
    if isinstance(value, float):
        return str(value).replace(".", decimal)
    return _inert(value) if isinstance(value, str) else value


def _inert(text: str) -> str:
    """Text of the user (name of a spec), escaped so that a spreadsheet reads no formula into it."""
    shown = printable(text)
    return f"'{shown}" if shown.startswith(("=", "+", "-", "@")) else shown


def _columns(laid_out: Document) -> list[Column]:
    """Columns of the list marked ``data``, else of the first list; without a list, columns of all quantities."""
    lists = [table for table in laid_out.tables if not table.columns[0].path.endswith(".key")]
    if lists:
        return next((table for table in lists if table.shown.data), lists[0]).columns
    wide = [*chain(*map(_flat, (*laid_out.singles, *laid_out.triples)))]
    for table in laid_out.tables:
        names, values = table.columns
        pairs = zip(names.values, values.values, strict=True)
        wide += [values._replace(path=f"{values.path}.{name}", values=[value]) for name, value in pairs]
    return wide


def _figures(laid_out: Document) -> list[Column]:
    """Columns with a row for every single value and every number in a list, with the name of the number's record."""
    rows: list[tuple[Any, ...]] = [
        (single.path, None, *single.values, *(single.errors or [None]), single.unit) for single in laid_out.singles
    ]
    for table in laid_out.tables:
        of, *figures = table.columns
        for number, name in enumerate(of.values):
            for column in figures:
                value = column.values[number]
                error = column.errors[number] if column.errors else None
                unit = column.units[number] if column.units else column.unit
                if value is not None and not column.shown.is_unit:
                    rows.append((f"{table.path}.{column.path}", name, value, error, unit))
    names = ("quantity", "of", "value", "standard_error", "unit")
    return [Column(name, "", name, "", list(part)) for name, part in zip(names, zip(*rows, strict=True), strict=True)]


def _flat(column: Column) -> list[Column]:
    """One column for each number of an interval or a triple."""
    values, ends = column.values, [""]
    if len(values) == 3:
        ends = [f".{end}" for end in ENDS]
    elif isinstance(values[0], list) and column.unit:
        values, ends = values[0], [".low", ".high"]
    return [column._replace(path=column.path + end, values=[value]) for end, value in zip(ends, values, strict=True)]
