"""The result of a design; a clutch of its front as a row of it, and as a spec."""

import math
from typing import Literal

import numpy as np

from ...messages import joined, say, term
from ...result import Answer, Result, Sentence, described, quantity
from ...spec import Spec, make_spec
from ...spec.edit import as_written, put
from ...spec.models import ControlUnit
from ...spec.requirements import Requirements
from ...spec.rules import SHARED, foreign_keys, given_in
from ..check import CheckResult
from .candidates import Candidates
from .space import LININGS, curved, with_lining


class DesignRow(Result):
    """One clutch of the front."""

    number: int = quantity("", "no.", "number, for --pick")
    mark: Literal["knee"] | None = described("mark", optional=True, null="")
    variant: str = described("variant")
    material: str | None = described("friction material", code=True, optional=True)
    driving_material: str | None = described("friction material of the driving pairs", code=True, optional=True)
    driven_material: str | None = described("friction material of the driven pairs", code=True, optional=True)
    pairs: int = quantity("1", "z", "friction pairs")
    driving_pairs: int | None = quantity("1", "z_1", "bypass pairs", optional=True)
    mean_radius: float = quantity("m", "R_cp", "mean friction radius")
    inner_radius: float | None = quantity("m", "r_i", "inner radius of the friction faces", optional=True, detail=True)
    outer_diameter: float | None = quantity("m", "2 r_o", "outer diameter of the friction faces", optional=True)
    gain: float | None = quantity("1", "C", "feedback gain", optional=True)
    gain_slope: float | None = quantity("1/m", "C_1", "how the gain grows with the sleeve's travel", optional=True)
    wall_angle: float | None = quantity("rad", "α", "wall angle", optional=True)
    ball_circle_radius: float | None = quantity("m", "r", "ball-circle radius", optional=True)
    closing_stiffness: float | None = quantity("N/m", "c_1", "stiffness of the closing spring", optional=True)
    control_stiffness: float | None = quantity("N/m", "c_2", "stiffness of the control spring", optional=True)
    closing_force: float = quantity("N", "F_п", "closing-spring force as set")
    control_force: float | None = quantity("N", "F_п2", "control-spring force as set", optional=True)
    pack_force_at_rest: float | None = quantity("N", "N(0)", "force on the pack at rest", optional=True)
    closing_deflection: float | None = quantity("m", "F_п/c_1", "deflection of the closing spring", optional=True)
    control_deflection: float | None = quantity("m", "F_п2/c_2", "deflection of the control spring", optional=True)
    nominal_torque: float = quantity("N*m", "T_н", "nominal torque of the clutch")
    machine_torque: float | None = quantity("N*m", "T_н.маш", "nominal torque of the machine", optional=True)
    accuracy_factor: float = quantity("1", "K_т", "accuracy factor")
    torque_max: float = quantity("N*m", "T_max", "largest torque")
    accuracy_factor_hysteresis: float | None = quantity(
        "1", "K_т,h", "accuracy factor under a load that lasts", optional=True
    )
    cycles: float | None = quantity("1", "N_ц", "life in cycles of the side that fails first", optional=True)
    torque_after_wear: float | None = quantity(
        "N*m", "T_w", "least torque in service with the lining worn off", optional=True
    )
    ball_diameter: float | None = quantity("m", "d_ш", "standard ball", optional=True)
    travel: float | None = quantity("m", "x_max", "largest travel of the sleeve", optional=True)
    contact_force: float | None = quantity("N", "F_n", "largest force on one ball", optional=True)
    surface_pressure: float | None = quantity("Pa", "p", "mean surface pressure", optional=True)
    closing_part: Sentence | None = described(
        "closing spring, discs in parallel × packs or turns × coils", optional=True
    )
    control_part: Sentence | None = described(
        "control spring, discs in parallel × packs or turns × coils", optional=True
    )
    accuracy_factor_sprung: float | None = quantity("1", "K_т,п", "accuracy factor with these springs", optional=True)
    torque_max_sprung: float | None = quantity(
        "N*m", "T_max,п", "largest torque with these springs", optional=True, detail=True
    )

    peak_torque: float | None = quantity("N*m", "T_peak", "peak torque in the shaft", optional=True)
    work: float | None = quantity("J/m^2", "q_A", "work per area of a pair", optional=True)
    temperature: float | None = quantity("K abs", "Θ", "mean temperature of the discs after a trip", optional=True)
    face_temperature: float | None = quantity(
        "K abs", "Θ_s", "largest temperature of the faces during a trip", optional=True
    )
    trips_per_hour: float | None = quantity("1/h", "ν", "trips per hour, mean temperature at the limit", optional=True)
    exceedance: float | None = quantity("1", "P(T>T_max)", "probability that the torque exceeds T_max", optional=True)

    def objective(self, name: str) -> float:
        """Value by which it was judged; what its variant does not have costs nothing."""
        if name == "closing_force" and self.pack_force_at_rest is not None:
            return self.pack_force_at_rest
        value = getattr(self, name)
        if value is None and name == "control_deflection" and self.control_stiffness == 0:
            return math.inf
        return float(value or 0.0)


_CONSTRAINTS = {
    "gain_limit": say("feedback gain as a share of its limit"),
    "reduced_gain": say("reduced gain"),
    "gain_threshold": say("feedback gain below the one at which the sleeve moves"),
    "contact_pressure": say("contact pressure of balls and pockets"),
    "standard_ball": say("size that the largest standard ball lacks"),
    "hub_diameter": say("inner diameter of the faces, around the hub"),
    "face_width": say("mean radius that the width of the faces needs"),
    "material_pressure": say("peak pressure on the friction material"),
    "shaft_yield": say("largest torque for the shaft"),
    "housing_diameter": say("outer diameter of the housing"),
    "length": say("length of the clutch"),
    "hub_pack": say("overlap of hub and disc pack"),
    "hub_balls": say("overlap of hub and balls"),
    "pack_balls": say("overlap of disc pack and balls"),
    "pressure_disc_balls": say("overlap of pressure disc and balls"),
    "housing_balls": say("overlap of housing and balls"),
    "housing_stop_ring": say("overlap of housing and stop ring"),
    "closing_spring": say("no closing spring to be had"),
    "control_spring": say("no control spring to be had"),
    "springs": say("no springs with which it passes a check"),
}
"""Constraint that is no quantity of a row → what people read."""


def in_words(names: str) -> str:
    """Say what a constraint or an objective is called; several may be joined by plus signs."""
    fields, each = DesignRow.model_fields, names.split(" + ")
    return joined(
        (_CONSTRAINTS.get(name) or term((name in fields and fields[name].description) or name) for name in each), " + "
    )


class Attainable(Result):
    """The best of a requirement among clutches that miss nothing else, or only what is named together with it."""

    together: str | None = described("requirements given up together", optional=True, in_words=in_words)
    requirement: str = described("requirement given up", in_words=in_words)
    sense: str = described("is to be")
    limit: float = described("limit", unit_in="unit")
    best: float = described("best found", unit_in="unit")
    relax_to: float | None = described("relax it to", unit_in="unit", optional=True)
    unit: str = described("unit", is_unit=True)
    key: str | None = described("key to relax", optional=True, code=True)
    feasible: int | None = described("candidates that then meet all", optional=True)


class Trade(Result):
    """What a neighbour on the front gains or gives up in one objective."""

    number: int = described("no.")
    variant: str = described("variant")
    objective: str = described("objective", in_words=in_words)
    verdict: Literal["gains", "gives up"] = described("verdict")
    change: float | None = quantity("1", None, "change, as a share")
    value: float | None = described("has", unit_in="unit")
    instead_of: float | None = described("instead of", unit_in="unit")
    unit: str = described("unit", is_unit=True)


class OfVariant(Result):
    """What became of the candidates of one variant."""

    variant: str = described("variant")
    candidates: int = described("candidates searched")
    excluded: dict[str, int] = described("excluded by:", in_words=in_words)
    feasible: int = described("candidates that meet every requirement")
    on_front: int = described("clutches on the front")


class DesignResult(Answer):
    """The front of a design: the best between the grid points."""

    candidates: int = described("candidates searched")
    feasible: int = described("candidates that meet every requirement")
    unasked: int | None = described(
        "of them not given to a check, which simulates: one of the front beats them", optional=True
    )
    objectives: list[str] = described("what is small on the front", in_words=in_words)
    on_front: int = described("clutches on the front: none beats another in everything")
    knee: int | None = described("number of the knee: least sum of the objectives, each over its range",
        optional=True,
    )  # fmt: skip
    excluded: dict[str, int] = described(
        "candidates excluded by each constraint", ranked=True, keys_are="constraint", in_words=in_words
    )
    front: list[DesignRow] = described("the front", folds=True)
    picked: list[DesignRow] | None = described(
        "the clutch picked, calculated from the round values as written", optional=True, across=True
    )
    explained: int | None = described("number whose neighbours on the front are told", optional=True)
    neighbours: list[Trade] | None = described("its neighbours, and what each gains and gives up", optional=True)
    of_variants: list[OfVariant] | None = described("candidates of each variant", optional=True, across=True)
    attainable: list[Attainable] | None = described(
        "what could be had instead, with all other requirements held", optional=True
    )
    verdict: CheckResult | None = described("check of the clutch as written", optional=True)

    def words(self, name: str) -> str | None:
        """Leave out what people are told of each variant."""
        return "" if name == "excluded" and self.of_variants else None


@np.errstate(all="ignore")
def rows(tried: Candidates) -> list[DesignRow]:
    """Turn columns to rows, numbered in their order; what does not apply, or is not finite, is None."""
    need, at, variant = tried.need, tried.at, tried.variant
    searched = ("pairs", "driving_pairs", "mean_radius", "ball_circle_radius", "closing_stiffness", "control_stiffness")
    names = ["closing_force", "nominal_torque", "accuracy_factor", "torque_max", "surface_pressure", "outer_diameter"]
    asked = ("accuracy_factor_hysteresis", "cycles", "torque_after_wear")
    names += [name for name in asked if getattr(need.wanted, name) is not None]
    if variant.controlled:
        names += ["gain", "ball_diameter", "contact_force"]
    if curved(need, variant):
        names.append("gain_slope")
    if variant.travels:
        names += ["control_force", "closing_deflection", "control_deflection", "travel"]
    columns = {name: getattr(at, name) for name in searched} | {name: getattr(tried, name) for name in names}
    columns["inner_radius"] = at.mean_radius - tried.face_width / 2
    if variant.controlled and need.search.wall_angle is not None:
        columns["wall_angle"] = at.steering
    if variant.travels:
        columns["pack_force_at_rest"] = tried.pack_force
    if need.wanted.margin != 1:
        columns["machine_torque"] = tried.nominal_torque / need.wanted.over_machine
    blocks = {f"{path}.material": block for path, block in need.friction.blocks.items()}
    lining = {name: ", ".join(blocks[path].material_names) for name, path in LININGS.items() if path in blocks}
    lists = zip(*(np.broadcast_to(column, at.pairs.shape).tolist() for column in columns.values()), strict=True)
    finite = ([value if math.isfinite(value) else None for value in values] for values in lists)
    return [
        DesignRow(number=number, variant=variant.name, **lining, **dict(zip(columns, values, strict=True)))
        for number, values in enumerate(finite, 1)
    ]


def as_spec(need: Requirements, row: DesignRow) -> Spec:
    """Write a row as a spec, with as many digits as a file of it has."""
    need = with_lining(need, row)
    wanted, fixed, blocks = need.wanted, need.fixed.model_dump(exclude_none=True), {*SHARED, "catalogues", "friction"}
    if row.inner_radius is None or row.outer_diameter is None:
        faces = {"mean_radius": row.mean_radius}
    else:
        faces = {"inner_radius": row.inner_radius, "outer_radius": row.outer_diameter / 2}
    # what the variant is held to; the limit of the force on a ball is a key of the control unit
    limited = {"surface_pressure", "outer_diameter"}
    limited |= {"reduced_gain"} if row.ball_circle_radius is not None else set()
    limited |= {"travel"} if row.travel is not None else set()
    of_pockets = set() if row.gain else {"contact_pressure"}
    data = need.model_dump(exclude_none=True, include=blocks) | {
        "name": say("{name}, no. {number}", name=need.name or say("Design"), number=row.number),
        "variant": row.variant,
        "friction_group": faces | _given(pairs=row.pairs, driving_pairs=row.driving_pairs),
        "closing_spring": _given(
            force=row.closing_force, stiffness=row.closing_stiffness, room=fixed.get("closing_room")
        ),
        "control_spring": _given(stiffness=row.control_stiffness, room=fixed.get("control_room")),
        "control_unit": {name: value for name, value in fixed.items() if name in ControlUnit.model_fields}
        | _given(
            gain=row.gain if row.wall_angle is None else None,
            wall_angle=row.wall_angle,
            ball_circle_radius=row.ball_circle_radius,
            ball_diameter=row.ball_diameter,
            allowable_contact_force=need.limits.contact_force,
        ),
        "adjustment": {"method": wanted.method, "margin": wanted.margin},
        "requirements": wanted.model_dump(exclude_none=True, exclude={"method", "margin", *of_pockets})
        | need.limits.model_dump(exclude_none=True, include=limited),
    }
    if need.envelope is not None and row.closing_stiffness is None:
        put(data, "envelope.hub_diameter", need.hub_diameter)
    for path in foreign_keys(given_in(data), row.variant):
        put(data, path, None)
    return as_written(make_spec(data))


def _given(**values: object) -> dict[str, object]:
    return {name: value for name, value in values.items() if value is not None}
