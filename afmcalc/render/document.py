"""Layout of a result: single values, triples, tables. All formats for people, CSV and the report write this layout."""

from collections.abc import Sequence
from contextvars import ContextVar
from functools import partial
from itertools import chain
from typing import Any, NamedTuple

from ..messages import translate, within
from ..result import OpenTriple, Result, Series, Shown, Triple, shown_as

ENDS = {"min": "at f_min", "mean": "at mean f", "max": "at f_max"}
"""Field of a triple → its friction, in the words of a heading."""
_with_details = ContextVar("with_details", default=False)
with_details = partial(within, _with_details)
"""Context in which layouts include the columns of details, if that is asked."""


class Column(NamedTuple):
    """Quantity with one value, with three values (at f_min, mean f, f_max), or with a value for each table row."""

    path: str
    symbol: str
    name: str
    unit: str
    values: list[Any]
    shown: Shown = Shown()
    units: list[str] | None = None
    """SI unit of each value, if ``unit`` does not hold for all values."""
    words: Sequence[str | None] = ()
    """Word shown to people in place of each value; None: the value itself is shown."""
    errors: Sequence[Any] = ()
    """Standard error of each value, if the values have standard errors."""
    hidden: bool = False
    """True if formats for people leave the column out: it is a detail, or another column shows its values."""


class Table(NamedTuple):
    """Columns of equal length; the first ``axes`` of them are coordinates."""

    title: str
    columns: list[Column]
    axes: int = 0
    shown: Shown = Shown()
    path: str = ""
    """Path of the list in the result."""


class Document(NamedTuple):
    """Layout of a result."""

    singles: list[Column]
    steps: list[Any]
    """Steps of an explanation, as the analysis made them."""
    triples: list[Column]
    tables: list[Table]


def document(result: Result) -> Document:
    """Lay out a result by the symbol, unit and description of its fields; null optional fields are left out."""
    laid_out = Document([], [], [], [])
    _walk(result, laid_out)
    return laid_out


def indexed(symbol: str, index: str) -> str:
    """Symbol with an index, for a quantity that a result has more than once.

    >>> indexed("ΔT", "1"), indexed("K_т", "1"), indexed("N", "'"), indexed("N'_1", "cp"), indexed("T", "")
    ('ΔT_1', 'K_т,1', "N'", "N'_1,cp", 'T')
    """
    if not symbol or not index:
        return symbol
    head, mark, below = symbol.partition("_")
    if index.startswith("'"):
        return indexed(head + "'" + mark + below, index[1:])
    return f"{symbol}{',' if mark else '_'}{index}"


def _walk(
    result: Result, into: Document, prefix: str = "", heading: str = "", index: str = "", hidden: bool = False
) -> None:
    for field in fields_of([result], prefix):
        (value,) = field.values
        if value is None and not type(result).model_fields[field.path.removeprefix(prefix)].is_required():
            continue
        label = f"{heading}: {field.name}" if heading else field.name
        column = field._replace(symbol=indexed(field.symbol, index), name=label)
        if isinstance(value, Triple | OpenTriple):
            into.triples.append(column._replace(values=[getattr(value, end) for end in ENDS], words=()))
        elif isinstance(value, Result):
            below = column.shown.symbol or "", hidden or column.words[0] == ""
            _walk(value, into, column.path + ".", label, *below)
        elif isinstance(value, dict):
            if not value or column.words[0] == "":
                continue
            keys = sorted(value, key=lambda key: -round(abs(value[key]), 9)) if column.shown.ranked else list(value)
            words = [*map(column.shown.in_words, keys)] if column.shown.in_words else []
            heads = Column(f"{column.path}.key", "", translate(column.shown.keys_are), "", keys, words=words)
            figures = column._replace(values=[value[key] for key in keys], words=())
            into.tables.append(Table(column.name, [heads, figures]))
        elif isinstance(value, list) and value and isinstance(value[0], Result):
            table = _sweep(value) if isinstance(value[0], Series) else _records(value)
            into.tables.append(table._replace(title=label, shown=column.shown, path=column.path))
            into.steps.extend(value if column.shown.steps else ())
        elif value != []:
            out = hidden or column.hidden or column.shown.is_unit or column.words[0] == ""
            into.singles.append(column._replace(hidden=out))


def fields_of(records: Sequence[Result], prefix: str = "") -> list[Column]:
    """Return a column, with standard errors, for every field of records of one type; a triple takes one column."""
    fields = type(records[0]).model_fields
    shown_by_name = {name: shown_as(info) for name, info in fields.items()}
    error_fields = {shown.error_of: name for name, shown in shown_by_name.items()}
    columns = []
    for name, shown in shown_by_name.items():
        if shown.error_of:
            continue
        values = [getattr(record, name) for record in records]
        units = [getattr(record, shown.unit_in) for record in records] if shown.unit_in else None
        words = [_word(record, name, shown) for record in records]
        errors = [getattr(record, error_fields[name]) for record in records] if name in error_fields else []
        label = translate(fields[name].description or name)
        column = Column(prefix + name, shown.symbol or "", label, shown.unit, values, shown, units, words)
        hidden = shown.details and not _with_details.get()
        columns.append(column._replace(errors=[] if None in errors else errors, hidden=hidden))
    return columns


def _word(record: Result, name: str, shown: Shown) -> str | None:
    """Words shown to people in place of a field's value; None: the value itself is shown."""
    value = getattr(record, name)
    if shown.in_words is None or not isinstance(value, str | list):
        return record.words(name)
    return "; ".join(map(shown.in_words, [value] if isinstance(value, str) else value))


def _records(records: Sequence[Result]) -> Table:
    """Lay out records, one row each; triples become three columns, all-null columns are left out."""
    columns: list[Column] = []
    for column in fields_of(records):
        if any(isinstance(value, Triple | OpenTriple) for value in column.values):
            for end, at in ENDS.items():
                values = [getattr(value, end, None) for value in column.values]
                symbol, name = f"{column.symbol} {translate(end, 'value')}", f"{column.name}, {translate(at)}"
                columns.append(column._replace(path=f"{column.path}_{end}", symbol=symbol, name=name, values=values))
        elif isinstance(column.values[0], list) and any(isinstance(one, Result) for one in column.values[0]):
            continue  # only JSON has records inside records
        elif isinstance(column.values[0], dict):
            for key in dict.fromkeys(chain(*column.values)):
                values = [value.get(key) for value in column.values]
                name = f"{column.name} {translate(column.shown.in_words(key) if column.shown.in_words else key)}"
                columns.append(column._replace(path=f"{column.path}.{key}", name=name, values=values))
        elif any(value is not None for value in column.values) or any(column.words):
            columns.append(column)
    return Table("", columns)


def _sweep(sweeps: Sequence[Series]) -> Table:
    """Table of sweeps over one grid: the coordinates of each sweep, then the results, which are the same for all."""
    first, digits = sweeps[0], Shown(digits=5)
    axes = [Column(each.path, each.parameter, each.path, each.unit, each.values, digits) for each in sweeps]
    answers = [
        column._replace(values=column.values[0], words=())
        for column in fields_of([first])
        if column.path not in Series.model_fields and isinstance(column.values[0], list)
    ]
    return Table("", [*axes, *answers], axes=len(axes))
