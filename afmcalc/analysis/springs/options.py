"""A part as it is told of: what it gives, and what it bears."""

import math
from typing import Any

from ...engines.characteristic import CoilCharacteristic, characteristic
from ...engines.parts import demands
from ...engines.wish import Wish
from ...equations import springs as law
from ...spec.catalogues import discs
from ...spec.springs import CoilSprings, DiscStack
from .candidates import STEEL, Candidate, label_of
from .result import SpringOption
from .stacks import stack_of

SETTING = 0.05
"""Share of the force that the nut is to set more or less."""
_BORNE = ("deflection", "stress", "fatigue")
"""Demands that tell how much of what it bears a part uses."""


def named(wish: Wish, part: DiscStack | CoilSprings) -> SpringOption:
    """The part that a spec names."""
    deflection = float(characteristic(part).deflection(wish.force))
    found = option_of(wish, Candidate(part, label_of(part), deflection, {}))
    return found.model_copy(update={"spring": wish.name})


def option_of(wish: Wish, found: Candidate) -> SpringOption:
    """A part as set, and in service."""
    own, part, deflection = characteristic(found.part), found.part, found.deflection
    force, stiffness = float(own.force(deflection)), float(own.stiffness(deflection))
    low, high = deflection - wish.relaxes, deflection + wish.compresses
    setting = float(own.deflection((1 + SETTING) * force) - own.deflection((1 - SETTING) * force))
    common = {
        "number": None,
        "part": found.label,
        "force": force,
        "force_least": None if low < 0 else float(own.force(low)),
        "force_largest": float(own.force(high)),
        "stiffness": stiffness,
        "deflection": deflection,
        "length_set": own.free_length - deflection,
        "length": own.free_length - low,
        "free_length": own.free_length,
        "used_low": low / own.end,
        "used_high": high / own.end,
        "loss_per_travel": stiffness / force,
        "loss_per_wear": None if wish.follows is None else wish.follows * stiffness / force,
        "utilisation": max(each.utilisation for each in demands(wish, part) if each.rule.misses in _BORNE),
        "travel_setting": setting,
        "turns_setting": None if wish.pitch is None else setting / wish.pitch,
    }
    if isinstance(own, CoilCharacteristic):
        return SpringOption(**common, **_coil(own, wish, high))
    assert isinstance(part, DiscStack)
    middle, edge = own.stresses(high)
    return SpringOption(
        **common,
        **_friction(wish, force, part.parallel),
        kind="disc",
        parallel=part.parallel,
        series=part.series,
        count=None,
        turns=None,
        outer_diameter=part.outer_diameter,
        inner_diameter=part.inner_diameter,
        loading=None,
        stress_correction=None,
        stress=edge,
        stress_middle=middle,
        mass=part.parallel
        * part.series
        * float(law.ring_mass(STEEL, part.outer_diameter, part.inner_diameter, own.thickness, math.pi)),
    )


def _coil(own: CoilCharacteristic, wish: Wish, high: float) -> dict[str, Any]:
    part, rests = own.part, wish.stroke is None
    correction = 1.0 if rests else own.correction
    mass = law.coil_mass(STEEL, part.wire_diameter, part.coil_diameter, part.turns, math.pi)
    return {
        "kind": "coil",
        "parallel": None,
        "series": None,
        "count": part.count,
        "turns": part.turns,
        "outer_diameter": part.coil_diameter + part.wire_diameter,
        "inner_diameter": part.coil_diameter - part.wire_diameter,
        "loading": "static" if rests else "dynamic",
        "stress_correction": correction,
        "stress": correction * own.stress(high),
        "stress_solid": own.stress(own.end),
        "force_up": None,
        "force_down": None,
        "mass": part.count * float(mass),
    }


def _friction(wish: Wish, force: float, parallel: int) -> dict[str, float | None]:
    if wish.friction is None:
        return {"force_up": None, "force_down": None}
    surface, edge = wish.friction
    return {
        "force_up": float(law.stack_force_with_friction(force, parallel, surface, edge)),
        "force_down": float(law.stack_force_with_friction(force, parallel, -surface, -edge)),
    }


def part_of(option: SpringOption) -> DiscStack | CoilSprings:
    """The part as a spec says it."""
    if option.kind == "disc":
        (disc,) = (each for each in discs() if option.part.endswith(f" {each.name}"))
        assert option.parallel is not None
        assert option.series is not None
        return stack_of(disc, option.parallel, option.series)
    wire = (option.outer_diameter - option.inner_diameter) / 2
    return CoilSprings(
        wire_diameter=wire,
        coil_diameter=option.outer_diameter - wire,
        turns=option.turns,
        free_length=option.free_length,
        count=option.count,
    )
