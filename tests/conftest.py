"""Fixtures and hooks of all tests: running the program in-process, a browser, a limit of time."""

import contextlib
import functools
import gc
import io
import json
import os
import shutil
import sys
import time
from collections.abc import Iterable
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings

gc.disable()  # nothing imported is ever garbage
os.environ["AFMCALC_LANG"] = "en"
os.environ["OPENBLAS_NUM_THREADS"] = "1"  # as the program does
sys.dont_write_bytecode = False  # else every worker, and every start of the program, compiles all of it anew
for variable in ("PYTHONDONTWRITEBYTECODE", "COLUMNS"):  # tables are as wide as they need to be
    os.environ.pop(variable, None)

ROOT = Path(__file__).parents[1]
CONFIGS = ROOT / "configs"
WANTED = {path.stem for path in CONFIGS.glob("*.toml") if "\n[search]" in path.read_text(encoding="utf-8")}
"""Examples with a search."""
PICKED = {f"{name}-clutch" for name in WANTED} - {"requirements-clutch", "machine-clutch"}
"""Clutches that a design of such requirements picked."""
S21 = Path(__file__).parent / "data" / "s21-fig2.toml"
"""The clutch of S21 fig. 2 with a closing spring of 2 kN, whose figures are the paper's or worked out by hand."""


def slow(*cases: Any) -> list[Any]:
    """Cases of a test that are run only with the slow tests; a tuple holds several arguments."""
    return [pytest.param(*(each if isinstance(each, tuple) else (each,)), marks=pytest.mark.slow) for each in cases]


def overrides(*changes: str) -> list[str]:
    """Changes of keys as options of the command line."""
    return [f"--set={each}" for each in changes]


def codes(findings: Iterable[Any]) -> dict[str, Any]:
    """Findings by their codes."""
    return {each.code: each for each in findings}


@dataclass(frozen=True)
class Run:
    """Exit code and output of a run of the program."""

    code: int
    out: str
    err: str

    @property
    def json(self) -> Any:
        return json.loads(self.out, parse_constant=pytest.fail)  # NaN and Infinity are no JSON


def _decoded(written: bytes, encoding: str) -> str:
    """A text in the encoding of its stream; a spec is UTF-8 whatever the stream."""
    try:
        return written.decode()
    except UnicodeDecodeError:
        return written.decode(encoding)


@pytest.fixture(scope="session")
def afmcalc():
    """Run the program in this process: ``afmcalc("torque", "x.toml", stdin="…")``."""
    from afmcalc.cli.main import main

    def run(*arguments: object, stdin: str = "", encoding: str = "utf-8") -> Run:
        out, err = io.TextIOWrapper(io.BytesIO(), encoding), io.TextIOWrapper(io.BytesIO(), encoding)
        with pytest.MonkeyPatch.context() as patch, contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            patch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(stdin.encode()), "utf-8"))
            with pytest.raises(SystemExit) as ended:
                main([str(argument) for argument in arguments])
        for stream in (out, err):
            stream.flush()
        texts = [_decoded(stream.buffer.getvalue(), encoding) for stream in (out, err)]  # type: ignore[attr-defined]
        code = ended.value.code
        return Run(code if isinstance(code, int) else 0, *texts)

    return run


@pytest.fixture(scope="session")
def answered(afmcalc):
    """Run the program as ``afmcalc`` does, but each command line once: for lines that read only files that ship."""
    return functools.cache(afmcalc)


@pytest.fixture(scope="module")
def libraries(answered):
    """Import the libraries that draw, derive and sample before the time of a test is taken."""
    for line in ("plot torque", "explain torque", "tolerance example:tolerance --set tolerance.samples=1000"):
        answered(*line.split())


@pytest.fixture(scope="session")
def parsed_package():
    """Parse every module before the time of a test is taken."""
    from sources import FILES, nodes

    for module in FILES:
        nodes(module)


@pytest.fixture(scope="session")
def chromium():
    """A headless browser, one for the whole run."""
    program = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    api = pytest.importorskip("playwright.sync_api")
    if program is None:
        pytest.skip("no chromium, chromium-browser or google-chrome on the path")
    with api.sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=program, args=["--no-sandbox", "--disable-quic"])
        yield opened
        opened.close()


FRAME = "<svg viewBox='0 0 7 4'></svg>"


@pytest.fixture
def undrawn(monkeypatch):
    """Replace the drawings of reports, which take most of their time, with empty frames."""
    monkeypatch.setattr("afmcalc.render.report.page.inline_svg", lambda sheet: FRAME)


SEARCHED: dict[tuple[Any, ...], Any] = {}


@pytest.fixture
def searched_once(monkeypatch):
    """Run the search of each spec once for the whole test run."""
    from afmcalc.analysis import design
    from afmcalc.messages import spoken

    search = design.design

    def kept(spec: Any, sort: str | None = None) -> Any:
        if (key := (spec.model_dump_json(), sort, spoken())) not in SEARCHED:
            SEARCHED[key] = search(spec, sort)
        return SEARCHED[key]

    monkeypatch.setattr(design, "design", kept)


def pytest_configure(config):
    """Set Hypothesis to a few derandomised examples per test, more of them with the slow tests."""
    if os.environ.get("AFMCALC_UPDATE"):
        config.option.markexpr = ""  # every stored output
    settings.register_profile("default", deadline=None, derandomize=True, max_examples=6)
    settings.register_profile("slow", deadline=None, derandomize=True, max_examples=50)
    settings.load_profile("default" if "not slow" in config.option.markexpr else "slow")


@pytest.fixture(scope="session", autouse=True)
def _the_whole_run():
    """Cache every event, and the parser of each command and of the whole program, for the test run."""
    from afmcalc.cli import main
    from afmcalc.drive import cases
    from afmcalc.messages import spoken

    program_of, known = main.application, {*main.COMMANDS, "help"}

    @functools.cache
    def kept(called: str, helped: bool, language: str) -> Any:
        return program_of([called, *["--help"] * helped])

    main.application = lambda line: kept(
        line[0] if line and line[0] in known else "", not {"-h", "--help"}.isdisjoint(line), spoken()
    )
    cases.kept = functools.lru_cache(4096)(cases.kept.__wrapped__)


LONGEST = 1.0  # Process time of a test that is marked neither slow nor tool, s
LOOP = 0.06  # Process time of ``_loop`` on the machine on which LONGEST was set, s


def _loop() -> float:
    begun = time.process_time()
    sum(i * i for i in range(1_000_000))
    return time.process_time() - begun


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item):
    """Fail a test that takes too long, relative to the speed that this machine has just now."""
    begun = time.process_time()
    result = yield
    taken = time.process_time() - begun
    limit = LONGEST * settings.default.max_examples / 6  # more of them where slow tests run
    own = any(map(item.get_closest_marker, ("slow", "tool")))
    if not own and taken > limit and taken > LONGEST * max(1.0, _loop() / LOOP):
        pytest.fail(f"took {taken:.1f} s of process time: make it faster, or mark it slow or tool", pytrace=False)
    return result


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item):
    """Turn a skip for a missing tool into a failure if AFMCALC_TOOLS is ``required``, unless the tool is optional."""
    report = yield
    if report.skipped and item.get_closest_marker("tool") and os.environ.get("AFMCALC_TOOLS") == "required":
        reason = str(report.longrepr[-1]) if isinstance(report.longrepr, tuple) else ""
        if "optional" not in reason and not hasattr(report, "wasxfail"):
            report.outcome, report.longrepr = "failed", f"skipped although every tool is required: {reason}"
    return report


def pytest_collection_finish(session):
    """Import what many tests need, so that none of them is charged with it."""
    if len(session.items) > 300:
        for name in ("matplotlib.figure", "scipy.stats", "sympy"):
            import_module(name)
    gc.freeze()  # what is imported by now stays
    gc.set_threshold(100_000)
    gc.enable()


def pytest_addoption(parser):
    parser.addoption("--fuzz", type=int, metavar="N", help="try N hostile specs and command lines, not the usual ones")
