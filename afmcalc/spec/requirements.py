"""What a clutch is wanted to do, and among what it may be chosen: the file of the design command."""

from collections.abc import Iterable
from os import PathLike
from typing import Annotated, Literal

from pydantic import Field, StrictBool, model_validator

from ..errors import Problem
from ..messages import say
from ..variants import VARIANTS
from . import rules
from .choices import Angles, Choice, Diameters, Forces, Lengths, Pairs, Ratios, Stiffnesses, StiffnessesOrNone
from .contact import HARDENED_STEEL, Contact
from .fields import AtLeastOne, Block, Count, Force, Gap, Length, Name, Ratio, Stress, Torque, key_field
from .models import Friction, Method, PocketShape, Profiled, VariantName
from .overrides import Overrides, apply_overrides, overridden
from .parsing import parse, text_of
from .reading import validated
from .springs import Room

Objective = Literal[
    "closing_force", "accuracy_factor", "pairs", "ball_diameter", "travel",
    "control_force", "closing_deflection", "control_deflection",
]  # fmt: skip

_GAIN_LIMITS = ", ".join(dict.fromkeys(each.gain_limit.rule for each in VARIANTS.values() if each.gain_limit))


class Wanted(Block):
    """What the clutch must do."""

    nominal_torque: Torque | None = key_field("nominal torque of the clutch", "T_н")
    machine_torque: Torque | None = key_field(
        "nominal torque of the machine, instead: with min-friction the clutch's is margin times it", "T_н.маш"
    )
    accuracy_factor: AtLeastOne | None = key_field("largest K_т allowed", "K_т")
    torque_max: Torque | None = key_field("largest torque allowed", "T_max")
    method: Method = key_field("friction at which the nominal torque is set", default="min-friction")
    margin: AtLeastOne = key_field(
        "torque margin: in the spring with mean-friction (S19), between clutch and machine with min-friction (S22)",
        "β_н",
        default=1.0,
    )

    @model_validator(mode="after")
    def _one_torque(self) -> "Wanted":
        if (self.nominal_torque is None) == (self.machine_torque is None):
            message = say("required: nominal_torque of the clutch or machine_torque, one of them")
            raise rules.RuleError([rules.wrong("nominal_torque", message)])
        return self

    @property
    def in_spring(self) -> float:
        """Margin as far as it is in the spring."""
        return self.margin if self.method == "mean-friction" else 1.0

    @property
    def over_machine(self) -> float:
        """Nominal torque of the clutch over that of the machine."""
        return self.margin / self.in_spring

    @property
    def clutch_torque(self) -> float:
        """Nominal torque of the clutch, N·m."""
        given = self.nominal_torque
        return given if given is not None else (self.machine_torque or 0.0) * self.over_machine


class ForceRange(Block):
    """Force that the pack may be pressed by at rest, any value between the ends (F_п; indirect F_п2)."""

    min: Force = Field(description="smallest force")
    max: Force = Field(description="largest force")

    @model_validator(mode="after")
    def _ordered(self) -> "ForceRange":
        if self.min > self.max:
            raise rules.RuleError([rules.wrong("max", say("must not be below min ({low:g})", low=self.min))])
        return self


class Search(Block):
    """Among what to choose: one value, a list, or ``{ start, stop, count }`` each."""

    pairs: Pairs = Field(description="friction pairs z")
    driving_pairs: Pairs = Field(
        default_factory=lambda: Choice((1.0,)), description="bypass pairs z_1 (differentiated); default 1"
    )
    mean_radius: Lengths | None = key_field("mean friction radius R_cp; or inner_radius and outer_radius")
    inner_radius: Lengths | None = key_field("inner radius r_i of the friction faces")
    outer_radius: Lengths | None = key_field("outer radius r_o; R_cp is the mean of both")
    gain: Ratios | None = key_field("feedback gain C")
    wall_angle: Angles | None = key_field("wall angle instead of the gain")
    ball_circle_radius: Lengths | None = key_field("ball-circle radius r")
    closing_force: ForceRange | None = key_field(
        "force the pack must bear, any between min and max: F_п, of an indirect clutch F_п2"
    )
    closing_forces: Forces | None = key_field("closing-spring forces F_п of a catalogue, instead of a range")
    closing_stiffness: Stiffnesses | None = key_field("c_1 (indirect)")
    control_stiffness: StiffnessesOrNone | None = key_field("c_2 (indirect); 0: a constant force")
    ball_diameters: Diameters | None = key_field("standard balls; default the list that ships")

    @property
    def radii(self) -> Choice:
        """What the mean radius follows: itself, or the outer radius at a given inner one."""
        found = self.mean_radius or self.outer_radius
        assert found is not None
        return found

    @property
    def least_mean_radius(self) -> float:
        """No mean radius is smaller, m."""
        outer = float(self.radii.array()[0])
        inner = outer if self.inner_radius is None else float(self.inner_radius.array()[0])
        return (max(inner, outer) + inner) / 2


class Fixed(Block):
    """What is the same for every candidate."""

    balls: Count = key_field("number of balls n", default=6)
    face_gap: Gap = key_field("gap s between the faces", default=0.002)
    edge_clearance: Gap = key_field("clearance y at the pocket's edge", default=0.002)
    face_width: Length | None = key_field("radial width of the friction faces, for pressure and outer diameter")
    hub_diameter: Length | None = key_field("hub diameter d (indirect)")
    key_friction: Ratio | None = key_field("friction f_1 at the key (indirect)")
    pocket: PocketShape | None = key_field(
        "constant-torque: pockets with the curved wall that holds the torque (indirect)"
    )
    profiled: Profiled | None = key_field("sleeves with the curved wall (indirect); default one")
    contact: Contact | None = key_field("elastic data of balls and pockets, as in a spec; default hardened steel")
    closing_room: Room | None = key_field("room for the closing spring, with springs", default=None)
    control_room: Room | None = key_field("room for the control spring (indirect), with springs", default=None)


class Limits(Block):
    """What no candidate may exceed."""

    surface_pressure: Stress | None = key_field("mean surface pressure; needs the width of the faces, or both radii")
    outer_diameter: Length | None = key_field("outer diameter of the friction faces; needs the same")
    contact_force: Force | None = key_field("normal force on one ball, instead of the contact pressure by Hertz")
    travel: Length | None = key_field("travel of the sleeve (indirect)")
    reduced_gain: Ratio | None = key_field("reduced gain")
    gain_limit: StrictBool = key_field(f"hold the gain limit of the variant ({_GAIN_LIMITS})", default=True)


class Requirements(Block):
    """What is wanted, among what to choose, and what counts."""

    name: Name | None = key_field("what the design is called")
    variants: Annotated[tuple[VariantName, ...], Field(min_length=1)] = Field(description="variants allowed")
    objectives: Annotated[tuple[Objective, ...], Field(min_length=1)] = Field(
        description="what is to be small; closing_force is the force the pack must bear (F_п; indirect F_п2)"
    )
    springs: Literal["disc"] | None = key_field(
        "disc: only clutches whose springs can be stacks of disc springs (DIN EN 16983) in fixed.closing_room, and "
        "fixed.control_room of an indirect one"
    )
    friction: Friction
    wanted: Wanted
    search: Search
    fixed: Fixed = Field(default_factory=Fixed)
    limits: Limits = Field(default_factory=Limits)

    @property
    def contact(self) -> Contact | None:
        """Elastic data by which a check of the written clutch judges its balls; None: by the force given alone."""
        return self.fixed.contact or (HARDENED_STEEL if self.limits.contact_force is None else None)

    @model_validator(mode="after")
    def _complete(self) -> "Requirements":
        if problems := [*self._friction_problems(), *self._needed()]:
            raise rules.RuleError(problems)
        return self

    def _friction_problems(self) -> Iterable[Problem]:
        try:
            _ = self.friction.groups
        except ValueError:
            yield rules.wrong("friction.min", say("required: min and max, a material, or both groups"))
        else:
            if self.friction.unlike and not all(VARIANTS[name].unlike for name in self.variants):
                able = ", ".join(repr(each.name) for each in VARIANTS.values() if each.unlike)
                yield rules.wrong("friction.driving", say("unlike materials are for variant {able} alone", able=able))

    def _needed(self) -> Iterable[Problem]:
        search, fixed = self.search, self.fixed
        if (search.closing_force is None) == (search.closing_forces is None):
            yield rules.wrong(
                "search.closing_force",
                say("give closing_force (a range) or closing_forces (a catalogue), one of them"),
            )
        yield from self._radii_problems()
        variants = [VARIANTS[name] for name in self.variants]
        if any(each.controlled for each in variants):
            if (search.gain is None) == (search.wall_angle is None):
                yield rules.wrong("search.gain", say("give gain or wall_angle, one of them"))
            if search.ball_circle_radius is None:
                yield rules.wrong("search.ball_circle_radius", say("required with a control unit"))
        springs_and_hub = {
            "search.closing_stiffness": search.closing_stiffness,
            "search.control_stiffness": search.control_stiffness,
            "fixed.hub_diameter": fixed.hub_diameter,
            "fixed.key_friction": fixed.key_friction,
        }
        for each in (each for each in variants if each.travels):
            for path in (path for path, given in springs_and_hub.items() if given is None):
                yield rules.wrong(path, say("required for variant {variant!r}", variant=each.name))
        yield from self._springs_problems(any(each.travels for each in variants))
        if fixed.pocket is not None and not any(each.travels for each in variants):
            able = ", ".join(repr(each.name) for each in VARIANTS.values() if each.travels)
            yield rules.wrong("fixed.pocket", say("is of variant {able}", able=able))
        if fixed.profiled is not None and fixed.pocket is None:
            yield rules.wrong("fixed.profiled", say("is of a curved wall: give fixed.pocket with it"))

    def _springs_problems(self, travels: bool) -> Iterable[Problem]:
        rooms = {"fixed.closing_room": self.fixed.closing_room, "fixed.control_room": self.fixed.control_room}
        if self.springs is None:
            for path in (path for path, room in rooms.items() if room is not None):
                yield rules.wrong(path, say("has no effect without {other}", other="springs"))
            return
        if self.fixed.pocket is not None:
            message = say("excludes {other}: such a wall is laid out for straight springs", other="fixed.pocket")
            yield rules.wrong("springs", message)
        for path, room in list(rooms.items())[: 1 + travels]:
            if room is None or room.inner_diameter is None or room.outer_diameter is None:
                message = say("required with springs: inner_diameter and outer_diameter, and length if bounded")
                yield rules.wrong(path, message)
        if not travels and self.fixed.control_room is not None:
            yield rules.wrong("fixed.control_room", say("is of variant {able}", able="'indirect'"))

    def _radii_problems(self) -> Iterable[Problem]:
        width, mean, inner, outer = (
            self.fixed.face_width, self.search.mean_radius, self.search.inner_radius, self.search.outer_radius,
        )  # fmt: skip
        if mean is not None and inner is None and outer is None:
            for name in ("surface_pressure", "outer_diameter"):
                if width is None and getattr(self.limits, name) is not None:
                    yield rules.wrong("fixed.face_width", say("required beside {other}", other=f"limits.{name}"))
        elif mean is not None or inner is None or outer is None:
            yield rules.wrong("search.mean_radius", say("give mean_radius, or inner_radius and outer_radius"))
        elif width is not None:
            yield rules.wrong("fixed.face_width", say("follows from search.inner_radius and search.outer_radius"))
        elif not inner.array()[0] < outer.array()[-1]:
            yield rules.wrong("search.outer_radius", say("must reach beyond search.inner_radius"))


def read_requirements(source: str | PathLike[str], overrides: Overrides = ()) -> Requirements:
    """Read a requirements file (TOML or JSON, ``"-"`` for standard input) with ``"path=value"`` overrides.

    Raises:
        SpecError: every problem found.
        FileError: the file cannot be read.
    """
    text, label = text_of(source)
    data = apply_overrides(parse(text, label), overrides, Requirements)
    return make_requirements(data, label.but(overridden(overrides, Requirements)))


def make_requirements(data: rules.Table, label: str = "requirements") -> Requirements:
    """Validate requirements given as nested mappings."""
    return validated(Requirements, data, label)
