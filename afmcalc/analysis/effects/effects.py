"""What the torque law neglects, for one clutch, in numbers (theory of the drive, section 13)."""

from collections.abc import Callable, Iterable, Iterator

from ...engines.protocol import Clutch
from ...errors import Problem, SpecError
from ...findings import Finding, finding
from ...messages import say
from ...result import Answer, Result, Triple, quantity
from .brackets import SOURCES, Bracket, EffectName, Torque

NOTICEABLE = 0.05
"""Relative change, of K_т or else of the torque, that is warned of."""
POINTS = 33
"""Frictions at which the largest and the smallest torque are looked for."""
ENDS = ("min", "mean", "max")


class Effect(Result):
    """One effect: what the torque lies between, springs as set."""

    effect: EffectName = quantity("", None, "effect")
    torque_low: Triple = quantity("N*m", "T_low", "smaller slip torque")
    torque_high: Triple = quantity("N*m", "T_high", "larger slip torque")
    accuracy_factor_low: float = quantity("1", "K_low", "smaller accuracy factor")
    accuracy_factor_high: float = quantity("1", "K_high", "larger accuracy factor")


class EffectsResult(Answer):
    """The law's torque, and what each effect makes of it."""

    accuracy_factor: float = quantity("1", "K_т", "accuracy factor by the law")
    torque: Triple = quantity("N*m", "T", "slip torque by the law")
    effects: list[Effect] = quantity("", None, "effects the law neglects")


def effects(clutch: Clutch) -> tuple[EffectsResult, list[Finding]]:
    """Put each effect that the spec gives the data of into numbers.

    Args:
        clutch: the clutch; its springs stay as they are set.

    Returns:
        The brackets and their findings.

    Raises:
        SpecError: the spec has the data of none, or an effect leaves no clutch.
    """
    brackets = {name: source.bracket(clutch) for name, source in SOURCES.items() if not source.missing(clutch)}
    if not brackets:
        problems = [
            Problem(path, None, say("required for the effect {name}; no effect has its keys", name=name))
            for name, source in SOURCES.items()
            for path in source.missing(clutch)
        ]
        raise SpecError(clutch.spec.label, problems)
    result = EffectsResult(
        accuracy_factor=clutch.accuracy_factor,
        torque=_triple(clutch, clutch.torque),
        effects=[_effect(clutch, name, bracket) for name, bracket in brackets.items() if bracket.curves],
    )
    remarks = [each for bracket in brackets.values() for each in bracket.found]
    return result, [*clutch.findings(), *remarks, *_findings(clutch, result)]


def _triple(clutch: Clutch, *curves: Torque, of: Callable[[Iterable[float]], float] = max) -> Triple:
    """The largest of some curves at the three frictions, or the smallest."""
    at = {end: [getattr(own, end) for own in clutch.friction] for end in ENDS}
    return Triple(**{end: float(of([curve(*frictions) for curve in curves])) for end, frictions in at.items()})


def _effect(clutch: Clutch, name: EffectName, bracket: Bracket) -> Effect:
    factors = sorted(_accuracy(clutch, curve) for curve in bracket.curves)
    return Effect(
        effect=name,
        torque_low=_triple(clutch, *bracket.curves, of=min),
        torque_high=_triple(clutch, *bracket.curves),
        accuracy_factor_low=factors[0],
        accuracy_factor_high=factors[1],
    )


def _accuracy(clutch: Clutch, curve: Torque) -> float:
    """Largest over smallest torque along the common path of f_1 and f_2."""
    torques = [curve(*frictions) for frictions in path_of(clutch)]
    return float(max(torques) / min(torques))


def path_of(clutch: Clutch) -> Iterator[tuple[float, float]]:
    """The common path of f_1 and f_2."""
    for number in range(POINTS):
        first, second = clutch.path(number / (POINTS - 1))
        yield float(first), float(second)


def _findings(clutch: Clutch, result: EffectsResult) -> Iterator[Finding]:
    """Warn of an effect on K_т, else of one on the torque; say which effects were not asked."""
    for own in result.effects:
        source, law = SOURCES[own.effect], result.accuracy_factor
        low, high, path = own.accuracy_factor_low, own.accuracy_factor_high, source.needs[0]
        farthest = max(low, high, key=lambda factor: abs(factor / law - 1))
        change = max(_changes(own, result.torque), key=abs)
        if abs(farthest / law - 1) > NOTICEABLE:
            yield finding(source.on_accuracy, "warning", value=farthest, limit=law, path=path, low=low, high=high)
        elif abs(change) > NOTICEABLE:
            yield finding(source.on_torque, "warning", value=change, limit=NOTICEABLE, path=path)
        if own.effect == "wear":
            yield from _worn(clutch, own, path)
    for name, source in SOURCES.items():
        if gone := source.missing(clutch):
            yield finding("effect-not-told", "info", path=source.needs[0], name=name, listed=", ".join(gone))


def _worn(clutch: Clutch, own: Effect, path: str) -> Iterator[Finding]:
    """Say where the clutch, worn, carries less than its own torque; a warning where that is less than the machine's."""
    worn = min(getattr(own.torque_low, end) for end in ENDS)
    machine, nominal = float(clutch.machine_torque), float(clutch.nominal_torque)
    if worn < machine * (1 - 1e-12):
        yield finding("worn-below-machine", "warning", value=worn, limit=machine, path=path)
    elif worn < nominal * (1 - 1e-12):
        yield finding("worn-below-nominal", "info", value=worn, limit=nominal, path=path, machine=machine)


def _changes(own: Effect, law: Triple) -> Iterator[float]:
    for torque in (own.torque_low, own.torque_high):
        yield from (getattr(torque, end) / getattr(law, end) - 1 for end in ENDS)
