"""The bar appears on a terminal, after a second, with the time left, and nowhere else; nobody waits a minute unasked."""

import io
import itertools
import re
import sys

import pytest

from afmcalc import progress
from afmcalc.errors import AfmcalcError

LONG = """tolerance example:tolerance --set tolerance.samples=2000 --set tolerance.sobol_base=64
design example:requirements --set search.friction_group.pairs=8
plot pareto example:requirements --set search.friction_group.pairs=8
simulate example:drive --set drive.event.duration=0.004 --sweep drive.shaft_stiffness=1000,2000
check example:tolerance --set tolerance.samples=2000 --set tolerance.sobol_base=64 --set requirements.exceedance=0.5
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
    monkeypatch.setattr(progress, "LONG", 60.0)

    def passed(seconds):
        now[0] += seconds

    return passed


WHERE = [(Terminal, False, True), (Terminal, True, False), (io.StringIO, False, False)]


@pytest.mark.parametrize(("stream", "quiet", "shown"), WHERE)
def test_where_and_when_the_bar_appears(stream, quiet, shown, passes, monkeypatch):
    """After a second, ten times a second; what it shows is gone when it ends."""
    monkeypatch.setattr(sys, "stderr", stream())
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "100")
    with progress.Bar(quiet=quiet, agreed=True) as bar:
        bar.advance("searching", 0, 10)
        passes(0.9)
        bar.advance("searching", 1, 10)
        assert sys.stderr.getvalue() == ""
        passes(4.1)
        bar.advance("searching", 4, 10)
        written = sys.stderr.getvalue()
        assert (" 40%" in written) == ("searching" in written) == shown
        passes(0.05)
        bar.advance("searching", 5, 10)
        assert sys.stderr.getvalue() == written
        passes(1)
        bar.advance("searching", 8, 10)
        assert (" 80%" in sys.stderr.getvalue()) == shown
    written = sys.stderr.getvalue()
    assert written.rstrip().endswith("\x1b[2K") == shown, "what it showed is gone"
    assert written.count("\x1b[?25h") == written.count("\x1b[?25l") == shown, "the cursor is there again"


@pytest.mark.parametrize("line", LONG)
def test_a_command_that_may_take_long_tells_how_far_it_is(line, afmcalc, monkeypatch):
    told = []
    monkeypatch.setattr(progress.Bar, "advance", lambda self, work, done, total: told.append((work, done, total)))
    assert afmcalc(*line.split()).code == 0
    shares = {done / total for _, done, total in told}
    assert max(shares) == 1
    assert any(0 < share < 1 for share in shares)


@pytest.mark.parametrize("line", LONG[:3])
def test_what_takes_longer_than_a_minute_wants_a_yes(line, afmcalc, monkeypatch):
    """Here anything does: nothing has been waited for, all is left."""
    monkeypatch.setattr(progress, "PATIENCE", -1e12)
    monkeypatch.setattr(progress, "LONG", -1e12)
    clock = itertools.chain([1e9], itertools.count(0.0, 1e-3))
    monkeypatch.setattr(progress.time, "monotonic", lambda: next(clock))
    run = afmcalc(*line.split())
    assert (run.code, run.out) == (2, "")
    assert re.fullmatch("error: this takes about 0 min: --yes goes on with it, or ask for less\n", run.err)
    assert afmcalc(*line.split(), "--yes").code == 0


def is_refused(work, said):
    """Whether work takes too long, and how long; agreed to it goes on."""
    if said:
        with pytest.raises(AfmcalcError, match=said), progress.Bar(quiet=True):
            work()
    with progress.Bar(quiet=True, agreed=bool(said)):
        work()


@pytest.mark.parametrize(("first", "then", "refused"), [
    ([5.0], 1.0, "about 8 min"),  # 1 of 100 took 5 s: 495 s are left
    ([0.4], 0.4, None),  # too soon to tell, then 40 s in all
    ([5.5] * 6, 9.0, None),  # 55 s at first, 69 as it turns out: less is left than is behind
])  # fmt: skip
def test_how_long_is_told_from_what_is_behind(first, then, refused, passes):
    total = 10 if len(first) > 1 else 100

    def work():
        for done in range(total + 1):
            progress.tell("sampling", done, total)
            passes(first[done] if done < len(first) else then)

    is_refused(work, refused)


@pytest.mark.parametrize(("first", "refused"), [(1.0, None), (5.0, None), (15.0, "about 1 min")])
def test_one_event_of_several_tells_what_all_take(first, refused, passes):
    """A trial of the work's own cost: one of five parts, which cannot itself say how long it takes."""

    def all_five():
        for _ in progress.counted("simulating", range(5)):
            for _ in range(100):
                passes(first / 100)
                progress.pulse()

    is_refused(all_five, refused)
