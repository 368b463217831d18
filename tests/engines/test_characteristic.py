"""Parts as springs: the standard's printed forces, examples of others, and clutches that follow a curved spring."""

import math

import pytest
from conftest import CONFIGS
from hypothesis import given
from hypothesis import strategies as st

from afmcalc.engines import build
from afmcalc.engines.characteristics import CoilCharacteristic, DiscCharacteristic
from afmcalc.engines.parts import following_stiffness, lost_by_wear
from afmcalc.equations import springs as law
from afmcalc.spec import read_spec
from afmcalc.spec.catalogues import discs
from afmcalc.spec.models import CoilSprings, DiscStack

SIZES = {each.name: each for each in discs()}


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
        found = float(disc(name).force(math.floor(size.cone_height * 75e3 + 0.5 + 1e-9) * 1e-5))
        if size.printed_force is None:
            assert (name, round(found, -2)) == ("C 125", 15400), "not printed; the theory computes 15 416 N at ¾ h_0"
        else:
            assert float(f"{found:.{2 if name == 'C 8' else 3}g}") == size.printed_force, name
    assert [sum(size.series == series for size in discs()) for series in "ABC"] == [29, 29, 29]
    ratios = {s: [size.cone_height / size.thickness for size in discs() if size.series == s] for s in "ABC"}
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
        shape = size.outer_diameter, size.inner_diameter, size.thickness, size.cone_height
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
    force = float(disc("C 90", 1, 2).force(2 * 0.7 * size.cone_height))
    spec = read_spec(CONFIGS / "default.toml", [f"closing_spring.force={force}"])
    clutch = build(spec.model_copy(update={"closing_spring": spec.closing_spring.model_copy(update={"disc": stacked})}))
    pairs, wear = 8, 1e-4
    shape = size.outer_diameter, size.inner_diameter, size.thickness, size.cone_height
    left = almen_laszlo(*shape, (2 * 0.7 * size.cone_height - pairs * wear) / 2)
    assert lost_by_wear(clutch, wear) == pytest.approx(force - left, rel=1e-9)
    assert lost_by_wear(clutch, 1.0) == pytest.approx(force), "no more than there is"
    assert following_stiffness(clutch) == pytest.approx(float(disc("C 90", 1, 2).stiffness(1.4 * size.cone_height)))
