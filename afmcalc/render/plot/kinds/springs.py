"""Force of the springs over their deflection, with what the clutch uses of it."""

from ....analysis.springs.curve import SpringCurve, SpringsCurve
from ....messages import term, told, translate
from ..chart import Chart, Guide, Line, Sheet, axis_of, describe, stated

NAMES = {"closing": term("closing spring"), "control": term("control spring")}


def sheet(curve: SpringsCurve) -> Sheet:
    """Draw a panel for each spring."""
    caption = translate(
        "Upright: ends of the range of use, and of what service takes of it. Friction between discs is left out."
    )
    return Sheet(translate("Springs"), [_panel(each) for each in curve.springs], caption, name=curve.name or "")


def _panel(own: SpringCurve) -> Chart:
    lines = [
        Line(describe(SpringCurve, "force"), own.deflection, own.force),
        Line(
            describe(SpringCurve, "tangent"),
            own.deflection,
            [force if force >= 0 else None for force in own.tangent],
        ),
        Line(
            told("as set: {stated}", stated=stated("F", own.set_force, "N")),
            [own.set_deflection],
            [own.set_force],
            points=True,
        ),
    ]
    guides = [Guide(translate("range of use"), end, across=False, style=0) for end in own.usable if end > 0]
    low, high = own.service
    guides += [Guide(translate("service"), end, across=False, style=1) for end in sorted({low, high})]
    x, y = axis_of(SpringCurve, "deflection"), axis_of(SpringCurve, "force")
    title = f"{translate(NAMES[own.spring])}: {translate(own.part)}"
    return Chart(x, y, lines, title=title[:1].upper() + title[1:], guides=_named_once(guides), from_zero=True)


def _named_once(guides: list[Guide]) -> list[Guide]:
    """Only the first of those that mean the same is named in the legend."""
    seen: set[str] = set()
    named = []
    for guide in guides:
        named.append(guide._replace(label="") if guide.label in seen else guide)
        seen.add(guide.label)
    return named
