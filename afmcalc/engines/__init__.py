"""Engines: the laws that make up a clutch, its springs and its layout."""

from collections.abc import Mapping
from typing import Any

from ..spec import Spec, make_spec
from .selection import Clutch, accepted, quantities_of

__all__ = ["Clutch", "build"]


def build(spec: Spec | Mapping[str, Any]) -> Clutch:
    """Return the clutch of ``spec``, a validated one or plain data of the same structure.

    Raises SpecError: no valid spec; an indirect clutch whose gain does not overcome the friction at the key.
    """
    if not isinstance(spec, Spec):
        spec = make_spec(spec)
    return accepted(quantities_of(spec))
