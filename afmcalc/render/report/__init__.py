"""The calculation report: one self-contained HTML file."""

from .interface import Chapter, ExplainedStep, Subject
from .page import render

__all__ = ["Chapter", "ExplainedStep", "Subject", "render"]
