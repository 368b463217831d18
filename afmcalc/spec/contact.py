"""Elastic data of the control unit's balls and pockets."""

from pydantic import Field

from .fields import Block, PoissonRatio, Stress


class Contact(Block):
    """Elastic data of ball and pocket wall, for a Hertz check where no allowable force is given."""

    ball_modulus: Stress = Field(description="Young's modulus of the ball", json_schema_extra={"symbol": "E_1"})
    ball_poisson: PoissonRatio = Field(description="Poisson's ratio of the ball", json_schema_extra={"symbol": "ν_1"})
    wall_modulus: Stress = Field(description="Young's modulus of the pocket wall", json_schema_extra={"symbol": "E_2"})
    wall_poisson: PoissonRatio = Field(
        description="Poisson's ratio of the pocket wall", json_schema_extra={"symbol": "ν_2"}
    )
    allowable_pressure: Stress = Field(
        description="allowable maximum contact pressure", json_schema_extra={"symbol": "[p_0]"}
    )
