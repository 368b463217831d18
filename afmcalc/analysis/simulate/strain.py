"""What an event asks of balls, pockets and springs: a sleeve swings farther than the law has it travel."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from ...engines.parts import demands_of
from ...engines.protocol import Clutch
from ...equations import synthesis
from ...findings import Finding, finding
from ...messages import term
from ..registry import ANALYSES
from ..synthesize import synthesize
from ..wall import Wall, wall_of
from .cases import Outcome
from .indirect import IndirectPlant

_ENDS = ("f_min", "f_cp", "f_max")
_ROUNDING = 1e-9


class Strength(NamedTuple):
    """What a control unit bears; None where it is not known, or nothing travels."""

    contact_force: float | None
    """On one ball, N."""
    contact_path: str
    """Key of the spec that this is from."""
    travel: float | None
    """At which a ball touches the edge of its pocket, m."""
    clearance: float
    """y that is to be left, m."""
    wall: Wall | None


def contact_forces(clutch: Clutch, found: Sequence[Outcome]) -> list[float] | None:
    """Largest F_n of every event, N; None without balls whose number and circle are known."""
    unit = clutch.spec.control_unit
    if unit is None or unit.balls is None or unit.ball_circle_radius is None or not clutch.gain:
        return None
    if clutch.spec.kind.travels and let_go(found) is None:
        return None  # feedback that the key just holds is simulated without its balls
    count, radius = unit.balls, unit.ball_circle_radius
    return [float(synthesis.contact_force(each.trip.peak_wall, count, radius, 1.0)) for each in found]


def strength_of(clutch: Clutch) -> Strength:
    """Return what the control unit as synthesized bears."""
    if not ANALYSES["synthesize"].applies(clutch):
        return Strength(None, "", None, 0.0, None)
    found, _ = synthesize(clutch)
    wall = wall_of(clutch, found.face_gap, found.ball_diameter / 2)
    if not clutch.spec.kind.travels or found.ball_diameter_standard is None or not wall.can_be_cut:
        return Strength(found.contact_force_allowable, found.contact_path, None, 0.0, None)
    travel = wall.sleeves * wall.mouth
    return Strength(found.contact_force_allowable, found.contact_path, travel, found.edge_clearance, wall)


def let_go(found: Sequence[Outcome]) -> float | None:
    """Travel at which the closing spring presses no more, m; None without a sleeve."""
    plant = found[-1].case.plant
    return float(plant.sleeve.farthest) if isinstance(plant, IndirectPlant) else None


def strains(clutch: Clutch, found: Sequence[Outcome]) -> Iterator[Finding]:
    """Say where an event asks for more than balls, pockets or the closing spring have."""
    own = strength_of(clutch)
    if (forces := contact_forces(clutch, found)) is not None and own.contact_force is not None:
        force, at = max(zip(forces, _ENDS, strict=True))
        if force > own.contact_force * (1 + 1e-9):
            limit, path = own.contact_force, own.contact_path
            yield finding("event-contact-force", "error", value=force, limit=limit, path=path, at=at)
    travel, at = max((each.trip.travel_max, end) for each, end in zip(found, _ENDS, strict=True))
    if own.travel is not None and own.wall is not None:
        left = own.wall.clearance(travel)
        if travel > own.travel:
            yield finding("event-ball-leaves-pocket", "error", value=travel, limit=own.travel, at=at)
        elif left < own.clearance * (1 - 1e-9):
            path = "control_unit.edge_clearance"
            yield finding(
                "event-clearance", "warning", value=left, limit=own.clearance, path=path, at=at, travel=travel
            )
    yield from _springs(clutch, travel)
    free = let_go(found)
    if free is not None and travel > free * (1 - 1e-9):
        yield finding("event-spring-let-go", "error", value=travel, limit=free, path="closing_spring", at=at)


def _springs(clutch: Clutch, travel: float) -> Iterator[Finding]:
    """What the springs named do not hold where the sleeve swings, and held where the law has it."""
    own, rules = clutch.spec, {}
    if not own.spring_parts or not own.kind.travels:
        return
    for path, each in demands_of(own, clutch.wishes()):
        rules[path, each.rule] = each.beyond > _ROUNDING
    for path, each in demands_of(own, clutch.wishes(travel)):
        if each.beyond > _ROUNDING and not rules.get((path, each.rule)):
            yield finding(
                "event-spring", each.rule.level, value=each.value, limit=each.limit, path=path, travel=travel,
                what=term(each.rule.what),
            )  # fmt: skip
