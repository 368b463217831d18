"""Friction in service: the life of a clutch over all its slips, and the exact torque where nothing else scatters.

Friction varies from slip to slip, the rest from clutch to clutch.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ...engines import Clutch
from ...equations import life as law
from ...equations.arrays import Values
from ...errors import given
from ...spec.tolerance import FRICTION, Tolerance
from .model import Array, Input, Model, normal_probability, normal_score
from .result import LIFE_PROBABILITIES, ROBUST, Estimate, IndexRow, LifeRow, QuantileRow

_EDGES = (0.0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3, 1e-2, 0.05, 0.15, 0.3, 0.5)
_PER_PANEL = 24
_NEGLIGIBLE = 1e-12
"""Probability of a part that is not worth nodes."""
_LEAST, _MOST, _MOST_OF_TWO = 8, 64, 16
"""Nodes per friction."""
_ENOUGH = 1e-6
"""Relative change of the life at which more nodes are not worth their time."""


def panels(kinks: Sequence[float]) -> tuple[Array, Array]:
    """Gauss–Legendre nodes of a probability, on panels that are finer towards the tails and end at kinks."""
    edges = np.array(sorted({*_EDGES, *(1 - edge for edge in _EDGES), *(k for k in kinks if 0 < k < 1)}))
    x, w = np.polynomial.legendre.leggauss(_PER_PANEL)
    half = np.diff(edges) / 2
    u = (edges[:-1] + half)[:, None] + half[:, None] * x
    return u.ravel(), (half[:, None] * w).ravel()


def gauss(scattering: Input, count: int, bend: float | None = None) -> tuple[Array, Array]:
    """Gauss nodes and weights of a distribution as truncated, exact for polynomials in its value (lognormal: its log).

    The weights add up to 1. What is integrated may have a bend at one value; the nodes, ``count`` on either side, are
    exact for polynomials of their own there. Each node costs a torque of 200,000 clutches, and 8 or 16 of these do for
    what takes 500 of ``panels``.

    Source: Golub, Welsch, Calculation of Gauss quadrature rules, Math. Comp. 23 (1969); the polynomials by Lanczos'
        method on a fine rule (Gautschi, Orthogonal Polynomials, 2004, section 2.2).
    """
    share = 0.0 if bend is None else scattering.share_below(bend)
    u, weights = panels([*scattering.kinks, share])
    sides = [side for side in (u < share, u >= share) if weights[side].sum() > _NEGLIGIBLE]
    rules = [_gauss_of_part(scattering, u[side], weights[side], count) for side in sides]
    values, shares = (np.concatenate(columns) for columns in zip(*rules, strict=True))
    return values, shares / shares.sum()


def _gauss_of_part(scattering: Input, u: Array, weights: Array, count: int) -> tuple[Array, Array]:
    """Nodes and weights of a part of a distribution: some of its probabilities."""
    whole = weights.sum()
    x = scattering.quantiles(u)
    x = np.log(x) if scattering.kind == "lognormal" else x
    center = float((weights * x).sum() / whole)
    scale = float((weights * (x - center) ** 2).sum() / whole) ** 0.5
    if scale <= 1e-12 * abs(center):
        return scattering.quantiles(u[[u.size // 2]]), np.array([whole])
    x = (x - center) / scale
    polynomials = np.sqrt(weights / whole)[None, :]
    while len(polynomials) < count:
        following = x * polynomials[-1]
        # twice: rounding would otherwise let the polynomials lose their right angles
        for _ in range(2):
            following -= polynomials.T @ (polynomials @ following)
        polynomials = np.vstack([polynomials, following / np.linalg.norm(following)])
    nodes, vectors = np.linalg.eigh((polynomials * x) @ polynomials.T)
    values = center + scale * nodes
    return np.exp(values) if scattering.kind == "lognormal" else values, vectors[0] ** 2 * whole


class Slip(NamedTuple):
    """One slip that stands for a share of all."""

    share: float
    frictions: Mapping[str, float]
    """By path."""


def service_of(model: Model) -> list[Slip]:
    """Slips that stand for the service of a clutch, as many as the clutch as drawn needs."""
    frictions = [scattering for scattering in model.inputs if scattering.path in FRICTION]
    clutch, life, count = model.clutch(model.centers), math.inf, _LEAST
    # where the sleeve leaves its stop, the torque bends
    bend = None if not clutch.spec.kind.travels else float(clutch.friction_leaving)
    while True:
        slips = _slips(frictions, model.correlation, count, bend)
        last, life = life, life_of(model, clutch, slips).item()
        most = _MOST if len(frictions) < 2 else _MOST_OF_TWO
        if count >= most or len(slips) == 1 or abs(life / last - 1) < _ENOUGH:
            return slips
        count *= 2


def _slips(frictions: list[Input], correlation: float, count: int, bend: float | None) -> list[Slip]:
    """Gauss nodes of the friction in service, ``count`` for each; a single slip where none scatters."""
    slips = [Slip(1.0, {})]
    for friction in frictions:
        finer = []
        for slip in slips:
            if slip.frictions and correlation:
                # nodes where the friction before has its value
                before = normal_score(np.array([frictions[0].share_below(slip.frictions[frictions[0].path])]))
                z, shares = np.polynomial.hermite_e.hermegauss(count if abs(correlation) < 1 else 1)
                scores = correlation * before + (1 - correlation**2) ** 0.5 * z
                values, shares = friction.quantiles(normal_probability(scores)), shares / shares.sum()
            else:
                values, shares = gauss(friction, count, bend)
            finer += [
                Slip(slip.share * float(share), {**slip.frictions, friction.path: float(value)})
                for value, share in zip(values, shares, strict=True)
            ]
        slips = finer
    return slips


def life_of(model: Model, clutch: Clutch, slips: list[Slip]) -> Array:
    """Slips to failure of the protected side (Miner), of one clutch or many: each does the damage 1/N of its torque."""
    damage, block = np.zeros(1), 256
    for first in range(0, len(slips), block):
        own = slips[first : first + block]
        # the slips on an axis before that of the clutches
        shares, *columns = (
            np.array(column)[:, None]
            for column in ([slip.share for slip in own], *zip(*(slip.frictions.values() for slip in own), strict=True))
        )
        torque = clutch.torque(*model.frictions(dict(zip(own[0].frictions, columns, strict=True))))
        damage = damage + (shares * damage_of(clutch, torque)).sum(axis=0)
    life: Array = law.cycles_of_mean_damage(damage)
    return life


def damage_of(clutch: Clutch, torque: Values) -> Values:
    """Damage of one slip on the protected side, by the paper's S–N line."""
    own = clutch.quantities
    return own.at(damaging_stress=own.at(torque=torque)["shear_stress"])["damage"]


def unprotected(clutch: Clutch, life: Values) -> Values:
    """Slips to failure of the unprotected side, all torques being k_д times those of the protected one (S–N line)."""
    return life / given(clutch.spec.drive.dynamic_factor) ** given(clutch.spec.fatigue).exponent


@dataclass(frozen=True)
class Exact:
    """Figures of the torque where only friction varies: torque is monotone in it, so quantiles map to quantiles."""

    model: Model
    rising: bool
    """Whether torque rises with the probability of the friction."""

    def quantiles(self, p: Array) -> Array:
        """Torque not exceeded with each probability of an array."""
        return self.model.torque_along(p if self.rising else 1 - p)

    def quantile(self, p: float) -> float:
        """Torque not exceeded with probability p."""
        return float(self.quantiles(np.array([p]))[0])

    def below(self, torques: Array) -> Array:
        """Probability of a smaller torque, for each of an array, by bisection on the probability."""
        low, high = np.zeros(torques.shape), np.ones(torques.shape)
        while bool(((low < (middle := (low + high) / 2)) & (middle < high)).any()):
            smaller = self.quantiles(middle) < torques
            low, high = np.where(smaller, middle, low), np.where(smaller, high, middle)
        return np.where(high < 1, low, 1.0)

    def figures(self, given: Tolerance, machine: float) -> dict[str, object]:
        """Fields of the result that are figures of the torque: all without error."""
        model, clutch = self.model, self.model.clutch(self.model.centers)
        kinks = [kink for friction in model.inputs for kink in friction.kinks]
        if clutch.spec.kind.travels:
            kinks += [friction.share_below(float(clutch.friction_leaving)) for friction in model.inputs]
        u, weights = panels(kinks)
        torque = model.torque_along(u)
        mean = float((weights * torque).sum())
        low, high = (self.quantile(p) for p in ROBUST)
        one = Estimate(1.0)
        fields: dict[str, object] = {
            "method": "exact",
            "mean": Estimate(mean),
            "standard_deviation": Estimate(float((weights * (torque - mean) ** 2).sum()) ** 0.5),
            "accuracy_factor_robust": Estimate(high / low),
            "probability_below_machine": Estimate(float(self.below(np.array(machine)))),
            "sobol": [
                IndexRow.of(path=" + ".join(friction.path for friction in model.inputs), first_order=one, total=one)
            ],
            "quantiles": [QuantileRow.of(probability=p, torque=Estimate(self.quantile(p))) for p in given.quantiles],
        }
        if given.torque_limit is not None:
            fields["probability_above_limit"] = Estimate(1 - float(self.below(np.array(given.torque_limit))))
        if model.spec.fatigue is not None:
            # all clutches are alike, and each sees the whole range of friction
            life = float(law.cycles_of_mean_damage(float((weights * damage_of(clutch, torque)).sum())))
            sides = {"protected": Estimate(life), "unprotected": Estimate(float(unprotected(clutch, life)))}
            fields |= {f"life_{side}": cycles for side, cycles in sides.items()}
            fields["life_quantiles"] = [LifeRow.of(probability=p, **sides) for p in LIFE_PROBABILITIES]
        return fields


def exact_of(model: Model) -> Exact | None:
    """Return the exact answer, or None where more than friction varies or torque is not monotone along it."""
    only_friction = {friction.path for friction in model.inputs} <= set(FRICTION)
    if not only_friction or (len(model.inputs) > 1 and model.correlation != 1):
        return None
    along = model.torque_along(np.linspace(0, 1, 2001)[1:-1])
    # pockets that hold the torque leave it to rounding
    steps = np.where(np.abs(np.diff(along)) > 1e-12 * along[:-1], np.diff(along), 0.0)
    if bool((steps >= 0).all()) or bool((steps <= 0).all()):
        return Exact(model, bool(steps.sum() >= 0))
    return None
