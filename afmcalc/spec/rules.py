"""Rules between the keys of a spec: what excludes what, what needs what, what a variant does not have."""

from collections.abc import Iterable, Mapping
from typing import Any, TypeAlias

from pydantic import ValidationError
from pydantic_core import InitErrorDetails, PydanticCustomError

from ..variants import VARIANTS, Path

Finding: TypeAlias = tuple[tuple[str, ...], Any, str]
"""Key path, value given (``MISSING`` when there is none), what is wrong and what is allowed."""

MISSING: Any = type("Missing", (), {"__repr__": lambda self: "MISSING"})()


def validation_error(title: str, problems: Iterable[Finding], others: ValidationError | None = None) -> ValidationError:
    """Build one pydantic error from problems of ours and, if given, those pydantic found."""
    details: list[InitErrorDetails] = []
    for error in others.errors(include_url=False) if others else []:
        kind = PydanticCustomError(error["type"], "{message}", {**error.get("ctx", {}), "message": error["msg"]})
        details.append({"type": kind, "loc": error["loc"], "input": error["input"]})
    for path, value, message in problems:
        details.append(
            {"type": PydanticCustomError("rule", "{message}", {"message": message}), "loc": path, "input": value}
        )
    return ValidationError.from_exception_data(title, details)


def order_problems(low: float | None, mean: float | None, high: float | None) -> list[Finding]:
    """Check min ≤ mean ≤ max as far as given."""
    problems: list[Finding] = []
    if low is not None and high is not None and low > high:
        problems.append((("max",), high, f"must not be below min ({low:g})"))
    elif mean is not None and low is not None and mean < low:
        problems.append((("mean",), mean, f"must not be below min ({low:g})"))
    elif mean is not None and high is not None and mean > high:
        problems.append((("mean",), mean, f"must not be above max ({high:g})"))
    return problems


def problems(data: Mapping[str, Any]) -> list[Finding]:
    """Every rule between keys that ``data`` breaks; values themselves are the models' business."""
    return [
        *_friction(data),
        *_radii(data),
        *_gain(data),
        *_force(data),
        *_contact(data),
        *_variant(data),
        *_pairs(data),
    ]


def _get(data: Mapping[str, Any], *path: str) -> Any:
    """Value at ``path``; MISSING when absent (null counts as absent) or when a block is no table."""
    value: Any = data
    for key in path:
        if not isinstance(value, Mapping) or value.get(key) is None:
            return MISSING
        value = value[key]
    return value


def _has(data: Mapping[str, Any], *path: str) -> bool:
    return _get(data, *path) is not MISSING


def _is_table(data: Mapping[str, Any], *path: str) -> bool:
    return isinstance(_get(data, *path), Mapping)


def _friction(data: Mapping[str, Any]) -> Iterable[Finding]:
    if not _is_table(data, "friction"):
        return
    groups = [group for group in ("driving", "driven") if _has(data, "friction", group)]
    own = [key for key in ("min", "mean", "max", "material") if _has(data, "friction", key)]
    for key in own if groups else ():
        yield (
            ("friction", key),
            _get(data, "friction", key),
            ("give friction for all pairs or per group (friction.driving, friction.driven), not both"),
        )
    if len(groups) == 1:
        other = "driven" if groups == ["driving"] else "driving"
        yield ("friction", other), MISSING, f"required beside friction.{groups[0]}"
    blocks: list[tuple[str, ...]] = [("friction", group) for group in groups]
    for block in blocks or [("friction",)]:
        if not _is_table(data, *block) or _has(data, *block, "material"):
            continue
        for key in ("min", "max"):
            if not _has(data, *block, key):
                yield (*block, key), MISSING, "required (or give material instead of min and max)"


def _radii(data: Mapping[str, Any]) -> Iterable[Finding]:
    block = "friction_group"
    if not _is_table(data, block):
        return
    two = [key for key in ("inner_radius", "outer_radius") if _has(data, block, key)]
    if _has(data, block, "mean_radius"):
        for key in (*two, *(["radius_model"] if _has(data, block, "radius_model") else [])):
            yield (
                (block, key),
                _get(data, block, key),
                ("excludes friction_group.mean_radius: give mean_radius, or inner_radius and outer_radius"),
            )
    elif not two:
        yield (block, "mean_radius"), MISSING, "required (or give inner_radius and outer_radius)"
    elif len(two) == 1:
        other = "outer_radius" if two == ["inner_radius"] else "inner_radius"
        yield (block, other), MISSING, f"required beside friction_group.{two[0]}"


def _gain(data: Mapping[str, Any]) -> Iterable[Finding]:
    block = "control_unit"
    if not _is_table(data, block):
        return
    gain, angle = _has(data, block, "gain"), _has(data, block, "wall_angle")
    if gain and angle:
        yield (
            (block, "wall_angle"),
            _get(data, block, "wall_angle"),
            ("excludes control_unit.gain: give gain, or wall_angle and ball_circle_radius"),
        )
    elif not gain and not angle:
        yield (block, "gain"), MISSING, "required (or give wall_angle and ball_circle_radius)"
    elif angle and not _has(data, block, "ball_circle_radius"):
        yield (block, "ball_circle_radius"), MISSING, "required beside control_unit.wall_angle"


def _contact(data: Mapping[str, Any]) -> Iterable[Finding]:
    force, block = ("control_unit", "allowable_contact_force"), ("control_unit", "contact")
    if _has(data, *force) and _has(data, *block):
        yield (
            force,
            _get(data, *force),
            "excludes control_unit.contact: give the allowable force, or the elastic data it follows from",
        )


def _force(data: Mapping[str, Any]) -> Iterable[Finding]:
    if not _has(data, "closing_spring", "force") and not _has(data, "adjustment", "nominal_torque"):
        yield ("closing_spring", "force"), MISSING, "required (or give adjustment.nominal_torque, which sets it)"
    elif _has(data, "control_spring", "force") and not _has(data, "closing_spring", "force"):
        yield ("closing_spring", "force"), MISSING, "required beside control_spring.force: both forces as made"


def _special() -> dict[Path, tuple[str, ...]]:
    """Keys that only some variants have → those variants."""
    every = VARIANTS.values()
    return {key: tuple(each.name for each in every if key in each.keys) for each in every for key in each.keys}


def variants_of(path: str) -> tuple[str, ...]:
    """Variants that have the key at a dotted path; empty when all have."""
    parts = tuple(path.split("."))
    found = [variants for key, variants in _special().items() if key == parts[: len(key)]]
    return min(found, key=len) if found else ()


def foreign_keys(data: Mapping[str, Any]) -> list[Path]:
    """Paths of the keys present that the variant of ``data`` does not have; a block stands for its keys."""
    own = VARIANTS[data["variant"]].keys
    found = [path for path in _special() if path not in own and _has(data, *path)]
    return [path for path in found if path[:1] not in found or len(path) == 1]


def _variant(data: Mapping[str, Any]) -> Iterable[Finding]:
    name = _get(data, "variant")
    if not isinstance(name, str) or name not in VARIANTS:
        return
    for path in foreign_keys(data):
        yield path, _get(data, *path), f"not for variant {name!r}; only for {', '.join(_special()[path])}"
    for path in VARIANTS[name].needs:
        if not _has(data, *path) and (len(path) == 1 or _has(data, path[0]) or path[0] == "closing_spring"):
            yield path, MISSING, f"required for variant {name!r}"


def _pairs(data: Mapping[str, Any]) -> Iterable[Finding]:
    pairs, driving = _get(data, "friction_group", "pairs"), _get(data, "friction_group", "driving_pairs")
    if not isinstance(pairs, int | float):
        return
    if isinstance(driving, int | float):
        if not driving < pairs:
            yield ("friction_group", "driving_pairs"), driving, f"must be less than friction_group.pairs ({pairs})"
        return
    variant = VARIANTS.get(str(_get(data, "variant")))
    if driving is MISSING and variant is not None and 1 <= pairs < (least := variant.least_pairs()) > 1:
        default = " (the default)" if variant.chooses_bypass else ""
        bypass = f"{least - 1} driving pair{'s' if least > 2 else ''}{default}"
        message = f"a {variant.name} clutch needs at least {least}: {bypass} and 1 driven"
        yield ("friction_group", "pairs"), pairs, message
