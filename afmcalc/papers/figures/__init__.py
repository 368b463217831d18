"""The figures of the papers, recalculated from their formulas with the misprints mended."""

from .interface import FIGURES, PaperCurve, PaperFigure, paper_figure

__all__ = ["FIGURES", "PaperCurve", "PaperFigure", "paper_figure"]
