"""Remarks on a study: what varies, who is set, what the sample cannot tell."""

from ...findings import Finding, finding
from ...spec.tolerance import FRICTION, Tolerance
from .figures import Figures
from .model import Model
from .ranked import needed


def findings_of(model: Model, given: Tolerance, figures: Figures) -> list[Finding]:
    """Remarks in the order of the [tolerance] block, then on the figures."""
    names = {each.path for each in model.inputs}
    found = []
    if not names <= set(FRICTION):
        adjusted = given.setting == "each-adjusted"
        found.append(finding("each-adjusted" if adjusted else "as-made", "info", path="tolerance.setting"))
    if not names & set(FRICTION):
        found.append(finding("friction-fixed", "info", path="tolerance.fields"))
    if {"friction.driving", "friction.driven"} <= names and given.friction_correlation is None:
        found.append(finding("friction-independent", "info", path="tolerance.friction_correlation"))
    if figures.lives:
        found.append(finding("miner", "info", path="fatigue"))
    return [*found, *_of_the_sample(given, figures)]


def _of_the_sample(given: Tolerance, figures: Figures) -> list[Finding]:
    found = []
    if figures.no_clutch is not None and figures.no_clutch.value > 0:
        found.append(finding("no-clutch", "warning", value=figures.no_clutch.value, limit=0.0, path="tolerance.fields"))
    found += _of_the_tails(given, figures)
    least = max(needed(p) for p in given.quantiles)
    if figures.samples is not None and figures.samples < least:
        found.append(finding("few-samples", "warning", value=figures.samples, limit=least, path="tolerance.samples"))
    return found


_UNSURE = {"monte-carlo": 0.025, "quasi-monte-carlo": 0.005}
"""Relative standard error of the standard deviation beyond which it is too small itself: two of them cover the true
value of lognormal torques in 92…95 % of samples below, in 89, 76 and 57 % at 0.034, 0.046 and 0.065 (quasi: 75 % at
0.013)."""
_HEAVY = 10.0
"""Kurtosis (3 of a normal torque) below which few samples, not the tails, make that error large: it is a fair one."""


def _of_the_tails(given: Tolerance, figures: Figures) -> list[Finding]:
    """Say where so few samples carry the variance that its error cannot be known from them."""
    limit = _UNSURE.get(figures.method)
    if limit is None or figures.samples is None or not figures.deviation.value:
        return []
    error = figures.deviation.standard_error / figures.deviation.value
    kurtosis = 1 + 4 * figures.samples * error**2
    # two samples stand behind each index
    of_indices = ((kurtosis - 1) / (8 * given.sobol_base)) ** 0.5
    if kurtosis <= _HEAVY or max(error, of_indices) <= limit:
        return []
    code, path = "heavy-tails/indices", "tolerance.sobol_base"
    if error > limit:
        code, path = "heavy-tails", "tolerance.samples"
    return [finding(code, "warning", value=max(error, of_indices), limit=limit, path=path)]
