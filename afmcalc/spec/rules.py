"""Rules between the keys of a spec: what excludes what, what needs what, what a variant does not have."""

from collections.abc import Iterable, Mapping
from typing import TypeAlias, TypeGuard

from pydantic import ValidationError

from ..errors import Problem
from ..messages import say, say_many
from ..variants import VARIANTS, Path

Table: TypeAlias = Mapping[str, object]
"""A table of a spec as it was written."""


class RuleError(ValueError):
    """Rules that a table breaks, raised while pydantic validates it; ``problems.problems_of`` takes it apart."""

    def __init__(self, problems: Iterable[Problem], others: ValidationError | None = None) -> None:
        """Carry problems whose paths begin at the table, and what pydantic itself found in it."""
        self.problems, self.others = list(problems), others
        super().__init__("; ".join(map(str, [*([others] if others else []), *self.problems])))


def wrong(path: str, message: str) -> Problem:
    """Report a key; what was given is looked up when the problem is told."""
    return Problem(path, None, message)


def order_problems(low: float | None, mean: float | None, high: float | None) -> list[Problem]:
    """Check min ≤ mean ≤ max as far as given."""
    if low is not None and high is not None and low > high:
        return [wrong("max", say("must not be below min ({low:g})", low=low))]
    if mean is not None and low is not None and mean < low:
        return [wrong("mean", say("must not be below min ({low:g})", low=low))]
    if mean is not None and high is not None and mean > high:
        return [wrong("mean", say("must not be above max ({high:g})", high=high))]
    return []


def problems(data: Table) -> list[Problem]:
    """Every rule between keys that ``data`` breaks; values themselves are the models' business."""
    return [
        *_friction(data),
        *_radii(data),
        *_gain(data),
        *_pocket(data),
        *_force(data),
        *_variant(data),
        *_pairs(data),
    ]


def get(data: Table, *path: str) -> object:
    """Return the value at ``path``; None when absent or when a block is no table."""
    value: object = data
    for key in path:
        if not isinstance(value, dict):
            return None
        value = value.get(key)
    return value


def has(data: Table, *path: str) -> bool:
    """Whether a key is present."""
    return get(data, *path) is not None


def is_table(data: Table, *path: str) -> bool:
    """Whether a block is present, and a table."""
    return isinstance(get(data, *path), dict)


def _friction(data: Table) -> Iterable[Problem]:
    if not is_table(data, "friction"):
        return
    groups = [group for group in ("driving", "driven") if has(data, "friction", group)]
    own = [key for key in ("min", "mean", "max", "material") if has(data, "friction", key)]
    for key in own if groups else ():
        yield wrong(
            f"friction.{key}",
            say("give friction for all pairs or per group (friction.driving, friction.driven), not both"),
        )
    if len(groups) == 1:
        other = "driven" if groups == ["driving"] else "driving"
        yield beside(f"friction.{other}", f"friction.{groups[0]}")
    if _number(get(data, "friction", "static_ratio")) > 1 and not has(data, "friction", "stribeck_speed"):
        yield beside("friction.stribeck_speed", "friction.static_ratio")
    blocks: list[tuple[str, ...]] = [("friction", group) for group in groups]
    for block in blocks or [("friction",)]:
        if not is_table(data, *block) or has(data, *block, "material"):
            continue
        for key in ("min", "max"):
            if not has(data, *block, key):
                yield wrong(".".join((*block, key)), say("required (or give material instead of min and max)"))


def _number(value: object) -> float:
    return float(value) if isinstance(value, int | float) else 0.0


def beside(path: str, other: str) -> Problem:
    """Report a key that another needs."""
    return wrong(path, say("required beside {other}", other=other))


def _radii(data: Table) -> Iterable[Problem]:
    block = "friction_group"
    if not is_table(data, block):
        return
    two = [key for key in ("inner_radius", "outer_radius") if has(data, block, key)]
    if has(data, block, "mean_radius"):
        for key in (*two, *(["radius_model"] if has(data, block, "radius_model") else [])):
            yield wrong(
                f"{block}.{key}",
                say("excludes friction_group.mean_radius: give mean_radius, or inner_radius and outer_radius"),
            )
    elif not two:
        yield wrong(f"{block}.mean_radius", say("required (or give inner_radius and outer_radius)"))
    elif len(two) == 1:
        other = "outer_radius" if two == ["inner_radius"] else "inner_radius"
        yield beside(f"{block}.{other}", f"{block}.{two[0]}")


def _gain(data: Table) -> Iterable[Problem]:
    block = "control_unit"
    if not is_table(data, block):
        return
    gain, angle = has(data, block, "gain"), has(data, block, "wall_angle")
    if gain and angle:
        yield wrong(
            f"{block}.wall_angle", say("excludes control_unit.gain: give gain, or wall_angle and ball_circle_radius")
        )
    elif not gain and not angle:
        yield wrong(f"{block}.gain", say("required (or give wall_angle and ball_circle_radius)"))
    elif angle and not has(data, block, "ball_circle_radius"):
        yield beside(f"{block}.ball_circle_radius", f"{block}.wall_angle")


def _pocket(data: Table) -> Iterable[Problem]:
    block = "control_unit"
    slope, pocket = has(data, block, "gain_slope"), has(data, block, "pocket")
    if slope and pocket:
        message = say("excludes control_unit.pocket: give the slope, or the pocket that it follows from")
        yield wrong(f"{block}.gain_slope", message)
    if has(data, block, "profiled") and not slope and not pocket:
        yield wrong(f"{block}.profiled", say("is of a curved wall: give gain_slope or pocket with it"))


def _force(data: Table) -> Iterable[Problem]:
    if not has(data, "closing_spring", "force") and not has(data, "adjustment", "nominal_torque"):
        yield wrong("closing_spring.force", say("required (or give adjustment.nominal_torque, which sets it)"))
    elif has(data, "control_spring", "force") and not has(data, "closing_spring", "force"):
        yield wrong("closing_spring.force", say("required beside control_spring.force: both forces as made"))


def _special() -> dict[Path, tuple[str, ...]]:
    """Keys that only some variants have → those variants."""
    every = VARIANTS.values()
    return {key: tuple(each.name for each in every if key in each.keys) for each in every for key in each.keys}


def variants_of(path: str) -> tuple[str, ...]:
    """Variants that have the key at a dotted path; empty when all have."""
    parts = tuple(path.split("."))
    found = [variants for key, variants in _special().items() if key == parts[: len(key)]]
    return min(found, key=len) if found else ()


def foreign_keys(data: Table) -> list[Path]:
    """Paths of the keys present that the variant of ``data`` does not have; a block stands for its keys."""
    own = VARIANTS[str(data["variant"])].keys
    found = [path for path in _special() if path not in own and has(data, *path)]
    return [path for path in found if path[:1] not in found or len(path) == 1]


def _variant(data: Table) -> Iterable[Problem]:
    name = get(data, "variant")
    if not isinstance(name, str) or name not in VARIANTS:
        return
    for path in foreign_keys(data):
        only = ", ".join(_special()[path])
        yield wrong(".".join(path), say("not for variant {variant!r}; only for {only}", variant=name, only=only))
    for path in VARIANTS[name].needs + VARIANTS[name].requires:
        if not has(data, *path) and (len(path) == 1 or has(data, path[0]) or path[0] == "closing_spring"):
            yield wrong(".".join(path), say("required for variant {variant!r}", variant=name))


def _is_number(value: object) -> TypeGuard[float]:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _pairs(data: Table) -> Iterable[Problem]:
    pairs, driving = get(data, "friction_group", "pairs"), get(data, "friction_group", "driving_pairs")
    if not _is_number(pairs):
        return
    if _is_number(driving):
        if not driving < pairs:
            yield wrong(
                "friction_group.driving_pairs", say("must be less than friction_group.pairs ({pairs})", pairs=pairs)
            )
        return
    variant = VARIANTS.get(str(get(data, "variant")))
    if driving is None and variant is not None and 1 <= pairs < (least := variant.least_pairs()) > 1:
        default = say(" (the default)") if variant.chooses_bypass else ""
        bypass = say_many(
            "{count} driving pair{default}", "{count} driving pairs{default}", count=least - 1, default=default
        )
        yield wrong(
            "friction_group.pairs",
            say(
                "a {variant} clutch needs at least {least}: {bypass} and 1 driven",
                variant=variant.name,
                least=least,
                bypass=bypass,
            ),
        )
