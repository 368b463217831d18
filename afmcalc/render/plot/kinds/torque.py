"""Torque against friction: both settings with their scatter bands, or several clutches as they are set."""

from typing import Any

from ....analysis.curves import TorqueCurve, torque_curve
from ..chart import Axis, Chart, Level, Line, Sheet, Span, axis_of, describe, named, stated
from ..interface import Request

_EXTRA = ("breakaway_torque", "torque_returning")


def sheet(request: Request) -> Sheet:
    """Draw one clutch in detail, or several as one curve each."""
    if len(request.subjects) == 1:
        return _one(request.subjects[0])
    curves = [torque_curve(clutch) for clutch in request.subjects]
    lines = [
        Line(named(clutch), curve.friction, curve.torque)
        for clutch, curve in zip(request.subjects, curves, strict=True)
    ]
    return Sheet(
        "Slip torque against friction", [Chart(_friction(curves), _torque(), lines, from_zero=True, named=True)]
    )


def _one(clutch: Any) -> Sheet:
    curve = torque_curve(clutch)
    methods = ("torque_min_friction", "torque_mean_friction")
    lines = [Line(describe(TorqueCurve, name), curve.friction, getattr(curve, name)) for name in methods]
    lines += [
        Line(describe(TorqueCurve, name), curve.friction, getattr(curve, name))
        for name in _EXTRA
        if getattr(curve, name)
    ]
    spans = [_band(number, getattr(curve, name)) for number, name in enumerate(methods)]
    nominal = float(clutch.nominal_torque)
    levels = [Level(stated("nominal torque T_н", nominal, "N*m"), nominal)]
    chart = Chart(_friction([curve]), _torque(), lines, levels=levels, spans=spans, from_zero=True)
    caption = (
        f"Both settings for the same nominal torque; margin β_н = {clutch.spec.adjustment.margin:g} in the second. "
        f"ΔT is the scatter band of each. The spec sets it by {clutch.spec.adjustment.method}."
        + (" f_2 moves with f_1." if clutch.spec.friction.unlike else "")
    )
    return Sheet("Slip torque against friction", [chart], caption, name=clutch.spec.name or "")


def _band(number: int, torque: list[float]) -> Span:
    ends = sorted((torque[0], torque[-1]))
    return Span(stated(f"ΔT_{number + 1}", ends[1] - ends[0], "N*m"), ends[0], ends[1], number)


def _friction(curves: list[TorqueCurve]) -> Axis:
    unlike = any(curve.friction_driving for curve in curves)
    return axis_of(TorqueCurve, "friction_driving" if unlike else "friction")


def _torque() -> Axis:
    return axis_of(TorqueCurve, "torque", quantity="slip torque")
