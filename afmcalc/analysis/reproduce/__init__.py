"""Every printed figure and claim of the papers recomputed: what follows from the formulas, and what does not."""

from collections.abc import Callable
from importlib import import_module
from typing import Literal

from ...engines.findings import Finding
from ...errors import AfmcalcError
from ...spec.suggest import did_you_mean
from ..register import PAPERS
from ..result import Result, quantity

Verdict = Literal["reproduced", "reproduced with correction", "not reproduced"]


class Row(Result):
    """One printed figure or claim."""

    id: str = quantity("", None, "id")
    source: str = quantity("", None, "source")
    inputs: str = quantity("", None, "inputs", detail=True)
    printed: str = quantity("", None, "printed")
    computed: str = quantity("", None, "computed")
    deviation: float | None = quantity("1", "dev.", "computed over printed, less 1")
    verdict: Verdict = quantity("", None, "verdict")
    correction: str | None = quantity("", None, "correction")
    why: str = quantity("", None, "why")


class ReproduceResult(Result):
    """The rows asked for, and whether every verdict is the one on record."""

    rows: list[Row] = quantity("", None, "printed figures and claims")
    reproduced: int = quantity("", None, "reproduced as printed")
    corrected: int = quantity("", None, "reproduced with a correction")
    not_reproduced: int = quantity("", None, "not reproduced")
    as_expected: bool = quantity("", None, "every verdict is the one on record")


EXPECTED: dict[str, Verdict] = {
    **dict.fromkeys(("P2", "P7", "P9", "P11", "P12", "P19", "P22"), "reproduced"),
    **dict.fromkeys(("P1", "P3", "P5", "P6", "P8", "P10", "P13"), "reproduced with correction"),
    **dict.fromkeys(("P4", "P14", "P15", "P16", "P17", "P18", "P20", "P21"), "not reproduced"),
}
"""The verdict on record for every row; a different one means the formulas have changed."""

_MODULES = {"F11": "fokin2011", "S19": "shishkarev2019", "S21": "shishkarev2021", "S22": "shishkarev2022"}


def reproduce(papers: list[str]) -> tuple[ReproduceResult, list[Finding]]:
    """Recompute the printed figures of the papers asked for (empty: all), in the order of their numbers.

    Raises:
        AfmcalcError: no such paper.
    """
    for paper in papers:
        if paper not in PAPERS:
            raise AfmcalcError(
                f"--paper {paper}: no such paper{did_you_mean(paper, PAPERS)}; papers: {', '.join(PAPERS)}"
            )
    rows: list[Row] = []
    for paper in papers or PAPERS:
        module = import_module(f".{_MODULES[paper]}", __name__)
        rows += [check() for check in module.CHECKS]
    rows.sort(key=lambda row: int(row.id[1:]))
    verdicts = [row.verdict for row in rows]
    unexpected = [row for row in rows if row.verdict != EXPECTED[row.id]]
    result = ReproduceResult(
        rows=rows,
        reproduced=verdicts.count("reproduced"),
        corrected=verdicts.count("reproduced with correction"),
        not_reproduced=verdicts.count("not reproduced"),
        as_expected=not unexpected,
    )
    findings = [
        Finding("error", "unexpected-verdict", f"{row.id}: {row.verdict}; on record is: {EXPECTED[row.id]}")
        for row in unexpected
    ]
    return result, findings


Check = Callable[[], Row]


def verdict(as_printed: bool, corrected: bool = False) -> Verdict:
    """Judge a row: it follows from the inputs as printed, or with the correction, or not at all."""
    if as_printed:
        return "reproduced"
    return "reproduced with correction" if corrected else "not reproduced"


def near(computed: float, printed: float, digits: float) -> bool:
    """Whether a computed number rounds to the printed one: ``digits`` is a unit in its last place."""
    return abs(computed - printed) <= digits


def figures(values: list[float], digits: int = 3) -> str:
    """List numbers for a cell."""
    return ", ".join(f"{value:.{digits}f}" for value in values)
