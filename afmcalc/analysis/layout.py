"""The clutch in half section: whether its parts fit into the space there is, its mass and inertia."""

from collections.abc import Iterator
from typing import Any

from ..engines.layout import (
    TOUCHES,
    Box,
    Half,
    PartName,
    SectionPart,
    inertia_of,
    length_of,
    overlaps,
    parts_of,
    sizes_of,
)
from ..engines.protocol import Clutch
from ..errors import Problem, SpecError
from ..findings import Finding, finding
from ..messages import say, term
from ..result import Answer, Result, described, quantity


class LayoutPart(Result):
    """One part: the space it takes in half section, its mass and inertia."""

    part: PartName = described("part of the clutch")
    left: float = quantity("m", "x_1", "left end, from the web of the housing on")
    right: float = quantity("m", "x_2", "right end")
    inner_diameter: float = quantity("m", "D_i", "inner diameter")
    outer_diameter: float = quantity("m", "D_e", "outer diameter")
    mass: float = quantity("kg", "m", "mass")
    inertia: float = quantity("kg*m^2", "J", "moment of inertia")


class LayoutResult(Answer):
    """The clutch in half section, as the papers draw it."""

    length: float = quantity("m", "L", "length along the axis, without clearances, bearings and bolts")
    outer_diameter: float = quantity("m", "D_h", "outer diameter of the housing")
    mass: float = quantity("kg", "m", "mass, all parts of steel")
    driving_inertia: float = quantity("kg*m^2", "J_k", "inertia of the driving half: housing and outer discs")
    hub_inertia: float | None = quantity(
        "kg*m^2",
        "J_h",
        "inertia between the discs and the balls: inner discs, pressure disc and its sleeve",
        optional=True,
    )
    driven_inertia: float = quantity("kg*m^2", "J_2", "inertia of the driven half")
    parts: list[LayoutPart] = described("parts")


def layout(clutch: Clutch) -> tuple[LayoutResult, list[Finding]]:
    """Lay out a clutch.

    Raises:
        SpecError: the spec has no envelope.
    """
    if clutch.spec.envelope is None:
        problem = Problem("envelope", None, say("required by layout: the space there is, and what is how thick"))
        raise SpecError(clutch.spec.label, [problem])
    parts = parts_of(sizes_of(clutch))
    halves: tuple[Half, ...] = ("driving", "hub", "driven")
    driving, hub, driven = (float(inertia_of(parts, half)) for half in halves)
    result = LayoutResult(
        length=length_of(parts),
        outer_diameter=_around(parts[0]).outer * 2,
        mass=sum(body.mass for part in parts for body in part.bodies),
        driving_inertia=driving,
        hub_inertia=hub if clutch.sleeve else None,
        driven_inertia=driven,
        parts=[_row(part) for part in parts if _is_there(part)],
    )
    return result, [*clutch.findings(), *_findings(clutch, result, parts)]


def _extends(box: Box) -> bool:
    return bool(box.right > box.left and box.outer > box.inner)


def _is_there(part: SectionPart) -> bool:
    return any(map(_extends, part.boxes))


def _around(part: SectionPart) -> Box:
    """The smallest ring that holds all of a part."""
    left, right, inner, outer = zip(*filter(_extends, part.boxes), strict=True)
    return Box(min(left), max(right), min(inner), max(outer))


def _row(part: SectionPart) -> LayoutPart:
    around = _around(part)
    return LayoutPart(
        part=part.name,
        left=around.left,
        right=around.right,
        inner_diameter=2 * around.inner,
        outer_diameter=2 * around.outer,
        mass=sum(body.mass for body in part.bodies),
        inertia=sum(body.inertia for body in part.bodies),
    )


def _findings(clutch: Clutch, result: LayoutResult, parts: list[SectionPart]) -> Iterator[Finding]:
    """Say what is in the way of what, what is beyond the space, and what is not in the layout."""
    for first, second, missing in overlaps(parts):
        if missing > TOUCHES:
            yield finding("parts-collide", "error", value=float(missing), first=term(first), second=term(second))
    for code, path, value, limit in space_limits(clutch, result):
        if value > limit + TOUCHES:
            yield finding(code, "error", value=value, limit=limit, path=path, missing=value - limit)
    names = {row.part for row in result.parts}
    sought = {"closing spring": "closing_spring.disc"}
    if clutch.spec.kind.travels:
        sought["control spring"] = "control_spring.disc"
    if clutch.spec.control_unit is not None and clutch.gain > 0:
        sought["balls"] = "control_unit.ball_diameter"
    for name, path in sought.items():
        if name not in names:
            yield finding("layout-without", "info", path=path, name=term(name))


def space_limits(clutch: Clutch, result: LayoutResult) -> Iterator[tuple[str, str, float, float]]:
    """Yield each limit of the space that is given: code of the finding beyond it, key, value and limit, m."""
    room: Any = clutch.spec.envelope
    for code, name, value in (
        ("housing-too-wide", "outer_diameter", result.outer_diameter),
        ("clutch-too-long", "length", result.length),
    ):
        if (limit := getattr(room, name)) is not None:
            yield code, f"envelope.{name}", value, limit
