"""A document on A4 sheets of paper: PDF by Typst, tagged and suitable for archives (PDF/A-2a, PDF/UA-1)."""

import json
from datetime import date
from pathlib import Path

from ...messages import say
from .blocks import Document, data_of


def print_pdf(document: Document) -> tuple[bytes, str]:
    """PDF of a document (the same bytes each time), and the characters that no font has and that are shown as boxes.

    The only fonts are those of Typst and of matplotlib.
    """
    import typst
    from matplotlib import get_data_path
    from matplotlib.ft2font import FT2Font

    day = date.fromisoformat(document.date)
    words = {
        "where": say("where"), "contents": say("Contents"),
        "table": say("Table {number}", number="|"), "again": say("Table {number}, continued", number="|"),
        "figure": say("Figure {number}", number="|"), "sheet": say("Sheet {page} of {pages}", page="|", pages="|"),
    }  # fmt: skip
    more = {"words": words, "date": {"year": day.year, "month": day.month, "day": day.day}}
    data = json.dumps(data_of(document) | more, ensure_ascii=False, default=data_of)
    fonts, here = Path(get_data_path(), "fonts", "ttf"), Path(__file__).parent
    letters = FT2Font(str(fonts / "DejaVuSans.ttf")).get_charmap()
    pdf = typst.compile(
        here / "report.typ",
        root=here,
        font_paths=[fonts],
        ignore_system_fonts=True,
        sys_inputs={"data": data},
        pdf_standards=["a-2a", "ua-1"],
        timestamp=0,
    )
    return pdf, "".join(sorted(sign for sign in {*data} if ord(sign) not in letters))
