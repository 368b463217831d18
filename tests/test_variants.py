"""The records of the variants: what a spec, an engine and every analysis ask them."""

import pytest
from conftest import CONFIGS

from afmcalc.variants import BREAKAWAY_LIMIT, VARIANTS, Variant


def torque(f: float, gain: float = 0.4, pairs: int = 8) -> float:
    """T = F R (z_1 f + z_2 f)/(1 + C z_2 f) with two bypass pairs."""
    return 2000 * 0.1 * pairs * f / (1 + gain * (pairs - 2) * f)


@pytest.fixture
def spec(monkeypatch, tmp_path):
    """A spec file of a fifth variant, which is this one record."""
    record = Variant(
        name="two-bypass",
        law="direct",
        description="two pairs bypass the control unit, whatever the spec says",
        bypass=lambda pairs, driving: 2,
        needs=("control_unit",),
        gain_limit=BREAKAWAY_LIMIT,
    )
    monkeypatch.setitem(VARIANTS, record.name, record)
    file = tmp_path / "fifth.toml"
    file.write_text(
        'variant = "two-bypass"\nfriction = {min = 0.1, mean = 0.3, max = 0.8}\n'
        "friction_group = {pairs = 8, mean_radius = 0.1}\nclosing_spring = {force = 2000}\n"
        "control_unit = {gain = 0.4}\nadjustment = {margin = 1.25}\n",
        encoding="utf-8",
    )
    return file


def test_a_fifth_variant_is_calculated(spec, afmcalc):
    found = afmcalc("torque", spec, "--json").json["result"]
    assert found["torque"] == pytest.approx({"min": torque(0.1), "mean": torque(0.3), "max": torque(0.8)})
    assert found["reduced_gain"] == pytest.approx(6 * 0.4)
    accuracy = afmcalc("accuracy", spec, "--json").json["result"]
    assert accuracy["accuracy_factor"] == pytest.approx(torque(0.8) / torque(0.1))
    assert accuracy["gain_limit"] == pytest.approx(1 / (2 * 0.8))
    adjusted = afmcalc("adjust", spec, "--json").json["result"]
    assert adjusted["scatter_ratio"] == pytest.approx(1.25 * torque(0.1) / torque(0.3))
    assert adjusted["pairs_threshold"] == pytest.approx((1 / 0.1 - 1.25 / 0.3) / (0.25 * 0.4) + 2)


def test_a_fifth_variant_is_checked_against_its_own_limit(spec, afmcalc):
    assert afmcalc("check", spec).code == 0
    beyond = afmcalc("check", spec, "--set", "C=0.7", "--json").json["findings"]
    (found,) = [each for each in beyond if each["code"] == "gain-above-limit"]
    assert found["limit"] == pytest.approx(0.625)


def test_a_fifth_variant_is_swept_and_solved(spec, afmcalc):
    (swept,) = afmcalc("accuracy", spec, "--sweep", "z", "--json").json["result"]["sweep"]
    assert swept["values"][0] == 3
    assert swept["accuracy_factor"] == pytest.approx(
        [torque(0.8, pairs=z) / torque(0.1, pairs=z) for z in swept["values"]]
    )
    (over_gain,) = afmcalc("accuracy", spec, "--sweep", "C", "--json").json["result"]["sweep"]
    assert over_gain["values"][-1] == pytest.approx(0.625)
    solved = afmcalc("solve", "accuracy_factor=3", "--for", "C", spec, "--json").json["result"]
    assert torque(0.8, solved["value"]) / torque(0.1, solved["value"]) == pytest.approx(3)
    refused = afmcalc("solve", "accuracy_factor=1.1", "--for", "C", spec)
    assert refused.code == 2
    pairs = afmcalc("solve", "accuracy_factor=3", "--for", "z", spec, "--json").json["result"]["value"]
    ends = [torque(0.8, pairs=z) / torque(0.1, pairs=z) for z in (pairs, pairs - 1)]
    assert ends[0] <= 3 < ends[1]


def test_a_fifth_variant_is_compared_and_described(spec, afmcalc, undrawn):
    rows = afmcalc("compare", CONFIGS / "default.toml", "--variants", "--json").json["result"]["clutches"]
    assert {row["variant"] for row in rows} == {"conventional", "differentiated", "all-driving", "two-bypass"}
    own = afmcalc("compare", spec, spec, "--json").json["result"]["clutches"]
    assert own[0]["variant"] == "two-bypass"
    described = afmcalc("schema").json["properties"]["variant"]
    assert described["enum"] == list(VARIANTS)
    assert "did you mean 'two-bypass'?" in afmcalc("torque", spec, "--set", "variant=two-bypas").err
    page = spec.with_suffix(".html")
    assert afmcalc("report", spec, "-o", page).code == 0
    assert ">Accuracy<" in page.read_text(encoding="utf-8")
    # S22 does not know it
    assert "not variant 'two-bypass'" in afmcalc("overload", spec).err


@pytest.mark.parametrize(
    ("change", "path"),
    [
        ("friction_group.pairs=2", "friction_group.pairs"),
        ("friction_group.driving_pairs=3", "friction_group.driving_pairs"),
        ("control_unit.hub_diameter=0.1", "control_unit.hub_diameter"),
        ("control_unit=", "control_unit"),
    ],
)
def test_a_fifth_variant_has_its_own_keys(spec, afmcalc, change, path):
    """Two pairs bypass and one is driven at least; what other variants have is refused, what it needs required."""
    run = afmcalc("torque", spec, "--set", change)
    assert (run.code, f"{path}:" in run.err or f"{path} =" in run.err) == (2, True), run.err
