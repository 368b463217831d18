"""What only a simulation or a sample tells, asked of the candidates that meet the rest, as far as the front needs it.

Many are simulated at once, in coarse steps: who is beyond a limit by more than the error of these is out. The front of
the others is given to a check, one by one: who fails is out, and another front takes its place. So the front is that
of all candidates that pass a check; whom one of it beats need not be asked.
"""

import math
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ...drive.heat import least_rise, least_share, motor_torque, run_down
from ...drive.peaks import slips_of
from ...engines import Clutch, build
from ...equations import heat as law
from ...errors import given
from ...messages import say
from ...progress import counted, tell, unwatched
from ...spec.edit import value_at, with_values
from ...spec.keys import keys
from ...spec.requirements import Requirements
from ...variants import Variant
from ..heat import HOUR, bodies_of, limit_of
from ..requirements import JUDGED
from ..simulate import at_ends, bypass_peaks
from .candidates import Candidates, candidates
from .pick import asked, judged
from .rows import Attainable, DesignRow, as_spec, rows
from .search import Members, Survey, front, ranks
from .space import Axes, Numbers, Places

_BATCH = 2730
"""Candidates simulated at once: at three frictions each as many drives as stay in the processor's cache."""
_UNSURE = 0.02
"""Share of a limit beyond it that the coarse steps may be wrong by; in it a check decides."""
_TRIED = 5
"""Candidates that miss the same, given to a check to tell what is attainable."""


class Held(NamedTuple):
    """What became of the candidates that meet the rest."""

    front: list[DesignRow]
    """The best of those that hold everything."""
    unasked: int
    """Candidates that one of the front beats: no check was asked about them."""
    attainable: list[Attainable]
    """Where there is no front: what those that miss the fewest requirements have of these."""


class _Failed(NamedTuple):
    missed: tuple[str, ...]
    share: float
    """Of the limits missed what they have of each, multiplied."""
    place: int


def held(need: Requirements, survey: Survey) -> Held:
    """Ask the candidates of a survey, which has every one that meets the rest, and count in it who fails."""
    if not survey.members:
        return Held([], 0, [])
    pool = _Pool(need, survey.members)
    while True:
        best = pool.best()
        if not pool.tried[best].all():
            pool.simulate(best)
        elif not pool.check(best):
            break
    for one in pool.failed:
        for counts in (survey, survey.parts[pool.candidate(one.place).variant.name]):
            counts.feasible -= 1
            counts.excluded.update(one.missed)
    missing = [] if pool.passed else list(pool.attainable())
    return Held(list(pool.passed.values()), len(pool.values) - len(pool.failed) - len(pool.passed), missing)


class _Pool:
    """Candidates that meet the rest, each by its place."""

    def __init__(self, need: Requirements, members: list[Members]) -> None:
        self.need, self.members = need, members
        self.values = np.concatenate([member.values for member in members])
        self.ends = np.cumsum([len(member.values) for member in members])
        self.order = np.argsort(np.sum([ranks(column) for column in self.values.T], axis=0), kind="stable")
        self.left, self.tried = np.ones(len(self.values), bool), np.zeros(len(self.values), bool)
        self.passed: dict[int, DesignRow] = {}
        self.failed: list[_Failed] = []

    def best(self) -> Places:
        """Front of those that did not fail."""
        left = np.flatnonzero(self.left)
        return left[front(self.values[left])]

    @np.errstate(all="ignore")
    def simulate(self, best: Places) -> None:
        """Simulate those of the front, and further ones that none beats who may well pass."""
        open_ = self.left & ~self.tried
        for place in best[self.tried[best]]:
            open_ &= (self.values < self.values[place]).any(axis=1)
        waiting = self.order[open_[self.order]]
        batch = np.unique(np.append(best[~self.tried[best]], waiting[:_BATCH]))
        behind = int(np.count_nonzero(self.tried))
        for member, some in enumerate(np.split(batch, np.searchsorted(batch, self.ends[:-1]))):
            for part in np.split(some, range(_BATCH, some.size, _BATCH)):
                tell(say("simulating the candidates"), behind, behind + waiting.size)
                if part.size:
                    self._simulate(member, part)
        self.tried[batch] = True

    def _simulate(self, member: int, places: Places) -> None:
        variant, at, columns, need = self.members[member]
        with unwatched():
            shares = _shares(need, variant, at.at(places - (self.ends[member] - len(columns))))
        out = np.any([share > 1 for share in shares.values()], axis=0) if shares else np.zeros(0, bool)
        for k in np.flatnonzero(out):
            missed = {name: float(share[k]) for name, share in shares.items() if share[k] > 1}
            self.fail(int(places[k]), tuple(missed), math.prod(missed.values()))

    def fail(self, place: int, missed: tuple[str, ...], share: float) -> None:
        self.left[place] = False
        self.failed.append(_Failed(missed, share, place))

    def check(self, best: Places) -> bool:
        """Give those of the front to a check that have not been; return whether one failed."""
        fresh, before = [place for place in best.tolist() if place not in self.passed], len(self.failed)
        for place in counted(say("checking the front"), fresh):
            row, missed = self.judged(place)
            if missed:
                self.fail(place, missed, 1.0)
            else:
                self.passed[place] = row
        return len(self.failed) > before

    def judged(self, place: int) -> tuple[DesignRow, tuple[str, ...]]:
        """Return a candidate with what a check says of it, and what it misses by that."""
        row = rows(self.candidate(place))[0]
        with unwatched():
            return judged(self.need, row)

    def candidate(self, place: int) -> Candidates:
        """One of them."""
        member = int(np.searchsorted(self.ends, place, "right"))
        variant, at, columns, need = self.members[member]
        number = place - int(self.ends[member]) + len(columns)
        return candidates(need, variant, at.at(slice(number, number + 1)))

    def attainable(self) -> Iterator[Attainable]:
        """What those that miss the fewest requirements have of these, by a check, the nearest to the limits first."""
        wanted = self.need.wanted
        named = [one for one in self.failed if JUDGED.keys() >= set(one.missed)]
        fewest, told = min((len(one.missed) for one in named), default=0), Counter[tuple[str, ...]]()
        for one in sorted(named, key=lambda one: one.share):
            if len(one.missed) > fewest or told[one.missed] >= _TRIED:
                continue
            told[one.missed] += 1
            row, missed = self.judged(one.place)
            if set(missed) != set(one.missed):
                continue
            told[one.missed] = _TRIED
            for name in missed:
                if (value := getattr(row, name)) is not None:
                    yield Attainable(
                        together=" + ".join(missed) if len(missed) > 1 else None, requirement=name,
                        sense="at least" if JUDGED[name].least else "at most", limit=getattr(wanted, name), best=value,
                        unit=(keys()[f"requirements.{name}"].unit or "").removesuffix(" abs"),
                    )  # fmt: skip


def _shares(need: Requirements, variant: Variant, at: Axes) -> dict[str, Numbers]:
    """Requirement → by candidate at least what share of its limit, widened by what is unsure, it takes; over 1: out."""
    clutch, names = _together(need, variant, at), asked(need.wanted, need.drive)
    of_heat = [name for name in names if JUDGED[name].analysis == "heat"]
    event, (first, second) = clutch.spec.drive.event, at_ends(clutch)
    told: dict[str, Numbers] = {}
    if event is not None and (of_heat or "peak_torque" in names):
        found = slips_of(clutch, first, second, whole=bool(of_heat))
        time, heat = found.slipped, found.heat
        if "peak_torque" in names:
            alone = bypass_peaks(clutch, lambda *asked: slips_of(*asked, whole=False).peak)
            told["peak_torque"] = np.fmax(found.peak.max(axis=0), alone)
    elif of_heat:
        time, heat = _run_down(clutch, np.broadcast_to(clutch.torque(first, second), (3, at.pairs.size)))
    if of_heat:
        told |= {name: value for name, value in _of_heat(clutch, time, heat).items() if name in names}
    ambient = 0.0 if need.heat is None else need.heat.ambient or 0.0
    shares = {}
    for name, value in told.items():
        limit, zero = getattr(need.wanted, name), ambient if "temperature" in name else 0.0
        share = (limit / value) if JUDGED[name].least else (value - zero) / (limit - zero)
        shares[name] = np.broadcast_to(share / (1 + _UNSURE), at.pairs.shape)
    return shares


def _together(need: Requirements, variant: Variant, at: Axes) -> Clutch:
    """Candidates as one clutch, its numbers arrays."""
    tried = candidates(need, variant, at)
    spec = as_spec(need, rows(replace(tried, at=at.at(slice(0, 1))))[0])
    half, angle = tried.face_width / 2, need.search.wall_angle is not None
    searched = {
        "friction_group.pairs": at.pairs,
        "friction_group.driving_pairs": at.driving_pairs,
        "friction_group.mean_radius": at.mean_radius,
        "friction_group.inner_radius": at.mean_radius - half,
        "friction_group.outer_radius": at.mean_radius + half,
        "closing_spring.force": tried.closing_force,
        "closing_spring.stiffness": at.closing_stiffness,
        "control_spring.stiffness": at.control_stiffness,
        "control_unit.wall_angle" if angle else "control_unit.gain": at.steering,
        "control_unit.ball_circle_radius": at.ball_circle_radius,
    }
    # the first of them says which keys its variant has
    return build(
        with_values(spec, {path: value for path, value in searched.items() if value_at(spec, path) is not None})
    )


def _run_down(clutch: Clutch, torque: Numbers) -> tuple[Numbers, Numbers]:
    """Time and heat of trips that block the tool; infinite where the motor carries the clutch on."""
    motor = np.broadcast_to(motor_torque(clutch), torque.shape)
    slips = [run_down(clutch.spec.drive, *pair) for pair in zip(torque.ravel(), motor.ravel(), strict=True)]
    told = [(slip.time, slip.energy) if slip.energy is not None else (np.inf, np.inf) for slip in slips]
    time, heat = np.array(told, float).T
    return time.reshape(torque.shape), heat.reshape(torque.shape)


def _of_heat(clutch: Clutch, time: Numbers, heat: Numbers) -> dict[str, Numbers]:
    """Requirement → the least favourable of three frictions, at least as favourable as a check has it."""
    own, group, told = given(clutch.spec.heat), clutch.spec.friction_group, dict[str, Numbers]()
    area = None
    if group.inner_radius is not None and group.outer_radius is not None:
        area = law.friction_area(group.inner_radius, group.outer_radius, math.pi)
        told["work"] = law.specific_work(heat, group.pairs, area)
    bodies = [
        body if body.depth is None else body._replace(depth=np.broadcast_to(body.depth, time.shape).ravel())
        for body in bodies_of(own, group.pairs, area)
    ]
    flat, slipped = np.where(time > 0, time, 1.0).ravel(), heat > 0
    if own.ambient is not None and own.disc_mass is not None and own.specific_heat is not None:
        share = least_share(bodies, flat).reshape(time.shape) if len(bodies) > 1 else 1.0
        rise = law.temperature_rise(heat, own.disc_mass, own.specific_heat) * share
        told["temperature"] = own.ambient + np.where(slipped, rise, 0.0)
    if own.ambient is not None and bodies:
        rise = least_rise(bodies, flat, law.power_density(heat, group.pairs, area).ravel()).reshape(time.shape)
        told["face_temperature"] = own.ambient + np.where(slipped, rise, 0.0)
    told = {name: value.max(axis=0) for name, value in told.items()}
    limit = limit_of(clutch)
    if limit is not None and own.ambient is not None and own.cooling is not None:
        told["trips_per_hour"] = (HOUR * law.trips_per_time(own.cooling, limit.low, own.ambient, heat)).min(axis=0)
    return told
