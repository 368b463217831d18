"""Clutches side by side."""

import pytest
from conftest import CONFIGS, S21

from afmcalc.analysis.compare import compare_variants
from afmcalc.engines import build
from afmcalc.spec import read_spec


def test_specs_side_by_side(afmcalc):
    paths = [CONFIGS / f"{name}.toml" for name in ("default", "indirect", "conventional")]
    rows = afmcalc("compare", *paths, "--json").json["result"]["clutches"]
    for path, row in zip(paths, rows, strict=True):
        torque = afmcalc("torque", path, "--json").json["result"]
        for key in ("closing_force", "nominal_torque", "torque", "scatter", "accuracy_factor", "gain"):
            assert row[key] == torque[key]


def test_what_check_finds_is_counted(afmcalc):
    """A pressure above the allowable, a ball that does not fit, a requirement missed."""
    weak = ["friction_group.mean_radius=", "friction_group.inner_radius=80 mm", "friction_group.outer_radius=120 mm",
            "friction.material=moulded-dry", "friction.min=", "friction.mean=", "friction.max=",
            "closing_spring.force=60 kN", "requirements.accuracy_factor=1.1"]  # fmt: skip
    sets = [part for each in weak for part in ("--set", each)]
    result = afmcalc("check", *sets, "--json").json["result"]
    assert result["errors"] >= 3
    run = afmcalc("compare", CONFIGS / "default.toml", *sets, "--json").json
    (row,) = run["result"]["clutches"]
    assert (row["errors"], row["warnings"]) == (result["errors"], result["warnings"])
    assert {"peak-pressure-exceeded", "requirement-missed"} <= {each["code"] for each in run["findings"]}


@pytest.mark.slow
def test_what_is_simulated_is_not_counted(afmcalc):
    """Heat of an event is not asked: the requirement that it misses is no error here."""
    missed = "requirements.temperature=20.5 degC"
    run = afmcalc("compare", CONFIGS / "drive.toml", "--set", missed, "--json").json
    assert run["result"]["clutches"][0]["errors"] == 0


def test_variants_at_equal_force_and_equal_nominal_torque(afmcalc):
    rows = afmcalc("compare", S21, "--variants", "--json").json["result"]["clutches"]
    assert [row["variant"] for row in rows] == ["conventional", "differentiated", "all-driving", "indirect"] * 2
    clutch = build(read_spec(S21))
    assert {row["closing_force"] for row in rows[:4]} == {2000.0}
    assert [row["nominal_torque"] for row in rows[4:]] == pytest.approx([clutch.nominal_torque] * 4)
    assert rows[3]["accuracy_factor"] == pytest.approx(rows[7]["accuracy_factor"])
    # K_п: the indirect clutch's nominal torque against the all-driving one of equal spring force
    assert rows[3]["nominal_torque"] / rows[2]["nominal_torque"] == pytest.approx(clutch.nominal_torque_ratio)
    assert rows[2]["accuracy_factor"] == pytest.approx(1.946, abs=5e-4)


@pytest.mark.parametrize("method", ["min-friction", "mean-friction"])
@pytest.mark.parametrize("force", [2000.0, 3300.0, 5500.0, 8000.0])
def test_nominal_torque_ratio_with_springs_as_made(force, method):
    """K_п is T_н over that of the all-driving clutch of equal F_п1 and gain, however the control spring is made."""
    clutch = build(
        read_spec(CONFIGS / "indirect.toml", [f"control_spring.force={force}", f"adjustment.method={method}"])
    )
    rows = {(row.variant, row.basis): row.nominal_torque for row in compare_variants(clutch)[0].clutches}
    ratio = rows["indirect", "spring force"] / rows["all-driving", "spring force"]
    assert clutch.nominal_torque_ratio == pytest.approx(ratio, rel=1e-12)
    by_s21 = build(read_spec(CONFIGS / "indirect.toml", [f"adjustment.method={method}"]))
    assert by_s21.nominal_torque_ratio == pytest.approx(1 + 8 * 1.0 * by_s21.friction_set, rel=1e-12)


def test_what_is_not_possible_is_said(afmcalc):
    run = afmcalc("compare", CONFIGS / "unlike-materials.toml", "--variants", "--json")
    assert [row["variant"] for row in run.json["result"]["clutches"]] == ["differentiated"] * 2
    notes = [f["message"] for f in run.json["findings"] if f["code"] == "variant-not-possible"]
    assert len(notes) == 3


@pytest.mark.parametrize(
    ("example", "change"), [("indirect", "control_spring.force=5500"), ("constant-torque", "name=x")]
)
def test_among_its_variants_a_clutch_stands_as_it_is(example, change, afmcalc):
    """The control spring and the pockets as made: with both springs set by S21 (14) K_т were 2.1304, not 2.1868."""
    spec = f"example:{example}"
    torque = afmcalc("torque", spec, "--set", change, "--json").json["result"]
    rows = afmcalc("compare", spec, "--variants", "--set", change, "--json").json["result"]["clutches"]
    as_made = [row for row in rows if row["variant"] == "indirect"]
    assert [row["basis"] for row in as_made] == ["spring force", "nominal torque"]
    for row in as_made:
        assert {
            key: row[key] for key in ("closing_force", "torque", "accuracy_factor", "scatter")
        }.items() <= torque.items()
