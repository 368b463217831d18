"""Parts as springs: the standard's printed forces, examples of others, a curved spring followed; each limit of a part by hand."""

import math

import pytest
from conftest import CONFIGS, codes
from hypothesis import given
from hypothesis import strategies as st
from sources import table

from afmcalc.analysis.clutch_findings import clutch_findings
from afmcalc.analysis.spring_search import option_of
from afmcalc.engines import build
from afmcalc.engines.characteristics import CoilCharacteristic, DiscCharacteristic
from afmcalc.engines.parts import following_stiffness, lost_by_wear, spring_demands
from afmcalc.equations import springs as law
from afmcalc.errors import SpecError
from afmcalc.spec import read_spec
from afmcalc.spec.catalogues import discs
from afmcalc.spec.models import CoilSprings, DiscStack

SIZES = {each.name: each for each in discs()}
PRINTED = table("forces")
"""Disc → force that DIN EN 16983 prints, at ¾ of the cone height, N; none is printed for C 125."""


def stack(name, parallel=1, series=1):
    size = SIZES[name]
    shape = {key: getattr(size, key) for key in ("outer_diameter", "inner_diameter", "thickness", "free_height")}
    return DiscStack(**shape, reduced_thickness=size.reduced_thickness, parallel=parallel, series=series)


def disc(name, parallel=1, series=1):
    return DiscCharacteristic(stack(name, parallel, series))


def almen_laszlo(outer, inner, thickness, height, deflection):
    """Force of a plain disc, written out with E 206 GPa and ν 0.3."""
    ratio = outer / inner
    k1 = ((ratio - 1) / ratio) ** 2 / (math.pi * ((ratio + 1) / (ratio - 1) - 2 / math.log(ratio)))
    h, s = height / thickness, deflection / thickness
    return 4 * 206e9 / 0.91 * thickness**4 / (k1 * outer**2) * s * ((h - s) * (h - s / 2) + 1)


def test_printed_forces_of_the_standard():
    """DIN EN 16983: the force at ¾ of the cone height, rounded to 0.01 mm; 29 of each series, A the stiffest."""
    for name, size in SIZES.items():
        cone = size.free_height - size.thickness
        found = float(disc(name).force(math.floor(cone * 75e3 + 0.5 + 1e-9) * 1e-5))
        if (printed := PRINTED[name[0]].get(name[2:])) is None:
            assert (name, round(found, -2)) == ("C 125", 15400), "not printed; the theory computes 15 416 N at ¾ h_0"
        else:
            assert float(f"{found:.{2 if name == 'C 8' else 3}g}") == printed, name
    assert [sum(name[0] == series for name in SIZES) for series in "ABC"] == [29, 29, 29]
    ratios = {s: [each.free_height / each.thickness for each in discs() if each.name[0] == s] for s in "ABC"}
    assert max(ratios["A"]) < min(ratios["B"]) < max(ratios["B"]) < min(ratios["C"])


@given(st.sampled_from(sorted(SIZES)), st.integers(1, 6), st.integers(1, 30), st.floats(0.01, 1))
def test_a_stack_is_n_forces_and_i_deflections(name, parallel, series, share):
    size, own = SIZES[name], disc(name, parallel, series)
    single = disc(name)
    each = share * single.end
    assert own.force(series * each) == pytest.approx(parallel * float(single.force(each)), rel=1e-12)
    step = 1e-7 * single.end
    slope = (float(own.force(series * (each + step))) - float(own.force(series * (each - step)))) / (2 * series * step)
    assert own.stiffness(series * each) == pytest.approx(slope, rel=1e-5)
    assert own.deflection(own.force(series * each)) == pytest.approx(series * each, rel=1e-9)
    if size.reduced_thickness is None:
        shape = size.outer_diameter, size.inner_diameter, size.thickness, (size.free_height - size.thickness)
        assert single.force(each) == pytest.approx(almen_laszlo(*shape, each), rel=1e-12)


def test_disc_spring_of_a_textbook():
    """Machinery's Handbook, 31st edition (2020), "Disc spring examples", pages 362 and 363.
    80 × 41 × 4, 2.2 high, reckoned with the diameter 77.78 its edges are apart: K_1, K_2, K_3; at 0.9 and 1.32 mm the force
    (14 390 and 20 050 N) and the stresses at OM (1103 N/mm²), II and III.
    """
    ratio = 80 / 41
    logarithm = math.log(ratio)
    load = law.disc_factor_load(ratio, logarithm, math.pi)
    membrane = law.disc_factor_membrane(ratio, logarithm, math.pi)
    bending = law.disc_factor_bending(ratio, logarithm, math.pi)
    assert (load, membrane, bending) == pytest.approx((0.6841, 1.2086, 1.3589), abs=6e-5)
    edges = {"OM": (0.0, 3 / math.pi), "II": (membrane, -bending)}
    edges["III"] = ((membrane - 2 * bending) / ratio, -bending / ratio)
    printed = {0.9: (14390, {"II": 654, "III": 815}), 1.32: (20050, {"OM": -1103, "II": 1032, "III": 1149})}
    for deflection, (force, stresses) in printed.items():
        disc_of = 206000, 0.3, load, 1.0, 77.78, 4.0, 2.2, deflection
        assert law.disc_force(*disc_of) == pytest.approx(force, abs=10)
        for name, stress in stresses.items():
            assert law.disc_stress(*disc_of, *edges[name]) == pytest.approx(stress, abs=1), (name, deflection)


def test_curvature_of_a_coil_in_a_textbook():
    """Budynas & Nisbett, Shigley's Mechanical Engineering Design, example 10-1: 4.13 lbf/in, K_B 1.124, 6.46 lbf."""
    inch, pound = 25.4e-3, 4.4482216152605
    psi = pound / inch**2
    stiffness = law.coil_stiffness(11.85e6 * psi, 0.037 * inch, 0.4 * inch, 10.5)
    assert stiffness / (pound / inch) == pytest.approx(4.13, abs=0.005)
    correction = law.coil_correction(0.037 * inch, 0.4 * inch)
    assert correction == pytest.approx(1.124, abs=0.0005)
    stress = law.coil_stress(6.46 * pound, 0.037 * inch, 0.4 * inch, correction, math.pi)
    assert stress / psi == pytest.approx(146e3, rel=1e-3)


def test_coil_spring_by_en_13906_1():
    """A published verification (wire 5, outside 39.6, 9.5 turns of 11.5, 105.8 long): 16.181 N/mm; gaps of swinging."""
    own = CoilCharacteristic(CoilSprings(wire_diameter=5e-3, coil_diameter=34.6e-3, turns=9.5, free_length=105.8e-3))
    assert own.rate == pytest.approx(16181, abs=0.5)
    assert 1.5 * (own.end - own.range[1]) == pytest.approx(12.3e-3, abs=1e-4)
    assert own.deflection(280.0) == pytest.approx(17.3e-3, abs=5e-5)
    twice = CoilCharacteristic(own.part.model_copy(update={"count": 2}))
    assert twice.force(0.01) == pytest.approx(2 * own.force(0.01))


def test_wear_follows_the_curve():
    """A direct clutch on series C: near ¾ of the cone height the force hardly falls."""
    size = SIZES["C 90"]
    stacked = stack("C 90", 1, 2)
    force = float(disc("C 90", 1, 2).force(2 * 0.7 * (size.free_height - size.thickness)))
    spec = read_spec(CONFIGS / "default.toml", [f"closing_spring.force={force}"])
    clutch = build(spec.model_copy(update={"closing_spring": spec.closing_spring.model_copy(update={"disc": stacked})}))
    pairs, wear = 8, 1e-4
    shape = size.outer_diameter, size.inner_diameter, size.thickness, (size.free_height - size.thickness)
    left = almen_laszlo(*shape, (2 * 0.7 * (size.free_height - size.thickness) - pairs * wear) / 2)
    assert lost_by_wear(clutch, wear) == pytest.approx(force - left, rel=1e-9)
    assert lost_by_wear(clutch, 1.0) == pytest.approx(force), "no more than there is"
    assert following_stiffness(clutch) == pytest.approx(
        float(disc("C 90", 1, 2).stiffness(1.4 * (size.free_height - size.thickness)))
    )


DEFAULT, INDIRECT = CONFIGS / "default.toml", CONFIGS / "indirect.toml"
WIDE = (
    "closing_spring.disc={outer_diameter=0.08, inner_diameter=0.041, thickness=2.25e-3, free_height=5.2e-3, series=2}"
)


def coil(spring="closing_spring", **sizes):
    """A coil spring that passes every check, 2 kN at 21.2 mm of 40 mm; ``sizes`` replace its sizes."""
    own = {"wire_diameter": 10e-3, "coil_diameter": 60e-3, "turns": 5, "free_length": 110e-3, "count": 1} | sizes
    return f"{spring}.coil={{{', '.join(f'{name}={value}' for name, value in own.items())}}}"


def rate(wire, diameter, turns, count=1):
    return count * 81.5e9 * wire**4 / (8 * diameter**3 * turns)


def found_by(path, *overrides):
    return codes(clutch_findings(build(read_spec(path, overrides))))


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
    """The curvature of its wire counts, except up to 10⁴ strokes, which count as static (EN 13906-1)."""
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
    for told in ([], ["--set", "closing_spring.stiffness=94.3 N/mm"]):
        worn = afmcalc("effects", DEFAULT, "--set", coil(), *told, "--set", "heat.lining=1e-4", "--json").json
        (effect,) = (each for each in worn["result"]["effects"] if each["effect"] == "wear")
        lost = effect["torque_low"]["min"] / effect["torque_high"]["min"]
        assert lost == pytest.approx(1 - 8e-4 * rate(0.01, 0.06, 5) / 2000, rel=1e-4)
