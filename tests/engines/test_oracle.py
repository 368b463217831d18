"""Every quantity of random clutches by the laws, against the engine of 0.3.0 and its analyses."""
# ruff: noqa: SIM905, SIM108

import math
from collections import Counter
from typing import Any

import pytest
import scipy.special  # noqa: F401 what takes long to import is imported before a test begins
from random_clutches import random_clutches

from afmcalc.analysis.accuracy import accuracy
from afmcalc.analysis.adjust import adjust
from afmcalc.analysis.life import life
from afmcalc.analysis.limits import ring_pressures
from afmcalc.analysis.overload import overload
from afmcalc.analysis.synthesize import synthesize
from afmcalc.analysis.torque import traced
from afmcalc.engines import build
from afmcalc.engines.elasticity import elasticities
from afmcalc.engines.selection import quantities_of
from afmcalc.errors import AfmcalcError
from afmcalc.spec import make_spec
from afmcalc.spec.lists import diameters

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
    _adjust(q, clutch, found)
    if clutch.spec.kind.overload and not clutch.spec.friction.unlike:
        _overload(q, clutch, found)
    _life(q, clutch, found)
    for kind, pressure in ring_pressures(clutch).items():
        found.same(f"{kind}_pressure", q[f"{kind}_pressure"], pressure)
    if not discs:
        _synthesis(q, clutch, found)
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
    old, _ = accuracy(clutch)
    names = "accuracy_factor_worst_case accuracy_factor_peak accuracy_factor_hysteresis conventional_accuracy_factor gain_limit "
    for name in (names + "gain_threshold equivalent_gain constant_torque_slope nominal_torque_ratio").split():
        found.same(name, q[name] if getattr(old, name) is not None else 0, getattr(old, name))
    for name in ("slope_in_ratio_max", "slope_in_ratio_min"):
        found.same(name, q[name] if getattr(old, name) is not None else 0, getattr(old, name), scale=0.01)
    if discs:
        return
    own = elasticities(q)
    for path, slope in old.sensitivity.items():
        new = own.get(path)
        sides = (0.0, 0.0) if new is None else new
        side = min(sides, key=lambda value: abs(value - slope))
        kink = "elasticity at a kink" if sides[0] != sides[1] else "elasticity"
        found.same(kink, side, slope, scale=1.0, close=CLOSE_SLOPE)
    for path, new in own.items():
        if path not in old.sensitivity:
            found.same("elasticity", new.slope, 0.0, scale=1.0, close=CLOSE_SLOPE)


def _adjust(q, clutch, found):
    try:
        old, _ = adjust(clutch)
    except AfmcalcError:
        return
    for case, one in (("by_min", old.min_friction), ("by_mean", old.mean_friction)):
        as_set = q.at(case)
        for name in ("closing_force", "accuracy_factor", "mid_torque"):
            found.same(f"{case} {name}", as_set[name], getattr(one, name))
        found.same(f"{case} scatter", as_set.scatter, one.scatter, scale=float(old.nominal_torque))
        found.triple("torque", as_set, one.torque)
    found.same("force_ratio", q.force_ratio if old.force_ratio else 0, old.force_ratio)
    if old.scatter_ratio is not None and old.min_friction.scatter > 1e-6 * old.nominal_torque:
        found.same("scatter_ratio", q.scatter_ratio, old.scatter_ratio, scale=1e-3)
    found.same("pairs_threshold", q.pairs_threshold if old.pairs_threshold else 0, old.pairs_threshold)


def _overload(q, clutch, found):
    old, _ = overload(clutch, friction=[(0.17, None)])
    for name in ("nominal_torque", "machine_torque"):
        found.same(f"overload {name}", q.at("overload")[name], getattr(old, name))
    scale = 1e-2 * float(old.nominal_torque)
    for (
        name
    ) in "potential_torque expected_torque load_rise actuation_torque_published actuation_torque_equilibrium".split():
        found.triple(name, q, getattr(old, name), scale)
        found.same(f"{name} at a point", q.at(friction=0.17)[name], getattr(old.points[0], name), scale)
    found.triple("potential_torque_gain", q, old.potential_torque_gain, scale)
    found.triple("actuation_factor", q, old.actuation_factor, 0.1)
    for (
        name
    ) in "accuracy_factor_expected accuracy_factor_actual accuracy_factor_equilibrium optimal_reduced_gain".split():
        found.same(name, q[name], getattr(old, name))
    if old.friction_interval:
        ends = [q.friction_at_equal_potential, q.friction_at_unit_loop_gain]
        low, high = max(min(ends), q.friction_min), min(max(ends), q.friction_max)
        found.same("friction_interval", low, old.friction_interval[0])
        found.same("friction_interval", high, old.friction_interval[1])
    for load in old.loads or []:
        risen = q.at(friction=load.friction, risen_load=load.rise)
        found.same("load", risen.load_risen, load.load, scale)
        found.same("potential_torque_risen", risen.potential_torque_risen, load.potential_torque, scale)


def _life(q, clutch, found):
    try:
        old, _ = life(clutch)
    except (AfmcalcError, OverflowError):
        return
    sides = ("", old.protected), ("unprotected", old.unprotected)
    forecasts = ("forecast", old.protected_forecast), ("forecast unprotected", old.unprotected_forecast)
    for cases, one in (*sides, *forecasts):
        for method, name in (("", "as_set"), ("by_min", "min_friction"), ("by_mean", "mean_friction")):
            at = q.at(method) if method else q
            for case in cases.split():
                at = at.at(case)
            found.same(f"cycles {cases} {name}", at.cycles, getattr(one, name))
    found.same("stress_protected", q.damaging_stress if old.stress_protected else 0, old.stress_protected)
    found.same("stress_unprotected", q.at("unprotected").damaging_stress, old.stress_unprotected)
    if clutch.spec.shaft is not None and clutch.spec.shaft.yield_strength is not None:
        found.same("shear_yield_strength", q.shear_yield_strength, clutch.spec.shaft.shear_yield_strength)


def _synthesis(q, clutch, found):
    try:
        old, _ = synthesize(clutch)
    except (AfmcalcError, OverflowError):
        return
    q = q.at(balls_listed=tuple(diameters()))
    names = "wall_angle ball_radius ball_diameter_standard pocket_depth pocket_depth_cut pocket_width ball_pitch contact_force"
    curved = old.undercut_radius is not None
    if curved and old.ball_diameter >= 2 * old.undercut_radius:
        names = names.replace("pocket_width", "undercut_radius")  # a wall that cannot be cut has no width
    for name in (names + (" wall_angle_max undercut_radius" if curved else "")).split():
        found.same(name, q[name] if getattr(old, name) is not None else 0, getattr(old, name))
    found.same("edge_clearance_standard", q.edge_clearance_standard, old.edge_clearance_standard, scale=1e-4)
    found.same("travel_max", q.travel_max, old.travel_max, scale=1e-5)
    if old.web is not None and "undercut" not in names:
        found.same("web", q.web, old.web, scale=1e-4)
    if not curved:
        for name in ("contact_pressure", "contact_force_hertz"):
            found.same(name, q[name] if getattr(old, name) is not None else 0, getattr(old, name))
    elif old.contact_pressure is not None:
        assert q.contact_pressure >= old.contact_pressure * (1 - 1e-9)  # on the safe side


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
    assert found.count.total() > 50_000
