"""Which events are simulated: the clutch at a friction, and an ordinary clutch in its place."""

import functools
from collections.abc import Iterable
from typing import Any, NamedTuple

from ..engines import Clutch
from ..equations.arrays import Values
from .integrator import Event, simulate
from .motion import stacked
from .pack_and_sleeve import DirectPack, Sleeve, ordinary_pack, pack_of
from .train import Train, train_of


class Case(NamedTuple):
    """Clutches in their drives at one friction each: numbers, or arrays."""

    train: Train
    pack: DirectPack | Sleeve
    duration: float | None
    """Duration asked for, s."""

    def run(self) -> Event:
        """Simulate one drive until nothing more can come.

        Raises:
            CalculationError: the duration has too many steps.
        """
        return event_of(self)

    def history(self) -> Event:
        """Simulate one drive to the end of the duration asked for, if any; errors as ``run``."""
        return event_of(self, full=self.duration is not None)

    def peaks(self) -> Event:
        """Simulate, many drives too, until the peaks have passed; errors as ``run``."""
        return simulate(*self, whole=False)


@functools.lru_cache(maxsize=128)
def kept(case: Case, whole: bool, full: bool) -> list[Event]:  # noqa: FBT001
    """Place of an event, empty until it is simulated; the last are cached: heat and requirements ask for them again."""
    return []


def event_of(case: Case, *, whole: bool = True, full: bool = False) -> Event:
    """Simulate one drive, unless its event is kept."""
    place = kept(case, whole, full)
    if not place:
        place.append(simulate(*case, whole=whole, full=full))
    return place[0]


def simulate_together(cases: Iterable[Case], *, whole: bool = True) -> None:
    """Simulate the events of direct clutches in drives alike, as arrays; ``event_of`` then has them."""
    alike: dict[Any, list[Case]] = {}
    for case in dict.fromkeys(cases):
        if isinstance(case.pack, DirectPack) and not kept(case, whole, False):
            train = case.train
            optional = train.engine.slip, train.cut_off, case.duration
            alike.setdefault((train.kind, *(value is None for value in optional)), []).append(case)
    for group in alike.values():
        trains, packs, durations = zip(*group, strict=True)
        events = simulate(stacked(trains), stacked(packs), stacked(durations), whole=whole)
        for case, *figures in zip(group, *events[:-1], strict=True):
            numbers = (figure.item() if hasattr(figure, "item") else figure for figure in figures)
            kept(case, whole, False).append(Event(*numbers))


def case_of(clutch: Clutch, driving: Values, driven: Values | None = None, *, ordinary: bool = False) -> Case:
    """Return the event at f, or at f_1 and f_2; of an ``ordinary`` clutch of equal T_н in the place of the clutch.

    Raises:
        SpecError: no event.
    """
    frictions: tuple[Any, Any] = (driving, driving if driven is None else driven)
    train, pack = train_of(clutch), (ordinary_pack if ordinary else pack_of)(clutch, *frictions)
    if isinstance(pack, DirectPack):
        train = train.without_hub
    event = clutch.spec.drive.event
    return Case(train, pack, None if event is None else event.duration)


class Outcome(NamedTuple):
    """Event at one friction, of the clutch and of an ordinary one in its place."""

    case: Case
    event: Event
    ordinary: Case
    """An ordinary clutch of equal T_н in its place."""

    @property
    def ordinary_peak(self) -> float:
        """Peak torque with that, N·m."""
        return float(event_of(self.ordinary, whole=False).peak)

    @property
    def dynamic_factor(self) -> float:
        """k_д."""
        return float(self.event.peak / self.case.pack.sliding)

    @property
    def ended(self) -> bool:
        """True if the slip has ended for good, as far as is known."""
        return _ended(self.event, self.case)

    @property
    def slip_time(self) -> float | None:
        """Time of slip; None where it has not ended."""
        return self.event.slip_time if self.ended else None

    @property
    def energy(self) -> float | None:
        """Heat in the pack; None where the slip has not ended."""
        return self.event.heat if self.ended else None

    @property
    def key_energy(self) -> float | None:
        """Energy lost at the key until the slip has ended, or until the end where it does not slip; None as above."""
        return self.event.key_heat if self.ended else None

    @property
    def rattles(self) -> bool:
        """True if the balls leave their stop, against which the sleeve then rattles."""
        return bool(self.event.travel_max)

    @property
    def energies(self) -> tuple[float | None, float | None]:
        """Heat in the pack by both step sizes."""
        other = self.event.other
        return self.energy, other.heat if _ended(other, self.case) else None

    @property
    def endless(self) -> bool:
        """True if the motor keeps it slipping."""
        train, event = self.case.train, self.event
        strong = train.cut_off is None and abs(event.last) <= train.engine.torque
        return not self.ended and strong and not event.stuck

    @property
    def potential(self) -> float | None:
        """T_п, at which it would slip if the release force did not follow the load; None of an indirect clutch."""
        pack = self.case.pack
        return pack.potential(self.case.train.load, pack.static_ratio) if isinstance(pack, DirectPack) else None

    @property
    def trip_torque(self) -> float | None:
        """Torque at which the clutch begins to slip, N·m; None where it does not."""
        return self.event.trip_torque or None

    @property
    def trip_position(self) -> float | None:
        """Where the trip lies between T_муф (0) and T_п (1); None without slip, or where the two are one."""
        expected, potential, at = self.case.pack.breakaway, self.potential, self.trip_torque
        if at is None or potential is None or potential <= expected:
            return None
        return float((at - expected) / (potential - expected))


def _ended(event: Event, case: Case) -> bool:
    slipped = bool(event.trip_torque)
    return bool(event.stuck) and (bool(event.settled) or case.duration is not None or not slipped)


def outcome_of(clutch: Clutch, friction: float, friction_driven: float | None = None) -> Outcome:
    """Simulate the clutch at one friction; arguments as ``case_of``."""
    case, ordinary = (case_of(clutch, friction, friction_driven, ordinary=plain) for plain in (False, True))
    return Outcome(case, case.run(), ordinary)


def simulate_clutches(clutches: Iterable[Clutch]) -> None:
    """Simulate the events of many clutches at f_min, mean friction and f_max together, for ``outcome_of``."""
    at_ends = [(clutch, *end) for clutch in clutches for end in zip(*clutch.spec.friction.groups, strict=True)]
    for ordinary in (False, True):
        simulate_together((case_of(*each, ordinary=ordinary) for each in at_ends), whole=not ordinary)
