"""Requirements that a clutch answers, to search around it."""

from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel

from ...engines import Clutch
from ...spec.edit import value_at
from ...spec.models import resolved
from ...spec.requirements import Fixed, Limits, Wanted
from ...spec.rules import SHARED
from ...spec.write import value_as_written, written

_AROUND = 0.4
"""How far a searched length lies from that of the clutch, as a share of it."""
_FORCES = {"min": 0.25, "max": 4.0}
"""Ends of the force searched, as shares of that of the clutch."""
_COUNT = 9
"""Values of what is searched: few, for each may have to be simulated; whoever wants more writes more."""


def requirements_like(clutch: Clutch) -> dict[str, Any]:
    """Return the data of a requirements file: what the clutch is held to, searched around what it is.

    Where its [requirements] name no torque, that of the clutch is wanted.
    """
    spec, data = clutch.spec, resolved(clutch.spec)
    asked, unit, group = data.get("requirements", {}), data.get("control_unit", {}), data["friction_group"]
    wanted = _of(asked, Wanted, "requirements") | {name: data["adjustment"][name] for name in ("method", "margin")}
    if "machine" not in data and not {"nominal_torque", "machine_torque"} & wanted.keys():
        wanted["nominal_torque"] = value_as_written(float(f"{clutch.nominal_torque:.4g}"), "N*m")
    outer = "outer_radius" in group
    force = float(clutch.pack_force_at_rest)
    search: dict[str, Any] = {
        "pairs": {"start": spec.least_pairs, "stop": 2 * group["pairs"], "step": max(1, group["pairs"] // 4)},
        **({"inner_radius": value_as_written(group["inner_radius"], "m")} if outer else {}),
        "outer_radius" if outer else "mean_radius": _around(group["outer_radius" if outer else "mean_radius"]),
        "closing_force": {end: value_as_written(_round(force * share), "N") for end, share in _FORCES.items()},
    }
    if spec.kind.chooses_bypass:
        search["driving_pairs"] = group["driving_pairs"]
    if spec.kind.controlled:
        gain = max(float(clutch.quantities.get("gain_limit", 0.0)), 2 * float(clutch.gain))
        search["gain"] = {"start": 0.0, "stop": _round(gain), "count": _COUNT}
        circle = unit.get("ball_circle_radius", float(clutch.mean_radius) / 2)
        search["ball_circle_radius"] = value_as_written(_round(circle), "m")
    if spec.kind.travels:
        for name in ("closing", "control"):
            search[f"{name}_stiffness"] = value_as_written(value_at(spec, f"{name}_spring.stiffness"), "N/m")
    limits = _of(asked, Limits, "requirements")
    if "allowable_contact_force" in unit:
        limits["contact_force"] = value_as_written(unit["allowable_contact_force"], "N")
    called = {} if spec.name is None else {"name": str(spec.name)}
    return called | {
        "variants": [spec.variant],
        "objectives": ["closing_force", "accuracy_factor", "pairs"],
        "friction": data["friction"],
        "wanted": wanted,
        "search": search,
        "fixed": _of(unit, Fixed, "control_unit"),
        "limits": limits,
        **written({name: data[name] for name in SHARED if name in data}),
    }


def _of(given: Mapping[str, Any], model: type[BaseModel], table: str) -> dict[str, Any]:
    """Return what a table of the spec says of the keys of a table of requirements, with units."""
    chosen = {name: value for name, value in given.items() if name in model.model_fields}
    return written({table: chosen}).get(table, {})


def _around(length: float) -> dict[str, Any]:
    low, high = (value_as_written(_round(share * length), "m") for share in (1 - _AROUND, 1 + _AROUND))
    return {"start": low, "stop": high, "count": _COUNT}


def _round(value: float) -> float:
    """Round to two digits."""
    return float(f"{value:.2g}")
