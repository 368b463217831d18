"""Section through a ball and its two pockets (A–A of the papers), to scale, with the synthesized ball."""

import math
from typing import Any, NamedTuple

from ...analysis.figures import PocketSection
from ...analysis.synthesize import SynthesisResult
from ...messages import localized, told, translate
from ..symbols import mathtext
from ..units import display
from .chart import Sheet, stated
from .paint import COLOURS, INK, WIDTH

_HATCH = {-1: "///", 1: "\\\\\\"}


def pocket(section: PocketSection) -> Sheet:
    """Draw the ball at the stop and, where the sleeve travels, at its largest travel."""
    synthesis, panels = section.synthesis, [Position(section.synthesis, 0.0)]
    if travel := synthesis.travel_max:
        moved = told("at f_max, {stated}", stated=stated("x_max", travel, "m"))
        panels = [Position(synthesis, 0.0, translate("at the stop, x = 0")), Position(synthesis, travel, moved)]
    return Sheet(translate("Ball and pockets, section A–A"), panels, _caption(section), section.name)


def _caption(section: PocketSection) -> str:
    synthesis = section.synthesis
    sentences = [
        told(
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
        sentences.append(told("On one ball {force}.", force=stated("F_n", synthesis.contact_force, "N")))
    if synthesis.web is not None and synthesis.web > 0:
        sentences.append(told("The web between pockets is {web}.", web=stated("e", synthesis.web, "m")))
    elif synthesis.web is not None:
        sentences.append(told("{pockets} pockets cut into each other.", pockets=section.balls))
    if synthesis.wall_angle_max is not None and synthesis.wall is None:
        sentences.append(
            translate("The ball undercuts the curved wall, which cannot be cut: straight walls are drawn.")
        )
    elif synthesis.wall_angle_max is not None:
        angle = synthesis.wall_angle_max
        sentences.append(told("Curved wall: at the largest travel α = {angle:.4g deg}.", angle=angle))
    return " ".join(sentences)


def _ball(synthesis: SynthesisResult) -> str:
    ball = stated("d_ш", synthesis.ball_diameter, "m")
    if synthesis.ball_diameter_standard is None:
        return told("Drawn with {ball}, for no standard ball is that large.", ball=ball)
    if synthesis.edge_clearance_standard is None:
        return told("Drawn with {ball}.", ball=ball)
    clearance = stated("y", synthesis.edge_clearance_standard, "m")
    return told("Drawn with {ball}, which leaves {clearance} to the edge.", ball=ball, clearance=clearance)


class _Side(NamedTuple):
    """One sleeve where it is."""

    hand: int
    """-1 of the left one, 1 of the right one."""
    face: float
    """Off the ball's centre."""
    middle: float
    """Of its pocket."""
    wall: tuple[tuple[float, float], ...]
    """Its upper wall: depth below the face, distance from the middle."""
    angle: float
    """Where the ball touches."""
    seats: bool
    """Whether both walls touch it."""


class Position:
    """One position of the sleeve, in metres."""

    def __init__(self, synthesis: SynthesisResult, travel: float, title: str = "") -> None:
        """Lay out the section with the sleeve at its stop, or at its largest travel."""
        self.synthesis, self.travel, self.title = synthesis, travel, title
        self.radius, self.depth = synthesis.ball_diameter / 2, synthesis.pocket_depth
        sleeves = 2 if synthesis.wall_angle_max is None else 1  # that the ball moves in: 1 where the other seats it
        gap, cut, angle = synthesis.face_gap / 2, synthesis.pocket_depth_cut, synthesis.wall_angle
        tangent, steepest = math.tan(angle), synthesis.wall_angle_max or angle
        # a sleeve that the ball moves in turns until its walls bear on the ball again
        turned = synthesis.travel_max / sleeves * (tangent + math.tan(steepest)) / 2
        # from the face to where the ball touches at the stop
        curved = [(-(place.wall_axial + gap), place.wall_around) for place in reversed(synthesis.wall or ())]

        def side(hand: int, *, moves: bool) -> _Side:
            wall = (*(moves and curved or [(0.0, self.depth * tangent)]), (cut, (self.depth - cut) * tangent))
            if moves and travel:
                return _Side(hand, gap + travel / sleeves, turned, wall, steepest, seats=False)
            return _Side(hand, gap, 0.0, wall, angle, seats=True)

        self.sides = self.left, self.right = side(-1, moves=sleeves == 2), side(1, moves=True)
        # the same frame for every position, so that they are drawn to one scale
        reach = gap + synthesis.travel_max / sleeves + self.depth
        self.back, self.top = 1.18 * reach, 1.12 * (synthesis.pocket_width / 2 + turned) + 0.12 * reach
        self.step = max(0.1 * reach, self.top / 16)  # texts one above the other keep apart also where it is narrow
        self.extent = 2 * (self.back + 3.2 * self.step), 2 * self.top + 5.6 * self.step

    @property
    def height(self) -> float:
        """Inches that leave the drawing its scale over the width of the sheet."""
        wide, high = self.extent
        return min(5.0, (WIDTH - 0.3) * high / wide) + 0.25

    def paint(self, axes: Any) -> None:
        """Draw into matplotlib's axes."""
        from matplotlib.patches import Circle

        axes.set_axis_off()
        axes.set_aspect("equal")
        (wide, high), top = self.extent, self.top + 3.6 * self.step
        axes.set_xlim(-wide / 2, wide / 2)
        axes.set_ylim(top - high, top)
        if self.title:
            axes.set_title(mathtext(self.title), fontsize=9.5)
        for side in self.sides:
            self._sleeve(axes, side)
        axes.add_patch(Circle((0, 0), self.radius, facecolor="none", edgecolor=COLOURS[0], linewidth=2.0))
        centre: dict[str, Any] = {"color": INK, "linewidth": 0.7, "linestyle": (0, (10, 3, 2, 3))}
        axes.plot([side.hand * (side.face + self.depth) for side in self.sides], [0, 0], **centre)
        axes.plot([0, 0], [-self.radius * 1.18, self.radius * 1.18], **centre)
        self._dimensions(axes)

    def _sleeve(self, axes: Any, side: _Side) -> None:
        """One half: the face with its pocket, the back cut off, the walls to their apex, where the ball touches."""
        from matplotlib.patches import Polygon

        hand, middle = side.hand, side.hand * side.middle
        face, back = hand * side.face, hand * self.back
        upper = [(face + hand * depth, half) for depth, half in side.wall]
        wall = [(x, middle + y) for x, y in (*upper, *((x, -half) for x, half in reversed(upper)))]
        outline = [(back, self.top), (face, self.top), *wall, (face, -self.top), (back, -self.top)]
        axes.add_patch(
            Polygon(outline, closed=True, facecolor="none", edgecolor=INK, hatch=_HATCH[hand], linewidth=1.2)
        )
        (floor, half), apex = upper[-1], face + hand * self.depth
        walls = [middle + half, middle, middle - half]
        axes.plot([floor, apex, floor], walls, color=INK, linewidth=0.9, linestyle=(0, (4, 3)))
        along, across = hand * self.radius * math.sin(side.angle), hand * self.radius * math.cos(side.angle)
        # at rest and in a seat both walls of a pocket touch the ball, under way one
        for y in (-across, across) if side.seats else (-across,):
            axes.plot([along], [y], marker="o", markersize=5, color=COLOURS[1], zorder=4)

    def _dimensions(self, axes: Any) -> None:
        from matplotlib.patches import Arc

        left, right, cut = self.left, self.right, self.synthesis.pocket_depth_cut
        corner = right.middle + right.wall[-1][1]
        self._along(axes, right.face, right.face + cut, self.top + self.step, f"h_c = {_mm(cut)}", corner)
        apex, text = right.face + self.depth, f"h_1 = {_mm(self.depth)}"
        self._along(axes, right.face, apex, self.top + 2.6 * self.step, text, right.middle)
        text = f"{'s + x' if self.travel else 's'} = {_mm(left.face + right.face)}"
        self._along(axes, -left.face, right.face, -self.top - self.step, text, -self.top)
        # width of the right pocket's mouth, beside the section
        x, middle, half = self.back + self.step, right.middle, self.synthesis.pocket_width / 2
        for y in (middle - half, middle + half):
            axes.plot([right.face, x + 0.25 * self.step], [y, y], color=INK, linewidth=0.6)
        _arrow(axes, (x, middle - half), (x, middle + half))
        axes.text(x + 0.3 * self.step, middle, mathtext(f"b = {_mm(2 * half)}"), ha="left", va="center")
        reach = self.radius * math.sqrt(0.5)
        diameter = told("ball d_ш = {diameter}", diameter=_mm(2 * self.radius))
        at = -left.face - 0.35 * (left.face + self.depth), self.top + self.step
        _leader(axes, diameter, (-reach, reach), at, "-|>", 0.8)
        # the wall angle at the apex of the left pocket, between wall and axis
        angle, size = self.synthesis.wall_angle, 0.9 * self.depth
        x, y = -left.face - self.depth, -left.middle
        axes.plot([x, x + size * 0.6], [y, y], color=INK, linewidth=0.7)
        axes.add_patch(Arc((x, y), size, size, theta1=0, theta2=math.degrees(angle), color=INK, linewidth=0.9))
        tip = x + size / 2 * math.cos(angle / 2), y + size / 2 * math.sin(angle / 2)
        text = f"α = {localized(f'{math.degrees(angle):.4g}')}°"
        _leader(axes, text, tip, (-self.back - 0.2 * self.step, tip[1]), "-", 0.6)

    def _along(self, axes: Any, left: float, right: float, y: float, text: str, start: float) -> None:
        """Dimension along the axis, with extension lines; arrows from outside where it is too narrow for them."""
        beyond = math.copysign(0.25 * self.step, y)
        for x, origin in ((left, math.copysign(self.top, y)), (right, start)):
            axes.plot([x, x], [origin, y + beyond], color=INK, linewidth=0.6)
        narrow = right - left < 1.6 * self.step
        if narrow:
            for x, outside in ((left, left - 1.2 * self.step), (right, right + 1.2 * self.step)):
                _arrow(axes, (x, y), (outside, y), "-|>")
        else:
            _arrow(axes, (left, y), (right, y))
        if right - left < 3.2 * self.step:
            off = 1.4 if narrow else 0.4
            axes.text(right + off * self.step, y, mathtext(text), ha="left", va="center")
        else:
            va = "bottom" if y > 0 else "top"
            axes.text((left + right) / 2, y + beyond, mathtext(text), ha="center", va=va)


def _leader(axes: Any, text: str, tip: tuple[float, float], at: tuple[float, float], arrow: str, width: float) -> None:
    """Draw a line from a text to what it is of."""
    style = {"arrowstyle": arrow, "color": INK, "linewidth": width, "shrinkA": 1, "shrinkB": 0}
    axes.annotate(mathtext(text), tip, xytext=at, ha="right", va="center", arrowprops=style)


def _arrow(axes: Any, tip: tuple[float, float], tail: tuple[float, float], style: str = "<|-|>") -> None:
    arrow = {"arrowstyle": style, "color": INK, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 7}
    axes.annotate("", tip, tail, arrowprops=arrow)


def _mm(value: float) -> str:
    return display(value, "m")
