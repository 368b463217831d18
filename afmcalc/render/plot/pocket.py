"""Section through a ball and its two pockets (A–A of the papers), to scale in mm, with the synthesized ball."""

import math
from typing import Any, NamedTuple

from ...analysis.figures import PocketSection
from ...analysis.unit import SynthesisResult
from ...messages import localized, told, translate
from ..symbols import mathtext
from ..units import display
from .chart import Sheet, stated
from .paint import COLOURS, INK, WIDTH

_MM = 1e3
_HATCH = ("///", "\\\\\\")


class _Sizes(NamedTuple):
    """What the section shows, mm and radians."""

    radius: float
    angle: float
    gap: float
    depth: float
    """To the virtual apex."""
    cut: float
    width: float
    travel: float
    angle_max: float
    """At the largest travel."""
    sleeves: int
    """That the ball moves in: 1 where the other seats it."""
    curve: tuple[tuple[float, float], ...]
    """Of a curved wall, from the face to where the ball touches at the stop: depth, and distance from the middle."""


class _Side(NamedTuple):
    """One sleeve where it is: its face off the ball's centre, its pocket's middle, the upper wall below the face."""

    face: float
    middle: float
    wall: tuple[tuple[float, float], ...]
    angle: float
    """Where the ball touches."""
    seats: bool
    """Whether both walls touch it."""


def pocket(section: PocketSection) -> Sheet:
    """Draw the ball at the stop and, where the sleeve travels, at its largest travel."""
    found = section.synthesis
    sizes = _Sizes(
        radius=found.ball_diameter / 2 * _MM,
        angle=found.wall_angle,
        gap=found.face_gap * _MM,
        depth=found.pocket_depth * _MM,
        cut=found.pocket_depth_cut * _MM,
        width=found.pocket_width * _MM,
        travel=found.travel_max * _MM,
        angle_max=found.wall_angle if found.wall_angle_max is None else found.wall_angle_max,
        sleeves=1 if found.profiled == "one" else 2,
        curve=tuple(
            (-(each.wall_axial + found.face_gap / 2) * _MM, each.wall_around * _MM)
            for each in reversed(found.wall or [])
        ),
    )
    positions = {
        0.0: translate("at the stop, x = 0"),
        sizes.travel: told("at f_max, {stated}", stated=_stated("x_max", found.travel_max)),
    }
    panels = [Position(sizes, travel, title if sizes.travel else "") for travel, title in positions.items()]
    return Sheet(translate("Ball and pockets, section A–A"), panels, _caption(section), section.name)


def _stated(symbol: str, value: float) -> str:
    return stated(symbol, value, "m")


def _caption(section: PocketSection) -> str:
    found = section.synthesis
    circle, smallest = _stated("r", found.ball_circle_radius), _stated("r_ш", found.ball_radius)
    said = [
        told(
            "To scale, dimensions in mm. Cylindrical section at the ball circle ({circle}), axis of clutch horizontal, "
            "dots: contact. S21 (20), (23), (24): smallest ball {smallest}.",
            circle=circle, smallest=smallest,
        ),
        _ball(found),
        translate("Cut to h_c, where the ball ends; h_1 is to the virtual apex of the walls."),
    ]  # fmt: skip
    if found.contact_force is not None:
        said.append(told("On one ball {force}.", force=stated("F_n", found.contact_force, "N")))
    if found.web is not None and found.web > 0:
        said.append(told("The web between pockets is {web}.", web=_stated("e", found.web)))
    elif found.web is not None:
        said.append(told("{pockets} pockets cut into each other.", pockets=section.balls))
    return " ".join(filter(None, [*said, _of_the_curve(found)]))


def _ball(found: SynthesisResult) -> str:
    ball = _stated("d_ш", found.ball_diameter)
    if found.ball_diameter_standard is None:
        return told("Drawn with {ball}, for no standard ball is that large.", ball=ball)
    if found.edge_clearance_standard is None:
        return told("Drawn with {ball}.", ball=ball)
    clearance = _stated("y", found.edge_clearance_standard)
    return told("Drawn with {ball}, which leaves {clearance} to the edge.", ball=ball, clearance=clearance)


def _of_the_curve(found: SynthesisResult) -> str:
    """What a curved wall adds to the caption."""
    if found.wall_angle_max is None:
        return ""
    if found.wall is None:
        return translate("The ball undercuts the curved wall, which cannot be cut: straight walls are drawn.")
    return told("Curved wall: at the largest travel α = {angle:.4g deg}.", angle=found.wall_angle_max)


class Position:
    """One position of the sleeve."""

    def __init__(self, sizes: _Sizes, travel: float, title: str) -> None:
        """Lay out the section with the sleeve ``travel`` from its stop."""
        self.sizes = sizes
        self.travel = travel
        self.title = title
        self.mouth = sizes.width / 2
        self.sides = {hand: self._placed(hand) for hand in (-1, 1)}
        # the same frame for every position, so that they are drawn to one scale
        reach = sizes.gap / 2 + sizes.travel / sizes.sleeves + sizes.depth
        self.back = 1.18 * reach
        self.side = 1.12 * (self.mouth + self._turned(sizes.travel)) + 0.12 * reach
        self.step = 0.1 * reach

    def _turned(self, travel: float) -> float:
        """How far a sleeve that the ball moves in has turned: its walls bear on the ball again."""
        sizes = self.sizes
        tangents = math.tan(sizes.angle) + math.tan(sizes.angle_max if travel else sizes.angle)
        return travel / sizes.sleeves * tangents / 2

    def _placed(self, hand: int) -> _Side:
        """The sleeve on one side: the ball moves in the right one, and in the left unless that seats it."""
        sizes, moves = self.sizes, hand > 0 or self.sizes.sleeves == 2
        floor = sizes.cut, (sizes.depth - sizes.cut) * math.tan(sizes.angle)
        straight = ((0.0, sizes.depth * math.tan(sizes.angle)), floor)
        wall = (*sizes.curve, floor) if sizes.curve and moves else straight
        if not (self.travel and moves):
            return _Side(sizes.gap / 2, 0.0, wall, sizes.angle, seats=True)
        face = sizes.gap / 2 + self.travel / sizes.sleeves
        return _Side(face, self._turned(self.travel), wall, sizes.angle_max, seats=False)

    @property
    def height(self) -> float:
        """Inches that leave the drawing its scale over the width of the sheet."""
        wide, high = self._extent()
        return min(5.0, (WIDTH - 0.3) * high / wide) + 0.25

    def _extent(self) -> tuple[float, float]:
        return 2 * (self.back + 3.2 * self.step), 2 * self.side + 5.6 * self.step

    def paint(self, axes: Any) -> None:
        """Draw into matplotlib's axes."""
        from matplotlib.patches import Circle, Polygon

        axes.set_axis_off()
        axes.set_aspect("equal")
        wide, high = self._extent()
        axes.set_xlim(-wide / 2, wide / 2)
        axes.set_ylim(self.side + 3.6 * self.step - high, self.side + 3.6 * self.step)
        if self.title:
            axes.set_title(mathtext(self.title), fontsize=9.5)
        for hand, hatch in zip((-1, 1), _HATCH, strict=True):
            axes.add_patch(
                Polygon(self._half(hand), closed=True, facecolor="none", edgecolor=INK, hatch=hatch, linewidth=1.2)
            )
        axes.add_patch(Circle((0, 0), self.sizes.radius, facecolor="none", edgecolor=COLOURS[0], linewidth=2.0))
        for x, y in self._contacts():
            axes.plot([x], [y], marker="o", markersize=5, color=COLOURS[1], zorder=4)
        self._centre_lines(axes)
        self._dimensions(axes)

    def _half(self, hand: int) -> list[tuple[float, float]]:
        """Outline of one half: the face with its pocket, the back cut off."""
        own = self.sides[hand]
        face, middle = hand * own.face, hand * own.middle
        upper = [(hand * (own.face + depth), middle + half) for depth, half in own.wall]
        lower = [(hand * (own.face + depth), middle - half) for depth, half in reversed(own.wall)]
        return [
            (hand * self.back, self.side),
            (face, self.side),
            *upper,
            *lower,
            (face, -self.side),
            (hand * self.back, -self.side),
        ]

    def _contacts(self) -> list[tuple[float, float]]:
        """Where ball and walls touch: at rest and in a seat both walls of a pocket, under way one."""
        found = []
        for hand, own in self.sides.items():
            along = hand * self.sizes.radius * math.sin(own.angle)
            across = hand * self.sizes.radius * math.cos(own.angle)
            found += [(along, -across), *([(along, across)] if own.seats else [])]
        return found

    def _centre_lines(self, axes: Any) -> None:
        style: dict[str, Any] = {"color": INK, "linewidth": 0.7, "linestyle": (0, (10, 3, 2, 3))}
        reach = self.sizes.radius * 1.18
        axes.plot([hand * (own.face + self.sizes.depth) for hand, own in self.sides.items()], [0, 0], **style)
        axes.plot([0, 0], [-reach, reach], **style)
        for hand, own in self.sides.items():
            (cut, half), middle = own.wall[-1], hand * own.middle
            floor, apex = hand * (own.face + cut), hand * (own.face + self.sizes.depth)
            walls = [middle + half, middle, middle - half]
            axes.plot([floor, apex, floor], walls, color=INK, linewidth=0.9, linestyle=(0, (4, 3)))

    def _dimensions(self, axes: Any) -> None:
        sizes, top, right, left = self.sizes, self.side, self.sides[1], self.sides[-1]
        floor, apex, corner = right.face + sizes.cut, right.face + sizes.depth, right.middle + right.wall[-1][1]
        self._measure(axes, right.face, floor, top + self.step, f"h_c = {_mm(sizes.cut)}", corner)
        self._measure(axes, right.face, apex, top + 2.6 * self.step, f"h_1 = {_mm(sizes.depth)}", right.middle)
        gap = "s + x" if self.travel else "s"
        self._measure(axes, -left.face, right.face, -top - self.step, f"{gap} = {_mm(left.face + right.face)}", -top)
        self._mouth(axes)
        self._diameter(axes)
        self._angle(axes)

    def _mouth(self, axes: Any) -> None:
        """Width of the right pocket's mouth, beside the section."""
        own = self.sides[1]
        x, low, high = self.back + self.step, own.middle - self.mouth, own.middle + self.mouth
        for y in (low, high):
            axes.plot([own.face, x + 0.25 * self.step], [y, y], color=INK, linewidth=0.6)
        arrow = {"color": INK, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 7}
        axes.annotate("", (x, low), (x, high), arrowprops={"arrowstyle": "<|-|>", **arrow})
        text = mathtext(f"b = {_mm(self.sizes.width)}")
        axes.text(x + 0.3 * self.step, own.middle, text, ha="left", va="center")

    def _diameter(self, axes: Any) -> None:
        """Leader from the ball to its diameter."""
        reach = self.sizes.radius * math.sqrt(0.5)
        left = self.sides[-1].face
        text = (-left - 0.35 * (left + self.sizes.depth), self.side + self.step)
        axes.annotate(
            mathtext(told("ball d_ш = {diameter}", diameter=_mm(2 * self.sizes.radius))),
            (-reach, reach), xytext=text, ha="right", va="center",
            arrowprops={"arrowstyle": "-|>", "color": INK, "linewidth": 0.8, "shrinkA": 1, "shrinkB": 0},
        )  # fmt: skip

    def _angle(self, axes: Any) -> None:
        """The wall angle at the apex of the left pocket, between wall and axis."""
        from matplotlib.patches import Arc

        own, degrees = self.sides[-1], math.degrees(self.sizes.angle)
        apex = (-own.face - self.sizes.depth, -own.middle)
        size = 0.9 * self.sizes.depth
        axes.plot([apex[0], apex[0] + size * 0.6], [apex[1]] * 2, color=INK, linewidth=0.7)
        axes.add_patch(Arc(apex, size, size, theta1=0, theta2=degrees, color=INK, linewidth=0.9))
        middle = self.sizes.angle / 2
        tip = (apex[0] + size / 2 * math.cos(middle), apex[1] + size / 2 * math.sin(middle))
        text = (-self.back - 0.2 * self.step, tip[1])
        axes.annotate(
            mathtext(f"α = {localized(f'{degrees:.4g}')}°"), tip, xytext=text, ha="right", va="center",
            arrowprops={"arrowstyle": "-", "color": INK, "linewidth": 0.6, "shrinkA": 1, "shrinkB": 0},
        )  # fmt: skip

    def _measure(self, axes: Any, left: float, right: float, y: float, text: str, start: float) -> None:
        """Dimension along the axis, with extension lines; arrows from outside where it is too narrow for them."""
        beyond, small = math.copysign(0.25 * self.step, y), right - left < 1.6 * self.step
        for x, origin in ((left, math.copysign(self.side, y)), (right, start)):
            axes.plot([x, x], [origin, y + beyond], color=INK, linewidth=0.6)
        arrow = {"color": INK, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 7}
        if small:
            for x, outside in ((left, left - 1.2 * self.step), (right, right + 1.2 * self.step)):
                axes.annotate("", (x, y), (outside, y), arrowprops={"arrowstyle": "-|>", **arrow})
            axes.text(right + 1.4 * self.step, y, mathtext(text), ha="left", va="center")
        else:
            axes.annotate("", (left, y), (right, y), arrowprops={"arrowstyle": "<|-|>", **arrow})
            if right - left < 3.2 * self.step:
                axes.text(right + 0.4 * self.step, y, mathtext(text), ha="left", va="center")
            else:
                above = "bottom" if y > 0 else "top"
                axes.text((left + right) / 2, y + beyond, mathtext(text), ha="center", va=above)


def _mm(value: float) -> str:
    return display(value / _MM, "m")
