"""The clutch at one friction as the drive meets it: its discs, or discs, sleeve and balls; numbers, or arrays."""

from dataclasses import replace
from typing import cast

import numpy as np

from ..arrays import Values, is_array
from ..engines import setting
from ..engines.direct_law import DirectLaw
from ..engines.laws import IndirectLaw
from ..engines.protocol import Clutch
from ..equations import adjustment
from ..errors import CalculationError
from ..messages import say
from .direct import DirectPack, DirectPlant
from .indirect import IndirectPlant
from .plant import Plant
from .sleeve import Sleeve
from .train import Train


def pack_of(clutch: Clutch, driving: Values, driven: Values) -> DirectPack | Sleeve:
    """Return the clutch at one friction.

    Raises:
        CalculationError: a sleeve that would be off its stop without load.
    """
    own = clutch.law
    if isinstance(own, DirectLaw):
        return _discs(clutch, own, clutch.closing_force, driving, driven)
    if not is_array(own.net_gain) and not own.net_gain:
        # feedback that the key just holds: an ordinary clutch
        ordinary = DirectLaw(own.mean_radius, own.pairs, 0.0, 0.0)
        return _discs(clutch, ordinary, clutch.closing_force, driving, driven)
    return _sleeve(clutch, own, driving)


def ordinary_pack(clutch: Clutch, driving: Values, driven: Values) -> DirectPack:
    """Return the same discs without control unit, set for the same nominal torque."""
    bypass = clutch.bypass_pairs
    own = DirectLaw(clutch.mean_radius, bypass, clutch.spec.friction_group.pairs - bypass, 0.0)
    per_force = own.torque_per_force(*setting.friction_at_setting(clutch.spec))
    force = adjustment.closing_force(clutch.nominal_torque, setting.margin(clutch.spec), per_force)
    return replace(_discs(clutch, own, force, driving, driven), lag=0.0)


def plant_of(train: Train, pack: DirectPack | Sleeve) -> Plant:
    """Put a clutch into its drive."""
    if isinstance(pack, Sleeve):
        return IndirectPlant(train, pack)
    return DirectPlant(without_hub(train) if train.hub_inertia else train, pack)


def without_hub(train: Train) -> Train:
    """Without control unit the hub belongs to the driven half."""
    return replace(train, driven_inertia=train.driven_inertia + train.hub_inertia, hub_inertia=0.0)


def _discs(clutch: Clutch, own: DirectLaw, force: Values, driving: Values, driven: Values) -> DirectPack:
    unit = clutch.spec.control_unit
    ratio, decay = _static(clutch)
    return DirectPack(
        closing_force=cast(float, force),
        mean_radius=cast(float, own.mean_radius),
        bypass_pairs=cast(float, own.bypass_pairs),
        controlled_pairs=cast(float, own.controlled_pairs),
        gain=cast(float, own.gain),
        driving=cast(float, driving),
        driven=cast(float, driven),
        static_ratio=ratio,
        decay_rate=decay,
        lag=0.0 if unit is None or unit.release_lag is None else unit.release_lag,
        lever=_lever(clutch),
    )


def _sleeve(clutch: Clutch, own: IndirectLaw, friction: Values) -> Sleeve:
    unit, control = clutch.spec.control_unit, own.control_force(clutch.closing_force)
    below = np.asarray(control < clutch.closing_force)
    if below.any():
        raise CalculationError(
            say(
                "simulate: the control spring ({control:.5g N}) must press more than the closing spring "
                "({closing:.5g N}), else the sleeve is off its stop without load",
                control=np.broadcast_to(control, below.shape)[below].flat[0],
                closing=np.broadcast_to(clutch.closing_force, below.shape)[below].flat[0],
            )
        )
    ratio, decay = _static(clutch)
    return Sleeve(
        law=own,
        closing_force=cast(float, clutch.closing_force),
        friction=cast(float, friction),
        mass=0.0 if unit is None or unit.sleeve_mass is None else unit.sleeve_mass,
        static_ratio=ratio,
        decay_rate=decay,
        lever=_lever(clutch),
    )


def _lever(clutch: Clutch) -> float:
    """r/R; 0 where the circle of the balls is not known."""
    unit = clutch.spec.control_unit
    if unit is None or unit.ball_circle_radius is None:
        return 0.0
    return unit.ball_circle_radius / cast(float, clutch.mean_radius)


def _static(clutch: Clutch) -> tuple[float, float]:
    """Static over sliding friction, and R/v_s by which it decays with the slip."""
    friction, radius = clutch.spec.friction, cast(float, clutch.mean_radius)
    ratio = 1.0 if friction.static_ratio is None else friction.static_ratio
    return ratio, 0.0 if friction.stribeck_speed is None else radius / friction.stribeck_speed
