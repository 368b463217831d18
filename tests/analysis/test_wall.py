"""Pockets: standard balls, contact, the completed spec; the wall against the distance from the path and what a ball needs."""

import math

import numpy as np
import pytest
from conftest import CONFIGS, S21, codes, slow
from hypothesis import assume, example, given
from hypothesis import strategies as st
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk
from sources import CLUTCHES
from strategies import indirect_specs, p5

from afmcalc.analysis.accuracy_factor import accuracy
from afmcalc.analysis.check import check
from afmcalc.analysis.clutch_findings import clutch_findings
from afmcalc.analysis.fatigue import life
from afmcalc.analysis.pocket_wall import Wall
from afmcalc.analysis.synthesize import pocket
from afmcalc.analysis.tolerance_study import tolerance, with_setting
from afmcalc.engines import build
from afmcalc.equations import control_unit, curved_wall
from afmcalc.spec import make_spec, read_spec
from afmcalc.spec.catalogues import balls
from afmcalc.spec.edit import with_key, with_values
from afmcalc.spec.models import Contact, Required

STEEL = Contact(ball_modulus=210e9, ball_poisson=0.3, wall_modulus=206e9, wall_poisson=0.28, allowable_pressure=4e9)


@st.composite
def walls(draw):
    """A wall that a ball can run on, the ball touching it below the face at the stop."""
    tangent, radius = draw(st.floats(0.1, 2)), draw(st.floats(2e-3, 30e-3))
    limit = (1 + tangent**2) ** 1.5
    steepening = draw(st.floats(0.01, 0.95)) * limit / radius
    wall = Wall(tangent, steepening, draw(st.floats(0, 3e-3)), radius, limit / steepening)
    assume(wall.clearance(0.0) > 1e-4)
    return wall


def path(wall, depth):
    return np.array([depth, depth * wall.tangent + wall.steepening * depth**2 / 2])


@given(walls())
def test_the_wall_is_a_ball_s_radius_from_the_path(wall):
    """To 1e-9 mm no place of the ball cuts into the wall and one touches it; chords are within 0.01 mm."""
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


def test_what_cannot_be_cut_is_refused():
    found, findings = pocket(constant_torque(gain=1.0, allowable_contact_force=5e3))
    assert [each.level for each in findings if each.code == "wall-undercut"] == ["error"]
    assert found.wall is None


def borne(ball, rho):
    """Contact force at the allowable pressure, where the path of the ball has a radius of curvature ``rho``."""
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
    clutch = constant_torque(allowable_contact_force=None, contact=STEEL, static_safety=1.0)
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


BEST = 18.75
"""C_1* of P5's clutch: (20 + 10) N/mm/(8·0.1·2 kN)."""
HELD = "control_unit.pocket=constant-torque"


def pocketed(*overrides, **blocks):
    return build(p5(*overrides, **blocks))


def told(own):
    return codes(clutch_findings(own)).keys()


@pytest.mark.parametrize(
    ("slope", "found"),
    [(BEST, set()), (20, {"torque-falls-with-travel"}), (22.7, {"torque-falls-with-travel"}), (22.8, {"torque-jumps"})],
)
def test_a_torque_that_falls_is_said(slope, found):
    """D(f_set) = (20 + 10 + 8·20·0.1·0.4) N/mm over 8·0.1·2 kN: 22.75 1/m."""
    given = f"control_unit.gain_slope={slope}"
    assert told(pocketed(given)) & {"torque-falls-with-travel", "torque-jumps"} == found
    never = pocketed(given, "friction.mean=0.8", "adjustment.method=mean-friction")
    assert not told(never) & {"torque-falls-with-travel", "torque-jumps"}, "it rests all the way"


def test_life_where_the_torque_jumps():
    """The mean damage over the friction, by brute force: T rises to f_set, jumps down, and falls."""
    steep = pocketed(
        "control_unit.gain_slope=30", "adjustment.method=mean-friction", "closing_spring.force=75 kN",
        "closing_spring.stiffness=1500 N/mm", "control_spring.stiffness=750 N/mm", "fatigue.ultimate_strength=5 GPa",
    )  # fmt: skip
    assert "torque-jumps" in told(steep)
    torque, part = steep.at(friction=np.linspace(0.1, 0.8, 400_001))["torque"], steep.spec.fatigue
    assert torque.max() == pytest.approx(float(steep.torque_max), rel=1e-5)
    high = torque / part.polar_section_modulus / 2
    stress = high / (1 - high / part.ultimate_strength)
    above = stress > part.endurance_limit
    assert 0.2 < above.mean() < 0.8
    damage = np.where(above, (stress / part.endurance_limit) ** part.exponent / part.base_cycles, 0.0).mean()
    assert life(steep, "goodman")[0].protected.mean_friction == pytest.approx(1 / damage, rel=1e-2), "256 slips"


@pytest.mark.parametrize("setting", ["each-adjusted", *slow("as-made")])
def test_a_pocket_is_cut_once(setting):
    """Clutches with scattered values all have the pocket of the nominal clutch, unless the slope itself scatters."""
    fields = {
        "friction": {"distribution": "uniform"},
        "closing_spring.stiffness": {"distribution": "uniform", "spread": "10 %"},
        "control_unit.gain_slope": {"distribution": "normal", "spread": "2 %"},
    }
    nominal = pocketed(HELD, tolerance={"setting": setting, "samples": 5000, "sobol_base": 64, "fields": fields})
    made = with_setting(nominal, nominal.spec.tolerance)
    sample = build(with_values(made, {"closing_spring.stiffness": np.array([18e3, 22e3])}))
    assert sample.gain_slope == pytest.approx(BEST)
    assert sample.at(friction=0.5)["torque"] != pytest.approx(160, rel=1e-3)
    found, _ = tolerance(nominal)
    assert {row.path: row.center for row in found.inputs}["control_unit.gain_slope"] == pytest.approx(BEST)
    assert 1.01 < found.accuracy_factor_robust < 1.5
    alone, _ = tolerance(
        pocketed(
            HELD, tolerance={"samples": 5000, "sobol_base": 64, "fields": {"friction": {"distribution": "uniform"}}}
        )
    )
    assert (alone.accuracy_factor_robust, alone.histogram) == (pytest.approx(1, rel=1e-12), [])


def test_where_pockets_hold_the_torque_an_elasticity_is_one_side_s():
    """K_т = 1 there, and more on either side of C_1*."""
    told = [accuracy(pocketed(f"control_unit.gain_slope={share * BEST}")) for share in (0.99, 1, 1.01)]
    factors = [each.accuracy_factor for each, _ in told]
    assert factors[1] == pytest.approx(1)
    assert min(factors[0], factors[2]) > 1.0005
    said = [[each.limit for each in findings if each.code == "elasticity-one-sided"] for _, findings in told]
    assert said == [[], [pytest.approx(BEST)], []]


def test_a_kink_of_any_key_is_told():
    """K_т has a kink if the sleeve leaves its stop just at f_min: below, the stop bears part of the control spring."""
    made = build(read_spec("example:indirect", ["control_spring.force=6608", "friction.min=0.3"]))
    (told,) = [each for each in accuracy(made)[1] if each.code.startswith("elasticity-one-sided")]
    assert (told.code, told.path) == ("elasticity-one-sided", "friction.min")
    assert "control_spring.force" in told.message


@given(indirect_specs(), st.floats(0, 0.01), st.floats(0, 0.01))
def test_the_next_standard_ball_not_smaller(spec, gap, clearance):
    unit = spec.control_unit.model_copy(update={"face_gap": gap, "edge_clearance": clearance})
    result, findings = pocket(build(spec.model_copy(update={"control_unit": unit})))
    sizes = balls()
    wanted = 2 * result.ball_radius
    if result.ball_diameter_standard is None:
        assert wanted > max(sizes) == codes(findings)["no-standard-ball"].limit
        return
    assert result.ball_diameter_standard >= wanted * (1 - 1e-9)
    assert not any(wanted * (1 + 1e-9) <= size < result.ball_diameter_standard for size in sizes)
    assert result.edge_clearance_standard >= clearance - 1e-9
    # the torque of the balls: F_n has the moment n F_n cos α r about the axis
    clutch = build(spec)
    moment = result.contact_force * spec.control_unit.balls * math.cos(result.wall_angle) * result.ball_circle_radius
    assert moment == pytest.approx(clutch.at(friction=spec.friction.range.max)["torque"], rel=1e-9)


def small_balls(given):
    """Six balls of 5 mm, 574 N on each."""
    data = CLUTCHES["small_balls"]
    return build(make_spec(data | {"control_unit": data["control_unit"] | given}))


FORCE = {"allowable_contact_force": 5000}
ONE_STEEL = {"ball_modulus": 206e9, "ball_poisson": 0.3, "wall_modulus": 206e9, "wall_poisson": 0.3}
CONTACT = {"contact": ONE_STEEL | {"allowable_pressure": 4.2e9}}
BY_HERTZ, BY_FORCE = {True: 3.08}, {False: 0.115}
JUDGED = [({}, BY_HERTZ), (FORCE, BY_FORCE), (CONTACT, BY_HERTZ), (FORCE | CONTACT, BY_HERTZ | BY_FORCE)]


@pytest.mark.parametrize(("given", "judged"), JUDGED)
def test_small_balls_are_judged_by_hertz_unless_a_force_is_given(given, judged):
    """By Hertz 187 N are allowed, utilisation 3.08, 6.1 GPa; of a given 5 kN 0.115; with both given, both."""
    own = small_balls(given)
    verdict, found = check(own)
    on_ball = [each for each in verdict.checks if each.name.startswith("contact force on one ball")]
    rows = {"Hertz" in each.name: each for each in on_ball}
    assert {hertz: each.utilisation for hertz, each in rows.items()} == pytest.approx(judged, rel=2e-3)
    assert all(each.grade == ("fail" if hertz else "pass") for hertz, each in rows.items())
    assert ("contact-assumed" in codes(found)) == ("contact" not in given)
    assert True not in rows or rows[True].limit == pytest.approx(187, abs=0.5)
    result, _ = pocket(own)
    assert result.contact_pressure == pytest.approx(6.1e9, rel=5e-3)
    assert result.contact_utilisation == max(each.utilisation for each in rows.values())
    for most, passed in ((6.0e9, False), (6.2e9, True)):
        required = own.spec.model_copy(update={"requirements": Required(contact_pressure=most)})
        (row,) = check(build(required))[0].requirements
        assert (row.path, row.passed) == ("requirements.contact_pressure", passed)
        assert row.value == result.contact_pressure


@given(indirect_specs(), st.floats(0, 0.01), st.floats(0, 0.01))
def test_the_pocket_is_as_it_was_laid_out(spec, gap, clearance):
    """Ball at the origin, faces at ±s/2: the wall from mouth to apex touches the ball, the floor lies under it."""
    unit = spec.control_unit.model_copy(update={"face_gap": gap, "edge_clearance": clearance})
    found, _ = pocket(build(spec.model_copy(update={"control_unit": unit})))
    mouth, apex = np.array([gap / 2, found.pocket_width / 2]), np.array([gap / 2 + found.pocket_depth, 0.0])
    wall = (apex - mouth) / np.linalg.norm(apex - mouth)
    touching = mouth - wall * (mouth @ wall)
    assert np.linalg.norm(touching) == pytest.approx(found.ball_diameter / 2, rel=1e-9)
    assert found.pocket_depth_cut + gap / 2 == pytest.approx(found.ball_diameter / 2, rel=1e-9)
    around = [found.ball_circle_radius * np.exp(2j * np.pi * k / unit.balls) for k in (0, 1)]
    assert found.ball_pitch == pytest.approx(abs(around[0] - around[1]), rel=1e-9)
    assert found.web == pytest.approx(found.ball_pitch - found.pocket_width, abs=1e-12)
    if found.ball_diameter_standard is not None:
        # at the largest travel the contact is still y below the face
        assert touching[0] - (gap + found.travel_max) / 2 == pytest.approx(found.edge_clearance_standard, abs=1e-9)


def test_the_completed_spec_is_the_same_clutch(afmcalc, tmp_path):
    target, own = tmp_path / "completed.toml", tmp_path / "balls.toml"
    assert afmcalc("pocket", S21, "--save", target).code == 0
    assert read_spec(target).control_unit.gain is None
    before, after = (afmcalc("torque", path, "--json").json["result"]["torque"] for path in (S21, target))
    assert after == pytest.approx(before)
    own.write_text('diameters = [30, "60 mm", 200]')
    found = afmcalc("pocket", "--set", f"catalogues.balls={own}", "--json").json["result"]
    assert found["ball_diameter_standard"] == 0.03
