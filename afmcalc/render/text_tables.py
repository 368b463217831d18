"""From document to tables of text cells and lines of text, shared by all formats for people and the report."""

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from ..findings import Finding
from ..messages import deferred, named, native, printable, say, translate, with_unit
from ..result import Output
from .amounts import display, display_unit, estimate, headed, measured, worded
from .document import ENDS, Column, Document, Table

_LONG = 3
"""Number of rows above which a table leaves out columns marked ``detail``."""
_NUMBER = re.compile(r"(\(?[-−]?\d+(?:\xa0\d{3})*|–)(.*)")
_APART: Mapping[str, Mapping[str | None, str]] = {
    "setting": {
        None: deferred("springs as made"), "min-friction": deferred("springs set anew at f_min"),
        "mean-friction": deferred("springs set anew at mean f"),
    },
    "side": {None: "protected side", "unprotected": "unprotected side"},
}  # fmt: skip


class TextTable(NamedTuple):
    """One table of text cells."""

    title: str
    header: list[str]
    rows: list[list[str]]
    numeric: list[bool]
    """True for each column that is set flush right."""
    source: Table | None = None
    notes: Sequence[str] = ()
    """Lines above the table: the values that are the same in all rows, the meanings of the symbols in the header."""


def title(output: Output) -> str:
    """Heading of an output: command, name and variant of the clutch."""
    spec = {} if output.result.of_several else output.spec or {}
    variant = translate(str(spec.get("variant") or ""), "value")
    about = " – ".join(printable(str(part)) for part in (named(spec.get("name")), variant) if part)
    heading = output.result.code if output.command == "mend" else output.command
    return f"{heading}: {about}" if about else heading


def lead(output: Output) -> str:
    """Text before the tables: the verdict on each checked clutch, the meaning of a finding, or an empty text."""
    if output.command == "mend":
        return output.result.lead
    if output.command == "compare":
        lines = dict[str, None]()
        for row in output.result.clutches:
            variant = translate(row.variant, "value")
            name = f"{variant}, {worded(row.basis)}" if row.basis else printable(named(row.name) or variant)
            lines[f"{name}: {row.sentence}"] = None
        return "\n".join(lines)
    checked = output.result if output.command == "check" else getattr(output.result, "verdict", None)
    return "" if checked is None else checked.verdict.sentence


def blocks(laid_out: Document) -> list[TextTable]:
    """Tables of the single values, of the triples, and of the lists, in this order."""
    values, triples = (
        [(column, cells(column)) for column in columns if not column.hidden]
        for columns in (laid_out.singles, laid_out.triples)
    )
    tables = [quantities([translate("Value")], values)] if values else []
    tables += [quantities([*map(translate, ENDS.values())], triples)] if triples else []
    if not laid_out.steps:
        tables += [_table(table) for table in laid_out.tables if not table.shown.data]
    return tables


def quantities(heads: Sequence[str], lines: Iterable[tuple[Column, Sequence[str]]], title: str = "") -> TextTable:
    """Table with a quantity in each row: symbol, name, cells below ``heads``, unit."""
    rows = [
        [native(column.symbol), column.name, *texts, display_unit(column.units[0] if column.units else column.unit)]
        for column, texts in lines
    ]
    header = [translate("Symbol"), translate("Quantity"), *heads, translate("Unit")]
    return TextTable(title, header, rows, [False, False, *(True for _ in heads), False])


def cells(column: Column) -> list[str]:
    """Displayed values of a column, with their standard errors."""
    if column.shown.is_unit:
        return [display_unit(unit) for unit in column.units or column.values]
    if column.shown.code:
        return [worded(column.shown.null) if value is None else printable(str(value)) for value in column.values]
    units = column.units or [column.unit] * len(column.values)
    if column.errors:
        return [estimate(*figure) for figure in zip(column.values, column.errors, units, strict=True)]
    words = column.words or [None] * len(column.values)
    missing = worded(column.shown.null)
    texts = [
        translate(word or "") or (missing if value is None else display(value, unit, column.shown.digits))
        for value, unit, word in zip(column.values, units, words, strict=True)
    ]
    return [*map(native, texts)] if column.path.endswith("symbol") else texts


def _table(table: Table) -> TextTable:
    long = bool(table.columns) and len(table.columns[0].values) > _LONG
    shown = [column for column in table.columns if not (column.hidden or (long and column.shown.detail))]
    shown, same = _folded(shown) if table.shown.folds else (shown, "")
    named = (column for column in shown if column.symbol and column.name != table.title)
    meanings = "; ".join(f"{native(translate(column.symbol))}: {column.name}" for column in named)
    heads = [headed(native(translate(column.symbol or column.name)), column.unit) for column in shown]
    numeric = [
        any(isinstance(value, int | float) and not isinstance(value, bool) for value in column.values)
        for column in shown
    ]
    title, rows = table.title[:1].upper() + table.title[1:], [[*row] for row in zip(*map(cells, shown), strict=True)]
    return TextTable(title, heads, rows, numeric, table._replace(columns=shown), [*filter(None, (same, meanings))])


def _folded(columns: Sequence[Column]) -> tuple[list[Column], str]:
    """Columns whose cells differ between rows, and a line of text with the cells that are the same in all rows."""
    kept, same = list[Column](), list[str]()
    for column in columns:
        text, *others = cells(column)
        if others and set(others) == {text}:
            name = native(translate(column.symbol or column.name))
            same.append(f"{name} = {with_unit(text, display_unit(column.unit))}")
        else:
            kept.append(column)
    return kept, say("the same in all: {list}", list="; ".join(same)) if same else ""


def padded(block: TextTable) -> TextTable:
    """Table with the cells of numeric columns padded to one width and aligned at the decimal point."""
    columns = zip(block.header, *block.rows, strict=True)
    texts = [_pointed(column) if right else column for column, right in zip(columns, block.numeric, strict=True)]
    header, *rows = (list(line) for line in zip(*texts, strict=True))
    return block._replace(header=header, rows=rows)


def _pointed(column: Sequence[str]) -> list[str]:
    """Cells of a numeric column, heading first, with numbers aligned at the decimal point, other texts flush right."""
    heading, *texts = column
    numbers = [_NUMBER.fullmatch(text) for text in texts]
    tail = max((len(number[2]) for number in numbers if number), default=0)
    aligned = [
        heading,
        *(number[1] + number[2].ljust(tail) if number else text for text, number in zip(texts, numbers, strict=True)),
    ]
    width = max(map(len, aligned))
    return [text.rjust(width) for text in aligned]


def unfolded(laid_out: Document) -> list[TextTable]:
    """Tables of a layout; a table marked ``across`` is turned: its records become columns."""
    return [_turned(block) if block.source and block.source.shown.across else block for block in blocks(laid_out)]


def _turned(block: TextTable) -> TextTable:
    """Turned table: the records side by side, the quantities as rows.

    Text that is the same in all records goes into the title; the first column whose text differs is the new header.
    """
    assert block.source
    shared: list[str] = []
    others: list[tuple[Column, list[str]]] = []
    for head, column, right, *texts in zip(block.header, block.source.columns, block.numeric, *block.rows, strict=True):
        if len(texts) > 1 and not right and len(set(texts)) == 1:
            shared.append(f"{head}: {texts[0]}")
        else:
            others.append((column._replace(units=None), texts))
    (_, heads), *rest = others
    title = f"{block.title} ({'; '.join(shared)})" if shared else block.title
    return quantities(heads, rest, title)


def step_lines(laid_out: Document) -> list[str]:
    """Lines of an explanation, for each step: name, formula, numbers, value with source, difference from the print."""
    lines = []
    for step in laid_out.steps:
        at = [say(" at {place}", place=step.at) if step.at else ""]
        for name, words in _APART.items():  # spring setting and side, if steps of the same quantity differ in them
            if len({getattr(other, name) for other in laid_out.steps if other.symbol == step.symbol}) > 1:
                at.append(translate(words[getattr(step, name)]))
        symbol = native(step.symbol)
        lines += ["", f"{symbol}{', '.join(at)}: {translate(step.name)}", f"    {symbol} = {step.formula}"]
        indent = " " * (5 + len(symbol))
        if step.substituted != step.formula:
            lines.append(f"{indent}= {step.substituted}")
        lines.append(f"{indent}= {measured(step.value, step.unit)}    [{translate(step.source).rstrip('.')}]")
        if step.print_differs:
            lines.append(say("    print differs: {what}", what=step.print_differs))
    return lines


def ranked(findings: Iterable[Finding]) -> list[Finding]:
    """Findings sorted by level, errors first."""
    return sorted(findings, key=lambda finding: ("error", "warning", "info").index(finding.level))


def findings_lines(findings: Iterable[Finding]) -> list[str]:
    """One line per finding, errors first."""
    return [
        printable(f"{translate(f.level, 'value')}: {f.message} [{f.code}{', ' + f.path if f.path else ''}]")
        for f in ranked(findings)
    ]
