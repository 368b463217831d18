"""Engines: one per torque law, behind one protocol."""

from os import PathLike

from ..errors import CalculationError
from ..spec import Spec, read_spec
from .direct import DirectClutch
from .protocol import Clutch

__all__ = ["Clutch", "build", "load"]


def build(spec: Spec) -> Clutch:
    """Build the engine that calculates ``spec``.

    Raises:
        CalculationError: the variant has no engine.
    """
    if spec.variant == "indirect":
        raise CalculationError("variant 'indirect' is not calculated yet")
    return DirectClutch.from_spec(spec)


def load(source: str | PathLike[str] | None = None) -> Clutch:
    """Read a spec (a path, ``"-"`` for standard input, None for the built-in base clutch) and build its clutch.

    Raises:
        SpecError: the spec is invalid.
        FileError: the file cannot be read.
    """
    return build(read_spec(source))
