"""Torque by the old engine, whose equations note their calls: for ``explain`` and the report, until they read steps."""

from collections.abc import Iterable
from typing import Any

from ..engines.protocol import Clutch
from ..equations import direct, indirect
from ..findings import Finding
from ..result import Triple
from .torque import (
    FrictionPoint,
    Pair,
    TorqueExtremes,
    TorqueResult,
    friction_fields,
    outside_range,
    pairs_asked,
    triple,
)


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
