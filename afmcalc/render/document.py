"""One walk over a result: rows, triples, tables. Every format for people and CSV writes this."""

from typing import Any, NamedTuple

from pydantic import BaseModel

from ..messages import translate
from ..result import OpenTriple, Result, Triple


class Entry(NamedTuple):
    """A quantity with one value, or with one per friction."""

    path: str
    symbol: str
    name: str
    unit: str
    values: tuple[Any, ...]
    """One value, or three at f_min, mean, f_max."""
    null: str = "–"
    """What a missing value means, for people."""


class Column(NamedTuple):
    """One column of a table."""

    path: str
    symbol: str
    name: str
    unit: str
    values: list[Any]
    detail: bool = False
    """Left out of tables for people when the table is long."""
    null: str = "–"
    units: list[str] | None = None
    """SI units of values that have theirs in a field of its own."""
    is_unit: bool = False
    """Whether the values are units."""
    code: bool = False
    """Whether the values are names that a user types."""


class Table(NamedTuple):
    """Columns of equal length; ``axes`` of them, from the left, are coordinates."""

    title: str
    columns: list[Column]
    axes: int = 0
    data: bool = False
    """Rows for programs: CSV writes them, people are spared them."""


class Document(NamedTuple):
    """A result laid out: single values, triples, tables."""

    singles: list[Entry]
    steps: list[Any]
    """Steps of an explanation, as the analysis made them."""
    triples: list[Entry]
    tables: list[Table]


def document(result: BaseModel) -> Document:
    """Lay out a result by the symbol, unit and description of its fields; null optional fields are left out."""
    laid_out = Document([], [], [], [])
    _walk(result, "", "", laid_out)
    return laid_out


def _walk(model: BaseModel, prefix: str, heading: str, into: Document) -> None:
    for name, info in type(model).model_fields.items():
        value = getattr(model, name)
        if value is None and not info.is_required():
            continue
        about: dict[str, Any] = info.json_schema_extra if isinstance(info.json_schema_extra, dict) else {}
        path, title = prefix + name, translate(info.description or name)
        symbol, unit = str(about.get("symbol") or ""), str(about.get("unit") or "")
        label = f"{heading}: {title}" if heading else title
        if isinstance(value, Triple | OpenTriple):
            null = str(about.get("null") or "–")
            into.triples.append(Entry(path, symbol, label, unit, (value.min, value.mean, value.max), null))
        elif isinstance(value, Result):
            _walk(value, path + ".", label, into)
        elif isinstance(value, dict):
            into.tables.append(_mapping(path, symbol, label, unit, value, ranked=bool(about.get("ranked"))))
        elif about.get("steps"):
            into.steps.extend(value)
            into.tables.append(_records(label, value))
        elif isinstance(value, list) and value and isinstance(value[0], BaseModel):
            laid_out = _side_by_side(label, value) if about.get("columns") else _records(label, value)
            into.tables.append(laid_out._replace(data=bool(about.get("data"))))
        elif value != []:
            into.singles.append(Entry(path, symbol, label, unit, (value,), str(about.get("null") or "–")))


def _mapping(path: str, symbol: str, title: str, unit: str, value: dict[str, Any], *, ranked: bool) -> Table:
    """Lay out a dictionary; ``ranked`` puts the largest magnitude first."""
    names = sorted(value, key=lambda name: -abs(value[name])) if ranked else list(value)
    return Table(
        title,
        [
            Column(f"{path}.key", "", translate("parameter"), "", names),
            Column(path, symbol, title, unit, [value[name] for name in names]),
        ],
    )


def _records(title: str, items: list[BaseModel]) -> Table:
    """Lay out a list of records, one row each; triples become three columns, all-null columns are left out."""
    columns: list[Column] = []
    for name, info in type(items[0]).model_fields.items():
        about: dict[str, Any] = info.json_schema_extra if isinstance(info.json_schema_extra, dict) else {}
        values = [getattr(item, name) for item in items]
        if all(value is None for value in values):
            continue
        symbol, unit = str(about.get("symbol") or ""), str(about.get("unit") or "")
        label = translate(info.description or name)
        if any(isinstance(value, Triple | OpenTriple) for value in values):
            for end in ("min", "mean", "max"):
                ends = [getattr(value, end, None) for value in values]
                columns.append(
                    Column(f"{name}_{end}", f"{symbol} {translate(end, 'value')}", f"{label}, {end}", unit, ends)
                )
        else:
            own = [str(getattr(item, str(about["unit_in"]))) for item in items] if "unit_in" in about else None
            detail, is_unit, code = (bool(about.get(part)) for part in ("detail", "is_unit", "code"))
            columns.append(Column(name, symbol, label, unit, values, detail, units=own, is_unit=is_unit, code=code))
    return Table(title, columns)


def _side_by_side(title: str, items: list[BaseModel]) -> Table:
    """Lay out series that share a grid: the coordinate of each, then the answers, which all have in common."""
    axes: list[Column] = []
    answers: list[Column] = []
    for item in items:
        facts: Any = item
        for name, info in type(item).model_fields.items():
            about: dict[str, Any] = info.json_schema_extra if isinstance(info.json_schema_extra, dict) else {}
            value = getattr(item, name)
            if about.get("axis"):
                axes.append(Column(facts.path, facts.parameter, facts.path, facts.unit, value))
            elif isinstance(value, list) and item is items[0]:
                label = translate(info.description or name)
                symbol, unit, null = (str(about.get(part) or "") for part in ("symbol", "unit", "null"))
                answers.append(Column(name, symbol, label, unit, value, null=null or "–"))
    return Table(title, [*axes, *answers], axes=len(axes))
