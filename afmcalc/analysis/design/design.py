"""Which clutch is needed: the Pareto front of everything that meets the requirements."""

import math
from collections.abc import Callable
from typing import Any

from ...errors import AfmcalcError, CalculationError
from ...findings import Finding
from ...messages import say
from ...result import Result, quantity
from ...spec import Spec, make_spec
from ...spec.requirements import Requirements
from .candidates import Axes, State, evaluate
from .refine import refined
from .search import Found, search, total

MOST = 10_000_000_000
"""Candidates beyond which a search is refused."""


class DesignRow(Result):
    """One clutch of the front."""

    number: int = quantity("", "N", "number, for --pick")
    variant: str = quantity("", None, "variant")
    pairs: int = quantity("1", "z", "friction pairs")
    driving_pairs: int | None = quantity("1", "z_1", "bypass pairs", optional=True)
    mean_radius: float = quantity("m", "R_cp", "mean friction radius")
    gain: float | None = quantity("1", "C", "feedback gain", optional=True)
    wall_angle: float | None = quantity("rad", "α", "wall angle", optional=True)
    ball_circle_radius: float | None = quantity("m", "r", "ball-circle radius", optional=True)
    closing_stiffness: float | None = quantity("N/m", "c_1", "stiffness of the closing spring", optional=True)
    control_stiffness: float | None = quantity("N/m", "c_2", "stiffness of the control spring", optional=True)
    closing_force: float = quantity("N", "F_п", "closing-spring force as set")
    nominal_torque: float = quantity("N*m", "T_н", "nominal torque")
    accuracy_factor: float = quantity("1", "K_т", "accuracy factor")
    torque_max: float = quantity("N*m", "T_max", "largest torque")
    ball_diameter: float | None = quantity("m", "2 r_ш", "standard ball", optional=True)
    travel: float | None = quantity("m", "x_max", "largest travel of the sleeve", optional=True)
    contact_force: float | None = quantity("N", "F_n", "largest force on one ball", optional=True)
    surface_pressure: float | None = quantity("Pa", "p", "mean surface pressure", optional=True)


class DesignResult(Result):
    """The front of a design, on the grid and refined between its points."""

    candidates: int = quantity("", None, "candidates searched")
    feasible: int = quantity("", None, "candidates that meet every requirement")
    objectives: list[str] = quantity("", None, "what is small on the front")
    excluded: dict[str, int] = quantity("", None, "candidates excluded by each constraint", ranked=True)
    refined: list[DesignRow] = quantity("", None, "the front refined between the grid points, same numbers")
    front: list[DesignRow] = quantity("", None, "the front on the grid")


def design(
    need: Requirements, progress: Callable[[int], None] = lambda done: None
) -> tuple[DesignResult, list[Finding]]:
    """Search everything the requirements allow.

    Args:
        need: the requirements.
        progress: is told how many candidates are behind.

    Returns:
        The front, empty where nothing meets the requirements, and findings.

    Raises:
        AfmcalcError: more candidates than are searched.
    """
    count = total(need)
    if count > MOST:
        raise AfmcalcError(
            say(
                "the search asks for {count:,} candidates; at most {most:,} are searched: coarser ranges, please",
                count=count,
                most=MOST,
            )
        )
    found = search(need, progress)
    grid, fine = _rows(need, found)
    result = DesignResult(
        candidates=found.candidates,
        feasible=found.feasible,
        objectives=list(need.objectives),
        excluded={name: number for name, number in found.excluded.items() if number},
        refined=fine,
        front=grid,
    )
    return result, _findings(result)


def _rows(need: Requirements, found: Found) -> tuple[list[DesignRow], list[DesignRow]]:
    """Lay out the front by its first objective, and the refined one in the same order."""
    import numpy as np

    pairs: list[tuple[list[float], dict[str, Any], dict[str, Any]]] = []
    for variant, rows, values in _by_variant(found):
        both = [
            _table(need, variant, Axes(*each.T), evaluate(need, variant, Axes(*each.T)))
            for each in (rows, refined(need, variant, rows))
        ]
        pairs += [(key.tolist(), *own) for key, *own in zip(np.asarray(values), *both, strict=True)]
    pairs.sort(key=lambda pair: pair[0])
    return (
        [DesignRow(number=number, **pair[1]) for number, pair in enumerate(pairs, 1)],
        [DesignRow(number=number, **pair[2]) for number, pair in enumerate(pairs, 1)],
    )


def _by_variant(found: Found) -> list[tuple[str, Any, Any]]:
    import numpy as np

    names = dict.fromkeys(variant for variant, _, _ in found.members)
    return [
        (
            name,
            np.concatenate([rows for variant, rows, _ in found.members if variant == name]),
            np.concatenate([values for variant, _, values in found.members if variant == name]),
        )
        for name in names
    ]


def _table(need: Requirements, variant: str, at: Axes, state: State) -> list[dict[str, Any]]:
    """Columns to rows; what does not apply becomes None."""
    angle = need.search.wall_angle is not None
    columns: dict[str, Any] = {
        "pairs": at.pairs,
        "driving_pairs": at.driving_pairs,
        "mean_radius": at.mean_radius,
        "gain": state.gain if variant != "conventional" else at.gain,
        "wall_angle": at.gain if angle else at.gain * math.nan,
        "ball_circle_radius": at.ball_circle_radius,
        "closing_stiffness": at.closing_stiffness,
        "control_stiffness": at.control_stiffness,
        **{name: column for name, column in state._asdict().items() if name not in ("gain", "excluded")},
    }
    if variant != "indirect":
        columns["travel"] = at.gain * math.nan
    lists = {name: column.tolist() for name, column in columns.items()}
    return [
        {"variant": variant}
        | {
            name: None if math.isnan(value) else int(value) if name.endswith("pairs") else value
            for name, value in zip(lists, row, strict=True)
        }
        for row in zip(*lists.values(), strict=True)
    ]


def _findings(result: DesignResult) -> list[Finding]:
    if result.front:
        return []
    most = sorted(result.excluded.items(), key=lambda item: -item[1])
    listed = ", ".join(f"{name} excludes {number:,}" for name, number in most)
    message = f"none of {result.candidates:,} candidates meets every requirement: {listed}"
    return [Finding(level="error", code="no-candidate", message=message, value=0.0)]


def picked(need: Requirements, result: DesignResult, number: int, *, fine: bool = False) -> Spec:
    """Return a clutch of the front as a spec.

    Raises:
        CalculationError: no such number.
    """
    rows = result.refined if fine else result.front
    if not 1 <= number <= len(rows):
        raise CalculationError(
            say("--pick {number}: the front has the numbers 1 to {count}", number=number, count=len(rows))
        )
    row, fixed, limits = rows[number - 1], need.fixed, need.limits
    group: dict[str, Any] = {"pairs": row.pairs}
    if row.driving_pairs is not None:
        group["driving_pairs"] = row.driving_pairs
    if fixed.face_width is None:
        group["mean_radius"] = row.mean_radius
    else:
        group |= {
            "inner_radius": row.mean_radius - fixed.face_width / 2,
            "outer_radius": row.mean_radius + fixed.face_width / 2,
        }
    data: dict[str, Any] = {
        "name": f"{need.name or 'Design'}, no. {number}",
        "variant": row.variant,
        "friction": need.friction.model_dump(exclude_none=True),
        "friction_group": group,
        "closing_spring": {"force": row.closing_force},
        "adjustment": {"method": need.wanted.method, "margin": need.wanted.margin},
    }
    if row.variant != "conventional":
        data["control_unit"] = {
            **({"gain": row.gain} if row.wall_angle is None else {"wall_angle": row.wall_angle}),
            "ball_circle_radius": row.ball_circle_radius,
            "balls": fixed.balls,
            "face_gap": fixed.face_gap,
            "edge_clearance": fixed.edge_clearance,
            **({} if limits.contact_force is None else {"allowable_contact_force": limits.contact_force}),
            **({} if row.ball_diameter is None else {"ball_diameter": row.ball_diameter}),
        }
    if row.variant == "indirect":
        data["control_unit"] |= {"hub_diameter": fixed.hub_diameter, "key_friction": fixed.key_friction}
        data["closing_spring"]["stiffness"] = row.closing_stiffness
        data["control_spring"] = {"stiffness": row.control_stiffness}
    return make_spec(data)
