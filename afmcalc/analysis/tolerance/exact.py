"""The exact answer where only friction varies: torque is monotone in it, so quantiles map to quantiles."""

from collections.abc import Callable

import numpy as np

from ...arrays import Values
from ...engines.laws import IndirectLaw
from ...equations.life import cycles_of_mean_damage
from .distributions import Array, Input
from .model import Model
from .quadrature import panels
from .service import damage_of, unprotected


class Exact:
    """Figures of the torque by the quantile function of the friction."""

    def __init__(self, model: Model, rising: bool) -> None:
        """Keep the model; ``rising`` says whether torque rises with the probability of the friction."""
        self.model, self.rising = model, rising
        self._u, self._weights = _nodes(model)
        self._torque = self._at(self._u)

    def _at(self, u: Array) -> Array:
        return _torque_at(self.model, u)

    def quantile(self, p: float) -> float:
        """Torque not exceeded with probability p."""
        return float(self._at(np.array([p if self.rising else 1 - p]))[0])

    def mean_of(self, function: Callable[[Array], Values]) -> float:
        """Expectation of a function of the torque."""
        return float((self._weights * function(self._torque)).sum())

    def below(self, torque: float) -> float:
        """Probability of a smaller torque."""
        return float(self.all_below(np.array([torque]))[0])

    def all_below(self, torques: Array) -> Array:
        """Probability of a smaller torque, for each of an array, by bisection on the probability."""
        low, high = np.zeros(torques.shape), np.ones(torques.shape)
        for _ in range(200):
            middle = (low + high) / 2
            if bool(((middle == low) | (middle == high)).all()):
                break
            smaller = self._at(middle if self.rising else 1 - middle) < torques
            low, high = np.where(smaller, middle, low), np.where(smaller, high, middle)
        return np.where(high < 1, low, 1.0)

    def lives(self) -> tuple[float, float]:
        """Slips to failure on both sides: all clutches are alike, and each sees the whole range of friction."""
        clutch = self.model.clutch([each.center for each in self.model.inputs])
        life = cycles_of_mean_damage(self.mean_of(lambda torque: damage_of(clutch, torque)))
        return life, float(unprotected(clutch, life))


def exact_of(model: Model) -> Exact | None:
    """Return the exact answer, or None where more than friction varies or torque is not monotone along it."""
    names = {each.path for each in model.inputs}
    if not names <= {"friction", "friction.driving", "friction.driven"}:
        return None
    if len(names) > 1 and model.correlation != 1:
        return None
    along = _torque_at(model, np.linspace(0, 1, 2001)[1:-1])
    # pockets that hold the torque leave it to rounding
    steps = np.where(np.abs(np.diff(along)) > 1e-12 * along[:-1], np.diff(along), 0.0)
    if bool((steps >= 0).all()) or bool((steps <= 0).all()):
        return Exact(model, rising=bool(steps.sum() >= 0))
    return None


def _torque_at(model: Model, u: Array) -> Array:
    """Torque with every friction at a probability."""
    return np.broadcast_to(model.torque([each.quantiles(u) for each in model.inputs]), u.shape)


def _nodes(model: Model) -> tuple[Array, Array]:
    """Nodes of the probability, panels ending at kinks of the distribution and of the law."""
    kinks = [kink for each in model.inputs for kink in each.kinks]
    clutch = model.clutch([each.center for each in model.inputs])
    law, force = clutch.law, clutch.closing_force
    if isinstance(law, IndirectLaw):
        kinks += [_lift(law, force, each) for each in model.inputs]
    return panels(kinks)


def _lift(law: IndirectLaw, closing_force: Values, friction: Input) -> float:
    """Probability of a friction below which the sleeve rests at its stop: a kink of the law."""
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = (low + high) / 2
        seated = law.is_seated(closing_force, friction.quantiles(np.array([middle])))
        low, high = (middle, high) if seated else (low, middle)
    return low
