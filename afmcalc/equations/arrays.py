"""The few steps of a law that are not plain arithmetic, for numbers, arrays and the symbols of an explanation alike.

No other module of the laws knows NumPy, and of numbers none imports it. An array holds one value for each clutch;
what a law calculates at many frictions of one clutch (``spread``) lies along a first axis before that.
"""

import math
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
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
    return _called("max", values, max, "maximum")


def smaller(*values: Any) -> Any:
    """Elementwise minimum."""
    return _called("min", values, min, "minimum")


def _called(name: str, values: tuple[Any, ...], of_numbers: Callable[..., Any], of_arrays: str) -> Any:
    for value in values:
        if hasattr(value, "called"):
            return value.called(name, *values)
    if any(map(is_array, values)):
        import numpy as np

        function = getattr(np, of_arrays)
        return reduce(function, values) if len(values) > 1 else function(*values)
    return of_numbers(*values)


def _elementwise(name: str, of_arrays: str) -> Callable[[Any], Any]:
    return lambda value: _called(name, (value,), getattr(math, name), of_arrays)


sin, cos, tan = (_elementwise(name, name) for name in ("sin", "cos", "tan"))
atan, square_root, logarithm = _elementwise("atan", "arctan"), _elementwise("sqrt", "sqrt"), _elementwise("log", "log")


def chosen(condition: Any, yes: Callable[[], Any], no: Callable[[], Any]) -> Any:
    """Elementwise choice of two functions without arguments; of numbers only the one chosen is called."""
    if is_array(condition):
        import numpy as np

        with np.errstate(all="ignore"):
            return np.where(condition, yes(), no())
    return yes() if condition else no()


def quotient(numerator: Any, denominator: Any) -> Any:
    """Quotient; where it divides by zero ±inf, by the sign of the numerator, of 0/0 inf."""
    if is_array(numerator) or is_array(denominator):
        import numpy as np

        with np.errstate(all="ignore"):
            return np.where(denominator == 0, np.where(numerator >= 0, np.inf, -np.inf), numerator / denominator)
    if isinstance(denominator, int | float) and denominator == 0:
        return math.inf if numerator >= 0 else -math.inf
    return numerator / denominator


def place_of_smallest(values: Any, places: Any, tie: float = 1e-12) -> Any:
    """Place of the smallest value: the first of those that are equal but for rounding."""
    low, at = values[0], places[0]
    for value, place in zip(values[1:], places[1:], strict=True):
        at = _where(value < low * (1 - tie), place, at)
        low = smaller(low, value)
    return at


def place_of_largest(values: Any, places: Any, tie: float = 1e-12) -> Any:
    """Place of the largest value: the last of those that are equal but for rounding."""
    high, at = values[-1], places[-1]
    for value, place in zip(values[-2::-1], places[-2::-1], strict=True):
        at = _where(value > high * (1 + tie), place, at)
        high = larger(high, value)
    return at


def _where(condition: Any, yes: Any, no: Any) -> Any:
    return chosen(condition, lambda: yes, lambda: no)


def next_listed(least: Any, listed: Any) -> Any:
    """The smallest of an ascending list that is not below a value; NaN where there is none."""
    if is_array(least):
        import numpy as np

        return np.append(listed, np.nan)[np.searchsorted(listed, least * (1 - 1e-12))]
    return next((size for size in listed if size >= least * (1 - 1e-12)), math.nan)


def spread(low: Any, high: Any, count: int, *, ends: bool = True) -> Any:
    """Values from one to another along a first axis: with the ends, or in the middles of so many equal parts."""
    import numpy as np

    shares = np.linspace(0, 1, count) if ends else (np.arange(count) + 0.5) / count
    return low + np.multiply.outer(shares, np.atleast_1d(high - low))


def beside(along: Any, value: Any) -> Any:
    """Values along a first axis, and one more."""
    import numpy as np

    shape = np.broadcast_shapes(along.shape[1:], np.shape(value))
    return np.concatenate([np.broadcast_to(along, (len(along), *shape)), np.broadcast_to(value, shape)[None]])


def mean_along(values: Any) -> Any:
    """Mean along the first axis; a number of one clutch."""
    return _one(values.mean(axis=0))


def largest_along(values: Any) -> Any:
    """Largest value along the first axis; a number of one clutch."""
    return _one(values.max(axis=0))


def _one(values: Any) -> Any:
    return float(values[0]) if values.shape == (1,) else values


def zero_of(falling: Callable[[Any], Any], end: Any) -> Any:
    """Zero of a function that falls between 0 and ``end``, by bisection."""
    low, high = 0.0 * end, end
    for _ in range(60):
        middle = (low + high) / 2
        above = falling(middle) > 0
        low, high = _where(above, middle, low), _where(above, high, middle)
    return low


def greatest(value: Values) -> float:
    """Largest of the numbers, as one."""
    if is_array(value):
        import numpy as np

        return float(np.max(value))
    return float(value)


def quiet_division(value: Values) -> AbstractContextManager[object]:
    """Context in which arrays such as ``value`` divide by zero without a warning."""
    if is_array(value):
        import numpy as np

        return np.errstate(divide="ignore", invalid="ignore")
    return nullcontext()


def finite(value: Values) -> Values:
    """Return a number, or an array in which NaN may stand for no value.

    Raises OverflowError: it is beyond the range of numbers.
    """
    if is_array(value):
        import numpy as np

        within = not np.isinf(value).any()
    else:
        within = math.isfinite(value)
    if not within:
        raise OverflowError
    return value
