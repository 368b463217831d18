"""Rules between the keys of a spec: what excludes what, what needs what, what a variant does not have."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple, TypeAlias, TypeGuard

from ..messages import deferred, filled, say, say_many
from ..variants import VARIANTS, foreign_keys, special_keys
from .fields import Broken

Table: TypeAlias = Mapping[str, object]
"""A table of a spec as it was written."""


_BESIDE = deferred("required beside {other}")


class KeyRule(NamedTuple):
    """A key is wrong, or wanting, where some keys are given and others are not; ``friction.`` is a block, a table."""

    key: str
    given: frozenset[str]
    absent: frozenset[str]
    message: str
    """Template, which may name the first of ``given`` but the key as ``{other}``."""
    other: str


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
excludes {other}: it is the same hub
  - envelope.hub_diameter | control_unit.hub_diameter |
required beside {other}
  + drive.speed | drive.event. | drive.motor
excludes [machine], whose plate gives it
  - requirements.machine_torque | machine. |
excludes [shaft], whose diameter gives it
  - fatigue.polar_section_modulus | shaft. |
required (or give shaft.diameter)
  + fatigue.polar_section_modulus | fatigue. | shaft.
has no effect beside {other}
  - tolerance.fields.closing_spring.stiffness | closing_spring.disc |
  - tolerance.fields.control_spring.stiffness | control_spring.disc |
"""
"""Message, and below it: keys that are wrong (-) or wanting (+), keys given beside one, keys not given."""


def _rules_of(table: str) -> Iterator[KeyRule]:
    message = ""
    for line in table.splitlines():
        if line[0] != " ":
            message = line
            continue
        sign, *cells = line[2], *map(str.split, line[3:].split("|"))
        for key in cells[0]:
            given, absent = (cells[1], [key, *cells[2]]) if sign == "+" else ([key, *cells[1]], cells[2])
            yield KeyRule(key, frozenset(given), frozenset(absent), message, "".join(cells[1][:1]).rstrip("."))


KEY_RULES = (*_rules_of(_TABLE),)
"""Rules that ask only whether keys are given."""


def broken_rules(data: Table) -> list[Broken]:
    """Rules between keys that ``data`` breaks; values themselves are the models' business."""
    given = given_in(data)
    variant = VARIANTS.get(str(given.get("variant")))
    of_event = _event(given, travels=variant is not None and variant.travels)
    keys = given.keys()
    wrong = (rule for rule in KEY_RULES if keys >= rule.given and keys.isdisjoint(rule.absent))
    of_keys = {(rule.key, filled(rule.message, {"other": rule.other})): None for rule in wrong}
    return [*of_keys, *_static_friction(given), *_variant(given), *_pairs(given), *of_event]


def given_in(data: Table, prefix: str = "") -> dict[str, object]:
    """Every value and table of a spec by dotted path, a table also with a dot at its end; what is None is not given."""
    given: dict[str, object] = {}
    for name, value in data.items():
        if value is not None:
            given[prefix + name] = value
            if isinstance(value, dict):
                given |= {f"{prefix}{name}.": value} | given_in(value, f"{prefix}{name}.")
    return given


def _static_friction(given: Table) -> Iterator[Broken]:
    ratio = given.get("friction.static_ratio")
    if isinstance(ratio, int | float) and ratio > 1 and "friction.stribeck_speed" not in given:
        yield "friction.stribeck_speed", filled(_BESIDE, {"other": "friction.static_ratio"})


def _variant(given: Table) -> Iterator[Broken]:
    name = given.get("variant")
    if not isinstance(name, str) or name not in VARIANTS:
        return
    for path in foreign_keys(given, name):
        only = ", ".join(special_keys()[path])
        yield path, say("not for variant {variant!r}; only for {only}", variant=name, only=only)
    for path in VARIANTS[name].needs + VARIANTS[name].requires:
        table = path.partition(".")[0]
        if path not in given and (table in (path, "closing_spring") or table in given):
            yield path, say("required for variant {variant!r}", variant=name)


def _is_number(value: object) -> TypeGuard[float]:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _pairs(given: Table) -> Iterator[Broken]:
    pairs, driving = given.get("friction_group.pairs"), given.get("friction_group.driving_pairs")
    if not _is_number(pairs):
        return
    if _is_number(driving):
        if not driving < pairs:
            message = say("must be less than friction_group.pairs ({pairs})", pairs=pairs)
            yield "friction_group.driving_pairs", message
        return
    variant = VARIANTS.get(str(given.get("variant")))
    if driving is None and variant is not None and 1 <= pairs < (least := variant.least_pairs()) > 1:
        default = say(" (the default)") if variant.chooses_bypass else ""
        bypass = say_many(
            "{count} driving pair{default}", "{count} driving pairs{default}", count=least - 1, default=default
        )
        message = say(
            "a {variant} clutch needs at least {least}: {bypass} and 1 driven",
            variant=variant.name, least=least, bypass=bypass,
        )  # fmt: skip
        yield "friction_group.pairs", message


_OF_EVENT = {"stop": ("stop_time",), "load": ("torque", "rise_time")}
"""Kind of event → keys that it needs and no other kind has."""


def _event(given: Table, *, travels: bool) -> Iterator[Broken]:
    if "drive.event." not in given:
        return
    kind = given.get("drive.event.kind")
    if kind == "load" and "drive.tool_inertia" not in given:
        yield "drive.tool_inertia", filled(_BESIDE, {"other": "drive.event"})
    if travels and given.keys().isdisjoint(("drive.hub_inertia", "envelope.")):
        yield "drive.hub_inertia", filled(_BESIDE, {"other": "drive.event"})
    if kind == "stop" and "drive.tool_inertia" in given:
        yield "drive.tool_inertia", say("only with an event of kind load: a stopped tool moves as it is told")
    for other, keys in _OF_EVENT.items():
        for path in (f"drive.event.{key}" for key in keys):
            if other == kind and path not in given:
                yield path, say("required for an event of kind {kind}", kind=other)
            if other != kind and path in given and str(kind) in _OF_EVENT:
                yield path, say("only for an event of kind {kind}", kind=other)
