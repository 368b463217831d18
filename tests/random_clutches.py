"""Random specs of every variant and of all keys of a clutch, as plain data; some are refused."""

import random
from collections.abc import Iterator
from typing import Any

VARIANTS = ("conventional", "differentiated", "unlike", "all-driving", "indirect")
DISC = {"outer_diameter": 0.1, "inner_diameter": 0.051, "thickness": 0.005, "free_height": 0.00775}


def random_clutches(count: int, seed: int, variants: tuple[str, ...] = VARIANTS) -> Iterator[dict[str, Any]]:
    """Specs, the variants in turn."""
    rnd = random.Random(seed)
    for number in range(count):
        yield _clutch(rnd, variants[number % len(variants)])


def _range(rnd: random.Random) -> dict[str, float]:
    low = rnd.uniform(0.03, 0.3)
    high = low + rnd.uniform(0.02, 0.6)
    found = {"min": low, "max": high}
    if rnd.random() < 0.7:
        found["mean"] = rnd.uniform(low, high)
    return found


def _clutch(rnd: random.Random, variant: str) -> dict[str, Any]:
    pairs, radius = rnd.randint(2, 16), rnd.uniform(0.02, 0.3)
    group: dict[str, Any] = {"pairs": pairs, "mean_radius": radius}
    if rnd.random() < 0.4:
        group |= {"inner_radius": radius * 0.8, "outer_radius": radius * 1.2}
        del group["mean_radius"]
        if rnd.random() < 0.7:
            group["radius_model"] = rnd.choice(["uniform-wear", "uniform-pressure"])
    spec: dict[str, Any] = {
        "variant": "differentiated" if variant == "unlike" else variant,
        "friction": {"driving": _range(rnd), "driven": _range(rnd)} if variant == "unlike" else _range(rnd),
        "friction_group": group,
        "closing_spring": {"force": rnd.uniform(100, 2e4)},
        "adjustment": {"method": rnd.choice(["min-friction", "mean-friction"]), "margin": rnd.choice([1.0, 1.25, 1.7])},
        "fatigue": {"endurance_limit": 1e8, "polar_section_modulus": rnd.uniform(2e-6, 5e-5)},
    }
    spec["fatigue"] |= {"exponent": 6, "base_cycles": 1e7}
    if variant in ("differentiated", "unlike") and rnd.random() < 0.8:
        group["driving_pairs"] = rnd.randint(1, pairs - 1)
    if variant != "unlike" and rnd.random() < 0.1:
        spec["friction"] = {"material": rnd.choice(["moulded-dry", "woven-dry", "sintered-oil", "paper-oil"])}
    if variant != "conventional":
        spec["control_unit"] = {"gain": rnd.uniform(0.01, 1.5)}
        if variant != "indirect" and rnd.random() < 0.05:
            spec["control_unit"]["gain"] = 0.0
    if variant == "indirect":
        _sleeve(rnd, spec, radius)
    elif rnd.random() < 0.2:
        spec["closing_spring"] = {"force": rnd.uniform(500, 9e3), "disc": DISC | {"series": 4}}
    if variant != "conventional":
        _unit(rnd, spec["control_unit"], variant)
    if rnd.random() < 0.3:
        force = spec["closing_spring"].pop("force")
        spec["adjustment"]["nominal_torque"] = force * pairs * radius * rnd.uniform(0.02, 0.3)
        spec.get("control_spring", {}).pop("force", None)
    _around(rnd, spec)
    return spec


def _sleeve(rnd: random.Random, spec: dict[str, Any], radius: float) -> None:
    closing, hub, key = spec["closing_spring"], rnd.uniform(0.02, 0.2), rnd.choice([0.0, rnd.uniform(0, 0.2)])
    closing["stiffness"] = rnd.uniform(5e3, 8e5)
    control = spec["control_spring"] = {"stiffness": rnd.choice([0.0, *[rnd.uniform(5e3, 8e5)] * 5])}
    unit = spec["control_unit"]
    unit |= {"hub_diameter": hub, "key_friction": key, "gain": 2.04 * radius * key / hub + rnd.uniform(0.05, 2)}
    kind = rnd.random()
    if kind < 0.25:
        unit["gain_slope"] = rnd.uniform(1, 300)
    elif kind < 0.5:
        unit["pocket"] = "constant-torque"
    if rnd.random() < 0.35:
        control["force"] = closing["force"] * rnd.uniform(0.8 if kind > 0.5 else 1.05, 4)
    if rnd.random() < 0.2:
        closing |= {"force": rnd.uniform(800, 9e3), "stiffness": 1e6, "disc": DISC | {"series": rnd.randint(4, 12)}}
        control.pop("force", None)
        if rnd.random() < 0.5:
            control["disc"] = DISC | {"thickness": 0.006, "free_height": 0.0082, "series": rnd.randint(8, 20)}
            control["disc"]["parallel"] = 2


def _unit(rnd: random.Random, unit: dict[str, Any], variant: str) -> None:
    unit |= {"ball_circle_radius": rnd.uniform(0.02, 0.2), "balls": rnd.randint(3, 9)}
    if rnd.random() < 0.2:
        unit |= {"face_gap": rnd.uniform(0, 0.004), "edge_clearance": rnd.uniform(0.001, 0.004)}
    if rnd.random() < 0.2:
        unit["ball_diameter"] = rnd.uniform(0.01, 0.05)
    if rnd.random() < 0.2:
        unit["contact"] = {
            "ball_modulus": 2.1e11, "ball_poisson": 0.28, "wall_modulus": 1.9e11, "wall_poisson": 0.31, "allowable_pressure": 3e9
        }  # fmt: skip
    if variant != "indirect" and rnd.random() < 0.3:
        del unit["gain"]
        unit["wall_angle"] = rnd.uniform(0.1, 1.2)
    if rnd.random() < 0.1:
        del unit["balls"]
    if rnd.random() < 0.1:
        del unit["ball_circle_radius"]
        if "wall_angle" in unit:
            unit["ball_circle_radius"] = 0.05


def _around(rnd: random.Random, spec: dict[str, Any]) -> None:
    if rnd.random() < 0.5:
        spec["drive"] = {"dynamic_factor": rnd.uniform(1, 2)}
    if rnd.random() < 0.3:
        spec["fatigue"]["ultimate_strength"] = rnd.uniform(2e7, 9e8)
    if rnd.random() < 0.3:
        spec["shaft"] = {"diameter": rnd.uniform(0.02, 0.06)}
        del spec["fatigue"]["polar_section_modulus"]
        if rnd.random() < 0.5:
            spec["shaft"]["yield_strength"] = 4e8
    if rnd.random() < 0.3:
        spec["machine"] = {"power": rnd.uniform(1e3, 5e4), "speed": rnd.uniform(50, 300)}
        if rnd.random() < 0.6:
            spec["machine"] |= {
                "ratio": rnd.uniform(1, 5), "efficiency": 0.9, "service_factor": 1.5, "starting_torque_ratio": 2.2,
            }  # fmt: skip
