"""The calculation report: one self-contained HTML file."""

from .interface import ExplainedStep, Section, Subject
from .page import render

__all__ = ["ExplainedStep", "Section", "Subject", "render"]
