"""Sweeps: each point is a single calculation; ranges without being given."""

import numpy as np
import pytest

from afmcalc import load
from afmcalc.engines.evaluate import evaluate
from afmcalc.spec import read_spec


def test_sweep_is_the_single_calculations(afmcalc):
    sweep = afmcalc("accuracy", "--sweep", "z=4,8,16", "--sweep", "C=0.2:1:3", "--json").json["result"]["sweep"]
    assert [entry["parameter"] for entry in sweep] == ["z", "C"]
    assert [entry["path"] for entry in sweep] == ["friction_group.pairs", "control_unit.gain"]
    assert len(sweep[0]["values"]) == 9
    for index, (z, c) in enumerate(zip(sweep[0]["values"], sweep[1]["values"], strict=True)):
        single = ["--set", f"z={z:g}", "--set", f"C={c!r}", "--json"]
        torque, accuracy = (afmcalc(command, *single).json["result"] for command in ("torque", "accuracy"))
        assert sweep[0]["accuracy_factor"][index] == accuracy["accuracy_factor"]
        assert sweep[1]["nominal_torque"][index] == torque["nominal_torque"]
        assert sweep[1]["torque_max"][index] == torque["torque"]["max"]


def test_any_quantity_is_a_column(afmcalc):
    """In JSON, table and CSV; one that is none, or no number, is refused."""
    asked = ["accuracy", "example:indirect", "--sweep", "R=0.08,0.1", "--columns", "travel_max,normal_force_at_f_max"]
    (entry,) = afmcalc(*asked, "--json").json["result"]["sweep"]
    for index, radius in enumerate((0.08, 0.1)):
        clutch = load("example:indirect", {"R": radius})
        own = clutch["travel_max"], clutch.at("f_max").normal_force
        assert (entry["travel_max"][index], entry["normal_force_at_f_max"][index]) == own
    assert "N(f_max)" in afmcalc(*asked).out
    assert "travel_max [m],normal_force_at_f_max [N]" in afmcalc(*asked, "--format", "csv").out
    for wrong, says in (("travle_max", "did you mean 'travel_max'"), ("torque", "f_max"), ("is_locked", "--columns")):
        run = afmcalc("accuracy", "example:indirect", "--sweep", "R", "--columns", wrong)
        assert (run.code, says in run.err) == (2, True), run.err
    assert "--sweep" in afmcalc("accuracy", "--columns", "gain").err


NAMES = ["C", "z", "z1", "R", "F", "f_min", "f_max", "beta", "friction.mean", "drive.dynamic_factor", "alpha=0:0.5:5"]


@pytest.mark.parametrize("name", NAMES)
def test_every_sweep_has_a_sensible_range(name, afmcalc):
    (entry,) = afmcalc("accuracy", "--sweep", name, "--json").json["result"]["sweep"]
    assert len(entry["values"]) == len(entry["accuracy_factor"]) >= 3
    assert min(entry["accuracy_factor"]) >= 1


def test_a_sweep_of_a_stiffness_beside_disc_springs(afmcalc):
    """A straight control spring against a closing spring of discs, behind curved walls."""
    disc = "closing_spring.disc={outer_diameter=0.1,inner_diameter=0.051,thickness=0.005,free_height=0.00775,series=8}"
    walls = ["--set", "control_unit.pocket=", "--set", "gain_slope=200"]
    asked = ["accuracy", "example:constant-torque", "--set", disc, *walls, "--json"]
    sweep = afmcalc(*asked, "--sweep", "c2=2e5,3e5").json["result"]["sweep"][0]
    single = [afmcalc(*asked, "--set", f"c2={value}").json["result"]["accuracy_factor"] for value in (2e5, 3e5)]
    assert sweep["accuracy_factor"] == pytest.approx(single, rel=1e-12)


def test_a_sweep_from_no_gain_on(afmcalc):
    """At κ = 0 nothing moves the sleeve, and nothing holds it back."""
    asked = "accuracy", "example:constant-torque", "--set", "key_friction=0", "--set", "control_spring.force=6000"
    (entry,) = afmcalc(*asked, "--sweep", "C=0,0.5", "--json").json["result"]["sweep"]
    assert entry["accuracy_factor_hysteresis"][0] == pytest.approx(entry["accuracy_factor"][0])


BAD = ["", "x", "n", "variant", "C=", "C=1:2", "C=1:2:1", "C=1:2:x", "C=a,b", "C=-1:1:5", "z=1.5,2", "f_min=0.5:0.9:5",
       "F=1 J,2 J", "C=nan", "z=1,0", "z1=1:9:9", "C=0:1:99999999999", "friction.driving.min"]  # fmt: skip


@pytest.mark.parametrize("sweep", BAD)
def test_bad_sweeps(sweep, afmcalc, tmp_path):
    run = afmcalc("accuracy", "--sweep", sweep, "-o", tmp_path / "x")
    assert run.code == 2, run.out
    assert run.err.strip().splitlines()[-1].startswith("error: ")
    assert not (tmp_path / "x").exists()


def test_a_long_sweep_is_calculated_in_stretches_that_join():
    """More points than one stretch takes, against the formula F11 (14) over all of them."""
    gain = np.linspace(0, 1.25, 96_001)
    found = evaluate(read_spec(), {"control_unit.gain": gain}, {"factor": lambda clutch: clutch.accuracy_factor})
    np.testing.assert_allclose(found["factor"], 8 * (1 + 0.7 * gain) / (1 + 5.6 * gain), rtol=1e-14)


def test_what_is_swept_heads_its_column(afmcalc):
    """The reduced gain is no key of the spec: its values are not told as gains."""
    run = afmcalc("accuracy", "example:all-driving", "--sweep", "zC=1:2:2", "--format", "csv")
    head, first, _ = run.out.splitlines()
    assert head.startswith("reduced_gain [1],accuracy_factor [1]")
    low, high = (getattr(read_spec("example:all-driving").friction.range, end) for end in ("min", "max"))
    told = [float(each) for each in first.split(",")[:2]]
    assert told == pytest.approx([1.0, high * (1 + low) / (low * (1 + high))])
