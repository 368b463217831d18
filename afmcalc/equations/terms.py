"""Symbol, SI unit and meaning of every quantity, once, from ``terms.txt``: for results, explanations, units of checks.

The unit is "1" for a pure number and empty for a condition, spring or list. In modules whose functions are called
directly (``drive``, ``heat``, …) a name may have a meaning of its own, ``heat.speed``, or in one function alone,
``heat.slip_power.speed``. A fourth column names the command that shows the quantity among its details: a law in a
module beside this one and a row there suffice for a new quantity in that command, explanations, sweeps and Python.
"""

from importlib.resources import files
from typing import NamedTuple


class Term(NamedTuple):
    """Symbol, unit and meaning of a quantity."""

    symbol: str
    """Symbol of the papers."""
    unit: str
    """SI unit."""
    meaning: str


def _rows() -> list[list[str]]:
    """Rows of ``terms.txt``: names, symbol, unit, meaning, and and perhaps the command that shows them as details."""
    table = files(__package__).joinpath("terms.txt").read_text(encoding="utf-8")
    return [[part.strip() for part in row.split("|")] for row in table.splitlines()]


_ALL = {name: Term(*row[:3]) for names, *row in _rows() for name in names.split()}
DETAILS = {name: row[3] for names, *row in _rows() if len(row) > 3 for name in names.split()}
"""Quantity without a field of its own in the result → command that shows it among its details."""
TERMS = {name: term for name, term in _ALL.items() if "." not in name}
"""Term of each quantity of a clutch, by name."""

CASES = {
    "f_min": "f_min", "f_mean": "f_cp", "f_max": "f_max", "setting": "f_set", "rest": "f = 0", "leaving": "f_L",
    "leaving_in_range": "f_L", "leaving_from_mean": "f_L", "unlocking": "f_u", "returning": "returning",
    "by_min": "set at f_min", "by_mean": "set at f_cp", "overload": "T_н at f_min", "unprotected": "unprotected side",
    "forecast": "f ≥ f_cp", "f_min_max": "f_1min, f_2max", "f_max_min": "f_1max, f_2min", "low": "T_low",
    "high": "T_high", "slips": "each slip", "each_slip": "each slip", "along_wall": "along the wall",
    **dict.fromkeys(("worst_case", "peak", "hysteresis", "expected", "actual", "equilibrium"), ""),
}  # fmt: skip
"""Case → its name in explanations; empty if quantities in this case have rows of their own."""
_SYMBOLS = {"returning": "κ₊", "by_min": "F_п,1", "by_mean": "F_п,2", "overload": "f_min"}
"""Case → text in brackets after a symbol, if shorter than that of ``CASES``."""


def term_of(name: str) -> Term:
    """Return symbol, unit and meaning of a quantity; in a case such as ``torque_at_f_max`` the symbol is T(f_max)."""
    if name in TERMS:
        return TERMS[name]
    quantity, _, case = name.rpartition("_at_")
    if not CASES[case]:
        return TERMS[f"{quantity}_{case}"]
    own = term_of(quantity)
    return Term(f"{own.symbol}({_SYMBOLS.get(case, CASES[case])})", own.unit, own.meaning)


def term_in(function: str, name: str) -> Term:
    """Term of a quantity as argument or result of ``module.function``."""
    module = function.partition(".")[0]
    return _ALL.get(f"{function}.{name}") or _ALL.get(f"{module}.{name}") or term_of(name)


def quantity_of(name: str) -> str:
    """Return the name without its case: ``torque`` for ``torque_at_f_max``; names with a row of their own unchanged."""
    return name if name in TERMS else quantity_of(name.rpartition("_at_")[0])
