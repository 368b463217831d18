"""Torque against friction, by the law and between what each neglected effect makes of it."""

from ....analysis.effects import EffectsCurve
from ....messages import term, translate
from ..chart import Chart, Line, Sheet, axis_of, describe

NAMES = {
    "spline-friction": term("discs held in their splines"),
    "sliding-cams": term("cams that slide"),
    "centrifugal": term("balls thrown against conical pockets"),
    "wear": term("lining worn"),
}


def sheet(curve: EffectsCurve) -> Sheet:
    """Draw the law's curve, and two of each effect."""
    lines = [Line(describe(EffectsCurve, "torque"), curve.friction, curve.torque, style=0)]
    for style, own in enumerate(curve.effects, 1):
        for field, end in (("T_high", own.high), ("T_low", own.low)):
            if end != curve.torque:
                lines.append(Line(f"{translate(NAMES[own.effect])}, {field}", curve.friction, end, style=style))
    x, y = axis_of(EffectsCurve, "friction"), axis_of(EffectsCurve, "torque", quantity=translate("slip torque"))
    caption = translate("Springs as set. Of each effect both ends: the torque lies between, by what happened before.")
    return Sheet(
        translate("What the law neglects"), [Chart(x, y, lines, from_zero=True)], caption, name=curve.name or ""
    )
