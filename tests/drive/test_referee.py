"""``simulate`` against a second program of the theory, which has no line in common with it."""

import pytest
from drives import REFERENCE, VARIANTS, merged
from referee import referee
from test_events import EVENTS, TOLERANCES

import afmcalc

EXAMPLE = {
    "variant": "differentiated",
    "friction": {"min": 0.1, "mean": 0.3, "max": 0.8, "static_ratio": 1.15, "stribeck_speed": 0.1},
    "friction_group": {"pairs": 8, "mean_radius": 0.1},
    "control_unit": {"gain": 0.5},
    "adjustment": {"nominal_torque": 160 / 1.35},
    "drive": {
        "speed": 30.0, "motor_inertia": 1.5, "driven_inertia": 0.01, "shaft_stiffness": 4000.0, "damping_ratio": 0.03,
        "load_torque": 128 / 1.35, "event": {"kind": "stop", "stop_time": 0.01},
    },
}  # fmt: skip
"""``example:drive``."""
PEAKS = {"conventional": (415, 952, 2078), "differentiated": (397, 556, 636), "all-driving": (402, 629, 764)}
"""Of the reference drive, in the shaft: theory, section 9."""
ENDS: dict[str, dict[int, float]] = {
    "direct": {
        2: 0.16, 3: 0.6, 4: 0.22, 6: 0.68, 8: 0.67, 10: 0.13, 12: 0.33, 14: 2.6, 15: 2.1, 16: 1.7, 17: 0.52, 19: 0.44,
        22: 0.17, 28: 0.95, 32: 0.048,
    },
    "indirect": {
        15: 0.32, 37: 0.036, 40: 0.1, 44: 0.46, 48: 0.22, 51: 0.048, 57: 0.59, 60: 0.161, 70: 0.32, 78: 0.088, 79: 0.39,
        84: 0.64, 89: 0.12, 92: 0.017, 97: 0.02,
    },
}  # fmt: skip
"""Random drives by their number → when nothing can come any more, s; indirect ones all have a key that rubs."""
STEPS = {"direct": {}, "indirect": {48: 1600, 57: 400, 79: 800}}
"""For each radian of the fastest swing, 200 else: static friction comes back within the last moment of these slips."""


@pytest.mark.slow
def test_the_referee_meets_the_theory():
    found = referee(EXAMPLE, [0.3], 0.35)
    assert found[:4] == pytest.approx((359.42, 250.057, 0.31498, 1113.27), rel=1e-4)
    for variant, peaks in PEAKS.items():
        told = [referee(merged(REFERENCE, VARIANTS[variant]), [f], 0.06).peak_torque for f in (0.1, 0.3, 0.8)]
        assert told == pytest.approx(peaks, abs=0.5)


def compared(kind: str, number: int) -> None:
    row = EVENTS[kind][number]
    pair = tuple(row["friction"])
    point = afmcalc.build(row["spec"]).simulate(friction=[pair if len(pair) == 2 else pair[0]]).points[0]
    own = referee(row["spec"], row["friction"], ENDS[kind][number], STEPS[kind].get(number, 200))
    assert not own.slips_at_end
    told = {name: getattr(point, name) for name in TOLERANCES[kind]}
    for name, tolerance in TOLERANCES[kind].items():
        assert told[name] == pytest.approx(getattr(own, name), rel=tolerance, abs=1e-9), (name, told, own)
    if point.travel_max is not None:
        assert point.travel_max == pytest.approx(own.travel_max, rel=0.01, abs=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("number", ENDS["direct"])
def test_direct_drives(number):
    compared("direct", number)


@pytest.mark.slow
@pytest.mark.parametrize("number", ENDS["indirect"])
def test_indirect_drives(number):
    compared("indirect", number)
