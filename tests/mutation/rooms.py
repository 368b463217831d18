"""Mutation run over the rooms that formulas do not reach: a sample of small changes, each of which a test must notice.

    python tests/mutation/rooms.py                     # 12 changes of render/, spec/ and cli/
    python tests/mutation/rooms.py 100 cli --seed 3    # 100 of one room, others than last time

A change is one of: a comparison turned, ``and`` for ``or``, a ``not`` dropped, a number raised by one, True for False.
Each runs the tests of its room against a copy of the package. Exit code 1 if too many survive.
"""

import argparse
import ast
import os
import random
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).parents[2]
ROOMS = ("render", "spec", "cli")
SHARE = 0.2
"""Share of the changes that may survive: some compute the same, or make only a message shorter."""
TURNED: dict[type, type] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.And: ast.Or, ast.Or: ast.And,
}  # fmt: skip


def changes(source: str) -> Iterator[tuple[int, str, str]]:
    """Line, what is changed, and the source with the change."""
    count = sum(1 for _ in _places(ast.parse(source)))
    for index in range(count):
        tree = ast.parse(source)
        node = list(_places(tree))[index]
        line, before = node.lineno, ast.unparse(node)
        _change(node)
        yield line, f"{before} → {ast.unparse(node)}", ast.unparse(ast.fix_missing_locations(tree))


def _places(tree: ast.AST) -> Iterator[ast.expr]:
    """What can be changed, but for annotations."""
    for node in ast.walk(tree):
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


def survives(room: str, name: str, text: str) -> bool:
    """Whether every test passes with the change in place."""
    with tempfile.TemporaryDirectory() as folder:
        package = Path(folder) / "afmcalc"
        shutil.copytree(ROOT / "afmcalc", package, ignore=shutil.ignore_patterns("__pycache__"))
        shutil.copytree(ROOT / "configs", package / "configs")
        (package / name).write_text(text, encoding="utf-8")
        run = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", f"tests/{room}"]
        environment = {**os.environ, "PYTHONPATH": folder}
        try:
            return (
                subprocess.run(run, cwd=ROOT, env=environment, capture_output=True, timeout=300, check=False).returncode
                == 0
            )
        except subprocess.TimeoutExpired:
            return False


def main() -> int:
    """Run a sample of the changes and report those that no test notices."""
    parser = argparse.ArgumentParser()
    parser.add_argument("count", nargs="?", type=int, default=12)
    parser.add_argument("rooms", nargs="*", default=ROOMS)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    every = [
        (room, str(file.relative_to(ROOT / "afmcalc")), *change)
        for room in asked.rooms
        for file in sorted((ROOT / "afmcalc" / room).rglob("*.py"))
        for change in changes(file.read_text(encoding="utf-8"))
    ]
    sample = random.Random(asked.seed).sample(every, min(asked.count, len(every)))
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        alive = list(pool.map(lambda each: survives(each[0], each[1], each[4]), sample))
    for (_, name, line, change, _), survived in zip(sample, alive, strict=True):
        if survived:
            print(f"survived: {name}:{line} {change}")
    print(f"{len(sample)} of {len(every)} changes, {sum(alive)} survived, {SHARE:.0%} may")
    return 1 if sum(alive) > SHARE * len(sample) else 0


if __name__ == "__main__":
    sys.exit(main())
