"""Torque and forces of the slipping clutch."""

from collections.abc import Callable, Iterable
from typing import Any, TypeVar

from ..engines.protocol import Clutch
from ..equations import direct, indirect
from ..errors import CalculationError
from ..findings import Finding, finding
from ..result import Answer, Result, Triple, described, quantity


def _detail(unit: str, symbol: str, description: str) -> Any:
    return quantity(unit, symbol, description, optional=True, details=True)


_T_1 = _detail("N*m", "T_1", "torque of the bypass pairs")
_T_2 = _detail("N*m", "T_2", "torque of the controlled pairs, which passes the balls")
_F_O = _detail("N", "F_o", "circumferential force on all the balls")
_F_KEY = _detail("N", "F_тр", "friction force of the key on the sleeve")
_S = _detail("N", "S", "reaction of the stop on the sleeve")
_ONSET = _detail("N*m", "T_1(0)", "torque that the bypass pairs carry alone, before the balls take a share")


class FrictionPoint(Result):
    """The slipping clutch at one chosen friction."""

    friction: float | None = quantity("1", "f", "coefficient of friction of all pairs", optional=True)
    friction_driving: float | None = quantity("1", "f_1", "friction of the driving pairs", optional=True)
    friction_driven: float | None = quantity("1", "f_2", "friction of the driven pairs", optional=True)
    torque: float = quantity("N*m", "T", "slip torque")
    normal_force: float = quantity("N", "N", "normal force on the pairs")
    release_force: float = quantity("N", "F_p", "release force")
    travel: float | None = quantity("m", "x", "axial travel of the sleeve", optional=True)
    driving_torque: float | None = _T_1
    driven_torque: float | None = _T_2
    circumferential_force: float | None = _F_O
    key_friction_force: float | None = _F_KEY
    stop_reaction: float | None = _S
    onset_torque: float | None = _ONSET


class TorqueExtremes(Result):
    """Smallest and largest torque along the common path of f_1 and f_2; of a jump, the torque just before it."""

    low: float = quantity("N*m", "T_min", "smallest slip torque")
    high: float = quantity("N*m", "T_max", "largest slip torque")
    at_low: float = quantity("1", "f(T_min)", "friction (f_1) where it is smallest")
    at_high: float = quantity("1", "f(T_max)", "friction (f_1) where it is largest")


class TorqueResult(Answer):
    """Torque, forces and accuracy over the friction range."""

    nominal_torque: float = quantity("N*m", "T_н", "nominal torque of the clutch")
    machine_torque: float = quantity("N*m", "T_н.маш", "nominal torque of the machine")
    closing_force: float = quantity("N", "F_п", "closing-spring force as set")
    control_force: float | None = quantity("N", "F_п2", "control-spring force as set", optional=True)
    pack_force_at_rest: float | None = quantity("N", "N(0)", "force on the pack of the clutch at rest", optional=True)
    gain: float = quantity("1", "C", "feedback gain")
    gain_slope: float | None = quantity("1/m", "C_1", "how the gain grows with the sleeve's travel", optional=True)
    reduced_gain: float = quantity("1", "z_2 C", "reduced gain")
    friction: Triple | None = quantity("1", "f", "coefficient of friction", optional=True)
    friction_driving: Triple | None = quantity("1", "f_1", "friction of the driving pairs", optional=True)
    friction_driven: Triple | None = quantity("1", "f_2", "friction of the driven pairs", optional=True)
    torque: Triple = quantity("N*m", "T", "slip torque (sustained)")
    normal_force: Triple = quantity("N", "N", "normal force on the pairs")
    release_force: Triple = quantity("N", "F_p", "release force")
    travel: Triple | None = quantity("m", "x", "axial travel of the sleeve", optional=True)
    torque_returning: Triple | None = quantity(
        "N*m", "T_ret", "slip torque, friction falling again from f_max under load", optional=True
    )
    driving_torque: Triple | None = _T_1
    driven_torque: Triple | None = _T_2
    circumferential_force: Triple | None = _F_O
    key_friction_force: Triple | None = _F_KEY
    stop_reaction: Triple | None = _S
    onset_torque: Triple | None = _ONSET
    motor_torque: float | None = quantity("N*m", "M_н", "rated torque of the motor, P_н/ω_н", optional=True)
    torque_asked_for: float | None = quantity("N*m", "T_маш", "torque that the machine asks for", optional=True)
    starting_torque: float | None = quantity(
        "N*m", "T_пуск", "largest torque at the clutch at a direct start", optional=True
    )
    torque_range: TorqueExtremes = quantity("", "", "extremes")
    scatter: float = quantity("N*m", "ΔT", "torque scatter band")
    accuracy_factor: float = quantity("1", "K_т", "accuracy factor T_max/T_min")
    points: list[FrictionPoint] | None = described("at the friction asked for", optional=True)

    def words(self, name: str) -> str | None:
        """Tell people nothing of extremes at the ends of the range: the triple of the torque shows them."""
        path, extremes = self.friction or self.friction_driving, self.torque_range
        shown = path is not None and {extremes.at_low, extremes.at_high} <= {path.min, path.max}
        return "" if name == "torque_range" and shown else None


Pair = tuple[float, float | None]
T = TypeVar("T")


def torque(clutch: Clutch, friction: Iterable[Pair] = ()) -> tuple[TorqueResult, list[Finding]]:
    """Calculate torque and forces over the friction range, and at pairs (f, None) or (f_1, f_2) asked for."""
    points = pairs_asked(clutch, friction)
    sleeve = clutch.sleeve
    asked = ("torque", "normal_force", "release_force", *(("travel",) if sleeve else ()))

    def state(*pair: Any) -> dict[str, Any]:
        return {**{name: getattr(clutch, name)(*pair) for name in asked}, **shares(clutch, *pair)}

    plate = clutch.spec.machine
    of_plate = {} if plate is None else {
        "motor_torque": plate.motor_torque, "torque_asked_for": plate.torque, "starting_torque": plate.starting_torque,
    }  # fmt: skip
    # before all else: a report numbers the formulas in the order in which they run
    states = [state(*pair) for pair in zip(*clutch.friction, strict=True)]
    result = TorqueResult(
        nominal_torque=clutch.nominal_torque,
        machine_torque=clutch.machine_torque,
        closing_force=clutch.closing_force,
        gain=clutch.gain,
        gain_slope=None if sleeve is None else sleeve.gain_slope or None,
        reduced_gain=clutch.reduced_gain,
        **friction_fields(clutch, *map(Triple.of, clutch.friction)),
        **{name: Triple.of([state[name] for state in states]) for name in states[0]},
        control_force=sleeve and sleeve.control_force,
        pack_force_at_rest=sleeve and sleeve.pack_force_at_rest,
        torque_returning=sleeve and triple(clutch, lambda friction, _: sleeve.torque_returning(friction)),
        **of_plate,
        torque_range=TorqueExtremes(**clutch.torque_range._asdict()),
        scatter=clutch.scatter,
        accuracy_factor=clutch.accuracy_factor,
        points=[FrictionPoint(**friction_fields(clutch, *pair), **state(*pair)) for pair in points] or None,
    )
    return result, [*clutch.findings(), *(remark for pair in points for remark in outside_range(clutch, *pair))]


def shares(clutch: Clutch, friction: float, friction_driven: float | None) -> dict[str, Any]:
    """Return what each group, the balls, the key and the stop bear of a slip, as far as the clutch has them.

    F11: a torque too small for the balls is carried by the bypass pairs, pressed by the whole spring; only when it has
    grown beyond that do the balls climb their walls, and the controlled pairs take their share.
    """
    result: dict[str, Any] = {}
    force, sleeve, unit = clutch.normal_force(friction, friction_driven), clutch.sleeve, clutch.spec.control_unit
    if clutch.bypass_pairs:
        bypass = clutch.mean_radius, clutch.bypass_pairs, friction
        result["driving_torque"] = direct.driving_torque(force, *bypass)
        if unit is not None:
            result["onset_torque"] = direct.onset_torque(clutch.closing_force, *bypass)
    if unit is not None:
        result["driven_torque"] = torque = clutch.ball_torque(friction, friction_driven)
        if unit.ball_circle_radius is not None:
            result["circumferential_force"] = direct.circumferential_force(torque, unit.ball_circle_radius)
        if sleeve is not None:
            key = sleeve.key_friction, sleeve.hub_diameter
            result["key_friction_force"] = indirect.key_friction_force(torque, *key)
            result["stop_reaction"] = sleeve.stop_reaction(friction)
    return result


def pairs_asked(clutch: Clutch, friction: Iterable[Pair]) -> list[Pair]:
    """Return the frictions asked for.

    Raises:
        CalculationError: two of a clutch that has one.
    """
    points = list(friction)
    if not clutch.spec.friction.unlike and any(pair[1] is not None for pair in points):
        raise CalculationError(
            "--friction F1,F2 is for unlike materials; this clutch has one friction (a decimal point, no comma)"
        )
    return points


def triple(clutch: Clutch, function: Callable[..., Any]) -> Triple:
    """Evaluate ``function(f_1, f_2)`` at the smallest, mean and largest friction."""
    return Triple.of([function(*frictions) for frictions in zip(*clutch.friction, strict=True)])


def friction_fields(clutch: Clutch, friction: T, friction_driven: T | None) -> dict[str, T]:
    """Return frictions as result fields: ``friction``, or one per group with unlike materials."""
    if not clutch.spec.friction.unlike:
        return {"friction": friction}
    return {"friction_driving": friction, "friction_driven": friction if friction_driven is None else friction_driven}


def outside_range(clutch: Clutch, friction: float, friction_driven: float | None) -> list[Finding]:
    """Say where a friction asked for lies outside the range of the spec."""
    asked = (friction, friction if friction_driven is None else friction_driven)
    findings = [
        finding(
            "friction-outside-range", "info", value=value, limit=allowed.min if value < allowed.min else allowed.max,
            least=allowed.min, largest=allowed.max,
        )
        for value, allowed in zip(asked, clutch.friction, strict=True)
        if not allowed.min <= value <= allowed.max
    ]  # fmt: skip
    return list(dict.fromkeys(findings))
