"""Cases to simulate: the clutch at one friction, and an ordinary clutch in its place; their events are cached."""

import functools
from collections.abc import Iterable
from dataclasses import replace
from typing import Any, NamedTuple

from ..engines import Clutch
from ..equations.arrays import Values
from .integrator import Event, simulate
from .motion import stacked
from .pack_and_sleeve import DirectPack, Sleeve, ordinary_pack, pack_of
from .train import Train, train_of


class Case(NamedTuple):
    """Drive with its clutch at one friction, as numbers; or many such drives, as arrays."""

    train: Train
    pack: DirectPack | Sleeve
    duration: float | None
    """Duration to simulate, s; None: until nothing more can happen."""

    def run(self, *, whole: bool = True, full: bool = False) -> Event:
        """Event of one drive, perhaps from the cache; raises CalculationError if the duration has too many steps."""
        full = full and self.duration is not None
        events = kept(self, whole, full)
        if not events:
            events.append(simulate(*self, whole=whole, full=full))
        return events[0]

    def peaks(self) -> Event:
        """Simulate one or many drives until their peaks have passed; raises the errors of ``run``."""
        return simulate(*self, whole=False)


@functools.lru_cache(maxsize=320)
def kept(case: Case, whole: bool, full: bool) -> list[Event]:  # noqa: FBT001
    """Cache entry of an event: a list, empty until the event is simulated. Heat and requirements share the events."""
    return []


def case_of(clutch: Clutch, driving: Values, driven: Values | None = None, *, ordinary: bool = False) -> Case:
    """Return the case at friction f, or f_1 and f_2; with ``ordinary`` it has an ordinary clutch of equal T_н.

    Raises SpecError if the spec has no event.
    """
    frictions: tuple[Any, Any] = (driving, driving if driven is None else driven)
    train, pack = train_of(clutch), (ordinary_pack if ordinary else pack_of)(clutch, *frictions)
    if isinstance(pack, DirectPack):
        # the hub turns with the driven half
        train = replace(train, driven_inertia=train.driven_inertia + train.hub_inertia, hub_inertia=0.0)
    event = clutch.spec.drive.event
    return Case(train, pack, None if event is None else event.duration)


class Outcome(NamedTuple):
    """Results of an event at one friction, with the clutch and with an ordinary clutch in its place."""

    case: Case
    event: Event
    ordinary: Case
    """Case of an ordinary clutch of equal nominal torque T_н."""

    @property
    def ordinary_peak(self) -> float:
        """Peak torque with the ordinary clutch, N·m."""
        return float(self.ordinary.run(whole=False).peak)

    @property
    def endless(self) -> bool:
        """True if the motor keeps the clutch slipping for ever."""
        train, event = self.case.train, self.event
        strong = train.cut_off is None and abs(event.last) <= train.engine.torque
        return not event.ended and strong and not event.stuck

    @property
    def potential(self) -> float | None:
        """Potential torque T_п, N·m: slip torque with the release force from before the event; None if indirect."""
        pack = self.case.pack
        if isinstance(pack, Sleeve):
            return None
        return float(pack.carried(pack.pressed_at_stop(self.case.train.load, pack.stop_gains[0]), pack.static_ratio))

    @property
    def trip_position(self) -> float | None:
        """Place of the trip torque between slip torque T_муф (0) and T_п (1); None without slip, or if T_п ≤ T_муф."""
        expected, potential, at = self.case.pack.breakaway, self.potential, self.event.trip_torque
        if not at or potential is None or potential <= expected:
            return None
        return float((at - expected) / (potential - expected))


def outcome_of(clutch: Clutch, friction: float, friction_driven: float | None = None) -> Outcome:
    """Simulate the clutch at one friction; arguments as ``case_of``."""
    case, ordinary = (case_of(clutch, friction, friction_driven, ordinary=plain) for plain in (False, True))
    return Outcome(case, case.run(), ordinary)


def simulate_clutches(clutches: Iterable[Clutch]) -> None:
    """Simulate direct clutches at f_min, mean friction and f_max as arrays; ``outcome_of`` uses the cached events."""
    at_ends = [(clutch, *end) for clutch in clutches for end in zip(*clutch.spec.friction.groups, strict=True)]
    for ordinary in (False, True):
        # drives of the same kind are simulated together
        alike: dict[Any, list[Case]] = {}
        for case in dict.fromkeys(case_of(*each, ordinary=ordinary) for each in at_ends):
            if isinstance(case.pack, DirectPack) and not kept(case, not ordinary, False):
                optional = case.train.engine.slip, case.train.cut_off, case.duration
                alike.setdefault((case.train.kind, *(value is None for value in optional)), []).append(case)
        for group in alike.values():
            events = simulate(*map(stacked, zip(*group, strict=True)), whole=not ordinary)
            for place, case in enumerate(group):
                kept(case, not ordinary, False).append(Event(*(part.item(place) for part in events)))
