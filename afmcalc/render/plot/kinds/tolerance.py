"""The torque over tolerances: its histogram, with quantiles, the nominal torques and the limit marked."""

import math

from ....analysis.figures import ToleranceFigure
from ....analysis.tolerance.result import Study
from ....messages import localized, term, told, translate
from ...units import display
from ..chart import Area, Chart, ChartAxis, Guide, Line, Sheet, stated

_METHODS = {"exact": term("Exact"), "monte-carlo": term("Monte Carlo"), "quasi-monte-carlo": term("Quasi-Monte Carlo")}


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
        ChartAxis(translate("slip torque"), "T", "N*m"),
        ChartAxis(translate("probability density"), "p", "1/(N*m)"),
        [Line(translate("density of the slip torque"), x, y)],
        guides=guides,
        areas=[Area("", x, [0.0] * len(x), y)],
        bounds=(min(ends) - room, max(ends) + room, 0.0, 1.05 * max(densities)),
    )
    return Sheet(translate("Slip torque over tolerances and scatter"), [chart], _caption(figure), figure.name or "")


def _quantiles(found: Study) -> list[Guide]:
    """Thin lines named by their probability; the first stands for all of them in the legend."""
    rows = found.result.quantiles
    label = translate("quantiles: torque not exceeded with this probability")
    return [
        Guide("" if number else label, row.torque, across=False, tag=_percent(row.probability), style=0)
        for number, row in enumerate(rows)
    ]


def _torques(figure: ToleranceFigure) -> list[Guide]:
    """The nominal torques and the limit, where each is one of its own."""
    result, nominal = figure.study.result, figure.nominal_torque
    named = [("T_н", translate("clutch's nominal torque"), nominal)]
    if not math.isclose(result.machine_torque, nominal, rel_tol=1e-9):
        named.append(("T_н.маш", translate("machine's nominal torque"), result.machine_torque))
    if result.torque_limit is not None:
        named.append(("T_lim", translate("torque limit"), result.torque_limit))
    return [
        Guide(stated(f"{about} {symbol}", value, "N*m"), value, across=False, tag=symbol, style=style)
        for style, (symbol, about, value) in enumerate(named, 1)
    ]


def _caption(figure: ToleranceFigure) -> str:
    result = figure.study.result
    how = told("{method}: only friction scatters.", method=term(_METHODS[result.method]))
    if result.samples:
        how = told(
            "{method}, {samples:,} samples, seed {seed}.",
            method=term(_METHODS[result.method]), samples=result.samples, seed=figure.seed,
        )  # fmt: skip
    said = [how, told("The bars hold the middle {share}.", share=_percent(figure.share))]
    listed = "; ".join(f"{_percent(row.probability)}: {display(row.torque, 'N*m')}" for row in result.quantiles)
    said.append(told("Quantiles in N·m: {listed}.", listed=listed))
    said.append(told("Robust accuracy factor K_т,r = {factor}.", factor=display(result.accuracy_factor_robust, "1")))
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
    return f"{localized(f'{100 * probability:.4g}')} %"
