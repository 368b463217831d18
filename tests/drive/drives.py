"""Drives to simulate: the reference drive of the theory, and bare ones for closed forms."""

from dataclasses import replace
from typing import Any

from afmcalc.drive.pack import DirectPack, Sleeve
from afmcalc.drive.plant import Plant
from afmcalc.drive.train import Engine, Train
from afmcalc.drive.trip import Trip, trip
from afmcalc.engines import Clutch, build
from afmcalc.engines.quantities import Quantities
from afmcalc.engines.selection import laws_for

REFERENCE: dict[str, Any] = {
    "variant": "differentiated",
    "friction": {"min": 0.1, "mean": 0.3, "max": 0.8, "static_ratio": 1.2, "stribeck_speed": 0.3},
    "friction_group": {"pairs": 8, "mean_radius": 0.1},
    "control_unit": {"gain": 1.25},
    "adjustment": {"nominal_torque": 200.0, "margin": 4 / 3},
    "drive": {
        "speed": 15.0, "motor_inertia": 8.0, "driven_inertia": 0.05, "shaft_stiffness": 8000.0, "damping_ratio": 0.03,
        "load_torque": 150.0, "motor_torque": 150.0, "event": {"kind": "stop", "stop_time": 0.01},
    },
}  # fmt: skip
"""Reference drive of theory-drive.md, section 9."""

VARIANTS: dict[str, dict[str, Any]] = {
    "conventional": {"variant": "conventional", "control_unit": None},
    "differentiated": {},
    "all-driving": {"variant": "all-driving", "control_unit": {"gain": 0.625}},
}


def merged(data: dict[str, Any], changes: dict[str, Any]) -> dict[str, Any]:
    """A spec with some keys changed, None taking them out."""
    found = dict(data)
    for key, value in changes.items():
        if value is None:
            found.pop(key, None)
        elif isinstance(value, dict) and isinstance(found.get(key), dict):
            found[key] = merged(found[key], value)
        else:
            found[key] = value
    return found


def clutch(**changes: Any) -> Clutch:
    """The reference drive with changes."""
    return build(merged(REFERENCE, changes))


def light(**changes: Any) -> Clutch:
    """The reference drive with a small motor, which is soon at rest, with changes."""
    return build(merged(merged(REFERENCE, {"drive": {"motor_inertia": 0.2}}), changes))


TRAIN = Train(
    motor_inertia=8.0, hub_inertia=0.0, driven_inertia=0.05, tool_inertia=0.0, stiffness=8000.0, damping=0.0, speed=15.0,
    load=150.0, engine=Engine(150.0, None, 0.0), kind="stop", time=0.02, overload=150.0, cut_off=None,
)  # fmt: skip


def plant(sliding: float, *, pack: dict[str, Any] | None = None, **changes: Any) -> Plant:
    """An ordinary clutch that slides at a torque (one pair, R = 0.1 m, f = 0.5), in a drive with changes."""
    own = DirectPack(sliding / 0.05, 0.1, 1.0, 0.0, 0.0, 0.5, 0.5)
    return Plant(replace(TRAIN, **changes), replace(own, **(pack or {})))


class Begun(Plant):
    """A drive that begins in a state of its own."""

    state: tuple[float, ...]

    def start(self) -> list[float]:
        return list(self.state)


def begun(own: Plant, *state: float) -> Begun:
    """The same drive, begun elsewhere: v, ω_2, φ of the shaft, ω_3, of an indirect clutch w and φ of the balls, and N."""
    found = Begun(own.train, own.pack)
    at_stop = () if own.pack.travels else (0.0, 0.0)
    object.__setattr__(found, "state", (*state[:-1], *at_stop, state[-1]))
    return found


def run(own: Plant, horizon: float, *, recorded: bool = False) -> Trip:
    """Simulate; the energy must close, whatever is asked."""
    found = trip(own, horizon, recorded=recorded)
    assert found.residual < 1e-6
    return found


P5 = {
    "closing_force": 2500.0,
    "mean_radius": 0.1,
    "pairs": 8,
    "gain": 1.0,
    "closing_stiffness": 2e4,
    "control_stiffness": 1e4,
    "key_friction": 0.15,
    "hub_diameter": 0.05,
    "friction_set": 0.1,
}
"""Data of P5: κ 0.4, κ₊ 1.6, springs 20 and 10 N/mm."""


def springs(**changes: Any) -> Quantities:
    """The clutch of P5 with other values of some quantities, None taking them out."""
    given = {name: value for name, value in (P5 | changes).items() if value is not None}
    return Quantities(laws_for("indirect", "min-friction", frozenset(given.keys() - P5.keys())), given)


SLEEVE = Sleeve(springs(), friction=0.3)
"""With T_н = 200 N·m at f 0.1: F_п2 3300 N."""


def indirect(friction: float = 0.3, *, law: dict[str, Any] | None = None, mass: float = 0.0, **changes: Any) -> Plant:  # fmt: skip
    """An indirect clutch (P5) in a drive with changes."""
    own = replace(SLEEVE, law=springs(**(law or {})), friction=friction, mass=mass)
    return Plant(replace(TRAIN, hub_inertia=0.02, **changes), own)
