"""Shared by all tests: running the program in-process, random clutches."""

import contextlib
import io
import json
import os
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings

# the same examples every time where a machine judges, new ones where a person looks; no verdict by the clock
settings.register_profile("person", deadline=None)
settings.register_profile("machine", deadline=None, derandomize=True)
settings.load_profile("machine" if os.environ.get("CI") else "person")

os.environ["AFMCALC_LANG"] = "en"  # whoever runs the tests
os.environ.pop("COLUMNS", None)  # tables are as wide as they need to be, whoever runs the tests

ROOT = Path(__file__).parents[1]
CONFIGS = ROOT / "configs"
S21 = Path(__file__).parent / "data" / "s21-fig2.toml"
"""The clutch of S21 fig. 2 with a closing spring of 2 kN, whose figures are the paper's or worked out by hand."""


@dataclass(frozen=True)
class Run:
    """What a run of the program left."""

    code: int
    out: str
    err: str

    @property
    def json(self) -> Any:
        return json.loads(self.out, parse_constant=_refuse)


def _decoded(written: bytes, encoding: str) -> str:
    """A text in the encoding of its stream; a spec is UTF-8 whatever the stream."""
    try:
        return written.decode()
    except UnicodeDecodeError:
        return written.decode(encoding)


def _refuse(constant: str) -> None:
    raise AssertionError(f"{constant} in JSON")


@pytest.fixture(scope="session")
def afmcalc():
    """Run the program in this process: ``afmcalc("torque", "x.toml", stdin="…")``."""
    from afmcalc.cli.entry import main

    def run(*arguments: object, stdin: str = "", encoding: str = "utf-8") -> Run:
        out, err = io.TextIOWrapper(io.BytesIO(), encoding), io.TextIOWrapper(io.BytesIO(), encoding)
        with pytest.MonkeyPatch.context() as patch, contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            patch.setattr("afmcalc.cli.entry._tune", lambda: None)
            patch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(stdin.encode()), "utf-8"))
            with pytest.raises(SystemExit) as ended:
                main([str(argument) for argument in arguments])
        for stream in (out, err):
            stream.flush()
        texts = [_decoded(stream.buffer.getvalue(), encoding) for stream in (out, err)]  # type: ignore[attr-defined]
        code = ended.value.code
        return Run(code if isinstance(code, int) else 0, *texts)

    return run


def pytest_addoption(parser):
    parser.addoption(
        "--fuzz", type=int, metavar="N", help="try N new hostile specs and command lines, not the usual 2000"
    )
