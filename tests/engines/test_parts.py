"""Springs that a spec names: held to what the search holds those it finds to, each limit by hand."""

import math

import pytest
from conftest import CONFIGS

from afmcalc.analysis.clutch_findings import clutch_findings
from afmcalc.analysis.spring_search import option_of
from afmcalc.engines import build
from afmcalc.engines.parts import spring_demands
from afmcalc.errors import SpecError
from afmcalc.spec import read_spec

DEFAULT, INDIRECT = CONFIGS / "default.toml", CONFIGS / "indirect.toml"
WIDE = (
    "closing_spring.disc={outer_diameter=0.08, inner_diameter=0.041, thickness=2.25e-3, free_height=5.2e-3, series=2}"
)


def coil(spring="closing_spring", **sizes):
    """One that does, 2 kN at 21.2 mm of 40 mm, unless a size is another."""
    own = {"wire_diameter": 10e-3, "coil_diameter": 60e-3, "turns": 5, "free_length": 110e-3, "count": 1} | sizes
    return f"{spring}.coil={{{', '.join(f'{name}={value}' for name, value in own.items())}}}"


def rate(wire, diameter, turns, count=1):
    return count * 81.5e9 * wire**4 / (8 * diameter**3 * turns)


def found_by(path, *overrides):
    spec = read_spec(path, overrides)
    return {each.code: each for each in clutch_findings(build(spec))}


def test_check_judges_the_stress_of_a_coil(afmcalc):
    """8 F D/(π d³) = 1591 MPa against 0.56 (1980 − 740 lg 4) MPa."""
    part = coil(wire_diameter=4e-3, coil_diameter=20e-3, turns=6, free_length=75e-3)
    run = afmcalc("check", DEFAULT, "--set", part, "--json")
    stress, limit = 8 * 2000 * 0.02 / (math.pi * 0.004**3), 0.56 * (1980 - 740 * math.log10(4)) * 1e6
    rows = {row["symbol"]: row for row in run.json["result"]["checks"] if row["name"].startswith("closing spring")}
    assert (run.code, rows["τ_2 ≤ [τ]"]["passed"]) == (1, False)
    assert rows["τ_2 ≤ [τ]"]["utilisation"] == pytest.approx(stress / limit)
    solid = stress * rate(4e-3, 20e-3, 6) * (75e-3 - 8 * 4e-3) / 2000
    assert (rows["τ_c ≤ [τ]"]["value"], rows["τ_c ≤ [τ]"]["level"]) == (pytest.approx(solid), "warning")
    levels = {each["code"]: each["level"] for each in run.json["findings"]}
    assert (levels["coil-overstressed"], levels["coil-stress-solid"]) == ("error", "warning")
    assert afmcalc("check", DEFAULT, "--set", coil()).code == 0


PRESSED = 2000 / rate(0.01, 0.06, 5)
TOLD = [
    ([coil(coil_diameter=36e-3)], "coil-index", "warning", 3.6, 4),
    ([coil(coil_diameter=210e-3, turns=2, free_length=0.9)], "coil-index", "warning", 21, 20),
    ([coil(free_length=94e-3)], "coil-gaps-closed", "warning", PRESSED, 24e-3 - 7.7e-3),
    ([coil(), "heat.lining=3e-3"], "spring-slack", "error", 24e-3, PRESSED),
    ([coil(), "closing_spring.room.outer_diameter=0.069"], "spring-does-not-fit", "error", 0.07, 0.069),
    ([coil(), "closing_spring.room.inner_diameter=0.051"], "spring-does-not-fit", "error", 0.05, 0.051),
    ([coil(), "closing_spring.room.length=0.08"], "spring-does-not-fit", "error", 0.11 - PRESSED, 0.08),
    ([coil(wire_diameter=25e-3, coil_diameter=0.2, free_length=0.4)], "wire-not-judged", "warning", 25e-3, None),
    ([WIDE, "closing_spring.stiffness=2e6"], "stiffness-of-the-discs", "warning", 2e6, None),
]


@pytest.mark.parametrize(("overrides", "code", "level", "value", "limit"), TOLD)
def test_what_a_part_does_not_hold_is_told(overrides, code, level, value, limit):
    own = found_by(DEFAULT, "closing_spring.force=2000", *overrides)[code]
    assert (own.level, own.value) == (level, pytest.approx(value))
    assert limit is None or own.limit == pytest.approx(limit)
    assert own.path.startswith("closing_spring")


def test_coils_side_by_side_do_not_touch():
    """Eight on a circle of 100 mm: 100 sin(π/8) = 38.27 mm apart, in a ring 40 mm wide."""
    rooms = ["closing_spring.room.inner_diameter=0.06", "closing_spring.room.outer_diameter=0.14"]
    small = {"wire_diameter": 4e-3, "count": 8, "turns": 4, "free_length": 60e-3}
    wide = found_by(DEFAULT, *rooms, coil(**small, coil_diameter=35e-3))["spring-does-not-fit"]
    assert (wide.value, wide.limit) == (pytest.approx(39e-3), pytest.approx(0.1 * math.sin(math.pi / 8)))
    assert "spring-does-not-fit" not in found_by(DEFAULT, *rooms, coil(**small, coil_diameter=34e-3))


def test_a_coil_that_the_sleeve_presses_solid():
    """The control spring is free to within half the sleeve's travel."""
    stiffness = rate(14e-3, 70e-3, 4)
    given = f"control_spring.stiffness={stiffness}"
    plain = build(read_spec(INDIRECT, [given]))
    set_at, travel = plain.control_force / stiffness, plain.at(friction=0.8)["travel"]
    free = 6 * 14e-3 + set_at + travel / 2
    sizes = {"wire_diameter": 14e-3, "coil_diameter": 70e-3, "turns": 4, "free_length": free}
    told = found_by(INDIRECT, given, coil("control_spring", **sizes))["coil-solid"]
    assert told.level == "error"
    assert (told.value, told.limit) == (pytest.approx(set_at + travel), pytest.approx(set_at + travel / 2))
    short = coil("control_spring", **sizes | {"free_length": 85e-3})
    with pytest.raises(SpecError, match="must be greater than 0.0917"):
        read_spec(INDIRECT, [given, short])


def test_a_slender_coil_buckles_unless_guided():
    """Against the load at which a bar of the coil's bending and shear stiffness buckles between plates (Haringx)."""
    wire, diameter, turns, free, young, shear = 6e-3, 40e-3, 20, 400e-3, 206e9, 81.5e9

    def excess(share):
        left = free * (1 - share)
        bending = left * 2 * young * shear * wire**4 / (32 * turns * diameter * (2 * shear + young))
        sheared = left * young * wire**4 / (8 * diameter**3 * turns)
        load = rate(wire, diameter, turns) * share * free
        return load * (1 + load / sheared) - math.pi**2 * bending / (0.5 * left) ** 2

    low, high = 0.0, 0.5
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if excess(middle) < 0 else (low, middle)
    part = coil(wire_diameter=wire, coil_diameter=diameter, turns=turns, free_length=free)
    force = f"closing_spring.force={1.02 * low * free * rate(wire, diameter, turns)}"
    told = found_by(DEFAULT, part, force)["coil-buckles"]
    assert (told.value, told.limit) == (pytest.approx(1.02 * low * free), pytest.approx(low * free))
    for guide in ("inner_diameter=0.029", "outer_diameter=0.051"):
        assert "coil-buckles" not in found_by(DEFAULT, part, force, f"closing_spring.room.{guide}")
    for loose in ("inner_diameter=0.027", "outer_diameter=0.053"):
        assert "coil-buckles" in found_by(DEFAULT, part, force, f"closing_spring.room.{loose}")


@pytest.mark.parametrize(
    ("cycles", "loading", "level"), [(None, "dynamic", "warning"), (1e7, "dynamic", "error"), (1e4, "static", None)]
)
def test_a_coil_that_moves_at_every_trip(cycles, loading, level):
    """Its curvature counts; to 10⁴ strokes it is as one that rests (EN 13906-1)."""
    part = {"wire_diameter": 8e-3, "coil_diameter": 36e-3, "turns": 5.5, "free_length": 100e-3}
    overrides = [coil("closing_spring", **part), f"closing_spring.stiffness={rate(8e-3, 36e-3, 5.5)}"]
    overrides += ["control_spring.stiffness=50e3", "closing_spring.force=4500"]
    overrides += [] if cycles is None else [f"requirements.cycles={cycles}"]
    clutch = build(read_spec(INDIRECT, overrides))
    own = option_of(spring_demands(clutch)[0], clutch.spec.spring_parts["closing"])
    index = 36 / 8
    factor = 1 + 1.25 / (index - 0.75) if loading == "dynamic" else 1
    assert (own.loading, own.stress_correction) == (loading, pytest.approx(factor))
    upper = 8 * 4500 * 36e-3 / (math.pi * 8e-3**3)
    assert own.stress == pytest.approx(factor * upper)
    lower = upper * (1 - clutch.at(friction=0.8)["travel"] * rate(8e-3, 36e-3, 5.5) / 4500)
    ultimate = 0.67 * (1980 - 740 * math.log10(8))
    alternating = factor * (upper - lower) / 2e6 / (241 / (1 - 379 / ultimate))
    assert alternating + factor * (upper + lower) / 2e6 / ultimate > 1 or level is None
    assert {each.code: each.level for each in clutch_findings(clutch)}.get("coil-fatigue") == level


def test_a_stiffness_beside_a_coil_is_the_coil_s(afmcalc):
    """94.33 N/mm; eight linings worn by 0.1 mm take 75.46 N of 2 kN."""
    refused = afmcalc("torque", DEFAULT, "--set", coil(), "--set", "closing_spring.stiffness=2e6")
    assert (refused.code, "closing_spring.stiffness" in refused.err) == (2, True)
    assert rate(0.01, 0.06, 5) == pytest.approx(94329, abs=1)
    for given in ([], ["--set", "closing_spring.stiffness=94.3 N/mm"]):
        worn = afmcalc("effects", DEFAULT, "--set", coil(), *given, "--set", "heat.lining=1e-4", "--json").json
        (effect,) = (each for each in worn["result"]["effects"] if each["effect"] == "wear")
        lost = effect["torque_low"]["min"] / effect["torque_high"]["min"]
        assert lost == pytest.approx(1 - 8e-4 * rate(0.01, 0.06, 5) / 2000, rel=1e-4)
