"""An event of the drive: torque in the shaft, speeds, and the sleeve's travel over time."""

from collections.abc import Callable

from ....analysis.figures import SimulateFigure
from ....analysis.simulate import MomentRow
from ....messages import term, told, translate
from ....result import OpenTriple, Triple
from ...units import display
from ..chart import Chart, ChartAxis, Guide, Line, Sheet, axis_of, stated

_ENDS = ("f_min", "f_cp", "f_max")
_EVENTS = {
    "stop": term("At t = 0 the tool is stopped; friction is constant during the event."),
    "load": term("At t = 0 the load of the tool rises; friction is constant during the event."),
}


def sheet(figure: SimulateFigure) -> Sheet:
    """Draw what the shaft carries at three frictions, who turns how fast, and how far the sleeve goes."""
    panels = [_torque(figure), _speeds(figure)]
    if figure.result.travel_max is not None:
        panels.append(_travel(figure))
    peaks, ordinary = figure.result.peak_torque, figure.result.peak_torque_conventional
    told_peaks = told(
        "Peaks in the shaft, N·m: {peaks}; with an ordinary clutch of equal T_н: {ordinary}. Shown until the peak has "
        "passed; the slip may last longer.",
        peaks=_listed(peaks), ordinary=_listed(ordinary),
    )  # fmt: skip
    caption = f"{translate(_EVENTS[figure.kind])} {told_peaks}"
    return Sheet(translate("When the clutch trips"), panels, caption, figure.name or "")


def _listed(ends: OpenTriple | Triple) -> str:
    return "; ".join(display(end, "N*m") for end in (ends.min, ends.mean, ends.max))


def _lines(figure: SimulateFigure, value: Callable[[MomentRow], float | None], style: int = 0) -> list[Line]:
    return [
        Line(
            told("at {friction}", friction=end),
            [row.time for row in course],
            [value(row) for row in course],
            style=style + number,
        )
        for number, (end, course) in enumerate(zip(_ENDS, figure.courses, strict=True))
    ]


def _time() -> ChartAxis:
    return axis_of(MomentRow, "time")


def _torque(figure: SimulateFigure) -> Chart:
    guides = [Guide(told("load before the event {stated}", stated=stated("T_0", figure.load, "N*m")), figure.load)]
    lines = _lines(figure, lambda row: row.torque_shaft)
    return Chart(
        _time(), axis_of(MomentRow, "torque_shaft"), lines, title=translate("Torque in the shaft"), guides=guides
    )


def _speeds(figure: SimulateFigure) -> Chart:
    course = figure.courses[1]
    times = [row.time for row in course]
    lines = [
        Line(translate("motor side ω_1"), times, [row.speed_motor for row in course]),
        Line(translate("driven half ω_2"), times, [row.speed_driven for row in course]),
        Line(translate("tool ω_3"), times, [row.speed_tool for row in course]),
    ]
    return Chart(
        _time(), ChartAxis(translate("speed"), "ω", "rad/s"), lines, title=translate("Speeds at the mean friction")
    )


def _travel(figure: SimulateFigure) -> Chart:
    return Chart(
        _time(),
        axis_of(MomentRow, "travel"),
        _lines(figure, lambda row: row.travel),
        title=translate("Travel of the sleeve"),
    )
