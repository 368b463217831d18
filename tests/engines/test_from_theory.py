"""Five clutches calculated by hand from the papers, in plain arithmetic that shares no line with the program."""

import tomllib
from math import atan, cos, sin

import pytest

from afmcalc import Clutch


def direct(z1, z2, gain, friction):
    """With F_п = 3 kN, R = 90 mm."""
    given = f"friction_group = {{ pairs = {z1 + z2}, driving_pairs = {z1}, mean_radius = 0.09 }}\nfriction = {friction}"
    given += f"\nclosing_spring.force = 3e3\ncontrol_unit.gain = {gain}"
    return Clutch(tomllib.loads('variant = "differentiated"\n' + given))


def test_one_material():
    """F11 (9), (14); T = F R (z_1 + z_2) f/(1 + C z_2 f)."""
    clutch = direct(2, 8, 0.9, "{ min = 0.08, max = 0.45 }")
    low, high = (3000 * 0.09 * 10 * f / (1 + 0.9 * 8 * f) for f in (0.08, 0.45))
    assert clutch.accuracy().accuracy_factor == pytest.approx(high / low, rel=1e-12)
    assert clutch.accuracy().gain_limit == pytest.approx(1 / (2 * 0.45), rel=1e-12)
    assert clutch.torque().to_dict()["torque"]["min"] == pytest.approx(low, rel=1e-12)


def test_unlike_materials():
    """F11 (12), (15); with z_1 C f_1 > 1 the torque is largest at the smallest friction."""
    driving, driven = (0.5, 0.55, 0.6), (0.1, 0.35, 0.6)
    blocks = "driving = { min = 0.5, mean = 0.55, max = 0.6 }, driven = { min = 0.1, mean = 0.35, max = 0.6 }"
    found = direct(1, 6, 3, f"{{ {blocks} }}").accuracy().to_dict()
    path = [(one + 6 * two) / (1 + 18 * two) for one, two in zip(driving, driven, strict=True)]
    corners = [(one + 6 * two) / (1 + 18 * two) for one in driving[::2] for two in driven[::2]]
    assert found["accuracy_factor"] == pytest.approx(max(path) / min(path), rel=1e-12)
    assert found["accuracy_factor_worst_case"] == pytest.approx(max(corners) / min(corners), rel=1e-12)


Z, R, F1, C1, C2, LOW, MEAN, HIGH = 6, 0.1, 2500, 40e3, 25e3, 0.1, 0.3, 0.7
KEY = 2 * R * 0.1 / 0.06
INDIRECT = f"""
variant = "indirect"
friction = {{ min = {LOW}, mean = {MEAN}, max = {HIGH} }}
friction_group = {{ pairs = {Z}, mean_radius = {R} }}
closing_spring = {{ force = {F1}, stiffness = {C1} }}
control_spring.stiffness = {C2}
control_unit = {{ gain = 1.0, ball_circle_radius = 0.05, hub_diameter = 0.06, key_friction = 0.1, balls = 6 }}
"""


def indirect(gain, method):
    gaps = {"control_unit.face_gap": 0.003, "control_unit.edge_clearance": 0.002}
    return Clutch(tomllib.loads(INDIRECT)).with_({"C": gain, "adjustment.method": method} | gaps)


@pytest.mark.parametrize(("method", "setting"), [("mean-friction", MEAN), ("min-friction", LOW)])
def test_indirect_rising_and_returning(method, setting):
    """S21 (10), (11), (14): below its setting at the stop; back with κ₊, locked until f has fallen by κ₊/κ."""
    rising, back = 0.8 - KEY, 0.8 + KEY
    control = F1 * (1 + Z * rising * setting)

    def torque(f, net, seated):
        pressed = control / (1 + Z * net * f) if seated else (F1 * C2 + control * C1) / (C1 + C2 + Z * C1 * f * net)
        return Z * R * f * pressed

    def returning(f):
        if f >= HIGH * rising / back:
            return torque(HIGH, rising, seated=False) * f / HIGH
        return torque(f, back, seated=f <= setting * rising / back)

    clutch, frictions = indirect(0.8, method), {"min": LOW, "mean": MEAN, "max": HIGH}
    up = {name: torque(f, rising, seated=f <= setting) for name, f in frictions.items()}
    found = clutch.torque().to_dict()
    assert found["control_force"] == pytest.approx(control, rel=1e-12)
    assert found["torque"] == pytest.approx(up, rel=1e-12)
    assert found["torque_returning"] == pytest.approx({name: returning(f) for name, f in frictions.items()}, rel=1e-12)
    least = min(returning(LOW + (HIGH - LOW) * step / 1000) for step in range(1001))
    expected = max(up.values()) / least
    assert clutch.accuracy().accuracy_factor_hysteresis == pytest.approx(expected, rel=1e-9)


def test_synthesis():
    """S21 (16), (20), (23), (24); the depth is that of the standard ball."""
    net = 1.3 - KEY
    stiffness = C1 + C2 + Z * C1 * HIGH * net
    travel = Z * F1 * (HIGH - LOW) * net / stiffness
    torque = Z * R * HIGH * (F1 * C2 + F1 * (1 + Z * net * LOW) * C1) / stiffness
    angle, found = atan(1.3 * 0.05 / R), indirect(1.3, "min-friction").pocket().to_dict()
    assert found["ball_radius"] == pytest.approx((travel + 0.003 + 2 * 0.002) / (2 * sin(angle)), rel=1e-12)
    assert found["contact_force"] == pytest.approx(torque / (6 * 0.05 * cos(angle)), rel=1e-12)
    assert found["pocket_depth"] == pytest.approx(found["ball_diameter_standard"] / 2 / sin(angle) - 0.0015, rel=1e-12)


def test_of_unlike_materials_the_torque_may_be_largest_at_the_means():
    """T = F R (z_1 f_1 + z_2 f_2)/(1 + z_2 C f_2): f_1 rises first, then f_2 where z_1 C f_1 > 1, and T falls."""
    spec = {
        "variant": "differentiated", "friction_group": {"pairs": 8, "driving_pairs": 4, "mean_radius": 0.1},
        "friction": {"driving": {"min": 0.2, "mean": 0.5, "max": 0.5}, "driven": {"min": 0.1, "mean": 0.1, "max": 0.8}},
        "closing_spring": {"force": 1000}, "control_unit": {"gain": 1.0},
    }  # fmt: skip
    assert Clutch(spec)["torque_max"] == pytest.approx(1000 * 0.1 * (4 * 0.5 + 4 * 0.1) / (1 + 4 * 0.1), rel=1e-12)
