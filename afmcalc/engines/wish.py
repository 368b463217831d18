"""What a clutch wants of its springs."""

from typing import Literal, NamedTuple

from ..spec.models import Spec
from ..spec.springs import ClosingSpring, ControlSpring, Room

SpringName = Literal["closing", "control"]
QUASI_STATIC = 1e4
"""Strokes up to which a spring counts as one that rests (EN 13906-1)."""


class Wish(NamedTuple):
    """What one spring is to give, and what happens to it."""

    name: SpringName
    force: float
    """As set, N."""
    stiffness: float | None
    """N/m; None: any."""
    relaxes: float
    """How much longer it gets in service, m."""
    compresses: float
    """How much shorter, m."""
    follows: int | None
    """Pairs whose wear it follows; None: wear does not reach it."""
    room: Room
    pitch: float | None
    """Of the nut, m."""
    friction: tuple[float, float] | None
    """w_M of the cones of a stack on each other, w_R of its edges."""
    stroke: float | None = None
    """How far it goes and comes at every trip, m; None: it rests, or moves too seldom to count (EN 13906-1)."""
    cycles: float | None = None
    """Trips asked for; None: not told."""


def wishes(spec: Spec, closing_force: float, control_force: float | None, travel: float) -> list[Wish]:
    """What each spring of a clutch is to give.

    Args:
        spec: the clutch.
        closing_force: F_п as set, N.
        control_force: F_п2, N; None where there is no such spring.
        travel: x_max of the sleeve, m.

    The closing spring of a direct clutch follows the wear of the pack; that of an indirect one is slackened by the
    travel of the sleeve, which presses the control spring together, and it is the control spring that follows the wear.
    The first rests; the others move at every trip.
    """
    pairs = spec.friction_group.pairs
    lining = spec.heat.lining if spec.heat is not None else None
    worn = pairs * (lining or 0.0)
    closing, control = spec.closing_spring, spec.control_spring
    if control is None or control_force is None:
        return [_wish("closing", closing, closing_force, worn, 0.0, pairs)]
    cycles = spec.requirements.cycles if spec.requirements is not None else None
    stroke = travel if cycles is None or cycles > QUASI_STATIC else None
    return [
        _wish("closing", closing, closing_force, travel, 0.0, None)._replace(stroke=stroke, cycles=cycles),
        _wish("control", control, control_force, worn, travel, pairs)._replace(stroke=stroke, cycles=cycles),
    ]


def _wish(
    name: SpringName,
    spring: ClosingSpring | ControlSpring,
    force: float,
    relaxes: float,
    compresses: float,
    follows: int | None,
) -> Wish:
    held = spring.surface_friction, spring.edge_friction
    return Wish(
        name=name,
        force=force,
        stiffness=spring.stiffness or None,
        relaxes=relaxes,
        compresses=compresses,
        follows=follows,
        room=spring.room or Room(),
        pitch=spring.thread_pitch,
        friction=None if held[0] is None or held[1] is None else (held[0], held[1]),
    )
