"""The calculation report as a document, written as one self-contained HTML file or printed on sheets."""

from .page import Subject, render, report

__all__ = ["Subject", "render", "report"]
