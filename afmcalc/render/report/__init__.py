"""The calculation report as a document, written as one self-contained HTML file or printed on sheets."""

from .page import Subject, render, report, subject_of

__all__ = ["Subject", "render", "report", "subject_of"]
