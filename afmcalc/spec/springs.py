"""The springs of a clutch: forces, stiffness, the room for them, and the part itself."""

from collections.abc import Iterable
from typing import Annotated

from ..equations import springs
from ..messages import say
from .fields import (
    Broken,
    Count,
    Force,
    Gap,
    Length,
    Quantity,
    Ratio,
    RuledBlock,
    Stiffness,
    StiffnessOrNone,
    key,
    required,
)

SNAPS = 1.4
"""Cone height over thickness up to which the force of a disc only grows (√2)."""
SHEAR_MODULUS = 81.5e9
"""Of patented drawn wire (EN 13906-1), Pa."""
ROUNDED = 0.005
"""How far a stiffness written to three figures may be off, relative."""
Turns = Annotated[float, Quantity("1", ge=2)]


def _bigger(name: str, value: float | None, other: str, least: float | None) -> Iterable[Broken]:
    if value is not None and least is not None and value <= least:
        yield name, say("must be greater than {other} ({least:g} m)", other=other, least=least)


class Room(RuledBlock):
    """Room for a spring around the shaft."""

    inner_diameter: Gap | None = key("diameter of what the spring stands around", "D_1")
    outer_diameter: Length | None = key("diameter of what is around the spring", "D_2")
    length: Length | None = key("length there is for the spring as set, and as worn", "L")

    def broken_rules(self) -> Iterable[Broken]:
        """The outer diameter is the greater one."""
        return _bigger("outer_diameter", self.outer_diameter, "inner_diameter", self.inner_diameter)


class DiscStack(RuledBlock):
    """A stack of disc springs, DIN EN 16983."""

    outer_diameter: Length = required("outer diameter of a disc", "D_e")
    inner_diameter: Length = required("inner diameter of a disc", "D_i")
    thickness: Length = required("thickness of a disc", "t")
    reduced_thickness: Length | None = key("thickness of a disc with flats", "t'")
    free_height: Length = required("height of a disc without load", "l_0")
    parallel: Count = key("discs laid into each other", "n", default=1)
    series: Count = key("such packs against each other", "i", default=1)

    def broken_rules(self) -> Iterable[Broken]:
        """A disc is a cone that does not snap through."""
        broken = [
            *_bigger("outer_diameter", self.outer_diameter, "inner_diameter", self.inner_diameter),
            *_bigger("free_height", self.free_height, "thickness", self.thickness),
            *_bigger("thickness", self.thickness, "reduced_thickness", self.reduced_thickness),
        ]
        yield from broken
        if not broken and self.free_height - self.thickness > SNAPS * self.thickness:
            most = (1 + SNAPS) * self.thickness
            yield "free_height", say("must be at most {most:.5g} m: a higher disc snaps through", most=most)


class CoilSprings(RuledBlock):
    """Coil springs side by side, ends closed and ground."""

    wire_diameter: Length = required("diameter of the wire", "d")
    coil_diameter: Length = required("mean diameter of the coil", "D")
    turns: Turns = required("active turns", "n")
    free_length: Length = required("length without load", "L_0")
    count: Count = key("springs around the shaft", "j", default=1)

    def broken_rules(self) -> Iterable[Broken]:
        """A coil is wider than its wire, and longer than it is when its turns touch."""
        wire, coil, turns = self.wire_diameter, self.coil_diameter, self.turns
        yield from _bigger("coil_diameter", coil, "wire_diameter", wire)
        least = float(springs.coil_solid_length(wire, turns) + springs.coil_least_gap(wire, coil, turns))
        if self.free_length <= least:
            message = say("must be greater than {least:.5g} m: pressed so far its turns all but touch", least=least)
            yield "free_length", message

    @property
    def rate(self) -> float:
        """Stiffness of all together, N/m."""
        one = springs.coil_stiffness(SHEAR_MODULUS, self.wire_diameter, self.coil_diameter, self.turns)
        return self.count * float(one)


class _Spring(RuledBlock):
    """What both springs may say of the part."""

    room: Room | None = None
    disc: DiscStack | None = None
    coil: CoilSprings | None = None
    surface_friction: Ratio | None = key("friction of the cones of a disc stack on each other", "w_M")
    edge_friction: Ratio | None = key("friction of the edges of a disc stack", "w_R")
    thread_pitch: Length | None = key("pitch of the nut that sets the spring", "P_h")

    def broken_rules(self) -> Iterable[Broken]:
        """It is of one part, whose stiffness it has."""
        given = getattr(self, "stiffness", None)
        if self.disc is not None and self.coil is not None:
            yield "coil", say("excludes disc: a spring is one or the other")
        elif self.coil is not None and given is not None and abs(given / self.coil.rate - 1) > ROUNDED:
            message = say(
                "is not the stiffness of the coil named, {own:.5g} N/m: leave it out, or the coil", own=self.coil.rate
            )
            yield "stiffness", message

    @property
    def part(self) -> DiscStack | CoilSprings | None:
        """What it is made of, if that is known."""
        return self.disc or self.coil


class ClosingSpring(_Spring):
    """The spring that presses the pack (13 in S21)."""

    force: Force | None = key("closing-spring force as set", "F_п")
    stiffness: Stiffness | None = key("stiffness of the closing spring; needed by an indirect clutch", "c_1")


class ControlSpring(_Spring):
    """The spring that holds the thrust sleeve at its stop (11 in S21)."""

    stiffness: StiffnessOrNone = required("stiffness of the control spring", "c_2")
    force: Force | None = key("control-spring force as made; default so that the sleeve just rests at T_н", "F_п2")
