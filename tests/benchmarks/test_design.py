"""Search of 1e8 candidates: time per candidate, and the memory of the whole process."""

import json
import subprocess
import sys
import time
import tomllib

import pytest
from conftest import CONFIGS

from afmcalc.analysis.design import service
from afmcalc.analysis.design.search import Survey, by_tile, search
from afmcalc.analysis.design.space import total
from afmcalc.spec.requirements import make_requirements
from afmcalc.variants import VARIANTS

BASE = tomllib.loads((CONFIGS / "requirements.toml").read_text(encoding="utf-8"))


def wide(objectives, radii=1000, gains=1000, circles=8):
    data = json.loads(json.dumps(BASE))
    data["variants"], data["objectives"] = ["differentiated"], objectives
    data["search"] |= {
        "pairs": {"start": 4, "stop": 16},
        "driving_pairs": [1],
        "mean_radius": {"start": 0.06, "stop": 0.14, "count": radii},
        "gain": {"start": 0.001, "stop": 1.25, "count": gains},
        "ball_circle_radius": {"start": 0.03, "stop": 0.06, "count": circles},
    }
    return data


def nanoseconds(action, count, runs=3):
    times = []
    for _ in range(runs):
        start = time.process_time()
        action()
        times.append(time.process_time() - start)
    return sorted(times)[runs // 2] / count * 1e9


@pytest.mark.parametrize(
    ("objectives", "limit"),
    [(["closing_force", "accuracy_factor"], 3), (["closing_force", "accuracy_factor", "pairs", "ball_diameter"], 8)],
    ids=["two", "four"],
)
def test_a_hundred_million(objectives, limit, report):
    """With the ball an objective every one of 148 sizes has a front of its own."""
    need = make_requirements(wide(objectives))
    count = total(need)
    assert count == 104_000_000
    report(f"search, {len(objectives)} objectives, ns per candidate", nanoseconds(lambda: search(need), count), limit)


def grid(low, high, count):
    return {"start": low, "stop": high, "count": count}


PAIRS = {"start": 4, "stop": 16}
DIRECT = {"pairs": PAIRS, "driving_pairs": [1], "mean_radius": grid(0.06, 0.14, 100)}
INDIRECT = {
    "pairs": PAIRS, "mean_radius": grid(0.06, 0.14, 60), "ball_circle_radius": grid(0.03, 0.06, 4),
    "closing_stiffness": grid(1e4, 2e5, 10), "control_stiffness": grid(1e4, 2e5, 10),
}  # fmt: skip
ANGLE = {"gain": None, "ball_circle_radius": grid(0.03, 0.06, 8)}
INSEPARABLE = {
    "wall angle": ("differentiated", {**DIRECT, **ANGLE, "wall_angle": grid(0.05, 1.0, 100)}),
    "indirect": ("indirect", {**INDIRECT, "gain": grid(0.3, 3, 60)}),
    "indirect, wall angle": ("indirect", {**INDIRECT, "gain": None, "wall_angle": grid(0.1, 1.2, 60)}),
    "catalogue": (
        "differentiated",
        {**DIRECT, "gain": grid(0.001, 1.25, 100), "ball_circle_radius": grid(0.03, 0.06, 8), "closing_force": None,
         "closing_forces": grid(500, 8000, 20)},
    ),
}  # fmt: skip


@pytest.mark.parametrize("space", INSEPARABLE)
def test_spaces_that_do_not_separate(space, report):
    variant, axes = INSEPARABLE[space]
    data = wide(["closing_force", "accuracy_factor"])
    data["variants"] = [variant]
    data["search"] = {key: value for key, value in {**data["search"], **axes}.items() if value is not None}
    if variant == "indirect":
        data["wanted"] |= {"accuracy_factor": 4, "torque_max": 1000}
        data["fixed"] |= {"hub_diameter": 0.05, "key_friction": 0.05, "face_gap": 1e-3, "edge_clearance": 1e-3}
    need = make_requirements(data)
    report(f"{space}, ns per candidate", nanoseconds(lambda: search(need), total(need)), 10)


def test_every_candidate_evaluated(report):
    """The way without the look-up of the radii."""
    need = make_requirements(wide(["closing_force", "accuracy_factor"], radii=100, gains=100))
    report(
        "evaluated one by one, ns per candidate",
        nanoseconds(lambda: by_tile(need, VARIANTS["differentiated"], Survey(), print_nothing), total(need)),
        50,
    )


def print_nothing(done):
    pass


def test_peak_memory(report):
    code = """
import json, sys
from afmcalc.analysis.design.search import search
from afmcalc.spec.requirements import make_requirements
search(make_requirements(json.loads(sys.stdin.read())))
print(next(line.split()[1] for line in open("/proc/self/status") if line.startswith("VmHWM")))
"""
    data = json.dumps(wide(["closing_force", "accuracy_factor", "pairs", "ball_diameter"]))
    run = subprocess.run([sys.executable, "-c", code], input=data, capture_output=True, text=True, check=True)
    report("peak memory of the process, 1e8 candidates, MiB", float(run.stdout) / 1024, 100)


def test_a_batch_simulated(report):
    """The wood chipper: three events of each candidate; 10⁵ of them are to take 5 minutes at most."""
    data = tomllib.loads((CONFIGS / "wood-chipper.toml").read_text(encoding="utf-8"))
    data["search"] |= {"mean_radius": grid(0.13, 0.14, 40), "gain": grid(0.2, 1.5, 40)}
    need = make_requirements(data)
    member = max(search(need, print_nothing, every=True).members, key=lambda each: len(each.values))
    count = min(len(member.values), 2000)
    assert count == 2000

    def simulated():
        service._shares(member.need, member.variant, member.at.at(slice(0, count)))

    report("simulated in a batch, ms per candidate", nanoseconds(simulated, count, runs=1) / 1e6, 3)
