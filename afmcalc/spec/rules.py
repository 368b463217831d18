"""Rules between the keys of a spec: what excludes what, what needs what, what a variant does not have."""

from collections.abc import Iterator, Mapping
from itertools import chain
from typing import TypeAlias, TypeGuard

from ..messages import say, say_many
from ..variants import VARIANTS
from .fields import Broken

Table: TypeAlias = Mapping[str, object]
"""A table of a spec as it was written."""


def broken_rules(data: Table) -> list[Broken]:
    """Rules between keys that ``data`` breaks; values themselves are the models' business."""
    given = given_in(data)
    every = (_friction, _radii, _gain, _pocket, _force, _variant, _pairs, _drive, _event, _discs)
    return [*chain.from_iterable(rule(given) for rule in every)]


def given_in(data: Table, prefix: str = "") -> dict[str, object]:
    """Every value and table of a spec by dotted path; what is None is not given."""
    given: dict[str, object] = {}
    for name, value in data.items():
        if value is not None:
            given[prefix + name] = value
            if isinstance(value, dict):
                given |= given_in(value, f"{prefix}{name}.")
    return given


def _is_table(given: Table, path: str) -> bool:
    return isinstance(given.get(path), dict)


def _beside(path: str, other: str) -> Broken:
    return path, say("required beside {other}", other=other)


def _friction(given: Table) -> Iterator[Broken]:
    groups = [path for path in ("friction.driving", "friction.driven") if path in given]
    for key in ("min", "mean", "max", "material") if groups else ():
        if (path := f"friction.{key}") in given:
            yield (
                path,
                say("give friction for all pairs or per group (friction.driving, friction.driven), not both"),
            )
    if len(groups) == 1:
        yield _beside("friction.driven" if groups == ["friction.driving"] else "friction.driving", groups[0])
    ratio = given.get("friction.static_ratio")
    if isinstance(ratio, int | float) and ratio > 1 and "friction.stribeck_speed" not in given:
        yield _beside("friction.stribeck_speed", "friction.static_ratio")
    for block in groups or ["friction"]:
        if _is_table(given, block) and f"{block}.material" not in given:
            for path in (f"{block}.min", f"{block}.max"):
                if path not in given:
                    yield path, say("required (or give material instead of min and max)")


def _radii(given: Table) -> Iterator[Broken]:
    inner, outer, mean, model = (
        f"friction_group.{name}" for name in ("inner_radius", "outer_radius", "mean_radius", "radius_model")
    )
    if mean in given:
        for path in (inner, outer, model):
            if path in given:
                yield (
                    path,
                    say("excludes friction_group.mean_radius: give mean_radius, or inner_radius and outer_radius"),
                )
    elif inner in given and outer not in given:
        yield _beside(outer, inner)
    elif outer in given and inner not in given:
        yield _beside(inner, outer)
    elif inner not in given and _is_table(given, "friction_group"):
        yield mean, say("required (or give inner_radius and outer_radius)")


def _gain(given: Table) -> Iterator[Broken]:
    gain, angle, radius = (f"control_unit.{name}" for name in ("gain", "wall_angle", "ball_circle_radius"))
    if gain in given and angle in given:
        yield angle, say("excludes control_unit.gain: give gain, or wall_angle and ball_circle_radius")
    elif angle in given and radius not in given:
        yield _beside(radius, angle)
    elif gain not in given and angle not in given and _is_table(given, "control_unit"):
        yield gain, say("required (or give wall_angle and ball_circle_radius)")


def _pocket(given: Table) -> Iterator[Broken]:
    slope, pocket, profiled = (f"control_unit.{name}" for name in ("gain_slope", "pocket", "profiled"))
    if slope in given and pocket in given:
        yield slope, say("excludes control_unit.pocket: give the slope, or the pocket that it follows from")
    if profiled in given and slope not in given and pocket not in given:
        yield profiled, say("is of a curved wall: give gain_slope or pocket with it")


def _force(given: Table) -> Iterator[Broken]:
    path = "closing_spring.force"
    if path not in given and "adjustment.nominal_torque" not in given:
        yield path, say("required (or give adjustment.nominal_torque, which sets it)")
    elif "control_spring.force" in given and path not in given:
        yield path, say("required beside control_spring.force: both forces as made")


def _special_keys() -> dict[str, tuple[str, ...]]:
    """Keys that only some variants have → those variants."""
    variants = VARIANTS.values()
    return {
        ".".join(key): tuple(variant.name for variant in variants if key in variant.keys)
        for variant in variants
        for key in variant.keys
    }


def variants_of(path: str) -> tuple[str, ...]:
    """Variants that have the key at a dotted path; empty when all have."""
    having = [variants for key, variants in _special_keys().items() if f"{path}.".startswith(f"{key}.")]
    return min(having, key=len) if having else ()


def foreign_keys(given: Table, variant: str) -> list[str]:
    """Paths that are given and that the variant does not have; a block stands for its keys."""
    foreign = [path for path in _special_keys() if path in given and not VARIANTS[variant].has(path)]
    return [path for path in foreign if "." not in path or path.partition(".")[0] not in foreign]


def _variant(given: Table) -> Iterator[Broken]:
    name = given.get("variant")
    if not isinstance(name, str) or name not in VARIANTS:
        return
    for path in foreign_keys(given, name):
        only = ", ".join(_special_keys()[path])
        yield path, say("not for variant {variant!r}; only for {only}", variant=name, only=only)
    for key in VARIANTS[name].needs + VARIANTS[name].requires:
        path = ".".join(key)
        if path not in given and (len(key) == 1 or key[0] in given or key[0] == "closing_spring"):
            yield path, say("required for variant {variant!r}", variant=name)


def _is_number(value: object) -> TypeGuard[float]:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _pairs(given: Table) -> Iterator[Broken]:
    pairs, driving = given.get("friction_group.pairs"), given.get("friction_group.driving_pairs")
    if not _is_number(pairs):
        return
    if _is_number(driving):
        if not driving < pairs:
            yield (
                "friction_group.driving_pairs",
                say("must be less than friction_group.pairs ({pairs})", pairs=pairs),
            )
        return
    variant = VARIANTS.get(str(given.get("variant")))
    if driving is None and variant is not None and 1 <= pairs < (least := variant.least_pairs()) > 1:
        default = say(" (the default)") if variant.chooses_bypass else ""
        bypass = say_many(
            "{count} driving pair{default}", "{count} driving pairs{default}", count=least - 1, default=default
        )
        message = say(
            "a {variant} clutch needs at least {least}: {bypass} and 1 driven",
            variant=variant.name,
            least=least,
            bypass=bypass,
        )
        yield "friction_group.pairs", message


def _drive(given: Table) -> Iterator[Broken]:
    if "drive.motor" in given and "drive.motor_torque" in given:
        yield "drive.motor_torque", say("excludes drive.motor: give a constant torque, or the motor's curve")


_OF_EVENT = {"stop": ("stop_time",), "load": ("torque", "rise_time")}
"""Kind of event → keys that it needs and no other kind has."""


def _event(given: Table) -> Iterator[Broken]:
    if not _is_table(given, "drive.event"):
        return
    kind, variant = given.get("drive.event.kind"), VARIANTS.get(str(given.get("variant")))
    needed = {
        "motor_inertia": True,
        "driven_inertia": True,
        "shaft_stiffness": True,
        "tool_inertia": kind == "load",
        "hub_inertia": variant is not None and variant.travels,
        "speed": "drive.motor" not in given,
    }
    for key, is_needed in needed.items():
        if is_needed and f"drive.{key}" not in given:
            yield _beside(f"drive.{key}", "drive.event")
    if kind == "stop" and "drive.tool_inertia" in given:
        yield "drive.tool_inertia", say("only with an event of kind load: a stopped tool moves as it is told")
    for other, keys in _OF_EVENT.items():
        for path in (f"drive.event.{key}" for key in keys):
            if other == kind and path not in given:
                yield path, say("required for an event of kind {kind}", kind=other)
            if other != kind and path in given and str(kind) in _OF_EVENT:
                yield path, say("only for an event of kind {kind}", kind=other)


def _discs(given: Table) -> Iterator[Broken]:
    """A stack of discs has no stiffness that scatters on its own."""
    for spring in ("closing_spring", "control_spring"):
        path = f"tolerance.fields.{spring}.stiffness"
        if path in given and f"{spring}.disc" in given:
            yield path, say("has no effect beside {spring}.disc", spring=spring)
