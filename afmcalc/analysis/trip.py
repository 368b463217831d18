"""Overload with a torque margin (S22): potential torque, actuation torque as published and at equilibrium."""

from collections.abc import Sequence

from ..engines import Clutch
from ..errors import CalculationError
from ..findings import Finding, finding
from ..messages import say
from ..result import Answer, Series, Triple, described, quantity
from .asking import Asking, answer, asked, asked_by
from .clutch_findings import clutch_findings
from .registry import ANALYSES
from .sweep import Axis, replaced, series


class OverloadSweep(Asking, Series):
    """Overload over a swept key."""

    accuracy_factor_expected: list[float] = asked(description="T_муф(f_max)/T_min")
    accuracy_factor_actual: list[float] = asked(description="max(T_ср, T_муф)(f_max)/T_min, published T_ср")
    actuation_factor: list[float] = asked("actuation_factor_at_f_max", "T_ср/T_муф at f_max, published", symbol="A")
    expected_torque: list[float] = asked("expected_torque_at_f_max", "expected torque at f_max", symbol="T_муф")
    actuation_torque_published: list[float] = asked(
        "actuation_torque_published_at_f_max", "published actuation torque at f_max", symbol="T_ср"
    )
    actuation_torque_equilibrium: list[float] = asked(
        "actuation_torque_equilibrium_at_f_max", "actuation torque at equilibrium, at f_max", symbol="T_eq"
    )


class OverloadResult(Asking, Answer):
    """Overload of a clutch set at f_min with a margin over the machine's torque."""

    nominal_torque: float = asked(
        "nominal_torque_at_overload",
        "nominal torque of the clutch, set at f_min, as S22 does, whatever adjustment.method says",
        symbol="T_н.муф",
    )
    machine_torque: float = asked(
        "machine_torque_at_overload", "nominal torque of the machine, T_н.муф over the margin", symbol="T_н.маш"
    )
    margin: float = asked()
    potential_torque: Triple = asked()
    potential_torque_bypass_first: Triple | None = asked(optional=True)
    potential_torque_bound: Triple = asked()
    expected_torque: Triple = asked()
    potential_torque_gain: Triple | None = asked(optional=True)
    load_rise: Triple = asked()
    actuation_torque_published: Triple = asked()
    actuation_torque_equilibrium: Triple = asked()
    actuation_factor: Triple = asked()
    friction_interval: list[float] | None = quantity(
        "1", "f (17)", "friction at which T_ср < T_муф, S22 (17), within the range", optional=True
    )
    optimal_reduced_gain: float = asked()
    accuracy_factor_expected: float = asked()
    accuracy_factor_actual: float = asked()
    accuracy_factor_equilibrium: float = asked()
    sweep: list[OverloadSweep] | None = described("overload over the swept values", optional=True)


def overload(clutch: Clutch, sweeps: Sequence[Axis] = ()) -> tuple[OverloadResult, list[Finding]]:
    """Calculate the overload of an all-driving or differentiated clutch of one material.

    Raises CalculationError if S22 does not treat the variant, or unlike materials.
    """
    refuse(clutch)
    spec = clutch.spec
    alike = dict.fromkeys(() if clutch["bypass_pairs"] else ("potential_torque_bypass_first", "potential_torque_gain"))
    # frictions between which the published actuation torque is below the expected torque, S22 (17)
    low = high = 0.0
    if clutch["reduced_gain"] != 0:
        ends = sorted((clutch["friction_at_equal_potential"], clutch["friction_at_unit_loop_gain"]))
        low, high = max(ends[0], clutch["friction_min"]), min(ends[1], clutch["friction_max"])
    result = answer(
        OverloadResult, clutch, **alike, friction_interval=[low, high] if low < high else None,
        sweep=series(OverloadSweep, spec, sweeps, asked_by(OverloadSweep, clutch)),
    )  # fmt: skip
    findings = [*clutch_findings(clutch), finding("published-against-equilibrium", "info")]
    if spec.adjustment.method == "mean-friction":
        findings.append(finding("margin-role", "warning", value=spec.adjustment.margin, path="adjustment.method"))
    return result, [*findings, *replaced(spec, sweeps)]


def refuse(clutch: Clutch) -> None:
    """Raise CalculationError for a variant that S22 does not treat, or for unlike materials."""
    if not ANALYSES["overload"].applies(clutch):
        unlike, variant = clutch.spec.friction.unlike, clutch.spec.variant
        what = say("unlike materials") if unlike else say("variant {variant!r}", variant=variant)
        raise CalculationError(
            "overload: S22 treats all-driving and differentiated clutches of one material, not {what}", what=what
        )
