"""Torques of the groups, forces on balls, key and stop, the load up to slip; clutches side by side; a variant is one record."""

import pytest
from conftest import CONFIGS, S21
from sources import DATA

from afmcalc.analysis.asking import answer
from afmcalc.analysis.compare import compare
from afmcalc.analysis.explain.explain import noting, steps_of
from afmcalc.analysis.torque import FrictionPoint, torque
from afmcalc.engines import build
from afmcalc.equations.terms import DETAILS
from afmcalc.result import shown_as
from afmcalc.spec import read_spec
from afmcalc.variants import VARIANTS, Variant

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


def test_variants_at_equal_force_and_equal_nominal_torque(afmcalc):
    rows = afmcalc("compare", S21, "--variants", "--json").json["result"]["clutches"]
    assert [row["variant"] for row in rows] == ["conventional", "differentiated", "all-driving", "indirect"] * 2
    clutch = build(read_spec(S21))
    assert {row["closing_force"] for row in rows[:4]} == {2000.0}
    assert [row["nominal_torque"] for row in rows[4:]] == pytest.approx([clutch.nominal_torque] * 4)
    assert rows[3]["accuracy_factor"] == pytest.approx(rows[7]["accuracy_factor"])
    # K_т of 1.6 (equal force) and of 1.5999999999999996 (equal torque) must give one finding
    asked = [CONFIGS / "drilling-head-clutch.toml", "--set", "drive.event=", "--variants", "--json"]
    told = [each["message"] for each in afmcalc("compare", *asked).json["findings"]]
    assert len(told) == len({*told}) > 1


@pytest.mark.parametrize(("force", "method"), [(3300.0, "min-friction"), (8000.0, "mean-friction")])
def test_nominal_torque_ratio_with_springs_as_made(force, method):
    """K_п is T_н over that of the all-driving clutch of equal F_п1 and gain, however the control spring is made."""
    setting = f"adjustment.method={method}"
    clutch = build(read_spec(CONFIGS / "indirect.toml", [f"control_spring.force={force}", setting]))
    rows = {(row.variant, row.basis): row.nominal_torque for row in compare([clutch], variants=True)[0].clutches}
    ratio = rows["indirect", "spring force"] / rows["all-driving", "spring force"]
    assert clutch.nominal_torque_ratio == pytest.approx(ratio, rel=1e-12)
    by_s21 = build(read_spec(CONFIGS / "indirect.toml", [setting]))
    assert by_s21.nominal_torque_ratio == pytest.approx(1 + 8 * 1.0 * by_s21.friction_set, rel=1e-12)


def test_what_is_not_possible_is_said(afmcalc):
    run = afmcalc("compare", CONFIGS / "unlike-materials.toml", "--variants", "--json")
    assert [row["variant"] for row in run.json["result"]["clutches"]] == ["differentiated"] * 2
    assert [each["code"] for each in run.json["findings"]].count("variant-not-possible") == 3


@pytest.mark.parametrize("made", [["indirect", "control_spring.force=5500"], ["constant-torque", "name=x"]])
def test_among_its_variants_a_clutch_stands_as_it_is(made, afmcalc):
    """It keeps the control spring and the pockets as made; set by S21 (14) its K_т would be 2.1304, not 2.1868."""
    asked = [f"example:{made[0]}", "--set", made[1], "--json"]
    torque = afmcalc("torque", *asked).json["result"]
    rows = afmcalc("compare", *asked, "--variants").json["result"]["clutches"]
    as_made = [row for row in rows if row["variant"] == "indirect"]
    assert [row["basis"] for row in as_made] == ["spring force", "nominal torque"]
    for row in as_made:
        assert all(row[key] == torque[key] for key in ("closing_force", "torque", "accuracy_factor", "scatter"))


def test_a_row_of_the_terms_makes_a_law_a_detail(monkeypatch):
    """A row of the terms is enough: no result, sweep or explanation must be changed."""
    monkeypatch.setitem(DETAILS, "breakaway_torque", "torque")

    class Point(FrictionPoint):
        pass

    clutch = noting(read_spec("example:default"))
    told = answer(Point, clutch.at(friction=0.3), friction_driving=None, friction_driven=None)
    shown = shown_as(type(told).model_fields["breakaway_torque"])
    assert told.breakaway_torque == clutch.at(friction=0.3)["breakaway_torque"] > 0
    assert (shown.details, shown.unit, shown.symbol) == (True, "N*m", "P")
    assert "breakaway_torque" in {step.name for step in steps_of(clutch)}


SPEC = (DATA / "two-bypass.toml").read_text(encoding="utf-8")


def carried(f: float, gain: float = 0.4, pairs: int = 8) -> float:
    """T = F R (z_1 f + z_2 f)/(1 + C z_2 f) with two bypass pairs."""
    return 2000 * 0.1 * pairs * f / (1 + gain * (pairs - 2) * f)


@pytest.fixture
def told(monkeypatch, afmcalc):
    """Run commands on a clutch of a fifth variant, which is defined by one record."""
    record = Variant("two-bypass", lambda pairs, driving: 2, needs=("control_unit",), gain_limit="breakaway")
    monkeypatch.setitem(VARIANTS, record.name, record)
    return lambda *arguments: afmcalc(*arguments, "-", "--json", stdin=SPEC)


def test_a_fifth_variant_is_calculated(told):
    found = told("torque").json["result"]
    assert found["torque"] == pytest.approx({"min": carried(0.1), "mean": carried(0.3), "max": carried(0.8)})
    assert found["reduced_gain"] == pytest.approx(6 * 0.4)
    accuracy = told("accuracy").json["result"]
    assert accuracy["accuracy_factor"] == pytest.approx(carried(0.8) / carried(0.1))
    assert accuracy["gain_limit"] == pytest.approx(1 / (2 * 0.8))
    adjusted = told("adjust").json["result"]
    assert adjusted["scatter_ratio"] == pytest.approx(1.25 * carried(0.1) / carried(0.3))
    assert adjusted["pairs_threshold"] == pytest.approx((1 / 0.1 - 1.25 / 0.3) / (0.25 * 0.4) + 2)


def test_a_fifth_variant_is_checked_against_its_own_limit(told):
    assert told("check").code == 0
    (found,) = (each for each in told("check", "--set", "C=0.7").json["findings"] if each["code"] == "gain-above-limit")
    assert found["limit"] == pytest.approx(0.625)


def test_a_fifth_variant_has_its_own_keys(told):
    """At least two bypass pairs and one driven pair; keys of other variants are refused, needed keys required."""
    group = ("friction_group.pairs=2", "friction_group.driving_pairs=3")
    for change in (*group, "control_unit.hub_diameter=0.1", "control_unit="):
        path, run = change.partition("=")[0], told("torque", "--set", change)
        assert (run.code, f"{path}:" in run.err or f"{path} =" in run.err) == (2, True), run.err
