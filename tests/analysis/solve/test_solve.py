"""solve: what it finds gives what was wanted, what it refuses has no answer; closed forms by hand and a dense scan."""

import math
from collections import Counter
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from conftest import CONFIGS, S21

from afmcalc.analysis.check import check
from afmcalc.analysis.solve.solve import PARAMETERS, TARGETS, NotAttainableError, solve
from afmcalc.engines import build
from afmcalc.errors import CalculationError
from afmcalc.spec import make_spec, read_spec
from afmcalc.spec.edit import respecified, with_key
from afmcalc.spec.keys import ALIASES


def test_driving_pairs():
    """More bypass pairs regulate less; f 0.1…0.8, z 8, C 0.5: z_1 = 2 gives 3.06, 3 gives 3.33."""
    result, _, _ = solve(build(read_spec()), "z1", "accuracy_factor", 3.2)
    assert (result.value, result.exact_value) == (2, None), "2.55 is beyond the gain limit, 1/(C f_max) = 2.5"
    beyond, _, _ = solve(build(read_spec()), "z1", "accuracy_factor", 3.2, beyond_limit=True)
    assert (beyond.value, beyond.exact_value) == (2, pytest.approx(8 - 4.8 / 0.88))  # z_2 = (8 − 3.2)/(0.5·0.8·2.2)


ALPHA = ["C=", f"alpha={math.atan(0.25)} rad"]
UNATTAINABLE = [
    ("C", "accuracy_factor", 1.5, None, [], 1.875, 1.25),  # the gain limit 1/(z_1 f_1max)
    ("C", "accuracy_factor", 9.0, None, [], 8.0, 0.0),
    ("C", "accuracy_factor", 1.0, S21, [], 1.0, None),
    # K_т at zC = 5 is m (1 + 5 f_min)/(1 + 5 f_max) = 8·1.5/5 for every z
    ("C", "accuracy_factor", 2.0, "example:all-driving", ["f_min=0.1", "f_max=0.8", "z=13"], 2.4, 5 / 13),
    ("z1", "accuracy_factor", 2.7, None, [], 8 * 1.35 / 3.8, 1),
    ("z", "nominal_torque", 1e6, None, [], 2000 * 0.1 / 0.5, None),
    # both torques go to F R/C as z grows; beyond 1e7 pairs their difference is only rounding
    ("z", "scatter", 1e-9, None, [], 0.0, None),
    # κ = 0 at R = C d/(2 f_1) = 1/6 m: T = z R f F
    ("R", "torque_max", 2200.0, S21, [], 8 * 0.8 * 2000 / 6, 1 / 6),
    # the gain follows R: C = R tan α/r = 1.25 at R = 0.05·1.25/0.25, T = F R z f/(1 + z_2 C f)
    ("R", "torque_max", 1000.0, None, ALPHA, 400.0, 0.25),
    # below F_п1 the sleeve would leave its stop without torque; at C = 2 R f_1/d = 2·0.1·0.15/0.05 F_п2 = F_п1
    ("C", "control_force", 1500.0, S21, [], 2000.0, 0.6),
    ("z", "control_force", 2500.0, "example:indirect", [], 2000 * 1.288, 1),  # F_п1 (1 + 0.288 z)
]
"""Parameter, target, wanted, spec, overrides; the best, and where it is (None: approached as the parameter grows)."""


@pytest.mark.parametrize(("name", "target", "wanted", "spec", "overrides", "best", "at"), UNATTAINABLE)
def test_the_best_of_what_cannot_be_had(name, target, wanted, spec, overrides, best, at):
    with pytest.raises(NotAttainableError) as refused:
        solve(build(read_spec(spec, overrides)), name, target, wanted)
    assert refused.value.best == pytest.approx(best, rel=1e-6, abs=1e-6)
    assert (refused.value.at is None) if at is None else (refused.value.at == pytest.approx(at, rel=1e-6))


@pytest.mark.parametrize(
    "arguments",
    [
        "--for F accuracy_factor=2", "--for c1 accuracy_factor=2", "--for c2 accuracy_factor=2", "--for x accuracy_factor=2",
        f"--for R reduced_gain=8 {S21}", f"--for c2 control_force=3kN {S21}", "--for z1 accuracy_factor=2 --set C=2",
        "acuracy_factor=2", "accuracy_factor", "nominal_torque=2J", "nominal_torque=-2", "travel_max=1mm",
        "control_force=1kN", "accuracy_factor=nan", "exceedance=0.1", "temperature=150",
    ],
)  # fmt: skip
def test_what_cannot_be_asked(arguments, afmcalc):
    run = afmcalc("solve", *arguments.split())
    assert (run.code, run.out) == (2, "")


def test_a_force_replaces_the_torque_it_was_set_for(afmcalc):
    run = afmcalc("solve", "--for", "F", "nominal_torque=250", "--set", "F=", "--set", "T_n=100", "--json").json
    assert "nominal_torque" not in run["spec"]["adjustment"]
    assert "solve-replaces" in [finding["code"] for finding in run["findings"]]
    # F = T (1 + 3.5·0.1)/(0.1·8·0.1)
    assert run["result"]["value"] == pytest.approx(250 * 1.35 / 0.08)


@pytest.mark.parametrize("count", [4, pytest.param(20, marks=pytest.mark.slow)])
@pytest.mark.parametrize("name", PARAMETERS)
def test_against_a_scan(name, count):
    """What is solved is, what is refused has no answer, the best is one."""
    seen = run(name, count)
    assert seen["solved"] > 0.3 * count, seen


def test_a_plateau_is_no_answer(afmcalc):
    """Above C_1* the largest torque is T_н whatever c_1: every c_1 below 1240 N/mm gives 160 N·m, none is the answer."""
    pocket = ["--set", "control_unit.pocket=", "--set", "control_unit.gain_slope=900"]
    refused = afmcalc("solve", "--for", "c1", "torque_max=160", CONFIGS / "constant-torque.toml", *pocket)
    assert refused.code == 2
    assert "a whole range of c1" in refused.err
    rising = afmcalc("solve", "--for", "c1", "torque_max=170", CONFIGS / "constant-torque.toml", *pocket, "--json")
    assert rising.json["result"]["reached"] == pytest.approx(170)


LIFE = [CONFIGS / "drive.toml", ["drive.dynamic_factor=2", "drive.event="]]


@pytest.mark.parametrize("cycles", [1e5, 2e6])
def test_force_for_a_life(cycles):
    """N = N_0 (τ_limb/τ_eq)^m of τ_eq = k_д (T_min + T_max)/2 W; T = 8 F R f/(1 + 7 C f) with z_1 = 1 of 8 pairs."""
    spec = read_spec(*LIFE)
    result, _, _ = solve(build(spec), "F", "cycles", cycles)
    per_force = sum(0.1 * 8 * f / (1 + 7 * 0.5 * f) for f in (0.1, 0.8)) / 2
    assert result.value == pytest.approx(400e6 * (1e7 / cycles) ** (1 / 6) * 15e-6 / 2 / per_force, rel=1e-6)


def test_a_life_without_end_is_no_number():
    """Above N_0 = 1e7 there is no life with a number: the best is at the endurance limit, and a smaller force has none."""
    with pytest.raises(NotAttainableError, match="it has no end at F = ") as refused:
        solve(build(read_spec(*LIFE)), "F", "cycles", 1e8)
    assert refused.value.best == pytest.approx(1e7, rel=1e-6)


def test_what_check_says_of_the_clutch_found():
    result, solved, _ = solve(build(read_spec(*LIFE)), "F", "cycles", 1e5)
    again = build(respecified(solved.spec, {"requirements.cycles": 1e5, "requirements.temperature": None}))
    values = {row.requirement: row.value for row in check(again)[0].requirements}
    assert values["cycles"] == result.reached


POINTS = 4001
LEVEL = 1e-11
"""Relative difference below which nothing depends on the parameter."""
WHOLE = ("z", "z1")
ONLY = {"C": "differentiated unlike all-driving indirect", "z1": "differentiated unlike"}
ONLY |= dict.fromkeys(("c1", "c2", "gain_slope"), "indirect")
VARIANTS = "conventional differentiated unlike all-driving indirect"


@dataclass(frozen=True)
class Case:
    """What is asked."""

    data: dict[str, Any]
    name: str
    target: str
    wanted: float
    beyond: bool


def random_spec(rng: np.random.Generator, name: str) -> dict[str, Any]:
    """A clutch of any variant that has the parameter, given in any of the ways a spec may."""
    variant = str(rng.choice(ONLY.get(name, VARIANTS).split()))

    def friction() -> dict[str, float]:
        low, mean, high = np.sort(rng.uniform(0.03, 1.0, 3)).tolist()
        return {"min": low, "max": high, **({"mean": mean} if rng.random() < 0.5 else {})}

    pairs, radius = int(rng.integers(2, 20)), rng.uniform(0.03, 0.4)
    data: dict[str, Any] = {
        "variant": "differentiated" if variant == "unlike" else variant,
        "friction": {"driving": friction(), "driven": friction()} if variant == "unlike" else friction(),
        "friction_group": {"pairs": pairs, "mean_radius": radius},
        "adjustment": {"method": str(rng.choice(["min-friction", "mean-friction"])), "margin": rng.uniform(1, 2)},
    }
    if variant in ("differentiated", "unlike") and (name == "z1" or rng.random() < 0.5):
        data["friction_group"]["driving_pairs"] = int(rng.integers(1, pairs))
    if rng.random() < 0.3:
        data["friction_group"] |= {"inner_radius": radius * 0.8, "outer_radius": radius * 1.2}
        del data["friction_group"]["mean_radius"]
    if rng.random() < 0.3:
        data["adjustment"]["nominal_torque"] = 10 ** rng.uniform(1, 3)
    else:
        data["closing_spring"] = {"force": 10 ** rng.uniform(2, 4)}
    if variant == "conventional":
        return data
    gain = float(rng.choice([0.0, 10 ** rng.uniform(-2, 0.7)], p=[0.05, 0.95]))
    unit = data["control_unit"] = {"ball_circle_radius": rng.uniform(0.02, 0.2)}
    if variant == "indirect":
        unit["key_friction"] = float(rng.choice([0.0, rng.uniform(0.05, 0.3)]))
        unit["hub_diameter"] = rng.uniform(0.03, 0.15)
        gain += 2 * radius * 1.2 * unit["key_friction"] / unit["hub_diameter"]
        data.setdefault("closing_spring", {})["stiffness"] = 10 ** rng.uniform(3, 5)
        data["control_spring"] = {"stiffness": float(rng.choice([0.0, 10 ** rng.uniform(3, 5)], p=[0.1, 0.9]))}
        if "force" in data["closing_spring"] and rng.random() < 0.2:
            data["control_spring"]["force"] = data["closing_spring"]["force"] * rng.uniform(1, 5)
    if rng.random() < 0.3:
        unit["wall_angle"] = math.atan(gain * unit["ball_circle_radius"] / radius)
    else:
        unit["gain"] = gain
    # with both forces as made steep pockets make the torque jump over values: no scan sees how
    if variant == "indirect" and "force" not in data["control_spring"] and rng.random() < 0.3:
        unit |= {"pocket": "constant-torque"} if rng.random() < 0.3 else {"gain_slope": 10 ** rng.uniform(-1, 3)}
    return data


Scan = tuple[np.ndarray, np.ndarray]


def scan(case: Case) -> Scan:
    """Values of the parameter at which there is a clutch (and, unless beyond, its gain within the limit), and the target."""
    spec, path, value = make_spec(case.data), ALIASES[case.name], TARGETS[case.target].value
    clutch = build(spec)
    if case.name in WHOLE:
        x = np.arange(1.0, 3001 if case.name == "z" else spec.friction_group.pairs)
        if case.name == "z":
            x = np.unique(np.concatenate([x, np.round(np.geomspace(3000, 1e9, 2000))]))
            x = x[x > spec.bypass_pairs] if spec.variant == "differentiated" else x
    else:
        x = np.geomspace(1e-6, 1e13, POINTS)
        x = np.concatenate([[0.0], x]) if case.name in ("C", "c2", "gain_slope") else x
    unit, angle = spec.control_unit, spec.control_unit is not None and spec.control_unit.wall_angle is not None
    if spec.variant == "indirect":
        threshold = 2 * clutch.mean_radius * unit.key_friction / unit.hub_diameter
        if case.name == "C":
            x = threshold + x
        if case.name == "R" and not angle and threshold > 0:
            end = clutch.mean_radius * clutch.gain / threshold * (1 - 1e-13)
            x = np.concatenate([x[x < end], np.linspace(0, end, POINTS)[1:]])
    x = np.unique(x)
    over = build(with_key(spec, path, x))
    if not case.beyond and "gain_limit" in over.quantities:
        x = x[np.broadcast_to(over.gain <= over.gain_limit * (1 + 1e-12), x.shape)]
        if case.name not in WHOLE and len(x) and x[-1] < 1e13:
            # the limit itself, between two points
            end = {"C": lambda: clutch.gain_limit, "R": lambda: clutch.mean_radius * clutch.gain_limit / clutch.gain}
            x = np.unique(np.concatenate([x, np.linspace(x[0], end[case.name](), POINTS)]))
        if not len(x):
            return x, x
        over = build(with_key(spec, path, x))
    with np.errstate(all="ignore"):
        found = np.broadcast_to(value(over), x.shape)
        told = np.isfinite(found)
        if case.target == "scatter":
            # a difference of torques: below this it is their rounding
            told &= (found == 0) | (found > 1e-5 * over.torque_max)
    return x[told], found[told]


def best_of(case: Case, scanned: Scan, side: float, approached: bool) -> float:
    """The largest (side 1) or smallest of the target: near the best of the scan, or beyond its ends by 1/x."""
    x, value = scanned
    if approached:
        (first, second), (last, other) = (np.interp([x[i], x[i] * by], x, value) for i, by in ((0, 10), (-1, 0.1)))
        return float(max(side * (first + (first - second) / 9), side * (last + (last - other) / 9)) * side)
    spec, path = make_spec(case.data), ALIASES[case.name]
    for _ in range(0 if case.name in WHOLE else 3):
        i = int(np.argmax(side * value))
        x = np.linspace(x[max(i - 1, 0)], x[min(i + 1, len(x) - 1)], POINTS)
        value = np.broadcast_to(TARGETS[case.target].value(build(with_key(spec, path, x))), x.shape)
    return float(max(side * value) * side)


def random_case(rng: np.random.Generator, name: str) -> tuple[Case, Scan] | None:
    """A question, half of the time with an answer somewhere; None where the parameter cannot matter."""
    data = random_spec(rng, name)
    left_out = () if data["variant"] == "indirect" else ("travel_max", "control_force")
    targets = [target for target in TARGETS if target not in left_out]
    case = Case(data, name, str(rng.choice(targets)), 1.0, bool(rng.random() < 0.5))
    x, value = scan(case)
    if not len(x) or not max(value) > 0 or (np.ptp(value) <= LEVEL * abs(value[0]) and rng.random() < 0.95):
        return None
    likely = value[(x > 1e-3) & (x < 1e5)] if np.any((x > 1e-3) & (x < 1e5)) else value
    picked = float(rng.choice([rng.choice(likely), min(likely), max(likely)], p=[0.5, 0.25, 0.25]))
    beside = [1.0, 1 + 10 ** rng.uniform(-7, -2), 1 - 10 ** rng.uniform(-7, -2), 10 ** rng.uniform(-1, 1)]
    wanted = picked * float(rng.choice(beside))
    if any(abs(end - wanted) < 3e-9 * wanted for end in (value[0], value[-1])):
        return None  # solve counts it as the limit, which is only approached
    return (Case(data, name, case.target, wanted, case.beyond), (x, value)) if 1e-8 < wanted < 1e12 else None


def judge(case: Case, scanned: Scan) -> str:
    """Ask solve, and hold the answer to the scan: what happened in a word; AssertionError where they differ."""
    clutch = build(make_spec(case.data))
    better = TARGETS[case.target].better
    x, value = scanned
    meets = value <= case.wanted if better == "low" else value >= case.wanted
    off = np.abs(value - case.wanted) > 1e-12 * case.wanted
    gap = value[off] - case.wanted
    crossings = x[off][1:][gap[:-1] * gap[1:] < 0]
    try:
        result, solved, findings = solve(clutch, case.name, case.target, case.wanted, beyond_limit=case.beyond)
    except NotAttainableError as refusal:
        assert not (meets.any() if case.name in WHOLE else len(crossings)), f"the scan has a root: {refusal}"
        side = math.copysign(1, case.wanted - float(value[0]))
        best = best_of(case, scanned, side, approached=refusal.at is None)
        assert math.isclose(refusal.best, best, rel_tol=1e-6, abs_tol=1e-9), f"best {best}, not {refusal.best}"
        assert refusal.at is None or side * (refusal.best - best) >= -1e-9 * abs(best), f"better is {best}: {refusal}"
        return "refused"
    except CalculationError as refusal:
        # the same everywhere, or along a stretch
        level = np.abs(value - case.wanted) <= LEVEL * case.wanted
        assert np.ptp(value) <= LEVEL * abs(value[0]) or (level[1:] & level[:-1]).any(), str(refusal)
        assert len(x) > 1, str(refusal)
        return "independent"
    again = build(make_spec(solved.spec.model_dump(exclude_none=True)))
    reached = float(TARGETS[case.target].value(again))
    assert math.isclose(reached, result.reached, rel_tol=1e-12)
    if case.name in WHOLE:
        assert float(result.value).is_integer()
        assert reached <= case.wanted * (1 + 1e-8) if better == "low" else reached >= case.wanted * (1 - 1e-8)
    else:
        assert math.isclose(reached, case.wanted, rel_tol=1e-8), f"reached {reached}"
        told = [result.value, *(float(f.value) for f in findings if f.code == "solve-another-value")]
        assert result.value <= min(crossings, default=math.inf) * (1 + 1e-9), "a smaller value gives it too"
        assert len(told) >= min(len(crossings), 2), f"a second root is not told: {crossings}, {told}"
    if not case.beyond and "gain_limit" in again.quantities and case.name in ("C", "z", "z1"):
        assert again.gain <= again.gain_limit * (1 + 1e-9), "past the gain limit"
    return "solved"


def run(name: str, count: int) -> Counter[str]:
    """Judge ``count`` random questions about one parameter."""
    rng = np.random.default_rng([7, [*PARAMETERS].index(name)])
    seen: Counter[str] = Counter()
    while seen.total() < count:
        drawn = random_case(rng, name)
        if drawn is None:
            continue
        case, scanned = drawn
        try:
            seen[judge(case, scanned)] += 1
        except AssertionError as wrong:
            raise AssertionError(f"{case}: {wrong}") from wrong
    return seen
