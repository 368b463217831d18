"""Life against the scatter band, and where both settings put the clutch."""

from typing import Any

from ....analysis.adjust import adjust
from ....analysis.curves import POINTS
from ....analysis.life import LifeSweep, band_axis, life
from ....analysis.sweep.grid import Axis as SweptKey
from ....errors import AfmcalcError, CalculationError
from ....messages import say
from ..chart import Axis, Chart, Level, Line, Sheet, axis_of, describe, named, power
from ..interface import Request

_SIDES = ("protected", "unprotected", "protected_forecast")


def sheet(request: Request) -> Sheet:
    """Draw both sides of one clutch, or the protected side of several."""
    model: Any = request.model or "mean-stress"
    keys = [_band(request.sweep, clutch) for clutch in request.subjects]
    results = [life(clutch, model, [key])[0] for clutch, key in zip(request.subjects, keys, strict=True)]
    x = Axis("torque scatter band", "ΔT", "N*m")
    y = axis_of(LifeSweep, "protected", log=True, quantity="cycles to failure")
    if len(results) > 1:
        lines = [
            Line(named(clutch), result.sweep[0].values, result.sweep[0].protected)
            for clutch, result in zip(request.subjects, results, strict=True)
            if result.sweep
        ]
        title, levels = "Life of the protected side against the scatter band", []
    else:
        result = results[0]
        assert result.sweep is not None
        swept = result.sweep[0]
        lines = [Line(describe(LifeSweep, side), swept.values, getattr(swept, side)) for side in _SIDES]
        lines += _settings(request.subjects[0], result)
        title = "Life against the scatter band"
        levels = [Level(f"base cycles N_0 = {power(result.base_cycles)}", result.base_cycles)]
    if not any(value for line in lines for value in line.y):
        raise CalculationError(
            say("plot life: by the model {model!r} fatigue sets no limit anywhere in the range", model=model)
        )
    beyond = (
        "Above N_0 the stress is below the endurance limit: life is not limited by fatigue, the line is extrapolated "
        "as the paper does."
        if model == "mean-stress"
        else "Where there is no line, fatigue sets no limit."
    )
    caption = f"Model: {model}. T_min as the clutch has it, T_max = T_min + ΔT. {beyond}"
    name = request.subjects[0].spec.name or "" if len(results) == 1 else ""
    return Sheet(title, [Chart(x, y, lines, levels=levels, named=len(results) > 1)], caption, name=name)


def _settings(clutch: Any, result: Any) -> list[Line]:
    """The protected side with the spring set by either method."""
    both, _ = adjust(clutch)
    return [
        Line(f"protected side, {label}", [setting.scatter], [cycles], points=True)
        for label, setting, cycles in (
            ("set at f_min", both.min_friction, result.protected.min_friction),
            ("set at mean f with margin", both.mean_friction, result.protected.mean_friction),
        )
        if cycles
    ]


def _band(text: str | None, clutch: Any) -> SweptKey:
    """The scatter band, from half to twice what the clutch has."""
    import numpy as np

    name = (text or "dT").partition("=")[0].strip()
    if name != "dT":
        raise AfmcalcError(
            say("plot life: its axis is the scatter band dT, not {name!r} (dT=RANGE sets its range)", name=name)
        )
    key = band_axis(text or "dT", clutch.spec)
    if text and "=" in text:
        return key
    low, high = float(key.values.min()), float(key.values.max())
    if not high > low:
        raise CalculationError(say("plot life: the friction does not wander, there is no band: give --sweep dT=RANGE"))
    return key._replace(values=np.linspace(low, high, POINTS))
