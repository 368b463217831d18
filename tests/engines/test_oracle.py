"""Every quantity of random clutches by the laws, against the engine of 0.3.0."""
# ruff: noqa: SIM905, SIM108

import math
from collections import Counter
from typing import Any

import pytest
import scipy.special  # noqa: F401 what takes long to import is imported before a test begins
from random_clutches import random_clutches

from afmcalc.analysis.torque import traced
from afmcalc.engines import build
from afmcalc.engines.elasticity import elasticities
from afmcalc.engines.selection import quantities_of
from afmcalc.errors import AfmcalcError
from afmcalc.spec import make_spec

ENDS = {"f_min": "min", "f_mean": "mean", "f_max": "max"}
CLOSE, CLOSE_SLOPE = 1e-9, 1e-7


class Comparison:
    """Values of the laws against those of the old engine."""

    def __init__(self) -> None:
        self.count: Counter[str] = Counter()
        self.worst: Counter[str] = Counter()
        self.wrong: list[tuple[Any, ...]] = []
        self.spec: Any = None

    def same(self, name: str, own: Any, old: Any, scale: float = 0.0, close: float = CLOSE) -> None:
        if old is None:
            return
        own, old = float(own), float(old)
        error = 0.0
        if not (own == old or (math.isnan(own) and math.isnan(old))):
            error = abs(own - old) / max(abs(old), scale, 1e-300)
        self.count[name] += 1
        self.worst[name] = max(self.worst[name], error)
        if not error < close:
            self.wrong.append((name, own, old, error, self.spec))

    def triple(self, name: str, clutch: Any, old: Any, scale: float = 0.0, own: str = "") -> None:
        for case, end in ENDS.items():
            if old is not None:
                self.same(f"{name}_at_{case}", clutch[f"{own or name}_at_{case}"], getattr(old, end), scale)


def compare(data: dict[str, Any], found: Comparison) -> bool:
    """Compare all answers of one spec; False if it is refused."""
    try:
        clutch = build(make_spec(data))
        clutch.torque_range  # noqa: B018
    except AfmcalcError:
        return False
    found.spec, q = data, quantities_of(clutch.spec)
    discs = clutch.sleeve is not None and clutch.sleeve.curved
    _torque(q, clutch, found)
    _accuracy(q, clutch, found, discs)
    return True


def _torque(q, clutch, found):
    old, _ = traced(clutch, [(0.17, None)] if not clutch.spec.friction.unlike else [(0.17, 0.4)])
    names = "closing_force gain reduced_gain nominal_torque machine_torque accuracy_factor control_force gain_slope motor_torque "
    for name in (names + "torque_asked_for starting_torque").split():
        found.same(name, q[name] if getattr(old, name) is not None else 0, getattr(old, name))
    least, most = old.torque_range.low, old.torque_range.high
    found.same("torque_min", q.torque_min, least)
    found.same("torque_max", q.torque_max, most)
    found.same("scatter", q.scatter, old.scatter, scale=most)
    if most - least > 1e-9 * most:
        found.same("friction_of_torque_min", q.friction_of_torque_min, old.torque_range.at_low)
        found.same("friction_of_torque_max", q.friction_of_torque_max, old.torque_range.at_high)
    if clutch.sleeve is not None:
        found.same("pack_force_at_rest", q.pack_force_at_rest, old.pack_force_at_rest)
        found.same("torque_returning_min", q.torque_returning_min, clutch.sleeve.torque_returning_min)
        if clutch.sleeve.net_gain > 0:
            found.same("hysteresis_ratio", q.hysteresis_ratio, clutch.sleeve.hysteresis_ratio)
            found.same("jumping_slope", q.jumping_slope, clutch.sleeve.jumping_slope)
    names = "torque normal_force release_force torque_returning driving_torque driven_torque circumferential_force key_friction_force"
    for name in (names + " onset_torque").split():
        found.triple(name, q, getattr(old, name))
    found.triple("travel", q, old.travel, scale=1e-5)
    found.triple("stop_reaction", q, old.stop_reaction, scale=1e-3 * float(old.control_force or 0))
    point = old.points[0]
    if clutch.spec.friction.unlike:
        here = q.at(friction_driving=0.17, friction_driven=0.4)
    else:
        here = q.at(friction=0.17)
    found.same("torque at a point", here.torque, point.torque)
    found.same("travel at a point", here.travel if point.travel is not None else 0, point.travel, scale=1e-5)


def _accuracy(q, clutch, found, discs):
    for name in ("accuracy_factor_worst_case", "accuracy_factor_peak", "gain_limit"):
        old = getattr(clutch, name)
        found.same(name, q[name] if old is not None else 0, old)
    if clutch.sleeve is not None:
        names = "accuracy_factor_hysteresis gain_threshold equivalent_gain constant_torque_slope nominal_torque_ratio"
        for name in names.split():
            old = getattr(clutch.sleeve, name)
            found.same(name, q[name] if old is not None else 0, old)
    if discs:
        return
    own = elasticities(q)
    old = clutch.sensitivity()
    for path, slope in old.items():
        new = own.get(path)
        sides = (0.0, 0.0) if new is None else new
        side = min(sides, key=lambda value: abs(value - slope))
        kink = "elasticity at a kink" if sides[0] != sides[1] else "elasticity"
        found.same(kink, side, slope, scale=1.0, close=CLOSE_SLOPE)
    for path, new in own.items():
        if path not in old:
            found.same("elasticity", new.slope, 0.0, scale=1.0, close=CLOSE_SLOPE)


def compared(count: int, seed: int) -> Comparison:
    found = Comparison()
    refused = sum(not compare(data, found) for data in random_clutches(count, seed))
    assert refused <= 1 + 0.1 * count
    return found


@pytest.mark.parametrize("seed", range(12))
def test_quantities_are_those_of_the_old_engine(seed):
    assert compared(5, seed).wrong == []


@pytest.mark.slow
def test_a_thousand_clutches():
    found = compared(1000, 7)
    assert found.wrong == []
    assert found.count.total() > 30_000
