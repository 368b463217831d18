"""Plots as data in SI: a sheet of panels, each with its axes, lines, points and guides."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from ...messages import RAISED, filled, localized, translate
from ...result import Result, shown_as
from ..amounts import converted, headed, measured


class ChartAxis(NamedTuple):
    """One axis of a chart: quantity, symbol, SI unit."""

    quantity: str
    symbol: str
    unit: str = "1"
    log: bool = False

    @property
    def label(self) -> str:
        """Quantity, symbol and the engineer's unit."""
        return headed(f"{self.quantity} {self.symbol}".strip(), self.unit)

    def shown(self, values: Iterable[float | None]) -> list[float]:
        """Return values in the engineer's unit, NaN for those that are None."""
        return [math.nan if value is None else converted(value, self.unit) for value in values]


class Line(NamedTuple):
    """A curve; values that are None are gaps."""

    label: str
    x: Sequence[float | None]
    y: Sequence[float | None]
    tag: str = ""
    """Short name set at its end, such as the number of the curve in a paper."""
    style: int | None = None
    """Which of the line styles; by default the next one."""
    points: bool = False
    """Only markers, no line."""
    marker: int | None = None
    """Which of the markers; by default that of the style."""
    filled: bool = False
    """Filled markers instead of open ones: points that stand out."""
    names: Sequence[str] = ()
    """Name of each point; those of the first and the last stand beside them."""


class Guide(NamedTuple):
    """A thin straight line across, at a value of one axis."""

    label: str
    value: float
    across: bool = True
    """Along x, at a value of y; False: the other way round."""
    tag: str = ""
    """Short name set above the axes, for one that stands upright."""
    style: int | None = None
    """Which of the guide styles; by default the next one."""


class Dimension(NamedTuple):
    """A dimension line beside the axes, between two values of y."""

    label: str
    low: float
    high: float
    style: int


class Area(NamedTuple):
    """A shaded region between two curves."""

    label: str
    x: Sequence[float]
    low: Sequence[float]
    high: Sequence[float]


@dataclass(frozen=True)
class Chart:
    """One pair of axes."""

    x: ChartAxis
    y: ChartAxis
    lines: list[Line]
    title: str = ""
    guides: list[Guide] = field(default_factory=list)
    spans: list[Dimension] = field(default_factory=list)
    areas: list[Area] = field(default_factory=list)
    from_zero: bool = False
    """True if the axis of y begins at 0."""
    bounds: tuple[float, float, float, float] | None = None
    """Ends of the axes where they are not the data's: of x, then of y."""
    named: bool = False
    """True if the lines are labelled with names of the user's, set as they are."""

    @property
    def labels(self) -> list[str]:
        """Entries of the legend."""
        entries: list[Area | Line | Guide] = [*self.areas, *self.lines, *self.guides]
        return [entry.label for entry in entries if entry.label]


@dataclass(frozen=True)
class Sheet:
    """Drawing of one plot command: panels one below the other, title above, caption below."""

    title: str
    panels: Sequence[Any]
    """Charts, or one ``Drawing``."""
    caption: str = ""
    name: str | None = None
    """Name of the user's (a spec's), beside the title; set as it is."""
    aside: str = ""
    """Text below the caption where the drawing stands alone."""

    @property
    def below(self) -> str:
        """Text below the drawing where it stands alone."""
        return f"{self.caption} {self.aside}".strip()


def axis_of(record: Result, name: str, *, log: bool = False, quantity: str | None = None) -> ChartAxis:
    """Axis of a field of results, read off its symbol, unit and description."""
    field = type(record).model_fields[name]
    shown = shown_as(field)
    return ChartAxis(quantity or translate(field.description or name), shown.symbol or "", shown.unit, log)


def line_of(record: Result, name: str, x: Sequence[float | None], **how: Any) -> Line:
    """Line of a field that holds a list, labelled by its symbol and description; ``how`` as of ``Line``."""
    axis = axis_of(record, name)
    return Line(f"{axis.symbol}: {axis.quantity}", x, getattr(record, name), **how)


def power(value: float) -> str:
    """Write a large number as a power of ten.

    >>> power(1e7), power(2.5e12)
    ('10⁷', '2.5·10¹²')
    """
    mantissa, _, exponent = f"{value:.3e}".partition("e")
    ten = "10" + str(int(exponent)).translate(RAISED)
    return ten if float(mantissa) == 1 else f"{localized(f'{float(mantissa):g}')}·{ten}"


def stated(symbol: str, value: float, unit: str) -> str:
    """``symbol = value unit`` in the engineer's unit.

    >>> stated("F_п", 2000.0, "N"), stated("C", 0.5, "1")
    ('F_п = 2 kN', 'C = 0.5')
    """
    return f"{symbol} = {measured(value, unit)}"


def guide_at(text: str, symbol: str, value: float, unit: str, *, across: bool = True) -> Guide:
    """Guide at a value, which ``{stated}`` in the text of its label tells."""
    return Guide(filled(text, {"stated": stated(symbol, value, unit)}), value, across)
