"""The part whose life is asked for: the [fatigue] block of a spec."""

from pydantic import Field

from .fields import Block, Coefficient, Ratio, SectionModulus, Stress, TorqueOrNone, key_field


class Fatigue(Block):
    """The part whose life is asked for."""

    endurance_limit: Stress = Field(description="endurance limit in shear", json_schema_extra={"symbol": "τ_limb"})
    polar_section_modulus: SectionModulus = Field(
        description="polar section modulus", json_schema_extra={"symbol": "W_p"}
    )
    exponent: Coefficient = Field(description="exponent of the S-N line", json_schema_extra={"symbol": "m_τ"})
    mean_stress_sensitivity: Ratio | None = key_field("sensitivity to the mean stress (model amplitude)", "ψ_τ")
    ultimate_strength: Stress | None = key_field("ultimate strength in shear (model goodman)", "τ_u")
    base_cycles: Coefficient = Field(description="base cycles of the S-N line", json_schema_extra={"symbol": "N_0"})
    load_low: TorqueOrNone = key_field(
        "torque from which a slip swings the load and to which it falls back (amplitude, goodman)", "T_low", default=0.0
    )
