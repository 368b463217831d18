"""The torque of a clutch as a function of what scatters."""

from collections.abc import Sequence
from dataclasses import dataclass

from ...arrays import Values
from ...engines import Clutch, build
from ...spec import Spec
from ...spec.edit import with_value
from ...spec.tolerance import FRICTION
from .distributions import Input


@dataclass(frozen=True)
class Model:
    """A clutch and the numbers of it that scatter."""

    spec: Spec
    inputs: Sequence[Input]
    correlation: float = 0.0
    """Of f_1 and f_2."""

    @property
    def pair(self) -> tuple[int, int] | None:
        """Places of the two correlated frictions."""
        names = [each.path for each in self.inputs]
        if self.correlation and "friction.driving" in names and "friction.driven" in names:
            return names.index("friction.driving"), names.index("friction.driven")
        return None

    def clutch(self, values: Sequence[Values]) -> Clutch:
        """Engine with values (numbers or arrays) in place of those of the spec."""
        spec = self.spec
        for each, value in zip(self.inputs, values, strict=True):
            if each.path not in FRICTION:
                spec = with_value(spec, each.path.split("."), value)
        return build(spec)

    def torque(self, values: Sequence[Values], clutch: Clutch | None = None) -> Values:
        """Slip torque, N·m, at the mean friction where none scatters."""
        clutch = clutch or self.clutch(values)
        named = {each.path: value for each, value in zip(self.inputs, values, strict=True)}
        first, second = (friction.mean for friction in self.spec.friction.groups)
        torque: Values
        if self.spec.friction.unlike:
            torque = clutch.torque(named.get("friction.driving", first), named.get("friction.driven", second))
        else:
            torque = clutch.torque(named.get("friction", first))
        return torque
