"""Plots: from what an analysis gathered to a sheet, and from a sheet to text, PNG, SVG or PDF."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .chart import Sheet

__all__ = ["sheet_of"]

_HOMES = {"tolerance": "studies", "pareto": "studies", "pocket": "pocket_drawing", "section": "section_drawing"}


def sheet_of(kind: str, gathered: Any) -> "Sheet":
    """Lay out what ``analysis.plot_data.gathered`` gives for a kind of plot, by the function of its name."""
    module = import_module(f".{_HOMES.get(kind, 'curve_sheets')}", __package__)
    return getattr(module, kind)(gathered)
