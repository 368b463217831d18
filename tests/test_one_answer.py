"""One question, one answer: several commands give the same number, and no friction gives a torque beyond the extremes.

Extremes are searched over 10⁴ frictions, and by a law written here from the balance of the sleeve (theory, 5 and 12).
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
from conftest import slow
from sources import table

import afmcalc

DIRECT = ("conventional", "differentiated", "unlike", "all-driving")
KINDS = (*DIRECT, "straight", "curved", "steep", "constant-torque")
Rng, Spec = np.random.Generator, dict[str, Any]


def friction(rng: Rng) -> dict[str, float]:
    """A friction range with its mean anywhere in the range."""
    low, spread = rng.uniform(0.04, 0.25), rng.uniform(1.3, 7)
    return {"min": low, "mean": low * rng.uniform(1, spread), "max": low * spread}


def clutch(rng: Rng, kind: str) -> Spec:
    """A random clutch, set by either method, with a torque margin."""
    pairs, force, given = int(rng.integers(2, 13)), rng.uniform(300, 8000), friction(rng)
    inner, wide = rng.uniform(0.04, 0.12), rng.uniform(1.15, 1.6)
    radius, margin = inner * (1 + wide) / 2, max(1.0, rng.uniform(0.7, 2))
    unit = {"ball_circle_radius": radius * rng.uniform(0.4, 0.9), "balls": int(rng.integers(3, 9))}
    spec: Spec = {
        "variant": "differentiated" if kind == "unlike" else kind if kind in DIRECT else "indirect",
        "friction": {"driving": given, "driven": friction(rng)} if kind == "unlike" else given,
        "friction_group": {"pairs": pairs, "inner_radius": inner, "outer_radius": inner * wide},
        "closing_spring": {"force": force},
        "control_unit": unit | {"face_gap": 0.002, "edge_clearance": 0.002, "allowable_contact_force": 5e3},
        "adjustment": {"method": str(rng.choice(["min-friction", "mean-friction"])), "margin": margin},
        "drive": {"dynamic_factor": rng.uniform(1, 2)},
        "fatigue": {"endurance_limit": 1e6, "polar_section_modulus": 3e-5, "exponent": 6.0, "base_cycles": 1e7},
    }
    if kind == "conventional":
        del spec["control_unit"]
    elif kind == "all-driving":
        spec["control_unit"]["gain"] = rng.uniform(0, 6) / pairs
    elif kind in DIRECT:
        spec["friction_group"]["driving_pairs"] = driving = int(rng.integers(1, pairs))
        spec["control_unit"]["gain"] = rng.uniform(0, 2) / driving / given["max"]
    else:
        made_indirect(spec, rng, kind, radius)
    return spec


def made_indirect(spec: Spec, rng: Rng, kind: str, radius: float) -> None:
    """Add key and springs, the control spring as set or as made; the sleeve of a steep pocket jumps off its stop."""
    given, pairs, force = spec["friction"], spec["friction_group"]["pairs"], spec["closing_spring"]["force"]
    hub, key, net = radius * rng.uniform(0.4, 0.9), float(rng.choice([0, 0.01, 0.1])), rng.uniform(0.05, 2)
    closing, control = force / rng.uniform(0.002, 0.03), (rng.random() < 0.9) * force / rng.uniform(0.002, 0.05)
    spec["closing_spring"]["stiffness"], spec["control_spring"] = closing, {"stiffness": control}
    spec["control_unit"] |= {"hub_diameter": hub, "key_friction": key, "gain": net + 2 * radius * key / hub}
    leaves = given[spec["adjustment"]["method"].removesuffix("-friction")]
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


def drive(spec: Spec, rng: Rng) -> Spec:
    """Put a clutch in a drive whose tool is stopped or overloaded; the discs take the heat."""
    event = {"kind": "stop", "stop_time": rng.uniform(0.004, 0.02)}
    spec["drive"] = {
        "speed": rng.uniform(8, 30), "motor_inertia": rng.uniform(0.1, 0.5), "cut_off": 0.05, "event": event,
    }  # fmt: skip
    spec["drive"] |= {"driven_inertia": rng.uniform(0.01, 0.05), "shaft_stiffness": rng.uniform(3e3, 9e3)}
    spec["drive"] |= {"damping_ratio": rng.uniform(0.02, 0.08)}
    if spec["variant"] == "indirect":
        spec["drive"]["hub_inertia"] = rng.uniform(0.002, 0.006)
    elif rng.random() < 0.3:
        spec["drive"]["event"] = {"kind": "load", "torque": 1e4, "rise_time": rng.uniform(0, 0.02)}
        spec["drive"]["tool_inertia"] = rng.uniform(0.1, 0.5)
    heat = {"disc_mass": 1.6, "specific_heat": 480, "conductivity": 50, "density": 7850}
    return spec | {"heat": heat | {"cooling": 2.5, "ambient": 293.15}}


TOLD, SCATTERED, SPRUNG, PRINTED, EVENT = table("told").values()
"""Tables: quantity → every place that tells it, a command and the path in its answer."""


def rows(table: str) -> dict[str, list[str]]:
    split = (row.replace("\n  ", " | ").split(": ", 1) for row in re.split(r"\n(?=\S)", table.strip()))
    return {quantity: places.split(" | ") for quantity, places in split}


AT_LEAST = {"nominal_torque", "machine_torque", "cycles"}


def limit(key: str) -> str:
    return f"requirements.{key}={1e-9 if key in AT_LEAST else '9m' if key == 'travel' else 1e9}"


class Asked:
    """A clutch, and the answers of the commands about it, each asked once."""

    def __init__(self, run: Callable[..., Any], spec: Spec, file: Path) -> None:
        self.run, self.spec, self.file, self.answers = run, spec, file, dict[str, Any]({"none": {}})
        file.write_text(json.dumps(spec))
        given, method = spec["friction"], spec["adjustment"]["method"]
        ends = [one["max"] for one in ((given["driving"], given["driven"]) if "driven" in given else (given,))]
        self.words = {
            "variant": spec["variant"],
            "f_max": ",".join(map(repr, ends)),
            "sweep": f"--sweep z={spec['friction_group']['pairs']}",
            "scatter": 'tolerance.fields={friction={distribution="uniform"}} tolerance.sobol_base=64'
            " tolerance.quantiles=[1e-9,0.999999999]",
            "judged": " ".join(["check", *map(limit, ("peak_torque", "work", "temperature"))]),
            "overload": "overload" if method == "min-friction" else "none",  # S22 sets at f_min; overload says so
            "method": "none" if "force" in spec.get("control_spring", {}) else method.replace("-", "_"),
        }
        # with a given force of the control spring several closing forces, or none, may give the same torque
        goal = f"solve --for F nominal_torque={self.told('torque > nominal_torque')!r}"
        self.words["solve"] = "none" if self.words["method"] == "none" else goal

    def answer(self, command: str) -> Any:
        if command not in self.answers:
            head, *rest = command.split()
            if head.startswith("python-"):
                answer = getattr(afmcalc.load(self.file), head.removeprefix("python-"))()
            elif head == "report":
                answer = rows_of(self.run("report", self.file).out)
            else:
                words = [f"--set={one}" if one.startswith(("tolerance.", "requirements.")) else one for one in rest]
                ran = self.run(head, *words, self.file, "--json")
                answer = ran.json["result"] if ran.code in (0, 1) else {}
            self.answers[command] = answer
        return self.answers[command]

    def told(self, place: str) -> Any:
        """The number at a place of an answer; None if this clutch has no such number."""
        if place.startswith("= "):
            return DERIVED[place[2:]](self)
        if place.startswith("required "):
            place = f"check {limit(place[9:])} > checks/path=requirements.{place[9:]}/value"
        command, path = place.format_map(self.words).split(" > ")
        value = self.answer(command)
        for step in path.split("/"):
            if step in ("#min", "#max"):
                numbers = [one for one in value.values() if one is not None] if value else []
                value = (min if step == "#min" else max)(numbers, default=None)
            elif isinstance(value, list):
                key, _, wanted = step.rpartition("=")
                fitting = [one for one in value if one[key] == wanted] if key else value[int(step) :][:1]
                value = fitting[0] if fitting else None
            else:
                value = value.get(step) if isinstance(value, dict) else getattr(value, step, None)
        return value

    def apart(self, table: str, relative: float, telling: set[str]) -> Iterator[str]:
        """Quantities to which two places give different numbers, with these numbers; notes all places with a number."""
        for quantity, places in rows(table).items():
            values = {place: self.told(place) for place in places}
            numbers = [value for value in values.values() if value is not None]
            telling.update(place for place, value in values.items() if value is not None)
            scale = self.told("torque > torque/max") if quantity == "scatter" else max(map(abs, numbers), default=0.0)
            if numbers and max(numbers) - min(numbers) > relative * scale:  # a scatter is a difference of torques
                told = "".join(f"\n    {value!r:24} {place.format_map(self.words)}" for place, value in values.items())
                yield f"{quantity} of {json.dumps(self.spec)}{told}"


def rows_of(page: str) -> dict[str, list[float]]:
    """Text in a row of a report's tables → numbers of that row, or of the first of several rows with this text."""
    rows = [re.findall(r"<t[dh]([^>]*)>(.*?)</t[dh]>", row, re.S) for row in re.findall("<tr>(.*?)</tr>", page, re.S)]
    bare = re.compile("<.*?>")
    plain = [[("number" in kind, bare.sub("", text.replace("<sub>", "_"))) for kind, text in row] for row in rows]
    return {
        name: [float(text) for is_number, text in row if is_number and re.fullmatch(r"[\d.]+", text)]
        for row in reversed(plain)
        for is_number, name in row
        if not is_number
    }


def extremes(asked: Asked) -> tuple[float, float]:
    return asked.told("torque > torque_range/low"), asked.told("torque > torque_range/high")


def cycles(asked: Asked, low: float, high: float, factor: float = 1.0) -> float:
    """Cycles to failure, S19 (19)."""
    fatigue = asked.spec["fatigue"]
    stress = factor * (low + high) / 2 / fatigue["polar_section_modulus"]
    return float(fatigue["base_cycles"] * (fatigue["endurance_limit"] / stress) ** fatigue["exponent"])


def pressure(asked: Asked) -> float:
    group = asked.spec["friction_group"]
    force = asked.told("torque > pack_force_at_rest") or asked.told("torque > closing_force")
    return float(force / math.pi / (group["outer_radius"] ** 2 - group["inner_radius"] ** 2))


def peak(asked: Asked) -> float:
    """The peak torque that is judged, with that of the bypass pairs (finding bypass-peak)."""
    return float(max(asked.told("simulate > peak_torque/#max"), asked.told("simulate > peak_torque_bypass") or 0.0))


def dynamic_factor(asked: Asked) -> float:
    """The largest dynamic factor that a life takes, with that of the bypass pairs, which may hold first at f_max."""
    bypass = asked.told("simulate > peak_torque_bypass") or 0.0
    slipping = asked.told("simulate > dynamic_factor/#max")
    return float(max(slipping, bypass / asked.told("simulate > sliding_torque/max")))


DERIVED: dict[str, Callable[[Asked], float]] = {
    "high - low": lambda asked: extremes(asked)[1] - extremes(asked)[0],
    "high / low": lambda asked: extremes(asked)[1] / extremes(asked)[0],
    "pressure at rest": pressure,
    "peak, bypass pairs included": peak,
    "dynamic factor, bypass pairs included": dynamic_factor,
    "cycles": lambda asked: cycles(asked, *extremes(asked)),
    "unprotected cycles": lambda asked: cycles(asked, *extremes(asked), asked.spec["drive"]["dynamic_factor"]),
}


@pytest.fixture
def ask(afmcalc, tmp_path) -> Callable[[Spec], Asked]:
    """Ask the commands of a spec."""
    names = itertools.count()
    return lambda spec: Asked(afmcalc, spec, tmp_path / f"{next(names)}.json")


def some(seeds: range, kinds: tuple[str, ...] = KINDS) -> Iterator[tuple[Rng, str, Spec]]:
    for seed, kind in itertools.product(seeds, kinds):
        rng = np.random.default_rng([seed, KINDS.index(kind)])
        yield rng, kind, clutch(rng, kind)


def verdict(wrong: list[str], telling: set[str], *tables: str) -> None:
    places = {place for table in tables for row in rows(table).values() for place in row}
    assert not wrong, f"{len(wrong)} disagreements\n" + "\n".join(wrong)
    assert not (silent := places - telling), f"places that never tell a number: {silent}"


TELLING, AGREED = set[str](), set[str]()  # Places that told a number of any clutch, and kinds of the clutches
QUICK = ["unlike"]


@pytest.mark.parametrize("kind", [*QUICK, *slow(*(each for each in KINDS if each not in QUICK))])
def test_a_quantity_is_one_number(kind, ask):
    ((_, _, spec),) = some(range(2, 3), (kind,))
    asked = ask(spec)
    wrong = [*asked.apart(TOLD, 1e-9, TELLING)]
    # the two frictions of unlike materials scatter apart; samples miss a peak just before a jump
    wrong += asked.apart(SCATTERED, 1e-3, TELLING) if kind not in ("unlike", "steep", "curved") else []
    AGREED.add(kind)
    assert not wrong, "\n".join(wrong)


def test_every_place_tells_a_number():
    """This test needs the clutches of the test before it, if that ran with all of them."""
    if {*KINDS} == AGREED:
        verdict([], TELLING, TOLD, SCATTERED)


@pytest.mark.parametrize("kind", ["differentiated", *slow("straight")])
def test_springs_are_chosen_for_the_forces_of_the_clutch(kind, ask):
    for _, _, spec in some(range(2, 3), (kind,)):
        telling = set[str]()
        assert not [*ask(spec).apart(SPRUNG, 1e-9, telling)]
        assert len(telling) == (4 if kind == "straight" else 2)


EVERY_KIND = slow((("conventional", "all-driving", "curved"),), (("curved",),))


@pytest.mark.parametrize("kinds", [("conventional",), *EVERY_KIND])
def test_a_report_prints_what_the_commands_tell(kinds, ask, undrawn):
    wrong, telling = [], set[str]()
    for _, _, spec in some(range(200, 201), kinds):
        wrong += ask(spec).apart(PRINTED, 1e-4, telling)
    verdict(wrong, telling, PRINTED)


@pytest.mark.parametrize("kinds", [("unlike",), *EVERY_KIND])
def test_an_event_is_one_number(kinds, ask):
    wrong, telling = [], set[str]()
    for rng, _, spec in some(range(301, 302), kinds):
        wrong += ask(drive(spec, rng)).apart(EVENT, 1e-9, telling)
    verdict(wrong, telling, EVENT)


class Law:
    """Torque and friction of an indirect clutch as functions of the sleeve's travel: no equation is solved."""

    def __init__(self, spec: Spec) -> None:
        group, unit, given = spec["friction_group"], spec["control_unit"], spec["friction"]
        self.radius, self.pairs = (group["inner_radius"] + group["outer_radius"]) / 2, group["pairs"]
        key = 2 * self.radius * unit["key_friction"] / unit["hub_diameter"]
        self.rising, self.returning = unit["gain"] - key, unit["gain"] + key
        self.force, self.closing = (spec["closing_spring"][name] for name in ("force", "stiffness"))
        self.springs = self.closing + spec["control_spring"]["stiffness"]
        at = given[spec["adjustment"]["method"].removesuffix("-friction")]
        self.control = spec["control_spring"].get("force", self.force * (1 + self.pairs * self.rising * at))
        self.leaves = (self.control / self.force - 1) / self.pairs / self.rising
        holding = self.springs / (self.pairs * self.leaves * self.force)
        self.slope = holding if "pocket" in unit else unit.get("gain_slope", 0.0)

    def moving(self, travel: Any, gain: float) -> tuple[Any, Any]:
        """Friction and torque at which the sleeve moves through a travel."""
        net, pull = gain + self.slope * travel, self.control - self.force + self.springs * travel
        return pull / (self.pairs * net * (self.force - self.closing * travel)), self.radius * pull / net

    def seated(self, friction: Any, gain: float) -> Any:
        return self.pairs * self.radius * friction * self.control / (1 + self.pairs * gain * friction)

    def rise(self, low: float, high: float, steps: int) -> tuple[Any, Any]:
        """Torque and travel as friction rises; the sleeve jumps to a larger travel that needs less friction."""
        travel = np.linspace(0, self.force / self.closing * (1 - 1e-9), 100 * steps)
        friction, torque = self.moving(travel, self.rising)
        passed = (friction >= np.maximum.accumulate(friction)) & (friction > max(low, self.leaves)) & (friction <= high)
        at_stop = np.linspace(low, max(low, min(high, self.leaves)), steps * (self.leaves > low * (1 - 1e-9)))
        torque = np.concatenate([self.seated(at_stop, self.rising), torque[passed]])
        return torque, np.concatenate([0 * at_stop, travel[passed]])

    def least_returning(self, low: float, high: float, most: float, steps: int) -> float:
        """Smallest torque as friction falls under load from ``high``: sleeve locked, then moving, then at the stop."""
        held = self.pairs * self.radius * (self.force - self.closing * most)
        locked = held if most else self.seated(high, self.rising) / high
        falls = high * (self.rising + self.slope * most) / (self.returning + self.slope * most)
        back = np.linspace(most, 0, 100 * steps)
        friction, torque = self.moving(back, self.returning) if most else (np.array([falls]),) * 2
        friction, torque = (one[: 1 + np.argmax([*(np.diff(friction) > 0), True])] for one in (friction, torque))
        seats = [self.seated(one, self.returning) for one in (low, friction[-1]) if friction[-1] > low]
        return float(min([locked * max(falls, low), *seats, *(torque[friction >= low] if most else [])]))


HARD = ("unlike", "all-driving", "curved", "steep", "constant-torque")


@pytest.mark.parametrize(
    ("seeds", "kinds"), [(range(102, 103), (kind,)) for kind in HARD] + slow((range(103, 105), KINDS))
)
def test_no_friction_exceeds_what_is_told(seeds, kinds, ask):
    wrong, steps = [], 3_001
    for _, kind, spec in some(seeds, kinds):
        asked, given = ask(spec), spec["friction"]
        torque_of = afmcalc.load(asked.file).torque
        groups = [given[name] for name in ("driving", "driven") if name in given]
        ends = [[one[name] for name in ("min", "mean", "max")] for one in groups or [given]]
        grids = [[np.interp(np.linspace(0, 2, steps), (0, 1, 2), one) for one in ends]]
        for _ in range(4):  # where it may jump, ever closer
            jump = np.abs(np.diff(torque_of(*grids[-1]))).argmax()
            grids.append([np.linspace(one[jump], one[jump + 1], steps) for one in grids[-1]])
        torque = np.concatenate([torque_of(*grid) for grid in grids])
        low, high = torque.min(), torque.max()
        searched = {"torque > torque_range/low": low, "torque > torque_range/high": high, "required torque_max": high}
        searched |= {"accuracy > accuracy_factor": high / low, "life > protected/as_set": cycles(asked, low, high)}
        if spec["variant"] == "indirect":
            law, unit, ends = Law(spec), spec["control_unit"], (given["min"], given["max"])
            torque, travel = law.rise(*ends, steps)
            least = law.least_returning(*ends, travel.max(), steps)
            tangent = unit["ball_circle_radius"] / law.radius * (unit["gain"] + law.slope * travel)
            force = torque * np.sqrt(1 + tangent**2) / unit["balls"] / unit["ball_circle_radius"]
            searched |= {"required torque_max": torque.max(), "pocket > contact_force": force.max()}
            searched["accuracy > accuracy_factor_hysteresis"] = torque.max() / least
        told = {place: asked.told(place) for place in searched}
        # no torque lies beyond the extremes that are told; the search misses either extreme by a part of its step
        room = {place: (-1, 1)[place.endswith(("low", "as_set"))] for place in searched}
        wrong += [
            f"{kind}, {place} tells {told[place]!r}, the search {float(value)!r}: {json.dumps(spec)}"
            for place, value in searched.items()
            if told[place] is None or not -1e-9 <= room[place] * (value / told[place] - 1) <= 2e-4
        ]
    assert not wrong, f"{len(wrong)}\n" + "\n".join(wrong)
