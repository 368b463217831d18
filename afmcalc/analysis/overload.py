"""Overload with a torque margin (S22): potential torque, actuation torque as published and at equilibrium."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

from ..engines.protocol import Clutch
from ..equations import direct
from ..equations import overload as law
from ..equations.arrays import larger
from ..errors import CalculationError
from ..findings import Finding, finding
from ..messages import say
from ..result import Answer, Result, Series, Triple, described, quantity
from .registry import ANALYSES
from .sweep.grid import Axis, replaced, series
from .torque import Pair, outside_range, pairs_asked

SHARES = (0.0, 0.25, 0.5, 0.75, 1.0)
"""Of the rise of the load until slip: where the potential torque is told."""


class OverloadSweep(Series):
    """Overload over a swept key."""

    accuracy_factor_expected: list[float] = quantity("1", "K_т,exp", "T_муф(f_max)/T_min")
    accuracy_factor_actual: list[float] = quantity("1", "K_т,act", "max(T_ср, T_муф)(f_max)/T_min, published T_ср")
    actuation_factor: list[float] = quantity("1", "A", "T_ср/T_муф at f_max, published")
    expected_torque: list[float] = quantity("N*m", "T_муф", "expected torque at f_max")
    actuation_torque_published: list[float] = quantity("N*m", "T_ср", "published actuation torque at f_max")
    actuation_torque_equilibrium: list[float] = quantity("N*m", "T_eq", "actuation torque at equilibrium, at f_max")


class OverloadPoint(Result):
    """The trip at one chosen friction."""

    friction: float = quantity("1", "f", "coefficient of friction")
    potential_torque: float = quantity("N*m", "T_п", "potential torque at T_н.маш")
    expected_torque: float = quantity("N*m", "T_муф", "expected slip torque")
    load_rise: float = quantity("N*m", "ΔT'", "load rise until slip")
    actuation_torque_published: float = quantity("N*m", "T_ср", "actuation torque as published, S22 (14)")
    actuation_torque_equilibrium: float = quantity(
        "N*m", "T_eq", "actuation torque at equilibrium, without misprint M12"
    )
    actuation_factor: float = quantity("1", "A", "published over expected actuation torque")


class RisenLoad(Result):
    """The clutch under a load between the machine's nominal torque and slip."""

    friction: float = quantity("1", "f", "coefficient of friction")
    rise: float = quantity("N*m", "ΔT", "rise of the load above T_н.маш")
    load: float = quantity("N*m", "T_н.маш + ΔT", "load")
    potential_torque: float = quantity(
        "N*m", "T_п(ΔT)", "potential torque under it, S22 (6), (9); at slip it is the load"
    )


class OverloadResult(Answer):
    """Overload of a clutch set at f_min with a margin over the machine's torque."""

    nominal_torque: float = quantity("N*m", "T_н.муф", "nominal torque of the clutch, at f_min")
    machine_torque: float = quantity("N*m", "T_н.маш", "nominal torque of the machine")
    margin: float = quantity("1", "β_н", "torque margin")
    potential_torque: Triple = quantity(
        "N*m",
        "T_п",
        "potential torque: what the clutch could carry while T_н.маш loads it; upper bound of the tripping torque",
    )
    expected_torque: Triple = quantity("N*m", "T_муф", "expected slip torque; lower bound of the tripping torque")
    potential_torque_gain: Triple | None = quantity(
        "N*m",
        "T'_п − T_п",
        "potential torque above that of the all-driving clutch of equal spring, gain and margin",
        optional=True,
    )
    load_rise: Triple = quantity("N*m", "ΔT'", "load rise until slip")
    actuation_torque_published: Triple = quantity("N*m", "T_ср", "actuation torque as published, S22 (14)")
    actuation_torque_equilibrium: Triple = quantity(
        "N*m", "T_eq", "actuation torque at equilibrium, without misprint M12"
    )
    actuation_factor: Triple = quantity("1", "A", "published over expected actuation torque")
    friction_interval: list[float] | None = quantity(
        "1", "f (17)", "friction at which T_ср < T_муф, S22 (17), within the range", optional=True
    )
    optimal_reduced_gain: float = quantity(
        "1", "(zC)_opt", "reduced gain with the best accuracy by the published T_ср, 1/f_max; T_eq has no optimum"
    )
    accuracy_factor_expected: float = quantity("1", "K_т,exp", "expected accuracy factor, S22 (18)")
    accuracy_factor_actual: float = quantity("1", "K_т,act", "actual accuracy factor with the published T_ср, S22 (19)")
    accuracy_factor_equilibrium: float = quantity("1", "K_т,eq", "accuracy factor with the equilibrium torque")
    sweep: list[OverloadSweep] | None = described("overload over the swept values", optional=True)
    points: list[OverloadPoint] | None = described("at the friction asked for", optional=True)
    loads: list[RisenLoad] | None = described("load from the machine's nominal torque up to slip", optional=True)


def overload(
    clutch: Clutch, sweeps: Sequence[Axis] = (), friction: Iterable[Pair] = ()
) -> tuple[OverloadResult, list[Finding]]:
    """Calculate the overload of an all-driving or differentiated clutch of one material.

    Raises:
        CalculationError: a variant S22 does not treat.
    """
    refuse(clutch)
    trips = [Actuation(clutch, friction) for friction in clutch.friction[0]]
    at_min, _, at_max = trips
    points = pairs_asked(clutch, friction)
    asked = [(value, Actuation(clutch, value)) for value, _ in points]
    result = OverloadResult(
        nominal_torque=at_min.expected_torque,
        machine_torque=at_min.machine_torque,
        margin=clutch.spec.adjustment.margin,
        potential_torque_gain=_potential_gain(clutch) if clutch.bypass_pairs else None,
        **{name: Triple.of(getattr(trip, name) for trip in trips) for name in OF_TRIP},
        friction_interval=_interval(clutch),
        optimal_reduced_gain=law.optimal_reduced_gain(clutch.friction[0].max),
        accuracy_factor_expected=_accuracy_expected(clutch),
        accuracy_factor_actual=_accuracy_actual(clutch),
        accuracy_factor_equilibrium=law.accuracy_factor_equilibrium(
            at_max.actuation_torque_equilibrium, at_min.actuation_torque_equilibrium
        ),
        points=[
            OverloadPoint(friction=value, **{name: getattr(trip, name) for name in OF_TRIP}) for value, trip in asked
        ]
        or None,
        loads=[load for trip in asked for load in _loads(*trip)] or None,
        sweep=series(OverloadSweep, clutch, sweeps, SWEEP_OUTPUTS),
    )
    findings = [*clutch.findings(), finding("published-against-equilibrium", "info")]
    setting = clutch.spec.adjustment
    if setting.method == "mean-friction":
        findings.append(finding("margin-role", "warning", value=setting.margin, path="adjustment.method"))
    findings += [remark for pair in points for remark in outside_range(clutch, *pair)]
    return result, [*findings, *replaced(clutch.spec, sweeps)]


def _potential_gain(clutch: Clutch) -> Triple:
    """T'_п of the differentiated clutch less T_п of the all-driving one."""
    pack = clutch.spec.friction_group.pairs, clutch.bypass_pairs, clutch.closing_force, clutch.mean_radius
    low, margin = clutch.friction[0].min, clutch.spec.adjustment.margin
    return Triple.of(
        law.potential_torque_gain_of_differentiated(*pack, friction, low, clutch.gain, margin)
        for friction in clutch.friction[0]
    )


class Actuation:
    """Everything S22 says of the trip at one friction; parameters may be arrays."""

    def __init__(self, clutch: Clutch, friction: Any) -> None:
        """Calculate the trip of ``clutch`` at ``friction``."""
        pairs = clutch.spec.friction_group.pairs
        controlled = direct.controlled_pairs(pairs, clutch.bypass_pairs)
        low, margin = clutch.friction[0].min, clutch.spec.adjustment.margin
        pack = pairs, clutch.closing_force, clutch.mean_radius
        at_min = law.loop_gain(controlled, clutch.gain, low)
        here = law.loop_gain(controlled, clutch.gain, friction)
        self.loop_gain = here
        self.expected_torque = law.expected_torque(*pack, friction, here)
        self.machine_torque = law.machine_torque(law.expected_torque(*pack, low, at_min), margin)
        self.potential_torque = law.potential_torque(*pack, friction, margin, at_min)
        self.load_rise = law.load_rise(self.potential_torque, self.machine_torque, here)
        self.actuation_torque_published = law.actuation_torque_published(self.potential_torque, self.load_rise)
        self.actuation_torque_equilibrium = law.actuation_torque_equilibrium(self.machine_torque, self.load_rise)
        self.actuation_factor = law.actuation_factor(here, at_min, friction, low, margin)


OF_TRIP = [name for name in OverloadPoint.model_fields if name != "friction"]
"""Quantities of the trip, as they are called in every result."""


def _loads(friction: float, trip: Actuation) -> Iterator[RisenLoad]:
    """Loads from T_н.маш up to slip; one where the pack slips under T_н.маш already."""
    for share in SHARES if trip.load_rise > 0 else (0.0,):
        rise = share * trip.load_rise
        potential = law.potential_torque_risen(trip.potential_torque, trip.loop_gain, rise)
        yield RisenLoad(friction=friction, rise=rise, load=trip.machine_torque + rise, potential_torque=potential)


def _ends(clutch: Clutch) -> tuple[Actuation, Actuation]:
    """The trip at f_max, and at f_min."""
    return Actuation(clutch, clutch.friction[0].max), Actuation(clutch, clutch.friction[0].min)


def _accuracy_expected(clutch: Clutch) -> Any:
    """K_т expected, S22 (18)."""
    at_max, at_min = _ends(clutch)
    return law.accuracy_factor_expected(at_max.expected_torque, at_min.expected_torque)


def _accuracy_actual(clutch: Clutch) -> Any:
    """K_т actual, S22 (19): the larger of published and expected torque at f_max over the clutch's nominal torque."""
    at_max, at_min = _ends(clutch)
    largest = larger(at_max.actuation_torque_published, at_max.expected_torque)
    return law.accuracy_factor_actual(largest, at_min.expected_torque)


SWEEP_OUTPUTS: dict[str, Callable[[Clutch], Any]] = {
    "accuracy_factor_expected": _accuracy_expected,
    "accuracy_factor_actual": _accuracy_actual,
} | {
    name: lambda clutch, name=name: getattr(Actuation(clutch, clutch.friction[0].max), name)  # type: ignore[misc]
    for name in OF_TRIP
    if name in OverloadSweep.model_fields
}


def refuse(clutch: Clutch) -> None:
    """Refuse a variant S22 does not treat."""
    if not ANALYSES["overload"].applies(clutch):
        unlike, variant = clutch.spec.friction.unlike, clutch.spec.variant
        what = say("unlike materials") if unlike else say("variant {variant!r}", variant=variant)
        raise CalculationError(
            "overload: S22 treats all-driving and differentiated clutches of one material, not {what}", what=what
        )


def _interval(clutch: Clutch) -> list[float] | None:
    """Friction where the published actuation torque is below the expected one, S22 (17), within the range."""
    friction, reduced = clutch.friction[0], clutch.reduced_gain
    if reduced == 0:
        return None
    controlled = direct.controlled_pairs(clutch.spec.friction_group.pairs, clutch.bypass_pairs)
    at_min = law.loop_gain(controlled, clutch.gain, friction.min)
    ends = sorted((law.interval_low(friction.min, clutch.spec.adjustment.margin, at_min), law.interval_high(reduced)))
    low, high = max(ends[0], friction.min), min(ends[1], friction.max)
    return [low, high] if low < high else None
