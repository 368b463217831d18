"""Drives to simulate: the reference drive of the theory, and bare ones for closed forms."""

from dataclasses import replace
from typing import Any

from sources import CLUTCHES

from afmcalc.drive.cases import Case
from afmcalc.drive.integrator import Event, step_of, stepped
from afmcalc.drive.motion import Motion
from afmcalc.drive.pack_and_sleeve import DirectPack, Sleeve
from afmcalc.drive.train import Engine, Train
from afmcalc.engines import Clutch, build
from afmcalc.engines.quantities import Quantities
from afmcalc.engines.selection import laws_for

REFERENCE, P5 = CLUTCHES["reference"], CLUTCHES["p5"]

VARIANTS: dict[str, dict[str, Any]] = {
    "conventional": {"variant": "conventional", "control_unit": None},
    "differentiated": {},
    "all-driving": {"variant": "all-driving", "control_unit": {"gain": 0.625}},
}


def merged(data: dict[str, Any], changes: dict[str, Any]) -> dict[str, Any]:
    """A spec with some keys changed; None removes a key."""
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


def case(sliding: float, *, pack: dict[str, Any] | None = None, **changes: Any) -> Case:
    """An ordinary clutch that slides at a torque (one pair, R = 0.1 m, f = 0.5), in a drive with changes."""
    own = DirectPack(sliding / 0.05, 0.1, 1.0, 0.0, 0.0, 0.5, 0.5)
    return Case(replace(TRAIN, **changes), replace(own, **(pack or {})), None)


def run(own: Case, end: float, *, finer: float = 1.0, full: bool = True, **state: float) -> Event:
    """Simulate from a given state, in steps ``finer`` times as fine as usual; assert that the energy balance closes."""
    motion = Motion(own.train, own.pack, float(step_of(own.train, own.pack)) / finer)
    vars(motion).update(state)
    motion.motor = motion.before = motion.driven + motion.rate + motion.slip
    motion.twisting = motion.driven - motion.tool
    motion.torque = motion.elastic + own.train.damping * motion.twisting
    found = stepped(motion, end, full=full)
    assert found.residual < 1e-3
    return found._replace(rows=found.rows.item())


def springs(**changes: Any) -> Quantities:
    """The clutch of P5 with other values of some quantities; None removes a quantity."""
    given = {name: value for name, value in (P5 | changes).items() if value is not None}
    return Quantities(laws_for("indirect", "min-friction", frozenset(given.keys() - P5.keys())), given)


SLEEVE = Sleeve(springs(), friction=0.3)
"""Sleeve of P5, set to T_н = 200 N·m at f = 0.1, so F_п2 = 3300 N."""


def indirect(friction: float = 0.3, *, law: dict[str, Any] | None = None, mass: float = 0.0, **changes: Any) -> Case:
    """An indirect clutch (P5) in a drive with changes."""
    own = replace(SLEEVE, law=springs(**(law or {})), friction=friction, mass=mass)
    return Case(replace(TRAIN, hub_inertia=0.02, **changes), own, None)
