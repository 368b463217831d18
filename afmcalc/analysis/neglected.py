"""Effects that the torque law neglects, for one clutch, in numbers (handbook, chapter 13)."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
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
from ..errors import CalculationError
from ..findings import Finding, finding
from ..messages import deferred, say, translate
from ..result import Answer, Result, Triple, described, quantity
from ..spec.edit import value_at
from ..spec.models import PressureDiscKey
from ..spec.write import lacking
from ..variants import foreign_keys
from .clutch_findings import clutch_findings, speed_findings
from .drive_result import ends_of

EffectName = Literal["spline-friction", "centrifugal", "wear", "pressure-disc-key"]
NOTICEABLE = 0.05
"""Relative change of the accuracy factor, or else of the torque, above which there is a warning."""
POINTS = 33
"""Number of friction values at which the largest and the smallest torque are searched."""
STEEL = 7850.0
"""Density of a ball of bearing steel (ISO 3290-1), kg/m³."""
STIFFNESS, _SPEED = "closing_spring.stiffness", "drive.speed"
_MOST_PAIRS = 1000

Torque = Callable[[Floats, Floats], Floats]
"""Function that returns the slip torques at the frictions f_1 and f_2, N·m."""


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
    """Least slip torque with the lining worn off, N·m; 0 if no force is left, None if the spec lacks data for wear."""
    if SOURCES["wear"].missing(clutch):
        return None
    return next((effect.torque_least for effect in result.effects if effect.effect == "wear"), 0.0)


Bracket = tuple[Sequence[Torque], Sequence[Finding]]
"""Curves between which the torque lies under an effect, and findings; no curves if the clutch then fails."""


class EffectSource(NamedTuple):
    """Definition of an effect: the spec keys that it needs, the ``Bracket`` of its torques, and its name in words."""

    needs: tuple[str, ...]
    bracket: Callable[..., Bracket]
    """Function that returns the bracket for a clutch and the values of the keys in ``needs``."""
    words: str

    def missing(self, clutch: Clutch) -> list[str]:
        """Keys in ``needs`` that the spec lacks; a stiffness that a spring part gives is not missing."""
        gone = [path for path in self.needs if _value(clutch, path) is None]
        return [path for path in gone if path != STIFFNESS or following_stiffness(clutch) is None]


def _value(clutch: Clutch, path: str) -> Any:
    """Value of a key that an effect needs; the speed may come from the rating plate of the motor."""
    return clutch.spec.speed if path == _SPEED else value_at(clutch.spec, path)


def effects(clutch: Clutch) -> tuple[EffectsResult, list[Finding]]:
    """Calculate each effect for which the spec has the data (else SpecError); the springs stay as they are set."""
    told = {name: source for name, source in SOURCES.items() if not source.missing(clutch)}
    if not told:
        begun = [source for source in SOURCES.values() if source.needs[0] != _SPEED and _value(clutch, source.needs[0])]
        listed, paths = _wanting(clutch, begun or SOURCES.values())
        needs = "\n  ".join([say("the data of one effect at least:"), *listed])
        raise lacking(clutch.spec, "effects", needs, "drive", paths)
    # accuracy factor: largest over smallest torque as f_1 and f_2 rise together
    path, (first, second) = clutch.path(np.linspace(0.0, 1.0, POINTS)), map(np.array, clutch.spec.friction.groups)
    found, remarks = list[Effect](), [*speed_findings(clutch.spec)] if "centrifugal" in told else []
    for name, source in told.items():
        curves, said = source.bracket(clutch, *(_value(clutch, path) for path in source.needs))
        remarks += said
        if curves:
            factors = sorted(float(course.max() / course.min()) for course in (curve(*path) for curve in curves))
            torques = np.sort([curve(first, second) for curve in curves], axis=0)
            ends = {"torque_low": ends_of(torques[0].tolist()), "torque_high": ends_of(torques[-1].tolist())}
            effect = Effect(effect=name, **ends, accuracy_factor_low=factors[0], accuracy_factor_high=factors[-1])
            found.append(effect)
    torque = ends_of(_torque(clutch, first, second).tolist())
    result = EffectsResult(accuracy_factor=clutch.accuracy_factor, torque=torque, effects=found)
    return result, [*clutch_findings(clutch), *remarks, *_findings(clutch, result)]


def _torque(clutch: Clutch, driving: Floats, driven: Floats) -> Floats:
    """Slip torques at f_1 and f_2, N·m."""
    return np.broadcast_to(clutch.at_friction(driving, driven)["torque"], driving.shape)


def _findings(clutch: Clutch, result: EffectsResult) -> Iterator[Finding]:
    """Yield a warning for each effect on the accuracy factor, else on the torque; a note on effects without data."""
    for effect in result.effects:
        by_law, low, high = result.accuracy_factor, effect.accuracy_factor_low, effect.accuracy_factor_high
        path, words = SOURCES[effect.effect].needs[0], translate(SOURCES[effect.effect].words)
        farthest = max(low, high, key=lambda factor: abs(factor / by_law - 1))
        torques = np.array([[*vars(each).values()] for each in (effect.torque_low, effect.torque_high)])
        change = max((torques / [*vars(result.torque).values()] - 1).ravel().tolist(), key=abs)
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
    listed, paths = _wanting(clutch, SOURCES.values())
    if listed:
        yield finding("effect-not-told", "info", path=paths[0], listed="; ".join(listed))


def _wanting(clutch: Clutch, sources: Iterable[EffectSource]) -> tuple[list[str], list[str]]:
    """Effects that lack keys of the spec, each with these keys; and all these keys."""
    gone = {source.words: source.missing(clutch) for source in sources}
    gone = {words: paths for words, paths in gone.items() if paths and not foreign_keys(paths, clutch.spec.variant)}
    listed = [
        say("{name} (needs {listed})", name=translate(words), listed=", ".join(paths)) for words, paths in gone.items()
    ]
    return listed, [path for paths in gone.values() for path in paths]


def _splines(clutch: Clutch, spline_friction: float, *radii: float) -> Bracket:
    """Torques with friction in the splines of the discs: one curve as the pack closes, one as the balls unload it.

    The controlled pairs lie next to the spring (F11 fig. 1); from the spring on, the disc behind the first pair is
    an inner disc.
    """
    bypass, pairs = int(clutch.bypass_pairs), clutch.spec.friction_group.pairs
    most_force = float(clutch.pack_force_at_rest)

    def share(friction: Any, radius: Any) -> Any:
        """Largest share of a pair's normal force that friction in a disc's splines can carry."""
        return law.spline_share(spline_friction, friction, float(clutch.mean_radius), radius)

    most = float(max(share(friction.max, radius) for friction in clutch.spec.friction.groups for radius in radii))
    if most >= 1:
        locks = finding("splines-lock", "error", value=most, limit=1.0, path="friction_group.spline_friction")
        return (), (locks,)
    if pairs > _MOST_PAIRS:
        raise CalculationError("effects: splines are followed disc by disc, at most {most:,} pairs", most=_MOST_PAIRS)
    of_discs = np.resize(radii, pairs - 1)[:, None]

    def forces(next_force: Callable[..., Floats], driving: Floats, driven: Floats) -> Floats:
        """Ratio of each pair's normal force to that of the first pair, one row per pair, counted from the spring."""
        frictions = np.array([driven] * (pairs - bypass) + [driving] * bypass)
        ratios = next_force(1.0, share(frictions[:-1], of_discs), share(frictions[1:], of_discs))
        return np.cumprod(np.concatenate([np.ones_like(frictions[:1]), ratios]), axis=0)

    def counted(chain: Floats, driving: Floats, driven: Floats) -> Quantities:
        """Clutch at f_1 and f_2 in which each pair counts with its relative normal force in ``chain``."""
        controlled, others = chain[: pairs - bypass].sum(axis=0), chain[pairs - bypass :].sum(axis=0)
        return with_pairs(clutch, others, controlled).at_friction(driving, driven)

    def closing(driving: Floats, driven: Floats) -> Floats:
        """Torques, N·m, if splines hold back every disc as the spring pushes the discs together."""
        return counted(forces(law.next_force_closing, driving, driven), driving, driven)["torque"]

    def opening(driving: Floats, driven: Floats) -> Floats:
        """Torques, N·m, if splines hold back every disc as the balls unload it; at most the force at rest presses."""
        chain = forces(law.next_force_opening, driving, driven)

        def pressed(first: Floats) -> Quantities:
            return counted(np.minimum(chain, most_force / first), driving, driven)

        first = zero_of(lambda first: pressed(first)["normal_force"] - first, np.full_like(driving, most_force))
        return pressed(first)["torque"]

    return (closing, opening), ()


def _centrifugal(clutch: Clutch, speed: float, balls: int, diameter: float, circle: float) -> Bracket:
    """Torques with balls in conical pockets: without the centrifugal thrust of the balls, and with it."""
    tangent = pack.tan_wall_angle(clutch.gain, circle, clutch.mean_radius)
    mass = law.ball_mass(STEEL, diameter / 2, math.pi)
    return _weaker(clutch, float(law.centrifugal_thrust(balls, mass, speed, circle, tangent)), _SPEED)


def _pressure_disc_key(clutch: Clutch, key: PressureDiscKey) -> Bracket:
    """Torques with friction at the feather key of the pressure disc: as the pack closes, and as it is unloaded.

    The feather key carries the share e of the force on the pack, N (1 ± e) = F_п1 − c_1 x: the torque law then holds
    at the friction f/(1 ± e). If the feather key locks, the pack keeps the force F_п2 of the control spring.
    """
    most = float(clutch.friction_max)
    share = float(law.key_share(clutch.pairs, clutch.mean_radius, most, key.friction, key.diameter)) / most

    def torque(sign: int, driving: Floats, driven: Floats) -> Floats:
        """Torques, N·m, with feather-key friction against the spring force (``sign`` 1), or along with it (−1)."""
        held = 1 + sign * share * driving
        free = held > _LOCKED
        bound = clutch.pairs * clutch.mean_radius * driving * float(clutch.pack_force_at_rest)
        own = driving / np.where(free, held, 1.0)
        return np.where(free, np.minimum(_torque(clutch, own, own), bound), bound)

    def set_free(driving: Floats, driven: Floats) -> Floats:
        """Torques, N·m, of a clutch that was set at f_min without friction at the feather key."""
        slackening = torque(-1, driving, driven)
        return np.where(driving > float(clutch.friction_min), slackening, _torque(clutch, driving, driven))

    locks = finding("pressure-disc-key-locks", "warning", value=1 / share, limit=most, path=_KEY_FRICTION)
    return (partial(torque, 1), partial(torque, -1), set_free), (locks,) if share * most >= 1 else ()


_KEY_FRICTION = "control_unit.pressure_disc_key.friction"
_LOCKED = 1e-9
"""Value of 1 ± e up to which the feather key counts as locked."""


def _weaker(clutch: Clutch, loss: float, path: str) -> Bracket:
    """Torques with and without a loss of force on the pack at rest, N; no curves if no force is left."""
    force = float(clutch.pack_force_at_rest)
    if loss >= force:
        return (), (finding("force-used-up", "error", value=loss, limit=force, path=path),)
    name = "control_force_made" if clutch.spec.kind.travels else "closing_force"
    weakened = as_set(clutch, **{name: force - loss})
    return (partial(_torque, weakened), partial(_torque, clutch)), ()


def with_pairs(clutch: Clutch, bypass: Values, controlled: Values, **values: Values) -> Clutch:
    """Clutch with other numbers of pairs, which need not be whole, and other ``values``; the springs stay as set."""
    own = 0.0 if clutch.spec.kind.travels else bypass
    return as_set(clutch, pairs=bypass + controlled, bypass_pairs=own, **values)


SOURCES: Mapping[EffectName, EffectSource] = {
    "spline-friction": EffectSource(
        tuple(f"friction_group.{key}" for key in ("spline_friction", "inner_spline_radius", "outer_spline_radius")),
        _splines,
        deferred("discs held in their splines"),
    ),
    "centrifugal": EffectSource(
        (_SPEED, "control_unit.balls", "control_unit.ball_diameter", "control_unit.ball_circle_radius"),
        _centrifugal,
        deferred("balls thrown against conical pockets"),
    ),
    "wear": EffectSource(
        ("heat.lining", STIFFNESS),
        lambda clutch, lining, *_: _weaker(clutch, float(lost_by_wear(clutch, lining)), "heat.lining"),
        deferred("wear of the lining"),
    ),
    "pressure-disc-key": EffectSource(
        ("control_unit.pressure_disc_key",),
        _pressure_disc_key,
        deferred("friction at the key of the pressure disc"),
    ),
}
"""Definitions of the effects, in the order of the result."""
