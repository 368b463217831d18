"""The calculation report: one self-contained HTML file."""

from .page import Subject, render

__all__ = ["Subject", "render"]
