"""Fronts of random searches against brute force: every candidate written as a spec, and given to a check by itself."""

import copy
import itertools
import json
import math
import re
from random import Random

import numpy as np
import pytest
from conftest import overrides, slow
from hypothesis import given
from hypothesis import strategies as st
from sources import CLUTCHES, REFUSED

from afmcalc import Clutch, SpecError, load
from afmcalc.analysis.design import design as searched
from afmcalc.analysis.design import picked
from afmcalc.analysis.design_grid import unbeaten
from afmcalc.engines import build
from afmcalc.spec import make_spec
from afmcalc.spec.keys import MOVED, keys
from afmcalc.spec.read import put

DIRECT = ["conventional", "differentiated", "all-driving"]
BALLS = [0.008, 0.012, 0.016, 0.022, 0.03, 0.045]
EXCLUDING = {"gain-above-limit", "reduced-gain-above-limit", "feedback-idle"}
"""Warnings that exclude a candidate, and those of the pressure within the printed range."""
FOREIGN = {
    "conventional": ["control_unit", "friction_group.driving_pairs", "control_spring"],
    "differentiated": ["control_spring", "control_unit.hub_diameter", "control_unit.key_friction"],
    "all-driving": ["friction_group.driving_pairs", "control_spring", "control_unit.hub_diameter", "control_unit.key_friction"],
    "indirect": ["friction_group.driving_pairs"],
}  # fmt: skip
DISCS = """name,outer_diameter_mm,inner_diameter_mm,thickness_mm,free_height_mm,source
A 60,60,30.5,1.5,3.5,works
B 80,80,41,3,5.3,works
C 80,80,41,2.25,5.2,works
D 100,100,51,3.5,6.3,works
E 125,125,64,4,8.5,works
"""
HEAT = {"disc_mass": 0.8, "specific_heat": 480.0, "ambient": 313.15, "cooling": 5.0}
DRIVE = {"speed": 150.0, "motor_inertia": 0.02, "driven_inertia": 0.01, "shaft_stiffness": 8000.0, "load_torque": 60.0,
         "motor_torque": 60.0, "cut_off": 0.01, "event": {"kind": "stop", "stop_time": 0.01}}  # fmt: skip
SPACE = {"disc_thickness": 0.003, "plate_thickness": 0.008, "housing_wall": 0.006, "bore": 0.03}


def search_of(kind, rng, folder):
    """A random design file with some hundred candidates at most."""
    chance, some = lambda p: rng.random() < p, lambda low, high, n: sorted(rng.uniform(low, high) for _ in range(n))  # noqa: E731
    travels = kind in ("indirect", "curved")
    variants = ["indirect"] if travels else ["differentiated"] if kind == "unlike" else rng.sample(DIRECT, rng.randint(1, 3))  # fmt: skip
    variants.sort(
        key=["differentiated", "all-driving", "indirect", "conventional"].index
    )  # first the one with most keys
    low = rng.uniform(0.1, 0.25)
    own = {"min": low, "mean": 1.5 * low, "max": low * rng.uniform(1.8, 4)}
    material = not travels and kind != "unlike" and chance(0.3)
    driven = {"min": low, "mean": low * 1.2, "max": low * 2}
    friction = {"driving": own, "driven": driven} if kind == "unlike" else {"material": "moulded-dry"} if material else own  # fmt: skip
    controlled = variants != ["conventional"]
    search = {"friction_group.pairs": rng.sample([2, 4, 6, 8, 10], 2)}
    both = kind in ("envelope", "sprung") or chance(0.5)
    group = {"pairs": 8, **({"inner_radius": 0.07, "outer_radius": 0.1} if both else {"mean_radius": 0.09})}
    if both:
        search |= {"friction_group.inner_radius": some(0.05, 0.09, 2), "friction_group.outer_radius": some(0.08, 0.13, 2)}  # fmt: skip
    else:
        search["friction_group.mean_radius"] = some(0.07, 0.12, 2)
    if "differentiated" in variants:
        search["friction_group.driving_pairs"] = [1, 3]
    if controlled:
        steering = ("control_unit.wall_angle", 0.15, 0.7) if chance(0.4) else ("control_unit.gain", 0.15, 1.5)
        search[steering[0]] = [*some(*steering[1:], 3), *([0.0] if chance(0.3) else [])]
        search["control_unit.ball_circle_radius"] = some(0.03, 0.06, 1)
    if material and chance(0.7):
        search["friction.material"] = ["moulded-dry", "sintered-dry"]
    if len(variants) > 1 or chance(0.3):
        search["variant"] = variants
    data = {
        "variant": variants[0], "friction": friction, "friction_group": group, "search": search,
        "adjustment": {"nominal_torque": rng.uniform(80, 200), "method": rng.choice(["min-friction", "mean-friction"]), "margin": rng.uniform(1.0, 1.4)},
        "requirements": {}, "objectives": ["closing_force", *rng.sample(["accuracy_factor", "pairs", "torque_max", "ball_diameter" if controlled else "scatter", "-nominal_torque"], 2)],
        "catalogues": {"balls": str(folder / "balls.csv")},
    }  # fmt: skip
    if controlled:
        data["control_unit"] = {"balls": rng.randint(5, 9), "face_gap": 5e-4, "edge_clearance": 1e-3, steering[0].rpartition(".")[2]: 0.5}  # fmt: skip
        data["control_unit"]["ball_circle_radius"] = 0.05
        if chance(0.3):
            data["control_unit"]["allowable_contact_force"] = rng.uniform(1500, 6000)
    if travels:
        data["control_unit"] |= {"hub_diameter": 0.04, "key_friction": 0.05}
        data |= {"closing_spring": {"stiffness": 4e5}, "control_spring": {"stiffness": 1e5}}
        search["control_spring.stiffness"] = [0.0, *some(5e4, 3e5, 1)]
        data["objectives"].append("travel_max")
    if kind == "curved":
        data["control_unit"]["pocket"] = "constant-torque"
    if kind == "envelope":
        data["envelope"] = SPACE | {"outer_diameter": rng.uniform(0.2, 0.27), "length": rng.uniform(0.06, 0.1)}
        data["envelope"]["hub_diameter"] = 0.04
    if kind == "event":
        data |= {"heat": HEAT, "drive": DRIVE}
    if kind == "sprung":
        search["springs"] = "disc"
        data["catalogues"]["discs"] = str(folder / "discs.csv")
        put(data, "closing_spring.room", {"inner_diameter": 0.03, "outer_diameter": 0.15, "length": rng.uniform(0.02, 0.2)})  # fmt: skip
    most = {"event": 3, "sprung": 8}.get(kind, 24)
    while math.prod(len(values) for path, values in search.items() if path != "springs") > most:
        longest = max((values for path, values in search.items() if path != "springs"), key=len)
        del longest[rng.randrange(len(longest))]
    return data


def candidates(data):
    """Yield every candidate as plain data, once; candidates that differ in keys their variant lacks are the same."""
    axes = {path: values for path, values in data["search"].items() if path != "springs"}
    seen = []
    for values in itertools.product(*axes.values()):
        one = {name: value for name, value in copy.deepcopy(data).items() if name not in ("search", "objectives")}
        for path, value in zip(axes, values, strict=True):
            put(one, path, value)
        for path in FOREIGN[one["variant"]]:
            if path.partition(".")[0] in one:
                put(one, path, None)
        if one not in seen:
            seen.append(one)
            yield one


def passing(one, springs):
    """The clutch with the smallest ball and the first springs with which it passes a check; None if none passes."""
    unit = one.get("control_unit", {})
    balls = BALLS if unit.get("gain") or unit.get("wall_angle") else [None]
    for ball in balls:
        made = copy.deepcopy(one)
        if ball:
            made["control_unit"]["ball_diameter"] = ball
        try:
            clutches = [load(made)] if springs is None else with_springs(load(made), springs)
        except SpecError:
            return None
        for clutch in clutches:
            remarks = clutch.check().findings
            if not any(each.level == "error" or each.code in EXCLUDING or each.code.endswith("-pressure-in-range") for each in remarks):  # fmt: skip
                return clutch
    return None


def with_springs(clutch, kind):
    from afmcalc.analysis.spring_search import ranked
    from afmcalc.engines.parts import spring_demands

    (demand,) = spring_demands(clutch._engine)
    for option in ranked(demand, kind, 5):
        part = option.made.model_dump(exclude_none=True)
        yield clutch.with_({f"closing_spring.{option.kind}": part, "closing_spring.stiffness": option.stiffness})


def costs_of(clutch, objectives):
    costs = []
    for name in objectives:
        value = float(clutch._engine.get(name.removeprefix("-"), 0.0) or 0.0)
        costs.append(float(f"{-value if name.startswith('-') else value:.9g}"))
    return tuple(costs)


def best_of(points):
    return {a for a in points if not any(b != a and all(x <= y for x, y in zip(b, a, strict=True)) for b in points)}


COUNTS = {"direct": 6, "unlike": 5, "indirect": 3, "curved": 3, "envelope": 3, "sprung": 2, "event": 1}
QUICK = {kind: 4 if kind == "unlike" else 0 for kind in COUNTS if kind != "event"}
REST = [(kind, seed) for kind, count in COUNTS.items() for seed in range(count) if QUICK.get(kind) != seed]


@pytest.mark.parametrize(("kind", "seed"), [*QUICK.items(), *slow(*REST)])
def test_the_front_is_that_of_all_that_pass_a_check(kind, seed, tmp_path):
    """Limits are drawn from the candidates' values; every pick passes a check and has the values of its row."""
    (tmp_path / "balls.csv").write_text("diameter_mm\n" + "\n".join(f"{1e3 * ball:g}" for ball in BALLS))
    (tmp_path / "discs.csv").write_text(DISCS, encoding="utf-8")
    rng = Random(f"{kind} {seed + 3}")
    data = search_of(kind, rng, tmp_path)
    every = list(candidates(data))
    springs = data["search"].get("springs")
    if good := [clutch for one in every if (clutch := passing(one, springs))]:
        for name in rng.sample(["accuracy_factor", "torque_max"], rng.randint(0, 2)):
            values = sorted(float(clutch[name]) for clutch in good)
            data["requirements"][name] = values[rng.randrange(len(values))] * (1 + 1e-6)
        good = [clutch for clutch in good if all(float(clutch[n]) <= most for n, most in data["requirements"].items())]
    spec = make_spec(data)
    result, _ = searched(spec)
    points = {costs_of(clutch, data["objectives"]) for clutch in good}
    rows = [tuple(float(f"{row.objective(name) * (-1 if name[0] == '-' else 1):.9g}") for name in data["objectives"]) for row in result.front]  # fmt: skip
    assert set(rows) == best_of(points)
    assert len(rows) == len(set(rows))
    if len(rows) > 2 and len(rows[0]) > 1:  # least sum of objectives, each over its range, if this is no rounding error
        (best,) = (number for number, row in enumerate(result.front) if row.mark == "compromise")
        span = np.ptp(rows, axis=0)
        shares = (np.array(rows) - np.min(rows, axis=0)) / np.where(
            span > 1e-8 * np.abs(rows).max(axis=0), span, np.inf
        )
        assert shares.sum(axis=1)[best] == pytest.approx(shares.sum(axis=1).min(), abs=1e-6)
    assert result.candidates == len(every)
    assert bool(result.front) == bool(good) == (not result.binding)
    if kind not in ("sprung", "event"):
        assert result.feasible == len(good)
    for row in rng.sample(result.front, min(3, len(rows))):
        _, clutch = picked(spec, result, row.number)
        assert Clutch(clutch).check().passed
        told = row.model_dump(exclude_none=True, exclude={"number", "mark", "variant", "closing_part"})
        own = build(clutch)
        for name, value in told.items():
            if isinstance(value, float) and name in own:
                assert value == pytest.approx(float(own[name]), rel=1e-9, abs=1e-12), name
        assert row.warnings == Clutch(clutch).check().warnings
        for path, values in data["search"].items():
            assert path == "springs" or row.changes.get(path, values[0]) in values


@given(st.integers(1, 4), st.integers(0, 40), st.integers(1, 6), st.integers(0, 10_000))
def test_a_front_by_definition(objectives, size, levels, seed):
    """Values that differ in the last place only count as equal."""
    generator = np.random.default_rng(seed)
    points = generator.integers(1, levels + 1, (size, objectives)).astype(float)
    noisy = points * (1 + generator.integers(-2, 3, points.shape) * 2.0**-52)
    assert sorted(map(tuple, points[unbeaten(noisy)].tolist())) == sorted(best_of({*map(tuple, points.tolist())}))


def test_a_straight_wall_is_one_among_curved_ones_too():
    """Of a straight and a curved wall, only the curved one has pockets that overlap."""
    result, _ = searched(make_spec(CLUTCHES["pocket"] | {"search": {"control_unit.gain_slope": [0.0, 5.0]}}))
    assert ([row.gain_slope for row in result.front], result.excluded) == ([0.0], {"pockets-overlap": 1})


BORNE = CLUTCHES["borne"]


def test_a_ball_bears_its_contact_force_with_the_pressure_that_is_asked():
    """Hertz's pressure of 3595 MPa with a ball of 20 mm falls as d^(-2/3): 3000 MPa takes 26.3 mm, the next is 26.988."""
    data = BORNE | {"requirements": {"contact_pressure": 3e9}, "search": {"control_unit.gain": [0.5]}}
    (row,) = searched(make_spec(data))[0].front
    assert row.ball_diameter_standard == pytest.approx(0.026988, rel=1e-4)


def test_equals_of_the_front_are_counted():
    """The number of balls changes no objective."""
    result, findings = searched(make_spec(BORNE | {"search": {"control_unit.balls": [6, 7, 8]}}))
    equals = [each.value for each in findings if each.code == "front-equals"]
    assert (result.feasible, len(result.front), equals) == (3, 1, [2])


def test_a_table_has_ten_clutches_and_the_compromise(afmcalc):
    """A note says how many more there are; ``--all`` and JSON have the whole front."""
    vary = ('search={"control_unit.gain" = "0.3:0.7:21"}', 'objectives=["-torque_max", "accuracy_factor"]')
    asked = ("design", "example:default", *overrides(*vary))
    whole = afmcalc(*asked, "--json").json["result"]
    count, compromise = len(whole["front"]), whole["compromise"]
    assert count > compromise > 10
    for options, numbers in (((), [*range(1, 11), compromise]), (("--all",), [*range(1, count + 1)])):
        run = afmcalc(*asked, *options)
        _, _, table = run.out.partition("The front")
        assert [int(number) for number in re.findall(r"^ *(\d+) ", table, re.M)] == numbers
        assert (f"the front has {count - 11} more: --all shows them" in run.err) == (not options)


def test_a_pick_is_the_file_with_its_values(afmcalc, tmp_path):
    """The file keeps comments, order and units, has no [search], and has the values of the picked row."""
    source, target = tmp_path / "search.toml", tmp_path / "clutch.toml"
    source.write_text(
        'variant = "all-driving" # mine\nobjectives = ["closing_force", "accuracy_factor"]\n\n[search]\n'
        '"friction_group.pairs" = [6, 8]\ncontrol_unit.gain = "0.3:0.6:4"\n\n[friction]\nmin = 0.1 # measured\nmax = 0.3\n'
        '[friction_group]\npairs = 4 # z\nmean_radius = "10 cm"\n[adjustment]\nnominal_torque = "100 N*m"\n'
        '[control_unit]\ngain = 1.0 # bought elsewhere\nball_circle_radius = "50 mm"\nballs = 6\n'
    )
    run = afmcalc(
        "design", source, "--pick", "compromise", "--save", target, "--set", "adjustment.margin=1.25", "--json"
    )
    assert run.code == 0, run.err
    (row,) = run.json["result"]["front"]
    text = target.read_text()
    for kept in (
        'variant = "all-driving" # mine',
        "min = 0.1 # measured",
        'mean_radius = "10 cm"',
        "# bought elsewhere",
    ):
        assert kept in text
    assert "[search]" not in text
    clutch = load(target)
    assert clutch.check().passed
    assert clutch.spec == load(run.json["spec"]).spec
    plain = afmcalc("design", source, "--set", "adjustment.margin=1.25", "--json").json
    assert load(plain["spec"]).spec == clutch.spec, "JSON is the spec of the compromise"
    assert (clutch["pairs"], clutch["gain"], clutch.spec.adjustment.margin) == (row["pairs"], row["gain"], 1.25)
    assert afmcalc("design", source, "--save", target).code == 2
    assert afmcalc("design", source, "--pick", "99").code == 2


def test_an_old_file_is_told_where_each_key_is(afmcalc, tmp_path):
    """Each place that a message names is a key of the spec."""
    old = {"variants": ["conventional"], "objectives": ["pairs"], "friction": {"min": 0.1, "max": 0.3}}
    for path in MOVED:
        put(old, path, 1.0) if "." in path else old.setdefault(path, 1.0)
    by_rule = {"wanted.peak_torque", "limits.outer_diameter", "fixed.balls", "search.pairs", "search.gain"}
    for path in by_rule:
        put(old, path, 1.0)
    with pytest.raises(SpecError) as refused:
        make_spec(old)
    told = {problem.path: problem.message for problem in refused.value.problems}
    assert told.keys() == MOVED.keys() | by_rule
    places = [word.strip(",") for message in told.values() for word in message.split() if "." in word]
    assert len(places) >= len(told) - 2
    for place in places:
        known = place.removeprefix("search.")
        assert known in keys() or any(key.startswith(f"{known}.") for key in keys()) or known in ("variant", "springs")
    path = tmp_path / "old.toml"
    path.write_text('variants = ["conventional"]\n[wanted]\naccuracy_factor = 3.0\n')
    assert "is now requirements.accuracy_factor" in afmcalc("design", path).err


@pytest.mark.parametrize(
    ("given", "check"),
    [
        (["requirements.accuracy_factor=1.2"], "accuracy_factor"),
        *slow(
        (["search.control_unit.ball_circle_radius=20 mm", "search.variant=differentiated"], "parts-collide"),
        (["search.control_unit.ball_circle_radius=", "control_unit.ball_circle_radius=20 mm", "search.variant=differentiated"], "parts-collide"),
        ),
        (["search.friction_group.pairs=[2]", "requirements.closing_force=2 kN"], "closing_force"),
        (["search.control_unit.gain=[2.5, 3.0]", "search.variant=differentiated", "requirements.accuracy_factor=6"], "gain-above-limit"),
    ],
)  # fmt: skip
def test_without_a_result_the_nearest_says_what_would_do(given, check, afmcalc):
    """With the key as told there is a front; and no count says that anything meets all."""
    few = [
        f"search.{each}" for each in ('friction_group.outer_radius=["80 mm", "90 mm"]', "control_unit.gain=0.1:1.1:6")
    ]
    sets = overrides(*few, *given, "heat.lining=", "requirements.trip_ratio=")
    run = afmcalc("design", "example:machine", *sets, "--json")
    result = run.json["result"]
    (binding,) = result["binding"]
    assert (run.code, result["front"], result["feasible"], binding["check"]) == (2, [], 0, check)
    assert max(result["excluded"].values()) <= result["candidates"]
    assert binding["sign"] == (
        "≥" if binding["key"].startswith("requirements.") or check == "parts-collide" else binding["sign"]
    )
    eased = [*sets, "--set", f"{binding['key']}={binding['would_do'] * (1 + 1e-9)!r}"]
    if binding["key"].endswith("pairs"):
        eased[-1] = f"{binding['key']}=[{binding['would_do']:.0f}]"
    assert afmcalc("design", "example:machine", *eased, "--json").json["result"]["front"], binding


def test_springs_that_are_not_to_be_had_are_named(afmcalc):
    sets = ("search.control_unit.gain=1.2", "search.variant=all-driving", "search.friction_group.pairs=4", "closing_spring.room.length=20 mm")  # fmt: skip
    result = afmcalc("design", "example:conveyor", *overrides(*sets), "--json").json["result"]  # fmt: skip
    (binding,) = result["binding"]
    assert (result["front"], binding["check"]) == ([], "no-spring")
    assert "which misses" in binding["message"]


def test_every_requirement_that_the_nearest_misses_would_have_to_give_way(afmcalc):
    few = ["search.friction_group.pairs=[12]", 'search.friction_group.outer_radius=["90 mm"]', "search.variant=differentiated", "requirements.accuracy_factor=1.1", "heat.lining=", "requirements.closing_force=1 kN"]  # fmt: skip
    sets = overrides(*few)
    run = afmcalc("design", "example:machine", *sets, "--json")
    missed = run.json["result"]["binding"]
    assert {each["check"] for each in missed} == {"accuracy_factor", "closing_force"}
    for each in missed:
        assert f"{each['key']} ≥ " in run.err
        sets += ["--set", f"{each['key']}={each['would_do']!r}"]
    assert afmcalc("design", "example:machine", *sets, "--json").json["result"]["front"]


def test_what_cannot_be_searched_is_refused_by_its_key(afmcalc):
    for override, said in REFUSED["search"]:
        run = afmcalc("design", "example:requirements", "--set", override)
        assert (run.code, said in run.err, "Traceback" in run.err) == (2, True, False), (override, run.err)


def test_every_command_calculates_a_file_with_a_search(afmcalc):
    few = ("--set", "search.friction_group.pairs=8", "--set", "search.control_unit.gain=0.5:1:2", "--json")
    plain = afmcalc("torque", "example:requirements", "--set", "search=", "--json").json
    with_search = afmcalc("torque", "example:requirements", *few).json
    assert with_search["result"] == plain["result"]
    again = afmcalc("design", "-", "--json", stdin=json.dumps({"spec": with_search["spec"]})).json["result"]
    assert again == afmcalc("design", "example:requirements", *few).json["result"]
