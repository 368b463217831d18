"""Accuracy factor against any key of the spec, several clutches as several curves."""

from collections.abc import Sequence

from ....analysis.accuracy import AccuracySweep
from ....analysis.curves import AccuracyCurve
from ....messages import named, told, translate
from ....spec.keys import is_whole, keys
from ..chart import Chart, ChartAxis, Guide, Line, Sheet, axis_of, describe, stated


def sheet(curves: Sequence[AccuracyCurve]) -> Sheet:
    """Draw K_т over the gain, or over the key asked for; of one clutch also what it is and where its limit lies."""
    x, y = _abscissa(curves[0]), axis_of(AccuracySweep, "accuracy_factor")
    title = told("Accuracy factor K_т against {quantity} {symbol}", quantity=x.quantity, symbol=x.symbol).rstrip()
    if len(curves) > 1:
        lines = [_line(named(curve.name) or translate(curve.variant, "value"), curve) for curve in curves]
        return Sheet(title, [Chart(x, y, lines, named=True)])
    (curve,) = curves
    return Sheet(title, [Chart(x, y, _lines(curve), guides=_guides(curve, x))], name=curve.name or "")


def _abscissa(curve: AccuracyCurve) -> ChartAxis:
    if curve.series.parameter == "zC":
        return ChartAxis(translate("reduced gain"), "zC")
    key = keys()[curve.series.path]
    return ChartAxis(translate(key.description).partition(";")[0], key.symbol or "", key.unit or "1")


def _line(label: str, curve: AccuracyCurve, answer: str = "accuracy_factor") -> Line:
    return Line(label, curve.series.values, getattr(curve.series, answer), points=is_whole(curve.series.path))


def _lines(curve: AccuracyCurve) -> list[Line]:
    """K_т, and by breakaway peaks where they tell."""
    lines = [_line(describe(AccuracySweep, "accuracy_factor"), curve)]
    pairs = zip(curve.series.accuracy_factor_peak, curve.series.accuracy_factor, strict=True)
    if any(peak > sustained * (1 + 1e-9) for peak, sustained in pairs):
        lines.append(_line(describe(AccuracySweep, "accuracy_factor_peak"), curve, "accuracy_factor_peak"))
    return lines


def _guides(curve: AccuracyCurve, x: ChartAxis) -> list[Guide]:
    """The clutch as it is, and the limit of the gain."""
    found = []
    symbol = x.symbol or curve.series.path
    if curve.own is not None:
        own, factor = stated(symbol, curve.own, x.unit), stated("K_т", curve.accuracy_factor, "1")
        label = told("this clutch: {own}, {factor}", own=own, factor=factor)
        found.append(Guide(label, curve.own, across=False))
    if curve.limit is not None:
        found.append(
            Guide(
                told("limit of the gain, {stated}", stated=stated(symbol, curve.limit, "1")), curve.limit, across=False
            )
        )
    return found
