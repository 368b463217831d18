"""Curves to draw: torque and trip over friction, accuracy and life over what is swept, with what stands beside them."""

from typing import Any

import numpy as np

from ..engines import Clutch
from ..equations.arrays import Floats
from ..errors import AfmcalcError, CalculationError, given
from ..result import Result, described, quantity
from ..spec.keys import is_whole
from ..spec.models import Method
from .accuracy import AccuracySweep
from .adjust import METHODS, AdjustResult
from .answers import Answers
from .asking import asked_by
from .life import LifeResult, LifeSweep, band_axis, life_sweep
from .overload import OverloadSweep, refuse
from .registry import StressRule
from .sweep import Axis, S, current_value, find_key, parse_axis, series

POINTS = 201
"""Points of a curve: enough for a line without corners on paper."""


class ClutchCurve(Result):
    """Base of a curve: the clutch that it belongs to."""

    name: str | None = described("name of the clutch", optional=True)
    variant: str = described("variant")


class TorqueCurve(ClutchCurve):
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
    nominal_torque: float = quantity("N*m", "T_н", "nominal torque of the clutch")
    margin: float = quantity("1", "β_н", "torque margin")
    method: Method = described("setting of the spec")


class AccuracyCurve(ClutchCurve):
    """Accuracy over one key; where on it the clutch is, and its gain limit, as far as the key has them."""

    series: AccuracySweep = described("accuracy over the key")
    about: str = described("what it is")
    symbol: str = described("symbol")
    unit: str = described("SI unit")
    own: float | None = described("what the clutch has of the key", optional=True)
    accuracy_factor: float = quantity("1", "K_т", "accuracy factor of the clutch as it is")
    limit: float | None = described("gain limit, as the key is called", optional=True)


class SettingLife(Result):
    """The protected side with the spring set by one method."""

    method: Method = described("method")
    scatter: float = quantity("N*m", "ΔT", "torque scatter band")
    cycles: float | None = quantity("1", "N_ц", "cycles of the protected side", null="unlimited")


class LifeCurve(ClutchCurve):
    """Life over the scatter band, and where both settings put the clutch."""

    model: StressRule = described("rule for the damaging stress")
    series: LifeSweep = described("life over the band")
    base_cycles: float = quantity("1", "N_0", "base cycles of the S-N line")
    settings: list[SettingLife] = described("both settings")


class OverloadCurve(ClutchCurve):
    """The trip over friction (S22), set at f_min, and the accuracy over the reduced gain."""

    friction: list[float] = quantity("1", "f", "coefficient of friction")
    expected_torque: list[float] = quantity("N*m", "T_муф", "expected slip torque")
    actuation_torque_published: list[float] = quantity("N*m", "T_ср", "actuation torque as published, S22 (14)")
    actuation_torque_equilibrium: list[float] = quantity(
        "N*m", "T_eq", "actuation torque at equilibrium, without misprint M12"
    )
    potential_torque: list[float] = quantity("N*m", "T_п", "potential torque at T_н.маш, upper end of the trip bracket")
    machine_torque: float = quantity("N*m", "T_н.маш", "nominal torque of the machine")
    margin: float = quantity("1", "β_н", "torque margin")
    accuracy: OverloadSweep = described("accuracy over the reduced gain")
    bypass_pairs: int = quantity("1", "z_1", "pairs that bypass the control unit")
    reduced_gain: float = quantity("1", "z_2 C", "reduced gain of the clutch")
    optimal_reduced_gain: float = quantity(
        "1", "(zC)_opt", "reduced gain with the best accuracy by the published T_ср, 1/f_max; T_eq has no optimum"
    )


def torque_curve(clutch: Clutch) -> TorqueCurve:
    """Calculate the torque from f_min to f_max, as set and by both adjustment methods for the same nominal torque."""
    path = _path(clutch)
    there = clutch.at(**path)
    friction, sustained, peak = (np.asarray(there[name]) for name in (next(iter(path)), "torque", "breakaway_torque"))
    by_min, by_mean = (clutch.at(case).at(**path)["torque"].tolist() for case in METHODS.values())
    return TorqueCurve(
        **_of(clutch),
        friction=friction.tolist(),
        friction_driving=friction.tolist() if clutch.spec.friction.unlike else None,
        torque=sustained.tolist(),
        torque_min_friction=by_min,
        torque_mean_friction=by_mean,
        breakaway_torque=peak.tolist() if (peak > sustained * (1 + 1e-9)).any() else None,
        torque_returning=there["torque_returning"].tolist() if "torque_returning" in there else None,
        nominal_torque=clutch["nominal_torque"],
        margin=clutch["margin"],
        method=clutch.spec.adjustment.method,
    )


def accuracy_curve(clutch: Clutch, sweep: str | None) -> AccuracyCurve:
    """Calculate K_т over the gain, or over the key asked for.

    A range that is given is taken as it is; one of our own is refined, and reaches the clutch as it is.
    """
    text = sweep or "C"
    axis = parse_axis(text, clutch.spec)
    # what the clutch has of the key, also where it follows from others
    follows = {"control_unit.gain": clutch["gain"], "closing_spring.force": clutch["closing_force"]}
    value = follows.get(axis.key.path, current_value(clutch.spec, axis.key.path))
    current = None if value is None else float(value) / axis.scale
    if "=" not in text and not is_whole(axis.key.path):
        ends = [float(axis.values.min()), float(axis.values.max()), *([] if current is None else [current])]
        axis = axis._replace(values=np.linspace(min(ends), max(ends), POINTS))
    limit = clutch["gain_limit"] if axis.key.path == "control_unit.gain" and "gain_limit" in clutch else None
    return AccuracyCurve(
        **_of(clutch),
        series=_over(axis, AccuracySweep, clutch),
        about="reduced gain" if axis.name == "zC" else axis.key.description,
        symbol="zC" if axis.name == "zC" else axis.key.symbol or "",
        unit=axis.key.unit or "1",
        own=current,
        accuracy_factor=clutch["accuracy_factor"],
        limit=None if limit is None else limit / axis.scale,
    )


def overload_curve(clutch: Clutch) -> OverloadCurve:
    """Calculate the trip from f_min to f_max, and the accuracy over the reduced gain.

    The gain goes from 0 to the recommended limit 5, or as far as the clutch lies beyond it.

    Raises:
        CalculationError: a variant S22 does not treat.
    """
    refuse(clutch)
    path = _path(clutch)
    trip, set_at_min = clutch.at(**path), clutch.at("overload")
    reduced = float(clutch["reduced_gain"])
    gains = Axis(
        "zC",
        find_key("C", clutch.spec),
        np.linspace(0.0, max(5.0, 1.2 * reduced), 401),
        1 / float(clutch["controlled_pairs"]),
    )
    names = ("expected_torque", "actuation_torque_published", "actuation_torque_equilibrium", "potential_torque")
    return OverloadCurve(
        **_of(clutch),
        friction=path["friction"].tolist(),
        **{name: trip[name].tolist() for name in names},
        machine_torque=set_at_min["machine_torque"],
        margin=clutch["margin"],
        accuracy=_over(gains, OverloadSweep, clutch),
        bypass_pairs=int(clutch["bypass_pairs"]),
        reduced_gain=reduced,
        optimal_reduced_gain=clutch["optimal_reduced_gain"],
    )


def life_curve(answers: Answers, sweep: str | None) -> LifeCurve:
    """Calculate the life over the scatter band, from half to twice what the clutch has, or as asked for.

    Raises:
        AfmcalcError: another key is asked for.
        CalculationError: there is no band.
    """
    clutch, text = answers.clutch, sweep or "dT"
    name = text.partition("=")[0].strip()
    if name != "dT":
        raise AfmcalcError(
            "plot life: its axis is the scatter band dT, not {name!r} (dT=RANGE sets its range)", name=name
        )
    axis = band_axis(text, clutch)
    if "=" not in text:
        low, high = float(axis.values.min()), float(axis.values.max())
        if not high > low:
            raise CalculationError("plot life: the friction does not wander, there is no band: give --sweep dT=RANGE")
        axis = axis._replace(values=np.linspace(low, high, POINTS))
    life, both = answers.of(LifeResult), answers.of(AdjustResult)
    (over,) = life_sweep(clutch, life.model, [axis], life.dynamic_factor)
    fields = {method: method.replace("-", "_") for method in METHODS}
    return LifeCurve(
        **_of(clutch),
        model=life.model,
        series=over,
        base_cycles=life.base_cycles,
        settings=[
            SettingLife(method=method, scatter=getattr(both, field).scatter, cycles=getattr(life.protected, field))
            for method, field in fields.items()
        ],
    )


def _of(clutch: Clutch) -> dict[str, Any]:
    """Name and variant of a clutch."""
    return {"name": clutch.spec.name, "variant": clutch.spec.variant}


def _over(axis: Axis, kind: type[S], clutch: Clutch) -> S:
    """Sweep over one axis what the series asks."""
    return given(series(kind, clutch.spec, [axis], asked_by(kind, clutch)))[0]


def _path(clutch: Clutch) -> dict[str, Floats]:
    """Frictions by name, those of unlike materials moving together, from their smallest to their largest values.

    Raises:
        CalculationError: they do not move.
    """
    if not any(group.max > group.min for group in clutch.spec.friction.groups):
        raise CalculationError("the friction does not wander (min = max): there is no curve over it")
    first, second = clutch.path(np.linspace(0.0, 1.0, POINTS))
    if not clutch.spec.friction.unlike:
        return {"friction": first}
    return {"friction_driving": first, "friction_driven": second}
