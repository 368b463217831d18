"""Whatever is given: a documented exit code, quickly, and nothing in the output that was not meant for it."""

import re
import resource
import signal
import time
from contextlib import contextmanager

from conftest import Run, several
from hostile import CASES
from hypothesis import HealthCheck, Phase, given, settings

SECONDS = 2.0
LASTING = 60
MEBIBYTES = 500
CONTROL = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069\ud800-\udfff]")


class Stuck(BaseException):
    """A run that does not end."""


@contextmanager
def at_most(seconds):
    def stop(number, frame):
        raise Stuck

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def judge(run: Run, case, afmcalc) -> None:
    assert run.code in (0, 1, 2, 3), run.err
    assert run.code != 1 or case.arguments[0] in ("check", "reproduce")
    assert "Traceback" not in run.err
    assert "Warning" not in run.err
    assert not CONTROL.search(run.out + run.err)
    if run.code == 2:
        assert "error: " in run.err or run.err.startswith("Usage")
        assert not run.out or case.arguments[0] in ("design", "check")  # that nothing was found, what is wrong as JSON
    assert run.err.count("\n") <= 75  # the help, where nothing is asked
    assert max(map(len, run.err.split("\n"))) <= 400
    if run.code == 0 and "--json" in case.arguments and run.out.startswith("{"):
        accepted_back(run, case, afmcalc)


def accepted_back(run: Run, case, afmcalc) -> None:
    """JSON is strict, and the spec in it gives the same result again."""
    printed = run.json
    if case.arguments[0] not in (
        "torque",
        "accuracy",
        "adjust",
        "overload",
        "synthesize",
        "life",
        "check",
        "tolerance",
    ):
        return
    arguments = [each for each in case.arguments if not each.startswith("--set")]
    again = afmcalc(*arguments, stdin=run.out)
    assert again.code == run.code, again.err
    assert again.json["spec"] == printed["spec"]
    assert again.json["result"] == printed["result"]


def test_nothing_breaks_it(afmcalc, request, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    asked = request.config.getoption("--fuzz")
    if not asked:
        monkeypatch.setattr("afmcalc.drive.trip.MOST_STEPS", 2000)  # the same refusal, sooner
    for lasting in ("simulate", "handbook"):  # what they import and draw first is no part of the time of a case
        afmcalc(lasting)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    @settings(
        max_examples=asked or several(50, 2000),
        derandomize=not asked,
        suppress_health_check=list(HealthCheck),
        database=None,
        print_blob=False,
        phases=set(Phase) - {Phase.explain},  # it traces, and what is traced is slow
    )
    @given(CASES)
    def whatever_is_given(case):
        began = time.process_time()
        # an event is a second of two processors, and more with its refusals as they are; the handbook is all there is
        events, whole = case.arguments[:1] in (["simulate"], ["heat"]), case.arguments[:1] == ["handbook"]
        slow = LASTING if whole or (asked and events) else 5 if events else 1
        try:
            with at_most(10 * slow):
                run = afmcalc(*case.arguments, stdin=case.stdin)
        except Stuck:
            raise AssertionError("does not end") from None
        assert time.process_time() - began < SECONDS * slow
        grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
        assert grown < MEBIBYTES
        judge(run, case, afmcalc)

    whatever_is_given()
