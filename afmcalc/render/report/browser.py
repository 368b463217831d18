"""Printing a page to PDF with a headless browser, where there is one."""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from ...errors import AfmcalcError

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "microsoft-edge", "msedge")
_SECONDS = 120


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
