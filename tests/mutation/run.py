"""Mutation run over afmcalc/equations: every arithmetic operator and every constant flipped once.

    python tests/mutation/run.py            # all modules
    python tests/mutation/run.py direct     # one

A mutant is killed when a proof or a dimension check fails. Each runs in a forked process with only the mutated
function exchanged. Exit code 1 if one survives that is not justified below.
"""

import ast
import os
import signal
import sys
from collections.abc import Iterator
from functools import cache
from importlib import import_module, reload
from inspect import getsource, unwrap
from pathlib import Path
from typing import NamedTuple

EQUIVALENT: dict[str, str] = {}
"""Mutants (as printed) that compute the same as the original, each with the reason."""

SWAPS = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult}
SECONDS = 30


class Mutant(NamedTuple):
    """One change to one function."""

    module: str
    function: str
    line: int
    change: str
    tree: ast.Module

    @property
    def equation(self) -> str:
        """Its name in the catalogue."""
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


def survives(mutant: Mutant) -> bool:
    """Whether every proof and dimension check passes with the mutant in place."""
    order = _proof_order(mutant.equation)
    child = os.fork()
    if child == 0:
        signal.alarm(SECONDS)
        os._exit(0 if _passes(mutant, order) else 1)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0


def _passes(mutant: Mutant, order: list[str]) -> bool:
    from afmcalc.proofs import prove

    try:
        module = import_module(f"afmcalc.equations.{mutant.module}")
        code = compile(ast.fix_missing_locations(mutant.tree), "mutant", "exec")
        original = unwrap(vars(module)[mutant.function])
        exec(code, vars(module))
        original.__code__ = unwrap(vars(module)[mutant.function]).__code__
        _check_dimensions(mutant.equation)
        _proofs_anew()
        for name in order:
            prove(name)
    except BaseException:
        return False
    return True


def _proofs_anew() -> None:
    """Import the proofs again: what they prepare when they are imported must come from the mutant."""
    from afmcalc import proofs

    for name in proofs.MODULES:
        reload(import_module(f"afmcalc.proofs.{name}"))
    proofs.proofs.cache_clear()


@cache
def _proof_order(equation: str) -> list[str]:
    """Proofs by how near they are to an equation: those that name it first."""
    from afmcalc.proofs import proofs

    return sorted(proofs(), key=lambda name: equation not in getsource(proofs()[name]))


def _check_dimensions(name: str) -> None:
    import pint

    from afmcalc.equations.catalogue import equations

    units, equation = _registry(), equations()[name]
    arguments = {
        key: 0.31 + 0.17 * i if term.unit == "1" else units.Quantity(0.31 + 0.17 * i, term.unit.replace("^", "**"))
        for i, (key, term) in enumerate(equation.arguments.items())
    }
    value = equation.function(**arguments)
    for part in value if isinstance(value, tuple) else (value,):
        wanted = units.Quantity(1, "" if equation.result.unit == "1" else equation.result.unit.replace("^", "**"))
        if units.Quantity(part).dimensionality != wanted.dimensionality:
            raise pint.DimensionalityError(part, wanted)


def _registry(cache: list[object] = []) -> object:  # noqa: B006
    import pint

    if not cache:
        cache.append(pint.UnitRegistry())
    return cache[0]


def _control(source: str) -> Mutant:
    """A function as it is: it must survive, or the run kills everything."""
    function = next(
        node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef) and node.name == "torque"
    )
    return Mutant("direct", "torque", function.lineno, "unchanged", ast.Module([function], []))


def main(chosen: list[str]) -> int:
    """Run all mutants of the modules chosen (or all) and report."""
    from concurrent.futures import ThreadPoolExecutor

    import afmcalc.equations
    from afmcalc.proofs import proofs, prove

    for name in proofs():
        prove(name)
    _registry()
    folder = Path(afmcalc.equations.__file__).parent
    if not survives(_control((folder / "direct.py").read_text(encoding="utf-8"))):
        print("the control, an unchanged function, did not survive: nothing here can be believed")
        return 2
    names = chosen or sorted(
        p.stem for p in folder.glob("*.py") if p.stem not in ("__init__", "arrays", "calls", "catalogue", "terms")
    )
    found = [mutant for name in names for mutant in mutants(name, (folder / f"{name}.py").read_text(encoding="utf-8"))]
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        alive = [str(m) for m, survived in zip(found, pool.map(survives, found), strict=True) if survived]
    for mutant in alive:
        print(f"survived: {mutant}" + (f" (equivalent: {EQUIVALENT[mutant]})" if mutant in EQUIVALENT else ""))
    unexplained = [mutant for mutant in alive if mutant not in EQUIVALENT]
    print(
        f"{len(found)} mutants, {len(found) - len(alive)} killed, {len(alive)} survived, {len(unexplained)} unexplained"
    )
    return 1 if unexplained else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
