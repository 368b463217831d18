"""What a clutch is: the pydantic models of a spec (contract, Spec). SI inside."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from datetime import date
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import (
    BeforeValidator,
    Field,
    GetPydanticSchema,
    ModelWrapValidatorHandler,
    PrivateAttr,
    ValidationError,
    field_validator,
    model_validator,
)
from pydantic_core import PydanticKnownError, core_schema

from ..messages import say
from ..variants import VARIANTS, Variant
from . import rules
from .drive import Drive, Heat
from .fields import (
    AtLeastOne,
    Block,
    Broken,
    Coefficient,
    Count,
    Force,
    Gap,
    Length,
    Name,
    Quantity,
    Ratio,
    RuledBlock,
    Stress,
    Temperature,
    TimeOrNone,
    Torque,
    TorqueOrNone,
    WallAngle,
    key,
    required,
    rule_error,
)
from .source import Source
from .springs import ClosingSpring, CoilSprings, ControlSpring, DiscStack
from .tolerance import Tolerance, in_si

SectionModulus = Annotated[float, Quantity("m^3", gt=0)]
PoissonRatio = Annotated[float, Quantity("1", ge=0, le=0.5)]
Probability = Annotated[float, Quantity("1", gt=0, lt=1)]
SpecificWork = Annotated[float, Quantity("J/m^2", gt=0)]
Slope = Annotated[float, Quantity("1/m", ge=0)]
SlidingSpeed = Annotated[float, Quantity("m/s", gt=0)]
Mass = Annotated[float, Quantity("kg", ge=0)]


def _registered(value: object) -> object:
    if isinstance(value, str) and value in VARIANTS:
        return value
    *names, last = map(repr, VARIANTS)
    raise PydanticKnownError("literal_error", {"expected": f"{', '.join(names)} or {last}"})


VariantName = Annotated[
    str,
    GetPydanticSchema(
        lambda source, handler: core_schema.no_info_plain_validator_function(_registered),
        lambda core, handler: {"enum": list(VARIANTS), "type": "string"},
    ),
]
"""Whichever variants there are records of when a spec is read or described."""
Method = Literal["min-friction", "mean-friction"]
PocketShape = Literal["constant-torque"]
Profiled = Literal["one", "both"]
RadiusModel = Literal["uniform-wear", "uniform-pressure"]


class Range(NamedTuple):
    """Coefficient of friction over a clutch's service: smallest, mean, largest."""

    min: float
    mean: float
    max: float


class FrictionRange(RuledBlock):
    """Friction of one group of pairs: a range, or a material of the catalogue."""

    min: Coefficient | None = key("smallest coefficient of friction", "f_min")
    mean: Coefficient | None = key("mean coefficient of friction; default (min + max)/2", "f_cp")
    max: Coefficient | None = key("largest coefficient of friction", "f_max")
    material: str | None = key("name of a friction material of the catalogue")

    def broken_rules(self) -> Iterable[Broken]:
        """Nothing beside a material; min ≤ mean ≤ max as far as given."""
        low, mean, high = self.min, self.mean, self.max
        if self.material is not None:
            from . import catalogues

            yield from catalogues.broken_rules(self.material, {"min": low, "mean": mean, "max": high})
        elif low is not None and high is not None and low > high:
            yield "max", say("must not be below min ({low:g})", low=low)
        elif mean is not None and low is not None and mean < low:
            yield "mean", say("must not be below min ({low:g})", low=low)
        elif mean is not None and high is not None and mean > high:
            yield "mean", say("must not be above max ({high:g})", high=high)

    @property
    def range(self) -> Range:
        """The three coefficients, with the material looked up and the mean filled in."""
        low, mean, high = self.min, self.mean, self.max
        if self.material is not None:
            from .catalogues import friction_materials

            material = friction_materials()[self.material]
            low, high = material.friction_min, material.friction_max
        if low is None or high is None:
            raise ValueError(say("no range here: friction is given per group"))
        return Range(low, (low + high) / 2 if mean is None else mean, high)


class Friction(FrictionRange):
    """Friction of all pairs, or of the driving and the driven group apart (differentiated only)."""

    driving: FrictionRange | None = key("friction of the driving (bypass) pairs", "f_1")
    driven: FrictionRange | None = key("friction of the driven (controlled) pairs", "f_2")
    static_ratio: AtLeastOne | None = key("static over sliding friction; default 1", "r_s")
    stribeck_speed: SlidingSpeed | None = key("sliding speed in which static friction decays", "v_s")

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
        return {f"{path}.material": block.material for path, block in blocks.items() if block and block.material}


class FrictionGroup(RuledBlock):
    """The pack of friction discs."""

    pairs: Count = required("number of friction pairs, all groups", "z")
    driving_pairs: Count | None = key("pairs that bypass the control unit; default 1 (differentiated only)", "z_1")
    mean_radius: Length | None = key("mean friction radius", "R_cp")
    inner_radius: Length | None = key("inner radius of the friction surface", "r_i")
    outer_radius: Length | None = key("outer radius of the friction surface", "r_o")
    radius_model: RadiusModel | None = key("how the mean radius follows from the two; default uniform-wear")
    spline_friction: Ratio | None = key("friction of the discs in their splines (effects only)", "μ_s")
    inner_spline_radius: Length | None = key("radius of the inner discs' splines (effects only)", "r_si")
    outer_spline_radius: Length | None = key("radius of the outer discs' splines (effects only)", "r_so")

    def broken_rules(self) -> Iterable[Broken]:
        """The outer radius is the greater one."""
        inner, outer = self.inner_radius, self.outer_radius
        if inner is not None and outer is not None and inner >= outer:
            yield "outer_radius", say("must be greater than friction_group.inner_radius ({inner:g} m)", inner=inner)


class Contact(Block):
    """Elastic data of ball and pocket wall, for a Hertz check beside or instead of an allowable force."""

    ball_modulus: Stress = required("Young's modulus of the ball", "E_1")
    ball_poisson: PoissonRatio = required("Poisson's ratio of the ball", "ν_1")
    wall_modulus: Stress = required("Young's modulus of the pocket wall", "E_2")
    wall_poisson: PoissonRatio = required("Poisson's ratio of the pocket wall", "ν_2")
    allowable_pressure: Stress = required("allowable maximum contact pressure", "[p_0]")


HARDENED_STEEL = Contact.model_construct(
    ball_modulus=206e9, ball_poisson=0.3, wall_modulus=206e9, wall_poisson=0.3, allowable_pressure=4.2e9
)
"""Assumed where neither [control_unit.contact] nor an allowable force is given; 4200 MPa: static limit of ball bearings
(ISO 76, self-aligning ball bearings 4600, other ball bearings 4200 MPa)."""


class ControlUnit(Block):
    """Balls in pockets with inclined walls."""

    gain: Ratio | None = key("feedback gain", "C")
    gain_slope: Slope | None = key(
        "how the gain grows with the sleeve's travel, pockets with a curved wall (indirect only); default 0", "C_1"
    )
    pocket: PocketShape | None = key(
        "constant-torque: the curved wall that holds the torque, instead of gain_slope (indirect only)"
    )
    profiled: Profiled | None = key("sleeves with the curved wall (indirect only); default one")
    ball_circle_radius: Length | None = key("radius of the ball circle", "r")
    wall_angle: WallAngle | None = key("wall angle of the pockets, from the axis", "α")
    balls: Count | None = key("number of balls", "n")
    hub_diameter: Length | None = key("hub diameter at the key (indirect only)", "d")
    key_friction: Ratio | None = key("friction coefficient at the key (indirect only)", "f_1")
    sleeve_mass: Mass | None = key("mass of the thrust sleeve; default 0 (indirect only)", "m")
    release_lag: TimeOrNone | None = key("time by which the normal force lags the load; default 0", "τ")
    face_gap: Gap | None = key("gap between the faces of the pockets", "s")
    edge_clearance: Gap | None = key("clearance of the contact from the pocket's edge", "y")
    allowable_contact_force: Force | None = key("allowable normal force on one ball", "[F_n]")
    ball_diameter: Length | None = key("ball chosen; synthesize takes it instead of the next standard one", "d_ш")
    sleeve_depth: Length | None = key("thickness, along the axis, of the sleeve the pockets are cut into", "B")
    wall_friction: Ratio | None = key("friction of cams that slide on the walls, balls do not (effects only)", "μ")
    contact: Contact | None = None

    @property
    def elasticity(self) -> Contact:
        """Elastic data of ball and wall: as given, or assumed."""
        return self.contact or HARDENED_STEEL


class Adjustment(Block):
    """How the spring is set."""

    method: Method = key("friction at which the nominal torque is set", default="min-friction")
    margin: AtLeastOne = key("torque margin", "β_н", default=1.0)
    nominal_torque: Torque | None = key("nominal torque of the clutch; gives the spring force where absent", "T_н")


class Fatigue(Block):
    """The part whose life is asked for."""

    endurance_limit: Stress = required("endurance limit in shear", "τ_limb")
    polar_section_modulus: SectionModulus = required("polar section modulus", "W_p")
    exponent: Coefficient = required("exponent of the S-N line", "m_τ")
    mean_stress_sensitivity: Ratio | None = key("sensitivity to the mean stress (model amplitude)", "ψ_τ")
    ultimate_strength: Stress | None = key("ultimate strength in shear (model goodman)", "τ_u")
    base_cycles: Coefficient = required("base cycles of the S-N line", "N_0")
    load_low: TorqueOrNone = key(
        "torque from which a slip swings the load and to which it falls back (amplitude, goodman)", "T_low", default=0.0
    )


class Required(RuledBlock):
    """What a clutch is to hold; each key is a row of ``check`` and of the report."""

    nominal_torque: Torque | None = key("nominal torque of the clutch, at least", "T_н")
    machine_torque: Torque | None = key(
        "nominal torque of the machine, at least: the clutch's over the margin", "T_н.маш"
    )
    accuracy_factor: AtLeastOne | None = key("accuracy factor, at most", "K_т")
    accuracy_factor_hysteresis: AtLeastOne | None = key("accuracy factor under a load that lasts, at most", "K_т,h")
    torque_max: Torque | None = key("largest sustained torque, at most", "T_max")
    outer_diameter: Length | None = key("outer diameter of the friction faces, at most", "2 r_o")
    surface_pressure: Stress | None = key("mean surface pressure at rest, at most; needs both radii", "p")
    travel: Length | None = key("largest travel of the sleeve, at most (indirect)", "x_max")
    reduced_gain: Ratio | None = key("reduced gain, at most", "z_2 C")
    peak_torque: Torque | None = key("peak torque in the shaft, at most (simulate)", "T_peak")
    exceedance: Probability | None = key("probability that the torque exceeds T_max, at most (tolerance)", "P(T>T_max)")
    work: SpecificWork | None = key("specific work of a trip, at most (heat)", "q_A")
    temperature: Temperature | None = key("mean temperature of the discs after one trip, at most (heat)", "Θ")
    face_temperature: Temperature | None = key("largest temperature of the faces in one trip, at most (heat)", "Θ_s")
    contact_pressure: Stress | None = key("largest contact pressure of ball and wall, at most (synthesize)", "p_0")
    cycles: Coefficient | None = key("life in cycles on either side of the clutch, at least", "N_ц")

    def broken_rules(self) -> Iterable[Broken]:
        """A probability is one of a torque."""
        if self.exceedance is not None and self.torque_max is None:
            yield "torque_max", say("required beside {other}", other="requirements.exceedance")


def _as_text(value: object) -> object:
    """A revision 2 and a TOML date need no quotes."""
    if isinstance(value, date):
        return value.isoformat()
    return str(value) if isinstance(value, int) and not isinstance(value, bool) else value


Entry = Annotated[Name, BeforeValidator(_as_text)]


class TitleBlock(Block):
    """What stands in the title block of a report; each is text."""

    project: Entry | None = key("project the clutch belongs to")
    drawing: Entry | None = key("number of the drawing")
    revision: Entry | None = key("revision of the calculation")
    author: Entry | None = key("who calculated")
    checked: Entry | None = key("who checked")
    norm_control: Entry | None = key("who checked it against the standards")
    approved: Entry | None = key("who approved")
    date: Entry | None = key("date of the calculation")
    organisation: Entry | None = key("who answers for the calculation")


@dataclass(frozen=True)
class Origin:
    """Where a spec was read from; specs that say the same are equal wherever that was."""

    label: Source = field(compare=False)


class Spec(Block):
    """A clutch, as a spec file describes it."""

    name: Name | None = key("what the clutch is called")
    variant: VariantName = required("how the clutch regulates")
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
        broken = rules.broken_rules(data) if isinstance(data, dict) else []
        try:
            spec = handler(data)
        except ValidationError as error:
            raise rule_error(broken, error) from None
        if broken:
            raise rule_error(broken)
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
    def spring_parts(self) -> dict[str, DiscStack | CoilSprings]:
        """The parts that the springs are, where they are named: closing, control."""
        springs = {"closing": self.closing_spring, "control": self.control_spring}
        return {name: spring.part for name, spring in springs.items() if spring and spring.part}
