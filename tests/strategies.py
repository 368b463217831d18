"""Random clutches for property tests."""

from typing import Any

from hypothesis import strategies as st

from afmcalc.spec import make_spec, read_spec
from afmcalc.spec.models import CoilSprings

FRICTION = st.floats(0.02, 1.0)
GAIN = st.one_of(st.just(0.0), st.floats(1e-6, 5))
"""Gain of 0, or one that a machine could have: with 1e-306 a wanted accuracy would take 1e306 pairs."""
CHARACTERS = st.one_of(*(st.integers(*ends) for ends in ((0, 127), (0, 0xD7FF), (0xE000, 0x10FFFF)))).map(chr)
"""Any character but a surrogate; ``st.characters`` would first make a table of all, which takes longer than a test."""


def p5(*overrides: str, **blocks: Any) -> Any:
    """The clutch of P5 (S21 fig. 2) with C = 1, F_п1 = 2 kN, its mean friction 0.3, with other values of some keys."""
    base = {
        "variant": "indirect", "friction": {"min": 0.1, "mean": 0.3, "max": 0.8},
        "friction_group": {"pairs": 8, "mean_radius": 0.1}, "closing_spring": {"force": 2e3, "stiffness": 20e3},
        "control_spring": {"stiffness": 10e3},
        "control_unit": {"gain": 1.0, "ball_circle_radius": 0.05, "hub_diameter": 0.05, "key_friction": 0.15},
        "adjustment": {"margin": 1.25},
        "fatigue": {"endurance_limit": 400e6, "polar_section_modulus": 15e-6, "exponent": 6, "base_cycles": 1e7},
    }  # fmt: skip
    return read_spec(base | blocks, overrides)


@st.composite
def ranges(draw: st.DrawFn) -> dict[str, float]:
    low = draw(st.floats(0.02, 0.5))
    high = draw(st.floats(low, 1.2))
    return {"min": low, "mean": draw(st.floats(low, high)), "max": high}


DIRECT = ("conventional", "differentiated", "unlike", "all-driving")


@st.composite
def direct_specs(draw: st.DrawFn, variants: tuple[str, ...] = DIRECT) -> Any:
    """A spec of any direct variant, SI."""
    variant = draw(st.sampled_from(variants))
    pairs = draw(st.integers(2, 30))
    data: dict[str, Any] = {
        "variant": "differentiated" if variant == "unlike" else variant,
        "friction": {"driving": draw(ranges()), "driven": draw(ranges())} if variant == "unlike" else draw(ranges()),
        "friction_group": {"pairs": pairs, "mean_radius": draw(st.floats(0.02, 0.5))},
        "closing_spring": {"force": draw(st.floats(10, 1e5))},
    }
    if variant in ("differentiated", "unlike"):
        data["friction_group"]["driving_pairs"] = draw(st.integers(1, pairs - 1))
    if variant != "conventional":
        data["control_unit"] = {"gain": draw(GAIN)}
    return make_spec(data)


@st.composite
def spaced_specs(draw: st.DrawFn) -> Any:
    """A spec of any variant with all that a layout needs, balls and springs included; its parts may collide."""
    data = draw(st.one_of(direct_specs(), indirect_specs())).model_dump(exclude_none=True)
    radius = data["friction_group"].pop("mean_radius")
    share = lambda low, high: draw(st.floats(low, high)) * radius  # noqa: E731
    data["friction_group"] |= {"inner_radius": share(0.5, 0.95), "outer_radius": share(1.05, 1.4)}
    if data["variant"] == "indirect":  # as much above what the key needs, whose threshold grows with the radius
        unit, group = data["control_unit"], data["friction_group"]
        mean = (group["inner_radius"] + group["outer_radius"]) / 2
        unit["gain"] += 2 * (mean - radius) * unit["key_friction"] / unit["hub_diameter"]
    data["envelope"] = {"disc_thickness": share(0.01, 0.06), "plate_thickness": share(0.04, 0.15)}
    data["envelope"]["housing_wall"] = share(0.03, 0.1)
    if data["variant"] != "indirect":
        data["envelope"]["hub_diameter"] = share(0.2, 1.0)
    if unit := data.get("control_unit"):
        unit |= {"ball_circle_radius": share(0.3, 1.0), "ball_diameter": share(0.08, 0.5), "balls": 6}
    for name in ("closing_spring", "control_spring") if data["variant"] == "indirect" else ("closing_spring",):
        wire, wide, turns = share(0.03, 0.12), share(0.6, 2.4), draw(st.integers(2, 4))
        coil = {"wire_diameter": wire, "coil_diameter": wide, "turns": turns}
        coil["free_length"] = (turns + 2) * wire * draw(st.floats(1.2, 2.0)) + turns * 0.01 * wide**2 / wire
        data[name]["coil"] = coil
        if "stiffness" in data[name]:
            data[name]["stiffness"] = CoilSprings(**coil).rate
    return make_spec(data)


@st.composite
def indirect_specs(
    draw: st.DrawFn, methods: tuple[str, ...] = ("min-friction", "mean-friction"), *, curved: bool = False
) -> Any:
    """A spec of an indirect clutch with a gain above its threshold; ``curved``: its pockets nearly hold the torque."""
    radius, key, hub = draw(st.floats(0.05, 0.3)), draw(st.floats(0, 0.3)), draw(st.floats(0.03, 0.2))
    threshold = 2 * radius * key / hub
    own, method = draw(ranges()), draw(st.sampled_from(methods))
    pairs, force = draw(st.integers(1, 20)), draw(st.floats(100, 1e4))
    closing, control = draw(st.floats(1e3, 1e5)), draw(st.floats(0, 1e5))
    unit = {"gain": threshold + draw(st.floats(1e-3, 5)), "ball_circle_radius": draw(st.floats(0.02, 0.2))}
    unit |= {"hub_diameter": hub, "key_friction": key, "balls": draw(st.integers(3, 12))}
    if curved:
        at_set = own["min" if method == "min-friction" else "mean"]
        holding = (closing + control) / (pairs * at_set * force)
        about = st.one_of(st.just(0.0), st.just(1.0), st.floats(1e-3, 1.1), st.floats(1, 4))
        unit["gain_slope"] = holding * draw(about)
    spec = {"variant": "indirect", "friction": own, "friction_group": {"pairs": pairs, "mean_radius": radius}}
    spec |= {"closing_spring": {"force": force, "stiffness": closing}, "control_spring": {"stiffness": control}}
    spec |= {"control_unit": unit, "adjustment": {"method": method, "margin": draw(st.floats(1, 2))}}
    return make_spec(spec)
