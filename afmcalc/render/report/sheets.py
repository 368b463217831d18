"""A page on sheets of paper: its contents say on which of them each heading stands, a table that goes on says so."""

import io
import re
from collections.abc import Mapping
from functools import partial
from typing import Any

from ...errors import need
from ...messages import told as message
from .browser import print_pdf

_TIMES = 4
"""How often a page is printed at most: what its contents say of the sheets may move what they tell of."""
_CHROMIUM = 131
"""The first version that prints running title, number and frame of a sheet."""
_NUMBER = re.compile(r'(data-of="([^"]+)">)[^<]*')
_TABLE = re.compile(
    r'<table class="(?P<kind>[^"]*)">\s*<caption id="table-(?P<number>\d+)">(?P<caption>.*?)</caption>\s*'
    r"<thead>(?P<head>.*?)</thead>(?P<rows>.*?)</table>",
    re.DOTALL,
)


def need_pdf() -> None:
    """Require what reads a printed page.

    Raises:
        AfmcalcError: it is not installed; it says how to get it.
    """
    need("report", "pypdf")


def printed(browser: str, page: str) -> bytes:
    """Print a page, and again with what its sheets were, until what it says of them is true.

    Raises:
        AfmcalcError: the browser does not print.
    """
    last, pdf, sheets = "", b"", dict[str, int]()
    for _ in range(_TIMES):
        told = _NUMBER.sub(partial(_number, sheets=sheets), _TABLE.sub(partial(_parted, sheets=sheets), page))
        if told == last:
            break
        last, pdf = told, print_pdf(browser, told)
        sheets = sheets_of(pdf)
    return pdf


def _number(entry: re.Match[str], sheets: Mapping[str, int]) -> str:
    """Set the number of a sheet in the contents; one of two digits where none is known."""
    return f"{entry[1]}{sheets.get(entry[2], 88)}"


def _parted(table: re.Match[str], sheets: Mapping[str, int]) -> str:
    """Set a table as it stands on its sheets: on each further one below a caption and the head.

    A browser repeats a head: with the caption in it, there is room for one where a table is not known to go on.
    """
    number, head = table["number"], table["head"]
    caption = f'<tr class="caption"><th colspan="{head.count("<th ")}"'
    again = f"{caption}>{message('Table {number}, continued', number=number)}</th></tr>{head}"
    text, *rows = re.split(r"(?=<tr\b)", table["rows"])
    names = [f"row-{number}-{place}" for place, _ in enumerate(rows)]
    at = [sheets.get(name) for name in names]
    for row, name, sheet, before in zip(rows, names, at, at[:1] + at, strict=False):
        text += (again if sheet != before else "") + re.sub("<t[dh]", rf'\g<0> id="{name}"', row, count=1)
    kind = table["kind"] + " parted" * (len({*at}) > 1)
    # a browser tells the sheet of what a link leads to
    links = "".join(f'<a hidden href="#{name}"></a>' for name in names)
    return (
        f'<table class="{kind}"><thead>{caption} id="table-{number}">{table["caption"]}</th></tr>{head}</thead>'
        f"{text}</table>{links}"
    )


def printed_without_margins(pdf: bytes) -> bool:
    """Whether an old browser, which left out what stands round the text, printed a PDF."""
    version = re.search(rb"Skia/PDF m(\d+)", pdf)
    return version is not None and int(version[1]) < _CHROMIUM


def sheets_of(pdf: bytes) -> dict[str, int]:
    """Return what links lead to → the number of its sheet, from 1 on."""
    from pypdf import PdfReader

    reader: Any = PdfReader(io.BytesIO(pdf))
    places = reader.named_destinations.items()
    return {name.removeprefix("/"): reader.get_destination_page_number(place) + 1 for name, place in places}
