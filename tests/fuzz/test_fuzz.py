"""Whatever is given: a documented exit code, quickly, and nothing in the output that was not meant for it."""

import re
import resource
import signal
import time
from contextlib import contextmanager
from unittest.mock import Mock

import pytest
from conftest import Run
from hostile import ASKED, LONG, calculations, command_lines
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

pytestmark = pytest.mark.usefixtures("libraries")
SECONDS = 2.0
LASTING = {"handbook": 60, **dict.fromkeys(LONG, 60)}
"""Command → how many times as long it may take: an event with few steps is a second of two processors."""
MEBIBYTES = 500
CONTROL = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069\ud800-\udfff]")
PURE = ("torque", "accuracy", "adjust", "overload", "pocket", "life", "check", "tolerance")


class Stuck(BaseException):
    """A run that does not end."""


@contextmanager
def at_most(seconds):
    before = signal.signal(signal.SIGALRM, Mock(side_effect=Stuck))
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def judge(run: Run, case, afmcalc) -> None:
    assert run.code in ((0, 1, 2, 3) if case.arguments[:1] in (["check"],) else (0, 2, 3)), run.err
    assert "Traceback" not in run.err
    assert not re.search("Warning|Input should|pydantic", run.err)
    assert not CONTROL.search(run.out + run.err)
    if run.code == 2:
        assert "error: " in run.err or run.err.startswith("Usage")
        # that nothing was found, what is wrong as JSON
        assert not run.out or case.arguments[0] in ("design", "check", "solve")
    assert run.err.count("\n") <= 75  # the help, where nothing is asked
    assert max(map(len, run.err.split("\n"))) <= 400
    # JSON is strict, and the spec in it gives the same result again
    printed = run.json if run.code == 0 and "--json" in case.arguments and run.out.startswith("{") else None
    if printed and case.arguments[0] in PURE:
        again = afmcalc(*(each for each in case.arguments if not each.startswith("--set")), stdin=run.out)
        assert again.code == run.code, again.err
        assert (again.json["spec"], again.json["result"]) == (printed["spec"], printed["result"])


def nothing_breaks_it(afmcalc, cases, many: int) -> None:
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    @settings(
        max_examples=many,
        suppress_health_check=list(HealthCheck),
        database=None,
        print_blob=False,
        phases=set(Phase) - {Phase.explain},  # it traces, and what is traced is slow
    )
    @given(cases)
    def whatever_is_given(case):
        began, slow = time.process_time(), LASTING.get(next(iter(case.arguments), ""), 1)
        try:
            with at_most(60 * slow):
                run = afmcalc(*case.arguments, stdin=case.stdin)
        except Stuck:
            raise AssertionError("does not end") from None
        assert time.process_time() - began < SECONDS * slow
        assert (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024 < MEBIBYTES
        judge(run, case, afmcalc)

    whatever_is_given()


@pytest.fixture(autouse=True)
def _fewer_steps(monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    monkeypatch.setattr("afmcalc.drive.integrator.MOST_STEPS", 2000)  # the same refusal, sooner


@pytest.mark.parametrize("command", ASKED)
def test_a_command_about_any_spec(command, afmcalc):
    nothing_breaks_it(afmcalc, calculations(command), 2)


def test_any_command_line(afmcalc):
    nothing_breaks_it(afmcalc, command_lines(), 8)


@pytest.mark.slow
@pytest.mark.parametrize("command", LONG)
def test_a_command_that_takes_its_time(command, afmcalc):
    nothing_breaks_it(afmcalc, calculations(command), 5)


@pytest.mark.slow
def test_many_of_each(afmcalc, request):
    """``--fuzz N`` asks for N."""
    every = st.sampled_from(ASKED).flatmap(calculations)
    nothing_breaks_it(afmcalc, every | every | every | command_lines(), request.config.getoption("--fuzz") or 250)
