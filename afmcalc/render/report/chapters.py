"""The chapters of a report: one for each topic of the dossier, its numbers, its calculation, its drawing."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

from ...analysis.adjust import AdjustResult
from ...analysis.dossier import Dossier
from ...analysis.springs.springs import SpringsResult
from ...analysis.tolerance.result import ToleranceResult
from ...messages import term, translate
from ...result import Result, Triple
from ...spec.keys import keys
from ..document import ENDS, Column, document, fields_of
from ..layout import TextTable, blocks, cells, quantities
from ..plot import sheet_of
from ..plot.chart import Sheet
from ..plot.curves import SPRINGS
from .steps import Derived, block_of


@dataclass(frozen=True)
class Chapter:
    """One calculation of the report."""

    key: str
    title: str
    about: str
    tables: Sequence[TextTable]
    blocks: Sequence[Derived]
    sheets: Sequence[Sheet]
    sources: Sequence[str]
    """Keys of the references it rests on."""


def chapters(dossier: Dossier) -> list[Chapter]:
    """Lay out every topic."""
    return [
        Chapter(
            key=topic.name,
            title=translate(topic.title),
            about=translate(topic.about),
            tables=_TABLES.get(topic.name, lambda result: blocks(document(result)))(topic.result),
            blocks=[block_of(derivation, dossier.spec.adjustment.method) for derivation in topic.derivations],
            sheets=[] if topic.figure is None else [sheet_of(topic.plot, topic.figure)],
            sources=topic.sources,
        )
        for topic in dossier.topics
    ]


def _both_settings(result: AdjustResult) -> list[TextTable]:
    laid_out = document(result)
    others = [row for row in laid_out.singles if not row.path.startswith(("min_friction.", "mean_friction."))]
    heads = [translate("set at f_min"), translate("set at mean f")]
    methods = _side_by_side(heads, [result.min_friction, result.mean_friction])
    return [methods, *blocks(laid_out._replace(singles=others, triples=[], tables=[]))]


def _named_springs(result: SpringsResult) -> list[TextTable]:
    """The springs of the spec; what could take their place is no part of a report."""
    springs = {translate(SPRINGS[option.spring]): option for option in result.named or [] if option.spring}
    return [_side_by_side([*springs], [*springs.values()], without=("number", "spring", "kind"))]


def _side_by_side(heads: Sequence[str], results: Sequence[Result], without: Sequence[str] = ()) -> TextTable:
    """Set results of one type as columns, what none of them has left out; a triple takes a row for each friction."""
    columns = [part for column in fields_of(results) if column.path not in without for part in _at_frictions(column)]
    known = [column for column in columns if any(value is not None for value in column.values)]
    return quantities(heads, [(column, cells(column)) for column in known])


def _at_frictions(column: Column) -> Iterator[Column]:
    if not isinstance(column.values[0], Triple):
        yield column
        return
    for end, at in zip(ENDS, ("at f_min", "at mean f", "at f_max"), strict=True):
        values = [getattr(triple, end) for triple in column.values]
        yield column._replace(name=f"{column.name} {translate(at)}", values=values)


def _scatter(result: ToleranceResult) -> list[TextTable]:
    """The tables of the command, with symbols and names in place of keys, what scatters most first."""
    laid_out = document(result.model_copy(update={"sobol": sorted(result.sobol, key=lambda row: -row.total)}))
    tables = [table._replace(columns=[*chain(*map(_named, table.columns))]) for table in laid_out.tables]
    return blocks(laid_out._replace(tables=tables))


def _named(column: Column) -> list[Column]:
    """Two columns, symbols and names, in place of one of keys of the spec."""
    if column.path != "path":
        return [column]
    rows = [_FRICTION.get(path) or (keys()[path].symbol or "", keys()[path].description) for path in column.values]
    return [
        Column("symbol", "", "Symbol", "", [symbol for symbol, _ in rows]),
        Column("quantity", "", "Quantity", "", [translate(name).partition(";")[0] for _, name in rows]),
    ]


_FRICTION = {
    "friction": ("f", term("friction in service")),
    "friction.driving": ("f_1", term("friction of the driving pairs in service")),
    "friction.driven": ("f_2", term("friction of the driven pairs in service")),
}

_TABLES: Mapping[str, Callable[[Any], list[TextTable]]] = {
    "adjust": _both_settings,
    "tolerance": _scatter,
    "springs": _named_springs,
}
"""Topics whose numbers are not set as they come."""
