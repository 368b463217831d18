"""Clutches side by side: several specs, or all variants one spec can be built as."""

from collections.abc import Sequence
from dataclasses import replace

from ..engines import build
from ..engines.protocol import Clutch
from ..errors import SpecError
from ..findings import Finding, finding
from ..messages import joined, say, term
from ..result import Result, Triple, quantity
from ..spec.edit import as_variant, with_force, with_nominal_torque
from ..variants import VARIANTS
from .torque import scatter, triple


class ComparedClutch(Result):
    """The main quantities of one clutch."""

    name: str | None = quantity("", None, "clutch", optional=True)
    variant: str = quantity("", None, "variant")
    basis: str | None = quantity("", None, "kept equal", optional=True)
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
    warnings: int = quantity("", None, "warnings")


class CompareResult(Result):
    """Clutches side by side."""

    clutches: list[ComparedClutch] = quantity("", None, "clutches compared")


def compare(clutches: Sequence[Clutch]) -> tuple[CompareResult, list[Finding]]:
    """Set the main quantities of several clutches side by side."""
    rows = [_row(clutch, None) for clutch in clutches]
    findings = [
        _named(each, clutch.spec.name or clutch.spec.variant) for clutch in clutches for each in clutch.findings()
    ]
    return CompareResult(clutches=rows), findings


def compare_variants(clutch: Clutch) -> tuple[CompareResult, list[Finding]]:
    """Set all variants that a spec can be built as side by side, at equal spring force and at equal nominal torque."""
    rows, remarks, missing = [], [], []
    for variant in VARIANTS:
        try:
            spec = as_variant(clutch.spec, variant)
            by_force = build(with_force(spec, float(clutch.closing_force)))
            by_torque = build(with_nominal_torque(spec, float(clutch.nominal_torque)))
        except SpecError as error:
            missing.append(_missing(variant, error))
            continue
        rows += [_row(by_force, term("spring force")), _row(by_torque, term("nominal torque"))]
        remarks += [_named(remark, variant) for each in (by_force, by_torque) for remark in each.findings()]
    rows.sort(key=lambda row: row.basis != "spring force")
    return CompareResult(clutches=rows), [*dict.fromkeys(remarks), *missing]


def _named(remark: Finding, name: str) -> Finding:
    """Say which clutch a finding is about."""
    return replace(remark, message=say("{name}: {message}", name=name, message=remark.message))


def _row(clutch: Clutch, basis: str | None) -> ComparedClutch:
    torque = triple(clutch, clutch.torque)
    return ComparedClutch(
        name=clutch.spec.name,
        variant=clutch.spec.variant,
        basis=basis,
        closing_force=clutch.closing_force,
        nominal_torque=clutch.nominal_torque,
        gain=clutch.gain,
        reduced_gain=clutch.reduced_gain,
        torque=torque,
        scatter=scatter(clutch),
        accuracy_factor=clutch.accuracy_factor,
        accuracy_factor_peak=clutch.accuracy_factor_peak,
        gain_limit=clutch.gain_limit,
        travel_max=clutch.travel(clutch.friction[0].max),
        warnings=sum(each.level != "info" for each in clutch.findings()),
    )


def _missing(variant: str, error: SpecError) -> Finding:
    lacks = joined(map(str, error.problems), "; ")
    return finding("variant-not-possible", "info", variant=term(variant), lacks=lacks)
