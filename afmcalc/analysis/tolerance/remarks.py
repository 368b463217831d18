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
    least = max(needed(p) for p in given.quantiles)
    if figures.samples is not None and figures.samples < least:
        found.append(finding("few-samples", "warning", value=figures.samples, limit=least, path="tolerance.samples"))
    return found
