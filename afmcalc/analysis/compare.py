"""Clutches side by side: several specs, or all variants as which one spec can be built."""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import ClassVar

from ..engines import Clutch, build
from ..errors import AfmcalcError, SpecError
from ..findings import Finding, finding
from ..messages import deferred, named, translate
from ..result import Answer, Triple, described
from ..spec.edit import candidate, with_key
from ..variants import VARIANTS
from .asking import Asking, answer, asked
from .check import CheckRow, check
from .clutch_findings import clutch_findings


class ComparedClutch(Asking):
    """The main quantities of one clutch; it is called by its file where names are equal."""

    name: str | None = described("clutch", optional=True)
    variant: str = described("variant")
    basis: str | None = described("kept equal", optional=True)
    closing_force: float = asked()
    nominal_torque: float = asked()
    gain: float = asked()
    reduced_gain: float = asked()
    torque: Triple = asked()
    scatter: float = asked()
    accuracy_factor: float = asked()
    accuracy_factor_peak: float = asked(description="accuracy factor by breakaway peaks")
    gain_limit: float | None = asked(description="gain limit", optional=True)
    travel_max: float | None = asked(optional=True)
    warnings: int = described("warnings of check")
    errors: int = described("errors of check")
    passed: bool | None = described("whether the check passed; null: a part is not yet judged", details=True)
    sentence: str = described("verdict", details=True)
    checks: list[CheckRow] = described("requirements and checks")


class CompareResult(Answer):
    """Clutches side by side."""

    of_several: ClassVar[bool] = True
    clutches: list[ComparedClutch] = described("clutches compared", across=True)


def compare(clutches: Sequence[Clutch], *, variants: bool = False) -> tuple[CompareResult, list[Finding]]:
    """Set the main quantities of several clutches side by side, or of one clutch built as every variant.

    A variant is built at equal spring force and at equal nominal torque. Raises AfmcalcError if ``variants`` is true
    and there are several clutches.
    """
    if variants and len(clutches) > 1:
        raise AfmcalcError("compare --variants takes one SPEC")
    entries, missing = (_as_variants(clutches[0])) if variants else ([(clutch, None) for clutch in clutches], [])
    often, rows, remarks = Counter(clutch.spec.name for clutch in clutches), list[ComparedClutch](), []
    for clutch, basis in entries:
        name, variant = clutch.spec.name, translate(clutch.spec.variant, "value")
        if len(clutches) > 1 and (name is None or often[name] > 1):
            name = clutch.spec.label
        judged, findings = check(clutch)
        row = answer(
            ComparedClutch, clutch, name=name and named(name), variant=clutch.spec.variant, basis=basis,
            **({} if clutch.spec.kind.travels else {"travel_max": None}), errors=judged.errors,
            warnings=judged.warnings, passed=judged.verdict.passed, sentence=judged.verdict.sentence,
            checks=judged.checks,
        )  # fmt: skip
        rows.append(row)
        called = variant if variants else named(name) or variant
        # findings on its law, and errors and warnings of its check
        counted = (remark for remark in findings if remark.level != "info")
        remarks += [(called, remark) for remark in dict.fromkeys((*clutch_findings(clutch), *counted))]
    asked = clutches[0].spec.label.findings if variants else ()
    return CompareResult(clutches=rows), [*asked, *_joined(remarks), *missing]


def _as_variants(clutch: Clutch) -> tuple[list[tuple[Clutch, str | None]], list[Finding]]:
    """Clutches of all variants as which a spec can be built, with what is kept equal; findings on the others."""
    by_force, by_torque, missing = list[Clutch](), list[Clutch](), []
    for variant in VARIANTS:
        own = [clutch, clutch]
        if variant != clutch.spec.variant:
            try:
                spec = candidate(clutch.spec, {"variant": variant})
                equal = {"closing_spring.force": "closing_force", "adjustment.nominal_torque": "nominal_torque"}
                own = [build(with_key(spec, path, clutch[name])) for path, name in equal.items()]
            except SpecError as error:
                lacks = "; ".join(map(str, error.problems))
                missing.append(finding("variant-not-possible", "info", variant=translate(variant), lacks=lacks))
                continue
        by_force.append(own[0])
        by_torque.append(own[1])
    bases = (by_force, deferred("spring force")), (by_torque, deferred("nominal torque"))
    return [(each, basis) for built, basis in bases for each in built], missing


def _joined(remarks: Iterable[tuple[str, Finding]]) -> list[Finding]:
    """Findings of several clutches, each finding once, headed by the names of the clutches that have it."""
    names = dict[object, list[str]]()
    firsts = dict[object, Finding]()
    for name, remark in remarks:
        alike = remark.level, remark.code, remark.path, remark.message  # value and limit may differ by rounding
        firsts.setdefault(alike, remark)
        names.setdefault(alike, []).append(name)
    return [
        replace(remark, message=f"{', '.join(dict.fromkeys(names[alike]))}: {remark.message}")
        for alike, remark in firsts.items()
    ]


def change(now: object, before: object) -> float | None:
    """Return the relative change from ``before`` to ``now``; None if either is not a number, or ``before`` is 0.

    >>> change(3.0, 2.0), change(2, 0.0), change("a", "b")
    (0.5, None, None)
    """
    if not isinstance(now, int | float) or not isinstance(before, int | float) or not before:
        return None
    return (now - before) / abs(before)
