"""The records of the variants: what a spec, an engine and every analysis ask them."""

import pytest
from sources import DATA

from afmcalc.variants import VARIANTS, Variant

SPEC = (DATA / "two-bypass.toml").read_text(encoding="utf-8")


def torque(f: float, gain: float = 0.4, pairs: int = 8) -> float:
    """T = F R (z_1 f + z_2 f)/(1 + C z_2 f) with two bypass pairs."""
    return 2000 * 0.1 * pairs * f / (1 + gain * (pairs - 2) * f)


@pytest.fixture
def told(monkeypatch, afmcalc):
    """Ask about a clutch of a fifth variant, which is this one record."""
    record = Variant("two-bypass", lambda pairs, driving: 2, needs=("control_unit",), gain_limit="breakaway")
    monkeypatch.setitem(VARIANTS, record.name, record)
    return lambda *arguments: afmcalc(*arguments, "-", "--json", stdin=SPEC)


def test_a_fifth_variant_is_calculated(told):
    found = told("torque").json["result"]
    assert found["torque"] == pytest.approx({"min": torque(0.1), "mean": torque(0.3), "max": torque(0.8)})
    assert found["reduced_gain"] == pytest.approx(6 * 0.4)
    accuracy = told("accuracy").json["result"]
    assert accuracy["accuracy_factor"] == pytest.approx(torque(0.8) / torque(0.1))
    assert accuracy["gain_limit"] == pytest.approx(1 / (2 * 0.8))
    adjusted = told("adjust").json["result"]
    assert adjusted["scatter_ratio"] == pytest.approx(1.25 * torque(0.1) / torque(0.3))
    assert adjusted["pairs_threshold"] == pytest.approx((1 / 0.1 - 1.25 / 0.3) / (0.25 * 0.4) + 2)


def test_a_fifth_variant_is_checked_against_its_own_limit(told):
    assert told("check").code == 0
    (found,) = (each for each in told("check", "--set", "C=0.7").json["findings"] if each["code"] == "gain-above-limit")
    assert found["limit"] == pytest.approx(0.625)


def test_a_fifth_variant_has_its_own_keys(told):
    """Two pairs bypass and one is driven at least; what other variants have is refused, what it needs required."""
    group = ("friction_group.pairs=2", "friction_group.driving_pairs=3")
    for change in (*group, "control_unit.hub_diameter=0.1", "control_unit="):
        path, run = change.partition("=")[0], told("torque", "--set", change)
        assert (run.code, f"{path}:" in run.err or f"{path} =" in run.err) == (2, True), run.err
