"""The bar appears on a terminal, after a second, with the time left, and nowhere else."""

import io
import sys
from types import SimpleNamespace

import pytest
from conftest import slow

from afmcalc import progress
from afmcalc.cli.options import Common

LONG = """tolerance example:tolerance --set tolerance.samples=1000 --set tolerance.sobol_base=64
design example:requirements --set search.friction_group.pairs=8 --set search.control_unit.gain=0.5:1:4
plot pareto example:requirements --set search.friction_group.pairs=8 --set search.control_unit.gain=0.5:1:4
simulate example:drive --set drive.event.duration=0.002 --sweep drive.shaft_stiffness=1000,2000
check example:tolerance --set tolerance.samples=1000 --set tolerance.sobol_base=64 --set requirements.exceedance=0.5
life example:drive --set drive.event.duration=0.004""".splitlines()
"""Every command that may take long."""


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.fixture
def passes(monkeypatch):
    """A clock that stands still, and a way to let time pass."""
    now = [0.0]
    monkeypatch.setattr(progress.time, "monotonic", lambda: now[0])

    def passed(seconds):
        now[0] += seconds

    return passed


WHERE = [(Terminal, False, True), (Terminal, True, False), (io.StringIO, False, False)]


@pytest.mark.parametrize(("stream", "quiet", "shown"), WHERE)
def test_where_and_when_the_bar_appears(stream, quiet, shown, passes, monkeypatch):
    """After a second; what it shows is gone when it ends."""
    monkeypatch.setattr(sys, "stderr", stream())
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "100")
    with Common("design", quiet=quiet).bar():
        progress.tell("searching", 0, 10)
        passes(0.9)
        progress.tell("searching", 1, 10)
        assert sys.stderr.getvalue() == ""
        passes(4.1)
        progress.tell("searching", 4, 10)
    written = sys.stderr.getvalue()
    assert (" 40%" in written) == ("searching" in written) == shown
    assert written.rstrip().endswith("\x1b[2K") == shown, "what it showed is gone"
    assert written.count("\x1b[?25h") == written.count("\x1b[?25l") == shown, "the cursor is there again"


@pytest.mark.parametrize("line", [*LONG[:2], *slow(*LONG[2:])])
def test_a_command_that_may_take_long_tells_how_far_it_is(line, afmcalc):
    shares = set()
    watcher = SimpleNamespace(advance=lambda work, done, total: shares.add(done / total))
    token = progress.WATCHER.set(watcher)
    assert afmcalc(*line.split()).code == 0
    progress.WATCHER.reset(token)
    assert max(shares) == 1
    assert any(0 < share < 1 for share in shares)
