"""The formats of one answer agree: table, Markdown, CSV, the CSV of Excel and JSON; a few tables are stored."""

import csv
import io
import math
import os
import re
from pathlib import Path

import pytest
from conftest import slow
from jsonschema import validate
from sources import READ

from afmcalc.analysis.registry import ANALYSES, schema

COMMANDS = {name: line.split() for name, line in READ["formats"].items()}
QUICK = ("torque", "accuracy-grid", "pocket", "check")
STORED = {name: COMMANDS[name] for name in QUICK} | {"check.ru": [*COMMANDS["check"], "--lang", "ru"]}
STORED |= {"torque.ru": ["torque", "example:indirect", "--lang", "ru"]}


@pytest.mark.parametrize("name", STORED)
def test_a_stored_table(name, answered):
    path = Path(__file__).parent / "snapshots" / f"{name}.txt"
    text = answered(*STORED[name]).out
    if os.environ.get("AFMCALC_UPDATE"):
        path.write_text(text, encoding="utf-8")
    assert text == path.read_text(encoding="utf-8"), f"{name} differs; AFMCALC_UPDATE=1 writes it anew: read it"


@pytest.mark.parametrize("name", [*QUICK, *slow(*(name for name in COMMANDS if name not in QUICK))])
def test_the_formats_of_an_answer_agree(name, answered):
    """JSON is as its schema; Markdown has the cells of the table, CSV the numbers of the JSON, Excel's those of CSV."""
    runs = [answered(*COMMANDS[name], "--format", form) for form in ("table", "json", "csv", "markdown")]
    runs.append(answered(*COMMANDS[name], "--format", "csv", "--lang", "ru"))
    assert {run.code for run in runs} == {0}
    table, printed, sheet, markdown, excel = runs
    assert list(printed.json) == ["command", "version", "spec", "result", "findings"]
    if (command := printed.json["command"]) in ANALYSES:
        validate(printed.json, schema(command))
    if command != "explain":  # whose Markdown has formulas of its own
        lines = [cells(line) for line in table.out.splitlines()]
        rows = [cells(line, "|") for line in markdown.out.splitlines() if re.match(r"\| (?!-+:? )", line)]
        assert rows
        assert [row for row in rows if row not in lines] == []
    header, *rows = wanted = list(csv.reader(io.StringIO(sheet.out)))
    assert rows
    assert {len(row) for row in rows} == {len(header)}
    result, findings = printed.json["result"], printed.json["findings"]
    intervals = [text.split() for row in rows for text in row]  # mostly of one number
    written = {float(end) for ends in intervals if all(map(is_number, ends)) for end in ends}
    assert written <= {*numbers(result), *numbers(findings)}
    lists = [part for part in result.values() if part and isinstance(part, list) and isinstance(part[0], dict)]
    flat = [{name: part for name, part in row.items() if name != "checks"} for row in lists[0]] if lists else result
    assert {*numbers(flat)} <= written
    opened = opened_with_commas(excel.out)
    told = [[float(cell) for cell in row if is_number(cell)] for row in wanted]
    assert [[cell for cell in row if isinstance(cell, float)] for row in opened] == told


def cells(line, rule=None):
    """Cells of a line of a table that are not empty; of Markdown between its rules, without what escapes a sign."""
    parts = re.split(r"(?<!\\)\|", line) if rule else re.split(r"\s{2,}", line)
    return [(re.sub(r"\\(.)", r"\1", part) if rule else part).strip() for part in parts if part.strip()]


def numbers(value):
    """Every number of a JSON value."""
    if isinstance(value, dict | list):
        for part in value.values() if isinstance(value, dict) else value:
            yield from numbers(part)
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield value


def is_number(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def opened_with_commas(text):
    """Rows as a spreadsheet with decimal commas opens them: a number with a point would be a date there."""
    assert text.startswith("\ufeff")
    rows = list(csv.reader(io.StringIO(text[1:]), delimiter=";"))
    assert not [cell for row in rows for cell in row if re.fullmatch(r"-?\d+\.\d+(e.*)?", cell)]
    comma = re.compile(r"-?\d+(,\d+)?(e[-+]\d+)?")
    return [[float(cell.replace(",", ".")) if comma.fullmatch(cell) else cell for cell in row] for row in rows]
