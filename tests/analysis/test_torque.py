"""Torques of the groups, forces on balls, key and stop, the load up to slip: balances and the papers' formulas."""

import math

import pytest

from afmcalc.analysis.adjust import adjust
from afmcalc.analysis.overload import overload
from afmcalc.analysis.torque import torque
from afmcalc.engines import build
from afmcalc.errors import CalculationError
from afmcalc.spec import read_spec

NAMES = ("default", "unlike-materials", "all-driving", "indirect", "constant-torque", "conventional")
ENDS = ("min", "mean", "max")


def example(name, *overrides):
    return build(read_spec(f"example:{name}", overrides))


@pytest.mark.parametrize("name", NAMES)
def test_the_groups_make_the_torque(name):
    """F11 (1), (5), (10): T = T_1 + T_2, T_2 = F_o r, F_o tan α = F_p."""
    clutch = example(name)
    result = torque(clutch)[0]
    unit = clutch.spec.control_unit
    for end in ENDS:
        groups = [getattr(part, end) for part in (result.driving_torque, result.driven_torque) if part]
        assert sum(groups) == pytest.approx(getattr(result.torque, end), rel=1e-12)
        if unit is not None and unit.ball_circle_radius and not (result.travel and result.gain_slope):
            around = getattr(result.circumferential_force, end)
            assert around * unit.ball_circle_radius == pytest.approx(getattr(result.driven_torque, end), rel=1e-12)
            tangent = result.gain * unit.ball_circle_radius / clutch.mean_radius
            assert around * tangent == pytest.approx(getattr(result.release_force, end), rel=1e-12)


def test_first_torque_of_the_bypass_pairs():
    """F11: z_1 f_1 R F_п = 1 · f · 0.1 m · 2 kN; only where bypass pairs stand before controlled ones."""
    assert torque(example("default"))[0].onset_torque.to_dict() == pytest.approx({"min": 20, "mean": 60, "max": 160})
    for name in ("all-driving", "indirect", "conventional"):
        assert torque(example(name))[0].onset_torque is None


@pytest.mark.parametrize("friction", [0.1, 0.3, 0.8])
def test_forces_on_the_sleeve_are_in_balance(friction):
    """S21 (6): closing spring, balls, key, stop and control spring."""
    clutch = example("indirect")
    (point,) = torque(clutch, [(friction, None)])[0].points
    pushed = clutch.closing_force - clutch.closing_stiffness * point.travel + point.release_force
    held = clutch.control_force + clutch.control_stiffness * point.travel
    assert pushed + point.stop_reaction - held - point.key_friction_force == pytest.approx(0, abs=1e-9 * held)
    assert point.stop_reaction >= 0 == point.stop_reaction * point.travel
    assert point.key_friction_force == pytest.approx(2 * point.torque * 0.01 / 0.05)


def test_the_load_rises_until_slip():
    """S22 (6), (9) by hand: z 8, z_1 1, C 0.5, R 0.1 m, F_п 2 kN, f_min 0.1, β_н 1.25, at f = 0.3."""
    result = overload(example("default"), friction=[(0.3, None)])[0]
    (point,) = result.points
    machine = 8 * 2000 * 0.1 * 0.1 / 1.35 / 1.25
    potential = 8 * 0.3 * 0.1 * (2000 - machine * 7 / 8 * 0.5 / 0.1)  # the release force of T_н.маш, shared 1 : 7
    assert (point.potential_torque, point.expected_torque) == pytest.approx((potential, 480 / 2.05))
    assert [load.load for load in result.loads][::4] == pytest.approx([machine, 480 / 2.05])
    for load in result.loads:
        assert load.potential_torque == pytest.approx(8 * 0.3 * 0.1 * (2000 - load.load * 7 / 8 * 0.5 / 0.1))
    assert result.loads[-1].potential_torque == pytest.approx(result.loads[-1].load)


def test_friction_asked_for_of_overload():
    result, found = overload(example("all-driving"), friction=[(0.01, None)])
    assert "friction-outside-range" in {each.code for each in found}
    assert len(result.loads) == 1  # the pack slips under the load of the machine already
    with pytest.raises(CalculationError, match="unlike"):
        overload(example("all-driving"), friction=[(0.1, 0.2)])
    assert overload(example("all-driving"))[0].loads is None


def test_middle_of_the_band():
    """S19, conclusions: at equal T_н the middle is lower where the band is narrower."""
    for beta in (1.05, 1.5):
        result = adjust(example("default", f"adjustment.margin={beta}", "friction_group.pairs=20"))[0]
        first, second = result.min_friction, result.mean_friction
        assert first.mid_torque == pytest.approx(math.fsum((first.torque.min, first.torque.max)) / 2)
        assert second.mid_torque / first.mid_torque == pytest.approx(result.scatter_ratio)
