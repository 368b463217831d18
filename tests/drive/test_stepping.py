"""Steps: many drives and one alike, random drives of all kinds, how the error falls with the step, hostile cases."""

from dataclasses import fields, is_dataclass, replace
from itertools import product

import numpy as np
import pytest
from conftest import slow
from drives import SLEEVE, TRAIN, case, indirect, run, springs

from afmcalc.drive.integrator import simulate, stepped
from afmcalc.drive.motion import Motion
from afmcalc.drive.pack_and_sleeve import DirectPack, Sleeve
from afmcalc.drive.train import Engine
from afmcalc.engines.quantities import Quantities

EACH = 3
END = 0.05
VARIANTS = ["conventional", "differentiated", "all-driving", "indirect"]


def random_drives(variant: str, kind: str, rng: np.random.Generator):
    """Drives and clutches as arrays."""
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
    """A drive or a clutch of the many, or some of them."""
    if isinstance(whole, np.ndarray):
        return whole[place] if isinstance(place, slice) else float(whole[place])
    if isinstance(whole, Quantities):
        return Quantities(whole.laws, {name: part(value, place) for name, value in whole.given.items()})
    if not is_dataclass(whole):
        return whole
    return replace(whole, **{each.name: part(getattr(whole, each.name), place) for each in fields(whole)})


QUICK = [("conventional", "load")]


@pytest.mark.parametrize(
    ("variant", "kind"), QUICK + slow(*(each for each in product(VARIANTS, ("stop", "load")) if each not in QUICK))
)
def test_a_sweep_has_the_answers_of_its_rows(variant, kind):
    """Many drives at once, of which some need finer steps, give what each alone gives, and in finer steps alike."""
    rng = np.random.default_rng([5, VARIANTS.index(variant) * 2 + (kind == "load")])
    train, pack = random_drives(variant, kind, rng)
    found = simulate(train, pack, END)
    for number in range(EACH):
        own, clutch = part(train, number), part(pack, number)
        alone = simulate(own, clutch, END)
        for name in ("peak", "peak_clutch", "heat", "slip_time", "key_heat", "travel_max"):
            assert getattr(found, name)[number] == pytest.approx(getattr(alone, name), rel=1e-9), name
        finer = stepped(Motion(own, clutch, alone.rows[1].time / 4), END)
        assert alone.peak == pytest.approx(finer.peak, rel=2e-3)
        assert alone.heat == pytest.approx(finer.heat, rel=5e-3, abs=1e-3 * Motion(own, clutch, 1e-6).stored)
        assert alone.residual < 1e-3


def test_the_error_falls_with_the_step():
    """Of the second order while it slips all along, and at least of the first over every switch."""
    pack = DirectPack(3000.0, 0.1, 0.0, 8.0, 0.5, 0.4, 0.4, 1.2, 0.1 / 0.3)
    for own, hub in ((pack, 0.0), (replace(SLEEVE, friction=0.4), 0.02)):
        train = replace(TRAIN, hub_inertia=hub, damping=1.0)
        heats = [stepped(Motion(train, own, 0.05 / steps), 0.05).heat for steps in (256, 1024, 4096)]
        coarse, fine = (abs(heat / heats[-1] - 1) for heat in heats[:-1])
        assert fine < min(coarse * 4**-0.8, 1e-4)


def test_a_key_free_of_friction_swings_on_for_the_duration():
    """Nothing damps the balls: they rattle to the end, which is no error, and their energy closes."""
    own = indirect(0.4, law={"key_friction": 0.0}, motor_inertia=0.4)
    found = simulate(own.train, own.pack, 0.25, full=True)
    assert found.time == pytest.approx(0.25)
    assert found.key_heat == 0
    assert found.residual < 1e-3


def test_friction_of_nothing_is_no_traceback():
    found = run(case(1e-300, time=0.0), 0.1)
    assert found.peak < 500
    assert not found.stuck
