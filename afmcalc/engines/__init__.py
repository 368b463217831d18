"""Engines: one per torque law, behind one protocol."""

from collections.abc import Mapping
from typing import Any

from ..spec import Spec, make_spec
from .protocol import Clutch

__all__ = ["Clutch", "build"]


def build(spec: Spec | Mapping[str, Any]) -> Clutch:
    """Build the engine that calculates ``spec``, a validated one or plain data of the same structure.

    Raises:
        SpecError: no valid spec; an indirect clutch whose gain does not overcome the friction at the key.
    """
    if not isinstance(spec, Spec):
        spec = make_spec(spec)
    # each spares the start-up the other
    if spec.kind.law == "direct":
        from .direct import DirectClutch

        return DirectClutch.from_spec(spec)
    from .indirect import IndirectClutch

    return IndirectClutch.from_spec(spec)
