"""One question, one answer: what several commands tell is the same number, and no friction exceeds what is told.

Random clutches of every kind; extremes searched over 10⁴ frictions with a law written here from the balance of S21
(theory, sections 5 and 12), not from the program; drives about the friction of the setting, one event against a sweep.
"""

import itertools
import json
import math
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import afmcalc

Place = "str | Callable[[Asked], float | None]"

KINDS = ("conventional", "differentiated", "unlike", "all-driving", "straight", "curved", "steep", "constant-torque")
HEAT = {"disc_mass": 1.6, "specific_heat": 480, "conductivity": 50, "density": 7850, "cooling": 2.5, "ambient": 293.15}


def friction(rng: np.random.Generator) -> dict[str, float]:
    """A range whose mean is off the middle, or left to the program."""
    low = rng.uniform(0.04, 0.25)
    high = low * rng.uniform(1.3, 7)
    return {"min": low, "max": high} | ({"mean": rng.uniform(low, high)} if rng.random() < 0.8 else {})


def mean_of(given: dict[str, float]) -> float:
    return given.get("mean", (given["min"] + given["max"]) / 2)


def clutch(rng: np.random.Generator, kind: str) -> dict[str, Any]:
    """A random clutch of a kind: set by either method, with margin; an indirect one's springs as set or as made."""
    pairs, inner, given = int(rng.integers(2, 13)), rng.uniform(0.04, 0.12), friction(rng)
    outer = inner * rng.uniform(1.15, 1.6)
    radius, force = (inner + outer) / 2, rng.uniform(300, 8000)
    unit = {"ball_circle_radius": radius * rng.uniform(0.4, 0.9), "balls": int(rng.integers(3, 9))}
    spec: dict[str, Any] = {
        "variant": kind if kind in ("conventional", "all-driving") else "differentiated",
        "friction": given,
        "friction_group": {"pairs": pairs, "inner_radius": inner, "outer_radius": outer},
        "closing_spring": {"force": force},
        "control_unit": unit | {"face_gap": 0.002, "edge_clearance": 0.002, "allowable_contact_force": 5e3},
        "adjustment": {
            "method": str(rng.choice(["min-friction", "mean-friction"])),
            "margin": 1.0 if rng.random() < 0.4 else rng.uniform(1, 2),
        },
        "drive": {"dynamic_factor": rng.uniform(1, 2)},
        "fatigue": {"endurance_limit": rng.uniform(1e6, 3e6), "polar_section_modulus": 3e-5, "exponent": 6.0},
    }
    spec["fatigue"]["base_cycles"] = 1e7
    if kind == "conventional":
        del spec["control_unit"]
    elif kind == "all-driving":
        spec["control_unit"]["gain"] = rng.uniform(0, 6) / pairs
    elif kind in ("differentiated", "unlike"):
        driving = spec["friction_group"]["driving_pairs"] = int(rng.integers(1, pairs))
        if kind == "unlike":
            spec["friction"] = {"driving": given, "driven": friction(rng)}
        spec["control_unit"]["gain"] = rng.uniform(0, 2) / driving / given["max"]
    else:
        indirect(spec, rng, kind)
    return spec


def indirect(spec: dict[str, Any], rng: np.random.Generator, kind: str) -> None:
    """Make it indirect: key, springs, slope of the wall; the sleeve of a steep one jumps off its stop."""
    given, pairs, force = spec["friction"], spec["friction_group"]["pairs"], spec["closing_spring"]["force"]
    radius = (spec["friction_group"]["inner_radius"] + spec["friction_group"]["outer_radius"]) / 2
    hub, key, net = radius * rng.uniform(0.4, 0.9), float(rng.choice([0, 0.01, 0.1])), rng.uniform(0.05, 2)
    leaves = given["min"] if spec["adjustment"]["method"] == "min-friction" else mean_of(given)
    closing, control = force / rng.uniform(0.002, 0.03), (rng.random() < 0.9) * force / rng.uniform(0.002, 0.05)
    spec |= {"variant": "indirect", "control_spring": {"stiffness": control}}
    spec["closing_spring"]["stiffness"] = closing
    spec["control_unit"] |= {"hub_diameter": hub, "key_friction": key, "gain": net + 2 * radius * key / hub}
    if rng.random() < 0.4:
        leaves = rng.uniform(0.7 * given["min"], 1.2 * given["max"])
        spec["control_spring"]["force"] = force * (1 + pairs * net * leaves)
    holding = (closing + control) / (pairs * leaves * force)
    if kind == "constant-torque":
        spec["control_unit"]["pocket"] = kind
    elif kind == "curved":
        spec["control_unit"]["gain_slope"] = holding * rng.uniform(0.05, 1.5)
    elif kind == "steep":
        spec["control_unit"]["gain_slope"] = (holding + closing * net / force) * rng.uniform(1, 3)


def drive(spec: dict[str, Any], rng: np.random.Generator, kind: str = "stop") -> dict[str, Any]:
    """Put it in a drive: an event, what takes its heat."""
    event = {"kind": "stop", "stop_time": rng.uniform(0.004, 0.02)}
    if kind == "load":
        event = {"kind": "load", "torque": 1e4, "rise_time": rng.uniform(0, 0.02)}
    spec["drive"] = {
        "speed": rng.uniform(8, 30),
        "motor_inertia": rng.uniform(0.1, 0.5),
        "driven_inertia": rng.uniform(0.01, 0.05),
        "shaft_stiffness": rng.uniform(3e3, 9e3),
        "damping_ratio": rng.uniform(0.02, 0.08),
        "cut_off": 0.05,
        "event": event,
    }
    if spec["variant"] == "indirect":
        spec["drive"]["hub_inertia"] = rng.uniform(0.002, 0.006)
    if kind == "load":
        spec["drive"]["tool_inertia"] = rng.uniform(0.1, 0.5)
    return spec | {"heat": HEAT}


class Asked:
    """A clutch and what the commands answer, each asked once."""

    def __init__(self, run: Callable[..., Any], spec: dict[str, Any], file: Path) -> None:
        self.run, self.spec, self.file, self.answers = run, spec, file, dict[str, Any]()
        file.write_text(json.dumps(spec))
        group, given = spec["friction_group"], spec["friction"]
        ends = [one["max"] for one in ((given["driving"], given["driven"]) if "driven" in given else (given,))]
        self.area = math.pi * (group["outer_radius"] ** 2 - group["inner_radius"] ** 2)
        self.words = {
            "pairs": group["pairs"],
            "variant": spec["variant"],
            "uniform": 'tolerance.fields={friction={distribution="uniform"}}',
            "f_max": ",".join(map(repr, ends)),
            "f_max_path": f"friction{'.driven' * (len(ends) > 1)}.max={ends[-1]!r}",
            # S22 sets at f_min: of the mean, overload says that its T_н is another (a finding, margin-role)
            "overload": "overload" if spec["adjustment"]["method"] == "min-friction" else "none",
            # springs as made are not those that either method sets
            "method": "none"
            if "force" in spec.get("control_spring", {})
            else spec["adjustment"]["method"].replace("-", "_"),
        }
        self.words["goal"] = f"nominal_torque={self.told('torque: nominal_torque')!r}"

    def answer(self, command: str) -> Any:
        if command not in self.answers:
            head, *rest = command.split()
            if head == "none":
                answer = {}
            elif head == "python":
                answer = getattr(afmcalc.load(self.file), rest[0])().result
            elif head == "report":
                answer = rows_of(self.run("report", self.file).out)
            else:
                given = [
                    part for word in rest for part in (["--set", word] if re.match(r"\w+\.[\w.]+=", word) else [word])
                ]
                given = [
                    part
                    for part, before in zip(given, [head, *given], strict=False)
                    if (part, before) != ("--set", "--sweep")
                ]
                ran = self.run(head, *given, self.file, "--json")
                answer = ran.json["result"] if ran.code in (0, 1) else {}
            self.answers[command] = answer
        return self.answers[command]

    def told(self, place: Place) -> float | None:
        """The number in a place ``command: path``, or what a function makes of such; None where this clutch has none."""
        if not isinstance(place, str):
            return place(self)
        command, path = place.format_map(self.words).rsplit(": ", 1)
        value = self.answer(command)
        for step in path.split("/"):
            if isinstance(value, list):
                key, _, wanted = step.rpartition("=")
                fitting = [one for one in value if one[key] == wanted] if key else value[int(step) :][:1]
                value = fitting[-1] if fitting else None
            else:
                value = value.get(step) if isinstance(value, dict) else getattr(value, step, None)
        return value

    def apart(self, told: dict[str, tuple[Place, ...]], relative: float = 1e-9) -> Iterator[str]:
        """Quantities that two places tell apart, with what each tells."""
        for quantity, places in told.items():
            values = {getattr(place, "__name__", place): self.told(place) for place in places}
            numbers = [value for value in values.values() if value is not None]
            TALKATIVE.update((quantity, place) for place, value in values.items() if value is not None)
            if numbers and max(numbers) - min(numbers) > relative * max(map(abs, numbers)):
                yield "\n    ".join(
                    (f"{quantity}, {self.file}", *(f"{value!r:24} {place}" for place, value in values.items()))
                )


def rows_of(page: str) -> dict[str, list[float]]:
    """Numbers in the rows of a report's tables, by each text of the row; of rows of the same name the first's."""
    rows = [re.findall(r"<t[dh]([^>]*)>(.*?)</t[dh]>", row, re.S) for row in re.findall("<tr>(.*?)</tr>", page, re.S)]
    plain = [
        [("number" in kind, re.sub("<.*?>", "", text.replace("<sub>", "_"))) for kind, text in row] for row in rows
    ]
    return {
        name: [float(text) for number, text in row if number and re.fullmatch(r"[\d.]+", text)]
        for row in reversed(plain)
        for number, name in row
        if not number
    }


def required(key: str, limit: float = 1e9) -> str:
    return f"check requirements.{key}={limit}: requirements/requirement={key}/value"


def judged(key: str) -> str:
    limits = " ".join(f"requirements.{one}=1e9" for one in ("peak_torque", "work", "temperature"))
    return f"check {limits}: requirements/requirement={key}/value"


def swept(command: str, column: str) -> tuple[str, str]:
    return tuple(f"{command} --sweep {name}: sweep/0/{column}/0" for name in ("z={pairs}", "{f_max_path}"))  # type: ignore[return-value]


def of(function: Callable[..., Any], *places: str) -> Place:
    """A function of told numbers; a triple is the sequence of its numbers."""

    def made(asked: Asked) -> float | None:
        told = [asked.told(place) for place in places]
        told = [[n for n in one.values() if n is not None] if isinstance(one, dict) else one for one in told]
        return None if None in told or [] in told else function(asked, *told)

    made.__name__ = f"{function.__name__} of {', '.join(places)}"
    return made


LOW, HIGH = "torque: torque_range/low", "torque: torque_range/high"


def difference(_: Asked, low: float, high: float) -> float:
    return high - low


def ratio(_: Asked, low: float, high: float) -> float:
    return high / low


def least(_: Asked, numbers: list[float]) -> float:
    return min(numbers)


def largest(_: Asked, numbers: list[float]) -> float:
    return max(numbers)


def energy(asked: Asked, work: float) -> float:
    return work * asked.area * asked.words["pairs"]


def pressure(asked: Asked, force: float) -> float:
    return force / asked.area


def cycles(asked: Asked, low: float, high: float, factor: float = 1.0) -> float:
    """S19 (15)."""
    fatigue = asked.spec["fatigue"]
    stress = factor * (low + high) / 2 / fatigue["polar_section_modulus"]
    return float(fatigue["base_cycles"] * (fatigue["endurance_limit"] / stress) ** fatigue["exponent"])


TOLD: dict[str, tuple[Place, ...]] = {
    "nominal torque": (
        "torque: nominal_torque",
        "adjust: nominal_torque",
        "{overload}: nominal_torque",
        "compare: clutches/0/nominal_torque",
        *swept("accuracy", "nominal_torque"),
        required("nominal_torque", 1e-9),
        "python torque: nominal_torque",
        "explain torque: steps/symbol=T_н/value",
    ),
    "machine torque": (
        "torque: machine_torque",
        "{overload}: machine_torque",
        required("machine_torque", 1e-9),
        "explain torque: steps/symbol=T_н.маш/value",
        "tolerance {uniform} tolerance.sobol_base=64: machine_torque",
    ),
    "largest torque": (
        HIGH,
        required("torque_max"),
        *swept("accuracy", "torque_max"),
        "solve --for F {goal}: torque_max",
    ),
    "scatter": (
        of(difference, LOW, HIGH),
        "torque: scatter",
        "compare: clutches/0/scatter",
        "solve --for F {goal}: scatter",
        "adjust: {method}/scatter",
        "explain torque: steps/symbol=ΔT/value",
    ),
    "accuracy factor": (
        of(ratio, LOW, HIGH),
        "torque: accuracy_factor",
        "accuracy: accuracy_factor",
        *swept("accuracy", "accuracy_factor"),
        "compare: clutches/0/accuracy_factor",
        "compare --variants: clutches/variant={variant}/accuracy_factor",
        "adjust: {method}/accuracy_factor",
        "{overload}: accuracy_factor_expected",
        required("accuracy_factor"),
        "solve --for F {goal}: accuracy_factor",
        "python accuracy: accuracy_factor",
        "explain accuracy: steps/symbol=K_т/value",
    ),
    "accuracy factor by peaks": (
        "accuracy: accuracy_factor_peak",
        "compare: clutches/0/accuracy_factor_peak",
        *swept("accuracy", "accuracy_factor_peak"),
    ),
    "accuracy factor under a lasting load": (
        "accuracy: accuracy_factor_hysteresis",
        *swept("accuracy", "accuracy_factor_hysteresis"),
        required("accuracy_factor_hysteresis"),
        "python accuracy: accuracy_factor_hysteresis",
        "explain accuracy: steps/symbol=K_т,h/value",
    ),
    "torque at f_max": (
        "torque: torque/max",
        "torque --friction {f_max}: points/0/torque",
        "compare: clutches/0/torque/max",
        "adjust: {method}/torque/max",
        "{overload}: expected_torque/max",
    ),
    "normal force at f_max": ("torque: normal_force/max", "torque --friction {f_max}: points/0/normal_force"),
    "release force at f_max": ("torque: release_force/max", "torque --friction {f_max}: points/0/release_force"),
    "travel": (
        "torque: travel/max",
        "torque --friction {f_max}: points/0/travel",
        "synthesize: travel_max",
        "compare: clutches/0/travel_max",
        required("travel"),
    ),
    "closing force": (
        "torque: closing_force",
        "compare: clutches/0/closing_force",
        "adjust: {method}/closing_force",
        "springs --kind disc --top 1: closing_force",
        "solve --for F {goal}: closing_force",
    ),
    "control force": ("torque: control_force", "springs --kind disc --top 1: control_force"),
    "pressure at rest": (
        of(pressure, "torque: pack_force_at_rest"),
        required("surface_pressure"),
    ),
    "reduced gain": ("torque: reduced_gain", "compare: clutches/0/reduced_gain", required("reduced_gain")),
    "gain limit": ("accuracy: gain_limit", "compare: clutches/0/gain_limit", "check: limits/name=feedback gain/limit"),
    "contact force": (
        "synthesize: contact_force",
        "check: limits/name=contact force on one ball/value",
        "explain synthesize: steps/symbol=F_n/value",
    ),
    "ball": ("synthesize: ball_diameter_standard", "check: limits/name=ball diameter/value"),
    "life, protected": (
        "life: protected/as_set",
        "life: protected/{method}",
        of(cycles, LOW, HIGH),
        *swept("life", "protected"),
        "python life: protected/as_set",
    ),
    "life, unprotected": (
        "life: unprotected/as_set",
        "life: unprotected/{method}",
        of(cycles, LOW, HIGH, "life: dynamic_factor"),
        *swept("life", "unprotected"),
        required("cycles", 1e-9),
    ),
    "damaging stress": (
        "life: stress_protected",
        "check: limits/name=damaging stress, protected side (beyond: limited life)/value",
    ),
}
"""What is one quantity, and every place that tells it."""
PRINTED: dict[str, tuple[Place, ...]] = {
    "nominal torque": ("torque: nominal_torque", "report: nominal torque of the clutch/0"),
    "accuracy factor": ("accuracy: accuracy_factor", "report: accuracy factor T_max/T_min/0"),
    "torque at f_max": ("torque: torque/max", "report: slip torque (sustained)/2"),
}
SCATTERED: dict[str, tuple[Place, ...]] = {
    "smallest torque": (
        LOW,
        "tolerance {uniform} tolerance.sobol_base=64 tolerance.quantiles=[1e-9,0.999999999]: quantiles/0/torque",
    ),
    "largest torque": (
        HIGH,
        "tolerance {uniform} tolerance.sobol_base=64 tolerance.quantiles=[1e-9,0.999999999]: quantiles/1/torque",
    ),
}
EVENT: dict[str, tuple[Place, ...]] = {
    "sliding torque at f_max": ("simulate: sliding_torque/max", "torque: torque/max"),
    "peak at f_max": ("simulate: peak_torque/max", "simulate --friction {f_max}: points/0/peak_torque"),
    "peak torque": (of(largest, "simulate: peak_torque"), judged("peak_torque")),
    "dynamic factor": (of(largest, "simulate: dynamic_factor"), "life: dynamic_factor"),
    "contact force": (
        of(largest, "simulate: contact_force"),
        "check: limits/name=contact force on one ball in the event/value",
    ),
    "energy": (of(largest, "simulate: slip_energy"), of(largest, "heat: energy"), of(energy, judged("work"))),
    "temperature": (of(largest, "heat: temperature"), judged("temperature")),
    "trips per hour": (of(least, "heat: trips_per_hour"), required("trips_per_hour", 1e-9)),
}
TALKATIVE: set[tuple[str, str]] = set()


class Law:
    """Balance of an indirect clutch's sleeve (theory, sections 5 and 12), by the travel: no friction is solved for."""

    def __init__(self, spec: dict[str, Any]) -> None:
        group, unit, given = spec["friction_group"], spec["control_unit"], spec["friction"]
        self.turning = group["pairs"] * (group["inner_radius"] + group["outer_radius"]) / 2  # z R
        self.radius, self.pairs = self.turning / group["pairs"], group["pairs"]
        key = 2 * self.radius * unit["key_friction"] / unit["hub_diameter"]
        self.gain, self.rising, self.returning = unit["gain"], unit["gain"] - key, unit["gain"] + key
        self.closing, self.force = spec["closing_spring"]["stiffness"], spec["closing_spring"]["force"]
        self.springs = self.closing + spec["control_spring"]["stiffness"]
        at = given["min"] if spec["adjustment"]["method"] == "min-friction" else mean_of(given)
        self.control = spec["control_spring"].get("force", self.force * (1 + self.pairs * self.rising * at))
        self.leaves = (self.control / self.force - 1) / self.pairs / self.rising
        self.slope = unit.get("gain_slope", 0.0)
        if "pocket" in unit:
            self.slope = self.springs / (self.pairs * self.leaves * self.force)

    def moving(self, travel: np.ndarray, gain: float) -> tuple[np.ndarray, np.ndarray]:
        """Friction and torque at which the sleeve moves through a travel."""
        net = gain + self.slope * travel
        pull = self.control - self.force + self.springs * travel
        return pull / (self.pairs * net * (self.force - self.closing * travel)), self.radius * pull / net

    def seated(self, friction: np.ndarray, gain: float) -> np.ndarray:
        return self.turning * friction * self.control / (1 + self.pairs * gain * friction)

    def branches(self, low: float, high: float, steps: int) -> tuple[tuple[np.ndarray, np.ndarray, np.ndarray], float]:
        """Friction, torque and travel as friction rises from low to high; the smallest torque as it falls back, loaded."""
        travel = np.linspace(0, self.force / self.closing * (1 - 1e-9), 100 * steps)
        friction, torque = self.moving(travel, self.rising)
        # it leaves at `leaves`; where less friction would do for more travel it goes there at once
        reached = (
            (friction >= np.maximum.accumulate(friction))
            & (friction > self.leaves)
            & (friction <= high)
            & (friction >= low)
        )
        at = np.linspace(low, min(high, self.leaves), steps) if self.leaves > low else np.empty(0)
        rise = tuple(
            map(
                np.concatenate,
                ((at, friction[reached]), (self.seated(at, self.rising), torque[reached]), (0 * at, travel[reached])),
            )
        )
        most = travel[reached].max(initial=0.0)
        if high <= self.leaves:
            falls = high * self.rising / self.returning
            locked = self.turning * max(falls, low) * self.control / (1 + self.pairs * self.rising * high)
            return rise, min(locked, self.seated(np.array(low), self.returning)) if falls > low else locked
        falls = high * (self.rising + self.slope * most) / (self.returning + self.slope * most)
        locked = self.turning * max(falls, low) * (self.force - self.closing * most)
        friction, torque = self.moving(np.linspace(most, 0, 100 * steps), self.returning)
        until = np.argmax(np.diff(friction) > 0) if (np.diff(friction) > 0).any() else len(friction)
        friction, torque = friction[: until + 1], torque[: until + 1]
        candidates = [locked, *torque[friction >= low]]
        if friction[-1] > low:  # the sleeve is back at its stop
            candidates += [*self.seated(np.array([low, friction[-1]]), self.returning)]
        return rise, float(min(candidates))


def path(spec: dict[str, Any], steps: int) -> list[np.ndarray]:
    """Frictions from least over mean to largest, of both groups of unlike materials together."""
    given = spec["friction"]
    groups = (given["driving"], given["driven"]) if "driven" in given else (given,)
    return [np.interp(np.linspace(0, 2, steps), (0, 1, 2), (g["min"], mean_of(g), g["max"])) for g in groups]


def check_extremes(ask: Callable[[dict[str, Any]], Asked], seeds: range, steps: int = 10_001) -> None:
    wrong = []
    for _, kind, spec in some(seeds):
        asked = ask(spec)
        grid = path(spec, steps)
        points = [grid]
        torque = np.asarray(afmcalc.load(asked.file).torque(*grid))
        wide = np.argsort(-np.abs(np.diff(torque)))[:3]  # where it may jump, as close as numbers lie
        for at in wide:
            near = [np.linspace(one[at], one[at + 1], steps) for one in grid]
            for _ in range(3):
                jump = np.abs(np.diff(afmcalc.load(asked.file).torque(*near))).argmax()
                near = [np.linspace(one[jump], one[jump + 1], steps) for one in near]
            points.append(near)
        torque = np.concatenate([np.asarray(afmcalc.load(asked.file).torque(*one)) for one in points])
        low, high = torque.min(), torque.max()
        found = {"low": (low, LOW), "high": (high, HIGH), "ratio": (high / low, "accuracy: accuracy_factor")}
        found |= {"max": (high, required("torque_max")), "cycles": (cycles(asked, low, high), "life: protected/as_set")}
        if spec["variant"] == "indirect":
            law = Law(spec)
            (friction, own, travel), least_returning = law.branches(grid[0][0], grid[0][-1], steps)
            found |= {"low by the law": (own.min(), LOW), "high by the law": (own.max(), HIGH)}
            found["lasting"] = own.max() / least_returning, "accuracy: accuracy_factor_hysteresis"
            unit = spec["control_unit"]
            tangent = unit["ball_circle_radius"] / law.radius * (law.gain + law.slope * travel)
            force = own * np.sqrt(1 + tangent**2) / unit["balls"] / unit["ball_circle_radius"]
            found["contact"] = force.max(), "synthesize: contact_force"
        for name, (searched, place) in found.items():
            told = asked.told(place)
            if told is None:
                wrong.append(f"{kind}: {place} tells nothing, {name} is {searched!r}")
            elif abs(told - searched) > 1e-5 * searched:
                wrong.append(f"{kind}, {asked.file}: {place} tells {told!r}, {name} by search is {searched!r}")
    assert not wrong, f"{len(wrong)}\n" + "\n".join(wrong)


@pytest.fixture
def ask(afmcalc, tmp_path) -> Callable[[dict[str, Any]], Asked]:
    """Ask the commands of a spec."""
    return lambda spec: Asked(afmcalc, spec, tmp_path / f"{len(list(tmp_path.iterdir()))}.json")


def some(seeds: range) -> Iterator[tuple[np.random.Generator, str, dict[str, Any]]]:
    for seed, kind in itertools.product(seeds, KINDS):
        rng = np.random.default_rng([seed, KINDS.index(kind)])
        yield rng, kind, clutch(rng, kind)


def check_one_answer(ask: Callable[[dict[str, Any]], Asked], seeds: range) -> None:
    wrong = []
    for _, kind, spec in some(seeds):
        asked = ask(spec)
        wrong += asked.apart(TOLD)
        wrong += asked.apart(SCATTERED, 1e-6) if kind != "unlike" else []
    silent = {
        (quantity, getattr(place, "__name__", place)) for quantity, places in TOLD.items() for place in places
    } - TALKATIVE
    assert not wrong, f"{len(wrong)} disagreements\n" + "\n".join(wrong)
    assert not silent


def test_a_quantity_is_one_number(ask):
    check_one_answer(ask, range(1))


@pytest.mark.exhaustive
def test_a_quantity_is_one_number_of_many_clutches(ask):
    check_one_answer(ask, range(1, 60))


def check_report(ask: Callable[[dict[str, Any]], Asked], kinds: tuple[str, ...]) -> None:
    wrong = [one for _, kind, spec in some(range(200, 201)) if kind in kinds for one in ask(spec).apart(PRINTED, 1e-4)]
    assert not wrong, "\n".join(wrong)
    assert {name for name, place in TALKATIVE if place.startswith("report")} == {*PRINTED}


def test_a_report_prints_what_the_commands_tell(ask, undrawn):
    check_report(ask, ("curved",))


@pytest.mark.exhaustive
def test_every_report_prints_what_the_commands_tell(ask, undrawn):
    check_report(ask, KINDS)


def check_events(ask: Callable[[dict[str, Any]], Asked], kinds: tuple[str, ...], seeds: range) -> None:
    """What an event gives is told by simulate, heat, life and check alike."""
    wrong = []
    for rng, kind, spec in some(seeds):
        if kind in kinds:
            wrong += ask(drive(spec, rng, str(rng.choice(["stop", "load"])))).apart(EVENT)
    assert not wrong, f"{len(wrong)} disagreements\n" + "\n".join(wrong)
    assert {quantity for quantity, _ in TALKATIVE} >= {*EVENT}


def test_an_event_is_one_number(ask):
    check_events(ask, ("all-driving",), range(300, 301))


@pytest.mark.exhaustive
def test_an_event_is_one_number_of_every_kind(ask):
    check_events(ask, KINDS, range(301, 306))


def check_band(ask: Callable[[dict[str, Any]], Asked], seeds: range, shares: tuple[float, ...]) -> None:
    """About the friction at which the sleeve leaves, one event against a sweep's steps."""
    wrong = []
    for seed in seeds:
        rng = np.random.default_rng(seed)
        spec = drive(clutch(rng, "straight"), rng)
        group, unit, springs = spec["friction_group"], spec["control_unit"], spec["control_spring"]
        net = (
            unit["gain"] - (group["inner_radius"] + group["outer_radius"]) * unit["key_friction"] / unit["hub_diameter"]
        )
        leaves = rng.uniform(0.1, 0.4)
        springs["force"] = spec["closing_spring"]["force"] * (1 + group["pairs"] * net * leaves)
        spec["friction"] = {"min": 0.85 * leaves, "mean": 0.86 * leaves, "max": 1.2 * leaves}
        spec["adjustment"] = {"method": "min-friction", "margin": 2.0}
        asked, frictions = ask(spec), [share * leaves for share in shares]
        single = asked.answer("simulate --yes " + " ".join(f"--friction {one!r}" for one in frictions))
        table = asked.answer("simulate --yes --sweep friction.max=" + ",".join(map(repr, frictions)))["sweep"][0]
        low = max(single["peak_torque_clutch"][at] for at in ("min", "mean"))
        for one, shaft, ball in zip(
            single["points"], table["peak_torque_max"], table["peak_torque_clutch"], strict=True
        ):
            expected = max(low, one["peak_torque_clutch"])
            if abs(shaft / one["peak_torque"] - 1) > 1e-3 or abs(ball / expected - 1) > 5e-3:
                wrong.append(
                    f"{asked.file}, f = {one['friction']!r}: {one['peak_torque']} {expected}, swept {shaft} {ball}"
                )
    assert not wrong, "\n".join(wrong)


def test_about_the_setting_a_sweep_tells_what_an_event_does(ask):
    check_band(ask, range(400, 401), (0.95, 1.02))


@pytest.mark.exhaustive
def test_about_the_setting_every_sweep_tells_what_an_event_does(ask):
    check_band(ask, range(401, 412), (0.9, 0.93, 0.95, 0.97, 0.99, 1.0, 1.02, 1.05))


def test_no_friction_exceeds_what_is_told(ask):
    check_extremes(ask, range(100, 102))


@pytest.mark.exhaustive
def test_no_friction_exceeds_what_is_told_of_many_clutches(ask):
    check_extremes(ask, range(102, 160))


OF_A_ROW = {
    "nominal_torque": "torque: nominal_torque",
    "accuracy_factor": "torque: accuracy_factor",
    "torque_max": required("torque_max"),
    "closing_force": "torque: closing_force",
    "control_force": "torque: control_force",
    "pack_force_at_rest": "torque: pack_force_at_rest",
    "gain": "torque: gain",
    "travel": "torque: travel/max",
    "contact_force": "synthesize: contact_force",
    "surface_pressure": required("surface_pressure"),
}


def wanted(rng: np.random.Generator, objectives: list[str]) -> dict[str, Any]:
    """Requirements of a small random search, direct and indirect."""
    spans = {"mean_radius": (0.06, 0.14, 5), "gain": (0.1, 1.25, 6)}
    return {
        "variants": ["conventional", "differentiated", "all-driving", "indirect"],
        "objectives": objectives,
        "friction": friction(rng),
        "wanted": {
            "nominal_torque": rng.uniform(80, 400),
            "accuracy_factor": rng.uniform(2, 4),
            "method": str(rng.choice(["min-friction", "mean-friction"])),
            "margin": rng.uniform(1, 1.5),
        },
        "search": {
            "pairs": [4, 8, 12, 16],
            "driving_pairs": [1, 2],
            **{name: {"start": a, "stop": b * rng.uniform(0.9, 1), "count": n} for name, (a, b, n) in spans.items()},
            "ball_circle_radius": [0.04, 0.05, 0.06],
            "closing_force": {"min": 300, "max": 9000},
            "closing_stiffness": [2e5, 4e5],
            "control_stiffness": [1e5, 2e5],
        },
        "fixed": {
            "balls": 6,
            "face_gap": 0.002,
            "edge_clearance": 0.002,
            "face_width": 0.03,
            "hub_diameter": 0.05,
            "key_friction": 0.01,
        },
        "limits": {"surface_pressure": 6e5, "contact_force": 5e3},
    }


def check_designs(afmcalc, ask: Callable[[dict[str, Any]], Asked], tmp_path: Path, seeds: range, picks: int) -> None:
    """A row of the front is the clutch that its file describes, and check passes it."""
    wrong, fronts = [], 0
    for seed in seeds:
        rng = np.random.default_rng(seed)
        second = str(rng.choice(["accuracy_factor", "ball_diameter", "pairs"]))
        file = tmp_path / f"wanted-{seed}.json"
        file.write_text(json.dumps(wanted(rng, ["closing_force", second])))
        ran = afmcalc("design", file, "--json")
        if ran.code:
            assert "nothing" in ran.err, ran.err
            continue
        front = ran.json["result"]["front"]
        fronts += bool(front)
        for number in sorted({*np.linspace(1, len(front), picks).astype(int)}) if front else ():
            picked = tmp_path / f"picked-{seed}-{number}.json"
            answer = afmcalc("design", file, "--pick", number, "--json")
            picked.write_text(answer.out)
            checked = afmcalc("check", picked)
            if checked.code:
                wrong.append(
                    f"design {file} --pick {number}: check says "
                    + "; ".join(re.findall("error: .*", checked.out + checked.err))
                )
                continue
            asked = ask(answer.json["spec"])
            row = answer.json["result"].get("picked") or front[number - 1]
            near = 1e-9 if "picked" in answer.json["result"] else 1e-6
            for column, place in OF_A_ROW.items():
                told = asked.told(place)
                if row[column] is not None and (told is None or abs(told - row[column]) > near * abs(row[column])):
                    wrong.append(f"design {file} --pick {number}: {column} {row[column]!r}, {place} {told!r}")
    assert not wrong, f"{len(wrong)}\n" + "\n".join(wrong)
    assert fronts


def test_a_picked_row_is_the_clutch_of_its_file(afmcalc, ask, tmp_path):
    check_designs(afmcalc, ask, tmp_path, range(500, 501), 3)


@pytest.mark.exhaustive
def test_every_picked_row_is_the_clutch_of_its_file(afmcalc, ask, tmp_path):
    check_designs(afmcalc, ask, tmp_path, range(501, 541), 1000)
