"""Torque against friction: both settings with their scatter bands, or several clutches as they are set."""

from collections.abc import Sequence

from ....analysis.curves import TorqueCurve
from ....messages import named, term, told, translate
from ..chart import Chart, ChartAxis, Dimension, Guide, Line, Sheet, axis_of, describe, stated

_EXTRA = ("breakaway_torque", "torque_returning")


def sheet(curves: Sequence[TorqueCurve]) -> Sheet:
    """Draw one clutch in detail, or several as one curve each."""
    if len(curves) == 1:
        return _one(curves[0])
    lines = [
        Line(named(curve.name) or translate(curve.variant, "value"), curve.friction, curve.torque) for curve in curves
    ]
    return Sheet(
        translate("Slip torque against friction"),
        [Chart(_friction(curves), _torque(), lines, from_zero=True, named=True)],
    )


def _one(curve: TorqueCurve) -> Sheet:
    methods = ("torque_min_friction", "torque_mean_friction")
    lines = [Line(describe(TorqueCurve, name), curve.friction, getattr(curve, name)) for name in methods]
    lines += [
        Line(describe(TorqueCurve, name), curve.friction, getattr(curve, name))
        for name in _EXTRA
        if getattr(curve, name)
    ]
    spans = [_band(number, getattr(curve, name)) for number, name in enumerate(methods)]
    guides = [
        Guide(
            told("clutch's nominal torque {stated}", stated=stated("T_н", curve.nominal_torque, "N*m")),
            curve.nominal_torque,
        )
    ]
    chart = Chart(_friction([curve]), _torque(), lines, guides=guides, spans=spans, from_zero=True)
    caption = told(
        "Both settings for the same nominal torque; margin β_н = {margin:g} in the second. ΔT is the scatter band of "
        "each. The spec sets it by {method}.",
        margin=curve.margin, method=term(curve.method),
    )  # fmt: skip
    if curve.friction_driving:
        caption += " " + translate("f_2 moves with f_1.")
    return Sheet(translate("Slip torque against friction"), [chart], caption, name=curve.name or "")


def _band(number: int, torque: list[float]) -> Dimension:
    ends = sorted((torque[0], torque[-1]))
    return Dimension(stated(f"ΔT_{number + 1}", ends[1] - ends[0], "N*m"), ends[0], ends[1], number)


def _friction(curves: Sequence[TorqueCurve]) -> ChartAxis:
    unlike = any(curve.friction_driving for curve in curves)
    return axis_of(TorqueCurve, "friction_driving" if unlike else "friction")


def _torque() -> ChartAxis:
    return axis_of(TorqueCurve, "torque", quantity=translate("slip torque"))
