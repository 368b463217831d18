"""What a clutch is: the pydantic models of a spec (contract, Spec). SI inside."""

from dataclasses import dataclass, field
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import (
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    ModelWrapValidatorHandler,
    PrivateAttr,
    ValidationError,
    field_validator,
    model_validator,
)
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, PydanticKnownError, core_schema

from ..errors import Problem
from ..messages import say
from ..source import Source
from ..variants import VARIANTS, Variant
from . import drive, rules, springs
from .contact import HARDENED_STEEL, Contact
from .drive import Drive, Mass, SlidingSpeed, TimeOrNone
from .fatigue import Fatigue
from .fields import (
    AtLeastOne,
    Block,
    Coefficient,
    Count,
    Force,
    Gap,
    Length,
    Name,
    Ratio,
    Slope,
    Torque,
    WallAngle,
    key_field,
)
from .heat import Heat
from .report import TitleBlock
from .required import Required
from .springs import ClosingSpring, ControlSpring
from .tolerance import Tolerance, in_si


class _Registered:
    """Type of a field that names a variant: whichever records there are when a spec is read or described."""

    def __get_pydantic_core_schema__(self, source: object, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Take a name there is a record of."""
        return core_schema.no_info_plain_validator_function(_registered)

    def __get_pydantic_json_schema__(self, core: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """List the names."""
        return {"enum": list(VARIANTS), "type": "string"}


def _registered(value: object) -> object:
    if isinstance(value, str) and value in VARIANTS:
        return value
    *names, last = map(repr, VARIANTS)
    raise PydanticKnownError("literal_error", {"expected": f"{', '.join(names)} or {last}"})


VariantName = Annotated[str, _Registered()]
Method = Literal["min-friction", "mean-friction"]
PocketShape = Literal["constant-torque"]
Profiled = Literal["one", "both"]
RadiusModel = Literal["uniform-wear", "uniform-pressure"]


class Range(NamedTuple):
    """Coefficient of friction over a clutch's service: smallest, mean, largest."""

    min: float
    mean: float
    max: float


class FrictionRange(Block):
    """Friction of one group of pairs: a range, or a material of the catalogue."""

    min: Coefficient | None = key_field("smallest coefficient of friction", "f_min")
    mean: Coefficient | None = key_field("mean coefficient of friction; default (min + max)/2", "f_cp")
    max: Coefficient | None = key_field("largest coefficient of friction", "f_max")
    material: str | None = key_field("name of a friction material of the catalogue")

    @model_validator(mode="after")
    def _check_range(self) -> "FrictionRange":
        if problems := self._range_problems():
            raise rules.RuleError(problems)
        return self

    def _range_problems(self) -> list[Problem]:
        if self.material is not None:
            from . import materials

            return materials.problems(self.material, {"min": self.min, "mean": self.mean, "max": self.max})
        return rules.order_problems(self.min, self.mean, self.max)

    @property
    def range(self) -> Range:
        """The three coefficients, with the material looked up and the mean filled in."""
        low, mean, high = self.min, self.mean, self.max
        if self.material is not None:
            from . import materials

            low, high = materials.friction_range(self.material)
        if low is None or high is None:
            raise ValueError(say("no range here: friction is given per group"))
        return Range(low, (low + high) / 2 if mean is None else mean, high)


class Friction(FrictionRange):
    """Friction of all pairs, or of the driving and the driven group apart (differentiated only)."""

    driving: FrictionRange | None = key_field("friction of the driving (bypass) pairs", "f_1")
    driven: FrictionRange | None = key_field("friction of the driven (controlled) pairs", "f_2")
    static_ratio: AtLeastOne | None = key_field("static over sliding friction; default 1", "r_s")
    stribeck_speed: SlidingSpeed | None = key_field("sliding speed in which static friction decays", "v_s")

    @property
    def groups(self) -> tuple[Range, Range]:
        """Ranges of the driving and the driven pairs; twice the same with one material."""
        if self.driving is not None and self.driven is not None:
            return self.driving.range, self.driven.range
        return self.range, self.range

    @property
    def unlike(self) -> bool:
        """Whether the two groups have materials of their own."""
        return self.driving is not None

    @property
    def materials(self) -> dict[str, str]:
        """Names of the materials by the paths of their keys."""
        blocks = {"friction": self, "friction.driving": self.driving, "friction.driven": self.driven}
        return {f"{path}.material": own.material for path, own in blocks.items() if own and own.material}


class FrictionGroup(Block):
    """The pack of friction discs."""

    pairs: Count = Field(description="number of friction pairs, all groups", json_schema_extra={"symbol": "z"})
    driving_pairs: Count | None = key_field(
        "pairs that bypass the control unit; default 1 (differentiated only)", "z_1"
    )
    mean_radius: Length | None = key_field("mean friction radius", "R_cp")
    inner_radius: Length | None = key_field("inner radius of the friction surface", "r_i")
    outer_radius: Length | None = key_field("outer radius of the friction surface", "r_o")
    radius_model: RadiusModel | None = key_field("how the mean radius follows from the two; default uniform-wear")
    spline_friction: Ratio | None = key_field("friction of the discs in their splines (effects only)", "μ_s")
    inner_spline_radius: Length | None = key_field("radius of the inner discs' splines (effects only)", "r_si")
    outer_spline_radius: Length | None = key_field("radius of the outer discs' splines (effects only)", "r_so")

    @model_validator(mode="after")
    def _check_radii(self) -> "FrictionGroup":
        if self.inner_radius is not None and self.outer_radius is not None and self.inner_radius >= self.outer_radius:
            message = say("must be greater than friction_group.inner_radius ({inner:g} m)", inner=self.inner_radius)
            raise rules.RuleError([rules.wrong("outer_radius", message)])
        return self


class ControlUnit(Block):
    """Balls in pockets with inclined walls."""

    gain: Ratio | None = key_field("feedback gain", "C")
    gain_slope: Slope | None = key_field(
        "how the gain grows with the sleeve's travel, pockets with a curved wall (indirect only); default 0", "C_1"
    )
    pocket: PocketShape | None = key_field(
        "constant-torque: the curved wall that holds the torque, instead of gain_slope (indirect only)"
    )
    profiled: Profiled | None = key_field("sleeves with the curved wall (indirect only); default one")
    ball_circle_radius: Length | None = key_field("radius of the ball circle", "r")
    wall_angle: WallAngle | None = key_field("wall angle of the pockets, from the axis", "α")
    balls: Count | None = key_field("number of balls", "n")
    hub_diameter: Length | None = key_field("hub diameter at the key (indirect only)", "d")
    key_friction: Ratio | None = key_field("friction coefficient at the key (indirect only)", "f_1")
    sleeve_mass: Mass | None = key_field("mass of the thrust sleeve; default 0 (indirect only)", "m")
    release_lag: TimeOrNone | None = key_field("time by which the normal force lags the load; default 0", "τ")
    face_gap: Gap | None = key_field("gap between the faces of the pockets", "s")
    edge_clearance: Gap | None = key_field("clearance of the contact from the pocket's edge", "y")
    allowable_contact_force: Force | None = key_field("allowable normal force on one ball", "[F_n]")
    ball_diameter: Length | None = key_field("ball chosen; synthesize takes it instead of the next standard one", "d_ш")
    sleeve_depth: Length | None = key_field("thickness, along the axis, of the sleeve the pockets are cut into", "B")
    wall_friction: Ratio | None = key_field(
        "friction of cams that slide on the walls, balls do not (effects only)", "μ"
    )
    contact: Contact | None = None

    @property
    def elasticity(self) -> Contact:
        """Elastic data of ball and wall: as given, or assumed."""
        return self.contact or HARDENED_STEEL


class Adjustment(Block):
    """How the spring is set."""

    method: Method = key_field("friction at which the nominal torque is set", default="min-friction")
    margin: AtLeastOne = key_field("torque margin", "β_н", default=1.0)
    nominal_torque: Torque | None = key_field(
        "nominal torque of the clutch; gives the spring force where absent", "T_н"
    )


@dataclass(frozen=True)
class Origin:
    """Where a spec was read from; specs that say the same are equal wherever that was."""

    label: Source = field(compare=False)


class Spec(Block):
    """A clutch, as a spec file describes it."""

    name: Name | None = key_field("what the clutch is called")
    variant: VariantName = Field(description="how the clutch regulates")
    friction: Friction
    friction_group: FrictionGroup
    # to validate a default would build its block twice
    closing_spring: ClosingSpring = Field(default_factory=ClosingSpring.model_construct)
    control_spring: ControlSpring | None = None
    control_unit: ControlUnit | None = None
    adjustment: Adjustment = Field(default_factory=Adjustment.model_construct)
    drive: Drive = Field(default_factory=Drive.model_construct)
    fatigue: Fatigue | None = None
    heat: Heat | None = None
    tolerance: Tolerance | None = None
    requirements: Required | None = None
    report: TitleBlock | None = None

    _origin: Origin = PrivateAttr(Origin(Source("spec")))

    @field_validator("tolerance")
    @classmethod
    def _scatter(cls, given: Tolerance | None) -> Tolerance | None:
        return given and in_si(given, cls)

    @model_validator(mode="wrap")
    @classmethod
    def _every_problem_at_once(cls, data: object, handler: ModelWrapValidatorHandler["Spec"]) -> "Spec":
        """Report what the blocks find and what the rules between them find together."""
        problems = (
            [*rules.problems(data), *drive.problems(data), *springs.problems(data)] if isinstance(data, dict) else []
        )
        try:
            spec = handler(data)
        except ValidationError as error:
            raise rules.RuleError(problems, error) from None
        if problems:
            raise rules.RuleError(problems)
        return spec

    def model_post_init(self, context: object) -> None:
        """Keep where the spec was read from, if that is known."""
        if isinstance(context, str):
            self._origin = Origin(context if isinstance(context, Source) else Source(context))

    @property
    def label(self) -> Source:
        """What errors call the spec: the file it was read from, and the like."""
        return self._origin.label

    @property
    def kind(self) -> Variant:
        """The record of its variant."""
        return VARIANTS[self.variant]

    @property
    def bypass_pairs(self) -> Any:
        """z_1 of the one direct law: pairs whose torque does not pass the control unit."""
        return self.kind.bypass(self.friction_group.pairs, self.friction_group.driving_pairs)

    @property
    def least_pairs(self) -> Any:
        """Smallest z with the bypass pairs it has."""
        return self.kind.least_pairs(self.friction_group.driving_pairs)

    @property
    def spring_parts(self) -> "dict[str, springs.DiscStack | springs.CoilSprings]":
        """The parts that the springs are, where they are named: closing, control."""
        own = {"closing": self.closing_spring, "control": self.control_spring}
        return {name: spring.part for name, spring in own.items() if spring is not None and spring.part is not None}
