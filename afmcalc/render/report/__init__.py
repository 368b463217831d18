"""The calculation report: one self-contained HTML file."""

from .interface import Chapter, Subject
from .page import render

__all__ = ["Chapter", "Subject", "render"]
