"""How long a person waits: CPU seconds of every command on every shipped example, start-up included.

    python tests/benchmarks/waits.py simulate check --example drive    # all commands on all examples if none is named

Each row is a process of its own; the ratio is to ``python -c "import numpy, scipy.integrate"``, run before it.
With ``--start`` the wall time of three short commands against the import of the program's own four libraries.
"""

import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[2]
CALCULATING = ["-c", "import numpy, scipy.integrate"]
STARTING = ["-c", "import typer, rich.table, pydantic, numpy"]
PROGRAM = ["-m", "afmcalc"]
EVERY = (
    *("torque", "accuracy", "accuracy --sweep C", "adjust", "overload", "pocket", "life", "effects", "layout"),
    *("check", "simulate", "springs", "tolerance", "solve accuracy_factor=2", "explain check"),
    *("compare --variants", "plot torque -o torque.svg", "report -o report.html", "report -o report.pdf"),
)
"""Commands about a clutch; ``design`` is asked of the examples that search."""
ALONE = ("papers --claims", "handbook -o handbook.html", "papers", "list materials", "list examples", "--help")
WAIT = 300.0  # A command is ended after this time, s


def commands(chosen: list[str], example: str | None) -> Iterator[list[str]]:
    """Command lines asked for: each command on each example."""
    for path in sorted((ROOT / "configs").glob("*.toml")):
        searches = "\n[search]" in path.read_text(encoding="utf-8")
        for command in ("design",) if searches else EVERY:
            words = command.split()
            if (not chosen or words[0] in chosen) and example in (None, path.stem):
                yield [words[0], *_about(words, f"example:{path.stem}")]
    for command in ALONE if example is None else ():
        if not chosen or command.split()[0] in chosen:
            yield command.split()


def _about(words: list[str], example: str) -> list[str]:
    return [words[1], example, *words[2:]] if words[0] in ("plot", "explain") else [example, *words[1:]]


def cpu_seconds(arguments: list[str], folder: str) -> tuple[float, int]:
    """CPU time of a process with all that it starts, and its exit code."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    quiet = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    try:
        code = subprocess.run(
            [sys.executable, *arguments], cwd=folder, env=_environment(), timeout=WAIT, check=False, **quiet
        ).returncode
    except subprocess.TimeoutExpired:
        code = -1
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, code


def _environment() -> dict[str, str]:
    paths = [str(ROOT), *filter(None, [os.environ.get("PYTHONPATH")])]
    kept = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    return {**kept, "PYTHONPATH": os.pathsep.join(paths)}


def start(folder: str, pairs: int = 11) -> None:
    """Print the wall time of short commands over that of the imports, median of pairs."""
    for words in (["torque", "example:default", "--json"], ["torque", "example:default"], ["--help"]):
        ratios = []
        for _ in range(pairs + 1):
            times = []
            for arguments in ([*PROGRAM, *words], STARTING):
                begun = time.perf_counter()
                cpu_seconds(arguments, folder)
                times.append(time.perf_counter() - begun)
            ratios.append(times[0] / times[1])
        print(f"{' '.join(words):<40}{statistics.median(ratios[1:]):6.2f} times the imports")


def main() -> None:
    """Print a row for each command line, and the sum of each command."""
    parser = argparse.ArgumentParser()
    parser.add_argument("commands", nargs="*")
    parser.add_argument("--example")
    parser.add_argument("--start", action="store_true")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        if asked.start:
            start(folder)
            return
        print(f"{'command':<60}{'CPU s':>8}{'ratio':>8}  exit code")
        for words in commands(asked.commands, asked.example):
            base, _ = cpu_seconds(CALCULATING, folder)
            seconds, code = cpu_seconds([*PROGRAM, *words, *(["--force"] if "-o" in words else [])], folder)
            row = f"{' '.join(words):<60}{seconds:8.2f}{seconds / base:8.1f}"
            print(row + (f"  {code if code >= 0 else 'ended after the longest wait'}" if code else ""), flush=True)


if __name__ == "__main__":
    main()
