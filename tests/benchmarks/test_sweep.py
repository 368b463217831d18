"""A sweep of a million points through the Python API and in bare NumPy, each timed once in a process of its own."""

import statistics
import subprocess
import sys
from functools import cache

import numpy as np
import pytest

import afmcalc
from afmcalc.engines.evaluate import evaluate

PAIRS = 21
Z1, Z2, LOW, HIGH, FORCE, RADIUS = 1, 7, 0.1, 0.8, 2000.0, 0.1


def bare(gain):
    factor = (Z1 * HIGH + Z2 * HIGH) * (1 + Z2 * gain * LOW) / ((Z1 * LOW + Z2 * LOW) * (1 + Z2 * gain * HIGH))
    return {"accuracy_factor": factor}


def bare_three(gain):
    nominal = FORCE * RADIUS * (Z1 * LOW + Z2 * LOW) / (1 + gain * Z2 * LOW)
    largest = FORCE * RADIUS * (Z1 * HIGH + Z2 * HIGH) / (1 + gain * Z2 * HIGH)
    return {**bare(gain), "nominal_torque": nominal, "torque_max": largest}


clutch = cache(afmcalc.load)


def swept(gain, names=("accuracy_factor",)):
    return evaluate(clutch().spec, {"control_unit.gain": gain}, dict(zip(names, names, strict=True)))


def swept_three(gain):
    return swept(gain, ["accuracy_factor", "nominal_torque", "torque_max"])


def torque(f):
    return clutch().torque(f)


def bare_torque(f):
    return FORCE * RADIUS * (Z1 * f + Z2 * f) / (1 + 0.5 * Z2 * f)


_ONCE = """
import time, numpy as np, test_sweep
values = np.linspace(0.1, 0.8, 1_000_000)
test_sweep.{name}(values[:1000].copy())  # whatever is imported or compiled on first use
start = time.perf_counter()
answer = test_sweep.{name}(values)
print(time.perf_counter() - start)
"""


def seconds(name):
    """Of a sweep in a process of its own."""
    paths = f"import sys; sys.path[:0] = {[path for path in sys.path if path]!r}\n"
    run = subprocess.run([sys.executable, "-c", paths + _ONCE.format(name=name)], capture_output=True, check=True)
    return float(run.stdout)


@pytest.mark.parametrize(("text", "ours", "plain", "limit"), [
    ("torque of 1e6 frictions", torque, bare_torque, 1.2),
    ("sweep of 1e6 gains, accuracy factor alone", swept, bare, 1.25),  # 1.02 to 1.24 seen: validation is a tenth
    ("sweep of 1e6 gains, three answers each", swept_three, bare_three, 1.1),
])  # fmt: skip
def test_a_million_points(text, ours, plain, limit, report):
    values = np.linspace(0.1, 0.8, 1001)
    if ours is torque:
        assert np.array_equal(ours(values), plain(values))
    else:
        own, theirs = ({name: each.tolist() for name, each in of(values).items()} for of in (ours, plain))
        assert own == theirs
    times = [(seconds(ours.__name__), seconds(plain.__name__)) for _ in range(PAIRS)]
    # the quarter least disturbed: a single sweep is a few milliseconds
    own, theirs = (statistics.quantiles(each, n=4)[0] for each in zip(*times, strict=True))
    report(text, own / theirs, limit)
