"""A sweep of a million points through the Python API and in bare NumPy, each timed once in a process of its own."""

import statistics
import subprocess
import sys
from functools import cache

import numpy as np
import pytest
from sources import table

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


def seconds(name):
    """Time of a sweep in a process of its own, s."""
    paths = f"import sys; sys.path[:0] = {[path for path in sys.path if path]!r}\n"
    run = subprocess.run(
        [sys.executable, "-c", paths + table("programs")["timed"].format(name=name)], capture_output=True, check=True
    )
    return float(run.stdout)


@pytest.mark.parametrize(("text", "ours", "plain", "limit"), [
    ("sweep of 1e6 gains, accuracy factor alone", swept, bare, 1.25),  # 1.02 to 1.24 seen: validation is a tenth
    ("sweep of 1e6 gains, three answers each", swept_three, bare_three, 1.1),
])  # fmt: skip
def test_a_million_points(text, ours, plain, limit, capsys):
    values = np.linspace(0.1, 0.8, 1001)
    own, theirs = ({name: each.tolist() for name, each in of(values).items()} for of in (ours, plain))
    assert own == {name: pytest.approx(each, rel=1e-12) for name, each in theirs.items()}
    times = [(seconds(ours.__name__), seconds(plain.__name__)) for _ in range(PAIRS)]
    # the fastest quarter of the runs: a single sweep takes a few milliseconds, and is easily disturbed
    own, theirs = (statistics.quantiles(each, n=4)[0] for each in zip(*times, strict=True))
    with capsys.disabled():
        print(f"\n{text}: {own / theirs:.4g} (limit {limit:g})", end="")
    assert own / theirs <= limit
