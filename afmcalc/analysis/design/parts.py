"""The disc springs of a clutch of a front, and what they make of it."""

from itertools import product
from typing import NamedTuple

from ...engines import build
from ...engines.protocol import Clutch
from ...spec import Spec
from ...spec.edit import as_written
from ...spec.requirements import Requirements
from ..checks.check import found_unsimulated
from ..springs.options import part_of
from ..springs.result import SpringOption
from ..springs.springs import ranked
from .rows import DesignRow, as_spec

_TRIED = 5
"""Stacks of each spring."""


class Made(NamedTuple):
    """A clutch as it is written, with disc springs where they are wanted, and its row."""

    spec: Spec
    row: DesignRow


def made(need: Requirements, row: DesignRow) -> Made | None:
    """Write a row as a spec that passes a check, with the first disc springs, if wanted, with which it does.

    Springs that stay in their range come first: with them the sleeve travels farther, or less, than with straight ones.
    None where a check fails with all that are tried.
    """
    plain = as_spec(need, row)
    if need.springs is None:
        return Made(plain, row) if passes(build(plain)) else None
    lists: dict[str, list[SpringOption]] = {wish.name: ranked(wish, "disc")[:_TRIED] for wish in build(plain).wishes()}
    strayed = None
    for parts in product(*lists.values()):
        options = dict(zip(lists, parts, strict=True))
        clutch = build(as_written(_with(plain, options)))
        if passes(clutch):
            found = Made(clutch.spec, row.model_copy(update=_of_discs(clutch, options)))
            if not any(each.code == "spring-beyond-range" for each in clutch.findings()):
                return found
            strayed = strayed or found
    return strayed


def passes(clutch: Clutch) -> bool:
    """Whether a clutch passes a check, its friction material below what it is allowed."""
    findings = found_unsimulated(clutch)
    return not any(each.level == "error" or each.code.endswith("-pressure-in-range") for each in findings)


def _of_discs(clutch: Clutch, options: dict[str, SpringOption]) -> dict[str, str | float]:
    """Name the stacks, and the K_т that an indirect clutch has with them, whose force is no straight line."""
    names = {f"{name}_part": f"{each.part}, {each.parallel} × {each.series}" for name, each in options.items()}
    if not clutch.spec.kind.travels:
        return {**names}
    return {
        **names,
        "torque_max_sprung": float(clutch.torque_max),
        "accuracy_factor_sprung": float(clutch.accuracy_factor),
    }


def _with(plain: Spec, found: dict[str, SpringOption]) -> Spec:
    """With the stacks and their own stiffness; the forces stay."""
    blocks = {f"{name}_spring": option for name, option in found.items()}
    return plain.model_copy(
        update={
            block: getattr(plain, block).model_copy(update={"disc": part_of(option), "stiffness": option.stiffness})
            for block, option in blocks.items()
        }
    )
