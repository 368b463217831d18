"""A document on sheets of paper, A4: PDF by Typst, tagged and to be kept (PDF/A-2a, PDF/UA-1)."""

import json
from datetime import date
from pathlib import Path

from ...messages import say
from .blocks import Document, data_of


def print_pdf(document: Document) -> bytes:
    """Return a PDF, the same bytes for the same document; its fonts are Typst's and matplotlib's alone."""
    import typst
    from matplotlib import get_data_path

    day = date.fromisoformat(document.date)
    words = {
        "where": say("where"), "contents": say("Contents"),
        "table": say("Table {number}", number="|"), "again": say("Table {number}, continued", number="|"),
        "figure": say("Figure {number}", number="|"), "sheet": say("Sheet {page} of {pages}", page="|", pages="|"),
    }  # fmt: skip
    day_of = {"year": day.year, "month": day.month, "day": day.day}
    data = data_of(document) | {"words": words, "date": day_of}
    here = Path(__file__).parent
    return typst.compile(
        here / "report.typ",
        root=here,
        font_paths=[Path(get_data_path(), "fonts", "ttf")],
        ignore_system_fonts=True,
        sys_inputs={"data": json.dumps(data, ensure_ascii=False)},
        pdf_standards=["a-2a", "ua-1"],
        timestamp=0,
    )


def lacking(document: Document) -> str:
    """Characters of a document that are in no font of the sheets: a box stands there."""
    from matplotlib import get_data_path
    from matplotlib.ft2font import FT2Font

    font = FT2Font(str(Path(get_data_path(), "fonts", "ttf", "DejaVuSans.ttf")))
    signs = {*json.dumps(data_of(document), ensure_ascii=False)}
    return "".join(sorted(sign for sign in signs if ord(sign) not in font.get_charmap()))
