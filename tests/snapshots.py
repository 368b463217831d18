"""Stored outputs: a test compares with the file; AFMCALC_UPDATE=1 writes it anew, to be read before it is committed."""

import os
from pathlib import Path


def check(folder: Path, name: str, text: str) -> None:
    """Compare ``text`` with the stored file ``name``."""
    path = folder / "snapshots" / name
    if os.environ.get("AFMCALC_UPDATE"):
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    assert text == path.read_text(encoding="utf-8"), f"{name} differs; AFMCALC_UPDATE=1 pytest writes it anew"
