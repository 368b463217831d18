"""The clutch under its former name, for analyses that are not yet converted."""

from .adapter import Clutch

__all__ = ["Clutch"]
