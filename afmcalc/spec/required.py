"""The [requirements] block: what a clutch is to hold."""

from typing import Annotated

from pydantic import model_validator

from ..messages import say
from . import rules
from .fields import AtLeastOne, Block, Coefficient, Length, Quantity, Ratio, Stress, Torque, key_field
from .heat import Temperature

Probability = Annotated[float, Quantity("1", gt=0, lt=1)]
SpecificWork = Annotated[float, Quantity("J/m^2", gt=0)]


class Required(Block):
    """What a clutch is to hold; each key is a row of ``check`` and of the report."""

    nominal_torque: Torque | None = key_field("nominal torque of the clutch, at least", "T_н")
    machine_torque: Torque | None = key_field(
        "nominal torque of the machine, at least: the clutch's over the margin", "T_н.маш"
    )
    accuracy_factor: AtLeastOne | None = key_field("accuracy factor, at most", "K_т")
    accuracy_factor_hysteresis: AtLeastOne | None = key_field(
        "accuracy factor under a load that lasts, at most", "K_т,h"
    )
    torque_max: Torque | None = key_field("largest sustained torque, at most", "T_max")
    outer_diameter: Length | None = key_field("outer diameter of the friction faces, at most", "2 r_o")
    surface_pressure: Stress | None = key_field("mean surface pressure at rest, at most; needs both radii", "p")
    travel: Length | None = key_field("largest travel of the sleeve, at most (indirect)", "x_max")
    reduced_gain: Ratio | None = key_field("reduced gain, at most", "z_2 C")
    peak_torque: Torque | None = key_field("peak torque in the shaft, at most (simulate)", "T_peak")
    exceedance: Probability | None = key_field(
        "probability that the torque exceeds T_max, at most (tolerance)", "P(T>T_max)"
    )
    work: SpecificWork | None = key_field("specific work of a trip, at most (heat)", "q_A")
    temperature: Temperature | None = key_field("mean temperature of the discs after one trip, at most (heat)", "Θ")
    face_temperature: Temperature | None = key_field(
        "largest temperature of the faces in one trip, at most (heat)", "Θ_s"
    )
    contact_pressure: Stress | None = key_field(
        "largest contact pressure of ball and wall, at most (synthesize)", "p_0"
    )
    cycles: Coefficient | None = key_field("life in cycles on either side of the clutch, at least", "N_ц")

    @model_validator(mode="after")
    def _of_a_limit(self) -> "Required":
        if self.exceedance is not None and self.torque_max is None:
            message = say("required beside {other}", other="requirements.exceedance")
            raise rules.RuleError([rules.wrong("torque_max", message)])
        return self
