"""A page on sheets of paper: its contents say on which of them each heading stands."""

import io
import re
from collections.abc import Mapping
from typing import Any

from ...errors import need
from .browser import print_pdf

_TIMES = 4
"""How often a page is printed at most: what its contents say of the sheets may move what they tell of."""
_PAGE = re.compile(r'(data-of="([^"]+)">)[^<]*')


def need_pdf() -> None:
    """Require what reads a printed page.

    Raises:
        AfmcalcError: it is not installed; it says how to get it.
    """
    need("report", "pypdf")


def printed(browser: str, page: str) -> bytes:
    """Print a page, and again with the numbers of its sheets in its contents, until these are true.

    Raises:
        AfmcalcError: the browser does not print.
    """
    sheets: Mapping[str, int] = {}
    for _ in range(_TIMES):
        pdf = print_pdf(browser, _PAGE.sub(lambda span: f"{span[1]}{sheets.get(span[2], 88)}", page))
        if sheets == (sheets := sheets_of(pdf)):
            break
    return pdf


def sheets_of(pdf: bytes) -> dict[str, int]:
    """Return what links lead to → the number of its sheet, from 1 on."""
    from pypdf import PdfReader

    reader: Any = PdfReader(io.BytesIO(pdf))
    places = reader.named_destinations.items()
    return {name.removeprefix("/"): reader.get_destination_page_number(place) + 1 for name, place in places}
