"""The torque over tolerances: its histogram, with quantiles, the nominal torques and the limit marked."""

import math

from ....analysis.figures import ToleranceFigure
from ....analysis.tolerance.result import Study
from ...units import display
from ..chart import Area, Chart, ChartAxis, Guide, Line, Sheet, stated

_METHODS = {"exact": "Exact", "monte-carlo": "Monte Carlo", "quasi-monte-carlo": "Quasi-Monte Carlo"}


def sheet(figure: ToleranceFigure) -> Sheet:
    """Draw the histogram with what is marked on it."""
    found = figure.study
    densities = found.histogram.densities
    edges = found.histogram.edges
    x = [edge for edge in edges for _ in range(2)]
    y = [0.0, *(density for density in densities for _ in range(2)), 0.0]
    guides = [*_quantiles(found), *_torques(figure)]
    ends = [*edges, *(guide.value for guide in guides)]
    room = 0.03 * (max(ends) - min(ends))
    chart = Chart(
        ChartAxis("slip torque", "T", "N*m"),
        ChartAxis("probability density", "p", "1/(N*m)"),
        [Line("density of the slip torque", x, y)],
        guides=guides,
        areas=[Area("", x, [0.0] * len(x), y)],
        bounds=(min(ends) - room, max(ends) + room, 0.0, 1.05 * max(densities)),
    )
    return Sheet("Slip torque over tolerances and scatter", [chart], _caption(figure), figure.name or "")


def _quantiles(found: Study) -> list[Guide]:
    """Thin lines named by their probability; the first stands for all of them in the legend."""
    rows = found.result.quantiles
    label = "quantiles: torque not exceeded with this probability"
    return [
        Guide("" if number else label, row.torque, across=False, tag=_percent(row.probability), style=0)
        for number, row in enumerate(rows)
    ]


def _torques(figure: ToleranceFigure) -> list[Guide]:
    """The nominal torques and the limit, where each is one of its own."""
    result, nominal = figure.study.result, figure.nominal_torque
    named = [("T_н", "clutch's nominal torque", nominal)]
    if not math.isclose(result.machine_torque, nominal, rel_tol=1e-9):
        named.append(("T_н.маш", "machine's nominal torque", result.machine_torque))
    if result.torque_limit is not None:
        named.append(("T_lim", "torque limit", result.torque_limit))
    return [
        Guide(stated(f"{about} {symbol}", value, "N*m"), value, across=False, tag=symbol, style=style)
        for style, (symbol, about, value) in enumerate(named, 1)
    ]


def _caption(figure: ToleranceFigure) -> str:
    result = figure.study.result
    how = _METHODS[result.method]
    how += f", {result.samples:,} samples, seed {figure.seed}" if result.samples else ": only friction scatters"
    said = [f"{how}. The bars hold the middle {_percent(figure.share)}."]
    listed = ", ".join(f"{_percent(row.probability)}: {display(row.torque, 'N*m')}" for row in result.quantiles)
    said.append(f"Quantiles in N·m: {listed}.")
    said.append(f"Robust accuracy factor K_т,r = {display(result.accuracy_factor_robust, '1')}.")
    risks = [_risk("T < T_н.маш", result.probability_below_machine, result.samples)]
    if result.probability_above_limit is not None:
        risks.append(_risk("T > T_lim", result.probability_above_limit, result.samples))
    return " ".join([*said, ", ".join(risks) + "."])


def _risk(event: str, probability: float, samples: int | None) -> str:
    """A sample in which it never happens says only that it is rare."""
    if samples and not probability:
        return f"P({event}) < {_percent(1 / samples)}"
    return f"P({event}) = {_percent(probability)}"


def _percent(probability: float) -> str:
    return f"{100 * probability:.4g} %"
