"""Every limit a design is held against, passed or not, with its utilisation."""

from collections.abc import Iterator
from typing import Literal, Protocol

from ...engines.protocol import Clutch
from ...findings import Finding
from ...result import Result, quantity
from ..life import LifeResult
from ..synthesize import SynthesisResult
from .pressure import pressure_findings

Verdict = Literal["pass", "note", "warning", "fail"]
_VERDICTS: dict[str, Verdict] = {"info": "note", "warning": "warning", "error": "fail"}


class Check(Result):
    """One limit."""

    name: str = quantity("", None, "what is checked")
    symbol: str = quantity("", None, "symbols of value and limit")
    unit: str = quantity("", None, "SI unit of both")
    value: float = quantity("", None, "what the design has")
    limit: float = quantity("", None, "what it is held against")
    utilisation: float = quantity("1", "η", "utilisation, 1 at the limit")
    verdict: Verdict = quantity("", None, "pass, or how grave it is")


class _Check(Protocol):
    def __call__(
        self, code: str, name: str, symbol: str, unit: str, value: float, limit: float, *, least: bool = False
    ) -> Check:
        """Hold a value against a limit: the largest allowed, or the ``least``."""


def checks(
    clutch: Clutch, synthesis: SynthesisResult | None, life: LifeResult | None, findings: list[Finding]
) -> list[Check]:
    """Hold a design against every limit that applies to it.

    Args:
        clutch: the clutch.
        synthesis: its control unit, if one was synthesized.
        life: its life, if the spec has a [fatigue] block.
        findings: those of all its analyses; they decide how grave an exceeded limit is.

    Returns:
        The checks, each with its utilisation.
    """
    levels = {finding.code: finding.level for finding in findings}

    def check(
        code: str, name: str, symbol: str, unit: str, value: float, limit: float, *, least: bool = False
    ) -> Check:
        used = limit / value if least else value / limit
        beyond = used > 1 + 1e-9
        verdict: Verdict = _VERDICTS[levels.get(code, "info")] if beyond else "pass"
        return Check(name=name, symbol=symbol, unit=unit, value=value, limit=limit, utilisation=used, verdict=verdict)

    return [
        *_clutch_checks(clutch, check),
        *(_synthesis_checks(synthesis, check) if synthesis else ()),
        *map(_pressure, pressure_findings(clutch)),
        *(_life_checks(life, check) if life else ()),
    ]


def _clutch_checks(clutch: Clutch, check: _Check) -> Iterator[Check]:
    gain, rule, limit = float(clutch.gain), clutch.spec.kind.gain_limit, clutch.gain_limit
    if rule is not None and limit is not None:
        value, bound = rule.stated(gain, clutch.reduced_gain, limit)
        yield check(rule.code, rule.quantity, rule.symbol, "1", float(value), float(bound))
    if clutch.gain_threshold:
        threshold = float(clutch.gain_threshold)
        yield check("feedback-idle", "gain against key friction", "C ≥ 2R f_1/d", "1", gain, threshold, least=True)
    first, second = clutch.friction
    lowest = min(clutch.torque(first.min, second.min), clutch.torque(first.max, second.max))
    nominal = float(clutch.nominal_torque)
    name = "least torque in service"
    yield check("below-nominal-torque", name, "T_min ≥ T_н", "N*m", float(lowest), nominal, least=True)


def _synthesis_checks(found: SynthesisResult, check: _Check) -> Iterator[Check]:
    if found.ball_diameter_standard is not None:
        chosen, needed = found.ball_diameter_standard, 2 * found.ball_radius
        yield check("ball-too-small", "ball diameter", "d_ш ≥ 2 r_ш", "m", chosen, needed, least=True)
    if found.contact_force is not None and found.contact_force_allowable is not None:
        force, allowable = found.contact_force, found.contact_force_allowable
        yield check("contact-force-exceeded", "contact force on one ball", "F_n ≤ [F_n]", "N", force, allowable)


def _life_checks(found: LifeResult, check: _Check) -> Iterator[Check]:
    sides = (("protected", "τ_eq", found.stress_protected), ("unprotected", "τ'_eq", found.stress_unprotected))
    for side, symbol, stress in sides:
        if stress is None:
            continue
        name = f"damaging stress, {side} side (beyond: limited life)"
        yield check("life-limited", name, f"{symbol} ≤ τ_limb", "Pa", stress, found.endurance_limit)


def _pressure(finding: Finding) -> Check:
    assert finding.value is not None
    assert finding.limit is not None
    where = "at the inner edge" if finding.code.startswith("peak") else "in the mean"
    verdict: Verdict = "pass" if finding.level == "info" else _VERDICTS[finding.level]
    return Check(
        name=f"surface pressure {where}", symbol="p ≤ [p]", unit="Pa", value=finding.value, limit=finding.limit,
        utilisation=finding.value / finding.limit, verdict=verdict,
    )  # fmt: skip
