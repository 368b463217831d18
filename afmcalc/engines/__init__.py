"""Engines: the laws that make up a clutch, its springs and its layout."""

from .selection import Clutch, build

__all__ = ["Clutch", "build"]
