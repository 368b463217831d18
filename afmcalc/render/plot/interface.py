"""Which kinds of plots there are: each a module of ``kinds`` with a function ``sheet`` of what was gathered for it."""

from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .chart import Sheet


def sheet_of(kind: str, found: Any) -> "Sheet":
    """Lay out what was gathered for a kind of plot (``analysis.figures.gathered``), importing only its kind."""
    make: Callable[[Any], Sheet] = import_module(f".kinds.{kind}", __package__).sheet
    return make(found)
