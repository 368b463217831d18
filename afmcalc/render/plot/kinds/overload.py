"""Overload: the trip over friction, and expected against actual accuracy over the reduced gain (S22 fig. 3)."""

from ....analysis.curves import OverloadCurve
from ....analysis.overload import OverloadSweep
from ....messages import told, translate
from ..chart import Area, Chart, ChartAxis, Guide, Line, Sheet, axis_of, describe, stated


def sheet(curve: OverloadCurve) -> Sheet:
    """Draw both panels for one clutch."""
    caption = translate(
        "Equilibrium: at slip the load equals the expected torque for every margin; the published T_ср = T_п − ΔT' "
        "(S22 (14)) swaps the weights of T_п and T_н.маш (misprint M12). Where the release force lags the load "
        "(impact), the trip lies in the shaded bracket. Curves of K_т as S22 fig. 3, its optimum at zC = 1/f_max (M13)."
    )
    title = told("Overload with the margin {stated}", stated=stated("β_н", curve.margin, "1"))
    return Sheet(title, [_trip(curve), _accuracy(curve)], caption, name=curve.name or "")


def _trip(curve: OverloadCurve) -> Chart:
    names = ("expected_torque", "actuation_torque_published")
    lines = [Line(describe(OverloadCurve, name), curve.friction, getattr(curve, name)) for name in names]
    few = slice(None, None, 20)
    equilibrium = "actuation_torque_equilibrium"
    lines.append(
        Line(describe(OverloadCurve, equilibrium), curve.friction[few], getattr(curve, equilibrium)[few], points=True)
    )
    bracket = Area(
        translate("trip bracket, T_муф to T_п"), curve.friction, curve.expected_torque, curve.potential_torque
    )
    machine = Guide(
        told("machine's nominal torque {stated}", stated=stated("T_н.маш", curve.machine_torque, "N*m")),
        curve.machine_torque,
    )
    x, y = axis_of(OverloadCurve, "friction"), axis_of(OverloadCurve, "expected_torque", quantity=translate("torque"))
    return Chart(
        x,
        y._replace(symbol="T"),
        lines,
        title=translate("Torque at the trip"),
        guides=[machine],
        areas=[bracket],
        from_zero=True,
    )


def _accuracy(curve: OverloadCurve) -> Chart:
    swept = curve.accuracy
    lines = [
        Line(describe(OverloadSweep, name), swept.values, getattr(swept, name))
        for name in ("accuracy_factor_expected", "accuracy_factor_actual")
    ]
    own, best = curve.reduced_gain, curve.optimal_reduced_gain
    guides = [
        Guide(told("this clutch: {stated}", stated=stated("zC", own, "1")), own, across=False),
        Guide(told("best by the published T_ср, {stated}", stated=stated("zC", best, "1")), best, across=False),
    ]
    x = ChartAxis(translate("reduced gain"), "zC" if curve.bypass_pairs == 0 else "z_2 C")
    return Chart(
        x,
        ChartAxis(translate("accuracy factor"), "K_т"),
        lines,
        title=translate("Accuracy over the reduced gain"),
        guides=guides,
    )
