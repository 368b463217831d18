"""Small plausible faults put into the program by hand, one at a time: the default tests must notice most of them.

    python tests/mutation/faults.py               # all of faults.toml
    python tests/mutation/faults.py tests/spec    # those whose tests begin so

Each is put into a copy of the tree, where its ``tests`` run until one fails. Exit code 1 if less than SHARE are noticed
or what a fault replaces does not stand exactly once in its file, 2 if the tests fail without a fault.
"""

import ast
import math
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import tomllib
from concurrent.futures import ThreadPoolExecutor
from itertools import count
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[2]
COPIED = ("afmcalc", "configs", "tests", ".ci", "pyproject.toml", "README.md", "CHANGELOG.md")
SHARE = 0.9
SECONDS = 300
PASSED, FAILED = 0, (1, 2)  # Exit codes of pytest; 2: a module could not be imported
_TIMES = count(1)


class Fault(NamedTuple):
    """One line that is wrong."""

    file: str
    was: str
    now: str
    tests: str

    def __str__(self) -> str:
        return f"{self.file}: {self.was} → {self.now} ({self.tests})"


def read() -> list[Fault]:
    """Every fault of the list."""
    listed = tomllib.loads(Path(__file__).with_name("faults.toml").read_text(encoding="utf-8"))["fault"]
    return [Fault(each["file"], each["was"], each["is"], each["tests"]) for each in listed]


def misplaced(fault: Fault) -> str | None:
    """Text on what is wrong with the record of a fault, or None."""
    file = ROOT / fault.file
    found = file.read_text(encoding="utf-8").count(fault.was) if file.is_file() else 0
    if found != 1:
        return f"stands {found} times, not once"
    if not all((ROOT / path.partition("::")[0]).exists() for path in fault.tests.split()):
        return "there are no such tests"
    try:
        if file.suffix == ".py":
            ast.parse(file.read_text(encoding="utf-8").replace(fault.was, fault.now))
    except SyntaxError:
        return "no Python with it"
    return None


def copied(folder: Path) -> Path:
    """Copy the tree to a folder."""
    for name in COPIED:
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("work", ".pytest_cache"))
        else:
            shutil.copy2(ROOT / name, folder)
    return folder


def outcome(folder: Path, tests: str, *options: str) -> int | None:
    """Exit code of pytest in a copy; None if it does not end in time."""
    command = [sys.executable, "-m", "pytest", *options, "-q", "-p", "no:cacheprovider", *tests.split()]
    environment = {**os.environ, "CI": "1", "PYTHONPATH": str(folder)}
    with (folder / "told").open("wb") as told:
        run = subprocess.Popen(command, cwd=folder, env=environment, stdout=told, stderr=told, start_new_session=True)
    try:
        return run.wait(SECONDS)
    except subprocess.TimeoutExpired:
        os.killpg(run.pid, 9)
        run.wait()
        return None


def put(file: Path, text: str) -> None:
    """Write a file with a unique modification time, so that Python does not reuse bytecode of another text."""
    file.write_text(text, encoding="utf-8")
    os.utime(file, (at := 1_000_000_000 + 10 * next(_TIMES), at))


def with_fault(folder: Path, fault: Fault) -> int | None:
    """Exit code of the tests of a fault while the fault is in the copy."""
    file = folder / fault.file
    text = file.read_text(encoding="utf-8")
    put(file, text.replace(fault.was, fault.now))
    try:
        return outcome(folder, fault.tests, "-x")
    finally:
        put(file, text)


def main(chosen: list[str]) -> int:
    """Put in every fault and report those that no test notices."""
    faults = [fault for fault in read() if not chosen or fault.tests.startswith(tuple(chosen))]
    wrong = [f"{problem}: {fault}" for fault in faults if (problem := misplaced(fault))]
    print(*wrong, sep="\n", end="\n" if wrong else "")
    if wrong:
        return 1
    tests = sorted({path for fault in faults for path in fault.tests.split()})
    workers = os.cpu_count() or 1
    copy = threading.local()  # a tree for each worker

    def begin() -> None:
        copy.folder = copied(Path(tempfile.mkdtemp(dir=home)))

    with tempfile.TemporaryDirectory() as home, ThreadPoolExecutor(workers, initializer=begin) as pool:
        groups = [" ".join(own) for start in range(workers) if (own := tests[start::workers])]
        if any(code != PASSED for code in pool.map(lambda own: outcome(copy.folder, own), groups)):
            print(*(told.read_text(encoding="utf-8")[-2000:] for told in Path(home).glob("*/told")), sep="\n")
            print("tests fail without a fault, or do not end: nothing here can be believed")
            return 2
        codes = list(pool.map(lambda fault: with_fault(copy.folder, fault), faults))
    missed = [fault for fault, code in zip(faults, codes, strict=True) if code not in FAILED]
    for fault in missed:
        print(f"not noticed: {fault}")
    print(f"{len(faults)} faults, {len(faults) - len(missed)} noticed")
    return 1 if len(faults) - len(missed) < math.ceil(SHARE * len(faults)) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
