"""The few steps between equations that are not plain arithmetic, for floats and arrays alike."""

import math
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING, Any, TypeAlias, TypeGuard, TypeVar

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats: TypeAlias = NDArray[np.float64]
    Values: TypeAlias = float | Floats
else:
    Floats = Values = Any
"""One number, or an array of any shape; shapes of several arguments broadcast."""

V = TypeVar("V", bound=Values)
"""What a function takes and gives alike: numbers or arrays."""


def is_array(value: object) -> "TypeGuard[Floats]":
    """Whether ``value`` is a NumPy array (asked without importing NumPy)."""
    return type(value) is not float and hasattr(value, "__array__") and not isinstance(value, float)


def larger(first: Values, second: Values) -> Values:
    """Elementwise maximum."""
    if is_array(first) or is_array(second):
        import numpy as np

        return np.maximum(first, second)
    return first if first >= second else second


def smaller(first: Values, second: Values) -> Values:
    """Elementwise minimum."""
    if is_array(first) or is_array(second):
        import numpy as np

        return np.minimum(first, second)
    return first if first <= second else second


def greatest(value: Values) -> float:
    """Largest of the numbers, as one."""
    if is_array(value):
        import numpy as np

        return float(np.max(value))
    return float(value)


def chosen(condition: Any, yes: Callable[[], Values], no: Callable[[], Values]) -> Values:
    """Elementwise choice; of two numbers only the one chosen is calculated."""
    if getattr(condition, "ndim", 0):
        import numpy as np

        return np.where(condition, yes(), no())
    return yes() if condition else no()


def quiet_division(value: Values) -> AbstractContextManager[object]:
    """Context in which arrays such as ``value`` divide by zero without a warning."""
    if is_array(value):
        import numpy as np

        return np.errstate(divide="ignore", invalid="ignore")
    return nullcontext()


def square_root(value: Values) -> Values:
    """Square root, the same to the last bit for floats and arrays: a power of 0.5 may differ in the last."""
    if is_array(value):
        import numpy as np

        return np.sqrt(value)
    return math.sqrt(value)


def logarithm(value: Values) -> Values:
    """ln of a number or an array."""
    if is_array(value):
        import numpy as np

        return np.log(value)
    return math.log(value)


def tangent(angle: Values) -> Values:
    """Tangent, the same to the last bit for floats and arrays: NumPy's own may differ in the last."""
    if is_array(angle):
        import numpy as np

        return np.fromiter(map(math.tan, angle.ravel()), float, angle.size).reshape(angle.shape)
    return math.tan(float(angle))


def finite(value: Values) -> Values:
    """Return a number, or an array in which NaN may stand for no value.

    Raises:
        OverflowError: it is beyond the range of numbers.
    """
    if is_array(value):
        import numpy as np

        within = not np.isinf(value).any()
    else:
        within = math.isfinite(value)
    if not within:
        raise OverflowError
    return value
