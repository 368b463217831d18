"""The torque of a clutch as a function of what scatters."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ...arrays import Values
from ...engines import Clutch, build, geometry
from ...equations import indirect
from ...spec import Spec
from ...spec.edit import with_values
from ...spec.tolerance import FRICTION
from .distributions import Input

_IN_NET_GAIN = ("friction_group.", "control_unit.")
_RADII = ("friction_group.inner_radius", "friction_group.outer_radius")


@dataclass(frozen=True)
class Model:
    """A clutch and the numbers of it that scatter."""

    spec: Spec
    inputs: Sequence[Input]
    correlation: float = 0.0
    """Of the normal scores of f_1 and f_2."""

    @property
    def pair(self) -> tuple[int, int] | None:
        """Places of the two correlated frictions."""
        names = [each.path for each in self.inputs]
        if self.correlation and "friction.driving" in names and "friction.driven" in names:
            return names.index("friction.driving"), names.index("friction.driven")
        return None

    @cached_property
    def may_fail(self) -> bool:
        """Whether there may be samples that are no clutch."""
        causes = _IN_NET_GAIN if self.spec.kind.law == "indirect" else _RADII
        return any(each.path.startswith(causes) for each in self.inputs)

    def possible(self, values: Sequence[Values]) -> NDArray[np.bool_]:
        """Which samples are a clutch: feedback overcomes the friction at the key, the faces have a width."""
        spec = self._spec(values)
        group, unit = spec.friction_group, spec.control_unit
        found: NDArray[np.bool_] = np.ones(np.shape(values[0]), np.bool_)
        if group.inner_radius is not None and group.outer_radius is not None:
            found &= group.inner_radius < group.outer_radius
        if spec.kind.law == "indirect" and unit is not None:
            assert unit.key_friction is not None
            assert unit.hub_diameter is not None
            radius = geometry.mean_radius(spec)
            found &= indirect.net_gain(geometry.feedback_gain(spec), radius, unit.key_friction, unit.hub_diameter) > 0
        return found

    def clutch(self, values: Sequence[Values]) -> Clutch:
        """Engine with values (numbers or arrays) in place of those of the spec."""
        return build(self._spec(values))

    def _spec(self, values: Sequence[Values]) -> Spec:
        given = zip(self.inputs, values, strict=True)
        return with_values(
            self.spec, ((each.path.split("."), value) for each, value in given if each.path not in FRICTION)
        )

    def torque(self, values: Sequence[Values], clutch: Clutch | None = None) -> Values:
        """Slip torque, N·m."""
        named = {each.path: value for each, value in zip(self.inputs, values, strict=True)}
        return self.torque_of(clutch or self.clutch(values), named)

    def torque_of(self, clutch: Clutch, named: Mapping[str, Values]) -> Values:
        """Slip torque of a clutch, N·m, at the frictions named; at the mean where none is."""
        first, second = self.frictions(named)
        torque: Values = clutch.torque(first, second) if self.spec.friction.unlike else clutch.torque(first)
        return torque

    def frictions(self, named: Mapping[str, Values]) -> tuple[Values, Values]:
        """f_1 and f_2 as named, twice the same with one material; the mean where none is."""
        first, second = (friction.mean for friction in self.spec.friction.groups)
        if self.spec.friction.unlike:
            return named.get("friction.driving", first), named.get("friction.driven", second)
        alike = named.get("friction", first)
        return alike, alike
