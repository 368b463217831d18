"""The form: every key of a spec with what may stand there, and what does."""

import math
import re
from collections.abc import Mapping
from types import UnionType
from typing import Any, Literal, NamedTuple, Union, get_args, get_origin

from ..messages import translate
from ..render.units import display, display_unit
from ..spec import Spec
from ..spec.catalogues import friction_materials
from ..spec.fields import Key, block_at
from ..variants import VARIANTS
from .base import Base, editable


class Field(NamedTuple):
    """One key."""

    key: str
    label: str
    symbol: str
    unit: str
    text: str
    kind: Literal["number", "choice", "flag", "text"]
    choices: list[tuple[str, str]]
    required: bool
    whole: bool
    bounds: str
    low: float | None
    high: float | None
    step: float | None


class Group(NamedTuple):
    """One table of the spec, with the tables in it."""

    key: str
    fields: list[Field]
    groups: list["Group"]
    given: int


def form_of(base: Base) -> list[Group]:
    """Return the form of a base, filled in: keys that are in no table first, then the tables."""
    top = _group(base.texts({}), "")
    return [top._replace(groups=[]), *top.groups]


def _group(texts: Mapping[str, str], path: str) -> Group:
    inside = f"{path}." if path else ""
    model = block_at(path.split(".") if path else [], Spec)
    assert model is not None
    fields, groups = [], []
    for name in model.model_fields:
        if key := editable().get(inside + name):
            fields.append(_field(key, model.model_fields[name], texts.get(key.path, "")))
        elif any(other.startswith(f"{inside}{name}.") for other in editable()):
            groups.append(_group(texts, inside + name))
    given = sum(bool(field.text) for field in fields) + sum(group.given for group in groups)
    return Group(path, fields, groups, given)


def _field(key: Key, info: Any, text: str) -> Field:
    choices = _choices(key.path, info.annotation)
    kind: Any = "number" if key.about else "flag" if choices == ["true", "false"] else "choice" if choices else "text"
    low, high, step = _slider(key, text)
    return Field(
        key.path, translate(key.description), key.symbol or "", display_unit(key.unit or ""), text, kind,
        [(choice, translate(choice, "value")) for choice in choices], info.is_required(),
        bool(key.about and key.about.whole), _bounds(key), low, high, step,
    )  # fmt: skip


def _choices(path: str, annotation: Any) -> list[str]:
    """Words that may stand at a key; none where any may."""
    if path == "variant":
        return list(VARIANTS)
    if path.startswith("friction.") and path.endswith(".material"):
        return list(friction_materials())
    if annotation is bool:
        return ["true", "false"]
    if get_origin(annotation) is Literal:
        return [str(word) for word in get_args(annotation)]
    if get_origin(annotation) in (Union, UnionType):
        return [word for part in get_args(annotation) for word in _choices(path, part)]
    return []


def _bounds(key: Key) -> str:
    """Say what a number may be, in the engineer's unit."""
    about = key.about
    if about is None:
        return ""
    ends = [
        f"{sign} {display(bound, about.unit)}"
        for sign, bound in ((">", about.gt), ("≥", about.ge), ("<", about.lt), ("≤", about.le))
        if bound is not None
    ]
    return ", ".join(ends)


_NUMBER = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*)")
_STEPS = 200


def _slider(key: Key, text: str) -> tuple[float | None, float | None, float | None]:
    """Ends and step of a slider around a number, in the unit that it is written in."""
    written = _NUMBER.fullmatch(text)
    if key.about is None or written is None or not (number := float(written[1])):
        return None, None, None
    try:
        scale = key.about.read(float(text) if not written[2] else text) / number
    except ValueError:
        return None, None, None
    least, most = (end / scale for end in key.about.limits)
    high = 2 * number
    step = 1.0 if key.about.whole else 10.0 ** math.floor(math.log10(abs(high) / _STEPS))
    low = max(least, min(0.0, high))
    low += step if key.about.gt is not None and low == least else 0.0
    high = min(most, max(0.0, high))
    high -= step if key.about.lt is not None and high == most else 0.0
    return low, high, step
