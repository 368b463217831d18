"""Clutches side by side: several specs, or all variants one spec can be built as."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from typing import ClassVar

from ..engines import build
from ..engines.protocol import Clutch
from ..errors import AfmcalcError, SpecError
from ..findings import Finding, finding
from ..messages import joined, say, term
from ..result import Answer, Result, Sentence, Triple, described, quantity
from ..spec import Spec
from ..spec.edit import as_variant, with_key, with_nominal_torque
from ..variants import VARIANTS
from .check import found_unsimulated
from .torque import triple


class ComparedClutch(Result):
    """The main quantities of one clutch; it is called by its file where names are equal."""

    name: Sentence | None = described("clutch", optional=True)
    variant: str = described("variant")
    basis: Sentence | None = described("kept equal", optional=True)
    closing_force: float = quantity("N", "F_п", "closing-spring force as set")
    nominal_torque: float = quantity("N*m", "T_н", "nominal torque of the clutch")
    gain: float = quantity("1", "C", "feedback gain")
    reduced_gain: float = quantity("1", "z_2 C", "reduced gain")
    torque: Triple = quantity("N*m", "T", "slip torque")
    scatter: float = quantity("N*m", "ΔT", "torque scatter band")
    accuracy_factor: float = quantity("1", "K_т", "accuracy factor")
    accuracy_factor_peak: float = quantity("1", "K_т,p", "accuracy factor by breakaway peaks")
    gain_limit: float | None = quantity("1", "C_max", "gain limit", optional=True)
    travel_max: float | None = quantity("m", "x_max", "largest travel of the sleeve", optional=True)
    warnings: int = described("warnings of check, nothing simulated")
    errors: int = described("errors of check, nothing simulated")


class CompareResult(Answer):
    """Clutches side by side."""

    of_several: ClassVar[bool] = True
    clutches: list[ComparedClutch] = described("clutches compared", across=True, by="basis")


def compare(clutches: Sequence[Clutch], *, variants: bool = False) -> tuple[CompareResult, list[Finding]]:
    """Set the main quantities of several clutches side by side, or one clutch as every variant.

    Raises:
        AfmcalcError: the variants of several clutches.
    """
    if variants:
        if len(clutches) > 1:
            raise AfmcalcError("compare --variants takes one SPEC")
        return compare_variants(clutches[0])
    names = _names([clutch.spec for clutch in clutches])
    rows, remarks = [], []
    for clutch, name in zip(clutches, names, strict=True):
        judged = found_unsimulated(clutch)
        rows.append(_row(clutch, None, name, judged))
        remarks += _remarks_of(clutch, name or clutch.spec.variant, judged)
    return CompareResult(clutches=rows), remarks


def compare_variants(clutch: Clutch) -> tuple[CompareResult, list[Finding]]:
    """Set all variants that a spec can be built as side by side, at equal spring force and at equal nominal torque."""
    rows, remarks, missing = [], [], []
    for variant in VARIANTS:
        try:
            by_force, by_torque = _as_variant(clutch, variant)
        except SpecError as error:
            missing.append(_missing(variant, error))
            continue
        by_name = term("spring force"), term("nominal torque")
        for built, basis in zip((by_force, by_torque), by_name, strict=True):
            judged = found_unsimulated(built)
            rows.append(_row(built, basis, clutch.spec.name, judged))
            remarks += _remarks_of(built, variant, judged)
    rows.sort(key=lambda row: row.basis != "spring force")
    asked = list(clutch.spec.label.findings)
    return CompareResult(clutches=rows), [*asked, *dict.fromkeys(remarks), *missing]


def _as_variant(clutch: Clutch, variant: str) -> tuple[Clutch, Clutch]:
    """A clutch as another variant of equal spring force, and of equal nominal torque; itself as its own variant."""
    if variant == clutch.spec.variant:
        return clutch, clutch
    spec = as_variant(clutch.spec, variant)
    by_torque = build(with_nominal_torque(spec, float(clutch.nominal_torque)))
    return build(with_key(spec, "closing_spring.force", float(clutch.closing_force))), by_torque


def _names(specs: Sequence[Spec]) -> list[str | None]:
    """Names of several clutches; of those without one, or with the same, where each was read from."""
    often = Counter(spec.name for spec in specs)
    return [
        spec.name if len(specs) == 1 or (spec.name is not None and often[spec.name] == 1) else spec.label
        for spec in specs
    ]


def _remarks_of(clutch: Clutch, name: str, judged: Sequence[Finding]) -> list[Finding]:
    """What a clutch itself tells, and what else is counted, each with its name."""
    counted = (each for each in judged if each.level != "info")
    return [_named(each, name) for each in dict.fromkeys((*clutch.findings(), *counted))]


def _named(remark: Finding, name: str) -> Finding:
    """Say which clutch a finding is about."""
    return replace(remark, message=say("{name}: {message}", name=term(name, "name"), message=remark.message))


def _row(clutch: Clutch, basis: str | None, name: str | None, judged: Sequence[Finding]) -> ComparedClutch:
    torque = triple(clutch, clutch.torque)
    return ComparedClutch(
        name=name and term(name, "name"),
        variant=clutch.spec.variant,
        basis=basis,
        closing_force=clutch.closing_force,
        nominal_torque=clutch.nominal_torque,
        gain=clutch.gain,
        reduced_gain=clutch.reduced_gain,
        torque=torque,
        scatter=clutch.scatter,
        accuracy_factor=clutch.accuracy_factor,
        accuracy_factor_peak=clutch.accuracy_factor_peak,
        gain_limit=clutch.gain_limit,
        travel_max=clutch.sleeve and clutch.sleeve.travel_max,
        errors=sum(each.level == "error" for each in judged),
        warnings=sum(each.level == "warning" for each in judged),
    )


def _missing(variant: str, error: SpecError) -> Finding:
    lacks = joined(map(str, error.problems), "; ")
    return finding("variant-not-possible", "info", variant=term(variant), lacks=lacks)
