"""The disc springs of a clutch of a front, and what they make of it."""

from collections.abc import Sequence
from itertools import product

from ...engines import build
from ...findings import Finding, finding
from ...spec import Spec
from ...spec.edit import as_written
from ...spec.requirements import Requirements
from ..springs.options import part_of
from ..springs.result import SpringOption
from ..springs.springs import ranked
from .limits import OVER
from .rows import DesignRow, as_spec

_TRIED = 5
"""Stacks of each spring."""


def with_parts(need: Requirements, row: DesignRow) -> DesignRow:
    """Name the stacks of a row, and the K_т that an indirect clutch has with them, whose force is no straight line."""
    plain = as_spec(need, row)
    found = _stacks(plain)
    named = row.model_copy(update={f"{name}_part": _name(option) for name, option in found.items()})
    if not plain.kind.travels:
        return named
    clutch = build(_sprung(plain, found))
    torque, factor = float(clutch.torque_max), float(clutch.accuracy_factor)
    return named.model_copy(update={"torque_max_sprung": torque, "accuracy_factor_sprung": factor})


def springs_miss(need: Requirements, front: Sequence[DesignRow]) -> list[Finding]:
    """What is wanted was held of straight springs: say where the disc springs do not."""
    bounds = (
        ("accuracy_factor", need.wanted.accuracy_factor, [row.accuracy_factor_sprung for row in front]),
        ("torque_max", need.wanted.torque_max, [row.torque_max_sprung for row in front]),
    )
    found = []
    for name, limit, values in bounds:
        beyond = [value for value in values if value is not None and limit is not None and value > limit * OVER]
        if beyond:
            path, most = f"wanted.{name}", max(beyond)
            found.append(finding("springs-miss", "warning", value=most, limit=limit, path=path, count=len(beyond)))
    return found


def spec_with_parts(need: Requirements, row: DesignRow) -> Spec:
    """Write a row as a spec, with its springs."""
    plain = as_spec(need, row)
    return plain if need.springs is None else as_written(_sprung(plain, _stacks(plain)))


def _stacks(plain: Spec) -> dict[str, SpringOption]:
    """Of the stacks as they are told the first that stay in their range: with them the sleeve travels farther, or less.

    Where none of those tried do the first of all, which a check then tells of.
    """
    lists: dict[str, list[SpringOption]] = {wish.name: ranked(wish, "disc")[:_TRIED] for wish in build(plain).wishes()}
    every = [dict(zip(lists, each, strict=True)) for each in product(*lists.values())]
    return next((each for each in every if _in_range(_sprung(plain, each))), every[0])


def _in_range(spec: Spec) -> bool:
    return not any(each.code == "spring-beyond-range" for each in build(spec).findings())


def _sprung(plain: Spec, found: dict[str, SpringOption]) -> Spec:
    """With the stacks and their own stiffness; the forces stay."""
    blocks = {f"{name}_spring": option for name, option in found.items()}
    return plain.model_copy(
        update={
            block: getattr(plain, block).model_copy(update={"disc": part_of(option), "stiffness": option.stiffness})
            for block, option in blocks.items()
        }
    )


def _name(option: SpringOption) -> str:
    return f"{option.part}, {option.parallel} × {option.series}"
