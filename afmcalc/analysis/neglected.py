"""Effects that the torque law neglects, for one clutch, in numbers (handbook, chapter 13)."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any, Literal, NamedTuple

import numpy as np

from ..engines import Clutch
from ..engines.parts import following_stiffness, lost_by_wear
from ..engines.quantities import Quantities
from ..engines.selection import as_set
from ..equations import effects as law
from ..equations import pack
from ..equations.arrays import Floats, Values, zero_of
from ..errors import CalculationError, Problem, SpecError
from ..findings import Finding, finding
from ..messages import deferred, say, translate
from ..result import Answer, Result, Triple, described, quantity
from ..spec.edit import value_at
from .clutch_findings import clutch_findings

EffectName = Literal["spline-friction", "centrifugal", "wear"]
NOTICEABLE = 0.05
"""Relative change, of K_т or else of the torque, that is warned of."""
POINTS = 33
"""Frictions at which the largest and the smallest torque are looked for."""
ENDS = ("min", "mean", "max")
STEEL = 7850.0
"""Density of a ball of bearing steel (ISO 3290-1), kg/m³."""
STIFFNESS = "closing_spring.stiffness"
_MOST_PAIRS = 1000

Torque = Callable[[Floats, Floats], Floats]
"""Slip torques at f_1 and f_2, N·m."""


class Effect(Result):
    """One effect: what the torque lies between, springs as set."""

    effect: EffectName = described("effect")
    torque_low: Triple = quantity("N*m", "T_low", "smaller slip torque")
    torque_high: Triple = quantity("N*m", "T_high", "larger slip torque")
    accuracy_factor_low: float = quantity("1", "K_low", "smaller accuracy factor")
    accuracy_factor_high: float = quantity("1", "K_high", "larger accuracy factor")

    @property
    def torque_least(self) -> float:
        """Smallest slip torque, N·m."""
        return min(vars(self.torque_low).values())


class EffectsResult(Answer):
    """The law's torque, and what each effect makes of it."""

    accuracy_factor: float = quantity("1", "K_т", "accuracy factor by the law")
    torque: Triple = quantity("N*m", "T", "slip torque by the law")
    effects: list[Effect] = described("effects the law neglects")


def torque_after_wear(clutch: Clutch, result: EffectsResult) -> float | None:
    """Least torque of a pack whose lining is gone, N·m: 0 where that takes all of the force; None: not told."""
    if SOURCES["wear"].missing(clutch):
        return None
    return next((effect.torque_least for effect in result.effects if effect.effect == "wear"), 0.0)


class EffectCurve(Result):
    """One effect along the common path of f_1 and f_2."""

    effect: EffectName = described("effect")
    low: list[float] = quantity("N*m", "T_low", "smaller slip torque")
    high: list[float] = quantity("N*m", "T_high", "larger slip torque")


class EffectsCurve(Result):
    """The law's torque along the path, and what each effect makes of it."""

    name: str | None = described("name of the clutch", optional=True)
    friction: list[float] = quantity("1", "f", "coefficient of friction")
    torque: list[float] = quantity("N*m", "T", "slip torque by the law")
    effects: list[EffectCurve] = described("effects the law neglects")


class Bracket(NamedTuple):
    """Two curves that the torque lies between, or none and the reason why no clutch is left."""

    curves: Sequence[Torque]
    remarks: tuple[Finding, ...] = ()

    def ends(self, frictions: tuple[Floats, Floats]) -> list[list[float]]:
        """Smaller and larger torques at pairs of frictions, N·m."""
        return np.sort([curve(*frictions) for curve in self.curves], axis=0).tolist()


class EffectSource(NamedTuple):
    """Definition of an effect: the keys it needs, its own first, its bracket, and its name."""

    needs: tuple[str, ...]
    bracket: Callable[..., Bracket]
    """Of a clutch and the values of these keys."""
    words: str

    def missing(self, clutch: Clutch) -> list[str]:
        """Keys of the spec that are not given; a clutch of its own stiffness needs no key for it."""
        gone = [path for path in self.needs if value_at(clutch.spec, path) is None]
        return [path for path in gone if path != STIFFNESS or following_stiffness(clutch) is None]


def effects(clutch: Clutch) -> tuple[EffectsResult, list[Finding]]:
    """Put each effect that the spec gives the data of into numbers; springs stay as they are set.

    Raises:
        SpecError: the spec has the data of none.
    """
    brackets = _brackets(clutch)
    if not brackets:
        missing = SOURCES["wear"].missing(clutch)
        hint = say(
            "the spec has the data of no effect; to begin with wear, give {listed}, as afmcalc init --kind drive has "
            "them: what the other effects need, afmcalc effects then says",
            listed=", ".join(missing),
        )
        raise SpecError(clutch.spec.label, [Problem(missing[0], None, hint)])
    result = EffectsResult(
        accuracy_factor=clutch.accuracy_factor,
        torque=Triple.of(_torque(clutch, *_ends(clutch)).tolist()),
        effects=[_effect(clutch, name, bracket) for name, bracket in brackets.items() if bracket.curves],
    )
    remarks = [remark for bracket in brackets.values() for remark in bracket.remarks]
    return result, [*clutch_findings(clutch), *remarks, *_findings(clutch, result)]


def effects_curve(clutch: Clutch) -> EffectsCurve:
    """Calculate the torque over friction with every effect that the spec gives the data of.

    Raises:
        CalculationError: it gives the data of none, or the friction does not wander.
    """
    path, brackets = _path(clutch), _brackets(clutch)
    if not brackets:
        raise CalculationError("plot effects: the spec gives the data of no effect (afmcalc effects says which)")
    if all(friction[0] == friction[-1] for friction in path):
        raise CalculationError("the friction does not wander (min = max): there is no curve over it")
    courses = {name: bracket.ends(path) for name, bracket in brackets.items() if bracket.curves}
    return EffectsCurve(
        name=clutch.spec.name,
        friction=path[0].tolist(),
        torque=_torque(clutch, *path).tolist(),
        effects=[EffectCurve(effect=name, low=low, high=high) for name, (low, high) in courses.items()],
    )


def _torque(clutch: Clutch, driving: Floats, driven: Floats) -> Floats:
    """Slip torques at f_1 and f_2, N·m."""
    return np.broadcast_to(clutch.at_friction(driving, driven)["torque"], driving.shape)


def _brackets(clutch: Clutch) -> dict[EffectName, Bracket]:
    return {
        name: source.bracket(clutch, *(value_at(clutch.spec, path) for path in source.needs))
        for name, source in SOURCES.items()
        if not source.missing(clutch)
    }


def _path(clutch: Clutch) -> tuple[Floats, Floats]:
    """The common path of f_1 and f_2."""
    return clutch.path(np.linspace(0.0, 1.0, POINTS))


def _ends(clutch: Clutch) -> tuple[Floats, Floats]:
    """f_1 and f_2 at f_min, their means and f_max."""
    first, second = map(np.array, clutch.spec.friction.groups)
    return first, second


def _effect(clutch: Clutch, name: EffectName, bracket: Bracket) -> Effect:
    # largest over smallest torque along the common path of f_1 and f_2
    courses = (curve(*_path(clutch)) for curve in bracket.curves)
    least, most = sorted(float(course.max() / course.min()) for course in courses)
    low, high = map(Triple.of, bracket.ends(_ends(clutch)))
    return Effect(effect=name, torque_low=low, torque_high=high, accuracy_factor_low=least, accuracy_factor_high=most)


def _findings(clutch: Clutch, result: EffectsResult) -> Iterator[Finding]:
    """Warn of an effect on K_т, else of one on the torque; say which effects were not asked."""
    for effect in result.effects:
        by_law, low, high = result.accuracy_factor, effect.accuracy_factor_low, effect.accuracy_factor_high
        path, words = SOURCES[effect.effect].needs[0], translate(SOURCES[effect.effect].words)
        farthest = max(low, high, key=lambda factor: abs(factor / by_law - 1))
        changes = (
            getattr(torque, end) / getattr(result.torque, end) - 1
            for torque in (effect.torque_low, effect.torque_high)
            for end in ENDS
        )
        change = max(changes, key=abs)
        if abs(farthest / by_law - 1) > NOTICEABLE:
            yield finding(
                "effect-on-accuracy", "warning", value=farthest, limit=by_law, path=path, effect=words, low=low,
                high=high,
            )  # fmt: skip
        elif abs(change) > NOTICEABLE:
            yield finding("effect-on-torque", "warning", value=change, limit=NOTICEABLE, path=path, effect=words)
        if effect.effect == "wear":
            worn = effect.torque_least
            machine, nominal = float(clutch.machine_torque), float(clutch.nominal_torque)
            if worn < machine * (1 - 1e-12):
                yield finding("worn-below-machine", "warning", value=worn, limit=machine, path=path)
            elif worn < nominal * (1 - 1e-12):
                yield finding("worn-below-nominal", "info", value=worn, limit=nominal, path=path, machine=machine)
    for source in SOURCES.values():
        if gone := source.missing(clutch):
            yield finding(
                "effect-not-told", "info", path=source.needs[0], name=translate(source.words), listed=", ".join(gone)
            )


def _splines(clutch: Clutch, spline_friction: float, *radii: float) -> Bracket:
    """Discs held in their splines as the pack closes under torque, or as the balls unload a pack closed at rest.

    The controlled pairs are next to the spring (F11 fig. 1), an inner disc behind the first pair.
    """
    bypass, pairs = int(clutch.bypass_pairs), clutch.spec.friction_group.pairs
    most_force = float(clutch.pack_force_at_rest)

    def share(friction: Any, radius: Any) -> Any:
        """Share of the normal force of a pair that the spline of a disc can hold."""
        return law.spline_share(spline_friction, friction, float(clutch.mean_radius), radius)

    most = float(max(share(friction.max, radius) for friction in clutch.spec.friction.groups for radius in radii))
    if most >= 1:
        locks = finding("splines-lock", "error", value=most, limit=1.0, path="friction_group.spline_friction")
        return Bracket((), (locks,))
    if pairs > _MOST_PAIRS:
        raise CalculationError("effects: splines are followed disc by disc, at most {most:,} pairs", most=_MOST_PAIRS)
    of_discs = np.resize(radii, pairs - 1)[:, None]

    def forces(next_force: Callable[..., Floats], driving: Floats, driven: Floats) -> Floats:
        """Forces on the pairs over that of the first, from the spring on: the controlled pairs, then the others."""
        frictions = np.array([driven] * (pairs - bypass) + [driving] * bypass)
        ratios = next_force(1.0, share(frictions[:-1], of_discs), share(frictions[1:], of_discs))
        return np.cumprod(np.concatenate([np.ones_like(frictions[:1]), ratios]), axis=0)

    def counted(chain: Floats, driving: Floats, driven: Floats) -> Quantities:
        """The clutch whose pairs count by their forces, at frictions."""
        controlled, others = chain[: pairs - bypass].sum(axis=0), chain[pairs - bypass :].sum(axis=0)
        return with_pairs(clutch, others, controlled).at_friction(driving, driven)

    def closing(driving: Floats, driven: Floats) -> Floats:
        """Torques with every disc held on its way from the spring."""
        return counted(forces(law.next_force_closing, driving, driven), driving, driven)["torque"]

    def opening(driving: Floats, driven: Floats) -> Floats:
        """Torques with every disc held on its way back, none pressed more than the pack was closed with."""
        chain = forces(law.next_force_opening, driving, driven)

        def pressed(first: Floats) -> Quantities:
            return counted(np.minimum(chain, most_force / first), driving, driven)

        first = zero_of(lambda first: pressed(first)["normal_force"] - first, np.full_like(driving, most_force))
        return pressed(first)["torque"]

    return Bracket((closing, opening))


def _centrifugal(clutch: Clutch, speed: float, balls: int, diameter: float, circle: float) -> Bracket:
    """Conical pockets, as they are and with the force of balls thrown outward."""
    tangent = pack.tan_wall_angle(clutch.gain, circle, clutch.mean_radius)
    mass = law.ball_mass(STEEL, diameter / 2, math.pi)
    return _weaker(clutch, float(law.centrifugal_thrust(balls, mass, speed, circle, tangent)), "drive.speed")


def _wear(clutch: Clutch, lining: float, *_: float) -> Bracket:
    """The pack new, and with its lining gone."""
    return _weaker(clutch, float(lost_by_wear(clutch, lining)), "heat.lining")


def _weaker(clutch: Clutch, loss: float, path: str) -> Bracket:
    """The pack as it is, and with less force on it at rest, N."""
    force = float(clutch.pack_force_at_rest)
    if loss >= force:
        return Bracket((), (finding("force-used-up", "error", value=loss, limit=force, path=path),))
    name = "control_force_made" if clutch.spec.kind.travels else "closing_force"
    weakened = as_set(clutch, **{name: force - loss})
    return Bracket((partial(_torque, weakened), partial(_torque, clutch)))


def with_pairs(clutch: Clutch, bypass: Values, controlled: Values, **values: Values) -> Clutch:
    """The clutch with pairs that count in part, and other values of some quantities, its springs as they are set."""
    own = 0.0 if clutch.spec.kind.travels else bypass
    return as_set(clutch, pairs=bypass + controlled, bypass_pairs=own, **values)


SOURCES: Mapping[EffectName, EffectSource] = {
    "spline-friction": EffectSource(
        tuple(f"friction_group.{key}" for key in ("spline_friction", "inner_spline_radius", "outer_spline_radius")),
        _splines,
        deferred("discs held in their splines"),
    ),
    "centrifugal": EffectSource(
        ("drive.speed", "control_unit.balls", "control_unit.ball_diameter", "control_unit.ball_circle_radius"),
        _centrifugal,
        deferred("balls thrown against conical pockets"),
    ),
    "wear": EffectSource(("heat.lining", STIFFNESS), _wear, deferred("wear of the lining")),
}
"""Effect → where it comes from, in the order they are told."""
