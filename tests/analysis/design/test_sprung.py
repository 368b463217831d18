"""A design of clutches whose springs exist, against every stack of every size tried on every candidate."""

import functools
import itertools

import numpy as np
import pytest
from conftest import several

from afmcalc.analysis.clutch_findings import clutch_findings
from afmcalc.analysis.design import pick
from afmcalc.analysis.design.design import design
from afmcalc.analysis.design.pick import with_picked
from afmcalc.analysis.springs.springs import springs
from afmcalc.analysis.synthesize import synthesize
from afmcalc.engines import build
from afmcalc.engines.springs import DiscCharacteristic
from afmcalc.errors import SpecError
from afmcalc.spec.catalogues import discs
from afmcalc.spec.edit import with_values
from afmcalc.spec.lists import diameters
from afmcalc.spec.models import DiscStack
from afmcalc.spec.requirements import make_requirements

FRICTION = {"min": 0.1, "mean": 0.3, "max": 0.8}
CLOSING = {"inner_diameter": 0.02, "outer_diameter": 0.08, "length": 0.08}
NARROW = {"inner_diameter": 0.04, "outer_diameter": 0.082, "length": 0.004}
CONTROL = {"inner_diameter": 0.05, "outer_diameter": 0.2}
SHAPE = ("outer_diameter", "inner_diameter", "thickness", "reduced_thickness", "free_height")
INDIRECT = {
    "pairs": [6, 8],
    "mean_radius": [0.08, 0.1, 0.12],
    "gain": [0.8, 1.2],
    "ball_circle_radius": [0.04, 0.05],
    "closing_stiffness": [2e5, 4e5, 8e5],
    "control_stiffness": [0.0, 1e5, 3e5],
}
DIRECT = {
    "pairs": [4, 6, 8, 10],
    "mean_radius": np.linspace(0.05, 0.15, 21).tolist(),
    "gain": [0.3, 0.6, 1.0],
    "ball_circle_radius": [0.05],
}


def wanted(variant="indirect", search=INDIRECT, objectives=("closing_force", "accuracy_factor", "travel"), **fixed):
    return {
        "variants": [variant],
        "objectives": list(objectives),
        "springs": "disc",
        "friction": FRICTION,
        "wanted": {"nominal_torque": 150.0},
        "limits": {"gain_limit": False},
        "search": {**search, "closing_force": {"min": 100.0, "max": 1e5}},
        "fixed": {
            **({"hub_diameter": 0.05, "key_friction": 0.01, "control_room": CONTROL} if variant == "indirect" else {}),
            "closing_room": CLOSING,
            **fixed,
        },
    }  # fmt: skip


@functools.cache
def packs(inner, outer):
    """Cone height and characteristic of a pack of every size that has the room."""
    found = []
    for size, parallel in itertools.product(discs(), range(1, 7)):
        if inner <= size.inner_diameter and size.outer_diameter <= outer:
            own = DiscCharacteristic(DiscStack(**{name: getattr(size, name) for name in SHAPE}, parallel=parallel))
            found.append((size.cone_height, own))
    return found


def sprung(force, stiffness, room, relaxes=0.0, compresses=0.0):
    """Whether any stack of any size, of 1 to 300 packs, gives this."""
    series = np.arange(1, 301)
    for cone, own in packs(room["inner_diameter"], room["outer_diameter"]):
        each = float(own.deflection(force))
        if own.force(each) < force * (1 - 1e-9):
            continue
        good = (each - relaxes / series >= 0.15 * cone) & (each + compresses / series <= 0.75 * cone)
        if stiffness is not None:
            good &= np.abs(float(own.stiffness(each)) / series - stiffness) <= 0.1 * stiffness
        good &= series * (own.free_length - each) + relaxes <= room.get("length", np.inf)
        if good.any():
            return True
    return False


def clutch_of(need, values):
    """The clutch of one candidate, its spring set for the torque."""
    sleeve = need.variants == ("indirect",)
    springs_of = {"closing_spring": {}, "control_spring": {}} if sleeve else {"closing_spring": {}}
    for name, block in springs_of.items():
        if sleeve:
            block["stiffness"] = values[name.replace("_spring", "_stiffness")]
    return build(
        {
            "variant": need.variants[0],
            "friction": FRICTION,
            "friction_group": {"pairs": values["pairs"], "mean_radius": values["mean_radius"]},
            **springs_of,
            "control_unit": {
                "gain": values["gain"], "ball_circle_radius": values["ball_circle_radius"], "balls": 6,
                "face_gap": 0.002, "edge_clearance": 0.002,
                **({"hub_diameter": 0.05, "key_friction": 0.01} if sleeve else {}),
            },
            "adjustment": {"nominal_torque": 150},
        }
    )  # fmt: skip


def exists(clutch, need):
    closing, spec = need.fixed.closing_room.model_dump(exclude_none=True), clutch.spec
    if spec.control_spring is None:
        return sprung(clutch.closing_force, None, closing)
    travel = clutch.at(0.8)["travel"]
    return (
        spec.control_spring.stiffness > 0
        and sprung(clutch.closing_force, spec.closing_spring.stiffness, closing, relaxes=travel)
        and sprung(clutch.control_force, spec.control_spring.stiffness, CONTROL, compresses=travel)
    )


def rounded(*values):
    return tuple(float(f"{value:.7g}") for value in values)


def brute(need, search):
    """Objectives of every candidate whose springs and ball exist."""
    for values in (dict(zip(search, each, strict=True)) for each in itertools.product(*search.values())):
        clutch = clutch_of(need, values)
        found, _ = synthesize(clutch)
        hub = clutch.spec.control_unit.hub_diameter or 0.0
        # the smallest ball that reaches and bears: there is one beside the hub, or none
        balls = (
            synthesize(build(with_values(clutch.spec, {"control_unit.ball_diameter": each})))[1]
            for each in diameters()
            if each >= 2 * found.ball_radius and hub <= 2 * values["ball_circle_radius"] - each
        )
        if all(any(each.level == "error" for each in findings) for findings in balls) or not exists(clutch, need):
            continue
        own = {
            "closing_force": float(clutch.pack_force_at_rest),
            "accuracy_factor": float(clutch.accuracy_factor),
            "travel": found.travel_max,
            "pairs": values["pairs"],
        }
        yield rounded(*(own[name] for name in need.objectives))


@pytest.mark.every(2)
@pytest.mark.parametrize(
    "data",
    [
        wanted(),
        # sizes of one diameter, in short: forces that no stack holds lie between those of the next
        wanted("all-driving", DIRECT, ("closing_force", "accuracy_factor", "pairs"), closing_room=NARROW),
    ],
    ids=["indirect", "all-driving"],
)
def test_the_front_is_that_of_the_clutches_with_springs(data):
    need = make_requirements(data)
    search = INDIRECT if data["variants"] == ["indirect"] else DIRECT
    good = list(brute(need, search))
    best = {
        one
        for one in good
        if not any(all(a <= b for a, b in zip(other, one, strict=True)) and other != one for other in good)
    }
    result, _ = design(need)
    assert result.feasible == len(good)
    assert 1 < len(best) < len(good)
    assert {rounded(*(row.objective(name) for name in need.objectives)) for row in result.front} == best
    assert len(good) < 0.6 * result.candidates
    unsprung, _ = design(make_requirements(data | {"springs": None, "fixed": without_rooms(data["fixed"])}))
    there = {rounded(*(row.objective(name) for name in need.objectives)) for row in unsprung.front}
    assert best - there, "not the front of all, filtered"


def without_rooms(fixed):
    return {name: value for name, value in fixed.items() if not name.endswith("_room")}


def test_springs_finds_the_springs_of_every_clutch_proposed():
    """Refined clutches too, which lie between the grid points."""
    radii, stiffnesses, gains = several((4, 4, 4), (5, 5, 6))
    ranges = {
        "mean_radius": {"start": 0.08, "stop": 0.12, "count": radii},
        "closing_stiffness": {"start": 1e5, "stop": 8e5, "count": stiffnesses},
        "gain": {"start": 0.6, "stop": 2.0, "count": gains},
    }
    need = make_requirements(wanted(search={**INDIRECT, **ranges}))
    result, _ = design(need)
    assert result.on_front > 3
    for number in range(1, result.on_front + 1):
        chosen, spec = with_picked(need, result, number)
        (row,) = chosen.picked
        told, findings = springs(build(spec), kind="disc", top=1000)
        assert told.closing_found
        assert told.control_found
        assert "no-spring" not in {each.code for each in findings}
        named = {f"{each.part}, {each.parallel}" for each in (*told.closing, *told.control)}
        assert {part.partition(" ×")[0] for part in (row.closing_part, row.control_part)} <= named
        clutch = build(spec)
        assert clutch.accuracy_factor == row.accuracy_factor_sprung
        assert clutch.control_force == row.control_force
        assert 150 * (1 - 1e-12) <= clutch.nominal_torque < 150.2
        said = clutch_findings(clutch.spec, clutch.quantities)
        assert not [each for each in said if each.level == "error"]
        # with discs the sleeve travels a little farther than with the straight springs that were searched
        strays = [each.value for each in said if each.code == "spring-beyond-range"]
        assert strays == pytest.approx([0.15 if each < 0.4 else 0.75 for each in strays], rel=0.05)


def test_what_disc_springs_make_of_a_bound_is_said():
    need = make_requirements(wanted() | {"wanted": {"nominal_torque": 150.0, "torque_max": 480.0}})
    result, findings = design(need)
    beyond = [row for row in result.front if row.torque_max_sprung > 480]
    assert [each.code for each in findings] == (["springs-miss"] if beyond else [])


@pytest.mark.parametrize(
    ("fixed", "says"),
    [
        ({"closing_room": None}, "fixed.closing_room = null: required with springs"),
        ({"control_room": {"outer_diameter": 0.1}}, "fixed.control_room: required with springs"),
        ({"pocket": "constant-torque"}, "springs = .*: excludes fixed.pocket"),
    ],
)
def test_missing_room(fixed, says):
    with pytest.raises(SpecError, match=says):
        make_requirements(wanted(**fixed))
    with pytest.raises(SpecError, match="has no effect without springs"):
        make_requirements(wanted() | {"springs": None})


def test_clutches_that_fail_with_every_stack_are_left_out(monkeypatch):
    """Not on the front, and counted: those that press their pack with more than 4.5 kN."""
    need = make_requirements(wanted())
    before = design(need)[0].front
    heavy = [row for row in before if row.pack_force_at_rest > 4500]
    assert 0 < len(heavy) < len(before)

    def heavy_fails(clutch, **_):
        return pick.Judgement(("heavy",) * (clutch.pack_force_at_rest > 4500), {})

    monkeypatch.setattr(pick, "judgement_of", heavy_fails)
    result, findings = design(need)
    assert [row.pack_force_at_rest for row in result.front] == [r.pack_force_at_rest for r in before if r not in heavy]
    assert [row.number for row in result.front] == list(range(1, len(result.front) + 1))
    assert result.excluded["springs"] == len(heavy)
    assert "springs-miss" in {each.code for each in findings}
