"""Plots: one file per kind, each from results to a sheet; one file that sets a sheet as PNG, SVG or PDF."""

from .interface import KINDS, Kind, Request, check_request, kind_of, sheet_of

__all__ = ["KINDS", "Kind", "Request", "check_request", "kind_of", "sheet_of"]
