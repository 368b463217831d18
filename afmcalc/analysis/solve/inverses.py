"""Closed inverses by engine, parameter and target: which equation of ``equations.synthesis`` answers."""

from collections.abc import Callable
from typing import TypeAlias

from ...arrays import Values
from ...engines.direct import DirectClutch
from ...engines.geometry import angle_given
from ...engines.indirect import IndirectClutch
from ...engines.protocol import Clutch
from ...engines.setting import friction_at_setting, margin
from ...equations import adjustment, synthesis
from .targets import TARGETS

Inverse: TypeAlias = Callable[[float], float]
"""Value wanted → value of the parameter."""

PROPORTIONAL = ("nominal_torque", "torque_min", "torque_max", "scatter", "travel_max", "closing_force")
"""Targets proportional to the spring force."""
AT_SETTING = ("nominal_torque", "closing_force")
"""Those that are so with any pocket: the sleeve is at its stop."""


def closed_inverse(clutch: Clutch, name: str, target: str) -> Inverse | None:
    """Return the closed inverse for a parameter and a target; None where only a root search answers."""
    straight = not clutch.gain_slope
    if name == "F" and target in (PROPORTIONAL if straight or _follows(clutch) else AT_SETTING):
        per_force = float(TARGETS[target].value(clutch)) / float(clutch.closing_force)
        return lambda wanted: float(adjustment.closing_force(wanted, 1.0, per_force))
    inverses: dict[str, Inverse] = {}
    if isinstance(clutch, DirectClutch):
        inverses = _for_accuracy(clutch) if target == "accuracy_factor" else _for_torque(clutch, target)
    elif isinstance(clutch, IndirectClutch) and straight and target == "accuracy_factor":
        inverses = _for_indirect_accuracy(clutch)
    return inverses.get(name)


def _follows(clutch: Clutch) -> bool:
    """Whether the slope of the gain goes with the force as the travel does: pockets that hold the torque."""
    unit = clutch.spec.control_unit
    return unit is not None and unit.pocket is not None


def _for_accuracy(clutch: DirectClutch) -> dict[str, Inverse]:
    first, second = clutch.friction
    z1, z2 = clutch.bypass_pairs, clutch.controlled_pairs

    def gain(wanted: float) -> float:
        return float(synthesis.gain_for_accuracy_factor(z1, z2, wanted, first.min, second.min, first.max, second.max))

    def controlled(wanted: float) -> float:
        return float(synthesis.controlled_pairs_for_accuracy_factor(clutch.gain, wanted, first.min, first.max))

    if clutch.spec.friction.unlike:
        return {"C": gain}
    return {
        "C": gain,
        "z": lambda wanted: float(z1) + controlled(wanted),
        "z1": lambda wanted: float(z1 + z2) - controlled(wanted),
    }


def _for_torque(clutch: DirectClutch, target: str) -> dict[str, Inverse]:
    spec = clutch.spec
    # with the spring set for a nominal torque, the torques no longer follow the law at fixed force
    if spec.closing_spring.force is None:
        return {}
    if target == "nominal_torque":
        (first, second), factor = friction_at_setting(spec), margin(spec)
    elif target == "torque_max" and not spec.friction.unlike:
        first = second = clutch.friction[0].max
        factor = 1.0
    else:
        return {}
    force, radius, gain = clutch.closing_force, clutch.mean_radius, clutch.gain
    z1, z2 = clutch.bypass_pairs, clutch.controlled_pairs
    # pairs that are added are controlled ones; without a control unit they carry like bypass pairs
    kept = z1 if z2 else 0
    inverses: dict[str, Inverse] = {
        "C": lambda wanted: float(synthesis.gain_for_torque(factor * wanted, force, radius, z1, z2, first, second)),
        "z": lambda wanted: float(
            kept + synthesis.controlled_pairs_for_torque(factor * wanted, force, radius, kept, gain, first, second)
        ),
    }
    if not angle_given(spec):
        inverses["R"] = lambda wanted: float(
            synthesis.mean_radius_for_torque(factor * wanted, force, z1, z2, gain, first, second)
        )
    return inverses


def _for_indirect_accuracy(clutch: IndirectClutch) -> dict[str, Inverse]:
    own, at_set = clutch.friction[0], clutch.friction_set
    c1, c2, pairs, net = clutch.closing_stiffness, clutch.control_stiffness, clutch.pairs, clutch.net_gain

    def gain(wanted: float) -> float:
        found = synthesis.net_gain_for_accuracy_factor(own.min, at_set, own.max, c1, c2, pairs, wanted)
        return float(found + clutch.gain_threshold)

    def count(wanted: float) -> float:
        return float(synthesis.pairs_for_accuracy_factor_indirect(own.min, at_set, own.max, c1, c2, net, wanted))

    def ratio(wanted: float) -> Values:
        found: Values = synthesis.stiffness_ratio_for_accuracy_factor(own.min, at_set, own.max, pairs, net, wanted)
        return found

    return {
        "C": gain,
        "z": count,
        "c1": lambda wanted: float(c2 / ratio(wanted)),
        "c2": lambda wanted: float(c1 * ratio(wanted)),
    }
