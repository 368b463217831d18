"""Whole events: figures of a second program, until nothing more can come; steps, many drives at once, hostile cases."""

from dataclasses import fields, is_dataclass, replace

import numpy as np
import pytest
from conftest import slow
from drives import SLEEVE, TRAIN, case, indirect, merged, run, springs
from referee import referee
from sources import CLUTCHES

from afmcalc.analysis.simulate import simulate
from afmcalc.drive.cases import case_of, outcome_of
from afmcalc.drive.integrator import simulate as simulate_event
from afmcalc.drive.integrator import stepped
from afmcalc.drive.motion import Motion
from afmcalc.drive.pack_and_sleeve import DirectPack, Sleeve
from afmcalc.drive.train import Engine
from afmcalc.engines import build
from afmcalc.engines.quantities import Quantities
from afmcalc.spec import read_spec, resolved

HEAVY, STICKS = CLUTCHES["heavy"], CLUTCHES["sticks"]


@pytest.mark.slow
def test_a_heavy_tool_trips_the_clutch_late():
    """At f_max nothing slips in the first swing; it was said never to slip. The figures are those of referee.py."""
    result, found = simulate(build(HEAVY))
    told = (result.peak_torque.max, result.slip_time.max, result.slip_energy.max)
    assert told == pytest.approx((494.98, 2.01472, 10_887.9), rel=1e-3)
    assert min(vars(result.dynamic_factor).values()) > 1
    assert result.peak_torque_conventional.max == pytest.approx(result.peak_torque.max), "it is an ordinary clutch"
    assert result.largest_dynamic_factor > 1
    assert "motor-stops-at-cut-off" in {each.code for each in found}


def test_a_duration_is_run_out():
    """A given duration is simulated to its end, also in the history; a finding says if something may still come."""
    own = build(merged(HEAVY, {"drive": {"event": {"duration": 0.05}}}))
    result, found = simulate(own)
    assert result.slip_time.max == 0
    told = [(each.level, each.value) for each in found if each.code == "event-not-settled"]
    assert told == [("warning", pytest.approx(0.05))] * 2
    event = case_of(own, 0.3).run(full=True)
    assert event.rows[-1].time == pytest.approx(0.05)
    assert case_of(own, np.array([0.3])).peaks().peak[0] == pytest.approx(event.peak, rel=1e-9), "of a sweep"
    quick = merged(HEAVY, {"drive": {"event": {"kind": "stop", "stop_time": 0.01, "torque": None, "rise_time": None}}})
    quick = merged(quick, {"drive": {"tool_inertia": None, "cut_off": 0.05, "event": {"duration": 0.1}}})
    assert case_of(build(quick), 0.3).run(full=True).rows[-1].time == pytest.approx(0.1)
    assert "event-not-settled" not in {each.code for each in simulate(build(quick))[1]}


@pytest.mark.slow
def test_a_stalled_motor_slips_again_until_its_cut_off():
    """A Kloss motor at standstill pulls the harder the faster it turns: it swings a shaft that hardly damps."""
    own = merged(HEAVY, {"closing_spring": {"force": 1500}, "drive": {"damping_ratio": 0.0, "cut_off": 1.0}})
    own = merged(own, {"drive": {"motor": {"breakdown_torque": 340.0}, "tool_inertia": 0.5}})
    found = outcome_of(build(own), 0.3).event
    assert any(row.slip and row.time > 0.5 for row in found.rows), "long after the first slip has ended"
    assert found.settled
    assert found.time > 1.0, "the cut-off"
    never = merged(own, {"drive": {"cut_off": None}})
    assert simulate(build(never))[0].slip_time.max is None


@pytest.mark.slow
def test_the_comparison_covers_the_same_time():
    """The ordinary clutch that is compared is simulated until it trips, even if the clutch itself trips at once."""
    own = merged(HEAVY, {"variant": "differentiated", "control_unit": {"gain": 1.0}, "closing_spring": None})
    own["adjustment"] = {"nominal_torque": 160}
    found = outcome_of(build(own), 0.3)
    assert found.event.peak < 300
    assert found.ordinary_peak == pytest.approx(outcome_of(build(HEAVY), 0.3).event.peak, rel=1e-6)


def test_slips_are_summed():
    """Two slips with a stick of 0.2 ms between them count as the sum of both; figures of an independent program."""
    result, _ = simulate(build(STICKS))
    assert result.slip_time.max == pytest.approx(0.0155011, rel=1e-2)
    assert result.slip_energy.max == pytest.approx(61.7645, rel=1e-3)
    rows = [row for row in case_of(build(STICKS), STICKS["friction"]["max"]).run().rows if row.slip]
    assert rows[-1].time - rows[0].time > 1.01 * result.slip_time.max, "from the first slip to the last it is longer"


def test_balls_that_swing_on_are_left_once_nothing_can_come_of_them():
    """The end of an event that is left out changes nothing: with it, peak, slip and heat are the same."""
    own = indirect(0.4, law={"key_friction": 0.1}, motor_inertia=0.4, damping=1.0)
    found = own.run()
    assert found.settled
    on = simulate_event(own.train, own.pack, found.time + 0.1, full=True)
    assert on.time == pytest.approx(found.time + 0.1)
    assert (on.peak, on.slip_time, on.heat) == pytest.approx((found.peak, found.slip_time, found.heat), rel=1e-2)


def hammering(**more: object):
    """example:indirect in that drive."""
    given = {**{f"drive.{key}": value for key, value in CLUTCHES["hammering"].items()}, **more}
    return build(read_spec("example:indirect", [f"{key}={value}" for key, value in given.items()]))


@pytest.mark.parametrize("f", [0.15, 0.2])
def test_a_sleeve_that_hammers_meets_the_referee(f):
    own = hammering()
    set_to = {"adjustment": {"nominal_torque": own.nominal_torque}, "drive": {"load_torque": own.machine_torque}}
    case = case_of(own, f)
    found = simulate_event(case.train, case.pack, 0.03, full=True)
    peak, peak_clutch, _, heat, *_ = referee(merged(resolved(own.spec), set_to), [f], 0.03, 200)
    assert (found.peak, found.peak_clutch, found.heat) == pytest.approx((peak, peak_clutch, heat), rel=1e-3)


@pytest.mark.slow
def test_the_key_loses_what_the_turns_of_the_sleeve_tell():
    """dE = (C/κ − 1) dW on the way out, (1 − C/κ₊) dW back, W = (F_п2 − F_п1) x + ½ (c_1 + c_2) x², F_п2 = F_п1 (1 + 2.4 κ)."""
    gain, kappa, kappa_back = 2.0, 1.4, 2.6
    own = hammering(**{"control_unit.key_friction": 0.15, "control_unit.gain": gain})
    assert outcome_of(own, 0.1).event.key_heat == 0, "at f_min the sleeve stays at its stop"
    for friction in (0.3, 0.8):
        event = case_of(own, friction).run()
        slips = [row.time for row in event.rows if row.slip]
        travel = np.array([row.travel for row in event.rows if row.time <= slips[-1]])
        work = np.diff(2000 * 2.4 * kappa * travel + 6e5 * travel**2 / 2)
        lost = np.where(work > 0, (gain / kappa - 1) * work, (1 - gain / kappa_back) * -work)
        assert event.key_heat == pytest.approx(lost.sum(), rel=1e-2)


@pytest.mark.slow
def test_slow_slip_is_as_long_as_it_is():
    """example:drive at f_min, in quadruple precision (RK4): it ends in judder, which grows from the rest of the event."""
    own = build(read_spec("example:drive"))
    found = case_of(own, own.spec.friction.groups[0].min).run()
    assert found.slip_time == pytest.approx(1.87255, rel=5e-3)
    assert found.heat == pytest.approx(3356.19, rel=1e-3)
    assert found.residual < 1e-6


EACH = 3
UNTIL = 0.05
KINDS = ["conventional", "differentiated", "all-driving", "indirect"]


def random_drives(variant: str, kind: str, rng: np.random.Generator):
    """Random drives and clutches of one kind, as arrays."""
    u = rng.uniform
    inertia, stiffness, load = 10 ** u(-2, -0.5, EACH), 10 ** u(3.3, 4.7, EACH), u(60, 150, EACH)
    kloss = variant in ("differentiated", "indirect")
    breakdown, slip, speed = load * u(1.1, 2.5, EACH), u(0.05, 0.3, EACH), u(5, 40, EACH)
    ratio = breakdown / load
    synchronous = speed / (1 - slip * (ratio - np.sqrt(ratio**2 - 1)))
    train = replace(
        TRAIN, motor_inertia=10 ** u(-0.5, 1, EACH), driven_inertia=inertia, stiffness=stiffness, speed=speed, load=load,
        hub_inertia=10 ** u(-2.3, -1, EACH) if variant == "indirect" else 0.0, kind=kind,
        tool_inertia=10 ** u(-1, 0.5, EACH) if kind == "load" else 0.0,
        damping=2 * u(0, 0.1, EACH) * np.sqrt(stiffness * inertia),
        engine=Engine(breakdown, slip, synchronous) if kloss else Engine(load, None, 0.0),
        time=np.where(u(size=EACH) < 0.3, 0.0, 10 ** u(-2.5, -1.5, EACH)),
        overload=u(300, 1600, EACH) if kind == "load" else load,
        cut_off=u(0.01, 0.1, EACH) if variant == "all-driving" else None,
    )  # fmt: skip
    friction, static, decay = u(0.1, 0.8, EACH), np.where(u(size=EACH) < 0.5, 1.0, u(1, 1.3, EACH)), 0.1 / u(0.1, 0.5, EACH)  # fmt: skip
    if variant == "indirect":
        gain, slope = u(0.3, 1.5, EACH), np.where(u(size=EACH) < 0.5, 0.0, u(0, 15, EACH))
        names = ("closing_stiffness", "control_stiffness")
        law = dict(zip(names, 10 ** u(3.7, 4.7, (2, EACH)), strict=True))
        law = springs(**law, gain=gain, key_friction=u(0, 0.8, EACH) * gain / 2, hub_diameter=0.1, gain_slope=slope)
        mass = np.where(u(size=EACH) < 0.5, 0.0, u(0, 3, EACH))
        return train, Sleeve(law, friction, mass, static, decay)
    bypass = {"conventional": 8, "differentiated": 1, "all-driving": 0}[variant]
    gain = u(0.1, 1.25, EACH)
    force = 200 * (1 + 0.1 * gain * (8 - bypass)) / (0.1 * 8 * 0.1)
    lag = np.where(u(size=EACH) < 0.5, 0.0, 10 ** u(-3, -1, EACH)) if variant == "differentiated" else 0.0
    return train, DirectPack(force, 0.1, bypass, 8 - bypass, gain, friction, friction, static, decay, lag)


def part(whole, place: int | slice):
    """The drives or clutches at a place of the arrays: one, or some."""
    if isinstance(whole, np.ndarray):
        return whole[place] if isinstance(place, slice) else float(whole[place])
    if isinstance(whole, Quantities):
        return Quantities(whole.laws, {name: part(value, place) for name, value in whole.given.items()})
    if not is_dataclass(whole):
        return whole
    return replace(whole, **{each.name: part(getattr(whole, each.name), place) for each in fields(whole)})


@pytest.mark.parametrize(
    ("variant", "kind"),
    [("conventional", "load"), *slow(("differentiated", "stop"), ("all-driving", "load"), ("indirect", "stop"))],
)
def test_a_sweep_has_the_answers_of_its_rows(variant, kind):
    """Many drives at once, some of which need finer steps, give what each gives alone, also in finer steps."""
    rng = np.random.default_rng([5, KINDS.index(variant) * 2 + (kind == "load")])
    train, pack = random_drives(variant, kind, rng)
    found = simulate_event(train, pack, UNTIL)
    for number in range(EACH):
        own, clutch = part(train, number), part(pack, number)
        alone = simulate_event(own, clutch, UNTIL)
        for name in ("peak", "peak_clutch", "heat", "slip_time", "key_heat", "travel_max"):
            assert getattr(found, name)[number] == pytest.approx(getattr(alone, name), rel=1e-9), name
        finer = stepped(Motion(own, clutch, alone.rows[1].time / 4), UNTIL)
        assert alone.peak == pytest.approx(finer.peak, rel=2e-3)
        assert alone.heat == pytest.approx(finer.heat, rel=5e-3, abs=1e-3 * Motion(own, clutch, 1e-6).stored)
        assert alone.residual < 1e-3


def test_the_error_falls_with_the_step():
    """The error is of second order while the clutch slips all the time, and at least of first order over switches."""
    pack = DirectPack(3000.0, 0.1, 0.0, 8.0, 0.5, 0.4, 0.4, 1.2, 0.1 / 0.3)
    for own, hub in ((pack, 0.0), (replace(SLEEVE, friction=0.4), 0.02)):
        train = replace(TRAIN, hub_inertia=hub, damping=1.0)
        heats = [stepped(Motion(train, own, 0.05 / steps), 0.05).heat for steps in (256, 1024, 4096)]
        coarse, fine = (abs(heat / heats[-1] - 1) for heat in heats[:-1])
        assert fine < min(coarse * 4**-0.8, 1e-4)


def test_a_key_free_of_friction_swings_on_for_the_duration():
    """Nothing damps the balls: they rattle to the end, which is no error, and the energy balance closes."""
    own = indirect(0.4, law={"key_friction": 0.0}, motor_inertia=0.4)
    found = simulate_event(own.train, own.pack, 0.25, full=True)
    assert found.time == pytest.approx(0.25)
    assert found.key_heat == 0
    assert found.residual < 1e-3


def test_friction_of_nothing_is_no_traceback():
    found = run(case(1e-300, time=0.0), 0.1)
    assert found.peak < 500
    assert not found.stuck
