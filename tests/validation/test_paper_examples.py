"""The clutches of the papers' figures that ship: what the papers print for them, or the misprint that is met."""

import pytest

from afmcalc.analysis.adjust import adjust
from afmcalc.analysis.life import life
from afmcalc.analysis.overload import overload
from afmcalc.engines import build
from afmcalc.spec import read_spec


def clutch(example, **changes):
    overrides = [f"{key.replace('__', '.')}={value!r}" for key, value in changes.items()]
    return build(read_spec(f"example:{example}", overrides))


def test_s21_fig_2():
    """P5–P7: curves 1 and 3 at C = 1, 2, 4; K_п of curve 4; the base clutch of curve 5 is more accurate."""

    def factor(**changes):
        return clutch("shishkarev2021", **changes).accuracy_factor

    assert factor() == pytest.approx(3.586, abs=5e-4)
    assert factor() / factor(closing_spring__stiffness=40e3) == pytest.approx(1.088, abs=5e-4)
    assert factor() / factor(control_unit__gain=2.0) == pytest.approx(1.790, abs=5e-4)
    assert factor(control_unit__gain=2.0) / factor(control_unit__gain=4.0) == pytest.approx(1.381, abs=5e-4)
    base = (0.8 / 0.1) * (1 + 8 * 0.1) / (1 + 8 * 0.8)
    assert base == pytest.approx(1.946, abs=5e-4)
    assert base < factor()


def test_s21_fig_2_sets_a_torque_that_the_gain_does_not_change():
    """(4): T_н = z F_п1 R f_min = 8·400·0.1·0.1, whatever C; (14): F_п2 = F_п1 (1 + zCf_min − 2zRf_min f_1/d) at C = 1."""
    given = clutch("shishkarev2021")
    assert [clutch("shishkarev2021", control_unit__gain=gain).torque(0.1) for gain in (1.0, 3.0)] == pytest.approx(
        [32.0] * 2
    )
    assert given.control_force == pytest.approx(400 * (1 + 0.8 - 2 * 8 * 0.1 * 0.1 * 0.15 / 0.05))


def test_s22_fig_3():
    """At zC = 1.6 the two accuracies are not equal, as printed, but 1.225 apart: the optimum is 1.25 (M13). P9: 3 at 5."""
    printed, _ = overload(clutch("shishkarev2022-fig3"))
    assert printed.accuracy_factor_actual / printed.accuracy_factor_expected == pytest.approx(1.225, abs=5e-4)
    assert printed.optimal_reduced_gain == pytest.approx(1.25)
    best, _ = overload(clutch("shishkarev2022-fig3", control_unit__gain=1.25 / 4))
    assert best.accuracy_factor_actual == pytest.approx(best.accuracy_factor_expected) == pytest.approx(4.5)
    last, _ = overload(clutch("shishkarev2022-fig3", control_unit__gain=5 / 4))
    assert last.accuracy_factor_actual / last.accuracy_factor_expected == pytest.approx(3.0)
    assert last.accuracy_factor_expected == pytest.approx(overload(clutch("all-driving"))[0].accuracy_factor_expected)


def test_s22_fig_4():
    """M14: A = 1.225, 1.000, 0.419 for z_1 = 1, 2, 3 with the gains stated under the figure, not growing."""
    gains = {1: 1.6 / 3, 2: 1 / (2 * 0.8), 3: 1 / (3 * 0.8)}
    of = {
        z1: clutch("shishkarev2022-fig4", friction_group__driving_pairs=z1, control_unit__gain=c)
        for z1, c in gains.items()
    }
    found = [overload(each)[0].actuation_factor.max for each in of.values()]
    assert found == pytest.approx([1.225, 1.0, 0.419], abs=5e-4)
    as_it_ships, _ = overload(clutch("shishkarev2022-fig4"))
    assert as_it_ships.actuation_factor.max == pytest.approx(found[0], rel=1e-9)


def test_f11_fig_2_falls_as_printed_and_rises_as_meant():
    """M4: with z_1 = 2 K_т falls from n = 1.2 to 1.5, and C is above its limit; with z_1 = 1 it rises, up to line 5 at 1.5."""

    def factor(z1, n):
        changes = {
            "friction_group__pairs": z1 + 6,
            "friction_group__driving_pairs": z1,
            "friction__driven__max": n * 0.6,
        }
        return clutch("fokin2011-fig2", **changes).accuracy_factor

    given = clutch("fokin2011-fig2")
    assert given.accuracy_factor == pytest.approx(6 * 11 * (1 + 7.5 * 0.1033) / ((2 + 6.198) * (1 + 7.5 * 0.9)))
    assert factor(2, 1.5) == pytest.approx(given.accuracy_factor, rel=1e-12)
    assert factor(2, 1.5) < factor(2, 1.2)
    assert factor(1, 1.5) > factor(1, 1.2)
    assert factor(1, 1.5) == pytest.approx(1.909, abs=1e-3)


def test_f11_fig_2_as_printed_exceeds_the_limit_of_its_gain(afmcalc):
    run = afmcalc("check", "example:fokin2011-fig2", "--strict", "--json")
    assert run.code == 1
    (warning,) = [each for each in run.json["findings"] if each["level"] == "warning"]
    assert (warning["code"], warning["limit"]) == ("gain-above-limit", pytest.approx(1 / (2 * 0.6)))


def test_s19_fig_2_adjustment():
    """P1: z > 8.197, printed 9.23, which is C = 1.4 (M7). P4, P17: ratio of the bands 1.063…1.137, printed 1.254…1.112."""
    found, _ = adjust(clutch("shishkarev2019-fig2"))
    assert found.pairs_threshold == pytest.approx(8.197, abs=5e-4)
    assert found.nominal_torque == pytest.approx(200)
    assert adjust(clutch("shishkarev2019-fig2", control_unit__gain=1.4))[0].pairs_threshold == pytest.approx(
        9.225, abs=5e-4
    )
    assert found.min_friction.torque.min == pytest.approx(200)
    factor = (0.625 / 0.15) * (1 + 11 * 1.6 * 0.15) / (1 + 11 * 1.6 * 0.625)
    assert found.min_friction.scatter == pytest.approx(200 * (factor - 1))
    ratios = [adjust(clutch("shishkarev2019-fig2", friction_group__pairs=z))[0].scatter_ratio for z in (12, 15, 19, 22)]
    assert ratios == pytest.approx([1.063, 1.094, 1.122, 1.137], abs=5e-4)


def test_s19_fig_2_life():
    """P2: N falls (1500/900)⁶ = 21.43 times (printed 21.54) from ΔT 500 to 1100 N·m; without feedback ΔT = T_н (f_max/f_min − 1)."""
    lives = []
    for scatter in (500, 1100):
        ordinary = {"control_unit__gain": 0.0, "friction__max": 0.15 * (200 + scatter) / 200}
        lives.append(life(clutch("shishkarev2019-fig2", **ordinary), "mean-stress")[0].protected.min_friction)
    assert lives[0] == pytest.approx(1e7 * (2 * 400e6 * 15e-6 / 900) ** 6)
    assert lives[0] / lives[1] == pytest.approx(21.43, abs=5e-3)
    assert lives[0] / lives[1] == pytest.approx(21.54, rel=6e-3)
