"""The torque of a clutch as a function of what scatters, its springs as made or adjusted for each sample."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ...arrays import Values
from ...engines import Clutch, build, parameters
from ...equations import indirect
from ...errors import Problem, SpecError
from ...messages import say
from ...spec import Spec
from ...spec.edit import with_key, with_values
from ...spec.tolerance import FRICTION, Tolerance
from ..slips import dynamic_factor
from .distributions import Array, Input

_ONLY_SETTING = ("adjustment.", *(f"friction.{end}" for end in ("min", "mean", "max", "driving.", "driven.")))
"""Keys that act on a clutch through its setting alone."""
_CONTROL_FORCE = "control_spring.force"


@dataclass(frozen=True)
class Model:
    """A clutch and the numbers of it that scatter."""

    spec: Spec
    inputs: Sequence[Input]
    correlation: float = 0.0
    """Of the normal scores of f_1 and f_2."""

    @property
    def pair(self) -> tuple[int, ...]:
        """Places of the two correlated frictions; empty where they are independent."""
        paths = [scattering.path for scattering in self.inputs]
        if self.correlation and "friction.driving" in paths and "friction.driven" in paths:
            return paths.index("friction.driving"), paths.index("friction.driven")
        return ()

    @cached_property
    def centers(self) -> list[float]:
        """Center of each number that scatters."""
        return [scattering.center for scattering in self.inputs]

    @cached_property
    def may_fail(self) -> bool:
        """Whether there may be samples that are no clutch."""
        causes: tuple[str, ...] = ("friction_group.inner_radius", "friction_group.outer_radius")
        if self.spec.kind.law == "indirect":
            causes = ("friction_group.", "control_unit.")  # whatever the net gain depends on
        return any(scattering.path.startswith(causes) for scattering in self.inputs)

    def possible(self, values: Sequence[Values]) -> NDArray[np.bool_]:
        """Which samples are a clutch: feedback overcomes the friction at the key, the faces have a width."""
        spec = self._spec(values)
        group, unit = spec.friction_group, spec.control_unit
        possible: NDArray[np.bool_] = np.ones(np.shape(values[0]), np.bool_)
        if group.inner_radius is not None and group.outer_radius is not None:
            possible &= group.inner_radius < group.outer_radius
        if spec.kind.law == "indirect" and unit is not None:
            assert unit.key_friction is not None
            assert unit.hub_diameter is not None
            radius = parameters.mean_radius(spec)
            possible &= (
                indirect.net_gain(parameters.feedback_gain(spec), radius, unit.key_friction, unit.hub_diameter) > 0
            )
        return possible

    def clutches_of(self, values: Sequence[Array]) -> Sequence[Array]:
        """Leave out the samples that are no clutch."""
        if not self.may_fail:
            return values
        possible = self.possible(values)
        return values if possible.all() else [column[possible] for column in values]

    def clutch(self, values: Sequence[Values]) -> Clutch:
        """Engine with values (numbers or arrays) in place of those of the spec."""
        return build(self._spec(values))

    def _spec(self, values: Sequence[Values]) -> Spec:
        keys = {path: value for path, value in self.by_path(values).items() if path not in FRICTION}
        return with_values(self.spec, keys)

    def by_path(self, values: Sequence[Values]) -> dict[str, Values]:
        """Values by the path of what scatters."""
        return {scattering.path: value for scattering, value in zip(self.inputs, values, strict=True)}

    def torque(self, values: Sequence[Values]) -> Values:
        """Slip torque, N·m."""
        return self.clutch(values).torque(*self.frictions(self.by_path(values)))

    def torque_along(self, u: Array) -> Array:
        """Slip torque with every number that scatters at each probability of an array, N·m."""
        return np.broadcast_to(self.torque([scattering.quantiles(u) for scattering in self.inputs]), u.shape)

    def frictions(self, named: Mapping[str, Values]) -> tuple[Values, Values]:
        """f_1 and f_2 as named, twice the same with one material; the mean where none is."""
        driving, driven = self.spec.friction.groups
        if self.spec.friction.unlike:
            return named.get("friction.driving", driving.mean), named.get("friction.driven", driven.mean)
        alike = named.get("friction", driving.mean)
        return alike, alike


def with_setting(clutch: Clutch, given: Tolerance) -> Spec:
    """Return the spec of the samples: as-made the springs of the nominal clutch, each-adjusted those a sample needs.

    Raises:
        SpecError: a field scatters that this clutch does not have, or that could have no effect.
    """
    as_made, unlike = given.setting == "as-made", clutch.spec.friction.unlike
    for path in given.fields:
        if path in FRICTION and (path == "friction") == unlike:
            use = say("friction.driving and friction.driven") if unlike else "friction"
            message = say("this clutch has {use} instead", use=use)
        elif as_made and path.startswith(_ONLY_SETTING):
            message = say(
                'acts through the setting alone, which "as-made" holds: give tolerance.setting = "each-adjusted"'
            )
        elif not as_made and path == _CONTROL_FORCE:
            message = say('follows from the setting of each clutch: give tolerance.setting = "as-made"')
        else:
            continue
        raise SpecError(clutch.spec.label, [Problem(f"tolerance.fields.{path}", None, message)])
    spec = clutch.spec
    if spec.fatigue is not None:
        # the life of every sample takes that of the nominal clutch
        spec = with_values(spec, {"drive.dynamic_factor": dynamic_factor(clutch)})
    if as_made:
        spec = with_key(spec, "closing_spring.force", float(clutch.closing_force))
    if clutch.sleeve is not None:
        spec = with_values(spec, {_CONTROL_FORCE: float(clutch.sleeve.control_force) if as_made else None})
    if clutch.sleeve is not None and clutch.sleeve.gain_slope:
        # pockets are cut once, for the nominal clutch
        spec = with_key(spec, "control_unit.gain_slope", float(clutch.sleeve.gain_slope))
    return spec
