"""A clutch as its spec and its quantities: what an analysis that asks by name takes in the place of an engine."""

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

from ..messages import say
from ..spec.models import Spec
from .quantities import Quantities
from .selection import quantities_of


class Wired(Protocol):
    """What such an analysis takes: ``WiredClutch``, or until the last analysis is converted the old engine."""

    @property
    def spec(self) -> Spec:
        """The spec."""

    @property
    def quantities(self) -> Quantities:
        """The quantities."""


@dataclass(frozen=True)
class WiredClutch:
    """A clutch that is calculated by its laws alone."""

    spec: Spec

    @cached_property
    def quantities(self) -> Quantities:
        """Its quantities, each calculated when first asked for.

        Raises:
            SpecError: the spec describes no clutch.
        """
        return accepted(self.spec, quantities_of(self.spec))


def accepted(spec: Spec, clutch: Quantities) -> Quantities:
    """Return the quantities of a spec; refuse what its rules cannot see.

    Raises:
        SpecError: a gain below the threshold 2 R f_1/d, at which the sleeve would leave its stop at zero torque; no
            wall that holds the torque.
    """
    unit = spec.control_unit
    if not spec.kind.travels or unit is None:
        return clutch
    if clutch["net_gain"] < 0:
        message = say(
            "must be at least 2 R f_1/d = {threshold:.6g}: below that the friction at the key exceeds the release "
            "force, and the sleeve leaves its stop at zero torque",
            threshold=float(clutch["gain_threshold"]),
        )
        gain = f"{float(clutch['gain']):.6g}"
        if unit.wall_angle is not None:
            raise spec.refused("control_unit.wall_angle", message, f"(C = {gain})")
        raise spec.refused("control_unit.gain", message, gain)
    if unit.pocket is not None and not clutch["friction_leaving"] > 0:
        message = say(
            "no wall holds the torque: control_spring.force does not exceed the force of the closing spring, so "
            "that the sleeve never rests at its stop"
        )
        raise spec.refused("control_unit.pocket", message, repr(unit.pocket))
    return clutch
