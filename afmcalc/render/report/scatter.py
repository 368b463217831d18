"""Tables of the torque over tolerances: each value beside its standard error, inputs in the engineer's units."""

from ...analysis.tolerance.result import Estimate, IndexRow, InputRow, LifeRow, ToleranceResult
from ...messages import localized, term, translate
from ...messages import told as message
from ...spec.paths import keys
from ..document import document
from ..layout import TextTable
from ..units import display, display_unit, factor, significant


def scatter_blocks(result: ToleranceResult) -> list[TextTable]:
    """Return the distribution, its quantiles, what scatters and the share of each input."""
    errors = result.method != "exact"
    found = [_figures(result, errors), _quantiles(result, errors)]
    if result.life_quantiles:
        found.append(_lives(result.life_quantiles, errors))
    found.append(_inputs(result.inputs))
    return [*found, _shares(result.sobol)] if errors else found


def _figures(result: ToleranceResult, errors: bool) -> TextTable:
    names = result.error_fields()
    lined = [
        [
            row.symbol,
            row.name,
            *(
                _with_error(result.estimate(row.path), row.unit, errors)
                if row.path in names
                else [display(row.values[0], row.unit), *([""] if errors else [])]
            ),
            display_unit(row.unit),
        ]
        for row in document(result).singles
        if row.path not in names.values()
    ]
    header = [*map(translate, ("Symbol", "Quantity", "Value")), *(["±"] if errors else []), translate("Unit")]
    return TextTable("", header, lined, [False, False, True, *([True] if errors else []), False])


def _rounded(error: float, unit: str) -> str:
    """Write an error to two figures; more are not known of it."""
    return significant(float(f"{error * factor(unit):.2g}"))


def _quantiles(result: ToleranceResult, errors: bool) -> TextTable:
    rows = [
        [
            f"T_{100 * row.probability:g}",
            message("torque not exceeded with probability {percent:g} %", percent=100 * row.probability),
            *_with_error(row.estimate("torque"), "N*m", errors),
            display_unit("N*m"),
        ]
        for row in result.quantiles
    ]
    header = [*map(translate, ("Symbol", "Quantity", "Value")), *(["±"] if errors else []), translate("Unit")]
    return TextTable(
        translate("Quantiles of the torque"), header, rows, [False, False, True, *([True] if errors else []), False]
    )


def _lives(rows: list[LifeRow], errors: bool) -> TextTable:
    lined = [
        [
            f"{localized(f'{100 * row.probability:g}')} %",
            *(text for side in ("protected", "unprotected") for text in _with_error(row.estimate(side), "1", errors)),
        ]
        for row in rows
    ]
    sides = ([translate("Slips, protected side")], [translate("Slips, unprotected side")])
    header = [translate("Clutches failed"), *(name for side in sides for name in (side + ["±"] if errors else side))]
    return TextTable(translate("Life over the clutches"), header, lined, [False, *[True] * (len(header) - 1)])


def _with_error(estimate: Estimate, unit: str, errors: bool) -> list[str]:
    value = display(estimate.value, unit)
    return [value, _rounded(estimate.standard_error, unit)] if errors else [value]


def _inputs(inputs: list[InputRow]) -> TextTable:
    rows = [
        [
            *_named(each.path),
            translate(each.distribution, "value"),
            display(each.center, each.unit),
            display(each.spread, each.unit),
            display_unit(each.unit),
        ]
        for each in inputs
    ]
    header = [*map(translate, ("Symbol", "Quantity", "Distribution", "Center", "Spread", "Unit"))]
    return TextTable(translate("What scatters"), header, rows, [False, False, False, True, True, False])


def _shares(rows: list[IndexRow]) -> TextTable:
    lined = [
        [
            *_named(each.path),
            *_with_error(each.estimate("first_order"), "1", errors=True),
            *_with_error(each.estimate("total"), "1", errors=True),
        ]
        for each in sorted(rows, key=lambda each: -each.total)
    ]
    header = [*map(translate, ("Symbol", "Quantity", "S_1, first order")), "±", translate("S_T, total"), "±"]
    title = translate("Share in the variance of the torque (Sobol indices)")
    return TextTable(title, header, lined, [False, False, True, True, True, True])


def _named(path: str) -> tuple[str, str]:
    """Symbol and name of what scatters."""
    if path in _FRICTION:
        symbol, name = _FRICTION[path]
        return symbol, translate(name)
    key = keys()[path]
    return key.symbol or "", translate(key.description).partition(";")[0]


_FRICTION = {
    "friction": ("f", term("friction in service")),
    "friction.driving": ("f_1", term("friction of the driving pairs in service")),
    "friction.driven": ("f_2", term("friction of the driven pairs in service")),
}
