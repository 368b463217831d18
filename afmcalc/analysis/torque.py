"""Torque and forces of the slipping clutch."""

from collections.abc import Iterable
from typing import ClassVar

from pydantic import ConfigDict, SerializeAsAny

from ..engines import Clutch
from ..errors import CalculationError
from ..findings import Finding, finding
from ..result import Answer, Triple, described, quantity
from .asking import Asking, answer, asked
from .clutch_findings import clutch_findings


class FrictionPoint(Asking):
    """The slipping clutch at one chosen friction."""

    model_config = ConfigDict(json_schema_extra={"additionalProperties": True})
    details_of: ClassVar[str] = "torque"

    friction: float | None = asked(description="coefficient of friction of all pairs", optional=True)
    friction_driving: float | None = asked(optional=True)
    friction_driven: float | None = asked(optional=True)
    torque: float = asked()
    normal_force: float = asked()
    release_force: float = asked()
    travel: float | None = asked(optional=True)
    onset_torque: float | None = asked(optional=True, details=True)


class TorqueExtremes(Asking):
    """Smallest and largest torque along the common path of f_1 and f_2; of a jump, the torque just before it."""

    low: float = asked("torque_min")
    high: float = asked("torque_max")
    at_low: float = asked("friction_of_torque_min")
    at_high: float = asked("friction_of_torque_max")


class TorqueResult(Asking, Answer):
    """Torque, forces and accuracy over the friction range."""

    details_of: ClassVar[str] = "torque"
    details_are: ClassVar[type] = Triple

    nominal_torque: float = asked()
    machine_torque: float = asked()
    closing_force: float = asked()
    control_force: float | None = asked(optional=True)
    pack_force_at_rest: float | None = asked(optional=True)
    gain: float = asked()
    gain_slope: float | None = asked(optional=True)
    reduced_gain: float = asked()
    friction: Triple | None = asked(optional=True)
    friction_driving: Triple | None = asked(optional=True)
    friction_driven: Triple | None = asked(optional=True)
    torque: Triple = asked(description="slip torque (sustained)")
    normal_force: Triple = asked()
    release_force: Triple = asked()
    travel: Triple | None = asked(optional=True)
    torque_returning: Triple | None = asked(optional=True)
    onset_torque: Triple | None = asked(optional=True, details=True)
    motor_torque: float | None = asked(optional=True)
    torque_asked_for: float | None = asked(optional=True)
    starting_torque: float | None = asked(optional=True)
    running_torque: float = asked(description="rated torque at the clutch")
    trip_ratio_min: float = asked()
    trip_ratio_max: float = asked()
    torque_range: TorqueExtremes = quantity("", "", "extremes")
    scatter: float = asked()
    accuracy_factor: float = asked(description="accuracy factor T_max/T_min")
    points: list[SerializeAsAny[FrictionPoint]] | None = described("at the friction asked for", optional=True)

    def words(self, name: str) -> str | None:
        """Empty text, which hides extremes at the ends of the range (the torque row shows these); else None."""
        path, extremes = self.friction or self.friction_driving, self.torque_range
        shown = path is not None and {extremes.at_low, extremes.at_high} <= {path.min, path.max}
        return "" if name == "torque_range" and shown else None


Pair = tuple[float, float | None]


def torque(clutch: Clutch, friction: Iterable[Pair] = ()) -> tuple[TorqueResult, list[Finding]]:
    """Calculate torque and forces over the friction range, and at the given frictions (f, None) or (f_1, f_2)."""
    spec = clutch.spec
    points = pairs_asked(clutch, friction)
    absent = {"friction": None} if spec.friction.unlike else {"friction_driving": None, "friction_driven": None}
    at_rest = {} if spec.kind.travels else {"pack_force_at_rest": None}  # it equals the closing force
    result = answer(
        TorqueResult, clutch, torque_range=answer(TorqueExtremes, clutch), **absent, **at_rest,
        points=[answer(FrictionPoint, clutch.at_friction(*pair), **absent) for pair in points] or None,
    )  # fmt: skip
    remarks = [remark for pair in points for remark in outside_range(clutch, *pair)]
    return result, [*clutch_findings(clutch), *remarks]


def pairs_asked(clutch: Clutch, friction: Iterable[Pair]) -> list[tuple[float, float]]:
    """Return the given frictions as (f_1, f_2); raises CalculationError if a clutch of one material gets two."""
    points = list(friction)
    if not clutch.spec.friction.unlike and any(pair[1] is not None for pair in points):
        raise CalculationError(
            "--friction F1,F2 is for unlike materials; this clutch has one friction (a decimal point, no comma)"
        )
    return [(first, first if second is None else second) for first, second in points]


def friction_fields(clutch: Clutch, first: float, second: float) -> dict[str, float]:
    """Return frictions as result fields: ``friction`` or, with unlike materials, a field for each group of pairs."""
    return (
        {"friction_driving": first, "friction_driven": second} if clutch.spec.friction.unlike else {"friction": first}
    )


def outside_range(clutch: Clutch, *pair: float) -> list[Finding]:
    """Findings on a given friction that lies outside the friction range of the spec."""
    findings = [
        finding(
            "friction-outside-range", "info", value=value, limit=allowed.min if value < allowed.min else allowed.max,
            least=allowed.min, largest=allowed.max,
        )
        for value, allowed in zip(pair, clutch.spec.friction.groups, strict=True)
        if not allowed.min <= value <= allowed.max
    ]  # fmt: skip
    return list(dict.fromkeys(findings))
