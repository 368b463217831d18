"""A figure as SVG by one renderer that measures and draws; matplotlib would take four, each reading every text anew."""

import io
from typing import Any

from matplotlib.backend_bases import FigureCanvasBase
from matplotlib.backends.backend_svg import RendererSVG
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties

_POINTS = 72
"""Dots per inch of an SVG."""


class _Renderer(RendererSVG):
    """Measures a text with subscripts as it draws it, so that the parser meets it once."""

    def get_text_width_height_descent(self, s: str, prop: FontProperties, ismath: Any) -> Any:
        if ismath is not True:
            return super().get_text_width_height_descent(s, prop, ismath)  # type: ignore[no-untyped-call]
        return self._text2path.mathtext_parser.parse(s, _POINTS, prop)[:3]


class _Canvas(FigureCanvasBase):
    """Lays a figure out with the renderer that draws it."""

    def __init__(self, figure: Figure, renderer: RendererSVG) -> None:
        super().__init__(figure)
        self._renderer = renderer

    def get_renderer(self) -> RendererSVG:
        return self._renderer


def svg_of(figure: Figure) -> str:
    """Draw a figure; without date or version, so that the text depends on the figure only."""
    figure.dpi = _POINTS
    width, height = figure.get_size_inches() * _POINTS
    text = io.StringIO()
    renderer = _Renderer(width, height, text, image_dpi=_POINTS, metadata={"Date": None, "Creator": None})  # type: ignore[no-untyped-call]
    _Canvas(figure, renderer)
    figure.draw(renderer)
    renderer.finalize()  # type: ignore[no-untyped-call]
    return text.getvalue()
