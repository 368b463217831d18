"""The chapters of a report: one for each topic of the dossier, its numbers, its calculation, its drawing."""

from collections.abc import Callable, Mapping
from typing import Any

from ...analysis.adjust import AdjustResult
from ...analysis.dossier import Dossier, Topic
from ...analysis.springs.result import SpringOption, SpringsResult
from ...messages import translate
from ...result import Result, Triple
from ..document import Document, document
from ..layout import TextTable, blocks
from ..plot import sheet_of
from ..plot.kinds.springs import NAMES
from ..units import display, display_unit
from .interface import Chapter
from .scatter import scatter_blocks
from .steps import blocks_of


def chapters(dossier: Dossier) -> list[Chapter]:
    """Lay out every topic."""
    method = dossier.spec.adjustment.method
    return [_chapter(topic, method) for topic in dossier.topics]


def _chapter(topic: Topic, method: str) -> Chapter:
    lay_out = _BLOCKS.get(topic.name, lambda found: blocks(document(found)))
    return Chapter(
        key=topic.name,
        title=translate(topic.title),
        about=translate(topic.about),
        tables=lay_out(topic.result),
        blocks=blocks_of(topic.derivations, method),
        sheets=[] if topic.figure is None else [sheet_of(topic.plot, topic.figure)],
        sources=topic.sources,
    )


def _both_settings(found: AdjustResult) -> list[TextTable]:
    laid_out = document(found)
    own = [row for row in laid_out.singles if not row.path.startswith(("min_friction.", "mean_friction."))]
    methods = _side_by_side(
        {translate("set at f_min"): found.min_friction, translate("set at mean f"): found.mean_friction}
    )
    return [methods, *blocks(Document(own, [], [], []))]


def _named_springs(found: SpringsResult) -> list[TextTable]:
    """The springs of the spec; what could take their place is no part of a report."""
    springs = found.named or []
    table = _side_by_side({translate(NAMES[each.spring]): each for each in springs if each.spring})
    left_out = {translate(SpringOption.model_fields[name].description or "") for name in ("number", "spring", "kind")}
    unknown = display(None, "1")
    rows = [row for row in table.rows if row[1] not in left_out and set(row[2:-1]) != {unknown}]
    return [table._replace(rows=rows)]


_BLOCKS: Mapping[str, Callable[[Any], list[TextTable]]] = {
    "adjust": _both_settings,
    "tolerance": scatter_blocks,
    "springs": _named_springs,
}
"""Topics whose numbers are not set as they come."""


def _side_by_side(results: dict[str, Result]) -> TextTable:
    """Set results of one type as columns; a triple takes a row for each friction."""
    columns = [_rows(result) for result in results.values()]
    rows = [[*about, *(column[number][1] for column in columns)] for number, (about, _) in enumerate(columns[0])]
    lined = [[symbol, name, *values, unit] for symbol, name, unit, *values in rows]
    header = [translate("Symbol"), translate("Quantity"), *results, translate("Unit")]
    return TextTable("", header, lined, [False, False, *(True for _ in results), False])


def _rows(result: Result) -> list[tuple[tuple[str, str, str], str]]:
    """(symbol, name, unit) and value of every field."""
    found = []
    for name, info in type(result).model_fields.items():
        about: dict[str, Any] = info.json_schema_extra if isinstance(info.json_schema_extra, dict) else {}
        unit, symbol = str(about.get("unit") or ""), str(about.get("symbol") or "")
        value, title, shown = getattr(result, name), translate(info.description or name), display_unit(unit)
        if isinstance(value, Triple):
            found += [
                ((symbol, f"{title} {at}", shown), display(each, unit))
                for at, each in (
                    (translate("at f_min"), value.min),
                    (translate("at mean f"), value.mean),
                    (translate("at f_max"), value.max),
                )
            ]
        else:
            found.append(((symbol, title, shown), display(value, unit)))
    return found
