"""Ratios against a baseline, both measured in the same run: machines are noisy, ratios less so."""

import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable

BASELINE = [sys.executable, "-c", "import typer, rich.table, pydantic, numpy"]
BYTECODE = tempfile.TemporaryDirectory(prefix="bytecode-")


def _seconds(action: Callable[[], object]) -> float:
    start = time.perf_counter()
    action()
    return time.perf_counter() - start


def median_ratio(action: Callable[[], object], baseline: Callable[[], object], pairs: int) -> float:
    """Median over pairs of runs, one after the other, of time(action)/time(baseline)."""
    action(), baseline()
    return statistics.median(_seconds(action) / _seconds(baseline) for _ in range(pairs))


def process(command: list[str]) -> Callable[[], object]:
    """A whole process, output thrown away."""
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    # a checkout may be forbidden to keep the bytecode that pip compiles
    keeping = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    return lambda: subprocess.run(command, env={**keeping, "PYTHONPYCACHEPREFIX": BYTECODE.name}, check=True, **quiet)
