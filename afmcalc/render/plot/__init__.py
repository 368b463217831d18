"""Plots: from the data of an analysis to a sheet, and from a sheet to SVG, PNG or PDF."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .chart import Sheet

__all__ = ["sheet_of"]

_HOMES = {"pocket": "pocket_drawing", "section": "section_drawing"}


def sheet_of(kind: str, gathered: Any) -> "Sheet":
    """Sheet of a kind of plot, from the data that ``analysis.plot_data.gathered`` returns for this kind."""
    module = import_module(f".{_HOMES.get(kind, 'curve_sheets')}", __package__)
    return getattr(module, kind)(gathered)
