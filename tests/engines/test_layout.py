"""The layout against rings that are counted by hand, and its overlaps against those of its rectangles."""

import itertools
import math

import numpy as np
import pytest
from sources import CLUTCHES

from afmcalc.analysis.check import check
from afmcalc.drive.train import inertias_of
from afmcalc.engines import build
from afmcalc.engines.parts import spring_demands
from afmcalc.engines.rings import Sizes, SpringSize, inertia_of, length_of, overlaps, parts_of, sizes_of
from afmcalc.errors import SpecError
from afmcalc.spec import make_spec, read_spec
from afmcalc.spec.edit import respecified, value_at, with_values

STEEL = 7850.0
SLEEVES = {"direct": {"thrust disc", "pressure disc"}, "indirect": {"ball sleeve", "thrust sleeve"}}


def drawn(rng, travels):
    """Random sizes, with which parts collide in about half of the cases."""
    u = rng.uniform
    spring = lambda: SpringSize(inner := u(0.02, 0.11), inner + u(0.005, 0.03), u(0.005, 0.05), 0.3)  # noqa: E731
    return Sizes(
        travels, int(rng.integers(2, 12)), inner := u(0.04, 0.09), inner + u(0.02, 0.05), 0.01, u(0.012, 0.06),
        u(0.002, 0.005), u(0.005, 0.015), u(0.003, 0.008), u(0.01, 0.04) * (rng.random() < 0.9), 6, u(0.03, 0.09),
        0.002, u(0.004, 0.03) if rng.random() < 0.5 else None, u(0, 0.01), spring(),
        spring() if travels else SpringSize(),
    )  # fmt: skip


def apart(one, other):
    """Least distance by which one rectangle must be moved along one of its axes to be clear of another; 0 if it is."""
    moves = []
    for low, high in ((0, 1), (2, 3)):
        shared = min(one[high], other[high]) - max(one[low], other[low])
        if min(shared, one[high] - one[low], other[high] - other[low]) <= 0:
            return 0.0
        moves += [one[high] - other[low], other[high] - one[low]]
    return min(moves)


def outside(around, ring):
    """Distance by which a ring extends beyond the housing, or into the hub."""
    if not (ring.left < ring.right and ring.inner < ring.outer):
        return 0.0
    if around.name == "hub":
        return around.boxes[0].inner - ring.inner
    web, drum = around.boxes
    return max(ring.outer - web.outer, ring.right - drum.right, -ring.left)


@pytest.mark.parametrize("kind", SLEEVES)
def test_what_overlaps_is_what_the_rectangles_do(kind):
    rng, seen = np.random.default_rng(26), set()
    for _ in range(120):
        parts = parts_of(drawn(rng, kind == "indirect"))
        found = {frozenset(pair): float(missing) for *pair, missing in overlaps(parts) if missing > 0}
        expected = {}
        for one, other in itertools.combinations(parts, 2):
            names = {one.name, other.name}
            most = max(apart(box, beside) for box in one.boxes for beside in other.boxes)
            if one.name in ("housing", "hub"):
                most = max(most, *(outside(one, box) for box in other.boxes))
            if most > 0 and not ("balls" in names and names & SLEEVES[kind]):
                expected[frozenset(names)] = most
        assert found == pytest.approx(expected)
        seen |= set(found)
    named = [{"hub", "pack"}, {"hub", "balls"}, {"pack", "balls"}, {"hub", "closing spring"}]
    named += [{"closing spring", "stop ring"}, {"housing", "balls"}] if kind == "indirect" else []
    named += [{"housing", "closing spring"}]
    assert all(frozenset(pair) in seen for pair in named)


def ring(outer, inner, length):
    """Mass and moment of inertia of a steel ring (sizes in mm), summed over thin rings."""
    edges = np.linspace(inner, outer, 20001) / 1000
    radii = (edges[1:] + edges[:-1]) / 2
    mass = 2 * math.pi * STEEL * length / 1000 * radii * np.diff(edges)
    return np.array([mass.sum(), (mass * radii**2).sum()])


def direct(**given):
    return make_spec(CLUTCHES["spaced"] | given)


def test_a_direct_clutch_by_hand():
    """Pockets 12 mm deep over a floor of 10: faces at 32 and 34, the second boss ends at 56, a flange of 10 ends it."""
    clutch = build(direct())
    parts = parts_of(sizes_of(clutch))
    assert length_of(parts) == pytest.approx(0.066)
    discs, carrier = ring(120, 80, 5 * 3), ring(80, 74, 15)
    housing = ring(126, 15, 10) + ring(126, 120, 56)
    hub = ring(25, 15, 56)
    thrust = ring(120, 25, 10) + ring(63, 25, 12)
    pressure = ring(120, 25, 10) + ring(63, 25, 35 - 34) + ring(63, 25, 56 - 45)
    balls = 6 * STEEL * math.pi / 6 * 0.026**3
    driving = housing + 3 / 5 * discs
    driven = hub + 2 / 5 * discs + carrier + thrust + pressure
    assert sum(body.mass for part in parts for body in part.bodies) == pytest.approx(
        (driving + driven)[0] + balls, rel=1e-6
    )
    assert inertia_of(parts, "driving") == pytest.approx(driving[1], rel=1e-6)
    # the balls as a ring of their mass, 2 % more than six spheres on a circle
    assert inertia_of(parts, "driven") == pytest.approx(driven[1] + balls * (0.05**2 + 0.026**2 / 10), rel=1e-3)
    assert inertia_of(parts, "hub") == 0


def test_an_indirect_clutch_by_hand():
    """The springs have their length as set: free lengths of 14.8 and 70.1 mm, less the deflection by their force."""
    spec = read_spec("example:envelope")
    clutch = build(spec)
    closing = 14.8 - 2000 / spec.closing_spring.coil.rate * 1e3
    control = 70.1 - float(clutch.control_force) / spec.control_spring.coil.rate * 1e3
    assert length_of(parts_of(sizes_of(clutch))) * 1e3 == pytest.approx(16 + 24 + 8 + closing + 8 + control + 8)


TOLD = [
    ("envelope.outer_diameter", 0.25, "housing-too-wide", 0.252),
    ("envelope.length", 0.065, "clutch-too-long", 0.066),
    ("control_unit.ball_circle_radius", 0.064, "parts-collide", 0.064 + 0.013 - 0.074),
]


@pytest.mark.parametrize(("key", "given", "code", "value"), TOLD)
def test_a_check_names_what_is_missing(key, given, code, value):
    result, findings = check(build(respecified(direct(), {key: given})))
    (found,) = (remark for remark in findings if remark.code == code)
    assert found.value == pytest.approx(value)
    assert not result.passed
    if code != "parts-collide":
        assert any(row.grade == "fail" and row.value == pytest.approx(value) for row in result.checks)


ODD = {"friction_group.pairs": 4}


def test_a_spring_outside_the_housing_and_pairs_that_are_odd():
    """Discs of 301 by 333 mm around a housing of 252 mm: 40.5 mm too wide; five pairs end in a disc beside its plate."""
    disc = {"outer_diameter": 0.333, "inner_diameter": 0.301, "thickness": 3e-3, "free_height": 4e-3}
    _, findings = check(build(respecified(direct(), {"closing_spring.disc": disc})))
    (found,) = (each for each in findings if each.code == "parts-collide")
    assert found.message == "housing and closing spring are in each other's way by 40.5 mm"
    assert "odd-pairs" in {each.code for each in findings}
    assert "odd-pairs" not in {each.code for each in check(build(respecified(direct(), ODD)))[1]}


@pytest.mark.parametrize("unit", [{}, {"control_unit.ball_diameter": 0.02, **ODD}, {"friction_group.pairs": 12}])
def test_the_room_that_is_left_is_that_of_the_layout(unit):
    """A spring exceeds its room exactly if in the layout it collides with a part, or the clutch is too long."""
    rng, seen, plain = np.random.default_rng(36), set(), respecified(direct(), {"envelope.length": 0.12, **unit})
    for _ in range(30):
        wire, wide, force = rng.uniform(4e-3, 8e-3), rng.uniform(0.03, 0.25), rng.uniform(1, 20)
        free = 4 * wire + 2 * (0.0015 * wide**2 / wire + 0.1 * wire) + rng.uniform(1e-3, 0.06)
        coil = {"wire_diameter": wire, "coil_diameter": wide, "turns": 2, "free_length": free}
        spec = respecified(plain, {"closing_spring.coil": coil, "closing_spring.force": force})
        clutch = build(spec)
        parts, room = parts_of(sizes_of(clutch)), spring_demands(clutch)[0].room
        in_way = any(missing > 1e-9 for *pair, missing in overlaps(parts) if "closing spring" in pair)
        outer, inner = wide + wire, wide - wire
        set_at = free - force / spec.closing_spring.coil.rate
        across = inner >= room.inner_diameter and outer <= room.outer_diameter
        assert (across, set_at <= room.length + 1e-9) == (not in_way, length_of(parts) <= 0.12 + 1e-9)
        seen.add((across, set_at <= room.length))
    assert len(seen) >= 3


def test_a_space_that_is_none():
    """Invalid are a hub narrower than its bore, a housing narrower than the hub, and an envelope without plates."""
    for key, given in (("hub_diameter", 0.02), ("outer_diameter", 0.03), ("plate_thickness", None)):
        envelope = direct().envelope.model_dump(exclude_none=True) | {key: given}
        with pytest.raises(SpecError, match=f"envelope.{key}"):
            direct(envelope={name: value for name, value in envelope.items() if value is not None})


SWEPT = [
    *(f"envelope.{name}" for name in ("bore", "hub_diameter", "disc_thickness", "plate_thickness", "housing_wall")),
    *(f"closing_spring.disc.{name}" for name in ("outer_diameter", "inner_diameter", "thickness", "series")),
    *(f"control_unit.{name}" for name in ("balls", "ball_diameter", "ball_circle_radius", "face_gap")),
    *(f"friction_group.{name}" for name in ("pairs", "inner_radius", "outer_radius")),
]


def test_the_inertia_of_swept_sizes_is_that_of_each():
    spec = read_spec("example:conveyor-clutch", ["envelope.bore=0.038"])
    for key in SWEPT:
        value = value_at(spec, key)
        values = [value, value + 2 if isinstance(value, int) else 1.01 * value]
        swept = inertias_of(build(with_values(spec, {key: np.array(values)})))
        alone = [inertias_of(build(respecified(spec, {key: one}))) for one in values]
        for place, one in enumerate(swept):
            assert np.broadcast_to(one, 2) == pytest.approx([each[place] for each in alone], rel=1e-12), key
