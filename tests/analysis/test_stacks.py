"""What travel the stacks of a room give, against every stack of every size tried one by one."""

import itertools
from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from afmcalc.analysis.springs.candidates import held
from afmcalc.engines.springs import DiscCharacteristic
from afmcalc.spec.catalogues import discs
from afmcalc.spec.models import DiscStack, Room

NONE = -1.0
"""Travel where there is no stack, m."""
SHAPE = ("outer_diameter", "inner_diameter", "thickness", "reduced_thickness", "free_height")


@cache
def packs(inner, outer):
    """Cone height and characteristic of a pack of every size that has the room, of one to six discs."""
    sizes = [size for size in discs() if inner <= size.inner_diameter and size.outer_diameter <= outer]
    return [
        (
            size.cone_height,
            DiscCharacteristic(DiscStack(**{name: getattr(size, name) for name in SHAPE}, parallel=each)),
        )
        for size, each in itertools.product(sizes, range(1, 7))
    ]


def by_trying(room, force, stiffness, *, relaxes):
    """The largest travel of any stack of 1 to 10,000 packs; it lengthens down to 0.15 of the cone, or bends to 0.75."""
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


@given(
    st.sampled_from([(0.02, 0.06), (0.04, 0.1), (0.08, 0.2)]),
    st.one_of(st.none(), st.floats(0.005, 0.3)),
    st.floats(np.log(300), np.log(2e5)).map(np.exp),
    st.floats(np.log(5e4), np.log(2e7)).map(np.exp),
)
def test_the_travel_a_room_allows(across, length, force, stiffness):
    room = Room(inner_diameter=across[0], outer_diameter=across[1], length=length)
    for relaxes in (True, False):
        most = by_trying(room, force, stiffness, relaxes=relaxes)
        travels = np.array([max(most, 1e-6) * share for share in (1 - 1e-6, 1 + 1e-6)])
        service = {"relaxes" if relaxes else "compresses": travels}
        found = held("disc", discs(), room, np.full(2, force), np.full(2, stiffness), **service)
        assert found.tolist() == [most > 0, False]


@pytest.mark.parametrize(
    ("across", "length"), [((0.04, 0.082), None), ((0.04, 0.082), 0.02), ((0.0405, 0.0801), 6.03e-3)]
)
def test_the_forces_a_room_allows(across, length):
    """Of packs of one to six discs; where few sizes have the room, forces between them are not to be had."""
    room = Room(inner_diameter=across[0], outer_diameter=across[1], length=length)
    tried = [
        (float(own.force(low)), float(own.force(0.75 * cone)))
        for cone, own in packs(room.inner_diameter, room.outer_diameter)
        if (low := max(0.15 * cone, own.free_length - (length or np.inf))) <= 0.75 * cone
    ]
    forces = np.geomspace(100, 2e5, 500)
    assert held("disc", discs(), room, forces).tolist() == [
        any(low <= force <= high for low, high in tried) for force in forces
    ]


@pytest.mark.parametrize("share", [0.92, 0.95, 1.05])
def test_a_stiffness_may_be_a_tenth_off(share):
    """Of one or two packs, none of which is as stiff as asked."""
    room, kept = Room(inner_diameter=0.0405, outer_diameter=0.0801, length=None), []
    for (cone, own), part, number in itertools.product(packs(0.0405, 0.0801)[::6], (0.3, 0.5, 0.7), (1, 2)):
        force, stiffness = float(own.force(part * cone)), float(own.stiffness(part * cone)) / number * share
        found = held("disc", discs(), room, np.array([force]), np.array([stiffness])).item()
        assert found == (by_trying(room, force, stiffness, relaxes=True) > 0) or not found
        kept.append(found)
    assert all(kept)
