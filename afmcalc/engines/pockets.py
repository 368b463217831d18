"""The gain of an indirect clutch as its pockets have it: how it grows along the wall, and the least there must be."""

import math

from ..arrays import Values, chosen, is_array
from ..errors import Problem, SpecError
from ..messages import say
from ..spec.models import Spec
from . import geometry
from .laws import IndirectLaw


def gain_slope(spec: Spec, law: IndirectLaw, closing_force: Values) -> Values:
    """C_1 as given, or that which holds the torque."""
    unit = spec.control_unit
    assert unit is not None
    if unit.pocket == "constant-torque":
        leaving, friction_max = law.leaving_friction(closing_force), spec.friction.groups[0].max
        if not is_array(leaving) and not leaving > 0:
            message = say(
                "no wall holds the torque: control_spring.force does not exceed the force of the closing spring, so "
                "that the sleeve never rests at its stop"
            )
            raise SpecError(spec.label, [Problem("control_unit.pocket", repr(unit.pocket), message)])
        return chosen(leaving > 0, lambda: law.constant_torque_slope(closing_force, friction_max), lambda: math.nan)
    return 0.0 if unit.gain_slope is None else unit.gain_slope


def refuse_negative_net_gain(spec: Spec, law: IndirectLaw) -> None:
    """Below the threshold the sleeve leaves its stop at zero torque: no clutch at all."""
    net = law.net_gain
    if not _where_least(net, net) < 0:
        return
    threshold, gain = (_where_least(net, each) for each in (law.gain_threshold, law.gain))
    message = say(
        "must be at least 2 R f_1/d = {threshold:.6g}: below that the friction at the key exceeds the release "
        "force, and the sleeve leaves its stop at zero torque",
        threshold=threshold,
    )
    path = geometry.gain_path(spec)
    given = f"{gain:.6g}" if path == "control_unit.gain" else f"(C = {gain:.6g})"
    raise SpecError(spec.label, [Problem(path, given, message)])


def _where_least(value: Values, other: Values) -> float:
    """Where the first is least, the other, so that numbers named together belong together."""
    if not is_array(value):
        return float(other)
    import numpy as np

    return float(np.broadcast_to(other, np.shape(value)).flat[int(np.argmin(value))])
