"""Tables of the torque over tolerances: each value beside its standard error, inputs in the engineer's units."""

from typing import Any

from ...analysis.tolerance.study import IndexRow, InputRow, ToleranceResult
from ...messages import translate
from ...spec.paths import keys
from ..document import Row, document
from ..layout import Block
from ..units import display, display_unit, factor, significant

_ERROR = "_standard_error"


def scatter_blocks(result: ToleranceResult) -> list[Block]:
    """Return the distribution, its quantiles, what scatters and the share of each input."""
    errors = result.method != "exact"
    found = [_figures(result, errors), _quantiles(result, errors), _inputs(result.inputs)]
    return [*found, _shares(result.sobol)] if errors else found


def _figures(result: ToleranceResult, errors: bool) -> Block:
    rows = document(result).singles
    error_of = {row.path.removesuffix(_ERROR): row for row in rows if row.path.endswith(_ERROR)}
    lined = [
        [
            row.symbol,
            row.name,
            display(row.values[0], row.unit),
            *([_error_of(row, error_of.get(row.path))] if errors else []),
            display_unit(row.unit),
        ]
        for row in rows
        if not row.path.endswith(_ERROR)
    ]
    header = ["Symbol", "Quantity", "Value", *(["±"] if errors else []), "Unit"]
    return Block("", header, lined, [False, False, True, *([True] if errors else []), False])


def _error_of(row: Row, error: Row | None) -> str:
    return "" if error is None else _rounded(error.values[0], row.unit)


def _rounded(error: float, unit: str) -> str:
    """Write an error to two figures; more are not known of it."""
    return significant(float(f"{error * factor(unit):.2g}"))


def _quantiles(result: ToleranceResult, errors: bool) -> Block:
    rows = [
        [
            f"T_{100 * row.probability:g}",
            f"torque not exceeded with probability {100 * row.probability:g} %",
            display(row.torque, "N*m"),
            *([_rounded(row.standard_error, "N*m")] if errors else []),
            display_unit("N*m"),
        ]
        for row in result.quantiles
    ]
    header = ["Symbol", "Quantity", "Value", *(["±"] if errors else []), "Unit"]
    return Block("Quantiles of the torque", header, rows, [False, False, True, *([True] if errors else []), False])


def _inputs(inputs: list[InputRow]) -> Block:
    rows = [
        [
            *_named(each.path),
            each.distribution,
            display(each.center, each.unit),
            display(each.spread, each.unit),
            display_unit(each.unit),
        ]
        for each in inputs
    ]
    header = ["Symbol", "Quantity", "Distribution", "Center", "Spread", "Unit"]
    return Block("What scatters", header, rows, [False, False, False, True, True, False])


def _shares(rows: list[IndexRow]) -> Block:
    lined: list[list[Any]] = [
        [
            *_named(each.path),
            display(each.first_order, "1"),
            _rounded(each.first_order_standard_error, "1"),
            display(each.total, "1"),
            _rounded(each.total_standard_error, "1"),
        ]
        for each in sorted(rows, key=lambda each: -each.total)
    ]
    header = ["Symbol", "Quantity", "S_1, first order", "±", "S_T, total", "±"]
    title = "Share in the variance of the torque (Sobol indices)"
    return Block(title, header, lined, [False, False, True, True, True, True])


def _named(path: str) -> tuple[str, str]:
    """Symbol and name of what scatters."""
    if path in _FRICTION:
        return _FRICTION[path]
    key = keys()[path]
    return key.symbol or "", translate(key.description).partition(";")[0]


_FRICTION = {
    "friction": ("f", "friction in service"),
    "friction.driving": ("f_1", "friction of the driving pairs in service"),
    "friction.driven": ("f_2", "friction of the driven pairs in service"),
}
