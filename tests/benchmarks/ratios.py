"""Ratios against a baseline, both measured in the same run: machines are noisy, ratios less so."""

import statistics
import subprocess
import sys
import time
from collections.abc import Callable

BASELINE = [sys.executable, "-c", "import typer, rich.table, pydantic, numpy"]


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
    return lambda: subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
