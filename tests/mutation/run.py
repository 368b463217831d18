"""Mutation run over afmcalc/equations: every arithmetic operator and every constant changed once.

    python tests/mutation/run.py            # all modules, where equations or proofs differ from those of the last run
    python tests/mutation/run.py direct     # one, always

A mutant is killed where a stored value changes, a proof fails or a dimension is wrong, or where one of these raises
(how many died so is told); a proof that does not end within SECONDS kills nothing. Exit code 1 if one survives that is not
justified below, 2 if an unchanged function does not survive. A run over all modules without survivors stores the hash
of what it has tested (``equations.sha256``).
"""

import ast
import hashlib
import multiprocessing
import os
import signal
import sys
from collections import Counter
from collections.abc import Iterator
from functools import cache
from importlib import import_module, reload
from inspect import getsource, unwrap
from pathlib import Path
from typing import NamedTuple

os.environ["OPENBLAS_NUM_THREADS"] = "1"  # a process that forks has one thread
ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "tests")]
STORED = Path(__file__).with_name("equations.sha256")
TESTED = (
    "afmcalc/equations/*.py",
    "tests/proofs/*.py",
    "tests/equations/test_dimensions.py",
    "tests/engines/test_oracle.py",
)
EQUIVALENT: dict[str, str] = {}  # Mutants (as printed) that compute the same as the original, each with the reason
LOOKED_UP = ("__init__", "catalogue", "terms", "wiring")
NO_EQUATIONS = ("arrays", *LOOKED_UP)
SWAPS = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult}
SECONDS = 20
FATES = ("survived", "by an assertion", "by another exception")


class TimeUp(BaseException):
    """A proof takes too long."""


class Mutant(NamedTuple):
    """One change to one function."""

    module: str
    function: str
    line: int
    change: str
    tree: ast.Module

    @property
    def equation(self) -> str:
        """Name of the equation in the catalogue."""
        return f"{self.module}.{self.function}"

    def __str__(self) -> str:
        return f"{self.equation}:{self.line} {self.change}"


def mutants(module: str, source: str) -> Iterator[Mutant]:
    """Every mutant of a module: operators swapped, signs dropped, constants raised by one."""
    count = sum(1 for node in ast.walk(ast.parse(source)) if _places(node))
    for index in range(count):
        tree = ast.parse(source)
        node = [node for node in ast.walk(tree) if _places(node)][index]
        function = _enclosing(tree, node)
        if function is None:
            continue
        yield Mutant(module, function.name, node.lineno, _apply(node), ast.Module([function], []))


def _places(node: ast.AST) -> bool:
    if isinstance(node, ast.BinOp):
        return type(node.op) in SWAPS
    if isinstance(node, ast.UnaryOp):
        return isinstance(node.op, ast.USub)
    return isinstance(node, ast.Constant) and isinstance(node.value, int | float) and not isinstance(node.value, bool)


def _enclosing(tree: ast.Module, node: ast.AST) -> ast.FunctionDef | None:
    for function in tree.body:
        if isinstance(function, ast.FunctionDef) and any(child is node for child in ast.walk(function)):
            return function
    return None


def _apply(node: ast.AST) -> str:
    """Change the node in place and say how."""
    if isinstance(node, ast.BinOp):
        before, after = type(node.op), SWAPS[type(node.op)]
        node.op = after()
        return f"{before.__name__} → {after.__name__} at column {node.col_offset}"
    if isinstance(node, ast.UnaryOp):
        node.op = ast.UAdd()
        return f"− → + at column {node.col_offset}"
    assert isinstance(node, ast.Constant)
    before = node.value
    node.value = before + 1
    return f"{before} → {before + 1} at column {node.col_offset}"


def fate(mutant: Mutant) -> int:
    """Number of its fate; it spoils the process."""
    signal.signal(signal.SIGALRM, _stop)
    try:
        module = import_module(f"afmcalc.equations.{mutant.module}")
        original = unwrap(vars(module)[mutant.function])
        exec(compile(ast.fix_missing_locations(mutant.tree), "mutant", "exec"), vars(module))
        original.__code__ = unwrap(vars(module)[mutant.function]).__code__
        _check_numbers(mutant.module, mutant.equation)
        anew: set[str] = set()
        for name in _nearest_first(mutant.equation):
            try:
                signal.alarm(SECONDS)
                _prove_anew(name, anew)
            except TimeUp:
                print(f"{mutant}: {name} takes more than {SECONDS} s", flush=True)
            finally:
                signal.alarm(0)
    except (AssertionError, import_module("pint").DimensionalityError):
        return 1
    except Exception:
        return 2
    return 0


def _stop(*_: object) -> None:
    raise TimeUp


def _prove_anew(name: str, anew: set[str]) -> None:
    """Run a proof with its module imported again, so that what the module prepares comes from the mutant."""
    from proofs.symbols import prove

    file, _, function = name.rpartition("/")[2].partition(".py::")
    module = import_module(f"proofs.{file}")
    if file not in anew:
        reload(module)
        anew.add(file)
    prove(getattr(module, function))


@cache
def _sources() -> dict[str, tuple[str, str]]:
    """Proof → its source, and that of its module."""
    from proofs.symbols import proofs

    return {name: (getsource(proof), getsource(sys.modules[proof.__module__])) for name, proof in proofs().items()}


def _nearest_first(equation: str) -> list[str]:
    """Names of the proofs: those that name an equation, those of modules that do, the others."""
    return sorted(_sources(), key=lambda name: [equation not in text for text in _sources()[name]])


def _check_numbers(module: str, equation: str) -> None:
    """Check the dimension of a law that stands alone; stored values of clutches by laws that are wired."""
    from engines import test_oracle
    from equations import test_dimensions

    if module in test_dimensions.MODULES:
        test_dimensions.test_dimension_is_as_documented(equation)
        if test_dimensions.equations()[equation].result.unit != "1":
            test_dimensions.test_numbers_do_not_depend_on_the_units(equation)
    else:
        for number in range(len(test_oracle.stored()["specs"])):
            test_oracle.compare(number)


def _control(folder: Path) -> Mutant:
    """Judge an unchanged function as a mutant: it must survive, or the run kills everything."""
    tree = ast.parse((folder / "direct.py").read_text(encoding="utf-8"))
    function = next(node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == "torque")
    return Mutant("direct", "torque", function.lineno, "unchanged", ast.Module([function], []))


def fates(found: list[Mutant]) -> list[int]:
    """Fates of all mutants, each from a process of its own, as many at once as there are processors."""
    with multiprocessing.get_context("fork").Pool(maxtasksperchild=1) as pool:
        return pool.map(fate, found, chunksize=1)


def tested() -> str:
    """Hash of everything that decides what a run finds: syntax trees without docstrings, and units."""
    from afmcalc.equations.catalogue import equations

    files = [file for pattern in TESTED for file in sorted(ROOT.glob(pattern)) if file.stem not in LOOKED_UP]
    trees = [f"{file.name} {ast.dump(_bare(file))}" for file in files]
    laws = equations().items()
    units = [f"{name} {[term.unit for term in (*law.arguments.values(), law.result)]}" for name, law in laws]
    return hashlib.sha256("\n".join(trees + units).encode()).hexdigest()


def _bare(file: Path) -> ast.Module:
    """Syntax tree of a file without its docstrings."""
    tree = ast.parse(file.read_text(encoding="utf-8"))
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef) and ast.get_docstring(node) is not None:
            del node.body[0]
    return tree


def main(chosen: list[str]) -> int:
    """Run all mutants of the modules chosen (or all) and report."""
    now = tested()
    if not chosen and STORED.exists() and STORED.read_text(encoding="utf-8").strip() == now:
        print("equations and proofs are those of which every mutant was killed")
        return 0
    from proofs.symbols import proofs, prove

    for proof in proofs().values():
        prove(proof)
    _sources()
    _check_numbers("direct", "direct.torque")  # imported before the processes part
    import afmcalc.equations

    folder = Path(afmcalc.equations.__file__).parent
    if fates([_control(folder)]) != [0]:
        print("the control, an unchanged function, did not survive: nothing here can be believed")
        return 2
    names = chosen or sorted(file.stem for file in folder.glob("*.py") if file.stem not in NO_EQUATIONS)
    found = [mutant for name in names for mutant in mutants(name, (folder / f"{name}.py").read_text(encoding="utf-8"))]
    all_fates = fates(found)
    alive = [str(mutant) for mutant, own in zip(found, all_fates, strict=True) if own == 0]
    for mutant in alive:
        print(f"survived: {mutant}" + (f" (equivalent: {EQUIVALENT[mutant]})" if mutant in EQUIVALENT else ""))
    unexplained = [mutant for mutant in alive if mutant not in EQUIVALENT]
    counts = Counter(all_fates)
    told = ", ".join(f"{counts[number]} {fate}" for number, fate in enumerate(FATES))
    print(f"{len(found)} mutants: {told}; {len(unexplained)} unexplained")
    if not chosen and not unexplained:
        STORED.write_text(now + "\n", encoding="utf-8")
    return 1 if unexplained else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
