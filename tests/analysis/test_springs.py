"""Springs one can buy: each one found meets the demand, none that meets it is missed, a picked one reads back."""

from functools import cache

import numpy as np
import pytest
from conftest import CONFIGS
from hypothesis import given, settings
from hypothesis import strategies as st

from afmcalc.analysis.half_section import layout
from afmcalc.analysis.spring_search import _tables, coil_diameters, coils, picked, ranked, springs
from afmcalc.analysis.trip_heat import heat
from afmcalc.engines import build
from afmcalc.engines.characteristics import DiscCharacteristic
from afmcalc.engines.parts import SpringDemand, checks_of_part, spring_demands, values_of_part
from afmcalc.spec import make_spec, read_spec, resolved
from afmcalc.spec.catalogues import discs
from afmcalc.spec.models import CoilSprings, DiscStack, Room

ROOM = (60e-3, 160e-3, 80e-3)
DEFAULT, INDIRECT = CONFIGS / "default.toml", CONFIGS / "indirect.toml"


def within(spring, inner=ROOM[0], outer=ROOM[1], length=ROOM[2]):
    given = {"inner_diameter": inner, "outer_diameter": outer, "length": length}
    return [f"{spring}.room.{name}={value}" for name, value in given.items()]


def clutch(path, *overrides):
    return build(read_spec(path, overrides))


@pytest.mark.slow
def test_none_and_the_nearest():
    """No disc spring has 2.5 kN, 365 N/mm and 6 mm of travel (theory): the result has the nearest, with a finding."""
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
        # the nut moves ΔF/c, or further with a disc spring, which softens as it is pressed
        assert each.travel_setting == pytest.approx(200 / each.stiffness, rel=0.25 if each.kind == "disc" else 1e-9)
        assert each.turns_setting == pytest.approx(each.travel_setting / 1.5e-3)
    for each in result.closing:
        held = 0.02 * (each.parallel - 1) + 0.03
        assert (each.force_up, each.force_down) == pytest.approx((2000 / (1 - held), 2000 / (1 + held)))
    assert all(each.force_up is None for each in coils.closing)


def test_what_the_springs_go_through():
    """The closing spring of a direct clutch follows the wear; in an indirect one the control spring does."""
    (direct,) = spring_demands(clutch(DEFAULT, "heat.lining=0.5e-3"))
    assert (direct.relaxes, direct.compresses, direct.follows) == (4e-3, 0, 8)
    own = clutch(INDIRECT, "heat.lining=0.5e-3")
    closing, control = spring_demands(own)
    assert (closing.relaxes, closing.follows) == (own.at(friction=0.8)["travel"], None)
    assert (control.relaxes, control.compresses, control.follows) == (4e-3, own.at(friction=0.8)["travel"], 8)
    assert control.force == own.control_force


@pytest.mark.slow
def test_a_picked_spring_is_in_the_spec(afmcalc, tmp_path):
    made = tmp_path / "sprung.toml"
    run = afmcalc("springs", INDIRECT, "--kind", "disc", "--pick", 1, "--pick", 12, "--save", made, "--json").json[
        "result"
    ]
    first, second, spec = run["closing"][0], run["control"][1], read_spec(made)
    assert (first["number"], second["number"]) == (1, 12)
    assert spec.closing_spring.stiffness == pytest.approx(first["stiffness"])
    assert (spec.closing_spring.disc.parallel, spec.closing_spring.disc.series) == (first["parallel"], first["series"])
    assert spec.control_spring.force == pytest.approx(second["force"])
    torque, plain = (afmcalc("torque", path, "--json").json["result"]["torque"] for path in (made, INDIRECT))
    assert torque["min"] == pytest.approx(plain["min"], rel=1e-6), "as set"
    assert torque["max"] != pytest.approx(plain["max"], rel=1e-3), "the curve counts where it moves"
    assert afmcalc("check", made, "--set", "control_unit.static_safety=1").code == 0
    assert afmcalc("springs", DEFAULT, "--kind", "disc", "--pick", "99", "--save", tmp_path / "x.toml").code == 2


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
    columns = coils(wish)
    names = ("wire_diameter", "coil_diameter", "turns", "free_length", "count")
    found = [CoilSprings.model_construct(**dict(zip(names, row, strict=True)))
             for row in zip(*(getattr(columns, name).tolist() for name in names), strict=True)]  # fmt: skip
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
    assert coil_diameters(room, 1, 5e-3) == pytest.approx([each * 1e-3 for each in range(45, 66)], rel=1e-12)
    assert coil_diameters(room, 1, 4.5e-3) == pytest.approx([each * 1e-3 for each in range(45, 66)], rel=1e-12)
    # on a circle of 55 mm in the gap of 15 mm: index 4 to 20, within 15 − d
    assert coil_diameters(room, 3, 2e-3) == pytest.approx([each * 1e-3 for each in range(8, 14)], rel=1e-12)
    # sixteen on that circle: two neighbours are 55 sin(π/16) = 10.7 mm apart
    assert coil_diameters(room, 16, 2e-3) == pytest.approx([8e-3], rel=1e-12)
    # 33 + 4 and 44 − 4 are 37.00000000000001 and 39.99999999999999 in floats
    tight = Room(inner_diameter=0.033, outer_diameter=0.044)
    assert coil_diameters(tight, 1, 4e-3) == pytest.approx([each * 1e-3 for each in range(37, 41)], rel=1e-12)


NONE = -1.0
"""Travel that stands for no stack, m."""
SHAPE = ("outer_diameter", "inner_diameter", "thickness", "reduced_thickness", "free_height")


@cache
def packs(inner, outer):
    """Cone height and characteristic of packs of one to six discs of every size that fits the room."""
    found = []
    for size in discs():
        if inner <= size.inner_diameter and size.outer_diameter <= outer:
            shape = {name: getattr(size, name) for name in SHAPE}
            made = [DiscCharacteristic(DiscStack(**shape, parallel=each)) for each in range(1, 7)]
            found += [((size.free_height - size.thickness), each) for each in made]
    return found


def by_trying(room, force, stiffness, *, relaxes):
    """Largest travel of any stack of 1 to 10,000 packs, between 0.15 and 0.75 of the cone height."""
    series, best = np.arange(1, 10_001), NONE
    for cone, own in packs(room.inner_diameter, room.outer_diameter):
        each = float(own.deflection(force))
        if not (0.15 * cone <= each <= 0.75 * cone and own.force(each) >= force * (1 - 1e-9)):
            continue
        left = (room.length or np.inf) - series * (own.free_length - each)
        good = (left >= 0) & (np.abs(float(own.stiffness(each)) / series - stiffness) <= 0.1 * stiffness)
        travel = np.minimum(series * (each - 0.15 * cone), left) if relaxes else series * (0.75 * cone - each)
        best = max(best, travel[good].max(initial=NONE))
    return best


@settings(max_examples=5)
@given(
    st.sampled_from([(0.02, 0.06), (0.04, 0.1), (0.08, 0.2)]),
    st.one_of(st.none(), st.floats(0.005, 0.3)),
    st.floats(np.log(300), np.log(2e5)).map(np.exp),
    st.floats(np.log(5e4), np.log(2e7)).map(np.exp),
    st.booleans(),
)
def test_a_stack_is_found_wherever_one_of_10_000_packs_does(across, length, force, stiffness, relaxes):
    room = Room(inner_diameter=across[0], outer_diameter=across[1], length=length)
    most = by_trying(room, force, stiffness, relaxes=relaxes)
    for share, does in ((1 - 1e-6, most > 0), (1 + 1e-6, False)):
        service = {"relaxes": 0.0, "relaxes" if relaxes else "compresses": max(most, 1e-6) * share}
        demand = SpringDemand(force=force, stiffness=stiffness, room=room, **COIL | service)
        assert bool(ranked(demand, "disc", 1)) == does


@pytest.mark.parametrize("stroke", [None, 1e-3])
def test_columns_judge_as_a_part_that_is_named(stroke):
    """A row of the columns has the same value and limit for every rule as its part has by itself."""
    room, rng = Room(inner_diameter=0.03, outer_diameter=0.15, length=0.1), np.random.default_rng(36)
    demand = SpringDemand(
        force=3e3, stiffness=2e5, stroke=stroke, compresses=1e-3, room=room, **COIL | {"relaxes": 2e-3}
    )
    fits = set()
    for kind in ("disc", "coil"):
        (table,) = _tables(demand, kind, 0.1)
        for row in (*rng.choice(len(table.worst()), 20), table.worst().argmin()):
            part = table.part(row)
            single = {each.rule: each for each in checks_of_part(values_of_part(demand, part))}
            for rule, *numbers, _ in checks_of_part(table.values):
                value, limit = (np.broadcast_to(each, table.worst().shape)[row] for each in numbers)
                if np.isnan(value) or np.isnan(limit):
                    assert rule not in single
                    continue
                own = single.pop(rule)
                assert (value, limit) == pytest.approx((own.value, own.limit), rel=1e-9)
                missed = table.misses[rule.topic][row]
                assert missed > 0 or own.beyond <= 1e-9
            assert not single
            fits.add((kind, bool(table.worst()[row] == 0)))
    assert fits >= {("disc", False), ("coil", False), ("coil", True)}


def test_an_envelope_leaves_the_room_and_what_is_picked_fits(afmcalc, tmp_path):
    """A spec with an envelope but no room for springs: the springs offered fit the layout and collide with nothing."""
    own = clutch(CONFIGS / "machine-clutch.toml", "closing_spring.disc=", "closing_spring.coil=")
    result, found = springs(own, top=1000)
    assert "room-not-given" not in {each.code for each in found}
    for each in result.closing[::9]:
        told, remarks = layout(build(picked(own, result, [each.number])[1]))
        (row,) = (row for row in told.parts if row.part == "closing spring")
        assert row.right - row.left == pytest.approx(each.length_set)
        assert not {remark.code for remark in remarks} & {"parts-collide", "clutch-too-long"}
    made = tmp_path / "sprung.toml"
    run = afmcalc("springs", "example:machine-clutch", "--pick", 1, "--save", made)
    assert afmcalc("check", made, "--json").json["result"]["verdict"]["sentence"] in run.err
    assert afmcalc("springs", "example:machine-clutch", "--save", tmp_path / "x.toml").code == 2
