"""What a clutch is: the pydantic models of a spec (contract, Spec). SI inside."""

from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple, TypeAlias

from pydantic import BaseModel, ConfigDict, Field, ModelWrapValidatorHandler, ValidationError, model_validator
from pydantic_core import PydanticKnownError, core_schema

from ..variants import VARIANTS, Variant
from . import rules
from .fields import (
    AtLeastOne,
    Coefficient,
    Count,
    Force,
    Gap,
    Length,
    Name,
    PoissonRatio,
    Ratio,
    SectionModulus,
    Stiffness,
    StiffnessOrNone,
    Stress,
    Torque,
    WallAngle,
)


class _Registered:
    """Type of a field that names a variant: whichever records there are when a spec is read or described."""

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        """Take a name there is a record of."""
        return core_schema.no_info_plain_validator_function(_registered)

    def __get_pydantic_json_schema__(self, core: Any, handler: Any) -> Any:
        """List the names."""
        return {"enum": list(VARIANTS), "type": "string"}


def _registered(value: object) -> object:
    if isinstance(value, str) and value in VARIANTS:
        return value
    *names, last = map(repr, VARIANTS)
    raise PydanticKnownError("literal_error", {"expected": f"{', '.join(names)} or {last}"})


if TYPE_CHECKING:
    VariantName: TypeAlias = str
else:
    VariantName = Annotated[str, _Registered()]
Method = Literal["min-friction", "mean-friction"]
RadiusModel = Literal["uniform-wear", "uniform-pressure"]


class Range(NamedTuple):
    """Coefficient of friction over a clutch's service: smallest, mean, largest."""

    min: Any
    mean: Any
    max: Any


def key_field(description: str, symbol: str | None = None, default: Any = None) -> Any:
    """A spec key: its default, what it is and the papers' symbol."""
    return Field(default=default, description=description, json_schema_extra={"symbol": symbol} if symbol else None)


class Block(BaseModel):
    """Base of every table of a spec."""

    # only Spec is ever built on its own: building each block too would double the start-up time
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, defer_build=True)


class FrictionRange(Block):
    """Friction of one group of pairs: a range, or a material of the catalogue."""

    min: Coefficient | None = key_field("smallest coefficient of friction", "f_min")
    mean: Coefficient | None = key_field("mean coefficient of friction; default (min + max)/2", "f_cp")
    max: Coefficient | None = key_field("largest coefficient of friction", "f_max")
    material: str | None = key_field("name of a friction material of the catalogue")

    @model_validator(mode="after")
    def _check_range(self) -> "FrictionRange":
        problems = list(self._range_problems())
        if problems:
            raise rules.validation_error(type(self).__name__, problems)
        return self

    def _range_problems(self) -> list[rules.Finding]:
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
            raise ValueError("no range here: friction is given per group")
        return Range(low, (low + high) / 2 if mean is None else mean, high)


class Friction(FrictionRange):
    """Friction of all pairs, or of the driving and the driven group apart (differentiated only)."""

    driving: FrictionRange | None = key_field("friction of the driving (bypass) pairs", "f_1")
    driven: FrictionRange | None = key_field("friction of the driven (controlled) pairs", "f_2")

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

    @model_validator(mode="after")
    def _check_radii(self) -> "FrictionGroup":
        if self.inner_radius is not None and self.outer_radius is not None and self.inner_radius >= self.outer_radius:
            message = f"must be greater than friction_group.inner_radius ({self.inner_radius:g} m)"
            raise rules.validation_error("FrictionGroup", [(("outer_radius",), self.outer_radius, message)])
        return self


class ClosingSpring(Block):
    """The spring that presses the pack (13 in S21)."""

    force: Force | None = key_field("closing-spring force as set", "F_п")
    stiffness: Stiffness | None = key_field("stiffness of the closing spring (indirect only)", "c_1")


class ControlSpring(Block):
    """The spring that holds the thrust sleeve at its stop (11 in S21)."""

    stiffness: StiffnessOrNone = Field(
        description="stiffness of the control spring", json_schema_extra={"symbol": "c_2"}
    )
    force: Force | None = key_field(
        "control-spring force as made; default so that the sleeve just rests at T_н", "F_п2"
    )


class Contact(Block):
    """Elastic data of ball and pocket wall, for a Hertz check where no allowable force is given."""

    ball_modulus: Stress = Field(description="Young's modulus of the ball", json_schema_extra={"symbol": "E_1"})
    ball_poisson: PoissonRatio = Field(description="Poisson's ratio of the ball", json_schema_extra={"symbol": "ν_1"})
    wall_modulus: Stress = Field(description="Young's modulus of the pocket wall", json_schema_extra={"symbol": "E_2"})
    wall_poisson: PoissonRatio = Field(
        description="Poisson's ratio of the pocket wall", json_schema_extra={"symbol": "ν_2"}
    )
    allowable_pressure: Stress = Field(
        description="allowable maximum contact pressure", json_schema_extra={"symbol": "[p_0]"}
    )


class ControlUnit(Block):
    """Balls in pockets with inclined walls."""

    gain: Ratio | None = key_field("feedback gain", "C")
    ball_circle_radius: Length | None = key_field("radius of the ball circle", "r")
    wall_angle: WallAngle | None = key_field("wall angle of the pockets, from the axis", "α")
    balls: Count | None = key_field("number of balls", "n")
    hub_diameter: Length | None = key_field("hub diameter at the key (indirect only)", "d")
    key_friction: Ratio | None = key_field("friction coefficient at the key (indirect only)", "f_1")
    face_gap: Gap | None = key_field("gap between the faces of the pockets", "s")
    edge_clearance: Gap | None = key_field("clearance of the contact from the pocket's edge", "y")
    allowable_contact_force: Force | None = key_field("allowable normal force on one ball", "[F_n]")
    ball_diameter: Length | None = key_field(
        "ball chosen; synthesize takes it instead of the next standard one", "2 r_ш"
    )
    contact: Contact | None = None


class Adjustment(Block):
    """How the spring is set."""

    method: Method = key_field("friction at which the nominal torque is set", default="min-friction")
    margin: AtLeastOne = key_field("torque margin", "β_н", default=1.0)
    nominal_torque: Torque | None = key_field("nominal torque; gives the spring force when that is absent", "T_н")


class Drive(Block):
    """The drive around the clutch."""

    dynamic_factor: Coefficient = key_field("dynamic factor of the unprotected side", "k_д", default=1.0)


class Fatigue(Block):
    """The part whose life is asked for."""

    endurance_limit: Stress = Field(description="endurance limit in shear", json_schema_extra={"symbol": "τ_limb"})
    polar_section_modulus: SectionModulus = Field(
        description="polar section modulus", json_schema_extra={"symbol": "W_p"}
    )
    exponent: Coefficient = Field(description="exponent of the S-N line", json_schema_extra={"symbol": "m_τ"})
    mean_stress_sensitivity: Ratio | None = key_field("sensitivity to the mean stress (model amplitude)", "ψ_τ")
    ultimate_strength: Stress | None = key_field("ultimate strength in shear (model goodman)", "τ_u")
    base_cycles: Coefficient = Field(description="base cycles of the S-N line", json_schema_extra={"symbol": "N_0"})


class Deferred:
    """A table whose model is imported only where a spec has it: few specs do, and the start-up is everybody's."""

    def __init__(self, module: str, name: str) -> None:
        """Note the module of this package and the class."""
        self.module, self.name = module, name

    def model(self) -> type[BaseModel]:
        """The model of the table."""
        from importlib import import_module

        found: type[BaseModel] = getattr(import_module(f".{self.module}", __package__), self.name)
        return found

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        """Validate by the model, once there is something to validate."""
        from pydantic_core import core_schema

        def read(value: Any) -> Any:
            model = self.model()
            return value if value is None or isinstance(value, model) else model.model_validate(value)

        return core_schema.no_info_plain_validator_function(read)

    def __get_pydantic_json_schema__(self, core: Any, handler: Any) -> Any:
        """Describe the table as its model does."""
        model = self.model()
        model.model_rebuild()
        return handler(model.__pydantic_core_schema__)


class Spec(Block):
    """A clutch, as a spec file describes it."""

    name: Name | None = key_field("what the clutch is called")
    variant: VariantName = Field(description="how the clutch regulates")
    friction: Friction
    friction_group: FrictionGroup
    closing_spring: ClosingSpring = ClosingSpring()
    control_spring: ControlSpring | None = None
    control_unit: ControlUnit | None = None
    adjustment: Adjustment = Adjustment()
    drive: Drive = Drive()
    fatigue: Fatigue | None = None
    tolerance: Annotated[Any, Deferred("tolerance", "Tolerance")] = None

    @model_validator(mode="wrap")
    @classmethod
    def _every_problem_at_once(cls, data: Any, handler: ModelWrapValidatorHandler["Spec"]) -> "Spec":
        """Report what the blocks find and what the rules between them find together."""
        problems = rules.problems(data) if isinstance(data, dict) else []
        try:
            spec = handler(data)
        except ValidationError as error:
            raise rules.validation_error("Spec", problems, error) from None
        if problems:
            raise rules.validation_error("Spec", problems)
        return spec

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
