"""Springs one can buy: each found gives what is wanted, none that does is missed, what is picked reads back."""

import math

import pytest
from conftest import CONFIGS

from afmcalc.analysis.heat import heat
from afmcalc.analysis.springs.candidates import _coils, coil_springs
from afmcalc.analysis.springs.springs import springs
from afmcalc.engines import build
from afmcalc.engines.springs import SpringDemand
from afmcalc.spec import make_spec, read_spec, resolved
from afmcalc.spec.catalogues import discs
from afmcalc.spec.models import Room

ROOM = (60e-3, 160e-3, 80e-3)
DEFAULT, INDIRECT = CONFIGS / "default.toml", CONFIGS / "indirect.toml"


def within(spring, inner=ROOM[0], outer=ROOM[1], length=ROOM[2]):
    given = {"inner_diameter": inner, "outer_diameter": outer, "length": length}
    return [f"{spring}.room.{name}={value}" for name, value in given.items()]


def clutch(path, *overrides):
    return build(read_spec(path, overrides))


def force_and_slope(size, deflection):
    """Force and stiffness of one plain disc, from three forces of Almen and László written out."""

    def force(s):
        ratio = size.outer_diameter / size.inner_diameter
        k1 = ((ratio - 1) / ratio) ** 2 / (math.pi * ((ratio + 1) / (ratio - 1) - 2 / math.log(ratio)))
        h, t = size.cone_height, size.thickness
        return 4 * 206e9 / 0.91 * t * s / (k1 * size.outer_diameter**2) * ((h - s) * (h - s / 2) + t * t)

    step = 1e-6 * size.cone_height
    return force(deflection), (force(deflection + step) - force(deflection - step)) / (2 * step)


def moves_for_ever(coil, stroke):
    """Its stress, with the curvature's factor, is within Goodman's line through 241 MPa about 379 MPa (Zimmerli)."""
    wire, diameter = (coil.outer_diameter - coil.inner_diameter) / 2, (coil.outer_diameter + coil.inner_diameter) / 2
    index = diameter / wire
    factor = 1 + 1.25 / (index - 0.75)
    upper, lower = (
        factor * 8 * force / coil.count * diameter / (math.pi * wire**3)
        for force in (coil.force_largest, coil.force_largest - stroke * coil.stiffness)
    )
    assert (coil.loading, coil.stress_correction) == ("dynamic", pytest.approx(factor))
    assert coil.stress == pytest.approx(upper)
    ultimate = 0.67 * (1980 - 740 * math.log10(wire * 1e3))
    mean, amplitude = (upper + lower) / 2e6, (upper - lower) / 2e6
    return amplitude / 241 * (1 - 379 / ultimate) + mean / ultimate <= 1 + 1e-9


def by_force(size, force):
    """Deflection of one disc; None where it is flat before."""
    low, high = 0.0, size.cone_height
    if force_and_slope(size, high)[0] < force:
        return None
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if force_and_slope(size, middle)[0] < force else (low, middle)
    return low


@pytest.mark.slow
def test_every_part_gives_what_is_wanted_within_the_room():
    rooms = [*within("closing_spring", inner=20e-3), *within("control_spring", 30e-3, 200e-3, 0.3)]
    own = clutch(INDIRECT, *rooms, "heat.lining=0.5e-3")
    result, found = springs(own, top=1000)
    assert result.closing_found == len(result.closing) > 20
    assert result.control_found == len(result.control) > 20
    travel, worn = own.at(0.8)["travel"], 8 * 0.5e-3
    cases = (
        (result.closing, 2000, 4e5, (travel, 0), (20e-3, *ROOM[1:])),
        (result.control, own.control_force, 2e5, (worn, travel), (30e-3, 200e-3, 0.3)),
    )
    for options, force, stiffness, (relaxes, compresses), (inner, outer, length) in cases:
        assert {each.kind for each in options} == {"disc", "coil"}
        for each in options:
            assert each.force == pytest.approx(force, rel=1e-9)
            assert each.stiffness == pytest.approx(stiffness, rel=0.1)
            assert each.length <= length * (1 + 1e-9)
            if each.kind == "coil":
                wide = each.outer_diameter if each.count == 1 else 2 * each.outer_diameter + inner
                assert wide <= outer * (1 + 1e-9)
                assert each.count > 1 or each.inner_diameter >= inner * (1 - 1e-9)
                assert each.used_low > -1e-9
                assert moves_for_ever(each, relaxes if options is result.closing else compresses)
                continue
            (size,) = (size for size in discs() if each.part.endswith(f" {size.name}"))
            assert inner * (1 - 1e-9) <= size.inner_diameter
            assert size.outer_diameter <= outer * (1 + 1e-9)
            if size.reduced_thickness is None:
                cone, series = size.cone_height, each.series
                deflection = by_force(size, force / each.parallel)
                assert 0.15 * cone <= deflection - relaxes / series + 1e-9
                assert deflection + compresses / series <= 0.75 * cone + 1e-9
                _, slope = force_and_slope(size, deflection)
                assert each.stiffness == pytest.approx(each.parallel * slope / series, rel=1e-4)
    assert not {each.code for each in found} & {"no-spring", "room-not-given"}


@pytest.mark.slow
def test_none_and_the_nearest():
    """2.5 kN, 365 N/mm and 6 mm of travel have no disc spring (theory); the nearest and what it misses."""
    wish = ["closing_spring.force=2500", "closing_spring.stiffness=365e3", "heat.lining=0.75e-3"]
    result, found = springs(clutch(DEFAULT, *wish, *within("closing_spring", 0.03, 0.1, 0.2)), kind="disc")
    assert (result.closing, len(result.nearest)) == ([], 1)
    assert "no-spring" in {each.code for each in found}
    softer, _ = springs(clutch(DEFAULT, *wish, "closing_spring.stiffness=36500"), kind="disc")
    assert softer.closing, "as soon as it may be softer there is one"


def test_setting_friction_and_wear():
    own = clutch(DEFAULT, "closing_spring.thread_pitch=1.5e-3", "closing_spring.surface_friction=0.02",
                 "closing_spring.edge_friction=0.03", "closing_spring.stiffness=100e3", "heat.lining=0.1e-3")  # fmt: skip
    result, _ = springs(own, kind="disc", top=1000)
    coils, _ = springs(own, kind="coil", top=1000)
    for each in (*result.closing, *coils.closing):
        assert each.loss_per_travel == pytest.approx(each.stiffness / 2000)
        assert each.loss_per_wear == pytest.approx(8 * each.stiffness / 2000)
        # the nut moves ΔF/c; the softer as it is pressed, the more
        assert each.travel_setting == pytest.approx(200 / each.stiffness, rel=0.25 if each.kind == "disc" else 1e-9)
        assert each.turns_setting == pytest.approx(each.travel_setting / 1.5e-3)
    for each in result.closing:
        held = 0.02 * (each.parallel - 1) + 0.03
        assert (each.force_up, each.force_down) == pytest.approx((2000 / (1 - held), 2000 / (1 + held)))
    assert all(each.force_up is None for each in coils.closing)


def test_what_the_springs_go_through():
    """The closing spring of a direct clutch follows the wear; in an indirect one the control spring does."""
    (direct,) = clutch(DEFAULT, "heat.lining=0.5e-3").spring_demands()
    assert (direct.relaxes, direct.compresses, direct.follows) == (4e-3, 0, 8)
    own = clutch(INDIRECT, "heat.lining=0.5e-3")
    closing, control = own.spring_demands()
    assert (closing.relaxes, closing.follows) == (own.at(0.8)["travel"], None)
    assert (control.relaxes, control.compresses, control.follows) == (4e-3, own.at(0.8)["travel"], 8)
    assert control.force == own.control_force


@pytest.mark.slow
def test_a_picked_spring_is_in_the_spec(afmcalc, tmp_path):
    made = tmp_path / "sprung.toml"
    run = afmcalc("springs", INDIRECT, "--kind", "disc", "--pick", 1, "--pick", 12, "-o", made, "--json").json["result"]
    first, second, spec = run["closing"][0], run["control"][1], read_spec(made)
    assert (first["number"], second["number"]) == (1, 12)
    assert spec.closing_spring.stiffness == pytest.approx(first["stiffness"])
    assert (spec.closing_spring.disc.parallel, spec.closing_spring.disc.series) == (first["parallel"], first["series"])
    assert spec.control_spring.force == pytest.approx(second["force"])
    torque, plain = (afmcalc("torque", path, "--json").json["result"]["torque"] for path in (made, INDIRECT))
    assert torque["min"] == pytest.approx(plain["min"], rel=1e-6), "as set"
    assert torque["max"] != pytest.approx(plain["max"], rel=1e-3), "the curve counts where it moves"
    assert afmcalc("check", made).code == 0
    assert afmcalc("springs", DEFAULT, "--kind", "disc", "--pick", "99", "-o", tmp_path / "x.toml").code == 2


@pytest.mark.slow
def test_what_rests_on_a_slack_spring_is_not_told():
    """Six discs B 40 pressed by 3.56 mm by 2 kN; eight pairs wear by 4 mm: slack, no 1.5 million trips, no force < 0."""
    stack = {"outer_diameter": 0.04, "inner_diameter": 0.0204, "thickness": 1.5e-3, "free_height": 2.65e-3, "series": 6}
    data = resolved(read_spec(CONFIGS / "drive.toml", ["drive.motor_inertia=0.2"]))
    data["closing_spring"] = {"force": 2000.0, "disc": stack}
    own = build(make_spec(data))
    told, found = heat(own)
    assert told.trips_to_wear_out is None
    (slack,) = [each for each in found if each.code == "spring-slack-before-worn"]
    assert (slack.value, slack.limit) == (pytest.approx((6 * 2.65e-3 - 12.341e-3) / 8, rel=1e-4), 5e-4)
    (named,) = springs(own)[0].named
    assert named.force_least is None
    thinner = build(make_spec(data | {"heat": {**data["heat"], "lining": 4e-4}}))
    assert heat(thinner)[0].trips_to_wear_out is not None
    assert springs(thinner)[0].named[0].force_least > 0
    # a straight spring of the same force: 2 kN over 8 pairs of 0.5 mm is 500 N/mm
    for stiffness, worn in ((499e3, True), (501e3, False)):
        straight = build(make_spec(data | {"closing_spring": {"force": 2000.0, "stiffness": stiffness}}))
        assert (heat(straight)[0].trips_to_wear_out is not None) == worn


G = 81.5e9
COIL = {"relaxes": 0.0, "follows": None, "pitch": None, "friction": None, "name": "closing"}


def test_coils_are_of_sizes_that_a_works_makes():
    """Mean diameters in whole millimetres, every one that fits; turns in quarters, the nearest; lengths in tenths, up."""
    room = Room(inner_diameter=0.04, outer_diameter=0.07)
    wish = SpringDemand(force=2000.0, stiffness=20e3, compresses=1.23e-3, room=room, **COIL)
    found = list(coil_springs(wish))
    assert {part.count for part in found} >= {1, 3}
    sizes = {}
    for part in found:
        wire, coil, turns = part.wire_diameter, part.coil_diameter, part.turns
        sizes.setdefault((part.count, round(wire * 1e3, 3)), set()).add(round(coil * 1e3, 6))
        wanted = part.count * G * wire**4 / (8 * coil**3) / 20e3
        assert (4 * turns).is_integer()
        assert abs(turns - wanted) <= 0.125 + 1e-9
        rate = part.count * G * wire**4 / (8 * coil**3 * turns)
        needed = (turns + 2) * wire + turns * (0.0015 * coil**2 / wire + 0.1 * wire) + 2000 / rate + 1.23e-3
        assert part.free_length * 1e4 == pytest.approx(round(part.free_length * 1e4), abs=1e-6)
        assert -1e-9 <= part.free_length - needed < 1e-4
    assert all(size == round(size) for each in sizes.values() for size in each)
    # around 40 mm and within 70 mm: wire of 5 mm from 45 to 65, of 4.5 from 44.5 to 65.5; by its turns from 2 on
    assert _coils(room, 1, 5e-3) == pytest.approx([each * 1e-3 for each in range(45, 66)], rel=1e-12)
    assert _coils(room, 1, 4.5e-3) == pytest.approx([each * 1e-3 for each in range(45, 66)], rel=1e-12)
    # on a circle of 55 mm in the gap of 15 mm: index 4 to 20, within 15 − d
    assert _coils(room, 3, 2e-3) == pytest.approx([each * 1e-3 for each in range(8, 14)], rel=1e-12)
    # sixteen on that circle: two neighbours are 55 sin(π/16) = 10.7 mm apart
    assert _coils(room, 16, 2e-3) == pytest.approx([8e-3], rel=1e-12)
    # 33 + 4 and 44 − 4 are 37.00000000000001 and 39.99999999999999 in floats
    tight = Room(inner_diameter=0.033, outer_diameter=0.044)
    assert _coils(tight, 1, 4e-3) == pytest.approx([each * 1e-3 for each in range(37, 41)], rel=1e-12)
