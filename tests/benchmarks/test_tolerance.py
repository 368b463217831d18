"""Tolerance over ten million samples and Sobol indices, against plain NumPy, OpenTURNS and SALib on the same model.

OpenTURNS and SALib come with ``pip install 'afmcalc[bench]'``.
"""

import math
import os
import subprocess
import sys

import numpy as np
import pytest
from ratios import median_ratio

from afmcalc.analysis.tolerance.model import Model, inputs_of
from afmcalc.analysis.tolerance.statistics import merged, ranked
from afmcalc.analysis.tolerance.study import Plan, simulate, sobol_indices
from afmcalc.spec import make_spec

N = 10_000_000
BASE = 2**16
PROBABILITIES = [0.005, 0.05, 0.5, 0.95, 0.995]
CENTERS = {"friction": 0.3, "closing_spring.force": 2000.0, "friction_group.mean_radius": 0.1, "control_unit.gain": 0.5}
SPREADS = {
    "friction": 0.03,
    "closing_spring.force": 60.0,
    "friction_group.mean_radius": 1e-3,
    "control_unit.gain": 0.01,
}

SPEC = make_spec(
    {
        "variant": "differentiated",
        "friction": {"driving": {"min": 0.1, "mean": 0.3, "max": 0.8}, "driven": {"min": 0.1, "mean": 0.3, "max": 0.8}},
        "friction_group": {"pairs": 8, "mean_radius": 0.1},
        "closing_spring": {"force": 2000},
        "control_unit": {"gain": 0.5},
        "tolerance": {
            "fields": {
                "friction.driving": {"distribution": "normal", "spread": 0.03},
                "friction.driven": {"distribution": "normal", "spread": 0.03},
                "closing_spring.force": {"distribution": "normal", "spread": 60},
                "friction_group.mean_radius": {"distribution": "normal", "spread": 1e-3},
                "control_unit.gain": {"distribution": "normal", "spread": 0.01},
            }
        },
    }
)
MEANS, SIGMAS = np.array([0.3, 0.3, 2000, 0.1, 0.5]), np.array([0.03, 0.03, 60, 1e-3, 0.01])


def torque(f1, f2, force, radius, gain):
    return force * radius * (f1 + 7 * f2) / (1 + gain * 7 * f2)


def model():
    return Model(SPEC, inputs_of(SPEC))


def ours(samples=N, threads=2):
    whole = ranked(merged(simulate(model(), Plan(samples, 1, threads=threads), None, 0.0)))
    return [whole.quantile(p) for p in PROBABILITIES]


def plain():
    rng = np.random.default_rng(1)
    columns = [rng.normal(mean, sigma, N) for mean, sigma in zip(MEANS, SIGMAS, strict=True)]
    return np.quantile(torque(*columns), PROBABILITIES)


def openturns():
    """Its fastest way: all normals at once, one call for all quantiles."""
    ot = pytest.importorskip("openturns", reason="OpenTURNS is not installed: pip install 'afmcalc[bench]'")
    inputs = ot.Normal(MEANS.tolist(), SIGMAS.tolist())
    function = ot.SymbolicFunction(["a", "b", "F", "R", "C"], ["F * R * (a + 7 * b) / (1 + C * 7 * b)"])

    def run():
        return function(inputs.getSample(N)).computeQuantile(PROBABILITIES)

    return run


def test_the_same_answer():
    """Before speed: within the standard error of an extreme quantile."""
    assert ours(1_000_000) == pytest.approx(list(plain()), rel=2e-3)


def test_ten_million_samples_against_numpy(report):
    """Five normals a sample, drawn by NumPy here too, are three quarters of our time."""
    report("tolerance, 1e7 samples, against plain NumPy", median_ratio(ours, plain, pairs=5), 0.45)


@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="two threads want two processors")
def test_two_threads_against_one(report):
    report("tolerance, 1e7 samples, two threads against one", median_ratio(ours, lambda: ours(threads=1), pairs=5), 0.8)


def test_ten_million_samples_against_openturns(report):
    report("tolerance, 1e7 samples, against OpenTURNS", median_ratio(ours, openturns(), pairs=3), 1 / 4)


def test_peak_memory(report):
    """Of the whole process, for ten times as many samples too."""
    for samples in (N, 10 * N):
        code = _PROCESS.format(data=SPEC.model_dump(exclude_none=True), n=samples)
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        report(f"peak memory of the process, {samples:.0e} samples, MiB", float(run.stdout) / 1024, 100)


_PROCESS = """
from afmcalc.analysis.tolerance.model import inputs_of
from afmcalc.analysis.tolerance.model import Model
from afmcalc.analysis.tolerance.study import Plan, simulate
from afmcalc.spec import make_spec
spec = make_spec({data!r})
simulate(Model(spec, inputs_of(spec)), Plan({n}, 1, threads=2), None, 0.0)
# the kernel's high-water mark of this image; that of getrusage would be the parent's
print(next(line.split()[1] for line in open("/proc/self/status") if line.startswith("VmHWM")))
"""


def test_sobol_indices_against_salib(report):
    pytest.importorskip("SALib", reason="SALib is not installed: pip install 'afmcalc[bench]'")
    from SALib.analyze import sobol as analyze
    from SALib.sample import sobol as sample

    problem = {
        "num_vars": 5, "names": list("abFRC"), "dists": ["norm"] * 5,
        "bounds": [[float(m), float(s)] for m, s in zip(MEANS, SIGMAS, strict=True)],
    }  # fmt: skip

    def theirs():
        points = sample.sample(problem, BASE, calc_second_order=False, seed=1)
        return analyze.analyze(problem, torque(*points.T), calc_second_order=False, seed=1)

    def mine():
        return sobol_indices(model(), Plan(BASE, 1, threads=2))

    for index, expected in zip(mine(), theirs()["ST"], strict=True):
        assert math.isclose(index.total, expected, abs_tol=0.02)
    report("Sobol indices, base 2^16, against SALib", median_ratio(mine, theirs, pairs=5), 1 / 20)
