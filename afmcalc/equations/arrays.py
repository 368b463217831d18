"""Functions for laws beyond plain arithmetic; they take numbers and arrays alike.

No other module of the laws uses NumPy, and here it is imported only for arrays. An array holds one value for each
clutch; values at many frictions of each clutch (``spread``) lie along an additional first axis.
"""

import math
from collections.abc import Callable
from functools import reduce
from typing import TYPE_CHECKING, Any, TypeAlias, TypeGuard

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats: TypeAlias = NDArray[np.float64]
    Values: TypeAlias = float | Floats
else:
    Floats = Values = Any
"""One number, or an array of any shape; shapes of several arguments broadcast."""


def is_array(value: object) -> "TypeGuard[Floats]":
    """True for an array of one axis or more; does not import NumPy."""
    return type(value) is not float and bool(getattr(value, "ndim", 0))


def larger(*values: Any) -> Any:
    """Elementwise maximum."""
    for value in values:
        if value.__class__ is not float and is_array(value):
            import numpy as np

            return reduce(np.maximum, values)
    return max(values)


def smaller(*values: Any) -> Any:
    """Elementwise minimum."""
    if any(map(is_array, values)):
        import numpy as np

        return reduce(np.minimum, values)
    return min(values)


def _elementwise(name: str, of_arrays: str) -> Callable[[Any], Any]:
    def function(value: Any) -> Any:
        if is_array(value):
            import numpy as np

            return getattr(np, of_arrays)(value)
        return getattr(math, name)(value)

    return function


sin, cos, tan = (_elementwise(name, name) for name in ("sin", "cos", "tan"))
atan, logarithm = _elementwise("atan", "arctan"), _elementwise("log", "log")


def chosen(condition: Any, yes: Callable[[], Any], no: Callable[[], Any]) -> Any:
    """Elementwise choice of the results of two functions; without an array only the chosen one is called."""
    if is_array(condition):
        import numpy as np

        with np.errstate(all="ignore"):
            return np.where(condition, yes(), no())
    return yes() if condition else no()


def quotient(numerator: Any, denominator: Any) -> Any:
    """Quotient; on division by zero ±inf with the sign of the numerator, and inf for 0/0."""
    if is_array(numerator) or is_array(denominator):
        import numpy as np

        with np.errstate(all="ignore"):
            return np.where(denominator == 0, np.where(numerator >= 0, np.inf, -np.inf), numerator / denominator)
    if isinstance(denominator, int | float) and denominator == 0:
        return math.inf if numerator >= 0 else -math.inf
    return numerator / denominator


def place_of_smallest(values: Any, places: Any) -> Any:
    """Element of ``places`` at the smallest value; the first one if several are equal apart from rounding."""
    low, at = values[0], places[0]
    for value, place in zip(values[1:], places[1:], strict=True):
        at = _where(value < low - 1e-12 * abs(low), place, at)
        low = smaller(low, value)
    return at


def place_of_largest(values: Any, places: Any) -> Any:
    """Element of ``places`` at the largest value; the last one if several are equal apart from rounding."""
    return place_of_smallest([-value for value in values[::-1]], places[::-1])


def _where(condition: Any, yes: Any, no: Any) -> Any:
    return chosen(condition, lambda: yes, lambda: no)


def next_listed(least: Any, listed: Any) -> Any:
    """Smallest element of an ascending list that is not below ``least``; NaN if there is none."""
    if is_array(least):
        import numpy as np

        return np.append(listed, np.nan)[np.searchsorted(listed, least * (1 - 1e-12))]
    return next((size for size in listed if size >= least * (1 - 1e-12)), math.nan)


def spread(low: Any, high: Any, count: int, *, ends: bool = True) -> Any:
    """``count`` values from ``low`` to ``high`` along a first axis: with the ends, or midpoints of equal parts."""
    import numpy as np

    shares = np.linspace(0, 1, count) if ends else (np.arange(count) + 0.5) / count
    return low + np.multiply.outer(shares, np.atleast_1d(high - low))


def along_path(share: Any, low: Any, mean: Any, high: Any, bend: Any) -> Any:
    """Value at a share (0…1) of a path of two straight parts: low at 0, mean at the share ``bend``, high at 1."""
    below, above = smaller(share / bend, 1.0), larger((share - bend) / (1 - bend), 0.0)
    return low + below * (mean - low) + above * (high - mean)


def beside(along: Any, value: Any) -> Any:
    """Values along a first axis with one more appended."""
    import numpy as np

    shape = np.broadcast_shapes(along.shape[1:], np.shape(value))
    return np.concatenate([np.broadcast_to(along, (len(along), *shape)), np.broadcast_to(value, shape)[None]])


def mean_along(values: Any) -> Any:
    """Mean along the first axis; a float for a single clutch."""
    return _one(values.mean(axis=0))


def largest_along(values: Any) -> Any:
    """Largest value along the first axis; a float for a single clutch."""
    return _one(values.max(axis=0))


def _one(values: Any) -> Any:
    return float(values[0]) if values.shape == (1,) else values


def zero_of(falling: Callable[[Any], Any], end: Any) -> Any:
    """Zero of a decreasing function between 0 and ``end``, elementwise by bisection."""
    low, high = 0.0 * end, end
    for _ in range(60):
        middle = (low + high) / 2
        above = falling(middle) > 0
        low, high = _where(above, middle, low), _where(above, high, middle)
    return low


def greatest(value: Values) -> float:
    """Largest element of a number or an array."""
    if is_array(value):
        import numpy as np

        return float(np.max(value))
    return float(value)
