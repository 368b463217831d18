"""Selection of the laws of a clutch by its variant, adjustment method and given keys; its quantities from a spec."""

from collections.abc import Iterator, Mapping
from functools import cache
from types import ModuleType
from typing import Any, TypeAlias

from ..equations import (
    accuracy,
    adjustment,
    control_unit,
    curved,
    curved_wall,
    direct,
    indirect,
    life,
    machine,
    overload,
    pack,
    pressure,
    unlike,
)
from ..equations.arrays import along_path, is_array
from ..messages import say
from ..spec import Spec, make_spec
from ..spec.catalogues import balls
from ..variants import VARIANTS
from .quantities import Case, Laws, Quantities

Part: TypeAlias = ModuleType | Mapping[str, Any]

_EVERY: tuple[Part, ...] = (life, accuracy, adjustment, pressure, machine, pack)
_DIRECT: tuple[Part, ...] = (*_EVERY, direct, adjustment.DIRECT)
METHODS: dict[str, Part] = {"min-friction": pack.SET_AT_MIN, "mean-friction": pack.SET_AT_MEAN}
_METHODS_UNLIKE: dict[str, Part] = {"min-friction": unlike.SET_AT_MIN, "mean-friction": unlike.SET_AT_MEAN}

KEYS: dict[str, tuple[Part, ...]] = {
    "wall_angle": (pack.WALL_ANGLE_GIVEN,), "uniform-pressure": (pack.UNIFORM_PRESSURE,),
    "uniform-wear": (pressure.UNIFORM_WEAR,), "motor_power": (machine.GIVEN,),
    "breakdown_torque": (machine.BREAKDOWN_GIVEN,), "amplitude": (life.AMPLITUDE,),
    "goodman": (life.GOODMAN,), "event": (life.AFTER_EVENT,),
}  # fmt: skip
"""Given quantity or option of a spec → laws that it adds; for the laws of the sleeve see ``_sleeve``."""
RULES = ("amplitude", "goodman")
CURVED = ("gain_slope", "constant-torque")
DISCS = ("closing_disc", "control_disc")
_CHOOSING = {*KEYS, *CURVED, *DISCS, "control_force_made", "friction_driving_min"}


@cache
def laws_for(variant: str, method: str, keys: frozenset[str]) -> Laws:
    """Return the laws of a variant and an adjustment method; the given keys choose among alternatives."""
    unlike_materials = "friction_driving_min" in keys
    slips, slips_from_mean = {"friction": "friction_slips"}, life.FORECAST_OF_SLIPS
    kind = VARIANTS[variant]
    # a law in a later module replaces an earlier law of the same name
    if kind.travels:
        parts = [*_EVERY, control_unit, indirect]
    elif not kind.controlled:
        parts = [*_DIRECT, direct.CONVENTIONAL]
    else:
        bypass = kind.bypass(1, None)  # default of the variant, for any number of pairs
        part = direct.DIFFERENTIATED if bypass else direct.ALL_DRIVING
        parts = [*_DIRECT, control_unit, part, {"bypass_pairs": bypass}]
    parts.append(METHODS[method])
    if unlike_materials:
        parts += [accuracy.TURNING, unlike, _METHODS_UNLIKE[method]]
        slips = unlike.OF_SLIPS
        slips_from_mean = {"torque_high": "torque_max_from_mean", **unlike.OF_SLIPS_FROM_MEAN}
    else:
        parts.append(pack.ONE_FRICTION)
        if kind.overload and not kind.travels:
            parts.append(overload)
        if not kind.travels:
            parts.append(adjustment.DIRECT_ONE_MATERIAL)
    if kind.travels:
        parts += _sleeve(keys)
    parts += [part for key, chosen in KEYS.items() if key in keys for part in chosen]
    cases: dict[str, Case] = {"slips": slips}
    if not keys.isdisjoint(RULES):
        cases["forecast"] = slips_from_mean
    laws = Laws(*parts, cases=cases)
    laws.choice = variant, method, keys
    return laws


def _sleeve(keys: frozenset[str]) -> Iterator[Part]:
    """Modules with the laws of a sleeve between springs of any characteristic, behind straight or curved walls."""
    if "control_force_made" in keys:
        yield indirect.CONTROL_FORCE_MADE
    walls, discs = not keys.isdisjoint(CURVED), not keys.isdisjoint(DISCS)
    if walls:
        yield from (accuracy.TURNING, curved, curved_wall)
    elif not discs:
        yield indirect.STRAIGHT
    if discs:
        from . import curved_disc_balance, disc_balance

        yield from (disc_balance, disc_balance.NO_DISC)
        if walls:
            yield curved_disc_balance
    if "constant-torque" in keys:
        yield curved.CONSTANT_TORQUE


class Clutch(Quantities):
    """The quantities of a clutch, and the spec that gives them."""

    def __init__(self, spec: Spec, laws: Laws, given: Mapping[str, Any], *, noted: bool = False) -> None:
        """Start from the quantities that the spec gives; ``noted``: record the steps of the calculation."""
        super().__init__(laws, given, noted=noted)
        self.spec = spec

    def path(self, share: Any) -> tuple[Any, Any]:
        """Frictions f_1 and f_2 at a share (0…1) of their path: they rise together from minimum via mean to maximum."""
        first, second = self.spec.friction.groups
        if not self.spec.friction.unlike:
            return (first.min + share * (first.max - first.min),) * 2
        bend = self["bend_of_path"]
        one, two = (along_path(share, own.min, own.mean, own.max, bend) for own in (first, second))
        return one, two

    def at_friction(self, driving: Any, driven: Any) -> Quantities:
        """Quantities at given friction of driving and driven pairs; the same value twice if all pairs are alike."""
        if self.spec.friction.unlike or (not self.spec.kind.travels and driving is not driven):
            return self.at(friction_driving=driving, friction_driven=driven)
        return self.at(friction=driving)


def quantities_of(spec: Spec, *, noted: bool = False) -> Clutch:
    """Return the clutch of a spec.

    Args:
        spec: a valid spec, whose values may be arrays.
        noted: record the steps of the calculation.
    """
    found = given(spec)
    group, unit = spec.friction_group, spec.control_unit
    keys = {*found}
    if group.inner_radius is not None:
        keys.add(group.radius_model or "uniform-wear")
    if unit is not None and unit.pocket is not None:
        keys.add(unit.pocket)
    if spec.drive.event is not None and spec.drive.dynamic_factor is None:
        keys.add("event")
    laws = laws_for(spec.variant, spec.adjustment.method, frozenset(keys & _CHOOSING))
    return Clutch(spec, laws, found, noted=noted)


def by_rule(clutch: Clutch, rule: str) -> Clutch:
    """Return the clutch with a rule for the damaging stress: ``amplitude``, ``goodman``, else the mean stress."""
    variant, method, keys = clutch.laws.choice
    chosen = keys - {*RULES} | ({rule} & {*RULES})
    if chosen == keys:
        return clutch
    found = Clutch(clutch.spec, laws_for(variant, method, chosen), clutch.given)
    found.steps = clutch.steps
    return found


_NAMES = """\
friction          min=friction_min mean=friction_mean max=friction_max
friction.driving  min=friction_driving_min mean=friction_driving_mean max=friction_driving_max
friction.driven   min=friction_driven_min mean=friction_driven_mean max=friction_driven_max
friction_group    pairs driving_pairs=bypass_pairs mean_radius inner_radius outer_radius
closing_spring    force=closing_force stiffness=closing_stiffness
control_spring    force=control_force_made stiffness=control_stiffness
control_unit      gain gain_slope wall_angle ball_circle_radius hub_diameter key_friction balls face_gap edge_clearance
control_unit      static_safety ball_diameter=ball_diameter_standard allowable_contact_force sleeve_depth
control_unit.contact  ball_modulus ball_poisson wall_modulus wall_poisson
control_unit.contact  allowable_pressure=allowable_pressure_static
adjustment        margin nominal_torque=nominal_torque_wanted
machine           power=motor_power speed=motor_speed ratio=drive_ratio efficiency=drive_efficiency
machine           service_factor starting_torque_ratio
shaft             diameter=shaft_diameter yield_strength
drive             dynamic_factor
drive.motor       breakdown_torque
heat              lining
fatigue           endurance_limit polar_section_modulus exponent base_cycles mean_stress_sensitivity
fatigue           ultimate_strength
"""
NAMES: dict[str, dict[str, str]] = {}
"""Block of a spec → key → name of the quantity that the key gives; without = both names are the same."""
for _line in _NAMES.splitlines():
    _block, *_keys = _line.split()
    _named = (each.partition("=") for each in _keys)
    NAMES.setdefault(_block, {}).update({key: name or key for key, _, name in _named})


def given(spec: Spec) -> dict[str, Any]:
    """Return the quantities that a spec gives, by name."""
    found: dict[str, Any] = {}
    for path, names in NAMES.items():
        block: Any = spec
        for name in path.split("."):
            block = None if block is None else getattr(block, name)
        if block is not None:
            found |= {name: value for key, name in names.items() if (value := getattr(block, key)) is not None}
    for path, friction in spec.friction.blocks.items():  # smallest and largest friction of each material named
        names, (low, _, high) = NAMES[path], friction.range
        found |= {names["min"]: low, names["max"]: high}
    if "ball_circle_radius" in found:
        found["balls_listed"] = spec.lists.balls or balls()
    slope = found.get("gain_slope")
    if slope is not None and not (slope.any() if is_array(slope) else slope):
        del found["gain_slope"]  # a straight wall
    if "shaft_diameter" in found:
        found.pop("polar_section_modulus", None)
    for name, spring in (("closing_disc", spec.closing_spring), ("control_disc", spec.control_spring)):
        if spring is not None and spring.disc is not None:
            from .characteristics import DiscCharacteristic

            found[name] = DiscCharacteristic(spring.disc)
    return found


def as_set(clutch: Clutch, **values: Any) -> Clutch:
    """Return the clutch with other values of some quantities; its spring forces and gain slope stay as they are."""
    laws = clutch.laws
    kept = {name: clutch[name] for name in ("closing_force", "gain_slope") if name in clutch}
    if "control_force" in clutch:
        kept["control_force_made"] = clutch["control_force"]
        variant, method, keys = laws.choice
        laws = laws_for(variant, method, keys | {"control_force_made"})
    return Clutch(clutch.spec, laws, clutch.given | kept | values)


def build(spec: Spec | Mapping[str, Any]) -> Clutch:
    """Return the clutch of a validated spec, or of plain data of the same structure.

    Raises SpecError if the spec is invalid. Numbers (arrays become NaN) also raise it if the gain is below the
    threshold 2 R f_1/d, at which the sleeve leaves its stop without torque, or if no pocket wall holds the torque.
    """
    spec = spec if isinstance(spec, Spec) else make_spec(spec)
    clutch, unit = quantities_of(spec), spec.control_unit
    if not spec.kind.travels or unit is None or is_array(clutch["net_gain"]):
        return clutch
    if clutch["net_gain"] < 0:
        message = say(
            "must be at least 2 R f_1/d = {threshold:.6g}: below that the friction at the key exceeds the release "
            "force, and the sleeve leaves its stop at zero torque",
            threshold=float(clutch["gain_threshold"]),
        )
        gain = f"{float(clutch['gain']):.6g}"
        if unit.wall_angle is not None:
            raise spec.refused("control_unit.wall_angle", message, f"(C = {gain})")
        raise spec.refused("control_unit.gain", message, gain)
    leaving = clutch["friction_leaving"]
    if unit.pocket is not None and not is_array(leaving) and not leaving > 0:
        message = say(
            "no wall holds the torque: control_spring.force does not exceed the force of the closing spring, so "
            "that the sleeve never rests at its stop"
        )
        raise spec.refused("control_unit.pocket", message, repr(unit.pocket))
    return clutch
