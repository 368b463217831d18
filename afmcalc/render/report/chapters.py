"""The chapters of a report: one for each topic of the dossier, its numbers, its calculation, its drawing."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ...analysis.adjust import AdjustResult
from ...analysis.dossier import Dossier, Topic
from ...analysis.springs.springs import SpringsResult
from ...analysis.tolerance.result import IndexRow, InputRow, LifeRow, ToleranceResult
from ...messages import localized, term, translate
from ...messages import told as message
from ...result import Result, Triple
from ...spec.keys import keys
from ..document import ENDS, Column, document, fields_of
from ..layout import TextTable, blocks, cells, errors_in, quantities
from ..plot import sheet_of
from ..plot.chart import Sheet
from ..plot.curves import SPRINGS
from ..units import display, display_unit, factor, significant
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
    method = dossier.spec.adjustment.method
    return [_chapter(topic, method) for topic in dossier.topics]


def _chapter(topic: Topic, method: str) -> Chapter:
    lay_out = _TABLES.get(topic.name, lambda result: blocks(document(result)))
    return Chapter(
        key=topic.name,
        title=translate(topic.title),
        about=translate(topic.about),
        tables=lay_out(topic.result),
        blocks=[block_of(derivation, method) for derivation in topic.derivations],
        sheets=[] if topic.figure is None else [sheet_of(topic.plot, topic.figure)],
        sources=topic.sources,
    )


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
    """The distribution, its quantiles, what scatters and the share of each input, errors in columns of their own."""
    sampled = result.method != "exact"
    laid_out = document(result)
    errors = errors_in(laid_out.singles)
    heads = [translate("Value"), *(["±"] if sampled else [])]
    singles = [column for column in laid_out.singles if not column.error_of]
    figures = [(column, _with_error(column, errors.get(column.path), sampled)) for column in singles]
    quantiles = [(_quantile(row.probability, row.torque), [row.standard_error]) for row in result.quantiles]
    torques = [(column, _with_error(column, error, sampled)) for column, error in quantiles]
    tables = [quantities(heads, figures), quantities(heads, torques, translate("Quantiles of the torque"))]
    tables += [_lives(result.life_quantiles, sampled)] if result.life_quantiles else []
    return [*tables, _inputs(result.inputs), *([_shares(result.sobol)] if sampled else [])]


def _quantile(probability: float, torque: float) -> Column:
    percent = 100 * probability
    name = message("torque not exceeded with probability {percent:g} %", percent=percent)
    return Column("", f"T_{percent:g}", name, "N*m", [torque])


def _with_error(column: Column, errors: Sequence[float] | None, sampled: bool) -> list[str]:
    """A value, and its error to two figures; more are not known of it."""
    rounded = "" if errors is None else significant(float(f"{errors[0] * factor(column.unit):.2g}"))
    return [*cells(column), *([rounded] if sampled else [])]


def _estimates(row: LifeRow | IndexRow, names: Sequence[str], sampled: bool) -> list[str]:
    pairs = (row.estimate(name) for name in names)
    return [text for value, error in pairs for text in _with_error(Column("", "", "", "1", [value]), [error], sampled)]


def _lives(rows: Sequence[LifeRow], sampled: bool) -> TextTable:
    heads = [translate("Slips, protected side"), translate("Slips, unprotected side")]
    header = [translate("Clutches failed"), *(text for head in heads for text in ([head, "±"] if sampled else [head]))]
    texts = [
        [f"{localized(f'{100 * row.probability:g}')} %", *_estimates(row, ("protected", "unprotected"), sampled)]
        for row in rows
    ]
    return TextTable(translate("Life over the clutches"), header, texts, [False, *[True] * (len(header) - 1)])


def _inputs(inputs: Sequence[InputRow]) -> TextTable:
    texts = [
        [
            *_named(row.path),
            translate(row.distribution, "value"),
            *(display(value, row.unit) for value in (row.center, row.spread)),
            display_unit(row.unit),
        ]
        for row in inputs
    ]
    header = [*map(translate, ("Symbol", "Quantity", "Distribution", "Center", "Spread", "Unit"))]
    return TextTable(translate("What scatters"), header, texts, [False, False, False, True, True, False])


def _shares(rows: Sequence[IndexRow]) -> TextTable:
    ordered = sorted(rows, key=lambda row: -row.total)
    texts = [[*_named(row.path), *_estimates(row, ("first_order", "total"), True)] for row in ordered]
    header = [*map(translate, ("Symbol", "Quantity", "S_1, first order")), "±", translate("S_T, total"), "±"]
    title = translate("Share in the variance of the torque (Sobol indices)")
    return TextTable(title, header, texts, [False, False, True, True, True, True])


def _named(path: str) -> tuple[str, str]:
    """Symbol and name of what scatters."""
    if path in _FRICTION:
        symbol, name = _FRICTION[path]
        return symbol, translate(name)
    key = keys()[path]
    return key.symbol or "", translate(key.description).partition(";")[0]


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
