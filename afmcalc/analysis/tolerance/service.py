"""Friction varies from slip to slip, the rest from clutch to clutch: a clutch's life is that of all its slips."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from ...arrays import Values
from ...engines import Clutch
from ...equations import life as law
from ...spec.tolerance import FRICTION
from .distributions import Array, Input, normal_probability, normal_score
from .model import Model
from .quadrature import gauss

_LEAST, _MOST, _MOST_OF_TWO = 8, 64, 16
"""Nodes per friction."""
_ENOUGH = 1e-6
"""Relative change of the life at which more nodes are not worth their time."""


class Slip(NamedTuple):
    """One slip that stands for a share of all."""

    share: float
    frictions: Mapping[str, float]
    """By path."""


def service_of(model: Model) -> list[Slip]:
    """Slips that stand for the service of a clutch, as many as the clutch as drawn needs."""
    frictions = [each for each in model.inputs if each.path in FRICTION]
    clutch = model.clutch([each.center for each in model.inputs])
    most, count = _MOST if len(frictions) < 2 else _MOST_OF_TWO, _LEAST
    bend = None if clutch.leaving_friction is None else float(clutch.leaving_friction)
    slips = slips_of(frictions, model.correlation, count, bend)
    life = float(life_of(model, clutch, slips))
    while count < most and len(slips) > 1:
        last, count = life, 2 * count
        slips = slips_of(frictions, model.correlation, count, bend)
        life = float(life_of(model, clutch, slips))
        if abs(life / last - 1) < _ENOUGH:
            break
    return slips


def slips_of(frictions: list[Input], correlation: float, count: int, bend: float | None = None) -> list[Slip]:
    """Gauss nodes of the friction in service, ``count`` for each; a single slip where none scatters.

    Where the sleeve leaves its stop, at ``bend``, the torque bends.
    """
    found: list[Slip] = [Slip(1.0, {})]
    for number, each in enumerate(frictions):
        before = frictions[0] if number and correlation else None
        found = [
            Slip(slip.share * float(share), {**slip.frictions, each.path: float(value)})
            for slip in found
            for value, share in zip(*_nodes(each, count, before, slip, correlation, bend), strict=True)
        ]
    return found


def _nodes(
    each: Input, count: int, before: Input | None, slip: Slip, correlation: float, bend: float | None
) -> tuple[Array, Array]:
    """Nodes of one friction; where it hangs on the one before, those left by its value (Gaussian copula)."""
    if before is None:
        return gauss(each, count, bend)
    z, weights = np.polynomial.hermite_e.hermegauss(count if abs(correlation) < 1 else 1)
    score = normal_score(np.array([before.share_below(slip.frictions[before.path])]))
    scores = correlation * score + (1 - correlation**2) ** 0.5 * z
    return each.quantiles(normal_probability(scores)), weights / weights.sum()


def life_of(model: Model, clutch: Clutch, slips: list[Slip]) -> Values:
    """Slips to failure of the protected side (Miner): each slip does the damage 1/N of its torque.

    Args:
        model: what scatters.
        clutch: one clutch or, its values being arrays, many.
        slips: its service.
    """
    total: Values = 0.0
    for slip in slips:
        total = total + slip.share * damage_of(clutch, model.torque_of(clutch, slip.frictions))
    slips_to_failure: Values = law.cycles_of_mean_damage(total)
    return slips_to_failure


def damage_of(clutch: Clutch, torque: Values) -> Values:
    """Damage of one slip on the protected side, by the paper's S–N line."""
    part = clutch.spec.fatigue
    assert part is not None
    stress = law.shear_stress(torque, part.polar_section_modulus)
    damage: Values = law.damage(part.endurance_limit, stress, part.exponent, part.base_cycles)
    return damage


def unprotected(clutch: Clutch, life: Values) -> Values:
    """Slips to failure of the unprotected side, all torques being k_д times those of the protected one (S–N line)."""
    part, factor = clutch.spec.fatigue, clutch.spec.drive.dynamic_factor
    assert part is not None
    assert factor is not None
    slips: Values = life / factor**part.exponent
    return slips
