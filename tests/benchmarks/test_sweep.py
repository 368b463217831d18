"""A sweep of a million points through the Python API against the bare NumPy expressions of the same formulas."""

import numpy as np
from ratios import median_ratio

import afmcalc
from afmcalc.analysis.accuracy import SWEEP_OUTPUTS
from afmcalc.analysis.sweep.points import evaluate

N = 1_000_000


def test_torque_over_friction(report):
    clutch = afmcalc.load()
    f = np.linspace(0.1, 0.8, N)
    force, radius, z1, z2, c = 2000.0, 0.1, 1, 7, 0.5

    def bare():
        return force * radius * (z1 * f + z2 * f) / (1 + c * z2 * f)

    assert np.array_equal(bare(), clutch.torque(f))
    report("torque of 1e6 frictions", median_ratio(lambda: clutch.torque(f), bare, pairs=41), 1.2)


def test_sweep_of_the_gain(report):
    spec = afmcalc.load().spec
    gain = np.linspace(0, 1.25, N)
    force, radius, z1, z2, low, high = 2000.0, 0.1, 1, 7, 0.1, 0.8

    outputs = {name: SWEEP_OUTPUTS[name] for name in ("accuracy_factor", "nominal_torque", "torque_max")}

    def bare():
        factor = (z1 * high + z2 * high) * (1 + z2 * gain * low) / ((z1 * low + z2 * low) * (1 + z2 * gain * high))
        nominal = force * radius * (z1 * low + z2 * low) / (1 + gain * z2 * low)
        largest = force * radius * (z1 * high + z2 * high) / (1 + gain * z2 * high)
        return factor, nominal, largest

    def swept():
        return evaluate(spec, {"control_unit.gain": gain}, outputs)

    assert np.array_equal(bare()[0], swept()["accuracy_factor"])
    report("sweep of 1e6 gains, three answers each", median_ratio(swept, bare, pairs=41), 1.1)


def test_sweep_of_the_gain_one_formula(report):
    """The accuracy factor alone: validation and the copy weigh more than beside three answers."""
    spec = afmcalc.load().spec
    gain = np.linspace(0, 1.25, N)
    z1, z2, low, high = 1, 7, 0.1, 0.8

    def bare():
        return (z1 * high + z2 * high) * (1 + z2 * gain * low) / ((z1 * low + z2 * low) * (1 + z2 * gain * high))

    def swept():
        return evaluate(spec, {"control_unit.gain": gain}, {"accuracy_factor": SWEEP_OUTPUTS["accuracy_factor"]})

    report("sweep of 1e6 gains, accuracy factor alone", median_ratio(swept, bare, pairs=41), 1.1)
