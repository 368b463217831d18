"""Closed inverses by engine, parameter and target: which equation of ``equations.inverse`` answers."""

from collections.abc import Callable
from typing import TypeAlias

from ...engines.direct import DirectClutch
from ...engines.geometry import angle_given
from ...engines.indirect import IndirectClutch
from ...engines.protocol import Clutch
from ...engines.setting import margin
from ...equations import adjustment, inverse
from .targets import TARGETS

Inverse: TypeAlias = Callable[[Clutch, float], float]
"""``(clutch, wanted) → value of the parameter``."""

PROPORTIONAL = ("nominal_torque", "torque_min", "torque_max", "scatter", "travel_max", "closing_force")
"""Targets proportional to the spring force."""


def closed_inverse(clutch: Clutch, name: str, target: str) -> Inverse | None:
    """Return the closed inverse for a parameter and a target; None where only a root search answers."""
    if name == "F" and target in PROPORTIONAL:
        return lambda c, wanted: float(
            adjustment.closing_force(wanted, 1.0, TARGETS[target].value(c) / float(c.closing_force))
        )
    if not clutch.spec.kind.travels:
        return _direct(clutch, name, target)
    return _INDIRECT.get(name) if target == "accuracy_factor" else None


def _direct(clutch: Clutch, name: str, target: str) -> Inverse | None:
    if target == "accuracy_factor":
        unlike = clutch.spec.friction.unlike
        return {"C": _gain, **({} if unlike else {"z": _pairs, "z1": _driving_pairs})}.get(name)
    # with the spring set for a nominal torque, the torques no longer follow the law at fixed force
    if clutch.spec.closing_spring.force is None or target not in ("nominal_torque", "torque_max"):
        return None
    if clutch.spec.friction.unlike and target == "torque_max":
        return None
    at = _at_setting if target == "nominal_torque" else _at_max
    if name == "C":
        return lambda c, wanted: _gain_for_torque(c, wanted, at)
    if name == "z":
        return lambda c, wanted: _pairs_for_torque(c, wanted, at)
    if name == "R" and not angle_given(clutch.spec):
        return lambda c, wanted: _radius_for_torque(c, wanted, at)
    return None


def _gain(clutch: Clutch, wanted: float) -> float:
    assert isinstance(clutch, DirectClutch)
    first, second = clutch.friction
    z1, z2 = clutch.bypass_pairs, clutch.controlled_pairs
    return float(inverse.gain_for_accuracy_factor(z1, z2, wanted, first.min, second.min, first.max, second.max))


def _pairs(clutch: Clutch, wanted: float) -> float:
    own = clutch.friction[0]
    controlled = inverse.controlled_pairs_for_accuracy_factor(clutch.gain, wanted, own.min, own.max)
    return float(clutch.bypass_pairs + controlled)


def _driving_pairs(clutch: Clutch, wanted: float) -> float:
    own = clutch.friction[0]
    controlled = inverse.controlled_pairs_for_accuracy_factor(clutch.gain, wanted, own.min, own.max)
    return float(clutch.spec.friction_group.pairs - controlled)


_Place: TypeAlias = Callable[[Clutch], tuple[float, float, float]]


def _at_setting(clutch: Clutch) -> tuple[float, float, float]:
    """Return f_1, f_2 at the setting and the margin between the torque there and the nominal one."""
    at = "mean" if clutch.spec.adjustment.method == "mean-friction" else "min"
    first, second = clutch.friction
    return getattr(first, at), getattr(second, at), margin(clutch.spec)


def _at_max(clutch: Clutch) -> tuple[float, float, float]:
    first, second = clutch.friction
    return first.max, second.max, 1.0


def _gain_for_torque(clutch: Clutch, wanted: float, at: _Place) -> float:
    assert isinstance(clutch, DirectClutch)
    first, second, factor = at(clutch)
    force, radius, z1, z2 = clutch.closing_force, clutch.mean_radius, clutch.bypass_pairs, clutch.controlled_pairs
    return float(inverse.gain_for_torque(factor * wanted, force, radius, z1, z2, first, second))


def _pairs_for_torque(clutch: Clutch, wanted: float, at: _Place) -> float:
    assert isinstance(clutch, DirectClutch)
    first, second, factor = at(clutch)
    if not clutch.spec.kind.controlled:
        return float(factor * wanted / (clutch.closing_force * clutch.mean_radius * first))
    force, radius, z1 = clutch.closing_force, clutch.mean_radius, clutch.bypass_pairs
    found = inverse.controlled_pairs_for_torque(factor * wanted, force, radius, z1, clutch.gain, first, second)
    return float(z1 + found)


def _radius_for_torque(clutch: Clutch, wanted: float, at: _Place) -> float:
    assert isinstance(clutch, DirectClutch)
    first, second, factor = at(clutch)
    force, z1, z2, gain = clutch.closing_force, clutch.bypass_pairs, clutch.controlled_pairs, clutch.gain
    return float(inverse.mean_radius_for_torque(factor * wanted, force, z1, z2, gain, first, second))


def _indirect_gain(clutch: Clutch, wanted: float) -> float:
    assert isinstance(clutch, IndirectClutch)
    own, c1, c2 = clutch.friction[0], clutch.closing_stiffness, clutch.control_stiffness
    net = inverse.net_gain_for_accuracy_factor(
        own.min, clutch.friction_set, own.max, c1, c2, clutch.pairs, wanted
    )  # fmt: skip
    return float(net + clutch.gain_threshold)


def _indirect_pairs(clutch: Clutch, wanted: float) -> float:
    assert isinstance(clutch, IndirectClutch)
    own, c1, c2 = clutch.friction[0], clutch.closing_stiffness, clutch.control_stiffness
    return float(
        inverse.pairs_for_accuracy_factor_indirect(
            own.min, clutch.friction_set, own.max, c1, c2, clutch.net_gain, wanted
        )
    )


def _ratio(clutch: Clutch, wanted: float) -> float:
    assert isinstance(clutch, IndirectClutch)
    own = clutch.friction[0]
    return float(
        inverse.stiffness_ratio_for_accuracy_factor(
            own.min, clutch.friction_set, own.max, clutch.pairs, clutch.net_gain, wanted
        )
    )


def _closing_stiffness(clutch: Clutch, wanted: float) -> float:
    assert isinstance(clutch, IndirectClutch)
    return float(clutch.control_stiffness) / _ratio(clutch, wanted)


def _control_stiffness(clutch: Clutch, wanted: float) -> float:
    assert isinstance(clutch, IndirectClutch)
    return float(clutch.closing_stiffness) * _ratio(clutch, wanted)


_INDIRECT: dict[str, Inverse] = {
    "C": _indirect_gain,
    "z": _indirect_pairs,
    "c1": _closing_stiffness,
    "c2": _control_stiffness,
}
