"""What a clutch wants of its springs."""

from typing import Literal, NamedTuple

from ...engines.protocol import Clutch
from ...spec.springs import ClosingSpring, ControlSpring, Room

SpringName = Literal["closing", "control"]


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


def wishes(clutch: Clutch) -> list[Wish]:
    """What each spring of a clutch is to give.

    The closing spring of a direct clutch follows the wear of the pack; that of an indirect one is slackened by the
    travel of the sleeve, which presses the control spring together, and it is the control spring that follows the wear.
    """
    spec, pairs = clutch.spec, clutch.spec.friction_group.pairs
    lining = spec.heat.lining if spec.heat is not None else None
    worn = pairs * (lining or 0.0)
    closing, control = spec.closing_spring, spec.control_spring
    if control is None or clutch.control_force is None:
        return [_wish("closing", closing, float(clutch.closing_force), worn, 0.0, pairs)]
    travel = float(clutch.travel(clutch.friction[0].max) or 0.0)
    return [
        _wish("closing", closing, float(clutch.closing_force), travel, 0.0, None),
        _wish("control", control, float(clutch.control_force), worn, travel, pairs),
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
