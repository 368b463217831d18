"""Rendering: a result is laid out once as a document, which each format writes."""

from .formats import FORMATS, renderer

__all__ = ["FORMATS", "renderer"]
