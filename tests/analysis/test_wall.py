"""The wall of a pocket: against the distance from the path, against what a ball needs, and its contact."""

import math

import numpy as np
import pytest
from conftest import CONFIGS
from hypothesis import assume, example, given
from hypothesis import strategies as st
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

from afmcalc.analysis.pocket_wall import Wall
from afmcalc.analysis.synthesize import pocket
from afmcalc.engines import build
from afmcalc.equations import control_unit, curved_wall
from afmcalc.spec import read_spec
from afmcalc.spec.edit import with_key
from afmcalc.spec.models import Contact

STEEL = Contact(
    ball_modulus=210e9, ball_poisson=0.3, wall_modulus=206e9, wall_poisson=0.28, allowable_pressure=4e9
)  # fmt: skip


@st.composite
def walls(draw):
    """A wall that a ball can run on, the ball touching it below the face at the stop."""
    tangent, radius = draw(st.floats(0.1, 2)), draw(st.floats(2e-3, 30e-3))
    limit = (1 + tangent**2) ** 1.5
    wall = Wall(tangent, draw(st.floats(0.01, 0.95)) * limit / radius, draw(st.floats(0, 3e-3)), radius)
    assume(wall.clearance(0.0) > 1e-4)
    return wall


def path(wall, depth):
    return np.array([depth, depth * wall.tangent + wall.steepening * depth**2 / 2])


@given(walls())
def test_the_wall_is_a_ball_s_radius_from_the_path(wall):
    """1e-9 mm: no place of the ball reaches into it, and one touches it; chords lie within a hundredth."""
    points = wall.points()
    assert wall.can_be_cut
    for point in points:
        at = np.array([point.wall_axial, point.wall_around])

        ways = np.array([0, *np.linspace(-1e-3, 1e-3, 9), *np.linspace(0, wall.mouth, 9)])
        ways = np.clip(point.path_axial + ways, 0, None)  # the path begins at the stop
        distances = np.hypot(*(path(wall, ways) - at[:, None]))
        assert distances[0] == pytest.approx(wall.ball_radius, abs=1e-12)
        assert distances.min() >= wall.ball_radius - 1e-12
    assert points[-1].wall_axial == pytest.approx(-wall.face_gap / 2, abs=1e-12), "it ends at the face"
    for first, last in zip(points, points[1:], strict=False):
        ends = np.array([[p.wall_axial, p.wall_around] for p in (first, last)])
        along = np.diff(ends, axis=0)[0] / np.hypot(*np.diff(ends, axis=0)[0])
        for share in np.linspace(0, 1, 23):
            between = wall.at(first.path_axial + share * (last.path_axial - first.path_axial))
            off = np.array([between.wall_axial, between.wall_around]) - ends[0]
            assert abs(along[0] * off[1] - along[1] * off[0]) <= 1e-5


@example(Wall(0.3, 60.0, 1e-3, 0.01), 10.0, 3e-3, 1e-3)
@given(walls(), st.floats(0, 20), st.floats(0, 5e-3), st.floats(0, 5e-3))
def test_the_smallest_ball_touches_below_the_face_all_along(wall, steeper, travel, clearance):
    """r_ш sin α ≥ ξ + s/2 + y at every place, with equality at one, also where such a ball undercuts the wall."""
    wall = wall._replace(steepening=wall.steepening * (1 + steeper))
    steepest = curved_wall.wall_angle_max(wall.tangent, wall.steepening, travel)
    sine = math.sin(math.atan(wall.tangent))
    smallest = curved_wall.ball_radius(wall.face_gap, clearance, sine, travel, steepest)
    wall = wall._replace(ball_radius=smallest)
    ways = np.linspace(0, travel / wall.sleeves, 301)
    sine = np.sin(np.arctan(wall.tangent + wall.steepening * ways))
    left = wall.ball_radius * sine - ways - wall.face_gap / 2
    assert left.min() == pytest.approx(clearance, abs=1e-12)
    assert wall.clearance(travel) == pytest.approx(left.min(), abs=1e-12)


@given(walls(), st.floats(1.01, 3))
def test_a_larger_ball_undercuts(wall, times):
    """The wall of a ball beyond ρ_0 runs back on itself, and the contact sinks as the ball rises."""
    large = wall._replace(ball_radius=wall.undercut_radius * times)
    assert not large.can_be_cut
    step = 1e-7
    assert large.at(step).wall_axial < large.at(0.0).wall_axial
    assert wall.at(step).wall_axial > wall.at(0.0).wall_axial


def constant_torque(**keys):
    spec = read_spec(CONFIGS / "constant-torque.toml")
    for name, value in ({"ball_circle_radius": 0.05, "balls": 6} | keys).items():
        spec = with_key(spec, f"control_unit.{name}", value)
    return build(spec)


def test_the_path_turns_the_sleeves_as_far_as_the_law():
    """r dφ = tan α dx with tan α = (r/R)(C_0 + C_1 x)."""
    clutch = constant_torque()
    ratio = 0.5
    turned = ratio * (clutch.gain * 3e-3 + clutch.gain_slope * 3e-3**2 / 2)
    found, _ = pocket(clutch)
    wall = Wall(math.tan(found.wall_angle), clutch.gain_slope * ratio, 2e-3, found.ball_diameter / 2)
    assert wall.at(3e-3).path_around == pytest.approx(turned)


def test_what_cannot_be_cut_says_what_would():
    clutch = constant_torque(gain=1.0, allowable_contact_force=5e3)
    found, findings = pocket(clutch)
    told = [each for each in findings if each.code == "wall-undercut"]
    hint, refusal = sorted(told, key=lambda each: each.level == "error")
    assert (refusal.level, hint.level) == ("error", "info")
    assert found.wall is None
    gain = float(f"{hint.value:.4g}")
    again, after = pocket(constant_torque(gain=gain, allowable_contact_force=5e3))
    assert again.wall is not None
    assert not any(each.level == "error" for each in after)


def borne(ball, rho):
    """Force at the allowable pressure where the path of the ball is bent by a radius."""
    radius = curved_wall.contact_radius_at_ball(ball, 1 / rho, 0.0)
    modulus = control_unit.contact_modulus(210e9, 0.3, 206e9, 0.28)
    pressure = curved_wall.contact_pressure_at_ball(4e9, 1.0, radius, modulus)
    return curved_wall.contact_force_hertz(1.0, 4e9, pressure)


@given(st.floats(1.02, 50), st.floats(1e-3, 0.05))
def test_the_contact_on_a_curved_wall_is_on_the_safe_side(ratio, ball):
    """Johnson (4.26), (4.28): the pressure on the ellipse, R_e, K and E from SciPy, axes by bisection."""
    rho = ball * ratio
    force = borne(ball, rho)
    modulus = 1 / ((1 - 0.3**2) / 210e9 + (1 - 0.28**2) / 206e9)
    a_over_b = rho / (rho - ball)

    def integrals(k):
        return ellipk(1 - k * k), ellipe(1 - k * k)

    def curvatures(k):
        first, second = integrals(k)
        return (second / k**2 - first) / (first - second)

    k = brentq(lambda k: curvatures(k) - a_over_b, 1e-3, 1 - 1e-6)
    first, second = integrals(k)
    factor = 4 / (math.pi * (1 - k * k)) * k**1.5 * math.sqrt((second / k**2 - first) * (first - second))
    size = (3 * force * ball / math.sqrt(a_over_b) / (4 * modulus) * factor) ** (1 / 3)
    told = 4e9 / (3 * force / (2 * math.pi * size**2))
    assert told > 1 - 1e-6
    most = {2: 1.0265, 1.4: 1.085}
    assert all(told < limit for least, limit in most.items() if ratio >= least)


def test_the_contact_where_it_is_used_most():
    clutch = constant_torque(allowable_contact_force=None, contact=STEEL)
    found, findings = pocket(clutch)
    assert found.contact_basis == "hertz-ball-on-curved-wall"
    used, forces = [], []
    for friction in np.linspace(0.1, 0.8, 200):
        angle = math.atan((clutch.gain + clutch.gain_slope * clutch.at(friction=friction)["travel"]) * 0.5)
        force = clutch.at(friction=friction)["torque"] / (6 * 0.05 * math.cos(angle))
        forces.append(force)
        rho = 1 / (375 * 0.5 * math.cos(angle) ** 3)
        used.append(force / borne(found.ball_diameter / 2, rho))
    assert found.contact_utilisation == pytest.approx(max(used), rel=1e-3)
    assert found.contact_force == pytest.approx(max(forces), rel=1e-9), "the largest of all"
    critical = forces[int(np.argmax(used))]
    assert critical < 0.8 * max(forces)
    assert found.contact_force / found.contact_force_allowable == pytest.approx(found.contact_utilisation, rel=1e-3)
    (refusal,) = [each for each in findings if each.code == "contact-force-exceeded"]
    assert refusal.value == found.contact_force
