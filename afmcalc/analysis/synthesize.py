"""Synthesis of the control unit: wall angle, travel, balls, pockets, contact (S21 (16)–(24))."""

from collections.abc import Iterator
from typing import Any, ClassVar, Literal

import numpy as np

from ..engines import Clutch
from ..engines.checks import failures_of
from ..engines.quantities import Quantities
from ..findings import Finding, finding
from ..messages import say
from ..result import Answer, described, quantity
from ..spec.catalogues import ball_designation
from ..spec.models import ControlUnit
from .asking import Asking, answer, asked
from .clutch_findings import clutch_findings
from .pocket_wall import WallPoint, wall_of

Basis = Literal["given", "hertz-ball-on-flat", "hertz-ball-on-curved-wall"]


class SynthesisResult(Asking, Answer):
    """A control unit that fits the clutch."""

    rows_with_values: ClassVar[bool] = True

    wall_angle: float = asked()
    wall_angle_max: float | None = asked(optional=True)
    gain_slope: float | None = asked(optional=True)
    ball_circle_radius: float = asked()
    travel_max: float = asked()
    wear_play: float | None = asked(optional=True)
    face_gap: float = asked()
    edge_clearance: float = asked()
    ball_radius: float = asked()
    undercut_radius: float | None = asked(optional=True)
    ball_diameter_standard: float | None = asked()
    ball_designation: str | None = described("designation of the ball, without its grade", optional=True)
    edge_clearance_standard: float | None = asked()
    pocket_depth: float = asked()
    pocket_depth_cut: float = asked()
    pocket_width: float = asked()
    ball_pitch: float | None = asked()
    web: float | None = asked()
    contact_force: float | None = asked()
    contact_force_allowable: float | None = asked("allowable_contact_force")
    contact_basis: Basis | None = described("where the allowable force is from")
    contact_utilisation: float | None = quantity("1", "F_n/[F_n]", "utilisation of the contact")
    contact_force_hertz: float | None = asked(optional=True)
    contact_pressure: float | None = asked(optional=True)
    allowable_pressure: float | None = asked(optional=True)
    static_safety: float | None = asked(optional=True)
    wall: list[WallPoint] | None = described(
        "curved wall from the stop to the face, from the ball's centre at the stop", optional=True
    )

    @property
    def ball_diameter(self) -> float:
        """Diameter of the chosen ball, m; the smallest diameter needed if no ball in the list is large enough."""
        return 2 * self.ball_radius if self.ball_diameter_standard is None else self.ball_diameter_standard


def pocket(clutch: Clutch) -> tuple[SynthesisResult, list[Finding]]:
    """Design the control unit of a clutch.

    Raises SpecError if the spec lacks what synthesis needs.
    """
    spec, unit = clutch.spec, clutch.spec.control_unit
    if unit is None:
        raise spec.refused("variant", say("has no control unit, so no pockets"), spec.variant)
    if unit.ball_circle_radius is None:
        raise spec.refused("control_unit.ball_circle_radius", say("required by afmcalc pocket"))
    if clutch["gain"] == 0:
        raise spec.refused("control_unit.gain", say("must be greater than 0 to have pockets"), "0")
    diameter = float(clutch["ball_diameter_standard"])
    chosen = None if np.isnan(diameter) else diameter
    wall = wall_of(clutch, clutch["face_gap"], clutch["ball_radius_chosen"])
    unknown = dict[str, Any]()
    if unit.balls is None or unit.balls == 1:
        unknown |= {"ball_pitch": None, "web": None}
    if chosen is None:
        unknown |= {"edge_clearance_standard": None}
    if not clutch["wear_play"]:
        unknown |= {"wear_play": None}
    result = answer(
        SynthesisResult, clutch, ball_diameter_standard=chosen,
        ball_designation=None if chosen is None else ball_designation(chosen),
        wall=wall.points() if wall.steepening > 0 and wall.can_be_cut else None, **unknown,
        **_contact(clutch, unit, by_hertz=chosen is not None and wall.can_be_cut),
    )  # fmt: skip
    findings = [*clutch_findings(clutch), *failures_of(clutch.spec, clutch, "pocket")]
    return result, [*findings, *_remarks(clutch, unit, result)]


def _contact(clutch: Quantities, unit: ControlUnit, *, by_hertz: bool) -> dict[str, Any]:
    """Fields of the result on a ball's contact: its force, and the given limit, the Hertzian limit, or both limits.

    ``by_hertz``: True if a ball is chosen and its wall can be cut, as the Hertzian limit needs.
    """
    given, curved = unit.allowable_contact_force, "path_steepening" in clutch
    if unit.balls is None:  # the limit of one ball does not depend on the number of balls
        clutch = clutch.at(balls=1)
    limits: list[tuple[float, Basis]] = [] if given is None else [(given, "given")]
    hertz = clutch["contact_force_hertz"] if by_hertz and (given is None or unit.contact is not None) else None
    if hertz is not None:
        limits.append((hertz, "hertz-ball-on-curved-wall" if curved else "hertz-ball-on-flat"))
    allowable, basis = min(limits, key=lambda limit: limit[0], default=(None, None))
    force = None if unit.balls is None else clutch["contact_force"]
    return {
        "contact_force": force, "contact_force_allowable": allowable, "contact_basis": basis,
        "contact_utilisation": force / allowable if force is not None and allowable else None,
        "contact_force_hertz": hertz,
        "contact_pressure": clutch["contact_pressure"] if force is not None and by_hertz else None,
    }  # fmt: skip


def completed(result: SynthesisResult) -> dict[str, Any]:
    """Return path → value of the control unit as designed: wall angle (not gain), ball circle, ball, gap, clearance."""
    names = ("wall_angle", "ball_circle_radius", "face_gap", "edge_clearance")
    changes = {f"control_unit.{name}": getattr(result, name) for name in names}
    if result.ball_diameter_standard is not None:
        changes["control_unit.ball_diameter"] = result.ball_diameter_standard
    return changes


def _remarks(clutch: Clutch, unit: ControlUnit, result: SynthesisResult) -> Iterator[Finding]:
    """Yield findings on assumed values, sleeve travel, and the seat of the ball."""
    for key in ("face_gap", "edge_clearance"):
        if getattr(unit, key) is None:
            yield finding("default-clearance", "info", value=getattr(result, key), path=f"control_unit.{key}")
    if not clutch.spec.kind.travels:
        play = clutch["wear_play"]
        code = "no-sleeve-travel/worn" if play else "no-sleeve-travel"
        yield finding(code, "info", value=play, path="heat.lining")
    if result.undercut_radius is not None:
        yield finding("ball-slides-in-seat", "info", path=f"control_unit.{'pocket' if unit.pocket else 'gain_slope'}")
    if unit.balls is None:
        yield finding("balls-not-given", "info", path="control_unit.balls")
    elastic = unit.elasticity
    if result.contact_pressure is None:
        return
    if unit.static_safety is None and result.contact_force_hertz is not None:
        yield finding("static-safety-assumed", "info", value=1.0, limit=1.5, path="control_unit.static_safety")
    if unit.contact is None:
        yield finding(
            "contact-assumed", "info", value=result.contact_pressure, limit=result.allowable_pressure,
            path="control_unit.contact", modulus=elastic.wall_modulus, poisson=elastic.wall_poisson,
        )  # fmt: skip
