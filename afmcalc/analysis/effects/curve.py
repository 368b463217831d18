"""What a picture of the effects shows."""

from ...engines.protocol import Clutch
from ...errors import CalculationError
from ...messages import say
from ...result import Result, quantity
from .brackets import SOURCES, EffectName
from .effects import path_of


class EffectCurve(Result):
    """One effect along the common path of f_1 and f_2."""

    effect: EffectName = quantity("", None, "effect")
    low: list[float] = quantity("N*m", "T_low", "smaller slip torque")
    high: list[float] = quantity("N*m", "T_high", "larger slip torque")


class EffectsCurve(Result):
    """The law's torque and what each effect makes of it."""

    name: str | None = quantity("", None, "name of the clutch", optional=True)
    friction: list[float] = quantity("1", "f", "coefficient of friction")
    torque: list[float] = quantity("N*m", "T", "slip torque by the law")
    effects: list[EffectCurve] = quantity("", None, "effects the law neglects")


def effects_curve(clutch: Clutch) -> EffectsCurve:
    """Calculate the torque over friction with every effect that the spec gives the data of.

    Raises:
        CalculationError: it gives the data of none, or the friction does not wander.
    """
    path = list(path_of(clutch))
    brackets = {name: source.bracket(clutch) for name, source in SOURCES.items() if not source.missing(clutch)}
    if not brackets:
        raise CalculationError(say("plot effects: the spec gives the data of no effect (afmcalc effects says which)"))
    if path[0] == path[-1]:
        raise CalculationError(say("the friction does not wander (min = max): there is no curve over it"))
    found = []
    for name, bracket in brackets.items():
        if not bracket.curves:
            continue
        both = [sorted(float(curve(*frictions)) for curve in bracket.curves) for frictions in path]
        found.append(EffectCurve(effect=name, low=[low for low, _ in both], high=[high for _, high in both]))
    return EffectsCurve(
        name=clutch.spec.name,
        friction=[frictions[0] for frictions in path],
        torque=[float(clutch.torque(*frictions)) for frictions in path],
        effects=found,
    )
