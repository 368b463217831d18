"""Sheets of charts: clutches over friction, a spec key or time, scatter, fronts, and the papers' figures."""

import math
from collections import Counter
from collections.abc import Sequence

from ...analysis.design import DesignResult, DesignRow
from ...analysis.plot_data import (
    AccuracyCurve,
    LifeCurve,
    OverloadCurve,
    ParetoFigure,
    SimulateFigure,
    ToleranceFigure,
    TorqueCurve,
)
from ...messages import deferred, localized, named, say, translate
from ...papers.claims import PaperFigure
from ...spec.keys import is_whole
from ..amounts import display
from .chart import Area, Chart, ChartAxis, Guide, Line, Sheet, axis_of, guide_at, line_of, power, stated

_METHODS = {
    "min-friction": deferred("protected side, set at f_min"),
    "mean-friction": deferred("protected side, set at mean f with margin"),
}
SPRINGS = {"closing": deferred("closing spring"), "control": deferred("control spring")}
_EVENTS = {
    "stop": deferred("At t = 0 the tool is stopped; friction is constant during the event."),
    "load": deferred("At t = 0 the load of the tool rises; friction is constant during the event."),
}


def _called(curve: TorqueCurve | AccuracyCurve | LifeCurve) -> str:
    """Label for the curve of a clutch, if several clutches are drawn."""
    return named(curve.name) or translate(curve.variant, "value")


def torque(curves: Sequence[TorqueCurve]) -> Sheet:
    """Torque over friction: one clutch set by both methods, with scatter bands, or several clutches as they are set."""
    unlike = any(curve.friction_driving for curve in curves)
    x = axis_of(curves[0], "friction_driving" if unlike else "friction")
    y = axis_of(curves[0], "torque", quantity=translate("slip torque"))
    title = translate("Slip torque against friction")
    if len(curves) > 1:
        lines = [Line(_called(curve), curve.friction, curve.torque) for curve in curves]
        return Sheet(title, [Chart(x, y, lines, from_zero=True, named=True)])
    (curve,) = curves
    methods = ("torque_min_friction", "torque_mean_friction")
    extra = [name for name in ("breakaway_torque", "torque_returning") if getattr(curve, name)]
    lines = [line_of(curve, name, curve.friction) for name in (*methods, *extra)]
    for number, line in enumerate(lines[:2]):
        scatter = stated(f"ΔT_{number + 1}", abs((line.y[-1] or 0.0) - (line.y[0] or 0.0)), "N*m")
        lines[number] = line._replace(label=f"{line.label}, {scatter}")
    guide = guide_at(deferred("clutch's nominal torque {stated}"), "T_н", curve.nominal_torque, "N*m")
    caption = say(
        "Both settings for the same nominal torque; margin β_н = {margin:g} in the second. ΔT is the scatter band of "
        "each. The spec sets it by {method}.",
        margin=curve.margin, method=translate(curve.method),
    )  # fmt: skip
    if curve.friction_driving:
        caption += " " + translate("f_2 moves with f_1.")
    chart = Chart(x, y, lines, guides=[guide], from_zero=True)
    return Sheet(title, [chart], caption, curve.name)


def accuracy(curves: Sequence[AccuracyCurve]) -> Sheet:
    """Accuracy factor K_т over the gain or another key; for one clutch also its present value and the gain limit."""
    y = axis_of(curves[0].series, "accuracy_factor")
    x = ChartAxis(translate(curves[0].about).partition(";")[0], curves[0].symbol, curves[0].unit)
    title = say("Accuracy factor K_т against {quantity} {symbol}", quantity=x.quantity, symbol=x.symbol).rstrip()
    if len(curves) > 1:
        lines = [
            Line(_called(curve), curve.series.values, curve.series.accuracy_factor, points=is_whole(curve.series.path))
            for curve in curves
        ]
        return Sheet(title, [Chart(x, y, lines, named=True)])
    (curve,) = curves
    series, symbol = curve.series, x.symbol or curve.series.path
    pairs = zip(series.accuracy_factor_peak, series.accuracy_factor, strict=True)
    peaks = any(peak > sustained * (1 + 1e-9) for peak, sustained in pairs)
    answers = ["accuracy_factor", *(["accuracy_factor_peak"] if peaks else [])]
    lines = [line_of(series, answer, series.values, points=is_whole(series.path)) for answer in answers]
    guides = []
    if curve.own is not None:
        own, factor = stated(symbol, curve.own, x.unit), stated("K_т", curve.accuracy_factor, "1")
        guides.append(Guide(say("this clutch: {own}, {factor}", own=own, factor=factor), curve.own, across=False))
    if curve.limit is not None:
        guides.append(guide_at(deferred("limit of the gain, {stated}"), symbol, curve.limit, "1", across=False))
    return Sheet(title, [Chart(x, y, lines, guides=guides)], name=curve.name)


def overload(curve: OverloadCurve) -> Sheet:
    """Trip torque over friction, and expected and actual accuracy over the reduced gain (S22 fig. 3)."""
    caption = translate(
        "Equilibrium: at slip the load equals the expected torque for every margin; the published T_ср = T_п − ΔT' "
        "(S22 (14)) swaps the weights of T_п and T_н.маш (misprint M12). Where the release force lags the load "
        "(impact), the trip lies in the shaded bracket. Curves of K_т as S22 fig. 3, its optimum at zC = 1/f_max (M13)."
    )
    lines = [line_of(curve, name, curve.friction) for name in ("expected_torque", "actuation_torque_published")]
    dots = line_of(curve, "actuation_torque_equilibrium", curve.friction, points=True)
    lines.append(dots._replace(x=dots.x[::20], y=dots.y[::20]))
    label = translate("trip bracket, T_муф to T_п")
    trip = Chart(
        axis_of(curve, "friction"),
        axis_of(curve, "expected_torque", quantity=translate("torque"))._replace(symbol="T"),
        lines,
        translate("Torque at the trip"),
        guides=[guide_at(deferred("machine's nominal torque {stated}"), "T_н.маш", curve.machine_torque, "N*m")],
        areas=[Area(label, curve.friction, curve.expected_torque, curve.potential_torque)],
        from_zero=True,
    )
    series = curve.accuracy
    gains = {
        deferred("this clutch: {stated}"): curve.reduced_gain,
        deferred("best by the published T_ср, {stated}"): curve.optimal_reduced_gain,
    }
    accuracy = Chart(
        ChartAxis(translate("reduced gain"), "zC" if curve.bypass_pairs == 0 else "z_2 C"),
        ChartAxis(translate("accuracy factor"), "K_т"),
        [line_of(series, f"accuracy_factor_{name}", series.values) for name in ("expected", "actual")],
        translate("Accuracy over the reduced gain"),
        guides=[guide_at(text, "zC", gain, "1", across=False) for text, gain in gains.items()],
    )
    title = say("Overload with the margin {stated}", stated=stated("β_н", curve.margin, "1"))
    return Sheet(title, [trip, accuracy], caption, curve.name)


def life(curves: Sequence[LifeCurve]) -> Sheet:
    """Life over the scatter band: both sides and settings of one clutch, or the protected side of several clutches."""
    x = ChartAxis(translate("torque scatter band"), "ΔT", "N*m")
    y = axis_of(curves[0].series, "protected", quantity=translate("cycles to failure"))
    first, single = curves[0], len(curves) == 1
    if single:
        sides = ("protected", "unprotected", "protected_forecast")
        lines = [line_of(first.series, side, first.series.values) for side in sides]
        own = ((translate(_METHODS[each.method]), each.scatter, each.cycles) for each in first.settings)
        lines += [Line(label, [band], [cycles], points=True) for label, band, cycles in own if cycles]
        title = translate("Life against the scatter band")
        guides = [Guide(say("base cycles N_0 = {cycles}", cycles=power(first.base_cycles)), first.base_cycles)]
    else:
        lines = [Line(_called(curve), curve.series.values, curve.series.protected) for curve in curves]
        title, guides = translate("Life of the protected side against the scatter band"), []
    beyond = translate(
        "Above N_0 the stress is below the endurance limit: life is not limited by fatigue, the line is extrapolated "
        "as the paper does."
        if first.model == "mean-stress"
        else "Where there is no line, fatigue sets no limit."
    )
    about = say("Model: {model}. T_min as the clutch has it, T_max = T_min + ΔT.", model=translate(first.model))
    chart = Chart(x, y, lines, guides=guides, log=True, named=not single)
    return Sheet(title, [chart], f"{about} {beyond}", first.name if single else None)


def simulate(figure: SimulateFigure) -> Sheet:
    """An event of the drive over time: shaft torque and travel of the sleeve at three frictions, and the speeds."""
    mean = figure.courses[1]
    time, times = axis_of(mean[0], "time"), [row.time for row in mean]
    load = guide_at(deferred("load before the event {stated}"), "T_0", figure.result.load_torque, "N*m")
    torques, title = _at_frictions(figure, "torque_shaft"), translate("Torque in the shaft")
    panels = [Chart(time, axis_of(mean[0], "torque_shaft"), torques, title, guides=[load])]
    halves = {"speed_motor": "motor side ω_1", "speed_driven": "driven half ω_2", "speed_tool": "tool ω_3"}
    speeds = [Line(translate(text), times, [getattr(row, half) for row in mean]) for half, text in halves.items()]
    speed = ChartAxis(translate("speed"), "ω", "rad/s")
    panels.append(Chart(time, speed, speeds, translate("Speeds at the mean friction")))
    if figure.result.travel_max is not None:
        travels = _at_frictions(figure, "travel")
        panels.append(Chart(time, axis_of(mean[0], "travel"), travels, translate("Travel of the sleeve")))
    peak_torques = (figure.result.peak_torque, figure.result.peak_torque_conventional)
    listed, ordinary = ("; ".join(display(end, "N*m") for _, end in ends) for ends in peak_torques)
    peaks = say(
        "Peaks in the shaft, N·m: {peaks}; with an ordinary clutch of equal T_н: {ordinary}. Shown until the peak has "
        "passed; the slip may last longer.",
        peaks=listed, ordinary=ordinary,
    )  # fmt: skip
    caption = f"{translate(_EVENTS[figure.kind])} {peaks}"
    return Sheet(translate("When the clutch trips"), panels, caption, figure.name)


def _at_frictions(figure: SimulateFigure, name: str) -> list[Line]:
    lines = []
    for friction, course in zip(("f_min", "f_cp", "f_max"), figure.courses, strict=True):
        time, values = ([getattr(row, each) for row in course] for each in ("time", name))
        lines.append(Line(say("at {friction}", friction=friction), time, values))
    return lines


def paper(figure: PaperFigure) -> Sheet:
    """One figure of the papers, redrawn from the formulas; the caption names the corrections."""
    x, *axes = (ChartAxis(translate(axis.name), axis.symbol, axis.unit) for axis in (figure.x, *figure.y))
    panels = []
    for y, drawn, curves in zip(axes, figure.y, figure.panels, strict=True):
        shown = []
        for number, label, along, up, points in curves:
            name = ": ".join(filter(None, (number, translate(label))))
            # the number that a curve has in the paper is written at the end of the curve
            shown.append(Line(name, along, up, points=points, names=[""] * (len(along) - 1) + [number]))
        panels.append(Chart(x, y, shown, log=drawn.log))
    caption = [translate(figure.inputs), say("Mended: {mended}.", mended="; ".join(map(translate, figure.corrections)))]
    if figure.assumed:
        caption.append(say("Not printed, assumed here: {assumed}", assumed=translate(figure.assumed)))
    return Sheet(f"{translate(figure.name)}: {translate(figure.title)}", panels, "\n".join(caption))


def tolerance(figure: ToleranceFigure) -> Sheet:
    """Histogram of the torque, with quantiles, the nominal torques and the limit marked."""
    result, bars = figure.result, figure.result.histogram
    x = [bars[0].low, *(end for bar in bars for end in (bar.low, bar.high)), bars[-1].high]
    y = [0.0, *(bar.density for bar in bars for _ in range(2)), 0.0]
    label = translate("quantiles: torque not exceeded with this probability")
    guides = [
        Guide("" if number else label, row.torque, across=False, tag=_percent(row.probability), style=0)
        for number, row in enumerate(result.quantiles)
    ]
    torques = [("T_н", translate("clutch's nominal torque"), figure.nominal_torque)]
    if not math.isclose(result.machine_torque, figure.nominal_torque):
        torques.append(("T_н.маш", translate("machine's nominal torque"), result.machine_torque))
    if result.torque_limit is not None:
        torques.append(("T_lim", translate("torque limit"), result.torque_limit))
    guides += [
        Guide(stated(f"{about} {symbol}", value, "N*m"), value, across=False, tag=symbol, style=style)
        for style, (symbol, about, value) in enumerate(torques, 1)
    ]
    ends = [*x, *(guide.value for guide in guides)]
    room = 0.03 * (max(ends) - min(ends))
    chart = Chart(
        ChartAxis(translate("slip torque"), "T", "N*m"),
        ChartAxis(translate("probability density"), "p", "1/(N*m)"),
        [Line(translate("density of the slip torque"), x, y)],
        guides=guides,
        areas=[Area("", x, [0.0] * len(x), y)],
        bounds=(min(ends) - room, max(ends) + room, 0.0, 1.05 * max(y)),
    )
    return Sheet(translate("Slip torque over tolerances and scatter"), [chart], _study_caption(figure), figure.name)


def _study_caption(figure: ToleranceFigure) -> str:
    result = figure.result
    listed = "; ".join(f"{_percent(row.probability)}: {display(row.torque, 'N*m')}" for row in result.quantiles)
    risks = [_risk("T < T_н.маш", result.probability_below_machine, result.samples)]
    if result.probability_above_limit is not None:
        risks.append(_risk("T > T_lim", result.probability_above_limit, result.samples))
    sentences = (
        say("{samples:.0f} samples, seed {seed}.", samples=result.samples, seed=figure.seed),
        say("The bars hold the middle {share}.", share=_percent(0.999)),
        say("Quantiles in N·m: {listed}.", listed=listed),
        say("Robust accuracy factor K_т,r = {factor}.", factor=display(result.accuracy_factor_robust, "1")),
    )
    return f"{' '.join(sentences)} {', '.join(risks)}."


def _risk(event: str, probability: float, samples: int) -> str:
    """Probability of an event as text; for an event that no sample has: rarer than one in ``samples``."""
    return f"P({event}) {'=' if probability else '<'} {_percent(probability or 1 / samples)}"


def _percent(probability: float) -> str:
    return f"{localized(f'{100 * probability:.4g}')} %"


def pareto(figure: ParetoFigure) -> Sheet:
    """The Pareto front of a design: the first objective against each other objective, each clutch with its number."""
    result = figure.result
    x, *others = dict.fromkeys(name.removeprefix("-") for name in result.objectives)
    charts = [_front(result, x, y) for y in others]
    return Sheet(translate("Pareto front"), charts, _front_caption(result), figure.name)


def _front(result: DesignResult, x: str, y: str) -> Chart:
    """Draw the clutches of a front, each variant with its own markers, the compromise filled."""

    def points(label: str, rows: list[DesignRow]) -> Line:
        along, up = ([row.objective(name) for row in rows] for name in (x, y))
        return Line(label, along, up, points=True, names=[str(row.number) for row in rows])

    def bounds(name: str) -> tuple[float, float]:
        values = [row.objective(name) for row in result.front]
        low, high = min(values), max(values)
        room = 0.04 * (high - low) or 0.04 * abs(high) or 1.0
        return low - room, high + room

    variants = sorted({row.variant for row in result.front})
    lines = [
        points(translate(variant, "value"), [row for row in result.front if row.variant == variant])
        for variant in variants
    ]
    for row in result.front:
        if row.mark:
            marked = points(say("compromise: no. {number}", number=str(row.number)), [row])
            lines.append(marked._replace(filled=True))
    x_axis, y_axis = (axis_of(result.front[0], name) for name in (x, y))
    return Chart(x_axis, y_axis, lines, bounds=(*bounds(x), *bounds(y)))


def _front_caption(result: DesignResult) -> str:
    objectives = [name.removeprefix("-") for name in result.objectives]
    names = [axis_of(result.front[0], name).symbol for name in objectives]
    listed = say("{names} and {last}", names=", ".join(names[:-1]), last=names[-1])
    counts = sorted(Counter(row.variant for row in result.front).items())
    variants = ", ".join(say("{count:,} {variant}", count=count, variant=translate(name)) for name, count in counts)
    if len(counts) == 1:
        variants = say("all {variant}", variant=translate(counts[0][0]))
    caption = say(
        "{feasible:,} of {candidates:,} candidates meet every requirement; the {front:,} drawn are beaten by no other "
        "in {listed} together ({variants}). Numbers are those of --pick.",
        feasible=result.feasible, candidates=result.candidates, front=len(result.front), listed=listed,
        variants=variants,
    )  # fmt: skip
    lacking = any(getattr(row, name) is None for row in result.front for name in objectives)
    free = translate("What a variant does not have costs nothing: it lies at 0.")
    return f"{caption} {free}" if lacking else caption
