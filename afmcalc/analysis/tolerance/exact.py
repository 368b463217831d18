"""The exact answer where only friction varies: torque is monotone in it, so quantiles map to quantiles."""

from collections.abc import Callable, Sequence
from typing import Any

from .run import damage_rates
from .sampling import Model

_EDGES = (0.0, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3, 1e-2, 0.05, 0.15, 0.3, 0.5)


class Exact:
    """Figures of the torque by the quantile function of the friction."""

    def __init__(self, model: Model, rising: bool) -> None:
        """Keep the model; ``rising`` says whether torque rises with the probability of the friction."""
        self.model, self.rising = model, rising
        self._u, self._weights = _nodes(model)
        self._torque = self._at(self._u)

    def _at(self, u: Any) -> Any:
        return self.model.torque([each.quantiles(u) for each in self.model.inputs])

    def quantile(self, p: float) -> float:
        """Torque not exceeded with probability p."""
        import numpy as np

        return float(self._at(np.array([p if self.rising else 1 - p]))[0])

    def mean_of(self, function: Callable[[Any], Any]) -> float:
        """Expectation of a function of the torque."""
        return float((self._weights * function(self._torque)).sum())

    def below(self, torque: float) -> float:
        """Probability of a smaller torque."""
        import numpy as np

        return float(self.all_below(np.array([torque]))[0])

    def all_below(self, torques: Any) -> Any:
        """Probability of a smaller torque, for each of an array, by bisection on the probability."""
        import numpy as np

        low, high = np.zeros(torques.shape), np.ones(torques.shape)
        for _ in range(200):
            middle = (low + high) / 2
            if bool(((middle == low) | (middle == high)).all()):
                break
            smaller = self._at(middle if self.rising else 1 - middle) < torques
            low, high = np.where(smaller, middle, low), np.where(smaller, high, middle)
        return np.where(high < 1, low, 1.0)

    def damages(self) -> tuple[float, float]:
        """Expected damage of one slip on both sides."""
        values = [each.quantiles(self._u) for each in self.model.inputs]
        rates = damage_rates(self.model.clutch(values), self._torque)
        first, second = (float((self._weights * rate).sum()) for rate in rates)
        return first, second


def exact_of(model: Model) -> Exact | None:
    """Return the exact answer, or None where more than friction varies or torque is not monotone along it."""
    import numpy as np

    names = {each.path for each in model.inputs}
    if not names <= {"friction", "friction.driving", "friction.driven"}:
        return None
    if len(names) > 1 and model.correlation != 1:
        return None
    u = np.linspace(0, 1, 2001)[1:-1]
    steps = np.diff(np.broadcast_to(model.torque([each.quantiles(u) for each in model.inputs]), u.shape))
    if bool((steps >= 0).all()) or bool((steps <= 0).all()):
        return Exact(model, rising=bool(steps.sum() >= 0))
    return None


def _nodes(model: Model) -> tuple[Any, Any]:
    """Gauss–Legendre nodes on panels that are finer towards the tails and end at kinks of the distribution."""
    import numpy as np

    kinks = [each.cdf(each.center) for each in model.inputs if each.kind == "triangular"]
    # the sleeve leaves its stop at f_set: a kink of the law
    at = model.clutch([each.center for each in model.inputs]).friction_set
    if at is not None:
        kinks += [_share(each, float(at)) for each in model.inputs]
    edges = sorted({*_EDGES, *(1 - edge for edge in _EDGES), *(k for k in kinks if 0 < k < 1)})
    x, w = np.polynomial.legendre.leggauss(24)
    return _panels(edges, x, w)


def _share(each: Any, x: float) -> float:
    below, above = each.mass
    return float((each.cdf(x) - below) / (above - below))


def _panels(edges: Sequence[float], x: Any, w: Any) -> tuple[Any, Any]:
    import numpy as np

    low, high = np.array(edges[:-1]), np.array(edges[1:])
    half = (high - low) / 2
    u = (low + half)[:, None] + half[:, None] * x
    return u.ravel(), (half[:, None] * w).ravel()
