"""Layout of the clutch in half section: collisions, overall size, mass and inertia."""

from collections.abc import Iterator

from ..engines import Clutch
from ..engines.checks import failures_of
from ..engines.rings import TOUCHES, PartName, SectionPart, inertia_of, length_of, overlaps, parts_of, sizes_of
from ..findings import Finding, finding
from ..messages import say, translate
from ..result import Answer, Result, described, quantity
from .clutch_findings import clutch_findings


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
        "kg*m^2", "J_h", "inertia between the discs and the balls: inner discs, pressure disc and its sleeve",
        optional=True,
    )  # fmt: skip
    driven_inertia: float = quantity("kg*m^2", "J_2", "inertia of the driven half")
    parts: list[LayoutPart] = described("parts")


def layout(clutch: Clutch) -> tuple[LayoutResult, list[Finding]]:
    """Lay out a clutch. Raises SpecError if the spec has no [envelope]."""
    if clutch.spec.envelope is None:
        message = say("required by layout: a table of the space there is and of thicknesses, as in example:envelope")
        raise clutch.spec.refused("envelope", message)
    parts = parts_of(sizes_of(clutch))
    result = LayoutResult(
        length=length_of(parts), outer_diameter=2 * parts[0].boxes[0].outer,
        mass=sum(body.mass for part in parts for body in part.bodies), driving_inertia=inertia_of(parts, "driving"),
        hub_inertia=inertia_of(parts, "hub") if clutch.spec.kind.travels else None,
        driven_inertia=inertia_of(parts, "driven"), parts=[*rows_of(parts)],
    )  # fmt: skip
    return result, [*clutch_findings(clutch), *_findings(clutch, result, parts)]


def rows_of(parts: list[SectionPart]) -> Iterator[LayoutPart]:
    """Yield a row for each part that takes up space."""
    for part in parts:
        if rings := [ring for ring in part.boxes if ring.extends]:
            yield LayoutPart(
                part=part.name, left=min(ring.left for ring in rings), right=max(ring.right for ring in rings),
                inner_diameter=2 * min(ring.inner for ring in rings),
                outer_diameter=2 * max(ring.outer for ring in rings), mass=sum(body.mass for body in part.bodies),
                inertia=sum(body.inertia for body in part.bodies),
            )  # fmt: skip


def _findings(clutch: Clutch, result: LayoutResult, parts: list[SectionPart]) -> Iterator[Finding]:
    """Yield findings on collisions, impossible balls, an odd number of pairs, exceeded space, and parts left out."""
    for first, second, missing in overlaps(parts):
        if missing > TOUCHES:
            yield finding(
                "parts-collide", "error", value=float(missing), first=translate(first), second=translate(second)
            )
    yield from (each for each in failures_of(clutch.spec, clutch, "pocket") if each.code in _IMPOSSIBLE_BALLS)
    if clutch.spec.control_unit is not None and (play := clutch["wear_play"]):
        yield finding("laid-out-worn", "info", value=play, path="heat.lining")
    if clutch.spec.friction_group.pairs % 2:
        yield finding("odd-pairs", "warning", value=clutch.spec.friction_group.pairs, path="friction_group.pairs")
    known = {"outer_diameter": result.outer_diameter, "length": result.length}
    yield from failures_of(clutch.spec, known, "layout")
    absent = {part.name for part in parts} - {row.part for row in result.parts}
    for name, path in _SOUGHT.items():
        if name in absent and (name != "balls" or (clutch.spec.control_unit is not None and clutch.gain > 0)):
            yield finding("layout-without", "info", path=path, name=translate(name))


_IMPOSSIBLE_BALLS = ("balls-overlap", "ball-reaches-axis")
_SOUGHT: dict[PartName, str] = {
    "closing spring": "closing_spring.disc", "control spring": "control_spring.disc",
    "balls": "control_unit.ball_diameter",
}  # fmt: skip
