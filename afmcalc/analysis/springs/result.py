"""What is told of springs."""

from typing import Literal

from ...engines.wish import SpringName
from ...result import Answer, Result, quantity

Kind = Literal["disc", "coil"]


class SpringOption(Result):
    """A part that gives the force, and what else it gives."""

    number: int | None = quantity("", None, "number", optional=True)
    spring: SpringName | None = quantity("", None, "spring", optional=True)
    kind: Kind = quantity("", None, "kind", detail=True)
    part: str = quantity("", None, "part")
    parallel: int | None = quantity("1", "n", "discs laid into each other")
    series: int | None = quantity("1", "i", "packs against each other")
    count: int | None = quantity("1", "n_п", "springs around the shaft")
    turns: float | None = quantity("1", "n_w", "active turns")
    outer_diameter: float = quantity("m", "D_e", "outer diameter", detail=True)
    inner_diameter: float = quantity("m", "D_i", "inner diameter", detail=True)
    force: float = quantity("N", "F", "force as set", detail=True)
    force_least: float | None = quantity("N", "F_1", "least force in service", detail=True, null="slack")
    force_largest: float = quantity("N", "F_2", "largest force in service", detail=True)
    stiffness: float = quantity("N/m", "c", "stiffness as set")
    deflection: float = quantity("m", "s", "deflection as set", detail=True)
    length_set: float = quantity("m", "L", "length as set")
    length: float = quantity("m", "L_1", "largest length in service, let go as far as it is")
    free_length: float = quantity("m", "L_0", "length without load", detail=True)
    used_low: float = quantity("1", "s_1/s_c", "least deflection in service over that pressed flat or solid")
    used_high: float = quantity("1", "s_2/s_c", "largest deflection in service over that pressed flat or solid")
    loading: Literal["static", "dynamic"] | None = quantity("", None, "loading of a coil", optional=True)
    stress_correction: float | None = quantity(
        "1", "k_τ", "factor of the coil's curvature in the stress, 1 of one that rests", optional=True, detail=True
    )
    stress: float = quantity("Pa", "σ, τ", "largest stress in service: tension of a disc, shear of a wire")
    stress_middle: float | None = quantity(
        "Pa", "σ_OM", "stress where the section of a disc turns", optional=True, detail=True
    )
    stress_solid: float | None = quantity(
        "Pa", "τ_c", "shear stress of a wire, solid, without k_τ", optional=True, detail=True
    )
    utilisation: float = quantity(
        "1", "η", "largest share used: of the range of deflection, of the stress allowed", detail=True
    )
    loss_per_travel: float = quantity("1/m", "c/F", "share of the force lost per travel of the spring")
    loss_per_wear: float | None = quantity(
        "1/m", "c z/F", "share of the force lost per wear of a pair", optional=True, detail=True
    )
    travel_setting: float = quantity("m", "s_5%", "travel of the nut from 95 to 105 % of the force", detail=True)
    turns_setting: float | None = quantity("1", "ν_5%", "turns of the nut from 95 to 105 % of the force")
    force_up: float | None = quantity("N", "F_↓", "force that friction asks for when pressed", detail=True)
    force_down: float | None = quantity("N", "F_↑", "force that friction leaves when let go", detail=True)
    mass: float = quantity("kg", "m_s", "mass")


class SpringsResult(Answer):
    """Parts that give forces and stiffnesses of the springs, the best first."""

    closing_force: float = quantity("N", "F_п", "force wanted of the closing spring")
    closing_stiffness: float | None = quantity("N/m", "c_1", "stiffness wanted", null="any", optional=True)
    closing_found: int = quantity("", None, "parts found for it")
    control_force: float | None = quantity("N", "F_п2", "force wanted of the control spring", optional=True)
    control_stiffness: float | None = quantity("N/m", "c_2", "stiffness wanted of it", null="any", optional=True)
    control_found: int | None = quantity("", None, "parts found for it", optional=True)
    closing: list[SpringOption] = quantity("", None, "closing spring")
    control: list[SpringOption] | None = quantity("", None, "control spring", optional=True)
    named: list[SpringOption] | None = quantity("", None, "springs that the spec names", optional=True)
    utilisation: float | None = quantity(
        "1",
        "η",
        "largest share that these use: of the range of deflection, of the stress allowed",
        optional=True,
        detail=True,
    )
    nearest: list[SpringOption] | None = quantity("", None, "nearest, where there is none", optional=True)
