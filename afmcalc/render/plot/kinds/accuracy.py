"""Accuracy factor against any key of the spec, several clutches as several curves."""

from ....analysis.accuracy import AccuracyResult, AccuracySweep, accuracy
from ....analysis.curves import swept
from ....analysis.sweep.grid import Axis as SweptKey
from ....messages import translate
from ....spec.paths import is_whole
from ..chart import Axis, Chart, Level, Line, Sheet, axis_of, describe, named, stated
from ..interface import Request


def sheet(request: Request) -> Sheet:
    """Draw K_т over the gain, or over the key asked for; of one clutch also what it is and where its limit lies."""
    keys = [swept(request.sweep or "C", clutch) for clutch in request.subjects]
    results = [accuracy(clutch, [key])[0] for clutch, (key, _) in zip(request.subjects, keys, strict=True)]
    key, own = keys[0]
    x, y = _abscissa(key), axis_of(AccuracySweep, "accuracy_factor")
    title = f"Accuracy factor K_т against {x.quantity} {x.symbol}".rstrip()
    if len(results) > 1:
        pairs = zip(request.subjects, results, strict=True)
        lines = [_line(named(clutch), result, key) for clutch, result in pairs]
        return Sheet(title, [Chart(x, y, lines, named=True)])
    chart = Chart(x, y, _lines(results[0], key), levels=_levels(key, own, results[0]))
    return Sheet(title, [chart], name=request.subjects[0].spec.name or "")


def _abscissa(key: SweptKey) -> Axis:
    if key.name == "zC":
        return Axis("reduced gain", "zC")
    return Axis(translate(key.key.description).partition(";")[0], key.key.symbol or "", key.key.unit or "1")


def _line(label: str, result: AccuracyResult, key: SweptKey, answer: str = "accuracy_factor") -> Line:
    assert result.sweep is not None
    return Line(label, result.sweep[0].values, getattr(result.sweep[0], answer), points=is_whole(key.key.path))


def _lines(result: AccuracyResult, key: SweptKey) -> list[Line]:
    """K_т, and by breakaway peaks where they tell."""
    assert result.sweep is not None
    found = result.sweep[0]
    lines = [_line(describe(AccuracySweep, "accuracy_factor"), result, key)]
    pairs = zip(found.accuracy_factor_peak, found.accuracy_factor, strict=True)
    if any(peak > sustained * (1 + 1e-9) for peak, sustained in pairs):
        lines.append(_line(describe(AccuracySweep, "accuracy_factor_peak"), result, key, "accuracy_factor_peak"))
    return lines


def _levels(key: SweptKey, own: float | None, result: AccuracyResult) -> list[Level]:
    """The clutch as it is, and the limit of the gain."""
    found = []
    symbol = "zC" if key.name == "zC" else key.key.symbol or key.key.path
    if own is not None:
        here = stated(symbol, own, key.key.unit or "1")
        label = f"this clutch: {here}, {stated('K_т', result.accuracy_factor, '1')}"
        found.append(Level(label, own, across=False))
    if key.key.path == "control_unit.gain" and result.gain_limit is not None:
        limit = result.gain_limit / key.scale
        found.append(Level(stated(f"limit of the gain, {symbol}", limit, "1"), limit, across=False))
    return found
