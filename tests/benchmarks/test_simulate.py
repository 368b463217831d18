"""One event by located switches; many drives by time stepping against one such event after the other."""

import time
import tracemalloc
from dataclasses import replace

import numpy as np
from conftest import CONFIGS
from drives import clutch

import afmcalc
from afmcalc.drive.cases import case_of
from afmcalc.drive.lanes import march
from afmcalc.drive.pack import pack_of
from afmcalc.drive.train import train_of
from afmcalc.drive.trip import trip
from afmcalc.engines import build
from afmcalc.spec import read_spec
from afmcalc.spec.edit import respecified

DRIVES, STEPS = 10_000, 10_000
SAMPLE = 100
"""Steps that are timed of them; the rest takes as long."""


def seconds(action) -> float:
    """Of the processor: other work on the machine is not counted."""
    start = time.process_time()
    action()
    return time.process_time() - start


def test_one_event(report):
    case = case_of(afmcalc.load(CONFIGS / "drive.toml"), 0.3)

    def run():
        trip(case.plant, case.horizon)

    run()
    report("one event of configs/drive.toml, s", min(seconds(run) for _ in range(5)), 0.3)


def test_many_drives(report):
    """The reference drive, 10⁴ clutches × 10⁴ steps: each at least 200 times faster than its event, over the same time."""
    own = clutch()
    friction, rng = np.linspace(0.1, 0.8, DRIVES), np.random.default_rng(1)
    train = replace(train_of(own), stiffness=8000 * rng.uniform(0.8, 1.2, DRIVES))
    step = 2 * np.pi / np.sqrt(8000 / 0.05) / 200
    tracemalloc.start()
    march(train, pack_of(own, friction, friction), np.full(DRIVES, step), 5)
    report("memory of 10⁴ drives, MiB", tracemalloc.get_traced_memory()[1] / 2**20, 200)
    tracemalloc.stop()
    steps = seconds(lambda: march(train, pack_of(own, friction, friction), np.full(DRIVES, step), SAMPLE))
    plant = case_of(own, 0.3).plant
    alone = min(seconds(lambda: trip(plant, STEPS * step)) for _ in range(3))
    report("10⁴ steps of one of 10⁴ drives against its event alone", steps * STEPS / SAMPLE / DRIVES / alone, 1 / 200)


def test_a_sleeve_that_rattles(report):
    """Without key friction, and in pockets that hold the torque, the balls roll from wall to wall for long."""
    drive = {"speed": 30, "motor_inertia": 1.5, "driven_inertia": 0.01, "hub_inertia": 0.02, "shaft_stiffness": 4000}
    drive |= {"damping_ratio": 0.03, "event": {"kind": "stop", "stop_time": 0.01}, "dynamic_factor": None}
    for name, changed in (("indirect", {"control_unit.key_friction": 0.0}), ("constant-torque", {})):
        data = {f"drive.{key}": value for key, value in drive.items()} | changed
        spec = respecified(read_spec(CONFIGS / f"{name}.toml"), data)
        longest = max(seconds(case_of(build(spec), friction).run) for friction in (0.1, 0.3, 0.8))
        report(f"longest event of configs/{name}.toml, s", longest, 2.0)
