"""Specs and command lines as nobody means them: a documented exit code, quickly, and nothing shown that was not meant."""

import copy
import json
import re
import resource
import signal
import time
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple
from unittest.mock import Mock

import pytest
from conftest import CONFIGS, PICKED, WANTED, Run
from hypothesis import HealthCheck, Phase, assume, given, settings
from hypothesis import strategies as st
from sources import table
from strategies import CHARACTERS

from afmcalc.analysis.registry import ANALYSES, EXPLAINED, PLOTS
from afmcalc.cli.main import COMMANDS
from afmcalc.cli.options import Common
from afmcalc.spec import make_spec, resolved
from afmcalc.spec.keys import ALIASES
from afmcalc.spec.parse import example_names


class Case(NamedTuple):
    """A run: arguments, and the text of standard input."""

    arguments: list[str]
    stdin: str


SPECS = [name for name in example_names() if name not in {"drive", *WANTED, *PICKED}]
"""Examples of a clutch, except the slow one with a drive, which only the commands that need a drive get."""
_SMALL = {"samples": 1000, "sobol_base": 64}
"""Size of a tolerance study: a large one takes time and finds nothing more."""


def _load(name: str) -> dict[str, Any]:
    data = tomllib.loads((CONFIGS / f"{name}.toml").read_text(encoding="utf-8"))
    data.get("tolerance", {}).update(_SMALL)
    if name in ("default", "indirect"):
        data["fatigue"] |= {"mean_stress_sensitivity": 0.1, "ultimate_strength": "900 MPa"}
    if name == "requirements":
        data["search"] |= {"mean_radius": [0.1, 0.13], "gain": [0.3, 0.6, 1.0], "pairs": [4, 8, 16]}
    return data


BASES = {name: _load(name) for name in (*SPECS, "requirements")}
BASES["drive"] = BASES["default"] | table("hostile")
_SPLINES = {"spline_friction": 0.1, "inner_spline_radius": "75 mm", "outer_spline_radius": "125 mm"}
BASES["drive"]["friction_group"] = BASES["default"]["friction_group"] | _SPLINES

RESOLVED = {name: resolved(make_spec(BASES[name])) for name in (*SPECS, "drive")}

_MAGNITUDES = [0, 1, 5e-324, 1e-310, 1e-200, 1e-160, 1e-30, 1e30, 1e120, 1e160, 1e200, 1e300, 1.7e308, 1e400]
NUMBERS = st.one_of(
    st.sampled_from([each for size in _MAGNITUDES for each in (size, -size)]),
    st.sampled_from([2, 3, 7, 1000, 10**7, 2**63, 10**25, 0.1, 0.3, 0.8, 1.5, True, False, float("nan")]),
    st.floats(allow_nan=False),
    st.floats(1e-6, 1e6),
)
_SIZES = st.one_of(
    st.sampled_from([1e-300, 1e-160, 1e-30, 1e-9, 1e-3, 0.5, 1.0, 2.0, 1e3, 1e9, 1e30, 1e160, 1e300]),
    st.floats(1e-12, 1e12),
)
SIGNS = ["\x1b[31m", "\x7f", "\x9b2J", "\u202e", "\u2066", "\ufeff", "\x00", "\n", *"éЖ漢😀\ud800", "$x^2$"]
TEXTS = st.one_of(
    st.sampled_from(["", " ", "_x", "a_b", "=1+1", "@x", "-", "--", "5 kN", "5 mm", "-1 N", "1e999 N", "1e-400 mm", "30 deg", "89.999 deg"]),
    st.sampled_from(["5,5 mm", "5 N*m^2", "100 %", "1e300 %", "5 kH", "moulded-dry", "min-friction", "indirect", "x" * 300, "1/0", "{", "[1"]),
    st.lists(st.one_of(st.sampled_from(SIGNS), CHARACTERS), max_size=5).map("".join),
)  # fmt: skip
INNER = st.one_of(st.sampled_from(["min", "max", "mean", "distribution", "spread"]), TEXTS)
MANY = (st.lists(NUMBERS, max_size=3), st.dictionaries(INNER, NUMBERS, max_size=3))
VALUES = st.one_of(NUMBERS, NUMBERS, NUMBERS, TEXTS, *MANY)


def paths(data: dict[str, Any], above: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """Every key of nested tables."""
    for name, value in data.items():
        yield (*above, name)
        if isinstance(value, dict):
            yield from paths(value, (*above, name))


_KNOWN = dict.fromkeys(RESOLVED, list(dict.fromkeys(path for base in RESOLVED for path in paths(BASES[base]))))
_KNOWN["requirements"] = [*paths(BASES["requirements"])]


@st.composite
def outsized(draw: st.DrawFn, name: str) -> dict[str, Any]:
    """A shipped example, SI, with some numbers of another order of magnitude: most of these specs are still valid."""
    data = copy.deepcopy(RESOLVED[name])
    numbers = [path for path in paths(data) if isinstance(_at(data, path), float)]
    frictions = [path for path in numbers if path[0] == "friction"]
    for path in draw(st.lists(st.sampled_from(numbers), min_size=1, max_size=3)):
        size = draw(_SIZES)
        # all frictions together: else min ≤ mean ≤ max would fail, and hide most other faults
        for each in frictions if path in frictions else [path]:
            _at(data, each[:-1])[each[-1]] *= size
    if draw(st.booleans()):
        data["friction_group"]["pairs"] = draw(st.sampled_from([1, 2, 3, 8, 100, 10**6, 10**15]))
    return data


def _at(data: Any, path: tuple[str, ...]) -> Any:
    for name in path:
        data = data[name]
    return data


@st.composite
def tables(draw: st.DrawFn, name: str) -> dict[str, Any]:
    """A shipped example in which up to four keys are changed or removed."""
    data = copy.deepcopy(BASES[name])
    for _ in range(draw(st.integers(0, 4))):
        *blocks, last = draw(st.sampled_from(_KNOWN[name]))
        block: Any = data
        for each in blocks:
            block = block.setdefault(each, {})
            if not isinstance(block, dict):
                break
        else:
            kind = draw(st.integers(0, 9))
            if kind:
                block[last if kind > 1 else draw(TEXTS)] = draw(VALUES)
            else:
                block.pop(last, None)
    return data


NAMES = st.one_of(st.sampled_from([*ALIASES, "zC", "dT", "closing_spring.force", "friction", "name"]), TEXTS)
RANGES = st.one_of(
    st.just(""),
    st.builds("={}:{}:{}".format, NUMBERS, NUMBERS, st.integers(-1, 60)),
    st.builds(lambda values: "=" + ",".join(map(str, values)), st.lists(NUMBERS, min_size=1, max_size=4)),
    TEXTS.map("={}".format),
)
_SYMBOLS = st.sampled_from([*ALIASES, "zC", "dT", "control_unit.gain", "friction_group.pairs", "adjustment.margin"])
_SWEPT = st.builds("--sweep={}".format, _SYMBOLS)
_GIVEN = st.builds("--sweep={}={}:{}:{}".format, _SYMBOLS, _SIZES, _SIZES, st.integers(2, 60))
SWEEPS = st.one_of(st.builds("--sweep={}{}".format, NAMES, RANGES), _SWEPT, _SWEPT, _GIVEN)
SETS = st.builds("--set={}={}".format, NAMES, st.one_of(NUMBERS.map(str), TEXTS))
_AIMS = st.sampled_from(["accuracy_factor", "nominal_torque", "torque_max", "scatter", "travel_max"])
TARGETS = st.builds("{}={}".format, _AIMS | TEXTS, NUMBERS | TEXTS) | st.builds("{}={}".format, _AIMS, _SIZES)
_FORMATS = [["--json"], ["--json"], ["--json"], [], ["--format=csv"], ["--format=markdown"]]
OWN: dict[str, Any] = {
    "torque": st.lists(st.one_of(NUMBERS, TEXTS).map("--friction={}".format), max_size=2),
    "accuracy": st.lists(SWEEPS, max_size=2),
    "overload": st.lists(SWEEPS, max_size=2),
    "life": st.tuples(
        st.sampled_from(["--model=amplitude", "--model=mean-stress", "--model=goodman"]), st.one_of(st.just("--json"), SWEEPS)
    ),
    "solve": st.builds(lambda name, *more: [f"--for={name}", *more], st.one_of(st.sampled_from(["C", "F", "z", "R", "c1"]), NAMES), TARGETS),
    "explain": st.sampled_from(EXPLAINED).map(lambda each: [each]),
    "plot": st.sampled_from([*PLOTS]).map(lambda each: [each]),
}  # fmt: skip
"""Command → its own arguments, positional ones first, besides those of all commands."""
_NEEDED = {"design": "requirements", "tolerance": "tolerance", "simulate": "drive", "effects": "drive"}
"""Command → the only example it can be asked about."""
LONG = ("simulate", "effects", "springs", "design")  # Commands that integrate and search
ASKED = [*(name for name in ANALYSES if name in COMMANDS and name not in ("papers", *LONG)), "plot"]


@st.composite
def calculations(draw: st.DrawFn, command: str) -> Case:
    """A command that is asked about a hostile spec."""
    name = _NEEDED.get(command) or draw(st.sampled_from(SPECS))
    own = [*draw(OWN.get(command, st.just([])))]
    given = draw(st.sampled_from(_FORMATS)) if command != "plot" else []
    override = [draw(SETS)] if draw(st.integers(0, 5)) == 0 else []
    spec = draw(outsized(name) if name in RESOLVED and draw(st.integers(0, 3)) else tables(name))
    return Case([command, *own, "-", *given, *override], json.dumps(spec))


WORDS = st.one_of(
    st.sampled_from([*COMMANDS, *PLOTS, *ALIASES, "-", "--", "-h", "--version", "--help"]),
    st.sampled_from([f"--{each}" for each in Common.__dataclass_fields__] + ["--sweep", "--for", "--pick", "--id", "--paper", "--model"]),
    st.sampled_from([str(CONFIGS / f"{name}.toml") for name in ("default", "indirect", "materials")]),
    st.one_of(TEXTS, SETS, SWEEPS, TARGETS, NUMBERS.map(str)),
)  # fmt: skip
_SLOW = {"report", "papers", "handbook", "serve", *LONG}
"""Commands that are always slow: what they show, others show too; serve does not end (see tests/web)."""
_WRITE = {"init", "-o", "--output", "--save", "--force"}
"""Words that would make the program write files, which tests/cli/test_files.py tests."""


def _is_quick(words: list[str]) -> bool:
    return not any(each in _SLOW | _WRITE or each.startswith(("--o", "-o")) for each in words)


@st.composite
def command_lines(draw: st.DrawFn) -> Case:
    """Words in any order, the first of them mostly a command."""
    first = [draw(st.sampled_from([*COMMANDS]))] if draw(st.integers(0, 7)) else []
    words = [*first, *draw(st.lists(WORDS, max_size=5))]
    assume(_is_quick(words))
    return Case(words, draw(st.sampled_from(["", "{}", "name = 1", "\x00", json.dumps(BASES["default"])])))


pytestmark = pytest.mark.usefixtures("libraries")
SECONDS = 2.0
LASTING = {"handbook": 60, **dict.fromkeys(LONG, 60)}
"""Command → factor on the time it may take: an event with few steps takes a second of two processors."""
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
        # the result without a solution, or the problems as JSON
        assert not run.out or case.arguments[0] in ("design", "check", "solve")
    assert run.err.count("\n") <= 75  # lines of the help, which is shown if nothing is asked
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
    monkeypatch.setattr("afmcalc.drive.integrator.MOST_STEPS", 2000)  # too many steps are refused as usual, but sooner


@pytest.mark.parametrize("command", ASKED)
def test_a_command_about_any_spec(command, afmcalc):
    nothing_breaks_it(afmcalc, calculations(command), 2)


def test_any_command_line(afmcalc):
    nothing_breaks_it(afmcalc, command_lines(), 8)


@pytest.mark.slow
@pytest.mark.parametrize("command", LONG)
def test_a_command_that_takes_its_time(command, afmcalc):
    nothing_breaks_it(afmcalc, calculations(command), 3)


@pytest.mark.slow
def test_many_of_each(afmcalc, request):
    """``--fuzz N`` sets the number of cases."""
    every = st.sampled_from(ASKED).flatmap(calculations)
    nothing_breaks_it(afmcalc, every | every | every | command_lines(), request.config.getoption("--fuzz") or 100)
