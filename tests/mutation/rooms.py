"""Mutation run over the rooms that formulas do not reach: a sample of small changes, each of which a test must notice.

    python tests/mutation/rooms.py                     # 12 changes of render/, spec/ and cli/
    python tests/mutation/rooms.py 100 cli --seed 3    # 100 of one room, others than last time

A change is one of: a comparison turned, ``and`` for ``or``, a ``not`` dropped, a number raised by one, True for False.
Each runs the default tests of its room in a copy of the tree, until one fails. Exit code 1 if more survive than chance
allows, 2 if the tests fail without a change.
"""

import argparse
import ast
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[2]
ROOMS = ("render", "spec", "cli")
SHARE = 0.35
"""Share of the changes that may survive: some compute the same, others move a line, or are seen by other rooms' tests."""
TURNED: dict[type, type] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.And: ast.Or, ast.Or: ast.And,
}  # fmt: skip


class Change(NamedTuple):
    """A change of one place of a file."""

    room: str
    file: Path
    line: int
    what: str
    text: str

    def __str__(self) -> str:
        return f"{self.file.relative_to(ROOT)}:{self.line} {self.what}"


def changes(room: str, file: Path) -> Iterator[Change]:
    """Every change of a file, one at a time."""
    source = file.read_text(encoding="utf-8")
    for index in range(sum(1 for _ in _places(ast.parse(source)))):
        tree = ast.parse(source)
        node = list(_places(tree))[index]
        before = ast.unparse(node)
        _change(node)
        what = f"{before} → {ast.unparse(node)}"
        yield Change(room, file, node.lineno, what, ast.unparse(ast.fix_missing_locations(tree)))


def _places(tree: ast.AST) -> Iterator[ast.expr]:
    """What can be changed: not ``strict`` of zip, which only finds what cannot be."""
    strict = {
        keyword.value for keyword in ast.walk(tree) if isinstance(keyword, ast.keyword) and keyword.arg == "strict"
    }
    for node in ast.walk(tree):
        if node in strict:
            continue
        constant = isinstance(node, ast.Constant) and isinstance(node.value, bool | int)
        if constant or isinstance(node, ast.Compare | ast.BoolOp) or isinstance(getattr(node, "op", None), ast.Not):
            yield node


def _change(node: ast.expr) -> None:
    if isinstance(node, ast.Compare):
        node.ops[0] = TURNED[type(node.ops[0])]()
    elif isinstance(node, ast.BoolOp):
        node.op = TURNED[type(node.op)]()
    elif isinstance(node, ast.UnaryOp):
        node.op, node.operand = ast.Not(), ast.UnaryOp(ast.Not(), node.operand)
    elif isinstance(node, ast.Constant):
        node.value = not node.value if isinstance(node.value, bool) else node.value + 1  # type: ignore[operator]


def sampled(every: list[Change], count: int, seed: int) -> list[Change]:
    """Some of the changes, which stay the same ones however other lines change."""
    again: Counter[str] = Counter()
    ranks = []
    for change in every:
        name = f"{seed} {change.file.name} {change.what}"
        again[name] += 1
        ranks.append(sha256(f"{name} {again[name]}".encode()).digest())
    return [change for _, change in sorted(zip(ranks, every, strict=True), key=lambda each: each[0])[:count]]


def survives(room: str, file: Path, text: str) -> bool:
    """Whether its tests pass with this text of a file: those of the room, first those that name it, and the doctests."""
    name = file.parent.name if file.stem == "__init__" else file.stem
    naming = re.compile(rf"\b{name}\b|\btest_{name}\b")
    ours = (ROOT / "tests" / room).rglob("test_*.py")
    tests = sorted(ours, key=lambda test: not naming.search(test.name + test.read_text(encoding="utf-8")))
    with tempfile.TemporaryDirectory() as folder:
        for each in ("afmcalc", "configs", "tests"):
            shutil.copytree(ROOT / each, Path(folder, each))
        for page in ("pyproject.toml", "README.md", "CHANGELOG.md"):
            shutil.copy2(ROOT / page, folder)
        Path(folder, file.relative_to(ROOT)).write_text(text, encoding="utf-8")
        asked = ["tests/test_python.py::test_doctests", *(str(test.relative_to(ROOT)) for test in tests)]
        run = [sys.executable, "-m", "pytest", "-x", "-p", "no:cacheprovider", *asked]
        try:
            ended = subprocess.run(
                run, cwd=folder, env={**os.environ, "CI": "1"}, capture_output=True, timeout=300, check=False
            )
        except subprocess.TimeoutExpired:
            return False
        return ended.returncode == 0


def main() -> int:
    """Run a sample of the changes and report those that no test notices."""
    parser = argparse.ArgumentParser()
    parser.add_argument("count", nargs="?", type=int, default=12)
    parser.add_argument("rooms", nargs="*", default=ROOMS)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    files = [(room, file) for room in asked.rooms for file in sorted((ROOT / "afmcalc" / room).rglob("*.py"))]
    every = [change for room, file in files for change in changes(room, file)]
    sample = sampled(every, asked.count, asked.seed)
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        survived = pool.map(lambda each: survives(each.room, each.file, each.text), sample)
        alive = [change for change, survives_ in zip(sample, survived, strict=True) if survives_]
        # where none survived the tests may fail without a change too: then nothing here can be believed
        none = {each.room: each.file for each in sample if each.room not in {change.room for change in alive}}
        sound = pool.map(lambda each: survives(*each, each[1].read_text(encoding="utf-8")), none.items())
        if not all(sound):
            print(f"the tests fail without a change, in one of {', '.join(none)}")
            return 2
    for change in alive:
        print(f"survived: {change}")
    most = SHARE * len(sample) + 2 * math.sqrt(SHARE * (1 - SHARE) * len(sample))
    print(f"{len(sample)} of {len(every)} changes, {len(alive)} survived, {most:.0f} may")
    return 1 if len(alive) > most else 0


if __name__ == "__main__":
    sys.exit(main())
