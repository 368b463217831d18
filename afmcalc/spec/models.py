"""Pydantic models of a spec: the clutch and its surroundings. Values in SI."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from datetime import date
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Field,
    ModelWrapValidatorHandler,
    PrivateAttr,
    ValidationError,
    field_validator,
    model_validator,
)

from ..equations import springs
from ..errors import Problem, SpecError
from ..messages import did_you_mean, say
from ..variants import VARIANTS, Variant
from . import rules
from .catalogues import DiscSpring, Lists, Material, friction_materials, material_named
from .fields import (
    Block,
    Broken,
    Coefficient,
    Length,
    Name,
    RuledBlock,
    Stress,
    Torque,
    greater,
    key,
    required,
    rule_error,
)
from .parse import Source
from .quantity import Quantity, not_negative, positive
from .scatter import Tolerance, in_si
from .search import Search, axes_of

Ratio = Annotated[float, not_negative("1")]
AtLeastOne = Annotated[float, Quantity("1", ge=1)]
Count = Annotated[int, Quantity("1", ge=1, whole=True)]
Force = Annotated[float, positive("N")]
Gap = Annotated[float, not_negative("m")]
TorqueOrNone = Annotated[float, not_negative("N*m")]
Stiffness = Annotated[float, positive("N/m")]
WallAngle = Annotated[float, Quantity("rad", ge=0, lt=1.5707963267948966)]
Time = Annotated[float, positive("s")]
TimeOrNone = Annotated[float, not_negative("s")]
Temperature = Annotated[float, Quantity("K abs", ge=173.15)]
"""Temperature, K; 20 without a unit, which is meant in °C, is below the bound and thus an error."""
SectionModulus = Annotated[float, positive("m^3")]
PoissonRatio = Annotated[float, Quantity("1", ge=0, le=0.5)]
Probability = Annotated[float, Quantity("1", gt=0, lt=1)]
Mass = Annotated[float, not_negative("kg")]
Inertia = Annotated[float, positive("kg*m^2")]
Speed = Annotated[float, positive("rad/s")]
TorsionalStiffness = Annotated[float, positive("N*m/rad")]
Share = Annotated[float, Quantity("1", gt=0, le=1)]
Density = Annotated[float, positive("kg/m^3")]
SpecificHeat = Annotated[float, positive("J/kg/K")]
Conductivity = Annotated[float, positive("W/m/K")]
Cooling = Annotated[float, positive("W/K")]
EventKind = Literal["stop", "load"]


def _registered(name: str) -> str:
    if name in VARIANTS:
        return name
    known = ", ".join(VARIANTS)
    raise ValueError(say("must be one of {expected}{hint}", expected=known, hint=did_you_mean(name, VARIANTS)))


VariantName = Annotated[
    str, AfterValidator(_registered), Field(json_schema_extra=lambda schema: schema.update(enum=[*VARIANTS]))
]
"""Name of a variant, checked against ``VARIANTS`` when a spec is read or its schema is made."""


def _material_names(value: object) -> object:
    if isinstance(value, str) and value:
        return value
    names = tuple(value) if isinstance(value, list | tuple) else ()
    if not names or not all(isinstance(name, str) and name for name in names) or len({*names}) < len(names):
        raise ValueError(say("must be the name of a material in quotes, or a list of such names, each once"))
    return names


MaterialNames = Annotated[str | tuple[str, ...], BeforeValidator(_material_names)]
Method = Literal["min-friction", "mean-friction"]
PocketShape = Literal["constant-torque"]
RadiusModel = Literal["uniform-wear", "uniform-pressure"]


class Range(NamedTuple):
    """Smallest, mean and largest coefficient of friction in service."""

    min: float
    mean: float
    max: float


class FrictionRange(RuledBlock):
    """Friction of one group of pairs: a range, or a material of the catalogue."""

    min: Coefficient | None = key("smallest coefficient of friction", "f_min")
    mean: Coefficient | None = key("mean coefficient of friction; default (min + max)/2", "f_cp")
    max: Coefficient | None = key("largest coefficient of friction", "f_max")
    material: MaterialNames | None = key(
        "name of a friction material of the catalogue, or a list of them: a clutch is calculated with the worst"
    )

    _own: Mapping[str, Material] | None = PrivateAttr(default=None)

    def model_post_init(self, context: object) -> None:
        """Store the user's own list of materials that the file names."""
        self._own = context.lists.materials if isinstance(context, Source) and context.lists else None

    def broken_rules(self) -> Iterable[Broken]:
        """Yield the broken rules: a material is in the catalogue and excludes min, mean and max; min ≤ mean ≤ max."""
        low, mean, high = self.min or 0.0, self.mean, self.max or math.inf
        if self.material is not None:
            if missing := [name for name in self.material_names if name not in self.materials]:
                hint, listed = did_you_mean(missing[0], self._catalogue), ", ".join(self._catalogue)
                yield "material", say("unknown material{hint}; the catalogue has {listed}", hint=hint, listed=listed)
                return
            worst = self.lining
            message = say(
                "excludes material ({name!r} has {low:g}…{high:g}): give material, or min and max",
                name=worst.name, low=worst.friction_min, high=worst.friction_max,
            )  # fmt: skip
            yield from ((name, message) for name in ("min", "mean", "max") if getattr(self, name) is not None)
        elif low > high:
            yield "max", say("must not be below min ({low:g})", low=low)
        elif mean is not None and mean < low:
            yield "mean", say("must not be below min ({low:g})", low=low)
        elif mean is not None and mean > high:
            yield "mean", say("must not be above max ({high:g})", high=high)

    @property
    def material_names(self) -> tuple[str, ...]:
        """Names of the materials as given; empty if none."""
        return (self.material,) if isinstance(self.material, str) else self.material or ()

    @property
    def _catalogue(self) -> Mapping[str, Material]:
        return self._own or friction_materials()

    @property
    def materials(self) -> dict[str, Material]:
        """Materials by the names given; a name that the catalogue lacks is left out."""
        return {name: row for name in self.material_names if (row := material_named(name, self._catalogue))}

    @property
    def lining(self) -> Material:
        """Material; of several, the widest friction range and the lowest limits, None for a limit that none has."""
        first, *others = materials = [*self.materials.values()]
        if not others:
            return first
        least: dict[str, Any] = {}
        for name in ("friction_min", "pressure_min", "pressure_max", "temperature_min", "temperature_max"):
            values = (getattr(each, name) for each in materials)
            least[name] = min((value for value in values if value is not None), default=None)
        names, most = ", ".join(each.name for each in materials), max(each.friction_max for each in materials)
        return first.model_copy(update={"name": names, "friction_max": most, **least})

    @property
    def range(self) -> Range:
        """Smallest, mean and largest friction, as given or of the material; the default mean is the middle."""
        low, mean, high = self.min, self.mean, self.max
        if self.material is not None:
            low, high = self.lining.friction_min, self.lining.friction_max
        if low is None or high is None:
            raise ValueError(say("no range here: friction is given per group"))
        return Range(low, (low + high) / 2 if mean is None else mean, high)


class Friction(FrictionRange):
    """Friction of all pairs, or of the driving and the driven group apart (differentiated only)."""

    driving: FrictionRange | None = key("friction of the driving (bypass) pairs", "f_1")
    driven: FrictionRange | None = key("friction of the driven (controlled) pairs", "f_2")
    static_ratio: AtLeastOne | None = key("static over sliding friction; default 1", "r_s")
    stribeck_speed: Annotated[float, positive("m/s")] | None = key(
        "sliding speed over which static friction falls to sliding friction", "v_s"
    )

    def contradictions(self) -> Iterable[Broken]:
        """Yield the broken rules: the materials of a list must all be for dry faces, or all for faces in oil."""
        for path, block in self.blocks.items():
            if len({each.condition for each in block.materials.values()}) > 1:
                listed = ", ".join(f"{name}: {each.condition}" for name, each in block.materials.items())
                message = say("materials for dry faces and for oil contradict each other ({listed})", listed=listed)
                yield f"{path}.material", message

    @property
    def groups(self) -> tuple[Range, Range]:
        """Friction ranges of the driving and the driven pairs; equal if given for all pairs."""
        if self.driving is not None and self.driven is not None:
            return self.driving.range, self.driven.range
        return self.range, self.range

    @property
    def unlike(self) -> bool:
        """True if friction is given for each of the two groups of pairs."""
        return self.driving is not None

    @property
    def blocks(self) -> dict[str, FrictionRange]:
        """Blocks with a material, by path."""
        blocks = {"friction": self, "friction.driving": self.driving, "friction.driven": self.driven}
        return {path: block for path, block in blocks.items() if block and block.material}

    @property
    def linings(self) -> dict[str, Material]:
        """Path of a key ``material`` → the material, or the worst case of several that it lists."""
        return {f"{path}.material": block.lining for path, block in self.blocks.items()}


class FrictionGroup(RuledBlock):
    """The pack of friction discs."""

    pairs: Count = required("number of friction pairs, all groups", "z")
    driving_pairs: Count | None = key("pairs that bypass the control unit; default 1 (differentiated only)", "z_1")
    mean_radius: Length | None = key("mean friction radius", "R_cp")
    inner_radius: Length | None = key("inner radius of the friction surface", "r_i")
    outer_radius: Length | None = key("outer radius of the friction surface", "r_o")
    radius_model: RadiusModel | None = key("rule for the mean radius; default uniform-wear")
    spline_friction: Ratio | None = key("friction of the discs in their splines (effects only)", "μ_s")
    inner_spline_radius: Length | None = key("radius of the inner discs' splines (effects only)", "r_si")
    outer_spline_radius: Length | None = key("radius of the outer discs' splines (effects only)", "r_so")

    def broken_rules(self) -> Iterable[Broken]:
        """Yield the broken rule: the outer radius must exceed the inner radius."""
        return greater("outer_radius", self.outer_radius, "friction_group.inner_radius", self.inner_radius)


SHEAR_MODULUS = 81.5e9
"""Shear modulus of patented drawn wire (EN 13906-1), Pa."""
ROUNDED = 0.005
"""Relative deviation allowed between given and calculated stiffness: rounding to three figures."""


class Room(RuledBlock):
    """Room for a spring around the shaft."""

    inner_diameter: Gap | None = key("diameter of what the spring stands around", "D_1")
    outer_diameter: Length | None = key("diameter of what is around the spring", "D_2")
    length: Length | None = key("length available for the spring, as set and after wear", "L")

    def broken_rules(self) -> Iterable[Broken]:
        """Yield the broken rule: the outer diameter must exceed the inner diameter."""
        return greater("outer_diameter", self.outer_diameter, "inner_diameter", self.inner_diameter)


class DiscStack(DiscSpring):
    """A stack of disc springs, DIN EN 16983."""

    parallel: Count = key("discs nested in each other, in parallel", "n", default=1)
    series: Count = key("such packs against each other", "i", default=1)


class CoilSprings(RuledBlock):
    """Coil springs side by side, ends closed and ground."""

    wire_diameter: Length = required("diameter of the wire", "d")
    coil_diameter: Length = required("mean diameter of the coil", "D")
    turns: Annotated[float, Quantity("1", ge=2)] = required("active turns", "n")
    free_length: Length = required("length without load", "L_0")
    count: Count = key("springs around the shaft", "j", default=1)

    def broken_rules(self) -> Iterable[Broken]:
        """Yield the broken rules: a coil spring must be wider than its wire, and longer than at its minimum gaps."""
        wire, coil, turns = self.wire_diameter, self.coil_diameter, self.turns
        yield from greater("coil_diameter", coil, "wire_diameter", wire)
        least = float(springs.coil_solid_length(wire, turns) + springs.coil_least_gap(wire, coil, turns))
        if self.free_length <= least:
            message = say("must be greater than {least:.5g} m: pressed so far its turns all but touch", least=least)
            yield "free_length", message

    @property
    def rate(self) -> float:
        """Stiffness of all springs together, N/m."""
        one = springs.coil_stiffness(SHEAR_MODULUS, self.wire_diameter, self.coil_diameter, self.turns)
        return self.count * float(one)


class _Spring(RuledBlock):
    """Keys of the spring part and its room, which the closing spring and the control spring have in common."""

    room: Room | None = None
    disc: DiscStack | None = None
    coil: CoilSprings | None = None
    surface_friction: Ratio | None = key("friction of the cones of a disc stack on each other", "w_M")
    edge_friction: Ratio | None = key("friction of the edges of a disc stack", "w_R")
    thread_pitch: Length | None = key("pitch of the nut that sets the spring", "P_h")

    def broken_rules(self) -> Iterable[Broken]:
        """Yield the broken rules: a spring must not have both ``disc`` and ``coil``; a stiffness must fit ``coil``."""
        given, rate = getattr(self, "stiffness", None), self.coil and self.coil.rate
        if self.disc and self.coil:
            yield "coil", say("excludes disc: a spring is one or the other")
        elif rate and given is not None and abs(given / rate - 1) > ROUNDED:
            message = say("is not the stiffness of the coil named, {own:.5g} N/m: leave it out, or the coil", own=rate)
            yield "stiffness", message

    @property
    def part(self) -> DiscStack | CoilSprings | None:
        """Part of which the spring is made; None if the spec does not give the part."""
        return self.disc or self.coil


class ClosingSpring(_Spring):
    """The spring that presses the pack (13 in S21)."""

    force: Force | None = key("closing-spring force as set", "F_п")
    stiffness: Stiffness | None = key("stiffness of the closing spring; needed by an indirect clutch", "c_1")


class ControlSpring(_Spring):
    """The spring that holds the thrust sleeve at its stop (11 in S21)."""

    stiffness: Annotated[float, not_negative("N/m")] = required("stiffness of the control spring", "c_2")
    force: Force | None = key("control-spring force as made; default so that the sleeve just rests at T_н", "F_п2")


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
"""Default without [control_unit.contact] and allowable force; 4200 MPa: static limit of ball bearings
(ISO 76, self-aligning ball bearings 4600, other ball bearings 4200 MPa)."""


class PressureDiscKey(Block):
    """The key between hub and pressure disc (7 in S21); indirect only."""

    diameter: Length = required("diameter at the key of the pressure disc", "d_7")
    friction: Ratio = required("friction coefficient at that key", "f_7")


class ControlUnit(Block):
    """Balls in pockets with inclined walls."""

    gain: Ratio | None = key("feedback gain", "C")
    gain_slope: Annotated[float, not_negative("1/m")] | None = key(
        "how the gain grows with the sleeve's travel, pockets with a curved wall (indirect only); default 0", "C_1"
    )
    pocket: PocketShape | None = key(
        "wall of the pockets; constant-torque: curved so that the torque holds, instead of gain_slope (indirect only)"
    )
    ball_circle_radius: Length | None = key("radius of the ball circle", "r")
    wall_angle: WallAngle | None = key("wall angle of the pockets, from the axis", "α")
    balls: Count | None = key("number of balls", "n")
    hub_diameter: Length | None = key("hub diameter at the key (indirect only)", "d")
    key_friction: Ratio | None = key("friction coefficient at the key (indirect only)", "f_1")
    pressure_disc_key: PressureDiscKey | None = None
    sleeve_mass: Mass | None = key("mass of the thrust sleeve; default 0 (indirect only)", "m")
    release_lag: TimeOrNone | None = key("time by which the normal force lags the load; default 0", "τ")
    face_gap: Gap | None = key("gap between the faces of the pockets", "s")
    edge_clearance: Gap | None = key("clearance of the contact from the pocket's edge", "y")
    allowable_contact_force: Force | None = key("allowable normal force on one ball", "[F_n]")
    static_safety: AtLeastOne | None = key("static safety factor of the balls, 1.5 under shocks; default 1", "s_0")
    ball_diameter: Length | None = key("ball chosen; synthesize takes it instead of the next standard one", "d_ш")
    sleeve_depth: Length | None = key("thickness, along the axis, of the sleeve the pockets are cut into", "B")
    contact: Contact | None = None

    @property
    def elasticity(self) -> Contact:
        """Elastic data of ball and wall: as given, or hardened steel."""
        return self.contact or HARDENED_STEEL


class Adjustment(Block):
    """Setting of the spring."""

    method: Method = key("friction at which the nominal torque is set", default="min-friction")
    margin: AtLeastOne = key("torque margin", "β_н", default=1.0)
    nominal_torque: Torque | None = key(
        "nominal torque of the clutch; gives the spring force where that is not given", "T_н"
    )


class Motor(Block):
    """An induction motor by Kloss, M_1 = 2 M_b/(s/s_b + s_b/s)."""

    breakdown_torque: Torque = required("breakdown torque of the motor", "M_b")
    breakdown_slip: Share = required("slip at breakdown", "s_b")
    synchronous_speed: Speed = required("synchronous speed, reduced to the clutch", "ω_s")


class Event(Block):
    """Event at t = 0 that makes the clutch slip."""

    kind: EventKind = required(
        "what happens to the tool; stop: it is stopped in stop_time; load: its load rises to torque within rise_time"
    )
    stop_time: TimeOrNone | None = key("time in which the tool is stopped; 0 is a sudden lock", "t_b")
    torque: Torque | None = key(
        "load on the tool after the rise; it resists as friction does: it holds a stopped tool and does not turn it "
        "back, as the load of a hoist would",
        "M_L",
    )
    rise_time: TimeOrNone | None = key("time in which the load rises", "t_r")
    duration: Time | None = key("time that is simulated; default until nothing more can happen", "t_max")


class Drive(Block):
    """The drive around the clutch."""

    dynamic_factor: Coefficient | None = key(
        "dynamic factor of the unprotected side; default that of the event, 1 without one", "k_д"
    )
    speed: Speed | None = key(
        "speed before the event; default that of motor under load_torque, else that of [machine] at the clutch", "ω_0"
    )
    motor_inertia: Inertia | None = key("inertia of the motor side, driving half of the clutch included", "J_1")
    hub_inertia: Inertia | None = key("inertia between the discs and the balls (indirect only)", "J_h")
    driven_inertia: Inertia | None = key("inertia of the driven half of the clutch", "J_2")
    tool_inertia: Inertia | None = key("inertia of the tool (event of kind load)", "J_3")
    shaft_stiffness: TorsionalStiffness | None = key("torsional stiffness of the shaft between clutch and tool", "k")
    damping_ratio: Ratio | None = key("damping ratio of the driven half on the shaft; default 0", "ζ")
    load_torque: TorqueOrNone | None = key(
        "load before the event; default that of [machine] in rated running, else T_н.маш", "T_0"
    )
    motor_torque: TorqueOrNone | None = key("torque of the motor, constant; default load_torque", "M_1")
    motor: Motor | None = None
    cut_off: Time | None = key(
        "time from the first slip until the motor is switched off, the clutch slipping or stuck again; default never",
        "t_off",
    )
    event: Event | None = None


class Heat(Block):
    """Discs that take the heat, air that takes it from them, lining that is worn."""

    disc_mass: Annotated[float, positive("kg")] | None = key("mass of all discs that take the heat", "m")
    specific_heat: SpecificHeat | None = key("specific heat of the discs", "c_p")
    conductivity: Conductivity | None = key("thermal conductivity of the discs", "k_t")
    density: Density | None = key("density of the discs", "ρ")
    lining_conductivity: Conductivity | None = key(
        "thermal conductivity of the lining; absent: the discs take all the heat", "k_l"
    )
    lining_density: Density | None = key("density of the lining", "ρ_l")
    lining_specific_heat: SpecificHeat | None = key("specific heat of the lining", "c_l")
    ambient: Temperature | None = key("temperature around the clutch, and of the discs before a trip", "Θ_0")
    cooling: Cooling | None = key("heat given off per kelvin above the surroundings, α A_c", "α A_c")
    wear: Annotated[float, positive("m^3/J")] | None = key("volume of lining worn per energy", "w")
    lining: Length | None = key("thickness of lining that a pair may lose by wear", "s_w")


class Fatigue(Block):
    """The part whose life is asked for."""

    endurance_limit: Stress = required("endurance limit in shear", "τ_limb")
    polar_section_modulus: SectionModulus | None = key("polar section modulus; or shaft.diameter", "W_p")
    exponent: Coefficient = required("exponent of the S-N line", "m_τ")
    mean_stress_sensitivity: Ratio | None = key("sensitivity to the mean stress (model amplitude)", "ψ_τ")
    ultimate_strength: Stress | None = key("ultimate strength in shear (model goodman)", "τ_u")
    base_cycles: Coefficient = required("base cycles of the S-N line", "N_0")


class Envelope(RuledBlock):
    """The space a clutch is to fit into, and the thicknesses that decide whether it does."""

    outer_diameter: Length | None = key("outer diameter of the housing, at most", "D_h")
    length: Length | None = key("length of the clutch along the axis, at most", "L")
    bore: Length | None = key("bore of the hub; default shaft.diameter, without it none, a hub solid to the axis")
    hub_diameter: Length | None = key("outer diameter of the hub; of an indirect clutch control_unit.hub_diameter")
    disc_thickness: Length = required("thickness of a friction disc, lining included; a pack has one per pair")
    plate_thickness: Length = required(
        "thickness of thrust disc, pressure disc, flanges and web of the housing; the floor under a pocket"
    )
    housing_wall: Length = required("wall of the housing around the discs, and of what carries the inner ones")

    def broken_rules(self) -> Iterable[Broken]:
        """Yield the broken rules: the diameters must rise from bore to hub to housing."""
        yield from greater("hub_diameter", self.hub_diameter, "bore", self.bore)
        inside = "bore" if self.hub_diameter is None else "hub_diameter"
        yield from greater("outer_diameter", self.outer_diameter, inside, getattr(self, inside))


class Machine(Block):
    """The plate of the motor that drives the machine, and what is between it and the clutch."""

    power: Annotated[float, positive("W")] = required("rated power of the motor", "P_н")
    speed: Speed = required("rated speed of the motor", "ω_н")
    service_factor: AtLeastOne | None = key("service factor of the machine; default 1", "K_р")
    ratio: Coefficient = key("speed of the motor over that of the clutch", "i", default=1.0)
    efficiency: Share = key("efficiency between motor and clutch", "η", default=1.0)
    starting_torque_ratio: Coefficient | None = key(
        "largest torque of the motor at the start over its rated torque, where it is switched on directly", "m_п"
    )


class ProtectedShaft(Block):
    """The shaft that the clutch protects."""

    diameter: Length = required("diameter of the shaft", "d_в")
    yield_strength: Stress | None = key("yield strength of the shaft in tension", "σ_т")


def bore_of(source: Any) -> Any:
    """Bore of the hub, m, of a spec with an envelope: as given, else the shaft diameter, else 0."""
    bore = source.envelope.bore
    return bore if bore is not None else source.shaft.diameter if source.shaft else 0.0


def around_the_shaft(source: Any) -> Iterable[Broken]:
    """Yield the broken rules: the parts around the shaft must be wider than the shaft."""
    if (shaft := source.shaft) is None:
        return
    if (bore := source.envelope and source.envelope.bore) is not None and bore < shaft.diameter:
        yield "envelope.bore", say("must be at least shaft.diameter ({least:g} m)", least=shaft.diameter)
    for path in ("control_unit.hub_diameter", "envelope.hub_diameter", "envelope.outer_diameter"):
        block, _, name = path.partition(".")
        yield from greater(path, getattr(getattr(source, block), name, None), "shaft.diameter", shaft.diameter)


class TripRatio(RuledBlock):
    """Slip torque over the rated torque: that of the motor at the clutch, else the nominal torque of the machine."""

    min: AtLeastOne | None = key("least trip torque over the rated torque, at least", "k_min")
    max: AtLeastOne | None = key("largest trip torque over the rated torque, at most", "k_max")

    def broken_rules(self) -> Iterable[Broken]:
        """Yield the broken rule: min ≤ max."""
        if (low := self.min or 1.0) > (self.max or math.inf):
            yield "max", say("must not be below min ({low:g})", low=low)


class Required(Block):
    """Requirements; each key is a row of ``check`` and of the report, and a constraint of ``design``."""

    nominal_torque: Torque | None = key("nominal torque of the clutch, at least", "T_н")
    machine_torque: Torque | None = key(
        "nominal torque of the machine, at least: the clutch's over the margin", "T_н.маш"
    )
    accuracy_factor: AtLeastOne | None = key("accuracy factor, at most", "K_т")
    accuracy_factor_hysteresis: AtLeastOne | None = key("accuracy factor under a load that lasts, at most", "K_т,h")
    torque_max: Torque | None = key("largest sustained torque, at most", "T_max")
    trip_ratio: TripRatio | None = None
    outer_diameter: Length | None = key("outer diameter of the friction faces, at most", "2 r_o")
    surface_pressure: Stress | None = key("mean surface pressure at rest, at most; needs both radii", "p")
    closing_force: Force | None = key("force on the pack at rest, at most (F_п; indirect F_п2)", "N(0)")
    travel: Length | None = key("largest travel of the sleeve, at most (indirect)", "x_max")
    reduced_gain: Ratio | None = key("reduced gain, at most", "z_2 C")
    peak_torque: Torque | None = key("peak torque in the shaft, at most (simulate)", "T_peak")
    exceedance: Probability | None = key("probability that the torque exceeds T_max, at most (tolerance)", "P(T>T_max)")
    work: Annotated[float, positive("J/m^2")] | None = key("specific work of a trip, at most (heat)", "q_A")
    temperature: Temperature | None = key("mean temperature of the discs after one trip, at most (heat)", "Θ")
    face_temperature: Temperature | None = key("largest temperature of the faces in one trip, at most (heat)", "Θ_s")
    trips_per_hour: Coefficient | None = key(
        "trips per hour, mean temperature of the discs at its limit, at least (heat)", "ν_h"
    )
    contact_pressure: Stress | None = key("largest contact pressure of ball and wall, at most (synthesize)", "p_0")
    torque_after_wear: Torque | None = key(
        "least torque in service with the lining worn off, springs as set, at least (effects)", "T_w"
    )
    cycles: Coefficient | None = key("life in cycles on either side of the clutch, at least", "N_ц")


def _as_text(value: object) -> object:
    """Text of an entry; a whole number, such as a revision, and a TOML date need no quotes."""
    if isinstance(value, date):
        return value.isoformat()
    return str(value) if isinstance(value, int) and not isinstance(value, bool) else value


Entry = Annotated[Name, BeforeValidator(_as_text)]
SheetForm = Literal["calculation", "report"]


class TitleBlock(Block):
    """Entries of the title block of a report or a drawing; each is text."""

    project: Entry | None = key("project the clutch belongs to")
    drawing: Entry | None = key("number of the drawing")
    revision: Entry | None = key("revision of the calculation")
    author: Entry | None = key("who calculated")
    checked: Entry | None = key("who checked")
    norm_control: Entry | None = key("who checked it against the standards")
    approved: Entry | None = key("who approved")
    date: Entry | None = key("date of the calculation")
    organisation: Entry | None = key("who answers for the calculation")
    form: SheetForm | None = key(
        "sheets of the report: calculation (default; in Russian with frame and title block) or report (12 pt)"
    )


class ShopNotes(Block):
    """Notes of a drawing for the shop, beside its dimensions; each is text."""

    tolerance: Entry | None = key("limit deviations of the dimensions that show none, such as ±0.02 mm")
    roughness: Entry | None = key("roughness of the pocket walls, such as Ra 0.8")
    hardness: Entry | None = key("hardness of the pocket walls, such as 58…62 HRC")
    material: Entry | None = key("material of the sleeves with the pockets")


@dataclass(frozen=True)
class Origin:
    """Source of a spec, ignored in comparisons: specs with equal values are equal."""

    label: Source = field(compare=False)


class Catalogues(Block):
    """Lists of one's own in the place of those that ship; paths are relative to the file that names them."""

    materials: Name | None = key("friction materials, TOML or CSV with a source in every row")
    discs: Name | None = key("disc springs, TOML or CSV with a source in every row")
    balls: Name | None = key("ball diameters, TOML or CSV")


class Spec(Block):
    """A clutch, as a spec file describes it."""

    name: Name | None = key("what the clutch is called")
    variant: VariantName = required("how the clutch regulates")
    friction: Friction
    friction_group: FrictionGroup
    # with model_construct, because a validated default would build the validator of its block twice
    closing_spring: ClosingSpring = Field(default_factory=ClosingSpring.model_construct)
    control_spring: ControlSpring | None = None
    control_unit: ControlUnit | None = None
    adjustment: Adjustment = Field(default_factory=Adjustment.model_construct)
    machine: Machine | None = None
    drive: Drive = Field(default_factory=Drive.model_construct)
    shaft: ProtectedShaft | None = None
    fatigue: Fatigue | None = None
    heat: Heat | None = None
    tolerance: Tolerance | None = None
    envelope: Envelope | None = None
    requirements: Required | None = None
    catalogues: Catalogues | None = None
    report: TitleBlock | None = None
    drawing: ShopNotes | None = None
    objectives: tuple[str, ...] | None = key(
        'quantities that design makes small, or large ("-gain_limit"); default closing_force and accuracy_factor'
    )
    search: Search | None = key('keys that design varies, each with a list or "start:stop:count"; springs: from lists')

    _origin: Origin = PrivateAttr()

    @field_validator("search", mode="before")
    @classmethod
    def _axes(cls, given: object) -> object:
        return axes_of(given, cls) if isinstance(given, dict) else given

    @field_validator("tolerance")
    @classmethod
    def _scatter(cls, given: Tolerance | None) -> Tolerance | None:
        return given and in_si(given, cls)

    @model_validator(mode="wrap")
    @classmethod
    def _every_problem_at_once(cls, data: object, handler: ModelWrapValidatorHandler["Spec"]) -> "Spec":
        """Spec, or one error with all problems in its blocks and in the rules between them."""
        broken = rules.broken_rules(data) if isinstance(data, dict) else []
        try:
            spec = handler(data)
        except ValidationError as error:
            raise rule_error(broken, error) from None
        broken += spec.friction.contradictions()
        broken += around_the_shaft(spec)
        if broken:
            raise rule_error(broken)
        return spec

    @property
    def lists(self) -> Lists:
        """User's own lists of materials and parts that the spec names."""
        return self.label.lists or Lists()

    def model_post_init(self, context: object) -> None:
        """Remember the file that the spec was read from; "spec" if it is not known."""
        self._origin = Origin(context if isinstance(context, Source) else Source("spec"))

    @property
    def label(self) -> Source:
        """Name of the spec in errors, such as its file; it also carries the text of the spec."""
        return self._origin.label

    def refused(self, path: str, message: str, given: str | None = None) -> SpecError:
        """Error with a message about a key of the spec."""
        return self.label.refused([Problem(path, given, message)])

    @property
    def kind(self) -> Variant:
        """Record of the variant of the clutch."""
        return VARIANTS[self.variant]

    @property
    def speed(self) -> Any:
        """Speed ω_0 as given, else from rating plate and gear ratio; None if unknown or given by a motor's curve."""
        drive, plate = self.drive, self.machine
        if drive.speed is not None or drive.motor is not None or plate is None:
            return drive.speed
        return plate.speed / plate.ratio

    @property
    def runs_down(self) -> bool:
        """True if the spec gives the speed before a slip with blocked tool, and motor inertia or cut-off to end it."""
        ends = self.drive.motor_inertia is not None or self.drive.cut_off is not None
        return ends and self.drive.motor is None and self.speed is not None

    @property
    def bypass_pairs(self) -> Any:
        """Number z_1 of bypass pairs in the direct law: pairs whose torque does not pass the control unit."""
        return self.kind.bypass(self.friction_group.pairs, self.friction_group.driving_pairs)

    @property
    def least_pairs(self) -> Any:
        """Smallest possible number of pairs z with the given driving pairs."""
        return self.kind.least_pairs(self.friction_group.driving_pairs)

    @property
    def spring_parts(self) -> dict[str, DiscStack | CoilSprings]:
        """Name of a spring, ``closing`` or ``control`` → its part; a spring whose part is not given is left out."""
        both = {"closing": self.closing_spring, "control": self.control_spring}
        return {name: spring.part for name, spring in both.items() if spring and spring.part}


def resolved(spec: Spec) -> dict[str, Any]:
    """Spec as plain data, SI, with defaults filled in.

    Reading it again gives the same clutch. Values that follow from other keys (the mean of the friction range, the
    range of a material, the spring force from a nominal torque) are not filled in, so that they still follow when one
    of those keys is overridden.
    """
    data = spec.model_dump(exclude_none=True)
    group = data["friction_group"]
    if "friction_group.driving_pairs" in spec.kind.keys:
        group.setdefault("driving_pairs", spec.bypass_pairs)
    if "inner_radius" in group:
        group.setdefault("radius_model", "uniform-wear")
    return data
