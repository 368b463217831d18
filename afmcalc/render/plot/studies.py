"""Sheets of many clutches at once: the scatter of the torque under tolerances, and the front of a design."""

import math
from collections import Counter
from typing import TYPE_CHECKING

from ...messages import localized, say, translate
from ..amounts import display
from .chart import Area, Chart, ChartAxis, Guide, Line, Sheet, axis_of, stated

if TYPE_CHECKING:
    from ...analysis.design import DesignResult, DesignRow
    from ...analysis.plot_data import ParetoFigure, ToleranceFigure


def tolerance(figure: "ToleranceFigure") -> Sheet:
    """Histogram of the torque, with quantiles, the nominal torques and the limit marked."""
    result, bars = figure.result, figure.result.histogram
    x = [bars[0].low, *(end for bar in bars for end in (bar.low, bar.high)), bars[-1].high]
    y = [0.0, *(bar.density for bar in bars for _ in range(2)), 0.0]
    label = translate("quantiles: torque not exceeded with this probability")
    guides = [
        Guide("" if number else label, row.torque, across=False, tag=_percent(row.probability), style=0)
        for number, row in enumerate(result.quantiles)
    ]
    nominal, machine, limit = figure.nominal_torque, result.machine_torque, result.torque_limit
    torques = [
        ("T_н", translate("clutch's nominal torque"), nominal),
        ("T_н.маш", translate("machine's nominal torque"), None if math.isclose(machine, nominal) else machine),
        ("T_lim", translate("torque limit"), limit),
    ]
    marked = [(symbol, about, value) for symbol, about, value in torques if value is not None]
    guides += [
        Guide(stated(f"{about} {symbol}", value, "N*m"), value, across=False, tag=symbol, style=style)
        for style, (symbol, about, value) in enumerate(marked, 1)
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


def _study_caption(figure: "ToleranceFigure") -> str:
    result = figure.result
    how = say("{samples:.0f} samples, seed {seed}.", samples=result.samples, seed=figure.seed)
    listed = "; ".join(f"{_percent(row.probability)}: {display(row.torque, 'N*m')}" for row in result.quantiles)
    risks = [_risk("T < T_н.маш", result.probability_below_machine, result.samples)]
    if result.probability_above_limit is not None:
        risks.append(_risk("T > T_lim", result.probability_above_limit, result.samples))
    return " ".join(
        (
            how,
            say("The bars hold the middle {share}.", share=_percent(0.999)),
            say("Quantiles in N·m: {listed}.", listed=listed),
            say("Robust accuracy factor K_т,r = {factor}.", factor=display(result.accuracy_factor_robust, "1")),
            ", ".join(risks) + ".",
        )
    )


def _risk(event: str, probability: float, samples: int) -> str:
    """Probability of an event as text; for an event that no sample has: rarer than one in ``samples``."""
    if not probability:
        return f"P({event}) < {_percent(1 / samples)}"
    return f"P({event}) = {_percent(probability)}"


def _percent(probability: float) -> str:
    return f"{localized(f'{100 * probability:.4g}')} %"


def pareto(figure: "ParetoFigure") -> Sheet:
    """The Pareto front of a design: the first objective against each other objective, each clutch with its number."""
    result = figure.result
    x, *others = dict.fromkeys(name.removeprefix("-") for name in result.objectives)
    charts = [_front(result, x, y) for y in others]
    return Sheet(translate("Pareto front"), charts, _front_caption(result), figure.name)


def _front(result: "DesignResult", x: str, y: str) -> Chart:
    """Draw the clutches of a front, each variant with its own markers, the compromise filled."""
    variants = sorted({row.variant for row in result.front})
    lines = [
        _points(translate(variant, "value"), [row for row in result.front if row.variant == variant], x, y)
        for variant in variants
    ]
    for row in result.front:
        if row.mark:
            marked = _points(say("compromise: no. {number}", number=str(row.number)), [row], x, y)
            lines.append(marked._replace(filled=True))
    along, up = (_ends([row.objective(name) for row in result.front]) for name in (x, y))
    return Chart(_objective(result, x), _objective(result, y), lines, bounds=(*along, *up))


def _points(label: str, rows: "list[DesignRow]", x: str, y: str) -> Line:
    along, up = ([row.objective(name) for row in rows] for name in (x, y))
    return Line(label, along, up, points=True, names=[str(row.number) for row in rows])


def _objective(result: "DesignResult", name: str) -> ChartAxis:
    return axis_of(result.front[0], name)


def _ends(values: list[float]) -> tuple[float, float]:
    low, high = min(values), max(values)
    room = 0.04 * (high - low) or 0.04 * abs(high) or 1.0
    return low - room, high + room


def _front_caption(result: "DesignResult") -> str:
    objectives = [name.removeprefix("-") for name in result.objectives]
    names = [_objective(result, name).symbol for name in objectives]
    listed = say("{names} and {last}", names=", ".join(names[:-1]), last=names[-1])
    counts = sorted(Counter(row.variant for row in result.front).items())
    if len(counts) == 1:
        variants = say("all {variant}", variant=translate(counts[0][0]))
    else:
        variants = ", ".join(say("{count:,} {variant}", count=count, variant=translate(name)) for name, count in counts)
    caption = say(
        "{feasible:,} of {candidates:,} candidates meet every requirement; the {front:,} drawn are beaten by no other "
        "in {listed} together ({variants}). Numbers are those of --pick.",
        feasible=result.feasible, candidates=result.candidates, front=len(result.front), listed=listed,
        variants=variants,
    )  # fmt: skip
    lacking = any(getattr(row, name) is None for row in result.front for name in objectives)
    free = translate("What a variant does not have costs nothing: it lies at 0.")
    return f"{caption} {free}" if lacking else caption
