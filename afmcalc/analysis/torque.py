"""Torque and forces of the slipping clutch."""

from collections.abc import Callable, Iterable
from typing import Any, TypeVar

from ..engines.protocol import Clutch
from ..engines.quantities import Quantities
from ..engines.selection import Wired
from ..equations import calls, direct, indirect
from ..errors import CalculationError
from ..findings import Finding, finding
from ..result import Answer, Triple, described, quantity
from .asking import Asking, answer, asked
from .clutch_findings import clutch_findings


class FrictionPoint(Asking):
    """The slipping clutch at one chosen friction."""

    friction: float | None = asked(description="coefficient of friction of all pairs", optional=True)
    friction_driving: float | None = asked(optional=True)
    friction_driven: float | None = asked(optional=True)
    torque: float = asked()
    normal_force: float = asked()
    release_force: float = asked()
    travel: float | None = asked(optional=True)
    driving_torque: float | None = asked(optional=True, details=True)
    driven_torque: float | None = asked(optional=True, details=True)
    circumferential_force: float | None = asked(optional=True, details=True)
    key_friction_force: float | None = asked(optional=True, details=True)
    stop_reaction: float | None = asked(optional=True, details=True)
    onset_torque: float | None = asked(optional=True, details=True)


class TorqueExtremes(Asking):
    """Smallest and largest torque along the common path of f_1 and f_2; of a jump, the torque just before it."""

    low: float = asked("torque_min")
    high: float = asked("torque_max")
    at_low: float = asked("friction_of_torque_min")
    at_high: float = asked("friction_of_torque_max")


class TorqueResult(Asking, Answer):
    """Torque, forces and accuracy over the friction range."""

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
    driving_torque: Triple | None = asked(optional=True, details=True)
    driven_torque: Triple | None = asked(optional=True, details=True)
    circumferential_force: Triple | None = asked(optional=True, details=True)
    key_friction_force: Triple | None = asked(optional=True, details=True)
    stop_reaction: Triple | None = asked(optional=True, details=True)
    onset_torque: Triple | None = asked(optional=True, details=True)
    motor_torque: float | None = asked(optional=True)
    torque_asked_for: float | None = asked(optional=True)
    starting_torque: float | None = asked(optional=True)
    torque_range: TorqueExtremes = quantity("", "", "extremes")
    scatter: float = asked()
    accuracy_factor: float = asked(description="accuracy factor T_max/T_min")
    points: list[FrictionPoint] | None = described("at the friction asked for", optional=True)

    def words(self, name: str) -> str | None:
        """Tell people nothing of extremes at the ends of the range: the triple of the torque shows them."""
        path, extremes = self.friction or self.friction_driving, self.torque_range
        shown = path is not None and {extremes.at_low, extremes.at_high} <= {path.min, path.max}
        return "" if name == "torque_range" and shown else None


Pair = tuple[float, float | None]
T = TypeVar("T")


def torque(clutch: Wired, friction: Iterable[Pair] = ()) -> tuple[TorqueResult, list[Finding]]:
    """Calculate torque and forces over the friction range, and at pairs (f, None) or (f_1, f_2) asked for."""
    notes = calls._NOTES.get()
    if notes is not None and notes is not calls._UNNOTED:  # explain and the report read the calls of the old engine
        return traced(clutch, friction)  # type: ignore[arg-type]
    spec, own = clutch.spec, clutch.quantities
    points = pairs_asked(clutch, friction)
    left_out = {"friction": None} if spec.friction.unlike else {"friction_driving": None, "friction_driven": None}
    if not spec.kind.travels:
        left_out["pack_force_at_rest"] = None  # it is the spring's
    result = answer(
        TorqueResult,
        own,
        torque_range=answer(TorqueExtremes, own),
        points=[_point(own, *pair, unlike=spec.friction.unlike) for pair in points] or None,
        **left_out,
    )
    remarks = [remark for pair in points for remark in outside_range(clutch, *pair)]
    return result, [*clutch_findings(spec, own), *remarks]


def _point(clutch: Quantities, friction: float, friction_driven: float | None, *, unlike: bool) -> FrictionPoint:
    if not unlike:
        there = clutch.at(friction=friction)
        return answer(FrictionPoint, there, friction_driving=None, friction_driven=None)
    driven = friction if friction_driven is None else friction_driven
    there = clutch.at(friction_driving=friction, friction_driven=driven)
    return answer(FrictionPoint, there, friction=None)


def pairs_asked(clutch: Wired, friction: Iterable[Pair]) -> list[Pair]:
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


def outside_range(clutch: Wired, friction: float, friction_driven: float | None) -> list[Finding]:
    """Say where a friction asked for lies outside the range of the spec."""
    pair = (friction, friction if friction_driven is None else friction_driven)
    findings = [
        finding(
            "friction-outside-range", "info", value=value, limit=allowed.min if value < allowed.min else allowed.max,
            least=allowed.min, largest=allowed.max,
        )
        for value, allowed in zip(pair, clutch.spec.friction.groups, strict=True)
        if not allowed.min <= value <= allowed.max
    ]  # fmt: skip
    return list(dict.fromkeys(findings))


def traced(clutch: Clutch, friction: Iterable[Pair] = ()) -> tuple[TorqueResult, list[Finding]]:
    """Calculate the same by the old engine, whose equations note their calls, for ``explain`` and the report."""
    points = pairs_asked(clutch, friction)
    sleeve = clutch.sleeve
    names = ("torque", "normal_force", "release_force", *(("travel",) if sleeve else ()))

    def state(*pair: Any) -> dict[str, Any]:
        return {**{name: getattr(clutch, name)(*pair) for name in names}, **shares(clutch, *pair)}

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
