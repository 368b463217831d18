"""What a clutch is wanted to do, and among what it may be chosen: the file of the design command."""

from collections.abc import Iterable, Mapping
from os import PathLike
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple, TypeAlias

from pydantic import BeforeValidator, Field, ValidationError, model_validator

from ..errors import SpecError
from ..variants import VARIANTS
from . import rules
from .fields import AtLeastOne, Count, Force, Gap, Length, Name, Ratio, Stress, Torque
from .models import Block, Friction, Method, VariantName, key_field
from .quantity import parse_quantity
from .reading import apply_overrides, label_of, parse, problems_of, text_of

Objective = Literal["closing_force", "accuracy_factor", "pairs", "ball_diameter", "travel"]

MOST_VALUES = 10_000_000
_GAIN_LIMITS = ", ".join(dict.fromkeys(each.gain_limit.rule for each in VARIANTS.values() if each.gain_limit))


class Values(NamedTuple):
    """Values of one searched parameter, SI: a list, or an even grid that is not yet laid out."""

    listed: tuple[float, ...]
    start: float = 0.0
    stop: float = 0.0
    length: int = 0

    @property
    def size(self) -> int:
        """How many values."""
        return len(self.listed) or self.length

    def array(self) -> Any:
        """The values, ascending."""
        import numpy as np

        return np.array(self.listed) if self.listed else np.linspace(self.start, self.stop, self.length)


def _values(unit: str, *, whole: bool = False, least: float = 0.0) -> Any:
    """Type of a searched parameter: one value, a list, or a table with start, stop and count (or step)."""

    def number(value: object) -> float:
        found = parse_quantity(value, unit)
        if whole and found != found // 1:
            raise ValueError("must be whole numbers")
        if found < least or (not whole and least == 0 and unit != "1" and found == 0):
            raise ValueError(f"must be {'at least' if whole or unit == '1' else 'greater than'} {least:g}")
        return found

    def read(value: object) -> Values:
        if isinstance(value, Values):
            return value
        if isinstance(value, list | tuple):
            if not value:
                raise ValueError("must not be an empty list")
            return Values(tuple(sorted({number(item) for item in value})))
        if not isinstance(value, Mapping):
            return Values((number(value),))
        return _grid(value, number, whole=whole)

    schema: Any = float | str | list[float | str] | dict[str, float | str]
    return Annotated[Any, BeforeValidator(read, json_schema_input_type=schema)]


def _grid(value: Mapping[str, Any], number: Any, *, whole: bool) -> Values:
    if unknown := sorted(set(value) - {"start", "stop", "count", "step"}):
        raise ValueError(f"unknown key {unknown[0]!r}; a range has start, stop and count (or step)")
    if "start" not in value or "stop" not in value:
        raise ValueError("a range has start, stop and count (or step)")
    start, stop = number(value["start"]), number(value["stop"])
    if start > stop:
        raise ValueError(f"the range is inverted: start {start:g} is above stop {stop:g}")
    if "count" in value and "step" in value:
        raise ValueError("give count or step, not both")
    if "count" in value:
        count = value["count"]
        if isinstance(count, bool) or not isinstance(count, int) or count < 1:
            raise ValueError("count must be a whole number of at least 1")
    else:
        step = number(value["step"]) if "step" in value else 1.0 if whole else 0.0
        if not step > 0:
            raise ValueError("a range needs count, or a step greater than 0")
        count = int((stop - start) / step * (1 + 1e-12)) + 1
        stop = start + (count - 1) * step
    if count > MOST_VALUES:
        raise ValueError(f"{count} values; at most {MOST_VALUES} per parameter")
    if whole and count > 1 and (stop - start) % (count - 1):
        raise ValueError("count does not give whole numbers; use step")
    return Values((), start, stop, count)


if TYPE_CHECKING:
    Pairs: TypeAlias = Values
    Lengths: TypeAlias = Values
    Numbers: TypeAlias = Values
    Angles: TypeAlias = Values
    Stiffnesses: TypeAlias = Values
    Forces: TypeAlias = Values
else:
    Pairs = _values("1", whole=True, least=1)
    Lengths = _values("m")
    Numbers = _values("1")
    Angles = _values("rad")
    Stiffnesses = _values("N/m")
    Forces = _values("N")


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
            raise rules.validation_error("ForceRange", [(("max",), self.max, f"must not be below min ({self.min:g})")])
        return self


class Search(Block):
    """Among what to choose: one value, a list, or ``{ start, stop, count }`` each."""

    pairs: Pairs = Field(description="friction pairs z")
    driving_pairs: Pairs = Field(
        default_factory=lambda: Values((1.0,)), description="bypass pairs z_1 (differentiated); default 1"
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
        problems = [*self._friction_problems(), *self._needed()]
        if problems:
            raise rules.validation_error("Requirements", problems)
        return self

    def _friction_problems(self) -> list[rules.Finding]:
        try:
            _ = self.friction.groups
        except ValueError:
            return [(("friction", "min"), rules.MISSING, "required: min and max, a material, or both groups")]
        if self.friction.unlike and not all(VARIANTS[name].unlike for name in self.variants):
            able = ", ".join(repr(each.name) for each in VARIANTS.values() if each.unlike)
            return [(("friction", "driving"), rules.MISSING, f"unlike materials are for variant {able} alone")]
        return []

    def _needed(self) -> list[rules.Finding]:
        search = self.search
        problems: list[rules.Finding] = []
        if (search.closing_force is None) == (search.closing_forces is None):
            message = "give closing_force (a range) or closing_forces (a catalogue), one of them"
            problems.append((("search", "closing_force"), rules.MISSING, message))
        variants = [VARIANTS[name] for name in self.variants]
        if any(each.controlled for each in variants):
            if (search.gain is None) == (search.wall_angle is None):
                problems.append((("search", "gain"), rules.MISSING, "give gain or wall_angle, one of them"))
            if search.ball_circle_radius is None:
                problems.append((("search", "ball_circle_radius"), rules.MISSING, "required with a control unit"))
        for each in (each for each in variants if each.travels):
            for block, name in (
                ("search", "closing_stiffness"), ("search", "control_stiffness"),
                ("fixed", "hub_diameter"), ("fixed", "key_friction"),
            ):  # fmt: skip
                if getattr(getattr(self, block), name) is None:
                    problems.append(((block, name), rules.MISSING, f"required for variant {each.name!r}"))
        if self.limits.surface_pressure is not None and self.fixed.face_width is None:
            problems.append((("fixed", "face_width"), rules.MISSING, "required beside limits.surface_pressure"))
        return problems


def read_requirements(source: str | PathLike[str], overrides: Iterable[str] = ()) -> Requirements:
    """Read a requirements file (TOML or JSON, ``"-"`` for standard input) with ``"path=value"`` overrides.

    Raises:
        SpecError: every problem found.
        FileError: the file cannot be read.
    """
    text, _ = text_of(source)
    label = label_of(source)
    return make_requirements(apply_overrides(parse(text, label), overrides, label, Requirements), label)


def make_requirements(data: Mapping[str, Any], label: str = "requirements") -> Requirements:
    """Validate requirements given as nested mappings."""
    try:
        return Requirements.model_validate(dict(data))
    except ValidationError as error:
        raise SpecError(label, problems_of(error, data, Requirements)) from None
