"""What a clutch is wanted to do, and among what it may be chosen: the file of the design command."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from operator import attrgetter
from os import PathLike
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple, get_args

from pydantic import (
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    StrictBool,
    TypeAdapter,
)
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, core_schema

from ..messages import say
from ..variants import VARIANTS, Variant
from .edit import Overrides
from .fields import Block, Broken, Name, Quantity, RuledBlock, Torque, key, required
from .make import validated
from .models import (
    HARDENED_STEEL,
    AtLeastOne,
    Catalogues,
    Contact,
    Count,
    Drive,
    Envelope,
    Fatigue,
    FileBlock,
    Force,
    Friction,
    Gap,
    Heat,
    Length,
    Machine,
    Method,
    OfService,
    PocketShape,
    ProtectedShaft,
    Ratio,
    Room,
    Stiffness,
    StiffnessOrNone,
    Stress,
    VariantName,
    WallAngle,
    around_the_shaft,
    missing_of,
)
from .parse import text_of
from .read import data_of
from .rules import BY_PLATE, SHARED, Table, shared_rules
from .tolerance import Tolerance

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

MOST_VALUES = 1_000_000
"""Values of one searched parameter beyond which a file is refused."""
MOST_LISTED = 10_000
"""The same for values that are written out, and for balls and forces of a catalogue."""


class Choice(NamedTuple):
    """Values of one searched parameter, SI: a list, or an even grid that is not yet laid out."""

    listed: tuple[float, ...]
    start: float = 0.0
    stop: float = 0.0
    length: int = 0

    @property
    def size(self) -> int:
        """How many values."""
        return len(self.listed) or self.length

    @property
    def between(self) -> bool:
        """Whether any value between the ends is meant, and the grid but samples it."""
        return self.length > 1

    def array(self) -> "NDArray[np.float64]":
        """The values, ascending."""
        import numpy as np

        return np.array(self.listed) if self.listed else np.linspace(self.start, self.stop, self.length)


@dataclass(frozen=True)
class Searched:
    """What a searched parameter may be: one value, a list, or a table with start, stop and count (or step)."""

    kind: Any
    """Type of a spec's field; every value is held to what it is held to."""
    most: int = MOST_VALUES

    @property
    def about(self) -> Quantity:
        """What each value may be."""
        return get_args(self.kind)[1]

    @cached_property
    def _field(self) -> TypeAdapter[float]:
        return TypeAdapter(self.kind)

    def number(self, value: object) -> float:
        """Read one value, SI."""
        try:
            return float(self._field.validate_python(value))
        except OverflowError:
            raise ValueError(say("must be finite")) from None

    def read(self, value: object) -> Choice:
        """Read what stands in the file."""
        if isinstance(value, Choice):
            return value
        if isinstance(value, list | tuple):
            if not value:
                raise ValueError(say("must not be an empty list"))
            _check_count(len(value), min(self.most, MOST_LISTED))
            return Choice(tuple(sorted({self.number(item) for item in value})))
        return self._grid(value) if isinstance(value, Mapping) else Choice((self.number(value),))

    def _grid(self, value: Table) -> Choice:
        if unknown := sorted(set(value) - {"start", "stop", "count", "step"}):
            raise ValueError(say("unknown key {key!r}; a range has start, stop and count (or step)", key=unknown[0]))
        if "start" not in value or "stop" not in value:
            raise ValueError(say("a range has start, stop and count (or step)"))
        start, stop = self.number(value["start"]), self.number(value["stop"])
        if start > stop:
            raise ValueError(
                say("the range is inverted: start {start:g} is above stop {stop:g}", start=start, stop=stop)
            )
        if "count" in value and "step" in value:
            raise ValueError(say("give count or step, not both"))
        count, whole = value.get("count"), self.kind is Count
        if "count" not in value:
            step = self.number(value["step"]) if "step" in value else 1.0 if whole else 0.0
            if not step > 0:
                raise ValueError(say("a range needs count, or a step greater than 0"))
            steps = (stop - start) / step * (1 + 1e-12)
            _check_count(steps + 1, self.most)
            count = int(steps) + 1
            stop = start + (count - 1) * step
        if isinstance(count, bool) or not isinstance(count, int) or count < 1:
            raise ValueError(say("count must be a whole number of at least 1"))
        _check_count(count, self.most)
        if whole and count > 1 and (stop - start) % (count - 1):
            raise ValueError(say("count does not give whole numbers; use step"))
        return Choice((), start, stop, count)

    def __get_pydantic_core_schema__(self, source: object, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Validate by reading."""
        return core_schema.no_info_plain_validator_function(self.read)

    def __get_pydantic_json_schema__(self, core: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Describe what may stand in the file."""
        one = [{"type": "number"}, {"type": "string"}]
        several = {"type": "array", "items": {"anyOf": one}}, {"type": "object", "additionalProperties": {"anyOf": one}}
        return {"anyOf": [*one, *several]}


def _check_count(count: float, most: int) -> None:
    if not count <= most:
        raise ValueError(say("{count:,.10g} values; at most {most:,} here", count=count, most=most))


Pairs = Annotated[Choice, Searched(Count)]
Lengths = Annotated[Choice, Searched(Length)]
Ratios = Annotated[Choice, Searched(Ratio)]
Angles = Annotated[Choice, Searched(WallAngle)]
Stiffnesses = Annotated[Choice, Searched(Stiffness)]
StiffnessesOrNone = Annotated[Choice, Searched(StiffnessOrNone)]
Forces = Annotated[Choice, Searched(Force, MOST_LISTED)]
Diameters = Annotated[Choice, Searched(Length, MOST_LISTED)]

Objective = Literal[
    "closing_force", "accuracy_factor", "pairs", "ball_diameter", "travel",
    "control_force", "closing_deflection", "control_deflection",
]  # fmt: skip

_ONE_TORQUE = say("required: nominal_torque of the clutch or machine_torque, one of them; or [machine]")
_GAIN_LIMITS = ", ".join(dict.fromkeys(variant.gain_limit.rule for variant in VARIANTS.values() if variant.gain_limit))


_OF_DISCS = ("disc_mass", "ambient", "specific_heat", "conductivity", "density")
"""Keys of [heat]: the first three tell the mean of the discs, the last four the faces."""


class Wanted(OfService):
    """What the clutch must do."""

    nominal_torque: Torque | None = key("nominal torque of the clutch", "T_н")
    machine_torque: Torque | None = key(
        "nominal torque of the machine, instead: with min-friction the clutch's is margin times it", "T_н.маш"
    )
    accuracy_factor: AtLeastOne | None = key("largest K_т allowed", "K_т")
    accuracy_factor_hysteresis: AtLeastOne | None = key("largest K_т,h allowed, under a load that lasts", "K_т,h")
    torque_max: Torque | None = key("largest torque allowed", "T_max")
    method: Method = key("friction at which the nominal torque is set", default="min-friction")
    margin: AtLeastOne = key(
        "torque margin: in the spring with mean-friction (S19), between clutch and machine with min-friction (S22)",
        "β_н",
        default=1.0,
    )

    def broken_rules(self) -> Iterable[Broken]:
        """The torque is that of the clutch or that of the machine."""
        yield from super().broken_rules()
        if self.nominal_torque is not None and self.machine_torque is not None:
            yield "nominal_torque", _ONE_TORQUE

    @property
    def in_spring(self) -> float:
        """Margin as far as it is in the spring."""
        return self.margin if self.method == "mean-friction" else 1.0

    @property
    def over_machine(self) -> float:
        """Nominal torque of the clutch over that of the machine."""
        return self.margin / self.in_spring


class ForceRange(RuledBlock):
    """Force that the pack may be pressed by at rest, any value between the ends (F_п; indirect F_п2)."""

    min: Force = required("smallest force")
    max: Force = required("largest force")

    def broken_rules(self) -> Iterable[Broken]:
        """The ends are in order."""
        if self.min > self.max:
            yield "max", say("must not be below min ({low:g})", low=self.min)


class Search(Block):
    """Among what to choose: one value, a list, or ``{ start, stop, count }`` each."""

    pairs: Pairs = required("friction pairs z")
    driving_pairs: Pairs = Field(
        default_factory=lambda: Choice((1.0,)), description="bypass pairs z_1 (differentiated); default 1"
    )
    mean_radius: Lengths | None = key("mean friction radius R_cp; or inner_radius and outer_radius")
    inner_radius: Lengths | None = key("inner radius r_i of the friction faces")
    outer_radius: Lengths | None = key("outer radius r_o; R_cp is the mean of both")
    gain: Ratios | None = key("feedback gain C")
    wall_angle: Angles | None = key("wall angle instead of the gain")
    ball_circle_radius: Lengths | None = key("ball-circle radius r")
    closing_force: ForceRange | None = key(
        "force the pack must bear, any between min and max: F_п, of an indirect clutch F_п2"
    )
    closing_forces: Forces | None = key("closing-spring forces F_п of a catalogue, instead of a range")
    closing_stiffness: Stiffnesses | None = key(
        "c_1 (indirect); of a direct clutch, for torque_after_wear, the smallest is taken"
    )
    control_stiffness: StiffnessesOrNone | None = key("c_2 (indirect); 0: a constant force")
    ball_diameters: Diameters | None = key("standard balls; default the list that ships")

    @property
    def radii(self) -> Choice:
        """What the mean radius follows: itself, or the outer radius at a given inner one."""
        radii = self.mean_radius or self.outer_radius
        assert radii is not None
        return radii


class Fixed(Block):
    """What is the same for every candidate."""

    balls: Count = key("number of balls n", default=6)
    face_gap: Gap = key("gap s between the faces", default=0.002)
    edge_clearance: Gap = key("clearance y at the pocket's edge", default=0.002)
    face_width: Length | None = key("radial width of the friction faces, for pressure and outer diameter")
    hub_diameter: Length | None = key("hub diameter d (indirect)")
    key_friction: Ratio | None = key("friction f_1 at the key (indirect)")
    pocket: PocketShape | None = key("constant-torque: pockets with the curved wall that holds the torque (indirect)")
    contact: Contact | None = key("elastic data of balls and pockets, as in a spec; default hardened steel")
    closing_room: Room | None = key("room for the closing spring, with springs", default=None)
    control_room: Room | None = key("room for the control spring (indirect), with springs", default=None)


class Limits(Block):
    """What no candidate may exceed."""

    surface_pressure: Stress | None = key("mean surface pressure; needs the width of the faces, or both radii")
    outer_diameter: Length | None = key("outer diameter of the friction faces; needs the same")
    contact_force: Force | None = key("normal force on one ball, instead of the contact pressure by Hertz")
    travel: Length | None = key("travel of the sleeve (indirect)")
    reduced_gain: Ratio | None = key("reduced gain")
    gain_limit: StrictBool = key(f"hold the gain limit of the variant ({_GAIN_LIMITS})", default=True)


class Requirements(FileBlock, RuledBlock):
    """What is wanted, among what to choose, and what counts."""

    name: Name | None = key("what the design is called")
    variants: Annotated[tuple[VariantName, ...], Field(min_length=1)] = required("variants allowed")
    objectives: Annotated[tuple[Objective, ...], Field(min_length=1)] = required(
        "what is to be small; closing_force is the force the pack must bear (F_п; indirect F_п2)"
    )
    springs: Literal["disc", "coil", "any"] | None = key(
        "only clutches whose springs can be stacks of disc springs (disc, DIN EN 16983), coil springs (coil, "
        "EN 13906-1) or either (any) in fixed.closing_room, and fixed.control_room of an indirect one"
    )
    friction: Friction
    wanted: Wanted
    search: Search
    fixed: Fixed = Field(default_factory=Fixed)
    limits: Limits = Field(default_factory=Limits)
    machine: Machine | None = None
    drive: Drive | None = None
    shaft: ProtectedShaft | None = None
    fatigue: Fatigue | None = None
    heat: Heat | None = None
    tolerance: Tolerance | None = None
    envelope: Envelope | None = None
    catalogues: Catalogues | None = None

    @property
    def clutch_torque(self) -> float:
        """Nominal torque of the clutch, N·m: as given, or by that of the machine."""
        wanted = self.wanted
        if wanted.nominal_torque is not None:
            return wanted.nominal_torque
        machine = wanted.machine_torque if self.machine is None else float(self.machine.torque)
        return (machine or 0.0) * wanted.over_machine

    @property
    def shaft_torque(self) -> float:
        """Torque of the clutch at which its shaft yields, N·m, as a check that simulates nothing has it."""
        shaft, drive = self.shaft, self.drive
        if shaft is None or shaft.yield_strength is None:
            return math.inf
        factor = drive.dynamic_factor if drive is not None and drive.event is None else None
        return float(shaft.shear_yield_strength * shaft.section_modulus) / (factor or 1.0)

    @property
    def contact(self) -> Contact | None:
        """Elastic data by which a check of the written clutch judges its balls; None: by the force given alone."""
        return self.fixed.contact or (HARDENED_STEEL if self.limits.contact_force is None else None)

    @property
    def bearing(self) -> Contact | None:
        """The same, with the contact pressure wanted where that is less."""
        wanted, own = self.wanted.contact_pressure, self.contact
        if wanted is None or (own is not None and own.allowable_pressure <= wanted):
            return own
        return (own or HARDENED_STEEL).model_copy(update={"allowable_pressure": wanted})

    def broken_rules(self) -> Iterable[Broken]:
        """What the variants need is given, and nothing that they do not have."""
        variants = [VARIANTS[name] for name in self.variants]
        yield from shared_rules(self.model_dump(exclude_none=True, include={*SHARED, "fixed"}), variants)
        torques = [name for name in ("nominal_torque", "machine_torque") if getattr(self.wanted, name) is not None]
        if not torques and self.machine is None:
            yield "wanted.nominal_torque", _ONE_TORQUE
        yield from ((f"wanted.{name}", BY_PLATE) for name in torques if self.machine is not None)
        yield from self._friction_rules(variants)
        search, fixed = self.search, self.fixed
        if (search.closing_force is None) == (search.closing_forces is None):
            message = say("give closing_force (a range) or closing_forces (a catalogue), one of them")
            yield "search.closing_force", message
        yield from self._radii_rules()
        if any(variant.controlled for variant in variants):
            if (search.gain is None) == (search.wall_angle is None):
                yield "search.gain", say("give gain or wall_angle, one of them")
            if search.ball_circle_radius is None:
                yield "search.ball_circle_radius", say("required with a control unit")
        springs_and_hub = {
            "search.closing_stiffness": search.closing_stiffness,
            "search.control_stiffness": search.control_stiffness,
            "fixed.hub_diameter": fixed.hub_diameter,
            "fixed.key_friction": fixed.key_friction,
        }
        travelling = [variant.name for variant in variants if variant.travels]
        for name in travelling:
            for path, given in springs_and_hub.items():
                if given is None:
                    yield path, say("required for variant {variant!r}", variant=name)
        yield from self._springs_rules(bool(travelling))
        yield from self._service_rules(len(travelling) < len(variants))
        yield from around_the_shaft(self, "fixed")
        if fixed.pocket is not None and not travelling:
            yield "fixed.pocket", say("is of variant {able}", able=_able("travels"))

    def _friction_rules(self, variants: list[Variant]) -> Iterable[Broken]:
        yield from self.friction.contradictions() if self.friction.unknown else ()
        try:
            _ = self.friction.groups
        except ValueError:
            yield "friction.min", say("required: min and max, a material, or both groups")
        else:
            if self.friction.unlike and not all(variant.unlike for variant in variants):
                yield "friction.driving", say("unlike materials are for variant {able} alone", able=_able("unlike"))

    def _service_rules(self, direct: bool) -> Iterable[Broken]:
        """What a requirement is judged by is given."""
        wanted, heat = self.wanted, self.heat or Heat()
        needed: dict[str, list[tuple[str, object]]] = {
            "cycles": [("fatigue", self.fatigue)],
            "torque_after_wear": [("heat.lining", heat.lining)],
            "trips_per_hour": [("heat.ambient", heat.ambient), ("heat.cooling", heat.cooling)],
            "peak_torque": [("drive.event", self.drive and self.drive.event)],
            "work": [("fixed.face_width", self.fixed.face_width or self.search.inner_radius), ("heat", self.heat)],
            "temperature": [(f"heat.{key}", getattr(heat, key)) for key in _OF_DISCS[:3]],
            "face_temperature": [(f"heat.{key}", getattr(heat, key)) for key in _OF_DISCS[1:]],
            "exceedance": [("tolerance", self.tolerance)],
        }
        needed["face_temperature"] += needed["work"][:1]
        drive = self.drive or Drive()
        trip = [(f"drive.{key}", None) for key in missing_of(drive)] if drive.event is None else []
        for name in ("work", "temperature", "face_temperature", "trips_per_hour"):
            needed[name] += trip
        if direct and self.springs is None:
            needed["torque_after_wear"].append(("search.closing_stiffness", self.search.closing_stiffness))
        for name, blocks in needed.items():
            for path, given in blocks if getattr(wanted, name) is not None else ():
                if given is None:
                    yield path, say("required beside {other}", other=f"wanted.{name}")
        blocks_of = self.friction.blocks.values()
        limited = any(all(each.temperature_min for each in block.materials.values()) for block in blocks_of)
        if wanted.trips_per_hour is not None and wanted.temperature is None and not limited:
            yield "wanted.temperature", say("required beside wanted.trips_per_hour, or a material with a limit of it")

    def _springs_rules(self, travels: bool) -> Iterable[Broken]:
        rooms = {"fixed.closing_room": self.fixed.closing_room, "fixed.control_room": self.fixed.control_room}
        if self.springs is None:
            for path, room in rooms.items():
                if room is not None:
                    yield path, say("has no effect without {other}", other="springs")
            return
        if self.fixed.pocket is not None:
            yield "springs", say("excludes {other}: such a wall is laid out for straight springs", other="fixed.pocket")
        for path, room in list(rooms.items())[: 1 + travels]:
            if room is None or room.inner_diameter is None or room.outer_diameter is None:
                yield path, say("required with springs: inner_diameter and outer_diameter, and length if bounded")
        if not travels and self.fixed.control_room is not None:
            yield "fixed.control_room", say("is of variant {able}", able=_able("travels"))

    @property
    def hub_diameter(self) -> float | None:
        """Outer diameter of the hub, wherever it is given, m."""
        hub = self.fixed.hub_diameter
        return self.envelope.hub_diameter if hub is None and self.envelope else hub

    @property
    def faces_diameter(self) -> float:
        """Outer diameter that the faces may have, m: by their own limit, and by that of the housing around them."""
        faces, room = self.limits.outer_diameter or float("inf"), self.envelope
        within = room.outer_diameter - 2 * room.housing_wall if room and room.outer_diameter else faces
        return min(faces, within)

    def _radii_rules(self) -> Iterable[Broken]:
        width, mean, inner, outer = (
            self.fixed.face_width, self.search.mean_radius, self.search.inner_radius, self.search.outer_radius,
        )  # fmt: skip
        if mean is not None and inner is None and outer is None:
            for path in ("limits.surface_pressure", "limits.outer_diameter", "envelope"):
                if width is None and attrgetter(path)(self) is not None:
                    yield "fixed.face_width", say("required beside {other}", other=path)
        elif mean is not None or inner is None or outer is None:
            yield "search.mean_radius", say("give mean_radius, or inner_radius and outer_radius")
        elif width is not None:
            yield "fixed.face_width", say("follows from search.inner_radius and search.outer_radius")
        elif not inner.array()[0] < outer.array()[-1]:
            yield "search.outer_radius", say("must reach beyond search.inner_radius")


def _able(feature: str) -> str:
    """Names of the variants that have a feature."""
    return ", ".join(repr(variant.name) for variant in VARIANTS.values() if getattr(variant, feature))


def read_requirements(source: str | PathLike[str], overrides: Overrides = ()) -> Requirements:
    """Read a requirements file (TOML or JSON, ``"-"`` for standard input) with ``"path=value"`` overrides.

    Raises:
        SpecError: every problem found.
        FileError: the file cannot be read.
    """
    return validated(Requirements, *data_of(text_of(source), overrides, Requirements))


def make_requirements(data: Table, label: str = "requirements") -> Requirements:
    """Validate requirements given as nested mappings."""
    return validated(Requirements, data, label)
