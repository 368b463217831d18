"""An event of the drive: torque in the shaft, speeds, and the sleeve's travel over time."""

from collections.abc import Callable

from ....analysis.figures import SimulateFigure
from ....analysis.simulate.history import MomentRow
from ...units import display
from ..chart import Chart, ChartAxis, Guide, Line, Sheet, axis_of, stated

_ENDS = ("f_min", "f_cp", "f_max")
_EVENTS = {"stop": "the tool is stopped", "load": "the load of the tool rises"}


def sheet(figure: SimulateFigure) -> Sheet:
    """Draw what the shaft carries at three frictions, who turns how fast, and how far the sleeve goes."""
    panels = [_torque(figure), _speeds(figure)]
    if figure.result.travel_max is not None:
        panels.append(_travel(figure))
    peaks, ordinary = figure.result.peak_torque, figure.result.peak_torque_conventional
    caption = (
        f"At t = 0 {_EVENTS[figure.kind]}; friction is constant during the event. Peaks in the shaft: "
        + ", ".join(f"{display(getattr(peaks, end), 'N*m')}" for end in ("min", "mean", "max"))
        + " N·m; with an ordinary clutch of equal T_н: "
        + ", ".join(f"{display(getattr(ordinary, end), 'N*m')}" for end in ("min", "mean", "max"))
        + " N·m. Shown until the peak has passed; the slip may last longer."
    )
    return Sheet("When the clutch trips", panels, caption, figure.name or "")


def _lines(figure: SimulateFigure, value: Callable[[MomentRow], float | None], style: int = 0) -> list[Line]:
    return [
        Line(f"at {end}", [row.time for row in course], [value(row) for row in course], style=style + number)
        for number, (end, course) in enumerate(zip(_ENDS, figure.courses, strict=True))
    ]


def _time() -> ChartAxis:
    return axis_of(MomentRow, "time")


def _torque(figure: SimulateFigure) -> Chart:
    guides = [Guide(stated("load before the event T_0", figure.load, "N*m"), figure.load)]
    lines = _lines(figure, lambda row: row.torque_shaft)
    return Chart(_time(), axis_of(MomentRow, "torque_shaft"), lines, title="Torque in the shaft", guides=guides)


def _speeds(figure: SimulateFigure) -> Chart:
    course = figure.courses[1]
    times = [row.time for row in course]
    lines = [
        Line("motor side ω_1", times, [row.speed_motor for row in course]),
        Line("driven half ω_2", times, [row.speed_driven for row in course]),
        Line("tool ω_3", times, [row.speed_tool for row in course]),
    ]
    return Chart(_time(), ChartAxis("speed", "ω", "rad/s"), lines, title="Speeds at the mean friction")


def _travel(figure: SimulateFigure) -> Chart:
    return Chart(
        _time(), axis_of(MomentRow, "travel"), _lines(figure, lambda row: row.travel), title="Travel of the sleeve"
    )
