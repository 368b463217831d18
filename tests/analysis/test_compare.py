"""Clutches side by side."""

import pytest
from conftest import CONFIGS, S21

from afmcalc.engines import build
from afmcalc.spec import read_spec


def test_specs_side_by_side(afmcalc):
    paths = [CONFIGS / f"{name}.toml" for name in ("default", "indirect", "conventional")]
    rows = afmcalc("compare", *paths, "--json").json["result"]["clutches"]
    for path, row in zip(paths, rows, strict=True):
        torque = afmcalc("torque", path, "--json").json["result"]
        for key in ("closing_force", "nominal_torque", "torque", "scatter", "accuracy_factor", "gain"):
            assert row[key] == torque[key]


def test_what_check_finds_is_counted_but_for_what_is_simulated(afmcalc):
    """A pressure above the allowable, a ball that does not fit, a requirement missed; heat of an event is not asked."""
    weak = ["friction.material=moulded-dry", "friction.min=", "friction.mean=", "friction.max=", "closing_spring.force=60 kN",
            "requirements.accuracy_factor=1.1", "drive.event=", "requirements.temperature="]  # fmt: skip
    sets = [part for each in weak for part in ("--set", each)]
    result = afmcalc("check", CONFIGS / "drive.toml", *sets, "--json").json["result"]
    assert result["errors"] >= 3
    run = afmcalc("compare", CONFIGS / "drive.toml", *sets, "--json").json
    (row,) = run["result"]["clutches"]
    assert (row["errors"], row["warnings"]) == (result["errors"], result["warnings"])
    assert {"peak-pressure-exceeded", "requirement-missed"} <= {each["code"] for each in run["findings"]}
    simulated = afmcalc("compare", CONFIGS / "drive.toml", "--set", "requirements.temperature=22 degC", "--json").json
    assert simulated["result"]["clutches"][0]["errors"] == 0


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


def test_what_is_not_possible_is_said(afmcalc):
    run = afmcalc("compare", CONFIGS / "unlike-materials.toml", "--variants", "--json")
    assert [row["variant"] for row in run.json["result"]["clutches"]] == ["differentiated"] * 2
    notes = [f["message"] for f in run.json["findings"] if f["code"] == "variant-not-possible"]
    assert len(notes) == 3


def test_bad_calls(afmcalc):
    assert afmcalc("compare", CONFIGS / "default.toml", S21, "--variants").code == 2
    assert afmcalc("compare", "none.toml").code == 3


def test_findings_of_every_variant_compared_are_told(afmcalc):
    run = afmcalc("compare", S21, "--variants", "--json").json
    warned = {row["variant"] for row in run["result"]["clutches"] if row["warnings"]}
    told = {f["message"].partition(":")[0] for f in run["findings"] if f["level"] == "warning"}
    assert all(isinstance(row["errors"], int) for row in run["result"]["clutches"])
    assert warned <= told
