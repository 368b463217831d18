"""Rules between the keys of a spec: exclusion, dependence, keys foreign to a variant."""

from collections.abc import Iterator, Mapping

from ..messages import filled, say
from ..variants import VARIANTS, foreign_keys, special_keys
from .fields import Broken
from .quantity import is_number

Table = Mapping[str, object]
"""Table of a spec as plain data."""

_TABLE = """\
give friction for all pairs or per group (friction.driving, friction.driven), not both
  - friction.min friction.mean friction.max friction.material | friction.driving |
  - friction.min friction.mean friction.max friction.material | friction.driven |
required beside {other}
  + friction.driven | friction.driving |
  + friction.driving | friction.driven |
required (or give material instead of min and max)
  + friction.driving.min friction.driving.max | friction.driving. | friction.driving.material
  + friction.driven.min friction.driven.max | friction.driven. | friction.driven.material
  + friction.min friction.max | friction. | friction.material friction.driving friction.driven
excludes friction_group.mean_radius: give mean_radius, or inner_radius and outer_radius
  - friction_group.inner_radius friction_group.outer_radius friction_group.radius_model | friction_group.mean_radius |
required beside {other}
  + friction_group.outer_radius | friction_group.inner_radius | friction_group.mean_radius
  + friction_group.inner_radius | friction_group.outer_radius | friction_group.mean_radius
required (or give inner_radius and outer_radius)
  + friction_group.mean_radius | friction_group. | friction_group.inner_radius friction_group.outer_radius
excludes control_unit.gain: give gain, or wall_angle and ball_circle_radius
  - control_unit.wall_angle | control_unit.gain |
required beside {other}
  + control_unit.ball_circle_radius | control_unit.wall_angle | control_unit.gain
required (or give wall_angle and ball_circle_radius)
  + control_unit.gain | control_unit. | control_unit.wall_angle
excludes control_unit.pocket: give the slope, or the pocket that it follows from
  - control_unit.gain_slope | control_unit.pocket |
required (or give adjustment.nominal_torque, which sets it)
  + closing_spring.force |  | adjustment.nominal_torque
required beside control_spring.force: both forces as made
  + closing_spring.force | control_spring.force adjustment.nominal_torque |
excludes drive.motor: give a constant torque, or the motor's curve
  - drive.motor_torque | drive.motor |
required beside {other}
  + drive.motor_inertia drive.shaft_stiffness | drive.event. |
  + drive.driven_inertia | drive.event. | envelope.
required beside [envelope]: both radii of the faces, instead of mean_radius
  + friction_group.inner_radius friction_group.outer_radius | envelope. |
required beside {other}
  + envelope.hub_diameter | envelope. | control_unit.hub_diameter
  + requirements.torque_max | requirements.exceedance |
  + heat.lining_density heat.lining_specific_heat | heat.lining_conductivity |
  + heat.lining_conductivity heat.lining_specific_heat | heat.lining_density | heat.lining_conductivity
  + heat.lining_conductivity heat.lining_density | heat.lining_specific_heat | heat.lining_conductivity
excludes {other}: it is the same hub
  - envelope.hub_diameter | control_unit.hub_diameter |
required beside {other}
  + drive.speed | drive.event. | drive.motor machine.
excludes [machine], whose plate gives it
  - requirements.machine_torque | machine. |
excludes [shaft], whose diameter gives it
  - fatigue.polar_section_modulus | shaft. |
required (or give shaft.diameter)
  + fatigue.polar_section_modulus | fatigue. | shaft.
has no effect beside {other}
  - tolerance.fields.closing_spring.stiffness | closing_spring.disc |
  - tolerance.fields.control_spring.stiffness | control_spring.disc |
required beside {other}
  + drive.tool_inertia | drive.event. drive.event.kind=load |
only with an event of kind load: a stopped tool moves as it is told
  - drive.tool_inertia | drive.event.kind=stop |
required for an event of kind stop
  + drive.event.stop_time | drive.event.kind=stop |
required for an event of kind load
  + drive.event.torque drive.event.rise_time | drive.event.kind=load |
only for an event of kind stop
  - drive.event.stop_time | drive.event.kind=load |
only for an event of kind load
  - drive.event.torque drive.event.rise_time | drive.event.kind=stop |
"""
"""Messages, each with its rules in the lines below: keys that are wrong (-) or missing (+) | keys that are all given |
keys of which no key is given; tables end in a dot. ``drive.event.kind=VALUE`` stands for an event of that kind."""


def _rules_of(table: str) -> Iterator[tuple[str, set[str], set[str], str, str]]:
    """Yield rules: key that is wrong or missing, keys all given, keys none of which is, message and its ``other``."""
    message = ""
    for line in table.splitlines():
        if line[0] != " ":
            message = line
            continue
        sign, *cells = line[2], *map(str.split, line[3:].split("|"))
        for key in cells[0]:
            given, absent = (cells[1], [key, *cells[2]]) if sign == "+" else ([key, *cells[1]], cells[2])
            yield key, {*given}, {*absent}, message, "".join(cells[1][:1]).rstrip(".")


KEY_RULES = (*_rules_of(_TABLE),)


def broken_rules(data: Table) -> list[Broken]:
    """Violations of the rules between keys; values are checked by the models."""
    given = given_in(data)
    keys = {*given, f"drive.event.kind={given.get('drive.event.kind')}"}
    of_keys = {
        (key, filled(message, {"other": other})): None
        for key, present, absent, message, other in KEY_RULES
        if keys >= present and keys.isdisjoint(absent)
    }
    return [*of_keys, *_variant(given), *_pairs(given)]


def given_in(data: Table, prefix: str = "") -> dict[str, object]:
    """Dotted path → value or table of a spec; tables also have a path with a final dot; None counts as absent."""
    given: dict[str, object] = {}
    for name, value in data.items():
        if value is not None:
            given[prefix + name] = value
            if isinstance(value, dict):
                given |= {f"{prefix}{name}.": value} | given_in(value, f"{prefix}{name}.")
    return given


def _variant(given: Table) -> Iterator[Broken]:
    name, ratio = given.get("variant"), given.get("friction.static_ratio")
    if is_number(ratio) and ratio > 1 and "friction.stribeck_speed" not in given:
        yield "friction.stribeck_speed", say("required beside {other}", other="friction.static_ratio")
    if not isinstance(name, str) or name not in VARIANTS:
        return
    for path in foreign_keys(given, name):
        only = ", ".join(special_keys()[path])
        yield path, say("not for variant {variant!r}; only for {only}", variant=name, only=only)
    for path in VARIANTS[name].needs + VARIANTS[name].requires:
        table = path.partition(".")[0]
        if path not in given and (table in (path, "closing_spring") or table in given):
            yield path, say("required for variant {variant!r}", variant=name)
    inertia_unknown = "drive.event." in given and given.keys().isdisjoint(("drive.hub_inertia", "envelope."))
    if VARIANTS[name].travels and inertia_unknown:
        yield "drive.hub_inertia", say("required beside {other}", other="drive.event")


def _pairs(given: Table) -> Iterator[Broken]:
    pairs, driving = given.get("friction_group.pairs"), given.get("friction_group.driving_pairs")
    if not is_number(pairs):
        return
    variant = VARIANTS.get(str(given.get("variant")))
    if is_number(driving) and not driving < pairs:
        yield "friction_group.driving_pairs", say("must be less than friction_group.pairs ({pairs})", pairs=pairs)
    elif driving is None and variant is not None and 1 <= pairs < (least := variant.least_pairs()):
        message = say(
            "must be at least {least} for variant {variant!r}: driving pairs {bypass}, driven pairs 1",
            least=least, variant=variant.name, bypass=least - 1,
        )  # fmt: skip
        yield "friction_group.pairs", message
