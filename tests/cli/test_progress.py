"""The bar appears on a terminal, after a second, with the time left, and nowhere else; nobody waits a minute unasked."""

import contextlib
import io
import itertools
import os
import re
import subprocess
import sys

import pytest
from conftest import CONFIGS, ROOT

import afmcalc
from afmcalc import progress
from afmcalc.cli.main import main
from afmcalc.errors import AfmcalcError

STUDY = CONFIGS / "tolerance.toml"
DRIVE = CONFIGS / "drive.toml"


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
    with progress.Bar(quiet=quiet, agreed=True) as bar:
        bar.advance("searching", 3, 10)
        bar.advance("searching", 10, 10)
    assert ("searching" in stream.getvalue()) == shown


LONG = {
    "tolerance": ["tolerance", STUDY, "--set", "tolerance.samples=300_000", "--threads", "2"],
    "design": ["design", CONFIGS / "requirements.toml", "--top", "9"],
    "plot": ["plot", "pareto", CONFIGS / "requirements.toml"],
    "report": ["report", STUDY],
    "simulate": [
        "simulate",
        CONFIGS / "drive.toml",
        "--set",
        "drive.event.duration=0.02",
        "--sweep",
        "drive.shaft_stiffness",
    ],
    "check": ["check", STUDY, "--set", "requirements.exceedance=0.5"],
    "heat": ["heat", DRIVE, "--set", "drive.event.duration=0.02"],
    "tolerance of a drive": [
        "tolerance",
        DRIVE,
        "--set",
        "drive.event.duration=0.004",
        "--set",
        "tolerance={samples=1000, sobol_base=64, fields={\"control_unit.gain\"={distribution='normal', spread=0.01}}}",
    ],
    "history": ["simulate", DRIVE, "--set", "drive.event.duration=0.02", "--plot"],
    "life": ["life", DRIVE, "--set", "drive.event.duration=0.02"],
    "explain": ["explain", "heat", DRIVE, "--set", "drive.event.duration=0.02"],
    "compare": ["compare", DRIVE, "--set", "drive.event.duration=0.02"],
}


def is_a_bar_and_gone(shown):
    assert re.search(r"%.*\d:\d\d:\d\d|%.*-:--:--", shown), "a share and the time left"
    assert shown.rstrip().endswith("\x1b[2K"), "the line is clean again"
    assert shown.count("\x1b[?25h") == shown.count("\x1b[?25l") > 0, "and the cursor back"


@pytest.mark.parametrize("command", LONG)
def test_a_bar_with_the_time_left(command, undrawn, monkeypatch):
    """Every command that may take long tells how far it is; what it shows is gone when it ends."""
    for name, value in {"PATIENCE": 0, "_EACH": 0, "LONG": 1e9}.items():
        monkeypatch.setattr(progress, name, value)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "100")
    out, stream = contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(Terminal())
    with out, stream as shown, pytest.raises(SystemExit) as ended:
        main([str(each) for each in LONG[command]])
    assert ended.value.code == 0
    is_a_bar_and_gone(shown.getvalue())


def test_a_bar_on_a_real_terminal():
    person, terminal = os.openpty()
    code = "from afmcalc import progress; progress.PATIENCE = progress._EACH = 0; from afmcalc.cli.main import main; main()"
    with subprocess.Popen(
        [sys.executable, "-c", code, *map(str, LONG["design"])], stdout=subprocess.DEVNULL, stderr=terminal,
        env={**os.environ, "PYTHONPATH": str(ROOT), "TERM": "xterm", "COLUMNS": "100", "CI": ""},
    ) as process:  # fmt: skip
        os.close(terminal)
        shown = b""
        with contextlib.suppress(OSError):  # the terminal ends with the process
            while more := os.read(person, 65536):
                shown += more
    os.close(person)
    assert process.returncode == 0
    is_a_bar_and_gone(shown.decode())


@pytest.mark.parametrize("command", ["tolerance", "design", "plot", "report"])
def test_what_takes_longer_than_a_minute_wants_a_yes(command, undrawn, afmcalc, monkeypatch):
    monkeypatch.setattr(progress, "PATIENCE", -1e12)
    monkeypatch.setattr(progress, "LONG", -1e12)
    clock = itertools.chain([1e9], itertools.count(0.0, 1e-3))  # nothing has been waited for: all is left
    monkeypatch.setattr(progress.time, "monotonic", lambda: next(clock))
    run = afmcalc(*LONG[command])
    assert (run.code, run.out) == (2, "")
    assert re.fullmatch("error: this takes about 0 min: --yes goes on with it, or ask for less\n", run.err)
    assert afmcalc(*LONG[command], "--yes").code == 0


def test_how_long_is_told_from_what_is_behind(monkeypatch):
    now = iter([0.0, 5.0, 6.0])
    monkeypatch.setattr(progress.time, "monotonic", lambda: next(now))
    bar = progress.Bar(quiet=True)
    bar.advance("sampling", 1, 1000)
    with pytest.raises(AfmcalcError, match="about 17 min"):
        bar.advance("sampling", 2, 1000)


@contextlib.contextmanager
def clock(monkeypatch, *, agreed=False):
    """A bar, and a way to let time pass."""
    now = [0.0]
    monkeypatch.setattr(progress.time, "monotonic", lambda: now[0])

    def passes(seconds):
        now[0] += seconds

    with progress.Bar(quiet=True, agreed=agreed):
        yield passes


def test_it_is_too_late_to_refuse_when_less_is_left_than_is_behind(monkeypatch):
    with clock(monkeypatch) as passes:
        progress.tell("searching", 0, 10)
        for done in range(1, 11):
            passes(5.5 if done < 6 else 9)  # 55 s to go by at first, 72.5 s as it turns out
            progress.tell("searching", done, 10)


@pytest.mark.parametrize(("first", "refused"), [(1.0, False), (5.0, False), (15.0, True)])
def test_one_event_of_several_tells_what_all_take(first, refused, monkeypatch):
    """A trial of the work's own cost: one of five parts, which cannot itself say how long it takes."""

    def all_five(passes):
        for _ in progress.counted("simulating", range(5)):
            for _ in range(100):
                passes(first / 100)
                progress.pulse()

    with clock(monkeypatch) as passes:
        if refused:
            with pytest.raises(AfmcalcError, match="takes about 1 min"):
                all_five(passes)
        else:
            all_five(passes)
    with clock(monkeypatch, agreed=True) as passes:
        all_five(passes)


def test_nobody_is_told_when_nobody_waits():
    progress.pulse()
    assert [*progress.counted("simulating", "abc")] == [*"abc"]
    with pytest.raises(ZeroDivisionError), progress.Bar(quiet=True):
        raise ZeroDivisionError
    assert progress.WATCHER.get() is None


def test_a_slow_event_is_told_of_while_it_lasts(monkeypatch):
    """At every step of an integration, of which each is a matter of milliseconds."""
    told = []

    class Watcher:
        def advance(self, work, done, total):
            told.append((work, done, total))

        def pulse(self):
            told.append("on")

    waiting = progress.WATCHER.set(Watcher())
    afmcalc.load(DRIVE).simulate()
    progress.WATCHER.reset(waiting)
    parts = [each for each in told if each != "on"]
    assert parts == [("simulating the event", done, 3) for done in range(4)]
    between = [told.index(part) for part in parts]
    assert all(later - earlier > 50 for earlier, later in itertools.pairwise(between))
