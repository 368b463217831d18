"""The chapters of a report, one for each topic of the dossier: numbers, calculation and drawing of the topic."""

from collections.abc import Sequence
from itertools import chain
from typing import NamedTuple

from ...analysis.adjust import AdjustResult
from ...analysis.dossier import Dossier, Topic
from ...analysis.explain.explain import CaseRow, Derivation, Meaning
from ...analysis.spring_search import SpringsResult
from ...formula_tree import Tree, symbol_tree, value_tree
from ...messages import deferred, say, translate, with_unit
from ...result import Result, Triple
from ...spec.keys import keys
from ...units import typeset
from ..amounts import measured, significant
from ..document import ENDS, Column, Document, document, fields_of
from ..plot import sheet_of
from ..plot.chart import Sheet
from ..plot.curve_sheets import SPRINGS
from ..text_tables import TextTable, blocks, cells, quantities
from .blocks import SHORT, Piece, Step, Text, broken, formula, listed, piece, size, text, when
from .pieces import MISPRINT, said
from .words import form, told

_PEAKS = (
    "peak_torque", "dynamic_factor", "slip_time", "energy", "temperature", "face_temperature", "trips_per_hour",
    "trips_to_wear_out",
)  # fmt: skip
_FRICTION = {
    "friction": ("f", deferred("friction in service")),
    "friction.driving": ("f_1", deferred("friction of the driving pairs in service")),
    "friction.driven": ("f_2", deferred("friction of the driven pairs in service")),
}


class Chapter(NamedTuple):
    """One calculation of the report."""

    topic: Topic
    tables: Sequence[TextTable]
    steps: Sequence[Step]
    sheets: Sequence[Sheet]


def chapters(dossier: Dossier) -> list[Chapter]:
    """Lay out every topic of a dossier."""
    laid_out = []
    for topic in dossier.topics:
        title, tables = translate(topic.title), []
        for table in _tables(topic.result):
            # a table without title has the name of the topic and, if it has several columns, the names of its columns
            heads = table.header[2:-1]
            own = f"{title}: {', '.join(heads)}" if heads[1:] else title
            tables.append(table._replace(title=table.title or own))
        steps = [step_of(derivation, dossier.spec.adjustment.method) for derivation in topic.derivations]
        sheets = [] if topic.figure is None else [sheet_of(topic.plot, topic.figure)]
        laid_out.append(Chapter(topic, tables, steps, sheets))
    return laid_out


def _tables(result: Result) -> list[TextTable]:
    """Tables of a result, in which symbols and names replace keys of the spec."""
    laid_out = document(result)
    if isinstance(result, SpringsResult):  # only the springs in the spec, not the others that would fit
        springs = {translate(SPRINGS[option.spring]): option for option in result.named or [] if option.spring}
        return [_side_by_side([*springs], [*springs.values()], without=("number", "spring", "kind"))]
    if isinstance(result, AdjustResult):
        others = [row for row in laid_out.singles if not row.path.startswith(("min_friction.", "mean_friction."))]
        heads = [translate("set at f_min"), translate("set at mean f")]
        methods = _side_by_side(heads, [result.min_friction, result.mean_friction])
        return [methods, *blocks(laid_out._replace(singles=others, triples=[], tables=[]))]
    tables = [table._replace(columns=[*chain(*map(_named, table.columns))]) for table in laid_out.tables]
    return blocks(laid_out._replace(tables=tables))


def peaks(dossier: Dossier) -> list[TextTable]:
    """Table of the loads and the heat of a trip; no table if no trip is simulated and no slip is given."""
    topics = (topic for topic in dossier.topics if topic.name in ("simulate", "heat"))
    columns = {column.path: column for topic in topics for column in document(topic.result).triples}
    shown = [column for path, column in columns.items() if path in _PEAKS]
    return blocks(Document([], [], shown, []))


def _side_by_side(heads: Sequence[str], results: Sequence[Result], without: Sequence[str] = ()) -> TextTable:
    """Table with a column for each result of the same type; rows without values are left out, a triple has three."""
    columns = []
    for column in fields_of(results):
        if isinstance(column.values[0], Triple):
            for end, at in ENDS.items():
                values = [getattr(triple, end) for triple in column.values]
                columns.append(column._replace(name=f"{column.name} {translate(at)}", values=values))
        elif column.path not in without and any(value is not None for value in column.values):
            columns.append(column)
    return quantities(heads, [(column, cells(column)) for column in columns])


def _named(column: Column) -> list[Column]:
    """Two columns, symbols and names, in place of one column with keys of the spec."""
    if not all(isinstance(path, str) and (path in _FRICTION or path in keys()) for path in column.values):
        return [column]
    rows = [_FRICTION.get(path) or (keys()[path].symbol or "", keys()[path].description) for path in column.values]
    return [
        Column("symbol", "", "Symbol", "", [symbol for symbol, _ in rows]),
        Column("quantity", "", "Quantity", "", [translate(name).partition(";")[0] for _, name in rows]),
    ]


def step_of(step: Derivation, method: str) -> Step:
    """Lay out a derivation; lines that all have the spring setting of the spec, ``method``, do not name it."""
    columns = _labels(step.rows, method)
    symbol, first = symbol_tree(translate(step.symbol)), step.rows[0]
    in_one_line = not columns and len(step.rows) == 1 and size(step.formula) + size(first.numbers) <= SHORT
    # the formula may consist of the symbol alone, and the formula with numbers of the value alone
    parts = [symbol, *([step.formula] if step.formula not in ((), symbol) else [])]
    if in_one_line:
        parts += dict.fromkeys((first.numbers, *_values(first.value, step.unit)))
    # a label takes the room of a dozen signs
    room = SHORT - 12 * max(0, len(columns) - 1)
    lines = []
    for row, *labels in zip(step.rows, *columns.values(), strict=True):
        # a line may end between the formula with numbers and the values
        own, *rest = dict.fromkeys((symbol, broken(row.numbers, room), *_values(row.value, step.unit)))
        worked = [formula(own, *rest[:1]), *(formula((), value) for value in rest[1:])]
        lines.append(([*map(said, labels)], worked))
    heads = [*map(told, columns), say("Numbers put in")]
    return Step(
        what=_what(step),
        number=str(step.number) if step.formula else "",
        formula=formula(*parts) if len(parts) > 1 else None,
        where=_explained(step.where),
        lined=form().paper == "framed",
        head=[*map(text, heads)] if len(columns) > 1 else [],
        lines=[] if in_one_line else lines,
    )


def _what(step: Derivation) -> Text:
    """Symbol, name and sources of a quantity; the number of its formula if the formula is printed earlier."""
    parts: list[Text | Piece] = [piece("b", said(step.symbol)), said(translate(step.name))]
    if not step.formula:
        parts.append(piece("soft", say("By formula ({number}).", number=step.number)))
    named = MISPRINT.findall(step.source)
    notes = [said(translate(step.source).rstrip("."))] if step.source else []
    notes += [text(mark) for mark in dict.fromkeys(MISPRINT.findall(step.differs)) if mark not in named]
    parts += [piece("sources", text("[", listed(notes, "; "), "]"))] if notes else []
    return listed(parts, " ")


def _values(value: float, unit: str) -> list[Tree]:
    """Value in the unit of the tables, after the value in the SI unit if the two units differ."""
    in_si = [with_unit(significant(value), "" if unit == "1" else translate(typeset(unit), "unit"))] if value else []
    return [*map(value_tree, dict.fromkeys([*in_si, measured(value, unit)]))]


def _labels(cases: Sequence[CaseRow], method: str) -> dict[str, list[str]]:
    """Columns of labels that tell cases apart; the spring setting ``method`` is named only beside another."""
    columns = {}
    if any(case.at for case in cases):
        columns["friction"] = [case.at or "" for case in cases]
    if any(case.setting not in (None, method) for case in cases):
        columns["setting"] = [told(f"setting/{case.setting or method}") for case in cases]
    if any(case.side for case in cases):
        columns["side"] = [told(f"side/{case.side or 'protected'}") for case in cases]
    return columns


def explained(words: str, unit: str) -> str:
    """Meaning of a symbol, with its unit."""
    return ", ".join(filter(None, (translate(words), translate(typeset(unit), "unit")))) if words else ""


def _explained(meanings: Sequence[Meaning]) -> list[Text]:
    """Explain each symbol once, with every formula that gives the symbol."""
    origins: dict[tuple[str, str], list[Piece]] = {}
    for each in meanings:
        words = explained(each.text, each.unit)
        same = (key for key in origins if key[0] == each.symbol and words in ("", key[1]))
        known = origins.setdefault(next(same, (each.symbol, words)), [])
        if each.number is not None:  # a link to the formula, after the quantity's own symbol if the two differ
            by = say("by ({number})", number=each.number)
            if each.source:
                by = say("{source} by ({number})", source=each.source, number=each.number)
            known.append(piece("link", said(by), f"formula-{each.number}"))
    return [
        text(piece("b", said(symbol)), when(words or links, " – "), listed([said(words), *links]))
        for (symbol, words), links in origins.items()
    ]
