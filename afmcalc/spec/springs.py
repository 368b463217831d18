"""The springs of a clutch: forces, stiffness, the room for them, and the part itself."""

from collections.abc import Iterable, Mapping
from typing import Annotated

from pydantic import Field, model_validator

from ..equations import springs
from ..errors import Problem
from ..messages import say
from . import rules
from .fields import Block, Count, Force, Gap, Length, Quantity, Ratio, Stiffness, StiffnessOrNone, key_field

SNAPS = 1.4
"""Cone height over thickness up to which the force of a disc only grows (√2)."""
SHEAR_MODULUS = 81.5e9
"""Of patented drawn wire (EN 13906-1), Pa."""
ROUNDED = 0.005
"""How far a stiffness written to three figures may be off, relative."""
Turns = Annotated[float, Quantity("1", ge=2)]


def _bigger(name: str, value: float | None, other: str, least: float | None) -> list[Problem]:
    if value is None or least is None or value > least:
        return []
    return [rules.wrong(name, say("must be greater than {other} ({least:g} m)", other=other, least=least))]


def problems(data: rules.Table) -> Iterable[Problem]:
    """Rules of the springs of a spec: a stack of discs has no stiffness that scatters on its own."""
    scattering = rules.get(data, "tolerance", "fields")
    if not isinstance(scattering, Mapping):
        return
    for spring in ("closing_spring", "control_spring"):
        path = f"{spring}.stiffness"
        if path in scattering and rules.has(data, spring, "disc"):
            yield rules.wrong(f"tolerance.fields.{path}", say("has no effect beside {spring}.disc", spring=spring))


class Room(Block):
    """Room for a spring around the shaft."""

    inner_diameter: Gap | None = key_field("diameter of what the spring stands around", "D_1")
    outer_diameter: Length | None = key_field("diameter of what is around the spring", "D_2")
    length: Length | None = key_field("length there is for the spring as set, and as worn", "L")

    @model_validator(mode="after")
    def _ordered(self) -> "Room":
        if wrong := _bigger("outer_diameter", self.outer_diameter, "inner_diameter", self.inner_diameter):
            raise rules.RuleError(wrong)
        return self


class DiscStack(Block):
    """A stack of disc springs, DIN EN 16983."""

    outer_diameter: Length = Field(description="outer diameter of a disc", json_schema_extra={"symbol": "D_e"})
    inner_diameter: Length = Field(description="inner diameter of a disc", json_schema_extra={"symbol": "D_i"})
    thickness: Length = Field(description="thickness of a disc", json_schema_extra={"symbol": "t"})
    reduced_thickness: Length | None = key_field("thickness of a disc with flats", "t'")
    free_height: Length = Field(description="height of a disc without load", json_schema_extra={"symbol": "l_0"})
    parallel: Count = key_field("discs laid into each other", "n", default=1)
    series: Count = key_field("such packs against each other", "i", default=1)

    @model_validator(mode="after")
    def _a_cone(self) -> "DiscStack":
        wrong = [
            *_bigger("outer_diameter", self.outer_diameter, "inner_diameter", self.inner_diameter),
            *_bigger("free_height", self.free_height, "thickness", self.thickness),
            *_bigger("thickness", self.thickness, "reduced_thickness", self.reduced_thickness),
        ]
        if not wrong and self.free_height - self.thickness > SNAPS * self.thickness:
            most = (1 + SNAPS) * self.thickness
            wrong.append(
                rules.wrong("free_height", say("must be at most {most:.5g} m: a higher disc snaps through", most=most))
            )
        if wrong:
            raise rules.RuleError(wrong)
        return self


class CoilSprings(Block):
    """Coil springs side by side, ends closed and ground."""

    wire_diameter: Length = Field(description="diameter of the wire", json_schema_extra={"symbol": "d"})
    coil_diameter: Length = Field(description="mean diameter of the coil", json_schema_extra={"symbol": "D"})
    turns: Turns = Field(description="active turns", json_schema_extra={"symbol": "n"})
    free_length: Length = Field(description="length without load", json_schema_extra={"symbol": "L_0"})
    count: Count = key_field("springs around the shaft", "j", default=1)

    @model_validator(mode="after")
    def _a_coil(self) -> "CoilSprings":
        wire, coil, turns = self.wire_diameter, self.coil_diameter, self.turns
        wrong = _bigger("coil_diameter", coil, "wire_diameter", wire)
        least = float(springs.coil_solid_length(wire, turns) + springs.coil_least_gap(wire, coil, turns))
        if self.free_length <= least:
            message = say("must be greater than {least:.5g} m: pressed so far its turns all but touch", least=least)
            wrong.append(rules.wrong("free_length", message))
        if wrong:
            raise rules.RuleError(wrong)
        return self

    @property
    def rate(self) -> float:
        """Stiffness of all together, N/m."""
        one = springs.coil_stiffness(SHEAR_MODULUS, self.wire_diameter, self.coil_diameter, self.turns)
        return self.count * float(one)


class _Spring(Block):
    """What both springs may say of the part."""

    room: Room | None = None
    disc: DiscStack | None = None
    coil: CoilSprings | None = None
    surface_friction: Ratio | None = key_field("friction of the cones of a disc stack on each other", "w_M")
    edge_friction: Ratio | None = key_field("friction of the edges of a disc stack", "w_R")
    thread_pitch: Length | None = key_field("pitch of the nut that sets the spring", "P_h")

    @model_validator(mode="after")
    def _one_part(self) -> "_Spring":
        if self.disc is not None and self.coil is not None:
            raise rules.RuleError([rules.wrong("coil", say("excludes disc: a spring is one or the other"))])
        given = getattr(self, "stiffness", None)
        if self.coil is not None and given is not None and abs(given / self.coil.rate - 1) > ROUNDED:
            message = say(
                "is not the stiffness of the coil named, {own:.5g} N/m: leave it out, or the coil", own=self.coil.rate
            )
            raise rules.RuleError([rules.wrong("stiffness", message)])
        return self

    @property
    def part(self) -> DiscStack | CoilSprings | None:
        """What it is made of, if that is known."""
        return self.disc or self.coil


class ClosingSpring(_Spring):
    """The spring that presses the pack (13 in S21)."""

    force: Force | None = key_field("closing-spring force as set", "F_п")
    stiffness: Stiffness | None = key_field("stiffness of the closing spring; needed by an indirect clutch", "c_1")


class ControlSpring(_Spring):
    """The spring that holds the thrust sleeve at its stop (11 in S21)."""

    stiffness: StiffnessOrNone = Field(
        description="stiffness of the control spring", json_schema_extra={"symbol": "c_2"}
    )
    force: Force | None = key_field(
        "control-spring force as made; default so that the sleeve just rests at T_н", "F_п2"
    )
