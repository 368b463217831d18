"""Rendering: one walk over a result gives a document; each format writes the document."""

from .formats import FORMATS, renderer

__all__ = ["FORMATS", "renderer"]
