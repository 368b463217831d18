"""Surface pressure against the allowable of the material."""

import math

import pytest

RING = ("friction_group.mean_radius=", "friction_group.inner_radius=80 mm", "friction_group.outer_radius=120 mm")
RADII = [part for change in RING for part in ("--set", change)]
CORKS = ("friction.min=", "friction.mean=", "friction.max=", "friction.material=cork-dry")
CORK = [part for change in CORKS for part in ("--set", change)]
LOWER = 55e3
"""Pa, what cork bears at least; 95 kPa at most."""


def findings(run):
    return {finding["code"]: finding for finding in run.json["findings"]}


@pytest.mark.parametrize(
    ("force", "mean", "peak", "code"),
    [(1000, "mean-pressure", "peak-pressure", 0), (1500, "mean-pressure-in-range", "peak-pressure-in-range", 0), (3000, "mean-pressure-exceeded", "peak-pressure-exceeded", 1)],
)  # fmt: skip
def test_pressure(force, mean, peak, code, afmcalc):
    run = afmcalc("check", *RADII, *CORK, "--set", f"F={force}", "--json")
    assert run.code == code
    found = findings(run)
    assert found[mean]["value"] == pytest.approx(force / (math.pi * (0.12**2 - 0.08**2)))
    assert found[peak]["value"] == pytest.approx(force / (2 * math.pi * 0.08 * 0.04))
    assert found[mean]["path"] == "friction.material"
    pressed = findings(
        afmcalc("check", *RADII, *CORK, "--set", "friction_group.radius_model=uniform-pressure", "--json")
    )
    assert not any(code.startswith("peak") for code in pressed)


def test_one_limit_on_both_sides_of_the_allowable_range(afmcalc):
    """The utilisation grows with the load, and row, finding and sentence agree."""
    before = 0.0
    for force, grade in ((1000, "pass"), (1500, "warning"), (2380, "warning"), (2400, "fail"), (3000, "fail")):
        run = afmcalc("check", *RADII, *CORK, "--set", f"F={force}", "--json")
        row = next(row for row in run.json["result"]["limits"] if row["name"] == "surface pressure in the mean")
        said = next(each for code, each in findings(run).items() if code.startswith("mean-pressure"))
        assert row["verdict"] == grade
        assert said["limit"] == row["limit"] == LOWER
        assert row["utilisation"] == pytest.approx(row["value"] / LOWER)
        assert f"utilisation {row['utilisation']:.3g}" in said["message"]
        assert row["utilisation"] > before
        before = row["utilisation"]


def test_no_pressure_without_radii_or_material(afmcalc):
    for arguments in (RADII, CORK):
        assert not any("pressure" in code for code in findings(afmcalc("check", *arguments, "--json")))
