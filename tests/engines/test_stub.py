"""The stub by which type checkers and editors know the quantities."""

import os
from pathlib import Path

from afmcalc.engines import named
from afmcalc.equations.terms import TERMS

HEAD = '''# ruff: noqa: E501
"""Quantities by name. AFMCALC_UPDATE=1 pytest tests/engines/test_stub.py writes this file from equations/terms.py."""

from typing import Any

from ..equations.arrays import Values

class Named:
'''


def test_the_stub_has_every_quantity():
    rows = []
    for name, term in TERMS.items():
        kind, symbol = ("Values", f"{term.symbol}, {term.unit}: ") if term.unit else ("Any", "")
        rows.append(f"    {name}: {kind}  # {symbol}{term.meaning}\n")
    path, text = Path(named.__file__).with_suffix(".pyi"), HEAD + "".join(rows)
    if os.environ.get("AFMCALC_UPDATE"):
        path.write_text(text, encoding="utf-8")
    assert text == path.read_text(encoding="utf-8"), "a quantity has changed; AFMCALC_UPDATE=1 writes the stub"
