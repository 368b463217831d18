"""Rules between the keys of a spec: what excludes what, what needs what, what a variant does not have."""

from collections.abc import Iterable, Iterator, Mapping
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
    given: tuple[str, ...]
    absent: tuple[str, ...]
    message: str
    """Template, which may name the first of ``given`` but the key as ``{other}``."""

    def said(self) -> str:
        """Message in the language of the user."""
        other = next((path.rstrip(".") for path in self.given if path != self.key), "")
        return filled(self.message, {"other": other})


def _wrong(key: str, message: str, *beside: str) -> KeyRule:
    return KeyRule(key, (key, *beside), (), message)


def _wanted(key: str, *beside: str, unless: tuple[str, ...] = (), message: str = "") -> KeyRule:
    return KeyRule(key, beside, (key, *unless), message or _BESIDE)


_ONE_FRICTION = deferred("give friction for all pairs or per group (friction.driving, friction.driven), not both")
_RANGE = deferred("required (or give material instead of min and max)")
_RADII = deferred("required (or give inner_radius and outer_radius)")
_WALL = deferred("required (or give wall_angle and ball_circle_radius)")
_BOTH_FORCES = deferred("required beside control_spring.force: both forces as made")
_ONE_RADIUS = deferred("excludes friction_group.mean_radius: give mean_radius, or inner_radius and outer_radius")
_ONE_MOTOR = deferred("excludes drive.motor: give a constant torque, or the motor's curve")
BY_PLATE = deferred("excludes [machine], whose plate gives it")
_ONE_SLOPE = deferred("excludes control_unit.pocket: give the slope, or the pocket that it follows from")
_MODULUS = "fatigue.polar_section_modulus"
_GROUPS = ("friction.driving", "friction.driven")
_MEAN, _INNER, _OUTER = (f"friction_group.{name}_radius" for name in ("mean", "inner", "outer"))
_GAIN, _ANGLE, _CIRCLE = "control_unit.gain", "control_unit.wall_angle", "control_unit.ball_circle_radius"
_SLOPE, _POCKET = "control_unit.gain_slope", "control_unit.pocket"
_HUB = "control_unit.hub_diameter"
_ENVELOPE = deferred("required beside [envelope]: both radii of the faces, instead of mean_radius")
_FORCE, _TORQUE = "closing_spring.force", "adjustment.nominal_torque"

_RULES = (
    *(
        _wrong(key, _ONE_FRICTION, group)
        for group in _GROUPS
        for key in ("friction.min", "friction.mean", "friction.max", "friction.material")
    ),
    _wanted("friction.driven", "friction.driving"),
    _wanted("friction.driving", "friction.driven"),
    *(
        _wanted(f"{block}.{end}", f"{block}.", unless=(f"{block}.material", *groups), message=_RANGE)
        for block, groups in (("friction.driving", ()), ("friction.driven", ()), ("friction", _GROUPS))
        for end in ("min", "max")
    ),
    *(_wrong(key, _ONE_RADIUS, _MEAN) for key in (_INNER, _OUTER, "friction_group.radius_model")),
    _wanted(_OUTER, _INNER, unless=(_MEAN,)),
    _wanted(_INNER, _OUTER, unless=(_MEAN,)),
    _wanted(_MEAN, "friction_group.", unless=(_INNER, _OUTER), message=_RADII),
    _wrong(_ANGLE, deferred("excludes control_unit.gain: give gain, or wall_angle and ball_circle_radius"), _GAIN),
    _wanted(_CIRCLE, _ANGLE, unless=(_GAIN,)),
    _wanted(_GAIN, "control_unit.", unless=(_ANGLE,), message=_WALL),
    _wrong(
        _SLOPE, deferred("excludes control_unit.pocket: give the slope, or the pocket that it follows from"), _POCKET
    ),
    _wanted(_FORCE, unless=(_TORQUE,), message=deferred("required (or give adjustment.nominal_torque, which sets it)")),
    _wanted(_FORCE, "control_spring.force", _TORQUE, message=_BOTH_FORCES),
    _wrong("drive.motor_torque", _ONE_MOTOR, "drive.motor"),
    *(_wanted(f"drive.{key}", "drive.event.") for key in ("motor_inertia", "shaft_stiffness")),
    _wanted("drive.driven_inertia", "drive.event.", unless=("envelope.",)),
    *(_wanted(key, "envelope.", message=_ENVELOPE) for key in (_INNER, _OUTER)),
    _wanted("envelope.hub_diameter", "envelope.", unless=(_HUB,)),
    _wrong("envelope.hub_diameter", deferred("excludes {other}: it is the same hub"), _HUB),
    _wanted("drive.speed", "drive.event.", unless=("drive.motor",)),
    _wrong("requirements.machine_torque", BY_PLATE, "machine."),
    _wrong(_MODULUS, deferred("excludes [shaft], whose diameter gives it"), "shaft."),
    _wanted(_MODULUS, "fatigue.", unless=("shaft.",), message=deferred("required (or give shaft.diameter)")),
    *(
        _wrong(
            f"tolerance.fields.{spring}.stiffness",
            deferred("has no effect beside {other}"),
            f"{spring}.disc",
        )
        for spring in ("closing_spring", "control_spring")
    ),
)
"""Rules that ask only whether keys are given."""


def broken_rules(data: Table) -> list[Broken]:
    """Rules between keys that ``data`` breaks; values themselves are the models' business."""
    given = given_in(data)
    variant = VARIANTS.get(str(given.get("variant")))
    of_event = _event(given, travels=variant is not None and variant.travels)
    return [*_broken(given, _RULES), *_static_friction(given), *_variant(given), *_pairs(given), *of_event]


def _broken(given: Table, rules: Iterable[KeyRule]) -> list[Broken]:
    keys = given.keys()
    wrong = ((rule.key, rule.said()) for rule in rules if keys >= set(rule.given) and keys.isdisjoint(rule.absent))
    return list(dict.fromkeys(wrong))


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
