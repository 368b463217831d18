"""One walk over a result: rows, triples, tables. Every format for people and CSV writes this."""

from typing import Any, NamedTuple

from pydantic import BaseModel
from pydantic.fields import FieldInfo

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
    shown_unit: str = ""
    """SI unit of a value that has its unit in a field of its own; empty: ``unit``."""
    error_of: str = ""
    """Path of the figure whose standard error this is; people see it beside the figure."""
    told: bool = False
    """Whether people see it in what another entry shows: a unit, or what ``said`` says."""
    said: str = ""
    """What people are told instead of the value."""


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
    error_of: str = ""
    """Path of the column whose standard errors these are."""
    is_unit: bool = False
    """Whether the values are units."""
    code: bool = False
    """Whether the values are names that a user types."""
    said: list[str | None] | None = None
    """What people are told instead of some of the values."""


class Table(NamedTuple):
    """Columns of equal length; ``axes`` of them, from the left, are coordinates."""

    title: str
    columns: list[Column]
    axes: int = 0
    data: bool = False
    """Rows for programs: CSV writes them, people are spared them."""
    across: bool = False
    """Whether people see the records side by side, quantities as rows."""
    path: str = ""
    """Path of the list."""
    by: str = ""
    """Path of the column whose every value gets a table of its own, for people."""


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
    _walk(result, "", "", "", laid_out)
    return laid_out


def about(info: FieldInfo) -> dict[str, Any]:
    """Return what the declaration of a field says beside its description."""
    return info.json_schema_extra if isinstance(info.json_schema_extra, dict) else {}


def indexed(symbol: str, index: str) -> str:
    """Symbol of a quantity that is given more than once, with the index that tells it from the others.

    >>> indexed("ΔT", "1"), indexed("K_т", "1"), indexed("N", "'"), indexed("N'_1", "cp"), indexed("T", "")
    ('ΔT_1', 'K_т,1', "N'", "N'_1,cp", 'T')
    """
    if not symbol or not index:
        return symbol
    head, mark, below = symbol.partition("_")
    if index.startswith("'"):
        return indexed(head + "'" + mark + below, index[1:])
    return f"{symbol}{',' if mark else '_'}{index}"


def _walk(model: BaseModel, prefix: str, heading: str, index: str, into: Document) -> None:
    for name, info in type(model).model_fields.items():
        value = getattr(model, name)
        if value is None and not info.is_required():
            continue
        extra = about(info)
        path, title = prefix + name, translate(info.description or name)
        symbol, unit = indexed(str(extra.get("symbol") or ""), index), str(extra.get("unit") or "")
        label = f"{heading}: {title}" if heading else title
        if isinstance(value, Triple | OpenTriple):
            null = str(extra.get("null") or "–")
            into.triples.append(Entry(path, symbol, label, unit, (value.min, value.mean, value.max), null))
        elif isinstance(value, Result):
            start, told = len(into.singles), isinstance(model, Result) and model.words(name) == ""
            _walk(value, path + ".", label, str(extra.get("symbol") or ""), into)
            into.singles[start:] = [each._replace(told=each.told or told) for each in into.singles[start:]]
        elif isinstance(value, dict):
            of = translate(str(extra.get("of") or "parameter"))
            into.tables.append(_mapping(path, symbol, label, unit, value, of, ranked=bool(extra.get("ranked"))))
        elif extra.get("steps"):
            into.steps.extend(value)
            into.tables.append(_records(label, value))
        elif isinstance(value, list) and value and isinstance(value[0], BaseModel):
            laid_out = _side_by_side(label, value) if extra.get("columns") else _records(label, value)
            across, by = bool(extra.get("across")), str(extra.get("by") or "")
            into.tables.append(laid_out._replace(data=bool(extra.get("data")), across=across, by=by, path=path))
        elif value != []:
            null, shown_unit = str(extra.get("null") or "–"), str(getattr(model, str(extra.get("unit_in")), ""))
            error_of, told = str(extra.get("error_of") or ""), bool(extra.get("told"))
            said = model.words(name) if isinstance(model, Result) else None
            into.singles.append(
                Entry(
                    path, symbol, label, unit, (value,), null, shown_unit, error_of and prefix + error_of, told,
                    said or "",
                )
            )  # fmt: skip


def _mapping(path: str, symbol: str, title: str, unit: str, value: dict[str, Any], of: str, *, ranked: bool) -> Table:
    """Lay out a dictionary whose keys are called ``of``; ``ranked`` puts the largest magnitude first."""
    names = sorted(value, key=lambda name: -abs(value[name])) if ranked else list(value)
    return Table(
        title,
        [
            Column(f"{path}.key", "", of, "", names),
            Column(path, symbol, title, unit, [value[name] for name in names]),
        ],
    )


def _records(title: str, items: list[BaseModel]) -> Table:
    """Lay out a list of records, one row each; triples become three columns, all-null columns are left out."""
    columns: list[Column] = []
    for name, info in type(items[0]).model_fields.items():
        extra = about(info)
        values = [getattr(item, name) for item in items]
        said = [item.words(name) if isinstance(item, Result) else None for item in items]
        if all(value is None for value in values) and not any(said):
            continue
        symbol, unit = str(extra.get("symbol") or ""), str(extra.get("unit") or "")
        label = translate(info.description or name)
        if any(isinstance(value, Triple | OpenTriple) for value in values):
            for end in ("min", "mean", "max"):
                ends = [getattr(value, end, None) for value in values]
                column, of = f"{symbol} {translate(end, 'value')}", f"{label}, {translate(end, 'end')}"
                columns.append(Column(f"{name}_{end}", column, of, unit, ends))
        else:
            own = [str(getattr(item, str(extra["unit_in"]))) for item in items] if "unit_in" in extra else None
            columns.append(
                Column(
                    name, symbol, label, unit, values, bool(extra.get("detail")), str(extra.get("null", "–")), own,
                    str(extra.get("error_of") or ""), bool(extra.get("is_unit")), bool(extra.get("code")), said,
                )
            )  # fmt: skip
    return Table(title, columns)


def _side_by_side(title: str, items: list[BaseModel]) -> Table:
    """Lay out series that share a grid: the coordinate of each, then the answers, which all have in common."""
    axes: list[Column] = []
    answers: list[Column] = []
    for item in items:
        facts: Any = item
        for name, info in type(item).model_fields.items():
            extra = about(info)
            value = getattr(item, name)
            if extra.get("axis"):
                axes.append(Column(facts.path, facts.parameter, facts.path, facts.unit, value))
            elif isinstance(value, list) and item is items[0]:
                label = translate(info.description or name)
                symbol, unit, null = (str(extra.get(part) or "") for part in ("symbol", "unit", "null"))
                answers.append(Column(name, symbol, label, unit, value, null=null or "–"))
    return Table(title, [*axes, *answers], axes=len(axes))
