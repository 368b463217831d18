"""Random solves against a dense scan that knows nothing of how solve searches.

``python tests/solve_scan.py 1000`` tries 1,000 of every parameter; the suite tries 4, or 20.
"""

import math
import sys
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from afmcalc.analysis.solve.solve import PARAMETERS, TARGETS, NotAttainableError, solve
from afmcalc.engines import build
from afmcalc.errors import CalculationError
from afmcalc.spec import make_spec
from afmcalc.spec.edit import with_key
from afmcalc.spec.keys import ALIASES

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
        unit |= {
            "key_friction": float(rng.choice([0.0, rng.uniform(0.05, 0.3)])),
            "hub_diameter": rng.uniform(0.03, 0.15),
        }
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
    spec = make_spec(case.data)
    path = ALIASES[case.name]
    clutch = build(spec)
    value = TARGETS[case.target].value
    if case.name in WHOLE:
        x = np.arange(1.0, 3001) if case.name == "z" else np.arange(1.0, spec.friction_group.pairs)
        if case.name == "z":
            x = np.unique(np.concatenate([x, np.round(np.geomspace(3000, 1e9, 2000))]))
        if case.name == "z" and spec.variant == "differentiated":
            x = x[x > spec.bypass_pairs]
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
    if not case.beyond and spec.kind.gain_limit is not None:
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
    targets = [
        target for target in TARGETS if target not in ("travel_max", "control_force") or data["variant"] == "indirect"
    ]
    case = Case(data, name, str(rng.choice(targets)), 1.0, bool(rng.random() < 0.5))
    x, value = scan(case)
    if not len(x) or not max(value) > 0:
        return None
    if np.ptp(value) <= LEVEL * abs(value[0]) and rng.random() < 0.95:
        return None
    likely = value[(x > 1e-3) & (x < 1e5)] if np.any((x > 1e-3) & (x < 1e5)) else value
    picked = float(rng.choice([rng.choice(likely), min(likely), max(likely)], p=[0.5, 0.25, 0.25]))
    wanted = picked * float(
        rng.choice([1.0, 1 + 10 ** rng.uniform(-7, -2), 1 - 10 ** rng.uniform(-7, -2), 10 ** rng.uniform(-1, 1)])
    )
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
        assert not (meets.any() if case.name in WHOLE else len(crossings)), (
            f"refused, but the scan has a root: {refusal}"
        )
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
        assert result.value == int(result.value)
        assert reached <= case.wanted * (1 + 1e-8) if better == "low" else reached >= case.wanted * (1 - 1e-8)
    else:
        assert math.isclose(reached, case.wanted, rel_tol=1e-8), f"reached {reached}"
        told = [result.value, *(float(f.value) for f in findings if f.code == "solve-another-value")]
        assert result.value <= min(crossings, default=math.inf) * (1 + 1e-9), "a smaller value gives it too"
        assert len(told) >= min(len(crossings), 2), f"a second root is not told: {crossings}, {told}"
    if not case.beyond and again.spec.kind.gain_limit is not None and case.name in ("C", "z", "z1"):
        assert again.gain <= again.gain_limit * (1 + 1e-9), "past the gain limit"
    return "solved"


def run(name: str, count: int, report: Callable[[Case, str], None] | None = None) -> Counter[str]:
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
            if report is None:
                raise AssertionError(f"{case}: {wrong}") from wrong
            report(case, str(wrong))
            seen["wrong"] += 1
    return seen


if __name__ == "__main__":
    for parameter in PARAMETERS:
        print(parameter, dict(run(parameter, int(sys.argv[1]), lambda case, wrong: print("  ", wrong, case))))
