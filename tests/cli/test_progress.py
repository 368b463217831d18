"""The bar appears on a terminal, after a second, and nowhere else."""

import io
import sys

import pytest

from afmcalc.cli import progress


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.mark.parametrize(
    ("stream", "quiet", "patience", "shown"),
    [
        (Terminal(), False, -1.0, True),
        (Terminal(), False, 1e9, False),
        (Terminal(), True, -1.0, False),
        (io.StringIO(), False, -1.0, False),
    ],
)
def test_where_the_bar_appears(stream, quiet, patience, shown, monkeypatch):
    monkeypatch.setattr(sys, "stderr", stream)
    monkeypatch.setattr(progress, "PATIENCE", patience)
    with progress.Progress(quiet=quiet) as bar:
        bar.advance("searching", 3, 10)
        bar.advance("searching", 10, 10)
    assert ("searching" in stream.getvalue()) == shown
