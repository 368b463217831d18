"""Each effect as two curves of torque, springs as set."""

import math
from collections.abc import Callable, Mapping
from typing import Literal, NamedTuple

from ...engines.protocol import Clutch
from ...equations import effects as law
from ...equations import synthesis
from ...findings import Finding, finding
from ...spec.edit import value_at
from .splines import Shares, closing, opening
from .springs_held import weakened, with_gain

EffectName = Literal["spline-friction", "sliding-cams", "centrifugal", "wear"]

STEEL = 7850.0
"""Density of a ball of bearing steel (ISO 3290-1), kg/m³."""

Torque = Callable[[float, float], float]
"""Slip torque at f_1 and f_2, N·m."""


class Bracket(NamedTuple):
    """Two curves that the torque lies between, none where no clutch is left, and what is to be said of them."""

    curves: tuple[()] | tuple[Torque, Torque]
    found: tuple[Finding, ...] = ()


class EffectSource(NamedTuple):
    """Where an effect comes from: the keys it needs, the first of them its own, and its bracket."""

    needs: tuple[str, ...]
    bracket: Callable[[Clutch], Bracket]
    on_accuracy: str
    """Code of the finding where it moves K_т."""
    on_torque: str
    """Code of the finding where it moves the torque alone."""

    def missing(self, clutch: Clutch) -> list[str]:
        """Keys of the spec that are not given; a clutch of its own stiffness needs no key for it."""
        gone = [path for path in self.needs if value_at(clutch.spec, path) is None]
        return [path for path in gone if path != STIFFNESS or clutch.following_stiffness is None]


STIFFNESS = "closing_spring.stiffness"


def _splines(clutch: Clutch) -> Bracket:
    """Controlled pairs next to the spring (F11 fig. 1), an inner disc behind the first pair."""
    group = clutch.spec.friction_group
    radii = group.inner_spline_radius, group.outer_spline_radius
    own, radius = group.spline_friction, float(clutch.mean_radius)

    def share(friction: float, disc: int) -> float:
        return float(law.spline_share(own, friction, radius, radii[disc % 2]))

    shares: Shares = share
    most = max(shares(each.max, disc) for each in clutch.friction for disc in (0, 1))
    if most >= 1:
        locks = finding("splines-lock", "error", value=most, limit=1.0, path="friction_group.spline_friction")
        return Bracket((), (locks,))
    return Bracket((closing(clutch, shares), opening(clutch, shares)))


def _cams(clutch: Clutch) -> Bracket:
    """Gain with the friction of the wall against the cam driven up, and driven back."""
    unit = clutch.spec.control_unit
    assert unit is not None
    assert unit.ball_circle_radius is not None
    assert unit.wall_friction is not None
    over = synthesis.tan_wall_angle(1.0, unit.ball_circle_radius, float(clutch.mean_radius))
    tangent, path = float(clutch.gain) * over, "control_unit.wall_friction"
    if tangent * unit.wall_friction >= 1:
        stay = finding("cams-stay", "error", value=unit.wall_friction, limit=1 / tangent, path=path)
        return Bracket((), (stay,))
    loading = law.tan_wall_angle_loading(tangent, unit.wall_friction) / over
    unloading = law.tan_wall_angle_unloading(tangent, unit.wall_friction) / over
    least = float(clutch.gain_threshold or 0.0)
    locks = finding("cams-lock", "warning", value=loading, limit=least, path=path)
    curves = with_gain(clutch, loading).torque, with_gain(clutch, unloading).torque
    return Bracket(curves, (locks,) if loading <= least else ())


def _centrifugal(clutch: Clutch) -> Bracket:
    """Conical pockets, as they are and with the force of balls thrown outward."""
    unit, speed = clutch.spec.control_unit, clutch.spec.drive.speed
    assert unit is not None
    assert unit.ball_diameter is not None
    tangent = synthesis.tan_wall_angle(clutch.gain, unit.ball_circle_radius, clutch.mean_radius)
    mass = law.ball_mass(STEEL, unit.ball_diameter / 2, math.pi)
    thrust = float(law.centrifugal_thrust(unit.balls, mass, speed, unit.ball_circle_radius, tangent))
    return _weaker(clutch, thrust, "drive.speed")


def _wear(clutch: Clutch) -> Bracket:
    """The pack new, and with its lining gone."""
    own = clutch.spec.heat
    assert own is not None
    assert own.lining is not None
    return _weaker(clutch, float(clutch.lost_by_wear(own.lining)), "heat.lining")


def _weaker(clutch: Clutch, loss: float, path: str) -> Bracket:
    force = float(clutch.pack_force_at_rest)
    if loss >= force:
        return Bracket((), (finding("force-used-up", "error", value=loss, limit=force, path=path),))
    return Bracket((weakened(clutch, loss).torque, clutch.torque))


SOURCES: Mapping[EffectName, EffectSource] = {
    "spline-friction": EffectSource(
        (
            "friction_group.spline_friction",
            "friction_group.inner_spline_radius",
            "friction_group.outer_spline_radius",
        ),
        _splines,
        "effect-on-accuracy/spline-friction",
        "effect-on-torque/spline-friction",
    ),
    "sliding-cams": EffectSource(
        ("control_unit.wall_friction", "control_unit.ball_circle_radius"),
        _cams,
        "effect-on-accuracy/sliding-cams",
        "effect-on-torque/sliding-cams",
    ),
    "centrifugal": EffectSource(
        ("drive.speed", "control_unit.balls", "control_unit.ball_diameter", "control_unit.ball_circle_radius"),
        _centrifugal,
        "effect-on-accuracy/centrifugal",
        "effect-on-torque/centrifugal",
    ),
    "wear": EffectSource(("heat.lining", STIFFNESS), _wear, "effect-on-accuracy/wear", "effect-on-torque/wear"),
}
"""Effect → where it comes from, in the order they are told."""
