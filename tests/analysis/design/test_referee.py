"""The front of a random search against brute force: every candidate written as a spec, and given to a check by itself."""

import copy
import itertools
import json
import math
from dataclasses import dataclass, field
from random import Random

import pytest

from afmcalc import SpecError, load

DIRECT = ["conventional", "differentiated", "all-driving"]
OBJECTIVES = ["closing_force", "accuracy_factor", "pairs", "ball_diameter", "travel", "control_force", "closing_deflection",
              "control_deflection"]  # fmt: skip
MOST = {"trip": 6, "event": 5, "scatter": 6, "sprung": 10, "curved": 10}
"""Candidates of a search whose check takes longer; of others 20."""
AT_LEAST = {"trips_per_hour", "torque_after_wear", "cycles"}
"""Required at least; all others at most."""
SHAPES = {"surface_pressure", "outer_diameter", "reduced_gain"}
"""What springs that exist leave as it is."""
UNDER_LIMITS = {*SHAPES, "travel"}
HOUSING = {"length": "envelope.length", "housing_diameter": "envelope.outer_diameter"}
LARGER_BALL = {"ball-too-small", "contact-force-exceeded"}
"""Errors that a larger ball may put right."""
LININGS = {"material": "friction.material", "driving_material": "friction.driving.material"}
HEAT = {"disc_mass": 0.8, "specific_heat": 480.0, "ambient": 313.15, "cooling": 5.0, "lining": 1e-4}
DRIVE = {"speed": 150.0, "motor_inertia": 0.02, "driven_inertia": 0.01, "shaft_stiffness": 8000.0, "load_torque": 60.0,
         "motor_torque": 60.0, "cut_off": 0.01}  # fmt: skip
FATIGUE = {"endurance_limit": 4e7, "polar_section_modulus": 3e-6, "exponent": 6, "base_cycles": 1e7}
FORCE = {"distribution": "normal", "spread": 0.02}
FIELDS = {"friction": {"distribution": "uniform"}, "closing_spring.force": FORCE}
TOLERANCE = {"samples": 1000, "sobol_base": 64, "seed": 1, "fields": FIELDS}
DISCS = """name,outer_diameter_mm,inner_diameter_mm,thickness_mm,free_height_mm,source
A 60,60,30.5,1.5,3.5,works
B 80,80,41,3,5.3,works
C 80,80,41,2.25,5.2,works
D 100,100,51,3.5,6.3,works
E 125,125,64,4,8.5,works
"""


@dataclass
class Space:
    """A search: what every candidate has, as a spec has it, and the values to choose from, by the key of a spec."""

    variants: list
    objectives: list
    spec: dict
    axes: dict
    wanted: dict
    balls: list
    width: float | None = None  # of the faces, where the mean radius is searched
    forces: list | None = None  # of the closing springs that there are; None: any force
    springs: str | None = None
    gain_limit: bool = True
    counted_by: dict = field(default_factory=dict)  # limits that other requirements are counted by: they stay
    pressed: bool = True  # whether the contact pressure may be limited: then each ball is a candidate of its own


def put(spec, path, value):
    *blocks, name = path.split(".")
    for block in blocks:
        spec = spec.setdefault(block, {})
    spec[name] = value


def without_none(data):
    return {key: without_none(value) for key, value in data.items() if value is not None} if isinstance(data, dict) else data  # fmt: skip


def rounded(values):
    return tuple(float(f"{value:.8g}") for value in values)


def designed(run, space, limits, *options, between=False):
    """Write a search as requirements, its lists as ranges where ``between``, and return what ``design`` answers."""
    spec, limits, search = copy.deepcopy(space.spec), space.counted_by | limits, {"ball_diameters": space.balls}
    unit, rooms = spec.pop("control_unit"), [spec.pop(f"{name}_spring", {}).get("room") for name in ("closing", "control")]  # fmt: skip
    if space.forces is None:
        search["closing_force"] = {"min": 1e-3, "max": limits.pop("closing_force", 1e9)}
    else:
        search["closing_forces"] = space.forces
    for path, values in space.axes.items():
        (block, _, name), choice = path.partition("."), values
        if block == "friction":
            put(spec, path, values)
            continue
        if between and len(values) > 1 and "pairs" not in name:
            choice = {"start": min(values), "stop": max(values), "count": len(values)}
        search[f"{block.removesuffix('_spring')}_stiffness" if name == "stiffness" else name] = choice
    for name in limits.keys() & HOUSING.keys():
        put(spec, HOUSING[name], limits.pop(name))
    held = {"gain_limit": space.gain_limit, "contact_force": unit.pop("allowable_contact_force", None)}
    need = spec | {
        "variants": space.variants, "objectives": space.objectives, "springs": space.springs, "search": search,
        "wanted": space.wanted | {name: limit for name, limit in limits.items() if name not in UNDER_LIMITS},
        "limits": held | {name: limit for name, limit in limits.items() if name in UNDER_LIMITS},
        "fixed": unit | {"face_width": space.width, "closing_room": rooms[0], "control_room": rooms[1]},
    }  # fmt: skip
    answer = run("design", "-", "--json", "--yes", *options, stdin=json.dumps(without_none(need)))
    assert answer.code == 0 or not answer.json["result"]["front"], answer.err
    return answer.json


def objective(row, name):
    if name == "closing_force":
        return row.get("pack_force_at_rest") or row["closing_force"]
    if name == "control_deflection" and row.get("control_stiffness") == 0:
        return 1e99
    return row.get(name) or 0.0


def front_of(space, result):
    """Of each clutch on the front its variant and linings, and its objectives."""
    names = ["variant", *(name for name, path in LININGS.items() if path in space.axes)]
    values = [rounded(objective(row, name) for name in space.objectives) for row in result["front"]]
    return [(tuple(row[name] for name in names), each) for row, each in zip(result["front"], values, strict=True)]


def candidates(space):
    """Variant, linings and spec of every candidate, its ball yet to be chosen."""
    torque, method, margin = space.wanted.get("nominal_torque"), space.wanted["method"], space.wanted["margin"]
    if torque is None:  # S22: between clutch and machine; S19: in the spring
        torque = space.wanted["machine_torque"] * (margin if method == "min-friction" else 1)
    for variant in space.variants:
        axes = {path: values for path, values in space.axes.items() if has(variant, path)}
        for values in itertools.product(*axes.values()):
            spec = copy.deepcopy(space.spec) | {"variant": variant}
            for path, value in zip(axes, values, strict=True):
                put(spec, path, value)
            if variant == "conventional":
                del spec["control_unit"]
            if space.width is not None:
                radius = spec["friction_group"].pop("mean_radius")
                spec["friction_group"] |= {"inner_radius": radius - space.width / 2, "outer_radius": radius + space.width / 2}  # fmt: skip
            spec["adjustment"] = {"method": method, "margin": margin, "nominal_torque": torque}
            loose = {name: 0.999 if name == "exceedance" else 1e-9 if name in AT_LEAST else 1e12 for name in told_of(spec)}  # fmt: skip
            spec["requirements"] = loose | space.counted_by
            yield (variant, *(value for path, value in zip(axes, values, strict=True) if "material" in path)), spec


def has(variant, path):
    """Whether a variant has a key of the search."""
    if path == "friction_group.driving_pairs":
        return variant == "differentiated"
    if path == "control_spring.stiffness":
        return variant == "indirect"
    return variant != "conventional" or not path.startswith("control_unit.")


def told_of(spec):
    """Requirements that a check can tell of a candidate."""
    heat = spec.get("heat", {})
    return itertools.chain(
        ["accuracy_factor", "accuracy_factor_hysteresis", "torque_max"],
        ["surface_pressure", "outer_diameter"] * ("inner_radius" in spec["friction_group"]),
        ["reduced_gain", "contact_pressure"] * ("control_unit" in spec), ["travel"] * (spec["variant"] == "indirect"),
        ["cycles"] * ("fatigue" in spec), ["torque_after_wear"] * ("lining" in heat), ["face_temperature"] * ("density" in heat),
        ["work", "temperature", "trips_per_hour"] * ("disc_mass" in heat),
        ["peak_torque"] * ("event" in spec.get("drive", {})), ["exceedance"] * ("tolerance" in spec),
    )  # fmt: skip


def judged(space, spec):
    """What a candidate has, once for each ball with which a check finds nothing wrong."""
    try:
        clutch = load(spec)
        if space.forces is not None:
            wanted = clutch.torque().closing_force * (1 - 1e-9)
            put(spec, "closing_spring.force", min((force for force in space.forces if force >= wanted), default=None))
            if spec["closing_spring"]["force"] is None:
                return
            del spec["adjustment"]["nominal_torque"]
            clutch = load(spec)
    except SpecError:
        return
    if space.springs is not None:
        found = clutch.springs(kind=space.springs)
        if not found.closing_found or found.control_found == 0:
            return
    unit = spec.get("control_unit", {})
    steep = unit.get("gain") or unit.get("wall_angle")
    for ball in space.balls if steep else [None]:
        if steep:
            unit["ball_diameter"] = ball
        else:
            spec["requirements"].pop("contact_pressure", None)
        clutch = load(spec)
        check = clutch.check()
        wrong = {
            each.code for each in check.findings
            if each.level == "error" or each.code.endswith("-pressure-in-range") or (space.gain_limit and each.code.endswith("gain-above-limit"))
        }  # fmt: skip
        if not wrong:
            yield values_of(clutch, check, spec, ball)
        if not wrong - LARGER_BALL and (wrong or space.pressed):
            continue
        return


def values_of(clutch, check, spec, ball):
    """Objectives and what there are limits of."""
    torque, values = clutch.torque(), {row.requirement: row.value for row in check.requirements}
    closing, control = (spec.get(f"{name}_spring", {}).get("stiffness") for name in ("closing", "control"))
    return values | {
        "pairs": spec["friction_group"]["pairs"],
        "closing_force": torque.closing_force if control is None else torque.control_force,
        "ball_diameter": ball or 0.0,
        "travel": values.get("travel") or 0.0,
        "control_force": torque.control_force or 0.0,
        "closing_deflection": 0.0 if control is None else torque.closing_force / closing,
        "control_deflection": 0.0 if control is None else torque.control_force / control if control else 1e99,
        "length": clutch.layout().length if "envelope" in spec else None,
        "housing_diameter": clutch.layout().outer_diameter if "envelope" in spec else None,
    }


def missed(values, limits):
    """Names of the limits that a candidate is beyond."""
    signs = {name: -1 if name in AT_LEAST else 1 for name in limits if values.get(name) is not None}
    return {name for name, sign in signs.items() if sign * values[name] > sign * limits[name] * (1 + sign * 1e-12)}


def middling(rng, name, good):
    """A limit between two values that there are, or beyond them all."""
    least = name in AT_LEAST
    values = sorted({values[name] for _, _, values in good if values.get(name) is not None}, reverse=least)
    gaps = [pair for pair in itertools.pairwise(values) if abs(pair[1] - pair[0]) > 1e-6 * abs(pair[0])]
    if not gaps or rng.random() < 0.15:
        return values[-1] / 1.5 if least else values[-1] * 1.5
    return sum(gaps[int(rng.triangular(0, len(gaps), 0.9 * len(gaps)))]) / 2


def random_limits(rng, space, good, favoured=()):
    """Limits of some of what a check tells, of all that is favoured, most of which exclude a part of the candidates."""
    names = {name for _, _, values in good for name, value in values.items() if value}
    names -= {*OBJECTIVES, *space.counted_by, *["contact_pressure"] * (not space.pressed)}
    names |= {"accuracy_factor", *["closing_force"] * (space.forces is None), *["travel"] * (space.variants == ["indirect"])}  # fmt: skip
    names &= SHAPES if space.springs and space.variants == ["indirect"] else names
    chosen = {*rng.sample(sorted(names), rng.randint(1, min(4, len(names)))), *names & {*favoured}}
    return {name: middling(rng, name, good) for name in sorted(chosen)}


def best_of(points):
    beaten = lambda one, by: by != one and all(a <= b for a, b in zip(by, one, strict=True))  # noqa: E731
    return {one for one in points if not any(beaten(one, other) for other in points)}


def space_of(kind, rng, discs):
    """A search of a kind; what the kind leaves open is drawn."""
    some = lambda low, high, count: sorted(round(rng.uniform(low, high), 4) for _ in range(count))  # noqa: E731
    chance = lambda share: rng.random() < share  # noqa: E731
    travels = kind in ("indirect", "curved") or (kind == "sprung" and chance(0.5))
    variants = ["indirect"] if travels else ["differentiated"] if kind == "unlike" else rng.sample(DIRECT, rng.randint(2, 3))  # fmt: skip
    both, angle = chance(0.4), chance(0.4) and kind != "curved"
    axes = {"friction_group.pairs": rng.sample([4, 6, 8, 10], 2)}
    if "differentiated" in variants:
        axes["friction_group.driving_pairs"] = [1, 3]
    if both:
        axes |= {"friction_group.inner_radius": some(0.05, 0.07, 1), "friction_group.outer_radius": some(0.09, 0.13, 3)}
    else:
        axes["friction_group.mean_radius"] = some(0.07, 0.12, 3)
    steering = "control_unit.wall_angle" if angle else "control_unit.gain"
    steep = 4.0 if kind == "unlike" else 2.0
    axes[steering] = some(0.15, 0.7, 4) if angle else [*some(0.2, steep, 3), rng.choice([0.0, 1.0])]
    axes["control_unit.ball_circle_radius"] = some(0.035, 0.06, 1 if len(variants) > 1 else 2)
    spec = {"friction": friction(kind, rng, axes)}
    unit = spec["control_unit"] = {"balls": rng.randint(5, 9), "face_gap": 5e-4, "edge_clearance": 1e-3}
    if chance(0.25):
        unit["allowable_contact_force"] = rng.uniform(1500, 4000)
    if travels:
        unit |= {"hub_diameter": 0.06, "key_friction": 0.02}
        axes |= {"closing_spring.stiffness": some(1e5, 8e5, 2), "control_spring.stiffness": [0.0, *some(5e4, 3e5, 1)]}
    if kind == "curved":
        unit["pocket"] = "constant-torque"
    if kind == "sprung":
        spec["catalogues"] = {"discs": str(discs)}
        for name in ("closing_spring", "control_spring") if travels else ("closing_spring",):
            put(spec, f"{name}.room", {"inner_diameter": 0.03, "outer_diameter": 0.15, "length": rng.uniform(0.02, 0.2)})  # fmt: skip
    counted_by = service(kind, rng, spec, axes, travels) if kind not in ("sprung", "curved") else {}
    width = None if both else rng.uniform(0.015, 0.03)
    if kind != "sprung" and chance(0.3):
        spec["envelope"] = {"disc_thickness": 0.003, "plate_thickness": 0.008, "housing_wall": 0.006, "bore": 0.03}
        spec["envelope"] |= {} if travels else {"hub_diameter": 0.055}
    elif kind in ("direct", "unlike", "indirect") and chance(0.3):
        width = None
    thin(rng, variants, axes, MOST.get(kind, 20))
    fixed = ["closing_force", "ball_diameter" if kind == "curved" else "accuracy_factor"]
    others = sorted({*OBJECTIVES[: None if travels else 4]} - {*fixed})
    objectives = [*fixed, *rng.sample(others, 2 if travels else rng.randint(0, 1))]
    wanted = {"method": rng.choice(["min-friction", "mean-friction"]), "margin": rng.uniform(1.0, 1.4)}
    wanted[rng.choice(["nominal_torque", "machine_torque"])] = rng.uniform(80, 200)
    return Space(
        variants, rng.sample(objectives, len(objectives)), spec, axes, wanted, [0.03] if MOST.get(kind, 20) < 10 else rng.choice([[0.012, 0.02], [0.01, 0.0127, 0.03]]),
        width, some(300, 12000, 12) if chance(0.25) else None, "disc" if kind == "sprung" else None, chance(0.3 if kind == "unlike" else 0.7), counted_by, chance(0.4),
    )  # fmt: skip


def thin(rng, variants, axes, most):
    """Leave out values until the candidates are few: each costs a check or two."""
    while sum(math.prod(len(axes[path]) for path in axes if has(variant, path)) for variant in variants) > most:
        longest = max(map(len, axes.values()))
        values = axes[rng.choice([path for path in axes if len(axes[path]) == longest])]
        del values[rng.randrange(len(values))]


def friction(kind, rng, axes):
    """Of a range, of linings to choose from, of one of several that is not known, of unlike groups."""
    low, linings = rng.uniform(0.1, 0.25), rng.sample(["moulded-dry", "woven-dry", "sintered-dry", "cork-dry"], 2)
    own = {"min": low, "mean": 1.5 * low, "max": low * rng.uniform(1.8, 4)}
    if kind == "unlike":
        # beyond its gain limit the torque may be largest where neither is at its end: much of the one, little of the other
        driving = {"min": 0.1, "mean": rng.uniform(0.3, 0.4), "max": 0.4}
        if rng.random() < 0.4:
            axes["friction.driving.material"], driving = linings, {}
        return {"driving": driving, "driven": own | {"mean": low * rng.uniform(1.0, 1.5)}}
    if rng.random() < 0.6:
        return own
    if rng.random() < 0.3:
        return {"material": linings, "unknown": True}
    axes["friction.material"] = linings
    return {}


def service(kind, rng, spec, axes, travels):
    """Add blocks by which service is judged, and return the limits that something is counted by."""
    trips = kind in ("trip", "event")
    if trips:
        spec["heat"], spec["drive"] = dict(HEAT), dict(DRIVE)
    elif rng.random() < 0.3:
        spec["heat"] = {"lining": 2e-4}
    if kind == "event":  # without it the clutch blocks, and no face is asked for, which takes long
        spec["heat"] |= {"conductivity": 50.0, "density": 7850.0}
        spec["drive"]["event"] = {"kind": "stop", "stop_time": 0.01}
    if "heat" in spec and not travels:
        axes["closing_spring.stiffness"] = [1e5]
    if kind == "scatter":
        spec["tolerance"] = TOLERANCE
    if rng.random() < 0.3:
        spec["fatigue"] = FATIGUE
    elif rng.random() < 0.3:
        spec["shaft"] = {"diameter": rng.uniform(0.02, 0.03), "yield_strength": 3.5e8}
    return {"torque_max": 400.0} if kind == "scatter" else {"temperature": 800.0} if trips else {}


STRAIGHT = ("direct", "unlike", "indirect", "curved")
SEEDS = {"direct": [0, 5], "unlike": [1, 2, 6], "indirect": [2, 7], "curved": [15], "sprung": [2], "trip": [2]}
MORE = {
    "direct": [1, 3, 4, 6, 8, 10, 11], "unlike": [0, 3, 4, 5], "indirect": [1, 3, 4, 9, 10, 11, 13, 14], "curved": [3, 11, 23],
    "sprung": [0, 6, 9, 13], "trip": [0, 4, 5], "event": [2], "scatter": [1, 3],
}  # fmt: skip
"""Searches of each kind that have feasible candidates."""
CASES = [(kind, seed) for kind, seeds in SEEDS.items() for seed in seeds]
SLOW = [pytest.param(kind, seed, marks=pytest.mark.slow) for kind, seeds in MORE.items() for seed in seeds]


@pytest.mark.parametrize(("kind", "seed"), [*CASES, *SLOW])
def test_the_front_is_that_of_all_that_pass_a_check(kind, seed, afmcalc, tmp_path):
    (tmp_path / "discs.csv").write_text(DISCS, encoding="utf-8")
    rng = Random(f"{kind} {seed}")
    space = space_of(kind, rng, tmp_path / "discs.csv")
    every = list(enumerate(candidates(space)))
    good = [(number, which, values) for number, (which, spec) in every for values in judged(space, spec)]
    assert good
    for turn in range(4):
        limits = random_limits(rng, space, good, AT_LEAST if turn == 0 else ())
        held = [one for one in good if not missed(one[2], limits)]
        points = {(which, rounded(values[name] for name in space.objectives)) for _, which, values in held}
        result = designed(afmcalc, space, limits, *["--misses"] * (turn == 0))["result"]
        front = front_of(space, result)
        assert {point for _, point in front} == best_of({point for _, point in points})
        assert len(front) == result["on_front"] == len({point for _, point in front})
        assert set(front) <= points
        assert result["feasible"] - (result["unasked"] or 0) <= numbers(held) <= result["feasible"]
        assert result["candidates"] == len(every) * len(space.forces or [0])
        if turn == 0 and kind in STRAIGHT and "contact_pressure" not in limits:  # a larger ball would have less
            the_nearest_misses_are_the_nearest(limits, good, result)
    if kind != "event":
        the_pick_is_what_its_file_says(afmcalc, rng, space, limits if held else {})


def numbers(some):
    return len({number for number, *_ in some})


def the_nearest_misses_are_the_nearest(limits, good, result):
    """Of the candidates that miss nothing else; relaxed as told, as many meet all as are told."""
    told = {row["requirement"]: row for row in result["attainable"] or [] if row["together"] is None}
    alone = {name: [values[name] for _, _, values in good if missed(values, limits) == {name}] for name in limits}
    assert told.keys() & limits.keys() == {name for name in alone if alone[name]}
    for name in told.keys() & limits.keys():
        row, way = told[name], -1 if name in AT_LEAST else 1
        assert row["best"] == pytest.approx(min(alone[name], key=lambda value: way * value), rel=1e-9)  # noqa: B023
        assert way * row["relax_to"] >= way * row["best"] * (1 - way * 1e-12)
        eased = limits | {name: row["relax_to"]}
        assert row["feasible"] == numbers(one for one in good if not missed(one[2], eased)) > result["feasible"]


def the_pick_is_what_its_file_says(run, rng, space, limits):
    """Between the grid points and in round figures: a check passes, and tells what the row does."""
    exact = rng.choice(designed(run, space, limits, between=True)["result"]["front"])
    answer = designed(run, space, limits, "--pick", exact["number"], between=True)
    (row,), clutch = answer["result"]["picked"], load(answer["spec"])
    check, torque = clutch.check(), clutch.torque()
    assert check.passed
    told = {each.requirement: each.value for each in check.requirements}
    assert limits.keys() - told.keys() <= {"closing_force", "travel", "reduced_gain", "contact_pressure", *HOUSING}
    told |= {name: getattr(torque, name) for name in ("nominal_torque", "closing_force", "control_force", "gain", "gain_slope")}  # fmt: skip
    same = {name: value for name, value in told.items() if value is not None and row.get(name) is not None}
    assert {name: row[name] for name in same} == pytest.approx(same, rel=1e-9)
    assert all(objective(row, name) <= objective(exact, name) * (1.005 + 1e-9) for name in space.objectives)
