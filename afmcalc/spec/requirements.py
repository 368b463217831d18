"""What a clutch is wanted to do, and among what it may be chosen: the file of the design command."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from os import PathLike
from typing import TYPE_CHECKING, Annotated, Literal, NamedTuple

from pydantic import Field, GetCoreSchemaHandler, GetJsonSchemaHandler, model_validator
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, core_schema

from ..errors import Problem
from ..messages import say
from ..variants import VARIANTS
from . import rules
from .fields import AtLeastOne, Block, Count, Force, Gap, Length, Name, Ratio, Stress, Torque, key_field
from .models import Friction, Method, VariantName
from .quantity import parse_quantity
from .reading import apply_overrides, parse, text_of, validated

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

Objective = Literal["closing_force", "accuracy_factor", "pairs", "ball_diameter", "travel"]

MOST_VALUES = 10_000_000
_GAIN_LIMITS = ", ".join(dict.fromkeys(each.gain_limit.rule for each in VARIANTS.values() if each.gain_limit))


class Choices(NamedTuple):
    """Values of one searched parameter, SI: a list, or an even grid that is not yet laid out."""

    listed: tuple[float, ...]
    start: float = 0.0
    stop: float = 0.0
    length: int = 0

    @property
    def size(self) -> int:
        """How many values."""
        return len(self.listed) or self.length

    def array(self) -> "NDArray[np.float64]":
        """The values, ascending."""
        import numpy as np

        return np.array(self.listed) if self.listed else np.linspace(self.start, self.stop, self.length)


@dataclass(frozen=True)
class Searched:
    """What a searched parameter may be: one value, a list, or a table with start, stop and count (or step)."""

    unit: str
    whole: bool = False
    least: float = 0.0

    def number(self, value: object) -> float:
        """Read one value, SI."""
        found = parse_quantity(value, self.unit)
        if self.whole and found != found // 1:
            raise ValueError(say("must be whole numbers"))
        if self.whole or self.unit == "1":
            if found < self.least:
                raise ValueError(say("must be at least {least:g}", least=self.least))
        elif not found > self.least:
            raise ValueError(say("must be greater than {least:g}", least=self.least))
        return found

    def read(self, value: object) -> Choices:
        """Read what stands in the file."""
        if isinstance(value, Choices):
            return value
        if isinstance(value, list | tuple):
            if not value:
                raise ValueError(say("must not be an empty list"))
            return Choices(tuple(sorted({self.number(item) for item in value})))
        return self._grid(value) if isinstance(value, Mapping) else Choices((self.number(value),))

    def _grid(self, value: rules.Table) -> Choices:
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
        count = value.get("count")
        if "count" not in value:
            step = self.number(value["step"]) if "step" in value else 1.0 if self.whole else 0.0
            if not step > 0:
                raise ValueError(say("a range needs count, or a step greater than 0"))
            count = int((stop - start) / step * (1 + 1e-12)) + 1
            stop = start + (count - 1) * step
        if isinstance(count, bool) or not isinstance(count, int) or count < 1:
            raise ValueError(say("count must be a whole number of at least 1"))
        if count > MOST_VALUES:
            raise ValueError(say("{count} values; at most {most} per parameter", count=count, most=MOST_VALUES))
        if self.whole and count > 1 and (stop - start) % (count - 1):
            raise ValueError(say("count does not give whole numbers; use step"))
        return Choices((), start, stop, count)

    def __get_pydantic_core_schema__(self, source: object, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Validate by reading."""
        return core_schema.no_info_plain_validator_function(self.read)

    def __get_pydantic_json_schema__(self, core: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """Describe what may stand in the file."""
        one: JsonSchemaValue = {"anyOf": [{"type": "number"}, {"type": "string"}]}
        return {
            "anyOf": [*one["anyOf"], {"type": "array", "items": one}, {"type": "object", "additionalProperties": one}]
        }


Pairs = Annotated[Choices, Searched("1", whole=True, least=1)]
Lengths = Annotated[Choices, Searched("m")]
Numbers = Annotated[Choices, Searched("1")]
Angles = Annotated[Choices, Searched("rad")]
Stiffnesses = Annotated[Choices, Searched("N/m")]
Forces = Annotated[Choices, Searched("N")]


class Wanted(Block):
    """What the clutch must do."""

    nominal_torque: Torque = Field(description="nominal torque")
    accuracy_factor: AtLeastOne | None = key_field("largest K_т allowed", "K_т")
    torque_max: Torque | None = key_field("largest torque allowed", "T_max")
    method: Method = key_field("friction at which the nominal torque is set", default="min-friction")
    margin: AtLeastOne = key_field("torque margin", "β_н", default=1.0)


class ForceRange(Block):
    """Spring force that can be had, any value between the ends."""

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
        default_factory=lambda: Choices((1.0,)), description="bypass pairs z_1 (differentiated); default 1"
    )
    mean_radius: Lengths = Field(description="mean friction radius R_cp")
    gain: Numbers | None = key_field("feedback gain C")
    wall_angle: Angles | None = key_field("wall angle instead of the gain")
    ball_circle_radius: Lengths | None = key_field("ball-circle radius r")
    closing_force: ForceRange | None = key_field("spring force: any between min and max")
    closing_forces: Forces | None = key_field("spring forces of a catalogue, instead of a range")
    closing_stiffness: Stiffnesses | None = key_field("c_1 (indirect)")
    control_stiffness: Stiffnesses | None = key_field("c_2 (indirect)")
    ball_diameters: Lengths | None = key_field("standard balls; default the list that ships")


class Fixed(Block):
    """What is the same for every candidate."""

    balls: Count = key_field("number of balls n", default=6)
    face_gap: Gap = key_field("gap s between the faces", default=0.002)
    edge_clearance: Gap = key_field("clearance y at the pocket's edge", default=0.002)
    face_width: Length | None = key_field("radial width of the friction face, for the surface pressure")
    hub_diameter: Length | None = key_field("hub diameter d (indirect)")
    key_friction: Ratio | None = key_field("friction f_1 at the key (indirect)")


class Limits(Block):
    """What no candidate may exceed."""

    surface_pressure: Stress | None = key_field("mean surface pressure; needs fixed.face_width")
    contact_force: Force | None = key_field("normal force on one ball")
    travel: Length | None = key_field("travel of the sleeve (indirect)")
    reduced_gain: Ratio | None = key_field("reduced gain")
    gain_limit: bool = key_field(f"hold the gain limit of the variant ({_GAIN_LIMITS})", default=True)


class Requirements(Block):
    """What is wanted, among what to choose, and what counts."""

    name: Name | None = key_field("what the design is called")
    variants: Annotated[tuple[VariantName, ...], Field(min_length=1)] = Field(description="variants allowed")
    objectives: Annotated[tuple[Objective, ...], Field(min_length=1)] = Field(description="what is to be small")
    friction: Friction
    wanted: Wanted
    search: Search
    fixed: Fixed = Fixed()
    limits: Limits = Limits()

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
        if self.limits.surface_pressure is not None and fixed.face_width is None:
            yield rules.wrong("fixed.face_width", say("required beside {other}", other="limits.surface_pressure"))


def read_requirements(source: str | PathLike[str], overrides: Iterable[str] = ()) -> Requirements:
    """Read a requirements file (TOML or JSON, ``"-"`` for standard input) with ``"path=value"`` overrides.

    Raises:
        SpecError: every problem found.
        FileError: the file cannot be read.
    """
    text, label = text_of(source)
    return make_requirements(apply_overrides(parse(text, label), overrides, Requirements), label)


def make_requirements(data: rules.Table, label: str = "requirements") -> Requirements:
    """Validate requirements given as nested mappings."""
    return validated(Requirements, data, label)
