"""A page on sheets of paper, printed by a headless browser where there is one.

Its contents say on which sheet each heading stands; a table that goes on says so.
"""

import io
import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

from ...errors import AfmcalcError
from ...messages import told as message

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "microsoft-edge", "msedge")
_SECONDS = 120
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


def find_browser() -> str:
    """Return the program of a headless browser: AFMCALC_BROWSER, or one of ``NAMES`` on the path.

    Raises:
        AfmcalcError: there is none.
    """
    chosen = os.environ.get("AFMCALC_BROWSER")
    browser = next((path for name in ((chosen,) if chosen else NAMES) if (path := shutil.which(name))), None)
    if browser is None:
        looked = chosen or ", ".join(NAMES)
        raise AfmcalcError(
            "no headless browser found that prints a PDF (looked for {looked}): install Chromium, name one in "
            "AFMCALC_BROWSER, or write the HTML file alone and print it from any browser",
            looked=looked,
        )
    return browser


def arguments(browser: str, profile: str) -> list[str]:
    """Command line that starts a browser without window, network chatter or traces."""
    options = [
        "--headless", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
        "--disable-component-update", "--disable-sync", f"--user-data-dir={profile}",
    ]  # fmt: skip
    # Chromium refuses to start its sandbox as root (containers); the page has neither script nor network
    sandbox = ["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []
    return [browser, *options, *sandbox]


def print_pdf(browser: str, page: str) -> bytes:
    """Print a page; the browser never outlives this process.

    Raises:
        AfmcalcError: the browser does not start, does not end, or prints no whole PDF.
    """
    with tempfile.TemporaryDirectory(prefix="afmcalc-") as folder:
        source, target = Path(folder, "report.html"), Path(folder, "report.pdf")
        source.write_text(page, encoding="utf-8")
        printing = [
            "--no-pdf-header-footer",
            "--generate-pdf-document-outline",
            f"--print-to-pdf={target}",
            source.as_uri(),
        ]
        try:
            code = subprocess.run(
                [*arguments(browser, str(Path(folder, "profile"))), *printing],
                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=_SECONDS, check=False,
            ).returncode  # fmt: skip
        except (OSError, subprocess.TimeoutExpired) as error:
            raise AfmcalcError("PDF: {browser} did not print: {why}", browser=browser, why=error) from None
        content = target.read_bytes() if target.is_file() else b""
    if code or not (content.startswith(b"%PDF-") and content.rstrip().endswith(b"%%EOF")):
        raise AfmcalcError("PDF: {browser} did not print a whole PDF (exit code {code})", browser=browser, code=code)
    return content


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
