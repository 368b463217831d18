"""Section through a ball and its two pockets (A–A of the papers), to scale, with the synthesized ball."""

import math
from collections.abc import Iterator
from typing import NamedTuple

from ...analysis.plot_data import PocketSection
from ...analysis.synthesize import SynthesisResult
from ...messages import localized, say, translate
from ..drawing import (
    TEXT,
    WIDTH,
    Angle,
    Circle,
    Drawing,
    Inscription,
    Length,
    Point,
    Region,
    Shape,
    Stroke,
    leader,
    tenths,
)
from ..units import display
from .chart import Sheet, stated

_MM = 1e3
_HATCH = {-1: 45.0, 1: 135.0}
_HIGH = 210.0
"""Largest height on paper, mm."""


def pocket(section: PocketSection) -> Sheet:
    """Draw the ball at the stop and, where the sleeve travels, at its largest travel."""
    return Sheet(translate("Ball and pockets, section A–A"), [_drawing(section)], _caption(section), section.name)


def _drawing(section: PocketSection) -> Drawing:
    """Lay out the positions one below the other, to one scale."""
    synthesis, titles = section.synthesis, [(0.0, "")]
    if travel := synthesis.travel_max:
        moved = say("at f_max, {stated}", stated=stated("x_max", travel, "m"))
        titles = [(0.0, translate("at the stop, x = 0")), (travel, moved)]
    positions = [Position(synthesis, each) for each, _ in titles]
    back, top = positions[0].back, max(each.top for each in positions)
    beside, between = 26 * TEXT, 11 * TEXT
    unit = max(2 * back / (WIDTH - beside), 2 * top / (_HIGH / len(titles) - between))
    size, high, right = TEXT * unit, 2 * top + between * unit, WIDTH / 2 * unit
    shapes = list[Shape]()
    for number, (position, (_, title)) in enumerate(zip(positions, titles, strict=True)):
        down = number * high
        shapes += position.shapes(size, down)
        if title:
            shapes.append(Inscription(title, (0.5 * size - right, top + 4 * size - down), size))
    return Drawing(shapes, (-right, high - top - 5.5 * size - len(titles) * high, right, top + 5.5 * size))


def _caption(section: PocketSection) -> str:
    synthesis = section.synthesis
    sentences = [
        say(
            "To scale, dimensions in mm. Cylindrical section at the ball circle ({circle}), axis of clutch horizontal, "
            "dots: contact. S21 (20), (23), (24): smallest ball {smallest}.",
            circle=stated("r", synthesis.ball_circle_radius, "m"), smallest=stated("r_ш", synthesis.ball_radius, "m"),
        ),
        _ball(synthesis),
        translate(
            "Cut to h_c, where the ball ends; h_1 is to the virtual apex of the walls. The groove under the ball is "
            "left out here: drawings for the shop (.dxf, .svg) have it."
        ),
    ]  # fmt: skip
    if synthesis.contact_force is not None:
        sentences.append(say("On one ball {force}.", force=stated("F_n", synthesis.contact_force, "N")))
    if synthesis.web is not None and synthesis.web > 0:
        sentences.append(say("The web between pockets is {web}.", web=stated("e", synthesis.web, "m")))
    elif synthesis.web is not None:
        sentences.append(say("{pockets} pockets cut into each other.", pockets=section.balls))
    if synthesis.wall_angle_max is not None and synthesis.wall is None:
        sentences.append(
            translate("The ball undercuts the curved wall, which cannot be cut: straight walls are drawn.")
        )
    elif synthesis.wall_angle_max is not None:
        angle = synthesis.wall_angle_max
        sentences.append(say("Curved wall: at the largest travel α = {angle:.4g deg}.", angle=angle))
    return " ".join(sentences)


def _ball(synthesis: SynthesisResult) -> str:
    ball = stated("d_ш", synthesis.ball_diameter, "m")
    if synthesis.ball_diameter_standard is None:
        return say("Drawn with {ball}, for no standard ball is that large.", ball=ball)
    if synthesis.edge_clearance_standard is None:
        return say("Drawn with {ball}.", ball=ball)
    clearance = stated("y", synthesis.edge_clearance_standard, "m")
    return say("Drawn with {ball}, which leaves {clearance} to the edge.", ball=ball, clearance=clearance)


class _Side(NamedTuple):
    """One sleeve where it is, mm."""

    hand: int
    """-1 of the left one, 1 of the right one."""
    face: float
    """Off the ball's centre."""
    middle: float
    """Of its pocket."""
    wall: tuple[Point, ...]
    """Its upper wall: depth below the face, distance from the middle."""
    angle: float
    """Where the ball touches."""
    seats: bool
    """True if both walls touch it."""


class Position:
    """One position of the sleeve, mm."""

    def __init__(self, synthesis: SynthesisResult, travel: float) -> None:
        """Lay out the section with the sleeve at its stop, or at its largest travel (m)."""
        self.synthesis, self.travel = synthesis, travel * _MM
        self.radius, self.depth = synthesis.ball_diameter / 2 * _MM, synthesis.pocket_depth * _MM
        sleeves = 2 if synthesis.wall_angle_max is None else 1  # that the ball moves in: 1 where the other seats it
        gap, cut, angle = synthesis.face_gap / 2 * _MM, synthesis.pocket_depth_cut * _MM, synthesis.wall_angle
        tangent, steepest = math.tan(angle), synthesis.wall_angle_max or angle
        # a sleeve that the ball moves in turns until its walls bear on the ball again
        turned = synthesis.travel_max * _MM / sleeves * (tangent + math.tan(steepest)) / 2
        # from the face to where the ball touches at the stop
        curved = [
            (-(_MM * place.wall_axial + gap), _MM * place.wall_around) for place in reversed(synthesis.wall or ())
        ]

        def side(hand: int, *, moves: bool) -> _Side:
            wall = (*(moves and curved or [(0.0, self.depth * tangent)]), (cut, (self.depth - cut) * tangent))
            if moves and travel:
                return _Side(hand, gap + self.travel / sleeves, turned, wall, steepest, seats=False)
            return _Side(hand, gap, 0.0, wall, angle, seats=True)

        self.sides = self.left, self.right = side(-1, moves=sleeves == 2), side(1, moves=True)
        # the same extent for every position, so that they are drawn to one scale
        reach = gap + synthesis.travel_max * _MM / sleeves + self.depth
        self.back, self.top = 1.18 * reach, 1.12 * (synthesis.pocket_width / 2 * _MM + turned) + 0.12 * reach

    def shapes(self, size: float, down: float = 0.0) -> Iterator[Shape]:
        """Yield what is drawn with texts of a size, its middle ``down`` below the origin."""
        for side in self.sides:
            yield from self._sleeve(side, down)
        yield Circle("balls", (0.0, -down), self.radius)
        axis = (-self.left.face - self.depth, -down), (self.right.face + self.depth, -down)
        yield Stroke("centre", axis)
        yield Stroke("centre", ((0.0, -1.18 * self.radius - down), (0.0, 1.18 * self.radius - down)))
        yield from self._dimensions(size, down)

    def _sleeve(self, side: _Side, down: float) -> Iterator[Shape]:
        """Yield one half: the face with its pocket, the walls to their apex, where the ball touches."""
        hand, middle = side.hand, side.hand * side.middle - down
        face, back = hand * side.face, hand * self.back
        upper = [(face + hand * depth, half) for depth, half in side.wall]
        wall = [(x, middle + y) for x, y in (*upper, *((x, -half) for x, half in reversed(upper)))]
        top, low = self.top - down, -self.top - down
        outline = (back, top), (face, top), *wall, (face, low), (back, low)
        yield Region("hatch", (outline,), hatch=_HATCH[hand])
        yield Stroke("outline", outline)
        (floor, half), apex = upper[-1], face + hand * self.depth
        yield Stroke("assumed", ((floor, middle + half), (apex, middle), (floor, middle - half)))
        along, across = hand * self.radius * math.sin(side.angle), hand * self.radius * math.cos(side.angle)
        # at rest and in a seat both walls of a pocket touch the ball, under way one
        for y in (-across, across) if side.seats else (-across,):
            yield Circle("contact", (along, y - down), 0.04 * self.radius)

    def _dimensions(self, size: float, down: float) -> Iterator[Shape]:
        left, right, cut = self.left, self.right, self.synthesis.pocket_depth_cut * _MM
        face, top = right.face, self.top - down
        corner = face + cut, right.middle + right.wall[-1][1] - down
        yield Length(f"h_c = {_tenths(cut)}", size, (face, top), corner, top + size)
        text = f"h_1 = {_tenths(self.depth)}"
        low = -self.top - down
        yield Length(text, size, (face, low), (face + self.depth, right.middle - down), low - 1.7 * size)
        gap = left.face + face
        text = f"s + x = {_tenths(gap)}" if self.travel else f"s = {display(gap / _MM, 'm')}"
        yield Length(text, size, (-left.face, low), (face, low), low - 3.7 * size)
        # width of the right pocket's mouth, beside the section
        half, middle = self.synthesis.pocket_width / 2 * _MM, right.middle - down
        ends = (face, middle - half), (face, middle + half)
        yield Length(f"b = {_tenths(2 * half)}", size, *ends, self.back + 2 * size, upright=True)
        reach = self.radius * math.sqrt(0.5)
        diameter = say("ball d_ш = {diameter}", diameter=display(2 * self.radius / _MM, "m"))
        yield from leader(diameter, (-reach, reach - down), (-self.back / 2, top + size), size)
        # the wall angle at the apex of the left pocket, between wall and axis
        angle = self.synthesis.wall_angle
        x, y = apex = -left.face - self.depth, -left.middle - down
        wall = x + self.depth, y + self.depth * math.tan(angle)
        text = f"α = {localized(f'{math.degrees(angle):.4g}')}°"
        yield Stroke("dimensions", (apex, (x + 0.6 * self.depth, y)))
        yield Angle("", size, apex, (x + self.depth, y), wall, 0.45 * self.depth)
        turn = angle / 2
        tip = x + 0.45 * self.depth * math.cos(turn), y + 0.45 * self.depth * math.sin(turn)
        yield from leader(text, tip, (-self.back - 1.5 * size, tip[1] + 1.5 * size), size)


def _tenths(length: float) -> str:
    return tenths(length / _MM)
