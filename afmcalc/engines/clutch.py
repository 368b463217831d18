"""A clutch: its spec and its quantities; what depends on friction is asked at a friction."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from ..equations.arrays import is_array, larger, smaller
from ..equations.effects import force_lost_by_wear
from ..messages import say
from ..spec.models import Range, Spec
from .quantities import Quantities
from .selection import as_set

if TYPE_CHECKING:
    from .springs import SetSpring


@dataclass(frozen=True, eq=False)
class Clutch:
    """A spec and its quantities, numbers or arrays; what is not defined here is the quantity of that name."""

    spec: Spec
    quantities: Quantities

    def __getattr__(self, name: str) -> Any:
        """Return a quantity that depends on no friction."""
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self.quantities, name)

    def __getitem__(self, name: str) -> Any:
        """Return a quantity, also in a case."""
        return self.quantities[name]

    @cached_property
    def friction(self) -> tuple[Range, Range]:
        """Ranges of f_1 and f_2, twice the same with one material."""
        groups = ("driving", "driven")
        first, second = (
            Range(*(self[f"friction_{group}_{end}"] for end in ("min", "mean", "max"))) for group in groups
        )
        return first, second

    def path(self, share: Any) -> tuple[Any, Any]:
        """f_1 and f_2 at a share (0…1) of the common path, on which both rise from minimum through mean to maximum."""
        first, second = self.friction
        if not self.spec.friction.unlike:
            return (first.min + share * (first.max - first.min),) * 2
        bend = self["bend_of_path"]
        below, above = smaller(share / bend, 1.0), larger((share - bend) / (1 - bend), 0.0)
        one, two = (own.min + below * (own.mean - own.min) + above * (own.max - own.mean) for own in (first, second))
        return one, two

    # at a friction: a number or an array, f_1 of the driving pairs where f_2 is given

    def at(self, friction: Any, friction_driven: Any = None) -> Quantities:
        """Quantities at a friction of all pairs, or at f_1 and f_2.

        Raises:
            ValueError: negative friction, or two different ones where all pairs are alike.
        """
        first = second = _checked(friction)
        if friction_driven is not None and friction_driven is not friction:
            second = _checked(friction_driven)
        same: Any = first is second or first == second
        if self.spec.friction.unlike or (not self.spec.kind.travels and first is not second):
            return self.quantities.at(friction_driving=first, friction_driven=second)
        if not (bool(same.all()) if is_array(same) else same):
            raise ValueError(say("an indirect clutch has one friction for all pairs"))
        return self.quantities.at(friction=first)

    def torque(self, friction: Any, friction_driven: Any = None) -> Any:
        """Sustained slip torque, N·m."""
        return self.at(friction, friction_driven)["torque"]

    def breakaway_torque(self, friction: Any, friction_driven: Any = None) -> Any:
        """Upper bound of the breakaway torque, N·m."""
        return self.at(friction, friction_driven)["breakaway_torque"]

    def normal_force(self, friction: Any, friction_driven: Any = None) -> Any:
        """Normal force on the pairs, N."""
        return self.at(friction, friction_driven)["normal_force"]

    # springs

    @cached_property
    def following_spring(self) -> "SetSpring":
        """The spring that extends as the pack wears: of an indirect clutch the control one, as the stop moves along."""
        from .springs import DiscCharacteristic, SetSpring

        name, spring = "control" if self.spec.kind.travels else "closing", self.spec.closing_spring
        coil = None if self.spec.kind.travels else spring.coil
        stiffness = self.quantities.get(f"{name}_stiffness", coil and coil.rate)
        disc = self.quantities.given.get(f"{name}_disc")
        noted = disc and DiscCharacteristic(disc.part, self.quantities.apply)
        return SetSpring(self["pack_force_at_rest"], stiffness, noted)

    @property
    def following_stiffness(self) -> Any:
        """Stiffness of ``following_spring``, N/m; None where the spec does not give it."""
        spring = self.following_spring
        return spring.straight_stiffness if spring.disc is None else spring.stiffness(0.0)

    def lost_by_wear(self, wear: Any) -> Any:
        """Force that the pack loses when every pair wears by ``wear``, N; needs the stiffness of the spring."""
        spring, pairs = self.following_spring, self.spec.friction_group.pairs
        if spring.disc is None:
            return self.quantities.apply(force_lost_by_wear, spring.straight_stiffness, pairs, wear)
        return spring.set_force - spring.force(-smaller(pairs * wear, spring.deflection))

    def held(self, **values: Any) -> "Clutch":
        """The same clutch with other values of some quantities; its springs and pockets stay as they are."""
        return Clutch(self.spec, as_set(self.quantities, **values))


def _checked(friction: Any) -> Any:
    if isinstance(friction, list | tuple):
        import numpy as np

        friction = np.asarray(friction, float)
    if isinstance(friction, int | float) and not isinstance(friction, bool):
        if 0 <= friction < math.inf:
            return friction
    elif hasattr(friction, "dtype"):
        if friction.dtype.kind not in "fiu":
            raise ValueError(say("friction must be numbers, not an array of {dtype}", dtype=friction.dtype))
        if friction.size and not friction.min() >= 0:
            raise ValueError(say("friction must be at least 0 everywhere"))
        return friction
    raise ValueError(
        say("friction must be a finite number, at least 0, or an array of such; got {value!r}", value=friction)
    )
