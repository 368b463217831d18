"""Plots: one file per kind, each from results to a sheet; one file that sets a sheet as PNG, SVG or PDF."""

from .interface import sheet_of

__all__ = ["sheet_of"]
