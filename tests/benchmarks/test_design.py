"""Search of 1e8 candidates: time per candidate, and the memory of the whole process."""

import json
import subprocess
import sys
import time
import tomllib

import pytest
from conftest import CONFIGS

from afmcalc.analysis.design.found import Found
from afmcalc.analysis.design.search import search
from afmcalc.analysis.design.space import total
from afmcalc.analysis.design.tiles import by_tile
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
        start = time.perf_counter()
        action()
        times.append(time.perf_counter() - start)
    return sorted(times)[runs // 2] / count * 1e9


@pytest.mark.parametrize(
    "objectives",
    [["closing_force", "accuracy_factor"], ["closing_force", "accuracy_factor", "pairs", "ball_diameter"]],
    ids=["two", "four"],
)
def test_a_hundred_million(objectives, report):
    need = make_requirements(wide(objectives))
    count = total(need)
    assert count == 104_000_000
    report(f"search, {len(objectives)} objectives, ns per candidate", nanoseconds(lambda: search(need), count), 3)


def test_every_candidate_evaluated(report):
    """The way without the look-up of the radii, for what is not separable (catalogue, wall angle, indirect)."""
    need = make_requirements(wide(["closing_force", "accuracy_factor"], radii=100, gains=100))
    report(
        "evaluated one by one, ns per candidate",
        nanoseconds(lambda: by_tile(need, VARIANTS["differentiated"], Found(), print_nothing), total(need)),
        500,
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
