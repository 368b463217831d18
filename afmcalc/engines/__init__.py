"""Engines: one per torque law, behind one protocol."""

from collections.abc import Mapping
from typing import Any

from ..spec import Spec, make_spec
from ..variants import Law
from .protocol import Clutch

__all__ = ["Clutch", "build"]


def build(spec: Spec | Mapping[str, Any]) -> Clutch:
    """Build the engine that calculates ``spec``, a validated one or plain data of the same structure.

    Raises:
        SpecError: no valid spec; an indirect clutch whose gain does not overcome the friction at the key.
    """
    if not isinstance(spec, Spec):
        spec = make_spec(spec)
    return _engine(spec.kind.law).from_spec(spec)


def _engine(law: Law) -> type[Clutch]:
    """Return the engine of a law, and spare the start-up the other's."""
    if law == "direct":
        from .direct import DirectClutch

        return DirectClutch
    from .indirect import IndirectClutch

    return IndirectClutch
