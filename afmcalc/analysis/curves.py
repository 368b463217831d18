"""Curves over friction: the torque by each setting, and the trip with a torque margin."""

from typing import TYPE_CHECKING, Any

from ..engines.protocol import Clutch
from ..errors import CalculationError
from ..result import Result, quantity
from ..spec.paths import is_whole
from .adjust import METHODS, set_by
from .overload import Actuation, refuse
from .sweep.axes import current_value, parse_axis
from .sweep.grid import Axis

if TYPE_CHECKING:
    from numpy.typing import NDArray

POINTS = 201
"""Points of a curve: enough for a line without corners on paper."""


class TorqueCurve(Result):
    """Slip torque along the common path of f_1 and f_2."""

    friction: list[float] = quantity("1", "f", "coefficient of friction")
    friction_driving: list[float] | None = quantity("1", "f_1", "friction of the driving pairs", optional=True)
    torque: list[float] = quantity("N*m", "T", "slip torque, spring as set")
    torque_min_friction: list[float] = quantity("N*m", "T_1", "slip torque, set at f_min")
    torque_mean_friction: list[float] = quantity("N*m", "T_2", "slip torque, set at mean f with margin")
    breakaway_torque: list[float] | None = quantity(
        "N*m", "P", "breakaway torque, upper bound (gain above its limit)", optional=True
    )
    torque_returning: list[float] | None = quantity(
        "N*m", "T_ret", "slip torque, friction falling again under load", optional=True
    )


class OverloadCurve(Result):
    """The trip over friction (S22), set at f_min."""

    friction: list[float] = quantity("1", "f", "coefficient of friction")
    expected_torque: list[float] = quantity("N*m", "T_муф", "expected slip torque")
    actuation_torque_published: list[float] = quantity("N*m", "T_ср", "actuation torque as published, S22 (14)")
    actuation_torque_equilibrium: list[float] = quantity("N*m", "T_eq", "actuation torque at equilibrium (M12)")
    potential_torque: list[float] = quantity("N*m", "T_п", "potential torque at T_н.маш, upper end of the trip bracket")


def torque_curve(clutch: Clutch) -> TorqueCurve:
    """Calculate the torque from f_min to f_max, as set and by both adjustment methods for the same nominal torque."""
    path = _path(clutch)
    nominal = float(clutch.nominal_torque)
    by_method = [set_by(clutch.spec, method, nominal).torque(*path).tolist() for method in METHODS]
    returning = clutch.torque_returning(path[0])
    return TorqueCurve(
        friction=path[0].tolist(),
        friction_driving=path[0].tolist() if clutch.spec.friction.unlike else None,
        torque=clutch.torque(*path).tolist(),
        torque_min_friction=by_method[0],
        torque_mean_friction=by_method[1],
        breakaway_torque=_breakaway(clutch, path),
        torque_returning=None if returning is None else returning.tolist(),
    )


def overload_curve(clutch: Clutch) -> OverloadCurve:
    """Calculate the trip from f_min to f_max.

    Raises:
        CalculationError: a variant S22 does not treat.
    """
    refuse(clutch)
    friction = _path(clutch)[0]
    trip = Actuation(clutch, friction)
    return OverloadCurve(
        friction=friction.tolist(),
        expected_torque=trip.expected.tolist(),
        actuation_torque_published=trip.published.tolist(),
        actuation_torque_equilibrium=trip.equilibrium.tolist(),
        potential_torque=trip.potential.tolist(),
    )


def swept(text: str, clutch: Clutch) -> tuple[Axis, float | None]:
    """Read a sweep for a curve, and say where on it the clutch is.

    A range that is given is taken as it is; one of our own is refined, and reaches the clutch as it is.
    """
    import numpy as np

    axis = parse_axis(text, clutch.spec)
    own = _own_value(axis, clutch)
    if "=" in text or is_whole(axis.key.path):
        return axis, own
    ends = [float(axis.values.min()), float(axis.values.max()), *([] if own is None else [own])]
    return axis._replace(values=np.linspace(min(ends), max(ends), POINTS)), own


def _own_value(axis: Axis, clutch: Clutch) -> float | None:
    """What the clutch has of a swept key, also where it follows from others."""
    follows = {"control_unit.gain": clutch.gain, "closing_spring.force": clutch.closing_force}
    value = follows.get(axis.key.path, current_value(clutch.spec, axis.key.path))
    return None if value is None else float(value) / axis.scale


def _path(clutch: Clutch) -> "tuple[NDArray[Any], NDArray[Any]]":
    """f_1 and f_2 moving together from their smallest to their largest values.

    Raises:
        CalculationError: they do not move.
    """
    import numpy as np

    if not any(own.max > own.min for own in clutch.friction):
        raise CalculationError("the friction does not wander (min = max): there is no curve over it")

    first, second = (np.linspace(own.min, own.max, POINTS) for own in clutch.friction)
    return first, second


def _breakaway(clutch: Clutch, path: "tuple[NDArray[Any], NDArray[Any]]") -> list[float] | None:
    """Breakaway torque where it exceeds the sustained one anywhere."""
    peak, sustained = clutch.breakaway_torque(*path), clutch.torque(*path)
    return peak.tolist() if bool((peak > sustained * (1 + 1e-9)).any()) else None
