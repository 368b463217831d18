"""Elastic data of the control unit's balls and pockets."""

from pydantic import Field

from .fields import Block, PoissonRatio, Stress


class Contact(Block):
    """Elastic data of ball and pocket wall, for a Hertz check beside or instead of an allowable force."""

    ball_modulus: Stress = Field(description="Young's modulus of the ball", json_schema_extra={"symbol": "E_1"})
    ball_poisson: PoissonRatio = Field(description="Poisson's ratio of the ball", json_schema_extra={"symbol": "ν_1"})
    wall_modulus: Stress = Field(description="Young's modulus of the pocket wall", json_schema_extra={"symbol": "E_2"})
    wall_poisson: PoissonRatio = Field(
        description="Poisson's ratio of the pocket wall", json_schema_extra={"symbol": "ν_2"}
    )
    allowable_pressure: Stress = Field(
        description="allowable maximum contact pressure", json_schema_extra={"symbol": "[p_0]"}
    )


HARDENED_STEEL = Contact(
    ball_modulus=206e9, ball_poisson=0.3, wall_modulus=206e9, wall_poisson=0.3, allowable_pressure=4.2e9
)
"""Assumed where neither [control_unit.contact] nor an allowable force is given; 4200 MPa: static limit of ball bearings
(ISO 76, self-aligning ball bearings 4600, other ball bearings 4200 MPa)."""
